"""Worker processes that may hang or die: what one of them was given is tried again alone, then given up with a word.

An alarm ends a reader that is too slow; this is for what no alarm reaches, and for what takes its process with it.
"""

from __future__ import annotations

import multiprocessing
import signal
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from typing import TypeVar

from graphkin.sending import Sent

_Item = TypeVar("_Item")
_Found = TypeVar("_Found")
_AHEAD = 3
_GRACE = 5.0
"""Beyond its limits a batch is waited for so long [s]."""


def guarded(
    work: Callable[[list[_Item]], list[_Found]],
    batches: Iterable[list[_Item]],
    workers: int,
    seconds: float,
    failed: Callable[[_Item, str], _Found],
) -> Iterator[_Found]:
    """What `work` makes of every item, in order, a bounded number of batches in flight.

    work     a function that processes can import; it keeps to `seconds` an item by itself
    failed   what stands for an item whose process hung ("hung") or ended ("died")
    """
    pool = _pool(workers)

    def send(some: list[_Item]) -> Future[list[_Found]]:
        try:
            return pool.submit(work, some)
        except BrokenProcessPool as problem:  # told when it is this batch's turn
            future: Future[list[_Found]] = Future()
            future.set_exception(problem)
            return future

    sent = Sent(send, batches, _AHEAD * workers)
    try:
        for some, future in sent:
            try:
                found = future.result(timeout=seconds * len(some) + _GRACE)
            except (TimeoutError, BrokenProcessPool):
                _end(pool)
                yield from _alone(work, some, seconds, failed)
                pool = _pool(workers)
                sent.anew()
            else:
                yield from found
    finally:
        _end(pool)


def _alone(
    work: Callable[[list[_Item]], list[_Found]],
    items: list[_Item],
    seconds: float,
    failed: Callable[[_Item, str], _Found],
) -> Iterator[_Found]:
    """Each in a process of its own, so that it is known which of them it was."""
    for item in items:
        pool = _pool(1)
        try:
            yield pool.submit(work, [item]).result(timeout=seconds + _GRACE)[0]
        except TimeoutError:
            yield failed(item, "hung")
        except BrokenProcessPool:
            yield failed(item, "died")
        finally:
            _end(pool)


def _pool(workers: int) -> ProcessPoolExecutor:
    """Of processes that leave an interruption to the one that has sent them the work."""
    spawn = multiprocessing.get_context("spawn")
    return ProcessPoolExecutor(workers, mp_context=spawn, initializer=signal.signal, initargs=_DEAF)


_DEAF = (signal.SIGINT, signal.SIG_IGN)


def _end(pool: ProcessPoolExecutor) -> None:
    """Now, not when a hanging worker is done."""
    processes = list((getattr(pool, "_processes", None) or {}).values())
    pool.shutdown(wait=False, cancel_futures=True)
    for process in processes:
        process.kill()
        process.join(1.0)
