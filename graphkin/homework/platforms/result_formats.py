"""The formats of results by name, and their files in a folder: beside, then renamed, nothing outside the folder."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from decimal import Decimal
from functools import partial
from itertools import chain
from pathlib import Path

from graphkin.base.value import frozen
from graphkin.errors import CannotWrite, Lang
from graphkin.homework.platforms import class_report as reports
from graphkin.homework.platforms import class_table
from graphkin.homework.platforms import learning_platforms as platform_files
from graphkin.homework.platforms.class_table import Overrides, read_overrides, with_copies
from graphkin.homework.platforms.feedback import Feedback, Reveal
from graphkin.homework.platforms.learning_platforms import canvas, moodle
from graphkin.homework.platforms.markup import ZIP_MARKS, clean, write_file
from graphkin.homework.platforms.pages import KINDS, PAGE, html
from graphkin.homework.platforms.polygon_pictures import PolygonPictures
from graphkin.homework.platforms.result import Result, ResultPicture
from graphkin.homework.platforms.tables import BOM, Cell, line, printed, workbook_files
from graphkin.marking.diagnosis import Trace, habits
from graphkin.say.catalogue import LANGUAGES, in_both, say
from graphkin.say.text_table import unbraced
from graphkin.submissions import pictures_of, safe_name

CLASS_TABLE = "class.csv"  # in this table of a results folder teachers write their overrides
_JSON = (b'"graphkin"',)
_TABLE = tuple(
    title.encode(code) for title in in_both("platforms.column override").values() for code in ("utf-8", "gbk")
)
_BOOK = tuple(
    ",".join(say(f"platforms.column {key}", lang) for key in ("student", "name")).encode() for lang in LANGUAGES
)
_REPORT = tuple(title.encode() for title in in_both("class_report.title").values())


@frozen
class WrittenResults:
    """The files that were written, and what could not be, in words."""

    paths: tuple[Path, ...]
    left_out: tuple[str, ...] = ()


Pictures = Callable[[Result, Lang, Reveal], Sequence[ResultPicture]]


@frozen
class Order:
    """Results to be written into a folder.

    results   gone through as often as a format needs it
    pictures  makes those of a student's page of feedback
    several   the mistakes that the results of each student speak for, in all problems of which this is one
    names     of the students of the class, by id
    """

    folder: Path
    results: Sequence[Result]
    lang: Lang
    reveal: Reveal
    assignment: str
    pictures: Pictures
    force: bool
    overrides: Overrides
    most: Decimal
    several: Sequence[Mapping[str, Trace]] = ()
    names: Mapping[str, str] = field(default_factory=dict)

    def __iter__(self) -> Iterator[Result]:
        """The results, with the teacher's points and habits; what was not marked, or not read as a
        whole, is of as many as the others."""
        for result in self.results:
            own = [traces[result.student] for traces in self.several if result.lines and result.student in traces]
            whole = bool(result.lines) and not any(line.written for line in result.lines)
            most, override = result.most if whole else self.most, self.overrides.of(result.student, result.file)
            result = replace(result, most=most, habits=habits(own))
            yield result if override is None else replace(result, override=override.points, comment=override.comment)

    def page(self, result: Result) -> Feedback:
        """A student's feedback, with pictures."""
        lang, shows = self.lang, self.pictures
        problem = shows.problem(result, lang, self.reveal) if isinstance(shows, PolygonPictures) else None
        return Feedback(result, lang, self.reveal, shows(result, lang, self.reveal), self.names, problem)


def write_results(
    folder: Path, results: Sequence[Result], kind: str, lang: Lang = "en", reveal: Reveal = "mistake", *,
    assignment: str = "graphkin", pictures: Pictures = lambda result, lang, reveal: (), force: bool = False,
    several: Sequence[Mapping[str, Trace]] = (), merged: Sequence[Path] = (), names: Mapping[str, str] | None = None,
) -> WrittenResults:  # fmt: skip
    """Results into a folder, which is made where it is not there.

    pictures  makes those of a student's page (`PolygonPictures`); none where left out
    several   of all problems of which this is one: the `Result.trace` of each student
    merged    folders of other graders, whose overrides count, too
    names     of all students of the class by id, where there is a list of them (`Roster.called`)

    Overrides in the folder's class table count in every format. Raises NotAnOverride, Unreadable, FileInTheWay,
    CannotWrite, and what going through the results raises.
    """
    overrides = prepared(folder)
    for other in merged:
        overrides = overrides.joined(read_overrides(other / CLASS_TABLE).kept)
    overrides.among(results)
    most = max((result.most for result in results), default=Decimal(0))
    results, names = with_copies(results, lang), names or {}
    order = Order(folder, results, lang, reveal, assignment, pictures, force, overrides, most, several, names)
    return RESULTS[kind](order)


