"""The drawn position by what the file gives of it: poses and driver values, while nothing rolls.

From there rolling counts. What repeats what is known already is no error, as long as it says the same.

What a pose gives instead of a driver's value is laid off; the driver's value is measured in the end. So arcs may do
what a template would have to: of a cylinder whose stroke is open, or a wheel that rolls on a moving rack.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations, islice

import numpy as np

from graphkin.base.cache import kept
from graphkin.base.geometry import Real, number, phase, place, wrapped
from graphkin.base.tolerances import ROUNDED
from graphkin.base.value import frozen
from graphkin.construction import Construction, Meet, Plot, Ray, Touch, replay, slide_key
from graphkin.errors import CannotAssemble, DeadPoint, NotPlaced, PosesDiffer, Where
from graphkin.model.mechanism import FRAME, Driver, Mechanism, Pose
from graphkin.model.quantities import EDGE, driven
from graphkin.planning.assembly import assemble, with_sides
from graphkin.planning.equivalent import lower_pairs
from graphkin.planning.method import Method, facts_of
from graphkin.planning.needed import without_aids
from graphkin.planning.position import position
from graphkin.planning.refusals import extent, refuse_open
from graphkin.planning.stages import stages
from graphkin.planning.structure import Aside, SetAside, Topology

TRIES = 64  # so many choices of poses to leave out are tried


@frozen
class PlacingValue:
    """A driver's value or a pose: what it fixes, as a driver, and which of its table it is."""

    fixes: Driver
    posed: bool
    number: int

    def off(self, plot: Plot) -> float:
        """The difference by which a plot is beyond it [rad or m]."""
        value = self.fixes.value
        assert value is not None
        off = number(value_of(plot, self.fixes)) - value
        return off if self.fixes.kind == "slide" else number(wrapped(off))

    def holds(self, plot: Plot) -> bool:
        return abs(self.off(plot)) < (ROUNDED * extent(plot) if self.fixes.kind == "slide" else ROUNDED)

    def where(self, mechanism: Mechanism) -> Where:
        """The place where the file says so."""
        return mechanism.where("pose" if self.posed else "driver", self.number)


@frozen
class DrawnPlacement:
    """The drawn position: the mechanism held there by poses and values alone, how it is drawn by these, and drawn."""

    structure: Topology
    construction: Construction
    plot: Plot


def as_drawn(
    mechanism: Mechanism, lower: Mechanism, repeats: Sequence[SetAside] = ()
) -> tuple[dict[str, float], Mechanism]:
    """Angles and displacements at the drawn position, from which rolling counts, and the drivers with all their values;
    `repeats`: what repeats other constraints when all moves, here only where it does so though nothing rolls. Raises
    NotPlaced where values and poses leave something open, PosesDiffer where they do not fit together."""
    placed = placement(mechanism, lower, repeats)
    structure, plot = placed.structure, placed.plot
    drawn = {link: number(plot.theta[link]) if link in plot.theta else 0.0 for link in structure.bodies}
    drawn |= {slide_key(slide): number(value) for slide, value in plot.s.items()}
    sketch = {**lower.sketch, **{p: place(z) for p, z in plot.position.items() if p in mechanism.points}}
    drivers = []
    for driver in mechanism.drivers:  # one whose value a pose has fixed gets that value
        if driver.kind == "spin":
            driver = replace(driver, value=drawn[driver.link])
        elif driver.value is None:
            slides = driver.kind == "slide"
            driver = replace(driver, value=drawn[slide_key(driver.link)] if slides else number(value_of(plot, driver)))
        drivers.append(driver)
    valued, counted = replace(lower, drivers=tuple(drivers), sketch=sketch), dict(drawn)
    for body, turn in replace(structure, mechanism=valued).turns.items():  # count whole turns as the drivers' values do
        values = sum(sign * (drivers[k].value or 0.0) for k, sign in turn.drivers)
        turns = round((drawn[turn.base] + turn.constant + values - drawn[body]) / (2 * np.pi))
        counted[body] = drawn[body] + 2 * np.pi * turns
    return counted, valued


def value_of(plot: Plot, fixes: Driver | Pose) -> Real:
    """The value of a driver, or of a pose, in a plot [rad or m]; of many mechanisms side by side (n,)."""
    if fixes.kind == "slide":
        return plot.s[fixes.link]
    assert fixes.vector is not None
    value = phase(plot.arm(*fixes.vector))
    return wrapped(value - (phase(plot.arm(*fixes.from_vector)) if fixes.from_vector is not None else 0.0))


def placement(mechanism: Mechanism, lower: Mechanism, repeats: Sequence[SetAside]) -> DrawnPlacement:
    """All that is given taken together; where that does not do, without poses that the rest gives as well. Those must
    say the same as the position that comes out."""
    # the drivers' values and the poses as what they fix
    fixed = ((k, driver) for k, driver in enumerate(mechanism.drivers)
             if driver.value is not None and driver.kind != "spin")  # fmt: skip
    posed = (Driver(p.kind, p.link, p.vector, p.from_link, p.from_vector, p.value) for p in mechanism.poses)
    given = (*(PlacingValue(driver, False, k) for k, driver in fixed),
             *(PlacingValue(driver, True, k) for k, driver in enumerate(posed)))  # fmt: skip
    refusal, first = None, None
    poses = [each for each in reversed(given) if each.posed]  # left out the last first, then two of them, ..
    leaving = (left for count in range(len(poses) + 1) for left in combinations(poses, count))
    for needed in (tuple(each for each in given if each not in left) for left in islice(leaving, TRIES)):
        try:
            placed = _placed(mechanism, lower, needed, repeats)
        except (CannotAssemble, DeadPoint, NotPlaced) as error:
            if refusal is None or (isinstance(refusal, NotPlaced) and not isinstance(error, NotPlaced)):
                refusal = error
            continue
        if all(each.holds(placed.plot) for each in needed):
            for each in given:  # a pose that was not needed must hold all the same
                if each not in needed and not each.holds(placed.plot):
                    others = tuple(other.where(mechanism) for other in _fixing_same(placed.structure, each, needed))
                    unit = EDGE[driven(each.fixes.kind == "slide")]
                    value, off = each.fixes.value or 0.0, each.off(placed.plot)
                    values = unit.shown(value), unit.shown(value + off), unit.shown(abs(off))
                    raise PosesDiffer(each.where(mechanism), each.fixes.name, *values, others)
            return placed
        first = first or placed
    if first is None:
        assert refusal is not None
        raise refusal
    return first  # by drivers that contradict each other: there are too many of them


