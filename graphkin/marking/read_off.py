"""What a drawing determines beside the vectors that are measured on it, and which way its known arrows point.

omega = v / l and alpha = a^t / l with the student's own arrows, as a ruler reads them, with the sense that the arrow
has about the link's other point. Nothing is read where the points it needs are not drawn.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from typing import assert_never

import numpy as np

from graphkin.base.geometry import Value, cross
from graphkin.base.value import frozen
from graphkin.construction import Given, LayOff, Measure, Plane, Plot
from graphkin.marking.asked import ArrowPlaces, Ends
from graphkin.marking.follow_through import replay_with
from graphkin.marking.graded import Drawn
from graphkin.marking.handed import readable
from graphkin.model.quantities import (
    Centre,
    Component,
    Displacement,
    Moving,
    Place,
    Quantity,
    Quotient,
    Rotation,
    Track,
)
from graphkin.model.quantities.kinds import on_axis
from graphkin.planning import Method

_ALONG = math.radians(5)
"""An arrow that is nearer to its link's direction turns it neither way."""
ASTRAY = math.radians(15)
"""A known arrow that is laid off farther from where it should point is laid off another way."""
_SHORT = 0.02
"""Of an arrow that is a smaller part of its polygon's longest no direction is told."""

Rates = Mapping[tuple[str, str], float]


@frozen
class OffDrawing:
    """values: by quantity's text; no_sense: rotations whose arrow lies along the link."""

    values: Mapping[str, float]
    no_sense: tuple[str, ...] = ()


def read_off(method: Method, plot: Plot, arrows: ArrowPlaces, drawn: Drawn, wanted: Sequence[Quantity]) -> OffDrawing:
    """What of the wanted quantities a drawing determines.

    plot   the right one, for the lengths of links
    drawn  points by plane and letter, SI, from any of them
    """
    own = _OwnPoints(method, plot, drawn)
    rates = dict(own.rates())
    values = {quantity.text: own.value(quantity, rates, arrows) for quantity in wanted}
    whole = {text: value for text, value in values.items() if value is not None}
    astray = [q.text for q in wanted if isinstance(q, Rotation) and math.isnan(whole.get(q.text, 0.0))]
    return OffDrawing({text: value for text, value in whole.items() if math.isfinite(value)}, tuple(astray))


def pointing(
    method: Method, plot: Plot, arrows: ArrowPlaces, drawn: Drawn, vectors: Mapping[Moving, complex],
    written: Mapping[Rotation, float],
) -> dict[str, bool]:  # fmt: skip
    """By quantity, whether an arrow that is laid off points as it should: as in the right drawing, or as the student's
    own arrows and rotations before it have it, `written` ones before those that the drawing shows. Arrows that are
    found by lines that cross are not judged."""
    laid = _laid(method)
    ends = {quantity: at for quantity in vectors if (at := arrows.of(quantity)) is not None and at[0] in laid}
    if not ends:
        return {}
    own: dict[Quantity, Value] = dict(vectors.items())
    own.update(_turning(method, plot, drawn, written).items())
    ways = [replay_with(method, plot, known, arrows).plot for known in ({}, own)]
    return {
        quantity.text: told for quantity, (at, sign) in ends.items()
        if (told := _points(sign * vectors[quantity], [way.laid[at] for way in ways], _longest(ways[0], at[0])))
        is not None
    }  # fmt: skip


def _turning(method: Method, plot: Plot, drawn: Drawn, written: Mapping[Rotation, float]) -> dict[Rotation, float]:
    """Own rotations: as they are written, for all links that turn together; else as the drawing shows them."""
    base = {link: turn.base for link, turn in plot.facts.turns.items()}
    told = {(rotation.word, base.get(rotation.link)) for rotation in written}
    found = dict(written)
    for (word, link), value in _OwnPoints(method, plot, drawn).rates():
        rotation = readable(method.mechanism, f"{word} {link}")
        if math.isfinite(value) and isinstance(rotation, Rotation) and (word, base[link]) not in told:
            found[rotation] = value
    return found


