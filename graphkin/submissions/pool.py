"""Pool."""

from __future__ import annotations

import contextlib
import faulthandler
import multiprocessing
import os
import signal
import threading
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from itertools import islice
from multiprocessing.process import BaseProcess
from typing import TypeVar

from graphkin.errors import TookTooLong, Where

_AGAIN = 0.2
"""A reader that swallows the alarm is told again so soon [s]."""


_LATER = 2.0
"""So long after the alarm the watchdog ends the process [s]."""
ENDED = 1
"""The exit status of a process that its watchdog has ended."""


class _Watched:
    """Whether this process may be ended, and where the watchdog writes what it was at."""

    nowhere: int | None = None


def watch() -> None:
    """From now on this process is ended where an alarm is not heard."""
    if _Watched.nowhere is None:
        _Watched.nowhere = os.open(os.devnull, os.O_WRONLY)


class _TimeUp(BaseException):
    """No `except Exception` of another's reader stops it."""


def _ring(*_: object) -> None:
    raise _TimeUp


@contextlib.contextmanager
def limited(seconds: float, where: Where) -> Iterator[None]:
    """Raises TookTooLong. Where there are no alarms (Windows, other threads) only the pool's limit holds."""
    if not hasattr(signal, "setitimer") or threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGALRM, _ring)
    try:
        signal.setitimer(signal.ITIMER_REAL, seconds, _AGAIN)
        if _Watched.nowhere is not None:
            faulthandler.dump_traceback_later(seconds + _LATER, exit=True, file=_Watched.nowhere)
        try:
            yield
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            if _Watched.nowhere is not None:
                faulthandler.cancel_dump_traceback_later()
    except _TimeUp:
        raise TookTooLong(where, seconds) from None
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


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
    pool, waiting = _pool(workers), iter(batches)
    out: deque[tuple[list[_Item], Future[list[_Found]]]] = deque()
    try:
        while True:
            out.extend((some, _sent(pool, work, some)) for some in islice(waiting, _AHEAD * workers - len(out)))
            if not out:
                return
            some, future = out.popleft()
            try:
                found = future.result(timeout=seconds * len(some) + _GRACE)
            except (TimeoutError, BrokenProcessPool):
                _end(pool)
                yield from _alone(work, some, seconds, failed)
                pool = _pool(workers)
                out = deque((other, _sent(pool, work, other)) for other, _ in out)
            else:
                yield from found
    finally:
        _end(pool)


def _sent(
    pool: ProcessPoolExecutor, work: Callable[[list[_Item]], list[_Found]], some: list[_Item]
) -> Future[list[_Found]]:
    """A batch on its way; that the pool is broken is told when it is this batch's turn."""
    try:
        return pool.submit(work, some)
    except BrokenProcessPool as problem:
        future: Future[list[_Found]] = Future()
        future.set_exception(problem)
        return future


def _alone(
    work: Callable[[list[_Item]], list[_Found]],
    items: list[_Item],
    seconds: float,
    failed: Callable[[_Item, str], _Found],
) -> Iterator[_Found]:
    """Each in a process of its own, so that it is known which of them it was."""
    for item in items:
        pool = _pool(1)
        future = pool.submit(work, [item])
        processes = _processes(pool)
        try:
            yield future.result(timeout=seconds + _GRACE)[0]
        except TimeoutError:
            yield failed(item, "hung")
        except BrokenProcessPool:
            yield failed(item, "hung" if any(_was_ended(process) for process in processes) else "died")
        finally:
            _end(pool)


def _pool(workers: int) -> ProcessPoolExecutor:
    """Of processes that leave an interruption to the one that has sent them the work."""
    spawn = multiprocessing.get_context("spawn")
    return ProcessPoolExecutor(workers, mp_context=spawn, initializer=_begin)


def _begin() -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    watch()


def _was_ended(process: BaseProcess) -> bool:
    """By its watchdog."""
    process.join(1.0)
    return process.exitcode == ENDED


def _processes(pool: ProcessPoolExecutor) -> list[BaseProcess]:
    return list((getattr(pool, "_processes", None) or {}).values())


def _end(pool: ProcessPoolExecutor) -> None:
    """Now, not when a hanging worker is done."""
    processes = _processes(pool)
    pool.shutdown(wait=False, cancel_futures=True)
    for process in processes:
        process.kill()
        process.join(1.0)
