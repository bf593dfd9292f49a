"""Lengths and angles of a link, and the circles and straight lines they make of where a point may lie.

Unlike `graphkin.base.geometry` this works on one layout at a time and must decide: curves that touch within 1e-9
of their size touch in one point, as three collinear points want it.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping

from graphkin.base.value import frozen

TOUCHES = 1e-9
"""Two curves closer than this part of their size touch."""


@frozen
class CircleCurve:
    centre: complex
    radius: float


@frozen
class StraightLine:
    """Through `point` along the unit vector `along`."""

    point: complex
    along: complex

    def distance(self, place: complex) -> float:
        return abs(((place - self.point) * self.along.conjugate()).imag)


Curve = CircleCurve | StraightLine
Places = Mapping[str, complex]
Triple = tuple[str, str, str]


@frozen
class Length:
    """`AB = 24`."""

    key: str
    points: tuple[str, str]
    value: float

    def curves(self, point: str, placed: Places) -> list[Curve]:
        """Where `point` may lie, the other point being placed."""
        other = self.points[1] if point == self.points[0] else self.points[0]
        return [CircleCurve(placed[other], self.value)]

    def miss(self, placed: Places) -> float:
        """How far a layout is off this length [m]."""
        a, b = (placed[point] for point in self.points)
        return abs(abs(b - a) - self.value)


@frozen
class AngleMeasure:
    """`BDE = 90`: the angle at the middle point, 0 to pi."""

    key: str
    points: Triple
    value: float

    def curves(self, point: str, placed: Places) -> list[Curve]:
        """Where `point` may lie, the other two points being placed."""
        first, vertex, last = self.points
        if point == vertex:
            return _equal_angles(placed[first], placed[last], self.value)
        along = placed[last if point == first else first] - placed[vertex]
        if along == 0:
            return []
        turns = {cmath.rect(1, self.value), cmath.rect(1, -self.value)}
        return [StraightLine(placed[vertex], along / abs(along) * turn) for turn in turns]

    def miss(self, placed: Places) -> float:
        """How far the end of the shorter arm is off this angle [m]."""
        first, vertex, last = (placed[point] for point in self.points)
        one, other = first - vertex, last - vertex
        if one == 0 or other == 0:
            return 0.0
        return abs(abs(cmath.phase(one / other)) - self.value) * min(abs(one), abs(other))


Measure = Length | AngleMeasure


def _equal_angles(a: complex, b: complex, angle: float) -> list[Curve]:
    """The points that see the stretch ab under an angle."""
    if a == b:
        return []
    if math.sin(angle) < 1e-9:
        return [StraightLine(a, (b - a) / abs(b - a))]
    offset = (b - a) / 2j / math.tan(angle)
    return [CircleCurve((a + b) / 2 + side * offset, abs(b - a) / 2 / math.sin(angle)) for side in (1, -1)]


def crossings(one: Curve, other: Curve) -> list[complex]:
    """The points two curves share: none, one or two; none if they coincide."""
    if isinstance(one, CircleCurve):
        return _two_circles(one, other) if isinstance(other, CircleCurve) else _line_and_circle(other, one)
    return _line_and_circle(one, other) if isinstance(other, CircleCurve) else _two_lines(one, other)


def gap(one: Curve, other: Curve) -> float:
    """How far two curves that do not cross stay apart; 0 if they coincide."""
    if isinstance(one, StraightLine):
        return one.distance(other.point) if isinstance(other, StraightLine) else gap(other, one)
    if isinstance(other, StraightLine):
        return max(other.distance(one.centre) - one.radius, 0.0)
    apart = abs(one.centre - other.centre)
    return max(apart - one.radius - other.radius, abs(one.radius - other.radius) - apart, 0.0)


def _two_circles(one: CircleCurve, other: CircleCurve) -> list[complex]:
    between = other.centre - one.centre
    apart = abs(between)
    size = max(apart, one.radius, other.radius)
    if apart <= TOUCHES * size:
        return []
    along = between / apart
    outside = apart - one.radius - other.radius
    inside = abs(one.radius - other.radius) - apart
    if max(outside, inside) > TOUCHES * size:
        return []
    if abs(outside) <= TOUCHES * size:
        return [one.centre + one.radius * along]
    if abs(inside) <= TOUCHES * size:
        return [one.centre + (one.radius if one.radius > other.radius else -one.radius) * along]
    foot = (apart + (one.radius - other.radius) * (one.radius + other.radius) / apart) / 2
    height = math.sqrt(max((one.radius - foot) * (one.radius + foot), 0.0))
    return [one.centre + along * complex(foot, side * height) for side in (1, -1)]


def _line_and_circle(line: StraightLine, circle: CircleCurve) -> list[complex]:
    offset = (circle.centre - line.point) * line.along.conjugate()
    foot = line.point + offset.real * line.along
    room = circle.radius - abs(offset.imag)
    if abs(room) <= TOUCHES * circle.radius:
        return [foot]
    if room < 0:
        return []
    half = math.sqrt(room * (circle.radius + abs(offset.imag)))
    return [foot + half * line.along, foot - half * line.along]


def _two_lines(one: StraightLine, other: StraightLine) -> list[complex]:
    sine = (one.along.conjugate() * other.along).imag
    if abs(sine) <= TOUCHES:
        return []
    reach = ((other.point - one.point) * other.along.conjugate()).imag / -sine
    return [one.point + reach * one.along]
