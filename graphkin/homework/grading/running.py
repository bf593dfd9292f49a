"""Submissions marked batch by batch, here or by workers: memory stays flat, and one that fails stops no other.

A marking that was broken off goes on from its journal, and nothing is marked twice. A record holds as long as what was
handed in, the way it was read, and the key are the same. Where only the key is another, and asks the same, the numbers
that were read then are marked anew; all else is read.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import replace
from functools import cached_property, partial
from itertools import chain
from pathlib import Path
from types import TracebackType

import graphkin
from graphkin.api.drawing import Source, load
from graphkin.base.value import frozen
from graphkin.base.worklist import ahead
from graphkin.errors import CannotWrite, NoMarks, OwnFault, Where
from graphkin.homework.grading import batch as batches
from graphkin.homework.grading.batch import Item, Read, StoredRecord, marked
from graphkin.homework.grading.keys import key_for, pencils_of
from graphkin.homework.grading.photographs import Photographs, PhotoJob, photographs, printed_sheets
from graphkin.homework.grading.sets import OneKey, SetMarker, judge_from
from graphkin.marking.key import Key
from graphkin.marking.marker import Marker
from graphkin.marking.records import Graded
from graphkin.outputs.files import refuse
from graphkin.outputs.marks_json import MARKS, Record, records_in, text
from graphkin.outputs.sheets_json import is_readings
from graphkin.submissions import FirstOnes, Handed, Limits, Roster, called, guarded, handed_in
from graphkin.submissions.submission import fingerprint

_BATCH, _BYTES = 64, 4 << 20
"""Submissions, and bytes of them, that are marked at once; a single one may be larger."""
_AHEAD = 8
Written = Callable[[Graded], Record]


@frozen
class MarkingOptions:
    """Limits, workers and language of a marking.

    limits    of what is read of a submission
    workers   processes that read and mark, each submission within its time; 0: this one
    executor  does it instead, any of `concurrent.futures` or a cluster's; its workers must be able to import graphkin,
              and to reach the keys of a set
    words     the language of the records that are written
    photographs  what was read on the pictures among what is handed in
    """

    limits: Limits = Limits()
    workers: int = 0
    executor: Executor | None = None
    words: str = ""
    photographs: Photographs | None = None

    @cached_property
    def reading(self) -> str:
        """A fingerprint of how submissions are read."""
        return fingerprint(repr(self.limits), self.words, graphkin.__version__)


def grade(
    judge: Key | SetMarker | Source, paths: str | Path | Iterable[str | Path], limits: Limits | None = None, *,
    pencil: str | None = None, sigmas: float | None = None, relative: float | None = None,
    roster: str | Path | None = None, turned: bool = False, letters: str = "", workers: int = 0,
    executor: Executor | None = None, sheets: str | Path | None = None, seen: Photographs | None = None,
) -> Iterator[Graded]:  # fmt: skip
    """A record for every submission in these files, in order.

    judge   one key for all, or each student's own; or what `graphkin grade` takes as KEY, with what it says of pencils
            and its roster
    paths   answers, drawings, class tables, archives, folders; or files of marks, whose numbers are marked anew
    turned  in a drawing a polygon may stand turned; letters: "p,b2,b3", the points of drawings without letters
    sheets  the list of printed sheets, for photographs; it is looked for beside `judge` and `paths`, too
    seen    all pictures in `paths`, where these are looked at already

    A submission that cannot be read or marked is a record with its reason; so is a second one of a student. Raises
    NoMarks, Unreadable of a file of marks.
    """
    key = str(judge) if isinstance(judge, str | Path) else ""
    if not isinstance(judge, Key | SetMarker):
        said, listed = pencils_of(pencil, sigmas, relative), None if roster is None else Path(roster)
        judge = judge_from(str(judge), said, listed) if isinstance(judge, str | Path) else key_for(load(judge), said)
    judge = OneKey(Marker(judge)) if isinstance(judge, Key) else judge
    options = MarkingOptions(limits or limits_of(turned, letters), workers, executor, photographs=seen)
    paths = [paths] if isinstance(paths, str | Path) else [*paths]
    options = with_photographs(options, key, judge, paths, None if sheets is None else Path(sheets))
    for graded in run(judge, items(paths, options, judge), options, paths):
        assert isinstance(graded, Graded)
        yield graded


def with_photographs(
    options: MarkingOptions, key: str, judge: SetMarker, paths: Sequence[str | Path], sheets: Path | None = None,
    crop: bool = False,
) -> MarkingOptions:  # fmt: skip
    """With all pictures in these files looked at, by the list of sheets that is named, or is near; crop: with pictures
    for a teacher to look at. Raises NoSheetList, NoReadings, NoFile, Unreadable."""
    if options.photographs is not None:
        return options
    job = PhotoJob(judge, printed_sheets(key, paths, sheets), crop, options.limits, options.workers)
    return replace(options, photographs=photographs(paths, job))


def limits_of(turned: bool, letters: str) -> Limits:
    return Limits(turned=turned, names=tuple(name.strip() for name in letters.split(",") if name.strip()))


def items(paths: Iterable[str | Path], options: MarkingOptions, judge: SetMarker) -> Iterator[Handed | Read]:
    """Submissions, one after another, in the order of the files; what several files of marks have in common once. What
    was measured on pictures stands beside them, or behind."""
    every = [path for path in map(Path, paths) if options.photographs is None or not is_readings(path)]
    marks = [*dict.fromkeys(filter(batches.is_marks, every))]
    for path in every:
        if path not in marks:
            handed = handed_in([path], options.limits, judge.roster)
            yield from handed if options.photographs is None else options.photographs.joined(handed)
        elif path == marks[0]:
            yield from batches.merged(marks) if len(marks) > 1 else batches.records_of(path)
    yield from () if options.photographs is None else options.photographs.left()


def run(
    judge: SetMarker, some: Iterable[Item], options: MarkingOptions, paths: Iterable[str | Path],
    written: Written | None = None,
) -> Iterator[Graded | StoredRecord]:  # fmt: skip
    """The result of each, in order; what is kept goes through as it is. `paths`: of all that was handed in; `written`:
    results are lines, made where they are marked."""
    work = partial(marked, judge=judge, limits=options.limits, reading=options.reading)
    if written is not None:
        work = partial(_lines, work=work, written=written)
    done: Iterable[Graded | StoredRecord]
    if options.executor is not None:
        done = ahead(options.executor, work, _batches(some), _AHEAD)
    elif options.workers:
        done = guarded(work, _batches(some), options.workers, options.limits.seconds, _failed)
    else:
        done = chain.from_iterable(map(work, _batches(some)))
    return firsts(done, paths, judge.roster)


def _lines(
    some: list[Item], work: Callable[[list[Item]], list[Graded | StoredRecord]], written: Written
) -> list[Graded | StoredRecord]:
    """Results that need no more than to be written."""
    return [one if isinstance(one, StoredRecord) else _line(one, written) for one in work(some)]


def _line(one: Graded, written: Written) -> StoredRecord:
    return StoredRecord(one.student, one.file, one.place, one.marked is not None, one.prints, text(written(one)))


def firsts(
    records: Iterable[Graded | StoredRecord], paths: Iterable[str | Path], roster: Roster | None = None
) -> Iterator[Graded | StoredRecord]:
    """Of each student the first that was marked; a further one says so."""
    seen = FirstOnes([path for path in paths if not batches.is_marks(path)], roster)
    for one in records:
        if not one.marked:
            yield one
            continue
        reason = seen.reason(one.student, one.file, one.place)
        yield one if reason is None else Graded(called(one.student, reason), one.file, one.place, None, reason)


def _failed(item: Item, problem: str) -> Graded | StoredRecord:
    if isinstance(item, StoredRecord):
        return item
    of = item.record if isinstance(item, Read) else Graded(item.owner.student, item.file, item.place, None)
    return Graded(of.student, of.file, of.place, None, OwnFault(Where(of.file), problem))


def _batches(some: Iterable[Item]) -> Iterator[list[Item]]:
    """So many at once, and not too many bytes of them."""
    batch: list[Item] = []
    held = 0
    for item in some:
        batch.append(item)
        held += sum(len(content) for _, content in item.files) if isinstance(item, Handed) else 0
        if len(batch) >= _BATCH or held >= _BYTES:
            yield batch
            batch, held = [], 0
    if batch:
        yield batch


# --- going on from what there is --------------------------------------------------------------------------------------

SUFFIX = ".journal"
HEAD = '{"kind": "graphkin journal", "format": 1}\n'


class Journal:
    """The records of a marking by fingerprint of what was handed in; new ones are added to a file, a line each.

    The file is there as long as the marking is not whole: what was ended at any moment has lost at most the line it
    was writing. Of the records `before` so many are `kept`; of a student whose work is `replaced`, by what.
    """

    def __init__(self, path: Path, force: bool = False) -> None:
        """Raises FileInTheWay, NoFolder, CannotWrite, NoMarks."""
        self.path, self.beside = path, path.with_name(path.name + SUFFIX)
        self.records: dict[str, Record] = {}
        self.before: list[Record] = []
        self.kept, self.replaced = 0, list[tuple[str, str, str]]()
        refuse(path, force, MARKS)
        refuse(self.beside, force, [HEAD.strip().encode()])

    def __enter__(self) -> Journal:
        try:
            for path in (self.path, self.beside):
                # the last record of each submission; a line that was cut or changed is none
                for number, record in records_in(path, errors="replace") if path.is_file() else ():
                    if path == self.path:
                        batches.earlier_reading(record or {}, Where(str(path), number))
                        self.before += [record] if record else []
                    prints = None if record is None else record.get("fingerprints")
                    if record is not None and isinstance(prints, list) and prints:
                        self.records[str(prints[0])] = record
            self._new = self.beside.open("a", encoding="utf-8", newline="\n")
            self._write("\n" if self._new.tell() else HEAD)  # a line that was cut ends here
        except OSError as error:
            raise CannotWrite.by(self.beside, error) from None
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, _: TracebackType | None) -> None:
        """Of a marking that is whole the records are in the file of marks; a broken-off journal stays, unless empty."""
        with contextlib.suppress(OSError):
            self._new.close()
        if kind is None or self.beside.stat().st_size <= len(HEAD):
            with contextlib.suppress(OSError):
                self.beside.unlink()

    def add(self, line: str) -> None:
        """Raises CannotWrite."""
        try:
            self._write(line + "\n")
        except OSError as error:
            raise CannotWrite.by(self.beside, error) from None

    def _write(self, line: str) -> None:
        self._new.write(line)
        self._new.flush()


def resumed(
    judge: SetMarker, paths: Iterable[str | Path], journal: Journal, options: MarkingOptions, written: Written
) -> Iterator[str]:
    """The line of every submission, in order; what is new is in the journal before it is given out. Then those of
    students who are in the file of marks and have handed in nothing now, by the key of now where it asks the same.

    written   makes the record of one, as `outputs.marks_json` does in a language, which `options.words` names
    """
    paths = [*paths]
    rest = (_still_to_do(item, judge, journal, options) for item in items(paths, options, judge))
    newest: dict[str, StoredRecord] = {}
    places: set[tuple[str, str]] = set()
    for one in run(judge, rest, options, paths, written):
        stored = _line(one, written) if isinstance(one, Graded) else one
        if stored.line and stored.prints:
            journal.add(stored.line)
        if one.student not in newest or one.marked:
            newest[one.student] = stored
        places.add((one.file, one.place))
        yield stored.line or text(journal.records[stored.prints[0]])
    yield from map(text, _kept(judge, journal, options, written, newest, places))


def _kept(
    judge: SetMarker, journal: Journal, options: MarkingOptions, written: Written,
    newest: Mapping[str, StoredRecord], places: Container[tuple[str, str]],
) -> Iterator[Record]:  # fmt: skip
    """The earlier records that nothing takes the place of: a student's marks are given up for other marks alone, or
    where the same file is read otherwise. Marked anew where the key is another that asks the same."""
    kept: list[tuple[Record, Read | None]] = []
    for old in journal.before:
        now, place, had = newest.get(old["student"]), (old["file"], old["place"]), old["status"] == "marked"
        again = place in places and not (place[1].isdecimal() and had)
        if not again and (now is None or (had and not now.marked)):
            before = batches.earlier_reading(old, Where(str(journal.path)))
            *_, asks, key = ("", "", *before.record.prints)
            other = had and asks and key != judge.key_print(before.work.student)
            same = other and asks == batches.asked_print(judge, before.work.student)
            kept.append((old, before if same else None))
        elif now is not None and (had or not again) and [*now.prints[:1]] != old.get("fingerprints", [])[:1]:
            ways = (place, (now.file, now.place))
            lines = (Where(file, int(line) if line.isdecimal() else None) for file, line in ways)
            journal.replaced.append((old["student"], *map(str, lines)))
    journal.kept = len(kept)
    marks = run(judge, (read for _, read in kept if read is not None), options, ())
    for old, read in kept:
        one = None if read is None else next(marks)
        yield written(one) if isinstance(one, Graded) and one.marked else old


def _still_to_do(item: Handed | Read, judge: SetMarker, journal: Journal, options: MarkingOptions) -> Item:
    """The submission, its record of before, or its numbers of before, whichever still holds."""
    if not journal.records:
        return item
    handed, reading = (item.digest, options.reading) if isinstance(item, Handed) else item.record.prints[:2] or ("", "")
    there = journal.records.get(handed) if handed else None
    if there is None:
        return item
    try:
        read = batches.earlier_reading(there, Where(str(journal.path)))
    except NoMarks:
        return item
    before, student = read.record, read.record.student
    if before.prints[:2] != (handed, reading) or len(before.prints) != len(("handed", "reading", "asked", "key")):
        return item
    if before.prints[3] == judge.key_print(student):
        return StoredRecord(student, before.file, before.place, before.reason is None, before.prints)
    same = before.reason is None and before.prints[2] == batches.asked_print(judge, student)
    return read if same and isinstance(item, Handed) else item
