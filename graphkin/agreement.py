"""A replay beside the analytic solution.

`proved` is the one reader of a position for whatever is drawn or told: it replays the construction, solves the
mechanism anew by the matrix method, and gives neither where they differ.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from functools import reduce

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

__all__ = ["AGREE", "Proved", "apart", "apart_each", "compare", "proved"]

AGREE = 1e-6
"""Results of the two roads that differ by more are not given; the tests hold them to 1e-9."""

_Largest = Callable[[Sequence[Value]], Value]


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
        return float(_apart(mechanism, drawn, exact, _largest))


def apart_each(mechanism: Mechanism, drawn: Motions, exact: Motions) -> np.ndarray:
    """The same for each of many mechanisms that lie side by side: (b,)."""
    with np.errstate(all="ignore"):  # where either is nan
        return np.asarray(_apart(mechanism, drawn, exact, _largest_of_each))


def _apart(mechanism: Mechanism, drawn: Motions, exact: Motions, largest: _Largest) -> Value:
    points = mechanism.points
    links = {point: mechanism.owners[point][-1] for point in points}
    velocity, right_velocity = ({p: m.velocity_at(p, links[p]) for p in points} for m in (drawn, exact))
    acceleration, right_acceleration = ({p: m.acceleration_at(p, links[p]) for p in points} for m in (drawn, exact))
    size, rate = _sizes(exact, right_velocity, largest)
    pairs: list[tuple[Mapping[str, Value], Mapping[str, Value], Value]] = [
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
    return largest([largest(turned), *(_worst(*entry, largest) for entry in pairs)])


def _sizes(exact: Motions, velocity: Mapping[str, Value], largest: _Largest) -> tuple[Value, Value]:
    """Extent of the mechanism [m] and its fastest rotation, or speed over extent [rad/s]."""
    places = [exact.position[point] for point in velocity]
    size = largest([place - places[0] for place in places])
    size = size + (size == 0)
    return size, largest([*(v / size for v in (*velocity.values(), *exact.s_rate.values())), *exact.omega.values()])


def _worst(drawn: Mapping[str, Value], right: Mapping[str, Value], natural: Value, largest: _Largest) -> Value:
    size = largest([natural, *(right[name] for name in drawn)])
    return largest([drawn[name] - right[name] for name in drawn]) / (size + (size == 0))


def _largest(values: Sequence[Value]) -> float:
    """The largest size of all values (nan where one is nan), 0 of none."""
    sizes = [float(np.max(np.abs(value)) if isinstance(value, np.ndarray) else abs(value)) for value in values]
    return math.nan if any(map(math.isnan, sizes)) else max(sizes, default=0.0)


def _largest_of_each(values: Sequence[Value]) -> Value:
    """The same for each mechanism."""
    return reduce(np.maximum, map(np.abs, values), 0.0)
