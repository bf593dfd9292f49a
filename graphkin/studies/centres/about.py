"""Around a link's pole: acceleration pole, inflection and return circles, centres of curvature of its points' paths.

With the pole P, the acceleration a_P of the link's point at P, and omega, all lies ready: the pole moves along the
centrodes with u = i a_P / omega, the points whose paths are straight at this instant lie on the circle over the vector
a_P / omega^2 from P as its diameter (inflection circle), and every centre of curvature follows by Euler-Savary.
Source: theoretical mechanics (instant centre of acceleration); Euler-Savary equation, Bobillier: theory of machines.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Collection, Mapping
from dataclasses import replace
from functools import cached_property

import numpy as np

from graphkin.base.geometry import cross, number
from graphkin.base.plain import Plain
from graphkin.base.tolerances import STILL
from graphkin.base.value import bulky, frozen
from graphkin.construction import Plot, replay
from graphkin.construction.drafting import INFINITE
from graphkin.errors import UnknownLink, UnknownPoint, Where
from graphkin.errors.studies import FrameStands
from graphkin.model.mechanism import FRAME
from graphkin.proof.readings import readings
from graphkin.studies.centres.instant_centres import Centres

INFINITY = complex(math.inf)
NOWHERE = complex(math.nan, math.nan)
WHERE = Where("--about")


@frozen
class Circle:
    """A circle [m]; a point where its radius is 0."""

    centre: complex
    radius: float


@frozen
class InflectionLine:
    """A line through a point [m] in a direction (unit vector): what becomes of a circle that is infinitely large."""

    through: complex
    direction: complex


@frozen
class CarriedPoint:
    """A point carried by a link: place [m], velocity [m/s], acceleration [m/s^2], centre of curvature of its path [m].

    centre  infinite where the path is straight at this instant, NaN where the point stands still
    """

    place: complex
    velocity: complex
    acceleration: complex
    centre: complex

    @property
    def radius(self) -> float:
        """Radius of curvature of the path [m]; infinite or NaN as the centre is."""
        return math.inf if cmath.isinf(self.centre) else abs(self.centre - self.place)


@bulky
class About:
    """A link at one instant, seen about its pole.

    plot     the position with all three planes drawn
    base     place, velocity and acceleration of one point of the link [m, m/s, m/s^2]
    omega, alpha  [rad/s, rad/s^2]; 0 where they are 0 but for rounding
    names    points whose motion is read
    assumed  no driver moves, so that each was taken to move at 1 rad/s (1 m/s)
    """

    found: Centres
    plot: Plot
    link: str
    base: tuple[complex, complex, complex]
    omega: float
    alpha: float
    names: tuple[str, ...]
    assumed: bool

    @property
    def called(self) -> str:
        """The name that people call the link."""
        return self.found.method.mechanism.called(self.link)

    @cached_property
    def size(self) -> float:
        """The mechanism's size [m]."""
        return self.found.board.size

    @cached_property
    def pole(self) -> complex:
        """P, the place without velocity [m]; infinite in translation, NaN where a link at rest shows none."""
        place, velocity, _ = self.base
        if self.omega:
            return place + 1j * velocity / self.omega
        return INFINITY if velocity else complex(self.found.place(FRAME, self.link))

    @property
    def towards(self) -> complex:
        """The direction (unit vector) in which a pole at infinity lies; NaN where it is not at infinity."""
        velocity = self.base[1]
        if not cmath.isinf(self.pole):
            return NOWHERE
        if velocity:
            return 1j * velocity / abs(velocity)
        return cmath.rect(1.0, number(self.found.direction(FRAME, self.link)))

    @property
    def moves(self) -> bool:
        """True if the link moves at this instant."""
        return bool(self.omega or self.base[1])

    @cached_property
    def acceleration_pole(self) -> complex | None:
        """J, the place without acceleration [m]; None where omega and alpha are 0."""
        place, _, acceleration = self.base
        turn = self._turn
        return place - acceleration / turn if turn else None

    @property
    def _turn(self) -> complex:
        """The factor by which the vector from J to a point is multiplied to give its acceleration."""
        return 1j * self.alpha - self.omega**2

    @cached_property
    def diameter(self) -> complex | None:
        """From P to the inflection pole, a_P / omega^2 [m]; 0 for a link that turns about a fixed point.

        None where omega is 0.
        """
        if not self.omega:
            return None
        place, _, acceleration = self.base
        diameter = (acceleration + self._turn * (self.pole - place)) / self.omega**2
        return diameter if abs(diameter) > INFINITE * (self.size + abs(self.pole - place)) else 0j

    @property
    def pole_velocity(self) -> complex | None:
        """u, with which the pole changes along the centrodes [m/s]; None where omega is 0."""
        return None if self.diameter is None else 1j * self.omega * self.diameter

    @property
    def tangent(self) -> complex | None:
        """The pole tangent's direction, that of u; None where the pole stays, or is at infinity."""
        return 1j * self.normal if self.normal is not None else None

    @property
    def normal(self) -> complex | None:
        """The pole normal's direction, from P to the inflection pole."""
        return self.diameter / abs(self.diameter) if self.diameter else None

    @cached_property
    def inflection(self) -> Circle | InflectionLine | None:
        """The inflection circle: points whose paths are straight at this instant. A line in translation.

        None where no point, or where every point has such a path.
        """
        if self.diameter is not None:
            return Circle(self.pole + self.diameter / 2, abs(self.diameter) / 2)
        place, velocity, acceleration = self.base
        if not velocity or not self.alpha:
            return None
        along = velocity / abs(velocity)
        return InflectionLine(place - along * number(cross(along, acceleration)) / self.alpha, 1j * along)

    @property
    def returning(self) -> Circle | None:
        """The return circle: the inflection circle's mirror image in the pole tangent."""
        return None if self.diameter is None else Circle(self.pole - self.diameter / 2, abs(self.diameter) / 2)

    def carried(self, place: complex) -> CarriedPoint:
        """The point of the link's plane that lies at a place [m]."""
        start, velocity, acceleration = self.base
        arm = place - start
        return self._moved(place, velocity + 1j * self.omega * arm, acceleration + self._turn * arm)

    @cached_property
    def points(self) -> Mapping[str, CarriedPoint]:
        """The named points, as points of the link."""
        motions = readings(self.found.method, self.plot)
        points: dict[str, CarriedPoint] = {}
        for name in self.names:
            velocity, acceleration = motions.velocity_at(name, self.link), motions.acceleration_at(name, self.link)
            points[name] = self._moved(complex(self.plot.position[name]), complex(velocity), complex(acceleration))
        return points

    def _moved(self, place: complex, velocity: complex, acceleration: complex) -> CarriedPoint:
        speed, centre = abs(velocity), INFINITY
        if speed <= STILL * _pace(self.found, self.plot) * self.size:
            centre = place if self.diameter else NOWHERE
        elif abs(curvature := number(cross(velocity, acceleration)) / speed**3) * self.size > INFINITE:
            centre = place + 1j * velocity / speed / curvature
        return CarriedPoint(place, velocity, acceleration, centre)


