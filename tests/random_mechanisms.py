"""Random mechanisms for the tests: poses first, dimensions from them, so that every one can be assembled.

Two cranks with drivers of their own and the frame are the known bodies; a dyad of the wanted kind hangs
between two of them. Each sliding pair draws by lot which body is the guide, whether its line runs through a
point or beside it, and what the block looks like.
"""

from __future__ import annotations

import cmath
import math
import random
from dataclasses import dataclass, field, replace

from graphkin.model.mechanism import FRAME, Driver, Link, Mechanism, Pose
from graphkin.model.pairs import Cam, CircularSlot, Gear, Line, Profile, RollingContact, Slide

DYADS = ("RRR", "RRP", "PRR", "RPR", "PRP", "RPP", "PPR")


Seed = int | tuple[int, int]
"""What a mechanism is drawn by; a pair has all the kinds and names of its first number, and dimensions of its own."""


class Alike(random.Random):
    """Draws kinds and names by one text, numbers by another."""

    def __init__(self, kinds: str, numbers: str) -> None:
        super().__init__(kinds)
        self.numbers = random.Random(numbers)

    def uniform(self, a: float, b: float) -> float:
        return self.numbers.uniform(a, b)


def drawn(name: str, seed: Seed) -> random.Random:
    return random.Random(f"{name}{seed}") if isinstance(seed, int) else Alike(f"{name}{seed[0]}", f"{name}{seed}")


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
        return Mechanism(name=name, frame="0", links=order, pairs=slides, drivers=drivers, sketch=sketch)

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


def dyad(kind: str, seed: Seed) -> Mechanism:
    """A dyad of this kind between two of {frame, crank 1, crank 2}."""
    rng = drawn(kind, seed)
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


def cylinder(seed: Seed) -> Mechanism:
    """A driven slide between two unknown links: link 3 and 4 slide, 4 hinged to 5, both ends on known bodies."""
    build = _begun(seed, "cylinder", crank=False)
    rng = build.rng
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


def relative_angle(seed: Seed) -> Mechanism:
    """A driven angle between two unknown links hinged to each other (a motor carried on a moving link)."""
    build = _begun(seed, "relative", crank=False)
    rng = build.rng
    build.hinge(FRAME, "1")
    build.hinge("1", "2")
    build.hinge("2", "3")
    build.hinge("3", FRAME)
    build.drivers.append(
        Driver("angle", "2", from_link="1", rate=rng.uniform(-5, 5), acceleration=rng.uniform(-5, 5))
    )
    return build.finish(f"relative-{seed}")


def coupler_angle(seed: Seed) -> Mechanism:
    """A four-bar driven at its coupler: the angle is known before any point is."""
    build = _begun(seed, "coupler", crank=False)
    rng = build.rng
    build.hinge(FRAME, "1")
    build.hinge("1", "2")
    build.hinge("2", "3")
    build.hinge("3", FRAME)
    build.drivers.append(Driver("angle", "2", rate=rng.uniform(-5, 5), acceleration=rng.uniform(-5, 5)))
    return build.finish(f"coupler-{seed}")


def chain(seed: Seed) -> Mechanism:
    """A crank and two to four dyads of any kind, one hung on another."""
    build = _begun(seed, "chain", crank=False)
    rng = build.rng
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


# --- groups of Class III, gears, rolling, cams -------------------------------------------------


def _begun(seed: Seed, name: str, crank: bool = True) -> Build:
    """A frame, and a driven crank on it."""
    rng = drawn(name, seed)
    build = Build(rng, letters=[f"{c}{k}" for k in (4, 3, 2, 1) for c in "ABCDEFGHJKLMNQRSTUVWXYZ"])
    rng.shuffle(build.letters)
    build.body(FRAME)
    if crank:
        build.hinge(FRAME, "1")
        build.body("1").points[build.letter()] = build.place()
        build.drivers.append(Driver("angle", "1", rate=rng.uniform(-10, 10), acceleration=rng.uniform(-20, 20)))
    return build


def triad(seed: Seed) -> Mechanism:
    """A ternary link on three legs: bars, blocks on known guides, or blocks on the ternary link itself."""
    build = _begun(seed, "triad")
    rng = build.rng
    grounds = ["1", FRAME, rng.choice(("1", FRAME))]
    rng.shuffle(grounds)
    for leg, ground in zip(("3", "4", "5"), grounds, strict=True):
        kind = rng.choice(("RR", "RR", "RP", "PR"))
        if kind == "RR":
            build.hinge(ground, leg)
            build.hinge(leg, "2")
        elif kind == "RP":
            build.slide(ground, leg)
            build.hinge(leg, "2")
        else:
            build.hinge(ground, leg)
            build.slide(leg, "2")
    return build.finish(f"triad-{seed}")


