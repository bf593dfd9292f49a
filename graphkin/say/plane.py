"""One polygon as its readers see it: arrows measured with the ruler, their names, and the rows of an equation."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property
from typing import assert_never

from graphkin.base.geometry import Real
from graphkin.base.value import frozen
from graphkin.construction import Construction, Direction, Equation, Plane, Size, Step, Term, kinds, terms
from graphkin.model.mechanism import FRAME
from graphkin.say import names
from graphkin.say.entry import Calculation, Sentence
from graphkin.say.figures import Formula, Operand, squared
from graphkin.say.reading import Reading


@frozen
class PolygonReading:
    """The velocity or the acceleration polygon of a reading; `shown`: those of its parts that are told, if not all."""

    reading: Reading
    plane: Plane
    shown: tuple[Step | Equation, ...] | None = None

    @property
    def construction(self) -> Construction:
        return self.reading.method.construction(self.plane)

    @property
    def parts(self) -> tuple[Step | Equation, ...]:
        """The parts that are told."""
        return self.construction.parts if self.shown is None else self.shown

    @property
    def scale(self) -> float:
        """SI units that one millimetre stands for."""
        return self.reading.scales[self.plane]

    def sentence(self, step: Step, text: str, row: str = "") -> Sentence:
        """The sentence of an act of the pencil, with its number."""
        return Sentence(text, self.reading.act(self.plane, step), row)

    @cached_property
    def noise(self) -> float:
        """Arrows up to this are none [SI]."""
        return self.reading.usual.least("m/s" if self.plane == "velocity" else "m/s^2")

    def arrow(self, tail: str, head: str) -> complex:
        """An arrow of the finished polygon [SI]; exactly 0 where it is but rounding noise."""
        points = self.reading.plot.points(self.plane)
        arrow = complex(points[head] - points[tail])
        return arrow if abs(arrow) > self.noise else 0j

    def size(self, tail: str, head: str) -> float:
        return abs(self.arrow(tail, head))

    def read(self, tail: str, head: str) -> float:
        """The size of an arrow as the ruler reads it [SI]."""
        ruler, exactly = self.reading.ruler, self.size(tail, head)
        return float(ruler.arrow(self.reading.plot, self.plane, tail, head).real) if ruler and exactly else exactly

    def length_mm(self, tail: str, head: str) -> float:
        return self.read(tail, head) / self.scale

    def heading(self, tail: str, head: str) -> str:
        return self.reading.heading(self.arrow(tail, head))

    @cached_property
    def _names(self) -> dict[tuple[str, str], str]:
        """The arrows of the equations by their ends."""
        laid = [part.term for part in self.parts if isinstance(part, kinds.LayOff)]
        equations = (part.left + part.right for part in self.parts if isinstance(part, Equation))
        arrows = [*laid, *(term for equation in equations for term in equation)]
        return {(term.tail, term.head): term.name(self.plane) for term in arrows}

    def written(self, tail: str, head: str) -> bool:
        """True where an equation, or a known arrow, has these ends."""
        return (tail, head) in self._names

    def name(self, tail: str, head: str) -> str:
        """`v_CB` of the arrow from b to c, as the equations call it or would."""
        if (tail, head) in self._names:
            return names.vector(self._names[tail, head])
        return self.seen(self.of(head), "" if tail == self.construction.pole else self.of(tail))

    def of(self, node: str) -> str:
        """The site of a polygon's point: `B3` of b3."""
        return self.construction.nodes[node].of

    def seen(self, of: str, seen_from: str, part: str = "") -> str:
        """`aᵏ_B3B2` from its parts."""
        return self.vector(Term(of, seen_from, part, None, None, "", ""))

    def vector(self, term: Term) -> str:
        """The name of a term in this plane."""
        return names.vector(term.name(self.plane))

    def rate(self, link: str) -> str:
        """`ω3` in the velocity plane, `α3` in the acceleration plane."""
        return self.reading.rate(names.RATE[self.plane], link)

    @property
    def rate_unit(self) -> str:
        return "rad/s" if self.plane == "velocity" else "rad/s²"

    @cached_property
    def laid_off(self) -> dict[str, Term]:
        """Known absolute motions that are laid off by themselves, by the point at their tip."""
        return {part.tip: part.term for part in self.parts if isinstance(part, kinds.LayOff)}

    @cached_property
    def first_lever(self) -> kinds.Measure | None:
        """The first rotation that is told."""
        return next((step for step in self.parts if isinstance(step, kinds.Measure) and step.lever[0]), None)

    def direction(self, direction: Direction, among: tuple[Term, ...] = ()) -> str:
        """`⊥BD`, `∥BC`, `B→A`; a Coriolis term stands across its relative motion, one of the terms `among`."""
        match direction:
            case terms.Along(tail, head):
                return names.arrow(tail, head)
            case terms.Across(tail, head):
                return "⊥" + names.pair(tail, head)
            case terms.AlongGuide(slide):
                return "∥" + self.reading.line(slide)
            case terms.AcrossGuide(slide):
                return "⊥" + self.reading.line(slide)
            case terms.Quarter():
                # across the line of the slide; for a driven rotation along its lever
                for term in among:
                    if term.part == "r" and isinstance(term.direction, terms.AlongGuide):
                        return "⊥" + self.reading.line(term.direction.slide)
                    if term.part == "rt" and isinstance(term.direction, terms.Across):
                        return "∥" + names.pair(term.direction.tail, term.direction.head)
                return "⊥" + PolygonReading(self.reading, "velocity").name(direction.tail, direction.head)
            case _:
                assert_never(direction)

    def line_direction(self, direction: Direction, among: tuple[Term, ...] = ()) -> str:
        """The same of an arrow that may point either way."""
        if isinstance(direction, terms.Along):
            return "∥" + names.pair(direction.tail, direction.head)
        return self.direction(direction, among)

    def direction_row(self, term: Term, equation: tuple[Term, ...]) -> str:
        """The entry of a term in the row of directions."""
        if isinstance(term.size, terms.Drawn):
            known = self.laid_off.get(term.head)
            return self.direction(known.direction) if known and known.direction else "√"
        if term.direction is None:
            return "?"
        relatives = tuple(t for t in equation if (t.of, t.seen_from) == (term.of, term.seen_from))
        if term.size is None:
            return self.line_direction(term.direction, relatives)
        return self.direction(term.direction, relatives)

    def measured(self, tail: str, head: str, name: str = "", note: str = "") -> Calculation:
        """`v_B3 = μ_v·pb3 = 0.01 × 27.12 = 0.2712 m/s`."""
        ends, mu = names.stretch(tail, head), names.SCALE[self.plane]
        numbers = Operand(self.scale) * Operand(self.length_mm(tail, head))
        unit, size = names.UNIT[self.plane], self.read(tail, head)
        return Calculation(name or self.name(tail, head), (f"{mu}·{ends}",), numbers, size, unit, note if size else "")

    def laid(self, name: str, tail: str, head: str, ends: tuple[str, str] | None = None) -> str:
        """`pb2 = v_B2/μ_v = 0.24/0.01 = 24 mm`; `ends`: drawn elsewhere than where it belongs."""
        size, mu = self.size(tail, head), names.SCALE[self.plane]
        numbers = Operand(size) / Operand(self.scale)
        written = names.stretch(*(ends or (tail, head)))
        length = Calculation(written, (f"{name}/{mu}",), numbers, size / self.scale, "mm").text
        return length + self.reading.too_short(size / self.scale)

    def measured_absolute(self, node: str) -> Calculation:
        """The motion of a point, with its direction to +x."""
        pole = self.construction.pole
        return self.measured(pole, node, self.seen(self.of(node), ""), self.heading(pole, node))


