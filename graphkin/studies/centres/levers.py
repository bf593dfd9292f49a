"""From one link's motion to another's through their common centre: omega_i P1iPij = omega_j P1jPij, by ruler and sums.

Each calculation is a stage of drafting steps: lengths are measured and a sum is done with them; in which sense a link
turns, or which way it moves, is read off the centres.
Source: Sun Huan, 机械原理, section 3-2.2.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

from graphkin.construction.drafting import Far, Reckon, Stage, Traced
from graphkin.model.mechanism import FRAME, Driver, Mechanism
from graphkin.studies.centres.lever_board import NEAR, SCALE, BoardNumber, Lever, LeverBoard, Sense
from graphkin.studies.centres.lever_paths import LeverPaths


def driven_point(mechanism: Mechanism, driver: Driver) -> tuple[str, str, str]:
    """The point that a driver slides, the link it is driven with, and the link that carries its way."""
    pair = mechanism.pair(driver.link)
    assert pair.path is not None
    point, track = pair.path.point, pair.path.line.link
    moved = (link for link in (*pair.joins, *mechanism.owners[point]) if link != track)
    return point, next(moved), track


@dataclass
class Levers(LeverBoard):
    """What is given, and what is carried on from link to link."""

    # --- what is given --------------------------------------------------------------------------

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
        if abs(complex(self.found.place(FRAME, link) - self.found.place(FRAME, other))) <= NEAR * self.size:
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

    # --- from link to link ------------------------------------------------------------------------

    def path(self, target: str) -> list[str] | None:
        """The way to a link from those with known motion; None where no way leads there."""
        if target in self.turning:
            return [target]
        standing = {link for link in self.turning if self.stands(link)}
        moving = [link for link in self.turning if link not in standing]
        return self._paths.path(moving, standing, target)

    @cached_property
    def _paths(self) -> LeverPaths:
        return LeverPaths(self.found, self.size)

    def along(self, path: list[str]) -> list[Lever]:
        """What is worked out on the way to a link."""
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
        """Links that do not turn: each velocity, and that against each other, are at right angles to a centre's way.

        known, across   the number of one of these velocities, and its centre; other: the third one's centre
        """
        angles = self.between(other, across), self.between(other, self.found.name(FRAME, link))
        name, sense = self.becomes(link, turns=False), Sense(known, angles)
        return self.summed("triangle", base, link, name, "sines", known, *angles, sense=sense)

    # --- the motion of points -----------------------------------------------------------------

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
