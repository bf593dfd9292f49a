"""Each student's own numbers, drawn from a seed and the student's id: the same again whenever and in whatever order.

Only when two students would get the same problem does the list of students matter, and its order never.
"""

from __future__ import annotations

import contextlib
import hashlib
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from itertools import islice

import numpy as np

from graphkin.base.geometry import Array
from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.errors import GraphkinError, NoVariant, Where
from graphkin.homework.grading.keys import KEYS, marking_of
from graphkin.homework.problems.posed import PosedProblem, Refused, answers, well_posed
from graphkin.homework.problems.roster import Student
from graphkin.homework.problems.template import Template
from graphkin.marking.discriminability import LOOKED_AT, Always, Discriminability, MistakeVisibility, mistake_visibility
from graphkin.marking.key import Marking
from graphkin.model.mechanism import Mechanism
from graphkin.running.drawn_sides import DrawnSides, drawn_sides

_TRIES = 200
_HOPELESS = 20  # where so many draws do not assemble, and no other did better, the template is wrong
_APART = 60  # so many draws look for numbers that no other student has; then well-posed is enough
_DISTINCT = 0.02
"""Two problems whose answers all differ by a smaller part, or by less than paper allows, are like each other."""
_FAILS = 0.02  # where more of the drawings with a pencil do not close, a dead point is too near
_SAMPLE, _SAMPLE_TRIES = 9, 60
"""So many problems show how well mistakes can be told apart in a template; of so many draws at most."""
_LAID_OUT = 3  # so many sheets of the sample are laid out, for the usual size of a drawing


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
    order = sorted(students, key=lambda student: hashlib.sha256(_bytes(seed, student.id)).digest())
    others, goal = _GivenOut(), _Goal.of(template, seed)
    own = {student.id: _variant(template, student, seed, others, goal) for student in order}
    return tuple(own[student.id] for student in students)


def _variant(template: Template, student: Student, seed: str, others: _GivenOut, goal: _Goal) -> Variant:
    """The student's draw that is unlike the others' and hides the fewest mistakes."""
    refused: Counter[Refused] = Counter()
    good: list[tuple[Variant, _ProblemAnswers]] = []
    for attempt in range(_TRIES):
        numbers = _numbers(template, student.id, seed, attempt)
        draw = _posed(template, student, numbers, others, goal, attempt < _APART)
        if isinstance(draw, str):
            refused[draw] += 1
            if draw == "assembly" and attempt + 1 == refused[draw] == _HOPELESS:
                well_posed(template.mechanism(numbers))  # raises what is wrong with the template
            continue
        good.append(draw)
        if draw[0].shared or len(good) == LOOKED_AT or draw[0].told.lost <= goal.lost:
            break
    if not good:
        raise NoVariant(Where(template.file), student.id[:60], _TRIES, tuple(refused.most_common()))
    best, own = min(good, key=lambda pair: (pair[0].shared, pair[0].told.lost))
    others.numbers.add(best.numbers)
    others.answers.append(own)
    return best


def _posed(
    template: Template, student: Student, numbers: tuple[int, ...], others: _GivenOut, goal: _Goal, apart: bool
) -> tuple[Variant, _ProblemAnswers] | Refused:
    """The problem with these numbers, or what is against it; apart: no other student may have it."""
    if apart and numbers in others.numbers:
        return "taken"
    if numbers in others.refused:
        return others.refused[numbers]
    try:
        mechanism = template.mechanism(numbers)
        posed = well_posed(mechanism)
    except GraphkinError:
        return "assembly"
    if isinstance(posed, str) or (tells := goal.visibility(posed)).failed > _FAILS:
        others.refused[numbers] = posed if isinstance(posed, str) else "dead point"
        return others.refused[numbers]
    own = _ProblemAnswers(answers(posed), tells.right, tells.tolerance)
    shared = others.have(numbers, own)
    if shared and apart:
        return "taken"
    sides = drawn_sides(posed.method, posed.drawn)
    return Variant(student, numbers, mechanism, sides, goal.always.told(tells), shared), own


