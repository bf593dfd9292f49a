"""Carried errors: everything after a student's own value, as it follows from it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from graphkin.base.geometry import Value
from graphkin.base.value import frozen
from graphkin.construction import Coriolis, Image, LayOff, Measure, Plane, Plot, Size
from graphkin.marking.asked import ArrowPlaces, Ends, arrows_of, asked
from graphkin.marking.hand import Hand, Redrawing
from graphkin.marking.redrawing import redraw
from graphkin.model.quantities import Answer, Component, Moving, Quantity, Rotation
from graphkin.planning import Method


@frozen
class Followed:
    """The polygons drawn on from own values.

    plot     the drawing
    """

    method: Method
    arrows: ArrowPlaces
    plot: Redrawing

    def value(self, quantity: Quantity) -> Answer:
        """What follows for a quantity from the own values *before* it: its own one does not count."""
        if isinstance(quantity, Rotation) and (quantity.word, quantity.link) in self.plot.before:
            return Answer(self.plot.before[quantity.word, quantity.link], quantity.unit)
        return asked(self.method, self.plot, quantity, self.arrows, before=True)

    @property
    def least_sine(self) -> Value:
        """Of the angles under which lines meet, the smallest one's sine."""
        sines = [sine for (plane, _), sine in self.plot.sines.items() if plane != "position"]
        return np.minimum.reduce(np.broadcast_arrays(1.0, *sines))


def replay_with(
    method: Method, right: Plot, own: Mapping[Quantity, Value], arrows: ArrowPlaces | None = None
) -> Followed:
    """Draw the polygons on from a student's own values, at the positions of the right plot.

    own  by quantity, SI: omega and alpha with their sense; of a vector the complex vector where it was drawn (or both
         its components), or its size. Scalars, or arrays over students with NaN where one has no value. Other
         quantities have no effect.

    A vector's size alone is taken as read off or laid off in the direction it has: what is calculated from it follows,
    and what is drawn from a known arrow's end; a drawn vector moves its point.
    """
    arrows = arrows or arrows_of(method)
    hand = Own(own, arrows)
    shape = np.broadcast_shapes(*(np.shape(value) for value in own.values()))
    return Followed(method, arrows, redraw(method, right, hand, shape))


class Own(Hand):
    """Draws with own values in their place."""

    def __init__(self, own: Mapping[Quantity, Value], arrows: ArrowPlaces) -> None:
        self.rotations = {(q.word, q.link): value for q, value in own.items() if isinstance(q, Rotation)}
        self.vectors: dict[Ends, list[Value]] = {}
        for quantity, value in _whole(own):
            if isinstance(quantity, Moving) and (found := arrows.of(quantity)) is not None:
                ends, sign = found
                signed = quantity.along is not None and not np.iscomplexobj(value)
                vector = value * quantity.along if signed else value
                each = sign * vector if np.iscomplexobj(vector) else np.abs(vector)
                self.vectors.setdefault(ends, []).append(each)
        self.poles = arrows.poles

    def _own(self, ends: Ends, right: Value, drawn_only: bool = False) -> Value:
        """The own vector; of an own size, in the right direction. What is right where there is none.

        A vector may go by several names: each student's own is under the name that they have used.
        """
        plane, tail, head = ends
        sign = 1
        if ends not in self.vectors:
            ends, sign = (plane, head, tail), -1
        found = right
        for own in self.vectors.get(ends, ()):
            if np.iscomplexobj(own) or not drawn_only:
                found = _where_given(sign * own if np.iscomplexobj(own) else own * right / np.abs(right), found)
        return found

    def arrow(self, plot: Redrawing, plane: Plane, size: Size, right: Value) -> Value:
        """A Coriolis term with the own relative velocity."""
        if not isinstance(size, Coriolis):
            return right
        slip = plot.velocity[size.head] - plot.velocity[size.tail]
        return 2j * plot.omega[size.link] * self._own(("velocity", size.tail, size.head), slip)

    def laid(self, plot: Redrawing, plane: Plane, step: LayOff, right: Value) -> Value:
        ends = plane, step.term.tail, step.term.head
        points = plot.points(plane)
        drawn = points[step.start] - right if step.backwards else right - points[step.start]
        arrow = self._own(ends, drawn)
        return points[step.start] - arrow if step.backwards else points[step.start] + arrow

    def met(self, plot: Redrawing, plane: Plane, point: str, right: Value) -> Value:
        """A drawn vector from the pole moves its point."""
        return self._own((plane, self.poles[plane], point), right, drawn_only=True)

    def image(self, plot: Redrawing, plane: Plane, step: Image, right: Value) -> Value:
        return self._own((plane, self.poles[plane], step.point), right)

    def read(self, plot: Redrawing, plane: Plane, step: Measure, right: Value) -> Value:
        """omega = v / l with the own v."""
        points = plot.points(plane)
        arrow = points[step.head] - points[step.tail]
        own = self._own((plane, step.tail, step.head), arrow)
        if own is arrow:
            return right
        if step.quantity in ("omega", "alpha"):
            return right + ((own - arrow) / (1j * plot.arm(*step.lever))).real
        return right * np.abs(own) / np.abs(arrow)

    def settled(self, plot: Redrawing, quantity: str, links: tuple[str, ...], of: str) -> None:
        """An own omega holds for the links that turn with its link too, unless these have their own."""
        owned = [link for link in dict.fromkeys((of, *links)) if (quantity, link) in self.rotations]
        if not owned:
            return
        table: dict[str, Value] = getattr(plot, quantity)
        right = {link: table[link] for link in links}
        leads, more = self._leading(quantity, owned, right)
        for link in links:
            plot.before[quantity, link] = right[link] + np.where(leads.get(link, False), 0.0, more)
            table[link] = self._rotation(quantity, link, right[link] + more)

    def _leading(
        self, quantity: str, owned: Sequence[str], right: Mapping[str, Value]
    ) -> tuple[dict[str, np.ndarray], Value]:
        """Where each link is the first that a student has an own value of, and by how much that one is off."""
        leads: dict[str, np.ndarray] = {}
        taken, more = np.zeros((), dtype=bool), np.zeros(())
        for link in owned:
            own = self.rotations[quantity, link]
            leads[link] = np.isfinite(own) & ~taken
            more = np.where(leads[link], own - right[link], more)
            taken = taken | leads[link]
        return leads, more[()]

    def _rotation(self, quantity: str, link: str, right: Value) -> Value:
        own = self.rotations.get((quantity, link))
        return right if own is None else _where_given(own, right)


def _whole(own: Mapping[Quantity, Value]) -> list[tuple[Quantity, Value]]:
    """With both components of a vector put together."""
    axes: dict[Moving, dict[str, Value]] = {}
    for quantity, value in own.items():
        if isinstance(quantity, Component):
            axes.setdefault(quantity.whole, {})[quantity.axis] = value
    both = [(whole, parts["x"] + 1j * parts["y"]) for whole, parts in axes.items() if len(parts) == 2]
    return [*own.items(), *both]


def _where_given(own: Value, right: Value) -> Value:
    found: Value = np.where(np.isfinite(own), own, right)
    return found[()]
