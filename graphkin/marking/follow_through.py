"""Carried errors: everything after a student's own wrong values, as it follows from them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from graphkin.base.geometry import Real, Value
from graphkin.base.value import frozen
from graphkin.construction import Coriolis, Image, LayOff, Measure, Plane, Plot, Size
from graphkin.marking.answers import ArrowPlaces, Ends, arrows_of, drawn_answer
from graphkin.marking.hand import PolygonHand, Redrawing, redraw, turned_about
from graphkin.model.quantities import Answer, Moving, Quantity, Rotation
from graphkin.model.quantities.kinds import Component
from graphkin.planning import Method


@frozen
class Followed:
    """The polygons drawn on from own values."""

    method: Method
    arrows: ArrowPlaces
    plot: Redrawing

    def value(self, quantity: Quantity) -> Answer:
        """The answer that follows for a quantity from the own values *before* it: its own one does not count."""
        if isinstance(quantity, Rotation) and (quantity.word, quantity.link) in self.plot.before:
            return Answer(self.plot.before[quantity.word, quantity.link], quantity.unit)
        return drawn_answer(self.method, self.plot, quantity, self.arrows, before=True)

    @property
    def least_sine(self) -> np.ndarray:
        """Of the angles under which lines meet, the smallest one's sine."""
        sines = [sine for (plane, _), sine in self.plot.sines.items() if plane != "position"]
        return np.asarray(np.minimum.reduce(np.broadcast_arrays(1.0, *sines)))


def replay_with(
    method: Method, right: Plot, own: Mapping[Quantity, Value], arrows: ArrowPlaces | None = None,
    wheels: Mapping[tuple[str, str], Value] | None = None, calculates: bool = False,
) -> Followed:  # fmt: skip
    """Draw the polygons on from a student's own values, at the positions of the right plot.

    own  by quantity, SI: omega and alpha with their sense; of a vector the complex vector where it was drawn (or both
         its components), or its size. Scalars, or arrays over students with NaN where one has no value. Other
         quantities have no effect.
    wheels, calculates  as of `Own`

    A vector's size alone is taken as read off or laid off in the direction it has: what is calculated from it follows,
    and what is drawn from a known arrow's end; a drawn vector moves its point.
    """
    arrows = arrows or arrows_of(method)
    shape = np.broadcast_shapes(*(np.shape(value) for value in own.values()))
    return Followed(method, arrows, redraw(method, right, Own(own, arrows, wheels, calculates), shape))


