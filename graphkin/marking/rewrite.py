"""A mistake as a rewrite: one place of a construction done otherwise; and the hand that makes many of them at once."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from dataclasses import field, replace

import numpy as np

from graphkin.construction import Facts, Image, LayOff, Measure, Plane, Ray, Size
from graphkin.geometry import Value
from graphkin.marking.hand import Hand
from graphkin.marking.redrawing import Redrawing
from graphkin.value import frozen

__all__ = ["Change", "Edit", "Mistaken", "Rewrite", "Spot", "times"]

Spot = tuple[Hashable, ...]
"""What a hand is asked: ("arrow", plane, size), ("laid", plane, tip), ("line", plane, step number, ray),
("met", plane, point), ("image", plane, point), ("read", plane, quantity, of), ("settled", quantity, link),
("rate" or "acceleration", driver number)."""

Change = Callable[[Redrawing, Value], Value]
"""What is drawn or read instead, from the drawing so far and what would be right there."""


@frozen
class Edit:
    """One place done otherwise."""

    spot: Spot
    change: Change = field(default=lambda plot, right: right)


@frozen
class Rewrite:
    """A mistake made at one place.

    id     of the mistake, as in every output: `coriolis-omitted`
    of     what it was made with, as written: `a^k_B3B2`, `omega 3`
    form   which form of the mistake, where it has several: the quantity taken instead, or what was done
    edits  the places done otherwise
    asked  factors of handed-in values that were written otherwise though all was drawn right, by quantity as written
    """

    id: str
    of: str
    form: str = ""
    edits: tuple[Edit, ...] = ()
    asked: tuple[tuple[str, float], ...] = ()

    @property
    def name(self) -> tuple[str, str, str]:
        return self.id, self.of, self.form


def times(factor: complex) -> Change:
    """So many times what is right; 1j turns it by 90 degrees counter-clockwise."""
    return lambda plot, right: factor * right


class Mistaken(Hand):
    """Draws many columns at once, in each of them the mistakes named for it; (n,), or (n, ..) over positions."""

    def __init__(self, columns: Sequence[Sequence[Rewrite]], positions: tuple[int, ...] = ()) -> None:
        self.shape = (len(columns), *positions)
        found: dict[Spot, dict[int, tuple[Change, list[int]]]] = {}
        for k, rewrites in enumerate(columns):
            for edit in (edit for rewrite in rewrites for edit in rewrite.edits):
                found.setdefault(edit.spot, {}).setdefault(id(edit), (edit.change, []))[1].append(k)
        self.changes = {
            spot: [(change, np.array(which)) for change, which in edits.values()] for spot, edits in found.items()
        }

    def _done(self, spot: Spot, plot: Redrawing, right: Value) -> Value:
        """What is right, but otherwise in the columns that have a mistake there."""
        if spot not in self.changes:
            return right
        value = np.array(np.broadcast_to(right, self.shape))
        for change, which in self.changes[spot]:
            value[which] = np.broadcast_to(change(plot, value), self.shape)[which]
        return value

    def facts(self, facts: Facts) -> Facts:
        nothing = Redrawing(facts)
        rates, accelerations = (
            tuple(self._done((word, k), nothing, value) for k, value in enumerate(values))
            for word, values in (("rate", facts.rates), ("acceleration", facts.accelerations))
        )
        return replace(facts, rates=rates, accelerations=accelerations)

    def arrow(self, plot: Redrawing, plane: Plane, size: Size, right: Value) -> Value:
        return self._done(("arrow", plane, size), plot, right)

    def laid(self, plot: Redrawing, plane: Plane, step: LayOff, right: Value) -> Value:
        return self._done(("laid", plane, step.tip), plot, right)

    def line(self, plot: Redrawing, plane: Plane, number: int, ray: Ray, right: Value) -> Value:
        return self._done(("line", plane, number, ray), plot, right)

    def met(self, plot: Redrawing, plane: Plane, point: str, right: Value) -> Value:
        return self._done(("met", plane, point), plot, right)

    def image(self, plot: Redrawing, plane: Plane, step: Image, right: Value) -> Value:
        return self._done(("image", plane, step.point), plot, right)

    def read(self, plot: Redrawing, plane: Plane, step: Measure, right: Value) -> Value:
        return self._done(("read", plane, step.quantity, step.of), plot, right)

    def settled(self, plot: Redrawing, quantity: str, links: tuple[str, ...], of: str) -> None:
        table: dict[str, Value] = getattr(plot, quantity)
        for link in links:
            if ("settled", quantity, link) in self.changes:
                plot.before[quantity, link] = table[link]
                table[link] = self._done(("settled", quantity, link), plot, table[link])
