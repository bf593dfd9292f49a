"""The analytic solution at points that only a construction has: special points, rolling contacts."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from graphkin.analytic import Motion
from graphkin.check.drawing import DrawingFile
from graphkin.geometry import Value, meet_lines
from graphkin.mechanism import FRAME, Mechanism
from graphkin.methods import plan
from graphkin.naming import seen
from graphkin.pairs import Line
from graphkin.steps import Across, AcrossGuide, Along, AlongGuide, Direction, Meet, Ray, Touch
from graphkin.value import frozen

__all__ = ["Widened", "added_point", "widened"]


@frozen
class Widened:
    """The analytic solution, at points too that a construction adds: special points, rolling contacts."""

    mechanism: Mechanism
    motion: Motion
    added: Mapping[str, complex]

    @property
    def theta(self) -> Mapping[str, Value]:
        return self.motion.theta

    @property
    def omega(self) -> Mapping[str, Value]:
        return self.motion.omega

    @property
    def alpha(self) -> Mapping[str, Value]:
        return self.motion.alpha

    @property
    def s(self) -> Mapping[str, Value]:
        return self.motion.s

    @property
    def s_rate(self) -> Mapping[str, Value]:
        return self.motion.s_rate

    @property
    def s_acceleration(self) -> Mapping[str, Value]:
        return self.motion.s_acceleration

    @property
    def position(self) -> Mapping[str, Value]:
        return {**self.motion.position, **self.added}

    def velocity_at(self, point: str, link: str) -> Value:
        if point not in self.added or link == FRAME:
            return 0j if link == FRAME else self.motion.velocity_at(point, link)
        start = next(iter(self.mechanism.links[link].points))
        arm = self.added[point] - self.motion.position[start]
        return self.motion.velocity_at(start, link) + 1j * self.motion.omega[link] * arm

    def acceleration_at(self, point: str, link: str) -> Value:
        if point not in self.added or link == FRAME:
            return 0j if link == FRAME else self.motion.acceleration_at(point, link)
        start = next(iter(self.mechanism.links[link].points))
        arm = self.added[point] - self.motion.position[start]
        turn = 1j * self.motion.alpha[link] - self.motion.omega[link] ** 2
        return self.motion.acceleration_at(start, link) + turn * arm


def widened(mechanism: Mechanism, exact: Motion, drawing: DrawingFile) -> Widened:
    """The analytic solution, at every point of a drawing."""
    return Widened(mechanism, exact, _added(mechanism, exact, drawing))


def _added(mechanism: Mechanism, exact: Motion, drawing: DrawingFile) -> Mapping[str, complex]:
    """Where the added points of a drawing lie by the analytic solution. What they are, the planner says."""
    named = [attributes.get("data-of", "") for attributes, _ in drawing.points]
    if all(name == "pole" or "^" in name or seen(mechanism, name) for name in named):
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
    """Direction of a sliding pair's line, a track, or the flat face of a cam."""
    lines: dict[str, Line | None] = {pair.name: pair.line for pair in mechanism.slides}
    lines |= {roll.name: roll.line for roll in mechanism.rolls}
    lines |= {f"c{k}": face.line for k, cam in enumerate(mechanism.cams) for face in cam.profiles if face.line}
    line = lines[slide]
    assert line is not None
    return complex(line.direction * np.exp(1j * exact.theta[line.link]))
