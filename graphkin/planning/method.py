"""`Method`, what planning gives, and its acts of the pencil.

An arrow is laid off, two lines are drawn to where they meet, a figure similar to a link gives a point: each is one
act, which one sentence of a solution tells, with the number that drawing and words give it. What leads to it (the
pole, the two lines) and what is then measured belong to it.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from functools import cached_property
from typing import assert_never

from graphkin.base.cache import kept
from graphkin.base.geometry import Real
from graphkin.base.value import bulky, frozen
from graphkin.construction import Construction, Facts, Plane, Site, Step, kinds
from graphkin.model.mechanism import FRAME, Driver, Mechanism
from graphkin.planning.special_points import Ternary
from graphkin.planning.stages import Bridge, Group, Stage
from graphkin.planning.structure import SetAside, Topology


def facts_of(structure: Topology, values: Sequence[Real] | None, drawn: Mapping[str, float]) -> Facts:
    """The facts that are known before the pencil moves; drivers at the drawn position, or at other values [rad, m]."""
    drivers = structure.mechanism.drivers
    drawn_values = (0.0 if driver.value is None else driver.value for driver in drivers)
    return Facts(frame=FRAME, shapes=structure.shapes,
                 lines={s.name: (s.guide, s.line.origin, s.line.direction) for s in structure.mechanism.slides},
                 turns=structure.turns, slides_driven=structure.slides_driven,
                 values=tuple(drawn_values if values is None else values),
                 rates=tuple(driver.rate for driver in drivers),
                 accelerations=tuple(driver.acceleration for driver in drivers), drawn=drawn)  # fmt: skip


@bulky
class Method:
    """The solution of a mechanism on paper: three constructions, planned once from its topology.

    stages  the order of solution: bodies carried along, and loops with two unknown scalars
    coincident  points at which links move past each other, with the link whose point the hinge there is
    near, drawn angles by link and displacements by `slide_key` at the drawn position: where fitting starts,
                and from where rolling counts
    ternaries   the special point of each Class III group
    aside       the constraints that repeat others (虚约束)
    """

    mechanism: Mechanism
    structure: Topology
    stages: tuple[Stage, ...]
    position: Construction
    velocity: Construction
    acceleration: Construction
    coincident: Mapping[str, str]
    near: Mapping[str, float]
    drawn: Mapping[str, float]
    ternaries: Mapping[Group, Ternary]
    aside: tuple[SetAside, ...] = ()

    @property
    def drivers(self) -> tuple[Driver, ...]:
        """The drivers, each with its value at the drawn position."""
        return self.structure.mechanism.drivers

    @cached_property
    def moves_on(self) -> bool:
        """True where links are fitted, or wheels roll: positions hang on how they are reached from the drawn one."""
        return any(isinstance(step, kinds.Fit | kinds.Roll) for step in self.position.steps)

    @cached_property
    def fits(self) -> bool:
        """True if links are fitted: each such position is found from one close by."""
        return any(isinstance(step, kinds.Fit) for step in self.position.steps)

    @cached_property
    def size(self) -> float:
        """The longest reach of a link from its first point [m]: what small parts are measured by."""
        shapes = (tuple(shape.values()) for shape in self.structure.shapes.values())
        return max(abs(z - shape[0]) for shape in shapes for z in shape) or 1.0

    @property
    def doubtful(self) -> bool:
        """True if constraints and drivers, counted by the formula, do not add up: some repeat others, or clash."""
        bridged = any(isinstance(stage, Bridge) for stage in self.stages)
        return bridged or bool(self.aside) or self.structure.surplus != 0

    @property
    def special(self) -> frozenset[str]:
        """The special points, which no link of the file has."""
        return frozenset(ternary.name for ternary in self.ternaries.values())

    @cached_property
    def nodes_of_links(self) -> Mapping[str, Mapping[str, str]]:
        """By moving link: its points that the polygons show, with the velocity polygon's point."""
        nodes: dict[str, dict[str, str]] = {}
        owners = self.mechanism.owners
        for node in self.velocity.nodes.values():
            if node.site is not None and node.site.point in owners:
                links = owners[node.site.point] if node.site.link in owners[node.site.point] else (node.site.link,)
                for link in links:
                    nodes.setdefault(link, {}).setdefault(node.site.point, node.name)
        return nodes

    @property
    def constructions(self) -> tuple[Construction, Construction, Construction]:
        return self.position, self.velocity, self.acceleration

    def construction(self, plane: Plane) -> Construction:
        return {each.plane: each for each in self.constructions}[plane]

    @cached_property
    def acts(self) -> tuple[Act, ...]:
        """The acts of the pencil, each told by one sentence of the solution."""
        return acts(self.constructions, self.mechanism.unnamed)

    @property
    def sites(self) -> Mapping[str, Site]:
        """Every point written in the polygons (`C`, `B3`) as a point of the mechanism on a link."""
        nodes = self.velocity.nodes.values()
        return {node.of: node.site for node in nodes if node.site is not None}

    def facts(self, values: Sequence[Real] | None = None) -> Facts:
        """Dimensions, and drivers at the drawn position or at other values [rad, m]."""
        return facts_of(self.structure, values, self.drawn)


