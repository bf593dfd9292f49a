"""The closed vector polygons and the rolling contacts: all that the equations of a mechanism are.

Each link is an arrow with a length and an angle, from the frame round to the frame. A polygon goes through the links of
one stage of the plan (two unknown scalars) and closes over links known before, by as few as there are. A rolling
contact is an angle relation, r1 θ1 + r2 θ2 − (r1 + r2) θH = c, from the motion seen from the arm.
"""

from __future__ import annotations

import cmath
from collections import deque
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, field, replace

from graphkin.analytic import Motion
from graphkin.base.geometry import number
from graphkin.base.value import frozen
from graphkin.equations.bodies import Bodies, quarters
from graphkin.equations.expressions import AngleSum, Sum, Symbol, SymbolProduct, one, phasor
from graphkin.equations.legend import Legend, slide_readers
from graphkin.model.mechanism import FRAME
from graphkin.planning.equivalent import Contact
from graphkin.planning.structure import Hinge, Joint, Sliding, Topology
from graphkin.say.catalogue import meaning

Site = tuple[str, str]  # a point and the body it is taken on


@frozen
class LinkVector:
    """One link vector: its length, its angle, from where to where it points; sign -1 where walked backwards."""

    length: Symbol
    angle: AngleSum
    tail: Site
    head: Site
    sign: int = 1

    @property
    def sum(self) -> Sum:
        return phasor(one(self.length).times(float(self.sign)), self.angle)

    @property
    def forward(self) -> bool:
        """True for an arrow of the left side of the equation: half turns of its angle count."""
        return self.sum.terms[0].factor > 0


@frozen
class ClosedPolygon:
    """Arrows that close; `sum` of them is zero."""

    arrows: tuple[LinkVector, ...]

    @property
    def sum(self) -> Sum:
        """The arrows in the order of the sides: what is zero."""
        left, right = self.sides
        return Sum.of(term for arrow in (*left, *right) for term in arrow.sum.terms)

    @property
    def sides(self) -> tuple[tuple[LinkVector, ...], tuple[LinkVector, ...]]:
        """Arrows walked forward, and those walked backward in the order they are met from the start."""
        walk = self.walk
        return tuple(a for a in walk if a.forward), tuple(a for a in reversed(walk) if not a.forward)

    @property
    def walk(self) -> tuple[LinkVector, ...]:
        """Once round, beginning where arrows walked forward begin."""
        forward = [arrow.forward for arrow in self.arrows]
        first = next((k for k, each in enumerate(forward) if each and not forward[k - 1]), 0)
        return (*self.arrows[first:], *self.arrows[:first])


