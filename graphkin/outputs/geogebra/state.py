"""All that a construction has found so far, as formulas of GeoGebra: the mirror image of `construction.Plot`."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from typing import assert_never

from graphkin import construction as kinds
from graphkin.construction import Arm, Plane, Span
from graphkin.outputs.geogebra.protocol import FormulaPair, Protocol, grouped, minus, plus, product, value

ORDERS: Mapping[Plane, int] = {"position": 0, "velocity": 1, "acceleration": 2}


Drives = tuple[list[str], list[str], list[str]]  # labels of each driver's value [rad, m], rate and acceleration


class GeogebraState:
    """Labels of points by plane, formulas of turns by base link and of displacements by slide.

    scales  SI units to a unit of the drawing [1/mm]; near  angles by base link [rad] at the drawn position
    """

    def __init__(
        self, protocol: Protocol, facts: kinds.Facts, drives: Drives, scales: Mapping[Plane, float],
        near: Mapping[str, float],
    ) -> None:  # fmt: skip
        self.protocol, self.facts, self.drives, self.scales, self.near = protocol, facts, drives, scales, near
        self.points: dict[Plane, dict[str, str]] = {plane: {} for plane in kinds.LETTER}
        self._turns: tuple[dict[str, str], ...] = ({facts.frame: "0"}, {facts.frame: "0"}, {facts.frame: "0"})
        self.slides: tuple[dict[str, str], ...] = tuple(
            {slide: labels[driver] for slide, driver in facts.slides_driven.items()} for labels in self.drives
        )

    def base(self, link: str) -> str:
        return self.facts.turns[link].base

    def relative(self, link: str, order: int, more: float = 0.0) -> str:
        """Angle (and `more` of it), rate or acceleration of a link against its base link."""
        turn = self.facts.turns[link]
        constant = turn.constant + more if order == 0 else 0.0
        total = value(constant if abs(constant) >= 1e-15 else 0.0)  # two constants cancel but for rounding
        for driver, sign in turn.drivers:
            total = plus(total, product(str(sign), self.drives[order][driver]))
        return total

    def turn(self, link: str, order: int, more: float = 0.0) -> str:
        """theta (and `more` of it), omega or alpha of a link."""
        return plus(self._turns[order][self.base(link)], self.relative(link, order, more))

    def settle(self, order: int, base: str, formula: str, *, counted: bool = False) -> None:
        """Give a group of links its angle or its rate; an angle not yet counted lies close to the drawn one."""
        label = self.protocol.number(formula)
        if order == 0 and not counted and base in self.near:
            near = value(self.near[base])
            label = self.protocol.number(f"{label} - 2 * pi * round(({label} - {near}) / (2 * pi))")
        self._turns[order][base] = label

    def displace(self, order: int, slide: str, formula: str) -> None:
        self.slides[order][slide] = self.protocol.number(formula)

    def drawn(self, tail: str, head: str, plane: Plane, factor: float = 1.0) -> FormulaPair:
        """Between two points of a plane [SI]."""
        points = self.points[plane]
        return FormulaPair.between(points[tail], points[head]).times(value(factor * self.scales[plane]))

    def arm(self, tail: str, head: str) -> FormulaPair:
        """Between two points of the mechanism [m]."""
        return self.drawn(tail, head, "position")

    def guide(self, slide: str) -> FormulaPair:
        """Unit vector of a slide's line."""
        link, _, direction = self.facts.lines[slide]
        return FormulaPair.along(self.turn(link, 0, cmath.phase(direction)))

    def slide_line(self, slide: str) -> FormulaPair:
        """Unit vector of a slide's line, in the axes of its guide's base link."""
        link, _, direction = self.facts.lines[slide]
        return FormulaPair.along(self.relative(link, 0, cmath.phase(direction)))

    def span(self, span: Span, without: str = "") -> FormulaPair:
        """Arms and displacements end to end, in the axes of their base link [m]; `without` one slide's."""
        total = FormulaPair()
        for part in span.parts:
            if isinstance(part, Arm):
                total += self.own_arm(part).by(FormulaPair.along(self.relative(part.link, 0)))
            elif part.slide != without:
                total += self.slide_line(part.slide).times(product(str(part.sign), self.slides[0][part.slide]))
        return total

    def own_arm(self, part: Arm) -> FormulaPair:
        """An arm in the axes of its link [m]."""
        return FormulaPair.of(self.facts.shapes[part.link][part.head] - self.facts.shapes[part.link][part.tail])

    def arrow(self, size: kinds.Size, plane: Plane) -> FormulaPair:
        """A known term [SI]."""
        match size:
            case kinds.Drawn(tail, head):
                return self.drawn(tail, head, plane)
            case Span():
                part = size.parts[0]
                base = self.base(part.link if isinstance(part, Arm) else self.facts.lines[part.slide][0])
                return self.span(size).by(FormulaPair.along(self.turn(base, 0)))
            case kinds.Turning(link, tail, head):
                return self.arm(tail, head).turned.times(self.turn(link, 1))
            case kinds.Normal(link, tail, head):
                return self.arm(tail, head).times(minus("0", f"{grouped(self.turn(link, 1))}^2"))
            case kinds.Tangential(link, tail, head):
                return self.arm(tail, head).turned.times(self.turn(link, 2))
            case kinds.Coriolis(link, tail, head):
                return self.drawn(tail, head, "velocity", 2).turned.times(self.turn(link, 1))
            case kinds.Driven(slide, sign):
                return self.guide(slide).times(product(str(sign), self.slides[ORDERS[plane]][slide]))
            case kinds.Relative(link, seen_from, tail, head, part_of):
                arm, order = self.arm(tail, head), 2 if part_of == "t" else 1
                against = grouped(minus(self.relative(link, order), self.relative(seen_from, order)))
                return arm.times(f"-{against}^2") if part_of == "n" else arm.turned.times(against)
            case _:
                assert_never(size)

    def direction(self, direction: kinds.Direction) -> tuple[FormulaPair, bool]:
        """A direction, and True where it is at right angles to it."""
        match direction:
            case kinds.Along(tail, head):
                return self.arm(tail, head), False
            case kinds.Across(tail, head):
                return self.arm(tail, head), True
            case kinds.AlongGuide(slide):
                return self.guide(slide), False
            case kinds.AcrossGuide(slide):
                return self.guide(slide), True
            case kinds.Quarter(_, tail, head):
                points = self.points["velocity"]
                return FormulaPair.between(points[tail], points[head]), True
            case _:
                assert_never(direction)

    def swing(self, span: Span, slide: str, arm: FormulaPair, side: int) -> str:
        """The displacement at which a link's line passes where it must, settled; and the angle's formula."""
        line = self.slide_line(slide)
        if kinds.Slid(slide) not in span.parts:
            line = line.times("-1")
        fixed = self.span(span, without=slide)
        half = f"sqrt({arm.dot(arm)} - {self.protocol.number(line.cross(fixed))}^2)"
        self.displace(0, slide, minus(product(str(side), half), line.dot(fixed)))
        return minus(arm.angle, self.bound(self.span(span)).angle)

    def bound(self, pair: FormulaPair) -> FormulaPair:
        """The same by the labels of two numbers, so that formulas stay short."""
        return FormulaPair(self.protocol.number(pair.x), self.protocol.number(pair.y))
