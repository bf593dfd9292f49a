"""What waits to be looked at, first things first."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from heapq import heapify, heappop, heappush
from typing import TypeVar

_Found = TypeVar("_Found")


class Waiting:
    """Numbers to be looked at, the least first. One that gave nothing is looked at again when it is called."""

    def __init__(self, count: int) -> None:
        self._numbers = list(range(count))
        self._called = set(self._numbers)
        heapify(self._numbers)

    def first(self, look: Callable[[int], _Found | None]) -> _Found | None:
        """What the first number gives that gives anything."""
        while self._numbers:
            if (found := look(self._numbers[0])) is not None:
                return found
            self._called.remove(heappop(self._numbers))
        return None

    def call(self, numbers: Iterable[int]) -> None:
        for number in numbers:
            if number not in self._called:
                self._called.add(number)
                heappush(self._numbers, number)
