"""What the sketch and the drivers say of the unknowns before anything is solved: first guesses."""

from __future__ import annotations

import cmath
from dataclasses import dataclass, field

import numpy as np

from graphkin.analytic.loops import Loops
from graphkin.analytic.rules import Unknown, placing, theta
from graphkin.analytic.vectors import Real
from graphkin.mechanism import FRAME, Driver, Link, Mechanism, Pose
from graphkin.pairs import Slide

__all__ = ["guess"]


def guess(mechanism: Mechanism, loops: Loops) -> Real:
    """The unknowns (n,) as far as the sketch and the drivers show them, in internal units; nan elsewhere."""
    seen = _Seen(mechanism)
    for _ in mechanism.links:
        seen.look()
    found = {theta(link): angle for link, angle in seen.angles.items()}
    for pair in mechanism.slides:
        found[Unknown("s", pair.name)] = seen.displacement(pair)
    return np.array([found.get(unknown, np.nan) for unknown in loops.unknowns]) / loops.unit


@dataclass
class _Seen:
    """Located points [m] and angles of links [rad]; `look` adds what follows from them."""

    mechanism: Mechanism
    points: dict[str, complex] = field(default_factory=dict)
    angles: dict[str, float] = field(default_factory=lambda: {FRAME: 0.0})

    def __post_init__(self) -> None:
        self.points = {**self.mechanism.sketch, **self.mechanism.links[FRAME].points}

    def look(self) -> None:
        for given, value in placing(self.mechanism):
            if given.kind == "angle":
                self._driven(given, value)
            elif given.kind == "slide":
                self._pushed(self.mechanism.slide(given.link), value)
        for pair in self.mechanism.slides:
            self._aligned(pair)
        for link in self.mechanism.links.values():
            self._fitted(link)

    def _driven(self, given: Driver | Pose, value: float) -> None:
        if given.from_link in self.angles and given.vector is not None:
            links = self.mechanism.links
            back = given.from_vector
            start = 0.0 if back is None else cmath.phase(links[given.from_link].arm(*back))
            angle = self.angles[given.from_link] + start + value
            self.angles.setdefault(given.link, angle - cmath.phase(links[given.link].arm(*given.vector)))

    def _pushed(self, pair: Slide, value: float) -> None:
        if pair.guide in self.angles and pair.line.origin in self.points:
            along = pair.line.direction * cmath.rect(1, self.angles[pair.guide])
            self.points.setdefault(pair.point, self.points[pair.line.origin] + value * along)

    def _aligned(self, pair: Slide) -> None:
        """A block turns with its guide; two located points on a line give its direction."""
        if pair.block is not None and pair.guide in self.angles:
            self.angles.setdefault(pair.block, self.angles[pair.guide] + pair.turn)
        if pair.block is not None and pair.block in self.angles:
            self.angles.setdefault(pair.guide, self.angles[pair.block] - pair.turn)
        ends = self.points.get(pair.line.origin), self.points.get(pair.point)
        if ends[0] is not None and ends[1] is not None:
            self.angles.setdefault(pair.guide, cmath.phase((ends[1] - ends[0]) / pair.line.direction))

    def _fitted(self, link: Link) -> None:
        """Two located points give the link's angle; the angle and one point give all its points."""
        at = [(self.points[name], arm) for name, arm in link.points.items() if name in self.points]
        if not at:
            return
        place, arm = (sum(column) / len(at) for column in zip(*at, strict=True))
        turn = sum((here - place) * (there - arm).conjugate() for here, there in at)
        if abs(turn) > 0:
            self.angles.setdefault(link.name, cmath.phase(turn))
        if link.name in self.angles:
            unit = cmath.rect(1, self.angles[link.name])
            for name, there in link.points.items():
                self.points.setdefault(name, place + (there - arm) * unit)

    def displacement(self, pair: Slide) -> float:
        """s as seen, nan where it is not [m]."""
        origin, point = self.points.get(pair.line.origin), self.points.get(pair.point)
        if origin is None or point is None or pair.guide not in self.angles:
            return float("nan")
        along = pair.line.direction * cmath.rect(1, self.angles[pair.guide])
        return ((point - origin) / along).real
