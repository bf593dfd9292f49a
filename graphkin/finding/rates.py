"""How fast a quantity changes on the way, exactly, where the drawing itself tells: so that a greatest value is found
at the zero of another quantity, to the last digit.

theta changes by omega, omega by alpha, a displacement by its rate, a place by its velocity, a velocity by its
acceleration. On a way every driver keeps its speed, so what the drivers' own accelerations contribute is taken off.
"""

from __future__ import annotations

import numpy as np

from graphkin.geometry import Value, dot
from graphkin.mechanism import FRAME, Mechanism
from graphkin.motions import Motions
from graphkin.naming import Seen, pair, seen
from graphkin.sweeps import Course, Series
from graphkin.value import frozen

__all__ = ["Pace", "pace_of", "rate"]


@frozen
class Pace:
    """How time goes on a way: t changes by `speed` a second [1/s].

    growth  what all drivers' accelerations are of their speeds [1/s]; None where they differ
    """

    speed: float
    growth: float | None


def pace_of(course: Course) -> Pace | None:
    """The pace of a way that is gone as the drivers go; None for any other way."""
    drivers, way = course.method.drivers, course.way
    speed = drivers[course.swept].rate / way.pace[course.swept]
    together = all(
        abs(driver.rate - speed * pace) <= 1e-12 * abs(speed * way.pace[course.swept])
        for driver, pace in zip(drivers, way.pace, strict=True)
    )
    if not speed or not together:
        return None
    growth = drivers[course.swept].acceleration / drivers[course.swept].rate
    alike = all(abs(d.acceleration - growth * d.rate) <= 1e-12 * abs(growth * d.rate) for d in drivers)
    return Pace(speed, growth if alike else None)


def rate(mechanism: Mechanism, motions: Motions, entry: Series, pace: Pace) -> Value | None:
    """The change of a quantity with t; None where the drawing does not tell it."""
    word, _, of = entry.name.partition(" ")
    of = of.strip()
    if "/" in entry.name:
        return None
    if word == "theta":
        return motions.omega[of] / pace.speed if of in motions.omega else None
    if word == "s":
        return motions.s_rate[of] / pace.speed if of in motions.s_rate else None
    if word in ("x", "y"):
        site = seen(mechanism, of)
        assert site is not None
        there = motions.velocity_at(site.point, site.link) / pace.speed
        return np.real(there) if word == "x" else np.imag(there)
    if pace.growth is None:
        return None
    if word == "omega" and of in motions.alpha:
        return (motions.alpha[of] - pace.growth * motions.omega[of]) / pace.speed
    return _of_speed(mechanism, motions, entry, of, pace) if word in ("v", "v_x", "v_y") else None


def _of_speed(mechanism: Mechanism, motions: Motions, entry: Series, of: str, pace: Pace) -> Value:
    """Of a speed: the part of the vector's change along it, or along the direction in which it counts."""
    assert pace.growth is not None
    alone = seen(mechanism, of)
    sites = (alone,) if alone is not None else pair(mechanism, of) or ()
    changes = [_change(mechanism, motions, site) for site in sites]
    change = changes[0] - (changes[1] if len(changes) > 1 else 0)
    with np.errstate(divide="ignore", invalid="ignore"):
        if entry.along is not None or entry.vectors is None:
            along: Value = entry.along or {"v_x": 1, "v_y": 1j}[entry.name[:3]]
        else:
            along = np.where(entry.vectors == 0, 0, entry.vectors / np.abs(entry.vectors))
    return (dot(along, change) - pace.growth * entry.signed) / pace.speed


def _change(mechanism: Mechanism, motions: Motions, site: Seen) -> Value:
    """Of the velocity of the point of a link that lies under a point: ever another one where that moves on it."""
    acceleration = motions.acceleration_at(site.point, site.link)
    owners = mechanism.owners[site.point]
    if site.link in owners or site.link == FRAME:
        return acceleration
    slip = motions.velocity_at(site.point, owners[0]) - motions.velocity_at(site.point, site.link)
    return acceleration + 1j * motions.omega[site.link] * slip
