"""The analytic solution at points that only a construction has: special points, rolling contacts."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from graphkin.analytic import Motion
from graphkin.base.geometry import Value, meet_lines
from graphkin.base.value import Lazy, frozen
from graphkin.check.drawing import DrawingFile
from graphkin.construction import Across, AcrossGuide, Along, AlongGuide, Direction, Meet, Ray, Site, Touch
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import Mechanism
from graphkin.model.pairs import Line, Rod, Slot, pin_name, rod_name
from graphkin.planning import plan


@frozen
class Body:
    """A body that is no link: a pin turns with its slot, which is on the link `turns_with`; two centres that profiles
    keep apart are joined by a bar of the equivalent.
    """

    points: tuple[str, ...]
    turns_with: str = ""


@frozen
class Widened(Motions):
    """The analytic solution at every site of a drawing; bodies that are no links move among the links.

    added   points that a construction adds, and where they lie [m]: special points, rolling contacts
    bodies  those that are no links
    """

    added: Mapping[str, complex]
    bodies: Mapping[str, Body]

    def place(self, point: str) -> complex:
        return complex(self.position[point])

    def knows(self, site: Site) -> bool:
        known = site.link in self.mechanism.links or site.link in self.bodies
        return known and site.point in self.position

    def points_of(self, body: str) -> tuple[str, ...]:
        """Points that are a body's own; of a pin only the one that it is."""
        if body in self.mechanism.links:
            return tuple(self.mechanism.links[body].points)
        return self.bodies[body].points


def _bodies(mechanism: Mechanism) -> dict[str, Body]:
    """Pins and bars that stand for something else, under the names that the planner gives them."""
    found: dict[str, Body] = {}
    for pair in mechanism.pairs:
        same = pair.equivalent or pair.slipping
        if isinstance(same, Rod):
            found[rod_name(pair)] = Body(same.points)
        elif isinstance(same, Slot):
            found[pin_name(pair)] = Body((same.point,), same.line.link)
    return found


def widened(mechanism: Mechanism, exact: Motion, drawing: DrawingFile) -> Widened:
    """The analytic solution, at every point of a drawing."""
    bodies, added = _bodies(mechanism), _added(mechanism, exact, drawing)
    known = exact.velocities, exact.accelerations
    velocities, accelerations = (
        {**table, **{body: {(point := each.points[0]): vectors[point]} for body, each in bodies.items()}}
        for table, vectors in zip(known, (exact.velocity, exact.acceleration), strict=True)
    )
    return Widened(
        mechanism, exact.theta, _turning(exact, bodies, exact.omega, exact.velocity),
        _turning(exact, bodies, exact.alpha, exact.acceleration), exact.s, exact.s_rate, exact.s_acceleration,
        {**exact.position, **added}, velocities, accelerations, added, bodies,
    )  # fmt: skip


def _turning(
    exact: Motion, bodies: Mapping[str, Body], links: Mapping[str, Value], vectors: Mapping[str, Value]
) -> Mapping[str, Value]:
    """Angular velocities or accelerations of links and bodies, by the links' or by the vectors of two points."""

    def turning(body: str) -> Value:
        if body in links:
            return links[body]
        if guide := bodies[body].turns_with:
            return links[guide]
        point, other = bodies[body].points
        return np.imag((vectors[other] - vectors[point]) / (exact.position[other] - exact.position[point]))

    return Lazy((*links, *bodies), turning)


def _added(mechanism: Mechanism, exact: Motion, drawing: DrawingFile) -> Mapping[str, complex]:
    """Where the added points of a drawing lie by the analytic solution. What they are, the planner says."""
    named = {attributes.get("data-site", "").partition("@")[0] for attributes, _ in drawing.points}
    if named <= {"", *mechanism.points}:
        return {}
    method = plan(mechanism)
    steps = (step for step in method.position.steps if isinstance(step, Touch | Meet))
    return {step.point: added_point(step, mechanism, exact) for step in steps
            if isinstance(step, Touch) or step.point in method.special}  # fmt: skip


def added_point(step: Touch | Meet, mechanism: Mechanism, exact: Motion) -> complex:
    """The special point or the rolling contact that a step gives, from positions of the analytic solution."""
    if isinstance(step, Touch):
        centre = complex(exact.position[step.centre])
        if step.slide:
            return centre + 1j * step.offset * _along(step.slide, mechanism, exact)
        return centre + step.ratio * (complex(exact.position[step.other]) - centre)
    rays = [ray for ray in (step.first, step.second) if isinstance(ray, Ray)]
    first, second = ((exact.position[ray.through], _line(ray.direction, mechanism, exact)) for ray in rays)
    return complex(meet_lines(*first, *second)[0])


def _line(direction: Direction, mechanism: Mechanism, exact: Motion) -> complex:
    if isinstance(direction, AcrossGuide | AlongGuide):
        along = _along(direction.slide, mechanism, exact)
        return 1j * along if isinstance(direction, AcrossGuide) else along
    assert isinstance(direction, Along | Across)
    arm = complex(exact.position[direction.head] - exact.position[direction.tail])
    return arm / abs(arm) * (1j if isinstance(direction, Across) else 1)


def _along(slide: str, mechanism: Mechanism, exact: Motion) -> complex:
    line = lines_of(mechanism)[slide]
    return complex(line.direction * np.exp(1j * exact.theta[line.link]))


def lines_of(mechanism: Mechanism) -> dict[str, Line]:
    """The line of every sliding pair, track and flat face of a cam."""
    return {pair.name: line for pair in mechanism.pairs for line in pair.lines}