def six_bar(seed: Seed) -> Mechanism:
    """Watt's or Stephenson's chain, driven at any link of it by its angle against the frame."""
    build = _begun(seed, "six", crank=False)
    rng = build.rng
    if rng.random() < 0.5:
        pairs = [(FRAME, "1"), ("1", "2"), ("2", "3"), ("3", FRAME), ("3", "4"), ("4", "5"), ("5", FRAME)]
    else:
        pairs = [(FRAME, "1"), ("1", "2"), ("2", "3"), ("3", FRAME), ("2", "4"), ("4", "5"), ("5", FRAME)]
    for first, second in pairs:
        build.hinge(first, second)
    build.drivers.append(
        Driver("angle", str(rng.randint(1, 5)), rate=rng.uniform(-5, 5), acceleration=rng.uniform(-9, 9))
    )
    return build.finish(f"six-{seed}")


def geared_five_bar(seed: Seed) -> Mechanism:
    """Two cranks geared to each other; or a coupler geared to a fixed sun about the crank, driven at either end."""
    rng = drawn("kind", seed)
    kind = rng.choice(("cranks", "planet", "planet driven from the far end"))
    build = _begun(seed, "geared", crank=False)
    build.hinge(FRAME, "1")
    build.body("1").points[build.letter()] = build.place()
    build.hinge(FRAME, "4")
    build.hinge("1", "2")
    build.hinge("2", "3")
    build.hinge("3", "4")
    driven = "4" if kind.endswith("end") else "1"
    build.drivers.append(
        Driver("angle", driven, rate=rng.uniform(-10, 10), acceleration=rng.uniform(-20, 20))
    )
    machine = build.finish(f"geared-{seed}")
    links = ("1", "4") if kind == "cranks" else (FRAME, "2")
    pivots = [_shared(machine, FRAME, "1"), _shared(machine, FRAME, "4") if kind == "cranks" else _shared(machine, "1", "2")]
    carrier = FRAME if kind == "cranks" else "1"
    gear = _gear(rng, links, (pivots[0], pivots[1]), abs(machine.links[carrier].arm(*pivots)))
    posed = "4" if driven == "1" else "1"
    return replace(machine, pairs=(gear,), poses=(_pose(machine, build, posed),))


def _shared(machine: Mechanism, first: str, second: str) -> str:
    """The hinge of two links."""
    return next(point for point in machine.links[first].points if point in machine.links[second].points)


def _gear(rng: random.Random, links: tuple[str, str], centres: tuple[str, str], distance: float) -> Gear:
    if rng.random() < 0.5:
        share = rng.uniform(0.2, 0.8)
        return Gear("g0", links, centres, (distance * share, distance * (1 - share)), False)
    ratio = rng.uniform(1.5, 3)
    small = distance / (ratio - 1)
    radii = (small * ratio, small) if rng.random() < 0.5 else (small, small * ratio)
    return Gear("g0", links, centres, radii, True)


def _pose(machine: Mechanism, build: Build, link: str) -> Pose:
    """How a link stands at the drawn position."""
    points = build.bodies[link].points
    vector = tuple(machine.links[link].points)[:2]
    return Pose("angle", link, cmath.phase(points[vector[1]] - points[vector[0]]), vector)


def epicyclic(seed: Seed) -> Mechanism:
    """Sun, planet and ring on one arm, any of the three coaxial ones fixed or driven; a bar and rocker on the planet."""
    build = _begun(seed, "epicyclic", crank=False)
    rng = build.rng
    centre, planet = build.letter(), build.letter()
    place, arm = build.place(), cmath.rect(rng.uniform(0.03, 0.06), rng.uniform(0, 6.28))
    build.body(FRAME).points[centre] = place
    build.body("2").points |= {planet: place + arm, build.letter(): build.place()}
    build.body("4").points |= {centre: place, planet: place + arm}
    small = abs(arm) * rng.uniform(0.2, 0.6)
    sun, ring = abs(arm) - small, abs(arm) + small
    build.body("1").points |= {centre: place, build.letter(): build.place()}
    build.hinge("2", "5")
    build.hinge("5", "6")
    build.hinge("6", FRAME)
    driven = rng.choice(("1", "4", "2"))
    build.drivers.append(Driver("angle", driven, rate=rng.uniform(-9, 9), acceleration=rng.uniform(-9, 9)))
    machine = build.finish(f"epicyclic-{seed}")
    gears = (
        Gear("g0", ("1", "2"), (centre, planet), (sun, small), False),
        Gear("g1", ("2", FRAME), (planet, centre), (small, ring), True),
    )
    poses = tuple(_pose(machine, build, link) for link in ("1", "2", "4") if link != driven)
    return replace(machine, pairs=gears, poses=poses)


