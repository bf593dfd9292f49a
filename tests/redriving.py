"""Random mechanisms whose drawn position and motion are given by other quantities than their drivers.

A driver is replaced by another quantity of the same motion, with the values that the analytic solution has for it:
what follows must be the motion that was there before.
"""

from __future__ import annotations

import cmath
import random
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import random_mechanisms
from random_mechanisms import DYADS, Build, dyad

from graphkin.analytic import Motion, mobility, motion
from graphkin.errors import GraphkinError
from graphkin.model.mechanism import Driver, Mechanism, Pose

FAMILIES: dict[str, Callable[[int], Mechanism]] = {
    kind: lambda seed, kind=kind: dyad(kind, seed) for kind in DYADS
} | {
    kind: getattr(random_mechanisms, kind)
    for kind in ("cylinder", "relative_angle", "coupler_angle", "chain", "triad", "six_bar", "geared_five_bar",
                 "epicyclic", "rolling", "cam", "circular_slot")
}  # fmt: skip
FAMILIES |= {"truss": lambda seed: truss(seed, False), "truss_on_links": lambda seed: truss(seed, True)}
WELL = 1e-2
"""The least reciprocal condition of a mechanism that is well posed."""

Arm = tuple[str, str]


def truss(seed: int, on_links: bool) -> Mechanism:
    """Bars that are rigid together: a triangle or two on a hinge of the frame, or as the coupler of a four-bar."""
    build = Build(random.Random(f"truss {seed}"), letters=[f"{c}{k}" for k in (3, 2, 1) for c in "ABCDEFGHJKLMN"])
    build.body("frame")
    corners = [(build.letter(), build.place()) for _ in range(build.rng.choice((3, 4)))]
    bars = [(0, 1), (1, 2), (0, 2), (1, 3), (2, 3)][: 3 if len(corners) == 3 else 5]
    for number, ends in enumerate(bars, start=1):
        build.body(f"{number}").points |= dict(corners[k] for k in ends)
    hung = build.rng.sample(corners, 2)
    driven = "1"
    if on_links:
        for link, corner in zip(("8", "9"), hung, strict=True):
            build.hinge("frame", link)
            build.body(link).points |= dict([corner])
        driven = "8"
    else:
        build.body("frame").points |= dict(hung[:1])
    build.drivers.append(Driver("angle", driven, rate=build.rng.uniform(-9, 9), acceleration=build.rng.uniform(-9, 9)))
    return build.finish(f"truss-{seed}")


class Solved:
    """A mechanism with its motion, and lots to draw from it."""

    def __init__(self, mechanism: Mechanism, exact: Motion, rng: random.Random) -> None:
        self.mechanism, self.exact, self.rng = mechanism, exact, rng

    def arm(self, link: str) -> Arm | None:
        """Two points of a link that lie apart, in either order."""
        points = {p: z for p, z in self.mechanism.links[link].points.items() if p not in self.mechanism.unnamed}
        arms = [(p, q) for p in points for q in points if abs(points[p] - points[q]) > 1e-3]
        return self.rng.choice(arms) if arms else None

    def arms(self, count: int) -> list[tuple[str, Arm]]:
        """As many links, each with an arm; fewer where there are not so many."""
        found = [(link, arm) for link in self.mechanism.moving if (arm := self.arm(link)) is not None]
        return self.rng.sample(found, min(count, len(found)))

    def angle(self, arm: Arm) -> float:
        start, end = (self.exact.position[point] for point in arm)
        return cmath.phase(end - start)

    def rates(self, link: str, seen_from: str) -> tuple[float, float]:
        turning = self.exact.omega, self.exact.alpha
        return tuple(float(table[link] - table[seen_from]) for table in turning)

    # --- what may drive, or give the position ---------------------------------------------------

    def of_link(self) -> Driver | None:
        """The angle of any link."""
        for link, arm in self.arms(1):
            return Driver("angle", link, arm, value=self.angle(arm), **self._rates(link, "frame"))
        return None

    def of_two(self, hinged: bool = False) -> Driver | None:
        """The angle between any two links, or two that have a hinge in common."""
        if len(both := self.arms(2)) < 2:
            return None
        (link, arm), (other, seen_from) = both
        links = self.mechanism.links
        if hinged and not links[link].points.keys() & links[other].points.keys():
            return None
        value = self.angle(arm) - self.angle(seen_from)
        return Driver("angle", link, arm, other, seen_from, value, **self._rates(link, other))

    def of_slide(self) -> Driver | None:
        """The displacement of any sliding pair."""
        if not self.mechanism.slides:
            return None
        name, exact = self.rng.choice([pair.name for pair in self.mechanism.slides]), self.exact
        rate, acceleration = float(exact.s_rate[name]), float(exact.s_acceleration[name])
        return Driver("slide", name, value=float(exact.s[name]), rate=rate, acceleration=acceleration)

    def _rates(self, link: str, seen_from: str) -> dict[str, float]:
        rate, acceleration = self.rates(link, seen_from)
        return {"rate": rate, "acceleration": acceleration}


