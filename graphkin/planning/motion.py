"""The velocity and the acceleration polygon: one vector equation for each loop, images for further points.

Methods of Sun Huan, 机械原理, section 3-2.1: two points of one link, equations (3-1) and (3-2); coincident
points of a sliding pair, (3-3) and (3-4); velocity and acceleration image.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from graphkin.construction import Construction, Equation, Given, LayOff, Measure, Plane, Simultaneous, Site
from graphkin.model.mechanism import FRAME
from graphkin.model.naming import primes
from graphkin.planning.groups import chain, coincide, group, mesh, walk
from graphkin.planning.images import drive, fill, measure_slides, reach
from graphkin.planning.labels import Labels
from graphkin.planning.loop_terms import halves, way_round
from graphkin.planning.polygon import PolygonPlan
from graphkin.planning.special_points import Ternary
from graphkin.planning.stages import Bridge, Carry, Group, Loop, Mesh, Stage
from graphkin.planning.structure import Hinge, Topology


def motion(
    structure: Topology, order: tuple[Stage, ...], labels: Labels, plane: Plane, pole: str,
    velocity: Callable[[Site], str], ternaries: Mapping[Group, Ternary],
) -> tuple[Construction, Callable[[Site], str]]:  # fmt: skip
    """One polygon, and the name in it of each site; the acceleration polygon asks the velocity polygon's."""
    polygon = PolygonPlan(structure, labels, plane, pole + primes(structure.mechanism, plane), velocity)
    polygon.new(polygon.pole, "pole")
    polygon.parts.append(Given(polygon.pole, tuple(map(polygon.fixed, structure.named(FRAME)))))
    for stage in order:
        match stage:
            case Carry(body, by):
                if not isinstance(by, Hinge):
                    drive(polygon, by.slide, body)
                fill(polygon, body)
            case Bridge(body, points):
                # in the acceleration plane the normal part has no moment about the tail, so the whole arrow serves
                tail, head = (polygon.name(Site(point, body)) for point in points)
                polygon.parts.append(Measure(polygon.turning, body, tail, head, points))
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
        polygon.parts.append(Simultaneous(stage.angles, stage.slides, (chain(polygon, stage),), ()))
        walk(polygon, stage)
        return
    start, left, end, right = halves(polygon.structure, stage)
    reach(polygon, start)
    reach(polygon, end)
    sides = polygon.in_order(polygon.side(start, left), polygon.side(end, right))
    # as long as nothing is laid off from the pole, an equation may begin elsewhere and find it last
    free = polygon.plane == "velocity" and not any(isinstance(part, Equation | LayOff) for part in polygon.parts)
    polygon.equate(left[-1].of if left else start, *sides, polygon.pole if free else "")
    for hop in left + right:
        if not hop.known:
            polygon.measure_unknown(hop)
    for body in stage.bodies:
        fill(polygon, body)
