"""The vector equations of a problem as a table to fill: the terms, the choices of direction and of magnitude, and which
of these are right.

The lists are made of the letters of the mechanism alone, so they tell nothing. A choice is right if it says what the
term of the construction is, at the drawn position and close by: two lines that are always parallel, or two products
that are always equal, are equally right; lines that are parallel by chance are not.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from graphkin.base.cache import kept
from graphkin.base.geometry import dot, unit
from graphkin.base.value import frozen
from graphkin.construction import Construction, Equation, LayOff, Plane, Plot, Term, replay, slide_key, terms
from graphkin.errors import GraphkinError
from graphkin.marking.choice_rows import AXES, KNOWN, NOTHING, SAME, UNKNOWN, ChoiceRows, RowChoice
from graphkin.model.mechanism import FRAME
from graphkin.model.naming import in_order
from graphkin.model.quantities.reading import read
from graphkin.planning import Method
from graphkin.planning.asked import PLANES, asked_parts
from graphkin.planning.at_rest import at_rest, moving_parts, steady_turnings
from graphkin.planning.drawn_position import shown

_AWAY = (0.02, -0.035)
"""Positions close by, where what is the same by chance differs [rad, parts of the size]; rates differ more."""


@frozen
class TermChoices:
    """A term, and the tokens that are right for it, the textbook's own first.

    name       as files write it: `a^n_B3D`
    senseless  directions on the right line, but the other way or without the sense that they have
    nothing    its size is 0 here: it has no direction
    """

    name: str
    directions: tuple[str, ...]
    senseless: tuple[str, ...]
    magnitudes: tuple[str, ...]
    nothing: bool


@frozen
class EquationChoices:
    """A vector equation by its number in its plane, as it is written, with the choices for each term.

    front  the motion sought, where it is no side by itself: `v_C`; else ""
    """

    plane: Plane
    number: int
    front: str
    sides: tuple[tuple[TermChoices, ...], ...]
    directions: tuple[RowChoice, ...]
    magnitudes: tuple[RowChoice, ...]

    @property
    def terms(self) -> tuple[TermChoices, ...]:
        return tuple(term for side in self.sides for term in side)


@kept(8)
def equation_choices(method: Method, plot: Plot) -> tuple[EquationChoices, ...]:
    """The equations that lead to what a file asks, in their order; of all motions where it asks for none."""
    plots = _close_by(method, plot)
    method, plot = shown(method, plot)
    rested, steady = at_rest(method, plot.facts), steady_turnings(method, plot.facts)
    questions = (read(method.mechanism, text) for text in method.mechanism.ask)
    parts = asked_parts(method, [one for one in questions if one is not None], steady)
    polygons = {polygon.plane: polygon for polygon in (method.velocity, method.acceleration)}
    parts = parts or {plane: polygon.parts for plane, polygon in polygons.items()}
    every = list[EquationChoices]()
    for plane in (plane for plane in PLANES if plane in parts):
        moving = moving_parts(method, plane, parts[plane], rested)
        reader = _TermReader(ChoiceRows(method, plots, polygons[plane]))
        drawn = (part for part in moving if isinstance(part, Equation) and _is_written(method, polygons[plane], part))
        every += [reader.equation(part, number) for number, part in enumerate(drawn, 1)]
    return tuple(every)


def _is_written(method: Method, polygon: Construction, part: Equation) -> bool:
    """False where a sentence stands for it: of a link that cannot turn, or of an instant centre."""
    both = part.left + part.right
    size, turns = part.right[-1].size, method.structure.turns
    if isinstance(part.right[0].size, terms.Drawn) and isinstance(size, terms.Turning | terms.Normal):
        turn = turns[size.link]
        return not (len(part.right) == 2 and turn.base == FRAME and not turn.drivers)
    legs = len(both) == 2 and all(term.over and term.tail == polygon.pole for term in both)
    return polygon.plane != "velocity" or not legs


def _close_by(method: Method, plot: Plot) -> list[Plot]:
    """The plot, and those of positions close by that are reached."""
    near = {**method.near, **plot.theta, **{slide_key(slide): s for slide, s in plot.s.items()}}
    plots = [plot]
    for away in _AWAY:
        steps = [away * (1 + 0.3 * k) for k in range(len(method.drivers))]
        values = [value + step * (method.size if driver.kind == "slide" else 1.0)
                  for value, step, driver in zip(plot.facts.values, steps, method.drivers, strict=True)]  # fmt: skip
        facts = plot.facts
        rates, more = ([part * (1 + 9 * away) for part in parts] for parts in (facts.rates, facts.accelerations))
        there = Plot(replace(facts, values=tuple(values), rates=tuple(rates), accelerations=tuple(more)), near)
        try:
            for construction in method.constructions:
                there = replay(construction, there)
        except GraphkinError:
            continue  # beyond a dead point
        plots.append(there)
    return plots


@frozen
class _TermReader:
    """Reads the terms of one plane by its rows of choices."""

    rows: ChoiceRows

    @property
    def plane(self) -> Plane:
        return self.rows.plane

    @property
    def least(self) -> float:
        """Arrows up to this are none."""
        return self.rows.method.mechanism.usual.least("m/s" if self.plane == "velocity" else "m/s^2")

    def equation(self, part: Equation, number: int) -> EquationChoices:
        """One equation; its letters are those of the terms."""
        front = "" if part.is_sought(part.sides[0]) else Term(part.of, "", "", None, None, "", "").name(self.plane)
        sides = tuple(tuple(self._term(term) for term in side) for side in part.sides)
        return EquationChoices(self.plane, number, front, sides, (*self.rows.directions,), (*self.rows.magnitudes,))

    def _term(self, term: Term) -> TermChoices:
        known, size = isinstance(term.size, terms.Drawn | terms.Driven), np.abs(self._arrow(term))
        nothing = bool(size[0] <= self.least)
        directions, senseless = self._right_directions(term)
        if known or not directions:  # of one that never moves there is none
            directions.add(KNOWN)
        magnitudes = {UNKNOWN} if term.size is None else {KNOWN} | {
            choice.token for choice, value in self.rows.magnitudes.items()
            if value is not None and np.all(np.abs(value - size) <= SAME * value + self.least)
        }  # fmt: skip
        magnitudes |= {NOTHING} if nothing else set()
        sizes = sorted(magnitudes, key=lambda token: (token != self._own_size(term), token == KNOWN, token))
        own = self._own_direction(term)
        if nothing and own not in (UNKNOWN, ""):
            directions.add(own)
        ways = sorted(directions, key=lambda token: (token != own, token == KNOWN, " to " in token, token))
        return TermChoices(term.name(self.plane), tuple(ways), tuple(sorted(senseless)), tuple(sizes), nothing)

    def _own_size(self, term: Term) -> str:
        """The size as the construction has it."""
        match term.size:
            case None:
                return UNKNOWN
            case terms.Turning(link, tail, head) | terms.Tangential(link, tail, head) | terms.Normal(link, tail, head):
                word = "alpha" if isinstance(term.size, terms.Tangential) else "omega"
                squared = "^2" if isinstance(term.size, terms.Normal) else ""
                return f"{word}_{self.rows.called(link)}{squared}*l_{''.join(in_order(tail, head))}"
            case terms.Coriolis(link, tail, head):
                named = (name for name, ends in self.rows.velocities.items() if ends == (tail, head))
                return f"2*omega_{self.rows.called(link)}*{next(named, '')}"
            case terms.Relative(link, seen_from, tail, head, part):
                word, squared = "alpha" if part == "t" else "omega", "^2" if part == "n" else ""
                return f"{word}_{self.rows.against(link, seen_from)}{squared}*l_{''.join(in_order(tail, head))}"
            case _:
                return KNOWN

    def _own_direction(self, term: Term) -> str:
        """The direction as the construction has it, where two points give it; of a driven point that of its arrow."""
        if isinstance(term.size, terms.Drawn):
            laid = (part.term for part in self.rows.polygon.parts if isinstance(part, LayOff))
            term = next((one for one in laid if one.head == term.head), term)
        match term.direction:
            case None:
                return KNOWN if isinstance(term.size, terms.Drawn) else UNKNOWN
            case terms.Along(tail, head):
                return f"{tail} to {head}" if term.size is not None else f"parallel {''.join(in_order(tail, head))}"
            case terms.Across(tail, head):
                return f"perpendicular {''.join(in_order(tail, head))}"
            case _:
                return KNOWN if isinstance(term.size, terms.Drawn) else ""

    def _right_directions(self, term: Term) -> tuple[set[str], set[str]]:
        """The tokens that say where a term points; and those on its line that do not say which way."""
        if term.direction is None and not isinstance(term.size, terms.Drawn):
            return {UNKNOWN}, set()
        right, senseless, line = set[str](), set[str](), self._line_of(term)
        pointed = isinstance(term.direction, terms.Along) and term.size is not None
        for choice, value in self.rows.directions.items():
            axis = choice.kind == "guide" and choice.points[0] in AXES  # along which a line lies now, whatever it does
            if value is None or not self.rows.same_line(value, line, axis):
                continue
            free = term.size is None or not (pointed or choice.kind == "towards")
            ok = free or (choice.kind == "towards" and np.all(dot(value, line) > 0))
            (right if ok else senseless).add(choice.token)
        return right, senseless

    def _line_of(self, term: Term) -> np.ndarray:
        """The direction of a term, of one that is known with its sense; NaN of an arrow that is none."""
        if term.size is None and (direction := term.direction) is not None:
            return self.rows.at_each(lambda plot: plot.direction(direction))
        arrow = self._arrow(term)
        return np.where(np.abs(arrow) > self.least, unit(arrow), np.nan)

    def _arrow(self, term: Term) -> np.ndarray:
        return self.rows.at_each(lambda plot: plot.points(self.plane)[term.head] - plot.points(self.plane)[term.tail])
