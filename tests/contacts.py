"""Where gears, wheels and cams touch, worked out from the motion alone: an independent look at the pairs."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphkin.analytic import Motion
from graphkin.model.pairs import Cam, CircularSlot, Gear, Line, RollingContact

Array = np.ndarray
Circle = tuple[str, str, float]
"""Link, centre, radius [m]."""


def touching(found: Motion) -> Iterator[tuple[Array, Array]]:
    """For each gear, roll and cam: how far the profiles are apart [m], and the velocity that should vanish [m/s].

    That is all of the relative velocity where there is no slip, its part along the normal for a cam.
    """
    m = found.mechanism
    for gear in m.of(Gear):
        one, other = zip(gear.links, gear.centres, gear.radii, strict=True)
        yield circles(found, one, other, gear.internal)[::2]
    for roll in m.of(RollingContact):
        wheel = (roll.wheel, roll.centre, roll.radius)
        if roll.line is None:
            track = (roll.track, roll.track_centre, roll.track_radius)
            yield circles(found, track, wheel, roll.internal)[::2]
        else:
            gap, _, relative = beside(found, roll.line, roll.left, wheel)
            yield gap, relative
    for slot in m.of(CircularSlot):
        arm = found.position[slot.point] - found.position[slot.centre]
        cut = found.velocity[slot.centre] + 1j * found.omega[slot.guide] * arm
        yield abs(arm) - slot.radius, ((found.velocity[slot.point] - cut) / arm).real * slot.radius
    for cam in m.of(Cam):
        (first, second), (one, other) = cam.links, cam.profiles
        if one.line is not None:
            gap, normal, relative = beside(found, one.line, one.left, (second, other.centre, other.radius))
        elif other.line is not None:
            gap, normal, relative = beside(found, other.line, other.left, (first, one.centre, one.radius))
        else:
            ends = (first, one.centre, one.radius), (second, other.centre, other.radius)
            gap, normal, relative = circles(found, *ends, cam.internal)
        yield gap, (relative / normal).real


def circles(found: Motion, one: Circle, other: Circle, internal: bool) -> tuple[Array, Array, Array]:
    """Gap, unit normal, and the velocity of the second against the first where they touch."""
    between = found.position[other[1]] - found.position[one[1]]
    normal = between / abs(between)
    if not internal:
        gap, first, second = abs(between) - one[2] - other[2], normal * one[2], -normal * other[2]
    else:
        out = normal if one[2] > other[2] else -normal
        gap, first, second = abs(between) - abs(one[2] - other[2]), out * one[2], out * other[2]
    return gap, normal, rim(found, other, second) - rim(found, one, first)


def beside(found: Motion, line: Line, left: bool, wheel: Circle) -> tuple[Array, Array, Array]:
    """The same for a circle beside a line."""
    along = line.direction * np.exp(1j * found.theta[line.link])
    normal = 1j * along if left else -1j * along
    arm = found.position[wheel[1]] - found.position[line.origin]
    foot = arm - normal * wheel[2]
    track = found.velocity[line.origin] + 1j * found.omega[line.link] * foot
    return (arm / normal).real - wheel[2], normal, rim(found, wheel, -normal * wheel[2]) - track


def rim(found: Motion, wheel: Circle, arm: Array) -> Array:
    """Velocity of the point of a link at `arm` from its centre [m/s]."""
    return np.asarray(found.velocity[wheel[1]] + 1j * found.omega[wheel[0]] * arm)
