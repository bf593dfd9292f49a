"""How each instant centre was found, one sentence a centre."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from math import degrees
from typing import assert_never

import numpy as np

from graphkin.centres import Centres
from graphkin.construction import Ray
from graphkin.construction.centring import CentreStep, Far, Join, Kennedy, Pole, Seat, direction_of, place_of
from graphkin.errors import Lang
from graphkin.mechanism import FRAME, Mechanism
from graphkin.value import frozen
from graphkin.words import names
from graphkin.words.centre_phrases import told
from graphkin.words.entries import Entry, Heading, Sentence
from graphkin.words.figures import number

__all__ = ["CentreReader"]


@frozen
class CentreReader:
    """Instant centres at one position, about to be worded."""

    found: Centres
    lang: Lang

    @property
    def mechanism(self) -> Mechanism:
        return self.found.method.mechanism

    def say(self, key: str, **words: object) -> str:
        return told(key, self.lang, **words)

    def link(self, link: str) -> str:
        """What people call a link."""
        return names.point(self.mechanism.called(link))

    def centre(self, centre: str) -> str:
        return names.point(centre)

    def is_far(self, centre: str) -> bool:
        return not bool(np.isfinite(place_of(self.found.plot, centre)))

    def angle(self, centre: str) -> str:
        """The direction of a centre at infinity, from 0 to 180 degrees."""
        turned = round(degrees(float(direction_of(self.found.plot, centre))), 6) % 180
        return f"{number(turned)}°"

    @cached_property
    def noise(self) -> float:
        """Lengths below this are rounding noise [m]."""
        return 1e-9 * max(abs(complex(place)) for place in (*self.found.plot.position.values(), 1e-300))

    def place(self, centre: str) -> str:
        if self.is_far(centre):
            return self.say("infinite", angle=self.angle(centre))
        at = complex(place_of(self.found.plot, centre))
        x, y = (number(1000 * v, 1000 * self.noise) for v in (at.real, at.imag))
        return self.say("mm", x=x, y=y)

    # --- sentences ------------------------------------------------------------------------------

    def entries(self) -> Iterator[Entry]:
        """How many there are, those by definition, then the others in the order in which they are found."""
        count, steps = len(self.mechanism.links), self.found.centring.steps
        yield Heading(self.say("finding"))
        yield Sentence(self.say("count", n=count, less=count - 1, count=len(self.found.pairs)))
        direct = [step for step in steps if isinstance(step, Seat | Far)]
        others = [step for step in steps if not isinstance(step, Seat | Far)]
        for head, group in (("definition", direct), ("kennedy", others)):
            if group:
                yield Sentence(self.say(head))
            yield from (Sentence("  " + self.sentence(step)) for step in group)
        for pair in self.found.centring.together:
            yield Sentence("  " + self.say("together", name=self.centre(self.found.name(*pair)), **self._links(pair)))

    def sentence(self, step: CentreStep) -> str:
        """How one centre is found."""
        name, links = self.centre(step.centre), self._links(self.found.centring.links[step.centre])
        match step:
            case Seat(contact=None):
                point, place = names.point(step.point), self.place(step.centre)
                return self.say("hinge", name=name, point=point, place=place, **links)
            case Seat():
                return self.say("rolling", name=name, place=self.place(step.centre), **links)
            case Far():
                return self.say("slide", name=name, angle=self.angle(step.centre), **links)
            case Kennedy():
                lines = {"first": self._line(step, step.first), "second": self._line(step, step.second)}
                return self.say("two lines", name=name, met=self._met(step), **lines)
            case Pole():
                place = self.place(step.centre)
                return self.say("pole", name=name, reason=self._reason(), place=place, **links)
            case _:
                assert_never(step)

    def _links(self, pair: tuple[str, str]) -> dict[str, str]:
        return {"first": self.link(pair[0]), "second": self.link(pair[1])}

    def _line(self, step: Kennedy, line: Join | Ray) -> str:
        """A line on which a centre lies, and why it does."""
        if isinstance(line, Ray):
            return self._normal(step, line)
        links = self._three(line)
        ends = [line.first, line.second]
        far = [end for end in ends if self.is_far(end)]
        if not far:
            between = " " if any("," in end for end in ends) else ""
            return self.say("join", line=between.join(self.centre(end) for end in ends), links=links)
        if len(far) == 2:
            return self.say("at infinity", first=self.centre(ends[0]), second=self.centre(ends[1]), links=links)
        near = next(end for end in ends if end not in far)
        by_definition = any(isinstance(s, Far) and s.centre == far[0] for s in self.found.centring.steps)
        words = {"near": self.centre(near), "far": self.centre(far[0]), "links": links}
        return self.say("across guide" if by_definition else "parallel", angle=self.angle(far[0]), **words)

    def _normal(self, step: Kennedy, line: Ray) -> str:
        pair = self.found.centring.links[step.centre]
        if any({*cam.links} == {*pair} for cam in self.mechanism.cams):
            return self.say("normal", **self._links(pair))
        return self.say("slot", point=names.point(line.through), **self._links(pair))

    def _three(self, line: Join) -> str:
        """The three links whose centres lie on a line: `1, 2, 3`."""
        both = (*self.found.centring.links[line.first], *self.found.centring.links[line.second])
        order = {link: k for k, link in enumerate(dict.fromkeys(x for pair in self.found.pairs for x in pair))}
        between = "、" if self.lang == "zh" else ", "
        return between.join(self.link(link) for link in sorted({*both}, key=lambda link: order[link]))

    def _met(self, step: Kennedy) -> str:
        if not self.is_far(step.centre):
            return self.say("met", place=self.place(step.centre))
        ends = [(line.first, line.second) for line in (step.first, step.second) if isinstance(line, Join)]
        at_infinity = any(self.is_far(first) and self.is_far(second) for first, second in ends)
        key = "met infinity" if at_infinity else "met far"
        return self.say(key, name=self.centre(step.centre), angle=self.angle(step.centre))

    def _reason(self) -> str:
        """Why the lines do not suffice."""
        count = len(self.mechanism.drivers)
        return self.say("several freedoms", count=count) if count > 1 else self.say("lines coincide")

    # --- for those who use the centres ----------------------------------------------------------

    def absolute(self, link: str) -> str:
        """The name of a link's absolute centre."""
        return self.found.name(FRAME, link)
