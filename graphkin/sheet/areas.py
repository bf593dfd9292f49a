"""Filled areas on paper, many at once: how far from boxes they are, and which lines meet them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from graphkin.sheet.blocks import Blocks
from graphkin.sheet.crossings import through
from graphkin.sheet.edges import Edges, beyond
from graphkin.sheet.marks import Place

_SIDES = 4
"""An area of no more sides, all level or upright, is a rectangle."""

_ROUNDED = 1e-9
"""What only touches is not lost by rounding [mm]."""


class Areas:
    """Areas by their edges, one area after the other: of any shape, inside one another or not.

    _first, _count  where the edges of each begin, and how many there are; _way: from corner to corner, complex [mm]
    _low, _high     corners of what each lies in (2, k) [mm]; _plain: those that are all of that, as letters are
    """

    def __init__(self, areas: Sequence[Sequence[Place]]) -> None:
        """areas: the corners of each."""
        corners = np.array([place for area in areas for place in area], dtype=complex)
        nexts = np.array([place for area in areas for place in (*area[1:], area[0])], dtype=complex)
        self._edges, self._way = Edges.of(_xy(corners), _xy(nexts)), nexts - corners
        self._count = np.array([len(area) for area in areas], dtype=np.intp)
        self._first = np.cumsum(self._count) - self._count
        self._low, self._high, slanted = self._edges.low, self._edges.high, self._edges.across.all(axis=0)
        if areas:
            self._low = np.minimum.reduceat(self._low, self._first, axis=1)
            self._high = np.maximum.reduceat(self._high, self._first, axis=1)
            slanted = np.logical_or.reduceat(slanted, self._first)
        self._plain = ~slanted & (self._count <= _SIDES)

    @cached_property
    def _shapes(self) -> tuple[Any, Any, list[int]]:
        """Where edges face; which areas bulge nowhere inwards, and how many edges these have. For boxes close by."""
        out, round_ = _outwards(self._way, self._first, self._count)
        return out, round_, sorted(set(self._count[round_ & ~self._plain].tolist()))

    def touched(self, blocks: Blocks) -> Iterator[tuple[Any, Any]]:
        """Boxes (where they stand in blocks) that touch an area, once for each, and by how much they would have to
        grow to reach it: less than 0 [mm]."""
        low, high = blocks.low.reshape(2, -1), blocks.high.reshape(2, -1)
        for boxes, areas in self._about(blocks):
            apart = self._apart(areas, low.take(boxes, axis=1), high.take(boxes, axis=1))
            on = np.flatnonzero(apart <= 0)
            yield boxes[on], apart[on]

    def met(self, blocks: Blocks, start: Any, end: Any) -> Iterator[Any]:
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

    def _about(self, blocks: Blocks) -> Iterator[tuple[Any, Any]]:
        """Boxes (where they stand in blocks) and the areas whose surroundings they touch."""
        for block, areas in blocks.beside(self._low, self._high):
            low, high = self._low.take(areas[:, None], axis=1), self._high.take(areas[:, None], axis=1)
            pair, place = np.nonzero(beyond(low, high, *blocks.taken(block)) <= 0)
            yield block[pair] * blocks.low.shape[2] + place, areas[pair]

    def _apart(self, areas: Any, low: Any, high: Any) -> Any:
        """By how much each box would have to grow to reach the area it is paired with."""
        found = beyond(self._low.take(areas, axis=1), self._high.take(areas, axis=1), low, high)
        shaped = np.flatnonzero(~self._plain[areas])
        if len(shaped):
            low, high, areas = low.take(shaped, axis=1), high.take(shaped, axis=1), areas[shaped]
            found[shaped] = np.maximum(found[shaped], self._beyond_sides(areas, low, high))
        return found

    def _beyond_sides(self, areas: Any, low: Any, high: Any) -> Any:
        """By how much each box would have to grow to reach across all sides of the area it is paired with."""
        found, (out, round_, counts) = np.empty(len(areas)), self._shapes
        for sides in counts:
            rows = np.flatnonzero(round_[areas] & (self._count[areas] == sides))
            edges = self._first[areas[rows]] + np.arange(sides)[:, None]
            corners = low.take(rows, axis=1)[:, None], high.take(rows, axis=1)[:, None]
            found[rows] = self._edges.outside(edges, out.take(edges), *corners).max(axis=0)
        rows = np.flatnonzero(~round_[areas])
        if len(rows):
            found[rows] = self._from_edges(areas[rows], low.take(rows, axis=1), high.take(rows, axis=1))
        return found

    def _from_edges(self, areas: Any, low: Any, high: Any) -> Any:
        """The same of areas of any shape: what holds a box's middle, or has an edge there, is reached."""
        first, owner, edges = self._spread(areas)
        low, high = low.take(owner, axis=1), high.take(owner, axis=1)
        apart = np.minimum.reduceat(self._edges.apart(edges, low, high), first)
        odd = np.add.reduceat(self._edges.passed(edges, (low + high) / 2), first, dtype=np.intp) & 1
        return np.where(odd, -np.inf, apart)

    def _spread(self, areas: Any) -> tuple[Any, Any, Any]:
        """All edges of some areas: where those of each begin, of which of them they are, and which edges."""
        count = self._count[areas]
        first = np.cumsum(count) - count
        owner = np.repeat(np.arange(len(areas)), count)
        return first, owner, np.arange(len(owner)) + (self._first[areas] - first)[owner]


def _outwards(way: Any, first: Any, count: Any) -> tuple[Any, Any]:
    """On which side of each edge its area does not lie, 1 where that is the left as it goes down, else -1; and which
    areas bulge nowhere inwards, nor go round twice."""
    after = np.arange(1, len(way) + 1)
    after[first + count - 1] = first
    turn = np.angle(way[after] * way.conj())
    whole = np.add.reduceat(turn, first) if len(first) else turn
    owner = np.repeat(np.arange(len(first)), count)
    inwards = (turn * whole[owner] <= 0) | (way == 0)
    odd = np.bincount(owner, inwards, len(first)) > 0
    return np.where((way.imag >= 0) == (whole[owner] > 0), -1.0, 1.0), ~odd & (abs(abs(whole) - math.tau) < 1)


def _xy(places: Any) -> Any:
    """Complex places (n,) as x and y of each (2, n)."""
    return np.array([places.real, places.imag])
