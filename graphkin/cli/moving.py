"""`sweep` and `find`: a mechanism through a turn, or as far as it gets."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from graphkin.cli import shared, streams
from graphkin.cli.spoken import misused
from graphkin.errors import Lang, TooManyRows, Where

if TYPE_CHECKING:
    import numpy as np

    from graphkin.studies.sweeps import Course, Road, Sweep

PRINTED, IN_ONE = 100_000, 1_000_000
"""Rows that are printed as a table, and written as one JSON object, at most."""
LONG = 200_000  # positions from which a sweep shows how far it is


@click.command()
@shared.mechanism_argument
@shared.ranges_option
@click.option("--of", default="", metavar="QUANTITIES",
              help='Such as "theta 3, v E, a_k B3B2"; else what the file asks.')
@shared.by_option
@shared.svg_option(".csv, .json, .jsonl, .parquet, or a diagram: .svg, .png, .pdf; - for CSV on stdout.",
                   to_stdout=True, kinds=(".csv", ".json", ".jsonl", ".parquet", ".svg", ".png", ".pdf"))
@click.option("--table", is_flag=True, help="Print as table 3-1 of the textbook: deg and m, five decimals.")
@click.option("--limit", "limits", multiple=True, metavar="QUANTITY VALUE",
              help='Say where a size is passed, such as "a E 3 g".')
@shared.force_option
@shared.speaking
def sweep(
    mechanism: str, ranges: tuple[str, ...], of: str, by: Road, output: Path | None, table: bool,
    limits: tuple[str, ...], force: bool, lang: Lang,
) -> None:  # fmt: skip
    """Move the mechanism through a turn, or as far as it gets: tables and motion diagrams.

    \b
    Example:
      graphkin sweep ex3-7 --table
      graphkin sweep p3-20 --driver 0:360:1 -o needle.csv
      graphkin sweep ex3-7 --of "theta 3, omega 3, alpha 3, s ram, v E, a E" -o diagram.svg
    """
    from graphkin import api
    from graphkin.say.finding import plain_lines
    from graphkin.say.sweeps import book_lines, left_out, remarks, sweep_lines, sweep_notes
    from graphkin.studies import finding, sweeps

    method = api.plan(shared.read(mechanism))
    for text in limits:
        finding.check_limit(method.mechanism, text)
    names = sweeps.asked(method.mechanism, sweeps.split(of))
    course = sweeps.course(method, ranges)
    # text held whole in memory has its limit; files that are written row by row, and diagrams, have none
    most = PRINTED if output is None else IN_ONE if output.suffix.lower() == ".json" else course.t.size
    if course.t.size > most:
        raise TooManyRows(Where("--driver"), course.t.size, most)
    with streams.waiting():
        sweeps.prove(course)
        whole = sweeps.sweep_over(course, names, by) if output is None else None
    if whole is not None:
        click.echo("\n".join(book_lines(whole) if table else sweep_lines(whole, lang)))
        notes = (*sweep_notes(whole, lang),)
    else:
        assert output is not None
        notes = (*left_out(course, _write_sweep(output, course, names, by, force, lang), lang),)
        notes = (*remarks(course, lang), *notes)
    for line in notes:
        click.echo(line, err=table or output is not None)
    for text in limits:
        for line in plain_lines(finding.limit(course, text, ranges, by), lang):
            click.echo(line, err=table or output is not None)


def _write_sweep(
    output: Path, course: Course, names: tuple[str, ...], by: Road, force: bool, lang: Lang
) -> np.ndarray:
    """Write it; the driver's values at positions that are left out."""
    import numpy as np

    from graphkin.outputs import tables
    from graphkin.studies.sweeps import in_parts

    suffix, undefined = output.suffix.lower(), [np.empty(0)]
    if str(output) == "-":
        parts = tables.shown_parts(in_parts(course, names, by), lambda part: undefined.append(part.undefined))
        for lines in tables.csv_lines(course, parts):
            click.echo(lines, nl=False)
        return np.concatenate(undefined)
    if suffix in tables.FORMATS:
        with click.progressbar(length=course.t.size, file=sys.stderr, hidden=course.t.size < LONG) as bar:

            def count(part: Sweep) -> None:
                undefined.append(part.undefined)
                bar.update(part.t.size + part.undefined.size)

            tables.write(output, course, names, by, force, count)
    else:
        from graphkin.outputs import diagram

        with streams.waiting():
            remark = diagram.write(output, course, names, lang, by, force)
        if remark is not None:
            click.echo(remark.message(lang), err=True)
    click.echo(str(output))
    return np.concatenate(undefined)


@click.command()
@shared.mechanism_argument
@click.argument("condition")
@shared.ranges_option
@click.option("--vary", "dimensions", multiple=True, metavar="NAME=FROM:TO:STEP",
              help="Again for each value of a dimension.")
@shared.by_option
@click.option("--json", "as_json", is_flag=True, help="One JSON object, SI units and radians.")
@shared.svg_option("Draw the positions, as SVG.")
@shared.paper_option
@shared.force_option
@shared.speaking
def find(
    mechanism: str, condition: str, ranges: tuple[str, ...], dimensions: tuple[str, ...], by: Road, as_json: bool,
    output: Path | None, paper: str | None, force: bool, lang: Lang,
) -> None:  # fmt: skip
    """Find all positions with a property, extremes, strokes, the slowest point of a line, the speed that is asked for.

    CONDITION is `QUANTITY = VALUE` (also < or >), `max QUANTITY`, `min QUANTITY`, `range QUANTITY`,
    `stroke QUANTITY`, `slowest BC`, or `QUANTITY = VALUE by omega 1`.

    \b
    Example:
      graphkin find p3-4a "a_k B3B2 = 0" -o zeros.svg
      graphkin find ex3-7 "stroke s ram"
      graphkin find p3-18 "v_x E = 0.5 by omega 1"
      graphkin find p3-21 "stroke s piston" --vary DH=55:125:5
    """
    from graphkin import api
    from graphkin.studies import finding

    machine = shared.read(mechanism)
    if dimensions:
        misused("usage.one", len(dimensions) > 1, option="--vary", what="NAME=FROM:TO:STEP")
        misused("usage.without", output, option="--vary", others="-o")
        with streams.waiting():
            table = finding.vary(machine, dimensions[0], condition, ranges, by, plan=api.plan)
        shared.print_answer(table, as_json, lang)
        sys.exit(3 if all(row.error for row in table.rows) else 0)
    with streams.waiting():
        solution = finding.find(api.plan(machine), condition, ranges, by)
    shared.print_answer(solution, as_json, lang)
    if output is not None:
        from graphkin.outputs.saving import NotebookSheet
        from graphkin.sheet.finding_sheet import drawn

        sheet, more = drawn(solution, lang, paper=paper)
        if sheet is not None:
            saved = NotebookSheet.of(sheet).save(output, force=force)
            click.echo(f"{saved}  (+{more})" if more else str(saved), err=True)
