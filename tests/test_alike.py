"""Mechanisms of one topology that are proved together are what each is alone, or are left to be solved alone."""

from __future__ import annotations

import cmath
import json
import os
import random
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import random_mechanisms
from click.testing import CliRunner
from random_mechanisms import DYADS, Seed, dyad
from test_variants import varied

from graphkin import api, library
from graphkin.agreement import Proved, proved
from graphkin.alike import planned_together, proved_together
from graphkin.batches import solve_many
from graphkin.cli import main
from graphkin.errors import GraphkinError
from graphkin.mechanism import Link, Mechanism
from graphkin.running.program import TABLES

COUNT = max(8, int(os.environ.get("GRAPHKIN_RANDOM", "0")) // 10)
"""Variants of each topology; more of them with GRAPHKIN_RANDOM in the environment."""
OTHERS = ("cylinder", "relative_angle", "coupler_angle", "chain", "triad", "six_bar", "cam", "circular_slot", "rolling")
LIBRARY = ("ex3-1", "ex3-4", "p3-5", "p3-21", "fig2-32")
EXACT = ("theta", "omega", "alpha", "s", "s_rate", "s_acceleration", "position", "velocity", "acceleration")
NATURAL = {"s": "position", "s_rate": "velocity", "s_acceleration": "acceleration"}
"""By what displacements are measured, where all of them stand still."""


def mirrored(machine: Mechanism) -> Mechanism:
    """Seen in a mirror along x."""
    links = {name: replace(link, points={p: z.conjugate() for p, z in link.points.items()}) for name, link in machine.links.items()}
    pairs = tuple(replace(s, line=replace(s.line, direction=s.line.direction.conjugate()), tilt=-s.tilt) for s in machine.slides)
    drivers = tuple(replace(d, value=d.value if d.kind == "slide" else -d.value) for d in machine.drivers)
    return replace(machine, links=links, pairs=pairs, drivers=drivers, sketch={p: z.conjugate() for p, z in machine.sketch.items()})


def folded(machine: Mechanism, rng: random.Random) -> Mechanism:
    """Some points of a link in one place, some lines their links' own axes."""

    def of(link: Link) -> Link:
        one, other = rng.choice([*link.points]), rng.choice([*link.points])
        return replace(link, points=link.points | {one: link.points[other]})

    links = {name: of(link) if rng.random() < 0.2 else link for name, link in machine.links.items()}
    pairs = tuple(replace(s, line=replace(s.line, direction=1 + 0j)) if rng.random() < 0.3 else s for s in machine.slides)
    return replace(machine, links=links, pairs=pairs)


def elsewhere(machine: Mechanism, rng: random.Random) -> Mechanism:
    """Another sketch altogether: another assembly, or one that lies between two."""
    return replace(machine, sketch={p: complex(rng.uniform(-0.15, 0.15), rng.uniform(-0.15, 0.15)) for p in machine.sketch})


def resting(machine: Mechanism, rng: random.Random) -> Mechanism:
    """Some drivers turn the other way, stand still or turn evenly."""
    rates = (0.0, 1.0, -1.0)
    return replace(machine, drivers=tuple(
        replace(d, rate=d.rate * rng.choice(rates), acceleration=d.acceleration * rng.choice(rates)) for d in machine.drivers
    ))  # fmt: skip


def fewer(machine: Mechanism, much: float, rng: random.Random) -> Mechanism:
    """A sketch that is a little off."""
    return replace(machine, sketch={p: z + cmath.rect(much, rng.uniform(0, 6.3)) for p, z in machine.sketch.items()})


def ways(machine: Mechanism, rng: random.Random) -> list[Callable[[], Mechanism]]:
    """How it is varied, first not at all; of other pairs than slides dimensions stay."""
    slides = len(machine.slides) == len(machine.pairs)
    return [
        lambda: machine, lambda: resting(machine, rng), lambda: fewer(machine, 1e-3, rng), lambda: elsewhere(machine, rng),
        *((lambda: varied(machine, rng, 0.02), lambda: varied(machine, rng, 0.5), lambda: mirrored(varied(machine, rng)),
           lambda: folded(machine, rng)) if slides else (lambda: fewer(machine, 1e-5, rng),)),
    ]  # fmt: skip


def changed(machine: Mechanism, k: int, rng: random.Random) -> Mechanism:
    found = ways(machine, rng)
    return found[k % len(found)]()


def variants(kind: str) -> Iterator[Mechanism]:
    rng = random.Random(kind)
    for structure in range(2):
        for k in range(COUNT):
            yield changed(of_kind(kind, (structure, k)), k, rng)


def of_kind(kind: str, seed: Seed) -> Mechanism:
    if kind in LIBRARY:
        return library.load(kind)
    return dyad(kind, seed) if kind in DYADS else getattr(random_mechanisms, kind)(seed)


def hold(found: Proved, own: Proved) -> None:
    """Both roads give the same to 1e-12, as far as rounding lets them: by the square of the condition."""
    bound = 1e-12 / min(1.0, float(own.exact.condition)) ** 2
    pairs = [(found.plot, own.plot, name) for name in TABLES] + [(found.exact, own.exact, name) for name in EXACT]
    for mine, its, name in pairs:
        table, right = getattr(mine, name), getattr(its, name)
        assert table.keys() == right.keys()
        values = [*right.values(), *getattr(its, NATURAL.get(name, name)).values()]
        size = max((float(np.abs(value)) for value in values), default=0.0)
        for key, value in right.items():
            turned = name == "theta"
            off = abs(np.exp(1j * (table[key] - value)) - 1) if turned else abs(table[key] - value)
            assert off <= bound * (1.0 if turned else size), (name, key)
    assert found.worst < 1e-9 or found.worst < 10 * own.worst


@pytest.mark.parametrize("kind", [*DYADS, *OTHERS, *LIBRARY])
def test_together_is_what_each_is_alone(kind: str) -> None:
    many = [*variants(kind)]
    found = proved_together(many)
    for machine, together in zip(many, found, strict=True):
        if together is not None:
            method, alone = together[0], api.plan(machine)
            hold(together[1], proved(alone))
            assert (method.velocity, method.acceleration, method.position) == (alone.velocity, alone.acceleration, alone.position)
    every = len(ways(many[0], random.Random()))
    unchanged = [together is not None for structure in (0, COUNT) for together in found[structure : structure + COUNT : every]]
    assert sum(unchanged) >= 0.9 * len(unchanged)


def test_methods_together_are_what_each_is_alone() -> None:
    many = [varied(library.load("ex3-7"), random.Random(k), 0.05) for k in range(6)]
    for machine, method in zip(many, planned_together(many), strict=True):
        assert getattr(method, "position", None) == api.plan(machine).position


def test_files_in_any_order_say_what_each_says(tmp_path: Path) -> None:
    """Those of one topology, one of another, one that cannot be assembled, one that is no mechanism, and no file."""
    names = []
    for k, length in enumerate((24, 25, 26, 500, 27)):
        names.append(tmp_path / f"crank-{k}.toml")
        names[-1].write_text(library.text("ex3-1").replace("AB = 24", f"AB = {length}"), encoding="utf-8")
    (tmp_path / "broken.toml").write_text("[frame\n", encoding="utf-8")
    sources = [*map(str, names), "ex3-5", str(tmp_path / "broken.toml"), str(tmp_path / "none.toml"), str(names[0])]
    together = CliRunner().invoke(main, ["solve", "--json", *sources])
    alone = [CliRunner().invoke(main, ["solve", "--json", source]) for source in sources]
    assert together.exit_code == max(one.exit_code for one in alone) == 3
    said = [json.loads(line) for line in together.stdout.splitlines()]
    for mine, one in zip(said, alone, strict=True):
        assert flat(mine) == pytest.approx(flat(json.loads(one.stdout)), rel=1e-12, abs=1e-12)


def test_each_names_the_frame_as_its_own_file_does() -> None:
    """Points of a guide that stands still are called by the frame's number."""
    many = [replace(library.load("p3-19"), frame=frame) for frame in ("4", "4", "4", "9", "9", "9")]
    for machine, together in zip(many, proved_together(many), strict=True):
        assert together is not None
        assert together[0].velocity == api.plan(machine).velocity


def flat(value: object, path: str = "") -> dict[str, object]:
    """Every number and text of plain data, by where it stands; texts are told by the path itself."""
    if isinstance(value, dict | list):
        entries = value.items() if isinstance(value, dict) else enumerate(value)
        return {name: one for key, each in entries for name, one in flat(each, f"{path}/{key}").items()}
    return {path: value} if isinstance(value, float | int) else {f"{path} {value}": 0.0}


def test_many_refuse_what_one_refuses() -> None:
    machine = library.load("ex3-1")
    many = [machine.with_(AB=length) for length in (20, 24, 500, 28)]
    for one, solved in zip(many, solve_many(many, ["omega 3"]), strict=True):
        try:
            assert solved["omega 3"] == pytest.approx(float(api.Drawing.of(one)["omega 3"]), rel=1e-12)
        except GraphkinError as error:
            assert (solved.error or error).message() == error.message()
            assert len(solved) == 0
