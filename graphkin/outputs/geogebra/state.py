"""What a construction has found so far, as formulas of GeoGebra: the mirror image of `construction.Plot`."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from typing import assert_never

from graphkin.base.value import frozen
from graphkin.construction import (
    LETTER,
    Across,
    AcrossGuide,
    Along,
    AlongGuide,
    Arm,
    Coriolis,
    Direction,
    Drawn,
    Driven,
    Facts,
    Normal,
    Plane,
    Quarter,
    Relative,
    Size,
    Slid,
    Span,
    Tangential,
    Turning,
)
from graphkin.outputs.geogebra.protocol import (
    NOTHING,
    FormulaPair,
    Protocol,
    along,
    between,
    grouped,
    known,
    minus,
    plus,
    product,
    value,
)

ORDERS: Mapping[Plane, int] = {"position": 0, "velocity": 1, "acceleration": 2}


@frozen
class Drives:
    """The labels of each driver's value [rad, m], rate and acceleration."""

    values: tuple[str, ...]
    rates: tuple[str, ...]
    accelerations: tuple[str, ...]


class GeogebraState:
    """Labels of points by plane, formulas of turns by base link and of displacements by slide.

    scales  SI units to a unit of the drawing [1/mm]; near  angles by base link [rad] at the drawn position
    """

    def __init__(
        self, protocol: Protocol, facts: Facts, drives: Drives, scales: Mapping[Plane, float], near: Mapping[str, float]
    ) -> None:
        self.protocol, self.facts, self.drives, self.scales, self.near = protocol, facts, drives, scales, near
        self.points: dict[Plane, dict[str, str]] = {plane: {} for plane in LETTER}
        self._turns: tuple[dict[str, str], ...] = ({facts.frame: "0"}, {facts.frame: "0"}, {facts.frame: "0"})
        self.slides: tuple[dict[str, str], ...] = tuple(
            {slide: given[driver] for slide, driver in facts.slides_driven.items()}
            for given in (drives.values, drives.rates, drives.accelerations)
        )

    # --- turns and displacements ---

    def relative(self, link: str, order: int, more: float = 0.0) -> str:
        """Angle (and `more` of it), rate or acceleration of a link against its base link."""
        turn = self.facts.turns[link]
        given = (self.drives.values, self.drives.rates, self.drives.accelerations)[order]
        total = value(_rounded(turn.constant + more) if order == 0 else 0.0)
        for driver, sign in turn.drivers:
            total = plus(total, product(str(sign), given[driver]))
        return total

    def turn(self, link: str, order: int, more: float = 0.0) -> str:
        """theta (and `more` of it), omega or alpha of a link."""
        return plus(self._turns[order][self.facts.turns[link].base], self.relative(link, order, more))

    def settle(self, order: int, base: str, formula: str, *, counted: bool = False) -> None:
        """Give a group of links its angle or its rate; an angle not yet counted lies close to the drawn one."""
        label = self.protocol.number(formula)
        if order == 0 and not counted and base in self.near:
            near = value(self.near[base])
            label = self.protocol.number(f"{label} - 2 * pi * round(({label} - {near}) / (2 * pi))")
        self._turns[order][base] = label

    def displace(self, order: int, slide: str, formula: str) -> None:
        self.slides[order][slide] = self.protocol.number(formula)

    # --- arrows ---

    def arm(self, tail: str, head: str) -> FormulaPair:
        """Between two points of the mechanism [m]."""
        points = self.points["position"]
        return between(points[tail], points[head]).times(value(self.scales["position"]))

    def direction_of(self, link: str) -> FormulaPair:
        """The unit vector along a link's own x axis."""
        return self.bound(along(self.turn(link, 0)))

    def guide(self, slide: str) -> FormulaPair:
        """Unit vector of a slide's line."""
        link, _, direction = self.facts.lines[slide]
        return along(self.turn(link, 0, cmath.phase(direction)))

    def slide_line(self, slide: str) -> FormulaPair:
        """Unit vector of a slide's line, in the axes of its guide's base link."""
        link, _, direction = self.facts.lines[slide]
        return along(self.relative(link, 0, cmath.phase(direction)))

    def span(self, span: Span, without: str = "") -> FormulaPair:
        """Arms and displacements end to end, in the axes of their base link [m]; `without` one slide's."""
        total = NOTHING
        for part in span.parts:
            if isinstance(part, Arm):
                shape = self.facts.shapes[part.link]
                total += known(shape[part.head] - shape[part.tail]).by(along(self.relative(part.link, 0)))
            elif part.slide != without:
                total += self.slide_line(part.slide).times(product(str(part.sign), self.slides[0][part.slide]))
        return total

    def base_of(self, span: Span) -> str:
        part = span.parts[0]
        link = part.link if isinstance(part, Arm) else self.facts.lines[part.slide][0]
        return self.facts.turns[link].base

    def arrow(self, size: Size, plane: Plane) -> FormulaPair:
        """A known term [SI]."""
        order = ORDERS[plane]
        match size:
            case Drawn(tail, head):
                points = self.points[plane]
                return between(points[tail], points[head]).times(value(self.scales[plane]))
            case Span():
                base = self.base_of(size)
                return self.span(size).by(along(self.turn(base, 0)))
            case Turning(link, tail, head):
                return self.arm(tail, head).turned.times(self.turn(link, 1))
            case Normal(link, tail, head):
                return self.arm(tail, head).times(minus("0", f"{grouped(self.turn(link, 1))}^2"))
            case Tangential(link, tail, head):
                return self.arm(tail, head).turned.times(self.turn(link, 2))
            case Coriolis(link, tail, head):
                points = self.points["velocity"]
                seen = between(points[tail], points[head]).times(value(2 * self.scales["velocity"]))
                return seen.turned.times(self.turn(link, 1))
            case Driven(slide, sign):
                return self.guide(slide).times(product(str(sign), self.slides[order][slide]))
            case Relative(link, seen_from, tail, head, part):
                arm = self.arm(tail, head)
                rate = 2 if part == "t" else 1
                against = grouped(minus(self.relative(link, rate), self.relative(seen_from, rate)))
                return arm.times(f"-{against}^2") if part == "n" else arm.turned.times(against)
            case _:
                assert_never(size)

    def direction(self, direction: Direction) -> tuple[FormulaPair, bool]:
        """A direction, and whether it is at right angles to what is given."""
        match direction:
            case Along(tail, head):
                return self.arm(tail, head), False
            case Across(tail, head):
                return self.arm(tail, head), True
            case AlongGuide(slide):
                return self.guide(slide), False
            case AcrossGuide(slide):
                return self.guide(slide), True
            case Quarter(_, tail, head):
                points = self.points["velocity"]
                return between(points[tail], points[head]), True
            case _:
                assert_never(direction)

    def swing(self, span: Span, slide: str, way: FormulaPair, side: int) -> str:
        """The displacement at which a link's line passes where it must, settled; and the angle's formula."""
        line = self.slide_line(slide)
        if Slid(slide) not in span.parts:
            line = line.times("-1")
        fixed = self.span(span, without=slide)
        offset = self.protocol.number(line.cross(fixed))
        half = f"sqrt({way.square} - {offset}^2)"
        self.displace(0, slide, minus(product(str(side), half), line.dot(fixed)))
        return minus(way.angle, self.bound(self.span(span)).angle)

    def bound(self, pair: FormulaPair) -> FormulaPair:
        """The same by the labels of two numbers, so that formulas stay short."""
        return FormulaPair(self.protocol.number(pair.x), self.protocol.number(pair.y))


def _rounded(angle: float) -> float:
    """Nothing, where two constants cancel but for rounding."""
    return 0.0 if abs(angle) < 1e-15 else angle
