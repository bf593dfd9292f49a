"""Mistakes in every mechanism there is: the library's, and random ones of every family."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterator

import numpy as np
import pytest
from every_family import FAMILIES

from graphkin.construction import Plot
from graphkin.errors import DeadPoint
from graphkin.files import library
from graphkin.marking import MISTAKES, Consequences, combined, consequences, redraw
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.quantities import Quantity, read
from graphkin.planning import Method, plan
from graphkin.running import replay_all
from graphkin.say.catalogue import LANGUAGES
from graphkin.say.marks import mistake

COUNT = max(1, int(os.environ.get("GRAPHKIN_RANDOM", "800")) // 800)
"""Random mechanisms of each family; more of them with GRAPHKIN_RANDOM=8000 in the environment."""





def everything(mechanism: Mechanism) -> list[Quantity]:
    """What the file asks, every rotation, every velocity and acceleration."""
    texts = [*mechanism.ask]
    texts += [f"{word} {link}" for link in mechanism.moving for word in ("omega", "alpha")]
    moving = [point for point in mechanism.points if set(mechanism.owners[point]) != {FRAME}]
    texts += [f"{word} {point}" for point in moving for word in "va"]
    found = {quantity.text: quantity for text in texts if (quantity := read(mechanism, text)) is not None}
    return list(found.values())


def made(family: str) -> Iterator[tuple[Mechanism, Method, Plot]]:
    for seed in range(COUNT):
        mechanism = FAMILIES[family](seed)
        method = plan(mechanism)
        try:
            yield mechanism, method, replay_all(method)
        except DeadPoint:
            continue


def hold(mechanism: Mechanism, method: Method, plot: Plot) -> Consequences:
    """The right hand draws what a replay draws; every mistake is drawn without a warning, and alone as among others."""
    right = redraw(method, plot)
    for table in ("omega", "alpha", "velocity", "acceleration"):
        found, wanted = getattr(right, table), getattr(plot, table)
        assert found.keys() == wanted.keys()
        assert all(found[name] == pytest.approx(wanted[name], rel=1e-12, abs=1e-12) for name in wanted), table
    quantities = everything(mechanism)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = consequences(method, plot, quantities)
    assert len({rewrite.name for (rewrite,) in found.columns}) == len(found.columns)
    hold_sayable(found)
    hold_planes(found)
    hold_alone(method, plot, found)
    return found


def hold_sayable(found: Consequences) -> None:
    """Every sentence finds what it names."""
    for (rewrite,) in found.columns:
        for said in (mistake(rewrite.name, lang) for lang in LANGUAGES):
            assert said == " ".join(said.split()) != rewrite.id, said


def hold_planes(found: Consequences) -> None:
    """What is done otherwise in the acceleration polygon alone leaves velocities as they are."""
    slow = [k for k, q in enumerate(found.quantities) if q.word in ("omega", "v")]
    right = np.array([float(found.right[k].value) for k in slow])
    for row, (rewrite,) in enumerate(found.columns):
        if rewrite.edits and all("acceleration" in edit.spot[:2] for edit in rewrite.edits):
            assert found.values[row, slow] == pytest.approx(right, rel=1e-12, abs=1e-12), rewrite.name


def hold_alone(method: Method, plot: Plot, found: Consequences) -> None:
    """Every mistake drawn by itself; by default every third, in turns."""
    every = 1 if "GRAPHKIN_RANDOM" in os.environ else 3
    for row in range(len(found.columns) % every, len(found.columns), every):
        alone = combined(method, plot, found.quantities, [found.columns[row]])
        sizes = np.abs(np.nan_to_num(alone.values[0], posinf=0.0, neginf=0.0)).max()
        same = pytest.approx(alone.values[0], rel=1e-9, abs=1e-9 * max(1.0, float(sizes)), nan_ok=True)
        assert found.values[row] == same, found.columns[row][0].name


@pytest.mark.many(8)
@pytest.mark.parametrize("name", library.names())
def test_library(name: str):
    mechanism = library.load(name)
    method = plan(mechanism)
    hold(mechanism, method, replay_all(method))


@pytest.mark.many(8)
@pytest.mark.parametrize("family", FAMILIES)
def test_random_mechanisms(family: str):
    for mechanism, method, plot in made(family):
        found = hold(mechanism, method, plot)
        hold_reversal(method, plot, found)


def hold_reversal(method: Method, plot: Plot, found: Consequences) -> None:
    """All drivers reversed: every rotation is, and no acceleration changes."""
    reversals = [rewrite for (rewrite,) in found.columns if rewrite.id == "driver-reversed"]
    for whole in [rewrite for rewrite in reversals if rewrite.way == "all"] or reversals:
        values = combined(method, plot, found.quantities, [(whole,)]).values[0]
        for quantity, answer, value in zip(found.quantities, found.right, values, strict=True):
            if quantity.word == "omega":
                assert value == pytest.approx(-answer.value, rel=1e-9, abs=1e-9)
            elif quantity.word in ("alpha", "a"):
                assert value == pytest.approx(answer.value, rel=1e-9, abs=1e-9 * size_of_all(plot))


def size_of_all(plot: Plot) -> float:
    return float(max(1.0, *(abs(a) for a in plot.acceleration.values()), *(abs(a) for a in plot.alpha.values())))


def test_every_mistake_is_made_somewhere_in_the_library():
    found: set[str] = set()
    for name in library.names():
        mechanism = library.load(name)
        method = plan(mechanism)
        made_here = consequences(method, replay_all(method), everything(mechanism))
        found |= {rewrite.id for (rewrite,), moves in zip(made_here.columns, made_here.moves, strict=True) if moves}
    beyond = {"moves-as-centre"}  # no mechanism of the library has a rack on a pinion whose centre moves
    assert found == set(MISTAKES) - beyond
