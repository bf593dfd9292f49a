"""The analytic solution at points that only a construction has: special points, rolling contacts."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from graphkin.analytic import Motion
from graphkin.check.drawing import DrawingFile
from graphkin.geometry import meet_lines
from graphkin.mechanism import FRAME, Mechanism
from graphkin.methods import plan
from graphkin.pairs import Line
from graphkin.steps import Across, AcrossGuide, Along, AlongGuide, Direction, Meet, Ray, Site, Touch
from graphkin.value import frozen

__all__ = ["Widened", "added_point", "lines_of", "widened"]


@frozen
class Widened:
    """The analytic solution at every site of a drawing.

    added   points that a construction adds, and where they lie [m]: special points, rolling contacts
    bodies  those that are no links: a pin in a slot turns with the slot (its point, the slot's link); two centres that
            profiles keep apart are joined by a bar of the equivalent (both points)
    """

    mechanism: Mechanism
    motion: Motion
    added: Mapping[str, complex]
    bodies: Mapping[str, tuple[str, str]]

    def place(self, point: str) -> complex:
        return self.added[point] if point in self.added else complex(self.motion.position[point])

    def knows(self, site: Site) -> bool:
        bodies = {**self.mechanism.links, **self.bodies}
        return site.link in bodies and (site.point in self.added or site.point in self.motion.position)

    def velocity(self, site: Site) -> complex:
        """Of the point of a body that lies there at this instant [m/s]."""
        if site.link == FRAME:
            return 0j
        base = self._base(site.link)
        return complex(self.motion.velocity[base]) + 1j * self.turning(site.link)[0] * self._arm(base, site.point)

    def acceleration(self, site: Site) -> complex:
        """[m/s^2]"""
        if site.link == FRAME:
            return 0j
        base, (omega, alpha) = self._base(site.link), self.turning(site.link)
        return complex(self.motion.acceleration[base]) + (1j * alpha - omega**2) * self._arm(base, site.point)

    def turning(self, body: str) -> tuple[float, float]:
        """Angular velocity and acceleration [rad/s, rad/s^2]."""
        if body == FRAME:
            return 0.0, 0.0
        if body in self.mechanism.links:
            return float(self.motion.omega[body]), float(self.motion.alpha[body])
        point, other = self.bodies[body]
        if body.startswith("pin "):
            return self.turning(other)
        arm = self._arm(point, other)
        velocity, acceleration = self.motion.velocity, self.motion.acceleration
        omega = float(((velocity[other] - velocity[point]) / arm).imag)
        return omega, float(((acceleration[other] - acceleration[point]) / arm).imag)

    def points_of(self, body: str) -> tuple[str, ...]:
        """Points that are a body's own; of a pin only the one that it is."""
        if body in self.mechanism.links:
            return tuple(self.mechanism.links[body].points)
        return self.bodies[body][:1] if body.startswith("pin ") else self.bodies[body]

    def _base(self, body: str) -> str:
        return self.bodies[body][0] if body in self.bodies else next(iter(self.mechanism.links[body].points))

    def _arm(self, tail: str, head: str) -> complex:
        return self.place(head) - self.place(tail)


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
    return Widened(mechanism, exact, _added(mechanism, exact, drawing), _bodies(mechanism))


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
