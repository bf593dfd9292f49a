"""Work that waits: to be looked at, first things first, or sent ahead to other processes."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Hashable, Iterable, Iterator
from heapq import heapify, heappop, heappush
from itertools import islice
from typing import TYPE_CHECKING, Generic, TypeVar

if TYPE_CHECKING:
    from concurrent.futures import Executor, Future

_Item = TypeVar("_Item")
_Done = TypeVar("_Done")
_Result = TypeVar("_Result")
_Rule = TypeVar("_Rule")


class Waiting:
    """Numbers to be looked at, the least first. One that gave nothing is looked at again when it is called."""

    def __init__(self, count: int) -> None:
        self._numbers = list(range(count))
        self._called = set(self._numbers)
        heapify(self._numbers)

    def first(self, look: Callable[[int], _Result | None]) -> _Result | None:
        """The result of the first number that gives one."""
        while self._numbers:
            if (result := look(self._numbers[0])) is not None:
                return result
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


def ahead(
    executor: Executor, work: Callable[[list[_Item]], list[_Done]], batches: Iterable[list[_Item]], most: int
) -> Iterator[_Done]:
    """The results of `work` for each batch on an executor, in order; at most so many batches are out at once."""
    waiting = iter(batches)
    out: deque[Future[list[_Done]]] = deque()
    try:
        while True:
            out.extend(executor.submit(work, some) for some in islice(waiting, most - len(out)))
            if not out:
                return
            yield from out.popleft().result()
    finally:
        for future in out:
            future.cancel()


def batched(items: Iterable[_Item], size: int) -> Iterator[list[_Item]]:
    """Lists of so many; the last may be shorter."""
    waiting = iter(items)
    while some := list(islice(waiting, size)):
        yield some
