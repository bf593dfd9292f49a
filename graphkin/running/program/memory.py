"""Memory of results, lent again when nothing that was read from it is left: new memory takes as long as a program."""

from __future__ import annotations

import numpy as np

LEAST, MOST = 2**15, 2**23
"""Numbers in what is lent, and kept, at the least and at most: from a quarter of a MiB to 64."""

KEPT = 2
"""Pieces that are kept at most: those of a program, and of what its results are put together in."""

_KEPT: list[np.ndarray] = []
"""What came back last."""


def lent(size: int) -> np.ndarray:
    """So many numbers of any value (size,)."""
    if size < LEAST:
        return np.empty(size)
    fitting = (number for number, memory in enumerate(_KEPT) if size <= memory.size <= 2 * size)
    try:
        memory = _KEPT.pop(next(fitting))
    except (IndexError, StopIteration):
        memory = np.empty(size)
    return np.asarray(_Lent(memory))[:size]


class _Lent:
    """What an array lies in; it goes back with the last array that lies there."""

    def __init__(self, memory: np.ndarray) -> None:
        self.memory = memory
        self.__array_interface__ = memory.__array_interface__

    def __del__(self) -> None:
        if self.memory.size <= MOST:
            _KEPT[:] = [*_KEPT, self.memory][-KEPT:]