class Own(PolygonHand):
    """Draws with own values in their place."""

    def __init__(
        self, own: Mapping[Quantity, Value], arrows: ArrowPlaces, wheels: Mapping[tuple[str, str], Value] | None = None,
        calculates: bool = False,
    ) -> None:  # fmt: skip
        """wheels: omega and alpha of wheels that follow from own ones, which count where there is none of these;
        calculates: further points of a link by its own rotation, not by image."""
        self.calculates = calculates
        self.rotations = {(q.word, q.link): value for q, value in own.items() if isinstance(q, Rotation)}
        for rate, value in (wheels or {}).items():
            first = self.rotations.get(rate)
            self.rotations[rate] = value if first is None else _where_given(first, value)
        self.vectors: dict[Ends, list[Value]] = {}
        axes: dict[Moving, dict[str, Value]] = {}
        for quantity, value in own.items():
            if isinstance(quantity, Component):
                axes.setdefault(quantity.whole, {})[quantity.axis] = value
        both = [(whole, parts["x"] + 1j * parts["y"]) for whole, parts in axes.items() if len(parts) == 2]
        for quantity, value in (*own.items(), *both):
            if isinstance(quantity, Moving) and (arrow := arrows.of(quantity)) is not None:
                ends, sign = arrow
                along = 1.0 if quantity.along is None or np.iscomplexobj(value) else quantity.along
                vector = value * along
                each = sign * vector if np.iscomplexobj(vector) else np.abs(vector)
                self.vectors.setdefault(arrows.at_poles(ends), []).append(each)
        self.poles, self.at_poles = arrows.poles, arrows.at_poles
        self.turned: set[tuple[str, str]] = set()

    def _own(self, ends: Ends, right: Value, drawn_only: bool = False) -> Value:
        """The own vector, under any of the names that students use for it; of an own size, in the right direction. What
        is right where there is none."""
        plane, tail, head = ends = self.at_poles(ends)
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

    def tip(self, plot: Redrawing, plane: Plane, step: LayOff, right: Value) -> Value:
        start = plot.points(plane)[step.start]
        arrow = self._own((plane, step.term.tail, step.term.head), start - right if step.backwards else right - start)
        return start - arrow if step.backwards else start + arrow

    def crossing(self, plot: Redrawing, plane: Plane, point: str, right: Value) -> Value:
        """A drawn vector from the pole moves its point."""
        return self._own((plane, self.poles[plane], point), right, drawn_only=True)

    def corner(self, plot: Redrawing, plane: Plane, step: Image, right: Value) -> Value:
        if self.calculates:
            plot.met[plane, step.point] = right = self._calculated(plot, plane, step, right)
        return self._own((plane, self.poles[plane], step.point), right)

    def _calculated(self, plot: Redrawing, plane: Plane, step: Image, right: Value) -> Value:
        """A further point by own rotations: the centre of a wheel by that of the arm which bears it."""
        wheel, points = plot.wheels.get(step.link), plot.points(plane)
        if wheel is not None and wheel.pivot and wheel.centre == step.corners[2] and plane == "velocity":
            rate = self.rotations.get(("omega", wheel.arm), np.nan)
            pivot = points.get(plot.corners.get((plane, wheel.pivot), ""), 0j)
            return _where_given(pivot + 1j * rate * plot.arm(wheel.pivot, wheel.centre), right)
        if not {("omega", step.link), ("alpha", step.link)} & self.turned:
            return right
        at_pole = (known for known, node in zip(step.corners, step.base, strict=False) if node == self.poles[plane])
        return turned_about(plot, plane, step, next(at_pole, ""))

    def read(self, plot: Redrawing, plane: Plane, step: Measure, right: Real) -> Real:
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
        """An own omega holds for the links that keep their angle to its link, unless these have their own; and links
        that drivers turn against it, seen from the link it was read for, keep what the drivers give them."""
        if not any((quantity, link) in self.rotations for link in links):
            return
        self.turned.update((quantity, link) for link in links)
        root = of or plot.facts.turns[links[0]].base
        alike: dict[frozenset[int], list[str]] = {}
        for link in dict.fromkeys((root, *links)):
            alike.setdefault(plot.facts.drivers_between(root, link), []).append(link)
        offs: dict[frozenset[int], Real] = {}
        for drivers in sorted(alike, key=len):
            before = max((nearer for nearer in offs if nearer < drivers), key=len, default=None)
            offs[drivers] = self._turned(plot, quantity, alike[drivers], 0.0 if before is None else offs[before])

    def _turned(self, plot: Redrawing, quantity: str, links: Sequence[str], before: Real) -> Real:
        """By how much links that keep their angle to one another turn otherwise than is right; `before`: by how much
        those do against which drivers turn them."""
        table: dict[str, Real] = getattr(plot, quantity)
        right = {link: table[link] for link in links}
        # the students of whose own values each link's is the first, and by how much that one is off
        leads: dict[str, np.ndarray] = {}
        led, off = np.zeros((), dtype=bool), np.asarray(before)
        for link in links:
            own = self.rotations.get((quantity, link), np.nan)
            leads[link] = np.isfinite(own) & ~led
            off = np.where(leads[link], own - right[link], off)
            led = led | leads[link]
        more: Real = off[()]
        for link in links:
            plot.before[quantity, link] = right[link] + np.where(leads[link], before, more)
            own = self.rotations.get((quantity, link), np.nan)
            table[link] = _where_given(own, right[link] + more).real
        return more


def _where_given(own: Value, right: Value) -> Value:
    value: Value = np.where(np.isfinite(own), own, right)[()]
    return value
