"""`grade` and `tolerance`: handed-in work against a key, and what paper allows."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from graphkin.base.plain import Plain
from graphkin.base.value import frozen
from graphkin.cli import shared, streams
from graphkin.cli.shared import DriverOptions
from graphkin.cli.spoken import misused
from graphkin.errors import Lang, NoneMarked

if TYPE_CHECKING:
    from graphkin.homework.grading import Photographs, SetMarker
    from graphkin.homework.platforms import Reveal
    from graphkin.marking.records import Graded


RESULT_FORMATS = ("json", "csv", "xlsx", "moodle", "gradescope", "prairielearn", "canvas", "pages", "report")

pencil_option = click.option("--pencil", metavar="MM,DEG", show_default="0.25,0.25",
    help="What a pencil errs by: a length on paper, and a direction (standard deviations).")  # fmt: skip
sigmas_option = click.option("--sigmas", type=click.FloatRange(0.1, 100), show_default="3",
    help="How many standard deviations are right.")  # fmt: skip
relative_option = click.option("--relative", type=click.FloatRange(0, 1), metavar="PART",
    help="Allow this part of the right value instead, such as 0.02.")  # fmt: skip


@click.command()
@click.argument("key", metavar="KEY")
@click.argument("submissions", nargs=-1, required=True, metavar="SUBMISSION...")
@click.option("--json", "as_json", is_flag=True, help="One JSON line a student's submission; SI units and radians.")
@click.option("-o", "--output", type=click.Path(path_type=Path),
              help="Write all records into a .json file; with --format, a folder of results.")
@click.option("--format", "kinds", type=click.Choice(RESULT_FORMATS), multiple=True,
              help="What to write into the folder beside the records; again for each further one.")
@click.option("--reveal", type=click.Choice(["hint", "mistake", "answer"]), default="mistake", show_default=True,
              help="With --format: how much students are told; answer once nothing more may be handed in.")
@click.option("--assignment", default="graphkin", metavar="NAME",
              help="With --format canvas: the assignment's column in the gradebook.")
@pencil_option
@sigmas_option
@relative_option
@click.option("--turned", is_flag=True, help="In a drawing a polygon may stand turned on the page.")
@click.option("--letters", default="", metavar="P,B2,B3",
              help="The points of drawings without letters, in the file's order.")
@click.option("--roster", type=click.Path(path_type=Path), metavar="FILE",
              help="A class list, CSV or XLSX: ids, names, e-mails, numbers of a platform; Moodle's worksheet.")
@click.option("--sheets", type=click.Path(path_type=Path), metavar="FILE",
              help="For photographs: the sheets.json of the paper, if it is not beside KEY or beside the pictures.")
@click.option("--confirm", type=click.Path(path_type=Path), metavar="FILE.html",
              help="For photographs: a page to look at them with what was found, and to correct that.")
@click.option("--jobs", type=click.IntRange(0), default=0, metavar="N", help="Processes that read and mark.")
@shared.force_option
@shared.speaking
def grade(key: str, submissions: tuple[str, ...], **options: Any) -> None:
    """Mark what students hand in: verdicts, marks, and the mistake that a wrong number is consistent with.

    KEY is a key.json, a folder of problems with a key each, a mechanism file or a library mechanism. SUBMISSION is a
    file of answers or a drawing, a class table, a zip of a whole class, a folder, or a file of marks, whose numbers are
    marked anew. A key.json keeps the pencil and the tolerances that it was made with, but for those said here.

    A problem that asks for further positions (`also`) is marked at each: "omega 3 #2" is omega 3 at the second, and so
    is "omega 3 @ 120" where the driver stands at 120; "drawing #2.svg" is its drawing.

    With several problems KEY is a folder of them (NAME.key.json, NAME.toml, or a folder NAME), and what was handed in
    for each is called NAME.csv, NAME.zip, or a folder NAME. Reports and feedback then tell, too, which mistakes show in
    several problems of a student.

    Photographs and scans of sheets that `handout --stage blank --scan` printed are measured (graphkin[photo]): JPEG,
    PNG, PDF of any number of pages, in any order. The number on a sheet says whose it is. What is unsure counts
    where it is exact enough, and is first on the page of --confirm; the file that this saves is marked again in place
    of the pictures.

    Whose work it is says the folder of a platform, then the file's name, then a line in it; where these contradict each
    other, or the class list, nobody is marked. With --roster names count as well as ids.

    With -o nothing is marked twice: the same command again marks what is new or changed, and goes on where it was
    broken off; late work is added to what is there. Several files of marks are merged, with what teachers wrote.

    \b
    Example:
      graphkin grade ex3-1 s1.toml
      graphkin grade key.json class.zip --json
      graphkin grade key.json class.zip -o results --format csv --format moodle --reveal hint
      graphkin grade keys/ handed-in/ -o results --format report --jobs 4
      graphkin grade homework scan.pdf photos/ --confirm look.html
      graphkin grade homework look.json -o results --format csv
    """
    _Grading(**options).mark(key, submissions)


@click.command()
@shared.mechanism_argument
@pencil_option
@sigmas_option
@relative_option
@click.option("--power", is_flag=True, help="Draw up students who make each mistake, and tell how many are named.")
@click.option("--asked", is_flag=True, help="With --power: they hand in what is asked, and nothing on the way.")
@click.option("--trials", type=click.IntRange(1, 100_000), default=200, show_default=True, help="Students a mistake.")
@click.option("--json", "as_json", is_flag=True, help="One JSON object; SI units and radians.")
@shared.driver_options
@shared.speaking
def tolerance(
    mechanism: str, pencil: str | None, sigmas: float | None, relative: float | None, power: bool, asked: bool,
    trials: int, as_json: bool, at: DriverOptions, lang: Lang,
) -> None:  # fmt: skip
    """Print what accuracy paper allows: the construction is drawn many times with a pencil that errs.

    For each quantity its scatter, its tolerance and the step that costs it most; * marks what is asked. With --power
    also which mistakes can be told apart by the numbers that are handed in.

    \b
    Example:
      graphkin tolerance ex3-1 --angle 120
      graphkin tolerance ex3-1 --pencil 0.1,0.1 --power --lang zh
    """
    from graphkin.api.answers import data_of, lines_of
    from graphkin.homework import grading

    method = shared.placed(mechanism, at)
    with streams.waiting():
        scatter = grading.tolerance(method, pencil, sigmas, relative, marks=power)
        answers = {"power": grading.power(method, asked=asked, trials=trials, key=scatter.key)} if power else {}
    if as_json:
        click.echo(shared.json_line({**data_of(scatter), **{name: data_of(one) for name, one in answers.items()}}))
    else:
        more = [line for one in answers.values() for line in ("", *lines_of(one, lang))]
        click.echo("\n".join([*lines_of(scatter, lang), *more]))


@frozen
class _Grading:
    """The options of `grade`, and what is marked, printed and written by them."""

    as_json: bool
    output: Path | None
    kinds: tuple[str, ...]
    reveal: Reveal
    assignment: str
    pencil: str | None
    sigmas: float | None
    relative: float | None
    turned: bool
    letters: str
    roster: Path | None
    sheets: Path | None
    confirm: Path | None
    jobs: int
    force: bool
    lang: Lang

    def mark(self, key: str, submissions: Sequence[str]) -> None:
        """Every problem of the key by itself; then the folders of results, for all of them."""
        from graphkin.homework import grading
        from graphkin.homework.result_files import ResultFiles
        from graphkin.say.tolerances import untold_lines

        file = None if self.kinds else self.output
        misused("usage.needs", self.kinds and self.output is None, option="--format", other="-o DIR")
        misused("usage.suffix", file and file.suffix.lower() != ".json", output=file, kinds=".json")
        problems = grading.problems_of(key, submissions)
        misused("usage.needs", file and problems[0].name, option="-o", other="--format")
        pencils = grading.pencils_of(self.pencil, self.sigmas, self.relative)
        limits = grading.limits_of(self.turned, self.letters)
        misused("usage.one", self.confirm and problems[0].name, option="--confirm", what="KEY")
        usual = grading.MarkingOptions(limits, self.jobs, words=self.lang)
        judges = [grading.judge_from(problem.key, pencils, self.roster) for problem in problems]
        for one in (judge for judge in judges if isinstance(judge, grading.OneKey)):
            click.echo("".join(f"{line}\n" for line in untold_lines(one.untold(), self.lang)), nl=False, err=True)
        options = []
        for problem, judge in zip(problems, judges, strict=True):
            crop = self.confirm is not None
            options.append(grading.with_photographs(usual, problem.key, judge, problem.paths, self.sheets, crop))
        self._write_page(options[0].photographs, judges[0])
        marked: list[bool] = []
        if self.output is None:
            for problem, judge, own in zip(problems, judges, options, strict=True):
                records = grading.grade(judge, problem.paths, limits, workers=self.jobs, seen=own.photographs)
                marked += self._print(problem.name, records)
        else:
            watch = partial(self._printed, marked)
            files = ResultFiles(self.output, self.kinds, self.reveal, self.assignment, self.lang, self.force, watch)
            for said in files.written(problems, judges, options):
                click.echo(str(said), err=self.as_json or isinstance(said, str))
        if not any(marked):
            raise NoneMarked(len(marked))

    def _write_page(self, seen: Photographs | None, judge: SetMarker) -> None:
        """The page on which photographs are looked at."""
        from graphkin.page.confirm import write_page

        if seen is None or self.confirm is None:
            return
        reasons = [one.reason for one in seen.failed if one.reason is not None]
        called = {} if judge.roster is None else judge.roster.called
        write_page(self.confirm, seen.readings, reasons, called, self.lang, self.force)
        click.echo(str(self.confirm), err=True)

    def _print(self, problem: str, records: Iterable[Graded]) -> Iterator[bool]:
        """Each as it comes, and whether it was marked."""
        from graphkin.outputs import marks_json
        from graphkin.say.marks import grade_lines

        if problem and not self.as_json:
            click.echo(f"{problem}:")
        for graded in streams.counted(records, True):
            if self.as_json:
                click.echo(_line(problem, marks_json.line(graded, self.lang)))
            else:
                click.echo("\n".join(grade_lines(graded, self.lang)))
            yield graded.marked is not None

    def _printed(self, marked: list[bool], problem: str, lines: Iterable[str]) -> Iterator[str]:
        """Each record's line, printed as data where that is wanted; and whether it was marked."""
        from graphkin.outputs import marks_json

        for line in streams.counted(lines, self.as_json):
            marked.append(marks_json.is_marked(line))
            if self.as_json and (record := marks_json.record_of(line)) is not None:
                click.echo(_line(problem, marks_json.line_of(record)))
            yield line


def _line(problem: str, data: Mapping[str, Plain]) -> str:
    return shared.json_line({**data, "problem": problem} if problem else data)


