"""Readings off a drawing beside the vectors that are measured on it, and the directions of its known arrows.

omega = v / l and alpha = a^t / l with the student's own arrows, as a ruler reads them, with the sense that the arrow
has about the link's other point. Nothing is read where the points it needs are not drawn.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import assert_never

import numpy as np

from graphkin.base.geometry import Value, cross, number, place
from graphkin.base.value import frozen
from graphkin.construction import Given, LayOff, Measure, Plot
from graphkin.marking.answers import ArrowPlaces, Ends, readable
from graphkin.marking.consequences import combined
from graphkin.marking.diagnosis import Diagnosis
from graphkin.marking.follow_through import replay_with
from graphkin.marking.key import Name
from graphkin.marking.records import Drawn, HandedNumber
from graphkin.marking.rewrite import Rewrite
from graphkin.model.quantities import Quantity, kinds
from graphkin.model.quantities.kinds import on_axis
from graphkin.planning import Method

_ALONG = math.radians(5)  # an arrow that is nearer to its link's direction turns it neither way
ASTRAY = math.radians(15)  # a known arrow that is laid off farther from where it should point is laid off another way
_SHORT = 0.02  # of an arrow that is a smaller part of its polygon's longest no direction is told

Rates = Mapping[tuple[str, str], float]


@frozen
class OffDrawing:
    """values: by quantity's text; no_sense: rotations whose arrow lies along the link."""

    values: Mapping[str, float]
    no_sense: tuple[str, ...] = ()


def read_off(
    method: Method, plot: Plot, arrows: ArrowPlaces, drawn: Drawn, quantities: Sequence[Quantity]
) -> OffDrawing:
    """The values of the quantities that a drawing determines.

    plot   the right one, for the lengths of links
    drawn  points by plane and letter, SI, from any of them
    """
    own = OwnPoints(method, plot, drawn)
    rates = dict(own.rates())
    values = {quantity.text: own.value(quantity, rates, arrows) for quantity in quantities}
    whole = {text: value for text, value in values.items() if value is not None}
    no_sense = [q.text for q in quantities if isinstance(q, kinds.Rotation) and math.isnan(whole.get(q.text, 0.0))]
    return OffDrawing({text: value for text, value in whole.items() if math.isfinite(value)}, tuple(no_sense))


def pointing(
    method: Method, plot: Plot, arrows: ArrowPlaces, drawn: Drawn, vectors: Mapping[kinds.Moving, complex],
    written: Mapping[kinds.Rotation, float],
) -> dict[str, bool]:  # fmt: skip
    """By quantity, whether an arrow that is laid off points as it should: as in the right drawing, or as the student's
    own arrows and rotations before it have it, `written` ones before those that the drawing shows. Arrows that are
    found by lines that cross are not judged."""
    steps = [(polygon.plane, step) for polygon in (method.velocity, method.acceleration) for step in polygon.steps]
    laid = {(plane, step.term.tail, step.term.head) for plane, step in steps if isinstance(step, LayOff)}
    ends = {quantity: at for quantity in vectors if (at := arrows.of(quantity)) is not None and at[0] in laid}
    if not ends:
        return {}
    own: dict[Quantity, Value] = dict(vectors.items())
    own.update(written.items())
    # own rotations: as they are written, for all links that turn together; else as the drawing shows them
    base = {link: turn.base for link, turn in plot.facts.turns.items()}
    in_words = {(rotation.word, base.get(rotation.link)) for rotation in written}
    for (word, link), value in OwnPoints(method, plot, drawn).rates():
        shown = readable(method.mechanism, f"{word} {link}")
        if math.isfinite(value) and isinstance(shown, kinds.Rotation) and (word, base[link]) not in in_words:
            own[shown] = value
    expected = [replay_with(method, plot, known, arrows).plot for known in ({}, own)]
    good = {}
    for quantity, (arrow, sign) in ends.items():
        longest = max((abs(place(corner)) for corner in expected[0].points(arrow[0]).values()), default=0.0)
        vector = sign * vectors[quantity]
        laid_off = [place(plot.laid[arrow]) for plot in expected]
        some = [one for one in laid_off if np.isfinite(one) and abs(one) > _SHORT * longest]
        if some and abs(vector) > _SHORT * longest:
            good[quantity.text] = any(abs(cmath.phase(vector / one)) < ASTRAY for one in some)
    return good


