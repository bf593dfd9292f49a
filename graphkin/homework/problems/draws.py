"""Each student's own numbers, drawn from a seed and the student's id: the same again whenever and in whatever order.

Only when two students would get the same problem does the list of students matter, and its order never. The list is a
file, or so many of them.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import Executor
from contextlib import suppress
from dataclasses import replace
from functools import cached_property, partial
from pathlib import Path

import numpy as np

from graphkin.base.geometry import Array
from graphkin.base.value import bulky, frozen
from graphkin.base.worklist import ahead
from graphkin.errors import GraphkinError, NotBetween, NoVariant, Where
from graphkin.homework.grading.keys import USUAL, Pencils, further_methods, marking_of, page_scales
from graphkin.homework.grading.sets import class_list
from graphkin.homework.problems.carried import carried
from graphkin.homework.problems.posed import PosedProblem, Refused, answers, well_posed
from graphkin.homework.problems.template import Template, digest
from graphkin.marking.discriminability import LOOKED_AT, Always, Discriminability, MistakeVisibility, mistake_visibility
from graphkin.marking.key import TELLS, Marking, columns
from graphkin.marking.key_making import AskedAnswers, asked_alone
from graphkin.marking.tolerances import parts_off
from graphkin.model.mechanism import Mechanism
from graphkin.model.quantities import at_position
from graphkin.running import replay_all
from graphkin.submissions import Student

_TRIES = 200
_HOPELESS = 20  # where so many draws do not assemble, and no other did better, the template is wrong
_APART = 60  # so many draws look for numbers that no other student has; then well-posed is enough
_CROWDED = 4  # of a class too large for its ranges so many draws a student, and those of one, look for such numbers
_DISTINCT = 0.02
"""Two problems whose answers all differ by a smaller part, or by less than paper allows, are like each other."""
_FAILS = 0.02  # where more of the drawings with a pencil do not close, a dead point is too near
_SAMPLE, _TOLD, _SAMPLE_TRIES = 24, 9, 150
"""So many problems show how accurate a template's answers are, and so many of those that are alike how well mistakes
can be told apart; of so many draws at most."""
_LIKE = math.log(3) / 2
"""The tolerance of answers to one question, as a part of them, differs by a smaller logarithm from the usual part, so
that for two students it differs by less than a factor of 3."""
_PRINTED = 0.01  # a smaller part is that of three printed digits, and is like any other
_AHEAD = 64  # students who are drawn for before it is their turn
_FAR, _STIFF = 2.0, 0.1  # that logarithm of problems that are none; and how little guesses follow single problems


@bulky
class Variant:
    """One student's problem.

    numbers  of the value of each range
    told     what its answers tell of mistakes
    shared   whether another student has the same, or nearly
    """

    student: Student
    numbers: tuple[int, ...]
    mechanism: Mechanism
    told: Discriminability
    shared: bool = False


def drawn_variants(
    template: Template, students: Sequence[Student], seed: str, pencils: Pencils = USUAL,
    given_out: Mapping[str, tuple[int, ...]] = {}, executor: Executor | None = None,
) -> Iterator[Variant]:  # fmt: skip
    """Each when it is drawn, in an order that hangs on the seed and the ids alone.

    given_out  the numbers that some have already, by id
    executor   draws ahead, as if each student were alone; who then has what another has is drawn once more
    """
    order = sorted(students, key=lambda student: digest(seed, student.id))
    others, goal = _GivenOut(), _Goal.of(template, seed, pencils)
    fresh = ([student] for student in order if student.id not in given_out)
    found = None if executor is None else ahead(executor, partial(_each_alone, template, seed, goal), fresh, _AHEAD)
    for student in order:
        if student.id in given_out:
            draw = _posed(template, student, given_out[student.id], others, goal, False)
            one = None if isinstance(draw, str) else _Drawn(*draw, ())
        else:
            one = next(found) if found is not None else None
            if one is not None and any(numbers in others.numbers or (own is not None and others.have(numbers, own))
                                       for numbers, own in one.tried):  # fmt: skip
                one = None
        one = one or _drawn_for(template, student, seed, others, goal)
        others.numbers.add(one.best.numbers)
        others.often[one.best.numbers] += 1
        others.answers.append(one.own)
        yield one.best


@frozen
class _Drawn:
    """A student's draw with its answers; and the numbers that were tried, with their answers where they are good."""

    best: Variant
    own: _ProblemAnswers
    tried: tuple[tuple[tuple[int, ...], _ProblemAnswers | None], ...]


def _each_alone(template: Template, seed: str, goal: _Goal, students: Sequence[Student]) -> list[_Drawn | None]:
    """As if no other student had any; None where something is wrong."""
    draws: list[_Drawn | None] = []
    for student in students:
        with suppress(GraphkinError):
            draws.append(_drawn_for(template, student, seed, _GivenOut(), goal))
    return draws if len(draws) == len(students) else [None] * len(students)


