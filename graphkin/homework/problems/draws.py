"""Each student's own numbers, drawn from a seed and the student's id: the same again whenever and in whatever order.

Only when two students would get the same problem does the list of students matter, and its order never.
"""

from __future__ import annotations

import hashlib
from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import islice

import numpy as np

from graphkin.base.value import frozen
from graphkin.errors import GraphkinError, NoVariant, Where
from graphkin.homework.problems.paper import DrawingSizes
from graphkin.homework.problems.posed import PosedProblem, Refused, answers, well_posed
from graphkin.homework.problems.roster import Student
from graphkin.homework.problems.template import Template
from graphkin.marking.discriminability import LOOKED_AT, Always, Discriminability, MistakeVisibility, mistake_visibility
from graphkin.model.mechanism import Mechanism
from graphkin.running.assembled import DrawnSides, assembled

_TRIES = 200
_HOPELESS = 20
"""Where so many draws do not assemble, and no other did better, the template is wrong."""
_APART = 60
"""So many draws look for numbers that no other student has; then well-posed is enough."""
_DISTINCT = 0.02
"""Two problems whose answers all differ by a smaller part, or by less than paper allows, are like each other."""
_FAILS = 0.02
"""Where more of the drawings with a pencil do not close, a dead point is too near."""
_SAMPLE, _SAMPLE_TRIES = 9, 60
"""So many problems show how well mistakes can be told apart in a template; of so many draws at most."""


@frozen
class Variant:
    """One student's problem.

    numbers  of the value of each range
    drawn    in which assembly
    told     what its answers tell of mistakes
    shared   whether another student has the same, or nearly
    """

    student: Student
    numbers: tuple[int, ...]
    mechanism: Mechanism
    drawn: DrawnSides
    told: Discriminability
    shared: bool = False


def variants(template: Template, students: Sequence[Student], seed: str) -> tuple[Variant, ...]:
    """In the order of the students. Raises NoVariant, and what is wrong with the template itself."""
    turns = sorted(students, key=lambda student: hashlib.sha256(_bytes(seed, student.id)).digest())
    taken, goal = _Taken(), _Goal.of(template, seed)
    drawn = {student.id: _drawn(template, student, seed, taken, goal) for student in turns}
    return tuple(drawn[student.id] for student in students)


def _drawn(template: Template, student: Student, seed: str, taken: _Taken, goal: _Goal) -> Variant:
    refused: Counter[Refused] = Counter()
    good: list[tuple[Variant, _Answers]] = []
    for attempt in range(_TRIES):
        numbers = _numbers(template, student.id, seed, attempt)
        if attempt < _APART and numbers in taken.numbers:
            refused["taken"] += 1
            continue
        if numbers in taken.refused:
            refused[taken.refused[numbers]] += 1
            continue
        try:
            mechanism = template.mechanism(numbers)
            found = well_posed(mechanism)
        except GraphkinError:
            refused["assembly"] += 1
            if attempt + 1 == refused["assembly"] == _HOPELESS:
                raise
            continue
        if isinstance(found, str) or (tells := goal.telling(found)).failed > _FAILS:
            taken.refused[numbers] = found if isinstance(found, str) else "dead point"
            refused[taken.refused[numbers]] += 1
            continue
        own = _Answers(answers(found), tells.right, tells.tolerance)
        there = taken.has(numbers, own)
        if there and attempt < _APART:
            refused["taken"] += 1
            continue
        seen = assembled(found.method, found.drawn)
        good.append((Variant(student, numbers, mechanism, seen, goal.always.told(tells), there), own))
        if there or len(good) == LOOKED_AT or good[-1][0].told.lost <= goal.lost:
            break
    if not good:
        raise NoVariant(Where(template.file), student.id[:60], _TRIES, tuple(refused.most_common()))
    best, own = min(good, key=lambda one: (one[0].shared, one[0].told.lost))
    taken.add(best.numbers, own)
    return best


@frozen
class _Goal:
    """What a template can do: its paper, mistakes that are always the same, how many its better problems lose."""

    paper: DrawingSizes
    always: Always
    lost: int

    @classmethod
    def of(cls, template: Template, seed: str) -> _Goal:
        """By problems that are nobody's."""
        some = list(islice(_sample(template, seed), _SAMPLE))
        paper = DrawingSizes.of(some)
        found = [mistake_visibility(one.method, one.drawn, paper.marking(one)) for one in some]
        always = Always(found)
        lost = sorted(always.told(one).lost for one in found)
        return cls(paper, always, lost[(len(lost) - 1) // 3] if lost else 0)

    def telling(self, posed: PosedProblem) -> MistakeVisibility:
        """What the answers at the drawn position tell."""
        return mistake_visibility(posed.method, posed.drawn, self.paper.marking(posed))


def _sample(template: Template, seed: str) -> Iterator[PosedProblem]:
    for attempt in range(_SAMPLE_TRIES):
        try:
            posed = well_posed(template.mechanism(_numbers(template, "", seed, attempt)))
        except GraphkinError:
            continue
        if not isinstance(posed, str):
            yield posed


def _numbers(template: Template, student: str, seed: str, attempt: int) -> tuple[int, ...]:
    """Of each range by its place in the file, so that a range added elsewhere changes none of the others."""
    digests = (hashlib.sha256(_bytes(seed, student, str(attempt), each.name)).digest() for each in template.ranges)
    return tuple(
        int.from_bytes(digest[:8], "big") % each.count for digest, each in zip(digests, template.ranges, strict=True)
    )


def _bytes(*parts: str) -> bytes:
    return "\0".join(parts).encode("utf-8", "surrogatepass")


@frozen
class _Answers:
    """The answers of one problem at all positions, and those at the drawn one with what paper allows of them."""

    all: np.ndarray
    right: np.ndarray
    tolerance: np.ndarray


class _Taken:
    """Numbers and answers that other students have; and numbers that are no good problem, each with why."""

    def __init__(self) -> None:
        self.refused: dict[tuple[int, ...], Refused] = {}
        self.numbers: set[tuple[int, ...]] = set()
        self.answers: list[_Answers] = []

    def has(self, numbers: tuple[int, ...], own: _Answers) -> bool:
        if numbers in self.numbers:
            return True
        if not self.answers or not own.all.size:
            return False
        last = self.answers[-2000:]
        return _alike(np.array([one.all for one in last]), own.all, _DISTINCT, 0.0) or (
            own.right.size > 0 and _alike(np.array([one.right for one in last]), own.right, 0.0, own.tolerance)
        )

    def add(self, numbers: tuple[int, ...], own: _Answers) -> None:
        self.numbers.add(numbers)
        self.answers.append(own)


def _alike(others: np.ndarray, own: np.ndarray, part: float, off: np.ndarray | float) -> bool:
    """Whether the answers (n,) are all as another problem's (problems, n), but for a part of them or so much."""
    reach = np.maximum(part * np.maximum(np.abs(others), np.abs(own)), off)
    return bool(np.any(np.all(np.abs(others - own) <= reach, axis=1)))
