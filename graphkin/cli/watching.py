"""Commands for one mechanism that take several, one after the other, and again with `--watch` when a file is saved."""

from __future__ import annotations

import functools
import os
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path

import click

from graphkin.cli.shared import is_folder, mechanisms_argument, refuse_one_file
from graphkin.cli.spoken import misused

PAUSE = 0.3  # between two looks at the files [s]

Stamp = tuple[tuple[int, int, int] | None, ...]


def each_mechanism(command: Callable[..., None]) -> Callable[..., None]:
    """The command for each MECHANISM. One that is refused stops none of the others; the worst status is that of all."""
    draws = command.__name__ == "draw"

    @functools.wraps(command)
    def wrapped(mechanisms: tuple[str, ...], watched: bool, **options: object) -> None:
        output = options.get("output")
        one = isinstance(output, Path) and not (draws and is_folder(output))
        misused("usage.one", one and len(mechanisms) > 1, option=f"-o {output}", what="MECHANISM")
        if draws:
            refuse_one_file((Path(source).stem for source in dict.fromkeys(mechanisms)), ".svg")
        if watched:
            watch(mechanisms, lambda source: _again(command, source, options))
            return
        statuses = []
        for k, source in enumerate(mechanisms):
            if k and not draws:
                click.echo()
            statuses.append(_status(command, source, options))
        if status := max(statuses):
            sys.exit(status)

    again = "Do it again whenever a file is saved, until Ctrl-C."
    return mechanisms_argument(click.option("--watch", "watched", is_flag=True, help=again)(wrapped))


def _status(command: Callable[..., None], source: str, options: dict[str, object]) -> int:
    try:
        command(mechanism=source, **options)
    except SystemExit as end:
        return end.code if isinstance(end.code, int) else 1
    return 0


def _again(command: Callable[..., None], source: str, options: dict[str, object]) -> None:
    """Errors are said and end nothing: a file that is mended is looked at again."""
    try:
        _status(command, source, options)
    except click.ClickException as error:
        error.show()
    sys.stdout.flush()


def watch(files: Sequence[str], act: Callable[[str], None]) -> None:
    """Act on each file, and again on each one that is saved, until Ctrl-C."""
    for file in files:
        misused("usage.watched", not Path(file).is_file(), file=file)
    seen: dict[str, Stamp] = dict.fromkeys(files, ())
    try:
        while True:
            for file in files:
                now = _stamp(file)
                if now != seen[file] and now != (None,):
                    seen[file] = now
                    act(file)
            wait()
    except KeyboardInterrupt:
        return


def wait() -> None:
    """Sleep until files are looked at again."""
    time.sleep(PAUSE)


def _stamp(file: str) -> Stamp:
    """Numbers that change when a file is saved or replaced by another; None while an editor has it away."""
    try:
        state = os.stat(file)
    except OSError:
        return (None,)
    return ((state.st_mtime_ns, state.st_size, state.st_ino),)