def prepared(folder: Path) -> Overrides:
    """A folder of results, made where there is none, and the overrides in it. Raises CannotWrite, Unreadable,
    NotAnOverride."""
    return read_overrides(_made(folder) / CLASS_TABLE)


def _made(folder: Path) -> Path:
    """A folder that is there. Raises CannotWrite."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise CannotWrite.by(folder, error) from None
    return folder


def _table(order: Order) -> Iterator[Sequence[Cell]]:
    """The class table; those who are not here come last, known when all others are through."""
    names, there = class_table.quantities(order.results), {result.student for result in order.results}
    several = len(order.several) > 1
    rows = class_table.rows(order, names, order.lang, several, order.names)
    return chain(rows, class_table.absent(order.overrides, names, order.names, there, order.lang))


def write_gradebook(
    folder: Path, problems: Mapping[str, Sequence[Result]], kind: str, lang: Lang = "en",
    names: Mapping[str, str] | None = None, force: bool = False,
) -> Path:  # fmt: skip
    """The points of a class in several problems, with the overrides in their folders, as `csv` or `xlsx`.

    Raises as `write_results`."""
    marked = {}
    for name, results in problems.items():
        overrides, most = prepared(folder / name), max((result.most for result in results), default=Decimal(0))
        same = with_copies(results, lang)
        marked[name] = [*Order(folder, same, lang, "hint", "", lambda *asked: (), force, overrides, most)]
    rows = class_table.gradebook(marked, names or {}, lang)
    if kind == "csv":
        return write_file(folder / "class.csv", "".join([BOM, *map(line, rows)]), force, _BOOK)
    sheets = _sheets(rows, marked, names or {}, lang)
    return write_file(folder / "class.xlsx", workbook_files(sheets), force, ZIP_MARKS)


def _sheets(
    rows: Iterable[Sequence[Cell]], problems: Mapping[str, Sequence[Result]], names: Mapping[str, str], lang: Lang
) -> Mapping[str, Iterable[Sequence[Cell]]]:
    """The class, and what is to be looked at."""
    look = class_table.look_rows(problems, names, lang)
    return {say("platforms.gradebook", lang): rows, say("class_report.part remarks", lang): look}


def _written_table(kind: str, order: Order) -> WrittenResults:
    if kind == "csv":
        path = write_file(order.folder / CLASS_TABLE, "".join([BOM, *map(line, _table(order))]), order.force, _TABLE)
    else:
        sheets = _sheets(_table(order), {"": [*order]}, order.names, order.lang)
        path = write_file(order.folder / "class.xlsx", workbook_files(sheets), order.force, ZIP_MARKS)
    names = (each.student or each.file for each in order.overrides.rest())
    clashes = (
        say(
            "platforms.overrides differ", order.lang, student=first.student or first.file, table=first.table,
            points=printed(first.points or Decimal(0)), other=printed(other.points or Decimal(0)), beside=other.table,
        )
        for first, other in order.overrides.clashes
    )  # fmt: skip
    kept = (say("platforms.override kept", order.lang, student=name) for name in names)
    return WrittenResults((path,), (*clashes, *kept))


def _by_names(platform: str, order: Order) -> WrittenResults:
    """A table of grades, and a zip of feedback in the kind of each file under the names of the platform's download."""
    of = {"Moodle": moodle, "Canvas": canvas}[platform]
    named = [(name, result) for result in order if (name := of(result.file)) is not None]
    if platform == "Moodle":
        rows, mark = platform_files.moodle_grades(named, order.lang, order.reveal), b"Identifier,Full name,"
    else:
        rows, mark = platform_files.canvas_grades(named, order.assignment, order.most), b"Points Possible,"
    grades, feedback = (order.folder / f"{platform.lower()}-{end}" for end in ("grades.csv", "feedback.zip"))
    write_file(grades, "".join(rows), order.force, [mark])
    ends = {name.name: Path(name.name).suffix for name, _ in named}
    writers = ((name.name, KINDS.get(ends[name.name].lower()), result) for name, result in named)
    pages = ((name, write(order.page(result))) for name, write, result in writers if write is not None)
    write_file(feedback, pages, order.force, ZIP_MARKS)
    left_out = []
    if files := [result.file for result in order.results if of(result.file) is None]:
        example = {"count": len(files), "file": files[0], "platform": platform}
        left_out.append(say("platforms.no platform name", order.lang, **example))
    unwritten = Counter(ends[name.name] for name, _ in named if ends[name.name].lower() not in KINDS)
    left_out += [say("platforms.no feedback in kind", order.lang, count=count, kind=suffix or "?")
                 for suffix, count in unwritten.items()]  # fmt: skip
    return WrittenResults((grades, feedback), tuple(left_out))