def _drawn_for(template: Template, student: Student, seed: str, others: _GivenOut, goal: _Goal) -> _Drawn:
    """The student's draw that is unlike the others' and hides the fewest mistakes."""
    refused: Counter[Refused] = Counter()
    good: list[tuple[Variant, _ProblemAnswers]] = []
    tried: list[tuple[tuple[int, ...], _ProblemAnswers | None]] = []
    tries = goal.likely_first([template.numbers(student.id, seed, attempt) for attempt in range(_TRIES)])
    first = tries[:_APART] if others.taken <= _APART + _CROWDED * len(others.answers) else []
    rest = sorted(tries[len(first) :] + first, key=others.often.__getitem__)  # what the fewest have comes first
    for attempt, numbers in enumerate([*first, *rest]):
        apart = attempt < len(first)
        draw = _posed(template, student, numbers, others, goal, apart)
        others.taken += draw == "taken"
        tried.append((numbers, None if isinstance(draw, str) else draw[1]))
        if isinstance(draw, str):
            refused[draw] += attempt < _TRIES
            if draw == "assembly" and attempt + 1 == refused[draw] == _HOPELESS:
                _drawn(template, numbers, goal.pencils)  # raises what is wrong with the template
            continue
        good.append(draw)
        if draw[0].shared or len(good) == LOOKED_AT or draw[0].told.lost <= goal.lost:
            break
    if not good:
        question, part = max(others.least.items(), key=lambda item: item[1], default=("", 0.0))
        untold = (question, part) if part > TELLS else ("", 0.0)
        raise NoVariant(Where(template.file), student.id[:60], _TRIES, tuple(refused.most_common()), *untold)
    return _Drawn(*min(good, key=lambda pair: (pair[0].shared, pair[0].told.lost)), tuple(tried))


def _posed(
    template: Template, student: Student, numbers: tuple[int, ...], others: _GivenOut, goal: _Goal, apart: bool
) -> tuple[Variant, _ProblemAnswers] | Refused:
    """The problem with these numbers, or what is against it; apart: no other student may have it."""
    if apart and numbers in others.numbers:
        return "taken"
    if numbers in others.refused:
        return others.refused[numbers]
    try:
        drawn = _drawn(template, numbers, goal.pencils)
    except GraphkinError:
        return "assembly"
    if isinstance(drawn, str):
        others.refused[numbers] = drawn
        return drawn
    others.least |= {text: min(part, others.least.get(text, part)) for text, part in drawn.parts.items()}
    if (against := goal.against(drawn)) is not None:
        others.refused[numbers] = against
        return against
    posed, table = drawn.posed, columns(drawn.asked[1])
    own = _ProblemAnswers(answers(posed), table.right, table.tolerance)
    shared = others.have(numbers, own)
    if shared and apart:
        others.numbers.add(numbers)
        return "taken"
    return Variant(student, numbers, posed.method.mechanism, goal.always.told(drawn.tells), shared), own


@frozen
class _DrawnProblem:
    """A problem at the scales that its file states.

    asked  what a pencil allows of its answers at the drawn position, as of `asked_alone`
    parts  of each answer at any position: what may be off
    """

    posed: PosedProblem
    marking: Marking
    asked: AskedAnswers
    parts: Mapping[str, float]

    @cached_property
    def tells(self) -> MistakeVisibility:
        """The mistakes that the answers at the drawn position tell apart."""
        return mistake_visibility(self.posed.method, self.posed.drawn, self.marking, self.asked)


def _drawn(template: Template, numbers: tuple[int, ...], pencils: Pencils) -> _DrawnProblem | Refused:
    """The problem with these numbers, or what is against it. Raises what loading and solving raise."""
    if (mechanism := carried(template, numbers)) is None:
        return "elsewhere"
    posed = well_posed(mechanism)
    if isinstance(posed, str):
        return posed
    marking = marking_of(posed.method, pencils, page_scales(posed.method, posed.drawn))
    # its pencil errs as that of its key does, by the text of its file
    mechanism = template.at_scales(mechanism, marking.scales)
    posed = replace(posed, method=replace(posed.method, mechanism=mechanism))
    asked = asked_alone(posed.method, posed.drawn, marking)
    parts = parts_off(posed.method, asked[1])
    for at, there in enumerate(further_methods(posed.method), 2):
        some = parts_off(there, asked_alone(there, replay_all(there), marking)[1])
        parts |= {at_position(text, at): part for text, part in some.items()}
    return _DrawnProblem(posed, marking, asked, parts)


