"""A drawing board for each student of a set of problems."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from concurrent.futures import Executor
from functools import partial
from itertools import chain
from pathlib import Path

from graphkin.base.worklist import ahead
from graphkin.handouts.problem_folder import SetOrder
from graphkin.homework.problems import Variant
from graphkin.outputs.files import refuse
from graphkin.page.board import board_page
from graphkin.page.writer import MARK, write

_AT_ONCE = 8  # pages that are being written

_Numbered = tuple[int, Variant]


def write_boards(order: SetOrder, variants: Sequence[Variant], executor: Executor | None = None) -> Iterator[Path]:
    """The pages, beside the students' problems, as they are written; raises FileInTheWay before the first, CannotWrite.
    A page knows its student by id, as the set's key does."""
    for variant in variants:
        if (path := order.board(variant.student)).exists():
            refuse(path, order.force, (MARK.encode(),))
    work, each = partial(_written, order), ([one] for one in enumerate(variants, 1))
    yield from chain.from_iterable(map(work, each)) if executor is None else ahead(executor, work, each, _AT_ONCE)


def _written(order: SetOrder, some: Sequence[_Numbered]) -> list[Path]:
    paths = []
    for number, variant in some:
        student, path = variant.student, order.board(variant.student)
        write(path, board_page(variant.mechanism, order.lang, student.id, order.template.name, number), order.force)
        paths.append(path)
    return paths
