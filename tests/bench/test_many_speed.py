"""How many mechanisms of one file are drawn a second, each at three positions; trials; how many files are solved.

Each beside the same done one by one in the same run, so that a busy machine slows both.
"""

from __future__ import annotations

import json
import os
import random
import re
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import graphkin
from graphkin.cli import main
from graphkin.files import library

COUNT, ALONE, ROUNDS = 100_000, 30, 2
LENGTHS = {
    "ex3-1": {"AB": 24, "DC": 48, "D": (78, 0)},
    "ex3-5": {"AB": 30, "DC": 60, "links.2.shape.C": (70, 0), "links.2.shape.E": (35, 20)},
    "ex3-7": {"AB": 125, "CD": 600, "DE": 150},
}
SHIFTS = np.array([-0.05, 0.0, 0.05])


def least(work: Callable[[], object], rounds: int = ROUNDS) -> float:
    """The least time that it takes [s]."""
    times = []
    for _ in range(rounds):
        start = time.thread_time()
        work()
        times.append(time.thread_time() - start)
    return min(times)


def read(state: graphkin.State) -> float:
    """Everything of points and links."""
    mechanism = state.mechanism
    places = (table[point] for table in (state.position, state.v, state.a) for point in mechanism.points)
    turns = (table[link] for table in (state.theta, state.omega, state.alpha) for link in mechanism.moving)
    return float(sum(np.abs(np.sum(value)) for value in (*places, *turns)))


@pytest.mark.bench
@pytest.mark.parametrize("name", LENGTHS)
def test_mechanisms_a_second(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    """Every length another one, up to two hundredths; made, drawn and read, and all of that one by one; one core."""
    mechanism, rng = library.load(name), np.random.default_rng(1)

    def around(value: float | tuple[float, ...]) -> object:
        return tuple(map(around, value)) if isinstance(value, tuple) else value * rng.uniform(0.98, 1.02, COUNT)

    lengths = {key: around(value) for key, value in LENGTHS[name].items()}
    values = [np.degrees(mechanism.drivers[0].value + SHIFTS)]

    def row(k: int) -> dict[str, object]:
        return {key: value[k] if isinstance(value, np.ndarray) else tuple(part[k] for part in value) for key, value in lengths.items()}

    def one_by_one() -> None:
        for k in range(ALONE):
            read(graphkin.replay(graphkin.plan(mechanism.with_(row(k))), values, held=False))

    proved = least(lambda: read(graphkin.replay(mechanism.variants(lengths), values))) / COUNT
    together = least(lambda: read(graphkin.replay(mechanism.variants(lengths), values, held=False))) / COUNT
    alone = least(one_by_one) / ALONE
    found, last = graphkin.replay(mechanism.variants(lengths), values), ALONE - 1
    own = graphkin.replay(graphkin.plan(mechanism.with_(row(last))), values)
    assert not found.refused
    for point in mechanism.points:
        assert np.array(found.a[point])[:, last] == pytest.approx(np.broadcast_to(own.a[point], 3), rel=1e-9, abs=1e-9)
    with capsys.disabled():
        print(f"\n{name}: {1 / together:,.0f} mechanisms a second at 3 positions each, {alone / together:,.0f} times one by one; "
              f"some held against the analysis: {1 / proved:,.0f}")  # fmt: skip
    assert alone / together > 200


@pytest.mark.bench
@pytest.mark.parametrize(("name", "names", "point"), [("ex3-5", ("AB", "DC"), "C"), ("s3-four", ("BE", "CE"), "E")])
def test_trials(name: str, names: tuple[str, str], point: str, capsys: pytest.CaptureFixture[str]) -> None:
    """A point at 361 positions with two other lengths, beside planning the mechanism anew."""
    mechanism = library.load(name)
    lengths = [float(mechanism.given["links", link, key].written) for key in names
               for link in mechanism.links if ("links", link, key) in mechanism.given]  # fmt: skip
    trial, turn = graphkin.trial(mechanism, *names, over="0:360:1"), [np.arange(361)]
    other = [length * 1.01 for length in lengths]
    quick = least(lambda: trial(*other).position[point], rounds=200)
    planned = least(lambda: graphkin.replay(graphkin.plan(mechanism.with_(dict(zip(names, other)))), turn, held=False).position[point])
    proved = trial.taken(*other).position[point]
    assert np.array(trial(*other).position[point]) == pytest.approx(np.array(proved), rel=1e-9, abs=1e-12)
    with capsys.disabled():
        print(f"\n{name}: a trial of 361 positions in {quick * 1e3:.3f} ms, {planned / quick:.0f} times as fast as planned anew")
    assert planned / quick > 10


FILES, SHARED = (200, 2000) if "GRAPHKIN_RANDOM" in os.environ else (100, 300)


def another(text: str, rng: random.Random) -> str:
    """The same mechanism with every length another one, up to two hundredths."""
    return re.sub(r"(?m)^([A-Z]{2} = )([0-9.]+)", lambda line: f"{line[1]}{float(line[2]) * rng.uniform(0.98, 1.02):.6g}", text)


def written(folder: Path, count: int, names: tuple[str, ...]) -> list[Path]:
    rng, files = random.Random(1), [folder / f"{k:04d}.toml" for k in range(count)]
    for k, file in enumerate(files):
        file.write_text(another(library.text(names[k % len(names)]), rng), encoding="utf-8")
    return files


@pytest.mark.bench
@pytest.mark.parametrize("names", [("ex3-1",), ("ex3-1", "ex3-5", "ex3-7", "p3-22", "fig2-32")])
def test_files_a_second(names: tuple[str, ...], tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """`solve --json` of so many different files, read, planned, drawn, proved, written, beside reading them; one core."""
    files = written(tmp_path, FILES, names)
    printed: list[str] = []
    taken = least(lambda: printed.append(CliRunner().invoke(main, ["solve", "--json", *map(str, files)]).stdout), rounds=1)
    reading = least(lambda: [graphkin.load(file) for file in files], rounds=1)
    answers = [json.loads(line) for line in printed[0].splitlines()]
    assert len(answers) == FILES
    assert sum("error" in one for one in answers) < FILES / 20
    with capsys.disabled():
        print(f"\n{len(names)} topologies: {FILES / taken:,.0f} files a second, {taken / reading:.1f} times what reading them takes")


@pytest.mark.bench
def test_two_processes(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Many files by `solve_many`, here and on two processes, which two free cores do in about half the time."""
    files = written(tmp_path, SHARED, ("ex3-1",))

    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, range(os.cpu_count() or 1))  # the others here keep to one core
    start, before = time.perf_counter(), os.times()
    alone = [result["omega 3"] for result in graphkin.solve_many(files)]
    here, own = time.perf_counter() - start, os.times()
    start = time.perf_counter()
    with ProcessPoolExecutor(2) as executor:
        shared = [result["omega 3"] for result in graphkin.solve_many(files, executor=executor)]
    two, end = time.perf_counter() - start, os.times()
    assert alone == shared
    work = end.children_user + end.children_system - own.children_user - own.children_system
    with capsys.disabled():
        print(f"\n{SHARED} files here {here:.2f} s, on two processes {two:.2f} s: {here / two:.2f} times as fast; the work of "
              f"both together is {work / (own.user + own.system - before.user - before.system):.2f} of that here, and "
              f"{end.user + end.system - own.user - own.system:.2f} s of sending")  # fmt: skip