def _fixing_same(structure: Topology, given: PlacingValue, needed: Sequence[PlacingValue]) -> list[PlacingValue]:
    """Entries that fix the same: those that turn one of the two links against the other, else all that is needed."""
    fixes, turns = given.fixes, structure.turns
    if fixes.kind == "slide":
        return [other for other in needed if other.fixes.link == fixes.link] or list(needed)
    one, other = turns[fixes.link], turns[fixes.from_link]
    if one.base != other.base:
        return list(needed)
    path = {k for k, _ in one.drivers} ^ {k for k, _ in other.drivers}
    return [each for k, each in enumerate(needed) if k in path]


def _placed(
    mechanism: Mechanism, lower: Mechanism, given: tuple[PlacingValue, ...], repeats: Sequence[SetAside]
) -> DrawnPlacement:
    """The mechanism put together by these values."""
    structure = _placed_by(mechanism, lower, given, repeats)
    order, bodies = stages(structure)
    left = [body for body in bodies if not structure.is_pin(body)]
    turning = [body for body in left if structure.base(body) != FRAME]  # those first whose direction is open
    if names := [name for name in turning or left if structure.is_link(name)]:
        raise NotPlaced(mechanism.where("links", names[0]), tuple(mechanism.called(name) for name in names))
    construction, choices = position(structure, order)
    facts = facts_of(structure, None, {})
    sides, near = assemble(structure, construction, choices, facts, {})
    construction = with_sides(construction, sides)
    plot = replay(construction, Plot(facts, near))
    refuse_open(structure, plot, ROUNDED)
    return DrawnPlacement(structure, construction, plot)


def _placed_by(
    mechanism: Mechanism, lower: Mechanism, given: tuple[PlacingValue, ...], repeats: Sequence[SetAside]
) -> Topology:
    """The mechanism with these values; wheels that nothing turns and that show no direction stand at 0."""
    drivers = tuple(each.fixes for each in given)
    structure = Topology(replace(lower, drivers=drivers))
    if repeats:
        from graphkin.planning.redundancy import still_redundant  # loaded for the few mechanisms that have any

        structure = replace(structure, aside=Aside.of(still_redundant(structure, repeats)))
    wheels = {wheel for pair in mechanism.pairs if pair.rolling is not None for wheel in pair.joins}
    wheels |= {driver.link for driver in mechanism.drivers if driver.kind == "spin"}
    plain: dict[str, str] = {}
    for body in (body for body in structure.bodies if body in wheels and structure.base(body) != FRAME):
        # one cannot see how it stands: it hangs on its centre alone, and has no other point
        if len(structure.joints(body)) < 2 and len(set(structure.shapes[body].values())) == 1:
            plain.setdefault(structure.base(body), body)
    marked = tuple(Driver("spin", body, value=0.0) for body in plain.values())
    return replace(structure, mechanism=replace(lower, drivers=(*drivers, *marked)))


def by_pose(method: Method, plot: Plot) -> tuple[Method, Plot] | None:
    """A method whose position is drawn from what is given of it, with its plot; None where that is the method's own,
    or for another position."""
    values = zip(plot.facts.values, method.facts().values, strict=True)
    given = method.mechanism.poses or method.structure.contacts
    if not given or not all(abs(number(value) - number(drawn)) < 1e-12 for value, drawn in values):
        return None
    placed, own = _placement(method), method.position
    apart = (abs(place(placed.plot.position[p] - plot.position[p])) for p in method.mechanism.points)
    if not all(gap < 1e-9 * method.size for gap in apart):
        return None
    structure = replace(placed.structure, contacts=method.structure.contacts)
    more = tuple(part for part in own.parts if isinstance(part, Touch | Ray)
                 or (isinstance(part, Meet) and part.point in method.special))  # fmt: skip
    parts, nodes = (*placed.construction.parts, *more), {**own.nodes, **placed.construction.nodes}
    construction = replace(placed.construction, parts=parts, nodes=nodes)
    posed = replace(placed.plot, position={**plot.position, **placed.plot.position})
    return replace(method, structure=structure, position=construction), posed


@kept(4, objects=2)  # a sheet, its words and its proof ask for the same
def shown(method: Method, plot: Plot) -> tuple[Method, Plot]:
    """The same method and plot, with the position as `by_pose` draws it."""
    polygons = without_aids(method)
    if (posed := by_pose(method, plot)) is None:
        return polygons, plot
    return replace(polygons, position=posed[0].position), replace(plot, position=posed[1].position)


@kept(4)
def _placement(method: Method) -> DrawnPlacement:
    return placement(method.mechanism, lower_pairs(method.mechanism), method.aside)
