"""Where something surely lies: places on all that is drawn, counted in the squares of a grid.

Boxes that hold such a square need no closer look.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np


class Held:
    """Squares of a grid that hold one of many places.

    _cell, _origin  how wide a square is, and the first one's corner [mm]
    _sums           how many places lie in the squares above and to the left of each corner (rows + 1, columns + 1)
    """

    def __init__(self, places: Any, cell: float) -> None:
        """places: (2, n) [mm]."""
        self._cell, self._origin = cell, places.min(axis=1, initial=np.inf)
        x, y = cells = ((places - self._origin[:, None]) / cell).astype(np.intp)
        wide, high = cells.max(axis=1, initial=0) + 1
        counts = np.bincount(y * wide + x, minlength=wide * high).reshape(high, wide)
        self._sums = np.zeros((high + 1, wide + 1), dtype=np.intp)
        self._sums[1:, 1:] = counts.cumsum(axis=0).cumsum(axis=1)

    def within(self, low: Sequence[Any], high: Sequence[Any]) -> Any:
        """Which boxes low..high hold a whole square in which something lies; x and y of their corners may broadcast
        against one another."""
        (left, right), (top, foot) = (self._squares(axis, low[axis], high[axis]) for axis in (0, 1))
        sums, width = self._sums.ravel(), self._sums.shape[1]
        above, below = top * width, foot * width
        return sums.take(below + right) - sums.take(below + left) > sums.take(above + right) - sums.take(above + left)

    def _squares(self, axis: int, low: Any, high: Any) -> tuple[Any, Any]:
        """The first square that lies between two places, and the first that no longer does."""
        most = self._sums.shape[1 - axis] - 1
        first = np.clip(np.ceil((low - self._origin[axis]) / self._cell), 0, most).astype(np.intp)
        after = np.clip(np.floor((high - self._origin[axis]) / self._cell), 0, most).astype(np.intp)
        return first, np.maximum(first, after)
