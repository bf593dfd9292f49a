"""Many mechanisms of one topology as one, whose lengths, directions and drivers are arrays (n,) over mechanisms."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import reduce

import numpy as np
from numpy.typing import NDArray

from graphkin.base.geometry import Value
from graphkin.model.mechanism import Driver, Link, Mechanism
from graphkin.model.pairs import Slide

__all__ = ["coincidences", "count_of", "cut", "single", "stacked", "topology"]

SAME_PLACE = 1e-9
"""Points of a link nearer than this to each other do not give its axis [size]; as `Link.axis` has it."""


def topology(mechanism: Mechanism) -> tuple[object, ...]:
    """All of a mechanism but its numbers: what has the same, and `coincidences`, is drawn by the same steps."""
    return (
        mechanism.frame,
        tuple((name, tuple(link.points)) for name, link in mechanism.links.items()),
        tuple(_without_numbers(pair) for pair in mechanism.pairs),
        tuple(_undriven(driver) for driver in mechanism.drivers),
        tuple(replace(pose, value=0.0) for pose in mechanism.poses),
        tuple(mechanism.sketch),
    )


def _undriven(driver: Driver) -> Driver:
    value = None if driver.value is None else 0.0
    return replace(driver, value=value, rate=0.0, acceleration=0.0, also=())


def _without_numbers(pair: object) -> object:
    if isinstance(pair, Slide):
        stands = type(pair.stands_for)
        return stands, replace(pair, line=replace(pair.line, direction=0j), tilt=0.0, stands_for=None)
    return type(pair), getattr(pair, "joins", ())


def coincidences(mechanism: Mechanism) -> NDArray[np.int8]:
    """What numbers happen to be, as far as the steps hang on it: (k,), or (k, b) of many mechanisms side by side.

    Points of a link that lie in one place (0) or nearly so (1), and lines that are their links' own axes.
    """
    found: list[Value] = [slide.line.direction == 1 for slide in mechanism.slides]
    for link in mechanism.links.values():
        points = [*link.points.values()]
        size = reduce(np.maximum, (np.abs(z - points[0]) for z in points), 0.0)
        for k, z in enumerate(points):
            apart = [np.abs(z - other) for other in points[:k]]
            found += [np.where(far == 0, 0, np.where(far <= SAME_PLACE * size, 1, 2)) for far in apart]
    return np.array(np.broadcast_arrays(*found), dtype=np.int8) if found else np.zeros(0, dtype=np.int8)


def stacked(mechanisms: Sequence[Mechanism]) -> Mechanism:
    """One mechanism whose numbers are arrays (n,) over mechanisms of one topology; of pairs only those of slides."""
    first = mechanisms[0]
    links = {
        name: Link(name, {point: _array(m.links[name].points[point] for m in mechanisms) for point in link.points})
        for name, link in first.links.items()
    }
    sketch = {point: _array(m.sketch[point] for m in mechanisms) for point in first.sketch}
    slides = iter([_slides([m.slides[k] for m in mechanisms]) for k in range(len(first.slides))])
    pairs = tuple(next(slides) if isinstance(pair, Slide) else pair for pair in first.pairs)
    values = [_array(m.poses[k].value for m in mechanisms) for k in range(len(first.poses))]
    poses = tuple(replace(pose, value=value) for pose, value in zip(first.poses, values, strict=True))
    drivers = tuple(_drivers([m.drivers[k] for m in mechanisms]) for k in range(len(first.drivers)))
    return replace(first, links=links, pairs=pairs, drivers=drivers, poses=poses, sketch=sketch)


def _slides(slides: Sequence[Slide]) -> Slide:
    direction, tilt = _array(slide.line.direction for slide in slides), _array(slide.tilt for slide in slides)
    return replace(slides[0], line=replace(slides[0].line, direction=direction), tilt=tilt)


def _drivers(drivers: Sequence[Driver]) -> Driver:
    rate, acceleration = _array(driver.rate for driver in drivers), _array(driver.acceleration for driver in drivers)
    given = [driver.value for driver in drivers if driver.value is not None]
    value: Value = _array(given) if len(given) == len(drivers) else None
    return replace(drivers[0], value=value, rate=rate, acceleration=acceleration)


def _array(numbers: Iterable[complex]) -> Value:
    return np.array([*numbers])


def cut(value: Value, part: slice | int, count: int = 0) -> Value:
    """Of some mechanisms, or of one; what all of them share stays."""
    shared = np.ndim(value) == 0 or (count > 1 and np.shape(value)[-1] == 1)
    if not shared:
        return value[..., part]
    return value if np.ndim(value) == 0 or isinstance(part, slice) else value[..., 0]


def count_of(mechanism: Mechanism) -> int:
    """How many mechanisms lie side by side."""
    return int(np.prod(np.broadcast_shapes(*map(np.shape, _numbers(mechanism)))))


def _numbers(mechanism: Mechanism) -> list[Value]:
    """All that may be arrays."""
    found: list[Value] = [z for link in mechanism.links.values() for z in link.points.values()]
    found += [number for slide in mechanism.slides for number in (slide.line.direction, slide.tilt)]
    found += [number for d in mechanism.drivers for number in (d.value, d.rate, d.acceleration) if number is not None]
    return [*found, *(pose.value for pose in mechanism.poses), *mechanism.sketch.values()]


def single(mechanism: Mechanism, row: int) -> Mechanism:
    """One of many mechanisms that lie side by side."""

    def at(value: Value) -> Value:
        return value[row].item() if np.ndim(value) else value

    links = {
        name: replace(link, points={point: at(z) for point, z in link.points.items()})
        for name, link in mechanism.links.items()
    }
    pairs = tuple(
        replace(pair, line=replace(pair.line, direction=at(pair.line.direction)), tilt=at(pair.tilt))
        if isinstance(pair, Slide)
        else pair
        for pair in mechanism.pairs
    )
    poses = tuple(replace(pose, value=at(pose.value)) for pose in mechanism.poses)
    drivers = tuple(
        replace(driver, value=at(driver.value), rate=at(driver.rate), acceleration=at(driver.acceleration))
        for driver in mechanism.drivers
    )
    sketch = {point: at(z) for point, z in mechanism.sketch.items()}
    return replace(mechanism, links=links, pairs=pairs, drivers=drivers, poses=poses, sketch=sketch)
