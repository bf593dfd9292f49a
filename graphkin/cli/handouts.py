"""`handout`: problems on paper."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from graphkin.cli import shared, streams
from graphkin.cli.shared import DriverOptions
from graphkin.cli.spoken import misused
from graphkin.errors import Lang, NothingToScan

if TYPE_CHECKING:
    from graphkin.handouts import Handout, Stage
    from graphkin.model.mechanism import Mechanism
    from graphkin.submissions import Student

    Problem = tuple[Mechanism, Student | None]  # and whom it is for


@click.command()
@click.argument("mechanisms", metavar="MECHANISM|DIR...", nargs=-1, required=True)
@click.option("-o", "--output", type=click.Path(path_type=Path),
              help=".pdf, .html, or a folder: a file for each mechanism.")
@click.option("--stage", type=click.Choice(["problem", "blank", "half", "solution"]), default="solution",
              show_default=True, help="The problem; with room to draw; begun; solved.")
@click.option("--upto", type=click.IntRange(0), show_default="1",
              help="Of --stage half: so many vector equations are done.")
@click.option("--answers", is_flag=True, help="The answers of all at the end.")
@click.option("--both", is_flag=True, help="In both languages, one after the other.")
@click.option("--paper", type=click.Choice(shared.PAPERS), default="A4", show_default=True, help="Paper.")
@click.option("--duplex", is_flag=True, help="For printing on both sides: each problem begins on the front of a sheet.")
@click.option("--font", type=click.Path(path_type=Path, dir_okay=False), help="A font file with the letters wanted.")
@click.option("--scan", type=click.IntRange(0, 60_000), metavar="NUMBER",
              help="Print what sets a photograph straight, and sheet numbers from this one on.")
@click.option("--number", type=click.IntRange(1), help="Of the first problem; of several it is 1 if left out.")
@click.option("--seed", default="", help="The set it belongs to, as every page says it.")
@shared.force_option
@shared.driver_options
@shared.speaking
def handout(
    mechanisms: tuple[str, ...], output: Path | None, stage: Stage, upto: int | None, answers: bool, both: bool,
    paper: str, duplex: bool, font: Path | None, scan: int | None, number: int | None, seed: str, force: bool,
    at: DriverOptions, lang: Lang,
) -> None:  # fmt: skip
    """Make handouts: a problem, a worksheet at true scale, a half-worked or a whole solution; several make a book.

    DIR is a folder that `problems` wrote: each student's own problem, in one file to print; into a folder, a file each.

    \b
    Example:
      graphkin handout ex3-1 --stage blank -o worksheet.pdf
      graphkin handout ex3-1 ex3-5 p3-6a --answers -o book.pdf --lang zh
      graphkin handout homework --stage blank --scan 0 -o sheets/
    """
    from graphkin.handouts import in_languages, saving
    from graphkin.handouts.problem import untold_answers
    from graphkin.outputs import files

    if scan is not None and stage == "solution":
        raise NothingToScan()
    problems, seed = _problems(mechanisms, seed, at)
    books, sheets = _books(problems, output or Path(f"{problems[0][0].name}.pdf"), scan is not None)
    langs: tuple[Lang, ...] = ("zh", "en") if both else (lang,)
    for path, several in streams.counted(books, True):
        files.refuse(path, force, saving.MARKS)
        machines, whose = zip(*several, strict=True)
        with streams.waiting(len(books) == 1):
            made = in_languages(machines, stage, langs, upto=upto, answers=answers, seed=seed, whose=whose,
                                duplex=duplex, number=number)  # fmt: skip
        for machine, who in several if stage != "solution" else ():
            for line in untold_answers(machine, lang) if who is None else ():  # those of a set can be told
                click.echo(line, err=True)
        pages = _write(path, made, paper, font, scan, force, sheets)
        scan = None if scan is None else scan + pages  # sheet numbers go on from file to file, and those of problems
        number = number if number is None or any(whose) else number + 1


def _books(problems: list[Problem], output: Path, scan: bool) -> tuple[list[tuple[Path, list[Problem]]], Path | None]:
    """Each file with its problems, and the list of sheets that all files of a folder have."""
    from graphkin.outputs.sheets_json import NAME

    if output.is_dir() or not output.suffix:
        shared.refuse_one_file((machine.name for machine, _ in problems), ".pdf")
        output.mkdir(parents=True, exist_ok=True)
        return [(output / f"{machine.name}.pdf", [(machine, who)]) for machine, who in problems], output / NAME
    kind = output.suffix.lower()
    misused("usage.suffix", kind not in (".pdf", ".html"), output=output, kinds=".pdf, .html")
    misused("usage.needs", scan and kind == ".html", option="--scan", other="-o OUT.pdf")
    return [(output, problems)], None


def _problems(sources: tuple[str, ...], seed: str, at: DriverOptions) -> tuple[list[Problem], str]:
    """Those of a problem set in its order; and the set's seed."""
    from graphkin.handouts.problem_folder import is_set, students_of

    problems: list[Problem] = []
    for source in sources:
        if source and is_set(Path(source)):
            misused("usage.without", at, option=source, others="--angle, --at")
            own, students = students_of(Path(source))
            seed = seed or own
            problems += [(shared.read(str(path)), who) for who, path in students]
        else:
            problems.append((shared.read_at(source, at), None))
    return problems, seed


def _write(
    path: Path, made: Handout, paper: str, font: Path | None, scan: int | None, force: bool, sheets: Path | None
) -> int:
    """Write a handout; the number of its pages of paper."""
    from graphkin.handouts.saving import SavedHandout
    from graphkin.handouts.typst import page_count
    from graphkin.outputs.sheets_json import NAME

    SavedHandout(**vars(made)).save(path, paper=paper, font=font, scan=scan, force=force, sheets=sheets)
    count = page_count(path.read_bytes()) if path.suffix.lower() != ".html" else 0
    if scan is not None:
        listed = path.with_suffix(f".{NAME}") if sheets is None else sheets
        click.echo(f"#{scan}-{scan + count - 1} {path.name}, {listed.name}", err=True)
    click.echo(str(path))
    return count
