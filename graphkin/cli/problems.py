"""`problems`: a problem for each student of a class."""

from __future__ import annotations

from pathlib import Path

import click

from graphkin.cli import shared
from graphkin.cli.marking import pencil_option, pencils_of
from graphkin.errors import Lang

PLATFORMS = ("moodle", "moodle-numerical", "qti", "csv", "xuexitong")


@click.command()
@click.argument("template", type=click.Path(path_type=Path))
@click.option("--students", required=True, metavar="ROSTER.csv|N", help="A list of ids, or how many students.")
@click.option("--seed", default="1", show_default=True, help="Another word gives other numbers.")
@click.option("-o", "--output", required=True, type=click.Path(path_type=Path, file_okay=False), metavar="DIR",
              help="Folder to write.")
@click.option("--format", "kinds", type=click.Choice(PLATFORMS), multiple=True,
              help="Write the whole set for a platform, too, answers and mistakes in it; again for each.")
@pencil_option
@shared.force_option
@shared.speaking
def problems(
    template: Path, students: str, seed: str, output: Path, kinds: tuple[str, ...], pencil: str | None,
    force: bool, lang: Lang,
) -> None:  # fmt: skip
    """Write a problem for each student: one mechanism, each with numbers of their own.

    TEMPLATE is a mechanism file in which numbers may be ranges: AB = { from = 20, to = 30, step = 1 }. A student's
    numbers hang on the seed and the student's id alone, as long as no two students get the same problem.

    \b
    Example:
      graphkin problems shaper.toml --students class.csv --seed 2027 -o homework
      graphkin problems shaper.toml --students 60 -o homework --format moodle --format xuexitong --lang zh
    """
    from graphkin.homework import platforms
    from graphkin.homework import problems as sets
    from graphkin.say.problems import remark

    read = sets.read_template(template)
    pencils = pencils_of(pencil)
    variants = sets.variants(read, sets.roster(students), seed, pencils)
    count = sum(1 for _ in platforms.write_problems(output, read, variants, seed, lang, force, pencils=pencils))
    click.echo(f"{output}: {count}")
    click.echo(platforms.told_of(output))
    if kinds:
        from graphkin.homework import grading

        whole = platforms.problem_set(read, variants, grading.judge_from(str(output)))
        for kind in dict.fromkeys(kinds):
            path = platforms.file_of(output, kind)
            platforms.write_set(path, whole, kind, lang, force)
            click.echo(str(path))
    if shared_numbers := [variant.student.id for variant in variants if variant.shared]:
        click.echo(remark(shared_numbers, lang), err=True)
