"""`plan`: the three constructions of a mechanism, made once.

Polygons by Sun Huan, 机械原理, section 3-2.1: two points of one link, equations (3-1) and (3-2); coincident points of a
sliding pair, (3-3) and (3-4); velocity and acceleration image.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace

from graphkin.base.cache import kept
from graphkin.construction import Construction, Equation, Plane, Plot, Site, kinds, replay
from graphkin.errors import GraphkinError, HigherClass, OtherSide
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.naming import primes
from graphkin.model.pairs import Cam, Pair, RollingContact, Slide
from graphkin.planning.assembly import assemble, with_sides
from graphkin.planning.equivalent import contacts, lower_pairs
from graphkin.planning.groups import chain, coincide, group, mesh, walk
from graphkin.planning.images import drive, fill, measure_slides, reach
from graphkin.planning.labels import Labels, coincident_points
from graphkin.planning.loop_terms import halves, way_round
from graphkin.planning.method import Method, facts_of
from graphkin.planning.polygon import PolygonPlan
from graphkin.planning.position import position
from graphkin.planning.refusals import refuse_contacts_apart
from graphkin.planning.special_points import Ternary, special_points, with_special_points
from graphkin.planning.stages import Bridge, Carry, Group, Loop, Mesh, Stage, stages
from graphkin.planning.structure import Aside, Hinge, SetAside, Topology


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
    aside, drawn = tuple[SetAside, ...](), dict[str, float]()
    if structure.surplus > 0:
        from graphkin.planning.redundancy import redundant_constraints  # few mechanisms have any

        aside = redundant_constraints(mechanism, structure)
    if ties or mechanism.poses:
        from graphkin.planning.drawn_position import as_drawn

        drawn, lower = as_drawn(mechanism, lower, aside)
    if aside or ties or mechanism.poses:
        structure = replace(structure, mechanism=lower, aside=Aside.of(aside))
    if aside and ties:
        guided = (replace(contact, way=_shares(structure, structure.slides[contact.slide], contact.centres[1]))
                  if contact.slide in structure.aside.slides else contact
                  for contact in structure.contacts)  # fmt: skip
        structure = replace(structure, contacts=tuple(guided))
    order = _order(structure)
    construction, choices = position(structure, order)
    facts = facts_of(structure, None, drawn)
    sides, near = assemble(structure, construction, choices, facts, drawn)
    construction = with_sides(construction, sides)
    ternaries: Mapping[Group, Ternary] = {}
    if ties or any(isinstance(stage, Group) for stage in order):  # nothing else hangs on places
        plot = replay(construction, Plot(facts, near))
        refuse_contacts_apart(mechanism, ties, plot)
        ternaries = special_points(structure, order, plot)
    polygons = _polygons(structure, order, construction, ternaries)
    return Method(mechanism, structure, order, *polygons, near, drawn, ternaries, aside)


def with_other_points(method: Method, plot: Plot) -> Method:
    """The same mechanism with the special points of its groups chosen anew, for the position of a plot."""
    structure, order = method.structure, method.stages
    construction, _ = position(structure, order)
    sides = {step.choice: step.side for step in method.position.steps if isinstance(step, kinds.Meet | kinds.Swing)}
    construction = with_sides(construction, tuple(sides[k] for k in sorted(k for k in sides if k is not None)))
    ternaries = special_points(structure, order, plot)
    polygons = _polygons(structure, order, construction, ternaries)
    return Method(method.mechanism, structure, order, *polygons, method.near, method.drawn, ternaries, method.aside)


def _polygons(
    structure: Topology, order: tuple[Stage, ...], construction: Construction, ternaries: Mapping[Group, Ternary]
) -> tuple[Construction, Construction, Construction, dict[str, str]]:
    """Position, velocity and acceleration by way of these special points; the coincident points."""
    meeting = coincident_points(structure, order)
    owners = structure.mechanism.owners
    pole = next(letter for letter in ("p", "o", "q", "z", "pole") if letter.upper() not in owners)
    labels = Labels(structure, meeting)
    velocity, at = _polygon(structure, order, labels, "velocity", pole, lambda site: "", ternaries)
    acceleration, _ = _polygon(structure, order, labels, "acceleration", pole, at, ternaries)
    return with_special_points(construction, ternaries), velocity, acceleration, meeting


def _order(structure: Topology) -> tuple[Stage, ...]:
    """The order of solution; refuses a mechanism some of whose links it does not reach."""
    order, left = stages(structure)
    if left:
        homes = dict.fromkeys(structure.home(body) for body in left)
        names = [name for name in homes if structure.is_link(name)]
        raise HigherClass(structure.mechanism.where("links", names[0]), tuple(names))
    # a wheel whose centre other pairs keep on its path leaves no equation that gives how far it is
    given = set(structure.slides_driven) | structure.aside.slides
    for stage in order:
        given |= {stage.slide} if isinstance(stage, Mesh) else set()
        given |= set(stage.slides) if isinstance(stage, Loop | Group) else set()
        meeting = stage.contacts if isinstance(stage, Group) else (stage.contact,) if isinstance(stage, Mesh) else ()
        for contact in meeting:
            if contact.slide and contact.slide not in given:
                links = tuple(structure.mechanism.called(wheel) for wheel in contact.wheels)
                raise HigherClass(structure.mechanism.where("links", contact.wheels[1]), links)
    return order


SlideShares = tuple[tuple[str, float], ...]
"""Slides whose displacements add up to another one, each with what it counts."""


def _shares(structure: Topology, track: Slide, centre: str) -> SlideShares:
    """From a track set aside over parallel slides to a link that carries the centre; nothing where none lead there. A
    plate on a guide, a wheel that rolls on it, a second plate on top: how far the wheel goes along the second plate is
    made up of the displacements of plates and wheel along their own lines, which are all parallel."""
    reached: dict[str, tuple[complex, SlideShares]] = {track.guide: (track.line.direction, ())}
    queue = [track.guide]
    for link in queue:
        along, shares = reached[link]
        if centre in structure.bodies[link]:
            return shares
        for name, share, other, turned in _parallel_slides(structure, link, along):
            if other not in reached:
                reached[other] = (turned, (*shares, (name, share)))
                queue.append(other)
    return ()


def _parallel_slides(structure: Topology, link: str, along: complex) -> Iterator[tuple[str, float, str, complex]]:
    """The slides of a link that run as the track does: name, what it counts, the other body, the track's line there."""
    for slide in structure.joining:
        block, turn = structure.block(slide), cmath.rect(1.0, slide.turn)
        if link == slide.guide:
            share, other, turned = slide.line.direction / along, block, along / turn
        elif link == block:
            share, other, turned = -slide.line.direction / (along * turn), slide.guide, along * turn
        else:
            continue
        if abs(share.imag) < 1e-9 * abs(share):
            yield slide.name, 1.0 if share.real > 0 else -1.0, other, turned


