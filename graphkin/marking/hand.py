"""Who draws: the hand that does each step as it should be done, and what another may do differently; and what it draws.

A step comes to the hand with what is right at this place of the drawing as it stands; what the hand gives is drawn, and
everything after follows from it. Mistakes, a student's own values and a pencil that errs are hands.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from graphkin.base.geometry import Value
from graphkin.construction import Facts, Image, InStep, LayOff, Measure, Plane, Plot, Ray, Size
from graphkin.model.mechanism import Usual


class Hand:
    """Does everything right. Values are scalars or arrays that broadcast with the positions."""

    def facts(self, facts: Facts) -> Facts:
        """The drivers' rates and accelerations that it starts from."""
        return facts

    def arrow(self, plot: Redrawing, plane: Plane, size: Size, right: Value) -> Value:
        """A known arrow, before it is laid off or put into equations that are solved together."""
        return right

    def laid(self, plot: Redrawing, plane: Plane, step: LayOff, right: Value) -> Value:
        """Where the pencil comes to when an arrow is laid off."""
        return right

    def line(self, plot: Redrawing, plane: Plane, number: int, ray: Ray, right: Value) -> Value:
        """The direction of a ray, of length 1; `number` is that of the crossing's step in its construction."""
        return right

    def through(self, plot: Redrawing, plane: Plane, number: int, ray: Ray, right: Value) -> Value:
        """Where a ray is drawn through."""
        return right

    def met(self, plot: Redrawing, plane: Plane, point: str, right: Value) -> Value:
        """Where two rays cross."""
        return right

    def image(self, plot: Redrawing, plane: Plane, step: Image, right: Value) -> Value:
        """A further point of a link."""
        return right

    def read(self, plot: Redrawing, plane: Plane, step: Measure, right: Value) -> Value:
        """What ruler and protractor give: omega or alpha of the link, or a slide's rate, with its sense."""
        return right

    def rolling(self, plot: Redrawing, plane: Plane, contact: InStep) -> InStep:
        """The law of a rolling contact, before it is put into equations that are solved together."""
        return contact

    def settled(self, plot: Redrawing, quantity: str, links: tuple[str, ...], of: str) -> None:
        """After a group of links that turn together has got its omega or alpha; `of`: the link it was read for."""


class Hands(Hand):
    """Several hands, each working on what the one before gives."""

    def __init__(self, *hands: Hand) -> None:
        self.hands = hands

    def facts(self, facts: Facts) -> Facts:
        for hand in self.hands:
            facts = hand.facts(facts)
        return facts

    def arrow(self, plot: Redrawing, plane: Plane, size: Size, right: Value) -> Value:
        for hand in self.hands:
            right = hand.arrow(plot, plane, size, right)
        return right

    def laid(self, plot: Redrawing, plane: Plane, step: LayOff, right: Value) -> Value:
        for hand in self.hands:
            right = hand.laid(plot, plane, step, right)
        return right

    def line(self, plot: Redrawing, plane: Plane, number: int, ray: Ray, right: Value) -> Value:
        for hand in self.hands:
            right = hand.line(plot, plane, number, ray, right)
        return right

    def through(self, plot: Redrawing, plane: Plane, number: int, ray: Ray, right: Value) -> Value:
        for hand in self.hands:
            right = hand.through(plot, plane, number, ray, right)
        return right

    def met(self, plot: Redrawing, plane: Plane, point: str, right: Value) -> Value:
        for hand in self.hands:
            right = hand.met(plot, plane, point, right)
        return right

    def image(self, plot: Redrawing, plane: Plane, step: Image, right: Value) -> Value:
        for hand in self.hands:
            right = hand.image(plot, plane, step, right)
        return right

    def read(self, plot: Redrawing, plane: Plane, step: Measure, right: Value) -> Value:
        for hand in self.hands:
            right = hand.read(plot, plane, step, right)
        return right

    def rolling(self, plot: Redrawing, plane: Plane, contact: InStep) -> InStep:
        for hand in self.hands:
            contact = hand.rolling(plot, plane, contact)
        return contact

    def settled(self, plot: Redrawing, quantity: str, links: tuple[str, ...], of: str) -> None:
        for hand in self.hands:
            hand.settled(plot, quantity, links, of)


@dataclass
class Redrawing(Plot):
    """A plot whose polygons a hand has drawn.

    laid      known arrows as they were laid off, by plane, tail and head
    by_hand   who draws
    before    omega and alpha by link as they follow from all before, where the hand has put another value
    met       points of the polygons as they follow from all before, likewise, where lines cross or by image
    reading   the link whose omega or alpha is being read
    usual     what sizes are usual: what is far below is nothing
    """

    by_hand: Hand = field(default_factory=Hand)
    laid: dict[tuple[Plane, str, str], Value] = field(default_factory=dict)
    before: dict[tuple[str, str], Value] = field(default_factory=dict)
    met: dict[tuple[Plane, str], Value] = field(default_factory=dict)
    reading: str = ""
    usual: Usual = field(default_factory=lambda: Usual(1.0, 0.0, 0.0))

    def arrow(self, size: Size, plane: Plane) -> Value:
        return self.by_hand.arrow(self, plane, size, super().arrow(size, plane))

    def settle(self, quantity: str, base: str, value: Value, counted: bool = False) -> None:
        super().settle(quantity, base, value, counted)
        links = tuple(link for link, turn in self.facts.turns.items() if turn.base == base)
        self.by_hand.settled(self, quantity, links, self.reading)
