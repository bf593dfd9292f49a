"""`handout`: problems on paper."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import click

from graphkin.cli.shared import (
    PAPERS,
    angle_option,
    at_option,
    force_option,
    lang_option,
    read,
    read_at,
    refuse_one_file,
    speaking,
)
from graphkin.errors import Lang

if TYPE_CHECKING:
    from graphkin.handouts import Handout, Stage
    from graphkin.model.mechanism import Mechanism

_KINDS = (".pdf", ".html")


@click.command()
@click.argument("mechanisms", metavar="MECHANISM|DIR...", nargs=-1, required=True)
@click.option("-o", "--output", type=click.Path(path_type=Path),
              help=".pdf, .html, or a folder: a file for each mechanism.")  # fmt: skip
@click.option("--stage", type=click.Choice(["problem", "blank", "half", "solution"]), default="solution",
              show_default=True, help="The problem; with room to draw; begun; solved.")  # fmt: skip
@click.option("--upto", type=click.IntRange(0), default=1, show_default=True,
              help="Of --stage half: so many vector equations are done.")  # fmt: skip
@click.option("--answers", is_flag=True, help="The answers of all at the end.")
@click.option("--both", is_flag=True, help="In both languages, one after the other.")
@click.option("--paper", type=click.Choice(PAPERS), default="A4", show_default=True, help="Paper.")
@click.option("--duplex", is_flag=True, help="For printing on both sides: each problem begins on the front of a sheet.")
@click.option("--font", type=click.Path(path_type=Path, dir_okay=False), help="A font file with the letters wanted.")
@click.option("--scan", type=click.IntRange(0, 60_000), metavar="NUMBER",
              help="Print what sets a photograph straight, and sheet numbers from this one on.")  # fmt: skip
@click.option("--seed", default="", help="The set it belongs to, as every page says it.")
@force_option
@angle_option
@at_option
@lang_option
@speaking
def handout(
    mechanisms: tuple[str, ...], output: Path | None, stage: Stage, upto: int, answers: bool, both: bool, paper: str,
    duplex: bool, font: Path | None, scan: int | None, seed: str, force: bool, angles: tuple[float, ...],
    displacements: tuple[float, ...], lang: Lang,
) -> None:  # fmt: skip
    """Make handouts: a problem, a worksheet at true scale, a half-worked or a whole solution; several make a book.

    DIR is a folder that `problems` wrote: each student's own problem, in one file to print; into a folder, a file each.

    \b
    Example:
      graphkin handout ex3-1 --stage blank -o worksheet.pdf
      graphkin handout ex3-1 ex3-5 p3-6a --answers -o book.pdf --lang zh
      graphkin handout homework --stage blank --scan 0 -o sheets/
    """
    from graphkin.handouts import in_languages
    from graphkin.outputs import files

    problems, seed = _problems(mechanisms, seed, angles, displacements)
    output = output or Path(f"{problems[0][0].name}.pdf")
    folder = output.is_dir() or not output.suffix
    kind = ".pdf" if folder else output.suffix.lower()
    if kind not in _KINDS:
        raise click.UsageError(f"{output}: the file to write must end in {' or '.join(_KINDS)}, or be a folder")
    if scan is not None and kind == ".html":
        raise click.UsageError("--scan needs a .pdf: a page of a browser has no fixed size")
    langs: tuple[Lang, ...] = ("zh", "en") if both else (lang,)
    if folder:
        refuse_one_file((machine.name for machine, _ in problems), kind)
        output.mkdir(parents=True, exist_ok=True)
    for path, several in _files(output, problems, folder):
        files.refuse(path, force, _MARKS)
        machines, whose = [machine for machine, _ in several], [who for _, who in several]
        made = in_languages(machines, stage, langs, upto=upto, answers=answers, seed=seed, whose=whose, duplex=duplex)
        content, told = _set_in(kind, made, paper, font, scan)
        with files.beside(path, force, _MARKS) as draft:
            draft.write_bytes(content)
        if scan is not None:
            click.echo(f"#{scan}-{scan + told - 1} {path.name}", err=True)
            scan += told  # sheet numbers go on from file to file
        click.echo(str(path))


_MARKS = (b"graphkin handout",)


def _problems(
    sources: tuple[str, ...], seed: str, angles: tuple[float, ...], displacements: tuple[float, ...]
) -> tuple[list[tuple[Mechanism, str]], str]:
    """Each mechanism with whom it is for, those of a problem set in its order; and the set's seed."""
    from graphkin.homework.platforms import is_set, students_of

    found: list[tuple[Mechanism, str]] = []
    for source in sources:
        if source and is_set(Path(source)):
            if angles or displacements:
                raise click.UsageError("--angle and --at are for a MECHANISM: the students of a set have their own")
            own, students = students_of(Path(source))
            seed = seed or own
            found += [(read(str(path)), who) for who, path in students]
        else:
            found.append((read_at(source, angles, displacements), ""))
    return found, seed


def _files(
    output: Path, problems: list[tuple[Mechanism, str]], folder: bool
) -> Iterator[tuple[Path, list[tuple[Mechanism, str]]]]:
    """One file, or one for each in a folder."""
    if not folder:
        yield output, problems
        return
    for machine, who in problems:
        yield output / f"{machine.name}.pdf", [(machine, who)]


def _set_in(kind: str, made: Handout, paper: str, font: Path | None, scan: int | None) -> tuple[bytes, int]:
    """What the file holds, and how many pages of paper that is."""
    if kind == ".html":
        from graphkin.handouts.page import html

        return html(made, paper).encode(), 0
    from graphkin.handouts.typst import pages, pdf

    content = pdf(made, paper, font, scan)
    return content, pages(content)
