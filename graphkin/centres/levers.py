"""From one link's motion to another's through their common centre: omega_i P1iPij = omega_j P1jPij, by ruler and sums.

Each calculation is a stage of drafting steps: lengths are measured on paper, and a sum is done with them. Every value
is worked out from the figures that are printed, as a student would do it; in which sense a link turns, and which way
one moves, is read off the centres.
Source: Sun Huan, 机械原理, section 3-2.2.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise
from typing import Literal

from graphkin.centres.found import Centres
from graphkin.centres.lever_paths import LeverPaths
from graphkin.centres.uses import ByCentres, driven_point
from graphkin.drafting import Board, Measure, NumberStep, Pricked, Reckon, Stage, draw
from graphkin.mechanism import FRAME, Driver
from graphkin.value import frozen

__all__ = ["Lever", "Levers", "Number", "printed"]

_NEAR = 1e-6
"""Lengths below this part of the mechanism's size are none."""
_SCALE = "scale"


def printed(value: float) -> float:
    """A value as it is printed: four digits."""
    return float(f"{value:.4g}")


@frozen
class Number:
    """What a number on the board is the size of.

    kind   "omega" of a link, "against": of a link that turns against another, "speed" of a link that does not turn,
           "velocity" of a point, or of one against another, "slide": the speed of a driven slide, "length" on paper
           [mm], "scale" [m/mm]
    """

    kind: Literal["omega", "against", "speed", "velocity", "slide", "length", "scale"]
    of: str = ""
    other: str = ""


@frozen
class Lever:
    """A stage that gives one number, and the links it leads from and to.

    A stage says "together", "against", "about", "levered", "alike", "pushed", "turned", "triangle", "glides", "point",
    "pair", or "none": there is no lever.
    """

    stage: Stage
    base: str
    link: str

    @property
    def sum(self) -> Reckon | None:
        """The sum, the last of its steps; None where there is none."""
        step = self.stage.steps[-1] if self.stage.steps else None
        return step if isinstance(step, Reckon) else None


