"""The analytic solution at points that only a construction has: special points, rolling contacts."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from graphkin.analytic import Motion
from graphkin.check.drawing import DrawingFile
from graphkin.construction import Across, AcrossGuide, Along, AlongGuide, Direction, Meet, Ray, Site, Touch
from graphkin.geometry import Value, meet_lines
from graphkin.mechanism import Mechanism
from graphkin.motions import Motions
from graphkin.pairs import Line
from graphkin.planning import plan
from graphkin.value import Lazy, frozen

__all__ = ["Widened", "added_point", "lines_of", "widened"]


@frozen
class Widened(Motions):
    """The analytic solution at every site of a drawing; bodies that are no links move among the links.

    added   points that a construction adds, and where they lie [m]: special points, rolling contacts
    bodies  those that are no links: a pin in a slot turns with the slot (its point, the slot's link); two centres that
            profiles keep apart are joined by a bar of the equivalent (both points)
    """

    added: Mapping[str, complex]
    bodies: Mapping[str, tuple[str, str]]

    def place(self, point: str) -> complex:
        return complex(self.position[point])

    def knows(self, site: Site) -> bool:
        known = site.link in self.mechanism.links or site.link in self.bodies
        return known and site.point in self.position

    def points_of(self, body: str) -> tuple[str, ...]:
        """Points that are a body's own; of a pin only the one that it is."""
        if body in self.mechanism.links:
            return tuple(self.mechanism.links[body].points)
        return self.bodies[body][:1] if body.startswith("pin ") else self.bodies[body]


def _bodies(mechanism: Mechanism) -> dict[str, tuple[str, str]]:
    """Pins and bars that stand for something else, under the names that the planner gives them."""
    found = {f"pin {slide.name}": (slide.point, slide.guide) for slide in mechanism.slides if slide.block is None}
    for roll in mechanism.rolls:
        if roll.line is not None:
            found[f"pin {roll.name}"] = (roll.centre, roll.line.link)
        elif roll.track_centre is not None:
            found[f"e {roll.name}"] = (roll.track_centre, roll.centre)
    for k, cam in enumerate(mechanism.cams):
        centres = [profile.centre for profile in cam.profiles if profile.centre is not None]
        faces = [profile.line.link for profile in cam.profiles if profile.line is not None]
        found |= {f"pin c{k}": (centres[0], faces[0])} if faces else {f"e c{k}": (centres[0], centres[1])}
    return found | {f"e g{k}": gear.centres for k, gear in enumerate(mechanism.gears)}


def widened(mechanism: Mechanism, exact: Motion, drawing: DrawingFile) -> Widened:
    """The analytic solution, at every point of a drawing."""
    bodies, added = _bodies(mechanism), _added(mechanism, exact, drawing)
    known = exact.velocities, exact.accelerations
    velocities, accelerations = (
        {**table, **{body: {point: vectors[point]} for body, (point, _) in bodies.items()}}
        for table, vectors in zip(known, (exact.velocity, exact.acceleration), strict=True)
    )
    return Widened(
        mechanism, exact.theta, _turning(exact, bodies, exact.omega, exact.velocity),
        _turning(exact, bodies, exact.alpha, exact.acceleration), exact.s, exact.s_rate, exact.s_acceleration,
        {**exact.position, **added}, velocities, accelerations, added, bodies,
    )  # fmt: skip


def _turning(
    exact: Motion, bodies: Mapping[str, tuple[str, str]], links: Mapping[str, Value], vectors: Mapping[str, Value]
) -> Mapping[str, Value]:
    """Angular velocities or accelerations of links and bodies, by the links' or by the vectors of two points."""

    def turning(body: str) -> Value:
        if body in links:
            return links[body]
        point, other = bodies[body]
        if body.startswith("pin "):
            return links[other]
        return np.imag((vectors[other] - vectors[point]) / (exact.position[other] - exact.position[point]))

    return Lazy((*links, *bodies), turning)


def _added(mechanism: Mechanism, exact: Motion, drawing: DrawingFile) -> Mapping[str, complex]:
    """Where the added points of a drawing lie by the analytic solution. What they are, the planner says."""
    named = {attributes.get("data-site", "").partition("@")[0] for attributes, _ in drawing.points}
    if named <= {"", *mechanism.points}:
        return {}
    steps = [step for step in plan(mechanism).position.steps if isinstance(step, Touch | Meet)]
    places = {step.point: added_point(step, mechanism, exact) for step in steps}
    return {point: place for point, place in places.items() if place is not None}


def added_point(step: Touch | Meet, mechanism: Mechanism, exact: Motion) -> complex | None:
    """The special point or the rolling contact that a step gives, from positions of the analytic solution."""
    if isinstance(step, Touch):
        centre = complex(exact.position[step.centre])
        if step.slide:
            return centre + 1j * step.offset * _along(step.slide, mechanism, exact)
        return centre + step.ratio * (complex(exact.position[step.other]) - centre)
    rays = [ray for ray in (step.first, step.second) if isinstance(ray, Ray)]
    if step.point in mechanism.points or not step.point[0].isupper() or len(rays) != 2:
        return None
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
    lines = {pair.name: pair.line for pair in mechanism.slides}
    lines |= {roll.name: roll.line for roll in mechanism.rolls if roll.line is not None}
    return lines | {f"c{k}": face.line for k, cam in enumerate(mechanism.cams) for face in cam.profiles if face.line}