def about(centres: Centres, link: str, points: Collection[str] = ()) -> About:
    """A moving link about its pole, at the one position of `centres`.

    link    its name; points of the mechanism whose motion is read; all of the link's own where left out

    Raises FrameStands, UnknownLink, UnknownPoint.
    """
    machine = centres.method.mechanism
    link = link_of(centres, link)
    if link == FRAME:
        raise FrameStands(WHERE, machine.frame)
    for name in points:
        if name not in machine.points:
            raise UnknownPoint(WHERE, name, machine.points)
    # speeds may have been assumed since the accelerations were drawn
    plot = replay(centres.method.acceleration, replace(centres.plot, acceleration={}, alpha={}, s_acceleration={}))
    own = next(point for point in machine.links[link].points if point in plot.position)
    motions, size, pace = readings(centres.method, plot), centres.board.size, _pace(centres, plot)
    velocity, omega = complex(motions.velocity_at(own, link)), float(plot.omega[link])
    acceleration, alpha = complex(motions.acceleration_at(own, link)), float(plot.alpha[link])
    if abs(omega) <= STILL * pace:  # 0 but for rounding
        omega, velocity = 0.0, velocity if abs(velocity) > STILL * pace * size else 0j
    change = pace**2 + max(abs(float(value)) for value in plot.alpha.values())
    alpha = alpha if abs(alpha) > STILL * change else 0.0
    assumed = not any(driver.rate for driver in centres.method.drivers)
    base = complex(plot.position[own]), velocity, acceleration
    return About(centres, plot, link, base, omega, alpha, tuple(points) or machine.named(link), assumed)


def link_of(centres: Centres, called: str, where: Where = WHERE) -> str:
    """A link's own name from what people call it. Raises UnknownLink."""
    machine = centres.method.mechanism
    names = {machine.called(link): link for link in machine.links} | {link: link for link in machine.links}
    if called not in names:
        raise UnknownLink(where, called, tuple(machine.called(link) for link in machine.links))
    return names[called]


def _pace(centres: Centres, plot: Plot) -> float:
    """The fastest motion [rad/s], slides counted by the mechanism's size."""
    turning = [abs(float(value)) for value in plot.omega.values()]
    sliding = [abs(complex(value)) / centres.board.size for value in plot.velocity.values()]
    return float(np.max([*turning, *sliding, 1e-300]))


def about_json(seen: About) -> dict[str, Plain]:
    """One object: poles, circles, and of each point its motion and the centre of curvature of its path.

    `pole` is a place [m], or {"direction": [x, y]} at infinity; null stands for what there is none of. `centre` of a
    point is "infinity" where its path is straight.
    """
    inflection, pole = seen.inflection, seen.pole
    line = inflection if isinstance(inflection, InflectionLine) else None
    return {
        "format": 1, "name": seen.found.method.mechanism.name, "link": seen.called, "speeds_assumed": seen.assumed,
        "pole": {"direction": _pair(seen.towards)} if cmath.isinf(pole) else _pair(pole),
        "omega": seen.omega, "alpha": seen.alpha, "acceleration_pole": _pair(seen.acceleration_pole),
        "pole_velocity": _pair(seen.pole_velocity), "tangent": _pair(seen.tangent),
        "inflection_circle": _circle(inflection) if isinstance(inflection, Circle) else None,
        "inflection_line": {"through": _pair(line.through), "direction": _pair(line.direction)} if line else None,
        "return_circle": _circle(seen.returning) if seen.returning else None,
        "points": {name: _point(carried) for name, carried in seen.points.items()},
    }  # fmt: skip


def _point(carried: CarriedPoint) -> dict[str, Plain]:
    straight = cmath.isinf(carried.centre)
    return {
        "at": _pair(carried.place), "velocity": _pair(carried.velocity), "acceleration": _pair(carried.acceleration),
        "centre": "infinity" if straight else _pair(carried.centre),
        "radius": None if straight or cmath.isnan(carried.centre) else carried.radius,
    }  # fmt: skip


def _circle(circle: Circle) -> dict[str, Plain]:
    return {"centre": _pair(circle.centre), "radius": circle.radius}


def _pair(value: complex | None) -> list[float] | None:
    """[x, y]; None for nothing, and for what is nowhere."""
    return None if value is None or not cmath.isfinite(value) else [value.real + 0.0, value.imag + 0.0]
