"""What moves how: positions, velocities and accelerations by name, whichever road they come from."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from graphkin.base.geometry import Real, Value
from graphkin.base.value import frozen
from graphkin.model.mechanism import FRAME, Mechanism

__all__ = ["Motions"]


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

    def velocity_at(self, point: str, link: str) -> Value:
        """Velocity of the point of `link` that lies under `point` at this instant [m/s]: known, or by image."""
        if link == FRAME:
            return self._still(point)
        known = self.velocities[link]
        if (base := _base(known, point)) == point:
            return _as_it_is(known[base])
        return known[base] + 1j * self.omega[link] * (self.position[point] - self.position[base])

    def acceleration_at(self, point: str, link: str) -> Value:
        """Acceleration of the point of `link` that lies under `point` at this instant [m/s^2]."""
        if link == FRAME:
            return self._still(point)
        known = self.accelerations[link]
        if (base := _base(known, point)) == point:
            return _as_it_is(known[base])
        turning = 1j * self.alpha[link] - self.omega[link] ** 2
        return known[base] + turning * (self.position[point] - self.position[base])

    def _still(self, point: str) -> Value:
        """Nothing, in the shape of the positions; nan where these are."""
        return 0 * self.position[point] + 0j

    def turning(self, link: str) -> Value:
        """Angular velocity of a link, the frame's too [rad/s]."""
        return 0.0 if link == FRAME else self.omega[link]

    def swing(self, link: str) -> Value:
        """Angular acceleration of a link, the frame's too [rad/s^2]."""
        return 0.0 if link == FRAME else self.alpha[link]


def _base(known: Mapping[str, Value], point: str) -> str:
    return point if point in known else next(iter(known))


def _as_it_is(value: Value) -> Value:
    """A number without -0; what is known of many positions is not copied."""
    return value if isinstance(value, np.ndarray) else value + 0j
