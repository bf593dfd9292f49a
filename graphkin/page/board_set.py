"""Problem sets as programs write them, in the words of `graphkin problems`; a drawing board for each student."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from concurrent.futures import Executor
from contextlib import nullcontext
from functools import partial
from itertools import chain
from pathlib import Path

from graphkin.base.worklist import ahead
from graphkin.errors import Lang
from graphkin.handouts.problem_folder import SetOrder, file_of, problem_set, write_problems
from graphkin.homework import kinds_of
from graphkin.homework.grading import judge_from, pencils_of
from graphkin.homework.platforms.set_formats import SETS, write_set
from graphkin.homework.problems import Variant, read_template, roster
from graphkin.outputs.files import refuse
from graphkin.page.board import board_page
from graphkin.page.writer import MARK, write
from graphkin.submissions import worker_pool

BOARD = "board"  # among the formats of sets
_AT_ONCE = 8  # pages that are being written

_Numbered = tuple[int, Variant]


def problems(
    template: str | Path, students: str | int | Path, output: str | Path, *, seed: str = "1",
    formats: str | Sequence[str] = (), lang: Lang = "en", pencil: str | Sequence[float] | None = None, jobs: int = 0,
    force: bool = False,
) -> list[Variant]:  # fmt: skip
    """Write a problem for each student into a folder, as `graphkin problems` does; students: a roster, or how many;
    formats: "board", "moodle", .., as `--format` has them."""
    kinds = kinds_of(formats, (BOARD, *SETS))
    order = SetOrder(
        Path(output), read_template(Path(template)), roster(str(students)), seed, lang, pencils_of(pencil), force
    )
    with worker_pool(jobs) if jobs > 1 else nullcontext() as executor:
        variants = [one for one in write_problems(order, executor) if isinstance(one, Variant)]
        for _ in further_files(order, variants, kinds, executor):
            pass
    return variants


def further_files(
    order: SetOrder, variants: Sequence[Variant], kinds: Sequence[str], executor: Executor | None = None
) -> Iterator[Path]:
    """A set's boards, then the whole set for each platform: the files as they are written."""
    if BOARD in kinds:
        yield from write_boards(order, variants, executor)
    if platforms := [kind for kind in dict.fromkeys(kinds) if kind != BOARD]:
        whole = problem_set(order.template, variants, judge_from(str(order.folder)), order.lang)
        for kind in platforms:
            write_set(path := file_of(order.folder, kind), whole, kind, order.lang, order.force)
            yield path


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
