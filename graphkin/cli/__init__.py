"""The commands: parse, call one function, print. A command's module is imported when the command is called.

Exit status: 0 good (also where the reader of a pipe has had enough), 1 a check failed, 2 wrong usage, 3 bad input, or
nowhere to write.
"""

from __future__ import annotations

import os
from importlib import import_module
from typing import Any

import click

from graphkin.cli import spoken, streams
from graphkin.say.catalogue import say

__all__ = ["main"]

CONTEXT = {"help_option_names": ["-h", "--help"], "max_content_width": 100}
COMMANDS = {
    "draw": "drawing", "explain": "drawing", "solve": "drawing", "check": "drawing",
    "sweep": "moving", "find": "moving", "equations": "drawing",
    "centres": "centres", "linkage": "linkages", "design": "design",
    "problems": "problems", "grade": "marking", "tolerance": "marking",
    "handout": "handouts", "page": "page",
    "structure": "library", "list": "library", "show": "library", "schema": "library",
    "help": "reference", "new": "library",
}  # fmt: skip
"""The module of each command."""

BROKEN_OFF = 130  # the exit status after Ctrl-C, as shells have it; 1 would say that a check failed

_THREADS = ("OPENBLAS_NUM_THREADS", "GOTO_NUM_THREADS", "OMP_NUM_THREADS")
"""Variables for the number of threads of NumPy's linear algebra, as its user may have said."""


class Program(click.Group):
    """The commands as a process of their own (a test, which calls `main.main`, has its own settings).

    It computes with one thread, where nothing else is said: matrices are small, and threads that wait for one another
    take longer. Set before NumPy is loaded; processes that it starts inherit it.

    It ends soon: the interpreter is not taken down module by module at the end, which would take a tenth of the whole
    time of `draw`. Files are written and closed by then.
    """

    def __call__(self, *args: Any, **kwargs: Any) -> object:
        if not any(name in os.environ for name in _THREADS):
            os.environ[_THREADS[0]] = "1"
        streams.prepare()
        status: object = 0
        try:
            super().__call__(*args, **kwargs)
        except SystemExit as end:
            status = end.code
        number = status if isinstance(status, int) else 0 if status is None else 1
        os._exit(number or (0 if streams.flushed() else 3))

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        spoken.listen(args)
        return super().parse_args(ctx, args)

    def invoke(self, ctx: click.Context) -> object:
        try:
            with streams.written():
                return super().invoke(ctx)
        except KeyboardInterrupt as end:
            said = str(end) or say("common.broken off", spoken.user_language())
            click.echo("\n" + said, err=True)
            ctx.exit(BROKEN_OFF)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        name, command, rest = super().resolve_command(ctx, args)
        if command is not None and not {"-h", "--help"}.isdisjoint(rest) and spoken.user_language() == "zh":
            command = import_module(f"graphkin.cli.{COMMANDS['help']}").in_chinese(command)
        return name, command, rest

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, name: str) -> click.Command | None:
        if name not in COMMANDS:
            return None
        module = import_module(f"graphkin.cli.{COMMANDS[name]}")
        commands = (entry for entry in vars(module).values() if isinstance(entry, click.Command))
        return next((command for command in commands if command.name == name), None)


@click.group(cls=Program, context_settings=CONTEXT)
@click.version_option(package_name="graphkin")
@click.option("--lang", type=click.Choice(["en", "zh"]), expose_value=False, help="Language, as after a command.")
def main() -> None:
    """Graphical kinematics for planar mechanisms.

    MECHANISM is a TOML file, a name from `graphkin list`, or - for standard input.

    \b
    Example:
      graphkin draw ex3-1
      graphkin show ex3-1 > mine.toml     (edit it, then)
      graphkin draw mine.toml
    """