def wrong_side(mechanism: Mechanism) -> OtherSide | None:
    """The error that names the first `side` of a wheel or a profile whose opposite closes the mechanism."""
    for k, pair in enumerate(mechanism.pairs):
        for turned, path, left in _other_sides(pair):
            pairs = (*mechanism.pairs[:k], turned, *mechanism.pairs[k + 1 :])
            try:
                plan(replace(mechanism, pairs=pairs))
            except GraphkinError:
                continue
            return OtherSide(mechanism.where(*mechanism.path(pair), *path, "side"), "left" if left else "right")
    return None


def _other_sides(pair: Pair) -> Iterator[tuple[Pair, tuple[str | int, ...], bool]]:
    """The pair with one side changed, where in its table that side stands, and what it is then."""
    if isinstance(pair, RollingContact) and pair.line is not None:
        yield replace(pair, left=not pair.left), (), not pair.left
    if isinstance(pair, Cam):
        for n, face in enumerate(pair.profiles):
            if face.line is not None:
                faces = [replace(each, left=not each.left) if each is face else each for each in pair.profiles]
                yield replace(pair, profiles=(faces[0], faces[1])), ("profiles", n), not face.left


# --- polygons ---------------------------------------------------------------------------------


def _polygon(
    structure: Topology, order: tuple[Stage, ...], labels: Labels, plane: Plane, pole: str,
    velocity: Callable[[Site], str], ternaries: Mapping[Group, Ternary],
) -> tuple[Construction, Callable[[Site], str]]:  # fmt: skip
    """One polygon, an equation for each loop, and the name in it of each site; accelerations ask velocities."""
    polygon = PolygonPlan(structure, labels, plane, pole + primes(structure.mechanism, plane), velocity)
    polygon.new(polygon.pole, "pole")
    polygon.parts.append(kinds.Given(polygon.pole, tuple(map(polygon.fixed, structure.named(FRAME)))))
    for stage in order:
        match stage:
            case Carry(body, by):
                if not isinstance(by, Hinge):
                    drive(polygon, by.slide, body)
                fill(polygon, body)
            case Bridge(body, points):
                # in the acceleration plane the normal part has no moment about the tail, so the whole arrow serves
                tail, head = (polygon.name(Site(point, body)) for point in points)
                polygon.parts.append(kinds.Measure(polygon.turning, body, tail, head, points))
                fill(polygon, body)
            case Mesh():
                mesh(polygon, stage)
            case Loop():
                _loop(polygon, stage)
            case Group():
                group(polygon, stage, ternaries.get(stage))
    for each in (stage for stage in order if isinstance(stage, Group)):
        for loop in each.floating:
            coincide(polygon, loop)
    measure_slides(polygon, structure.measured)
    return Construction(plane, tuple(polygon.parts), polygon.nodes, polygon.pole), polygon.name


def _loop(polygon: PolygonPlan, stage: Loop) -> None:
    """One vector equation, where the loop has two unknown scalars; else all of it by calculation."""
    if sum(not hop.known for hop in way_round(polygon.structure, stage)[1]) > 2:
        polygon.parts.append(kinds.Simultaneous(stage.angles, stage.slides, (chain(polygon, stage),), ()))
        walk(polygon, stage)
        return
    start, left, end, right = halves(polygon.structure, stage)
    reach(polygon, start)
    reach(polygon, end)
    sides = polygon.in_order(polygon.side(start, left), polygon.side(end, right))
    # as long as nothing is laid off from the pole, an equation may begin elsewhere and find it last
    free = polygon.plane == "velocity" and not any(isinstance(part, Equation | kinds.LayOff) for part in polygon.parts)
    polygon.equate(left[-1].of if left else start, *sides, polygon.pole if free else "")
    for hop in left + right:
        if not hop.known:
            polygon.measure_unknown(hop)
    for body in stage.bodies:
        fill(polygon, body)
