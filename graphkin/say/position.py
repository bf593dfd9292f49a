"""The drawing of the mechanism itself, in words: arcs, tangents, guides, and what is measured in it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import assert_never

import numpy as np

from graphkin.construction import (
    Across,
    AcrossGuide,
    Along,
    AlongGuide,
    Arc,
    Arm,
    Direction,
    Equation,
    Fit,
    Given,
    Image,
    LayOff,
    Measure,
    Meet,
    Quarter,
    Ray,
    Roll,
    Simultaneous,
    Span,
    Step,
    Swing,
    Touch,
)
from graphkin.geometry import cross, dot
from graphkin.mechanism import FRAME
from graphkin.say import names
from graphkin.say.entry import Calculation, Entry, Heading, Sentence
from graphkin.say.equivalents import equivalents
from graphkin.say.figures import Operand
from graphkin.say.numbers import degrees, number
from graphkin.say.reading import Reading
from graphkin.say.rolling import rolled, touched
from graphkin.say.together import fitted, special_point
from graphkin.value import frozen


@frozen
class PositionReader:
    """Reads the steps of the position plane."""

    reading: Reading

    def entries(self) -> Iterator[Entry]:
        construction = self.reading.method.position
        yield Heading(self.reading.say("derivation.plane position"))
        yield from self._fixed()
        yield from equivalents(self.reading)
        for part in construction.parts:
            for step in part.steps if isinstance(part, Equation) else (part,):
                yield from self._step(step)

    def _step(self, step: Step) -> Iterator[Entry]:
        match step:
            case Given() | Ray() | Arc():
                pass  # fixed points come together at the start, lines and circles where they cross
            case LayOff():
                yield Sentence(self._lay_off(step))
            case Meet():
                special = step.point in self.reading.method.special
                yield Sentence(special_point(self.reading, step) if special else self._meet(step))
            case Swing():
                yield Sentence(self._swing(step))
                yield from self._angles(step.link)
                yield from self._slide(step.slide)
            case Image(link, corners, _, point):
                if self.reading.named(point):  # the start of a line that has no name is told where it is needed
                    yield Sentence(self._corner(link, corners))
            case Measure("theta", of):
                yield from self._angles(of)
            case Measure(_, of):
                yield from self._slide(of)
            case Roll():
                yield from rolled(self.reading, step)
            case Touch():
                yield Sentence(touched(self.reading, step))
            case Fit():
                yield from fitted(self.reading, step)
            case Simultaneous():
                raise AssertionError("positions are fitted")
            case _:
                assert_never(step)

    # --- what stands still ----------------------------------------------------------------------

    def _fixed(self) -> Iterator[Entry]:
        reading = self.reading
        shape = reading.plot.facts.shapes[FRAME]
        fixed = [f"{names.point(p)}{self._paper(shape[p])}" for p in shape if reading.named(p)]
        if fixed:
            yield Sentence(reading.say("derivation.fixed points", points=reading.say("common.and").join(fixed)))
        for slide in reading.mechanism.slides:
            if slide.guide == FRAME:
                origin = slide.line.origin
                place = names.point(origin) if slide.line.named else self._paper(shape[origin])
                guide = self.reading.path(slide.name)
                angle = degrees(slide.line.direction)
                yield Sentence(reading.say("derivation.fixed guide", guide=guide, place=place, angle=angle))

    def _paper(self, place: complex) -> str:
        """Coordinates on paper, in mm."""
        x, y = (self.reading.on_paper(value) for value in (place.real, place.imag))
        return f"({x}, {y})"

    # --- lengths --------------------------------------------------------------------------------

    def _length(self, name: str, symbol: str, metres: float) -> str:
        """`AB = l_AB/μ_l = 0.024/0.001 = 24 mm`."""
        scale = self.reading.scales["length"]
        numbers = Operand(metres) / Operand(scale)
        chain = (name, f"{symbol}/μ_l") if name else (f"{symbol}/μ_l",)
        return Calculation(chain[0], chain[1:], numbers, metres / scale, "mm").text

    def _reach(self, span: Span, name: str = "") -> str:
        """A radius or a stretch: an arm, a displacement, or several of them end to end."""
        first, last = span.parts[0], span.parts[-1]
        metres = float(abs(self.reading.plot.span(span)))
        if len(span.parts) == 1 and not isinstance(first, Arm):
            pair = self.reading.method.structure.slides[first.slide]
            symbol = names.of_slide("s", first.slide if pair.named else names.point(pair.point))
            if not pair.named and pair.line.named:
                ends = names.pair(pair.line.origin, pair.point)
                return self._length(name or ends, f"l_{ends}", metres)
            return self._length(name, f"|{symbol}|" if self.reading.plot.s[first.slide] < 0 else symbol, metres)
        tail = first.tail if isinstance(first, Arm) else self._ends(first.slide, first.sign)[0]
        head = last.head if isinstance(last, Arm) else self._ends(last.slide, last.sign)[1]
        return self._length(name or names.pair(tail, head), f"l_{names.pair(tail, head)}", metres)

    def _ends(self, slide: str, sign: int) -> tuple[str, str]:
        pair = self.reading.method.structure.slides[slide]
        ends = (pair.line.origin, pair.point)
        return ends if sign > 0 else ends[::-1]

    # --- steps ----------------------------------------------------------------------------------

    def _lay_off(self, step: LayOff) -> str:
        reading, points = self.reading, self.reading.plot.position
        assert isinstance(step.term.size, Span)
        arrow = points[step.tip] - points[step.start]
        if isinstance(step.term.direction, AlongGuide) and not np.any(arrow):
            arrow = reading.plot.guide_direction(step.term.direction.slide)
        angle = degrees(arrow)
        aside = "*" in step.start + step.tip
        length = self._reach(step.term.size, names.stretch(step.start, step.tip) if aside else "")
        words = {"start": reading.place(step.start), "tip": reading.place(step.tip), "length": length, "angle": angle}
        if isinstance(step.term.direction, AlongGuide):
            guide = self.reading.path(step.term.direction.slide)
            return reading.say("derivation.lay off slide", guide=guide, **words)
        return reading.say("derivation.lay off link", **words)

    def _meet(self, step: Meet) -> str:
        circles = isinstance(step.first, Arc) or isinstance(step.second, Arc)
        return self.reading.say(
            "derivation.meet circles" if circles else "derivation.meet lines",
            first=_sentence_start(self._locus(step.first)),
            second=self._locus(step.second),
            point=names.point(step.point),
        )

    def _locus(self, locus: Ray | Arc) -> str:
        reading = self.reading
        if isinstance(locus, Arc):
            return reading.say("derivation.circle", about=reading.place(locus.about), length=self._reach(locus.reach))
        match locus.direction:
            case AlongGuide(slide):
                pair = reading.method.structure.slides[slide]
                if pair.guide == FRAME and pair.line.origin == locus.through:
                    return reading.say("derivation.take guide", guide=self.reading.path(slide))
                return self._parallel(locus.through, locus.direction)
            case Along() | Across() | AcrossGuide() | Quarter():
                return self._parallel(locus.through, locus.direction)
            case _:
                assert_never(locus.direction)

    def _parallel(self, through: str, direction: Direction) -> str:
        angle = degrees(self.reading.plot.direction(direction))
        at = self.reading.say("derivation.at direction", angle=angle)
        return self.reading.say("derivation.line parallel", through=self.reading.place(through), direction=at)

    def _swing(self, step: Swing) -> str:
        reading = self.reading
        along = reading.plot.guide_direction(step.slide)
        offset = float(abs(cross(along, reading.plot.arm(step.pivot, step.through))))
        pivot, through = reading.place(step.pivot), reading.place(step.through)
        link = reading.link(step.link)
        if offset <= reading.noise:
            return reading.say("derivation.swing join", link=link, pivot=pivot, through=through)
        length = self._length("r", "h", offset)
        return reading.say("derivation.swing tangent", link=link, pivot=pivot, through=through, length=length)

    def _corner(self, link: str, corners: tuple[str, str, str]) -> str:
        """A third point of a link whose two points are drawn."""
        reading = self.reading
        first, second, third = corners
        one, other = (reading.plot.arm(p, third) for p in (first, second))
        lengths = [self._arm(first, third), self._arm(second, third)]
        point, called = names.point(third), reading.link(link)
        if abs(cross(one, other)) <= reading.noise * abs(one):
            line = names.pair(first, second)
            both = reading.say("common.and").join(lengths)
            return reading.say("derivation.shape line", point=point, link=called, line=line, length=both)
        triangle = "△" + "".join(names.point(p) for p in corners)
        words = {"first": lengths[0], "second": lengths[1], "triangle": triangle}
        return reading.say("derivation.shape corner", point=point, link=called, **words)

    def _arm(self, tail: str, head: str) -> str:
        pair = names.pair(tail, head)
        return self._length(pair, f"l_{pair}", self.reading.distance(tail, head))

    # --- measured -------------------------------------------------------------------------------

    def _angles(self, link: str) -> Iterator[Entry]:
        """Directions of a link, and of those that keep their angle to it, by their first two points."""
        reading, found = self.reading, list[str]()
        for member in (reading.body(link), *reading.group(link)):
            named = reading.method.structure.named(member)
            if len(named) > 1:
                angle = reading.angle(reading.plot.arm(named[0], named[1]))
                name, arrow = reading.rate("θ", member), names.arrow(named[0], named[1])
                found.append(reading.say("derivation.angle of", name=name, angle=angle, arrow=arrow))
        if found:
            angles = reading.say("common.and").join(found)
            yield Sentence(reading.say("derivation.measured angles", angles=angles))

    def _slide(self, slide: str) -> Iterator[Entry]:
        """The displacement by its name, or as the distance of two points, or as where its point has come to lie."""
        reading = self.reading
        pair = reading.method.structure.slides[slide]
        origin, point = pair.line.origin, pair.point
        if slide in reading.contact_slides and pair.guide != FRAME:
            return
        if pair.named:
            along = dot(reading.plot.guide_direction(slide), reading.plot.arm(origin, point))
            read = reading.measured(float(along))
            text = f"{names.of_slide('s', slide)} = {number(read * 1000, reading.noise * 1000)} mm"
        elif pair.line.named:
            text = f"l_{names.pair(origin, point)} = {number(reading.distance(origin, point) * 1000)} mm"
        else:
            text = self._coordinates(point)
        yield Sentence(reading.say("derivation.measured slide", length=text))

    def _coordinates(self, point: str) -> str:
        """`x_C = 103.6 mm, y_C = −20 mm`."""
        reading, name = self.reading, names.point(point)
        place, noise = complex(reading.plot.position[point]), reading.noise * 1000
        x, y = (number(reading.measured(value) * 1000, noise) for value in (place.real, place.imag))
        return reading.say("common.and").join([f"x_{name} = {x} mm", f"y_{name} = {y} mm"])


def _sentence_start(text: str) -> str:
    return text[0].upper() + text[1:]
