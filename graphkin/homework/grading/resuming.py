"""A marking that goes on from what there is: nothing is marked twice.

A record holds as long as what was handed in, the way it was read, and the key are the same. Where only the key is
another, and asks the same, the numbers that were read then are marked anew; all else is read.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from types import TracebackType
from typing import Any

from graphkin.errors import CannotWrite, NoMarks, Where
from graphkin.homework.grading.again import Again, again
from graphkin.homework.grading.batch import Item, StoredRecord, asked_print
from graphkin.homework.grading.running import Way, items, run
from graphkin.homework.grading.sets import SetMarker
from graphkin.marking.records import Graded
from graphkin.outputs.files import refuse
from graphkin.outputs.marks_file import MARKS, records_in, text
from graphkin.submissions import Handed

SUFFIX = ".journal"
HEAD = '{"kind": "graphkin journal", "format": 1}\n'


class Journal:
    """The records of a marking by fingerprint of what was handed in; new ones are added to a file, a line each.

    The file is there as long as the marking is not whole: what was ended at any moment has lost at most the line it
    was writing.
    """

    def __init__(self, path: Path, force: bool = False) -> None:
        """Raises FileInTheWay, NoFolder, CannotWrite."""
        self.path, self.beside = path, path.with_name(path.name + SUFFIX)
        self.records: dict[str, Mapping[str, Any]] = {}
        refuse(path, force, MARKS)
        refuse(self.beside, force, [HEAD.strip().encode()])

    def __enter__(self) -> Journal:
        try:
            for path in (self.path, self.beside):
                self.records |= _by_fingerprint(path) if path.is_file() else {}
            self._new = self.beside.open("a", encoding="utf-8", newline="\n")
            self._write("\n" if self._new.tell() else HEAD)  # a line that was cut ends here
        except OSError as error:
            raise CannotWrite.by(self.beside, error) from None
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, _: TracebackType | None) -> None:
        """Where all went well, it is in the file of marks; a broken-off one stays, unless nothing is in it."""
        with contextlib.suppress(OSError):
            self._new.close()
        if kind is None or self.beside.stat().st_size <= len(HEAD):
            with contextlib.suppress(OSError):
                self.beside.unlink()

    def add(self, record: Mapping[str, Any]) -> None:
        """Raises CannotWrite."""
        try:
            self._write(text(record) + "\n")
        except OSError as error:
            raise CannotWrite.by(self.beside, error) from None

    def _write(self, line: str) -> None:
        self._new.write(line)
        self._new.flush()


def _by_fingerprint(path: Path) -> dict[str, Mapping[str, Any]]:
    """The last record of each submission; a line that was cut or changed is none."""
    records: dict[str, Mapping[str, Any]] = {}
    for _, record in records_in(path, errors="replace"):
        prints = None if record is None else record.get("fingerprints")
        if record is not None and isinstance(prints, list) and prints:
            records[str(prints[0])] = record
    return records


def resumed(
    judge: SetMarker, paths: Iterable[str | Path], journal: Journal, way: Way,
    written: Callable[[Graded], Mapping[str, Any]],
) -> Iterator[Mapping[str, Any]]:  # fmt: skip
    """The record of every submission, in order; what is new is in the journal before it is given out.

    written   makes the record of one, as `outputs.marks_json` does in a language, which `way.words` names
    """
    paths = [*paths]
    known = (_known(item, judge, journal, way) for item in items(paths, way))
    for one in run(judge, known, way, paths):
        if isinstance(one, StoredRecord):
            yield journal.records[one.handed]
            continue
        new = written(one)
        if one.prints:
            journal.add(new)
        yield new


def _known(item: Handed | Again, judge: SetMarker, journal: Journal, way: Way) -> Item:
    """What is still to be done for a submission."""
    handed, reading = (item.digest[:16], way.reading) if isinstance(item, Handed) else item.prints[:2] or ("", "")
    there = journal.records.get(handed) if handed else None
    if there is None:
        return item
    try:
        before = again(there, Where(str(journal.path)))
    except NoMarks:
        return item
    if before.prints[:2] != (handed, reading) or len(before.prints) != len(("handed", "reading", "asked", "key")):
        return item
    student = before.student
    if before.prints[3] == judge.key_print(student):
        return StoredRecord(student, before.file, before.place, before.reason is None, handed)
    same = isinstance(item, Handed) and before.reason is None and before.prints[2] == asked_print(judge, student)
    return before if same else item