@frozen
class Act:
    """Steps that the pencil does in one go, of which `done` finishes it. Its `number` counts from 1 through both
    polygons, in the mechanism's own plane apart; its `page` through all three planes, one drawing for each act."""

    plane: Plane
    number: int
    page: int
    steps: tuple[Step, ...]
    done: Step

    @property
    def numbered(self) -> bool:
        """True if its number is written: the drawing of the mechanism itself needs none."""
        return self.plane != "position"


def acts(constructions: Iterable[Construction], unnamed: Collection[str]) -> tuple[Act, ...]:
    """All acts in the order in which they are drawn; `unnamed`: points that nobody named."""
    in_order: list[Act] = []
    for construction in constructions:
        before = 0 if construction.plane in ("position", "velocity") else sum(act.numbered for act in in_order)
        # steps that go together, each group with the one that finishes it. A point that nobody named, as where a
        # guide's line begins, is there with what it belongs to
        groups: list[tuple[list[Step], Step]] = []
        begun: list[Step] = []
        for step in construction.steps:
            match step:
                case kinds.Image(point=point):
                    finishes = point not in unnamed
                case kinds.LayOff() | kinds.Meet() | kinds.Swing() | kinds.Touch() | kinds.Fit():
                    finishes = True
                case kinds.Given() | kinds.Ray() | kinds.Arc() | kinds.Measure() | kinds.Roll() | kinds.Simultaneous():
                    finishes = False
                case _:
                    assert_never(step)
            if groups and not begun and (isinstance(step, kinds.Measure | kinds.Roll | kinds.Image) and not finishes):
                groups[-1][0].append(step)
                continue
            begun.append(step)
            if finishes:
                groups.append((begun, step))
                begun = []
        if groups:
            groups[-1][0].extend(begun)
        for number, (steps, done) in enumerate((((tuple(steps), done) for steps, done in groups)), start=before + 1):
            in_order.append(Act(construction.plane, number, len(in_order) + 1, steps, done))
    return tuple(in_order)


def made(step: Step) -> tuple[str, ...]:
    """The points that a step finds."""
    match step:
        case kinds.Given(point, also):
            return (point, *also)
        case kinds.LayOff(tip=tip):
            return (tip,)
        case kinds.Meet(point=point) | kinds.Image(point=point) | kinds.Touch(point=point):
            return (point,)
        case kinds.Ray() | kinds.Arc() | kinds.Swing() | kinds.Measure():
            return ()
        case kinds.Roll() | kinds.Fit() | kinds.Simultaneous():
            return ()
        case _:
            assert_never(step)


@kept(8)
def pages(method: Method) -> Mapping[tuple[Plane, Step], int]:
    """The act in which each step is done, by its page."""
    return {(act.plane, step): act.page for act in method.acts for step in act.steps}


@kept(8)
def births(method: Method, plane: Plane) -> Mapping[str, int]:
    """The act in which each point of a plane is found, by its page."""
    numbers: dict[str, int] = {}
    for act in method.acts:
        for step in act.steps if act.plane == plane else ():
            for name in made(step):
                numbers.setdefault(name, act.page)
    return numbers


def rate_found(method: Method, plane: Plane, link: str) -> int | None:
    """The act in which a link's rotation is found in a polygon's plane; None for one that is driven."""
    base = method.structure.base(link)
    for act in method.acts:
        for step in act.steps if act.plane == plane else ():
            match step:
                case kinds.Measure(quantity="omega" | "alpha", of=of) if method.structure.base(of) == base:
                    return act.page
                case kinds.Roll(angle=angle) if angle == base:
                    return act.page
                case kinds.Simultaneous(angles=angles) if base in angles:
                    return act.page
                case _:
                    pass
    return None
