"""Where records begin in files, by a number that stands for each."""

from __future__ import annotations

from array import array

import numpy as np


class Places:
    """Places by numbers below 2^64; sixteen bytes of each are held."""

    def __init__(self) -> None:
        self._numbers, self._places = array("Q"), array("Q")
        self._order: tuple[np.ndarray, np.ndarray] | None = None

    def add(self, number: int, place: int) -> None:
        """All are added before the first is looked for."""
        self._numbers.append(number)
        self._places.append(place)

    def find(self, number: int) -> int | None:
        """The place that was added last for a number."""
        if self._order is None:
            order = np.argsort(np.asarray(self._numbers), kind="stable")
            self._order = np.asarray(self._numbers)[order], np.asarray(self._places)[order]
            self._numbers, self._places = array("Q"), array("Q")
        numbers, places = self._order
        k = int(np.searchsorted(numbers, np.uint64(number), side="right")) - 1
        return int(places[k]) if k >= 0 and numbers[k] == number else None
