"""Many line segments at once, beside many boxes and other segments."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from copy import copy

import numpy as np

from graphkin.base.boxes import beyond, meet
from graphkin.base.geometry import Array

_AT_ONCE, _PAIRS = 128, 32_000  # so many boxes are held against lines at once, or as many as make so many pairs


class Segments:
    """Line segments by place; _across: what a millimetre to the right and one down count across each, to its left as it
    goes down: one together; of one without a length, as if it went down (2, n)."""

    def __init__(self, start: Array, end: Array) -> None:
        """start, end: of the segments (2, n)."""
        self._start, self._end, along = start, end, end - start
        self._low, self._high = np.minimum(start, end), np.maximum(start, end)
        along[1] += (along == 0).all(axis=0)
        self._across = np.array([-along[1], along[0]]) / (np.where(along[1] < 0, -1.0, 1.0) * abs(along).sum(axis=0))

    def __add__(self, other: Segments) -> Segments:
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
