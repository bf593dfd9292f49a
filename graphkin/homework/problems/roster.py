"""The students of a class: a list in a file, or so many of them."""

from __future__ import annotations

from pathlib import Path

from graphkin.base.value import frozen
from graphkin.errors import NoFile, NoStudents, OutOfRange, StudentTwice, Unreadable, Where
from graphkin.submissions.documents import IDS, csv_cells, student_of
from graphkin.submissions.submission import Limits, tidy_id

MOST = 100_000


@frozen
class Student:
    """`names`: other cells of the student's row by their heading, such as the name."""

    id: str
    names: tuple[tuple[str, str], ...] = ()


def roster(given: str) -> tuple[Student, ...]:
    """The students of a CSV file (UTF-8 with or without its mark, UTF-16, GBK), or s1 .. sN for a number N.

    Raises NoFile, Unreadable, OutOfRange, StudentTwice, NoStudents.
    """
    if given.isdecimal() and given.isascii():
        if len(given) > 6 or not 0 < int(given) <= MOST:
            raise OutOfRange(Where("--students"), given[:20])
        wide = len(given)
        return tuple(Student(f"s{number:0{wide}d}") for number in range(1, int(given) + 1))
    path, where = Path(given), Where(given)
    try:
        with path.open("rb") as stream:
            return _students([[str(cell) for cell in row] for _, row in csv_cells(stream, where)], where)
    except FileNotFoundError:
        raise NoFile(where, path.name, ()) from None
    except OSError as problem:
        raise Unreadable(where, problem.strerror or str(problem)) from None


def _students(rows: list[list[str]], where: Where) -> tuple[Student, ...]:
    """By the column of ids that the header names, else the first column of all rows."""
    filled = [row for row in rows[: Limits().rows] if any(cell.strip() for cell in row)]
    head = [cell.strip().lower() for cell in filled[0]] if filled else []
    at = next((head.index(name) for name in IDS if name in head), None)
    students: dict[str, Student] = {}
    for row in filled if at is None else filled[1:]:
        column = at or 0
        name = tidy_id(row[column]) if column < len(row) else ""
        if not name:
            continue
        if name in students:
            raise StudentTwice(where, name)
        headings = filled[0] if at is not None else []
        cells = enumerate(zip(headings, row))
        more = tuple((tidy_id(h), tidy_id(cell)) for k, (h, cell) in cells if k != column and student_of(h))
        students[name] = Student(name, more)
    if not students:
        raise NoStudents(where)
    return tuple(students.values())