@frozen
class KnownSize:
    """A size as a formula, with its figures in it, and the direction of its arrow in words."""

    formula: str
    numbers: Formula | str
    direction: str


def size_row(polygon: PolygonReading, term: Term) -> str:
    """The entry of a term in the row of sizes: `?`, `√`, `0` at rest, or the formula."""
    if term.size is None:
        return "?"
    if isinstance(term.size, terms.Drawn):
        return "√" if polygon.arrow(term.tail, term.head) else "0"
    return _known_size(polygon, term, term.size, "").formula or "√"


def size_calculation(polygon: PolygonReading, term: Term, equation: tuple[Term, ...]) -> Calculation:
    """`aⁿ_B3D = ω3² l_BD = 3.919² × 0.0692 = 1.063 m/s²` of a term that is neither unknown nor drawn yet."""
    assert term.size is not None
    known = _known_size(polygon, term, term.size, polygon.direction_row(term, equation))
    value, heading = polygon.size(term.tail, term.head), polygon.heading(term.tail, term.head)
    note = polygon.reading.say("derivation.towards", direction=known.direction, heading=heading) if value else ""
    if not value and isinstance(term.size, terms.Coriolis):
        velocity, rate = PolygonReading(polygon.reading, "velocity"), polygon.reading.rate("ω", term.size.link)
        if velocity.size(term.size.tail, term.size.head):
            note = polygon.reading.say("derivation.no rate", rate=rate)
        else:
            note = polygon.reading.say("derivation.no rate", rate=velocity.seen(term.of, term.seen_from))
    size, formulas = term.size, list[str]()
    if isinstance(size, terms.Turning | terms.Normal) and not term.seen_from:
        # `v_B2 = v_B1`: the hinge is a point of the driven link too; `a_B = aⁿ_BA`: without a tangential part
        if term.of != size.head and (other := polygon.reading.numbered(size.head, size.link)) != term.of:
            formulas.append(polygon.seen(other, ""))
        if isinstance(size, terms.Normal) and not term.part:
            formulas.append(polygon.seen(term.of, size.tail, "n"))
    formulas += [known.formula] if known.formula else []
    return Calculation(polygon.vector(term), tuple(formulas), known.numbers, value, names.UNIT[polygon.plane], note)


