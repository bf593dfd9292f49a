"""Both polygons drawn again by a hand, on the mechanism as it was drawn: many hands at once by arrays."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field

import numpy as np

from graphkin.base.geometry import Real, Value
from graphkin.base.value import frozen
from graphkin.construction import Facts, Hand, Image, LayOff, Plane, Plot, Simultaneous, Size, replay
from graphkin.planning import Method


class PolygonHand(Hand["Redrawing"]):
    """Draws polygons, exactly in all that is not said otherwise, and notes what was right where it draws."""

    def facts(self, facts: Facts) -> Facts:
        """The drivers' rates and accelerations that it starts from."""
        return facts

    def arrow(self, plot: Redrawing, plane: Plane, size: Size, right: Value) -> Value:
        """A known arrow, before it is laid off or put into equations that are solved together."""
        return right

    def tip(self, plot: Redrawing, plane: Plane, step: LayOff, right: Value) -> Value:
        """The place where the pencil comes to when an arrow is laid off."""
        return right

    def crossing(self, plot: Redrawing, plane: Plane, point: str, right: Value) -> Value:
        """The point where two lines cross."""
        return right

    def corner(self, plot: Redrawing, plane: Plane, step: Image, right: Value) -> Value:
        """A further point of a link, by image."""
        return right

    def settled(self, plot: Redrawing, quantity: str, links: tuple[str, ...], of: str) -> None:
        """After a group of links that turn together has got its omega or alpha; `of`: the link it was read for."""

    def laid(self, plot: Redrawing, plane: Plane, step: LayOff, arrow: Value, right: Value) -> Value:
        plot.laid[plane, step.term.tail, step.term.head] = arrow
        return self.tip(plot, plane, step, right)

    def met(self, plot: Redrawing, plane: Plane, point: str, right: Value) -> Value:
        plot.met[plane, point] = right
        return self.crossing(plot, plane, point, right)

    def image(self, plot: Redrawing, plane: Plane, step: Image, right: Value) -> Value:
        wheel = plot.wheels.get(step.link)
        if wheel is not None and wheel.centre != step.corners[2]:
            right = turned_about(plot, plane, step, wheel.centre)
        return self.further(plot, plane, step, right)

    def further(self, plot: Redrawing, plane: Plane, step: Image, right: Value) -> Value:
        """The point of an image, from where it lies on this drawing."""
        plot.met[plane, step.point] = right
        return self.corner(plot, plane, step, right)


def turned_about(plot: Redrawing, plane: Plane, step: Image, about: str) -> Value:
    """A further point of a link by v = omega l, or a^n and a^t, about another of its points where that is drawn, else
    about the first that the image is from."""
    known, points = dict(zip(step.corners, step.base, strict=False)), plot.points(plane)
    node = known.get(about) or plot.corners.get((plane, about), "")
    if node not in points:
        about, node = next(iter(known.items()))
    omega = plot.omega[step.link]
    turned = 1j * omega if plane == "velocity" else 1j * plot.alpha[step.link] - omega**2
    value: Value = points[node] + turned * plot.arm(about, step.corners[2])
    return value


@frozen
class WheelCentre:
    """The centre of a link that rolls, the arm that bears it, and where that one turns."""

    centre: str
    arm: str = ""
    pivot: str = ""


@dataclass
class Redrawing(Plot):
    """A plot whose polygons a hand has drawn.

    laid      known arrows as they were laid off, by plane, tail and head
    by_hand   who draws
    before    omega and alpha by link as they follow from all before, where the hand has put another value
    met       points of the polygons as they follow from all before, likewise, where lines cross or by image
    wheels    links that roll: their further points are calculated from the rotation, not by image
    corners   of the polygons, by plane and point of the mechanism, the first where there are several
    least     the size up to which a value of an SI unit is nothing in this mechanism
    """

    by_hand: PolygonHand = field(default_factory=PolygonHand)
    laid: dict[tuple[Plane, str, str], Value] = field(default_factory=dict)
    before: dict[tuple[str, str], Real] = field(default_factory=dict)
    met: dict[tuple[Plane, str], Value] = field(default_factory=dict)
    wheels: Mapping[str, WheelCentre] = field(default_factory=dict)
    corners: Mapping[tuple[Plane, str], str] = field(default_factory=dict)
    least: Callable[[str], float] = field(default=lambda unit: 0.0)

    def arrow(self, size: Size, plane: Plane) -> Value:
        return self.by_hand.arrow(self, plane, size, super().arrow(size, plane))

    def settle(self, quantity: str, base: str, value: Real, counted: bool = False, of: str = "") -> None:
        super().settle(quantity, base, value, counted)
        links = tuple(link for link, turn in self.facts.turns.items() if turn.base == base)
        self.by_hand.settled(self, quantity, links, of)


RIGHT = PolygonHand()


def redraw(method: Method, right: Plot, hand: PolygonHand = RIGHT, shape: tuple[int, ...] = ()) -> Redrawing:
    """Velocities and accelerations by a hand, at the positions of a plot, from the rates of that.

    shape  of the values, where the hand gives arrays: it broadcasts with that of the positions
    """
    plot = Redrawing(
        hand.facts(right.facts), right.near, right.follows, right.position,
        theta=dict(right.theta), s=right.s, by_hand=hand, least=method.mechanism.usual.least,
    )  # fmt: skip
    polygons = (method.velocity, method.acceleration)
    if method.structure.tying:
        plot.wheels = dict(_wheels(method))
        plot.corners = {(polygon.plane, node.site.point): name for polygon in polygons
                        for name, node in reversed([*polygon.nodes.items()]) if node.site is not None}  # fmt: skip
    if shape and any(isinstance(step, Simultaneous) for polygon in polygons for step in polygon.steps):
        plot.theta[plot.facts.frame] = np.zeros(shape)  # what is solved together takes its shape from the angles
    with np.errstate(over="ignore"):
        for polygon in polygons:
            replay(polygon, plot, hand=hand)
            if (polygon.plane, polygon.pole) in plot.met:
                plot.met[polygon.plane, polygon.pole] = 0j
    return plot


def _wheels(method: Method) -> Iterator[tuple[str, WheelCentre]]:
    for contact in method.structure.tying:
        for wheel, centre, other in zip(contact.wheels, contact.centres, contact.centres[::-1], strict=True):
            if centre:
                yield wheel, WheelCentre(centre, contact.arm, other)
