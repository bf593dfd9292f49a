"""The construction drawn exactly and read as a hand reads it: every length to half a millimetre of the paper.

What is calculated from readings is laid off as it was calculated, and everything after follows from it. Lengths that
the problem gives are not read.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from graphkin.base.geometry import Real, Value, cross
from graphkin.base.value import frozen
from graphkin.construction import Facts, Image, LayOff, Measure, Plane, Plot, terms
from graphkin.marking.hand import PolygonHand, Redrawing, redraw
from graphkin.model.mechanism import FRAME
from graphkin.planning import Method
from graphkin.planning.position import touching

READ_MM, READ_DEGREES = 0.5, 0.5
"""The steps in which a ruler and a protractor are read."""
_STRAIGHT = 1e-9


@frozen
class Ruler:
    """Reads lengths on paper. Scales [m/mm, (m/s)/mm, (m/s²)/mm] by plane; `right`: what is drawn exactly."""

    method: Method
    right: Plot
    scales: Mapping[Plane, float]

    def read(self, length: Value, plane: Plane) -> Real:
        """A length in the units of its plane, to half a millimetre on paper; with its sign."""
        step = READ_MM * self.scales[plane]
        rounded: Real = np.round(length.real / step) * step
        return rounded

    def angle(self, degrees: float) -> float:
        return round(degrees / READ_DEGREES) * READ_DEGREES

    def distance(self, plot: Plot, first: str, second: str) -> Real:
        """Between two points of the mechanism [m]: as it is given, or as it is read."""
        length: Real = np.abs(plot.arm(first, second))
        return length if self.given(plot.facts, first, second) else self.read(length, "position")

    def given(self, facts: Facts, first: str, second: str) -> bool:
        """True if a length is given: on one link, driven, or the radius of a wheel to where it touches."""
        slides = self.method.structure.slides
        radii = ({letter, centre} for letter, contact in touching(self.method.structure) for centre in contact.centres)
        if {first, second} in radii:
            return True
        driven = [{slides[name].line.origin, slides[name].point} for name in facts.slides_driven]
        links = (shape for link, shape in facts.shapes.items() if link != FRAME)
        return {first, second} in driven or any(first in shape and second in shape for shape in links)

    def arrow(self, plot: Plot, plane: Plane, tail: str, head: str) -> Real:
        """The length of an arrow: as it was laid off, or as it is read."""
        points = plot.points(plane)
        length: Real = np.abs(points[head] - points[tail])
        polygon = self.method.velocity if plane == "velocity" else self.method.acceleration
        laid = {(step.term.tail, step.term.head) for step in polygon.steps if isinstance(step, LayOff)}
        return length if (tail, head) in laid else self.read(length, plane)


@frozen
class RulerHand(PolygonHand):
    """Draws exactly and reads with a ruler."""

    ruler: Ruler

    def arrow(self, plot: Redrawing, plane: Plane, size: terms.Size, right: Value) -> Value:
        """Calculated from what was read."""
        match size:
            case terms.Drawn() | terms.Driven() | terms.Span():
                return right
            case terms.Coriolis(_, tail, head):
                exactly = np.abs(plot.velocity[head] - plot.velocity[tail])
                return right * _part(self.ruler.arrow(plot, "velocity", tail, head), exactly)
            case terms.Turning() | terms.Normal() | terms.Tangential() | terms.Relative():
                lever = size.tail, size.head
                return right * _part(self.ruler.distance(plot, *lever), np.abs(plot.arm(*lever)))

    def corner(self, plot: Redrawing, plane: Plane, step: Image, right: Value) -> Value:
        """On a line by the lengths that are read; beside it by the similar figure."""
        first, second, third = step.corners
        points = plot.points(plane)
        tail, head = points[step.base[0]], points[step.base[1]]
        beside = np.abs(cross(plot.arm(first, third), plot.arm(second, third)))
        if not np.all(beside <= _STRAIGHT * np.abs(plot.arm(first, second)) ** 2):
            return right
        parts = [self.ruler.distance(plot, first, point) for point in (third, second)]
        length = self.ruler.arrow(plot, plane, *step.base) * parts[0] / parts[1]
        return tail + (right - tail) * _part(length, np.abs(right - tail)) if np.any(head != tail) else right

    def read(self, plot: Redrawing, plane: Plane, step: Measure, right: Real) -> Real:
        if step.quantity not in ("omega", "alpha"):
            return self.ruler.read(right, plane)
        arm = np.abs(plot.arm(*step.lever))
        return self.ruler.read(right * arm, plane) / self.ruler.distance(plot, *step.lever)


def _part(length: Real, exactly: Real) -> Real:
    """The part of the exact length that was taken; 1 of no length."""
    part: Real = np.where(exactly > 0, length / np.where(exactly > 0, exactly, 1.0), 1.0)[()]
    return part


def as_drawn(method: Method, plot: Plot, scales: Mapping[Plane, float]) -> tuple[Redrawing, Ruler]:
    """Both polygons of a plot, drawn exactly, with everything read off them to half a millimetre."""
    ruler = Ruler(method, plot, scales)
    return redraw(method, plot, RulerHand(ruler)), ruler
