"""What the sketch and the drivers say of the unknowns before anything is solved: first guesses."""

from __future__ import annotations

import cmath
from dataclasses import field
from itertools import pairwise

import numpy as np

from graphkin.analytic.loops import Loops
from graphkin.analytic.rules import Joint, Unknown, placing, theta
from graphkin.analytic.vectors import Real
from graphkin.base.geometry import phase
from graphkin.base.value import filled
from graphkin.model.mechanism import FRAME, Driver, Link, Mechanism, Pose
from graphkin.model.pairs import Slide


def guess(mechanism: Mechanism, loops: Loops) -> Real:
    """The unknowns (n,) as far as the sketch and the drivers show them, in internal units; nan elsewhere."""
    seen = _Seen(mechanism, loops.joints)
    while seen.look():
        pass
    seen.join_centres()
    found = {theta(link): angle for link, angle in seen.angles.items()}
    for joint in loops.joints:
        if joint.slide is not None:
            found[Unknown("s", joint.slide)] = seen.displacement(joint)
    seen_of = [found.get(unknown, np.nan) for unknown in loops.unknowns]
    return np.asarray(np.array(seen_of, dtype=np.float64) / loops.unit)


@filled
class _Seen:
    """Located points [m] and angles of links [rad]; `look` adds what follows from them."""

    mechanism: Mechanism
    joints: tuple[Joint, ...]
    points: dict[str, complex] = field(default_factory=dict)
    angles: dict[str, float] = field(default_factory=lambda: {FRAME: 0.0})

    def __post_init__(self) -> None:
        self.points = {**self.mechanism.sketch, **self.mechanism.links[FRAME].points}

    def look(self) -> bool:
        """Add what follows from what is seen; whether anything did."""
        before = len(self.points), len(self.angles)
        for given, value in placing(self.mechanism):
            if given.kind == "angle":
                self._driven(given, value)
            elif given.kind == "slide":
                self._pushed(next(joint for joint in self.joints if joint.slide == given.link), value)
        for link in self.mechanism.links.values():
            self._fitted(link)
        for pair in self.mechanism.slides:
            self._aligned(pair)
        return before != (len(self.points), len(self.angles))

    def _driven(self, given: Driver | Pose, value: float) -> None:
        if given.from_link in self.angles and given.vector is not None:
            links = self.mechanism.links
            back = given.from_vector
            start = 0.0 if back is None else phase(links[given.from_link].arm(*back))
            angle = self.angles[given.from_link] + start + value
            self.angles.setdefault(given.link, angle - phase(links[given.link].arm(*given.vector)))

    def _pushed(self, joint: Joint, value: float) -> None:
        origin = self._place(joint.tail, joint.tail_arm)
        if joint.tail in self.angles and origin is not None:
            place = origin + value * joint.direction * cmath.rect(1, self.angles[joint.tail])
            for name, arm in self.mechanism.links[joint.head].points.items():
                if arm == joint.head_arm:
                    self.points.setdefault(name, place)

    def _aligned(self, pair: Slide) -> None:
        """A block turns with its guide; two located points on a line give its direction."""
        if pair.block is not None and pair.guide in self.angles:
            self.angles.setdefault(pair.block, self.angles[pair.guide] + pair.turn)
        if pair.block is not None and pair.block in self.angles:
            self.angles.setdefault(pair.guide, self.angles[pair.block] - pair.turn)
        ends = self.points.get(pair.line.origin), self.points.get(pair.point)
        if ends[0] is not None and ends[1] is not None:
            self.angles.setdefault(pair.guide, phase((ends[1] - ends[0]) / pair.line.direction))

    def _fitted(self, link: Link) -> None:
        """Two located points give the link's angle; the angle and one point give all its points."""
        if link.name in self.angles and all(name in self.points for name in link.points):
            return
        at = [(self.points[name], arm) for name, arm in link.points.items() if name in self.points]
        if not at:
            return
        place, arm = (sum(column) / len(at) for column in zip(*at, strict=True))
        turn = sum((here - place) * (there - arm).conjugate() for here, there in at)
        if abs(turn) > 0:
            self.angles.setdefault(link.name, phase(turn))
        if link.name in self.angles:
            unit = cmath.rect(1, self.angles[link.name])
            for name, there in link.points.items():
                self.points.setdefault(name, place + (there - arm) * unit)

    def join_centres(self) -> None:
        """Lines of centres, links of a pair's own making: from one centre to the other."""
        for near, far in pairwise(self.joints):
            if near.head == far.tail and near.head not in self.mechanism.links:
                start, end = self._place(near.tail, near.tail_arm), self._place(far.head, far.head_arm)
                if start is not None and end is not None:
                    self.points[near.head] = start
                    self.angles[near.head] = phase(end - start)

    def displacement(self, joint: Joint) -> float:
        """s as seen, nan where it is not [m]."""
        origin, point = self._place(joint.tail, joint.tail_arm), self._place(joint.head, joint.head_arm)
        if origin is None or point is None or joint.tail not in self.angles:
            return float("nan")
        along = joint.direction * cmath.rect(1, self.angles[joint.tail])
        return ((point - origin) / along).real

    def _place(self, name: str, arm: complex) -> complex | None:
        """Where an arm of a link ends, None if that is not seen."""
        link = self.mechanism.links.get(name, Link(name, {name: 0}))
        seen = [(abs(arm - base), self.points[point], arm - base) for point, base in link.points.items()
                if point in self.points]  # fmt: skip
        if name == FRAME:
            return arm
        away, base, rest = min(seen, key=lambda each: each[0], default=(np.inf, 0j, 0j))
        if name in self.angles and seen:
            return base + rest * cmath.rect(1, self.angles[name])
        return base if away == 0 else None
