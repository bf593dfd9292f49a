"""Many boxes on paper in blocks of a few that are close together, so that what is far from all of these is passed over
at once."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

_SIZE, _CELL = 16, 6.0
"""So many boxes are a block; those are close together whose middles lie in one square so wide [mm]."""
_AT_ONCE = 2048
"""So many blocks are held against something at once: few enough to stay in the processor's memory."""


class Blocks(NamedTuple):
    """Blocks of boxes.

    boxes  how many; order: which of them stand where (m * _SIZE,), the last one again in what would be left
    low, high  their corners (2, m, _SIZE) [mm]; least, most: those of each block (2, m)
    """

    boxes: int
    order: NDArray[np.intp]
    low: Any
    high: Any
    least: Any
    most: Any

    @classmethod
    def of(cls, low: Any, high: Any) -> Blocks:
        """Of boxes low..high (2, n), at least one."""
        column, row = ((low + high) * (0.5 / _CELL)).astype(np.intp)
        order = np.argsort(row * 65536 + np.where(row & 1, -column, column), kind="stable")
        order = order[np.minimum(np.arange(-(-len(order) // _SIZE) * _SIZE), len(order) - 1)]
        count, low, high = low.shape[1], *(corner.take(order, axis=1).reshape(2, -1, _SIZE) for corner in (low, high))
        return cls(count, order, low, high, low.min(axis=2), high.max(axis=2))

    def beside(self, low: Any, high: Any) -> Iterator[tuple[Any, Any]]:
        """Pairs of blocks and of the things in low..high (2, k) that a box of it may touch, some at a time; block by
        block."""
        if not low.shape[1]:
            return
        near = (low[:, None] <= self.most[..., None]) & (high[:, None] >= self.least[..., None])
        blocks, things = np.nonzero(near[0] & near[1])
        for first in range(0, len(blocks), _AT_ONCE):
            yield blocks[first : first + _AT_ONCE], things[first : first + _AT_ONCE]

    def taken(self, blocks: Any) -> tuple[Any, Any]:
        """Corners of the boxes of some blocks (2, m, _SIZE)."""
        return self.low.take(blocks, axis=1), self.high.take(blocks, axis=1)

    def back(self, found: Any) -> Any:
        """What was found for boxes where they stand in blocks, box by box."""
        ordered = np.empty(self.boxes, dtype=found.dtype)
        ordered[self.order] = found.ravel()
        return ordered
