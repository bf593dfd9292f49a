"""A problem drawn at the scales of its handout; its solution in sections: given, asked, the planes, the answers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cached_property

from graphkin.api import Drawing, plan
from graphkin.base.value import frozen
from graphkin.construction import Construction, Plane
from graphkin.errors import Lang
from graphkin.homework.grading.keys import paper_scales
from graphkin.model.mechanism import Mechanism
from graphkin.model.quantities import read
from graphkin.planning.drawn_position import shown
from graphkin.running import replay_all
from graphkin.running.drawn_sides import drawn_sides
from graphkin.say import entry
from graphkin.say.explained import derivation
from graphkin.say.problems import posed_entries
from graphkin.say.reading import Reading
from graphkin.say.solution_goal import SolutionGoal, solution_goal
from graphkin.sheet.paper import KEYS

ROOM = complex(160.0, 120.0)  # of any polygon that is drawn as large as a handout draws it [mm]


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
        sections: list[tuple[entry.Heading, list[entry.Entry]]] = []
        drawing = self.drawing
        for each in derivation(drawing.method, drawing.plot, self._keys, self.lang, everything=False):
            if isinstance(each, entry.Heading):
                sections.append((each, []))
            else:
                sections[-1][1].append(each)
        return tuple(Section(heading.text, tuple(entries), heading.plane) for heading, entries in sections)

    @property
    def _keys(self) -> dict[str, float]:
        return {KEYS[plane]: scale for plane, scale in self.scales.items()}

    def construction(self, plane: Plane) -> Construction:
        """The construction of a polygon."""
        return self.drawing.method.velocity if plane == "velocity" else self.drawing.method.acceleration

    @cached_property
    def goal(self) -> SolutionGoal:
        """The goal: quantities that are asked for, in the symbols of the field."""
        return solution_goal(Reading(*shown(self.drawing.method, self.drawing.plot), self._keys, self.lang))

    @property
    def posed(self) -> list[entry.Entry]:
        """The data and the question; of a student's own problem with all that its figure shows."""
        drawn = drawn_sides(self.drawing.method, self.drawing.plot) if self.whose else None
        return [*posed_entries(self.asked, drawn)]

    @cached_property
    def asked(self) -> SolutionGoal:
        """The goal; of a student's own problem just what the file asks, though it be no motion."""
        mechanism = self.drawing.mechanism
        if not (self.whose and mechanism.ask):
            return self.goal
        wanted = tuple(read(mechanism, text) for text in mechanism.ask)
        return replace(self.goal, wanted=wanted, texts=mechanism.ask, chosen=True)

    @property
    def title(self) -> str:
        return " · ".join(filter(None, (self.drawing.mechanism.headline(self.lang), self.whose)))

    @property
    def head(self) -> tuple[Section, ...]:
        """The sections before the first plane: given, asked, the scales."""
        return self._sections[1:4]

    @property
    def parts(self) -> tuple[Section, ...]:
        """The mechanism, its instant centres where they are asked for, then the polygons that are drawn."""
        return self._sections[4:-1]

    @property
    def polygons(self) -> tuple[Plane, ...]:
        return tuple(self.goal.parts)

    @property
    def answers(self) -> Section:
        return self._sections[-1]

    def upto(self, equations: int) -> Iterator[tuple[Section, entry.VectorEquation | None]]:
        """The parts as far as whole equations and what is said of their arrows go, the last with the next equation."""
        seen = 0
        for section in self.parts:
            for k, each in enumerate(section.entries):
                if isinstance(each, entry.VectorEquation):
                    if seen == equations:
                        yield replace(section, entries=section.entries[:k]), each
                        return
                    seen += 1
            yield section, None


def drawn_problem(mechanism: Mechanism, lang: Lang, whose: str = "") -> HandoutProblem:
    """A mechanism drawn and proved at the scales of its handout, which are those that its key is made for."""
    drawing = Drawing.of(mechanism)
    keyed = paper_scales(drawing.method, drawing.plot)
    scaled = replace(mechanism, scales=keyed)
    method = plan(scaled)
    scales = {plane: keyed[key] for plane, key in KEYS.items()}
    return HandoutProblem(Drawing(scaled, method, replay_all(method)), scales, lang, whose)
