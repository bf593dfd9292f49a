"""Conditions that are asked at single positions: the slowest point of a line, and the speed the drivers must have."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from graphkin.base.value import frozen
from graphkin.errors import CannotScale, GivenTwice, NegativeSize, NoLineOf, NoSuchDriver, NotScaled, Where
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import Mechanism
from graphkin.model.naming import common_link, pair
from graphkin.planning import Method
from graphkin.proof import roads as agreement
from graphkin.running.other_positions import reached
from graphkin.running.path import DriverPath
from graphkin.studies.finding.answers import Position, SlowPoint, Speeds
from graphkin.studies.finding.conditions import WHERE, Scaling, Slowest, value
from graphkin.studies.finding.quantities import looked_for
from graphkin.studies.sweeps import Road, course, prove
from graphkin.studies.sweeps.quantities import series
from graphkin.studies.sweeps.roads import moving


@frozen
class SearchPoints:
    """Positions t (n,) on a way, and the motions there."""

    path: DriverPath
    swept: int
    t: np.ndarray
    motions: Motions

    def position(self, k: int, values: tuple[float, ...]) -> Position:
        drivers = tuple(float(value) for value in self.path.values(float(self.t[k])))
        return Position(float(self.t[k]), drivers, values, "here")


def spots(method: Method, ranges: Sequence[str], by: Road) -> SearchPoints:
    """The drawn position; with `AB=30` (no steps) that one; with ranges all of theirs."""
    if any(":" in text for text in ranges):
        moved = course(method, ranges)
        prove(moved)
        return SearchPoints(moved.path, moved.swept, moved.t, moving(method, moved.path, moved.t, by))
    values = _values(method, ranges)
    agreement.proved(method, values)
    path, t = reached(method, values)
    at = np.array([t])
    return SearchPoints(path, 0, at, moving(method, path, at, by))


def _values(method: Method, ranges: Sequence[str]) -> list[float]:
    """The drivers' values at the drawn position, with those of `AB=30` put in."""
    values = [float(value) for value in method.facts(None).values]
    names = [driver.name for driver in method.drivers]
    seen: set[int] = set()
    for number, text in enumerate(ranges):
        name, equals, given = text.rpartition("=")
        if (equals and name.strip() not in names) or (not equals and number >= len(names)):
            raise NoSuchDriver(Where("--driver"), name.strip() or text, tuple(names))
        at = names.index(name.strip()) if equals else number
        if at in seen:
            raise GivenTwice(Where("--driver"), names[at])
        seen.add(at)
        values[at] = value(given.strip(), "m" if method.drivers[at].kind == "slide" else "rad", Where("--driver"))
    return values


# --- the slowest point of a line --------------------------------------------------------------


def line_of(mechanism: Mechanism, of: str) -> tuple[str, str, str]:
    """The link and two of its points that `BC`, or a link's name, means. Raises NoLineOf."""
    if of in mechanism.moving:
        points = mechanism.named(of)
        if len(points) > 1:
            return of, points[0], points[1]
    elif (sites := pair(mechanism, of)) is not None and sites[0].point != sites[1].point:
        link = common_link(mechanism, *sites)
        if link is not None and {site.point for site in sites} <= set(mechanism.links[link].points):
            return link, sites[0].point, sites[1].point
    lines = [link for link in mechanism.moving if len(mechanism.named(link)) > 1]
    raise NoLineOf(WHERE, of, tuple(lines))


def slowest(method: Method, wanted: Slowest, at: SearchPoints) -> tuple[SlowPoint, ...]:
    """The foot of the perpendicular from the instant centre: there the velocity lies along the line."""
    link, first, second = line_of(method.mechanism, wanted.of)
    count = at.t.size
    start, end = (np.broadcast_to(at.motions.position[point], (count,)) for point in (first, second))
    omega = np.broadcast_to(at.motions.omega[link], (count,))
    velocity = np.broadcast_to(at.motions.velocity_at(first, link), (count,))
    return tuple(
        _slowest(at, k, (first, second), complex(start[k]), complex(end[k]), float(omega[k]), complex(velocity[k]))
        for k in range(count)
    )


def _slowest(
    at: SearchPoints, k: int, points: tuple[str, str], start: complex, end: complex, omega: float, velocity: complex
) -> SlowPoint:
    length = abs(end - start)
    line = (end - start) / length
    if abs(omega) * length <= 1e-12 * max(abs(velocity), 1e-300):
        return SlowPoint(at.position(k, (abs(velocity),)), points, None, length, start, abs(velocity))
    along = -(np.conj(1j * line) * velocity).real / omega
    speed = abs((np.conj(line) * velocity).real)
    return SlowPoint(at.position(k, (speed,)), points, float(along), length, start + along * line, float(speed))


# --- the speed the drivers must have ----------------------------------------------------------

_DEGREES = {"rad/s": 1, "m/s": 1, "rad/s^2": 2, "m/s^2": 2}
"""Velocities grow with the speeds, accelerations with their square."""


def scaled(method: Method, wanted: Scaling, at: SearchPoints) -> tuple[Speeds, ...]:
    """All drivers' speeds times one factor (their accelerations times its square), so that a quantity has a value.

    Velocities grow with the speeds, accelerations with their square. Raises NotScaled, NegativeSize, CannotScale.
    """
    entry = series(wanted.quantity, looked_for(method.mechanism, wanted.quantity), at.motions, at.t.size)
    degree = _DEGREES.get(entry.unit)
    if degree is None:
        raise NotScaled(WHERE, wanted.quantity)
    target = value(wanted.value, entry.unit)
    if target < 0 and entry.vectors is not None and entry.along is None:
        raise NegativeSize(WHERE, wanted.quantity, wanted.value)
    found = []
    for k, now in enumerate(map(float, entry.signed)):
        factor = _factor(now, target, degree)
        if factor is None:
            shown = f"{now:.6g} {entry.unit}" if abs(now) > 1e-12 else f"0 {entry.unit}"
            raise CannotScale(WHERE, wanted.quantity, shown, wanted.value)
        rates = tuple(driver.rate * factor for driver in method.drivers)
        found.append(Speeds(at.position(k, (target,)), factor, rates, now))
    return tuple(found)


def _factor(now: float, target: float, degree: int) -> float | None:
    """What the speeds are multiplied by; the sense changes only where it must."""
    if target == 0:
        return 0.0
    if abs(now) <= 1e-12 * abs(target) or not math.isfinite(now):
        return None
    ratio = target / now
    if degree == 1:
        return ratio
    return math.sqrt(ratio) if ratio > 0 else None
