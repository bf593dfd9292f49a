"""Higher pairs before anything is drawn: what replaces them (高副低代), and where their lines run."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from itertools import combinations
from typing import assert_never

from graphkin.base.geometry import dot
from graphkin.construction import Step, kinds, terms
from graphkin.model.mechanism import FRAME
from graphkin.model.pairs import Cam, CircularSlot, Gear, Line, Pair, Rod, RollingContact, Slot, rod_name
from graphkin.say import names
from graphkin.say.entry import Calculation, Entry, Sentence
from graphkin.say.figures import figures
from graphkin.say.numbers import degrees, given_figure, heading, number
from graphkin.say.reading import Reading, aside, capitalized


def equivalents(reading: Reading) -> Iterator[Entry]:
    """Each cam by its lower pairs, each rolling wheel by what its centre does."""
    for kind, entries in EQUIVALENTS.items():
        for pair in reading.mechanism.of(kind):
            yield from entries(reading, pair)


def _cam(reading: Reading, cam: Cam) -> Iterator[Entry]:
    match cam.equivalent:
        case Rod() as rod:
            (one, other), ((_, _, radius), (_, _, more)) = map(names.point, rod.points), cam.circles
            length = f"{names.pair(*rod.points)} = {number(1000 * rod.length)} mm"
            length = _distance(rod.points, (radius, more), cam.internal) if radius and more else length
            one, other = (one, other) if radius else (other, one)
            words = {"first": one, "second": other, "length": length, "link": names.point(rod_name(cam))}
            yield Sentence(reading.say("contacts.circles touch", which=not (radius and more), **words))
        case Slot() as slot:
            words = {"centre": names.point(slot.point), "face": _face(reading, slot.line)}
            words["link"] = reading.link(slot.line.link)
            if slot.offset:
                size = abs(slot.offset)
                length = f"{reading.circle(slot.point, size)} = {given_figure(size * 1000)} mm"
                yield Sentence(reading.say("contacts.flat touches", length=length, **words))
            else:
                yield Sentence(reading.say("contacts.edge touches", **words))
            if cam.name in reading.contact_slides:
                yield from _path(reading, cam.name)


def _circular_slot(reading: Reading, slot: CircularSlot) -> Iterator[Entry]:
    centre, pin = names.point(slot.centre), names.point(slot.point)
    length = f"{names.pair(slot.centre, slot.point)} = {number(1000 * slot.radius)} mm"
    words = {"guide": reading.link(slot.guide), "link": names.point(rod_name(slot)), "length": length}
    yield Sentence(reading.say("contacts.pin in arc", centre=centre, pin=pin, **words))


def _rolling(reading: Reading, roll: RollingContact) -> Iterator[Entry]:
    words = {"wheel": reading.link(roll.wheel)}
    if roll.line is not None:
        words |= {"face": _face(reading, roll.line), "link": reading.link(roll.line.link)}
        words |= {"centre": names.point(roll.centre)}
        words["length"] = f"{reading.radius(roll.wheel, roll.radius)} = {given_figure(roll.radius * 1000)} mm"
        free = roll.name in reading.contact_slides  # not held by a sliding pair
        yield Sentence(reading.say("contacts.wheel on line" if free else "contacts.wheel held at line", **words))
        if free:
            yield from _path(reading, roll.name)
    elif rod_name(roll) in reading.method.structure.bodies:
        assert roll.track_centre is not None
        first, second = centres = (roll.track_centre, roll.centre)
        words |= {"first": names.point(first), "second": names.point(second), "link": names.point(rod_name(roll))}
        length = _distance(centres, (roll.track_radius, roll.radius), roll.internal)
        yield Sentence(reading.say("contacts.wheel on circle", length=length, **words))


def _line_of_centres(reading: Reading, gear: Gear) -> Iterator[Entry]:
    if rod_name(gear) in reading.method.structure.bodies:
        words = {"wheels": reading.links(gear.links), "link": names.point(rod_name(gear))}
        length = _distance(gear.centres, gear.radii, gear.internal)
        yield Sentence(reading.say("contacts.line of centres", length=length, **words))


EQUIVALENTS: Mapping[type[Pair], Callable[..., Iterator[Entry]]] = {
    Cam: _cam, CircularSlot: _circular_slot, RollingContact: _rolling, Gear: _line_of_centres,
}  # fmt: skip
"""The entries of each kind that has a lower-pair equivalent, in this order."""


def _distance(centres: tuple[str, str], radii: tuple[float, float], internal: bool) -> str:
    """`O1O2 = 35 + 18 = 53 mm`; of circles that touch inside, the difference of the radii."""
    first, second = sorted((1000 * radius for radius in radii), reverse=True) if internal else [1000 * r for r in radii]
    one, other = figures(first, second)
    numbers, length = (one - other, first - second) if internal else (one + other, first + second)
    return Calculation(names.pair(*centres), (), numbers, length, "mm").text


def _face(reading: Reading, line: Line) -> str:
    """Two points of a moving line where such are named."""
    ends = points_of(reading, line)
    return f" {names.pair(*ends)}" if ends else ""


def points_of(reading: Reading, line: Line) -> tuple[str, str] | None:
    """Two named points of a moving line, in its direction."""
    link, points = reading.mechanism.links[line.link], reading.mechanism.named(line.link)
    if line.link == FRAME:
        return None
    on_it = [p for p in points if aside(line.direction, link.arm(line.origin, p)) <= reading.noise]
    for first, second in combinations(sorted(on_it, key=lambda p: p != line.origin), 2):
        ahead = float(dot(line.direction, link.arm(first, second)))
        if abs(ahead) > reading.noise:
            return (first, second) if ahead > 0 else (second, first)
    return None


def _path(reading: Reading, name: str) -> Iterator[Entry]:
    """The path of a centre, if it stands still; else the point at which it starts, if that is needed."""
    slide, (line,) = reading.method.structure.slides[name], reading.mechanism.pair(name).lines
    origin, path = slide.line.origin, reading.path(name)
    if slide.guide == FRAME:
        place = reading.place_on_paper(reading.plot.facts.shapes[FRAME][origin])
        words = {"path": capitalized(path), "place": place}
        words["heading"] = heading(degrees(slide.line.direction), reading.lang)
        yield Sentence(reading.say("contacts.fixed path", **words))
    elif origin != line.origin and any(_uses(step, origin) for step in reading.method.position.steps):
        words = {"path": path, "mark": names.point(origin)}
        if line.named:
            length = f"{names.pair(line.origin, origin)} = {reading.rim(reading.mechanism.pair(name))}"
            yield Sentence(reading.say("contacts.foot", origin=names.point(line.origin), length=length, **words))
        else:
            yield Sentence(reading.say("contacts.marked start", **words))


def _uses(step: Step, origin: str) -> bool:
    """True of a step that starts from a point or draws it, other than as a mere further point of its link."""
    match step:
        case kinds.LayOff():
            return origin in (step.start, step.tip)
        case kinds.Meet(first, second, point):
            through = [locus.through for locus in (first, second) if isinstance(locus, kinds.Ray)]
            return origin in (point, *through)
        case kinds.Image():
            return origin in step.base
        case kinds.Fit(closures=closures):
            arms = [part for closure in closures for part in closure.parts if isinstance(part, terms.Arm)]
            return any(origin in (arm.tail, arm.head) for arm in arms)
        case kinds.Measure() | kinds.Given() | kinds.Ray() | kinds.Arc() | kinds.Touch():
            return False
        case kinds.Swing() | kinds.Roll() | kinds.Simultaneous():
            return False
        case _:
            assert_never(step)
