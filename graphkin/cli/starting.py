"""`new`: a file to start from."""

from __future__ import annotations

import click

from graphkin.cli.shared import lang_option, speaking
from graphkin.errors import Lang
from graphkin.files import starters


@click.command()
@click.argument("kind", type=click.Choice(starters.kinds()))
@lang_option
@speaking
def new(kind: str, lang: Lang) -> None:
    """Print a mechanism file of a kind, with comments, to start one's own from.

    \b
    Example:
      graphkin new four-bar > mine.toml
      graphkin new shaper --lang zh > mine.toml
    """
    click.echo(starters.text(kind, lang), nl=False)
