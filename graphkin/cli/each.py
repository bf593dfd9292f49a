"""Commands for one mechanism that take several, one after the other, and go on with `--watch`."""

from __future__ import annotations

import functools
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import click

from graphkin.cli.shared import is_folder, mechanisms_argument, refuse_one_file


def each_mechanism(command: Callable[..., None]) -> Callable[..., None]:
    """The command for each MECHANISM. One that is refused stops none of the others; the worst status is that of all."""

    @functools.wraps(command)
    def wrapped(mechanisms: tuple[str, ...], watch: bool, **options: Any) -> None:
        output = options.get("output")
        or_folder = ", or a folder" if command.__name__ == "draw" else ""
        if len(mechanisms) > 1 and output is not None and not (or_folder and is_folder(output)):
            raise click.UsageError(f"-o writes one file; name one MECHANISM{or_folder}, or leave -o out")
        if command.__name__ == "draw":
            refuse_one_file((Path(source).stem for source in dict.fromkeys(mechanisms)), ".svg")
        if watch:
            from graphkin.cli import watching

            watching.watch(mechanisms, lambda source: _alive(command, source, options))
            return
        if status := max(_each(command, mechanisms, options)):
            sys.exit(status)

    option = click.option("--watch", is_flag=True, help="Do it again whenever a file is saved, until Ctrl-C.")
    return mechanisms_argument(option(wrapped))


def _each(command: Callable[..., None], mechanisms: Sequence[str], options: dict[str, Any]) -> list[int]:
    """The statuses, a blank line between what is said of two."""
    found = []
    for k, source in enumerate(mechanisms):
        if k and command.__name__ != "draw":
            click.echo()
        found.append(_status(command, source, options))
    return found


def _status(command: Callable[..., None], source: str, options: dict[str, Any]) -> int:
    try:
        command(mechanism=source, **options)
    except SystemExit as end:
        return end.code if isinstance(end.code, int) else 1
    return 0


def _alive(command: Callable[..., None], source: str, options: dict[str, Any]) -> None:
    """What is wrong is said, and a file that is mended is looked at again."""
    try:
        _status(command, source, options)
    except click.ClickException as error:
        error.show()
    sys.stdout.flush()
