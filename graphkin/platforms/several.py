"""What a student's results in several problems have in common, looked up in their files of marks."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any, BinaryIO

from graphkin.errors import NoFile, NotAResult, Unreadable, Where
from graphkin.grading import Places
from graphkin.marking.habits import Habit, Trace, habits

_BEGIN = re.compile(rb'\{"format": \d+, "student": ("(?:[^"\\]|\\.)*"), "file": "(?:[^"\\]|\\.)*", "status": "marked"')


class Several:
    """Files of marks, one a problem; of each record only its place is held. Raises NoFile, Unreadable, NotAResult."""

    def __init__(self, paths: Iterable[Path]) -> None:
        self._files = [_Marks(path) for path in paths]

    def __enter__(self) -> Several:
        return self

    def __exit__(self, *error: object) -> None:
        for marks in self._files:
            marks.close()

    @property
    def count(self) -> int:
        """Of the problems."""
        return len(self._files)

    def habits(self, student: str) -> tuple[Habit, ...]:
        """The mistakes that show in more than one problem of a student."""
        found = (file.trace(student) for file in self._files)
        return habits([trace for trace in found if trace is not None])


class _Marks:
    """One file, and where each student's record is."""

    def __init__(self, path: Path) -> None:
        self._path, self._places = path, Places()
        try:
            self._file: BinaryIO = path.open("rb")
            for student, at in self._students():
                self._places.add(_number(student), at)
        except FileNotFoundError:
            raise NoFile(Where(str(path)), path.name, ()) from None
        except OSError as error:
            raise Unreadable(Where(str(path)), error.strerror or str(error)) from None

    def close(self) -> None:
        """It is not read any more."""
        self._file.close()

    def _students(self) -> Iterator[tuple[str, int]]:
        at = 0
        for line in self._file:
            if (found := _BEGIN.match(line)) is not None:
                yield json.loads(found[1]), at
            at += len(line)

    def trace(self, student: str) -> Trace | None:
        """What this problem says of a student; None where nothing of theirs was marked."""
        at = self._places.find(_number(student))
        if at is None:
            return None
        self._file.seek(at)
        try:
            record = json.loads(self._file.readline().strip().removesuffix(b","))
            return _trace(record) if record["student"] == student else None
        except (ValueError, KeyError, TypeError, AttributeError, RecursionError):
            raise NotAResult(Where(str(self._path)), student[:80]) from None


def _trace(record: Mapping[str, Any]) -> Trace:
    named = dict.fromkeys(str(id) for one in record["mistakes"][:1] for id in one["ids"])
    return Trace(tuple(named), {str(id): float(weight) for id, weight in record["evidence"].items()})


def _number(student: str) -> int:
    return hash(student) % (1 << 64)
