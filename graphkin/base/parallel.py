"""Work that is sent ahead: batches, taken back in the order they were sent, a bounded number of them out at once."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Executor, Future
from itertools import islice
from typing import TypeVar

__all__ = ["ahead", "batched"]

_Item = TypeVar("_Item")
_Done = TypeVar("_Done")


def ahead(
    executor: Executor, work: Callable[[list[_Item]], list[_Done]], batches: Iterable[list[_Item]], most: int
) -> Iterator[_Done]:
    """What `work` makes of each batch on an executor, in order; at most so many batches are out at once."""
    waiting, out = iter(batches), deque[Future[list[_Done]]]()
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
