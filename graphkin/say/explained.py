"""A whole derivation in words: what is given, then the mechanism and its polygons in the order they are drawn."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property, partial
from math import degrees, radians
from typing import TYPE_CHECKING, assert_never

from graphkin.base.value import frozen
from graphkin.construction import Equation, Plane, Plot, Site
from graphkin.errors import GraphkinError, Lang
from graphkin.model.kinematic_state import Motions
from graphkin.model.naming import Seen
from graphkin.model.quantities import Quantity, kinds
from graphkin.model.quantities.kinds import Centre, Component, Displacement, Moving, Place, Quotient, Rotation, Track
from graphkin.model.units import EDGE
from graphkin.planning import Method
from graphkin.planning.drawn_position import by_pose, shown
from graphkin.proof.readings import readings
from graphkin.running import driver_values, replay_all
from graphkin.say import names
from graphkin.say.entry import Calculation, Entry, Heading, Sentence, VectorEquation, text_lines
from graphkin.say.equations import equation
from graphkin.say.figures import Formula, Operand, TrigFormula
from graphkin.say.numbers import coordinates, number
from graphkin.say.plane import PolygonReading
from graphkin.say.polygons import polygon_entries
from graphkin.say.position import PositionReader
from graphkin.say.problem_data import problem_data, solution_head
from graphkin.say.problems import position_lines
from graphkin.say.reading import Reading
from graphkin.say.sizes import in_files_unit
from graphkin.say.solution_goal import SolutionGoal, solution_goal

if TYPE_CHECKING:
    from graphkin.marking.ruler import Ruler

_NO_DEVIATION = 1e-6  # parts below this are none [%]


@frozen
class _OtherName:
    """A name under which a motion is worked out: that of another point, `elsewhere`, or of the opposite."""

    name: str
    elsewhere: bool
    opposite: bool = False


@frozen
class AnswerLines:
    """The answers, about to be worded; `calculated`: sizes of vectors that the solution has worked out [SI]."""

    goal: SolutionGoal
    calculated: Mapping[str, float]

    @property
    def reading(self) -> Reading:
        return self.goal.reading

    @cached_property
    def _motions(self) -> Motions:
        return readings(self.reading.method, self.reading.plot)

    @property
    def answerable(self) -> list[Quantity]:
        """The questions that can be answered."""
        return [quantity for quantity in self.goal.wanted if quantity is not None]

    def entries(self) -> Iterator[Entry]:
        if self.goal.wanted:
            yield Heading(self.reading.say("solution.answer"))
        yield from map(self.entry, self.answerable)
        for text in self.goal.in_words:
            yield Sentence(self.reading.say("solution.left", question=text))

    def entry(self, quantity: Quantity) -> Sentence | Calculation:
        """The answer to one question; of a file in inches in inches, too."""
        entry = self._answer(quantity)
        value = entry.value / EDGE[quantity.unit].factor if isinstance(entry, Calculation) else 0.0
        other = in_files_unit(self.reading.mechanism, value, quantity.unit) if value else ""
        if isinstance(entry, Calculation) and other:
            return replace(entry, note=self.reading.say("common.and").join(filter(None, (other, entry.note))))
        return entry

    def _answer(self, quantity: Quantity) -> Sentence | Calculation:
        """In the unit of the solution, with the figures it is worked out from where that is one step more."""
        name, say, unit = self.goal.symbol(quantity), self.reading.say, EDGE[quantity.unit]
        match quantity:
            case Centre():
                place = self._centre(quantity)
                return Sentence(say("solution.centre at", name=names.point(quantity.text), place=place), item=True)
            case Track():
                place = self._track(quantity)
                return Sentence(say("solution.place at", point=names.point(quantity.of), place=place), item=True)
            case Moving():
                size, vector = self.value(quantity), complex(quantity.vector(self._motions))
                note = self.reading.heading(vector) if size else ""
                if size and (solved := self._solved_as(quantity)):
                    note = say("common.and").join((*self._clauses(quantity, solved), note))
                worked = self._worked(quantity) if size and name not in self.calculated else ((), "")
                return Calculation(name, *worked, size, unit.sign, note)
            case Component():
                return self._component(name, quantity)
            case Quotient():
                top, bottom = self.value(quantity.top), self.value(quantity.bottom)
                if not (top and bottom):
                    return Calculation(name, (), "", float(quantity.answer(self._motions).value.real), "")
                turning = all(isinstance(half, Rotation) and half.word != "theta" for half in quantity.halves)
                note = say("centres.same" if top * bottom > 0 else "centres.opposite") if turning else ""
                return Calculation(name, (), Operand(top) / Operand(bottom), top / bottom, "", note)
            case Rotation() if quantity.word != "theta":
                value = self.value(quantity)
                return Calculation(name, (), "", abs(value), unit.sign, self.reading.sense(value))
            case Rotation() | Displacement() | Place():
                return Calculation(name, (), "", self.value(quantity) * unit.factor, unit.sign)
            case _:
                assert_never(quantity)

    def result(self, quantity: Quantity) -> str:
        """The answer without its name and without figures: `1.220 m/s (along −x)`."""
        if isinstance(quantity, Centre):
            return self._centre(quantity)
        if isinstance(quantity, Track):
            return f"{self._track(quantity)} mm"
        entry = self.entry(quantity)
        assert isinstance(entry, Calculation), quantity
        return f"{entry.result}{self.reading.note(entry.note)}"

    def signed(self, quantity: Quantity) -> float:
        """The answer as a number, of a rotation with its sense."""
        if isinstance(quantity, Rotation):
            return self.value(quantity)
        entry = self.entry(quantity)
        return entry.value if isinstance(entry, Calculation) else 0.0

    def value(self, quantity: Quantity) -> float:
        """A quantity [SI], as it was read where a ruler reads; 0 where it is but rounding noise."""
        exactly, ruler = float(quantity.answer(self._motions).value.real), self.reading.ruler
        if not self.reading.usual.cut(exactly, quantity.unit):
            return 0.0
        match quantity:
            case Moving():
                # as it was calculated, of the point or of that of one link (`v_C`, `v_C4`); else as it is read off
                site, method = quantity.site, self.reading.method
                holding = method.mechanism.owners.get(site.point, ())
                links = {site.link, *(holding if site.link in holding else ())}
                solved = self._solved_as(quantity)
                labels = [self.goal.symbol(quantity), *([solved.name] if solved else [])]
                for node in method.velocity.nodes.values() if quantity.seen_from is None else ():
                    if node.site is not None and node.site.point == site.point and node.site.link in links:
                        labels.append(names.vector(f"{quantity.letter}_{node.of}"))
                if (known := next((label for label in labels if label in self.calculated), None)) is not None:
                    return self.calculated[known]
                plane: Plane = "velocity" if quantity.letter == "v" else "acceleration"
                return exactly if ruler is None else float(ruler.read(exactly, plane).real)
            case Component():
                return self._component("", quantity).value
            case Displacement() | Place() | Track() | Centre():
                return self.reading.measured(exactly)
            case Rotation(word="theta") if ruler is not None:
                return radians(ruler.angle(degrees(exactly)))
            case Rotation() | Quotient():
                return exactly
            case _:
                assert_never(quantity)

    def _solved_as(self, quantity: Moving) -> _OtherName | None:
        """The motion worked out in place of one seen from a point: `aᵏ_A4A3` of `a_k A4A2`, where
        another link bears the same pin; `v_C2C3` of `v B2B3`, where the two links slide without turning; and where the
        motion seen from the other point is the opposite, that: `v_B3B2` of `v B2B3`."""
        if quantity.seen_from is None or self.goal.symbol(quantity) in self.calculated:
            return None
        if same := next(iter(self._names_of(quantity)), None):
            return _OtherName(*same)
        other = replace(quantity, site=quantity.seen_from, seen_from=quantity.site)
        vectors = (complex(one.vector(self._motions)) for one in (quantity, other))
        opposite = not self.reading.usual.cut(abs(sum(vectors)), quantity.unit)
        turned = next(iter(self._names_of(other)), None) if opposite else None
        return _OtherName(*turned, opposite=True) if turned else None

    def _names_of(self, quantity: Moving) -> Iterator[tuple[str, bool]]:
        """The names under which the solution has worked out a motion, and whether of another point; those last."""
        method = self.reading.method
        construction = method.velocity if quantity.letter == "v" else method.acceleration
        sliding = []
        for term in construction.vectors().values():
            name = names.vector(term.name(construction.plane))
            if term.part == quantity.part and len(term.sites) == 2 and name in self.calculated:
                pairs = list(zip(term.sites, quantity.sites, strict=True))
                if all(one.point == other.point and self._borne(one, other) for one, other in pairs):
                    yield name, False
                elif self._slides(quantity) and _coincide(term.sites) and all(a.link == b.link for a, b in pairs):
                    sliding.append((name, True))
        yield from sliding

    def _borne(self, one: Site, other: Seen) -> bool:
        """Two sites at one pin move as one: their links bear it, or one stands for it in its slot."""
        owners = self.reading.mechanism.owners.get(one.point, ())
        bears = one.link in owners or self.reading.method.structure.is_pin(one.link)
        return one.link == other.link or (bears and other.link in owners)

    def _slides(self, quantity: Moving) -> bool:
        """It is of coincident points of two links that slide without turning against each other."""
        links = {site.link for site in quantity.sites}
        return _coincide(quantity.sites) and any({s.guide, s.block} == links for s in self.reading.mechanism.slides)

    def _clauses(self, quantity: Moving, solved: _OtherName) -> Iterator[str]:
        """Why a motion is what the solution has worked out under another name."""
        if solved.elsewhere:
            one, other = (self.reading.link(site.link) for site in quantity.sites)
            yield self.reading.say("solution.no turning", one=one, other=other)
        if solved.opposite:
            yield self.reading.say("solution.opposite", name=solved.name)

    def _worked(self, quantity: Moving) -> tuple[tuple[str, ...], Formula | str]:
        """The way to a motion that the solution has not worked out by its own name."""
        if (solved := self._solved_as(quantity)) and not solved.opposite:
            return (solved.name,), ""
        if quantity.part != "k" or quantity.seen_from is None:
            return (), ""
        slip, motions = replace(quantity, word="v", part=""), self._motions
        link = kinds.turning_link(motions.mechanism, quantity.site, quantity.seen_from)
        numbers = Operand(2) * Operand(abs(float(motions.turning(link)))) * Operand(self.value(slip))
        return (f"2 {self.reading.rate('ω', link)} {self.goal.symbol(slip)}",), numbers

    def _component(self, name: str, quantity: Component) -> Calculation:
        """`v_E,x = 0.3201 × cos 36.87° = 0.2561 m/s`."""
        whole, vector = self.value(quantity.whole), complex(quantity.whole.vector(self._motions))
        turned = TrigFormula("cos" if quantity.axis == "x" else "sin", self.reading.direction(vector))
        value, unit = whole * turned.value, EDGE[quantity.unit].sign
        if not self.reading.usual.cut(value, quantity.unit):
            return Calculation(name, (), "", 0.0, unit)
        return Calculation(name, (), Operand(whole) * turned, value, unit)

    def _centre(self, quantity: Centre) -> str:
        """The place of an instant centre."""
        assert self.goal.centred is not None, quantity
        return self.goal.centred.place(quantity)

    def _track(self, quantity: Track) -> str:
        """`(34.5, −20)`, in mm."""
        place = complex(self._motions.position[quantity.site.point])
        read = self.reading.measured
        place = complex(read(place.real), read(place.imag))
        return coordinates(1000 * place, self.reading.lang, 1000 * self.reading.noise)


def _coincide(sites: Sequence[Seen] | Sequence[Site]) -> bool:
    return len(sites) == 2 and sites[0].point == sites[1].point


def deviations(drawn: AnswerLines, exactly: SolutionGoal) -> Iterator[Entry]:
    """Each answer read off a drawing beside its exact value; `exactly`: the same questions of the drawing itself."""
    right, say = AnswerLines(exactly, {}), drawn.reading.say
    if drawn.answerable:
        yield Heading(say("solution.exactly"))
    for quantity in drawn.answerable:
        name, off = exactly.symbol(quantity), ""
        if quantity.is_place:
            name = names.point(quantity.text.split()[-1])
        elif value := right.signed(quantity):
            off = say("solution.off", part=number(abs(drawn.signed(quantity) / value - 1) * 100, _NO_DEVIATION, 2))
        shown = {"read": drawn.result(quantity), "exact": right.result(quantity)}
        yield Sentence(say("solution.beside", name=name, off=off, **shown), item=True)


def explain(
    method: Method, plot: Plot, scales: Mapping[str, float], lang: Lang, everything: bool = False,
    only: Plane = "acceleration", ruler: Ruler | None = None,
) -> list[str]:  # fmt: skip
    """The solution as lines of plain text, as far as the file asks.

    plot    one position of the method, all three planes replayed
    scales  "length" [m/mm], "velocity" [(m/s)/mm], "acceleration" [(m/s²)/mm]
    everything, only   all points and links, whatever is asked; the last plane that is drawn
    ruler   reads what is measured; the plot then follows from its readings
    """
    return list(text_lines(derivation(method, plot, scales, lang, everything, only, ruler), lang))


def derivation(
    method: Method, plot: Plot, scales: Mapping[str, float], lang: Lang, everything: bool = True,
    only: Plane = "acceleration", ruler: Ruler | None = None, as_planned: bool = False, uncut: Method | None = None,
) -> Iterator[Entry]:  # fmt: skip
    """The solution as data.

    as_planned  every act of the polygons, though a driver at rest may make them easier
    uncut       the method with all steps, which moves the mechanism, where this one has been cut to what is needed
    """
    reading = Reading(*shown(method, plot), scales, lang, ruler, apart=as_planned)
    goal = solution_goal(reading, everything, only)
    body = drawn_acts(goal, as_planned)
    acts = [entry.act for entry in body if isinstance(entry, Sentence) and entry.act is not None]
    steps = {act.number for act in acts if act.numbered}
    yield from problem_data(reading)
    others = [] if as_planned else _other_positions(method, plot)
    yield from map(Sentence, position_lines(reading) if others else ())
    yield from goal.question()
    yield from solution_head(reading, ("length", *goal.parts), leaves_out=len(steps) < max(steps, default=0))
    yield from [Sentence(reading.say("solution.first position"))] if others else []
    yield from body
    answers = AnswerLines(goal, {entry.name: entry.value for entry in body if isinstance(entry, Calculation)})
    yield from answers.entries()
    yield from answers_elsewhere(goal, uncut or method, others)
    if ruler is not None:
        exactly = replace(reading, plot=ruler.right, ruler=None)
        yield from deviations(answers, solution_goal(exactly, everything, only))


def _other_positions(method: Method, plot: Plot) -> list[tuple[float, ...]]:
    """Driver values of the further positions that the file asks for; none where the plot is of another than its own."""
    own = zip(plot.facts.values, method.facts().values, strict=True)
    return [*driver_values(method)][1:] if all(value is first or value == first for value, first in own) else []


def answers_elsewhere(goal: SolutionGoal, method: Method, positions: Sequence[tuple[float, ...]]) -> Iterator[Entry]:
    """The answers at further positions, which are solved in the same way; of one that is not reached, why.

    method  that moves the mechanism: of the one that the goal is told by the position may be drawn by a pose
    """
    if not (positions and goal.wanted):
        return
    reading = goal.reading
    yield Sentence(reading.say("solution.elsewhere"))
    heads = [*position_lines(reading)][2:]
    for head, values in zip(heads, positions, strict=True):
        yield Sentence(head)
        try:
            plot = replay_all(method, values)
        except GraphkinError as problem:
            yield Sentence(problem.message(reading.lang), item=True)
            continue
        told, shown_there = shown(method, plot)
        answers = AnswerLines(replace(goal, reading=replace(reading, method=told, plot=shown_there, ruler=None)), {})
        for entry in map(answers.entry, answers.answerable):
            yield replace(entry, formulas=(), numbers="") if isinstance(entry, Calculation) else entry


def drawn_acts(goal: SolutionGoal, as_planned: bool = False) -> list[Entry]:
    """The drawing: the position, then instant centres where they are asked for, and the polygons that are needed."""
    reading = goal.reading
    posed = by_pose(reading.method, reading.plot)
    drawn = reading if posed is None else Reading(*posed, reading.scales, reading.lang, reading.ruler)
    body = list(PositionReader(drawn, reading, goal.levers, angles=goal.angles).entries())
    parts: list[Callable[..., Iterator[Entry]]]
    parts = [partial(polygon_entries, reading, plane, steps) for plane, steps in goal.parts.items()]
    if not as_planned and (centres := goal.centred) is not None:
        from graphkin.say.centre_velocities import shorter_road

        parts.insert(1 if centres.from_velocities and parts else 0, partial(shorter_road, goal))
    for count, part in enumerate(parts, start=2):
        body += part(number=count)
    return body


def vector_equations(
    method: Method, plot: Plot, scales: Mapping[str, float], lang: Lang, plane: Plane
) -> dict[Equation, VectorEquation]:
    """The equations of one polygon as they are printed, by the equations of its construction; none of what a sentence
    says in place of one."""
    drawn = PolygonReading(Reading(method, plot, scales, lang), plane)
    entries = ((part, entry) for part in drawn.construction.equations for entry in equation(drawn, part))
    return {part: entry for part, entry in entries if isinstance(entry, VectorEquation)}
