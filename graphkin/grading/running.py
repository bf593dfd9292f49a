"""Submissions marked one batch after another: memory stays flat, and one that fails stops no other."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import islice
from pathlib import Path

from graphkin.errors import GraphkinError, OwnFault, Where
from graphkin.marking.graded import Graded
from graphkin.marking.key import Key
from graphkin.marking.marked import Marked, Number, Work
from graphkin.marking.marker import Marker
from graphkin.submissions import Asked, Limits, Submission, read

__all__ = ["grade"]

_BATCH = 256
"""Submissions that are marked at once."""


def grade(
    key: Key, paths: Iterable[str | Path], limits: Limits | None = None, *, workers: int = 0
) -> Iterator[Graded]:
    """A record for every submission in these files, in order.

    workers  processes that read them; 0: this one. A submission that cannot be read or marked is a record with its
             reason.
    """
    marker = Marker(key)
    asked = Asked(marker.method.mechanism, tuple(entry.text for entry in key.entries))
    submissions = read(paths, asked, limits or Limits(), workers=workers)
    while batch := list(islice(submissions, _BATCH)):
        yield from _graded(marker, batch)


def _graded(marker: Marker, batch: Sequence[Submission]) -> Iterator[Graded]:
    good = [submission for submission in batch if submission.reason is None]
    marks = iter(_marks(marker, good))
    for one in batch:
        marked = one.reason or next(marks)
        notes = (*one.notes, *(given.fault for given in one.values.values() if given.fault is not None))
        if isinstance(marked, GraphkinError):
            yield Graded(one.student, one.file, one.place, None, marked, notes)
        else:
            yield Graded(one.student, one.file, one.place, marked, None, notes)


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
