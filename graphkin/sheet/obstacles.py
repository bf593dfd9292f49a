"""What labels keep away from: everything drawn, as lines and areas."""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from graphkin.sheet.areas import Areas
from graphkin.sheet.blocks import Blocks
from graphkin.sheet.edges import Edges
from graphkin.sheet.lettering import box
from graphkin.sheet.marks import ArcMark, Disc, Mark, Place, PointMark, Stroke, Text, VectorMark

if TYPE_CHECKING:
    from numpy.typing import NDArray

_TIP, _TIP_HALF = 2.8, 0.5
"""Length and half width of an arrow head [mm]."""
_LETTER = 2.0
"""No letter is much narrower [mm]."""
_SAME = 1e-9
"""Corners so close together are one [mm]."""
_CIRCLE = tuple(cmath.rect(1, k * cmath.pi / 12) for k in range(25))


class Obstacles:
    """All of it by place: line segments, and areas.

    Boxes are held against them in blocks of a few that are close together: most of what is drawn is far from a block,
    and asked one by one boxes would take longer than all else of a crowded sheet.
    """

    def __init__(self, start: Any, end: Any, areas: Sequence[Sequence[Place]]) -> None:
        """start, end: of the segments (2, n); areas: the corners of each."""
        self._lines, self._areas = Edges.of(start, end), Areas(areas)

    def touched(self, low: NDArray[np.float64], high: NDArray[np.float64]) -> NDArray[np.intp]:
        """Rows of the boxes low..high (n, 2) that touch something, once for each thing touched."""
        return _rows(self.around(low.T, high.T, (0.0,))[0])

    def around(self, low: Any, high: Any, margins: Sequence[float]) -> list[Any]:
        """To how many things each of the boxes low..high (2, n) is nearer than each of some margins [mm]."""
        if not low.shape[1]:
            return [np.zeros(0, dtype=np.intp) for _ in margins]
        most = max(margins)
        blocks, within = Blocks.of(low - most, high + most), [margin - most for margin in margins]
        found = [np.zeros(blocks.low.shape[1:], dtype=np.intp) for _ in margins]
        for block, lines in blocks.beside(self._lines.low, self._lines.high):
            apart = self._lines.apart(lines[:, None], *blocks.taken(block))
            for count, margin in zip(found, within, strict=True):
                _add(count, block, apart <= margin)
        for boxes, apart in self._areas.touched(blocks):
            for count, margin in zip(found, within, strict=True):
                count += np.bincount(boxes[apart <= margin], minlength=count.size).reshape(count.shape)
        return [blocks.back(count) for count in found]

    def crossed(self, start: NDArray[np.float64], end: NDArray[np.float64]) -> NDArray[np.intp]:
        """Rows of the lines start..end (n, 2) that touch something, once for each thing touched."""
        if not len(start):
            return np.zeros(0, dtype=np.intp)
        blocks = Blocks.of(np.minimum(start, end).T, np.maximum(start, end).T)
        start, end = start.T.take(blocks.order, axis=1), end.T.take(blocks.order, axis=1)
        found = np.zeros(blocks.low.shape[1:], dtype=np.intp)
        ends = start.reshape(blocks.low.shape), end.reshape(blocks.low.shape)
        for block, lines in blocks.beside(self._lines.low, self._lines.high):
            _add(found, block, self._lines.met(lines[:, None], *(each.take(block, axis=1) for each in ends)))
        for met in self._areas.met(blocks, start, end):
            found += np.bincount(met, minlength=found.size).reshape(found.shape)
        return _rows(blocks.back(found))


def _add(count: Any, blocks: Any, found: Any) -> None:
    """Things found beside boxes of blocks (m, size), block by block, are counted."""
    first = np.flatnonzero(np.concatenate([[True], blocks[1:] != blocks[:-1]]))
    count[blocks[first]] += np.add.reduceat(found, first, axis=0, dtype=np.intp)


def _rows(counts: NDArray[np.intp]) -> NDArray[np.intp]:
    """Each row as often as something was counted for it."""
    return np.repeat(np.arange(len(counts)), counts)


def obstacles(drawn: Iterable[Mark]) -> Obstacles:
    """The marks as obstacles."""
    lines: list[Place] = []
    areas: list[tuple[Place, ...]] = []
    for mark in drawn:
        for places, filled in _outlines(mark):
            if filled:
                areas.append(places[:-1] if abs(places[-1] - places[0]) < _SAME else places)
            else:
                for ends in pairwise(places):
                    lines += ends
    corners = np.array(lines, dtype=complex)
    xy = np.array([corners.real, corners.imag])
    return Obstacles(xy[:, ::2], xy[:, 1::2], areas)


def _outlines(mark: Mark) -> Iterator[tuple[tuple[Place, ...], bool]]:
    """Polylines and filled areas a mark is made of."""
    match mark:
        case Stroke(places, closed=closed, fill=fill):
            yield (*places, places[0]) if closed else places, closed and fill not in ("none", "tint")
        case Disc(centre, radius, fill=fill):
            yield tuple(centre + radius * turn for turn in _CIRCLE), fill not in ("none", "tint")
        case ArcMark():
            yield arc_places(mark), False
        case Text(label, at, size):
            yield _frame(label, at, size), True
        case VectorMark(start=start, end=end):
            yield (start, end), False
            if abs(end - start) > _TIP:
                yield _tip(start, end), True
        case PointMark(at=at, radius=radius):
            yield tuple(at + radius * turn for turn in _CIRCLE[::3]), True


def arc_places(arc: ArcMark) -> tuple[Place, ...]:
    """A polyline close to an arc."""
    count = max(4, int(abs(arc.sweep) * 8))
    return tuple(arc.centre + cmath.rect(arc.radius, arc.start + arc.sweep * k / count) for k in range(count + 1))


def _tip(start: Place, end: Place) -> tuple[Place, ...]:
    along = (end - start) / abs(end - start)
    back = end - along * _TIP
    return end, back + along * 1j * _TIP_HALF, back - along * 1j * _TIP_HALF


def _frame(label: Any, at: Place, size: float) -> tuple[Place, ...]:
    wide, up, down = box(label, size)
    return at + 1j * down, at + wide + 1j * down, at + wide - 1j * up, at - 1j * up


def bounds(drawn: Iterable[Mark]) -> tuple[float, float, float, float]:
    """Left, top, right, bottom of all marks [mm]."""
    places = [place for mark in drawn for outline, _ in _outlines(mark) for place in outline]
    xs, ys = [p.real for p in places] or [0.0], [p.imag for p in places] or [0.0]
    return min(xs), min(ys), max(xs), max(ys)


def places(drawn: Iterable[Mark]) -> Any:
    """Some places on all marks, no farther apart along their outlines than a letter is wide (2, n)."""
    outlines = [outline for mark in drawn for outline, _ in _outlines(mark)]
    start = np.array([place for outline in outlines for place in outline[:-1]], dtype=complex)
    end = np.array([place for outline in outlines for place in outline[1:]], dtype=complex)
    count = np.ceil(abs(end - start) / _LETTER).astype(np.intp) + 1
    number = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    along = np.repeat(start, count) + np.repeat((end - start) / np.maximum(count - 1, 1), count) * number
    return np.array([along.real, along.imag])
