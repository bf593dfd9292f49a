"""Each student's own numbers, drawn from a seed and the student's id: the same again whenever and in whatever order.

Only when two students would get the same problem does the list of students matter, and its order never.
"""

from __future__ import annotations

import hashlib
from collections import Counter
from collections.abc import Sequence

import numpy as np

from graphkin.errors import GraphkinError, NoVariant, Where
from graphkin.mechanism import Mechanism
from graphkin.problems.posed import Refused, answers, well_posed
from graphkin.problems.roster import Student
from graphkin.problems.template import Template
from graphkin.value import frozen

_TRIES = 200
_HOPELESS = 20
"""Where so many draws do not assemble, and no other did better, the template is wrong."""
_APART = 60
"""So many draws look for numbers that no other student has; then well-posed is enough."""
_DISTINCT = 0.02
"""Two problems whose answers all differ by a smaller part are like each other."""


@frozen
class Variant:
    """One student's problem.

    numbers  of the value of each range
    shared   whether another student has the same, or nearly
    """

    student: Student
    numbers: tuple[int, ...]
    mechanism: Mechanism
    shared: bool = False


def variants(template: Template, students: Sequence[Student], seed: str) -> tuple[Variant, ...]:
    """In the order of the students. Raises NoVariant, and what is wrong with the template itself."""
    turns = sorted(students, key=lambda student: hashlib.sha256(_bytes(seed, student.id)).digest())
    taken = _Taken()
    drawn = {student.id: _drawn(template, student, seed, taken) for student in turns}
    return tuple(drawn[student.id] for student in students)


def _drawn(template: Template, student: Student, seed: str, taken: _Taken) -> Variant:
    refused: Counter[Refused] = Counter()
    for attempt in range(_TRIES):
        numbers = _numbers(template, student.id, seed, attempt)
        try:
            mechanism = template.mechanism(numbers)
            found = well_posed(mechanism)
        except GraphkinError:
            refused["assembly"] += 1
            if attempt + 1 == refused["assembly"] == _HOPELESS:
                raise
            continue
        if isinstance(found, str):
            refused[found] += 1
            continue
        there = taken.has(numbers, answers(found))
        if there and attempt < _APART:
            refused["taken"] += 1
            continue
        taken.add(numbers, answers(found))
        return Variant(student, numbers, mechanism, there)
    raise NoVariant(Where(template.file), student.id[:60], _TRIES, tuple(refused.most_common()))


def _numbers(template: Template, student: str, seed: str, attempt: int) -> tuple[int, ...]:
    """Of each range by its place in the file, so that a range added elsewhere changes none of the others."""
    digests = (hashlib.sha256(_bytes(seed, student, str(attempt), each.name)).digest() for each in template.ranges)
    return tuple(
        int.from_bytes(digest[:8], "big") % each.count for digest, each in zip(digests, template.ranges, strict=True)
    )


def _bytes(*parts: str) -> bytes:
    return "\0".join(parts).encode("utf-8", "surrogatepass")


class _Taken:
    """What other students have: their numbers and their answers."""

    def __init__(self) -> None:
        self.numbers: set[tuple[int, ...]] = set()
        self.answers: list[np.ndarray] = []

    def has(self, numbers: tuple[int, ...], found: np.ndarray) -> bool:
        if numbers in self.numbers:
            return True
        if not self.answers or not found.size:
            return False
        others = np.array(self.answers[-2000:])
        size = np.maximum(np.abs(others), np.abs(found))
        return bool(np.any(np.all(np.abs(others - found) <= _DISTINCT * size, axis=1)))

    def add(self, numbers: tuple[int, ...], found: np.ndarray) -> None:
        self.numbers.add(numbers)
        self.answers.append(found)
