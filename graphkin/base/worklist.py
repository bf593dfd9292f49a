"""What waits to be looked at, first things first."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Iterator
from heapq import heapify, heappop, heappush
from typing import Generic, TypeVar

__all__ = ["Rounds", "Waiting"]

_Found = TypeVar("_Found")
_Rule = TypeVar("_Rule")


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


class Rounds(Generic[_Rule]):
    """Rules gone through in their order, round by round, as long as one is called: at first all are.

    A rule is called by something that it starts from; when its turn is past, it comes in the next round.
    """

    def __init__(self, rules: Iterable[tuple[Iterable[Hashable], _Rule]]) -> None:
        self._rules: list[_Rule] = []
        self._starting: dict[Hashable, list[int]] = {}
        for number, (starts, rule) in enumerate(rules):
            self._rules.append(rule)
            for start in starts:
                self._starting.setdefault(start, []).append(number)
        self._now: list[int] = []
        self._next = list(range(len(self._rules)))
        self._called, self._at = set(self._next), len(self._rules)

    def __iter__(self) -> Iterator[_Rule]:
        while self._now or self._next:
            if not self._now:
                self._now, self._next = self._next, []
                heapify(self._now)
            self._at = heappop(self._now)
            self._called.remove(self._at)
            yield self._rules[self._at]
        self._at = len(self._rules)

    def call(self, start: Hashable) -> None:
        for number in self._starting.get(start, ()):
            if number not in self._called:
                self._called.add(number)
                heappush(self._now if number > self._at else self._next, number)
