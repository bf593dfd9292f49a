"""The class as a table: a row a submission, in the order of the results, then those who handed in nothing, as CSV and
XLSX write it; the gradebook of several problems; what the teacher should look at; and overrides.

An override is the teacher's own points: a column of the table that survives when the table is written anew.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from decimal import ROUND_HALF_UP, Decimal, InvalidOperation
from pathlib import Path

from graphkin.base.value import frozen
from graphkin.errors import BrokenSubmission, Lang, NotAnOverride, SameNumbers, Unreadable, Where
from graphkin.homework.platforms.feedback import as_on_sheets, habit, suspected, without_place
from graphkin.homework.platforms.markup import one_line
from graphkin.homework.platforms.question import in_letters
from graphkin.homework.platforms.result import Result, most_of, points_of
from graphkin.homework.platforms.tables import HUNDREDTH, Cell, read_table
from graphkin.marking.records import Judged
from graphkin.say.boards import line_name
from graphkin.say.catalogue import in_both, say
from graphkin.say.marks import how_sure, verdict
from graphkin.say.text_table import unbraced

_FRONT = ("student", "name", "file", "status", "earned", "most", "override", "total", "score percent",
          "comment")  # fmt: skip
_BACK = ("remarks", "diagnosis")
_SURE = 0.9  # a diagnosis that gives points and is less probable is to be looked at


def quantities(results: Iterable[Result]) -> tuple[str, ...]:
    """All that is asked anywhere, as it is met first, and what is wrong on the way."""
    met: dict[str, bool] = {}
    for line in (line for result in results for line in result.lines):
        met[line.text] = met.get(line.text, False) or bool(most_of(line)) or line.verdict in ("wrong", "not read")
    return tuple(name for name, shown in met.items() if shown)


def rows(
    results: Iterable[Result], names: tuple[str, ...], lang: Lang, several: bool = False, called: Called | None = None
) -> Iterator[list[Cell]]:
    """The table with its head; with a last column, where this is one of several problems, for what shows in them."""
    lettered = [unbraced(in_letters(line_name(name, lang), names)) for name in names]
    pairs = [text for name in lettered for text in (name, say("platforms.column part earned", lang, name=name))]
    front, back = ([say(f"platforms.column {key}", lang) for key in keys] for keys in (_FRONT, _BACK))
    yield [*front, *pairs, *back, *([say("platforms.column habits", lang)] if several else [])]
    for result in results:
        habits = (  # with the evidence of all problems together
            say("platforms.habit", lang, shown=h.shown, of=h.of, mistake=habit(h, lang), evidence=f"{h.weight:.1f}")
            for h in result.habits
        )
        marked = result.status == "marked"
        front_cells: list[Cell] = [
            result.student, (called or {}).get(result.student, ""), result.file,
            say(f"verdicts.status {result.status}", lang), result.earned if marked else None, result.most,
            result.override, result.total, _percent(result.score), result.comment,
        ]  # fmt: skip
        by_name: dict[str, tuple[Cell, Cell]] = {}
        for line in result.lines:  # of an answer that was not read what was written
            written = f' "{one_line(line.written)}"' if line.written else ""
            by_name[line.text] = verdict(line, lang) + written, None if written else points_of(line)
        middle = [cell for name in names for cell in by_name.get(name, ("", None))]
        diagnosis = unbraced(as_on_sheets(result, suspected(result.suspicions[0], lang))) if result.suspicions else ""
        look = (reason.rstrip(".。") for reason in look_at(result, lang))
        row = [*front_cells, *middle, say("common.semicolon", lang).join(look), diagnosis]
        yield [*row, *([say("common.semicolon", lang).join(habits)] if several else [])]


def _percent(score: Decimal | None) -> Decimal | None:
    return None if score is None else (score * 100).quantize(HUNDREDTH)


def look_at(result: Result, lang: Lang) -> Iterator[str]:
    """The reasons for which the teacher should look at a submission."""
    if result.status != "marked":
        yield without_place(result.reason, lang)
    for line in result.lines:
        if line.written:
            name = as_on_sheets(result, line.text)
            yield say("platforms.look unread", lang, name=name, written=one_line(line.written))
    yield from result.remarks
    for one in result.suspicions[:1]:
        if one.probability < _SURE and any(line.of_mistake and points_of(line) for line in result.lines):
            mistake, sure = as_on_sheets(result, suspected(one, lang)), how_sure(one.probability, (), lang)
            yield say("platforms.look unsure", lang, mistake=mistake, sure=sure)


Called = Mapping[str, str]
"""The students of a class by id, with their names as far as a list has them."""
Marked = Mapping[str, Sequence[Result]]
"""The results of several problems by their names."""


def look_rows(problems: Marked, called: Called, lang: Lang) -> Iterator[list[Cell]]:
    """All that is to be looked at, a reason a row."""
    yield [say(f"platforms.column {key}", lang) for key in ("student", "name", "in problem", "file", "reason")]
    for problem, results in problems.items():
        for result in results:
            for reason in look_at(result, lang):
                yield [result.student, called.get(result.student, ""), problem, result.file, reason]


def gradebook(problems: Marked, called: Called, lang: Lang) -> Iterator[list[Cell]]:
    """The points of each student in several problems, and the total; with those who handed in nothing."""
    keys = ("total", "most", "score percent", "remarks")
    front, back = [say(f"platforms.column {key}", lang) for key in ("student", "name")], keys
    yield [*front, *problems, *(say(f"platforms.column {key}", lang) for key in back)]
    whole = sum((max((one.most for one in results), default=Decimal(0)) for results in problems.values()), Decimal(0))
    own: dict[str, dict[str, list[Result]]] = {student: {} for student in called}
    for name, results in problems.items():
        for result in results:
            own.setdefault(result.student, {}).setdefault(name, []).append(result)
    for student, handed_in in own.items():
        cells: list[Cell] = []
        for name in problems:
            points = [one.total for one in handed_in.get(name, ()) if one.total is not None]
            status = "not marked" if name in handed_in else "absent"
            cells.append(points[0] if points else say(f"verdicts.status {status}", lang))
        some = [cell for cell in cells if isinstance(cell, Decimal)]
        waits = say("verdicts.status not marked", lang) in cells  # that is no zero
        total = None if waits and not some else sum(some, Decimal(0))
        reasons = (f"{name}{say('common.colon', lang)}{reason.rstrip('.。')}" for name, results in handed_in.items()
                   for result in results for reason in look_at(result, lang))  # fmt: skip
        score = _percent(total / whole) if whole and total is not None and not waits else None
        look = say("common.semicolon", lang).join(reasons)
        yield [student, called.get(student, ""), *cells, total, whole, score, look]


def absent(
    overrides: Overrides, names: tuple[str, ...], called: Called, there: Container[str], lang: Lang
) -> Iterator[list[Cell]]:
    """Those of the class who are not among the results, and overrides of these and of others; a row each."""
    blank: list[Cell] = [None] * (2 * len(names) + len(_BACK))
    status = say("verdicts.status absent", lang)
    rest = {each.student: each for each in overrides.rest()}
    for student, name in called.items():
        if student not in there and student not in rest:
            yield [student, name, "", status, None, None, None, None, None, "", *blank]
    for each in overrides.rest():
        front = (each.student, called.get(each.student, ""), each.file, "" if each.student in there else status)
        yield [*front, None, None, each.points, None, None, each.comment, *blank]


_LARGEST = Decimal(10**6)


@frozen
class Override:
    """The teacher's points of one submission, and words about it; `table` is where they stand."""

    student: str
    file: str
    points: Decimal | None
    comment: str = ""
    table: str = ""


