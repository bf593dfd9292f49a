"""Work that waits: to be looked at, first things first, or sent ahead to other processes."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Iterator
from heapq import heapify, heappop, heappush
from itertools import islice
from typing import TYPE_CHECKING, TypeVar

if TYPE_CHECKING:
    from concurrent.futures import Executor, Future

_Item = TypeVar("_Item")
_Done = TypeVar("_Done")
_Result = TypeVar("_Result")


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
