"""The closed vector polygons: each link an arrow with a length and an angle, from the frame round to the frame.

A polygon goes through the links of one stage of the plan (two unknown scalars) and closes over links known before,
by as few as there are.
"""

from __future__ import annotations

import cmath
from collections import deque
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, field

from graphkin.base.value import frozen
from graphkin.equations.bodies import Bodies, quarters
from graphkin.equations.expressions import Sum, SymbolProduct, one, phasor
from graphkin.equations.legend import Legend
from graphkin.equations.readers import slide_readers
from graphkin.equations.symbols import AngleSum, Symbol
from graphkin.model.mechanism import FRAME
from graphkin.model.pairs import Slide
from graphkin.planning.structure import Hinge, Joint, Sliding, Topology
from graphkin.say.catalogue import meaning

Site = tuple[str, str]
"""A point and the body it is taken on."""


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
        return phasor(Sum((SymbolProduct(float(self.sign)),)) * one(self.length), self.angle)


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
        return tuple(a for a in walk if _sign(a) > 0), tuple(a for a in reversed(walk) if _sign(a) < 0)

    @property
    def walk(self) -> tuple[LinkVector, ...]:
        """Once round, beginning where arrows walked forward begin."""
        signs = [_sign(arrow) for arrow in self.arrows]
        first = next((k for k, sign in enumerate(signs) if sign > 0 and signs[k - 1] < 0), 0)
        return (*self.arrows[first:], *self.arrows[:first])


def _sign(arrow: LinkVector) -> float:
    """Which side of the equation an arrow stands on: half turns of its angle count."""
    return arrow.sum.terms[0].factor


@dataclass
class LinkVectorMaker:
    """Makes the arrows of links and slides, each once."""

    bodies: Bodies
    ledger: Legend
    arms: dict[tuple[str, frozenset[str]], LinkVector] = field(default_factory=dict)
    slides: dict[str, Symbol] = field(default_factory=dict)
    radii: dict[tuple[str, str], Symbol] = field(default_factory=dict)
    sizes: dict[str, float] = field(default_factory=dict)

    @property
    def structure(self) -> Topology:
        return self.bodies.structure

    def along(self, body: str, start: str, end: str) -> Iterator[LinkVector]:
        """The arrow on one body from a point to another; none where they lie at one place."""
        shape = self.structure.shapes[body]
        if start == end or abs(shape[end] - shape[start]) <= 1e-12 * self._size(body):
            return
        key = body, frozenset((start, end))
        if key not in self.arms:
            self.arms[key] = self._arm(body, start, end)
        arrow = self.arms[key]
        yield arrow if arrow.tail[0] == start else LinkVector(arrow.length, arrow.angle, arrow.tail, arrow.head, -1)

    def _size(self, body: str) -> float:
        """How far the points of a body lie apart at most [m]."""
        if body not in self.sizes:
            places = [*self.structure.shapes[body].values()]
            self.sizes[body] = max((abs(p - q) for p in places for q in places), default=0.0)
        return self.sizes[body]

    def _arm(self, body: str, start: str, end: str) -> LinkVector:
        """Along the link's own direction where it lies on it; else as nearly so as can be."""
        shape = self.structure.shapes[body]
        arm = shape[end] - shape[start]
        count = quarters(cmath.phase(arm))
        backward = count in (2, 3) if count is not None else arm.real < 0
        if backward:
            start, end, arm = end, start, -arm
            count = None if count is None else (count + 2) % 4
        called = self.bodies.called(body)
        ends = self.bodies.spot(start) + self.bodies.spot(end)
        what = meaning("equations.length", ends=ends, link=called)
        length = self.ledger.constant("l", called, what, "mm", abs(arm))
        angle = AngleSum((), count) if count is not None else self._offset(body, called, length, arm)
        return LinkVector(length, self.bodies.angles[body] + angle, (start, body), (end, body))

    def _offset(self, body: str, called: str, length: Symbol, arm: complex) -> AngleSum:
        low = called + "'" * length.primes
        if body == FRAME:
            what = meaning("equations.frame direction", vector=_written(length))
            return AngleSum.of(self.ledger.constant("θ", low, what, "deg", cmath.phase(arm)))
        what = meaning("equations.offset", link=called, vector=_written(length))
        return AngleSum.of(self.ledger.constant("β", low, what, "deg", cmath.phase(arm)))

    def sliding(self, name: str) -> LinkVector:
        """The displacement along a slide's line, from its origin on the guide to the point."""
        slide = self.structure.slides[name]
        angle = self.bodies.angles[slide.guide] + self.bodies.line(slide)
        tail, head = (slide.line.origin, slide.guide), (slide.point, self.structure.block(slide))
        return LinkVector(self.displacement(name), angle, tail, head)

    def displacement(self, name: str) -> Symbol:
        if name not in self.slides:
            slide = self.structure.slides[name]
            driver = self.structure.slides_driven.get(name)
            steady = driver is not None and self.structure.mechanism.drivers[driver].acceleration == 0
            symbol = self.ledger.fresh("s", self._low(slide), "displacement", steady)
            guide, point = self.bodies.called(slide.guide), slide.point
            words = {"point": point, "guide": guide, "start": self.bodies.spot(slide.line.origin)}
            texts = tuple(meaning(f"equations.sliding {rate}", **words) for rate in _SLIDING)
            self.ledger.variable(symbol, texts, ("mm", "m/s", "m/s^2"), slide_readers(self.structure, slide))
            self.slides[name] = symbol
        return self.slides[name]

    def _low(self, slide: Slide) -> str:
        """s_E on the frame; s3 along link 3's own direction; s2 where the block's direction is the line's."""
        if slide.guide == FRAME:
            return slide.point
        own = quarters(cmath.phase(slide.line.direction)) in (0, 2)
        if own or slide.block is None or slide.tilt != 0:
            return self.bodies.called(slide.guide)
        return self.bodies.called(slide.block)


