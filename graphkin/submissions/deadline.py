"""A time limit for reading one submission, in a process's own main thread."""

from __future__ import annotations

import contextlib
import signal
import threading
from collections.abc import Iterator

from graphkin.errors import TookTooLong, Where

_AGAIN = 0.2
"""A reader that swallows the alarm is told again so soon [s]."""


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
        try:
            yield
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
    except _TimeUp:
        raise TookTooLong(where, seconds) from None
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
