"""The drawing board, and its points and lines as three homogeneous coordinates.

A join and a meeting are one product then, and infinity is a place. A point is (x, y, w), a direction where w = 0; a
line is (a, b, c) with a x + b y + c w = 0. Each is (3,), or (3, n) over positions; what two that coincide would
give is NaN.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from graphkin.base.geometry import Array, Real, Value, unit
from graphkin.base.value import frozen

Homogeneous = Array  # three coordinates (3,) or (3, n)

INFINITE = 1e-9  # a point farther off than the unit of coordinates divided by this counts as at infinity


def improper(direction: Value) -> Homogeneous:
    """The point at infinity in a direction (unit vector)."""
    return np.array([np.real(direction), np.imag(direction), np.zeros_like(np.real(direction))])


def balanced(coordinates: Homogeneous) -> Homogeneous:
    """The same point or line, its coordinates of length 1."""
    if not np.ndim(length := reach(coordinates)) and length > 0:
        return coordinates / length
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(coordinates / length)


def reach(coordinates: Homogeneous) -> Array:
    """Their length."""
    a, b, c = coordinates
    length: Array = np.sqrt(a * a + b * b + c * c)
    return length


def product(one: Homogeneous, other: Homogeneous) -> Homogeneous:
    """The line through two points, or the point on two lines."""
    (a, b, c), (d, e, f) = one, other
    return np.array((b * f - c * e, c * d - a * f, a * e - b * d))


def joined(one: Homogeneous, other: Homogeneous) -> Homogeneous:
    """The line through two points; NaN where they are one but for rounding, as at infinity in one direction."""
    line = product(balanced(one), balanced(other))
    return np.where(reach(line) > INFINITE, line, np.nan)


def along(line: Homogeneous) -> Value:
    """The direction of a line (unit vector), from the first to the second of two points that it joins."""
    a, b, _ = line
    with np.errstate(divide="ignore", invalid="ignore"):
        return scalar((b - 1j * a) / np.hypot(a, b))


def scalar(value: Value) -> Value:
    """An array as it is, a single value as Python's own."""
    if np.ndim(value):
        return value
    single: complex = np.asarray(value).item()
    return single


@frozen
class Underlay:
    """The drawing under the board: points and lines that can be pricked through and traced."""

    points: dict[str, Homogeneous] = field(default_factory=dict)
    lines: dict[str, Homogeneous] = field(default_factory=dict)


@dataclass
class Board:
    """Points, lines, circles (centre [m] and radius [m]), numbers [SI]; single ones, or arrays over positions.

    origin, size   where coordinates are counted from [m], and their unit [m]
    read           reads a length with the ruler [m]: exactly, if nothing else is said
    lean           by point: how far the two lines that meet in it are from being one, 0 to 1
    """

    origin: complex = 0j
    size: float = 1.0
    underlay: Underlay = field(default_factory=Underlay)
    points: dict[str, Homogeneous] = field(default_factory=dict)
    lines: dict[str, Homogeneous] = field(default_factory=dict)
    circles: dict[str, tuple[Value, Real]] = field(default_factory=dict)
    numbers: dict[str, Real] = field(default_factory=dict)
    lean: dict[str, Real] = field(default_factory=dict)
    read: Callable[[Real], Real] = lambda length: length

    def at(self, point: str) -> Value:
        """The place of a point [m]; infinite at infinity, NaN where what should give it does not meet."""
        x, y, w = self.points[point]
        with np.errstate(divide="ignore", invalid="ignore"):
            off = np.hypot(x, y)
            far, infinite = np.abs(w) <= INFINITE * off, np.where(off > 0, np.inf, np.nan)
            return scalar(np.where(far, infinite, self.origin + self.size * (x + 1j * y) / w))

    @property
    def places(self) -> dict[str, Value]:
        """The places of all points [m]."""
        return {point: self.at(point) for point in self.points}

    def direction(self, point: str) -> Real:
        """The direction in which a point at infinity lies [rad], in (-pi/2, pi/2]."""
        x, y, _ = self.points[point]
        angle = np.arctan2(y, x)
        raised = np.where(angle <= -np.pi / 2, angle + np.pi, angle)
        return np.asarray(np.where(angle > np.pi / 2, angle - np.pi, raised))[()]

    def toward(self, at: str, point: str) -> Value:
        """Unit vector from a point to another, +x where there is none; NaN where both are at one place."""
        if not point:
            return 1.0 + 0j
        place = self.at(point)
        return scalar(np.where(np.isinf(place), self.away(point), unit(place - self.at(at))))

    def away(self, point: str) -> Value:
        """One of the two directions in which a point at infinity lies (unit vector), the same whenever it is asked."""
        x, y, _ = self.points[point]
        return unit(x + 1j * y)

    def line(self, name: str) -> tuple[Value, Value]:
        """The point of a line that is nearest to the origin [m], and its direction (unit vector)."""
        a, b, c = self.lines[name]
        with np.errstate(divide="ignore", invalid="ignore"):
            foot = scalar(-c * (a + 1j * b) / (a * a + b * b))
        return self.origin + self.size * foot, along(self.lines[name])

    def seen(self, at: Value) -> Homogeneous:
        """A place [m] in the coordinates of the board."""
        near = (at - self.origin) / self.size
        return np.array([np.real(near), np.imag(near), np.ones_like(np.real(near))])

    def sloping(self, at: Value, direction: Value) -> Homogeneous:
        """The line through a place [m] in a direction (unit vector)."""
        return product(self.seen(at), improper(direction))
