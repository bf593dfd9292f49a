"""Known sizes in words: `aⁿ_B3D = ω3² l_BD = 3.919² × 0.0692 = 1.063 m/s²`."""

from __future__ import annotations

from typing import assert_never

from graphkin.base.value import frozen
from graphkin.construction import Coriolis, Drawn, Driven, Normal, Relative, Size, Span, Tangential, Term, Turning
from graphkin.say import names
from graphkin.say.entry import Calculation
from graphkin.say.figures import Formula, Operand, squared
from graphkin.say.plane import PolygonReading


@frozen
class Sized:
    """A size as a formula, with its figures in it, and the way its arrow points."""

    formula: str
    numbers: Formula | str
    way: str


def size_row(polygon: PolygonReading, term: Term) -> str:
    """What the row of sizes says of a term: `?`, `√`, `0` at rest, or the formula."""
    if term.size is None:
        return "?"
    if isinstance(term.size, Drawn):
        return "√" if polygon.arrow(term.tail, term.head) else "0"
    return _sized(polygon, term, term.size, "").formula


def known_size(polygon: PolygonReading, term: Term, equation: tuple[Term, ...]) -> Calculation:
    """The size of a term that is neither unknown nor drawn yet, and where it points."""
    assert term.size is not None
    sized = _sized(polygon, term, term.size, polygon.direction_row(term, equation))
    value = polygon.size(term.tail, term.head)
    angle = polygon.angle(term.tail, term.head)
    note = polygon.reading.say("derivation.at angle", direction=sized.way, angle=angle)
    note = note if value else _why_none(polygon, term)
    formulas = (*_other_names(polygon, term), sized.formula)
    name = names.vector(term.name(polygon.plane))
    return Calculation(name, formulas, sized.numbers, value, names.UNIT[polygon.plane], note)


def _why_none(polygon: PolygonReading, term: Term) -> str:
    """Why there is no Coriolis acceleration; "" of other terms."""
    if not isinstance(term.size, Coriolis):
        return ""
    reading, velocity = polygon.reading, PolygonReading(polygon.reading, "velocity")
    if not velocity.size(term.size.tail, term.size.head):
        return reading.say("derivation.no sliding", relative=velocity.seen(term.of, term.seen_from))
    return reading.say("derivation.no turning", rate=reading.rate("ω", term.size.link))


def _other_names(polygon: PolygonReading, term: Term) -> tuple[str, ...]:
    """`v_B2 = v_B1`: the hinge is a point of the driven link too; `a_B = aⁿ_BA`: without a tangential part."""
    size = term.size
    if not isinstance(size, Turning | Normal) or term.seen_from:
        return ()
    found = []
    if term.of != size.head:
        other = polygon.reading.numbered(size.head, size.link)
        if other != term.of:
            found.append(polygon.seen(other, ""))
    if isinstance(size, Normal) and not term.part:
        found.append(polygon.seen(term.of, size.tail, "n"))
    return tuple(found)


def _sized(polygon: PolygonReading, term: Term, size: Size, direction: str) -> Sized:
    reading, plot = polygon.reading, polygon.reading.plot
    match size:
        case Turning(link, tail, head):
            rate = reading.rate("ω", link)
            return _times(polygon, rate, plot.omega[link], (tail, head), direction)
        case Tangential(link, tail, head):
            rate = reading.rate("α", link)
            return _times(polygon, rate, plot.alpha[link], (tail, head), direction)
        case Normal(link, tail, head):
            rate = reading.rate("ω", link)
            return _squared(polygon, rate, plot.omega[link], (tail, head), direction)
        case Coriolis():
            return _coriolis(polygon, term, size, direction)
        case Driven():
            return _driven(polygon, term, size, direction)
        case Relative():
            return _relative(polygon, size, direction)
        case Drawn() | Span():
            raise AssertionError("drawn arrows and lengths have no formula in a polygon")
        case _:
            assert_never(size)


def _times(polygon: PolygonReading, rate: str, value: float, ends: tuple[str, str], direction: str) -> Sized:
    length = Operand(polygon.reading.distance(*ends))
    way = polygon.reading.say("derivation.sense of", direction=direction, rate=rate)
    return Sized(f"{rate} l_{names.pair(*ends)}", Operand(abs(value)) * length, way)


def _squared(polygon: PolygonReading, rate: str, value: float, ends: tuple[str, str], direction: str) -> Sized:
    length = Operand(polygon.reading.distance(*ends))
    return Sized(f"{rate}² l_{names.pair(*ends)}", squared(abs(value)) * length, direction)


def _coriolis(polygon: PolygonReading, term: Term, size: Coriolis, direction: str) -> Sized:
    reading = polygon.reading
    rate, velocity = reading.rate("ω", size.link), PolygonReading(reading, "velocity")
    relative = velocity.seen(term.of, term.seen_from)
    omega = Operand(abs(reading.plot.omega[size.link]))
    numbers = Operand(2) * omega * Operand(velocity.read(size.tail, size.head))
    way = reading.say("derivation.quarter turned", relative=relative, rate=rate, direction=direction)
    return Sized(f"2 {rate} {relative}", numbers, way)


def _driven(polygon: PolygonReading, term: Term, size: Driven, direction: str) -> Sized:
    """The size of the driven speed itself, and whether the arrow points the way s counts."""
    reading = polygon.reading
    arrow = polygon.arrow(term.tail, term.head)
    along = complex(reading.plot.guide_direction(size.slide))
    grows = (arrow * along.conjugate()).real > 0
    s = names.of_slide("s", size.slide)
    way = reading.say("derivation.slide grows" if grows else "derivation.slide shrinks", direction=direction, s=s)
    return Sized(f"|{names.of_slide(names.SLIDING[polygon.plane], size.slide)}|", "", way)


def _relative(polygon: PolygonReading, size: Relative, direction: str) -> Sized:
    """A driven rotation of one link against another: ω21 l, ω21² l, α21 l."""
    reading, facts = polygon.reading, polygon.reading.plot.facts
    order, symbol = (2, "α") if size.part == "t" else (1, "ω")
    value = float(facts.relative_rate(size.link, order) - facts.relative_rate(size.seen_from, order))
    called = reading.mechanism.called
    rate = names.relative(symbol, called(reading.body(size.link)), called(reading.body(size.seen_from)))
    ends = (size.tail, size.head)
    if size.part == "n":
        return _squared(polygon, rate, value, ends, direction)
    return _times(polygon, rate, value, ends, direction)
