"""How many mechanisms of one topology are drawn a second, each at three positions; how many files are solved."""

from __future__ import annotations

import json
import random
import re
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import graphkin
from graphkin.cli import main
from graphkin.files import library
from graphkin.model.mechanism import Link, Mechanism
from graphkin.model.variants import single
from graphkin.running.variants import replay_many

COUNT, ALONE = 100_000, 100
LEAST = {"ex3-1": 300_000, "ex3-5": 300_000, "ex3-7": 200_000}
ROUNDS = 3


def variants(mechanism: Mechanism) -> Mechanism:
    """Every length of it another one, up to two hundredths."""
    rng = np.random.default_rng(1)

    def changed(link: Link) -> Link:
        start = next(iter(link.points))
        return replace(link, points={p: z if p == start else z * rng.uniform(0.98, 1.02, COUNT) for p, z in link.points.items()})

    return replace(mechanism, links={name: changed(link) for name, link in mechanism.links.items()})


@pytest.mark.bench
@pytest.mark.parametrize("name", LEAST)
def test_mechanisms_a_second(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    """Three planes of every point, all omega and alpha, read as arrays; one core."""
    mechanism = library.load(name)
    method, many = graphkin.plan(mechanism), variants(mechanism)
    values = [mechanism.drivers[0].value + np.array([[-0.05], [0.0], [0.05]])]
    together = alone = float("inf")
    for _ in range(ROUNDS):
        start = time.thread_time()
        found = replay_many(method, many, values)
        total = sum(np.sum(v) for t in (found.plot.acceleration, found.plot.alpha, found.plot.omega) for v in t.values())
        together = min(together, (time.thread_time() - start) / COUNT)
        start = time.thread_time()
        for row in range(ALONE):
            own = graphkin.plan(single(many, row))
            plot = graphkin.replay(own, [values[0][:, 0]], held=False)
        alone = min(alone, (time.thread_time() - start) / ALONE)
    assert np.isfinite(total)
    assert not found.refused
    for point, places in plot.acceleration.items():
        assert found.plot.acceleration[point][:, ALONE - 1] == pytest.approx(places, rel=1e-9, abs=1e-9)
    with capsys.disabled():
        print(f"\n{name}: {1 / together:,.0f} mechanisms a second at 3 positions each, {alone / together:.0f} times one by one")
    assert 1 / together > LEAST[name]


FILES, FILES_A_SECOND = 200, 80


def another(text: str, rng: random.Random) -> str:
    """The same mechanism with every length another one, up to two hundredths."""
    return re.sub(r"(?m)^([A-Z]{2} = )([0-9.]+)", lambda line: f"{line[1]}{float(line[2]) * rng.uniform(0.98, 1.02):.6g}", text)


@pytest.mark.bench
@pytest.mark.parametrize("names", [("ex3-1",), ("ex3-1", "ex3-5", "ex3-7", "p3-22", "fig2-32")])
def test_files_a_second(names: tuple[str, ...], tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """`solve --json` of so many different files: read, planned, drawn, proved, written; one core."""
    rng, files = random.Random(1), []
    for k in range(FILES):
        files.append(tmp_path / f"{k:03d}.toml")
        files[-1].write_text(another(library.text(names[k % len(names)]), rng), encoding="utf-8")
    taken = float("inf")
    for _ in range(ROUNDS):
        start = time.thread_time()
        said = CliRunner().invoke(main, ["solve", "--json", *map(str, files)])
        taken = min(taken, time.thread_time() - start)
    found = [json.loads(line) for line in said.stdout.splitlines()]
    assert len(found) == FILES
    assert sum("error" in one for one in found) < FILES / 20
    with capsys.disabled():
        print(f"\n{len(names)} topologies: {FILES / taken:,.0f} files a second")
    assert FILES / taken > FILES_A_SECOND
