"""The relation between the motions of two bodies that roll on each other: in names, in figures, solved for one."""

from __future__ import annotations

from collections.abc import Callable
from math import degrees

from graphkin.base.value import frozen
from graphkin.construction import InStep, slide_key
from graphkin.model.mechanism import FRAME
from graphkin.planning.equivalent import Contact
from graphkin.say import names
from graphkin.say.entry import Calculation
from graphkin.say.figures import Formula, Operand
from graphkin.say.plane import PolygonReading
from graphkin.say.reading import Reading


@frozen
class RollingRelation:
    """`r1(ω1 − ω4) + r2(ω2 − ω4) = 0` of two wheels; `r3(ω3 − ω7) + ṡ_C = 0` of one on a line.

    symbol  how the turning of a link is written; value: its size; slid, slid_value: the same of the wheel's path
    radian  by what turnings are multiplied that are not given in radians
    """

    reading: Reading
    contact: Contact
    symbol: Callable[[str], str]
    value: Callable[[str], float]
    slid: str
    slid_value: float
    radian: float = 1.0

    @property
    def text(self) -> str:
        if self.contact.slide:
            (one, other), second = self.contact.wheels, self.radius(1)
            way = "+" if self.contact.on_slide > 0 else "−"
            track = "" if one == FRAME else f" − {self.symbol(one)}"
            turning = f"({self.symbol(other)}{track})" if track else f" {self.symbol(other)}"
            return f"{second}{turning} {way} {self.slid} = 0"
        halves = [self._half(k) for k in self._order]
        still = [link for link in self.contact.wheels if link == FRAME != self.contact.arm]
        noted = "".join(self.reading.say("common.note", note=f"{self.symbol(link)} = 0") for link in still)
        return f"{halves[0]} {self._sign} {halves[1]} = 0{noted}"

    @property
    def figures(self) -> str:
        """The two sides of a pair of wheels in figures, which cancel."""
        one, other = (self._half_in_figures(k) for k in self._order)
        return (one + other if self._sign == "+" else one - other).text()

    @property
    def _order(self) -> tuple[int, int]:
        """The wheel whose radius counts positive first."""
        return (0, 1) if self.contact.radii[0] > 0 else (1, 0)

    @property
    def _sign(self) -> str:
        return "+" if self.contact.radii[0] * self.contact.radii[1] > 0 else "−"

    def _half(self, k: int) -> str:
        """`r1(ω1 − ω4)`, `r1 ω1` about fixed centres."""
        turn, arm = self.symbol(self.contact.wheels[k]), self.contact.arm
        if arm == FRAME:
            return f"{self.radius(k)} {turn}"
        return f"{self.radius(k)}({turn} − {self.symbol(arm)})"

    def _half_in_figures(self, k: int) -> Formula:
        """`0.03 × (10 − 2)`."""
        turn, arm = self._figure(self.contact.wheels[k]), self.contact.arm
        return self._radius(k) * (turn if arm == FRAME else turn - self._figure(arm))

    def _radius(self, k: int) -> Formula:
        return Operand(abs(self.contact.radii[k]))

    def radius(self, k: int) -> str:
        return self.reading.radius(self.contact.wheels[k], abs(self.contact.radii[k]))

    def solved(self, unknown: str, value: float, unit: str, note: str) -> Calculation:
        """The turning of `unknown` from that of the others, with its figures."""
        formula, numbers = self._solution(unknown)
        formulas = (formula,) if formula else ()
        return Calculation(self.symbol(unknown), formulas, numbers, value, unit, note)

    def _solution(self, unknown: str) -> tuple[str, Formula | str]:
        """`ω4 − r1(ω1 − ω4)/r2`, and the same in figures; nothing where more than one turning is unknown."""
        contact = self.contact
        if unknown not in contact.wheels:
            return "", ""
        k = contact.wheels.index(unknown)
        other = contact.wheels[1 - k]
        if contact.slide:
            return self._along(other) if k else ("", "")
        sign = "−" if self._sign == "+" else "+"
        ratio, arm = (self._radius(1 - k), self._radius(k)), contact.arm
        if arm == FRAME:
            start = "−" if sign == "−" else ""
            formula = f"{start}{self.radius(1 - k)} {self.symbol(other)}/{self.radius(k)}"
            turned = ratio[0] * self._figure(other) / ratio[1]
            return formula, -turned if start else turned
        turning = f"{self.radius(1 - k)}({self.symbol(other)} − {self.symbol(arm)})"
        formula = f"{self.symbol(arm)} {sign} {turning}/{self.radius(k)}"
        turned = ratio[0] * (self._figure(other) - self._figure(arm)) / ratio[1]
        return formula, self._figure(arm) - turned if sign == "−" else self._figure(arm) + turned

    def _along(self, track: str) -> tuple[str, Formula]:
        """`ω1 − ṡ_C/r3`, `ṡ_C/r3` of a wheel on a line."""
        sign = "−" if self.contact.on_slide > 0 else "+"
        moved = Operand(self.slid_value)
        turned = (Operand(self.radian) * moved if self.radian != 1.0 else moved) / self._radius(1)
        formula = f"{self.slid}/{self.radius(1)}"
        if track != FRAME:
            start = self._figure(track)
            return f"{self.symbol(track)} {sign} {formula}", start - turned if sign == "−" else start + turned
        return (f"−{formula}", -turned) if sign == "−" else (formula, turned)

    def slid_by(self, slide: str, polygon: PolygonReading) -> tuple[tuple[str, ...], Formula | str]:
        """`ṡ_A − r2(ω2 − ω1)`: one of the displacements that make up a wheel's way, by the others; r ω alone of one."""
        contact, plot, first = self.contact, self.reading.plot, polygon.plane == "velocity"
        ways = dict(contact.way or ((contact.slide, 1.0),))
        if slide not in ways:
            return (), ""
        track, wheel = contact.wheels
        table, own = plot.s_rate if first else plot.s_acceleration, ways[slide]
        terms: list[tuple[float, str, Formula]] = []
        for other, share in ways.items():
            if other != slide:
                moved = Operand(self.reading.usual.motion(float(table[other]), polygon.plane))
                terms.append((-share / own, path_name(self.reading, names.SLIDING[polygon.plane], other), moved))
        turning, turned = self.symbol(wheel), self._figure(wheel)
        if track != FRAME:
            turning, turned = f"({turning} − {self.symbol(track)})", turned - self._figure(track)
        room = "" if track != FRAME else " "
        terms.append((-contact.on_slide / own, f"{self.radius(1)}{room}{turning}", self._radius(1) * turned))
        return (_summed([(sign, name) for sign, name, _ in terms]),), _added([(sign, size) for sign, _, size in terms])

    def _figure(self, link: str) -> Formula:
        return Operand(self.value(link))


