"""The planner: which equation next. Everything here reads topology; numbers enter only to pick the assembly.

`plan` makes the three constructions of a mechanism once; `replay_all` carries them out, for the drawn
position or for any driver values, scalars or arrays.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from graphkin.errors import GearsApart, HigherClass, NotReached
from graphkin.geometry import Value
from graphkin.mechanism import FRAME, Driver, Mechanism
from graphkin.methods.assembly import DEAD_SINE, assemble, refuse_bad_positions
from graphkin.methods.equivalent import Contact, contacts, lower_pairs
from graphkin.methods.hops import Slip, Twist, way_round
from graphkin.methods.motion import Labels, motion
from graphkin.methods.position import position
from graphkin.methods.special import Ternary, ternary
from graphkin.methods.stages import Bridge, Carry, Group, Loop, Stage, stages
from graphkin.methods.structure import Sliding, Structure
from graphkin.steps import Construction, Equation, Facts, Fit, Meet, Node, Plot, Ray, Roll, Site, Step, Swing, replay
from graphkin.value import frozen

__all__ = ["Method", "plan", "replay_all"]


@frozen
class Method:
    """How a mechanism is solved on paper: three constructions, planned once from its topology.

    stages  the order of solution: bodies carried along, and loops with two unknown scalars
    coincident  points at which links move past each other, with the link whose point the hinge there is
    near, drawn angles by link and displacements by slide at the drawn position: where fitting starts, and from
                where rolling counts
    ternaries   the special point of each Class III group
    """

    mechanism: Mechanism
    structure: Structure
    stages: tuple[Stage, ...]
    position: Construction
    velocity: Construction
    acceleration: Construction
    coincident: Mapping[str, str]
    near: Mapping[str, float]
    drawn: Mapping[str, float]
    ternaries: Mapping[Group, Ternary]

    @property
    def drivers(self) -> tuple[Driver, ...]:
        """The drivers, each with its value at the drawn position."""
        return self.structure.mechanism.drivers

    @property
    def moves_on(self) -> bool:
        """Whether positions are found by moving on from the drawn one: where links are fitted, or wheels roll."""
        return any(isinstance(step, Fit | Roll) for step in self.position.steps)

    @property
    def doubtful(self) -> bool:
        """Whether constraints and drivers, counted by the formula, do not add up: some repeat others, or clash."""
        return any(isinstance(stage, Bridge) for stage in self.stages) or self.structure.surplus != 0

    @property
    def constructions(self) -> tuple[Construction, Construction, Construction]:
        return self.position, self.velocity, self.acceleration

    @property
    def sites(self) -> Mapping[str, Site]:
        """Every point written in the polygons (`C`, `B3`) as a point of the mechanism on a link."""
        nodes = self.velocity.nodes.values()
        return {node.of: node.site for node in nodes if node.site is not None}

    def facts(self, values: Sequence[Value] | None = None) -> Facts:
        """Dimensions, and drivers at the drawn position or at other values [rad, m]."""
        return _facts(self.structure, values, self.drawn)


def plan(mechanism: Mechanism, coincident: str = "", centres: bool = False) -> Method:
    """Plan the constructions of a mechanism, and pick its assembly by the sketch.

    coincident  the point at which sliding pairs are looked at, instead of the one the planner takes
    centres     in Class III groups with two legs on the frame, velocities by the instant centre (综合法)

    Raises a `GraphkinError` where the mechanism holds groups or pairs that are not solved, cannot be
    assembled, or has a sketch that does not tell its assemblies apart.
    """
    lower = lower_pairs(mechanism)
    ties = tuple(contacts(mechanism, lower))
    drawn: dict[str, float] = {}
    if ties or mechanism.poses:
        drawn, lower = _as_drawn(mechanism, lower)
    structure = Structure(lower, ties, coincident, centres)
    order, left = stages(structure)
    if left:
        names = list(dict.fromkeys(structure.home(body) for body in left))
        raise HigherClass(mechanism.where("links", names[0]), tuple(names))
    construction, choices = position(structure, order)
    facts = _facts(structure, None, drawn)
    found = assemble(structure, construction, choices, facts, drawn)
    construction = _with_sides(construction, found.sides)
    plot = replay(construction, Plot(facts, found.near))
    _refuse_gears_apart(mechanism, ties, plot)
    ternaries = _ternaries(structure, order, plot)
    construction = _with_special_points(construction, ternaries)
    meeting = _coincident(structure, order, ternaries)
    labels, pole = Labels(structure, meeting), _pole(mechanism)
    velocity, at = motion(structure, order, labels, "velocity", pole, lambda site: "", ternaries)
    acceleration, _ = motion(structure, order, labels, "acceleration", pole, at, ternaries)
    return Method(
        mechanism, structure, order, construction, velocity, acceleration, meeting, found.near, drawn, ternaries
    )


def _refuse_gears_apart(mechanism: Mechanism, ties: tuple[Contact, ...], plot: Plot) -> None:
    """The centres of a gear pair stand where the other links put them; their radii must fit that."""
    for k, tie in enumerate(ties[: len(mechanism.gears)]):
        distance, wanted = float(abs(plot.arm(*tie.centres))), abs(sum(tie.radii))
        if abs(distance - wanted) > 1e-6 * max(distance, wanted):
            where = mechanism.where("gear", k, "radii")
            raise GearsApart(where, tie.centres, distance * 1000, wanted * 1000)


def _as_drawn(mechanism: Mechanism, lower: Mechanism) -> tuple[dict[str, float], Mechanism]:
    """Angles and displacements at the drawn position, from which rolling counts, and the drivers with all their values.

    There the poses hold, and nothing rolls; a wheel that no pose and no other link turns stands at 0.
    """
    posed = tuple(
        Driver(pose.kind, pose.link, pose.vector, pose.from_link, pose.from_vector, pose.value)
        for pose in mechanism.poses
    )
    standing = tuple(driver for driver in mechanism.drivers if driver.value is not None and driver.kind != "spin")
    still = replace(lower, drivers=(*standing, *posed))
    structure = Structure(still)
    order, _ = stages(structure)
    construction, choices = position(structure, order)
    facts = _facts(structure, None, {})
    found = assemble(structure, construction, choices, facts, {})
    plot = replay(_with_sides(construction, found.sides), Plot(facts, found.near))
    drawn = {link: float(plot.theta[link]) if link in plot.theta else 0.0 for link in structure.bodies}
    drawn |= {slide: float(value) for slide, value in plot.s.items()}
    sketch = {**lower.sketch, **{p: complex(z) for p, z in plot.position.items() if p[0].isupper()}}
    drivers = tuple(_valued(driver, lower, plot, drawn) for driver in mechanism.drivers)
    return drawn, replace(lower, drivers=drivers, sketch=sketch)


def _valued(driver: Driver, lower: Mechanism, plot: Plot, drawn: Mapping[str, float]) -> Driver:
    """A driver whose value a pose has fixed, with that value."""
    if driver.kind == "slide":
        return driver if driver.value is not None else replace(driver, value=drawn[driver.link])
    if driver.kind == "spin":
        return replace(driver, value=drawn[driver.link])
    if driver.value is not None or driver.vector is None:
        return driver
    value = np.angle(plot.arm(*driver.vector))
    if driver.from_vector is not None:
        value -= np.angle(plot.arm(*driver.from_vector))
    return replace(driver, value=float(value))


def _ternaries(structure: Structure, order: tuple[Stage, ...], plot: Plot) -> dict[Group, Ternary]:
    """The special point of each Class III group, with a letter of its own."""
    letters = (letter for letter in "STUVWXYZ" if letter not in structure.owners)
    found: dict[Group, Ternary] = {}
    for stage in order:
        if isinstance(stage, Group) and (one := ternary(structure, stage, plot, next(letters))) is not None:
            found[stage] = one
    return found


def _with_special_points(construction: Construction, ternaries: Mapping[Group, Ternary]) -> Construction:
    """The mechanism with the lines of two legs, which meet in the special point."""
    parts, nodes = list(construction.parts), dict(construction.nodes)
    for one in ternaries.values():
        first, second = (Ray(leg.end.point, leg.line) for leg in one.legs[:2])
        parts += [first, second, Meet(first, second, one.name)]
        nodes[one.name] = Node(one.name, one.name, Site(one.name, one.link))
    return replace(construction, parts=tuple(parts), nodes=nodes)


def replay_all(method: Method, values: Sequence[Value] | None = None) -> Plot:
    """All three constructions at the drawn position, or at `values`: one entry a driver, scalar or (n,) [rad, m].

    A single position that is a dead point, or that is not reached from the drawn one without passing a dead
    point, raises; in arrays such positions are what the crossings give, or NaN, and `Plot.sines` tells how near
    each position is to a dead point.
    """
    if values is not None and not any(np.ndim(value) for value in values):
        values = _reached(method, values)
    plot = _positioned(method, values)
    refuse_bad_positions(method.structure, method.position, plot)
    replay(method.velocity, plot)
    return replay(method.acceleration, plot)


def _reached(method: Method, values: Sequence[Value]) -> Sequence[Value]:
    """The values, or the same angles the other way round where only that way is free of dead points."""
    start = method.facts(None).values
    try:
        _refuse_dead_points_between(method, values)
    except NotReached:
        if method.structure.contacts:
            raise
        other = [
            end - np.copysign(2 * np.pi, end - begin) if driver.kind == "angle" and end != begin else end
            for begin, end, driver in zip(start, values, method.drivers, strict=True)
        ]
        try:
            _refuse_dead_points_between(method, other)
        except NotReached:
            pass
        else:
            return other
        raise
    return values


WAY_DEG = 0.5
"""How closely the way to another position is looked at for dead points [deg]."""


def _refuse_dead_points_between(method: Method, values: Sequence[Value]) -> None:
    """Whether the mechanism gets from the drawn position to this one by moving on."""
    start = np.array([float(value) for value in method.facts(None).values])
    way = np.array([float(value) for value in values]) - start
    size = max(abs(z) for shape in method.structure.shapes.values() for z in shape.values()) or 1.0
    units = [size * 0.002 if driver.kind == "slide" else np.radians(WAY_DEG) for driver in method.drivers]
    count = int(np.ceil(np.max(np.abs(way) / units))) if way.size else 0
    if count == 0:
        return
    shares = np.linspace(0.0, 1.0, count + 1)
    for _ in range(3):
        sines = _least_sines(method, start, way, shares)
        bad = np.flatnonzero(~(sines >= DEAD_SINE))
        if bad.size:
            raise _not_reached(method, start, way, float(shares[bad[0]]))
        low = int(np.argmin(sines))
        if sines[low] > 0.3:
            return
        shares = np.linspace(shares[max(low - 1, 0)], shares[min(low + 1, shares.size - 1)], 201)


def _least_sines(method: Method, start: np.ndarray, way: np.ndarray, shares: np.ndarray) -> np.ndarray:
    """The least angle at which lines meet, at each share of the way; NaN where they do not."""
    values = [begin + go * shares for begin, go in zip(start, way, strict=True)]
    plot = _positioned(method, values)
    names = {step.name for step in method.ternaries.values()}
    sines = [
        np.broadcast_to(sine, shares.shape)
        for (plane, point), sine in plot.sines.items()
        if plane == "position" and point not in names
    ]
    least: np.ndarray = np.min([np.ones_like(shares), *sines], axis=0)
    return least


def _not_reached(method: Method, start: np.ndarray, way: np.ndarray, share: float) -> NotReached:
    moving = int(np.argmax(np.abs(way)))
    driver = method.drivers[moving]

    def told(value: float) -> str:
        return f"{value * 1000:.6g} mm" if driver.kind == "slide" else f"{np.degrees(value):.6g}°"

    where = method.mechanism.where("driver", moving)
    end, stop = start[moving] + way[moving], start[moving] + share * way[moving]
    return NotReached(where, driver.name, told(start[moving]), told(end), told(stop))


STEP_DEG, STEP_PART = 3.0, 0.02
"""How far a mechanism is moved at once where its position is found from the one before [deg, of its size]."""


def _positioned(method: Method, values: Sequence[Value] | None) -> Plot:
    """Positions, all at once; where they hang on those before (a fit, rolling) by moving on from the drawn one."""
    facts = method.facts(values)
    if values is None or not method.moves_on:
        plot = Plot(facts, method.near if method.moves_on else {})
        return replay(method.position, plot)
    start = method.facts(None).values
    ways = [np.asarray(end) - begin for begin, end in zip(start, facts.values, strict=True)]
    longest = 1.0 / _stretches(method, facts, ways)
    done, step, before = 0.0, longest, dict(method.near)
    near: dict[str, Value] = before
    slope: dict[str, Value] = dict.fromkeys(near, 0.0)
    while True:
        there = min(1.0, done + step)
        values = tuple(begin + way * there for begin, way in zip(start, ways, strict=True))
        guess = {name: near[name] + slope[name] * (there - done) for name in near}
        plot = replay(method.position, Plot(replace(facts, values=values), guess))
        now = {base: plot.theta[base] for base in method.structure.bases} | dict(plot.s)
        if _surprise(now, guess, method.structure.bases) > SURPRISE and step > longest / 256:
            step /= 2
            continue
        if there == 1.0:
            return plot
        slope = {name: np.nan_to_num((now[name] - near[name]) / (there - done)) for name in now}
        near, done, step = now, there, min(longest, 1.5 * step)


SURPRISE = 0.02
"""How far a link may turn beside what its turning so far foretold [rad]; more, and the step is halved."""


def _stretches(method: Method, facts: Facts, ways: Sequence[Value]) -> int:
    """In how many steps the drivers go their way."""
    size = max(abs(z) for shape in facts.shapes.values() for z in shape.values()) or 1.0
    drivers = method.structure.mechanism.drivers
    units = [size * STEP_PART if driver.kind == "slide" else np.radians(STEP_DEG) for driver in drivers]
    return max(1, *(int(np.ceil(np.max(np.abs(way)) / unit)) for way, unit in zip(ways, units, strict=True)))


def _surprise(now: Mapping[str, Value], guess: Mapping[str, Value], bases: Sequence[str]) -> float:
    """The largest angle between where links are and where they were expected."""
    return max((float(np.nanmax(np.abs(now[b] - guess[b]), initial=0.0)) for b in bases), default=0.0)


def _facts(structure: Structure, values: Sequence[Value] | None, drawn: Mapping[str, float]) -> Facts:
    mechanism = structure.mechanism
    drivers = mechanism.drivers
    return Facts(
        frame=FRAME,
        shapes=structure.shapes,
        lines={s.name: (s.guide, s.line.origin, s.line.direction) for s in mechanism.slides},
        turns=structure.turns,
        slides_driven=structure.slides_driven,
        values=tuple(values) if values is not None else tuple(driver.value or 0.0 for driver in drivers),
        rates=tuple(driver.rate for driver in drivers),
        accelerations=tuple(driver.acceleration for driver in drivers),
        drawn=drawn,
    )


def _pole(mechanism: Mechanism) -> str:
    """p, or the next letter that no point of the mechanism takes."""
    return next(letter for letter in ("p", "o", "q", "z", "pole") if letter.upper() not in mechanism.owners)


def _coincident(
    structure: Structure, order: tuple[Stage, ...], ternaries: Mapping[Group, Ternary]
) -> dict[str, str]:
    """Points at which links move past a moving link, with the link of which the hinge there is a point."""
    found: dict[str, str] = {}
    for stage in order:
        for hop in _jumps(structure, stage, ternaries):
            if FRAME not in (hop.seen_from.link, hop.of.link) or isinstance(hop, Twist):
                owners = structure.owners[hop.of.point]
                homes = [site.link for site in (hop.of, hop.seen_from) if site.link in owners]
                if homes:
                    found.setdefault(hop.of.point, structure.home(homes[0]))
    return found


def _jumps(structure: Structure, stage: Stage, ternaries: Mapping[Group, Ternary]) -> list[Slip | Twist]:
    """The coincident points of one stage."""
    if isinstance(stage, Loop):
        return [hop for hop in way_round(structure, stage)[1] if isinstance(hop, Slip | Twist)]
    if isinstance(stage, Group):
        ways = [way_round(structure, loop)[1] for loop in stage.loops]
        return [hop for way in ways for hop in way if isinstance(hop, Slip | Twist)]
    if isinstance(stage, Carry) and isinstance(stage.by, Sliding):
        pair = structure.slides[stage.by.slide]
        ends = (Site(pair.point, pair.guide), Site(pair.point, structure.block(pair)))
        return [Slip(ends[0], ends[1], True, pair.name)]
    return []


def _with_sides(construction: Construction, sides: tuple[int, ...]) -> Construction:
    """The construction with the crossings that the sketch asks for."""
    parts: list[Step | Equation] = []
    for part in construction.parts:
        if isinstance(part, Equation):
            parts.append(replace(part, steps=tuple(_chosen(step, sides) for step in part.steps)))
        else:
            parts.append(_chosen(part, sides))
    return replace(construction, parts=tuple(parts))


def _chosen(step: Step, sides: tuple[int, ...]) -> Step:
    if isinstance(step, Meet | Swing) and step.choice is not None:
        return replace(step, side=sides[step.choice])
    return step
