"""The planner: which equation next. Everything here reads topology; numbers enter only to pick the assembly.

`plan` makes the three constructions of a mechanism once; `replay_all` carries them out, for the drawn
position or for any driver values, scalars or arrays.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING

from graphkin.errors import HigherClass
from graphkin.geometry import Value
from graphkin.mechanism import Driver, Mechanism
from graphkin.methods.assembly import assemble, refuse_bad_positions
from graphkin.methods.bypass import with_ways
from graphkin.methods.drawn import facts_of, refuse_contacts_apart, with_sides
from graphkin.methods.equivalent import contacts, lower_pairs
from graphkin.methods.labels import Labels, coincident_points
from graphkin.methods.motion import motion
from graphkin.methods.position import position
from graphkin.methods.repeated import SetAside, as_aside, repeated
from graphkin.methods.special import Ternary, special_points, with_special_points
from graphkin.methods.stages import Bridge, Group, Loop, Mesh, Stage, stages
from graphkin.methods.standing import as_drawn
from graphkin.methods.structure import Structure
from graphkin.steps import Construction, Facts, Fit, Meet, Plot, Roll, Site, Swing, replay
from graphkin.value import frozen

if TYPE_CHECKING:
    from graphkin.methods.swift import Shelf

__all__ = ["Method", "plan", "replay_all", "with_other_points"]


@frozen
class Method:
    """How a mechanism is solved on paper: three constructions, planned once from its topology.

    stages  the order of solution: bodies carried along, and loops with two unknown scalars
    coincident  points at which links move past each other, with the link whose point the hinge there is
    near, drawn angles by link and displacements by `slide_key` at the drawn position: where fitting starts,
                and from where rolling counts
    ternaries   the special point of each Class III group
    aside       the constraints that repeat others (虚约束)
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
    aside: tuple[SetAside, ...] = ()

    @property
    def drivers(self) -> tuple[Driver, ...]:
        """The drivers, each with its value at the drawn position."""
        return self.structure.mechanism.drivers

    @property
    def moves_on(self) -> bool:
        """Whether positions hang on how they are reached from the drawn one: where links are fitted, or wheels roll."""
        return any(isinstance(step, Fit | Roll) for step in self.position.steps)

    @property
    def fits(self) -> bool:
        """Whether links are fitted: each such position is found from one close by."""
        return any(isinstance(step, Fit) for step in self.position.steps)

    @cached_property
    def size(self) -> float:
        """The longest reach of a link [m]: what small parts are measured by."""
        return max(abs(z) for shape in self.structure.shapes.values() for z in shape.values()) or 1.0

    @cached_property
    def shelf(self) -> Shelf:
        """Where the program for many positions is kept."""
        from graphkin.methods.swift import Shelf

        return Shelf()

    @property
    def doubtful(self) -> bool:
        """Whether constraints and drivers, counted by the formula, do not add up: some repeat others, or clash."""
        bridged = any(isinstance(stage, Bridge) for stage in self.stages)
        return bridged or bool(self.aside) or self.structure.surplus != 0

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
        return facts_of(self.structure, values, self.drawn)


def plan(mechanism: Mechanism, coincident: str = "", centres: bool = False) -> Method:
    """Plan the constructions of a mechanism, and pick its assembly by the sketch.

    coincident  the point at which sliding pairs are looked at, instead of the one the planner takes
    centres     in Class III groups with two legs on the frame, velocities by the instant centre (综合法)

    Raises a `GraphkinError` where the mechanism holds groups or pairs that are not solved, cannot be
    assembled, or has a sketch that does not tell its assemblies apart.
    """
    lower = lower_pairs(mechanism)
    ties = tuple(contacts(mechanism, lower))
    aside = repeated(mechanism, Structure(lower, ties))
    drawn: dict[str, float] = {}
    if ties or mechanism.poses:
        drawn, lower = as_drawn(mechanism, lower, aside)
    structure = Structure(lower, ties, coincident, centres, as_aside(aside))
    structure = replace(structure, contacts=with_ways(structure))
    order = _order(structure)
    construction, choices = position(structure, order)
    facts = facts_of(structure, None, drawn)
    found = assemble(structure, construction, choices, facts, drawn)
    construction = with_sides(construction, found.sides)
    plot = replay(construction, Plot(facts, found.near))
    refuse_contacts_apart(mechanism, ties, plot)
    return _method(mechanism, structure, order, construction, plot, found.near, drawn, aside)


