"""From one link's motion to another's through their common centre: omega_i P1iPij = omega_j P1jPij, by ruler and sums.

Each calculation is a stage of drafting steps: lengths are measured and a sum is done with them; in which sense a link
turns, or which way it moves, is read off the centres.
Source: Sun Huan, 机械原理, section 3-2.2.
"""

from __future__ import annotations

import cmath
import heapq
from collections.abc import Collection, Iterator
from dataclasses import dataclass, field
from itertools import pairwise
from math import inf, isfinite, log10

from graphkin.base.geometry import number
from graphkin.base.value import frozen
from graphkin.construction.drafting import Far, Reckon, Stage, Traced
from graphkin.model.mechanism import FRAME, Driver, Mechanism
from graphkin.studies.centres.instant_centres import Centres
from graphkin.studies.centres.lever_board import NEAR, SCALE, BoardNumber, Lever, LeverBoard, Sense


def driven_point(mechanism: Mechanism, driver: Driver) -> tuple[str, str, str]:
    """The point that a driver slides, the link it is driven with, and the link that carries its guide."""
    pair = mechanism.pair(driver.link)
    assert pair.path is not None
    point, track = pair.path.point, pair.path.line.link
    moved = (link for link in (*pair.joins, *mechanism.owners[point]) if link != track)
    return point, next(moved), track


def given_drivers(mechanism: Mechanism) -> list[Driver]:
    """The drivers that move; the first where none does."""
    return [driver for driver in mechanism.drivers if driver.rate] or [mechanism.drivers[0]]


@frozen
class DrivenEnd:
    """A centre of a link with one that is driven: as a point of either it has the velocity [m/s] that the driver gives.

    seat  the centre about which the driver turns
    """

    driver: Driver
    seat: str
    centre: str
    speed: float


def driven_ends(centres: Centres, link: str, known: Collection[str]) -> list[DrivenEnd]:
    """The centres of a link with links that turn by drivers of their own, each of these found before."""
    ends = list[DrivenEnd]()
    for driver in given_drivers(centres.method.mechanism):
        if driver.kind == "slide" or driver.from_link != FRAME or driver.link == link:
            continue
        seat, centre = centres.name(FRAME, driver.link), centres.name(driver.link, link)
        arm, at = centres.finite(FRAME, driver.link), centres.finite(driver.link, link)
        if arm is not None and at is not None and {seat, centre} <= {*known}:
            ends.append(DrivenEnd(driver, seat, centre, abs(driver.rate * (at - arm))))
    return ends


