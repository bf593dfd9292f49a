"""`page`: mechanisms that play in a browser, or a problem on a drawing board there."""

from __future__ import annotations

import sys
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

import click

from graphkin.cli import shared, streams
from graphkin.cli.spoken import misused
from graphkin.cli.watching import watch
from graphkin.errors import Lang

if TYPE_CHECKING:
    from graphkin.page.player import Data


@click.command()
@shared.mechanisms_argument
@shared.svg_option("The page to write, .html; else NAME.html.", kinds=(".html",))
@click.option("--board", is_flag=True, help="A drawing board: the problem to be drawn and handed in.")
@shared.coincident_option
@shared.method_option
@click.option("--watch", "watched", is_flag=True,
              help="Write it again whenever a file is saved, until Ctrl-C; where it is open it follows.")  # fmt: skip
@shared.force_option
@shared.speaking
def page(
    mechanisms: tuple[str, ...], output: Path | None, board: bool, coincident: str, method: str, watched: bool,
    force: bool, lang: Lang,
) -> None:  # fmt: skip
    """Write a page that plays in any browser: drag the crank, the polygons follow; several make a lecture.

    \b
    Example:
      graphkin page ex3-7 -o shaper.html
      graphkin page ex3-1 ex3-7 p3-20 -o lecture.html --lang zh
      graphkin page ex3-1 --board -o board.html
      graphkin page mine.toml --watch
    """
    misused("usage.one", board and len(mechanisms) > 1, option="--board", what="MECHANISM")
    sources, made = list(dict.fromkeys(mechanisms)), dict[str, "Data"]()

    def write(changed: list[str]) -> None:
        from graphkin.page import writer
        from graphkin.page.board import board_page

        with streams.waiting():
            if board:
                machine = shared.read(changed[0])
                name, text = machine.name, board_page(machine, lang)
            else:
                name, text = _played(changed, sources, made, coincident, method, lang)
            target = output or Path(f"{name}.html")
            writer.write(target, writer.watched(text) if watched else text, force)
        click.echo(str(target))

    def write_again(source: str) -> None:
        with suppress(SystemExit), shared.errors_said(lang):
            write([source])
        sys.stdout.flush()

    if watched:
        watch(sources, write_again)
    else:
        write(sources)


def _played(
    changed: list[str], sources: list[str], made: dict[str, Data], coincident: str, method: str, lang: Lang
) -> tuple[str, str]:
    """The name of the first mechanism, and the page of all that are made: those that changed, and before."""
    from graphkin.page import player

    for source in changed:
        made[source] = player.played(shared.plan(shared.read(source), coincident, method))
    every = [made[source] for source in sources if source in made]
    return str(every[0]["name"]), player.page_of(every, lang)
