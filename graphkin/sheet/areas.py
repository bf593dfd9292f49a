"""Filled areas on paper, many at once: how far from boxes they are, and which lines meet them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from graphkin.sheet.blocks import Blocks
from graphkin.sheet.crossings import through
from graphkin.sheet.edges import Edges, beyond
from graphkin.sheet.marks import Place

_SIDES = 5
"""An area of no more than four sides, all level or upright, is a rectangle; a side of no length may close it."""

_ROUNDED = 1e-9
"""What only touches is not lost by rounding [mm]."""


class Areas:
    """Areas by their edges, one area after the other: of any shape, inside one another or not.

    _first, _count  where the edges of each begin, and how many there are
    _low, _high     corners of what each lies in (2, k) [mm]; _plain: those that are all of that, as letters are
    """

    def __init__(self, areas: Sequence[Sequence[Place]]) -> None:
        """areas: the corners of each."""
        corners = np.array([place for area in areas for place in area], dtype=complex)
        nexts = np.array([place for area in areas for place in (*area[1:], area[0])], dtype=complex)
        self._edges = Edges.of(_xy(corners), _xy(nexts))
        self._count = np.array([len(area) for area in areas], dtype=np.intp)
        self._first = np.cumsum(self._count) - self._count
        self._low, self._high, slanted = self._edges.low, self._edges.high, self._edges.across.all(axis=0)
        if areas:
            self._low = np.minimum.reduceat(self._low, self._first, axis=1)
            self._high = np.maximum.reduceat(self._high, self._first, axis=1)
            slanted = np.logical_or.reduceat(slanted, self._first)
        self._plain = ~slanted & (self._count <= _SIDES)

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
            first, owner, edges = self._spread(areas[shaped])
            low, high = low.take(shaped[owner], axis=1), high.take(shaped[owner], axis=1)
            apart = np.minimum.reduceat(self._edges.apart(edges, low, high), first)
            odd = np.add.reduceat(self._edges.passed(edges, (low + high) / 2), first, dtype=np.intp) & 1
            found[shaped] = np.where(odd, -np.inf, apart)
        return found

    def _spread(self, areas: Any) -> tuple[Any, Any, Any]:
        """All edges of some areas: where those of each begin, of which of them they are, and which edges."""
        count = self._count[areas]
        first = np.cumsum(count) - count
        owner = np.repeat(np.arange(len(areas)), count)
        return first, owner, np.arange(len(owner)) + (self._first[areas] - first)[owner]


def _xy(places: Any) -> Any:
    """Complex places (n,) as x and y of each (2, n)."""
    return np.array([places.real, places.imag])
