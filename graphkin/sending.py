"""Work that is sent ahead: batches, taken back in the order they were sent, a bounded number of them out at once."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Executor, Future
from itertools import islice
from typing import Generic, TypeVar

__all__ = ["Sent", "ahead", "batched"]

_Item = TypeVar("_Item")
_Found = TypeVar("_Found")


class Sent(Generic[_Item, _Found]):
    """Batches that are out, each with its future; further ones are taken and sent only as these come back."""

    def __init__(
        self, send: Callable[[list[_Item]], Future[list[_Found]]], batches: Iterable[list[_Item]], most: int
    ) -> None:
        self._send, self._batches, self._most = send, iter(batches), most
        self._out: deque[tuple[list[_Item], Future[list[_Found]]]] = deque()

    def __iter__(self) -> Iterator[tuple[list[_Item], Future[list[_Found]]]]:
        while True:
            for some in islice(self._batches, max(self._most - len(self._out), 0)):
                self._out.append((some, self._send(some)))
            if not self._out:
                return
            yield self._out.popleft()

    def anew(self) -> None:
        """All that is out is sent once more: where it went is no more."""
        self._out = deque((some, self._send(some)) for some, _ in self._out)

    def cancel(self) -> None:
        """What has not begun need not."""
        for _, future in self._out:
            future.cancel()


def ahead(
    executor: Executor, work: Callable[[list[_Item]], list[_Found]], batches: Iterable[list[_Item]], most: int
) -> Iterator[_Found]:
    """What `work` makes of each batch on an executor, in order; at most so many batches are out at once."""
    sent: Sent[_Item, _Found] = Sent(lambda some: executor.submit(work, some), batches, most)
    try:
        for _, future in sent:
            yield from future.result()
    finally:
        sent.cancel()


def batched(items: Iterable[_Item], size: int) -> Iterator[list[_Item]]:
    """Lists of so many; the last may be shorter."""
    waiting = iter(items)
    while some := list(islice(waiting, size)):
        yield some
