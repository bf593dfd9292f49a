"""The solution of a mechanism, cut into what is given, what is asked, the planes, and the answers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cached_property

from graphkin.api import Drawing
from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.errors import Lang
from graphkin.say import entry
from graphkin.say.asked import Asked, asked
from graphkin.say.explained import derivation
from graphkin.say.reading import Reading
from graphkin.sheet.paper import KEYS
from graphkin.sheet.window import PLANES


@frozen
class Section:
    """A heading of the solution with what stands under it; `plane`: what is drawn there."""

    heading: str
    entries: tuple[entry.Entry, ...]
    plane: Plane | None = None


@frozen
class HandoutProblem:
    """One problem at its scales, by plane; `whose`: the student it is for, where it is one's own."""

    drawing: Drawing
    scales: Mapping[Plane, float]
    lang: Lang
    whose: str = ""

    @cached_property
    def _sections(self) -> tuple[Section, ...]:
        found: list[tuple[entry.Heading, list[entry.Entry]]] = []
        drawing = self.drawing
        for each in derivation(drawing.method, drawing.plot, self._keys, self.lang, everything=False):
            if isinstance(each, entry.Heading):
                found.append((each, []))
            else:
                found[-1][1].append(each)
        return tuple(Section(heading.text, tuple(entries), heading.plane) for heading, entries in found)

    @property
    def _keys(self) -> dict[str, float]:
        return {KEYS[plane]: scale for plane, scale in self.scales.items()}

    @cached_property
    def goal(self) -> Asked:
        """What is asked, in the symbols of the field."""
        return asked(Reading(self.drawing.method, self.drawing.plot, self._keys, self.lang))

    @property
    def title(self) -> str:
        return " · ".join(filter(None, (self._sections[0].heading, self.whose)))

    @property
    def given(self) -> Section:
        return self._sections[1]

    @property
    def asked(self) -> Section:
        return self._sections[2]

    @property
    def solution(self) -> Section:
        """What is said before the first plane: the scales."""
        return self._sections[3]

    @property
    def parts(self) -> tuple[Section, ...]:
        """The mechanism, its instant centres where they are asked for, then the polygons that are drawn."""
        return self._sections[4:-1]

    @property
    def polygons(self) -> tuple[Plane, ...]:
        return tuple(part.plane for part in self.parts if part.plane in PLANES[1:])

    @property
    def answers(self) -> Section:
        return self._sections[-1]

    @property
    def equations(self) -> int:
        """How many vector equations the solution has."""
        return sum(isinstance(each, entry.VectorEquation) for section in self.parts for each in section.entries)

    def upto(self, equations: int) -> Iterator[tuple[Section, entry.VectorEquation | None]]:
        """The parts as far as whole equations go, the last with the equation that comes next, if one does.

        What leads to that equation, its known arrows, is told; it stands between it and the one before.
        """
        seen = 0
        for section in self.parts:
            for k, each in enumerate(section.entries):
                if isinstance(each, entry.VectorEquation):
                    if seen == equations:
                        yield replace(section, entries=section.entries[:k]), each
                        return
                    seen += 1
            yield section, None