def _known_size(polygon: PolygonReading, term: Term, size: Size, direction: str) -> KnownSize:
    reading, plot = polygon.reading, polygon.reading.plot
    match size:
        case terms.Turning(link, tail, head) | terms.Normal(link, tail, head):
            power = 2 if isinstance(size, terms.Normal) else 1
            return _at_arm(polygon, reading.rate("ω", link), plot.omega[link], power, (tail, head), direction)
        case terms.Tangential(link, tail, head):
            return _at_arm(polygon, reading.rate("α", link), plot.alpha[link], 1, (tail, head), direction)
        case terms.Coriolis(link, tail, head):
            rate, velocity = reading.rate("ω", link), PolygonReading(reading, "velocity")
            relative = velocity.seen(term.of, term.seen_from)
            numbers = Operand(2) * Operand(abs(float(plot.omega[link]))) * Operand(velocity.read(tail, head))
            words = {"relative": relative, "rate": rate, "direction": direction}
            return KnownSize(f"2 {rate} {relative}", numbers, reading.say("derivation.quarter turned", **words))
        case terms.Driven(slide) if (rim := _rim(polygon, slide)) is not None:
            return replace(rim, direction=direction)
        case terms.Driven(slide):
            shrinks = (polygon.arrow(term.tail, term.head) * reading.guide(slide).conjugate()).real <= 0
            if reading.method.structure.slides[slide].named:
                words = {"direction": direction, "s": names.of_slide("s", slide)}
                direction = reading.say("derivation.slide way", which=shrinks, **words)
            rate = reading.slid(names.SLIDING[polygon.plane], slide)
            own = rate == polygon.vector(term)  # given by this very name
            return KnownSize("" if own else f"|{rate}|", "", direction)
        case terms.Relative():
            facts, called = plot.facts, reading.mechanism.called  # of one link against another: ω21 l, ω21² l, α21 l
            order, symbol = (2, "α") if size.part == "t" else (1, "ω")
            value = facts.relative_rate(size.link, order) - facts.relative_rate(size.seen_from, order)
            rate = names.relative(symbol, called(reading.body(size.link)), called(reading.body(size.seen_from)))
            return _at_arm(polygon, rate, value, 2 if size.part == "n" else 1, (size.tail, size.head), direction)
        case terms.Drawn() | terms.Span():
            raise AssertionError("drawn arrows and lengths have no formula in a polygon")
        case _:
            assert_never(size)


def _rim(polygon: PolygonReading, slide: str) -> KnownSize | None:
    """`r3 ω3` of the centre of a wheel that rolls on the frame and is turned, or of the rack that such a wheel moves;
    None of any other slide."""
    reading, structure = polygon.reading, polygon.reading.method.structure
    for contact in structure.contacts if slide not in structure.slides_driven else ():
        wheel, radius = contact.wheels[1], abs(contact.radii[1])
        track, alone = contact.wheels[0], {*dict(contact.way)} or {contact.slide}
        if alone == {slide} and (track == FRAME or reading.translates(track)):
            numbers = Operand(radius) * Operand(abs(reading.turning(wheel, polygon.plane)))
            return KnownSize(f"{reading.radius(wheel, radius)} {polygon.rate(wheel)}", numbers, "")
    return None


def _at_arm(
    polygon: PolygonReading, rate: str, value: Real, power: int, ends: tuple[str, str], direction: str
) -> KnownSize:
    """`ω3 l_BD` in the sense of the rotation, `ω3² l_BD` of power 2."""
    arm = Operand(polygon.reading.distance(*ends))
    if power == 2:
        return KnownSize(f"{rate}² l_{names.pair(*ends)}", squared(abs(float(value))) * arm, direction)
    direction = polygon.reading.say("derivation.sense of", direction=direction, rate=rate)
    return KnownSize(f"{rate} l_{names.pair(*ends)}", Operand(abs(float(value))) * arm, direction)
