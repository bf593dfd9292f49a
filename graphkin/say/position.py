"""The drawing of the mechanism itself, in words: arcs, tangents, guides, and what is measured in it."""

from __future__ import annotations

from cmath import rect
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from itertools import count
from typing import assert_never

from graphkin.base.geometry import dot
from graphkin.construction import (
    Arc,
    Arm,
    Equation,
    Fit,
    Given,
    Image,
    LayOff,
    Measure,
    Meet,
    Ray,
    Roll,
    Simultaneous,
    Step,
    Swing,
    Touch,
)
from graphkin.model.mechanism import FRAME, Driver
from graphkin.say import names
from graphkin.say.drawn_points import DrawnPoints
from graphkin.say.entry import Entry, Heading, Sentence
from graphkin.say.equivalents import equivalents
from graphkin.say.numbers import degrees
from graphkin.say.rolling import rolled, touched
from graphkin.say.together import fitted, special_point

_SPARE = "WXYHJ"
"""For points that nobody named."""


@dataclass
class PositionReader(DrawnPoints):
    """Reads the steps of the position plane in the order of the pencil.

    angles   links whose angles are asked for, None for all
    waiting  links whose angles can be measured as soon as their points are there
    told     links whose angles are measured
    """

    angles: frozenset[str] | None = None
    waiting: list[str] = field(default_factory=list)
    told: set[str] = field(default_factory=set)

    def __post_init__(self) -> None:
        self.told |= {driver.link for _, driver in self._open() if driver.from_link == FRAME}  # told as driven

    def entries(self) -> Iterator[Entry]:
        """What is told, with letters for the points that have none."""
        letters, free = dict[str, str](), self._free()
        for entry in self._told():
            text = names.lettered(entry.text, letters, free) if isinstance(entry, Sentence) else ""
            yield replace(entry, text=text) if isinstance(entry, Sentence) else entry

    def _free(self) -> Iterator[str]:
        """Letters that nothing in the drawing has."""
        taken = {*self.reading.mechanism.points, *self.reading.method.position.nodes, self._foot_name}
        return (mark for k in count() for letter in _SPARE if (mark := letter + "′" * k) not in taken)

    def _told(self) -> Iterator[Entry]:
        construction = self.reading.method.position
        yield Heading(self.reading.say("derivation.plane position"), "position")
        yield from self._fixed()
        yield from equivalents(self.reading)
        for part in construction.parts:
            for step in part.steps if isinstance(part, Equation) else (part,):
                entries = list(self._step(step))
                if entries and isinstance(entries[0], Sentence):  # the first tells what is drawn
                    entries[0] = Sentence(entries[0].text, self.reading.act("position", step))
                yield from entries
                self.drawn |= _made(step)
                yield from self._angles()
        yield from self._angles(True)
        yield from self._read_off()
        yield from self._used()

    def _open(self) -> Iterator[tuple[int, Driver]]:
        """The driven angles that the file leaves to a pose."""
        drivers = enumerate(self.reading.mechanism.drivers)
        return ((k, driver) for k, driver in drivers if driver.kind == "angle" and driver.value is None)

    def _read_off(self) -> Iterator[Entry]:
        """Drivers' values, measured where poses stand for them."""
        reading, values = self.reading, self.moving.plot.facts.values
        found = {reading.against(driver, "φ"): reading.angle(rect(1.0, values[k])) for k, driver in self._open()}
        if found:
            angles = reading.say("common.and").join(f"{name} = {angle}" for name, angle in found.items())
            yield Sentence(reading.say("derivation.measured angles", angles=angles))

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
                self.swung |= dict.fromkeys((step.link, *self.reading.group(step.link)), step)
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
                self.reached |= _corner_between(step)
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

    # --- measured -------------------------------------------------------------------------------

    def _angles(self, last: bool = False) -> Iterator[Entry]:
        """Directions of links, and of those that keep their angles to them, once their first two points are there.

        last  nothing more is drawn
        """
        reading, found, waiting = self.reading, list[str](), list[str]()
        members = (member for link in self.waiting for member in (reading.body(link), *reading.group(link)))
        for member in dict.fromkeys(members):
            named = reading.method.structure.named(member)
            if len(named) > 1 and not last and not {*named[:2]} <= self.drawn:
                waiting.append(member)
            elif len(named) > 1 and not self._knows(member):
                angle = reading.angle(reading.plot.arm(named[0], named[1]))
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
            text = self._ruler(name, "", reading.measured(float(along)))
        elif pair.line.named:
            self.measured.add(frozenset((origin, point)))
            line = names.pair(origin, point)
            text = self._ruler(f"l_{line}", line, reading.distance(origin, point))
        else:
            return  # where it has come to lie is all there is of it
        yield Sentence(reading.say("derivation.measured slide", length=text))


def _corner_between(step: Measure) -> dict[str, tuple[str, str]]:
    """The point at which both arms of a reach meet, with the ends of these."""
    parts = step.span.parts if step.span is not None else ()
    if len(parts) != 2 or not (isinstance(parts[0], Arm) and isinstance(parts[1], Arm)):
        return {}
    return {parts[0].head: (step.tail, step.head)} if parts[0].head == parts[1].tail else {}


def _made(step: Step) -> set[str]:
    """The points a step draws."""
    match step:
        case Given(point) | LayOff(tip=point) | Meet(point=point) | Image(point=point) | Touch(point=point):
            return {point}
        case Ray() | Arc() | Swing() | Measure() | Roll() | Fit() | Simultaneous():
            return set()
        case _:
            assert_never(step)