class Overrides:
    """Overrides by student and file. Where a spreadsheet has spoilt an id, or the file is another by now, by the one of
    the two that is left; the file of many students, such as a class table, is nobody's.

    clashes   of students of whom two tables say different points: what counts, and what does not
    """

    def __init__(self, kept: Sequence[Override] = (), clashes: Sequence[tuple[Override, Override]] = ()) -> None:
        self.kept, self.clashes = tuple(kept), tuple(clashes)
        self._exact = {(each.student, each.file): each for each in kept}
        self._by_file = _unique((each.file, each) for each in kept)
        self._by_student = _unique((_bare(each.student), each) for each in kept)
        self._shared: frozenset[str] = frozenset()
        self._met: set[Override] = set()

    def among(self, results: Iterable[Result]) -> Overrides:
        """The same, once it is known which names are those of several results."""
        counts = Counter(name for each in results for name in (one_line(each.file), _bare(one_line(each.student))))
        self._shared = frozenset(name for name, count in counts.items() if count > 1)
        return self

    def joined(self, others: Iterable[Override]) -> Overrides:
        """With those of other tables; of a student who has different points in two the first count."""
        at = {_bare(each.student) or each.file: k for k, each in reversed([*enumerate(self.kept)])}
        kept, clashes = [*self.kept], [*self.clashes]
        for each in others:
            k = at.setdefault(_bare(each.student) or each.file, len(kept))
            if k == len(kept):
                kept.append(each)
                continue
            first = kept[k]
            if None not in (first.points, each.points) and first.points != each.points:
                clashes.append((first, each))
            words = [first.comment, *([each.comment] if each.comment not in first.comment else [])]
            points = each.points if first.points is None else first.points
            kept[k] = replace(first, points=points, comment="; ".join(filter(None, words)))
        return Overrides(kept, clashes)

    def of(self, student: str, file: str) -> Override | None:
        """The teacher's for a submission, which is then none of the rest."""
        student, file = one_line(student), one_line(file)
        override = self._exact.get((student, file))
        if override is None and _bare(student) not in self._shared:
            override = self._by_student.get(_bare(student))
        if override is None and file not in self._shared:
            override = self._by_file.get(file)
        self._met |= {override} if override is not None else set()
        return override

    def rest(self) -> tuple[Override, ...]:
        """Those that were asked for by no result so far."""
        return tuple(each for each in self.kept if each not in self._met)


