"""The obstacles of labels: everything drawn, as lines; an area by its rim, and lines through it that leave no letter
room between them."""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Iterator, Sequence
from copy import copy
from itertools import pairwise

import numpy as np

from graphkin.base.boxes import beyond, meet, xy
from graphkin.base.geometry import Array
from graphkin.sheet.lettering import box
from graphkin.sheet.marks import ArcMark, Disc, Mark, Place, PointMark, Stroke, Text, VectorMark

_TIP, _TIP_HALF = 2.8, 0.5  # length and half width of an arrow head [mm]
_LETTER = 2.0  # no letter is much narrower [mm]
_AT_ONCE, _PAIRS = 128, 32_000  # so many boxes are held against lines at once, or as many as make so many pairs
_CIRCLE = tuple(cmath.rect(1, k * cmath.pi / 12) for k in range(25))


class Obstacles:
    """Line segments by place; _across: what a millimetre to the right and one down count across each, to its left as it
    goes down: one together; of one without a length, as if it went down (2, n)."""

    def __init__(self, start: Array, end: Array) -> None:
        """start, end: of the segments (2, n)."""
        self._start, self._end, along = start, end, end - start
        self._low, self._high = np.minimum(start, end), np.maximum(start, end)
        along[1] += (along == 0).all(axis=0)
        self._across = np.array([-along[1], along[0]]) / (np.where(along[1] < 0, -1.0, 1.0) * abs(along).sum(axis=0))

    def __add__(self, other: Obstacles) -> Obstacles:
        """Both together."""
        both = copy(self)
        for name, own in vars(other).items():
            setattr(both, name, np.concatenate([getattr(self, name), own], axis=1))
        return both

    def _beside(self, low: Array, high: Array) -> Iterator[tuple[Array, Array]]:
        """Pairs of boxes low..high (2, n) and of lines whose surroundings touch them, by their numbers."""
        some = max(_AT_ONCE, _PAIRS // max(1, self._low.shape[1]))
        for first in range(0, low.shape[1], some):
            least, most = low[:, first : first + some], high[:, first : first + some]
            there = (self._low <= most.max(axis=1)[:, None]) & (self._high >= least.min(axis=1)[:, None])
            if len(lines := np.flatnonzero(there[0] & there[1])):
                begin, end = self._low.take(lines, axis=1)[:, None], self._high.take(lines, axis=1)[:, None]
                near = (begin <= most[:, :, None]) & (end >= least[:, :, None])
                boxes, which = np.nonzero(near[0] & near[1])
                yield boxes + first, lines.take(which)

    def touched(self, low: Array, high: Array) -> Array:
        """True for those of the boxes low..high (2, n) that touch something."""
        return np.asarray(self.around(low, high, (0.0,))[0] > 0)

    def around(self, low: Array, high: Array, margins: Sequence[float]) -> Array:
        """To how many lines each of the boxes low..high (2, n) is nearer than each of some margins [mm]."""
        counts, far = np.zeros((len(margins), low.shape[1]), dtype=np.intp), max(margins)
        middle, half = (low + high) / 2, (high - low) / 2
        for boxes, lines in self._beside(low - far, high + far):
            across, off = self._across.take(lines, axis=1), middle.take(boxes, axis=1) - self._start.take(lines, axis=1)
            wide = half.take(boxes, axis=1)  # the growth of a box to all sides with which it reaches the line
            apart = abs(across[0] * off[0] + across[1] * off[1]) - abs(across[0]) * wide[0] - abs(across[1]) * wide[1]
            boxes, lines, apart = (each[apart <= far] for each in (boxes, lines, apart))
            if far:  # or its surroundings
                ends = self._low.take(lines, axis=1), self._high.take(lines, axis=1)
                apart = np.maximum(apart, beyond(*ends, low.take(boxes, axis=1), high.take(boxes, axis=1)))
            for count, margin in zip(counts, margins, strict=True):
                count += np.bincount(boxes[apart <= margin], minlength=len(count))
        return counts

    def crossed(self, start: Array, end: Array) -> Array:
        """Numbers of lines that the lines start..end (2, n) cross."""
        count = np.zeros(start.shape[1], dtype=np.intp)
        for rows, lines in self._beside(np.minimum(start, end), np.maximum(start, end)):
            others = self._start.take(lines, axis=1), self._end.take(lines, axis=1)
            crossing = meet(start.take(rows, axis=1), end.take(rows, axis=1), *others)
            count += np.bincount(rows[crossing], minlength=len(count))
        return count


def obstacles(drawn: Iterable[Mark]) -> Obstacles:
    """The marks as obstacles: their outlines, and what fills them."""
    lines: list[Sequence[Place]] = []
    for mark in drawn:
        for outline, filled in _outlines(mark):
            lines.append(outline)
            if filled:
                lines += _levels(outline)
    places = xy(np.array([place for line in lines for place in line], dtype=complex))
    start = np.delete(np.arange(places.shape[1]), np.cumsum([len(line) for line in lines], dtype=np.intp) - 1)
    return Obstacles(places.take(start, axis=1), places.take(start + 1, axis=1))


def _levels(outline: Sequence[Place]) -> Iterator[tuple[Place, Place]]:
    """Level lines through an area, from rim to rim, so close that no letter has room between them."""
    low, high = min(place.imag for place in outline), max(place.imag for place in outline)
    count = int((high - low) / _LETTER)
    for level in (low + (high - low) * k / (count + 1) for k in range(1, count + 1)):
        sides = [(a, b) for a, b in pairwise(outline) if (a.imag <= level) != (b.imag <= level)]
        cuts = sorted(a.real + (b - a).real * (level - a.imag) / (b - a).imag for a, b in sides)
        yield from ((complex(x, level), complex(other, level)) for x, other in zip(cuts[::2], cuts[1::2], strict=True))


def _outlines(mark: Mark) -> Iterator[tuple[Sequence[Place], bool]]:
    """Polylines that a mark is made of, and whether what is in them is filled."""
    match mark:
        case Stroke(places, closed=closed, fill=fill):
            yield (*places, places[0]) if closed else places, closed and fill not in ("none", "tint")
        case Disc(centre, radius, fill=fill):
            yield [centre + radius * turn for turn in _CIRCLE], fill not in ("none", "tint")
        case ArcMark():
            yield arc_places(mark), False
        case Text(label, at, size):
            (wide, up, down), turn = box(label, size), cmath.rect(1, mark.turn)
            corners = (1j * down, wide + 1j * down, wide - 1j * up, -1j * up, 1j * down)
            yield [at + turn * corner for corner in corners], True
        case VectorMark(start=start, end=end):
            yield (start, end), False
            if abs(end - start) > _TIP:
                along = (end - start) / abs(end - start)
                back, half = end - along * _TIP, along * 1j * _TIP_HALF
                yield (back + half, end, back - half), False
        case PointMark(at=at, radius=radius):
            yield [at + radius * turn for turn in _CIRCLE[::3]], False


def arc_places(arc: ArcMark, fine: float = 1.0) -> tuple[Place, ...]:
    """A polyline close to an arc; fine: so many times as many places."""
    count = max(4, int(abs(arc.sweep) * 8 * fine))
    return tuple(arc.centre + cmath.rect(arc.radius, arc.start + arc.sweep * k / count) for k in range(count + 1))


def bounds(drawn: Iterable[Mark]) -> tuple[float, float, float, float]:
    """Left, top, right, bottom of all marks [mm]."""
    places = [place for mark in drawn for outline, _ in _outlines(mark) for place in outline]
    xs, ys = [p.real for p in places] or [0.0], [p.imag for p in places] or [0.0]
    return min(xs), min(ys), max(xs), max(ys)


def places(drawn: Iterable[Mark], apart: float = _LETTER) -> tuple[Array, Array]:
    """Places on marks, no farther apart along their outlines than that [mm] (2, n), and the number of each's mark."""
    outlines = [(number, outline) for number, mark in enumerate(drawn) for outline, _ in _outlines(mark)]
    start = np.array([place for _, outline in outlines for place in outline[:-1]], dtype=complex)
    end = np.array([place for _, outline in outlines for place in outline[1:]], dtype=complex)
    count = np.ceil(abs(end - start) / apart).astype(np.intp) + 1
    number = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    on = np.repeat(start, count) + np.repeat((end - start) / np.maximum(count - 1, 1), count) * number
    owner = np.repeat([mark for mark, _ in outlines], [len(outline) - 1 for _, outline in outlines])
    return xy(on), np.repeat(owner, count).astype(np.intp)
