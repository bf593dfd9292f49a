"""Random mechanisms for the tests: poses first, dimensions from them, so that every one can be assembled.

Two cranks with drivers of their own and the frame are the known bodies; a dyad of the wanted kind hangs
between two of them. Each sliding pair draws by lot which body is the guide, whether its line runs through a
point or beside it, and what the block looks like.
"""

from __future__ import annotations

import cmath
import math
import random
from dataclasses import dataclass, field

from graphkin.mechanism import FRAME, Driver, Link, Mechanism
from graphkin.pairs import Line, Slide

DYADS = ("RRR", "RRP", "PRR", "RPR", "PRP", "RPP", "PPR")


@dataclass
class Body:
    """Points of a body where they stand now [m]."""

    name: str
    points: dict[str, complex] = field(default_factory=dict)
    axis: complex = 1 + 0j


@dataclass
class Build:
    rng: random.Random
    bodies: dict[str, Body] = field(default_factory=dict)
    slides: list[tuple[str, str, str, complex, str | None, str]] = field(default_factory=list)
    letters: list[str] = field(default_factory=list)
    drivers: list[Driver] = field(default_factory=list)

    def letter(self) -> str:
        return self.letters.pop()

    def place(self) -> complex:
        return complex(self.rng.uniform(-0.1, 0.1), self.rng.uniform(-0.1, 0.1))

    def direction(self) -> complex:
        return cmath.rect(1.0, self.rng.uniform(0, 2 * math.pi))

    def body(self, name: str) -> Body:
        return self.bodies.setdefault(name, Body(name))

    def hinge(self, first: str, second: str) -> None:
        point, place = self.letter(), self.place()
        self.body(first).points[point] = place
        self.body(second).points[point] = place

    def slide(self, first: str, second: str) -> None:
        """One of the two is the guide; its line passes through a point of it, in any direction."""
        guide, block = self.rng.sample((first, second), 2)
        origin, point, line = self.letter(), self.letter(), self.direction()
        place = self.place()
        self.body(guide).points[origin] = place
        along = self.rng.choice((-1, 1)) * self.rng.uniform(0.02, 0.1)
        self.body(block).points[point] = place + along * line
        self.slides.append((f"s{len(self.slides)}", guide, origin, line, block, point))

    def finish(self, name: str) -> Mechanism:
        for body in self.bodies.values():
            while len(body.points) < 2 and body.name != FRAME:
                body.points[self.letter()] = self.place()
        links = {body.name: link_of(body) for body in self.bodies.values()}
        slides = tuple(self.slide_of(*entry) for entry in self.slides)
        sketch = {p: z for body in self.bodies.values() if body.name != FRAME for p, z in body.points.items()}
        drivers = tuple(self.driver_of(driver) for driver in self.drivers)
        order = {FRAME: links.pop(FRAME), **dict(sorted(links.items()))}
        return Mechanism(name=name, frame="0", links=order, slides=slides, drivers=drivers, sketch=sketch)

    def slide_of(self, name: str, guide: str, origin: str, line: complex, block: str, point: str) -> Slide:
        own = self.bodies[guide].axis
        tilt = cmath.phase(self.bodies[block].axis / line)
        return Slide(name, False, Line(guide, origin, line / own), point, block, tilt)

    def driver_of(self, driver: Driver) -> Driver:
        if driver.kind == "slide":
            _, guide, origin, line, block, point = next(s for s in self.slides if s[0] == driver.link)
            arm = self.bodies[block].points[point] - self.bodies[guide].points[origin]
            value = (arm / line).real
            return Driver("slide", driver.link, value=value, rate=driver.rate, acceleration=driver.acceleration)
        points = self.bodies[driver.link].points
        vector = tuple(points)[:2]
        value = cmath.phase(points[vector[1]] - points[vector[0]])
        from_vector = None
        if driver.from_link != FRAME:
            others = self.bodies[driver.from_link].points
            from_vector = tuple(others)[:2]
            value -= cmath.phase(others[from_vector[1]] - others[from_vector[0]])
        return Driver(
            "angle", driver.link, vector, driver.from_link, from_vector, value, driver.rate, driver.acceleration
        )


def link_of(body: Body) -> Link:
    """The body in its own axes; the frame's are the world's."""
    points = list(body.points.values())
    if body.name == FRAME:
        return Link(FRAME, dict(body.points))
    body.axis = (points[1] - points[0]) / abs(points[1] - points[0])
    return Link(body.name, {name: (z - points[0]) / body.axis for name, z in body.points.items()})