@frozen
class _Goal:
    """The best a template can do: its paper, mistakes that are always the same, how many its better problems lose."""

    paper: DrawingSizes
    always: Always
    lost: int

    @classmethod
    def of(cls, template: Template, seed: str) -> _Goal:
        """By problems that are nobody's."""
        sample = list(islice(_sample(template, seed), _SAMPLE))
        paper = DrawingSizes.of(sample)
        tellings = [mistake_visibility(one.method, one.drawn, paper.marking(one)) for one in sample]
        always = Always(tellings)
        lost = sorted(always.told(each).lost for each in tellings)
        return cls(paper, always, lost[(len(lost) - 1) // 3] if lost else 0)

    def visibility(self, posed: PosedProblem) -> MistakeVisibility:
        """The mistakes that the answers at the drawn position tell apart."""
        return mistake_visibility(posed.method, posed.drawn, self.paper.marking(posed))


def _sample(template: Template, seed: str) -> Iterator[PosedProblem]:
    """Problems of a template that are nobody's."""
    for attempt in range(_SAMPLE_TRIES):
        with contextlib.suppress(GraphkinError):
            posed = well_posed(template.mechanism(_numbers(template, "", seed, attempt)))
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
class _ProblemAnswers:
    """The answers of one problem at all positions, and those at the drawn one with what paper allows of them."""

    all: Array
    right: Array
    tolerance: Array


class _GivenOut:
    """Numbers and answers that other students have; and numbers that are no good problem, each with why."""

    def __init__(self) -> None:
        self.refused: dict[tuple[int, ...], Refused] = {}
        self.numbers: set[tuple[int, ...]] = set()
        self.answers: list[_ProblemAnswers] = []

    def have(self, numbers: tuple[int, ...], own: _ProblemAnswers) -> bool:
        """True where another student has these numbers, or nearly these answers."""
        if numbers in self.numbers:
            return True
        if not self.answers or not own.all.size:
            return False
        last = self.answers[-2000:]
        return _any_alike(np.array([one.all for one in last]), own.all, _DISTINCT, 0.0) or (
            own.right.size > 0 and _any_alike(np.array([one.right for one in last]), own.right, 0.0, own.tolerance)
        )


def _any_alike(others: Array, own: Array, part: float, off: Array | float) -> bool:
    """True where all answers (n,) are those of one of the others (problems, n), but for a part of them or so much."""
    reach = np.maximum(part * np.maximum(np.abs(others), np.abs(own)), off)
    return bool(np.any(np.all(np.abs(others - own) <= reach, axis=1)))


# --- the paper that a template's problems fit on, without laying out the sheet of each --------------------------------


@frozen
class DrawingSizes:
    """The usual size of a drawing on paper [mm], by plane."""

    sizes: Mapping[Plane, float]

    @classmethod
    def of(cls, some: Sequence[PosedProblem]) -> DrawingSizes:
        """Of the sheets of a few problems."""
        laid_out = [(one, marking_of(one.method).scales) for one in some[:_LAID_OUT]]
        return cls({
            plane: float(np.median([_across(one, plane) / scales[key] for one, scales in laid_out] or [100.0]))
            for plane, key in KEYS.items()
        })  # fmt: skip

    def marking(self, posed: PosedProblem) -> Marking:
        """The pencil's errors at the file's scales or at those that make this problem's drawings as large."""
        own = {key: _across(posed, plane) / self.sizes[plane] for plane, key in KEYS.items()}
        return marking_of(posed.method, scales={**own, **posed.method.mechanism.scales})


def _across(posed: PosedProblem, plane: Plane) -> float:
    """The longest distance between points of a plane along an axis [SI]; 1 where all are one."""
    points = np.array([complex(z) for z in posed.drawn.points(plane).values()])
    points = points[np.isfinite(points)]
    return float(max(np.ptp(points.real), np.ptp(points.imag))) or 1.0 if points.size else 1.0