def rolling(seed: Seed) -> Mechanism:
    """A wheel on a line or circle of the frame or of the crank, pushed at its centre by a bar from the other one."""
    build = _begun(seed, "rolling")
    rng = build.rng
    track, other = rng.choice(((FRAME, "1"), ("1", FRAME)))
    radius, centre = rng.uniform(0.01, 0.04), build.letter()
    spot = build.place()
    build.body("2").points |= {centre: spot, build.letter(): spot + radius * build.direction()}
    build.body("3").points[centre] = spot
    build.hinge("3", other)
    if rng.random() < 0.5:
        machine = build.finish(f"rolling-{seed}")
        return _on_a_line(build, machine, track, centre, spot, radius)
    hub, away, internal = build.letter(), build.direction(), rng.random() < 0.5
    rim = radius * rng.uniform(1.5, 3)
    build.body(track).points[hub] = spot + away * (rim - radius if internal else rim + radius)
    machine = build.finish(f"rolling-{seed}")
    roll = RollingContact("r0", False, "2", centre, radius, track, None, True, hub, rim, internal)
    return replace(machine, pairs=(*machine.pairs, roll), poses=(_pose(machine, build, "2"),))


def _on_a_line(
    build: Build, machine: Mechanism, track: str, centre: str, spot: complex, radius: float
) -> Mechanism:
    left, line, origin = build.rng.random() < 0.5, build.direction(), "r0"
    foot = spot - 1j * line * (radius if left else -radius) - line * build.rng.uniform(-0.05, 0.05)
    body = build.bodies[track]
    first = next(iter(body.points.values())) if track != FRAME else 0j
    points = {**machine.links[track].points, origin: (foot - first) / body.axis}
    links = {**machine.links, track: Link(track, points)}
    roll = RollingContact("r0", False, "2", centre, radius, track, Line(track, origin, line / body.axis, False), left, None, 0.0, False)
    return replace(machine, links=links, pairs=(*machine.pairs, roll), poses=(_pose(machine, build, "2"),))


def cam(seed: Seed) -> Mechanism:
    """A disc on the crank against a disc, a knife edge or a flat face of a turning or a sliding follower."""
    build = _begun(seed, "cam")
    rng = build.rng
    disc, spot, radius = build.letter(), build.place(), rng.uniform(0.01, 0.05)
    build.body("1").points[disc] = spot
    (build.hinge if rng.random() < 0.6 else build.slide)(FRAME, "2")
    if rng.random() < 0.5:
        mate, away = build.letter(), build.direction()
        internal = rng.random() < 0.3
        other = rng.choice((0.0, rng.uniform(0.005, 0.04)))
        length = abs(radius - other) if internal else radius + other
        build.body("2").points[mate] = spot + away * length
        machine = build.finish(f"cam-{seed}")
        profiles = (Profile(disc, radius, None, True), Profile(mate, other, None, True))
        return replace(machine, pairs=(*machine.pairs, Cam("c0", ("1", "2"), profiles, internal)))
    left, line, origin = rng.random() < 0.5, build.direction(), build.letter()
    build.body("2").points[origin] = spot - 1j * line * (radius if left else -radius) - 0.02 * line
    machine = build.finish(f"cam-{seed}")
    face = Profile(None, 0.0, Line("2", origin, line / build.bodies["2"].axis), left)
    return replace(machine, pairs=(*machine.pairs, Cam("c0", ("1", "2"), (Profile(disc, radius, None, True), face), False)))


def circular_slot(seed: Seed) -> Mechanism:
    """Pins in circular slots: of a follower, of a link on a coupler, one leg of a ternary link, or all three.

    Crank, frame, follower or coupler has the slot, and another the pin; followers turn or slide.
    """
    build = _begun(seed, "circular")
    rng = build.rng
    kind = rng.choice(("follower", "on a coupler", "leg", "three slots"))
    grounds = [FRAME, "1", rng.choice((FRAME, "1"))]
    rng.shuffle(grounds)
    if kind == "follower":
        other, ground = rng.choice(((FRAME, "1"), ("1", FRAME)))
        (build.hinge if rng.random() < 0.6 else build.slide)(other, "2")
        slots = [(ground, "2")]
    elif kind == "on a coupler":
        build.hinge("1", "2")
        build.hinge("2", "3")
        (build.hinge if rng.random() < 0.7 else build.slide)("3", FRAME)
        (build.hinge if rng.random() < 0.6 else build.slide)(rng.choice((FRAME, "1")), "4")
        slots = [("2", "4")]
    elif kind == "leg":
        for leg, ground in zip(("3", "4"), grounds):
            build.hinge(ground, leg)
            build.hinge(leg, "2")
        slots = [(grounds[2], "2")]
    else:
        slots = [(ground, "2") for ground in grounds]
    return _with_slots(build, f"circular-{seed}", slots)


def _with_slots(build: Build, name: str, slots: list[tuple[str, str]]) -> Mechanism:
    """A pin of one link of each two in a circular slot of the other."""
    ends = []
    for two in slots:
        guide, link = build.rng.sample(two, 2)
        centre, pin = build.letter(), build.letter()
        build.body(guide).points[centre] = build.place()
        build.body(link).points[pin] = build.place()
        ends.append((guide, centre, link, pin))
    machine = build.finish(name)
    return replace(machine, pairs=(*machine.pairs, *(
        CircularSlot(
            f"c{k}", guide, centre, abs(build.bodies[guide].points[centre] - build.bodies[link].points[pin]), link, pin
        ) for k, (guide, centre, link, pin) in enumerate(ends)
    )))  # fmt: skip
