"""The drawing of the mechanism itself, in words: arcs, tangents, guides, and what is measured in it."""

from __future__ import annotations

from cmath import rect
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from itertools import count
from math import degrees as degrees_of
from math import tau
from typing import assert_never

from graphkin.base.geometry import cross, dot
from graphkin.base.tolerances import ROUNDED
from graphkin.construction import Equation, Step, kinds, terms
from graphkin.model.mechanism import FRAME, Driver
from graphkin.planning.method import made
from graphkin.say import names
from graphkin.say.dimensions import link_sizes
from graphkin.say.entry import Entry, Heading, Sentence
from graphkin.say.equivalents import equivalents
from graphkin.say.numbers import degrees, given_figure, heading, inclination, side
from graphkin.say.reading import Reading, aside, capitalized
from graphkin.say.rolling import rolled, touched
from graphkin.say.simultaneous import fitted, link_angle, special_point
from graphkin.say.sizes import DrawnAngle
from graphkin.say.tangents import Tangents

_SPARE = "WXYHJ"  # for points that nobody named


@dataclass
class PositionReader(Tangents):
    """Reads the steps of the position plane in the order of the pencil.

    angles   links whose angles are asked for
    waiting  links whose angles can be measured as soon as their points are there
    measured_links  links whose angles are measured, or said to be driven
    placed   points that are there by now
    reached  corners of reaches of two arms, with their ends
    ends     by link, the two points between which its angle has been found
    """

    angles: frozenset[str] = frozenset()
    waiting: list[str] = field(default_factory=list)
    measured_links: set[str] = field(default_factory=set)
    placed: set[str] = field(default_factory=set)
    reached: dict[str, tuple[str, str]] = field(default_factory=dict)
    ends: dict[str, tuple[str, str]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        driven = (driver.link for _, driver in self._open() if driver.from_link == FRAME)
        self.measured_links.update(driven)

    def entries(self) -> Iterator[Entry]:
        """The part of the solution that draws the mechanism, with letters for the points that have none."""
        taken = {*self.reading.mechanism.points, *self.reading.method.position.nodes, *self._feet.values()}
        free = (mark for k in count() for letter in _SPARE if (mark := letter + "′" * k) not in taken)
        letters = dict[str, str]()
        for entry in self._entries():
            if isinstance(entry, Sentence):
                entry = replace(entry, text=names.lettered(entry.text, letters, free))
            yield entry

    def _entries(self) -> Iterator[Entry]:
        yield Heading(self.reading.say("derivation.plane position"), "position")
        reading, shape = self.reading, self.reading.plot.facts.shapes[FRAME]
        fixed = [f"{names.point(p)}{reading.place_on_paper(shape[p])}" for p in shape if reading.named(p)]
        if fixed:
            yield Sentence(reading.say("derivation.fixed points", points=reading.joined(fixed)))
        for slide in (slide for slide in reading.mechanism.slides if slide.guide == FRAME):
            origin = slide.line.origin
            place = names.point(origin) if slide.line.named else reading.place_on_paper(shape[origin])
            words = {"guide": capitalized(reading.path(slide.name))}
            words["heading"] = inclination(degrees(slide.line.direction), reading.lang)
            yield Sentence(reading.say("derivation.fixed guide", place=place, **words))
        yield from equivalents(reading)
        for part in reading.method.position.parts:
            for step in part.steps if isinstance(part, Equation) else (part,):
                entries = list(self._step(step))
                if entries and isinstance(entries[0], Sentence):  # the first tells what is drawn
                    entries[0] = Sentence(entries[0].text, reading.act("position", step))
                yield from entries
                self.placed |= {*made(step)}
                yield from self._angles()
        yield from self._angles(last=True)
        values = self.moving.plot.facts.values
        arrows = {self._turned(d, float(values[k])): rect(1.0, float(values[k])) for k, d in self._open()}
        if arrows:  # drivers' values, measured where poses stand for them
            yield self._measured_angles(f"{name} = {reading.angle(arrow)}" for name, arrow in arrows.items())
        yield from self._used()

    def _turned(self, driver: Driver, value: float) -> str:
        """`φ1` of a driven line; `θ1` where that is asked for and the same."""
        machine, theta = self.reading.mechanism, self.moving.plot.theta.get(driver.link)
        asked = driver.from_link == FRAME and f"theta {machine.called(driver.link)}" in machine.ask
        same = asked and theta is not None and abs(rect(1.0, value) - rect(1.0, float(theta))) < ROUNDED
        return self.reading.against(driver, "θ" if same else "φ")

    def _step(self, step: Step) -> Iterator[Entry]:
        match step:
            case kinds.Given() | kinds.Ray() | kinds.Arc():
                pass  # fixed points come together at the start, lines and circles where they cross
            case kinds.LayOff():
                yield Sentence(self._lay_off(step))
            case kinds.Meet():
                special = step.point in self.reading.method.special
                yield Sentence(special_point(self.reading, step) if special else self._meet(step))
            case kinds.Swing():
                self.swung |= dict.fromkeys((step.link, *self.reading.group(step.link)), step)
                yield Sentence(self._swing(step))
                self.waiting.append(step.link)
                if self.reading.method.structure.slides[step.slide].named:
                    yield from self._slide(step.slide)
            case kinds.Image(link, corners, _, point):
                # the start of a line that has no name is told where it is needed
                if self.reading.named(point) and point not in self.marked:
                    yield Sentence(self._corner(link, corners))
            case kinds.Measure("theta", of):
                self.waiting.append(of)
                ends = (step.tail, step.head)
                self.ends |= dict.fromkeys((of, *self.reading.group(of)), ends)
                parts = step.span.parts if step.span is not None else ()
                if len(parts) == 2 and isinstance(parts[0], terms.Arm) and isinstance(parts[1], terms.Arm):
                    # the point at which both arms of a reach meet
                    self.reached |= {parts[0].head: ends} if parts[0].head == parts[1].tail else {}
            case kinds.Measure(_, of):
                yield from self._slide(of)
            case kinds.Roll():
                yield from rolled(self.reading, step)
            case kinds.Touch():
                yield Sentence(touched(self.reading, step))
            case kinds.Fit():
                yield from fitted(self.reading, step)
            case kinds.Simultaneous():
                raise AssertionError("positions are fitted")
            case _:
                assert_never(step)

    def _lay_off(self, step: kinds.LayOff) -> str:
        reading = self.reading
        assert isinstance(step.term.size, terms.Span)
        if (text := self._beside_guide(step)) or (text := self._over_reach(step)):
            return text
        arrow, direction = reading.at(step.tip) - reading.at(step.start), step.term.direction
        if isinstance(direction, terms.AlongGuide) and abs(arrow) <= reading.noise:
            arrow = reading.guide(direction.slide)
        nameless = "*" in step.start + step.tip
        length = self._reach(step.term.size, names.stretch(step.start, step.tip) if nameless else "")
        length = length if reading.named(step.start) or not nameless else length.partition(" = ")[2]
        words = {"start": reading.place(step.start), "tip": reading.place(step.tip), "length": length}
        words["heading"] = heading(self._stated(step) or degrees(arrow), reading.lang)
        if isinstance(direction, terms.AlongGuide):
            return reading.say("derivation.lay off slide", guide=reading.path(direction.slide), **words)
        part, line = step.term.size.parts[0], ""  # two points that are drawn, on whose line an arm of their link lies
        tail, head = self.ends.get(part.link, ("", "")) if isinstance(part, terms.Arm) else ("", "")
        if tail and reading.named(tail) and reading.named(head) and {tail, head} <= self.placed:
            off = aside(reading.arm(tail, head), reading.arm(step.start, step.tip))
            line = names.pair(tail, head) if off <= reading.noise * abs(reading.arm(step.start, step.tip)) else ""
        if line:
            return reading.say("derivation.lay off on line", line=line, **words)
        words["heading"] += self._held(part.link, arrow) if isinstance(part, terms.Arm) else ""
        return reading.say("derivation.lay off link", **words) + self._stand_in(step)

    def _held(self, link: str, way: complex) -> str:
        """`, ⊥AD`: how a line of a link lies to one that is drawn, of a link that turns as it does; "" of others."""
        reading = self.reading
        links = reading.group(link) if not reading.translates(link) else ()
        for ends in (reading.method.structure.named(member)[:2] for member in links):
            if len(ends) == 2 and self.placed.issuperset(ends):
                arm = reading.arm(*ends)
                for sign, off in (("∥", aside(arm, way)), ("⊥", aside(1j * arm, way))):
                    if off <= reading.noise * abs(arm) * abs(way):
                        return reading.say("common.and") + sign + names.pair(*ends)
        return ""

    def _stand_in(self, step: kinds.LayOff) -> str:
        """A point that the mechanism has not, in words, as `W is where Q is when N lies at O`: its link is drawn from
        where one of its points may lie; "" of others."""
        start, end = (step.term.head, step.term.tail) if step.backwards else (step.term.tail, step.term.head)
        known = self.reading.named(step.start) and "*" not in start + end
        if not names.auxiliary(step.tip) or not known or start == step.start:
            return ""
        words = {"tip": self.reading.place(step.tip), "start": names.point(step.start)}
        return self.reading.say("derivation.stand-in", point=names.point(end), other=names.point(start), **words)

    def _stated(self, step: kinds.LayOff) -> str:
        """The angle of a driven line as the file states it, where that is not one from 0 to 360 degrees."""
        values = self.reading.plot.facts.values
        for driver, value in zip(self.reading.method.drivers, values, strict=True):
            if driver.vector == (step.start, step.tip) and driver.from_link == FRAME and not 0 <= float(value) < tau:
                return f"{given_figure(degrees_of(float(value)))}°"
        return ""

    def _over_reach(self, step: kinds.LayOff) -> str:
        """A point between the ends of a reach made of several arms: by arcs about both ends; "" of others."""
        reading, ends = self.reading, self.reached.get(step.tip, ("", ""))
        if step.start not in ends:
            return ""
        end = ends[1] if step.start == ends[0] else ends[0]
        ccw = float(cross(reading.arm(step.start, step.tip), reading.arm(step.start, end))) > 0
        first = self._circle(step.start, self._arm(step.start, step.tip))
        words = {"first": capitalized(first), "second": self._circle(end, self._arm(step.tip, end))}
        order = reading.way_round((step.start, step.tip, end), ccw)
        return reading.say("derivation.over reach", point=names.point(step.tip), way=order, **words)

    def _corner(self, link: str, corners: tuple[str, str, str]) -> str:
        """A third point of a link whose two points are drawn."""
        reading = self.reading
        first, second, third = corners
        one, other = reading.arm(first, third), reading.arm(second, third)
        lengths = [self._arm(first, third), self._arm(second, third)]
        words = {"point": names.point(third), "link": reading.link(link)}
        if aside(one, other) <= reading.noise * abs(one):
            line = names.pair(first, second)
            return reading.say("derivation.shape line", line=line, length=reading.joined(lengths), **words)
        ccw = float(cross(reading.arm(first, second), one)) > 0
        for angle in link_sizes(reading, link):
            points = angle.shape.points if isinstance(angle.shape, DrawnAngle) else ()
            if {*points} == {*corners} and points[1] != third:
                words["angle"] = angle.text
                words["way"] = reading.way_round(corners, ccw)
                length = lengths[points[1] == second]
                return reading.say("derivation.shape angle", length=length, **words)
        words |= {"first": lengths[0], "second": lengths[1], "way": reading.way_round(corners, ccw)}
        return reading.say("derivation.shape corner", **words)

    def _meet(self, step: kinds.Meet) -> str:
        reading = self.reading
        arc = step.second if isinstance(step.second, kinds.Arc) else None
        words = {"point": names.point(step.point), "where": reading.note(_crossing(reading, step, arc)) if arc else ""}
        for one, other in ((step.first, step.second), (step.second, step.first)):
            if guide := self._guide(one):
                first = capitalized(self._locus(other))
                return reading.say("derivation.meet guide", first=first, guide=guide, **words)
        words |= {"first": capitalized(self._locus(step.first)), "second": self._locus(step.second)}
        return reading.say("derivation.meet circles" if arc else "derivation.meet lines", **words)

    def _guide(self, locus: kinds.Ray | kinds.Arc) -> str:
        """The fixed guide that a line is, which stands there already."""
        if not (isinstance(locus, kinds.Ray) and isinstance(locus.direction, terms.AlongGuide)):
            return ""
        pair = self.reading.method.structure.slides[locus.direction.slide]
        own = pair.guide == FRAME and pair.line.origin == locus.through
        return self.reading.path(locus.direction.slide) if own else ""

    def _locus(self, locus: kinds.Ray | kinds.Arc) -> str:
        reading = self.reading
        if isinstance(locus, kinds.Arc):
            return self._circle(locus.about, self._reach(locus.reach))
        match locus.direction:
            case terms.AlongGuide(slide):
                pair = reading.method.structure.slides[slide]
                ends = reading.points_along(slide) if pair.guide != FRAME else None
                if ends is not None and {*ends} <= self._before(locus):
                    words = {"through": reading.place(locus.through), "ends": names.pair(*ends)}
                    return reading.say("derivation.line beside", which=int(locus.through in ends), **words)
            case terms.Along() | terms.Across() | terms.AcrossGuide() | terms.Quarter():
                pass
            case _:
                assert_never(locus.direction)
        at = inclination(degrees(complex(reading.plot.direction(locus.direction))), reading.lang)
        return reading.say("derivation.line parallel", through=reading.place(locus.through), direction=at)

    def _before(self, ray: kinds.Ray) -> set[str]:
        """The points that are drawn before a line crosses another."""
        steps = self.reading.method.position.steps
        meets = ((k, step) for k, step in enumerate(steps) if isinstance(step, kinds.Meet))
        crossed = next((k for k, step in meets if ray in (step.first, step.second)), 0)
        return {point for step in steps[:crossed] for point in made(step)}

    def _open(self) -> Iterator[tuple[int, Driver]]:
        """The driven angles that the file leaves to a pose."""
        drivers = enumerate(self.reading.mechanism.drivers)
        return ((k, driver) for k, driver in drivers if driver.kind == "angle" and driver.value is None)

    def _measured_angles(self, angles: Iterable[str]) -> Sentence:
        return Sentence(self.reading.say("derivation.measured values", values=self.reading.joined(angles)))

    def _angles(self, last: bool = False) -> Iterator[Entry]:
        """Directions of links, and of those that turn with them, once their two points are there; `last`: of all."""
        reading, angles, waiting = self.reading, list[str](), list[str]()
        members = (member for link in self.waiting for member in (reading.body(link), *reading.group(link)))
        for member in dict.fromkeys(members):
            points = reading.method.structure.named(member)
            if len(points) > 1 and not last and not {*points[:2]} <= self.placed:
                waiting.append(member)
            elif len(points) > 1:
                if member not in self.measured_links and member in self.angles:
                    angles.append(link_angle(reading, member, reading.angle))
                self.measured_links.add(member)
        self.waiting = waiting
        if angles:
            yield self._measured_angles(dict.fromkeys(angles))

    def _slide(self, slide: str) -> Iterator[Entry]:
        """The displacement by its name; where its point has come to lie is all there is of another."""
        reading = self.reading
        pair = reading.method.structure.slides[slide]
        if pair.named and not (slide in reading.contact_slides and pair.guide != FRAME):
            along = float(dot(reading.guide(slide), reading.arm(pair.line.origin, pair.point)))
            text = self._ruler(names.of_slide("s", slide), "", reading.measured(along))
            yield Sentence(reading.say("derivation.measured values", values=text))


def _crossing(reading: Reading, step: kinds.Meet, circle: kinds.Arc) -> str:
    """`C above BD` of two circles, `the upper one` of a line and a circle; "" where both crossings are one."""
    here, about = reading.at(step.point), reading.at(circle.about)
    least = max(reading.noise, 1e-6 * abs(here - about))
    if isinstance(step.first, kinds.Ray):
        along = complex(reading.plot.direction(step.first.direction))
        chord = 2 * float(dot(along, here - about)) * along
        return reading.say("derivation.which", which=side(chord)) if abs(chord) > least else ""
    other = reading.at(step.first.about)
    foot = other + float(dot(about - other, here - other)) / abs(about - other) ** 2 * (about - other)
    if abs(here - foot) <= least:
        return ""
    ends = (step.first.about, circle.about)
    line = names.pair(*ends) if all(map(reading.named, ends)) else "–".join(map(reading.place, ends))
    return reading.say("derivation.side", which=side(here - foot), point=names.point(step.point), line=line)
