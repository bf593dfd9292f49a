"""`--watch`: a command again whenever a file is saved."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Sequence
from pathlib import Path

import click

PAUSE = 0.3
"""Between two looks at the files [s]."""

Stamp = tuple[tuple[int, int, int] | None, ...]


def watch(files: Sequence[str], act: Callable[[str], None]) -> None:
    """Act on each file, and again on each one that is saved, until Ctrl-C."""
    for file in files:
        if not Path(file).is_file():
            raise click.UsageError(f"--watch looks at files, and {file} is none")
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
    time.sleep(PAUSE)


def _stamp(file: str) -> Stamp:
    """What changes when a file is saved, replaced by another too; None while an editor has it away."""
    try:
        found = os.stat(file)
    except OSError:
        return (None,)
    return ((found.st_mtime_ns, found.st_size, found.st_ino),)
