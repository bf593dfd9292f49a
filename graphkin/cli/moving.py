"""`sweep`: a mechanism through a turn, or as far as it gets."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Literal

import click

from graphkin.cli.shared import force_option, lang_option, mechanism_argument, ranges_option, read, speaking
from graphkin.errors import Lang

if TYPE_CHECKING:
    from graphkin.sweeps import Course, Road

__all__ = ["sweep"]

LONG = 200_000
"""Positions from which a sweep shows how far it is."""


@click.command()
@mechanism_argument
@ranges_option
@click.option("--of", default="", metavar="QUANTITIES",
              help='Such as "theta 3, v E, a_k B3B2"; else what the file asks.')  # fmt: skip
@click.option("--by", type=click.Choice(["construction", "analysis"]), default="construction", show_default=True,
              help="Replay the construction at every position, or solve the loop equations there.")  # fmt: skip
@click.option("-o", "--output", type=click.Path(path_type=Path, dir_okay=False),
              help=".csv, .json, .parquet, or a diagram: .svg, .png, .pdf; - for CSV on stdout.")  # fmt: skip
@click.option("--table", is_flag=True, help="Print as table 3-1 of the textbook: deg and m, five decimals.")
@click.option("--limit", "limits", multiple=True, metavar="QUANTITY VALUE",
              help='Say where a size is passed, such as "a E 3 g".')  # fmt: skip
@force_option
@lang_option
@speaking
def sweep(
    mechanism: str, ranges: tuple[str, ...], of: str, by: Literal["construction", "analysis"], output: Path | None,
    table: bool, limits: tuple[str, ...], force: bool, lang: Lang,
) -> None:  # fmt: skip
    """Move the mechanism through a turn, or as far as it gets: tables and motion diagrams.

    \b
    Example:
      graphkin sweep ex3-7 --table
      graphkin sweep p3-20 --driver 0:360:1 -o needle.csv
      graphkin sweep ex3-7 --of "theta 3, omega 3, alpha 3, s ram, v E, a E" -o diagram.svg
    """
    from graphkin import api, reports, sweeps

    method = api.plan(read(mechanism))
    course = sweeps.course(method, ranges)
    names = sweeps.asked(method.mechanism, sweeps.split(of))
    if output is None:
        found = sweeps.sweep_over(course, names, by)
        click.echo("\n".join(reports.book_lines(found) if table else reports.sweep_lines(found)))
        for line in (*sweeps.remarks(course, lang), *sweeps.extremes(found, lang)):
            click.echo(line, err=table)
    else:
        _write_sweep(output, course, names, by, force, lang)
        for line in sweeps.remarks(course, lang):
            click.echo(line, err=True)


def _write_sweep(
    output: Path, course: Course, names: tuple[str, ...], by: Road, force: bool, lang: Lang
) -> None:
    from graphkin.outputs import tables
    from graphkin.sweeps import parts

    suffix = output.suffix.lower()
    if str(output) == "-":
        for lines in tables.csv_lines(course, parts(course, names, by)):
            click.echo(lines, nl=False)
        return
    if suffix in tables.FORMATS:
        with click.progressbar(length=course.t.size, file=sys.stderr, hidden=course.t.size < LONG) as bar:
            tables.write(output, course, names, by, force, bar.update)
    elif suffix in (".svg", ".png", ".pdf"):
        from graphkin.outputs import diagram

        if (remark := diagram.write(output, course, names, lang, by, force)) is not None:
            click.echo(remark.message(lang), err=True)
    else:
        raise click.UsageError(f"{output}: the file to write must end in .csv, .json, .parquet, .svg, .png or .pdf")
    click.echo(str(output))
