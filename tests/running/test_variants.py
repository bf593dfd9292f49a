"""Many mechanisms drawn at once are what each of them is by a plan of its own."""

from __future__ import annotations

import cmath
import os
import random
from dataclasses import replace

import numpy as np
import pytest
from random_mechanisms import DYADS, chain, coupler_angle, cylinder, dyad, relative_angle, rolling, triad

import graphkin
from graphkin.construction import Plot
from graphkin.errors import GraphkinError
from graphkin.files import library
from graphkin.model.mechanism import Mechanism
from graphkin.model.variants import stacked
from graphkin.running.recorder import TABLES
from graphkin.running.variants import DrawnVariants, is_simple, replay_many

COUNT = max(4, int(os.environ.get("GRAPHKIN_RANDOM", "400")) // 40)
OTHERS = {"cylinder": cylinder, "relative": relative_angle, "coupler": coupler_angle, "chain": chain}
LIBRARY = ("ex3-1", "ex3-5", "ex3-7", "p3-22", "p3-23a", "fig3-10")


def varied(mechanism: Mechanism, rng: random.Random, much: float = 0.15) -> Mechanism:
    """Every length, direction, driver and sketched place another one; some so far off that they do not close."""

    def around(z: complex) -> complex:
        return z * cmath.rect(rng.uniform(1 - much, 1 + much), rng.uniform(-much, much))

    links = {
        name: replace(link, points={p: around(z) if k else z for k, (p, z) in enumerate(link.points.items())})
        for name, link in mechanism.links.items()
    }
    slides = tuple(
        replace(pair, line=replace(pair.line, direction=pair.line.direction * cmath.rect(1, rng.uniform(-much, much))))
        for pair in mechanism.slides
    )
    drivers = tuple(
        replace(driver, value=(driver.value or 0.0) + rng.uniform(-much, much) * (0.1 if driver.kind == "slide" else 1),
                rate=rng.uniform(-5, 5), acceleration=rng.uniform(-5, 5)) for driver in mechanism.drivers
    )  # fmt: skip
    sketch = {point: z + complex(rng.gauss(0, 0.004), rng.gauss(0, 0.004)) for point, z in mechanism.sketch.items()}
    pairs = slides if len(slides) == len(mechanism.pairs) else mechanism.pairs
    return replace(mechanism, links=links, pairs=pairs, drivers=drivers, sketch=sketch)


def alone(mechanism: Mechanism, values: list[float] | None = None) -> Plot | GraphkinError:
    try:
        return graphkin.running.replay_all(graphkin.planning.plan(mechanism), values)
    except GraphkinError as error:
        return error


def hold(found: DrawnVariants, row: int, own: Plot | GraphkinError) -> None:
    """Each table of a row, to 1e-9 of the largest value in it (1e-12 where all stand still); or the same refusal."""
    if isinstance(own, GraphkinError):
        assert found.refused[row].message() == own.message()
        assert all(np.isnan(value[..., row]).all() for value in found.plot.position.values())
        return
    assert row not in found.refused
    for name in TABLES:
        mine, its = getattr(found.plot, name), getattr(own, name)
        assert its.keys() <= mine.keys()
        size = max((float(np.max(np.abs(value))) for value in its.values()), default=0.0)
        for key, value in its.items():
            assert np.all(np.abs(mine[key][..., row] - value) <= 1e-9 * size + 1e-12), (name, key)


def mechanism_of(kind: str) -> Mechanism:
    if kind in LIBRARY:
        return library.load(kind)
    for seed in range(100):
        found = OTHERS[kind](seed) if kind in OTHERS else dyad(kind, seed)
        if isinstance(alone(found), Plot):
            return found
    raise AssertionError(kind)


@pytest.mark.parametrize("kind", [*DYADS, *OTHERS, *LIBRARY])
def test_each_is_what_it_is_alone(kind: str) -> None:
    mechanism, rng = mechanism_of(kind), random.Random(kind)
    method = graphkin.plan(mechanism)
    assert is_simple(method)
    many = [mechanism, *(varied(mechanism, rng) for _ in range(COUNT))]
    found = replay_many(method, many)
    for row, one in enumerate(many):
        hold(found, row, alone(one))
    assert len(found.refused) < len(many)


@pytest.mark.parametrize("kind", ["ex3-1", "ex3-7", "RRR", "RPR", "cylinder"])
def test_at_other_positions(kind: str) -> None:
    """One entry a driver, positions by mechanisms; each row as a sweep of the mechanism by itself has it."""
    mechanism, rng = mechanism_of(kind), random.Random(kind)
    method = graphkin.plan(mechanism)
    many = [one for one in (varied(mechanism, rng, 0.03) for _ in range(COUNT)) if isinstance(alone(one), Plot)]
    starts = np.array([[driver.value for driver in one.drivers] for one in many]).T
    values = [start + np.array([[-0.02], [0.0], [0.01]]) * (0.1 if d.kind == "slide" else 1)
              for start, d in zip(starts, mechanism.drivers)]  # fmt: skip
    found = replay_many(method, many, values)
    for row, one in enumerate(many):
        hold(found, row, alone(one, [value[:, row] for value in values]))


def test_arrays_for_mechanisms() -> None:
    """A mechanism whose numbers are arrays is as many mechanisms; what all share may be one number."""
    mechanism, rng = library.load("ex3-7"), random.Random(1)
    method = graphkin.plan(mechanism)
    many = [varied(mechanism, rng) for _ in range(COUNT)]
    one, other = replay_many(method, many), replay_many(method, stacked(many))
    assert one.refused.keys() == other.refused.keys()
    for name in TABLES:
        for key, value in getattr(one.plot, name).items():
            assert np.array_equal(value, getattr(other.plot, name)[key], equal_nan=True)
    drivers = (replace(mechanism.drivers[0], rate=np.array([1.0, 2.0, -3.0])),)  # type: ignore[arg-type]
    speeds = replay_many(method, replace(mechanism, drivers=drivers)).plot.omega["4"]
    assert speeds == pytest.approx(float(speeds[0]) * np.array([1, 2, -3]))


@pytest.mark.parametrize("name", ["scotch-yoke", "s4-ex6", "s3-cam", "p3-19"])
def test_arrays_of_speeds_alone(name: str) -> None:
    """Of positions that no array enters, and of mechanisms with rolling wheels, cams and gears."""
    mechanism = library.load(name)
    rates = np.array([1.0, 2.0, -3.0])
    drivers = tuple(replace(driver, rate=rates, acceleration=0.0) for driver in mechanism.drivers)  # type: ignore[arg-type]
    found = replay_many(graphkin.plan(mechanism), replace(mechanism, drivers=drivers))
    assert not found.refused
    assert any(np.any(omega) for omega in found.plot.omega.values())
    for omega in found.plot.omega.values():
        assert np.broadcast_to(omega, 3) == pytest.approx(np.broadcast_to(omega, 3)[0] * rates)


@pytest.mark.parametrize("make", [triad, rolling])
def test_what_arrays_do_not_settle_is_planned_one_by_one(make) -> None:
    mechanism = make(3)
    method = graphkin.plan(mechanism)
    assert not is_simple(method)
    many = [replace(mechanism, drivers=tuple(replace(d, rate=rate) for d in mechanism.drivers)) for rate in (1.0, -2.0)]
    found = replay_many(method, many)
    for row, one in enumerate(many):
        hold(found, row, alone(one))


def test_another_topology_is_refused() -> None:
    with pytest.raises(ValueError, match="ex3-5"):
        replay_many(graphkin.plan(library.load("ex3-1")), [library.load("ex3-5")])


def test_none_at_all() -> None:
    assert replay_many(graphkin.plan(library.load("ex3-1")), []).refused == {}
