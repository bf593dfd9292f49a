"""What is known of a marking: the records in its file, and those that one that was broken off has left beside it."""

from __future__ import annotations

import contextlib
import json
import re
from collections.abc import Mapping
from pathlib import Path
from types import TracebackType
from typing import Any, BinaryIO

from graphkin.errors import CannotWrite, Where
from graphkin.grading.places import Places
from graphkin.outputs.files import refuse
from graphkin.outputs.marks_file import MARKS, text

SUFFIX = ".journal"
HEAD = b'{"kind": "graphkin journal", "format": 1}\n'
_PRINT = re.compile(rb'"fingerprints": \["([0-9a-f]{16})"')
"""No text within a record can hold it: its quotation marks would be escaped."""
_FILES = 1 << 56


class Journal:
    """The records of a marking by fingerprint of what was handed in; new ones are added to a file, a line each.

    The file is there as long as the marking is not whole: what was ended at any moment has lost at most the line it
    was writing.
    """

    def __init__(self, path: Path, force: bool = False) -> None:
        """Raises FileInTheWay, NoFolder, CannotWrite."""
        self.path, self.beside = path, path.with_name(path.name + SUFFIX)
        refuse(path, force, MARKS)
        refuse(self.beside, force, [HEAD.strip()])

    def __enter__(self) -> Journal:
        try:
            self._open()
        except OSError as error:
            raise CannotWrite.by(self.beside, error) from None
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, _: TracebackType | None) -> None:
        """Where all went well, it is in the file of marks; a broken-off one stays, unless nothing is in it."""
        for file in (*self._files, self._new):
            file.close()
        if kind is None or self.beside.stat().st_size <= len(HEAD):
            with contextlib.suppress(OSError):
                self.beside.unlink()

    def _open(self) -> None:
        self._new = _appended(self.beside)
        self._files: list[BinaryIO] = [path.open("rb") for path in (self.path, self.beside) if path.is_file()]
        self._known = Places()
        for number, file in enumerate(self._files):
            at = 0
            for line in file:
                if (found := _PRINT.search(line)) is not None:
                    self._known.add(int(found[1], 16), number * _FILES + at)
                at += len(line)

    def find(self, handed: str) -> int | None:
        """Where the last record of a submission begins, by its fingerprint."""
        return self._known.find(int(handed, 16))

    def read(self, at: int) -> Mapping[str, Any] | None:
        """The record there; None of a line that was cut or changed."""
        number, place = divmod(at, _FILES)
        file = self._files[number]
        file.seek(place)
        try:
            record = json.loads(file.readline().strip().removesuffix(b","))
        except (ValueError, RecursionError):
            return None
        return record if isinstance(record, dict) else None

    def add(self, record: Mapping[str, Any]) -> None:
        """Raises CannotWrite."""
        try:
            self._new.write(text(record).encode() + b"\n")
        except OSError as error:
            raise CannotWrite.by(self.beside, error) from None

    def where(self, at: int) -> Where:
        """The file of a record."""
        return Where(self._files[at // _FILES].name)


def _appended(path: Path) -> BinaryIO:
    """A journal to be gone on with, after its last whole line."""
    whole = _whole(path) if path.is_file() else 0
    file = path.open("r+b" if whole else "wb", buffering=0)
    file.truncate(whole)
    file.seek(whole)
    if not whole:
        file.write(HEAD)
    return file


def _whole(path: Path) -> int:
    """Bytes of the lines that were written to their end."""
    with path.open("rb") as file:
        return sum(len(line) for line in file if line.endswith(b"\n"))
