"""A problem drawn at the scales of its handout; its solution in sections: given, asked, the planes, the answers.

After it: the results of drawing and analysis beside each other, and the mistakes that move most of them.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property

import numpy as np

from graphkin.analytic import motion
from graphkin.api import Drawing, plan
from graphkin.base import geometry
from graphkin.base.cache import kept
from graphkin.base.value import frozen
from graphkin.construction import Construction, Plane, Plot
from graphkin.errors import GraphkinError, Lang
from graphkin.handouts.document import Block, HandoutHeading, HandoutTable, Paragraph
from graphkin.homework.grading.keys import further_methods, key_drawn, paper_scales
from graphkin.homework.problems.posed import shown_at
from graphkin.marking.consequences import combined
from graphkin.marking.diagnosis import COMMON
from graphkin.marking.key import Key, columns, upright
from graphkin.marking.key_making import make_key
from graphkin.marking.marker import Marker
from graphkin.marking.read_off import ASTRAY
from graphkin.marking.tolerances import untold
from graphkin.marking.weights import shifts
from graphkin.model.mechanism import Mechanism
from graphkin.model.quantities import EDGE, Centre, Rotation, at_position, read
from graphkin.outputs.letters import lettered
from graphkin.planning.drawn_position import shown
from graphkin.planning.needed import cut_to
from graphkin.proof.readings import readings
from graphkin.running import replay_all
from graphkin.running.drawn_sides import drawn_sides
from graphkin.say import entry
from graphkin.say.catalogue import say
from graphkin.say.dimensions import measured_lengths
from graphkin.say.explained import derivation
from graphkin.say.marks import mistake_in_signs
from graphkin.say.names import in_signs
from graphkin.say.numbers import degrees, heading, number
from graphkin.say.problems import posed_entries
from graphkin.say.reading import Reading
from graphkin.say.solution_goal import SolutionGoal, solution_goal
from graphkin.say.tolerances import untold_lines
from graphkin.sheet.lettering import Label, formula, plain
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
    """One problem at its scales, by plane; `whose`: the student it is for, where it is one's own; `before`: so many
    figures stand before it in its handout."""

    drawing: Drawing
    scales: Mapping[Plane, float]
    lang: Lang
    whose: str = ""
    before: int = 0

    def figure(self, number: int) -> str:
        """`Fig. 2`: the name of a figure, by its number in the problem."""
        return say("handouts.figure", self.lang, number=self.before + number)

    @cached_property
    def _sections(self) -> tuple[Section, ...]:
        sections: list[tuple[entry.Heading, list[entry.Entry]]] = []
        told, whole = self.told, self.drawing.method
        for each in derivation(told.method, told.plot, self._keys, self.lang, everything=False, uncut=whole):
            if isinstance(each, entry.Heading):
                sections.append((each, []))
            else:
                sections[-1][1].append(each)
        return tuple(Section(heading.text, tuple(entries), heading.plane) for heading, entries in sections)

    @property
    def _keys(self) -> dict[str, float]:
        return {KEYS[plane]: scale for plane, scale in self.scales.items()}

    @cached_property
    def told(self) -> Drawing:
        """The drawing without the steps that the questions do not need: text and figures number the others alike."""
        return _told(self.drawing)

    def construction(self, plane: Plane) -> Construction:
        """The construction of a polygon."""
        return self.told.method.construction(plane)

    @cached_property
    def posed_at(self) -> tuple[Plot, bool] | None:
        """As `shown_at` has it: the position in which the problem is posed."""
        return shown_at(self.drawing.method, self.drawing.plot)

    @property
    def is_read_off(self) -> bool:
        """True where something that is asked is measured in the mechanism itself."""
        return self.posed_at is None or not self.posed_at[1]

    @property
    def measured(self) -> list[tuple[str, str]]:
        """The distances that the solution measures in the mechanism, as the file gives no link such a length."""
        return measured_lengths(Reading(self.told.method, self.told.plot, self._keys, self.lang))

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
    def points(self) -> tuple[str, ...]:
        """The mechanism's."""
        return self.drawing.mechanism.points

    @property
    def title(self) -> str:
        return " · ".join(filter(None, (self.drawing.mechanism.headline(self.lang), self.whose)))

    @property
    def source(self) -> str:
        """Where it is from, as its sheet says."""
        return self.drawing.mechanism.credit(self.lang)

    @property
    def story(self) -> Sequence[entry.Entry]:
        """The text that stands before what is given."""
        return self._sections[0].entries

    @property
    def head(self) -> tuple[Section, ...]:
        """The sections before the first plane: given, asked, the scales."""
        return self._sections[1:4]

    @property
    def parts(self) -> tuple[Section, ...]:
        """The mechanism, its instant centres where they are asked for, then the polygons that are drawn."""
        return self._sections[4:-1]

    @cached_property
    def numbers(self) -> frozenset[int]:
        """Those of the steps of the polygons that its text tells."""
        sentences = (each for part in self.parts for each in part.entries if isinstance(each, entry.Sentence))
        return frozenset(each.act.number for each in sentences if each.act is not None and each.act.numbered)

    @property
    def polygons(self) -> tuple[Plane, ...]:
        return tuple(self.goal.parts)

    @property
    def answers(self) -> Section:
        return self._sections[-1]

    @property
    def equations(self) -> int:
        """The number of its vector equations."""
        return sum(isinstance(each, entry.VectorEquation) for section in self.parts for each in section.entries)

    def upto(self, equations: int) -> Iterator[tuple[Section, tuple[entry.Entry, ...]]]:
        """The parts as far as whole equations and what is said of their arrows go, and of each what is left, from an
        equation on: the last equation is always left; without any, all of the last part."""
        every = [(n, k) for n, section in enumerate(self.parts) for k, each in enumerate(section.entries)
                 if isinstance(each, entry.VectorEquation)]  # fmt: skip
        last, done = every[min(equations, len(every) - 1)] if every else (len(self.parts) - 1, 0)
        for n, section in enumerate(self.parts):
            told = len(section.entries) if n < last else done if n == last else 0
            yield replace(section, entries=section.entries[:told]), section.entries[told:]


