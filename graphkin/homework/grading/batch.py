"""A batch of submissions read and marked at once, as a worker does it; and records of earlier readings.

A file of marks holds every number that was handed in, in SI: these are marked anew, by another key or another
tolerance, and the submissions themselves are not needed any more.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import groupby
from pathlib import Path

from graphkin import errors
from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.errors import GraphkinError, NoMarks, OwnFault, SaidBefore, Where
from graphkin.homework import opening
from graphkin.homework.grading.sets import SetMarker
from graphkin.marking.marker import Marker
from graphkin.marking.records import Graded, HandedNumber, Marked, StudentWork
from graphkin.model.quantities import at_position, position_of
from graphkin.outputs.marks_json import FORMAT, KIND, Record, drawn_of, judged_of, measured_of, records_in
from graphkin.submissions import Handed, Limits, Submission, limited, read_one
from graphkin.submissions.board import work_of
from graphkin.submissions.reading import paper_polygons
from graphkin.submissions.submission import MeasuredDrawing, fingerprint, tidy_id

_EACH = 0.1  # a batch is marked at once in the time of one submission and so much more for each further one [s]
_ONCE_MORE = (OwnFault, errors.TookTooLong, errors.Unreadable, errors.WantsExtra)
"""Reasons that may be gone when it is tried again."""
_LOOK = (errors.NotMarkable, errors.BrokenSubmission, errors.NoNumbers, errors.WantsExtra, errors.TooMuch,
         errors.NoSheetsKnown, errors.AnsweredTwice, errors.SenseDisputed)  # fmt: skip
"""The teacher is told, too, why a file beside others is not read, and of two answers to one question."""
_GLANCE = 200
_SHOWN = 80  # letters of an answer that was not read
_POINTS = {"right": True, "wrong": False}  # of a drawn vector; of a number its sign says it again


# --- records of before ------------------------------------------------------------------------------------------------


def is_marks(path: str | Path) -> bool:
    """True where a file is one of marks."""
    try:
        with Path(path).open("rb") as file:
            start = file.read(_GLANCE)
    except (OSError, ValueError):
        return False
    return start.lstrip().startswith(b"{") and f'"kind": "{KIND}"'.encode() in start


@frozen
class Read:
    """A submission that is ready to be marked, or why it is not: read now, or then, as a file of marks has it. Its
    record is whole but for the marks."""

    work: StudentWork
    record: Graded


def earlier_reading(record: Record, where: Where) -> Read:
    """The submission of a record. Raises NoMarks."""
    try:
        student, file, place = (str(record[key]) for key in ("student", "file", "place"))
        reason = None if record["status"] == "marked" else SaidBefore(str(record["reason"]))
        notes = tuple(SaidBefore(str(note)) for note in record["notes"])
        lines = judged_of(record)
        numbers = {one.text: HandedNumber(one.given, one.unit_right, _POINTS.get(one.sense or ""), one.measured)
                   for one in lines if one.given is not None and not one.of_equations}  # fmt: skip
        unread = {one.text: one.written for one in lines if one.written}
        prints = tuple(map(str, record.get("fingerprints", ())))
        board = None if record.get("board") is None else work_of(record["board"])
        paper = measured_of(record)
        work = StudentWork(student, numbers, unread, board, 0.0 if paper is None else paper.error)
        remarks = tuple(
            SaidBefore(str(one["text"]), str(one["id"])) for one in record.get("remarks", ())
            if one["id"] != errors.AnotherStudent.id  # that is found anew
        )  # fmt: skip
        drawn = drawn_of(record)
        graded = Graded(student, file, place, None, reason, notes, drawn, prints, remarks, board, paper)
        return Read(work, graded)
    except (KeyError, TypeError, ValueError, AttributeError):
        raise NoMarks(where) from None


def records_of(path: Path) -> Iterator[Read]:
    """Those of a file of marks, in order. Raises NoFile, Unreadable, NoMarks."""
    with opening(path):
        for number, record in records_in(path):
            where = Where(str(path), number)
            if record is None or record.get("format") != FORMAT:
                raise NoMarks(where)
            yield earlier_reading(record, where)


def merged(paths: Sequence[Path]) -> Iterator[Read]:
    """The records of several graders: what more than one of them have of a student once, marked where one of them has
    marked it. Raises what reading one raises."""
    read = ((one, one.record) for path in paths for one in records_of(path))
    every = [(one, (record.student, record.place or Path(record.file).name)) for one, record in read]
    some = {at for one, at in every if one.record.reason is None}
    met = set[object]()
    for one, at in every:
        what = at if one.record.reason is not None else repr(one.work)
        if what not in met and (one.record.reason is None or at not in some):
            met.add(what)
            yield one


@frozen
class StoredRecord:
    """A submission whose record there is and holds: whose it is, whether it was marked, its fingerprints; and its line
    where that is new."""

    student: str
    file: str
    place: str
    marked: bool
    prints: tuple[str, ...]
    line: str = ""


Item = Handed | Read | StoredRecord


def marked(some: list[Item], judge: SetMarker, limits: Limits, reading: str) -> list[Graded | StoredRecord]:
    """The record of each, in order. It never raises."""
    items = [one if isinstance(one, StoredRecord) else _read(one, judge, limits, reading) for one in some]
    marks = _marked(judge, [one for one in items if isinstance(one, Read) and one.record.reason is None],
                    limits.seconds)  # fmt: skip
    records: list[Graded | StoredRecord] = []
    for one in items:
        if isinstance(one, StoredRecord):
            records.append(one)
            continue
        record, outcome = one.record, one.record.reason or next(marks)
        if isinstance(outcome, GraphkinError):
            prints = () if isinstance(outcome, _ONCE_MORE) else record.prints
            records.append(replace(record, reason=outcome, drawn={}, prints=prints))
        else:
            lines = {line.text for line in outcome.judged}
            # of all quantities the names of centres alone have no space
            centres = [text for text in (*one.work.numbers, *one.work.unread) if " " not in text and text not in lines]
            notes = [errors.CentresNotMarked(Where(record.file), tuple(centres))] if centres else []
            missing = any(line.points and line.verdict == "missing" for line in outcome.judged)
            # it may be what was passed over under a name that means nothing here
            passed = [note for note in record.notes if missing and isinstance(note, errors.NotAQuestion)]
            remarks = (*record.remarks, *passed, *judge.remarks(outcome))
            records.append(replace(record, marked=outcome, remarks=remarks, notes=(*record.notes, *notes)))
    return records


def _read(item: Handed | Read, judge: SetMarker, limits: Limits, reading: str) -> Read:
    if isinstance(item, Read):
        return _read_before(item, judge)
    one = read_one(item, judge, limits, judge.roster)
    prints = (item.digest, reading, asked_print(judge, one.student), judge.key_print(one.student))
    notes = (*one.notes, *(value.fault for value in one.values.values() if value.fault is not None))
    handed_in = {  # the reader has spoken of what is no number
        text: HandedNumber(value.value, value.fault is None, None, not value.text,
                           value.vector if value.text else None, value.within, worded=value.sense is not None)
        for text, value in one.values.items() if value.value is not None and math.isfinite(value.value)
    }  # fmt: skip
    unread = {text: tidy_id(value.text)[:_SHOWN] or "?" for text, value in one.values.items()
              if value.text and text not in handed_in}  # fmt: skip
    work, more, reason = StudentWork(one.student, handed_in, unread, one.board), list[GraphkinError](), one.reason
    try:
        with limited(limits.seconds, Where(one.file)):
            marker = _marker(judge, work) if one.drawings else None
            if marker is not None:
                fuller, said = work, list[GraphkinError]()
                for at in one.drawings:
                    fuller, new = _with_drawing(fuller, one, at, marker)
                    said += new
                work, more = _not_read(_doubtful(fuller, item.drawing, judge), one, marker), said
    except GraphkinError as problem:
        reason = problem
    except Exception as problem:
        reason = OwnFault(Where(one.file), type(problem).__name__)
    kept = () if isinstance(reason, _ONCE_MORE) else prints
    drawn = one.drawings[1].in_si() if 1 in one.drawings else {}
    remarks = [remark for drawing in one.drawings.values() for remark in drawing.remarks]
    remarks += [unsure for drawing in one.drawings.values() for unsure in drawing.unsure]
    remarks += [note for note in notes if isinstance(note, _LOOK)]
    every = (*notes, *more)
    board, measured = one.board, item.drawing
    record = Graded(one.student, one.file, one.place, None, reason, every, drawn, kept, (*remarks,), board, measured)
    return Read(work, record)


def _doubtful(work: StudentWork, drawing: MeasuredDrawing | None, judge: SetMarker) -> StudentWork:
    """With what hangs on points of a photograph that are not sure, each with its own standard deviation."""
    readable, marker = judge(work.student), _marker(judge, work)
    if drawing is None or readable is None or marker is None:
        return work
    from graphkin.submissions.drawings import lettered_vectors

    off, points, shapes = drawing.off, drawing.points, paper_polygons(readable)
    known = {at: place for at, place in points.items() if math.isfinite(off.get(at, 0.0))}

    def read(shift: Mapping[tuple[Plane, str], complex]) -> dict[str, float]:
        there = replace(drawing, points={at: place + shift.get(at, 0j) for at, place in known.items()})
        sizes = {text: abs(vector) for text, vector in lettered_vectors(there, shapes).items()}
        return sizes | dict(marker.off_drawing(there.in_si(), {}, {})[0].values)

    values, squares = read({}), dict[str, float]()
    for there in map(read, drawing.shifts):
        for text, value in values.items():
            squares[text] = squares.get(text, 0.0) + (there.get(text, math.inf) - value) ** 2
    new = {text: HandedNumber(values[text], measured=True, off=math.sqrt(square)) for text, square in squares.items()
           if 0 < square < math.inf and (text not in work.numbers or work.numbers[text].measured)}  # fmt: skip
    return replace(work, numbers={**work.numbers, **new})


def _not_read(work: StudentWork, one: Submission, marker: Marker) -> StudentWork:
    """With the error of photographs, and what is asked and was perhaps drawn, but cannot be measured surely."""
    error = max(drawing.error for drawing in one.drawings.values())
    asked = [entry.text for entry in marker.key.entries if entry.points]
    unsure = any(drawing.unsure for drawing in one.drawings.values())
    unread = {text: "?" for text in asked if unsure and text not in work.numbers and text not in work.unread}
    return replace(work, error=error, unread={**work.unread, **unread})


def _read_before(item: Read, judge: SetMarker) -> Read:
    record, student = item.record, item.work.student
    reason = record.reason
    try:
        if reason is None and judge.marker(student) is None:
            reason = errors.UnknownStudent(Where(record.file), student)
    except GraphkinError as problem:
        reason = problem
    prints = (*record.prints[:2], asked_print(judge, student), judge.key_print(student)) if record.prints else ()
    work = item.work if reason is not None else _doubtful(item.work, record.measured, judge)
    return Read(work, replace(record, reason=reason, prints=prints))


def asked_print(judge: SetMarker, student: str) -> str:
    """A fingerprint of what a student is asked: by the same, work is read alike. Empty where there is no key."""
    try:
        marker = judge.marker(student)
    except GraphkinError:
        marker = None
    if marker is None:
        return ""
    return fingerprint(*(text for key in marker.key.positions for text in (key.text, *(e.text for e in key.entries))))


# --- drawings: what they determine beside the vectors that are measured on them ---------------------------------------


def _with_drawing(
    work: StudentWork, one: Submission, at: int, marker: Marker
) -> tuple[StudentWork, list[GraphkinError]]:
    """With rotations and the like that are asked for and stand nowhere in numbers, and the senses of known arrows, by
    the drawing of one position; with notes that say so."""
    here = {text: position_of(text)[0] for text in (*one.values, *work.numbers) if position_of(text)[1] == at}
    vectors = {here[text]: v.vector for text, v in one.values.items() if text in here and v.vector is not None}
    numbers = {here[text]: number.value for text, number in work.numbers.items() if text in here}
    readings, points = marker.positions[at - 1].off_drawing(one.drawings[at].in_si(), vectors, numbers)
    values = {at_position(text, at): value for text, value in readings.values.items()}
    new = {text: HandedNumber(value, measured=True) for text, value in values.items() if text not in work.numbers}
    pointing = ((at_position(bare, at), good) for bare, good in points.items())
    senses = {text: replace(work.numbers[text], points=good) for text, good in pointing if text in work.numbers}
    lost = tuple(text for bare in readings.no_sense if (text := at_position(bare, at)) not in work.numbers)
    where = one.drawings[at].where
    notes: list[GraphkinError] = [errors.OffTheDrawing(where, tuple(new))] if new else []
    notes += [errors.NoSenseDrawn(where, lost)] if lost else []
    return replace(work, numbers={**work.numbers, **new, **senses}), notes


def _marker(judge: SetMarker, work: StudentWork) -> Marker | None:
    marker = judge.marker(work.student)
    return marker if marker is None or work.board is None else marker.of_board


def _marked(judge: SetMarker, batch: Sequence[Read], seconds: float) -> Iterator[Marked | GraphkinError]:
    """In their order; those in a row who have one key are marked at once."""
    for marker, some in groupby(batch, lambda one: _marker(judge, one.work)):
        assert marker is not None, "who is not of the class was refused before"
        alike = list(some)
        try:
            with limited(seconds + _EACH * (len(alike) - 1), Where(alike[0].record.file)):
                marks: list[Marked | GraphkinError] = [*marker.mark([one.work for one in alike])]
        except Exception as problem:
            if len(alike) > 1:
                # one by one, each within its time: an error of ours or a hostile submission is one student's row
                marks = [each for one in alike for each in _marked(judge, [one], seconds)]
            elif isinstance(problem, GraphkinError):
                marks = [problem]
            else:
                marks = [OwnFault(Where(alike[0].record.file), type(problem).__name__)]
        yield from marks
