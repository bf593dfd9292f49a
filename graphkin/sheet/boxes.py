"""Boxes and straight lines on paper, many at once: overlaps, crossings, distances.

All are places (2, ..), x and y of each [mm], that broadcast against one another; a box is its corners low and high, a
line its ends.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from graphkin.base.geometry import Array


def xy(places: Array) -> Array:
    """Complex places (n,) as x and y of each (2, n)."""
    return np.array([places.real, places.imag])


def overlap(low: Array, high: Array, other_low: Array, other_high: Array) -> Array:
    """True where boxes overlap others; those that only touch do not."""
    both = (low < other_high) & (high > other_low)
    return np.asarray(both[0] & both[1])


def through(start: Array, end: Array, low: Array, high: Array) -> Array:
    """True where lines, whose surroundings overlap boxes, pass through these: no box lies on one side of its line.

    A level or upright line is as large as its surroundings, and does.
    """
    along, half = end - start, (high - low) / 2
    wide = abs(along)
    between = abs(_cross(along, (low + high) / 2 - start)) <= wide[0] * half[1] + wide[1] * half[0]
    return np.asarray(between | ~(wide[0] * wide[1] > 0))


def meet(start: Array, end: Array, other: Array, other_end: Array) -> Array:
    """True where lines cross others: each has its ends on both sides of the other, and none of them upon it."""
    along, other_along, off = end - start, other_end - other, other - start
    first, second, between = _cross(along, off), _cross(other_along, off), _cross(along, other_along)
    return np.asarray((first * (first + between) < 0) & (second * (second + between) < 0))


def _cross(along: Array, off: Array) -> Array:
    """The side of a line on which a place lies, by its sign."""
    return np.asarray(along[0] * off[1] - along[1] * off[0])


def beyond(low: Array, high: Array, other_low: Array, other_high: Array) -> Array:
    """The length by which boxes would have to grow to all sides to reach others; less than 0: they overlap [mm]."""
    off = np.maximum(low - other_high, other_low - high)
    return np.asarray(np.maximum(off[0], off[1]))


class Edges(NamedTuple):
    """Lines from start to end, (2, n) [mm].

    low, high  corners of what each lies in
    across     what a millimetre to the right and one down count across it, to its left as it goes down: one together;
               of one without a length, as if it went down
    """

    start: Array
    end: Array
    low: Array
    high: Array
    across: Array

    @classmethod
    def of(cls, start: Array, end: Array) -> Edges:
        along = end - start
        along[1] += (along == 0).all(axis=0)
        wide = np.where(along[1] < 0, -1.0, 1.0) * abs(along).sum(axis=0)
        across = np.array([-along[1], along[0]]) / wide
        return cls(start, end, np.minimum(start, end), np.maximum(start, end), across)

    def apart(self, rows: Array, low: Array, high: Array) -> Array:
        """The growth of boxes low..high to all sides with which they reach some of them; below 0: they do [mm]."""
        half, across = (high - low) / 2, abs(self.across).take(rows, axis=1)
        off = abs(self._side(rows, low + half)) - across[0] * half[0] - across[1] * half[1]
        surroundings = self.low.take(rows, axis=1), self.high.take(rows, axis=1)
        return np.asarray(np.maximum(off, beyond(*surroundings, low, high)))

    def met(self, rows: Array, start: Array, end: Array) -> Array:
        """True where lines cross some of them."""
        return meet(start, end, self.start.take(rows, axis=1), self.end.take(rows, axis=1))

    def _side(self, rows: Array, at: Array) -> Array:
        """The distance of places across some of them."""
        off = at[0] - self.start[0].take(rows), at[1] - self.start[1].take(rows)
        return np.asarray(self.across[0].take(rows) * off[0] + self.across[1].take(rows) * off[1])


_SIZE, _CELL = 16, 6.0
"""So many boxes are a block; those are close together whose middles lie in one square so wide [mm]."""
_AT_ONCE = 2048  # so many blocks are held against something at once: few enough to stay in the processor's memory


class Blocks(NamedTuple):
    """Blocks of boxes.

    boxes  how many; order: which of them stand where (m * _SIZE,), the last one again in what would be left
    low, high  their corners (2, m, _SIZE) [mm]; least, most: those of each block (2, m)
    """

    boxes: int
    order: Array
    low: Array
    high: Array
    least: Array
    most: Array

    @classmethod
    def of(cls, low: Array, high: Array) -> Blocks:
        """Of boxes low..high (2, n), at least one."""
        column, row = ((low + high) * (0.5 / _CELL)).astype(np.intp)
        order = np.argsort(row * 65536 + np.where(row & 1, -column, column), kind="stable")
        order = order[np.minimum(np.arange(-(-len(order) // _SIZE) * _SIZE), len(order) - 1)]
        count, low, high = low.shape[1], *(corner.take(order, axis=1).reshape(2, -1, _SIZE) for corner in (low, high))
        return cls(count, order, low, high, low.min(axis=2), high.max(axis=2))

    def beside(self, low: Array, high: Array) -> Iterator[tuple[Array, Array]]:
        """Pairs of blocks and of the things in low..high (2, k) that a box of it may touch, some at a time; block by
        block."""
        if not low.shape[1]:
            return
        near = (low[:, None] <= self.most[..., None]) & (high[:, None] >= self.least[..., None])
        blocks, things = np.nonzero(near[0] & near[1])
        for first in range(0, len(blocks), _AT_ONCE):
            yield blocks[first : first + _AT_ONCE], things[first : first + _AT_ONCE]

    def taken(self, blocks: Array) -> tuple[Array, Array]:
        """Corners of the boxes of some blocks (2, m, _SIZE)."""
        return self.low.take(blocks, axis=1), self.high.take(blocks, axis=1)

    def back(self, values: Array) -> Array:
        """Values of boxes where they stand in blocks, box by box."""
        ordered = np.empty(self.boxes, dtype=values.dtype)
        ordered[self.order] = values.ravel()
        return ordered


class OccupiedSquares:
    """Squares of a grid that hold one of many places.

    _cell, _origin  how wide a square is, and the first one's corner [mm]
    _sums           how many places lie in the squares above and to the left of each corner (rows + 1, columns + 1)
    """

    def __init__(self, places: Array, cell: float) -> None:
        """places: (2, n) [mm]."""
        self._cell, self._origin = cell, places.min(axis=1, initial=np.inf)
        x, y = cells = ((places - self._origin[:, None]) / cell).astype(np.intp)
        wide, high = cells.max(axis=1, initial=0) + 1
        counts = np.bincount(y * wide + x, minlength=wide * high).reshape(high, wide)
        self._sums = np.zeros((high + 1, wide + 1), dtype=np.intp)
        self._sums[1:, 1:] = counts.cumsum(axis=0).cumsum(axis=1)

    def within(self, low: Array | tuple[Array, Array], high: Array | tuple[Array, Array]) -> Array:
        """The boxes low..high that hold a whole square in which something lies; x and y of their corners may
        broadcast against one another."""
        (left, right), (top, foot) = (self._squares(axis, low[axis], high[axis]) for axis in (0, 1))
        sums, width = self._sums.ravel(), self._sums.shape[1]
        above, below = top * width, foot * width
        inside = sums.take(below + right) - sums.take(below + left) - sums.take(above + right) + sums.take(above + left)
        return np.asarray(inside > 0)

    def _squares(self, axis: int, low: Array, high: Array) -> tuple[Array, Array]:
        """The first square that lies between two places, and the first that no longer does."""
        most = self._sums.shape[1 - axis] - 1
        first = np.clip(np.ceil((low - self._origin[axis]) / self._cell), 0, most).astype(np.intp)
        after = np.clip(np.floor((high - self._origin[axis]) / self._cell), 0, most).astype(np.intp)
        return first, np.maximum(first, after)