def _bare(student: str) -> str:
    """An id as a spreadsheet may have spoilt it: `007` is 7 to it."""
    return student.lstrip("0") or student


def read_overrides(path: Path) -> Overrides:
    """The columns `override` and `comment` of a class table; none where there is no table. Raises Unreadable,
    NotAnOverride."""
    try:
        return Overrides(tuple(_rows(path, read_table(path))))
    except (FileNotFoundError, BrokenSubmission):
        return Overrides()
    except OSError as error:
        raise Unreadable(Where(str(path)), error.strerror or str(error)) from None


def _rows(path: Path, table: Iterator[list[str]]) -> Iterator[Override]:
    columns = {name.strip(): k for k, name in reversed([*enumerate(next(table, []))])}  # the first of several
    student, file, override, comment = (
        next((columns[name] for name in in_both(f"platforms.column {key}").values() if name in columns), None)
        for key in ("student", "file", "override", "comment")
    )
    if override is None or (student is None and file is None):
        return
    for number, row in enumerate(table, 2):
        text, id, name, words = (
            row[column].strip() if column is not None and column < len(row) else ""
            for column in (override, student, file, comment)
        )
        points = _points(text)
        if text and points is None:
            raise NotAnOverride(Where(str(path), number), text)
        if text or words:
            yield Override(one_line(id), one_line(name), points, words, str(path))


def _points(text: str) -> Decimal | None:
    """None of what is no number, or none that can be points."""
    try:
        points = Decimal(text.replace(",", "."))
        return points.quantize(HUNDREDTH, ROUND_HALF_UP) if 0 <= points <= _LARGEST else None
    except InvalidOperation:  # or NaN
        return None


def _unique(pairs: Iterable[tuple[str, Override]]) -> dict[str, Override]:
    """By name, those whose name no other has."""
    named = [pair for pair in pairs if pair[0]]
    counts = Counter(name for name, _ in named)
    return {name: each for name, each in named if counts[name] == 1}


# --- numbers that two students have digit by digit, and that nobody reads off alike: for the teacher alone ------------

_FEWEST, _PART = 3, 0.6  # so many telling numbers are the same, and this part of what both have handed in
_MANY = 5  # a telling number that more have is a common mistake's, calculated
_EXACT = 0.005  # nearer than this part to a right value is that value in three digits, which many calculate


def with_copies(results: Sequence[Result], lang: Lang) -> tuple[Result, ...]:
    """The results with remarks on the same numbers; of one student with several submissions none of these."""
    marked = [k for k, result in enumerate(results) if result.status == "marked"]
    handed = {k: {line.text: line for line in results[k].lines if line.given and not line.of_equations} for k in marked}
    having: dict[tuple[str, str], list[int]] = {}
    for k, lines in handed.items():
        for line in lines.values():
            having.setdefault((line.text, f"{line.given:.6g}"), []).append(k)
    telling, wrong = (Counter[tuple[int, int]]() for _ in range(2))
    for (name, _), some in having.items():
        by_whom = {k for k in some if _tells(handed[k][name])}
        if len(by_whom) <= _MANY:
            for pair in {(min(k, other), max(k, other)) for k in by_whom for other in some if other != k}:
                telling[pair] += 1
                wrong[pair] += any(handed[k][name].verdict == "wrong" for k in pair)
    remarks: dict[int, list[str]] = {}
    for pair, count in telling.items():
        one, other = (handed[k] for k in pair)
        both = one.keys() & other.keys()
        same = sum(f"{one[name].given:.6g}" == f"{other[name].given:.6g}" for name in both)
        alike = count >= _FEWEST and wrong[pair] and same >= _PART * len(both)
        for k, from_whom in (pair, pair[::-1]) if alike else ():
            student = results[from_whom].student
            if student != results[k].student and not any(student in remark for remark in results[k].remarks):
                remarks.setdefault(k, []).append(SameNumbers(student, same, len(both)).message(lang))
    return tuple(replace(each, remarks=(*each.remarks, *remarks.get(k, ()))) for k, each in enumerate(results))


def _tells(line: Judged) -> bool:
    """True for a number that is not simply the right one, or what follows rightly from earlier ones."""
    if line.given is None or line.verdict in ("dead point", "too small"):
        return False
    values = (value for value in (line.right, line.carried) if value is not None)
    return all(abs(abs(line.given) - abs(value)) > _EXACT * abs(value) for value in values)
