"""`grade` and `tolerance`: handed-in work against a key, and what paper allows."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click

from graphkin.base.plain import Plain
from graphkin.base.value import frozen
from graphkin.cli import shared
from graphkin.cli.shared import DriverOptions
from graphkin.errors import BadPencil, Lang, Where

if TYPE_CHECKING:
    from graphkin.homework.grading import MarkingOptions, Pencils, Problem, SetMarker
    from graphkin.homework.platforms import Reveal
    from graphkin.marking.records import Graded

_Record = TypeVar("_Record")

RESULT_FORMATS = ("json", "csv", "xlsx", "moodle", "gradescope", "prairielearn", "canvas", "pages", "report")
MARKS = "marks.json"  # in a folder of results graphkin's own records, from which everything else there is made

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
    from graphkin.homework import grading
    from graphkin.marking.marker import Marker
    from graphkin.marking.power import power as power_of
    from graphkin.marking.tolerances import tolerances
    from graphkin.outputs import study_json as data
    from graphkin.say.tolerances import power_lines, tolerance_lines

    method = shared.position(shared.read(mechanism), at).moved_method
    marker = Marker(grading.key_drawn(method, pencils_of(pencil, sigmas, relative)))
    scatter = tolerances(marker.key, marker.method)
    texts = [entry.text for entry in marker.key.entries if entry.points] if asked else None
    tried = power_of(marker, trials, texts) if power else None
    if as_json:
        more = {} if tried is None else {"power": data.power_data(tried)}
        click.echo(shared.json_line({**data.tolerance_data(scatter), **more}))
        return
    click.echo("\n".join(tolerance_lines(scatter, lang)))
    if tried is not None:
        click.echo("\n" + "\n".join(power_lines(tried, lang)))


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
    jobs: int
    force: bool
    lang: Lang

    def mark(self, key: str, submissions: Sequence[str]) -> None:
        """Every problem of the key by itself; then the folders of results, for all of them."""
        from graphkin.homework import grading
        from graphkin.submissions import Limits

        if self.kinds and self.output is None:
            raise click.UsageError("--format needs -o: the folder to write into")
        if not self.kinds and self.output is not None and self.output.suffix.lower() != ".json":
            raise click.UsageError(f"{self.output}: the file to write must end in .json; or say --format, for a folder")
        problems = grading.problems_of(key, submissions)
        if self.output is not None and not self.kinds and problems[0].name:
            raise click.UsageError("several problems are written into a folder: say --format, such as --format json")
        pencils = pencils_of(self.pencil, self.sigmas, self.relative)
        names = tuple(name.strip() for name in self.letters.split(",") if name.strip())
        settings = grading.MarkingOptions(Limits(turned=self.turned, names=names), self.jobs, words=self.lang)
        judges = [grading.judge_from(problem.key, pencils, self.roster) for problem in problems]
        for problem, judge in zip(problems, judges, strict=True):
            if self.output is None:
                self._print(problem.name, grading.grade(judge, problem.paths, settings.limits, workers=self.jobs))
            else:
                path = self.output / problem.name / MARKS if self.kinds else self.output
                self._write_records(path, judge, problem, settings)
        if self.output is not None and self.kinds:
            self._write_folders([self.output / problem.name / MARKS for problem in problems], judges, problems)

    def _print(self, problem: str, records: Iterable[Graded]) -> None:
        """Each as it comes."""
        from graphkin.outputs import marks_json
        from graphkin.say.marks import grade_lines

        if problem and not self.as_json:
            click.echo(f"{problem}:")
        for graded in _counted(records, True):
            if self.as_json:
                click.echo(_line(problem, marks_json.line(graded, self.lang)))
            else:
                click.echo("\n".join(grade_lines(graded, self.lang)))

    def _write_records(self, path: Path, judge: SetMarker, problem: Problem, settings: MarkingOptions) -> None:
        """All records in one file. What a marking that was broken off has left is gone on with, and left again."""
        from graphkin.homework import grading, platforms
        from graphkin.outputs import marks_json
        from graphkin.say.marks import interrupted, kept_lines

        if self.kinds:
            platforms.prepared(path.parent)
        record = partial(marks_json.record, lang=self.lang)
        try:
            with grading.Journal(path, self.force) as journal:
                records = grading.resumed(judge, problem.paths, journal, settings, record)
                marks_json.write(path, self._printed(problem.name, _counted(records, self.as_json)), self.force)
        except KeyboardInterrupt:
            click.echo(interrupted(path, self.lang), err=True)
            raise
        click.echo(str(path), err=self.as_json)
        for line in kept_lines(journal.kept, journal.replaced, self.lang):
            click.echo(line, err=True)

    def _printed(self, problem: str, records: Iterable[Mapping[str, Any]]) -> Iterator[Mapping[str, Any]]:
        """Each record, once its line is printed where lines are wanted."""
        from graphkin.outputs import marks_json

        for record in records:
            if self.as_json:
                click.echo(_line(problem, marks_json.line_of(record)))
            yield record

    def _write_folders(
        self, files: Sequence[Path], judges: Sequence[SetMarker], problems: Sequence[Problem]
    ) -> None:
        """Everything else, made of the records; several problems of a student are seen together. What teachers wrote
        beside files of marks that are marked anew goes with these."""
        from graphkin.homework import platforms

        book, called = {file.parent.name: platforms.read_results(file) for file in files}, dict[str, str]()
        several = [{one.student: one.trace for one in results if one.status == "marked"}
                   for results in book.values()] if len(files) > 1 else []  # fmt: skip
        for file, judge, problem in zip(files, judges, problems, strict=True):
            results, pictures = book[file.parent.name], platforms.PolygonPictures(judge)
            names = {} if judge.roster is None else judge.roster.called
            called |= {student: name for student, name in names.items() if name or student not in called}
            merged = [path.parent for path in map(Path, problem.paths) if path.name == MARKS and path != file]
            for kind in dict.fromkeys((*self.kinds, *(["csv"] if merged else []))):
                if kind == "json":
                    continue
                done = platforms.write_results(
                    file.parent, results, kind, self.lang, self.reveal, assignment=self.assignment,
                    pictures=pictures, force=self.force, several=several, merged=merged, names=names,
                )  # fmt: skip
                click.echo("\n".join(map(str, done.paths)), err=self.as_json)
                for line in done.left_out:
                    click.echo(line, err=True)
        for kind in dict.fromkeys(kind for kind in self.kinds if kind in ("csv", "xlsx") and several):
            assert self.output is not None
            path = platforms.write_gradebook(self.output, book, kind, self.lang, called, self.force)
            click.echo(str(path), err=self.as_json)


def _line(problem: str, data: Mapping[str, Plain]) -> str:
    return shared.json_line({**data, "problem": problem} if problem else data)


def _counted(records: Iterable[_Record], printed: bool) -> Iterator[_Record]:
    """The records, counted for one who waits at a terminal on which nothing else is being printed."""
    quiet = not sys.stderr.isatty() or (printed and sys.stdout.isatty())
    with click.progressbar(records, file=sys.stderr, show_pos=True, hidden=quiet) as bar:
        yield from bar


def pencils_of(pencil: str | None, sigmas: float | None = None, relative: float | None = None) -> Pencils:
    """The errors of a pencil and what is allowed, by the options that were said. Raises BadPencil."""
    from graphkin.homework.grading import Pencils

    said = {name: value for name, value in (("sigmas", sigmas), ("relative", relative)) if value is not None}
    if pencil is not None:
        try:
            length, angle = (float(part) for part in pencil.split(","))
        except ValueError:
            raise BadPencil(Where("--pencil"), pencil) from None
        if not (0 <= length <= 10 and 0 <= angle <= 30):
            raise BadPencil(Where("--pencil"), pencil)
        said |= {"length_mm": length, "angle_deg": angle}
    return Pencils(**said, said=tuple(said))