@frozen
class _Goal:
    """The best a template can do.

    always  mistakes that are always the same; lost: how many its better problems lose
    usual   of each question: the part of the answer that may be off in the problem that most are like
    counts  of the values of each range; weights: of terms of the numbers (terms, questions), for a guess of how far
            the parts are from the usual ones, so that few problems are solved in vain
    """

    pencils: Pencils
    always: Always
    lost: int
    usual: Mapping[str, float]
    counts: Array
    weights: Array

    @classmethod
    def of(cls, template: Template, seed: str, pencils: Pencils) -> _Goal:
        """By problems that are nobody's."""
        tried = _sample(template, seed, pencils)
        sample = [one for one in tried.values() if one is not None]
        most = TELLS / math.exp(_LIKE)
        centres = [{text: min(part, most) for text, part in each.parts.items()} for each in sample]
        usual = max(centres, key=lambda one: sum(_alike(one, each.parts) for each in sample), default={})
        tellings = [each.tells for each in sample if _alike(usual, each.parts)][:_TOLD]
        always = Always(tellings)
        lost = sorted(always.told(each).lost for each in tellings)
        best = lost[(len(lost) - 1) // 3] if lost else 0
        counts = np.array([each.count for each in template.ranges])
        none = dict.fromkeys(usual, _FAR)
        off = [[*(none if one is None else _beside(usual, one.parts)).values()] for one in tried.values()]
        terms = _terms(np.array([*tried]) / counts)
        stiff = terms.T @ terms + _STIFF * np.eye(terms.shape[1])
        weights = np.linalg.solve(stiff, terms.T @ np.clip(off, -_FAR, _FAR))
        return cls(pencils, always, best, usual, counts, weights)

    def likely_first(self, tries: Sequence[tuple[int, ...]]) -> list[tuple[int, ...]]:
        """Numbers whose problem should be like the usual one first, each in their order; others, the nearest first."""
        off = np.abs(_terms(np.array(tries) / self.counts) @ self.weights).max(axis=1, initial=0.0)
        return [tries[k] for k in np.argsort(np.maximum(off, _LIKE), kind="stable")]

    def against(self, one: _DrawnProblem) -> Refused | None:
        """The objection to a problem by what a pencil can do."""
        if one.asked[2] > _FAILS:
            return "dead point"
        if any(part > TELLS for part in one.parts.values()):
            return "untold"
        return None if _alike(self.usual, one.parts) else "unlike"


def _terms(numbers: Array) -> Array:
    """Terms of numbers (.., n) from 0 to 1 for a smooth function of them: products of up to two, and waves."""
    x = np.column_stack([np.ones(len(numbers)), 2 * numbers - 1])
    pairs = (x[:, :, None] * x[:, None, :])[:, *np.triu_indices(x.shape[1])]
    turns = np.pi * x[:, 1:]
    return np.column_stack([pairs, *(wave(k * turns) for k in (1, 2, 3) for wave in (np.sin, np.cos))])


def _beside(usual: Mapping[str, float], parts: Mapping[str, float]) -> dict[str, float]:
    """Logarithms of the parts beside the usual ones."""
    return {text: math.log(max(parts[text], _PRINTED) / max(part, _PRINTED)) for text, part in usual.items()}


def _alike(usual: Mapping[str, float], parts: Mapping[str, float]) -> bool:
    """True where no part is so far from the usual one that two such might be unlike each other."""
    return all(abs(off) < _LIKE for off in _beside(usual, parts).values())


def _sample(template: Template, seed: str, pencils: Pencils) -> dict[tuple[int, ...], _DrawnProblem | None]:
    """Numbers that are nobody's with their problem, none where they are no good: as many as show enough."""
    tried: dict[tuple[int, ...], _DrawnProblem | None] = {}
    told = failed = 0
    for attempt in range(_SAMPLE_TRIES):
        numbers = template.numbers("", seed, attempt)
        if numbers in tried or told == _SAMPLE or failed == len(tried) == _HOPELESS:
            continue
        tried[numbers] = None
        try:
            drawn = _drawn(template, numbers, pencils)
        except GraphkinError:
            failed += 1
            continue
        if not isinstance(drawn, str):
            tried[numbers] = drawn
            told += max(drawn.parts.values(), default=0.0) <= TELLS
    return tried


@frozen
class _ProblemAnswers:
    """The answers of one problem at all positions, and those at the drawn one with what paper allows of them."""

    all: Array
    right: Array
    tolerance: Array


class _GivenOut:
    """Numbers and answers that other students have, or nearly, and how often numbers are given out; those that are no
    good problem, each with why; the least part of each answer that may be off in any problem; and how many draws others
    had already."""

    def __init__(self) -> None:
        self.refused: dict[tuple[int, ...], Refused] = {}
        self.least: dict[str, float] = {}
        self.taken = 0
        self.numbers: set[tuple[int, ...]] = set()
        self.often: Counter[tuple[int, ...]] = Counter()
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


# --- the students -----------------------------------------------------------------------------------------------------

MOST = 100_000


def roster(given: str) -> tuple[Student, ...]:
    """The students of a class list, or s1 .. sN for a number N.

    Raises NoFile, Unreadable, BrokenSubmission, WantsExtra, NotBetween, StudentTwice, StudentWithoutId, NoStudents.
    """
    if given.lstrip("+-").isdecimal() and given.isascii():
        if len(given) > 6 or not 0 < int(given) <= MOST:
            raise NotBetween(Where("--students"), given[:20], 1, MOST)
        wide = len(given)
        return tuple(Student(f"s{number:0{wide}d}") for number in range(1, int(given) + 1))
    return class_list(Path(given))
