"""Whether a place for the label of an arrow is nearer to that arrow than to all others."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from graphkin.sheet.marks import Mark, VectorMark
from graphkin.sheet.wanted import Wanted

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
        self.start = np.array([(v.start.real, v.start.imag) for v in vectors]).reshape(-1, 2)
        self.end = np.array([(v.end.real, v.end.imag) for v in vectors]).reshape(-1, 2)

    def strange(
        self, wanted: Sequence[Wanted], owner: NDArray[np.intp], low: NDArray[np.float64], high: NDArray[np.float64]
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
    """Distance of boxes (m, 1, 2) from lines (n, 2): (m, n); 0 where they meet."""
    corners = [np.stack([x[..., 0], y[..., 1]], axis=-1) for x in (low, high) for y in (low, high)]
    found = [_from_line(corner, start, end) for corner in corners]
    found += [np.linalg.norm(np.maximum(np.maximum(low - at, at - high), 0.0), axis=-1) for at in (start, end)]
    return np.minimum.reduce(found)


def _from_line(at: Any, start: Any, end: Any) -> Any:
    way = end - start
    t = np.clip(((at - start) * way).sum(axis=-1) / (way * way).sum(axis=-1), 0.0, 1.0)
    return np.linalg.norm(at - start - t[..., None] * way, axis=-1)