@frozen
class OwnPoints:
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
                arrow = self.arrow((construction.plane, step.tail, step.head))
                if arrow is None:
                    continue
                arm = complex(self.plot.arm(*step.lever))
                across = number(cross(arm, arrow))
                along = abs(across) < math.sin(_ALONG) * abs(arm) * abs(arrow)
                value = math.nan if along else math.copysign(abs(arrow) / abs(arm), across)
                order = 1 if word == "omega" else 2
                own = facts.relative_rate(step.of, order)
                for link, turn in facts.turns.items():
                    if turn.base == facts.turns[step.of].base:
                        yield (word, link), number(value - own + facts.relative_rate(link, order))

    def arrow(self, ends: Ends) -> complex | None:
        """Between two points that are drawn."""
        plane, *names = ends
        points = self.drawn.get(plane, {})
        construction = self.method.velocity if plane == "velocity" else self.method.acceleration
        givens = [step for step in construction.steps if isinstance(step, Given)]  # fixed points sit on the pole
        poles = {name: points.get(step.point) for step in reversed(givens) for name in step.also}
        tail, head = (points.get(name, poles.get(name)) for name in names)
        return None if tail is None or head is None else head - tail

    def value(self, quantity: Quantity, rates: Rates, arrows: ArrowPlaces) -> float | None:
        """The value of a quantity; None of what the drawing does not determine."""
        match quantity:
            case kinds.Rotation():
                facts, orders = self.plot.facts, {"omega": 1, "alpha": 2}
                turn, driven = facts.turns.get(quantity.link), None
                if turn is not None and turn.base == facts.frame and quantity.word in orders:
                    driven = number(facts.relative_rate(quantity.link, orders[quantity.word]))
                return rates.get((quantity.word, quantity.link), driven)
            case kinds.Quotient():
                top, bottom = (self.value(half, rates, arrows) for half in quantity.halves)
                return top / bottom if top is not None and bottom else None
            case kinds.Component():
                vector = self.vector(quantity.whole, arrows)
                return None if vector is None else number(on_axis(vector, quantity.axis))
            case kinds.Moving():
                vector = self.vector(quantity, arrows)
                return None if vector is None else abs(vector)
            case kinds.Displacement() | kinds.Place() | kinds.Track() | kinds.Centre():
                return None
            case _:
                assert_never(quantity)

    def vector(self, quantity: kinds.Moving, arrows: ArrowPlaces) -> complex | None:
        """A vector as it is drawn."""
        of = arrows.of(quantity)
        if of is None or (arrow := self.arrow(of[0])) is None:
            return None
        return of[1] * arrow


# --- mistakes told apart by known arrows that point another way -------------------------------


def as_handed_in(
    diagnosis: Diagnosis, handed_in: Mapping[str, tuple[Quantity, HandedNumber]], method: Method, plot: Plot,
    known: Mapping[Name, Rewrite],
) -> Diagnosis:  # fmt: skip
    """Of each set of mistakes those that turn most of the arrows astray, and no arrow otherwise than it was handed in.

    Sizes and rotations alone may go with an omega misread and with a driver drawn the other way round; only the second
    turns the driver's arrow. One that is astray and whose size a mistake explains may point just the other way. Drawn
    arrows that point as they should say nothing: they may by own values before them. No sense is missing that is said
    in words. `handed_in`: by the key's texts; `known`: rewrites by name.
    """
    quantities, numbers = zip(*handed_in.values(), strict=True)
    follows = np.array([bool(one.follows) for one in numbers])
    astray = np.array([one.points is False for one in numbers])
    given = np.array([np.nan if one.vector is None else one.vector for one in numbers], dtype=complex)
    within = np.array([max(ASTRAY, one.within) for one in numbers])
    worded = {quantity.text for quantity, one in handed_in.values() if one.worded}
    explanations = []
    for one in diagnosis.explanations:
        columns = [(), *(tuple(known[name] for name in names if name in known) for names in one.names)]
        vectors = combined(method, plot, quantities, columns).vectors
        turned, off = (np.abs(np.angle(vectors[1:] * arrow.conj())) for arrow in (vectors[0], given))
        turned, other, reverse = turned > ASTRAY, off > within, astray & (off > np.pi - within)
        drawn = np.array([all(name in known for name in names) for names in one.names], dtype=bool)
        explained = np.array([text in one.explains for text in handed_in], dtype=bool) & drawn[:, None]
        said = [any(id == "sense-not-given" and worded & {*of} for id, _, of, _ in names) for names in one.names]
        against = (other & ~follows & np.where(explained, ~reverse, turned)).any(axis=1) | said
        count = np.where(against, -1, (turned & (astray | follows) & ~other).sum(axis=1))
        if (most := count.max()) >= 0:
            names = tuple(names for names, n in zip(one.names, count, strict=True) if n == most)
            explanations.append(replace(one, names=names))
    return replace(diagnosis, explanations=tuple(explanations))
