"""How fast a quantity changes on the way, exactly, where the drawing itself tells: so that a greatest value is found
at the zero of another quantity, to the last digit.

theta changes by omega, omega by alpha, a displacement by its rate, a place by its velocity, a velocity by its
acceleration. On a way every driver keeps its speed, so what the drivers' own accelerations contribute is taken off.
"""

from __future__ import annotations

from typing import assert_never

import numpy as np

from graphkin.base.geometry import Value, dot
from graphkin.base.value import frozen
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import FRAME
from graphkin.model.naming import Seen
from graphkin.model.quantities import Centre, Component, Displacement, Moving, Place, Quotient, Rotation, Track, on_axis
from graphkin.studies.sweeps import Course, Series


@frozen
class Pace:
    """How time goes on a way: t changes by `speed` a second [1/s].

    growth  what all drivers' accelerations are of their speeds [1/s]; None where they differ
    """

    speed: float
    growth: float | None


def pace_of(course: Course) -> Pace | None:
    """The pace of a way that is gone as the drivers go; None for any other way."""
    drivers, path = course.method.drivers, course.path
    speed = drivers[course.swept].rate / path.pace[course.swept]
    together = all(
        abs(driver.rate - speed * pace) <= 1e-12 * abs(speed * path.pace[course.swept])
        for driver, pace in zip(drivers, path.pace, strict=True)
    )
    if not speed or not together:
        return None
    growth = drivers[course.swept].acceleration / drivers[course.swept].rate
    alike = all(abs(d.acceleration - growth * d.rate) <= 1e-12 * abs(growth * d.rate) for d in drivers)
    return Pace(speed, growth if alike else None)


def rate(motions: Motions, entry: Series, pace: Pace) -> Value | None:
    """The change of a quantity with t; None where the drawing does not tell it."""
    match entry.quantity:
        case Rotation(word="theta", link=link):
            return motions.omega[link] / pace.speed
        case Rotation(word="omega", link=link) if pace.growth is not None:
            return (motions.alpha[link] - pace.growth * motions.omega[link]) / pace.speed
        case Displacement(slide=slide):
            return motions.s_rate[slide] / pace.speed
        case Place(axis=axis, site=site):
            return on_axis(motions.velocity_at(site.point, site.link) / pace.speed, axis)
        case Moving(letter="v") | Component(letter="v") if pace.growth is not None:
            return _of_speed(motions, entry, pace.growth) / pace.speed
        case Rotation() | Moving() | Component() | Track() | Centre() | Quotient():
            return None
        case _:
            assert_never(entry.quantity)


def _of_speed(motions: Motions, entry: Series, growth: float) -> Value:
    """Of a speed: the part of the vector's change along it, or along the direction in which it counts."""
    changes = [_change(motions, site) for site in entry.quantity.sites]
    change = changes[0] - (changes[1] if len(changes) > 1 else 0)
    return dot(_along(entry), change) - growth * entry.signed


def _along(entry: Series) -> Value:
    if isinstance(entry.quantity, Component):
        return 1 if entry.quantity.axis == "x" else 1j
    if entry.along is not None:
        return entry.along
    assert entry.vectors is not None
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(entry.vectors == 0, 0, entry.vectors / np.abs(entry.vectors))


def _change(motions: Motions, site: Seen) -> Value:
    """Of the velocity of the point of a link that lies under a point: ever another one where that moves on it."""
    acceleration = motions.acceleration_at(site.point, site.link)
    owners = motions.mechanism.owners[site.point]
    if site.link in owners or site.link == FRAME:
        return acceleration
    slip = motions.velocity_at(site.point, owners[0]) - motions.velocity_at(site.point, site.link)
    return acceleration + 1j * motions.omega[site.link] * slip
