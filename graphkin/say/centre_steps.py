"""How each instant centre was found, one sentence a centre."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from math import degrees
from typing import assert_never

import numpy as np

from graphkin.base.value import frozen
from graphkin.construction.drafting import (
    ChosenPoint,
    DraftLayOff,
    DraftMeet,
    DraftTurn,
    Far,
    LineStep,
    MarkOn,
    PointStep,
    Pricked,
    Stage,
    drawn_through,
)
from graphkin.errors import Lang
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.pairs import Cam, CircularSlot, Pair, Slide
from graphkin.say import names
from graphkin.say.catalogue import say
from graphkin.say.entry import Entry, Heading, Sentence
from graphkin.say.numbers import number
from graphkin.studies.centres import Centres
from graphkin.studies.centres.underlay import CommonNormal

NORMALS: Mapping[type[Pair], str] = {Cam: "contact", Slide: "slot", CircularSlot: "circular slot"}
"""What the common normal is the normal of, for each kind of pair that slips."""


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
        """What people call a link."""
        return names.point(self.mechanism.called(link))

    def centre(self, centre: str) -> str:
        return names.point(centre)

    def is_far(self, centre: str) -> bool:
        return not bool(np.isfinite(self.found.board.at(centre)))

    def angle(self, centre: str) -> str:
        """The direction of a centre at infinity, from 0 to 180 degrees."""
        turned = round(degrees(float(self.found.board.direction(centre))), 6) % 180
        return f"{number(turned)}°"

    @cached_property
    def noise(self) -> float:
        """Lengths below this are rounding noise [m]."""
        return self.found.method.mechanism.usual.least("m")

    def place(self, centre: str) -> str:
        if self.is_far(centre):
            return self.say("centres.infinite", angle=self.angle(centre))
        at = complex(self.found.board.at(centre))
        read = float if self._is_given(centre) else self.read
        x, y = (number(1000 * read(v), 1000 * self.noise) for v in (at.real, at.imag))
        return self.say("centres.mm", x=x, y=y)

    def _is_given(self, centre: str) -> bool:
        """Whether it lies in a fixed point, whose place the problem gives."""
        step = self.found.centring.construction.made_by.get(centre)
        owners = self.mechanism.owners.get(step.point, ()) if isinstance(step, Pricked) else ()
        return FRAME in owners

    # --- sentences ------------------------------------------------------------------------------

    def entries(
        self, stages: Sequence[Stage], together: Sequence[tuple[str, str]], number: int = 1
    ) -> Iterator[Entry]:
        """How many there are, those by definition, then the others in the order in which they are found.

        stages, together   the centres that are told, and the pairs of links that have none
        """
        count = len(self.mechanism.links)
        yield Heading(self.say("centres.finding", number=number))
        yield Sentence(self.say("centres.count", n=count, less=count - 1, count=len(self.found.pairs)))
        others = [stage for stage in stages if stage.say in ("two lines", "velocities")]
        direct = [stage for stage in stages if stage not in others]
        for head, group in ((self.say("centres.definition"), direct), (self.say("centres.kennedy"), others)):
            if group:
                yield Sentence(head)
            yield from (Sentence("  " + self.sentence(stage)) for stage in group)
        for pair in together:
            name = self.centre(self.found.name(*pair))
            yield Sentence("  " + self.say("centres.together", name=name, **self._links(pair)))

    def sentence(self, stage: Stage) -> str:
        """How one centre is found."""
        name = stage.last.name
        words = {"name": self.centre(name), "place": self.place(name), "angle": self.angle(name)}
        return self.say(f"centres.found {stage.say}", **words, **self._made(stage))

    def _made(self, stage: Stage) -> dict[str, str]:
        """What its links, its point or its lines are called, by the step that makes a centre."""
        step = stage.last
        assert isinstance(step, PointStep), step
        match step:
            case Pricked():
                links = self._links(self.found.centring.links[step.name])
                return {"point": names.point(step.point), "reason": self._reason(), **links}
            case DraftMeet():
                first, second = (self._line(step, line) for line in stage.lines)
                return {"first": first, "second": second, "met": self._met(stage)}
            case Far() | ChosenPoint() | DraftLayOff() | MarkOn() | DraftTurn():
                return self._links(self.found.centring.links[step.name])
            case _:
                assert_never(step)

    def _links(self, pair: tuple[str, str]) -> dict[str, str]:
        return {"first": self.link(pair[0]), "second": self.link(pair[1])}

    def _line(self, step: DraftMeet, line: LineStep) -> str:
        """A line on which a centre lies, and why it does."""
        if (normal := self.found.centring.normals.get(line.name)) is not None:
            return self._normal(step, normal)
        ends = drawn_through(line)
        links, far = self._three(ends), [end for end in ends if self.is_far(end)]
        if not far:
            between = "" if all(self.centre(end)[1:].isdigit() for end in ends) else " "
            return self.say("centres.join", line=between.join(self.centre(end) for end in ends), links=links)
        if len(far) == 2:
            first, second = (self.centre(end) for end in ends)
            return self.say("centres.at infinity", first=first, second=second, links=links)
        near = next(end for end in ends if end not in far)
        by_definition = isinstance(self.found.centring.construction.made_by[far[0]], Far)
        words = {"near": self.centre(near), "far": self.centre(far[0]), "links": links}
        key = "centres.across guide" if by_definition else "centres.parallel"
        return self.say(key, angle=self.angle(far[0]), **words)

    def _normal(self, step: DraftMeet, normal: CommonNormal) -> str:
        pair = self.found.centring.links[step.name]
        key = f"centres.normal of {NORMALS[type(normal.pair)]}"
        return self.say(key, point=names.point(normal.line.through), **self._links(pair))

    def _three(self, ends: Iterable[str]) -> str:
        """The three links whose centres lie on a line: `1, 2, 3`."""
        both = {link for end in ends for link in self.found.centring.links[end]}
        return self.say("common.list").join(self.link(link) for link in sorted(both, key=self._order.__getitem__))

    @cached_property
    def _order(self) -> dict[str, int]:
        """The place of each link among those that have centres."""
        return {link: k for k, link in enumerate(dict.fromkeys(link for pair in self.found.pairs for link in pair))}

    def _met(self, stage: Stage) -> str:
        centre = stage.last.name
        if not self.is_far(centre):
            return self.say("centres.met", place=self.place(centre))
        joins = [line for line in stage.lines if line.name not in self.found.centring.normals]
        at_infinity = any(all(self.is_far(end) for end in drawn_through(line)) for line in joins)
        key = "centres.met infinity" if at_infinity else "centres.met far"
        return self.say(key, name=self.centre(centre), angle=self.angle(centre))

    def _reason(self) -> str:
        """Why the lines do not suffice."""
        count = len(self.mechanism.drivers)
        return self.say("centres.several freedoms", count=count) if count > 1 else self.say("centres.lines coincide")

    # --- for those who use the centres ----------------------------------------------------------

    def absolute(self, link: str) -> str:
        """The name of a link's absolute centre."""
        return self.found.name(FRAME, link)