@kept(4)
def drawn_problem(mechanism: Mechanism, lang: Lang, whose: str = "") -> HandoutProblem:
    """A mechanism drawn and proved at the scales of its handout, which are those that its key is made for."""
    drawing = _at_its_scales(mechanism)
    scales = {plane: drawing.mechanism.scales[key] for plane, key in KEYS.items()}
    return HandoutProblem(drawing, scales, lang, whose)


@kept(64)
def _told(drawing: Drawing) -> Drawing:
    """The same for all languages, whose figures are then arranged once."""
    goal = solution_goal(Reading(*shown(drawing.method, drawing.plot), drawing.mechanism.scales, "en"))
    return replace(drawing, method=cut_to(drawing.method, goal.parts))


@kept(64)
def _at_its_scales(mechanism: Mechanism) -> Drawing:
    """The same for all languages: those of a book follow one another."""
    drawing = Drawing.of(mechanism)
    scaled = replace(mechanism, scales=paper_scales(drawing.method, drawing.plot))
    method = plan(scaled)
    return Drawing(scaled, method, replay_all(method))


# --- what stands after a solution -------------------------------------------------------------------------------------

_SHOWN = 3  # mistakes
_TIMES = 5.0  # a value that is as many times the right one is seen to be wrong


def beside_analysis(problem: HandoutProblem) -> Iterator[Block]:
    """A row an answer: drawn, analysed, and how far a careful pencil may be off."""
    key = _key(problem)
    entries = {entry.text: entry for entry in key.entries} if key is not None else {}
    roads = readings(problem.drawing.method, problem.drawing.plot), motion(problem.drawing.mechanism)
    rows: list[tuple[Label, ...]] = []
    for text, quantity in zip(problem.goal.texts, problem.goal.wanted, strict=False):
        if quantity is None or isinstance(quantity, Centre):
            continue
        unit = EDGE[quantity.unit]
        values = (quantity.shown(road) for road in roads)
        sizes = (geometry.number(v.value) if v.vector is None else abs(geometry.place(v.vector)) for v in values)
        entry, off = entries.get(text), ""
        if entry is not None and entry.doubt in ("dead point", "too small"):
            off = say(f"handouts.allowed {entry.doubt}", problem.lang)
        elif entry is not None:
            off = f"± {number(entry.tolerance * unit.factor, digits=2)}"
        shown = [plain(number(size * unit.factor)) for size in sizes]
        rows.append((formula(problem.goal.symbol(quantity)), *shown, plain(off), plain(unit.sign)))
    if rows:
        heads = ("quantity", "drawn", "analysed", "allowed", "unit")
        turning = any(isinstance(quantity, Rotation) for quantity in problem.goal.wanted)  # its sign is a sense
        yield HandoutHeading(plain(say("handouts.beside", problem.lang, which=turning)))
        labels = tuple(plain(say(f"handouts.{head}", problem.lang)) for head in heads)
        yield HandoutTable(labels, tuple(rows), printed=True)


