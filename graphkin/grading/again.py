"""Marks given anew: by another key or another tolerance, from what was read of the submissions when they were marked.

A file of marks holds every number that was handed in, in SI; the submissions themselves are not needed any more.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from graphkin.errors import GraphkinError, NoFile, NoMarks, OwnFault, SaidBefore, UnknownStudent, Unreadable, Where
from graphkin.grading.sets import Judge
from graphkin.marking.graded import Graded
from graphkin.marking.marked import Number, Work
from graphkin.outputs.marks_file import KIND
from graphkin.outputs.marks_json import FORMAT, drawn_of

_GLANCE = 200


def is_marks(path: str | Path) -> bool:
    """Whether a file is one of marks."""
    try:
        with Path(path).open("rb") as file:
            start = file.read(_GLANCE)
    except (OSError, ValueError):
        return False
    return start.lstrip().startswith(b"{") and f'"kind": "{KIND}"'.encode() in start


def grade_again(judge: Judge, path: str | Path) -> Iterator[Graded]:
    """A record for every one in a file of marks, in order. Raises NoFile, Unreadable, NoMarks."""
    for record, where in _records(Path(path)):
        try:
            yield _graded(judge, record)
        except (KeyError, TypeError, ValueError, AttributeError):
            raise NoMarks(where) from None


def _records(path: Path) -> Iterator[tuple[Mapping[str, Any], Where]]:
    """The records, a line each, between the file's head and its end."""
    try:
        with path.open(encoding="utf-8") as file:
            for number, line in enumerate(file, 1):
                text = line.strip().removesuffix(",")
                if text.startswith('{"format"'):
                    yield _record(text, Where(str(path), number)), Where(str(path), number)
    except FileNotFoundError:
        raise NoFile(Where(str(path)), path.name, ()) from None
    except (OSError, UnicodeDecodeError) as problem:
        raise Unreadable(Where(str(path)), getattr(problem, "strerror", None) or "UTF-8") from None


def _record(text: str, where: Where) -> Mapping[str, Any]:
    try:
        record = json.loads(text)
    except (ValueError, RecursionError):
        raise NoMarks(where) from None
    if not isinstance(record, dict) or record.get("format") != FORMAT:
        raise NoMarks(where)
    return record


def _graded(judge: Judge, record: Mapping[str, Any]) -> Graded:
    student, file, place = (str(record[key]) for key in ("student", "file", "place"))
    notes = tuple(SaidBefore(str(note)) for note in record["notes"])
    if record["status"] != "marked":
        return Graded(student, file, place, None, SaidBefore(str(record["reason"])), notes)
    marker, work = judge.marker(student), _work(student, record["quantities"])
    if marker is None:
        return Graded(student, file, place, None, UnknownStudent(Where(file), student), notes)
    try:
        return Graded(student, file, place, marker.mark([work])[0], None, notes, drawn_of(record))
    except GraphkinError as problem:
        return Graded(student, file, place, None, problem, notes)
    except Exception as problem:
        return Graded(student, file, place, None, OwnFault(Where(file), type(problem).__name__), notes)


def _work(student: str, quantities: Mapping[str, Mapping[str, Any]]) -> Work:
    """The numbers that were read then."""
    return Work(
        student,
        {
            text: Number(float(each["given"]), bool(each["unit_right"]))
            for text, each in quantities.items()
            if each["given"] is not None
        },
    )
