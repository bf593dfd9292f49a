"""The answers of a solution: what is asked for, as the solution has found it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from math import degrees, radians
from typing import assert_never

from graphkin.base.geometry import Value
from graphkin.base.value import frozen
from graphkin.model.kinematic_state import Motions
from graphkin.model.quantities import (
    Centre,
    Component,
    Displacement,
    Moving,
    Place,
    Quantity,
    Quotient,
    Rotation,
    Track,
)
from graphkin.model.units import EDGE
from graphkin.proof.readings import readings
from graphkin.say import names
from graphkin.say.asked import Asked
from graphkin.say.entry import Calculation, Entry, Heading, Sentence
from graphkin.say.figures import Operand, TrigFormula
from graphkin.say.numbers import number
from graphkin.say.reading import Reading


@frozen
class AnswerLines:
    """What is asked for, about to be told.

    told  the sizes of the vectors that the solution has calculated [SI], by their names
    """

    goal: Asked
    told: Mapping[str, float]

    @property
    def reading(self) -> Reading:
        return self.goal.reading

    @cached_property
    def _motions(self) -> Motions:
        return readings(self.reading.method, self.reading.plot)

    def entries(self) -> Iterator[Entry]:
        if self.goal.wanted:
            yield Heading(self.reading.say("solution.answer"))
        yield from (self.entry(quantity) for quantity in self.goal.wanted if quantity is not None)

    def entry(self, quantity: Quantity) -> Sentence | Calculation:
        """The answer to one question, with the figures it is worked out from where that is one step more."""
        name = self.goal.symbol(quantity)
        match quantity:
            case Centre():
                words = {"name": names.point(quantity.text), "place": self._place(quantity)}
                return Sentence("  " + self.reading.say("solution.centre at", **words))
            case Track():
                words = {"point": names.point(quantity.of), "place": self._point(quantity)}
                return Sentence("  " + self.reading.say("solution.place at", **words))
            case Moving():
                note = self.reading.say("derivation.at direction", angle=self.reading.angle(self._vector(quantity)))
                size = self.value(quantity)
                return Calculation(name, (), "", size, EDGE[quantity.unit].sign, note if size else "")
            case Component():
                return self._component(name, quantity)
            case Quotient():
                return self._quotient(name, quantity)
            case Rotation() if quantity.word != "theta":
                value = self.value(quantity)
                return Calculation(name, (), "", abs(value), EDGE[quantity.unit].sign, self._sense(value))
            case Rotation() | Displacement() | Place():
                unit = EDGE[quantity.unit]
                return Calculation(name, (), "", self.value(quantity) * unit.factor, unit.sign)
            case _:
                assert_never(quantity)

    def result(self, quantity: Quantity) -> str:
        """The answer without its name and without figures: `1.220 m/s (at 180° to +x)`."""
        match quantity:
            case Centre():
                return self._place(quantity)
            case Track():
                return f"{self._point(quantity)} mm"
            case Rotation() | Displacement() | Place() | Moving() | Component() | Quotient():
                entry = self.entry(quantity)
                assert isinstance(entry, Calculation), quantity
                note = self.reading.say("common.note", note=entry.note) if entry.note else ""
                return f"{entry.result}{note}"
            case _:
                assert_never(quantity)

    def signed(self, quantity: Quantity) -> float:
        """The answer as a number, of a rotation with its sense."""
        if isinstance(quantity, Rotation):
            return self.value(quantity)
        entry = self.entry(quantity)
        return entry.value if isinstance(entry, Calculation) else 0.0

    def value(self, quantity: Quantity) -> float:
        """What a quantity is [SI], as it was read where a ruler reads; 0 where it is but rounding noise."""
        exactly, ruler = float(quantity.answer(self._motions).value), self.reading.ruler
        if not self.reading.usual.cut(exactly, quantity.unit):
            return 0.0
        match quantity:
            case Moving():
                return self._told(quantity, exactly)
            case Component():
                return self._component("", quantity).value
            case Displacement() | Place() | Track() | Centre():
                return self.reading.measured(exactly)
            case Rotation(word="theta") if ruler is not None:
                return radians(ruler.angle(degrees(exactly)))
            case Rotation() | Quotient():
                return exactly
            case _:
                assert_never(quantity)

    # --- vectors --------------------------------------------------------------------------------

    def _vector(self, quantity: Moving) -> Value:
        return quantity.vector(self._motions)

    def _told(self, quantity: Moving, exactly: float) -> float:
        """The size of a vector as it was calculated; else as it is read off the polygon."""
        found = next((self.told[name] for name in self._called(quantity) if name in self.told), None)
        if found is not None:
            return found
        ruler = self.reading.ruler
        plane = "velocity" if quantity.letter == "v" else "acceleration"
        return exactly if ruler is None else float(ruler.read(exactly, plane))  # type: ignore[arg-type]

    def _called(self, quantity: Moving) -> Iterator[str]:
        """What the solution may call it: `v_C`, and `v_C4` of the point of one link."""
        yield self.goal.symbol(quantity)
        site, method = quantity.site, self.reading.method
        owners = method.mechanism.owners.get(site.point, ())
        links = {site.link, *(owners if site.link in owners else ())}
        if quantity.seen_from is None:
            nodes = (node for node in method.velocity.nodes.values() if node.site is not None)
            here = (n.of for n in nodes if n.site and n.site.point == site.point and n.site.link in links)
            yield from (names.vector(f"{quantity.letter}_{of}") for of in here)

    def _component(self, name: str, quantity: Component) -> Calculation:
        """`v_E,x = 0.3201 × cos 36.87° = 0.2561 m/s`."""
        whole, vector = self.value(quantity.whole), self._vector(quantity.whole)
        angle = self.reading.direction(vector)
        turned = TrigFormula("cos" if quantity.axis == "x" else "sin", angle)
        value, unit = whole * turned.value, EDGE[quantity.unit].sign
        if not self.reading.usual.cut(value, quantity.unit):
            return Calculation(name, (), "", 0.0, unit)
        return Calculation(name, (), Operand(whole) * turned, value, unit)

    def _quotient(self, name: str, quantity: Quotient) -> Calculation:
        """`ω1/ω3 = 10/18.69 = 0.5350 (same sense)`."""
        top, bottom = self.value(quantity.top), self.value(quantity.bottom)
        if not (top and bottom):
            return Calculation(name, (), "", float(quantity.answer(self._motions).value), "")
        turning = all(isinstance(half, Rotation) and half.word != "theta" for half in quantity.halves)
        note = self.reading.say("centres.same" if top * bottom > 0 else "centres.opposite") if turning else ""
        return Calculation(name, (), Operand(top) / Operand(bottom), top / bottom, "", note)

    # --- places ---------------------------------------------------------------------------------

    def _place(self, quantity: Centre) -> str:
        centred = self.goal.centred
        assert centred is not None, quantity
        return centred.place(quantity)

    def _point(self, quantity: Track) -> str:
        """`(34.5, −20)`, in mm."""
        place = complex(self._motions.position[quantity.site.point])
        noise, read = self.reading.noise * 1000, self.reading.measured
        x, y = (number(read(value) * 1000, noise) for value in (place.real, place.imag))
        return f"({x}, {y})"

    # --- signs ----------------------------------------------------------------------------------

    def _sense(self, value: float) -> str:
        return self.reading.say("common.ccw" if value > 0 else "common.cw") if value else ""