@dataclass
class LinkVectorMaker:
    """Makes the arrows of links and slides, each once."""

    bodies: Bodies
    legend: Legend
    arms: dict[tuple[str, frozenset[str]], LinkVector] = field(default_factory=dict)
    slides: dict[str, Symbol] = field(default_factory=dict)
    radii: dict[tuple[str, str], Symbol] = field(default_factory=dict)

    @property
    def structure(self) -> Topology:
        return self.bodies.structure

    def along(self, body: str, start: str, end: str) -> Iterator[LinkVector]:
        """The arrow on one body from a point to another; none where they lie at one place."""
        shape = self.structure.shapes[body]
        size = max((abs(p - q) for p in shape.values() for q in shape.values()), default=0.0)
        if start == end or abs(shape[end] - shape[start]) <= 1e-12 * size:
            return
        key = body, frozenset((start, end))
        if key not in self.arms:
            self.arms[key] = self._arm(body, start, end)
        arrow = self.arms[key]
        yield arrow if arrow.tail[0] == start else replace(arrow, sign=-1)

    def _arm(self, body: str, start: str, end: str) -> LinkVector:
        """Along the link's own direction where it lies on it; else as nearly so as can be."""
        shape = self.structure.shapes[body]
        arm = shape[end] - shape[start]
        count = quarters(cmath.phase(arm))
        if count in (2, 3) if count is not None else arm.real < 0:
            start, end, arm = end, start, -arm
            count = None if count is None else (count + 2) % 4
        called = self.bodies.called(body)
        text = meaning("equations.length", ends=self.bodies.spot(start) + self.bodies.spot(end), link=called)
        length = self.legend.constant("l", called, text, "mm", abs(arm))
        angle = AngleSum((), count or 0)
        if count is None:  # a letter for the angle of the arrow against its link, or on the frame
            vector = length.letter + ("" if length.low.isdigit() else "_") + length.low + "'" * length.primes
            letter, text = "β", meaning("equations.offset", link=called, vector=vector)
            if body == FRAME:
                letter, text = "θ", meaning("equations.frame direction", vector=vector)
            low = called + "'" * length.primes
            angle = AngleSum.of(self.legend.constant(letter, low, text, "deg", cmath.phase(arm)))
        return LinkVector(length, self.bodies.angles[body] + angle, (start, body), (end, body))

    def sliding(self, name: str) -> LinkVector:
        """The displacement along a slide's line, from its origin on the guide to the point."""
        slide = self.structure.slides[name]
        angle = self.bodies.angles[slide.guide] + self.bodies.line(slide)
        tail, head = (slide.line.origin, slide.guide), (slide.point, self.structure.block(slide))
        return LinkVector(self.displacement(name), angle, tail, head)

    def displacement(self, name: str) -> Symbol:
        """The symbol of a slide's displacement."""
        if name not in self.slides:
            slide = self.structure.slides[name]
            driver = self.structure.slides_driven.get(name)
            steady = driver is not None and self.structure.mechanism.drivers[driver].acceleration == 0
            # s_E on the frame; s3 along link 3's own direction; s2 where the block's direction is the line's
            own = quarters(cmath.phase(slide.line.direction)) in (0, 2)
            body = slide.guide if own or slide.block is None or slide.tilt != 0 else slide.block
            low = slide.point if slide.guide == FRAME else self.bodies.called(body)
            symbol = self.legend.fresh("s", low, "displacement", steady)
            guide, start = self.bodies.called(slide.guide), self.bodies.spot(slide.line.origin)
            words = {"point": slide.point, "guide": guide, "start": start}
            rates = ("displacement", "velocity", "acceleration")
            texts = (meaning(f"equations.sliding {rate}", **words) for rate in rates)
            readers = slide_readers(self.structure, slide)
            self.slides[name] = self.legend.variable(symbol, tuple(texts), ("mm", "m/s", "m/s^2"), readers)
        return self.slides[name]

    def point_of(self, joint: Joint, body: str) -> str:
        """The point of a body in which a joint is."""
        return joint.point if isinstance(joint, Hinge) else self.structure.slide_point(joint.slide, body)

    def radius(self, wheel: str, radius: float) -> Symbol:
        """The radius of a wheel's circle, one letter for each size."""
        name, size = self.bodies.called(wheel), f"{radius * 1000:.12g}"
        if (name, size) not in self.radii:
            text = meaning("equations.radius", radius=size, wheel=name)
            self.radii[name, size] = self.legend.constant("r", name, text, "mm", radius)
        return self.radii[name, size]


def shortest_path(
    structure: Topology, known: Collection[str], starts: Sequence[str], ends: Collection[str]
) -> tuple[list[str], list[Joint]]:
    """The bodies, and the joints between them, of the shortest path over known bodies; the frame goes first."""
    queue = deque([([start], list[Joint]()) for start in starts])
    seen = set(starts)
    while queue:
        bodies, joints = queue.popleft()
        if bodies[-1] in ends:
            return bodies, joints
        for joint, others in structure.joints(bodies[-1]):
            for other in sorted(others, key=lambda body: body != FRAME):
                if other in known and other not in seen:
                    seen.add(other)
                    queue.append(([*bodies, other], [*joints, joint]))
    raise ValueError(f"no path from {starts} to {ends}")


