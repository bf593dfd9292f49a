"""Instant centres in words: how each is found, a sentence a centre, as a part of a solution or in a table."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from math import degrees
from typing import assert_never

import numpy as np

from graphkin.base.value import frozen
from graphkin.construction import drafting
from graphkin.construction.drafting import DraftMeet, Far, LineStep, Pricked, Stage, drawn_through
from graphkin.errors import Lang
from graphkin.model.mechanism import FRAME, Driver, Mechanism
from graphkin.model.pairs import Cam, CircularSlot, Pair, Slide
from graphkin.model.quantities import Centre
from graphkin.say import names
from graphkin.say.catalogue import say
from graphkin.say.entry import Entry, Heading, Sentence
from graphkin.say.numbers import coordinates, exact, number, sense
from graphkin.say.reading import Reading
from graphkin.studies.centres import Centres, centres, place
from graphkin.studies.centres.instant_centres import shortest
from graphkin.studies.centres.levers import DrivenEnd, driven_ends, driven_point, given_drivers

NORMALS: Mapping[type[Pair], str] = {Cam: "contact", Slide: "slot", CircularSlot: "circular slot"}
"""The line of which the common normal is the normal, for each kind of pair that slips."""


@frozen
class CentreReader:
    """Instant centres at one position, about to be worded; `read`: how a coordinate [m] is read off the drawing."""

    found: Centres
    lang: Lang
    read: Callable[[float], float] = float

    @property
    def mechanism(self) -> Mechanism:
        return self.found.method.mechanism

    def say(self, key: str, /, **words: object) -> str:
        return say(key, self.lang, **words)

    def link(self, link: str) -> str:
        """The name by which people call a link."""
        return names.point(self.mechanism.called(link))

    @cached_property
    def _far(self) -> set[str]:
        return {name for name, place in self.found.board.places.items() if not np.isfinite(complex(place))}

    @cached_property
    def _order(self) -> dict[str, int]:
        """Links in the order in which their centres are named."""
        return {link: k for k, link in enumerate(dict.fromkeys(link for pair in self.found.pairs for link in pair))}

    def is_far(self, centre: str) -> bool:
        """True of a centre at infinity."""
        return centre in self._far

    def angle(self, centre: str) -> str:
        """The direction of a centre at infinity, from 0 to 180 degrees."""
        turned = round(degrees(float(self.found.board.direction(centre).real)), 6) % 180
        return f"{number(turned)}°"

    def place(self, centre: str) -> str:
        if self.is_far(centre):
            return self.say("centres.infinite", angle=self.angle(centre))
        return self.say("centres.mm", place=self.coordinates(centre))

    def coordinates(self, centre: str) -> str:
        """`(34.5, −20)`: the place of a centre that is not at infinity, in mm."""
        at, noise = complex(self.found.board.at(centre)), self.mechanism.usual.least("m")
        step = self.found.centring.construction.made_by.get(centre)
        owners = self.mechanism.owners.get(step.point, ()) if isinstance(step, Pricked) else ()
        read = float if FRAME in owners else self.read  # the problem gives the places of fixed points
        at = complex(read(at.real), read(at.imag))
        return coordinates(1000 * at, self.lang, 1000 * noise)

    def given(self, driver: Driver) -> str:
        """The given speed of a driver: `v_C = 0.2 m/s`, `ω1 = 10 rad/s (counter-clockwise)`."""
        name = self.driven_rate(driver)
        if driver.kind == "slide":
            signed = driven_point(self.mechanism, driver)[2] != FRAME
            return f"{name} = {number(driver.rate if signed else abs(driver.rate))} m/s"
        return f"{name} = {number(abs(driver.rate))} rad/s{self.say('common.note', note=sense(driver.rate, self.lang))}"

    def driven_rate(self, driver: Driver) -> str:
        """The symbol of a driver's speed: `ω1`, `ω21` of a link that is driven from another, `v_C`, `ṡ_..`."""
        called = self.mechanism.called
        if driver.kind == "slide":
            point, _, guide = driven_point(self.mechanism, driver)
            return f"v_{names.point(point)}" if guide == FRAME else names.of_slide("ṡ", driver.link)
        if driver.from_link != FRAME:
            return names.relative("ω", called(driver.link), called(driver.from_link))
        return names.of_link("ω", called(driver.link))

    def entries(
        self, stages: Sequence[Stage], without: Mapping[tuple[str, str], str], number: int = 1
    ) -> Iterator[Entry]:
        """The number of centres, those by definition, the others in order; `without`: pairs of links that have none.

        An idle roller of which no centre is sought is counted with the link that it turns on."""
        sought = {link for stage in stages for link in self.found.centring.links[stage.last.name]}
        count = len(self.mechanism.links) - len({*self.mechanism.idle} - sought)
        yield Heading(self.say("centres.finding", number=number))
        yield Sentence(self.say("centres.count", n=count, less=count - 1, count=count * (count - 1) // 2))
        others = [stage for stage in stages if stage.say in ("two lines", "velocities")]
        direct = [stage for stage in stages if stage.say not in ("two lines", "velocities")]
        for head, group in ((self.say("centres.definition"), direct), (self.say("centres.kennedy"), others)):
            if group:
                yield Sentence(head)
            yield from (Sentence(self.sentence(stage), item=True) for stage in group)
        for pair in (pair for pair, why in without.items() if why == "together"):
            name = names.point(self.found.name(*pair))
            yield Sentence(self.say("centres.together", name=name, **self._links(pair)), item=True)
        yield from self._undetermined([pair for pair, why in without.items() if why == "undetermined"])

    def _undetermined(self, pairs: Sequence[tuple[str, str]]) -> Iterator[Entry]:
        """Those of idle rollers, which may turn as they like."""
        idle = [link for link in self.found.method.mechanism.idle if any(link in pair for pair in pairs)]
        if idle:
            called, comma = self.mechanism.called, self.say("common.list")
            count = len(self.mechanism.links) - len(idle)
            listed = comma.join(names.point(self.found.name(*pair)) for pair in pairs)
            words = {"links": comma.join(names.point(called(link)) for link in idle), "n": count}
            counts = {"count": count * (count - 1) // 2, "names": listed}
            yield Sentence(self.say("centres.undetermined", **words, **counts), item=True)

    def sentence(self, stage: Stage) -> str:
        """The sentence of one centre, with its links, its point or its lines by the step that makes it."""
        step = stage.last
        assert isinstance(step, drafting.PointStep), step
        words = {"name": names.point(step.name), "place": self.place(step.name), "angle": self.angle(step.name)}
        match step:
            case Pricked():
                count = len(self.mechanism.drivers)  # why the lines do not suffice
                reason = self.say("centres.several freedoms", count=count) if count > 1 else ""
                words |= {"point": names.point(step.point), "reason": reason or self.say("centres.lines coincide")}
                words |= self._links(self.found.centring.links[step.name])
                if stage.say == "velocities":
                    words["how"] = self._velocities_behind(stage)
            case DraftMeet():
                first, second = (self._line(step, line) for line in stage.lines)
                words |= {"first": first, "second": second, "met": self.say("centres.met", place=words["place"])}
                if self.is_far(step.name):
                    joins = [line for line in stage.lines if line.name not in self.found.centring.normals]
                    at_infinity = any(all(self.is_far(end) for end in drawn_through(line)) for line in joins)
                    key = "centres.met infinity" if at_infinity else "centres.met far"
                    words["met"] = self.say(key, name=words["name"], angle=words["angle"])
            case Far() | drafting.ChosenPoint() | drafting.DraftLayOff() | drafting.MarkOn() | drafting.DraftTurn():
                words |= self._links(self.found.centring.links[step.name])
            case _:
                assert_never(step)
        return self.say(f"centres.found {stage.say}", **words)

    def _velocities_behind(self, stage: Stage) -> str:
        """The velocities that give a pole: those of two points of the link that drivers have, else the polygon."""
        pair = self.found.centring.links[stage.last.name]
        known = [one.last.name for one in self.found.centring.stages]
        ends = driven_ends(self.found, pair[1], known[: known.index(stage.last.name)]) if pair[0] == FRAME else []
        if len(ends) < 2:
            rates = self.say("common.list").join(map(self.driven_rate, given_drivers(self.mechanism)))
            return self.say("centres.by polygon", rates=rates)
        first, second = map(self._driven_end, ends[:2])
        return self.say("centres.by two velocities", link=self.link(pair[1]), first=first, second=second)

    def _driven_end(self, end: DrivenEnd) -> str:
        """`v_P13 = ω1 P01P13 = 0.754 m/s`."""
        formula = f"{self.driven_rate(end.driver)} {joined((end.seat, end.centre))}"
        return f"v_{names.point(end.centre)} = {formula} = {number(end.speed)} m/s"

    def _links(self, pair: tuple[str, str]) -> dict[str, str]:
        return {"first": self.link(pair[0]), "second": self.link(pair[1])}

    def _line(self, step: DraftMeet, line: LineStep) -> str:
        """A line on which a centre lies, and why it does."""
        if (normal := self.found.centring.normals.get(line.name)) is not None:
            pair = self.found.centring.links[step.name]
            if isinstance(normal.pair, Cam) and (others := {*pair} - {*normal.pair.links}):
                return self._through_a_roller(normal.pair, *others)
            key = f"centres.normal of {NORMALS[type(normal.pair)]}"
            return self.say(key, point=names.point(normal.line.through), **self._links(pair))
        ends = drawn_through(line)
        three = {link for end in ends for link in self.found.centring.links[end]}
        links = self.say("common.list").join(map(self.link, sorted(three, key=self._order.__getitem__)))
        far = [end for end in ends if self.is_far(end)]
        if not far:
            return self.say("centres.join", line=joined(ends), links=links)
        if len(far) == 2:
            first, second = map(names.point, ends)
            return self.say("centres.at infinity", first=first, second=second, links=links)
        near = next(end for end in ends if end not in far)
        by_definition = isinstance(self.found.centring.construction.made_by[far[0]], Far)
        words = {"near": names.point(near), "far": names.point(far[0]), "links": links}
        key = "centres.across guide" if by_definition else "centres.parallel"
        return self.say(key, angle=self.angle(far[0]), **words)

    def _through_a_roller(self, cam: Cam, *others: str) -> str:
        """The common normal of links that do not touch themselves: rollers do, which are hinged to them."""
        centres = [centre for _, centre, _ in cam.circles if {*others} & {*self.mechanism.owners[centre]}]
        points = self.say("common.list").join(map(names.point, centres))
        links = self.say("common.list").join(map(self.link, sorted(others, key=self._order.__getitem__)))
        return self.say("centres.normal through rollers", points=points, links=links, **self._links(cam.links))


@frozen
class CentrePart:
    """The instant centres asked for, with those they hang on; `without`: pairs of links asked for that have none."""

    reader: CentreReader
    stages: tuple[Stage, ...]
    without: Mapping[tuple[str, str], str]

    @property
    def from_velocities(self) -> bool:
        """True where the velocities have to be there before."""
        return any(stage.say == "velocities" for stage in self.stages)

    def place(self, centre: Centre) -> str:
        """The place of one of them."""
        found = self.reader.found
        if not found.exists(*centre.links):
            pairs = {frozenset(pair): why for pair, why in found.without.items()}
            return self.reader.say(f"centres.by {pairs[frozenset(centre.links)]}")
        return self.reader.place(found.name(*centre.links))

    def figure(self, centre: Centre) -> tuple[str, str]:
        """The same for a table, and its unit: coordinates, or the angle at infinity; words where there is no centre."""
        reader, found = self.reader, self.reader.found
        if not found.exists(*centre.links):
            return self.place(centre), ""
        name = found.name(*centre.links)
        return (reader.angle(name).removesuffix("°"), "°") if reader.is_far(name) else (reader.coordinates(name), "mm")

    def entries(self, number: int) -> Iterator[Entry]:
        """The part of the solution with this number."""
        yield from self.reader.entries(self.stages, self.without, number)


def centre_part(reading: Reading, asked: Sequence[Centre]) -> CentrePart:
    """The centres asked for at the position of a reading; read off the drawing where a ruler reads."""
    found = centres(reading.method, reading.ruler.right if reading.ruler else reading.plot)
    labels = {found.name(*one.links) for one in asked}
    without = {pair: why for pair, why in found.without.items() if found.name(*pair) in labels}
    found = replace(found, centring=shortest(found, labels))
    return CentrePart(CentreReader(found, reading.lang, reading.measured), found.centring.stages, without)


def joined(ends: Sequence[str]) -> str:
    """`P12P14`, `P0,arm P13`: the line between two centres."""
    letters = [names.point(end) for end in ends]
    return ("" if all(letter[1:].isdigit() for letter in letters) else " ").join(letters)


def centre_rows(found: Centres, lang: Lang) -> Iterator[list[str]]:
    """The rows of a table of all centres, the heading first."""
    yield [say(f"centres.column {key}", lang) for key in ("centre", "links", "place", "by")]
    stages = {stage.last.name: stage for stage in found.centring.stages}
    for pair in found.pairs:
        name, links = found.name(*pair), say("common.list", lang).join(map(found.method.mechanism.called, pair))
        by = found.centring.found_by(stages[name]) if name in stages else found.without[pair]
        if isinstance(by, str):
            reason = say(f"centres.by {by}", lang)
        else:
            normal = say("centres.by normal", lang)
            reason = " × ".join(normal if line == ["normal"] else joined(line) for line in by)
        yield [name, links, centre_place(place(found, *pair), lang), reason]


def centre_place(entry: Mapping[str, object], lang: Lang) -> str:
    """`(66.404, 182.442)` in mm, or `at infinity, 90°`."""
    match entry:
        case {"at": [float(x), float(y)]}:
            return coordinates(1000 * complex(x, y), lang, 1e-9, exact)
        case {"direction": float(direction)}:
            return say("centres.place at infinity", lang, angle=exact(round(degrees(direction), 9) % 180))
        case _:
            return "-"
