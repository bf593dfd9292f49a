"""The order in which a drawing gives quantities, and the vector equation that gives each."""

from __future__ import annotations

from collections.abc import Sequence
from math import inf
from typing import assert_never

from graphkin.base.value import frozen
from graphkin.construction import Construction, Equation, Measure, Roll, Simultaneous, Step, TurnOf
from graphkin.marking.answers import ArrowPlaces, Ends
from graphkin.marking.scene import drawn_by
from graphkin.model.quantities import Quantity, kinds
from graphkin.planning import Method


@frozen
class DrawnAt:
    """The place of a quantity in a drawing.

    rank      by which quantities are in order; what is not drawn comes after its plane
    equation  the vector equation that gives it, with its plane; None where none does
    """

    rank: float
    construction: Construction | None = None
    equation: Equation | None = None

    def names(self) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """The arrows of both sides of the equation."""
        if self.construction is None or self.equation is None:
            return (), ()
        plane = self.construction.plane
        left, right = (tuple(term.name(plane) for term in side) for side in (self.equation.left, self.equation.right))
        return left, right


def drawing_order(method: Method, quantities: Sequence[Quantity], arrows: ArrowPlaces) -> list[DrawnAt]:
    """The place of each quantity."""
    order = _Order(method, arrows)
    for polygon, word in ((method.velocity, "omega"), (method.acceleration, "alpha")):
        order.go_through(polygon, word)
    return [order.place(quantity) for quantity in quantities]


class _Order:
    """The places of corners, rotations and arrows of both polygons, gone through step by step."""

    def __init__(self, method: Method, arrows: ArrowPlaces) -> None:
        facts = method.facts()
        self.turns, self.frame, self.arrows = facts.turns, facts.turns[facts.frame].base, arrows
        self.corners: dict[tuple[str, str], DrawnAt] = {}
        self.rotations: dict[tuple[str, str], DrawnAt] = {}
        self.ends: dict[Ends, DrawnAt] = {}
        self.planes: dict[str, int] = {"position": 0}
        self.rank = 0

    def go_through(self, polygon: Construction, word: str) -> None:
        for part in polygon.parts:
            equation = part if isinstance(part, Equation) else None
            for step in part.steps if isinstance(part, Equation) else (part,):
                self.rank += 1
                for corner in drawn_by(step):
                    self.corners.setdefault((polygon.plane, corner), DrawnAt(self.rank, polygon, equation))
                closed = equation
                if isinstance(step, Measure):  # off an arrow that an equation gave before
                    closed = equation or self._latest(polygon.plane, step.tail, step.head).equation
                for base in _rotations_of(step, word):
                    here = DrawnAt(self.rank, polygon, closed)
                    self.rotations.setdefault((word, self.turns[base].base), here)
            for term in (*equation.left, *equation.right) if equation is not None else ():
                self.ends.setdefault((polygon.plane, term.tail, term.head), DrawnAt(self.rank, polygon, equation))
        self.rank += 1
        self.planes[polygon.plane] = self.rank

    def _latest(self, plane: str, *corners: str) -> DrawnAt:
        places = [self.corners[plane, corner] for corner in corners if (plane, corner) in self.corners]
        return max(places, key=lambda at: at.rank, default=DrawnAt(inf))

    def place(self, quantity: Quantity) -> DrawnAt:
        """The place of one quantity; of one that is not drawn, after its plane."""
        match quantity:
            case kinds.Moving():
                arrow = self.arrows.of(quantity)
                if arrow is None:
                    return DrawnAt(self.planes["velocity" if quantity.letter == "v" else "acceleration"])
                drawn = self._latest(*arrow[0])
                return drawn if drawn.rank < inf else self.ends.get(arrow[0], drawn)
            case kinds.Rotation(word="omega" | "alpha"):
                turn = self.turns.get(quantity.link, TurnOf(quantity.link))
                if turn.base == self.frame and not turn.drivers:  # of a link that does not turn nothing is drawn
                    return DrawnAt(self.planes["velocity" if quantity.word == "omega" else "acceleration"])
                return self.rotations.get((quantity.word, turn.base), DrawnAt(0))
            case kinds.Component():
                return self.place(quantity.whole)
            case kinds.Quotient():
                return max(map(self.place, quantity.halves), key=lambda at: at.rank)
            case kinds.Rotation() | kinds.Displacement() | kinds.Place() | kinds.Track() | kinds.Centre():
                return DrawnAt(self.planes["position"])
            case _:
                assert_never(quantity)


def _rotations_of(step: Step, word: str) -> tuple[str, ...]:
    """The links whose omega or alpha a step gives."""
    match step:
        case Measure(quantity=quantity, of=link) if quantity == word:
            return (link,)
        case Roll(angle=base) if base:
            return (base,)
        case Simultaneous(angles=angles):
            return angles
        case _:
            return ()
