"""The order in which a drawing gives quantities, and the vector equation that gives each."""

from __future__ import annotations

from collections.abc import Sequence
from math import inf

from graphkin.base.value import frozen
from graphkin.construction import Construction, Equation, Measure, Roll, Simultaneous
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
    turns = method.facts().turns
    nodes: dict[tuple[str, str], DrawnAt] = {}
    rotations: dict[tuple[str, str], DrawnAt] = {}
    ends: dict[Ends, DrawnAt] = {}
    rank = 0
    planes: dict[str, float] = {"position": 0.0}
    for polygon, word in ((method.velocity, "omega"), (method.acceleration, "alpha")):
        for part in polygon.parts:
            equation = part if isinstance(part, Equation) else None
            for step in part.steps if isinstance(part, Equation) else (part,):
                rank += 1
                here = DrawnAt(rank, polygon, equation)
                for node in drawn_by(step):
                    nodes.setdefault((polygon.plane, node), here)
                match step:
                    case Measure(quantity=quantity, of=link) if quantity == word:
                        rotations.setdefault((word, turns[link].base), here)
                    case Roll(angle=base) if base:
                        rotations.setdefault((word, base), here)
                    case Simultaneous(angles=angles):
                        rotations.update({(word, base): here for base in angles if (word, base) not in rotations})
                    case _:
                        pass
            for term in (*equation.left, *equation.right) if equation is not None else ():
                ends.setdefault((polygon.plane, term.tail, term.head), DrawnAt(rank, polygon, equation))
        rank += 1
        planes[polygon.plane] = rank

    def place(quantity: Quantity) -> DrawnAt:
        match quantity:
            case kinds.Moving():
                plane = "velocity" if quantity.letter == "v" else "acceleration"
                arrow = arrows.of(quantity)
                if arrow is None:
                    return DrawnAt(planes[plane])
                first, tail, head = arrow[0]
                places = [nodes[first, node] for node in (tail, head) if (first, node) in nodes]
                return max(places, key=lambda at: at.rank, default=ends.get(arrow[0], DrawnAt(planes[plane])))
            case kinds.Rotation() if quantity.word != "theta":
                base = turns[quantity.link].base if quantity.link in turns else quantity.link
                return rotations.get((quantity.word, base), DrawnAt(0.5 if quantity.word == "omega" else inf))
            case kinds.Component():
                return place(quantity.whole)
            case kinds.Quotient():
                return max((place(half) for half in quantity.halves), key=lambda at: at.rank)
            case _:
                return DrawnAt(planes["position"])

    return [place(quantity) for quantity in quantities]