@dataclass
class Levers(LeverBoard):
    """Motions that are given, and those carried on from link to link.

    costs   of levers between two links that were asked for
    """

    costs: dict[tuple[str, str], float] = field(default_factory=dict)

    def given(self) -> list[Lever]:
        """The first motions by the driver that moves first, then what others state of links against the frame."""
        first, *others = given_drivers(self.mechanism)
        levers = self.start(first)
        for driver in others:
            link, base = driver.link, driver.from_link
            if driver.kind == "slide":
                _, link, base = driven_point(self.mechanism, driver)
            if base == FRAME and link not in self.turning:
                levers += self.start(driver)
        return levers

    def start(self, driver: Driver) -> list[Lever]:
        """The first motions, of the driven link or of the one it is driven from."""
        if driver.kind == "slide":
            return [*self._slid(driver)]
        if driver.from_link == FRAME:
            if self.found.finite(FRAME, driver.link) is not None:
                self.move(driver.link, True, driver.rate)
            return []
        name, meant = f"against {driver.link} {driver.from_link}", BoardNumber("against", driver.link, driver.from_link)
        return [self._against(self.know(name, meant, driver.rate), driver.link, driver.from_link)]

    def _against(self, relative: str, link: str, other: str) -> Lever:
        """omega_i = omega_ij P1jPij / P1iP1j: a link that turns at a given rate against another that moves."""
        own, seat, shared = self.centres(link, other)
        if self.found.finite(FRAME, link) is None:
            sense = Sense(relative, (self.do(Reckon("half a turn", "straight", ())),))
            return self.summed("against", link, other, self.becomes(other), "same", relative, sense=sense)
        if self.found.finite(FRAME, other) is None or self.found.finite(link, other) is None:
            name, sense = self.becomes(link), Sense(relative)
            return self.summed("against", other, link, name, "same", relative, sense=sense)
        if abs(complex(self.found.place(FRAME, link)) - complex(self.found.place(FRAME, other))) <= NEAR * self.size:
            return Lever(Stage("none", ()), other, link)
        arms = self.length(seat, shared), self.length(own, seat)
        name, sense = self.becomes(link), Sense(relative, (self.angle(seat, own, shared),))
        return self.summed("against", other, link, name, "lever", relative, *arms, sense=sense)

    def _slid(self, driver: Driver) -> Iterator[Lever]:
        """A point driven along a fixed guide, omega = v_C / (P1jC mu_l), or along one that moves."""
        point, link, guide = driven_point(self.mechanism, driver)
        meant = BoardNumber("velocity", point) if guide == FRAME else BoardNumber("slide", driver.link)
        swapped = self.found.together(FRAME, link)
        speed = self.know("driven", meant, driver.rate if swapped else -driver.rate)
        across = self.do(Far("across the guide", self.do(Traced("guide", driver.link))))
        link, guide = (guide, link) if swapped else (link, guide)
        own, seat, shared = self.centres(link, guide)
        turns, seated = (self.found.finite(FRAME, one) is not None for one in (link, guide))
        if self.found.together(FRAME, guide) and turns:
            yield self._about("about", guide, link, self.becomes(link), speed, across, own, self.pricked(point))
        elif self.found.together(FRAME, guide):
            name, sense = self.becomes(link, turns=False), Sense(speed, (self.between(across, own),))
            yield self.summed("glides", guide, link, name, "same", speed, sense=sense)
        elif self.found.finite(link, guide) is not None:
            relative = f"against {link} {guide}"
            self.meant[relative] = BoardNumber("against", link, guide)
            yield self._about("about", guide, link, relative, speed, across, shared, self.pricked(point))
            yield self._against(relative, link, guide)
        elif turns and seated:
            yield self._about("about", guide, link, self.becomes(link), speed, across, own, seat)
        else:
            yield self._triangle(guide, link, speed, across, seat)

    def path(self, target: str) -> list[str] | None:
        """The links from one with known motion to a target, by the cheapest levers; None where nothing leads there."""
        if target in self.turning:
            return [target]
        resting = {link for link in self.turning if self.stands(link)}
        costs = {base: self._cost(base, target) for base in sorted(self.turning.keys() - resting)}
        if costs and (nearest := min(costs, key=costs.__getitem__)) and costs[nearest] <= 2.0:  # two levers: 2 or more
            return [nearest, target]
        # Dijkstra's search from links whose motion is known; from resting ones none is carried on
        best = {link: 0.0 for link in self.turning if link not in resting}
        queue = [(0.0, link, [link]) for link in best]
        heapq.heapify(queue)
        while queue:
            cost, base, path = heapq.heappop(queue)
            if base == target:
                return path
            for link in self.mechanism.moving:
                if link in path or link in resting:
                    continue
                total = cost + self._cost(base, link)
                if total < best.get(link, inf):
                    best[link] = total
                    heapq.heappush(queue, (total, link, [*path, link]))
        return None

    def _cost(self, base: str, link: str) -> float:
        if (base, link) not in self.costs:
            self.costs[base, link] = _cost(self.found, self.size, base, link)
        return self.costs[base, link]

    def along(self, path: list[str]) -> list[Lever]:
        """Work out the motion of each link on a path."""
        return [self._carry(base, link) for base, link in pairwise(path) if link not in self.turning]

    def _carry(self, base: str, link: str) -> Lever:
        """The motion of a link from that of a base."""
        known, turns = self.rate(base), self.turning[base]
        own, first, shared = self.centres(link, base)
        if self.found.together(base, link):
            name, sense = self.becomes(link, turns), Sense(known, () if turns else (self.between(first, own),))
            return self.summed("together", base, link, name, "same", known, sense=sense)
        if self.found.finite(base, link) is None and not turns:
            return self._triangle(base, link, known, first, shared)
        if self.found.finite(base, link) is None:
            return self.summed("alike", base, link, self.becomes(link), "same", known, sense=Sense(known))
        if not turns:
            return self._about("turned", base, link, self.becomes(link), known, first, own, shared)
        arm = self.length(first, shared)
        if self.found.finite(FRAME, link) is None:
            name, sense = self.becomes(link, turns=False), Sense(known, (self.angle(first, shared, own),))
            return self.summed("pushed", base, link, name, "speed", known, arm, SCALE, sense=sense)
        name, sense = self.becomes(link), Sense(known, (self.angle(shared, first, own),))
        return self.summed("levered", base, link, name, "lever", known, arm, self.length(own, shared), sense=sense)

    def _about(
        self, say: str, base: str, link: str, name: str, speed: str, across: str, centre: str, end: str
    ) -> Lever:
        """A rotation about a centre from the speed of the end of an arm, at right angles to `across`."""
        arm, sense = self.length(centre, end), Sense(speed, (self.angle(centre, end, across),))
        return self.summed(say, base, link, name, "rate", speed, arm, SCALE, sense=sense)

    def _triangle(self, base: str, link: str, known: str, across: str, other: str) -> Lever:
        """Links that do not turn: velocities, and that against each other, are at right angles to their centres' rays.

        known, across   the number of one of these velocities, and its centre; other: the third one's centre
        """
        angles = self.between(other, across), self.between(other, self.found.name(FRAME, link))
        name, sense = self.becomes(link, turns=False), Sense(known, angles)
        return self.summed("triangle", base, link, name, "sines", known, *angles, sense=sense)

    def of_point(self, point: str, link: str) -> Lever:
        """v_E = omega P1jE mu_l, at right angles to P1jE."""
        name = f"velocity {point} {link}"
        self.meant[name] = BoardNumber("velocity", point)
        if not self.turning[link]:
            return self.summed("point", link, link, name, "same", self.rate(link))
        arm = self.length(self.found.name(FRAME, link), self.pricked(point))
        return self.summed("point", link, link, name, "speed", self.rate(link), arm, SCALE)

    def of_pair(self, first: str, second: str, link: str) -> Lever:
        """v_CB = omega BC mu_l, of two points of a link."""
        omega = self.know(f"omega {link}", BoardNumber("omega", link), self.omega(link))
        arm, name = self.length(self.pricked(second), self.pricked(first)), f"pair {first} {second}"
        self.meant[name] = BoardNumber("velocity", first, second)
        return self.summed("pair", link, link, name, "speed", omega, arm, SCALE)


