"""Standard streams: there, in UTF-8 or with letters replaced, and an end of their reader that is no error."""

from __future__ import annotations

import errno
import io
import os
import sys
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from itertools import count
from threading import Event, Thread
from time import monotonic
from typing import TypeVar

import click

from graphkin.cli.spoken import user_language
from graphkin.errors import CannotWrite

_Item = TypeVar("_Item")
_PATIENCE, _TICK = 2.0, 0.5  # so long nobody is told to wait; how often the bar moves [s]

NO_READER = (errno.EPIPE, errno.EINVAL) if sys.platform == "win32" else (errno.EPIPE,)
"""Errors of writing into a pipe that nobody reads any more."""


def prepare() -> None:
    """Streams that take every text.

    A file or a pipe gets UTF-8 whatever the system's own encoding is, so that what one command writes another reads;
    a terminal keeps its encoding, and letters it does not have are replaced. A stream that is closed leads nowhere.
    """
    for number, name in enumerate(("stdin", "stdout", "stderr")):
        if getattr(sys, name) is None:
            nowhere = os.open(os.devnull, os.O_RDWR)
            if nowhere != number:  # its number, too, so that no file that is opened later is taken for the stream
                os.dup2(nowhere, number)
                os.close(nowhere)
            setattr(sys, name, os.fdopen(number, "r" if name == "stdin" else "w", encoding="utf-8", closefd=False))
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            encoding = stream.encoding if stream.isatty() else "utf-8"
            stream.reconfigure(encoding=encoding, errors="replace")


@contextmanager
def written() -> Iterator[None]:
    """A reader that has had enough ends the command quietly; a stream that takes nothing is said, exit status 3."""
    try:
        yield
        sys.stdout.flush()
    except OSError as error:
        sys.exit(ended(error))


def flushed() -> bool:
    """True where all that was printed could be written."""
    try:
        sys.stdout.flush()
        sys.stderr.flush()
    except OSError as error:
        return ended(error) == 0
    return True


def ended(error: OSError) -> int:
    """The exit status of a command that could not write."""
    if isinstance(error, BrokenPipeError) or error.errno in NO_READER:
        return 0
    refused = CannotWrite.by(error.filename or "<stdout>", error)
    click.echo(refused.message(user_language()), err=True)
    return refused.exit_code


def counted(items: Iterable[_Item], printed: bool) -> Iterator[_Item]:
    """The items, counted for one who waits at a terminal on which nothing else is being printed; one alone is not."""
    quiet = not sys.stderr.isatty() or (printed and sys.stdout.isatty())
    quiet = quiet or (isinstance(items, Sequence) and len(items) < 2)
    if quiet:
        yield from items
        return
    with click.progressbar(items, file=sys.stderr, show_pos=True) as bar:
        yield from bar


@contextmanager
def waiting(alone: bool = True) -> Iterator[None]:
    """A bar that moves, with the time, at a terminal where work takes more than two seconds, unless another counts."""
    if not (alone and sys.stderr.isatty()):
        yield
        return
    done, start = Event(), monotonic()

    def move() -> None:
        if not done.wait(_PATIENCE):
            seconds = lambda _: f"{monotonic() - start:.0f} s"  # noqa: E731
            with click.progressbar(count(), file=sys.stderr, show_eta=False, item_show_func=seconds) as bar:
                while not done.wait(_TICK):
                    bar.update(1)

    mover = Thread(target=move, daemon=True)
    mover.start()
    try:
        yield
    finally:
        done.set()
        mover.join()