_SLIDING = ("displacement", "velocity", "acceleration")


def _written(symbol: Symbol) -> str:
    return symbol.letter + ("" if symbol.low.isdigit() else "_") + symbol.low + "'" * symbol.primes


def way(
    structure: Topology, known: Collection[str], starts: Sequence[str], ends: Collection[str]
) -> tuple[list[str], list[Joint]]:
    """The bodies, and the joints between them, of the shortest way over known bodies; the frame goes first."""
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
    raise ValueError(f"no way from {starts} to {ends}")


def closed(
    arrows: LinkVectorMaker, known: Collection[str], bodies: Sequence[str], joints: Sequence[Joint]
) -> ClosedPolygon:
    """The polygon through `bodies`, entered by the first of `joints` and left by the last, closed over known bodies.

    Where the last joint is the first, the bodies are a ring by themselves, whether or not any of them is known.
    """
    structure = arrows.structure
    if joints[0] == joints[-1]:
        return ClosedPolygon(tuple(_round(arrows, bodies, joints[:-1])))
    near = _known_side(structure, known, joints[0], bodies[0])
    far = _known_side(structure, known, joints[-1], bodies[-1])
    back, between = way(structure, known, far, near)
    ring, links = [*bodies, *back], [*joints, *between]
    return ClosedPolygon(tuple(_round(arrows, ring, links)))


def _known_side(structure: Topology, known: Collection[str], joint: Joint, body: str) -> list[str]:
    if isinstance(joint, Hinge):
        found = [other for other in structure.owners[joint.point] if other != body and other in known]
        return sorted(found, key=lambda other: other != FRAME)
    slide = structure.slides[joint.slide]
    return [slide.guide if body != slide.guide else structure.block(slide)]


def _round(arrows: LinkVectorMaker, ring: Sequence[str], joints: Sequence[Joint]) -> Iterator[LinkVector]:
    """All arrows of a ring of bodies: joint k leads into body k, the first one out of the last."""
    for k, body in enumerate(ring):
        into, out = joints[k], joints[(k + 1) % len(joints)]
        if isinstance(into, Sliding):
            arrow = arrows.sliding(into.slide)
            backward = arrows.structure.slides[into.slide].guide == body
            yield LinkVector(arrow.length, arrow.angle, arrow.tail, arrow.head, -1 if backward else 1)
        yield from arrows.along(body, _place(arrows.structure, into, body), _place(arrows.structure, out, body))


def _place(structure: Topology, joint: Joint, body: str) -> str:
    return joint.point if isinstance(joint, Hinge) else structure.slide_point(joint.slide, body)


