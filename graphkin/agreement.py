"""A replay beside the analytic solution.

`proved` is the one reader of a position for whatever is drawn or told: it replays the construction, solves the
mechanism anew by the matrix method, and gives neither where they differ.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from graphkin.analytic import Motion, motion
from graphkin.construction import Plot
from graphkin.errors import RoadsDiffer
from graphkin.geometry import Value
from graphkin.mechanism import Mechanism
from graphkin.motions import Motions
from graphkin.planning import Method
from graphkin.readings import readings
from graphkin.running import replay_all
from graphkin.value import frozen

__all__ = ["AGREE", "Proved", "apart", "compare", "proved"]

AGREE = 1e-6
"""Results of the two roads that differ by more are not given; the tests hold them to 1e-9."""


@frozen
class Proved:
    """One position by both roads: the replayed construction, the analytic solution, and how far they differ."""

    plot: Plot
    exact: Motion
    worst: float


def proved(method: Method, values: Sequence[float] | None = None) -> Proved:
    """The drawn position, or the one at driver `values` [rad, m], proved.

    Raises RoadsDiffer where the two roads differ by more than `AGREE`, and what either road raises: dead points,
    positions that are not reached, mechanisms that cannot be assembled.
    """
    plot = replay_all(method, values)
    exact = motion(method.mechanism, plot.facts.values)
    worst = compare(method, plot, exact)
    if not worst < AGREE:
        raise RoadsDiffer(method.mechanism.where("driver", 0), worst)
    return Proved(plot, exact, worst)


def compare(method: Method, plot: Plot, exact: Motion) -> float:
    """The worst relative difference between a replay and the analytic solution."""
    return apart(method.mechanism, readings(method, plot), exact)


def apart(mechanism: Mechanism, drawn: Motions, exact: Motions) -> float:
    """The worst relative difference between motions found by two roads; nan where either has none.

    Each kind of quantity is measured by the largest of its kind in the mechanism, or by what the lengths and
    speeds make of it (an angular acceleration of 0 by omega^2); angles in radians.
    """
    with np.errstate(invalid="ignore"):  # where either is nan
        return _apart(mechanism, drawn, exact)


def _apart(mechanism: Mechanism, drawn: Motions, exact: Motions) -> float:
    points = mechanism.points
    links = {point: mechanism.owners[point][-1] for point in points}
    velocity, right_velocity = ({p: m.velocity_at(p, links[p]) for p in points} for m in (drawn, exact))
    acceleration, right_acceleration = ({p: m.acceleration_at(p, links[p]) for p in points} for m in (drawn, exact))
    size, rate = _sizes(exact, right_velocity)
    pairs: list[tuple[Mapping[str, Value], Mapping[str, Value], float]] = [
        (drawn.omega, exact.omega, rate),
        (drawn.alpha, exact.alpha, rate**2),
        (drawn.s, exact.s, size),
        (drawn.s_rate, exact.s_rate, rate * size),
        (drawn.s_acceleration, exact.s_acceleration, rate**2 * size),
        ({point: drawn.position[point] for point in points}, exact.position, size),
        (velocity, right_velocity, rate * size),
        (acceleration, right_acceleration, rate**2 * size),
    ]
    turned = [np.exp(1j * (drawn.theta[link] - exact.theta[link])) - 1 for link in drawn.theta]
    return _largest([_largest(turned), *(_worst(*entry) for entry in pairs)])


def _sizes(exact: Motions, velocity: Mapping[str, Value]) -> tuple[float, float]:
    """Extent of the mechanism [m] and its fastest rotation, or speed over extent [rad/s]."""
    places = [exact.position[point] for point in velocity]
    size = _largest([place - places[0] for place in places]) or 1.0
    return size, _largest([*(v / size for v in (*velocity.values(), *exact.s_rate.values())), *exact.omega.values()])


def _worst(drawn: Mapping[str, Value], right: Mapping[str, Value], natural: float) -> float:
    size = _largest([natural, *(right[name] for name in drawn)]) or 1.0
    return _largest([drawn[name] - right[name] for name in drawn]) / size


def _largest(values: Sequence[Value]) -> float:
    """The largest size of all values (nan where one is nan), 0 of none."""
    sizes = [float(np.max(np.abs(value)) if isinstance(value, np.ndarray) else abs(value)) for value in values]
    return math.nan if any(map(math.isnan, sizes)) else max(sizes, default=0.0)
