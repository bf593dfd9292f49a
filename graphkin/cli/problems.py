"""`problems`: a problem for each student of a class."""

from __future__ import annotations

import sys
from contextlib import AbstractContextManager, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING

import click

from graphkin.cli import shared
from graphkin.cli.marking import pencil_option
from graphkin.errors import Lang

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from graphkin.handouts.problem_folder import SetOrder
    from graphkin.homework.problems import Variant

BOARD = "board"
PLATFORMS = ("moodle", "moodle-numerical", "qti", "csv", "xuexitong", "xuexitong-xlsx")


@click.command()
@click.argument("template", type=click.Path(path_type=Path))
@click.option("--students", required=True, metavar="ROSTER.csv|N", help="A list of ids, or how many students.")
@click.option("--seed", default="1", show_default=True, help="Another word gives other numbers.")
@click.option("-o", "--output", required=True, type=click.Path(path_type=Path, file_okay=False), metavar="DIR",
              help="Folder to write.")
@click.option("--format", "kinds", type=click.Choice((*PLATFORMS, BOARD)), multiple=True,
              help="Write the whole set for a platform, too, answers and mistakes in it; or, without these, a drawing "
              "board for each student; again for each.")
@click.option("--jobs", type=click.IntRange(0), default=0, metavar="N", help="Processes that draw and write.")
@pencil_option
@shared.force_option
@shared.speaking
def problems(
    template: Path, students: str, seed: str, output: Path, kinds: tuple[str, ...], jobs: int, pencil: str | None,
    force: bool, lang: Lang,
) -> None:  # fmt: skip
    """Write a problem for each student: one mechanism, each with numbers of their own.

    TEMPLATE is a mechanism file in which numbers may be ranges: AB = { from = 20, to = 30, step = 1 }. A student's
    numbers depend on the seed and the student's id alone, as long as no two students get the same problem.
    All get the assembly that the sketch means in the middle of the ranges.

    What may be handed out lies in DIR/students: each student's problem, what to hand in, a workbook to fill in. Keys
    and all else lie in DIR/teacher: `graphkin grade DIR`. The same command again goes on where it was broken off.

    \b
    Example:
      graphkin problems shaper.toml --students class.csv --seed 2027 -o homework
      graphkin problems shaper.toml --students 60 -o homework --format moodle --format xuexitong --lang zh
      graphkin problems shaper.toml --students class.csv -o homework --format board
    """
    from graphkin.handouts import problem_folder as folder
    from graphkin.homework import grading
    from graphkin.homework import problems as sets
    from graphkin.page.board_set import further_files
    from graphkin.say.problems import remarks
    from graphkin.submissions import worker_pool

    order = folder.SetOrder(
        output, sets.read_template(template), sets.roster(students), seed, lang, grading.pencils_of(pencil), force
    )
    workers: AbstractContextManager[Executor | None] = worker_pool(jobs) if jobs > 1 else nullcontext()
    with workers as executor:
        variants = _write(order, executor)
        click.echo(folder.told_of(output))
        for path in further_files(order, variants, kinds, executor):
            click.echo(str(path))
    alike = [variant.student.id for variant in variants if variant.shared]
    carried = [variant.student.id for variant in variants
               if sets.sketched_anew(order.template, variant.numbers, variant.mechanism)]  # fmt: skip
    for note in remarks(alike, carried, len(variants), lang):
        click.echo(note, err=True)


def _write(order: SetOrder, executor: Executor | None) -> list[Variant]:
    """The set's files; the variants in the order of the students."""
    from graphkin.handouts.problem_folder import write_problems
    from graphkin.say.catalogue import say

    variants: dict[str, Variant] = {}
    gone: list[Path] = []
    with click.progressbar(
        length=len(order.students), file=sys.stderr, show_pos=True, hidden=not sys.stderr.isatty()
    ) as bar:
        for one in write_problems(order, executor):
            if isinstance(one, Path):
                gone.append(one)
            else:
                variants[one.student.id] = one
                bar.update(1)
    click.echo(f"{order.folder}: {len(variants)}")
    if gone:
        files = say("common.and", order.lang).join(str(path.relative_to(order.folder)) for path in gone)
        click.echo(say("problems.removed", order.lang, files=files), err=True)
    return [variants[student.id] for student in order.students]
