"""Bodies, joints, and which links hold their angles to one another.

A pin in a slot counts as a block without mass of its own: a body that carries the pin's point and turns
with the slot. So every sliding pair joins two bodies, and every group of the method is made of hinges and
slides alone (the lower-pair form a textbook gives the half joint).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cached_property

from graphkin.base.geometry import phase
from graphkin.base.value import frozen
from graphkin.construction import Site, TurnOf
from graphkin.model.mechanism import FRAME, Driver, Mechanism
from graphkin.model.naming import PairName
from graphkin.model.pairs import Rod, Slide, pin_name
from graphkin.planning.equivalent import Contact


@frozen
class Hinge:
    """Bodies turn about a common point."""

    point: str


@frozen
class Sliding:
    """Two bodies slide on one another."""

    slide: str


Joint = Hinge | Sliding


# --- redundant constraints --------------------------------------------------------------------


@frozen
class ConstraintRow:
    """Whose equation a row is: of kind "hinge" (of a point and a body), "line" or "angle" (of a slide), "slip" (of a
    contact), "given" (of a driver or pose)."""

    kind: str
    name: str
    body: str = ""


@frozen
class SetAside:
    """One constraint that repeats others.

    pair   as in the file
    part   "whole", or only what keeps a "line", an "angle", or rolling without slip ("slip"); a "link" on hinges
    rows   its equations
    held   the pairs that hold the same already
    body   of a link on hinges, in the planner's structure
    """

    pair: PairName
    part: str
    rows: tuple[ConstraintRow, ...]
    held: tuple[PairName, ...] = ()
    body: str = ""


@frozen
class Aside:
    """Names of what repeats others: slides (those that stand for cams, too); blocks whose angle is held; contacts."""

    slides: frozenset[str] = frozenset()
    angles: frozenset[str] = frozenset()
    contacts: frozenset[str] = frozenset()

    @classmethod
    def of(cls, redundant: Iterable[SetAside]) -> Aside:
        """Constraints that the planner leaves out; links on hinges stay where they are (a `Bridge` is drawn last)."""
        rows = {row for each in redundant if each.part != "link" for row in each.rows}
        lines, angles, slips = ({row.name for row in rows if row.kind == kind} for kind in ("line", "angle", "slip"))
        return cls(frozenset(lines), frozenset(angles - lines), frozenset(slips))


# --- bodies and joints ------------------------------------------------------------------------


@frozen
class Topology:
    """The mechanism as the planner sees it.

    coincident  the point at which sliding pairs are looked at, where the user wants another than the planner's
    centres     whether a special point on two legs of the frame is taken for what it is, the instant centre (综合法)
    aside       what repeats other constraints (虚约束): its slides join nothing, its contacts tie nothing
    """

    mechanism: Mechanism
    contacts: tuple[Contact, ...] = ()
    coincident: str = ""
    centres: bool = False
    aside: Aside = Aside()

    @cached_property
    def joining(self) -> tuple[Slide, ...]:
        """The sliding pairs that join bodies: all but those set aside, blocks whose angle is held already as pins."""
        return tuple(replace(slide, block=None, tilt=0.0) if slide.name in self.aside.angles else slide
                     for slide in self.mechanism.slides if slide.name not in self.aside.slides)  # fmt: skip

    @cached_property
    def pins(self) -> dict[str, Slide]:
        """The slide in whose slot each body moves that stands for a pin."""
        return {self.block(slide): slide for slide in self.slides.values() if slide.block is None}

    @cached_property
    def bodies(self) -> dict[str, tuple[str, ...]]:
        """Points of each body: the links, then the blocks that stand for pins."""
        bodies = {name: tuple(link.points) for name, link in self.mechanism.links.items()}
        bodies |= {self.block(slide): (slide.point,) for slide in self.joining if slide.block is None}
        return bodies

    @cached_property
    def shapes(self) -> dict[str, Mapping[str, complex]]:
        """Points of each body in its axes [m]; the one of a pin's body is its origin."""
        shapes: dict[str, Mapping[str, complex]] = {n: link.points for n, link in self.mechanism.links.items()}
        return shapes | {body: {slide.point: 0j} for body, slide in self.pins.items() if body in self.bodies}

    @cached_property
    def order(self) -> dict[str, int]:
        return {name: k for k, name in enumerate(self.bodies)}

    @staticmethod
    def block(slide: Slide) -> str:
        """The body that slides: the block, or the one that stands for the pin."""
        return slide.block if slide.block is not None else pin_name(slide)

    @cached_property
    def followers(self) -> frozenset[str]:
        """Lines of centres of gears: they go with two points whose distance other links keep, and keep none."""
        rods = {name: link.stands_for.equivalent for name, link in self.mechanism.links.items() if link.stands_for}
        return frozenset(name for name, rod in rods.items() if isinstance(rod, Rod) and rod.follows)

    def is_pin(self, body: str) -> bool:
        return body not in self.mechanism.links

    def is_link(self, body: str) -> bool:
        """True of a body of the file: no pin, and no rod of the equivalent."""
        return not self.is_pin(body) and self.mechanism.links[body].stands_for is None

    def named(self, body: str) -> tuple[str, ...]:
        """The points of a body that people named."""
        return tuple(point for point in self.bodies[body] if point not in self.mechanism.unnamed)

    def home(self, body: str) -> str:
        """The link people name for a body: for a pin, the first link that carries it."""
        if not self.is_pin(body):
            return body
        slide = self.pins[body]
        return next(name for name in self.mechanism.owners[slide.point] if name != slide.guide)

    @cached_property
    def slides(self) -> dict[str, Slide]:
        """All of them by name, those set aside included."""
        return {slide.name: slide for slide in self.mechanism.slides} | {slide.name: slide for slide in self.joining}

    @property
    def tying(self) -> tuple[Contact, ...]:
        """The rolling contacts that are not set aside."""
        return tuple(contact for contact in self.contacts if contact.name not in self.aside.contacts)

    @cached_property
    def slides_driven(self) -> dict[str, int]:
        return {d.link: k for k, d in enumerate(self.mechanism.drivers) if d.kind == "slide"}

    @cached_property
    def owners(self) -> dict[str, tuple[str, ...]]:
        """Bodies of each point."""
        owners: dict[str, tuple[str, ...]] = {}
        for body, points in self.bodies.items():
            for point in points:
                owners[point] = (*owners.get(point, ()), body)
        return owners

    @cached_property
    def seen_as(self) -> dict[Site, Site]:
        """A hinge moves as one point: as that of the first of its bodies, whichever other it is seen as part of."""
        hinges = ((point, bodies) for point, bodies in self.owners.items() if len(bodies) > 1)
        return {Site(point, body): Site(point, first) for point, (first, *others) in hinges for body in others}

    def joints(self, body: str) -> Sequence[tuple[Joint, tuple[str, ...]]]:
        """The joints of a body, each with the other bodies there: hinges first, then slides, as in the file."""
        return self._joints[body]

    @cached_property
    def _joints(self) -> dict[str, list[tuple[Joint, tuple[str, ...]]]]:
        joints: dict[str, list[tuple[Joint, tuple[str, ...]]]] = {}
        for body, points in self.bodies.items():
            others = {point: tuple(other for other in self.owners[point] if other != body) for point in points}
            joints[body] = [(Hinge(point), those) for point, those in others.items() if those]
        for slide in self.joining:
            for one, other in ((slide.guide, self.block(slide)), (self.block(slide), slide.guide)):
                joints[one].append((Sliding(slide.name), (other,)))
        return joints

    def slide_point(self, slide: str, body: str) -> str:
        """The point at which a slide's line holds on to a body: its origin on the guide, its point on the block."""
        pair = self.slides[slide]
        return pair.line.origin if body == pair.guide else pair.point

    @cached_property
    def measured(self) -> tuple[str, ...]:
        """The slides whose displacements are of use: all but those that stand for cams and join nothing."""
        aside = [slide for name, slide in self.slides.items() if name in self.aside.slides]
        useless = {slide.name for slide in aside if slide.stands_for is not None and slide.stands_for.path is None}
        return tuple(name for name in self.slides if name not in useless)

    @property
    def surplus(self) -> int:
        """Drivers beyond the degrees of freedom by the formula F = 3 n - 2 p, idle ones apart."""
        hinges = sum(len(bodies) - 1 for bodies in self.owners.values())
        freedoms = 3 * (len(self.bodies) - 1) - 2 * (hinges + len(self.joining)) - len(self.tying) + len(self.followers)
        return len(self.mechanism.drivers) + len(self.mechanism.idle) - freedoms

    @cached_property
    def turns(self) -> Mapping[str, TurnOf]:
        """Each body's angle by that of the base body of its group; the frame's group is the known one."""
        ties: dict[str, list[tuple[str, TurnOf]]] = {body: [] for body in self.bodies}

        def tie(body: str, other: str, offset: float, drivers: tuple[int, ...] = ()) -> None:
            """The other's angle against the body's, as given by a slide or by a driver."""
            ties[body].append((other, TurnOf(body, offset, tuple((k, 1) for k in drivers))))
            ties[other].append((body, TurnOf(other, -offset, tuple((k, -1) for k in drivers))))

        for slide in self.joining:
            turn = slide.turn if slide.block is not None else phase(slide.line.direction)
            tie(slide.guide, self.block(slide), turn)
        for idle in self.mechanism.idle:
            ties[FRAME].append((idle, TurnOf(FRAME)))
        for k, driver in enumerate(self.mechanism.drivers):
            if driver.kind != "slide":
                tie(driver.from_link, driver.link, self.driver_offset(driver), (k,))
        turns: dict[str, TurnOf] = {}
        for base in self.bodies:
            reached = [] if base in turns else [base]
            turns.setdefault(base, TurnOf(base))
            for body in reached:
                for other, more in ties[body]:
                    if other not in turns:
                        first = turns[body]
                        turns[other] = TurnOf(first.base, first.constant + more.constant, first.drivers + more.drivers)
                        reached.append(other)
        return turns

    def driver_offset(self, driver: Driver) -> float:
        """Angle of the driven link against the other where the driver's own value is 0."""
        links = self.mechanism.links
        if driver.vector is None:
            return 0.0
        offset = -phase(links[driver.link].arm(*driver.vector))
        if driver.from_vector is not None:
            offset += phase(links[driver.from_link].arm(*driver.from_vector))
        return offset

    @property
    def bases(self) -> list[str]:
        return list(dict.fromkeys(turn.base for turn in self.turns.values()))

    def base(self, body: str) -> str:
        return self.turns[body].base

    @cached_property
    def calculated(self) -> frozenset[str]:
        """Bases whose rates the drivers give by ratios of wheels alone, one after another, wherever all is drawn."""
        known, more = frozenset[str](), {FRAME}
        while more:
            known |= more
            rolling = [{self.base(body) for body, _ in contact.angles} - known for contact in self.tying
                       if not contact.slide or contact.slide in self.slides_driven]  # fmt: skip
            more = set().union(*(unknown for unknown in rolling if len(unknown) == 1))
        return known

    def steady(self, body: str) -> bool:
        """True if a body of the frame's group has no angular acceleration, whatever the position."""
        turn, drivers = self.turns[body], self.mechanism.drivers
        return turn.base == FRAME and all(drivers[k].acceleration == 0 for k, _ in turn.drivers)
