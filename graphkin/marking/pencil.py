"""The construction drawn with a pencil that errs: many times at once, as arrays.

A mechanism drawn on paper is a slightly different mechanism: its pivots, lengths and guides are off by what ruler and
protractor allow (`drawn_positions`). The polygons are drawn on it by a hand that errs again at each arrow, line and
reading (`PencilHand`). Lengths that the problem gives are used as they are given.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import reduce

import numpy as np

from graphkin.base.geometry import Value
from graphkin.base.value import frozen
from graphkin.construction import (
    Across,
    AcrossGuide,
    Along,
    AlongGuide,
    Coriolis,
    Direction,
    Drawn,
    Driven,
    Facts,
    Image,
    Measure,
    Normal,
    Plane,
    Plot,
    Quarter,
    Ray,
    Relative,
    Size,
    Span,
    Tangential,
    Turning,
    replay,
)
from graphkin.marking.hand import Hand, Redrawing
from graphkin.marking.slips import Mark, Slips
from graphkin.planning import Method
from graphkin.running.path import turned

_STAGES = 3
"""Links are fitted anew while errors grow by this part of what they come to."""
_NO_ARROW = 1e-6
"""An arrow shorter than this part of what the pencil errs by is not drawn."""


@frozen
class Pencil:
    """Standard deviations of what is drawn or read.

    lengths  of a length, by plane, in its units [m, m/s, m/s^2]: the paper's errors at the plane's scale
    angle    of a direction [rad]
    """

    lengths: Mapping[Plane, float]
    angle: float

    def times(self, part: float) -> Pencil:
        """One that errs by so many times as much."""
        return Pencil({plane: part * length for plane, length in self.lengths.items()}, part * self.angle)


# --- the mechanism on paper -------------------------------------------------------------------


def drawn_positions(method: Method, pencil: Pencil, slips: Slips) -> Plot:
    """The mechanism drawn `slips.count` times: positions (n,), NaN in those drawings whose links do not meet.

    Where links are fitted the errors grow little by little, so that each drawing stays on the assembly it is one of;
    it does not close where it comes to a dead point on its way.
    """
    near: Mapping[str, Value] = method.near
    senses = replay(method.position, Plot(method.facts(), near)).senses if method.fits else {}
    for part in np.linspace(0, 1, _STAGES + 1)[1:] if method.fits else (1.0,):
        plot = replay(method.position, Plot(_on_paper(method, pencil.times(float(part)), slips), near))
        astray = reduce(np.logical_or, (plot.senses[name] != sense for name, sense in senses.items()), np.False_)
        for table in (plot.position, plot.theta, plot.s) if np.any(astray) else ():
            table.update({name: np.where(astray, np.nan, value) for name, value in table.items()})
        near = turned(method, plot)
    return plot


def _on_paper(method: Method, pencil: Pencil, slips: Slips) -> Facts:
    """Dimensions and drivers as they get onto the paper."""
    facts, length = method.facts(), pencil.lengths["position"]
    lines: dict[str, tuple[str, str, Value]] = {}
    for slide, (guide, origin, direction) in facts.lines.items():
        turned = pencil.angle * slips.of(Mark("position", "guide", (slide,)))
        lines[slide] = guide, origin, direction * np.exp(1j * turned)
    values = []
    for driver, value in zip(method.drivers, facts.values, strict=True):
        error = length if driver.kind == "slide" else pencil.angle
        values.append(value + error * slips.of(Mark("position", "driver", (driver.name,))))
    shapes = {link: _shape(facts, link, length, slips) for link in facts.shapes}
    return replace(facts, shapes=shapes, lines=lines, values=tuple(values))


def _shape(facts: Facts, link: str, length: float, slips: Slips) -> dict[str, Value]:
    """A link as drawn, in its axes: from its first point the second at a length, every other at two."""
    shape: dict[str, Value] = dict(facts.shapes[link])
    points = list(shape)
    on_axis = points[1] if link != facts.frame and len(points) > 1 else ""
    for point in points[1:]:
        mark = Mark("position", "point", (link, point))
        across = 0.0 if point == on_axis else slips.of(mark, 1)
        shape[point] = shape[point] + length * (slips.of(mark) + 1j * across)
    return shape


# --- the polygons -----------------------------------------------------------------------------


@frozen
class PencilHand(Hand):
    """Draws and reads with a pencil. `given`: the dimensions as the problem has them."""

    pencil: Pencil
    slips: Slips
    given: Facts

    def arrow(self, plot: Redrawing, plane: Plane, size: Size, right: Value) -> Value:
        """Calculated from what was read, then laid off in a length and a direction."""
        match size:
            case Drawn():
                return right
            case Coriolis(_, tail, head):
                read = right * self._read(plot, (tail, head))
            case Turning(link, tail, head) | Normal(link, tail, head) | Tangential(link, tail, head):
                read = right * self._given(plot, link, tail, head)
            case Relative(link, _, tail, head):
                read = right * self._given(plot, link, tail, head)
            case Driven() | Span():
                read = right
        return self._laid(plane, "arrow", called(size), read)

    def line(self, plot: Redrawing, plane: Plane, number: int, ray: Ray, right: Value) -> Value:
        mark = Mark(plane, "line", (ray.through, *_pointing(ray.direction)))
        return right * np.exp(1j * self.pencil.angle * self.slips.of(mark))

    def image(self, plot: Redrawing, plane: Plane, step: Image, right: Value) -> Value:
        """The similar figure, its new point at an angle and a length from one of the old."""
        base = plot.points(plane)[step.base[0]]
        return base + self._laid(plane, "image", (step.point,), right - base)

    def read(self, plot: Redrawing, plane: Plane, step: Measure, right: Value) -> Value:
        slip = self.pencil.lengths[plane] * self.slips.of(Mark(plane, "reading", (step.tail, step.head)))
        if step.quantity not in ("omega", "alpha"):
            return right + slip
        arm = np.abs(plot.arm(*step.lever))
        return (right + slip / arm) / self._given(plot, step.of, *step.lever)

    def _laid(self, plane: Plane, what: str, of: tuple[str, ...], right: Value) -> Value:
        """An arrow with errors in its length and its direction; one of no length is not drawn."""
        mark, error = Mark(plane, what, of), self.pencil.lengths[plane]
        length = np.abs(right)
        if not np.any(length > _NO_ARROW * error):
            return right
        longer = error * self.slips.of(mark) / np.where(length > _NO_ARROW * error, length, np.inf)
        return right * (1 + longer) * np.exp(1j * self.pencil.angle * self.slips.of(mark, 1))

    def _read(self, plot: Redrawing, ends: tuple[str, str]) -> Value:
        """By what part a length of the velocity polygon is read wrong, + 1."""
        length = np.abs(plot.velocity[ends[1]] - plot.velocity[ends[0]])
        error = self.pencil.lengths["velocity"]
        if not np.any(length > _NO_ARROW * error):
            return 1.0
        slip = self.slips.of(Mark("velocity", "reading", ends))
        return 1 + error * slip / np.where(length > _NO_ARROW * error, length, np.inf)

    def _given(self, plot: Redrawing, link: str, tail: str, head: str) -> Value:
        """The length as the problem gives it to that on the paper; 1 where it is read off the paper."""
        shape = self.given.shapes.get(link, {})
        if tail not in shape or head not in shape:
            return 1.0
        return abs(shape[head] - shape[tail]) / np.abs(plot.arm(tail, head))


def called(size: Size) -> tuple[str, ...]:
    """An arrow as marks name it: its kind with the points or slides it is made of."""
    match size:
        case Span(parts):
            return type(size).__name__, *(str(part) for part in parts)
        case Driven(slide, _):
            return type(size).__name__, slide
        case Drawn(tail, head):
            return type(size).__name__, tail, head
        case Turning(link, tail, head) | Normal(link, tail, head) | Tangential(link, tail, head):
            return type(size).__name__, link, tail, head
        case Coriolis(link, tail, head):
            return type(size).__name__, link, tail, head
        case Relative(link, seen_from, tail, head, part):
            return type(size).__name__, link, seen_from, tail, head, part


def _pointing(direction: Direction) -> tuple[str, ...]:
    match direction:
        case Along(tail, head) | Across(tail, head):
            return type(direction).__name__, tail, head
        case AlongGuide(slide) | AcrossGuide(slide):
            return type(direction).__name__, slide
        case Quarter(link, tail, head):
            return type(direction).__name__, link, tail, head
