"""Straight edges on paper, many at once: how far from boxes they pass, and which lines cross them."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from graphkin.sheet.crossings import meet


class Edges(NamedTuple):
    """Lines from start to end, (2, n) [mm].

    low, high  corners of what each lies in
    across     what a millimetre to the right and one down count across it, to its left as it goes down: one together;
               of one without a length, as if it went down
    """

    start: Any
    end: Any
    low: Any
    high: Any
    across: Any

    @classmethod
    def of(cls, start: Any, end: Any) -> Edges:
        way = end - start
        way[1] += (way == 0).all(axis=0)
        wide = np.where(way[1] < 0, -1.0, 1.0) * abs(way).sum(axis=0)
        across = np.array([-way[1], way[0]]) / wide
        return cls(start, end, np.minimum(start, end), np.maximum(start, end), across)

    def apart(self, rows: Any, low: Any, high: Any) -> Any:
        """By how much boxes low..high would have to grow to all sides to reach some of them; below 0: they do [mm]."""
        half, across = (high - low) / 2, abs(self.across).take(rows, axis=1)
        found = abs(self._side(rows, low + half))
        found -= across[0] * half[0]
        found -= across[1] * half[1]
        surroundings = self.low.take(rows, axis=1), self.high.take(rows, axis=1)
        return np.maximum(found, beyond(*surroundings, low, high), out=found)

    def outside(self, rows: Any, out: Any, low: Any, high: Any) -> Any:
        """By how much boxes low..high would have to grow to reach across some of them from that side; less than 0: they
        do [mm]."""
        half, across = (high - low) / 2, abs(self.across).take(rows, axis=1)
        found = self._side(rows, low + half)
        found *= out
        found -= across[0] * half[0]
        found -= across[1] * half[1]
        return found

    def passed(self, rows: Any, at: Any) -> Any:
        """Whether a way to the right from there crosses some of them: an odd number of those of an area about it."""
        level = (self.low[1].take(rows) <= at[1]) & (at[1] < self.high[1].take(rows))
        return level & (self._side(rows, at) > 0)

    def met(self, rows: Any, start: Any, end: Any, touch: bool = False) -> Any:
        """Whether lines cross some of them; touch: or touch them."""
        return meet(start, end, self.start.take(rows, axis=1), self.end.take(rows, axis=1), touch)

    def _side(self, rows: Any, at: Any) -> Any:
        """How far places lie across some of them."""
        found = self.across[0].take(rows) * (at[0] - self.start[0].take(rows))
        found += self.across[1].take(rows) * (at[1] - self.start[1].take(rows))
        return found


def beyond(low: Any, high: Any, other_low: Any, other_high: Any) -> Any:
    """By how much boxes would have to grow to all sides to reach others; less than 0: they overlap [mm]."""
    off = np.maximum(low - other_high, other_low - high)
    return np.maximum(off[0], off[1])
