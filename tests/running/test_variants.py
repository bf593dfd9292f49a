"""Many mechanisms drawn at once are what each of them is by a plan of its own."""

from __future__ import annotations

import cmath
import os
import random
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from random_mechanisms import DYADS, chain, coupler_angle, cylinder, dyad, relative_angle, rolling, triad

import graphkin
from graphkin.construction import Plot
from graphkin.errors import GraphkinError
from graphkin.files import library
from graphkin.files.variants import Variants
from graphkin.model.mechanism import Mechanism
from graphkin.model.pairs import Slide
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
            off = mine[key][..., row] - value
            off = np.exp(1j * off) - 1 if name == "theta" else off  # whole turns of angles are counted by paths alone
            assert np.all(np.abs(off) <= 1e-9 * size + 1e-12), (name, key)


def numbers(mechanism: Mechanism) -> list[complex]:
    """Of links, lines, drivers and the sketch."""
    links = [z for link in mechanism.links.values() for z in link.points.values()]
    rates = [x for driver in mechanism.drivers for x in (0.0 if driver.value is None else driver.value, driver.rate, driver.acceleration)]
    return [*links, *(slide.line.direction for slide in mechanism.slides), *rates, *mechanism.sketch.values()]


def with_numbers(mechanism: Mechanism, values: Sequence[Any]) -> Mechanism:
    more = iter(values)
    links = {n: replace(link, points={p: next(more) for p in link.points}) for n, link in mechanism.links.items()}
    slides = iter([replace(pair, line=replace(pair.line, direction=next(more))) for pair in mechanism.slides])
    drivers = tuple(replace(d, value=next(more), rate=next(more), acceleration=next(more)) for d in mechanism.drivers)
    pairs = tuple(next(slides) if isinstance(pair, Slide) else pair for pair in mechanism.pairs)
    return replace(mechanism, links=links, pairs=pairs, drivers=drivers, sketch={p: next(more) for p in mechanism.sketch})


class Stacked(Variants[Mechanism]):
    def __getitem__(self, row: int) -> Any:
        return self.read(row)


def stacked(many: list[Mechanism]) -> Variants:
    """Mechanisms that no file has: their numbers as columns, of a vector x and, where any has it, y."""
    table = np.array([numbers(one) for one in many]).T
    columns = [part for z in table for part in ([z.real, z.imag] if z.imag.any() else [z.real])]

    def built(values: Sequence[Any]) -> tuple[Mechanism, Any]:
        more, rates = iter(values), 3 * len(many[0].drivers)
        first = len(table) - rates - len(many[0].sketch)
        real = range(first, first + rates)
        each = [next(more) + 1j * next(more) if z.imag.any() else next(more) + (0 if k in real else 0j) for k, z in enumerate(table)]
        return with_numbers(many[0], each), lambda: np.array(True)

    found = Stacked(many[0], {}, len(many), many.__getitem__)
    found.__dict__ |= {"columns": {(k,): column for k, column in enumerate(columns)}, "built": built}
    return found


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
    found = replay_many(method, stacked(many))
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
    found = replay_many(method, stacked(many), values)
    for row, one in enumerate(many):
        hold(found, row, alone(one, [value[:, row] for value in values]))


@pytest.mark.parametrize("name", ["scotch-yoke", "ex3-3", "s3-cam", "p3-19", "ex3-7"])
def test_arrays_of_speeds_alone(name: str) -> None:
    """Of positions that no array enters, and of mechanisms with rolling wheels, cams and gears."""
    mechanism = library.load(name)
    found = graphkin.replay(mechanism.variants(omega=np.array([1.0, 2.0, -3.0])))
    assert not found.refused
    assert any(np.any(found.omega[link]) for link in mechanism.moving)
    for link in mechanism.moving:
        assert np.array(found.omega[link]) == pytest.approx(found.omega[link][0] * np.array([1, 2, -3]))


@pytest.mark.parametrize("make", [triad, rolling])
def test_what_arrays_do_not_settle_is_planned_one_by_one(make) -> None:
    mechanism = make(3)
    method = graphkin.plan(mechanism)
    assert not is_simple(method)
    many = [replace(mechanism, drivers=tuple(replace(d, rate=rate) for d in mechanism.drivers)) for rate in (1.0, -2.0)]
    found = replay_many(method, stacked(many))
    for row, one in enumerate(many):
        hold(found, row, alone(one))


# --- by a file's numbers ----------------------------------------------------------------------

FILES = ("ex3-1", "ex3-5", "ex3-7", "p3-22", "s3-four", "p3-21", "p3-14", "s2-1b", "p3-17")


def others(mechanism: Mechanism, rng: random.Random) -> dict[str, object]:
    """Other values of every number of a file, some too far off."""
    values: dict[str, object] = {}
    for path, given in mechanism.given.items():
        if given.dimension is not None and not isinstance(path[-1], int) and isinstance(given.written, int | float):
            far = [1 + rng.uniform(-0.02, 0.02) for _ in range(COUNT)]
            values[".".join(map(str, path))] = np.array([given.written * (3.0 if k == 2 else part) for k, part in enumerate(far)])
        elif isinstance(given.written, list) and (part := mechanism.given.get((*path, 1))) and part.dimension == "length":
            x, y = (np.array([float(part) + rng.uniform(-0.3, 0.3) for _ in range(COUNT)]) for part in given.written)
            values[".".join(map(str, path))] = (x, y)
    return values


@pytest.mark.parametrize("name", FILES)
def test_a_file_with_other_numbers(name: str) -> None:
    """Every number of it: each is what `with_` gives, its parts to 1e-12, what is drawn to 1e-9; or refused as there."""
    mechanism = library.load(name)
    values = others(mechanism, random.Random(name))
    variants = mechanism.variants(values)
    found = graphkin.replay(variants)
    made, sound = variants.built([*variants.columns.values()]) if name != "p3-17" else (mechanism, lambda: np.array(False))
    sure = np.broadcast_to(sound(), COUNT)
    for row in range(COUNT):
        own = {key: value[row] if isinstance(value, np.ndarray) else tuple(part[row] for part in value) for key, value in values.items()}
        try:
            single = mechanism.with_(own)
        except GraphkinError as error:
            assert found.refused[row].message() == error.message()
            assert not sure[row]
            continue
        assert numbers(variants[row]) == numbers(single)
        mine = [np.broadcast_to(value, COUNT)[row] for value in numbers(made)] if sure[row] else numbers(single)
        assert mine == pytest.approx(numbers(single), rel=1e-12, abs=1e-14)
        hold(DrawnVariants(found.plot, found.refused), row, alone(single))
    assert len(found.refused) < COUNT
    assert name == "p3-17" or sure.sum() > COUNT / 2
