"""Directions that are written beside sizes: right as the right vector points, or as own values before it have it."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property

import numpy as np

from graphkin.base.geometry import Value, place
from graphkin.base.value import frozen
from graphkin.marking.answers import drawn_answer
from graphkin.marking.carried import CarriedProblem
from graphkin.marking.follow_through import replay_with
from graphkin.marking.hand import redraw
from graphkin.marking.pencil import PencilHand
from graphkin.marking.read_off import ASTRAY
from graphkin.marking.records import HandedNumber, StudentWork
from graphkin.marking.tolerances import drawings_of
from graphkin.model.quantities import Answer, Moving, Quantity, Rotation

_DRAWINGS = 500
_SIGMAS = 3.0


@frozen
class WrittenDirections:
    """The directions of a key's vectors."""

    problem: CarriedProblem

    @cached_property
    def right(self) -> dict[str, tuple[Moving, complex, float]]:
        """By text: the quantity, the right vector, and by how much the direction may be off [rad]; without those whose
        direction a pencil cannot tell."""
        problem = self.problem
        method, marking = problem.method, problem.key.marking
        drawings = drawings_of(method, marking, _DRAWINGS)
        hand = PencilHand(drawings.pencil, drawings.slips, method.facts(), [()])
        each: dict[str, tuple[Moving, complex, float]] = {}
        with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
            drawn = redraw(method, hand.placed(method, drawings.positions), hand, hand.shape)
            plot = redraw(method, problem.plot)
            for quantity, entry in zip(problem.quantities, problem.key.entries, strict=True):
                if isinstance(quantity, Moving) and entry.right:
                    vector = place(_vector(drawn_answer(method, plot, quantity, problem.arrows)))
                    off = np.angle(_vector(drawn_answer(method, drawn, quantity, problem.arrows)) / vector)
                    allowed = max(ASTRAY, _SIGMAS * float(np.sqrt(np.nanmean(off**2))))
                    if allowed < math.pi / 2:
                        each[entry.text] = quantity, vector, allowed
        return each

    def judged(self, work: StudentWork, given: np.ndarray, carried: np.ndarray, near: np.ndarray) -> StudentWork:
        """With what is told of each vector whose direction is written.

        given    values by the key's columns; carried: the wrong ones that others follow from, near: the sizes that do
        """
        problem = self.problem
        bounded = problem.bounded(given[None])[0]
        own: dict[Quantity, Value] = {}
        for n, (quantity, entry) in enumerate(zip(problem.quantities, problem.key.entries, strict=True)):
            number = work.numbers.get(entry.text)
            if number is None or not bounded[n] or not isinstance(quantity, Moving | Rotation):
                continue
            if number.vector is not None and not number.within:
                own[quantity] = number.vector
            elif carried[n] and quantity.word != "theta":
                own[quantity] = number.value
        numbers = {
            entry.text: self._pointing(number, entry.text, own, bool(near[n]))
            for n, entry in enumerate(problem.key.entries) if entry.text in self.right
            if (number := work.numbers.get(entry.text)) is not None and number.vector is not None
        }  # fmt: skip
        return replace(work, numbers={**work.numbers, **numbers})

    def _pointing(self, number: HandedNumber, text: str, own: Mapping[Quantity, Value], near: bool) -> HandedNumber:
        quantity, vector, allowed = self.right[text]
        others = {other: value for other, value in own.items() if other != quantity}
        within = max(allowed, number.within)

        def off(used: Mapping[Quantity, Value]) -> float:
            problem, expected = self.problem, [vector]
            if used:  # drawn on from them, or calculated by own rotations
                each = (replay_with(problem.method, problem.plot, used, problem.arrows, None, calculates)
                        for calculates in (False, True))  # fmt: skip
                expected = [place(_vector(followed.value(quantity))) for followed in each]
            angles = (abs(cmath.phase((number.vector or 1.0) / one)) for one in expected if one and cmath.isfinite(one))
            return min(angles, default=math.pi)

        if not (points := off({}) <= within) and near and others and off(others) <= within:
            alone = [other for other, value in others.items() if off({other: value}) <= within]
            follows = tuple(other.text for other in alone or others)
            return replace(number, points=True, follows=follows, within=within)
        return replace(number, points=points, reversed=not points and math.pi - off({}) <= within, within=within)


def _vector(answer: Answer) -> Value:
    return np.nan if answer.vector is None else answer.vector
