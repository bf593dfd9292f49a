"""What instant centres alone tell: angular velocities, velocities of points, ratios, mechanical advantage.

A link's motion is its absolute centre with a weight, its angular velocity: (omega x_P, omega y_P, omega). Two such
differ by the same thing of their relative centre, so from one link's weight the common centre gives the other's:
omega_i P1iPij = omega_j P1jPij (3-6), with its sense, and with centres at infinity where links only move along.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

import numpy as np

from graphkin.centres.found import Centres
from graphkin.geometry import Value, dot
from graphkin.mechanism import FRAME, Driver, Mechanism
from graphkin.motions import Motions
from graphkin.value import Lazy, frozen

__all__ = ["ByCentres", "advantages", "driven_point"]


@frozen
class ByCentres:
    """Velocities from instant centres and the first driver that moves; they answer what `ask` asks of velocities."""

    found: Centres

    @property
    def mechanism(self) -> Mechanism:
        return self.found.method.mechanism

    @property
    def position(self) -> Mapping[str, Value]:
        return self.found.plot.position

    @cached_property
    def _motions(self) -> dict[str, Value]:
        """By link: its centre in homogeneous coordinates, weighted with its angular velocity."""
        driver = next((d for d in self.mechanism.drivers if d.rate), self.mechanism.drivers[0])
        found = self._driven(driver)
        while waiting := [link for link in self.mechanism.moving if link not in found]:
            tried = [(self._lever(base, link), base, link) for base in found for link in waiting]
            _, base, link = max(tried, key=lambda entry: entry[0])
            found[link] = self._carried(found[base], base, link)
        return {FRAME: np.zeros(3), **found}

    def _driven(self, driver: Driver) -> dict[str, Value]:
        """The driven link, and the link it is driven from where that one moves."""
        if driver.kind == "slide":
            link, other, relative = self._slid(driver)
        else:
            link, other = driver.link, driver.from_link
            centre = self._at(link, other)
            relative = driver.rate * centre / centre[2]
        if FRAME in (link, other):
            return {link: relative} if other == FRAME else {other: -relative}
        own = self._at(FRAME, link)
        weighted = _share(relative, own, self._at(FRAME, other)) * own
        return {link: weighted, other: weighted - relative}

    def _slid(self, driver: Driver) -> tuple[str, str, Value]:
        """A link with a point that is driven along a guide, the guide's link, and how they move against each other."""
        point, link, guide = driven_point(self.mechanism, driver)
        centre = self._at(link, guide)
        pace = self._velocity(centre, point)
        wanted = driver.rate * self.found.plot.guide_direction(driver.link)
        return link, guide, dot(pace, wanted) / np.abs(pace) ** 2 * centre

    def _carried(self, known: Value, base: str, link: str) -> Value:
        """The motion of a link by its centre with a known one; that of a link without an absolute centre is none."""
        own = self._at(FRAME, link)
        if self.found.together(FRAME, link):
            return np.zeros_like(known)
        return _share(known, own, self._at(base, link)) * own

    def _lever(self, base: str, link: str) -> float:
        """How far apart the absolute centre of a link and its centre with another lie, at least."""
        apart = np.linalg.norm(np.cross(self._at(FRAME, link), self._at(base, link), axis=0), axis=0)
        return float(np.min(np.nan_to_num(apart, nan=-1.0)))

    def _at(self, first: str, second: str) -> Value:
        """A centre in homogeneous coordinates; NaN where there is none."""
        return self.found.board.points.get(self.found.name(first, second), np.full(3, np.nan))

    # --- read as motions ----------------------------------------------------------------------

    @cached_property
    def omega(self) -> Mapping[str, Value]:
        """By link [rad/s]."""
        return {link: motion[2] for link, motion in self._motions.items() if link != FRAME}

    @cached_property
    def motions(self) -> Motions:
        """Places and velocities: v_E = omega P1E, at right angles to P1E with the sense of omega."""

        def of_link(link: str) -> Mapping[str, Value]:
            return Lazy(self.position, lambda point: self._velocity(self._motions[link], point))

        velocities = Lazy(self.mechanism.moving, of_link)
        return Motions(self.mechanism, {}, self.omega, {}, {}, {}, {}, self.position, velocities, {})

    def _velocity(self, motion: Value, point: str) -> Value:
        x, y, omega = motion
        board = self.found.board
        return 1j * (omega * (self.position[point] - board.origin) - board.size * (x + 1j * y))

    def ratio(self, first: str, second: str) -> Value:
        """omega of the first link by that of the second, positive for one sense (3-6)."""
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.divide(self._motions[first][2], self._motions[second][2])


def driven_point(mechanism: Mechanism, driver: Driver) -> tuple[str, str, str]:
    """The point that a driver slides, the link it is driven with, and the link that carries its way."""
    pair = mechanism.pair(driver.link)
    assert pair.path is not None
    point, track = pair.path.point, pair.path.line.link
    moved = (link for link in (*pair.joins, *mechanism.owners[point]) if link != track)
    return point, next(moved), track


def advantages(by: ByCentres) -> dict[str, float]:
    """Mechanical advantage of each link that turns with a frame hinge: its torque by the driver's, without losses.

    Power in is power out, so it is omega of the driver by omega of the link: P1j Pij / P1i Pij turned over. Empty
    where the driver does not turn.
    """
    mechanism = by.mechanism
    driver = next((d for d in mechanism.drivers if d.rate), mechanism.drivers[0])
    if driver.kind == "slide" or driver.from_link != FRAME or not np.isfinite(by.omega[driver.link]):
        return {}
    hinged = {link for hinge in mechanism.hinges if FRAME in hinge.links for link in hinge.links} - {FRAME, driver.link}
    least = 1e-9 * abs(driver.rate or 1.0)
    turning = [link for link in mechanism.moving if link in hinged and abs(by.omega[link]) > least]
    return {link: float(by.ratio(driver.link, link)) for link in turning}


def _share(known: Value, own: Value, common: Value) -> Value:
    """The weight w with w own - known on the way to `common`: from (w own - known) x common = 0."""
    left, right = np.cross(own, common, axis=0), np.cross(known, common, axis=0)
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.sum(left * right, axis=0) / np.sum(left * left, axis=0)