def with_other_points(method: Method, plot: Plot) -> Method:
    """The same mechanism with the special points of its groups chosen anew, for the position of a plot."""
    construction, _ = position(method.structure, method.stages)
    sides = {step.choice: step.side for step in method.position.steps if isinstance(step, Meet | Swing)}
    construction = with_sides(construction, tuple(sides[k] for k in sorted(k for k in sides if k is not None)))
    return _method(
        method.mechanism, method.structure, method.stages, construction, plot, method.near, method.drawn, method.aside
    )


def _method(
    mechanism: Mechanism,
    structure: Structure,
    order: tuple[Stage, ...],
    construction: Construction,
    plot: Plot,
    near: Mapping[str, float],
    drawn: Mapping[str, float],
    aside: tuple[SetAside, ...],
) -> Method:
    """The polygons to a position's construction, with special points that lie well at the position of a plot."""
    ternaries = special_points(structure, order, plot)
    meeting = coincident_points(structure, order)
    labels, pole = Labels(structure, meeting), _pole(mechanism)
    velocity, at = motion(structure, order, labels, "velocity", pole, lambda site: "", ternaries)
    acceleration, _ = motion(structure, order, labels, "acceleration", pole, at, ternaries)
    construction = with_special_points(construction, ternaries)
    return Method(
        mechanism, structure, order, construction, velocity, acceleration, meeting, near, drawn, ternaries, aside
    )


def _order(structure: Structure) -> tuple[Stage, ...]:
    """The order of solution; refuses a mechanism some of whose links it does not reach."""
    order, left = stages(structure)
    if left:
        homes = dict.fromkeys(structure.home(body) for body in left)
        names = [name for name in homes if name in structure.mechanism.links and " " not in name]
        raise HigherClass(structure.mechanism.where("links", names[0]), tuple(names))
    _refuse_held_twice(structure, order)
    return order


def _refuse_held_twice(structure: Structure, order: tuple[Stage, ...]) -> None:
    """A wheel whose centre other pairs keep on its path leaves no equation that gives how far it is."""
    given = set(structure.slides_driven) | structure.aside.slides
    for stage in order:
        given |= {stage.slide} if isinstance(stage, Mesh) else set()
        given |= set(stage.slides) if isinstance(stage, Loop | Group) else set()
        meeting = stage.contacts if isinstance(stage, Group) else (stage.contact,) if isinstance(stage, Mesh) else ()
        for contact in meeting:
            if contact.slide and contact.slide not in given:
                links = tuple(structure.mechanism.called(wheel) for wheel in contact.wheels)
                raise HigherClass(structure.mechanism.where("links", contact.wheels[1]), links)


def replay_all(method: Method, values: Sequence[Value] | None = None) -> Plot:
    """All three constructions at the drawn position, or at `values`: one entry a driver, scalar or (n,) [rad, m].

    A single position that is a dead point, or that is not reached from the drawn one without passing a dead
    point, raises; in arrays such positions are what the crossings give, or NaN, and `Plot.sines` tells how near
    each position is to a dead point.
    """
    if values is None:
        plot = replay(method.position, Plot(method.facts(), method.near))
    else:
        from graphkin.methods.swift import swiftly

        if (found := swiftly(method, values)) is not None:
            return found
        from graphkin.methods.moving import moved_to

        plot = moved_to(method, values)
    refuse_bad_positions(method.structure, method.position, plot)
    refuse_contacts_apart(method.mechanism, method.structure.contacts, plot)
    replay(method.velocity, plot)
    return replay(method.acceleration, plot)


def _pole(mechanism: Mechanism) -> str:
    """p, or the next letter that no point of the mechanism takes."""
    return next(letter for letter in ("p", "o", "q", "z", "pole") if letter.upper() not in mechanism.owners)
