"""`plan`: the three constructions of a mechanism, made once."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

from graphkin.base.cache import kept
from graphkin.construction import Construction, Meet, Plot, Swing, replay
from graphkin.errors import HigherClass
from graphkin.model.mechanism import Mechanism
from graphkin.planning.assembly import assemble
from graphkin.planning.equivalent import contacts, lower_pairs
from graphkin.planning.guided_rolling import with_ways
from graphkin.planning.labels import Labels, coincident_points
from graphkin.planning.method import Method
from graphkin.planning.motion import motion
from graphkin.planning.position import position
from graphkin.planning.repeated import as_aside, repeated
from graphkin.planning.special import Ternary, special_points, with_special_points
from graphkin.planning.stages import Group, Loop, Mesh, Stage, stages
from graphkin.planning.starting_facts import facts_of, refuse_contacts_apart, with_sides
from graphkin.planning.structure import Topology

if TYPE_CHECKING:
    from graphkin.planning.redundancy import SetAside


@kept(8)
def plan(mechanism: Mechanism, coincident: str = "", centres: bool = False) -> Method:
    """Plan the constructions of a mechanism, and pick its assembly by the sketch.

    coincident  the point at which sliding pairs are looked at, instead of the one the planner takes
    centres     in Class III groups with two legs on the frame, velocities by the instant centre (综合法)

    Raises a `GraphkinError` where the mechanism holds groups or pairs that are not solved, cannot be
    assembled, or has a sketch that does not tell its assemblies apart.
    """
    lower = lower_pairs(mechanism)
    ties = tuple(contacts(mechanism, lower))
    structure = Topology(lower, ties, coincident, centres)
    aside = repeated(mechanism, structure)
    drawn: dict[str, float] = {}
    if ties or mechanism.poses:
        from graphkin.planning.drawn_position import as_drawn

        drawn, lower = as_drawn(mechanism, lower, aside)
    if aside or ties or mechanism.poses:
        structure = replace(structure, mechanism=lower, aside=as_aside(aside))
    if aside and ties:
        structure = replace(structure, contacts=with_ways(structure))
    order = _order(structure)
    construction, choices = position(structure, order)
    facts = facts_of(structure, None, drawn)
    found = assemble(structure, construction, choices, facts, drawn)
    construction = with_sides(construction, found.sides)
    ternaries: Mapping[Group, Ternary] = {}
    if ties or any(isinstance(stage, Group) for stage in order):  # nothing else hangs on places
        plot = replay(construction, Plot(facts, found.near))
        refuse_contacts_apart(mechanism, ties, plot)
        ternaries = special_points(structure, order, plot)
    return _method(mechanism, structure, order, construction, ternaries, found.near, drawn, aside)


def with_other_points(method: Method, plot: Plot) -> Method:
    """The same mechanism with the special points of its groups chosen anew, for the position of a plot."""
    construction, _ = position(method.structure, method.stages)
    sides = {step.choice: step.side for step in method.position.steps if isinstance(step, Meet | Swing)}
    construction = with_sides(construction, tuple(sides[k] for k in sorted(k for k in sides if k is not None)))
    ternaries = special_points(method.structure, method.stages, plot)
    return _method(
        method.mechanism, method.structure, method.stages, construction, ternaries, method.near, method.drawn,
        method.aside,
    )  # fmt: skip


def _method(
    mechanism: Mechanism,
    structure: Topology,
    order: tuple[Stage, ...],
    construction: Construction,
    ternaries: Mapping[Group, Ternary],
    near: Mapping[str, float],
    drawn: Mapping[str, float],
    aside: tuple[SetAside, ...],
) -> Method:
    """The polygons to a position's construction, by way of these special points."""
    meeting = coincident_points(structure, order)
    labels, pole = Labels(structure, meeting), _pole(mechanism)
    velocity, at = motion(structure, order, labels, "velocity", pole, lambda site: "", ternaries)
    acceleration, _ = motion(structure, order, labels, "acceleration", pole, at, ternaries)
    construction = with_special_points(construction, ternaries)
    return Method(
        mechanism, structure, order, construction, velocity, acceleration, meeting, near, drawn, ternaries, aside
    )


def _order(structure: Topology) -> tuple[Stage, ...]:
    """The order of solution; refuses a mechanism some of whose links it does not reach."""
    order, left = stages(structure)
    if left:
        homes = dict.fromkeys(structure.home(body) for body in left)
        names = [name for name in homes if structure.is_link(name)]
        raise HigherClass(structure.mechanism.where("links", names[0]), tuple(names))
    _refuse_held_twice(structure, order)
    return order


def _refuse_held_twice(structure: Topology, order: tuple[Stage, ...]) -> None:
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


def _pole(mechanism: Mechanism) -> str:
    """p, or the next letter that no point of the mechanism takes."""
    return next(letter for letter in ("p", "o", "q", "z", "pole") if letter.upper() not in mechanism.owners)