def _posed(found: Driver | None) -> Pose | None:
    if found is None or found.value is None:
        return None
    return Pose(found.kind, found.link, found.value, found.vector, found.from_link, found.from_vector)


def _instead(solved: Solved, driver: Driver | None, pose: Pose | None = None) -> Mechanism | None:
    """The mechanism with a driver in place of one of its own, and one pose more where it says no value."""
    mechanism = solved.mechanism
    number = solved.rng.randrange(len(mechanism.drivers))
    if pose is not None:
        driver = replace(driver or mechanism.drivers[number], value=None)
    elif driver is None:
        return None
    drivers = [*mechanism.drivers]
    drivers[number] = driver
    named = {each.link for each in (driver, pose) if each is not None and each.kind == "slide"}
    pairs = tuple(replace(pair, named=True) if pair.name in named else pair for pair in mechanism.pairs)
    poses = (*mechanism.poses, *([pose] if pose is not None else []))
    return replace(mechanism, drivers=tuple(drivers), poses=poses, pairs=pairs)


def _with_pose(driven: Callable[[Solved], Driver | None], posed: Callable[[Solved], Driver | None]):
    def make(solved: Solved) -> Mechanism | None:
        pose = _posed(posed(solved))
        return _instead(solved, driven(solved), pose) if pose is not None else None

    return make


KINDS: dict[str, Callable[[Solved], Mechanism | None]] = {
    "link": lambda solved: _instead(solved, solved.of_link()),
    "slide": lambda solved: _instead(solved, solved.of_slide()),
    "relative": lambda solved: _instead(solved, solved.of_two()),
    "posed by a link": _with_pose(lambda solved: None, Solved.of_link),
    "posed by two links": _with_pose(lambda solved: None, Solved.of_two),
    "posed by a slide": _with_pose(lambda solved: None, Solved.of_slide),
    "relative and posed": _with_pose(lambda solved: solved.of_two(hinged=True), Solved.of_link),
}
"""By which quantity a mechanism is driven or posed instead."""


def redriven(family: str, kind: str, seed: int) -> tuple[Mechanism, Motion] | None:
    """A mechanism of a family so driven, with its motion before; None where it is not well posed."""
    rng = random.Random(f"{family} {kind} {seed}")
    mechanism = FAMILIES[family](seed)
    try:
        exact = motion(mechanism)
        other = KINDS[kind](Solved(mechanism, exact, rng))
        well = other is not None and exact.condition > WELL and motion(other).condition > WELL and _placed(other)
    except GraphkinError:
        return None
    return (other, exact) if well and other is not None else None


def _placed(mechanism: Mechanism) -> bool:
    """Whether what is given of the drawn position fixes it, and well."""
    if not mechanism.poses:
        return True
    if mobility(mechanism).unplaced:
        return False
    if any(pair.rolling is not None for pair in mechanism.pairs):
        return True
    valued = tuple(driver for driver in mechanism.drivers if driver.value is not None)
    posed = tuple(Driver(p.kind, p.link, p.vector, p.from_link, p.from_vector, p.value) for p in mechanism.poses)
    by_these = replace(mechanism, drivers=(*valued, *posed), poses=())
    return bool(np.all(motion(by_these).condition > WELL))
