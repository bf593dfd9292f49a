"""Positions, velocities and accelerations by name, whichever road they come from."""

from __future__ import annotations

import cmath
from collections.abc import Callable, Mapping

import numpy as np

from graphkin.base.geometry import Real, Value, number
from graphkin.base.value import frozen
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.pairs import Line


@frozen
class Motions:
    """Positions, velocities and accelerations, SI; every value a scalar or an array over positions.

    theta, omega, alpha         by moving link [rad, rad/s, rad/s^2]
    s, s_rate, s_acceleration   by slide, and by roll on a line (of the centre) [m, m/s, m/s^2]
    position                    by point, complex [m]
    velocities, accelerations   by moving link, then by those of its points that are known at once, complex
                                [m/s, m/s^2]; at least one of each link, from which its other points are read
    """

    mechanism: Mechanism
    theta: Mapping[str, Real]
    omega: Mapping[str, Real]
    alpha: Mapping[str, Real]
    s: Mapping[str, Real]
    s_rate: Mapping[str, Real]
    s_acceleration: Mapping[str, Real]
    position: Mapping[str, Value]
    velocities: Mapping[str, Mapping[str, Value]]
    accelerations: Mapping[str, Mapping[str, Value]]

    def along(self, line: Line) -> complex:
        """The unit vector of a line of a link as it lies, at a single position."""
        return line.direction * cmath.rect(1, number(self.theta[line.link]))

    def velocity_at(self, point: str, link: str) -> Value:
        """Velocity of the point of `link` that lies under `point` at this instant [m/s]: known, or by image."""
        return self._by_image(self.velocities, point, link, lambda: 1j * self.omega[link])

    def acceleration_at(self, point: str, link: str) -> Value:
        """Acceleration of the point of `link` that lies under `point` at this instant [m/s^2]."""
        return self._by_image(self.accelerations, point, link, lambda: 1j * self.alpha[link] - self.omega[link] ** 2)

    def _by_image(
        self, tables: Mapping[str, Mapping[str, Value]], point: str, link: str, ratio: Callable[[], Value]
    ) -> Value:
        """The motion of a point: as known, else from another point of the link by the `ratio` of image and link."""
        if link == FRAME:  # none, in the shape of the positions; nan where these are
            return 0 * self.position[point] + 0j
        known = tables[link]
        if point in known:
            value = known[point]
            return value if isinstance(value, np.ndarray) else value + 0j  # a number without -0
        base = next(iter(known))
        return known[base] + ratio() * (self.position[point] - self.position[base])

    def turning(self, link: str) -> Real:
        """Angular velocity of a link, the frame's too [rad/s]."""
        return 0.0 if link == FRAME else self.omega[link]

    def swing(self, link: str) -> Real:
        """Angular acceleration of a link, the frame's too [rad/s^2]."""
        return 0.0 if link == FRAME else self.alpha[link]
