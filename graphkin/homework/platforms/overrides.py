"""The teacher's own points: a column of the class table that survives when the table is written anew."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from decimal import ROUND_HALF_UP, Decimal, InvalidOperation
from pathlib import Path

from graphkin.base.value import frozen
from graphkin.errors import NotAnOverride, Unreadable, Where
from graphkin.homework.platforms.cells import columns_of, read_table
from graphkin.homework.platforms.marked_up import one_line
from graphkin.homework.platforms.numbers import HUNDREDTH
from graphkin.homework.platforms.result import Result
from graphkin.say.catalogue import in_both

_LARGEST = Decimal(10**6)


@frozen
class Override:
    """One override."""

    student: str
    file: str
    points: Decimal


class Overrides:
    """Overrides by student and file. A spreadsheet may have spoilt an id (`007`): then by the file alone."""

    def __init__(self, kept: Sequence[Override] = ()) -> None:
        self.kept = tuple(kept)
        self._exact = {(each.student, each.file): each for each in kept}
        self._by_file = _alone((each.file, each) for each in kept)
        self._by_student = _alone((each.student, each) for each in kept)
        self._met: set[Override] = set()

    def of(self, result: Result) -> Decimal | None:
        """The points that a teacher has given."""
        student, file = one_line(result.student), one_line(result.file)
        found = self._exact.get((student, file)) or self._by_student.get(student) or self._by_file.get(file)
        if found is None:
            return None
        self._met.add(found)
        return found.points

    def rest(self) -> tuple[Override, ...]:
        """Those that were asked for by no result so far."""
        return tuple(each for each in self.kept if each not in self._met)


def overridden(results: Iterable[Result], overrides: Overrides) -> Iterator[Result]:
    """The results with the teacher's points."""
    from dataclasses import replace

    for result in results:
        yield replace(result, override=overrides.of(result))


def read_overrides(path: Path) -> Overrides:
    """The column `override` of a class table; none where there is no table. Raises Unreadable, NotAnOverride."""
    try:
        return Overrides(tuple(_rows(path, read_table(path))))
    except FileNotFoundError:
        return Overrides()
    except OSError as error:
        raise Unreadable(Where(str(path)), error.strerror or str(error)) from None


def _rows(path: Path, table: Iterator[list[str]]) -> Iterator[Override]:
    columns = columns_of(next(table, []))
    student, file, override = (_column(columns, key) for key in ("student", "file", "override"))
    if override is None or (student is None and file is None):
        return
    for number, row in enumerate(table, 2):
        given = _cell(row, override)
        if given:
            found = _points(given, Where(str(path), number))
            yield Override(one_line(_cell(row, student)), one_line(_cell(row, file)), found)


def _column(columns: dict[str, int], key: str) -> int | None:
    """The column in either language."""
    return next((columns[name] for name in in_both(f"platforms.column {key}").values() if name in columns), None)


def _cell(row: list[str], column: int | None) -> str:
    return row[column].strip() if column is not None and column < len(row) else ""


def _points(given: str, where: Where) -> Decimal:
    try:
        found = Decimal(given.replace(",", "."))
        if 0 <= found <= _LARGEST:
            return found.quantize(HUNDREDTH, ROUND_HALF_UP)
    except InvalidOperation:
        pass
    raise NotAnOverride(where, given)


def _alone(pairs: Iterable[tuple[str, Override]]) -> dict[str, Override]:
    """By name, those whose name no other has."""
    found: dict[str, Override | None] = {}
    for name, each in pairs:
        found[name] = None if name in found else each
    return {name: each for name, each in found.items() if each is not None and name}