def dyad(kind: str, seed: int) -> Mechanism:
    """A dyad of this kind between two of {frame, crank 1, crank 2}."""
    rng = random.Random(f"{kind}{seed}")
    build = Build(rng, letters=[f"{c}{k}" for k in (2, 1) for c in "ABCDEFGHJKLMNQRSTUVWXYZ"])
    rng.shuffle(build.letters)
    build.body(FRAME)
    for name in ("1", "2"):
        build.hinge(FRAME, name)
        build.body(name).points[build.letter()] = build.place()
        rate, acceleration = rng.uniform(-10, 10), rng.choice((0.0, rng.uniform(-20, 20)))
        relative = name == "2" and rng.random() < 0.3
        build.drivers.append(
            Driver("angle", name, from_link="1" if relative else FRAME, rate=rate, acceleration=acceleration)
        )
    ends = rng.choice([("1", "2"), ("2", "1"), ("1", FRAME), (FRAME, "2"), ("1", "1"), ("2", FRAME)])
    chain = (ends[0], "3", "4", ends[1])
    for joint, first, second in zip(kind, chain, chain[1:]):
        (build.hinge if joint == "R" else build.slide)(first, second)
    return build.finish(f"{kind}-{seed}")


def cylinder(seed: int) -> Mechanism:
    """A driven slide between two unknown links: link 3 and 4 slide, 4 hinged to 5, both ends on known bodies."""
    rng = random.Random(f"cylinder{seed}")
    build = Build(rng, letters=[f"{c}{k}" for k in (2, 1) for c in "ABCDEFGHJKLMNQRSTUVWXYZ"])
    rng.shuffle(build.letters)
    build.body(FRAME)
    build.hinge(FRAME, "1")
    build.body("1").points[build.letter()] = build.place()
    build.drivers.append(Driver("angle", "1", rate=rng.uniform(-5, 5), acceleration=rng.uniform(-5, 5)))
    ends = rng.choice([("1", FRAME), (FRAME, "1"), (FRAME, FRAME), ("1", "1")])
    build.hinge(ends[0], "3")
    build.slide("3", "4")
    build.hinge("4", "5")
    build.hinge("5", ends[1])
    build.drivers.append(Driver("slide", "s0", rate=rng.uniform(-1, 1), acceleration=rng.uniform(-2, 2)))
    return build.finish(f"cylinder-{seed}")


def relative_angle(seed: int) -> Mechanism:
    """A driven angle between two unknown links hinged to each other (a motor carried on a moving link)."""
    rng = random.Random(f"relative{seed}")
    build = Build(rng, letters=[f"{c}{k}" for k in (2, 1) for c in "ABCDEFGHJKLMNQRSTUVWXYZ"])
    rng.shuffle(build.letters)
    build.body(FRAME)
    build.hinge(FRAME, "1")
    build.hinge("1", "2")
    build.hinge("2", "3")
    build.hinge("3", FRAME)
    build.drivers.append(
        Driver("angle", "2", from_link="1", rate=rng.uniform(-5, 5), acceleration=rng.uniform(-5, 5))
    )
    return build.finish(f"relative-{seed}")


def coupler_angle(seed: int) -> Mechanism:
    """A four-bar driven at its coupler: the angle is known before any point is."""
    rng = random.Random(f"coupler{seed}")
    build = Build(rng, letters=[f"{c}{k}" for k in (2, 1) for c in "ABCDEFGHJKLMNQRSTUVWXYZ"])
    rng.shuffle(build.letters)
    build.body(FRAME)
    build.hinge(FRAME, "1")
    build.hinge("1", "2")
    build.hinge("2", "3")
    build.hinge("3", FRAME)
    build.drivers.append(Driver("angle", "2", rate=rng.uniform(-5, 5), acceleration=rng.uniform(-5, 5)))
    return build.finish(f"coupler-{seed}")


def chain(seed: int) -> Mechanism:
    """A crank and two to four dyads of any kind, one hung on another."""
    rng = random.Random(f"chain{seed}")
    build = Build(rng, letters=[f"{c}{k}" for k in (4, 3, 2, 1) for c in "ABCDEFGHJKLMNQRSTUVWXYZ"])
    rng.shuffle(build.letters)
    build.body(FRAME)
    build.hinge(FRAME, "1")
    build.body("1").points[build.letter()] = build.place()
    build.drivers.append(Driver("angle", "1", rate=rng.uniform(-10, 10), acceleration=rng.uniform(-20, 20)))
    known = [FRAME, "1"]
    for _ in range(rng.randint(2, 4)):
        kind, one, two = rng.choice(DYADS), str(len(known)), str(len(known) + 1)
        first = rng.choice(known[1:])
        way = (first, one, two, rng.choice([body for body in known if body != first]))
        for joint, body, other in zip(kind, way, way[1:]):
            (build.hinge if joint == "R" else build.slide)(body, other)
        known += [one, two]
    return build.finish(f"chain-{seed}")
