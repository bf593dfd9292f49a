"""Tracks: numbers that change along the drivers, at knots, packed as text.

A track is whole numbers of its quantum, knot after knot (of a grid the last driver's first); where it is not there, it
stays as it was. Written are its differences of the order that takes the least room: first the order, then each number
with its sign as its last bit, in pieces of five bits from the lowest on, a sixth bit saying that more follow.
"""

from __future__ import annotations

import numpy as np

from graphkin.base.value import filled

QUANTUM = 0.001  # of places [mm]
OF_GRID = 0.0002  # of places over a grid, at whose rim rounding counts many times [mm]
FINE = 1e-7  # of other numbers [of the greatest]
_LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+-"
_ORDERS = 4


@filled
class Tracks:
    """All tracks of a page's mechanism, each once; masks: of the knots at which something is there."""

    texts: list[str | list[object]]
    masks: list[str]
    quantum: float = QUANTUM

    def __post_init__(self) -> None:
        self._numbers: dict[str, int] = {}
        self._masks: dict[str, int] = {}

    def place(self, values: np.ndarray) -> float | list[int]:
        """A number that never changes, or the number of a track [mm]."""
        return self._added(values, self.quantum)

    def fine(self, values: np.ndarray) -> float | list[int]:
        """The same of a number that is no place."""
        most = float(np.nanmax(np.abs(values), initial=0.0))
        return self._added(values, most * FINE or 1.0)

    def mask(self, there: np.ndarray) -> int | None:
        """The number of a mask; None where nothing is left out."""
        if there.all():
            return None
        text = packed(np.concatenate([[int(there[0])], np.diff(np.flatnonzero(np.diff(there.astype(int))), prepend=0)]))
        if text not in self._masks:
            self._masks[text] = len(self.masks)
            self.masks.append(text)
        return self._masks[text]

    def _added(self, values: np.ndarray, quantum: float) -> float | list[int]:
        held = np.flatnonzero(~np.isnan(values))
        nearest = held[np.maximum(np.searchsorted(held, np.arange(len(values)), "right") - 1, 0)]
        whole = np.rint(values[nearest] / quantum).astype(np.int64)
        if (whole == whole[0]).all():
            return float(f"{values[held[0]]:.9g}") if quantum != QUANTUM else round(float(whole[0]) * quantum, 3)
        text = min((_differences(whole, order) for order in range(_ORDERS)), key=len)
        key = text if quantum == QUANTUM else f"{quantum:.6g} {text}"
        if key not in self._numbers:
            self._numbers[key] = len(self.texts)
            self.texts.append(text if quantum == QUANTUM else [float(f"{quantum:.6g}"), text])
        return [self._numbers[key]]


def _differences(whole: np.ndarray, order: int) -> str:
    """Numbers by their differences; the first ones by those of lower orders."""
    for _ in range(order):
        whole = np.diff(whole, prepend=0)
    return packed(np.concatenate([[order], whole]))


def packed(whole: np.ndarray) -> str:
    """Whole numbers as letters."""
    letters: list[str] = []
    for number in whole.tolist():
        left = -2 * number + 1 if number < 0 else 2 * number
        while left >= 32:
            letters.append(_LETTERS[32 + left % 32])
            left //= 32
        letters.append(_LETTERS[left])
    return "".join(letters)
