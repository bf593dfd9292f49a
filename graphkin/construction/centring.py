"""Instant centres: the steps by which they are found, and what the pencil does for each.

A centre may lie at infinity, so it is kept as three homogeneous coordinates (x, y, w), with x and y in units of the
mechanism's size from a point of it: w = 0 is a direction. Lines are the same; a join and a meeting are one product.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import assert_never

import numpy as np

from graphkin.construction.kinds import Ray, Touch
from graphkin.construction.pencil import touch
from graphkin.construction.plot import Plot
from graphkin.geometry import Value
from graphkin.value import frozen

__all__ = [
    "CLEAR", "CentreStep", "Centring", "Far", "Join", "Kennedy", "Pole", "Seat", "axes_of", "direction_of",
    "line_of", "place_of", "take",
]  # fmt: skip

INFINITE = 1e-9
"""A centre farther off than the mechanism's size divided by this counts as at infinity."""
CLEAR = 1e-3
"""Two lines that are less than this far from being one give no centre."""
STILL = 1e-11
"""Links that move against each other by less than this part of the fastest motion stand still against each other."""


@frozen
class Seat:
    """A centre known by definition: of links on a hinge, at its point; of wheels that roll, where they touch."""

    centre: str
    point: str
    contact: Touch | None = None


@frozen
class Far:
    """The centre of a block and its guide: at infinity, at right angles to the line of the slide."""

    centre: str
    slide: str


@frozen
class Join:
    """The line through two centres, on which a third lies (Kennedy and Aronhold); a parallel, if one is at infinity."""

    first: str
    second: str


@frozen
class Kennedy:
    """A centre on two lines; a line is a join of centres, or the common normal of two profiles that touch."""

    centre: str
    first: Join | Ray
    second: Join | Ray


@frozen
class Pole:
    """A centre found from velocities: where two links have the same one.

    links   of each: the link, a point of the mechanism, and that point of the link in the velocity polygon
    """

    centre: str
    links: tuple[tuple[str, str, str], tuple[str, str, str]]


CentreStep = Seat | Far | Kennedy | Pole


@frozen
class Centring:
    """How the centres of a mechanism are found, one step each, in an order in which every line is known in time.

    links       the two links of each centre, by its name
    together    pairs of links that do not move against each other: they have no centre
    """

    steps: tuple[CentreStep, ...]
    links: Mapping[str, tuple[str, str]]
    together: tuple[tuple[str, str], ...] = ()


def take(step: CentreStep, plot: Plot) -> None:
    """One step."""
    match step:
        case Seat(centre, point, contact):
            place = plot.position[point] if contact is None else touch(contact, plot)
            plot.centres[centre] = _proper(plot, place)
        case Far(centre, slide):
            plot.centres[centre] = _improper(1j * plot.guide_direction(slide))
        case Kennedy(centre, first, second):
            found = _product(line_of(first, plot), line_of(second, plot))
            plot.lean[centre] = np.linalg.norm(found, axis=0)
            plot.centres[centre] = _balanced(found)
        case Pole(centre, links):
            plot.centres[centre] = _pole(plot, *links)
        case _:
            assert_never(step)


def place_of(plot: Plot, centre: str) -> Value:
    """Where a centre is [m]; infinite at infinity, NaN where links do not move against each other."""
    x, y, w = plot.centres[centre]
    origin, size = axes_of(plot)
    with np.errstate(divide="ignore", invalid="ignore"):
        far = np.abs(w) <= INFINITE * np.hypot(x, y)
        return np.where(far, np.where(np.hypot(x, y) > 0, np.inf, np.nan), origin + size * (x + 1j * y) / w)[()]


def direction_of(plot: Plot, centre: str) -> Value:
    """The direction in which a centre at infinity lies [rad], in (-pi/2, pi/2]."""
    x, y, _ = plot.centres[centre]
    angle = np.arctan2(y, x)
    return np.where(angle > np.pi / 2, angle - np.pi, np.where(angle <= -np.pi / 2, angle + np.pi, angle))[()]


# --- homogeneous coordinates ------------------------------------------------------------------


def axes_of(plot: Plot) -> tuple[complex, float]:
    """Where coordinates are counted from, and their unit: a fixed point, and the mechanism's longest reach [m]."""
    shapes, frame = plot.facts.shapes, plot.facts.frame
    fixed = next(iter(shapes[frame].values()), 0j)
    reaches = [abs(place - fixed) for place in shapes[frame].values()]
    reaches += [abs(place) for link, shape in shapes.items() if link != frame for place in shape.values()]
    return fixed, max(reaches) or 1.0


def _proper(plot: Plot, place: Value) -> Value:
    origin, size = axes_of(plot)
    seen = (place - origin) / size
    return np.array([np.real(seen), np.imag(seen), np.ones_like(np.real(seen))])


def _improper(direction: Value) -> Value:
    return np.array([np.real(direction), np.imag(direction), np.zeros_like(np.real(direction))])


def _balanced(found: Value) -> Value:
    """The same point or line, its coordinates of length 1."""
    with np.errstate(divide="ignore", invalid="ignore"):
        return found / np.linalg.norm(found, axis=0)


def _product(one: Value, other: Value) -> Value:
    """The line through two points, or the point on two lines."""
    (a, b, c), (d, e, f) = one, other
    return np.array(np.broadcast_arrays(b * f - c * e, c * d - a * f, a * e - b * d))


def line_of(line: Join | Ray, plot: Plot) -> Value:
    """A line, of length 1; NaN where two centres to be joined coincide."""
    match line:
        case Join(first, second):
            return _balanced(_product(_balanced(plot.centres[first]), _balanced(plot.centres[second])))
        case Ray(through, direction):
            way = _improper(plot.direction(direction))
            return _balanced(_product(_balanced(_proper(plot, plot.position[through])), way))
        case _:
            assert_never(line)


def _pole(plot: Plot, first: tuple[str, str, str], second: tuple[str, str, str]) -> Value:
    """Where two links have one velocity: of each a point of the mechanism, and the same in the velocity polygon.

    Source: theoretical mechanics, x_P = x_O - v_y / omega, y_P = y_O + v_x / omega of the relative motion.
    """
    speeds, turns = zip(*(_motion_of(plot, *entry) for entry in (first, second)), strict=True)
    moving, turning = speeds[0] - speeds[1], turns[0] - turns[1]
    fastest = np.max(np.abs(np.array(np.broadcast_arrays(*plot.omega.values(), *turns))), axis=0) + np.abs(moving)
    turning = np.where(np.abs(turning) <= STILL * fastest, 0.0, turning)
    moving = np.where((np.abs(moving) <= STILL * fastest) & (turning == 0), 0.0, moving)
    x, y = np.real(1j * moving), np.imag(1j * moving)
    return _balanced(np.array(np.broadcast_arrays(x, y, turning)))


def _motion_of(plot: Plot, link: str, point: str, node: str) -> tuple[Value, Value]:
    """Velocity of the place of the link at the origin of coordinates, in units of size, and its rotation."""
    origin, size = axes_of(plot)
    if link == plot.facts.frame:
        return 0j, 0.0
    omega = plot.omega[link]
    return (plot.velocity[node] + 1j * omega * (origin - plot.position[point])) / size, omega