def _cost(centres: Centres, size: float, base: str, link: str) -> float:
    """1 for a good lever, more for one that is very short or very long; infinite for none."""

    def badness(first: complex, second: complex) -> float:
        length = max(abs(first - second) / size, 1e-9)
        return max(0.0, log10(0.1 / length)) + max(0.0, log10(length / 10))

    if centres.together(base, link):
        return 1.0
    if centres.undetermined(FRAME, link):
        return inf
    own, other, common = centres.finite(FRAME, base), centres.finite(FRAME, link), centres.finite(base, link)
    if common is None:
        if own is not None and other is not None:
            return 1.0
        if own is not None or other is not None or centres.together(FRAME, link):
            return inf
        # neither turns: the triangle of velocities closes where their directions differ
        far, common_far = (number(centres.direction(*two)) for two in ((FRAME, link), (base, link)))
        return 5.0 if abs(cmath.rect(1, far - common_far).imag) > 1e-3 else inf
    if other is None:
        return inf if own is None else 1.0 + badness(own, common)
    if abs(other - common) < 1e-4 * size:
        return inf
    return 1.0 + badness(other, common) + (badness(own, common) if own is not None else 0.0)


def carried_through(centres: Centres, scale: float = 0.0) -> Levers:
    """The motions of all links that levers reach, from the first driver that moves. scale: as of `Levers`."""
    levers = Levers(centres, scale)
    levers.given()
    for link in levers.mechanism.moving:
        levers.along(levers.path(link) or [])
    return levers


def advantages(centres: Centres) -> dict[str, float]:
    """Mechanical advantage of each link that turns with a frame hinge: its torque by the driver's, without losses.

    Power in is power out, so it is omega of the driver by omega of the link: P1j Pij / P1i Pij turned over. Empty
    where the driver does not turn, and where another moves: it has a power of its own, and a ratio of speeds is none
    of torques.
    """
    levers, mechanism = carried_through(centres), centres.method.mechanism
    driver, *others = given_drivers(mechanism)
    if others:
        return {}
    if driver.kind == "slide" or driver.from_link != FRAME or not isfinite(levers.omega(driver.link)):
        return {}
    hinged = {link for hinge in mechanism.hinges if FRAME in hinge.links for link in hinge.links} - {FRAME, driver.link}
    omega = {link: levers.omega(link) for link in mechanism.moving if link in hinged}
    least = 1e-9 * abs(driver.rate or 1.0)
    return {link: levers.omega(driver.link) / rate for link, rate in omega.items() if abs(rate) > least}
