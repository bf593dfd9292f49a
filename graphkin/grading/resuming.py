"""A marking that goes on from what there is: nothing is marked twice.

A record holds as long as what was handed in, the way it was read, and the key are the same. Where only the key is
another, and asks the same, the numbers that were read then are marked anew; all else is read.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from graphkin.errors import NoMarks
from graphkin.grading.again import Again, again
from graphkin.grading.batch import Item, Kept, asked_print
from graphkin.grading.journal import Journal
from graphkin.grading.running import Way, items, run
from graphkin.grading.sets import Judge
from graphkin.marking.graded import Graded
from graphkin.submissions import Handed


def resumed(
    judge: Judge, paths: Iterable[str | Path], journal: Journal, way: Way,
    written: Callable[[Graded], Mapping[str, Any]],
) -> Iterator[Mapping[str, Any]]:  # fmt: skip
    """The record of every submission, in order; what is new is in the journal before it is given out.

    written   makes the record of one, as `outputs.marks_json` does in a language, which `way.words` names
    """
    paths = [*paths]
    known = (_known(item, judge, journal, way) for item in items(paths, way))
    for one in run(judge, known, way, paths):
        if isinstance(one, Kept):
            kept = journal.read(one.at)
            assert kept is not None, "it was read before"
            yield kept
            continue
        new = written(one)
        if one.prints:
            journal.add(new)
        yield new


def _known(item: Handed | Again, judge: Judge, journal: Journal, way: Way) -> Item:
    """What is still to be done for a submission."""
    handed, reading = (item.digest[:16], way.reading) if isinstance(item, Handed) else item.prints[:2] or ("", "")
    at = journal.find(handed) if handed else None
    there = None if at is None else journal.read(at)
    if at is None or there is None:
        return item
    try:
        before = again(there, journal.where(at))
    except NoMarks:
        return item
    if before.prints[:2] != (handed, reading) or len(before.prints) != len(("handed", "reading", "asked", "key")):
        return item
    student = before.student
    if before.prints[3] == judge.key_print(student):
        return Kept(student, before.file, before.place, before.reason is None, at)
    same = isinstance(item, Handed) and before.reason is None and before.prints[2] == asked_print(judge, student)
    return before if same else item