def common_mistakes(problem: HandoutProblem) -> Iterator[Block]:
    """The mistakes that move most of what is asked, of different kinds, with the numbers they give, and the directions
    that alone are wrong: those made where one follows the solution, of which nobody sees that they are wrong."""
    key = _key(problem)
    if key is None:
        return
    moved, likely, text = _moved(key), _likely(key), "\n".join(
        entry.text_lines((each for section in problem.parts for each in section.entries), problem.lang))
    asked = [k for k, entry in enumerate(key.entries) if entry.points]
    first = {made[0][0]: row for row, made in reversed([*enumerate(key.singles.names)])
             if any(moved[row][asked]) and all(likely[row][asked]) and _occurs(made[0][2], text, problem)}  # fmt: skip
    common = [first[id] for id in COMMON if id in first][:_SHOWN]
    if common:
        yield HandoutHeading(plain(say("handouts.common", problem.lang)))
    marker = Marker(key, problem.drawing.method)
    for row in common:
        made = [(), (marker.known[key.singles.names[row][0]],)]
        right, vectors = combined(marker.method, marker.plot, marker.quantities, made).vectors
        turned = (np.abs(np.angle(vectors * right.conj())) > ASTRAY) & ~moved[row]
        some = {k: degrees(vectors[k]) if turned[k] else "" for k in asked if moved[row][k] or turned[k]}
        yield Paragraph(_given_by(problem, key, row, some))


def _moved(key: Key) -> np.ndarray:
    """Flags (mistakes, quantities): what each mistake moves by more than a pencil may."""
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(shifts(columns(key.entries), key.singles.values) > 3)


def _likely(key: Key) -> np.ndarray:
    """Flags (mistakes, quantities): what has about the size of the right value, or none."""
    table = columns(key.entries)
    size = np.abs(upright(table, key.singles.values))
    return np.asarray(~(size > _TIMES * (np.abs(upright(table, table.right)) + table.tolerance)) | table.angle)


def _occurs(of: Sequence[str], text: str, problem: HandoutProblem) -> bool:
    """True where a text has all that a mistake is made in: arrows, rotations, triangles, both vectors of `BC/AB`."""
    signs = (in_signs(part, problem.goal.texts) for each in of for part in each.split("/"))
    return all(re.search(rf"(?<!\w){re.escape(sign)}(?![\w′])", text) for sign in signs)


def _given_by(problem: HandoutProblem, key: Key, row: int, moved: Mapping[int, str]) -> Label:
    """A mistake in words, and the values it gives of those quantities that it moves, with the direction of some."""
    symbols = {text: q for text, q in zip(problem.goal.texts, problem.goal.wanted, strict=False) if q is not None}
    values = upright(columns(key.entries), key.singles.values[row])
    shown = []
    for k, angle in moved.items():
        quantity, value = symbols.get(key.entries[k].text), values[k]
        if quantity is not None and np.isfinite(value):
            unit = EDGE[quantity.unit]
            to_x = say("common.note", problem.lang, note=heading(angle, problem.lang)) if angle else ""
            shown.append(f"{problem.goal.symbol(quantity)} = {number(value * unit.factor)} {unit.sign}".strip() + to_x)
    name = key.singles.names[row][0]
    text = mistake_in_signs(name, {entry.text for entry in key.entries}, problem.lang)
    if name[0].startswith("normal-"):  # a crank's whole acceleration, by what it is: `a_A = aⁿ_AO`
        entries = (each for section in problem.parts for each in section.entries)
        for each in (each for each in entries if isinstance(each, entry.Calculation) and each.name in text):
            text = text.replace(each.name, next((f for f in each.formulas if f.startswith("aⁿ_")), each.name))
    given = say("common.and", problem.lang).join(shown)
    return lettered(say("handouts.gives", problem.lang, mistake=text, values=given), problem.points)


def untold_answers(mechanism: Mechanism, lang: Lang) -> Iterator[str]:
    """A sentence a question that `problems` would not ask, at any position: a pencil does not tell its answer."""
    problem = drawn_problem(mechanism, lang, "")  # as its pages have it
    if (key := _key(problem)) is None:
        return
    method = problem.drawing.method
    off = {**untold(key, method)}
    for at, there in enumerate(further_methods(method), 2):
        further = untold(make_key(there, key.marking, marks=False), there)
        off |= {at_position(text, at): part for text, part in further.items()}
    yield from (f"{mechanism.where('ask')}: {line}" for line in untold_lines(off, lang))


@kept(4)
def _key(problem: HandoutProblem) -> Key | None:
    """The key of the problem, to be read; None where nothing is asked that is marked."""
    try:
        return key_drawn(problem.drawing.method, marks=False)
    except GraphkinError:
        return None