def closed(
    arrows: LinkVectorMaker, known: Collection[str], bodies: Sequence[str], joints: Sequence[Joint]
) -> ClosedPolygon:
    """The polygon through `bodies`, entered by the first of `joints` and left by the last, closed over known bodies.
    Where the last joint is the first, the bodies are a ring by themselves, whether or not any of them is known."""
    structure = arrows.structure

    def known_side(joint: Joint, body: str) -> list[str]:
        """The known bodies at the other side of a joint, the frame first."""
        if isinstance(joint, Hinge):
            owners = [other for other in structure.owners[joint.point] if other != body and other in known]
            return sorted(owners, key=lambda other: other != FRAME)
        slide = structure.slides[joint.slide]
        return [slide.guide if body != slide.guide else structure.block(slide)]

    if joints[0] == joints[-1]:
        return ClosedPolygon(tuple(_ring(arrows, bodies, joints[:-1])))
    near, far = known_side(joints[0], bodies[0]), known_side(joints[-1], bodies[-1])
    back, between = shortest_path(structure, known, far, near)
    return ClosedPolygon(tuple(_ring(arrows, [*bodies, *back], [*joints, *between])))


def _ring(arrows: LinkVectorMaker, ring: Sequence[str], joints: Sequence[Joint]) -> Iterator[LinkVector]:
    """All arrows of a ring of bodies: joint k leads into body k, the first one out of the last."""
    for k, body in enumerate(ring):
        into, out = joints[k], joints[(k + 1) % len(joints)]
        if isinstance(into, Sliding):
            backward = arrows.structure.slides[into.slide].guide == body
            yield replace(arrows.sliding(into.slide), sign=-1 if backward else 1)
        yield from arrows.along(body, arrows.point_of(into, body), arrows.point_of(out, body))


@frozen
class RollingSum:
    """sum = 0: what turns and slides, less the constant of the drawn position, of one rolling contact."""

    contact: Contact
    moving: Sum
    constant: Symbol

    @property
    def sum(self) -> Sum:
        return self.moving - one(self.constant)


def rolling(arrows: LinkVectorMaker, contact: Contact, motion: Motion) -> RollingSum:
    """The relation of one contact; its constant is what the drawn position gives."""
    track, wheel = (turning_part(arrows.bodies.angles[body]) for body in contact.wheels)
    moving = Sum()
    if contact.arm:
        arm = turning_part(arrows.bodies.angles[contact.arm])
        for body, turn, radius in zip(contact.wheels, (track, wheel), contact.radii, strict=True):
            moving += one(arrows.radius(body, abs(radius))).times(1.0 if radius > 0 else -1.0) * (turn - arm)
    else:  # s + r (θ_wheel − θ_track) where the centre lies left of the line, s − r (..) where right
        radius = next(share for body, share in contact.angles if body == contact.wheels[1])
        rolled = one(arrows.radius(contact.wheels[1], radius)) * (wheel - track)
        for slide, share in contact.way or ((contact.slide, 1.0),):  # other pairs may keep the centre on its path
            moving += one(arrows.displacement(slide)).times(share * contact.on_slide)
        moving += rolled
    value = number(moving.at({symbol: arrows.legend.entries[symbol].read(motion) for symbol in moving.symbols}))
    names = [arrows.bodies.called(wheel) for wheel in contact.wheels]
    text = meaning("equations.rolling constant", first=names[0], second=names[1])
    low = "".join(names) if all(map(str.isdigit, names)) else names[1]
    return RollingSum(contact, moving, arrows.legend.constant("c", low, text, "mm rad", value))


def turning_part(angle: AngleSum) -> Sum:
    """The part of an angle that changes with time."""
    return Sum.of(SymbolProduct(float(count), ((symbol, 1),)) for symbol, count in angle.moving)