def _points(vector: complex, expected: Sequence[Value], longest: float) -> bool | None:
    """Whether it points as one of these does; None where it, or all of these, are too short to tell."""
    some = [complex(one) for one in expected if np.isfinite(one) and abs(complex(one)) > _SHORT * longest]
    if not some or abs(vector) <= _SHORT * longest:
        return None
    return any(abs(cmath.phase(vector / one)) < ASTRAY for one in some)


def _longest(plot: Plot, plane: Plane) -> float:
    """How far the points of a polygon are apart at most, about."""
    return max((abs(complex(place)) for place in plot.points(plane).values()), default=0.0)


def _laid(method: Method) -> set[Ends]:
    """Arrows whose size is calculated before they are drawn."""
    return {
        (construction.plane, step.term.tail, step.term.head)
        for construction in (method.velocity, method.acceleration)
        for step in construction.steps
        if isinstance(step, LayOff)
    }


@frozen
class _OwnPoints:
    """A student's points, and the right lengths of links."""

    method: Method
    plot: Plot
    drawn: Drawn

    def rates(self) -> Iterator[tuple[tuple[str, str], float]]:
        """omega and alpha of the links that are read off, and of those that keep their angle to them; NaN where an
        arrow has no sense."""
        facts = self.plot.facts
        for construction, word in ((self.method.velocity, "omega"), (self.method.acceleration, "alpha")):
            for step in construction.steps:
                if not isinstance(step, Measure) or step.quantity != word:
                    continue
                value = self._measured(step, construction.plane)
                if value is None:
                    continue
                order = 1 if word == "omega" else 2
                own = facts.relative_rate(step.of, order)
                for link, turn in facts.turns.items():
                    if turn.base == facts.turns[step.of].base:
                        yield (word, link), float(value - own + facts.relative_rate(link, order))

    def _measured(self, step: Measure, plane: Plane) -> float | None:
        """The arrow's length over the link's."""
        arrow = self.arrow((plane, step.tail, step.head))
        if arrow is None:
            return None
        arm = complex(self.plot.arm(*step.lever))
        across = cross(arm, arrow)
        if abs(across) < math.sin(_ALONG) * abs(arm) * abs(arrow):
            return math.nan
        return math.copysign(abs(arrow) / abs(arm), across)

    def arrow(self, ends: Ends) -> complex | None:
        """Between two points that are drawn."""
        plane, *names = ends
        tail, head = (self._place(plane, name) for name in names)
        return None if tail is None or head is None else head - tail

    def _place(self, plane: Plane, name: str) -> complex | None:
        """Fixed points sit on the pole."""
        points = self.drawn.get(plane, {})
        construction = self.method.velocity if plane == "velocity" else self.method.acceleration
        for step in construction.steps:
            if isinstance(step, Given) and name in step.also:
                return points.get(name, points.get(step.point))
        return points.get(name)

    def value(self, quantity: Quantity, rates: Rates, arrows: ArrowPlaces) -> float | None:
        """None of what the drawing does not determine."""
        match quantity:
            case Rotation():
                return rates.get((quantity.word, quantity.link), self._driven(quantity))
            case Quotient():
                top, bottom = (self.value(half, rates, arrows) for half in quantity.halves)
                return top / bottom if top is not None and bottom else None
            case Component():
                vector = self._vector(quantity.whole, arrows)
                return None if vector is None else float(on_axis(vector, quantity.axis))
            case Moving():
                vector = self._vector(quantity, arrows)
                return None if vector is None else abs(vector)
            case Displacement() | Place() | Track() | Centre():
                return None
            case _:
                assert_never(quantity)

    def _driven(self, quantity: Rotation) -> float | None:
        """Of a link that turns as it is driven against the frame."""
        facts, orders = self.plot.facts, {"omega": 1, "alpha": 2}
        turn = facts.turns.get(quantity.link)
        if turn is None or turn.base != facts.frame or quantity.word not in orders:
            return None
        return float(facts.relative_rate(quantity.link, orders[quantity.word]))

    def _vector(self, quantity: Moving, arrows: ArrowPlaces) -> complex | None:
        found = arrows.of(quantity)
        if found is None or (arrow := self.arrow(found[0])) is None:
            return None
        return found[1] * arrow
