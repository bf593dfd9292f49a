"""Time limits: an alarm for one submission, and worker processes that may hang or die.

An alarm ends what runs in Python, in a process's own main thread. What is stuck in a library's own code hears none: in
a worker process that is there to be lost, a watchdog ends the process a little later. What takes its process with it,
and what neither of them reaches, is tried again alone, then given up with a word.
"""

from __future__ import annotations

import contextlib
import faulthandler
import gc
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
from typing import Any, ParamSpec, TypeVar

from graphkin.errors import TookTooLong, Where

_Item = TypeVar("_Item")
_Result = TypeVar("_Result")
_Args = ParamSpec("_Args")
_AGAIN = 0.2  # a reader that swallows the alarm hears it again so soon [s]
_LATER = 2.0  # so long after the alarm the watchdog ends the process [s]
_ENDED = 1  # the exit status of a process that its watchdog has ended
_AHEAD = 3
_NOWHERE: list[int] = []  # the file into which the watchdog writes; none where this process may not be ended
_WORK: list[Callable[[list[Any]], list[Any]]] = []  # what this process does with every batch
_THREADS = "/proc/self/task"
_GRACE = 5.0  # beyond its limits a batch is waited for so long [s]


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
        if _NOWHERE:
            faulthandler.dump_traceback_later(seconds + _LATER, exit=True, file=_NOWHERE[0])
        try:
            yield
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            if _NOWHERE:
                faulthandler.cancel_dump_traceback_later()
    except _TimeUp:
        raise TookTooLong(where, seconds) from None
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def guarded(
    work: Callable[[list[_Item]], list[_Result]], batches: Iterable[list[_Item]], workers: int, seconds: float,
    failed: Callable[[_Item, str], _Result],
) -> Iterator[_Result]:  # fmt: skip
    """The results of `work` for every item, in order, a bounded number of batches in flight.

    work     a function that processes can import; it keeps to `seconds` an item by itself
    failed   what stands for an item whose process hung ("hung") or ended ("died")
    """
    pool, waiting = worker_pool(workers, work), iter(batches)
    out: deque[tuple[list[_Item], Future[list[_Result]]]] = deque()
    try:
        while True:
            out.extend((some, _sent(pool, some)) for some in islice(waiting, _AHEAD * workers - len(out)))
            if not out:
                return
            some, future = out.popleft()
            try:
                results = future.result(timeout=seconds * len(some) + _GRACE)
            except (TimeoutError, BrokenProcessPool):
                _end(pool)
                for item in some:
                    yield _alone(work, item, seconds, failed)
                pool = worker_pool(workers, work)
                out = deque((other, _sent(pool, other)) for other, _ in out)
            else:
                yield from results
    finally:
        _end(pool)


def _sent(pool: ProcessPoolExecutor, some: list[_Item]) -> Future[list[Any]]:
    """A batch on its way; that the pool is broken is said when it is this batch's turn."""
    try:
        return pool.submit(_worked, some)
    except BrokenProcessPool as problem:
        future: Future[list[Any]] = Future()
        future.set_exception(problem)
        return future


def _alone(
    work: Callable[[list[_Item]], list[_Result]], item: _Item, seconds: float, failed: Callable[[_Item, str], _Result]
) -> _Result:
    """One item in a process of its own, so that it is clear which of a batch it was."""
    pool = worker_pool(1, work)
    future: Future[list[_Result]] = pool.submit(_worked, [item])
    processes = _processes(pool)
    try:
        return future.result(timeout=seconds + _GRACE)[0]
    except TimeoutError:
        return failed(item, "hung")
    except BrokenProcessPool:
        for process in processes:
            process.join(1.0)
        return failed(item, "hung" if any(process.exitcode == _ENDED for process in processes) else "died")
    finally:
        _end(pool)


def worker_pool(workers: int, *work: Callable[[list[Any]], list[Any]]) -> ProcessPoolExecutor:
    """Of processes that leave an interruption to the one that has sent them the work. They are copies of this one, in
    which all is loaded, where it has no other thread that could hold a lock meanwhile; work: what they get once."""
    alone = os.path.isdir(_THREADS) and len(os.listdir(_THREADS)) == 1
    context = multiprocessing.get_context("fork" if alone else "spawn")
    return _Pool(workers, mp_context=context, initializer=_begin, initargs=work)


class _Pool(ProcessPoolExecutor):
    """Its processes are begun, and known to it, before an interruption is heard; they never hear any."""

    def submit(self, fn: Callable[_Args, _Result], /, *args: _Args.args, **named: _Args.kwargs) -> Future[_Result]:
        with _deaf():
            return super().submit(fn, *args, **named)


@contextlib.contextmanager
def _deaf() -> Iterator[None]:
    """An interruption waits; a process that is begun now inherits that, and is deaf while Python is being loaded."""
    if not hasattr(signal, "pthread_sigmask") or threading.current_thread() is not threading.main_thread():
        yield
        return
    heard: list[int] = []
    handler = signal.signal(signal.SIGINT, lambda number, _: heard.append(number))
    mask = signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, mask)
        signal.signal(signal.SIGINT, handler or signal.SIG_DFL)
    if heard:
        signal.raise_signal(signal.SIGINT)


def _worked(some: list[Any]) -> list[Any]:
    """The work of this process on a batch."""
    return _WORK[0](some)


def _begin(*work: Callable[[list[Any]], list[Any]]) -> None:
    """From now on this process is ended where an alarm is not heard."""
    _WORK.extend(work)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    gc.freeze()  # what a copy has from the beginning stays shared
    if not _NOWHERE:
        _NOWHERE.append(os.open(os.devnull, os.O_WRONLY))


def _processes(pool: ProcessPoolExecutor) -> list[BaseProcess]:
    return list((getattr(pool, "_processes", None) or {}).values())


def _end(pool: ProcessPoolExecutor) -> None:
    """Now, not when a hanging worker is done."""
    processes, manager = _processes(pool), getattr(pool, "_executor_manager_thread", None)
    pool.shutdown(wait=False, cancel_futures=True)
    for process in processes:
        process.kill()
        process.join(1.0)
    if manager is not None:  # it gives back what the processes shared; not waited for where it hangs
        manager.join(1.0)
