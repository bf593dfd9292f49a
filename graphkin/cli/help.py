"""`help`: the pages that tell more than a command's own `--help`."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

import click

from graphkin.cli.shared import lang_option, speaking
from graphkin.errors import Lang


def _file(lang: Lang) -> Iterator[str]:
    from graphkin.say.file_help import file_lines

    return file_lines(lang)


PAGES: Mapping[str, Callable[[Lang], Iterator[str]]] = {"file": _file}
"""By topic; any other word is a command."""


@click.command("help")
@click.argument("topic", metavar="[file|COMMAND]", default="")
@lang_option
@speaking
def help_(topic: str, lang: Lang) -> None:
    """Print the reference of the mechanism file, or what a command says of itself.

    \b
    Example:
      graphkin help file
      graphkin help sweep
    """
    if topic in PAGES:
        click.echo("\n".join(PAGES[topic](lang)))
        return
    context = click.get_current_context().find_root()
    assert isinstance(context.command, click.Group)
    command = context.command.get_command(context, topic) if topic else context.command
    if command is None:
        raise click.UsageError(f"there is no page {topic!r}: {', '.join(PAGES)}, or a command")
    within = context if command is context.command else click.Context(command, info_name=topic, parent=context)
    click.echo(command.get_help(within))
