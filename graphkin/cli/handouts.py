"""`handout`: problems on paper."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import click

from graphkin.cli.shared import PAPERS, force_option, lang_option, read, speaking
from graphkin.errors import Lang

if TYPE_CHECKING:
    from graphkin.handouts import Stage
    from graphkin.mechanism import Mechanism

_KINDS = (".pdf", ".html")


@click.command()
@click.argument("mechanisms", metavar="MECHANISM...", nargs=-1, required=True)
@click.option("-o", "--output", type=click.Path(path_type=Path),
              help=".pdf, .html, or a folder: a file for each mechanism.")  # fmt: skip
@click.option("--stage", type=click.Choice(["problem", "blank", "half", "solution"]), default="solution",
              show_default=True, help="The problem; with room to draw; begun; solved.")  # fmt: skip
@click.option("--upto", type=click.IntRange(0), default=1, show_default=True,
              help="Of --stage half: so many vector equations are done.")  # fmt: skip
@click.option("--answers", is_flag=True, help="The answers of all at the end.")
@click.option("--both", is_flag=True, help="In both languages, one after the other.")
@click.option("--paper", type=click.Choice(PAPERS), default="A4", show_default=True, help="Paper.")
@click.option("--font", type=click.Path(path_type=Path, dir_okay=False), help="A font file with the letters wanted.")
@click.option("--scan", type=click.IntRange(0, 60_000), metavar="NUMBER",
              help="Print what sets a photograph straight, and sheet numbers from this one on.")  # fmt: skip
@click.option("--seed", default="", help="The set it belongs to, as every page says it.")
@force_option
@lang_option
@speaking
def handout(
    mechanisms: tuple[str, ...], output: Path | None, stage: Stage, upto: int, answers: bool, both: bool, paper: str,
    font: Path | None, scan: int | None, seed: str, force: bool, lang: Lang,
) -> None:  # fmt: skip
    """Make handouts: a problem, a worksheet at true scale, a half-worked or a whole solution; several make a book.

    \b
    Example:
      graphkin handout ex3-1 --stage blank -o worksheet.pdf
      graphkin handout ex3-1 ex3-5 p3-6a --answers -o book.pdf --lang zh
      graphkin handout homework/*.toml --stage blank -o sheets/
    """
    from graphkin.handouts.typst import pages
    from graphkin.outputs import files

    machines = [read(source) for source in mechanisms]
    output = output or Path(f"{machines[0].name}.pdf")
    folder = output.is_dir() or not output.suffix
    if not folder and output.suffix.lower() not in _KINDS:
        raise click.UsageError(f"{output}: the file to write must end in {' or '.join(_KINDS)}, or be a folder")
    if scan is not None and output.suffix.lower() == ".html":
        raise click.UsageError("--scan needs a .pdf: a page of a browser has no fixed size")
    langs: tuple[Lang, ...] = ("zh", "en") if both else (lang,)
    if folder:
        output.mkdir(parents=True, exist_ok=True)
    for path, several in _files(output, machines, folder):  # sheet numbers go on from file to file
        files.refuse(path, force, _MARKS)
        content = _written(path.suffix.lower(), several, stage, langs, upto, answers, seed, paper, font, scan)
        with files.beside(path, force, _MARKS) as draft:
            draft.write_bytes(content)
        if scan is not None:
            click.echo(f"#{scan}-{scan + pages(content) - 1}", err=True)
            scan += pages(content)
        click.echo(str(path))


_MARKS = (b"graphkin handout",)


def _files(output: Path, machines: list[Mechanism], folder: bool) -> Iterator[tuple[Path, list[Mechanism]]]:
    """One file, or one for each in a folder."""
    if not folder:
        yield output, machines
        return
    for machine in machines:
        yield output / f"{machine.name}.pdf", [machine]


def _written(
    kind: str, machines: list[Mechanism], stage: Stage, langs: tuple[Lang, ...], upto: int, answers: bool, seed: str,
    paper: str, font: Path | None, scan: int | None,
) -> bytes:  # fmt: skip
    from dataclasses import replace

    from graphkin.handouts import handout as made
    from graphkin.handouts.document import NewPage

    found = [made(machines, stage, lang, upto=upto, answers=answers, seed=seed) for lang in langs]
    blocks = [block for k, each in enumerate(found) for block in ((NewPage(),) if k else ()) + each.blocks]
    whole = replace(found[0], blocks=tuple(blocks))
    if kind == ".html":
        from graphkin.handouts.page import html

        return html(whole, paper).encode()
    from graphkin.handouts.typst import pdf

    return pdf(whole, paper, font, scan)
