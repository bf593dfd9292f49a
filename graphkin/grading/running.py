"""Submissions marked one batch after another: memory stays flat, and one that fails stops no other."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby, islice
from pathlib import Path

from graphkin.errors import GraphkinError, OwnFault, Where
from graphkin.grading.sets import Judge, OneKey
from graphkin.marking.graded import Graded
from graphkin.marking.key import Key
from graphkin.marking.marked import Marked, Number, Work
from graphkin.marking.marker import Marker
from graphkin.submissions import Limits, Submission, read

_BATCH = 256
"""Submissions that are marked at once."""


def grade(
    judge: Key | Judge, paths: Iterable[str | Path], limits: Limits | None = None, *, workers: int = 0
) -> Iterator[Graded]:
    """A record for every submission in these files, in order.

    judge    one key for all, or each student's own
    workers  processes that read them; 0: this one. A submission that cannot be read or marked is a record with its
             reason.
    """
    judge = OneKey(Marker(judge)) if isinstance(judge, Key) else judge
    asked = judge("") if isinstance(judge, OneKey) else judge
    assert asked is not None
    submissions = read(paths, asked, limits or Limits(), workers=workers)
    while batch := list(islice(submissions, _BATCH)):
        yield from _graded(judge, batch)


def _graded(judge: Judge, batch: Sequence[Submission]) -> Iterator[Graded]:
    marks = _marked(judge, [submission for submission in batch if submission.reason is None])
    for one in batch:
        marked = one.reason or next(marks)
        notes = (*one.notes, *(given.fault for given in one.values.values() if given.fault is not None))
        if isinstance(marked, GraphkinError):
            yield Graded(one.student, one.file, one.place, None, marked, notes)
        else:
            drawn = {} if one.drawn is None else one.drawn.in_si()
            yield Graded(one.student, one.file, one.place, marked, None, notes, drawn)


def _marked(judge: Judge, batch: Sequence[Submission]) -> Iterator[Marked | GraphkinError]:
    """In their order; those in a row who have one key are marked at once."""
    for marker, some in groupby(batch, lambda one: judge.marker(one.student)):
        assert marker is not None, "who is not of the class was refused before"
        yield from _marks(marker, list(some))


def _marks(marker: Marker, batch: Sequence[Submission]) -> list[Marked | GraphkinError]:
    """All at once; one by one where that fails, so that an error of ours is one student's row."""
    works = [_work(one) for one in batch]
    try:
        return list(marker.mark(works)) if works else []
    except Exception:
        return [_alone(marker, work, one) for work, one in zip(works, batch, strict=True)]


def _alone(marker: Marker, work: Work, submission: Submission) -> Marked | GraphkinError:
    try:
        return marker.mark([work])[0]
    except GraphkinError as problem:
        return problem
    except Exception as problem:
        return OwnFault(Where(submission.file), type(problem).__name__)


def _work(submission: Submission) -> Work:
    """The numbers of a submission; what is no number was said by the reader."""
    return Work(
        submission.student,
        {
            text: Number(given.value, given.fault is None)
            for text, given in submission.values.items()
            if given.value is not None and math.isfinite(given.value)
        },
    )
