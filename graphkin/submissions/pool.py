"""Worker processes that may hang or die: what one of them was given is tried again alone, then given up with a word.

An alarm ends a reader that is too slow; this is for what no alarm reaches, and for what takes its process with it.
"""

from __future__ import annotations

import multiprocessing
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from itertools import islice
from typing import TypeVar

_Item = TypeVar("_Item")
_Found = TypeVar("_Found")
_BATCH, _AHEAD = 16, 3
_GRACE = 5.0
"""Beyond its limits a batch is waited for so long [s]."""


def guarded(
    one: Callable[[_Item], _Found],
    items: Iterable[_Item],
    workers: int,
    seconds: float,
    failed: Callable[[_Item, str], _Found],
) -> Iterator[_Found]:
    """`one` of every item, in order, a bounded number of them in flight.

    one      a function that processes can import; it keeps to `seconds` by itself
    failed   what stands for an item whose process hung ("hung") or ended ("died")
    """
    waiting, sent = iter(items), deque[tuple[list[_Item], Future[list[_Found]]]]()
    pool = _pool(workers)
    try:
        while True:
            while len(sent) < _AHEAD * workers and (some := list(islice(waiting, _BATCH))):
                sent.append((some, pool.submit(_each, one, some)))
            if not sent:
                return
            some, future = sent.popleft()
            try:
                yield from future.result(timeout=seconds * len(some) + _GRACE)
            except (TimeoutError, BrokenProcessPool):
                _end(pool)
                yield from _alone(one, some, seconds, failed)
                pool = _pool(workers)
                sent = deque((batch, pool.submit(_each, one, batch)) for batch, _ in sent)
    finally:
        _end(pool)


def _each(one: Callable[[_Item], _Found], items: list[_Item]) -> list[_Found]:
    return [one(item) for item in items]


def _alone(
    one: Callable[[_Item], _Found], items: list[_Item], seconds: float, failed: Callable[[_Item, str], _Found]
) -> Iterator[_Found]:
    """Each in a process of its own, so that it is known which of them it was."""
    for item in items:
        pool = _pool(1)
        try:
            yield pool.submit(_each, one, [item]).result(timeout=seconds + _GRACE)[0]
        except TimeoutError:
            yield failed(item, "hung")
        except BrokenProcessPool:
            yield failed(item, "died")
        finally:
            _end(pool)


def _pool(workers: int) -> ProcessPoolExecutor:
    return ProcessPoolExecutor(workers, mp_context=multiprocessing.get_context("spawn"))


def _end(pool: ProcessPoolExecutor) -> None:
    """Now, not when a hanging worker is done."""
    processes = list((getattr(pool, "_processes", None) or {}).values())
    pool.shutdown(wait=False, cancel_futures=True)
    for process in processes:
        process.kill()
        process.join(1.0)
