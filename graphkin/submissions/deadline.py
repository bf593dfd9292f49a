"""A time limit for one submission, in a process's own main thread.

An alarm ends what runs in Python. What is stuck in a library's own code hears none: in a worker process that is there
to be lost, a watchdog ends the process a little later.
"""

from __future__ import annotations

import contextlib
import faulthandler
import os
import signal
import threading
from collections.abc import Iterator

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
