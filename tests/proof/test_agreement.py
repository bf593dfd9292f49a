"""What a program is given is held against the analysis: positions, arrays of them, many mechanisms at once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
import pytest
from folding import LINKAGES, folding
from random_mechanisms import DYADS, chain, cylinder, dyad, geared_five_bar, rolling, six_bar, triad
from si_values import si

import graphkin
from graphkin.api import variants as api_variants
from graphkin.errors import GraphkinError, NotReached, RoadsDiffer
from graphkin.files import library
from graphkin.model.mechanism import Mechanism
from graphkin.planning import Method
from graphkin.proof import roads as agreement
from graphkin.running import variants

KINDS = {kind: lambda seed, kind=kind: dyad(kind, seed) for kind in DYADS} | {
    "cylinder": cylinder, "chain": chain, "six bars": six_bar, "triad": triad, "gears": geared_five_bar, "rolling": rolling,
}  # fmt: skip


def planned(kind: str) -> Method:
    for seed in range(40):
        try:
            method = graphkin.plan(KINDS[kind](seed))
            graphkin.replay(method, si(method, near(method, 5)))
            return method
        except GraphkinError:
            continue
    raise AssertionError(kind)


def near(method: Method, count: int, far: float = 0.02) -> list[np.ndarray]:
    """Driver values a little to both sides of the drawn position."""
    steps = np.linspace(-far, far, count)
    starts = zip(method.drivers, method.facts(None).values, strict=True)
    return [value + steps * (method.size if driver.kind == "slide" else 1.0) for driver, value in starts]


def wronged(method: Method, part: float = 1e-3) -> Method:
    """A method that draws its mechanism with drivers a little too fast."""
    fast = tuple(replace(driver, rate=driver.rate * (1 + part) + part) for driver in method.mechanism.drivers)
    return replace(method, structure=replace(method.structure, mechanism=replace(method.structure.mechanism, drivers=fast)))


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("count", [None, 0, 1, 25, 200], ids=str)
def test_wrong_numbers_are_not_given(kind: str, count: int | None):
    """At the drawn position, at another, over few and over many; unless it is asked for."""
    right = planned(kind)
    wrong = wronged(right)
    values: Any = None if count is None else [float(v[0]) for v in near(right, 1)] if count == 0 else near(right, count)
    graphkin.replay(right, si(right, values))
    with pytest.raises(RoadsDiffer):
        graphkin.replay(wrong, si(wrong, values))
    assert np.all(np.isfinite(graphkin.replay(wrong, si(wrong, values), held=False).omega[right.mechanism.drivers[0].link]))


def test_what_the_links_do_beyond_a_change_point_is_not_given():
    """The crossing that was right before it is another assembly after it, all numbers of which are finite."""
    method = graphkin.plan(library.load("p3-22"))
    lift, tilt = method.facts(None).values
    beyond = [lift - method.size * np.linspace(0, 0.2, 25), np.full(25, tilt)]
    with pytest.raises(RoadsDiffer):
        graphkin.replay(method, si(method, beyond))
    assert np.isfinite(graphkin.replay(method, si(method, beyond), held=False).omega["7"]).all()


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("linkage", LINKAGES)
def test_over_change_points_a_replay_is_the_sweep_or_is_not_given(linkage: str, seed: int):
    method = graphkin.plan(folding(linkage, "none", seed))
    turn = method.facts(None).values[0] + np.linspace(0.01, 2 * np.pi, 100)
    try:
        drawn = graphkin.replay(method, si(method, [turn]))
    except (RoadsDiffer, NotReached):
        return
    swept = graphkin.motion(method.mechanism, si(method, [turn]))
    for link in method.mechanism.moving:
        there = np.isfinite(swept.omega[link])
        assert drawn.omega[link][there] == pytest.approx(swept.omega[link][there], rel=1e-6)


def test_an_assembly_beyond_a_dead_point_is_not_given():
    method = graphkin.plan(library.load("fig3-6"))
    with pytest.raises(NotReached):
        graphkin.replay(method, si(method, [method.facts(None).values[0] + np.linspace(-np.pi, np.pi, 361)]))


def test_what_is_known_is_not_asked_again(monkeypatch: pytest.MonkeyPatch):
    method, asked = graphkin.plan(library.load("ex3-5")), []
    solve = agreement.motion

    def counting(mechanism: Mechanism, values: Sequence[Any] | None = None) -> Any:
        asked.append(values)
        return solve(mechanism, values)

    monkeypatch.setattr(agreement, "motion", counting)
    for values, count in [
        ([np.linspace(0, 2, 50)], 1), ([np.linspace(2, 0, 7)], 1), ([np.linspace(0.5, 1, 90)], 1),
        ([np.linspace(0, 2.5, 50)], 2), (None, 3), (None, 3), ([1.0], 4), ([1.0], 4), ([1.1], 5),
    ]:  # fmt: skip
        graphkin.replay(method, si(method, values))
        assert len(asked) == count, values


@pytest.mark.parametrize("shape", [0, 1, 30], ids=str)
def test_values_of_any_kind(shape: int):
    """A list, a tuple, or one array of all drivers' numbers; of no position, too."""
    for name in ("ex3-5", "p3-22"):
        method = graphkin.plan(library.load(name))
        values = near(method, shape, 1e-3)
        for given in (values, tuple(values), np.array(values)):
            assert np.shape(graphkin.replay(method, si(method, given)).omega[method.mechanism.moving[1]]) in ((shape,), ())
        single = np.array([float(value) for value in method.facts(None).values])
        assert np.ndim(graphkin.replay(method, si(method, single)).omega[method.mechanism.moving[1]]) == 0


@pytest.mark.parametrize("name", ["ex3-1", "ex3-7"])
@pytest.mark.parametrize("at", [None, 3], ids=["as drawn", "elsewhere"])
def test_many_mechanisms_are_held_too(name: str, at: int | None, monkeypatch: pytest.MonkeyPatch):
    """Each by its own analysis: the first and the last are, whichever of them is wrong."""
    mechanism = library.load(name)
    key = "velocity" if mechanism.drivers[0].kind == "slide" else "omega"
    many = mechanism.variants({key: mechanism.drivers[0].rate * (1 + np.arange(20) / 9)})
    values = None if at is None else near(graphkin.plan(mechanism), at, 1e-3)
    assert not graphkin.replay(many, si(many.mechanism, values)).refused
    draw = api_variants.replay_many

    def draw_wrong(row: int, *given: Any) -> variants.DrawnVariants:
        made = draw(*given)
        for table in ("omega", "velocity"):
            wrong = {name: np.array(value) for name, value in getattr(made.plot, table).items()}
            for value in wrong.values():
                value[..., row] *= 1.001
            setattr(made.plot, table, wrong)
        return made

    for row in (0, 19):
        monkeypatch.setattr(api_variants, "replay_many", partial(draw_wrong, row))
        with pytest.raises(RoadsDiffer):
            graphkin.replay(many, si(many.mechanism, values))
        graphkin.replay(many, si(many.mechanism, values), held=False)
