"""Memory of results, lent again when nothing that was read from it is left: new memory takes as long as a program."""

from __future__ import annotations

import numpy as np

LEAST, MOST = 2**15, 2**23
"""Numbers in what is lent, and kept, at the least and at most: from a quarter of a MiB to 64."""

KEPT = 3
"""Pieces that are kept at most: results of a program, its registers, and what results are put together in."""

_KEPT: dict[int, np.ndarray] = {}
"""By identity, in the order in which they came back. Each change is one step, whatever else a thread does meanwhile."""


def lent(size: int) -> np.ndarray:
    """So many numbers of any value (size,)."""
    for key, memory in [*_KEPT.items()] if size >= LEAST else ():
        if size <= memory.size <= 2 * size and _KEPT.pop(key, None) is not None:
            return np.asarray(_Lent(memory))[:size]
    return np.asarray(_Lent(np.empty(size))) if size >= LEAST else np.empty(size)


class _Lent:
    """What an array lies in; it goes back with the last array that lies there."""

    def __init__(self, memory: np.ndarray) -> None:
        self.memory = memory
        self.__array_interface__ = memory.__array_interface__

    def __del__(self) -> None:
        if self.memory.size <= MOST:
            _KEPT[id(self.memory)] = self.memory
            for oldest in [*_KEPT][:-KEPT]:
                _KEPT.pop(oldest, None)
