"""`help`: reference pages."""

from __future__ import annotations

import click


@click.group()
def help() -> None:
    """Reference pages: the Python interface."""


@help.command()
@click.argument("names", nargs=-1, metavar="[NAME]...")
def api(names: tuple[str, ...]) -> None:
    """The Python interface: every public name, or those given.

    \b
    Example:
      graphkin help api
      graphkin help api sweep Mechanism
    """
    from graphkin import reference

    if unknown := [name for name in names if name not in reference.names()]:
        raise click.UsageError(f"no {', '.join(unknown)} in the interface. There are: {', '.join(reference.names())}")
    click.echo(reference.text(*names))
