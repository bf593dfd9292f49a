"""The class as a table: a row a submission, in the order of the results, as CSV and XLSX write it; and overrides.

An override is the teacher's own points: a column of the table that survives when the table is written anew.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from decimal import ROUND_HALF_UP, Decimal, InvalidOperation
from pathlib import Path

from graphkin.base.value import frozen
from graphkin.errors import BrokenSubmission, Lang, NotAnOverride, Unreadable, Where
from graphkin.homework.platforms.feedback import habit, suspected
from graphkin.homework.platforms.markup import one_line
from graphkin.homework.platforms.question import texts_in
from graphkin.homework.platforms.result import Result, most_of, points_of
from graphkin.homework.platforms.tables import HUNDREDTH, Cell, read_table
from graphkin.marking.records import Judged
from graphkin.say.catalogue import in_both, say
from graphkin.say.marks import verdict

_FRONT = ("student", "file", "status", "earned", "most", "override", "total", "score percent")
_BACK = ("remarks", "diagnosis", "reason")


def quantities(results: Iterable[Result]) -> tuple[str, ...]:
    """All that is asked anywhere, as it is met first, and what is wrong on the way."""
    met: dict[str, bool] = {}
    for line in (line for result in results for line in result.lines):
        met[line.text] = met.get(line.text, False) or bool(most_of(line)) or line.verdict in ("wrong", "not read")
    return tuple(name for name, shown in met.items() if shown)


def rows(results: Iterable[Result], names: tuple[str, ...], lang: Lang, several: bool = False) -> Iterator[list[Cell]]:
    """The table with its head; with a last column, where this is one of several problems, for what shows in them."""
    pairs = [text for name in names for text in (name, say("platforms.column part earned", lang, name=name))]
    front, back = ([say(f"platforms.column {key}", lang) for key in keys] for keys in (_FRONT, _BACK))
    yield [*front, *pairs, *back, *([say("platforms.column habits", lang)] if several else [])]
    for result in results:
        habits = (  # with the evidence of all problems together
            say("platforms.habit", lang, shown=h.shown, of=h.of, mistake=habit(h, lang), evidence=f"{h.weight:.1f}")
            for h in result.habits
        )
        marked = result.status == "marked"
        front_cells: list[Cell] = [
            result.student, result.file, say(f"verdicts.status {result.status}", lang),
            result.earned if marked else None, result.most, result.override, result.total,
            None if result.score is None else (result.score * 100).quantize(Decimal("0.01")),
        ]  # fmt: skip
        by_name: dict[str, tuple[Cell, Cell]] = {
            line.text: (_cell(line, lang), None if line.written else points_of(line)) for line in result.lines
        }
        unread = [line.text for line in result.lines if line.written]
        reasons = [say("marks.unread", lang, quantities=say("common.list", lang).join(unread))] if unread else []
        middle = [cell for name in names for cell in by_name.get(name, ("", None))]
        diagnosis = suspected(result.suspicions[0], lang) if result.suspicions else ""
        why = say("common.semicolon", lang).join(filter(None, [texts_in([result.reason], lang)[0], *reasons]))
        remarks = say("common.semicolon", lang).join(result.remarks)
        row = [*front_cells, *middle, remarks, diagnosis, why]
        yield [*row, *([say("common.semicolon", lang).join(habits)] if several else [])]


def _cell(line: Judged, lang: Lang) -> str:
    """A verdict; of an answer that was not read with what was written."""
    text = verdict(line, lang)
    return f'{text} "{one_line(line.written)}"' if line.written else text


def absent(overrides: Overrides, names: tuple[str, ...]) -> Iterator[list[Cell]]:
    """Overrides of those who are not among the results gone through so far; they keep a row each."""
    for each in overrides.rest():
        yield [each.student, each.file, "", None, None, each.points, *[None] * (2 + 2 * len(names) + len(_BACK))]


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
        override = self.at(student, file)
        self._met |= {override} if override is not None else set()
        return override

    def at(self, student: str, file: str) -> Override | None:
        """The teacher's for a submission."""
        student, file = one_line(student), one_line(file)
        override = self._exact.get((student, file))
        if override is None and _bare(student) not in self._shared:
            override = self._by_student.get(_bare(student))
        if override is None and file not in self._shared:
            override = self._by_file.get(file)
        return override

    def rest(self) -> tuple[Override, ...]:
        """Those that were asked for by no result so far."""
        return tuple(each for each in self.kept if each not in self._met)


def _bare(student: str) -> str:
    """An id as a spreadsheet may have spoilt it: `007` is 7 to it."""
    return student.lstrip("0") or student


def commented(table: Iterable[list[Cell]], overrides: Overrides, lang: Lang) -> Iterator[list[Cell]]:
    """The table with a column for the teacher's words, beside the score."""
    rows = iter(table)
    head = next(rows)
    at, of, score = (head.index(say(f"platforms.column {key}", lang)) for key in ("student", "file", "score percent"))
    yield [*head[: score + 1], say("platforms.column comment", lang), *head[score + 1 :]]
    for row in rows:
        override = overrides.at(str(row[at]), str(row[of]))
        yield [*row[: score + 1], "" if override is None else override.comment, *row[score + 1 :]]


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
