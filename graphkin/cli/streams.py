"""Standard streams: there, in UTF-8 or with letters replaced, and an end of their reader that is no error."""

from __future__ import annotations

import errno
import io
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager

import click

from graphkin.errors import CannotWrite, Lang

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


def ended(error: OSError, lang: Lang = "en") -> int:
    """The exit status of a command that could not write."""
    if isinstance(error, BrokenPipeError) or error.errno in NO_READER:
        return 0
    refused = CannotWrite.by(error.filename or "<stdout>", error)
    click.echo(refused.message(lang), err=True)
    return refused.exit_code


def spoken(context: click.Context, _: click.Parameter, lang: str | None) -> str | None:
    """A language that is said before the command is the command's, unless that has one of its own; and is kept."""
    context.meta["lang"] = lang
    return lang
