"""Many mechanisms of one topology as one, whose lengths, directions and drivers are arrays (n,) over mechanisms.

The classes of a mechanism declare numbers; here, and where such a mechanism is read, arrays stand in their place.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from graphkin.base.geometry import Array, Value
from graphkin.model.mechanism import Link, Mechanism
from graphkin.model.pairs import Pair, Slide

Stacked: TypeAlias = Any
"""A number of each mechanism as an array (n,), or one that all share, to stand where a class declares a number."""

SAME_PLACE = 1e-9  # points of a link nearer than this to each other do not give its axis [size]; as `Link.axis` has it


def topology(mechanism: Mechanism) -> tuple[object, ...]:
    """All of a mechanism but its numbers: what has the same, and `coincidences`, is drawn by the same steps."""
    links = tuple((name, tuple(link.points)) for name, link in mechanism.links.items())
    pairs = tuple(
        (type(pair.stands_for), replace(pair, line=replace(pair.line, direction=0j), tilt=0.0, stands_for=None))
        if isinstance(pair, Slide) else (type(pair), pair.joins) for pair in mechanism.pairs
    )  # fmt: skip
    drivers = tuple(replace(each, value=None if each.value is None else 0.0, rate=0.0, acceleration=0.0, also=())
                    for each in mechanism.drivers)  # fmt: skip
    poses = tuple(replace(pose, value=0.0) for pose in mechanism.poses)
    return mechanism.frame, links, pairs, drivers, poses, tuple(mechanism.sketch)


def coincidences(mechanism: Mechanism) -> NDArray[np.int8]:
    """Coincidences of the numbers, as far as the steps hang on them: (k,), or (k, b) of mechanisms side by side. Points
    of a link that lie in one place (0) or nearly so (1), and lines that are their links' own axes."""
    rows: list[Array] = [np.equal(slide.line.direction, 1) for slide in mechanism.slides]
    for link in mechanism.links.values():
        points: list[Value] = [*link.points.values()]
        size: Value = 0.0
        for z in points:
            size = np.maximum(size, np.abs(z - points[0]))
        for k, z in enumerate(points):
            gaps = [np.abs(z - other) for other in points[:k]]
            rows += [np.where(gap == 0, 0, np.where(gap <= SAME_PLACE * size, 1, 2)) for gap in gaps]
    return np.array(np.broadcast_arrays(*rows), dtype=np.int8) if rows else np.zeros(0, dtype=np.int8)


def stacked(mechanisms: Sequence[Mechanism]) -> Mechanism:
    """One mechanism whose numbers are arrays (n,) over mechanisms of one topology; of pairs only those of slides."""
    first = mechanisms[0]
    links = {name: Link(name, {point: _array(m.links[name].points[point] for m in mechanisms) for point in link.points})
             for name, link in first.links.items()}  # fmt: skip
    sketch = {point: _array(m.sketch[point] for m in mechanisms) for point in first.sketch}
    pairs: list[Pair] = []
    for k, pair in enumerate(first.pairs):
        if isinstance(pair, Slide):
            slides = [slide for m in mechanisms if isinstance(slide := m.pairs[k], Slide)]
            line = replace(pair.line, direction=_array(slide.line.direction for slide in slides))
            pair = replace(pair, line=line, tilt=_array(slide.tilt for slide in slides))
        pairs.append(pair)
    poses = tuple(replace(pose, value=_array(m.poses[k].value for m in mechanisms))
                  for k, pose in enumerate(first.poses))  # fmt: skip
    drivers = []
    for each in zip(*(m.drivers for m in mechanisms), strict=True):
        values = [driver.value for driver in each if driver.value is not None]
        value = _array(values) if len(values) == len(each) else None
        rate, acceleration = _array(d.rate for d in each), _array(d.acceleration for d in each)
        drivers.append(replace(each[0], value=value, rate=rate, acceleration=acceleration))
    return replace(first, links=links, pairs=tuple(pairs), drivers=tuple(drivers), poses=poses, sketch=sketch)


def _array(numbers: Iterable[complex]) -> Stacked:
    return np.array([*numbers])


def cut(value: Value, part: slice | int, count: int = 0) -> Value:
    """Of some mechanisms, or of one; what all of them share stays."""
    if not isinstance(value, np.ndarray) or value.ndim == 0:
        return value
    if count > 1 and value.shape[-1] == 1:
        return value if isinstance(part, slice) else value[..., 0]
    return value[..., part]


def count_of(mechanism: Mechanism) -> int:
    """The number of mechanisms that lie side by side."""
    shapes: list[tuple[int, ...]] = []

    def noted(value: Stacked) -> Stacked:
        shapes.append(np.shape(value))
        return value

    _with_numbers(mechanism, noted)
    return int(np.prod(np.broadcast_shapes(*shapes)))


def single(mechanism: Mechanism, row: int) -> Mechanism:
    """One of many mechanisms that lie side by side."""
    return _with_numbers(mechanism, lambda value: value[row].item() if np.ndim(value) else value)


def _with_numbers(mechanism: Mechanism, make: Callable[[Stacked], Stacked]) -> Mechanism:
    """The mechanism with other values for all numbers that may be arrays."""
    links = {name: replace(link, points={point: make(z) for point, z in link.points.items()})
             for name, link in mechanism.links.items()}  # fmt: skip
    pairs = tuple(replace(pair, line=replace(pair.line, direction=make(pair.line.direction)), tilt=make(pair.tilt))
                  if isinstance(pair, Slide) else pair for pair in mechanism.pairs)  # fmt: skip
    poses = tuple(replace(pose, value=make(pose.value)) for pose in mechanism.poses)
    drivers = tuple(replace(each, value=None if each.value is None else make(each.value), rate=make(each.rate),
                            acceleration=make(each.acceleration)) for each in mechanism.drivers)  # fmt: skip
    sketch = {point: make(z) for point, z in mechanism.sketch.items()}
    return replace(mechanism, links=links, pairs=pairs, drivers=drivers, poses=poses, sketch=sketch)
