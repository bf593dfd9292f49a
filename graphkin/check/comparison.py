"""A replay beside the analytic solution."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from graphkin.analytic import Motion
from graphkin.geometry import Value
from graphkin.methods import Method
from graphkin.readings import Readings
from graphkin.steps import Plot

__all__ = ["compare"]


def compare(method: Method, plot: Plot, exact: Motion) -> float:
    """The worst relative difference between a replay and the analytic solution.

    Each kind of quantity is measured by the largest of its kind in the mechanism, or by what the lengths and
    speeds make of it (an angular acceleration of 0 by omega^2); angles in radians.
    """
    readings, points = Readings(method, plot), method.mechanism.points
    links = {point: method.mechanism.owners[point][-1] for point in points}
    velocity = {point: readings.velocity_at(point, links[point]) for point in points}
    acceleration = {point: readings.acceleration_at(point, links[point]) for point in points}
    size, rate = _sizes(exact, points)
    pairs: list[tuple[Mapping[str, Value], Mapping[str, Value], float]] = [
        (readings.omega, exact.omega, rate),
        (readings.alpha, exact.alpha, rate**2),
        (readings.s, exact.s, size),
        (readings.s_rate, exact.s_rate, rate * size),
        (readings.s_acceleration, exact.s_acceleration, rate**2 * size),
        ({point: readings.position[point] for point in points}, exact.position, size),
        (velocity, exact.velocity, rate * size),
        (acceleration, exact.acceleration, rate**2 * size),
    ]
    turned = [np.abs(np.exp(1j * (readings.theta[link] - exact.theta[link])) - 1) for link in readings.theta]
    return max(float(np.max(turned, initial=0.0)), *(_worst(*entry) for entry in pairs))


def _sizes(exact: Motion, points: tuple[str, ...]) -> tuple[float, float]:
    """Extent of the mechanism [m] and its fastest rotation, or speed over extent [rad/s]."""
    places = np.array([exact.position[point] for point in points])
    size = float(np.max(np.abs(places - places[0]))) or 1.0
    speeds = [np.abs(v) / size for v in (*exact.velocity.values(), *exact.s_rate.values())]
    return size, float(np.max([*speeds, *(np.abs(w) for w in exact.omega.values())]))


def _worst(drawn: Mapping[str, Value], right: Mapping[str, Value], natural: float) -> float:
    if not drawn:
        return 0.0
    first = np.array([drawn[name] for name in drawn])
    second = np.array([right[name] for name in drawn])
    size = max(float(np.max(np.abs(second))), natural)
    off = float(np.max(np.abs(first - second)))
    return off / size if size > 0 else off
