"""The obstacles of labels: everything drawn, as lines and filled areas."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property
from itertools import pairwise

import numpy as np

from graphkin.base.geometry import Array
from graphkin.sheet.boxes import Blocks, Edges, beyond, through, xy
from graphkin.sheet.lettering import box
from graphkin.sheet.marks import ArcMark, Disc, Mark, Place, PointMark, Stroke, Text, VectorMark

_SIDES = 4  # an area of no more sides, all level or upright, is a rectangle
_ROUNDED = 1e-9  # a touch is not lost by rounding [mm]


class Areas:
    """Areas by their edges, one area after the other: of any shape, inside one another or not.

    _first, _count  where the edges of each begin, and how many there are; _way: from corner to corner, complex [mm]
    _low, _high     corners of what each lies in (2, k) [mm]; _plain: those that are all of that, as letters are
    """

    def __init__(self, areas: Sequence[Sequence[Place]]) -> None:
        """areas: the corners of each."""
        corners = np.array([place for area in areas for place in area], dtype=complex)
        nexts = np.array([place for area in areas for place in (*area[1:], area[0])], dtype=complex)
        self._edges, self._way = Edges.of(xy(corners), xy(nexts)), nexts - corners
        self._count = np.array([len(area) for area in areas], dtype=np.intp)
        self._first = np.cumsum(self._count) - self._count
        self._low, self._high, slanted = self._edges.low, self._edges.high, self._edges.across.all(axis=0)
        if areas:
            self._low = np.minimum.reduceat(self._low, self._first, axis=1)
            self._high = np.maximum.reduceat(self._high, self._first, axis=1)
            slanted = np.logical_or.reduceat(slanted, self._first)
        self._plain = ~slanted & (self._count <= _SIDES)

    @cached_property
    def _shapes(self) -> tuple[Array, Array, list[int]]:
        """On which side of each edge its area does not lie, 1 where that is the left as it goes down, else -1; which
        areas bulge nowhere inwards, nor go round twice, and the numbers of their edges."""
        way, first, count = self._way, self._first, self._count
        after = np.arange(1, len(way) + 1)
        after[first + count - 1] = first
        turn = np.angle(way[after] * way.conj())
        whole = np.add.reduceat(turn, first) if len(first) else turn
        owner = np.repeat(np.arange(len(first)), count)
        inwards = (turn * whole[owner] <= 0) | (way == 0)
        odd = np.bincount(owner, inwards, len(first)) > 0
        round_ = ~odd & (abs(abs(whole) - math.tau) < 1)
        out = np.where((way.imag >= 0) == (whole[owner] > 0), -1.0, 1.0)
        return out, round_, sorted(set(count[round_ & ~self._plain].tolist()))

    def touched(self, blocks: Blocks) -> Iterator[tuple[Array, Array]]:
        """Boxes (where they stand in blocks) that touch an area, once for each, and by how much they would have to
        grow to reach it: less than 0 [mm]."""
        low, high = blocks.low.reshape(2, -1), blocks.high.reshape(2, -1)
        for boxes, areas in self._about(blocks):
            corners = low.take(boxes, axis=1), high.take(boxes, axis=1)
            apart = beyond(self._low.take(areas, axis=1), self._high.take(areas, axis=1), *corners)
            shaped = np.flatnonzero(~self._plain[areas])
            if len(shaped):
                inner = (corner.take(shaped, axis=1) for corner in corners)
                apart[shaped] = np.maximum(apart[shaped], self._beyond_sides(areas[shaped], *inner))
            on = np.flatnonzero(apart <= 0)
            yield boxes[on], apart[on]

    def met(self, blocks: Blocks, start: Array, end: Array) -> Iterator[Array]:
        """Lines (where what they lie in stands in blocks) that meet an area, once for each; start, end: so ordered."""
        for lines, areas in self._about(blocks):
            low, high = self._low.take(areas, axis=1) - _ROUNDED, self._high.take(areas, axis=1) + _ROUNDED
            near = through(start.take(lines, axis=1), end.take(lines, axis=1), low, high)
            lines, areas = lines[near], areas[near]
            if len(lines):
                first, owner, edges = self._spread(areas)
                lying = lines[owner]
                ends = end.take(lying, axis=1)
                met = self._edges.met(edges, start.take(lying, axis=1), ends, touch=True)
                odd = np.add.reduceat(self._edges.passed(edges, ends), first, dtype=np.intp) & 1
                yield lines[np.logical_or.reduceat(met, first) | (odd > 0)]

    def _about(self, blocks: Blocks) -> Iterator[tuple[Array, Array]]:
        """Boxes (where they stand in blocks) and the areas whose surroundings they touch."""
        for block, areas in blocks.beside(self._low, self._high):
            low, high = self._low.take(areas[:, None], axis=1), self._high.take(areas[:, None], axis=1)
            pair, place = np.nonzero(beyond(low, high, *blocks.taken(block)) <= 0)
            yield block[pair] * blocks.low.shape[2] + place, areas[pair]

    def _beyond_sides(self, areas: Array, low: Array, high: Array) -> Array:
        """The length by which each box would have to grow to reach across all sides of the area it is paired with."""
        growth, (out, round_, counts) = np.empty(len(areas)), self._shapes
        for sides in counts:
            rows = np.flatnonzero(round_[areas] & (self._count[areas] == sides))
            edges = self._first[areas[rows]] + np.arange(sides)[:, None]
            corners = low.take(rows, axis=1)[:, None], high.take(rows, axis=1)[:, None]
            growth[rows] = self._edges.outside(edges, out.take(edges), *corners).max(axis=0)
        rows = np.flatnonzero(~round_[areas])
        if len(rows):  # of any shape: what holds a box's middle, or has an edge there, is reached
            first, owner, edges = self._spread(areas[rows])
            low, high = low.take(rows[owner], axis=1), high.take(rows[owner], axis=1)
            apart = np.minimum.reduceat(self._edges.apart(edges, low, high), first)
            odd = np.add.reduceat(self._edges.passed(edges, (low + high) / 2), first, dtype=np.intp) & 1
            growth[rows] = np.where(odd, -np.inf, apart)
        return growth

    def _spread(self, areas: Array) -> tuple[Array, Array, Array]:
        """All edges of some areas: where those of each begin, of which of them they are, and which edges."""
        count = self._count[areas]
        first = np.cumsum(count) - count
        owner = np.repeat(np.arange(len(areas)), count)
        return first, owner, np.arange(len(owner)) + (self._first[areas] - first)[owner]


_TIP, _TIP_HALF = 2.8, 0.5
"""Length and half width of an arrow head [mm]."""
_LETTER = 2.0  # no letter is much narrower [mm]
_SAME = 1e-9  # corners so close together are one [mm]
_CIRCLE = tuple(cmath.rect(1, k * cmath.pi / 12) for k in range(25))


class Obstacles:
    """All of it by place: line segments, and areas.

    Boxes are held against them in blocks of a few that are close together: most of what is drawn is far from a block,
    and asked one by one boxes would take longer than all else of a crowded sheet.
    """

    def __init__(self, start: Array, end: Array, areas: Sequence[Sequence[Place]]) -> None:
        """start, end: of the segments (2, n); areas: the corners of each."""
        self._lines, self._areas = Edges.of(start, end), Areas(areas)

    def touched(self, low: Array, high: Array) -> Array:
        """Rows of the boxes low..high (n, 2) that touch something, once for each thing touched."""
        return _rows(self.around(low.T, high.T, (0.0,))[0])

    def around(self, low: Array, high: Array, margins: Sequence[float]) -> list[Array]:
        """To how many things each of the boxes low..high (2, n) is nearer than each of some margins [mm]."""
        if not low.shape[1]:
            return [np.zeros(0, dtype=np.intp) for _ in margins]
        most = max(margins)
        blocks, within = Blocks.of(low - most, high + most), [margin - most for margin in margins]
        counts = [np.zeros(blocks.low.shape[1:], dtype=np.intp) for _ in margins]
        for block, lines in blocks.beside(self._lines.low, self._lines.high):
            apart = self._lines.apart(lines[:, None], *blocks.taken(block))
            for count, margin in zip(counts, within, strict=True):
                _add(count, block, apart <= margin)
        for boxes, apart in self._areas.touched(blocks):
            for count, margin in zip(counts, within, strict=True):
                count += np.bincount(boxes[apart <= margin], minlength=count.size).reshape(count.shape)
        return [blocks.back(count) for count in counts]

    def crossed(self, start: Array, end: Array) -> Array:
        """Rows of the lines start..end (n, 2) that touch something, once for each thing touched."""
        if not len(start):
            return np.zeros(0, dtype=np.intp)
        blocks = Blocks.of(np.minimum(start, end).T, np.maximum(start, end).T)
        start, end = start.T.take(blocks.order, axis=1), end.T.take(blocks.order, axis=1)
        counts = np.zeros(blocks.low.shape[1:], dtype=np.intp)
        first, last = start.reshape(blocks.low.shape), end.reshape(blocks.low.shape)
        for block, lines in blocks.beside(self._lines.low, self._lines.high):
            met = self._lines.met(lines[:, None], first.take(block, axis=1), last.take(block, axis=1))
            _add(counts, block, met)
        for met in self._areas.met(blocks, start, end):
            counts += np.bincount(met, minlength=counts.size).reshape(counts.shape)
        return _rows(blocks.back(counts))


def _add(count: Array, blocks: Array, hits: Array) -> None:
    """Count the hits beside boxes of blocks (m, size), block by block."""
    first = np.flatnonzero(np.concatenate([[True], blocks[1:] != blocks[:-1]]))
    count[blocks[first]] += np.add.reduceat(hits, first, axis=0, dtype=np.intp)


def _rows(counts: Array) -> Array:
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
                for pair in pairwise(places):
                    lines += pair
    ends = xy(np.array(lines, dtype=complex))
    return Obstacles(ends[:, ::2], ends[:, 1::2], areas)


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
            (wide, up, down), turn = box(label, size), cmath.rect(1, mark.turn)
            corners = (1j * down, wide + 1j * down, wide - 1j * up, -1j * up)
            yield tuple(at + turn * corner for corner in corners), True
        case VectorMark(start=start, end=end):
            yield (start, end), False
            if abs(end - start) > _TIP:
                along = (end - start) / abs(end - start)
                back, half = end - along * _TIP, along * 1j * _TIP_HALF
                yield (end, back + half, back - half), True
        case PointMark(at=at, radius=radius):
            yield tuple(at + radius * turn for turn in _CIRCLE[::3]), True


def arc_places(arc: ArcMark) -> tuple[Place, ...]:
    """A polyline close to an arc."""
    count = max(4, int(abs(arc.sweep) * 8))
    return tuple(arc.centre + cmath.rect(arc.radius, arc.start + arc.sweep * k / count) for k in range(count + 1))


def bounds(drawn: Iterable[Mark]) -> tuple[float, float, float, float]:
    """Left, top, right, bottom of all marks [mm]."""
    places = [place for mark in drawn for outline, _ in _outlines(mark) for place in outline]
    xs, ys = [p.real for p in places] or [0.0], [p.imag for p in places] or [0.0]
    return min(xs), min(ys), max(xs), max(ys)


def places(drawn: Iterable[Mark], apart: float = _LETTER) -> Array:
    """Some places on all marks, no farther apart along their outlines than a letter is wide (2, n)."""
    outlines = [outline for mark in drawn for outline, _ in _outlines(mark)]
    start = np.array([place for outline in outlines for place in outline[:-1]], dtype=complex)
    end = np.array([place for outline in outlines for place in outline[1:]], dtype=complex)
    count = np.ceil(abs(end - start) / apart).astype(np.intp) + 1
    number = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    return xy(np.repeat(start, count) + np.repeat((end - start) / np.maximum(count - 1, 1), count) * number)
