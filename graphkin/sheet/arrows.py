"""Arrows of a polygon that would lie on one another: side by side, and their heads apart.

Arrows on one line are drawn beside it, both ends moved alike, at right angles to it, by a whole number of `ASIDE`: so a
ruler reads them as before, and sees from the points at their ends that they were moved. Heads that meet at one point
under a small angle open outwards only; those between two others stand back from the point.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import count

import numpy as np

from graphkin.base.geometry import Array
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.marks import Half, Mark, PointMark, VectorMark
from graphkin.sheet.window import Figure

ASIDE = 1.2  # arrows on one line are drawn so far apart [mm]
_ON, _ALONG = 0.3, 1.0
"""Nearer than this to a line, over more than this of it, an arrow lies on it [mm]."""
_SHORT = 0.9  # shorter arrows stay where they are [mm]
_NO_LENGTH = 1e-9  # nothing is divided by less [mm]
_SAME = 0.2  # heads nearer than this are at one place [mm]
_MELT = math.radians(22)  # under a smaller angle two heads become one to the eye
_STEP = 3.4  # from a head to the next one behind it [mm]


def side_by_side(figure: Figure) -> Figure:
    """The figure with its arrows beside one another; their labels go with them."""
    vectors = [mark for mark in figure.marks if isinstance(mark, VectorMark)]
    asides = {(v.plane, v.name): aside for v, aside in zip(vectors, _asides(vectors), strict=True) if aside}

    def moved(mark: Mark) -> Mark:
        if not isinstance(mark, VectorMark) or (aside := asides.get((mark.plane, mark.name))) is None:
            return mark
        return replace(mark, start=mark.start + aside, end=mark.end + aside, aside=round(abs(aside) / ASIDE))

    by_name, labels = {name: aside for (_, name), aside in asides.items()}, list[LabelRequest]()
    for want in figure.wanted:  # a label stands on the side to which its arrow was moved
        if want.of in by_name and want.end is not None:
            aside = by_name[want.of]
            want = replace(want, start=want.start + aside, end=want.end + aside, away=aside)
        labels.append(want)
    return Figure([moved(mark) for mark in figure.marks], labels)


def _asides(vectors: Sequence[VectorMark]) -> Iterator[complex]:
    """The shift of each arrow: the least that keeps it off those before it."""
    start, end = (np.array([getattr(v, side) for v in vectors], dtype=complex) for side in ("start", "end"))
    planes, moved = np.array([vector.plane for vector in vectors]), np.zeros(len(vectors), dtype=bool)
    long = np.abs(end - start) >= _SHORT
    before = np.tri(len(vectors), k=-1, dtype=bool) & (planes == planes[:, None]) & long & long[:, None]
    meeting = before & _run_along(start[:, None], end[:, None], start, end)
    for k, vector in enumerate(vectors):
        if not (meeting[k] & ~moved).any() and not _met(vector.start, vector.end, start, end, before[k] & moved):
            yield 0j
            continue
        normal = 1j * (vector.end - vector.start) / vector.length if vector.length > _SHORT else 0j
        if (normal.imag, normal.real) > (0, 0):
            normal = -normal
        shifts = (normal * ASIDE * ((turn + 1) // 2) * (1 if turn % 2 else -1) for turn in count(1))
        free = (s for s in shifts if not s or not _met(vector.start + s, vector.end + s, start, end, before[k]))
        aside = next(free)
        start[k], end[k], moved[k] = vector.start + aside, vector.end + aside, bool(aside)
        yield aside


def _met(start: complex, end: complex, starts: Array, ends: Array, others: Array) -> bool:
    """True for an arrow that runs along one of some others."""
    return bool(others.any() and _run_along(start, end, starts[others], ends[others]).any())


def _run_along(start: complex | Array, end: complex | Array, starts: Array, ends: Array) -> Array:
    """True where an arrow runs along another; none does along one without a length."""
    length = np.abs(end - start)
    along = ((end - start) / np.maximum(length, _NO_LENGTH)).conjugate()
    one, other = (starts - start) * along, (ends - start) * along
    near = np.maximum(np.abs(one.imag), np.abs(other.imag)) < _ON
    low, high = np.minimum(one.real, other.real), np.maximum(one.real, other.real)
    return near & (np.minimum(length, high) - np.maximum(0.0, low) > _ALONG)


def heads_apart(figure: Figure) -> Figure:
    """The figure with its arrow heads at the rims of the dots they point to, and off one another."""
    vectors = [mark for mark in figure.marks if isinstance(mark, VectorMark) and mark.length > _SHORT]
    dots = [mark for mark in figure.marks if isinstance(mark, PointMark) and mark.fill == "ink"]
    ends = np.array([vector.end for vector in vectors], dtype=complex)
    changed: dict[int, VectorMark] = {}
    for vector in vectors:  # with the head that leaves those near it their own
        near = [vectors[k] for k in np.flatnonzero(np.abs(ends - vector.end) < _SAME)]
        rim = max((dot.radius for dot in dots if abs(dot.at - vector.end) < _SAME), default=0.0)
        own = vector.start - vector.end
        turns = [-cmath.phase((v.start - v.end) / own) or 1e-9 for v in near if v is not vector]
        left = [turn for turn in turns if -_MELT < turn <= 0]  # those that come from the left of it, looking along it
        right = [turn for turn in turns if 0 < turn < _MELT]
        half: Half = "" if left and right else "right" if left else "left" if right else ""
        changed[id(vector)] = replace(vector, half=half, back=rim + (_STEP if left and right else 0.0))
    return Figure([changed.get(id(mark), mark) for mark in figure.marks], figure.wanted)
