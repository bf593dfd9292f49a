"""Whether a place for the label of an arrow is nearer to that arrow than to all others."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from graphkin.sheet.marks import Mark, VectorMark
from graphkin.sheet.wanted import LabelRequest

if TYPE_CHECKING:
    from numpy.typing import NDArray

_NEARER = 0.3
"""By so much, to the eye [mm]."""
_LEAST = 0.1
"""Shorter arrows are points [mm]."""


class Arrows:
    """The arrows of a figure, by name."""

    def __init__(self, drawn: Iterable[Mark]) -> None:
        vectors = [mark for mark in drawn if isinstance(mark, VectorMark) and mark.length > _LEAST]
        self.names = np.array([vector.name for vector in vectors])
        self.start = np.array([vector.start for vector in vectors], dtype=complex)
        self.end = np.array([vector.end for vector in vectors], dtype=complex)

    def strange(
        self,
        wanted: Sequence[LabelRequest],
        owner: NDArray[np.intp],
        low: NDArray[np.float64],
        high: NDArray[np.float64],
    ) -> NDArray[np.bool_]:
        """Boxes low..high of labels that stand nearer to an arrow that is not their owner's."""
        found = np.zeros(len(owner), dtype=bool)
        if len(self.names) < 2:
            return found
        for k, want in enumerate(wanted):
            own = self.names == want.of
            if want.of and own.any():
                rows = np.flatnonzero(owner == k)
                apart = _apart(low[rows, None], high[rows, None], self.start, self.end)
                found[rows] = apart[:, own].min(axis=1) > apart[:, ~own].min(axis=1, initial=np.inf) - _NEARER
        return found


def _apart(low: Any, high: Any, start: Any, end: Any) -> Any:
    """Distance of boxes (m, 1, 2) from lines from start to end (n,), complex: (m, n); 0 where they meet."""
    (left, top), (right, bottom) = np.moveaxis(low, -1, 0), np.moveaxis(high, -1, 0)
    found = [_from_line(x + 1j * y, start, end) for x in (left, right) for y in (top, bottom)]
    for at in (start, end):
        across = np.maximum(np.maximum(left - at.real, at.real - right), 0.0)
        found.append(np.hypot(across, np.maximum(np.maximum(top - at.imag, at.imag - bottom), 0.0)))
    return np.minimum.reduce(found)


def _from_line(at: Any, start: Any, end: Any) -> Any:
    way = end - start
    off = at - start
    along = np.clip((off * way.conj()).real / (way * way.conj()).real, 0.0, 1.0)
    return np.abs(off - along * way)
