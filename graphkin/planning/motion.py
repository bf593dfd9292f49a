"""The velocity and the acceleration polygon: one vector equation for each loop, images for further points.

Methods of Sun Huan, 机械原理, section 3-2.1: two points of one link, equations (3-1) and (3-2); coincident
points of a sliding pair, (3-3) and (3-4); velocity and acceleration image.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from graphkin.construction import Construction, Equation, Given, LayOff, Measure, Plane, Simultaneous, Site
from graphkin.model.mechanism import FRAME
from graphkin.model.naming import primes
from graphkin.planning.groups import chain, coincide, group, walk
from graphkin.planning.images import drive, fill, reach
from graphkin.planning.labels import Labels
from graphkin.planning.loop_terms import halves, way_round
from graphkin.planning.polygon import PolygonPlan
from graphkin.planning.repeating import measure_all_slides
from graphkin.planning.rolling import mesh
from graphkin.planning.special import Ternary
from graphkin.planning.stages import Bridge, Carry, Group, Loop, Mesh, Stage
from graphkin.planning.structure import Hinge, Topology


def motion(
    structure: Topology,
    order: tuple[Stage, ...],
    labels: Labels,
    plane: Plane,
    pole: str,
    velocity: Callable[[Site], str],
    ternaries: Mapping[Group, Ternary],
) -> tuple[Construction, Callable[[Site], str]]:
    """One polygon, and the name in it of each site; the acceleration polygon asks the velocity polygon's."""
    polygon = _with_pole(structure, labels, plane, pole, velocity)
    for stage in order:
        _draw(polygon, stage, ternaries)
    for each in (stage for stage in order if isinstance(stage, Group)):
        for loop in each.floating:
            coincide(polygon, loop)
    measure_all_slides(polygon)
    return Construction(plane, tuple(polygon.parts), polygon.nodes, polygon.pole), polygon.name


def _with_pole(
    structure: Topology, labels: Labels, plane: Plane, pole: str, velocity: Callable[[Site], str]
) -> PolygonPlan:
    """The polygon as it begins: the pole, with the fixed points on it."""
    prime = primes(structure.mechanism, plane)
    polygon = PolygonPlan(structure, labels, plane, pole + prime, velocity)
    polygon.new(polygon.pole, "pole")
    fixed = tuple(polygon.fixed(point) for point in structure.named(FRAME))
    polygon.parts.append(Given(polygon.pole, fixed))
    return polygon


def _draw(polygon: PolygonPlan, stage: Stage, ternaries: Mapping[Group, Ternary]) -> None:
    match stage:
        case Carry():
            _carry(polygon, stage)
        case Bridge():
            _bridge(polygon, stage)
        case Mesh():
            mesh(polygon, stage)
        case Loop():
            _loop(polygon, stage)
        case Group():
            group(polygon, stage, ternaries.get(stage))


def _loop(polygon: PolygonPlan, stage: Loop) -> None:
    """One vector equation, where the loop has two unknown scalars; else all of it by calculation."""
    if sum(not hop.known for hop in way_round(polygon.structure, stage)[1]) > 2:
        together = (chain(polygon, stage),)
        polygon.parts.append(Simultaneous(stage.angles, stage.slides, together, ()))
        walk(polygon, stage)
        return
    start, left, end, right = halves(polygon.structure, stage)
    reach(polygon, start)
    reach(polygon, end)
    sides = polygon.in_order(polygon.side(start, left), polygon.side(end, right))
    polygon.equate(left[-1].of if left else start, *sides, _pole_to_find(polygon))
    for hop in left + right:
        if not hop.known:
            polygon.measure_unknown(hop)
    for body in stage.bodies:
        fill(polygon, body)


def _pole_to_find(polygon: PolygonPlan) -> str:
    """The pole, as long as nothing is laid off from it: an equation may then begin elsewhere and find it last."""
    free = not any(isinstance(part, Equation | LayOff) for part in polygon.parts)
    return polygon.pole if free and polygon.plane == "velocity" else ""


def _carry(polygon: PolygonPlan, stage: Carry) -> None:
    if not isinstance(stage.by, Hinge):
        drive(polygon, stage.by.slide, stage.body)
    fill(polygon, stage.body)


def _bridge(polygon: PolygonPlan, stage: Bridge) -> None:
    """In the acceleration plane the normal part has no moment about the tail, so the whole arrow serves."""
    tail, head = stage.points
    nodes = polygon.name(Site(tail, stage.body)), polygon.name(Site(head, stage.body))
    polygon.parts.append(Measure(polygon.turning, stage.body, *nodes, stage.points))
    fill(polygon, stage.body)
