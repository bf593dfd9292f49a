"""From one link's motion to another's through their common centre, with figures: omega_i P1iPij = omega_j P1jPij.

Every value is worked out from the figures that are printed, as a student would do it.
Source: Sun Huan, 机械原理, section 3-2.2.
"""

from __future__ import annotations

import cmath
import heapq
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import pairwise
from math import inf, log10

import numpy as np

from graphkin.mechanism import FRAME
from graphkin.value import frozen
from graphkin.words import names
from graphkin.words.centre_steps import CentreReader
from graphkin.words.entries import Calculation, Entry, Sentence
from graphkin.words.figures import degrees, number
from graphkin.words.phrases import say

__all__ = ["Gliding", "Levers", "Motion", "Turning", "printed"]

_NEAR = 1e-6
"""Lengths below this part of the mechanism's size are none."""


def printed(value: float) -> float:
    """A value as it is printed: four digits."""
    return float(f"{value:.4g}")


@frozen
class Turning:
    """A link turns about its absolute centre: omega with its sign [rad/s], and the centre [m]."""

    omega: float
    centre: complex


@frozen
class Gliding:
    """A link moves without turning: speed [m/s] and unit direction; no speed: it stands still."""

    speed: float
    way: complex


Motion = Turning | Gliding


@dataclass
class Levers:
    """Motions of links known so far, and how each was found."""

    reader: CentreReader
    scale: float
    known: dict[str, Motion] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.known[FRAME] = Gliding(0.0, 1 + 0j)
        for link in self.reader.mechanism.moving:
            if self.name(FRAME, link) not in self.reader.found.board.points:
                self.known[link] = Gliding(0.0, 1 + 0j)

    # --- lengths --------------------------------------------------------------------------------

    def name(self, first: str, second: str) -> str:
        return self.reader.found.name(first, second)

    def place(self, first: str, second: str) -> complex | None:
        """A centre at a finite place [m]; None at infinity or where there is none."""
        name, board = self.name(first, second), self.reader.found.board
        if name not in board.points:
            return None
        place = complex(board.at(name))
        return place if cmath.isfinite(place) else None

    def _far(self, first: str, second: str) -> complex | None:
        """The direction of a centre at infinity, a unit vector."""
        name, board = self.name(first, second), self.reader.found.board
        if name not in board.points or self.place(first, second) is not None:
            return None
        return cmath.rect(1, float(board.direction(name)))

    def moves_with(self, first: str, second: str) -> bool:
        """Whether two links do not move against each other."""
        return self.name(first, second) not in self.reader.found.board.points

    @property
    def size(self) -> float:
        places = [complex(place) for place in self.reader.found.plot.position.values()]
        return max(abs(place - places[0]) for place in places) or 1.0

    def length(self, first: complex, second: complex) -> float:
        """What a ruler reads between two places, as printed [mm]; nothing for what is only rounding."""
        off = abs(first - second)
        return printed(off / self.scale) if off > _NEAR * self.size else 0.0

    @staticmethod
    def stretch(first: str, second: str) -> str:
        """`P13P34`, `P13E`: the line between two centres, or from one to a point."""
        room = " " if "," in first + second else ""
        return names.point(first) + room + names.point(second)

    def rate(self, link: str) -> str:
        """`ω3`."""
        return names.of_link("ω", self.reader.mechanism.called(link))

    def speed(self, link: str) -> str:
        """`v_3`: of a link that does not turn."""
        return "v_" + self.reader.link(link)

    def sense(self, omega: float) -> str:
        return say("ccw" if omega > 0 else "cw", self.reader.lang)

    # --- from link to link ------------------------------------------------------------------------

    def reach(self, target: str) -> Iterator[Entry] | None:
        """What is worked out on the way from links with known motion to a target; None where no way leads there."""
        path = self._path(target)
        return None if path is None else self._along(path)

    def _along(self, path: list[str]) -> Iterator[Entry]:
        for base, link in pairwise(path):
            if link not in self.known:
                yield from self._carry(base, link)

    def _path(self, target: str) -> list[str] | None:
        """The way with the fewest and best levers (Dijkstra)."""
        moving = [link for link in self.known if not _stands(self.known[link])]
        if target in self.known:
            return [target]
        best, queue = dict.fromkeys(moving, 0.0), [(0.0, link, [link]) for link in moving]
        heapq.heapify(queue)
        while queue:
            cost, base, path = heapq.heappop(queue)
            if base == target:
                return path
            for link in self.reader.mechanism.moving:
                total = cost + self._cost(base, link) if link not in path else inf
                if total < best.get(link, inf):
                    best[link] = total
                    heapq.heappush(queue, (total, link, [*path, link]))
        return None

    def _cost(self, base: str, link: str) -> float:
        """1 for a good lever, more for one that is very short or very long; infinite for none."""
        if link in self.known and _stands(self.known[link]):
            return inf
        if self.moves_with(base, link):
            return 1.0
        own, other, common = self.place(FRAME, base), self.place(FRAME, link), self.place(base, link)
        if common is None:
            both = (own is None) == (other is None)
            return (1.0 if own is not None else 5.0) if both and self._triangle_closes(own, base, link) else inf
        if other is None:
            return inf if own is None else 1.0 + self._badness(own, common)
        if abs(other - common) < 1e-4 * self.size:
            return inf
        return 1.0 + self._badness(other, common) + (self._badness(own, common) if own is not None else 0.0)

    def _triangle_closes(self, own: complex | None, base: str, link: str) -> bool:
        if own is not None:
            return True
        far, common = self._far(FRAME, link), self._far(base, link)
        return far is not None and common is not None and abs(((1j * far) * common.conjugate()).real) > 1e-3

    def _badness(self, first: complex, second: complex) -> float:
        off = max(abs(first - second) / self.size, 1e-9)
        return max(0.0, log10(0.1 / off)) + max(0.0, log10(off / 10))

    def _carry(self, base: str, link: str) -> Iterator[Entry]:
        """The motion of a link from that of a base."""
        first = self.known[base]
        if self.moves_with(base, link):
            self.known[link] = first
            name = self.reader.centre(self.name(base, link))
            words = {"first": self.reader.link(base), "second": self.reader.link(link)}
            yield Sentence(self.reader.say("together", name=name, **words))
            return
        own, common = self.place(FRAME, link), self.place(base, link)
        if common is None:
            yield self._alike(first, base, link) if isinstance(first, Turning) else self._triangle(first, base, link)
        elif isinstance(first, Turning) and own is not None:
            yield self._levered(first, base, link, own, common)
        elif isinstance(first, Turning):
            yield self._pushed(first, base, link, common)
        else:
            assert own is not None
            yield self._turned(first, base, link, own, common)

    def _levered(self, first: Turning, base: str, link: str, own: complex, common: complex) -> Entry:
        """omega_j = omega_i P1iPij / P1jPij."""
        lever, other = self.length(first.centre, common), self.length(own, common)
        outside = ((first.centre - common).conjugate() * (own - common)).real > 0
        value = printed(abs(first.omega) * lever / other)
        omega = value * (1 if first.omega > 0 else -1) * (1 if outside else -1)
        self.known[link] = Turning(omega, own)
        names_ = [self.name(FRAME, base), self.name(base, link), self.name(FRAME, link)]
        formula = f"{self.rate(base)} {self.stretch(*names_[:2])} / {self.stretch(names_[2], names_[1])}"
        figures = f"{number(abs(first.omega))} × {number(lever)} / {number(other)}"
        words = {"centre": self.reader.centre(names_[1]), "ends": self.stretch(names_[0], names_[2])}
        key = "sense outside" if outside else "sense between"
        note = self.reader.say(key, sense=self.sense(omega), **words) if value else ""
        return Calculation(self.rate(link), (formula,), figures, value, "rad/s", note)

    def _alike(self, first: Turning, base: str, link: str) -> Entry:
        """The common centre is at infinity: the links turn alike."""
        own = self.place(FRAME, link)
        assert own is not None
        self.known[link] = Turning(first.omega, own)
        centre = self.reader.centre(self.name(base, link))
        note = self.reader.say("sense alike", sense=self.sense(first.omega), centre=centre) if first.omega else ""
        return Calculation(self.rate(link), (self.rate(base),), "", abs(first.omega), "rad/s", note)

    def _pushed(self, first: Turning, base: str, link: str, common: complex) -> Entry:
        """A link that does not turn has the velocity of its common centre: v_j = omega_i P1iPij mu_l."""
        lever, scale = self.length(first.centre, common), printed(self.scale)
        value = printed(abs(first.omega) * lever * scale)
        way = 1j * (common - first.centre) * first.omega
        self.known[link] = Gliding(value, way / abs(way) if value else 1 + 0j)
        name, shared = self.name(FRAME, base), self.name(base, link)
        formula = f"{self.rate(base)} {self.stretch(name, shared)} {names.SCALE['position']}"
        figures = f"{number(abs(first.omega))} × {number(lever)} × {number(scale)}"
        note = self.reader.say("along", angle=degrees(way)) if value else ""
        formulas = (f"v_{self.reader.centre(shared)}", formula)
        return Calculation(self.speed(link), formulas, figures, value, "m/s", note)

    def _turned(self, first: Gliding, base: str, link: str, own: complex, common: complex) -> Entry:
        """omega_j = v_i / (P1jPij mu_l)."""
        lever, scale = self.length(own, common), printed(self.scale)
        value = printed(first.speed / (lever * scale))
        sign = 1 if ((1j * (common - own)).conjugate() * first.way).real > 0 else -1
        self.known[link] = Turning(sign * value, own)
        stretch = self.stretch(self.name(FRAME, link), self.name(base, link))
        formula = f"{self.speed(base)} / ({stretch} {names.SCALE['position']})"
        figures = f"{number(first.speed)} / ({number(lever)} × {number(scale)})"
        return Calculation(self.rate(link), (formula,), figures, value, "rad/s", self.sense(sign) if value else "")

    def _triangle(self, first: Gliding, base: str, link: str) -> Entry:
        """Two links that do not turn: their relative velocity is at right angles to the direction of their centre."""
        common, far = self._far(base, link), self._far(FRAME, link)
        assert common is not None
        assert far is not None
        way = 1j * far
        share = (first.way * common.conjugate()).real / (way * common.conjugate()).real
        way = way if share > 0 else -way
        value = printed(first.speed * abs(share))
        self.known[link] = Gliding(value, way)
        note = "，" if self.reader.lang == "zh" else ", "
        note = self.reader.say("triangle") + note + self.reader.say("along", angle=degrees(way))
        return Calculation(self.speed(link), (), "", value, "m/s", note if value else "")

    # --- the motion of points -----------------------------------------------------------------

    def velocity(self, point: str, link: str) -> complex:
        """Velocity of a point of a link with known motion, from printed figures [m/s]."""
        motion, at = self.known[link], complex(self.reader.found.plot.position[point])
        if isinstance(motion, Gliding):
            return motion.speed * motion.way
        arm = at - motion.centre
        speed = printed(abs(motion.omega) * self.length(at, motion.centre) * printed(self.scale))
        way = 1j * arm * np.sign(motion.omega)
        return speed * way / abs(way) if speed else 0j

    def of_point(self, name: str, point: str, link: str) -> Calculation:
        """v_E = omega P1jE mu_l, at right angles to P1jE."""
        motion, velocity = self.known[link], self.velocity(point, link)
        note = self.reader.say("at", angle=degrees(velocity)) if velocity else ""
        if isinstance(motion, Gliding):
            formulas = (self.speed(link),) if motion.speed else ()
            return Calculation(name, formulas, "", abs(velocity), "m/s", note)
        centre, scale = self.name(FRAME, link), printed(self.scale)
        arm = self.stretch(centre, point)
        lever = self.length(complex(self.reader.found.plot.position[point]), motion.centre)
        formula = f"{self.rate(link)} {arm} {names.SCALE['position']}"
        figures = f"{number(abs(motion.omega))} × {number(lever)} × {number(scale)}"
        note = self.reader.say("across", arm=arm, angle=degrees(velocity)) if velocity else ""
        return Calculation(name, (formula,), figures, printed(abs(velocity)), "m/s", note)


def _stands(motion: Motion) -> bool:
    """Whether a link is at rest for good: nothing can be carried on from it."""
    return isinstance(motion, Gliding) and motion.speed == 0.0
