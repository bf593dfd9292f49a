"""What was read of submissions when they were marked, to be marked anew: by another key, or another tolerance.

A file of marks holds every number that was handed in, in SI; the submissions themselves are not needed any more.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from graphkin.base.value import frozen
from graphkin.errors import NoFile, NoMarks, SaidBefore, Unreadable, Where
from graphkin.marking.records import Drawn, HandedNumber, StudentWork
from graphkin.outputs.marks_file import KIND, records_in
from graphkin.outputs.marks_json import FORMAT, drawn_of

_GLANCE = 200
_POINTS = {"right": True, "wrong": False}
"""Of a drawn vector; of a number its sign says it again."""


def is_marks(path: str | Path) -> bool:
    """Whether a file is one of marks."""
    try:
        with Path(path).open("rb") as file:
            start = file.read(_GLANCE)
    except (OSError, ValueError):
        return False
    return start.lstrip().startswith(b"{") and f'"kind": "{KIND}"'.encode() in start


@frozen
class Again:
    """One record of a file of marks: what was read of a submission then, or why nothing was.

    prints   the record's fingerprints, empty where it has none
    """

    student: str
    file: str
    place: str
    work: StudentWork
    reason: SaidBefore | None
    notes: tuple[SaidBefore, ...]
    prints: tuple[str, ...]
    drawn: Drawn


def again(record: Mapping[str, Any], where: Where) -> Again:
    """Raises NoMarks."""
    try:
        student, file, place = (str(record[key]) for key in ("student", "file", "place"))
        reason = None if record["status"] == "marked" else SaidBefore(str(record["reason"]))
        notes = tuple(SaidBefore(str(note)) for note in record["notes"])
        work = _work(student, record["quantities"])
        prints = tuple(map(str, record.get("fingerprints", ())))
        return Again(student, file, place, work, reason, notes, prints, drawn_of(record))
    except (KeyError, TypeError, ValueError, AttributeError):
        raise NoMarks(where) from None


def records_of(path: Path) -> Iterator[Again]:
    """Those of a file of marks, in order. Raises NoFile, Unreadable, NoMarks."""
    try:
        for number, record in records_in(path):
            where = Where(str(path), number)
            if record is None or record.get("format") != FORMAT:
                raise NoMarks(where)
            yield again(record, where)
    except FileNotFoundError:
        raise NoFile(Where(str(path)), path.name, ()) from None
    except (OSError, UnicodeDecodeError) as problem:
        raise Unreadable(Where(str(path)), getattr(problem, "strerror", None) or "UTF-8") from None


def _work(student: str, quantities: Mapping[str, Mapping[str, Any]]) -> StudentWork:
    """The numbers that were read then."""
    return StudentWork(
        student,
        {
            text: _number(each)
            for text, each in quantities.items()
            if each["given"] is not None
        },
    )


def _number(each: Mapping[str, Any]) -> HandedNumber:
    points, measured = _POINTS.get(each["sense"]), bool(each.get("measured"))
    return HandedNumber(float(each["given"]), bool(each["unit_right"]), points, measured)