@dataclass
class Levers:
    """Motions of links known so far, as numbers on a board over the centres.

    scale    of the drawing from which lengths are taken [m/mm]
    turning  links with known motion; whether each turns
    meant    what each number is
    letters  points of the mechanism by their names on the board
    """

    found: Centres
    scale: float
    turning: dict[str, bool] = field(default_factory=dict)
    meant: dict[str, Number] = field(default_factory=dict)
    letters: dict[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self._know(_SCALE, Number("scale"), printed(self.scale))
        for link in (FRAME, *self.found.method.mechanism.moving):
            if link == FRAME or self.found.together(FRAME, link):
                self._move(link, False, 0.0)

    @cached_property
    def board(self) -> Board:
        """The centres' board, on which a ruler reads millimetres of paper and sums have four digits."""
        found = self.found.board
        points = dict(found.points)
        return Board(found.origin, found.size, found.beneath, points, read=self._read, written=printed)

    @cached_property
    def exact(self) -> ByCentres:
        """The same motions without ruler, for senses and directions."""
        return ByCentres(self.found)

    @cached_property
    def size(self) -> float:
        places = [complex(place) for place in self.found.plot.position.values()]
        return max(abs(place - places[0]) for place in places) or 1.0

    def _read(self, length: float) -> float:
        """What a ruler reads [mm]; nothing for what is only rounding."""
        return printed(length / self.scale) if length > _NEAR * self.size else 0.0

    # --- what is known --------------------------------------------------------------------------

    def rate(self, link: str) -> str:
        """The number that is known of a link: its angular velocity, or its speed."""
        return f"{'omega' if self.turning[link] else 'speed'} {link}"

    def value(self, link: str) -> float:
        return float(self.board.numbers[self.rate(link)])

    def omega(self, link: str) -> float:
        """Angular velocity with its sense [rad/s]; 0 for a link that does not turn."""
        if not self.turning[link]:
            return 0.0
        return self.value(link) if float(self.exact.omega[link]) > 0 else -self.value(link)

    def turned(self, rate: Number) -> float:
        """The same without ruler, of a link or of one against another."""
        omega = self.exact.omega
        return float(omega[rate.of] - (omega[rate.other] if rate.other else 0.0))

    def moved(self, velocity: Number, link: str) -> complex:
        """The velocity of a point of a link without ruler [m/s], or of one point against another."""
        found = self.exact.motions.velocity_at(velocity.of, link)
        return complex(found - self.exact.motions.velocity_at(velocity.other, link) if velocity.other else found)

    def way(self, link: str) -> complex:
        """The direction in which a link moves that does not turn (unit vector)."""
        return self._moving(link) / abs(self._moving(link))

    def _moving(self, link: str) -> complex:
        """The velocity of a point of a link, without ruler [m/s]."""
        points = self.found.method.mechanism.links[link].points
        point = next(point for point in points if point in self.exact.position)
        return complex(self.exact.motions.velocity_at(point, link))

    def velocity(self, point: str, link: str) -> complex:
        """Velocity of a point of a link [m/s], of the length that was worked out by `of_point`."""
        size = float(self.board.numbers[f"velocity {point} {link}"])
        velocity = self.moved(Number("velocity", point), link)
        return size * velocity / abs(velocity) if size else 0j

    def _know(self, name: str, meant: Number, value: float) -> str:
        self.board.numbers[name] = value
        self.meant[name] = meant
        return name

    def _move(self, link: str, turns: bool, value: float) -> None:
        """The motion of a link becomes known."""
        self.turning[link] = turns
        self._know(self.rate(link), Number("omega" if turns else "speed", link), value)

    def _stands(self, link: str) -> bool:
        """Whether a link is at rest for good: nothing can be carried on from it."""
        return not self.turning[link] and self.value(link) == 0.0

    # --- stages ---------------------------------------------------------------------------------

    def _length(self, first: str, second: str) -> Measure:
        """The ruler between two points of the board."""
        name = f"{first} to {second}"
        self.meant[name] = Number("length", first, second)
        return Measure(name, first, second)

    def _found(self, say: str, base: str, link: str, rule: str, *of: str | NumberStep, turns: bool = True) -> Lever:
        """The motion of a link by a sum; what is not yet on the board is measured."""
        self.turning[link] = turns
        self.meant[self.rate(link)] = Number("omega" if turns else "speed", link)
        return self._summed(say, base, link, self.rate(link), rule, *of)

    def _summed(self, say: str, base: str, link: str, name: str, rule: str, *of: str | NumberStep) -> Lever:
        measured = [one for one in of if not isinstance(one, str)]
        names = tuple(one if isinstance(one, str) else one.name for one in of)
        stage = Stage(say, (*measured, Reckon(name, rule, names)))
        draw(stage, self.board)
        return Lever(stage, base, link)

    def _pricked(self, point: str) -> str:
        """A point of the mechanism on the board, where a centre may have its name."""
        name = f"point {point}"
        self.letters[name] = point
        draw(Stage("", (Pricked(name, point),)), self.board)
        return name

    # --- what is given --------------------------------------------------------------------------

    def start(self, driver: Driver) -> list[Lever]:
        """The first motions, of the driven link or of the one it is driven from."""
        if driver.kind == "slide":
            return [*self._slid(driver)]
        if driver.from_link == FRAME:
            if self.found.finite(FRAME, driver.link) is not None:
                self._move(driver.link, True, printed(abs(driver.rate)))
            return []
        name, meant = f"against {driver.link} {driver.from_link}", Number("against", driver.link, driver.from_link)
        return [self._against(self._know(name, meant, printed(abs(driver.rate))), driver.link, driver.from_link)]

    def _against(self, relative: str, link: str, other: str) -> Lever:
        """omega_i = omega_ij P1jPij / P1iP1j: a link that turns at a given rate against another that moves."""
        name = self.found.name
        if self.found.finite(FRAME, link) is None:
            return self._found("against", link, other, "same", relative)
        if self.found.finite(FRAME, other) is None or self.found.finite(link, other) is None:
            return self._found("against", other, link, "same", relative)
        arm = self._length(name(FRAME, other), name(link, other))
        base = self._length(name(FRAME, link), name(FRAME, other))
        if abs(complex(self.found.place(FRAME, link) - self.found.place(FRAME, other))) <= _NEAR * self.size:
            return Lever(Stage("none", ()), other, link)
        return self._found("against", other, link, "lever", relative, arm, base)

    def _slid(self, driver: Driver) -> Iterator[Lever]:
        """A point driven along a fixed guide, omega = v_C / (P1jC mu_l), or along one that moves."""
        point, link, guide = driven_point(self.found.method.mechanism, driver)
        meant = Number("velocity", point) if guide == FRAME else Number("slide", driver.link)
        speed = self._know("driven", meant, printed(abs(driver.rate)))
        link, guide = (guide, link) if link == FRAME else (link, guide)
        own, seat, name = self.found.finite(FRAME, link), self.found.finite(FRAME, guide), self.found.name
        if guide == FRAME and own is not None:
            arm = self._length(name(FRAME, link), self._pricked(point))
            yield self._found("about", guide, link, "rate", speed, arm, _SCALE)
        elif guide == FRAME:
            yield self._found("glides", guide, link, "same", speed, turns=False)
        elif self.found.finite(link, guide) is not None:
            arm = self._length(name(link, guide), self._pricked(point))
            relative = f"against {link} {guide}"
            self.meant[relative] = Number("against", link, guide)
            yield self._summed("about", guide, link, relative, "rate", speed, arm, _SCALE)
            yield self._against(relative, link, guide)
        elif own is not None and seat is not None:
            arm = self._length(name(FRAME, link), name(FRAME, guide))
            yield self._found("about", guide, link, "rate", speed, arm, _SCALE)
        else:
            yield self._triangle(guide, link, speed, abs(driver.rate))

    # --- from link to link ------------------------------------------------------------------------

    def path(self, target: str) -> list[str] | None:
        """The way to a link from those with known motion; None where no way leads there."""
        if target in self.turning:
            return [target]
        standing = {link for link in self.turning if self._stands(link)}
        moving = [link for link in self.turning if link not in standing]
        return LeverPaths(self.found, self.size).path(moving, standing, target)

    def along(self, path: list[str]) -> list[Lever]:
        """What is worked out on the way to a link."""
        return [self._carry(base, link) for base, link in pairwise(path) if link not in self.turning]

    def _carry(self, base: str, link: str) -> Lever:
        """The motion of a link from that of a base."""
        name, known, turns = self.found.name, self.rate(base), self.turning[base]
        shared, own, first = name(base, link), name(FRAME, link), name(FRAME, base)
        if self.found.together(base, link):
            self._move(link, turns, self.value(base))
            return Lever(Stage("together", ()), base, link)
        if self.found.finite(base, link) is None:
            return self._alike(base, link) if turns else self._triangle(base, link, known, abs(self._moving(base)))
        if not turns:
            return self._found("turned", base, link, "rate", known, self._length(own, shared), _SCALE)
        arm = self._length(first, shared)
        if self.found.finite(FRAME, link) is None:
            return self._found("pushed", base, link, "speed", known, arm, _SCALE, turns=False)
        return self._found("levered", base, link, "lever", known, arm, self._length(own, shared))

    def _alike(self, base: str, link: str) -> Lever:
        """The common centre is at infinity: the links turn alike."""
        return self._found("alike", base, link, "same", self.rate(base))

    def _triangle(self, base: str, link: str, known: str, side: float) -> Lever:
        """Links that do not turn: each velocity, and that against each other, are at right angles to a centre's way.

        known, side   the number of one of these velocities, and how large it is exactly [m/s]
        """
        other = abs(self._moving(link))
        sought = self._know("side sought", Number("speed", link), other if other > _NEAR * side else 0.0)
        beside = self._know("side known", Number("speed", base), side)
        return self._found("triangle", base, link, "lever", known, sought, beside, turns=False)

    # --- the motion of points -----------------------------------------------------------------

    def of_point(self, point: str, link: str) -> Lever:
        """v_E = omega P1jE mu_l, at right angles to P1jE."""
        name = f"velocity {point} {link}"
        self.meant[name] = Number("velocity", point)
        if not self.turning[link]:
            return self._summed("point", link, link, name, "same", self.rate(link))
        arm = self._length(self.found.name(FRAME, link), self._pricked(point))
        return self._summed("point", link, link, name, "speed", self.rate(link), arm, _SCALE)

    def of_pair(self, first: str, second: str, link: str) -> Lever:
        """v_CB = omega BC mu_l, of two points of a link."""
        omega = self._know(f"omega {link}", Number("omega", link), self.value(link) if self.turning[link] else 0.0)
        arm, name = self._length(self._pricked(second), self._pricked(first)), f"pair {first} {second}"
        self.meant[name] = Number("velocity", first, second)
        return self._summed("pair", link, link, name, "speed", omega, arm, _SCALE)
