"""The drawing of the mechanism itself, in words: arcs, tangents, guides, and what is measured in it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from math import degrees as in_degrees
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
from graphkin.pairs import Slot
from graphkin.planning.position import touching
from graphkin.say import names
from graphkin.say.crossings import crossing
from graphkin.say.entry import Calculation, Entry, Heading, Sentence
from graphkin.say.equivalents import equivalents
from graphkin.say.guide_angle import guide_angle
from graphkin.say.numbers import degrees, number
from graphkin.say.reading import Reading
from graphkin.say.rolling import rolled, touched
from graphkin.say.together import fitted, special_point


@dataclass
class PositionReader:
    """Reads the steps of the position plane in the order of the pencil.

    angles   links whose angles are asked for, None for all
    used     pairs of points whose distance the polygons need; those that nothing gives are measured at the end
    special  the reading whose special points are told, where the mechanism is drawn by another method
    drawn    points that are there by now
    waiting  links whose angles can be measured as soon as their points are there
    swung    the last tangent drawn: its link, and the slide whose line it is
    arcs     by link, the further points that a found reach passes over
    """

    reading: Reading
    used: tuple[tuple[str, str], ...] = ()
    angles: frozenset[str] | None = None
    special: Reading | None = None
    drawn: set[str] = field(default_factory=set)
    waiting: list[str] = field(default_factory=list)
    swung: dict[str, Swing] = field(default_factory=dict)
    reached: dict[str, str] = field(default_factory=dict)
    measured: set[frozenset[str]] = field(default_factory=set)
    told: set[str] = field(default_factory=set)
    ends: dict[str, tuple[str, str]] = field(default_factory=dict)

    def entries(self) -> Iterator[Entry]:
        construction = self.reading.method.position
        yield Heading(self.reading.say("derivation.plane position"))
        yield from self._fixed()
        yield from equivalents(self.reading)
        for part in construction.parts:
            for step in part.steps if isinstance(part, Equation) else (part,):
                yield from self._step(step)
                self.drawn |= _made(step)
                yield from self._angles()
        yield from self._angles(True)
        yield from self._specials()
        yield from self._used()

    def _specials(self) -> Iterator[Entry]:
        """The special points of a method whose mechanism is drawn by another one."""
        if self.special is None or self.special is self.reading:
            return
        steps = (step for step in self.special.method.position.steps if isinstance(step, Meet))
        for step in steps:
            if step.point in self.special.method.special:
                yield Sentence(special_point(self.special, step))

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
                self.swung[step.link] = step
                yield Sentence(self._swing(step))
                self.waiting.append(step.link)
                if self.reading.method.structure.slides[step.slide].named:
                    yield from self._slide(step.slide)
            case Image(link, corners, _, point):
                if self.reading.named(point):  # the start of a line that has no name is told where it is needed
                    yield Sentence(self._corner(link, corners))
            case Measure("theta", of):
                self.waiting.append(of)
                self.ends |= dict.fromkeys((of, *self.reading.group(of)), (step.tail, step.head))
                if step.span is not None and len(step.span.parts) > 1:
                    self.reached |= dict.fromkeys((of, *self.reading.group(of)), step.head)
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
        numbers = f"{number(metres)}/{number(scale)}"
        chain = (name, f"{symbol}/μ_l") if name else (f"{symbol}/μ_l",)
        return Calculation(chain[0], chain[1:], numbers, metres / scale, "mm").text

    def _reach(self, span: Span, name: str = "") -> str:
        """A radius or a stretch: an arm, a displacement, or several of them end to end."""
        first, last = span.parts[0], span.parts[-1]
        metres = float(abs(self.reading.plot.span(span)))
        if len(span.parts) == 1 and not isinstance(first, Arm):
            pair = self.reading.method.structure.slides[first.slide]
            symbol = self._displacement(first.slide)
            if not pair.named and pair.line.named:
                ends = names.pair(pair.line.origin, pair.point)
                return self._length(name or ends, f"l_{ends}", metres)
            return self._length(name, f"|{symbol}|" if self.reading.plot.s[first.slide] < 0 else symbol, metres)
        tail = first.tail if isinstance(first, Arm) else self._ends(first.slide, first.sign)[0]
        head = last.head if isinstance(last, Arm) else self._ends(last.slide, last.sign)[1]
        text = self._length(name or names.pair(tail, head), f"l_{names.pair(tail, head)}", metres)
        if len(span.parts) > 1:
            self.measured.add(frozenset((tail, head)))
            text += self.reading.say("common.note", note=self._composed(span))
        return text

    def _composed(self, span: Span) -> str:
        """What a reach is made of: arms and displacements at known angles."""
        found = []
        for part in span.parts:
            if isinstance(part, Arm):
                found.append(f"l_{names.pair(part.tail, part.head)}")
            else:
                found.append(self._displacement(part.slide))
        return self.reading.say("derivation.composed", parts=self.reading.listed(found))

    def _displacement(self, slide: str) -> str:
        pair = self.reading.method.structure.slides[slide]
        return names.of_slide("s", slide if pair.named else names.point(pair.point))

    def _ends(self, slide: str, sign: int) -> tuple[str, str]:
        pair = self.reading.method.structure.slides[slide]
        ends = (pair.line.origin, pair.point)
        return ends if sign > 0 else ends[::-1]

    # --- steps ----------------------------------------------------------------------------------

    def _lay_off(self, step: LayOff) -> str:
        reading, points = self.reading, self.reading.plot.position
        assert isinstance(step.term.size, Span)
        if (text := self._beside_guide(step)) or (text := self._over_reach(step)):
            return text
        arrow = points[step.tip] - points[step.start]
        if isinstance(step.term.direction, AlongGuide) and abs(arrow) <= reading.noise:
            arrow = reading.plot.guide_direction(step.term.direction.slide)
        angle = degrees(arrow)
        aside = "*" in step.start + step.tip
        length = self._reach(step.term.size, names.stretch(step.start, step.tip) if aside else "")
        words = {"start": reading.place(step.start), "tip": reading.place(step.tip), "length": length, "angle": angle}
        if isinstance(step.term.direction, AlongGuide):
            guide = self.reading.path(step.term.direction.slide)
            return reading.say("derivation.lay off slide", guide=guide, **words)
        if line := self._drawn_line(step):
            return reading.say("derivation.lay off on line", line=line, **words)
        return reading.say("derivation.lay off link", **words)

    def _drawn_line(self, step: LayOff) -> str:
        """Two points that are drawn, on whose line an arm of their link lies; "" of others."""
        reading, part = self.reading, step.term.size.parts[0] if isinstance(step.term.size, Span) else None
        tail, head = self.ends.get(part.link, ("", "")) if isinstance(part, Arm) else ("", "")
        if not tail or not reading.named(tail) or not reading.named(head) or not {tail, head} <= self.drawn:
            return ""
        line, arm = reading.plot.arm(tail, head), reading.plot.arm(step.start, step.tip)
        return names.pair(tail, head) if abs(cross(line, arm)) <= reading.noise * abs(arm) else ""

    def _beside_guide(self, step: LayOff) -> str:
        """A further point of a link whose guide line has just been drawn, by how it lies to that line; "" of others."""
        reading, part = self.reading, step.term.size.parts[0] if isinstance(step.term.size, Span) else None
        if not isinstance(part, Arm) or part.link not in self.swung:
            return ""
        swing = self.swung[part.link]
        along, arm = reading.plot.guide_direction(swing.slide), reading.plot.arm(step.start, step.tip)
        words = {"start": reading.place(step.start), "tip": reading.place(step.tip),
                 "length": self._arm(step.start, step.tip)}  # fmt: skip
        if abs(cross(along, reading.plot.arm(swing.through, step.tip))) <= reading.noise:
            return self._on_tangent(step, swing)
        turned = float(np.angle(arm / along * np.sign(dot(along, arm) or 1.0)))
        if abs(cross(along, arm)) <= reading.noise:
            return reading.say("derivation.lay off parallel", angle=degrees(arm), **words)
        sense = reading.say("common.ccw" if turned > 0 else "common.cw")
        words["turned"] = f"{number(abs(in_degrees(turned)))}°"
        return reading.say("derivation.lay off turned", sense=sense, **words)

    def _on_tangent(self, step: LayOff, swing: Swing) -> str:
        """A point of the guide line itself: how far from the foot, and which way."""
        reading = self.reading
        foot, at_pivot = self._foot(swing), self._distance_of(swing) <= reading.noise
        length = reading.distance(step.start, step.tip)
        words = {"start": reading.place(step.start), "tip": reading.place(step.tip),
                 "length": self._arm(step.start, step.tip)}  # fmt: skip
        if abs(reading.plot.position[step.tip] - foot) <= reading.noise or not length:
            return reading.say("derivation.at the foot", **words)
        ahead = float(dot(reading.plot.position[swing.through] - foot, reading.plot.position[step.tip] - foot))
        key = "derivation.on tangent" if ahead > 0 else "derivation.on tangent beyond"
        named = reading.place(swing.pivot) if at_pivot else self._foot_name
        return reading.say(key, foot=named, through=reading.place(swing.through), **words)

    def _foot(self, swing: Swing) -> complex:
        """Where the guide line is nearest to the pivot."""
        plot = self.reading.plot
        along, arm = complex(plot.guide_direction(swing.slide)), complex(plot.arm(swing.pivot, swing.through))
        return complex(plot.position[swing.through] - dot(along, arm) * along)

    @property
    def _foot_name(self) -> str:
        """T, or the next letter that no point of the mechanism takes."""
        return next(letter for letter in ("T", "U", "V", "Z", "T′") if letter not in self.reading.mechanism.owners)

    def _over_reach(self, step: LayOff) -> str:
        """A point between the ends of a reach made of several arms: by arcs about both ends; "" of others."""
        reading, part = self.reading, step.term.size.parts[0] if isinstance(step.term.size, Span) else None
        end = self.reached.get(part.link, "") if isinstance(part, Arm) else ""
        owners = reading.mechanism.owners
        if not end or end == step.tip or not {*owners.get(end, ())} & {*owners.get(step.tip, ())}:
            return ""
        points = (step.start, step.tip, end)
        side = float(cross(reading.plot.arm(step.start, step.tip), reading.plot.arm(step.start, end)))
        return reading.say(
            "derivation.over reach", point=names.point(step.tip), way=reading.way_round(points, side > 0),
            first=_sentence_start(self._circle(step.start, self._arm(step.start, step.tip))),
            second=self._circle(end, self._arm(step.tip, end)),
        )  # fmt: skip

    def _circle(self, about: str, length: str) -> str:
        return self.reading.say("derivation.circle", about=self.reading.place(about), length=length)

    def _meet(self, step: Meet) -> str:
        reading, circles = self.reading, isinstance(step.second, Arc)
        words = {"first": _sentence_start(self._locus(step.first)), "second": self._locus(step.second)}
        point = names.point(step.point)
        if not circles:
            return reading.say("derivation.meet lines", point=point, **words)
        where = crossing(reading, step)
        note = reading.say("common.note", note=where) if where else ""
        return reading.say("derivation.meet circles", point=point, where=note, **words)

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
        arm = reading.plot.arm(step.pivot, step.through)
        offset = self._distance_of(step)
        words = {"pivot": reading.place(step.pivot), "through": reading.place(step.through),
                 "link": reading.link(step.link)}  # fmt: skip
        if offset <= reading.noise:
            return reading.say("derivation.swing join", **words)
        foot = self._foot_name
        way = names.point(step.pivot), foot, names.point(step.through)
        sense = reading.say("common.ccw" if float(cross(along, arm)) * float(dot(along, arm)) > 0 else "common.cw")
        which = reading.say("common.way round", way="→".join(way), sense=sense)
        length = self._distance(step, offset)
        if abs(dot(along, arm)) <= reading.noise:
            return reading.say("derivation.swing foot", length=length, foot=foot, **words)
        return reading.say("derivation.swing tangent", length=length, foot=foot, which=which, **words)

    def _distance_of(self, step: Swing) -> float:
        """How far the guide line passes from the pivot [m]."""
        plot = self.reading.plot
        return float(abs(cross(plot.guide_direction(step.slide), plot.arm(step.pivot, step.through))))

    def _distance(self, step: Swing, offset: float) -> str:
        """`h = l_CD sin γ = 0.048 × sin 100° = 0.04727 m`, and on paper; `h = r1 = 0.02 m` beside a face."""
        reading = self.reading
        pair = reading.method.structure.slides[step.slide]
        angle = None if pair.stands_for is not None else guide_angle(reading, pair)
        formula, figures = "", ""
        if angle is not None and angle.corner == step.pivot:
            formula = angle.distance
            length, turned = reading.distance(angle.corner, angle.through), abs(in_degrees(angle.angle))
            figures = f"{number(length)} × sin {number(turned)}°"
        slot = None if pair.stands_for is None else pair.stands_for.equivalent
        if isinstance(slot, Slot) and abs(offset - abs(slot.offset)) <= reading.noise:
            formula = "r"
        chain = Calculation("h", (formula,) if formula else (), figures, offset, "m").text
        return f"{chain}{reading.say('derivation.on paper', length=self._length('', 'h', offset))}"

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
        ccw = float(cross(reading.plot.arm(first, second), reading.plot.arm(first, third))) > 0
        words = {"first": lengths[0], "second": lengths[1], "way": reading.way_round(corners, ccw)}
        return reading.say("derivation.shape corner", point=point, link=called, **words)

    def _arm(self, tail: str, head: str) -> str:
        pair = names.pair(tail, head)
        return self._length(pair, f"l_{pair}", self.reading.distance(tail, head))

    # --- measured -------------------------------------------------------------------------------

    def _angles(self, last: bool = False) -> Iterator[Entry]:
        """Directions of links, and of those that keep their angles to them, once their first two points are there.

        last  nothing more is drawn
        """
        reading, found, waiting = self.reading, list[str](), list[str]()
        for link in self.waiting:
            for member in (reading.body(link), *reading.group(link)):
                named = reading.method.structure.named(member)
                if len(named) > 1 and not last and not {*named[:2]} <= self.drawn:
                    waiting.append(member)
                elif len(named) > 1 and not self._knows(member):
                    angle = degrees(reading.plot.arm(named[0], named[1]))
                    name, arrow = reading.rate("θ", member), names.arrow(named[0], named[1])
                    found.append(reading.say("derivation.angle of", name=name, angle=angle, arrow=arrow))
        self.waiting = waiting
        if found:
            angles = reading.say("common.and").join(dict.fromkeys(found))
            yield Sentence(reading.say("derivation.measured angles", angles=angles))

    def _knows(self, link: str) -> bool:
        """Whether an angle is told already, or nobody asks for it."""
        told = link in self.told or (self.angles is not None and link not in self.angles)
        self.told.add(link)
        return told

    def _slide(self, slide: str) -> Iterator[Entry]:
        """The displacement by its name, or as the distance of two points, or as where its point has come to lie."""
        reading = self.reading
        pair = reading.method.structure.slides[slide]
        origin, point = pair.line.origin, pair.point
        if slide in reading.contact_slides and pair.guide != FRAME:
            return
        if pair.named:
            along = dot(reading.plot.guide_direction(slide), reading.plot.arm(origin, point))
            name = names.of_slide("s", slide)
            text = self._ruler(name, "", float(along))
        elif pair.line.named:
            self.measured.add(frozenset((origin, point)))
            line = names.pair(origin, point)
            text = self._ruler(f"l_{line}", line, reading.distance(origin, point))
        else:
            return  # where it has come to lie is all there is of it
        yield Sentence(reading.say("derivation.measured slide", length=text))

    def _ruler(self, name: str, line: str, metres: float) -> str:
        """`BC = 58.87 mm, so l_BC = μ_l·BC = 0.001 × 58.87 = 0.05887 m`."""
        reading, scale = self.reading, self.reading.scales["length"]
        metres = metres if abs(metres) > reading.noise else 0.0
        paper = Calculation(line or f"{name}/μ_l", (), "", metres / scale, "mm").text
        formula = (f"μ_l·{line}",) if line else ()
        figures = f"{number(scale)} × {_bracketed(number(metres / scale))}"
        return reading.say("derivation.ruled", paper=paper, real=Calculation(name, formula, figures, metres, "m").text)

    def _used(self) -> Iterator[Entry]:
        """The distances that the polygons divide by and that no link gives."""
        reading, found = self.reading, list[str]()
        for first, second in self.used:
            pair = frozenset((first, second))
            if pair in self.measured or self._given(first, second):
                continue
            self.measured.add(pair)
            line = names.pair(first, second)
            found.append(self._ruler(f"l_{line}", line, self._apart(first, second)))
        if found:
            yield Sentence(reading.say("derivation.measured used", lengths=reading.say("common.semicolon").join(found)))

    def _apart(self, first: str, second: str) -> float:
        return (self.special or self.reading).distance(first, second)

    def _given(self, first: str, second: str) -> bool:
        """Whether one link, or a contact, holds two points apart."""
        links = self.reading.mechanism.links.values()
        contact = {letter for letter, _ in touching(self.reading.method.structure)}
        apart = any(first in link.points and second in link.points for link in links)
        rods = self.reading.method.structure.bodies.values()
        return apart or bool({first, second} & contact) or any(first in rod and second in rod for rod in rods)


def _sentence_start(text: str) -> str:
    return text[0].upper() + text[1:]


def _bracketed(figure: str) -> str:
    return f"({figure})" if figure.startswith("−") else figure


def _made(step: Step) -> set[str]:
    """The points a step draws."""
    match step:
        case Given(point) | LayOff(tip=point) | Meet(point=point) | Image(point=point) | Touch(point=point):
            return {point}
        case Ray() | Arc() | Swing() | Measure() | Roll() | Fit() | Simultaneous():
            return set()
        case _:
            assert_never(step)
