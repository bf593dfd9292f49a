"""What is nothing but the rounding of computing, by what is usual in a mechanism: the one rule for every 0."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from graphkin.construction import Plane, Plot
from graphkin.value import frozen

ROUNDING = 1e-9
"""Sizes below this part of the largest of their kind are rounding noise."""


@frozen
class Usual:
    """The sizes that are usual at one position: length [m], velocity and acceleration, omega and alpha [SI]."""

    length: float
    velocity: float
    acceleration: float
    omega: float
    alpha: float

    @classmethod
    def of(cls, plot: Plot) -> Usual:
        places = [complex(place) for place in plot.position.values()]
        length = _largest(place - places[0] for place in places) or 1.0
        speed = _largest(plot.velocity.values())
        omega = max(_largest(plot.omega.values()), speed / length)
        more = max(_largest(plot.acceleration.values()), omega**2 * length)
        return cls(length, speed, more, omega, max(_largest(plot.alpha.values()), more / length))

    def rate(self, value: float, plane: Plane) -> float:
        """omega or alpha, as the plane has it; 0 where it is but noise."""
        return cut(value, self.omega if plane == "velocity" else self.alpha)

    def motion(self, value: float, plane: Plane) -> float:
        """A speed or an acceleration, as the plane has it; 0 where it is but noise."""
        return cut(value, self.velocity if plane == "velocity" else self.acceleration)


def cut(value: float, largest: float) -> float:
    """The value, or 0 where it is rounding noise beside the largest of its kind."""
    return value if abs(value) > ROUNDING * largest else 0.0


def _largest(values: Iterable[object]) -> float:
    return max((float(np.abs(value)) for value in values), default=0.0)  # type: ignore[call-overload]
