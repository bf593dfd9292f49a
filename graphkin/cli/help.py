"""`help`: the pages that tell more than a command's own `--help`."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

import click

from graphkin.cli.shared import lang_option, speaking
from graphkin.errors import Lang


def _file(lang: Lang) -> Iterator[str]:
    from graphkin.say.file_help import file_lines

    return file_lines(lang)


def _api(names: tuple[str, ...]) -> str:
    from graphkin.cli import reference

    if unknown := [name for name in names if name not in reference.names()]:
        raise click.UsageError(f"no {', '.join(unknown)} in the interface. There are: {', '.join(reference.names())}")
    return reference.text(*names)


PAGES: Mapping[str, Callable[[Lang], Iterator[str]]] = {"file": _file}
"""By topic; any other word is a command."""


@click.command("help")
@click.argument("topic", metavar="[file|api|COMMAND]", default="")
@click.argument("names", nargs=-1, metavar="[NAME]...")
@lang_option
@speaking
def help_(topic: str, names: tuple[str, ...], lang: Lang) -> None:
    """Print the reference of the mechanism file, of the Python interface, or what a command says of itself.

    After api: the names that are wanted; all without any.

    \b
    Example:
      graphkin help file
      graphkin help api sweep Mechanism
      graphkin help sweep
    """
    if topic == "api":
        click.echo(_api(names))
        return
    if names:
        raise click.UsageError("only help api takes names")
    if topic in PAGES:
        click.echo("\n".join(PAGES[topic](lang)))
        return
    context = click.get_current_context().find_root()
    assert isinstance(context.command, click.Group)
    command = context.command.get_command(context, topic) if topic else context.command
    if command is None:
        raise click.UsageError(f"there is no page {topic!r}: {', '.join(PAGES)}, api, or a command")
    within = context if command is context.command else click.Context(command, info_name=topic, parent=context)
    click.echo(command.get_help(within))
