"""Submissions marked batch by batch, here or by workers: memory stays flat, and one that fails stops no other."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from concurrent.futures import Executor
from functools import partial
from itertools import chain
from pathlib import Path

import graphkin
from graphkin.base.parallel import ahead
from graphkin.base.value import frozen
from graphkin.errors import OwnFault, Where
from graphkin.homework.grading.again import Again, is_marks, records_of
from graphkin.homework.grading.batch import Item, StoredRecord, marked
from graphkin.homework.grading.sets import OneKey, SetMarker, fingerprint
from graphkin.marking.key import Key
from graphkin.marking.marker import Marker
from graphkin.marking.records import Graded
from graphkin.submissions import FirstOnes, Handed, Limits, called, guarded, handed_in

_BATCH, _BYTES = 64, 4 << 20
"""Submissions, and bytes of them, that are marked at once; a single one may be larger."""
_AHEAD = 8


@frozen
class Way:
    """How a marking is done.

    limits    what is looked at of a submission
    workers   processes that read and mark, each submission within its time; 0: this one
    executor  does it instead, any of `concurrent.futures` or a cluster's; its workers must be able to import graphkin,
              and to reach the keys of a set
    words     what the records that are written hang on beside: their language
    """

    limits: Limits = Limits()
    workers: int = 0
    executor: Executor | None = None
    words: str = ""

    @property
    def reading(self) -> str:
        """A fingerprint of how submissions are read."""
        return fingerprint(repr(self.limits), self.words, graphkin.__version__)


def grade(
    judge: Key | SetMarker, paths: Iterable[str | Path], limits: Limits | None = None, *, workers: int = 0,
    executor: Executor | None = None,
) -> Iterator[Graded]:  # fmt: skip
    """A record for every submission in these files, in order.

    judge   one key for all, or each student's own
    paths   answers, drawings, class tables, archives, folders; or files of marks, whose numbers are marked anew
    workers, executor   who reads and marks them, as in `Way`

    A submission that cannot be read or marked is a record with its reason; so is a second one of a student. Raises
    NoMarks, Unreadable of a file of marks.
    """
    judge = OneKey(Marker(judge)) if isinstance(judge, Key) else judge
    way = Way(limits or Limits(), workers, executor)
    paths = [*paths]
    for graded in run(judge, items(paths, way), way, paths):
        assert isinstance(graded, Graded)
        yield graded


def items(paths: Iterable[str | Path], way: Way) -> Iterator[Handed | Again]:
    """What is to be marked, one after another, in the order of the files."""
    for path in paths:
        if is_marks(path):
            yield from records_of(Path(path))
        else:
            yield from handed_in([path], way.limits)


def run(
    judge: SetMarker, some: Iterable[Item], way: Way, paths: Iterable[str | Path]
) -> Iterator[Graded | StoredRecord]:
    """The result of each, in order; what is kept goes through as it is. `paths`: of all that was handed in."""
    work = partial(marked, judge=judge, limits=way.limits, reading=way.reading)
    if way.executor is not None:
        return firsts(ahead(way.executor, work, _batches(some, _BATCH), _AHEAD), paths)
    if way.workers:
        seconds = way.limits.seconds
        return firsts(guarded(work, _batches(some, _BATCH), way.workers, seconds, _failed), paths)
    return firsts(chain.from_iterable(map(work, _batches(some, _BATCH))), paths)


def firsts(found: Iterable[Graded | StoredRecord], paths: Iterable[str | Path]) -> Iterator[Graded | StoredRecord]:
    """Of each student the first that was marked; a further one says so."""
    seen = FirstOnes(paths)
    for one in found:
        if not one.marked:
            yield one
            continue
        reason = seen.reason(one.student, one.file, one.place)
        yield one if reason is None else Graded(called(one.student, reason), one.file, one.place, None, reason)


def _failed(item: Item, problem: str) -> Graded | StoredRecord:
    if isinstance(item, StoredRecord):
        return item
    student = item.student if isinstance(item, Again) else item.owner.student
    return Graded(student, item.file, item.place, None, OwnFault(Where(item.file), problem))


def _batches(some: Iterable[Item], size: int) -> Iterator[list[Item]]:
    """So many at once, and not too many bytes of them."""
    batch: list[Item] = []
    held = 0
    for item in some:
        batch.append(item)
        held += sum(len(content) for _, content in item.files) if isinstance(item, Handed) else 0
        if len(batch) >= size or held >= _BYTES:
            yield batch
            batch, held = [], 0
    if batch:
        yield batch
