"""The drawing board: what is on it after the steps, and the drawing that may lie underneath."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from graphkin.base.geometry import Value, unit
from graphkin.base.value import frozen
from graphkin.construction.drafting.projective import Homogeneous, along, foot, improper, place, product, proper, scalar


@frozen
class Underlay:
    """The drawing under the board: points and lines that can be pricked through and traced."""

    points: dict[str, Homogeneous] = field(default_factory=dict)
    lines: dict[str, Homogeneous] = field(default_factory=dict)


def _exactly(value: Value) -> Value:
    return value


@dataclass
class Board:
    """Points, lines, circles (centre [m] and radius [m]), numbers [SI]; single ones, or arrays over positions.

    origin, size   where coordinates are counted from [m], and their unit [m]
    read           how the ruler reads a length [m]: exactly, if nothing else is said
    lean           by point: how far the two lines that meet in it are from being one, 0 to 1
    """

    origin: complex = 0j
    size: float = 1.0
    underlay: Underlay = field(default_factory=Underlay)
    points: dict[str, Homogeneous] = field(default_factory=dict)
    lines: dict[str, Homogeneous] = field(default_factory=dict)
    circles: dict[str, tuple[Value, Value]] = field(default_factory=dict)
    numbers: dict[str, Value] = field(default_factory=dict)
    lean: dict[str, Value] = field(default_factory=dict)
    read: Callable[[Value], Value] = _exactly

    def at(self, point: str) -> Value:
        """Where a point is [m]; infinite at infinity, NaN where what should give it does not meet."""
        return place(self.points[point], self.origin, self.size)

    @property
    def places(self) -> dict[str, Value]:
        """Where all points are [m]."""
        return {point: self.at(point) for point in self.points}

    def direction(self, point: str) -> Value:
        """The direction in which a point at infinity lies [rad], in (-pi/2, pi/2]."""
        x, y, _ = self.points[point]
        angle = np.arctan2(y, x)
        return np.where(angle > np.pi / 2, angle - np.pi, np.where(angle <= -np.pi / 2, angle + np.pi, angle))[()]

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
        """A point of a line [m], and its direction (unit vector)."""
        return self.origin + self.size * foot(self.lines[name]), along(self.lines[name])

    def seen(self, at: Value) -> Homogeneous:
        """A place [m] in the coordinates of the board."""
        return proper((at - self.origin) / self.size)

    def sloping(self, at: Value, direction: Value) -> Homogeneous:
        """The line through a place [m] in a direction (unit vector)."""
        return product(self.seen(at), improper(direction))