def _with_file_names(order: Order) -> Iterator[tuple[str, Result]]:
    """Every result with a name of its own for its file."""
    taken: set[str] = set()
    for result in order:
        name = safe_name(result.student)
        name = safe_name(f"{result.student}\0{result.file}") if name in taken else name
        taken.add(name)
        yield name, result


def _pages(order: Order) -> WrittenResults:
    """A page of feedback each."""
    folder = _made(order.folder / "pages")
    for name, result in _with_file_names(order):
        write_file(folder / f"{name}.html", html(order.page(result)), order.force, [PAGE])
    return WrittenResults((folder,))


def _each(platform: str, order: Order) -> WrittenResults:
    """`results.json` in the folder where there is one submission; else in a folder each, within the platform's."""
    alone = len(order.results) == 1
    for name, result in _with_file_names(order):
        folder = order.folder if alone else _made(order.folder / platform / name)
        if platform == "gradescope":
            data = platform_files.gradescope_json(result, order.lang, order.reveal)
        else:
            data = platform_files.prairielearn_json(result, order.lang, order.reveal, order.page(result).pictures)
        write_file(folder / "results.json", data, order.force, [f'"platform": "{platform}"'.encode()])
    if alone:
        return WrittenResults((order.folder / "results.json",))
    return WrittenResults((order.folder / platform,) if order.results else ())


def _report(order: Order) -> WrittenResults:
    """The class in words, as data and as a figure."""
    report = reports.class_report(order)
    lines = (say("class_report.title", order.lang), *map(clean, reports.report_text(report, order.lang, order.names)))
    text = "".join(f"{unbraced(line)}\n" for line in lines)
    record = json.dumps(reports.report_record(report), ensure_ascii=True)
    words = write_file(order.folder / "class-report.txt", text, order.force, _REPORT)
    data = write_file(order.folder / "class-report.json", record + "\n", order.force, _JSON)
    figure = order.folder / "class-report.svg"
    remark = reports.write_class_figure(figure, report, order.lang, order.force)
    drawn, shows = figure.read_text("utf-8"), order.pictures
    figures = (shows.problem(one, order.lang) for one in order.results) if isinstance(shows, PolygonPictures) else ()
    title = next((problem.label for problem in figures if problem is not None), "")
    drawn, seen = drawn[drawn.index("<svg") :], pictures_of({file for _, file, _ in report.remarks})
    whole = reports.report_page(report, order.lang, order.names, drawn, title, seen)
    page = write_file(order.folder / "class-report.html", whole, order.force, [PAGE])
    return WrittenResults((words, data, figure, page), () if remark is None else (remark.message(order.lang),))


RESULTS: Mapping[str, Callable[[Order], WrittenResults]] = {
    "csv": partial(_written_table, "csv"), "xlsx": partial(_written_table, "xlsx"),
    "moodle": partial(_by_names, "Moodle"), "canvas": partial(_by_names, "Canvas"),
    "gradescope": partial(_each, "gradescope"), "prairielearn": partial(_each, "prairielearn"),
    "pages": _pages, "report": _report,
}  # fmt: skip
"""By name, as `graphkin grade --format` has them."""
