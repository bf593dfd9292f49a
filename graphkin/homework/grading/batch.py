"""A batch of submissions read and marked at once: what a worker does. It never raises."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import groupby

from graphkin.base.value import frozen
from graphkin.errors import GraphkinError, OwnFault, TookTooLong, UnknownStudent, Unreadable, WantsExtra, Where
from graphkin.homework.grading.again import Again
from graphkin.homework.grading.drawn import with_drawings
from graphkin.homework.grading.sets import OneKey, SetMarker, fingerprint
from graphkin.marking.marker import Marker
from graphkin.marking.records import Drawn, Graded, HandedNumber, Marked, StudentWork
from graphkin.submissions import Handed, Limits, Submission, limited, read_one

_EACH = 0.1
"""A batch is marked at once in the time of one submission and so much more for each [s]."""
_ONCE_MORE = (OwnFault, TookTooLong, Unreadable, WantsExtra)
"""Reasons that may be gone when it is tried again."""


@frozen
class StoredRecord:
    """A submission whose record there is and holds: whose it is, whether it was marked, and its fingerprint."""

    student: str
    file: str
    place: str
    marked: bool
    handed: str


Item = Handed | Again | StoredRecord


def marked(some: list[Item], judge: SetMarker, limits: Limits, reading: str) -> list[Graded | StoredRecord]:
    """What becomes of each, in order."""
    read = [one if isinstance(one, StoredRecord) else _read(one, judge, limits, reading) for one in some]
    marks = _marked(judge, [one for one in read if isinstance(one, Read) and one.reason is None], limits.seconds)
    return [one if isinstance(one, StoredRecord) else _graded(one, one.reason or next(marks)) for one in read]


@frozen
class Read:
    """A submission that is ready to be marked, or why it is not."""

    work: StudentWork
    file: str
    place: str
    reason: GraphkinError | None
    notes: tuple[GraphkinError, ...]
    prints: tuple[str, ...]
    drawn: Drawn


def _read(item: Handed | Again, judge: SetMarker, limits: Limits, reading: str) -> Read:
    if isinstance(item, Again):
        return _again(item, judge)
    asked = judge.asked if isinstance(judge, OneKey) else judge
    one = read_one(item, asked, limits)
    prints = (item.digest[:16], reading, asked_print(judge, one.student), judge.key_print(one.student))
    notes = (*one.notes, *(given.fault for given in one.values.values() if given.fault is not None))
    work, more, reason = _work(one), list[GraphkinError](), one.reason
    try:
        with limited(limits.seconds, Where(one.file)):
            work, more = with_drawings(work, one, judge)
    except GraphkinError as problem:
        reason = problem
    except Exception as problem:
        reason = OwnFault(Where(one.file), type(problem).__name__)
    again = isinstance(reason, _ONCE_MORE)
    drawn = {} if one.drawn is None else one.drawn.in_si()
    return Read(work, one.file, one.place, reason, (*notes, *more), () if again else prints, drawn)


def _again(item: Again, judge: SetMarker) -> Read:
    """As it was read then."""
    reason: GraphkinError | None = item.reason
    try:
        if reason is None and judge.marker(item.student) is None:
            reason = UnknownStudent(Where(item.file), item.student)
    except GraphkinError as problem:
        reason = problem
    prints = (*item.prints[:2], asked_print(judge, item.student), judge.key_print(item.student)) if item.prints else ()
    return Read(item.work, item.file, item.place, reason, item.notes, prints, item.drawn)


def asked_print(judge: SetMarker, student: str) -> str:
    """A fingerprint of what a student is asked: by the same, work is read alike. Empty where there is no key."""
    try:
        marker = judge.marker(student)
    except GraphkinError:
        marker = None
    if marker is None:
        return ""
    return fingerprint(*(text for key in marker.key.positions for text in (key.text, *(e.text for e in key.entries))))


def _work(submission: Submission) -> StudentWork:
    """The numbers of a submission; what is no number was said by the reader."""
    return StudentWork(
        submission.student,
        {
            text: HandedNumber(given.value, given.fault is None, measured=given.ends is not None and not given.text)
            for text, given in submission.values.items()
            if given.value is not None and math.isfinite(given.value)
        },
    )


def _graded(one: Read, marks: Marked | GraphkinError) -> Graded:
    student, file, place = one.work.student, one.file, one.place
    if isinstance(marks, GraphkinError):
        prints = () if isinstance(marks, _ONCE_MORE) else one.prints
        return Graded(student, file, place, None, marks, one.notes, prints=prints)
    return Graded(student, file, place, marks, None, one.notes, one.drawn, one.prints)


# --- marking ----------------------------------------------------------------------------------


def _marked(judge: SetMarker, batch: Sequence[Read], seconds: float) -> Iterator[Marked | GraphkinError]:
    """In their order; those in a row who have one key are marked at once."""
    for marker, some in groupby(batch, lambda one: judge.marker(one.work.student)):
        assert marker is not None, "who is not of the class was refused before"
        yield from _marks(marker, list(some), seconds)


def _marks(marker: Marker, batch: Sequence[Read], seconds: float) -> list[Marked | GraphkinError]:
    """All at once; one by one, each within its time, where that fails or takes long, so that an error of ours or a
    hostile submission is one student's row."""
    try:
        with limited(seconds + _EACH * len(batch), Where(batch[0].file)):
            return list(marker.mark([one.work for one in batch]))
    except Exception:
        return [_alone(marker, one, seconds) for one in batch]


def _alone(marker: Marker, one: Read, seconds: float) -> Marked | GraphkinError:
    try:
        with limited(seconds, Where(one.file)):
            return marker.mark([one.work])[0]
    except GraphkinError as problem:
        return problem
    except Exception as problem:
        return OwnFault(Where(one.file), type(problem).__name__)