def _summed(terms: list[tuple[float, str]]) -> str:
    """`ṡ_A − r2 ω2`, `−r2 ω2`."""
    (sign, name), *more = sorted(terms, key=lambda term: term[0] < 0)
    return ("−" if sign < 0 else "") + name + "".join(f" {'−' if s < 0 else '+'} {other}" for s, other in more)


def _added(terms: list[tuple[float, Formula]]) -> Formula:
    (sign, total), *more = sorted(terms, key=lambda term: term[0] < 0)
    total = -total if sign < 0 else total
    for s, other in more:
        total = total - other if s < 0 else total + other
    return total


def relation_of(polygon: PolygonReading, contact: InStep) -> RollingRelation:
    """The relation between angular velocities, or accelerations."""
    reading, plot = polygon.reading, polygon.reading.plot
    first = polygon.plane == "velocity"
    table, slid = (plot.omega, plot.s_rate) if first else (plot.alpha, plot.s_acceleration)
    usual = reading.usual

    def value(link: str) -> float:
        return float(usual.rate(table[link], polygon.plane))

    symbol = names.SLIDING[polygon.plane]
    moved = usual.motion(float(slid[contact.slide]), polygon.plane) if contact.slide else 0.0
    return RollingRelation(
        reading, contact_of(reading, contact.name), polygon.rate, value,
        _slid(reading, symbol, contact), moved,
    )  # fmt: skip


def _slid(reading: Reading, symbol: str, contact: InStep) -> str:
    """`ṡ_ram`, or `ṡ_C` where only the centre has a name; `(ṡ_C − ṡ_ram)` where it is made up of others."""
    if not contact.slide:
        return ""
    if not contact.way:
        return path_name(reading, symbol, contact.slide)
    (first, share), *more = sorted(contact.way, key=lambda part: part[1] < 0)
    text = ("" if share > 0 else "−") + path_name(reading, symbol, first)
    text += "".join(f" {'+' if share > 0 else '−'} {path_name(reading, symbol, slide)}" for slide, share in more)
    return f"({text})" if more or text.startswith("−") else text


def path_name(reading: Reading, symbol: str, slide: str) -> str:
    """What the way of a slide, or of a wheel's centre, is called: `ṡ_ram`, `Δs_C`."""
    pair = reading.method.structure.slides[slide]
    return names.of_slide(symbol, pair.name if pair.named else names.point(pair.point))


def contact_of(reading: Reading, name: str) -> Contact:
    return next(contact for contact in reading.method.structure.contacts if contact.name == name)


def turned(reading: Reading, contact: InStep) -> RollingRelation:
    """The relation between the turns since the drawn position, in degrees."""
    plot, found = reading.plot, contact_of(reading, contact.name)
    drawn = plot.facts.drawn

    def value(link: str) -> float:
        return degrees(float(reading.usual.cut(plot.theta[link] - drawn.get(link, 0.0), "rad")))

    moved = float(plot.s[found.slide]) - drawn[slide_key(found.slide)] if found.slide else 0.0
    moved = float(reading.usual.cut(moved, "m"))
    slid = _slid(reading, "Δs", contact)
    return RollingRelation(reading, found, lambda link: reading.rate("Δθ", link), value, slid, moved, degrees(1.0))
