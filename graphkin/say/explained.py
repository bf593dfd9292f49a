"""A whole derivation in words: what is given, then the mechanism and its polygons in the order they are drawn."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from graphkin.construction import Equation, Plane, Plot
from graphkin.errors import Lang
from graphkin.planning import Method
from graphkin.planning.drawn_position import by_pose, shown
from graphkin.say.answer_lines import AnswerLines, deviations
from graphkin.say.entry import Calculation, Entry, Sentence, VectorEquation, text_lines
from graphkin.say.equations import worded
from graphkin.say.plane import PolygonReading
from graphkin.say.polygons import polygon_entries
from graphkin.say.position import PositionReader
from graphkin.say.problem_data import problem_data, solution_head
from graphkin.say.reading import Reading
from graphkin.say.solution_goal import solution_goal

if TYPE_CHECKING:
    from graphkin.marking.ruler import Ruler


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
    only: Plane = "acceleration", ruler: Ruler | None = None, as_planned: bool = False,
) -> Iterator[Entry]:  # fmt: skip
    """The solution as data; `as_planned`: every act of the polygons, though a driver at rest may make them easier."""
    reading = Reading(*shown(method, plot), scales, lang, ruler, apart=as_planned)
    goal = solution_goal(reading, everything, only)
    posed = by_pose(reading.method, reading.plot)
    drawn = reading if posed is None else Reading(*posed, scales, lang, ruler)
    body = list(PositionReader(drawn, reading, goal.levers, angles=goal.angles).entries())
    # then its instant centres where they are asked for, and the polygons that are needed
    parts: list[Callable[..., Iterator[Entry]]]
    parts = [partial(polygon_entries, reading, plane, steps) for plane, steps in goal.parts.items()]
    if not as_planned and (centres := goal.centred) is not None:
        parts.insert(1 if centres.from_velocities and parts else 0, centres.entries)
    for number, part in enumerate(parts, start=2):
        body += part(number=number)
    acts = [entry.act for entry in body if isinstance(entry, Sentence) and entry.act is not None]
    steps = {act.number for act in acts if act.numbered}
    yield from problem_data(reading)
    yield from goal.question()
    yield from solution_head(reading, leaves_out=len(steps) < max(steps, default=0))
    yield from body
    answers = AnswerLines(goal, {entry.name: entry.value for entry in body if isinstance(entry, Calculation)})
    yield from answers.entries()
    if ruler is not None:
        exactly = replace(reading, plot=ruler.right, ruler=None)
        yield from deviations(answers, solution_goal(exactly, everything, only))


def vector_equations(
    method: Method, plot: Plot, scales: Mapping[str, float], lang: Lang, plane: Plane
) -> dict[Equation, VectorEquation]:
    """The equations of one polygon as they are printed, by the equations of its construction."""
    drawn = PolygonReading(Reading(method, plot, scales, lang), plane)
    return {part: worded(drawn, part) for part in drawn.construction.equations}
