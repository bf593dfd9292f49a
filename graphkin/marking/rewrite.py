"""A mistake as a rewrite: one place of a construction done otherwise; and the hand that makes many of them at once."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator, Sequence
from dataclasses import field, replace
from itertools import chain

import numpy as np

from graphkin.base.geometry import Real, Value, unit
from graphkin.base.value import frozen
from graphkin.construction import Facts, Image, InStep, LayOff, Measure, Meet, Plane, Plot, Ray, Size, Swing, replay
from graphkin.marking.hand import PolygonHand, Redrawing
from graphkin.planning import Method

PARALLEL = np.sin(np.radians(0.5))  # sine of the angle under which lines are not taken to cross
NOTHING = 1e-9  # what a right value counts as nothing beside, as part of a wrong one

Spot = tuple[Hashable, ...]
"""A place of a drawing: ("arrow", plane, size), ("laid", plane, tip), ("line", plane, crossing's step, ray),
("through", plane, crossing's step, ray), ("met", plane, point), ("image", plane, point), ("read", plane, quantity, of),
("rolling", plane, contact, link) for a link's coefficient in a law, ("settled", quantity, link), ("rate" or
"acceleration" or "value", driver number), ("side", number of the choice)."""

Change = Callable[[Redrawing, Value], Value]
"""Gives what is drawn or read instead, from the drawing so far and what would be right there."""


@frozen
class Edit:
    """One place done otherwise."""

    spot: Spot
    change: Change = field(default=lambda plot, right: right)


@frozen
class RewrittenValue:
    """A handed-in value, by its quantity's text, that is not what was read: so many times it, or another instead, or
    what was read of another quantity."""

    quantity: str
    factor: complex = 1.0
    instead: complex | None = None
    other: str = ""


@frozen
class Rewrite:
    """A mistake made at one place.

    of     what it was made with, as written, each place by itself: `a^k_B3B2`, `omega 3`
    form   with what, where there is a choice: the quantity taken instead, the factor, as written
    way    which way of making it, where a mistake has several that take other words
    edits  the places done otherwise
    asked  handed-in values that were written otherwise though all was drawn right
    id     of the mistake, as in every output: `coriolis-omitted`; the register has it
    """

    of: tuple[str, ...]
    form: str = ""
    edits: tuple[Edit, ...] = ()
    asked: tuple[RewrittenValue, ...] = ()
    way: str = ""
    id: str = ""

    @property
    def name(self) -> tuple[str, str, tuple[str, ...], str]:
        """Different from those of all other rewrites of a construction."""
        return self.id, self.way, self.of, self.form


@frozen
class Times:
    """So many times what is right, whatever else is drawn; 1j turns it by 90 degrees counter-clockwise."""

    factor: complex

    def __call__(self, plot: Redrawing | None, right: Value) -> Value:
        return self.factor * right


def turned_back(link: str) -> Change:
    """The right value, turned by 90 degrees against the sense of a link's rotation."""
    return lambda plot, right: -1j * np.sign(plot.omega[link]) * right


def each_and_all(alone: Sequence[Rewrite], but: Sequence[str] = ()) -> Iterator[Rewrite]:
    """A mistake made at each of some places alone; and at all of them `but` some, where these are several."""
    yield from alone
    together = {one.of: one for one in alone if not {*one.of} <= {*but}}
    if len(together) > 1:
        edits = tuple(edit for one in together.values() for edit in one.edits)
        asked = tuple(value for one in together.values() for value in one.asked)
        yield replace(alone[0], of=(*chain(*together),), edits=edits, asked=asked)


def in_sense_of(plot: Redrawing, size: Value, right: Value, what: str) -> Value:
    """A size in the SI unit `what` with the sense, or the direction, of what is right; nan where that is nothing."""
    least, size = plot.least(what), np.abs(size)
    there = np.abs(right) > np.maximum(least, NOTHING * size)
    return np.where(there, unit(right), np.where(size > least, np.nan, 0.0)) * size


class Mistaken(PolygonHand):
    """Draws many columns at once, in each of them the mistakes named for it; (n,), or (n, ..) over positions."""

    def __init__(self, columns: Sequence[Sequence[Rewrite]], positions: tuple[int, ...] = ()) -> None:
        self.shape = (len(columns), *positions)
        spots: dict[Spot, dict[int, tuple[Change, list[int]]]] = {}
        for k, rewrites in enumerate(columns):
            for edit in (edit for rewrite in rewrites for edit in rewrite.edits):
                spots.setdefault(edit.spot, {}).setdefault(id(edit), (edit.change, []))[1].append(k)
        self.changes = {
            spot: [(change, np.array(which)) for change, which in edits.values()] for spot, edits in spots.items()
        }

    def _done(self, spot: Spot, plot: Redrawing | None, right: Value) -> Value:
        """The right value, but another in the columns that have a mistake there; no plot before the drawing begins."""
        if spot not in self.changes:
            return right
        value = np.broadcast_to(right, self.shape).astype(complex if np.iscomplexobj(right) else float)
        for change, which in self.changes[spot]:
            if isinstance(change, Times):
                value[which] *= change.factor
            elif plot is not None:
                value[which] = np.broadcast_to(change(plot, value), self.shape)[which]
        return value

    def _number(self, spot: Spot, plot: Redrawing | None, right: Real) -> Real:
        """The same of a real number."""
        return self._done(spot, plot, right).real

    def facts(self, facts: Facts) -> Facts:
        rates, accelerations = self._given("rate", facts.rates), self._given("acceleration", facts.accelerations)
        return replace(facts, rates=rates, accelerations=accelerations)

    def _given(self, word: str, values: tuple[Real, ...]) -> tuple[Real, ...]:
        return tuple(self._number((word, k), None, value) for k, value in enumerate(values))

    def placed(self, method: Method, right: Plot) -> Plot:
        """The mechanism, where its own drawing has mistakes too: by other driver values, on the other side."""
        if not any(spot[0] in ("value", "side") for spot in self.changes):
            return right
        sides = {
            step.choice: self._done(("side", step.choice), None, step.side)
            for step in method.position.steps if isinstance(step, Meet | Swing) and step.choice is not None
        }  # fmt: skip
        facts = replace(right.facts, values=self._given("value", right.facts.values))
        return replay(method.position, Plot(facts, right.near), sides)

    def arrow(self, plot: Redrawing, plane: Plane, size: Size, right: Value) -> Value:
        return self._done(("arrow", plane, size), plot, right)

    def tip(self, plot: Redrawing, plane: Plane, step: LayOff, right: Value) -> Value:
        return self._done(("laid", plane, step.tip), plot, right)

    def line(self, plot: Redrawing, plane: Plane, step: Meet, ray: Ray, right: Value) -> Value:
        return self._done(("line", plane, step, ray), plot, right)

    def through(self, plot: Redrawing, plane: Plane, step: Meet, ray: Ray, right: Value) -> Value:
        return self._done(("through", plane, step, ray), plot, right)

    def crossing(self, plot: Redrawing, plane: Plane, point: str, right: Value) -> Value:
        """Nowhere, where lines drawn otherwise hardly cross: nothing that follows is judged."""
        sine = plot.sines[plane, point]
        if np.any(sine < PARALLEL):
            right = np.where(sine < PARALLEL, np.nan, right)
        return self._done(("met", plane, point), plot, right)

    def corner(self, plot: Redrawing, plane: Plane, step: Image, right: Value) -> Value:
        return self._done(("image", plane, step.point), plot, right)

    def read(self, plot: Redrawing, plane: Plane, step: Measure, right: Real) -> Real:
        return self._number(("read", plane, step.quantity, step.of), plot, right)

    def rolling(self, plot: Redrawing, plane: Plane, contact: InStep) -> InStep:
        angles = ((link, self._done(("rolling", plane, contact, link), plot, right)) for link, right in contact.angles)
        return replace(contact, angles=tuple(angles))

    def settled(self, plot: Redrawing, quantity: str, links: tuple[str, ...], of: str) -> None:
        table: dict[str, Real] = getattr(plot, quantity)
        for link in links:
            if ("settled", quantity, link) in self.changes:
                plot.before[quantity, link] = table[link]
                table[link] = self._number(("settled", quantity, link), plot, table[link])
