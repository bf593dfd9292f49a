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
from graphkin.say.answers import AnswerLines
from graphkin.say.asked import Asked, asked
from graphkin.say.deviation import deviations
from graphkin.say.entry import Calculation, Entry, Sentence, VectorEquation
from graphkin.say.equations import worded
from graphkin.say.given import given, solving
from graphkin.say.layout import lines
from graphkin.say.plane import PolygonReading
from graphkin.say.polygons import polygon
from graphkin.say.position import PositionReader
from graphkin.say.reading import Reading

if TYPE_CHECKING:
    from graphkin.marking.ruler import Ruler


def explain(
    method: Method,
    plot: Plot,
    scales: Mapping[str, float],
    lang: Lang,
    everything: bool = False,
    only: Plane = "acceleration",
    ruler: Ruler | None = None,
) -> list[str]:
    """The solution as lines of plain text, as far as the file asks.

    plot    one position of the method, all three planes replayed
    scales  "length" [m/mm], "velocity" [(m/s)/mm], "acceleration" [(m/s²)/mm]
    everything, only   all points and links, whatever is asked; the last plane that is drawn
    ruler   reads what is measured; the plot then follows from its readings
    """
    return list(lines(derivation(method, plot, scales, lang, everything, only, ruler), lang))


def derivation(
    method: Method,
    plot: Plot,
    scales: Mapping[str, float],
    lang: Lang,
    everything: bool = True,
    only: Plane = "acceleration",
    ruler: Ruler | None = None,
    as_planned: bool = False,
) -> Iterator[Entry]:
    """The solution as data: what is given and asked, the planes in the order of their constructions, the answers.

    as_planned  every act of the polygons, though a driver at rest may make them easier
    """
    reading = Reading(*shown(method, plot), scales, lang, ruler, apart=as_planned)
    goal = asked(reading, everything, only)
    body = list(_drawn(goal, as_planned))
    yield from given(reading)
    yield from goal.question()
    yield from solving(reading, _leaves_out(body))
    yield from body
    answers = AnswerLines(goal, {entry.name: entry.value for entry in body if isinstance(entry, Calculation)})
    yield from answers.entries()
    if ruler is not None:
        yield from deviations(answers, asked(replace(reading, plot=ruler.right, ruler=None), everything, only))


def _drawn(goal: Asked, as_planned: bool) -> Iterator[Entry]:
    """The mechanism, its instant centres where they are asked for, and the polygons that are needed."""
    reading = goal.reading
    method, plot = reading.method, reading.plot
    posed = by_pose(method, plot)
    drawn = reading if posed is None else Reading(*posed, reading.scales, reading.lang, reading.ruler)
    yield from PositionReader(drawn, reading, goal.levers, angles=goal.angles).entries()
    for number, part in enumerate(_parts(reading, goal, centred=not as_planned), start=2):
        yield from part(number=number)


def _leaves_out(body: list[Entry]) -> bool:
    """Whether acts of the drawing are not told: their numbers are missing then."""
    acts = [entry.act for entry in body if isinstance(entry, Sentence) and entry.act is not None]
    told = {act.number for act in acts if act.numbered}
    return len(told) < max(told, default=0)


def _parts(reading: Reading, goal: Asked, centred: bool) -> list[Callable[..., Iterator[Entry]]]:
    """What follows the mechanism's drawing: its instant centres where they are asked for, and its polygons."""
    parts: list[Callable[..., Iterator[Entry]]]
    parts = [partial(polygon, reading, plane, steps) for plane, steps in goal.parts.items()]
    if centred and (found := goal.centred) is not None:
        parts.insert(1 if found.from_velocities and parts else 0, found.entries)
    return parts


def vector_equations(
    method: Method, plot: Plot, scales: Mapping[str, float], lang: Lang, plane: Plane
) -> dict[Equation, VectorEquation]:
    """The equations of one polygon as they are printed, by the equations of its construction."""
    drawn = PolygonReading(Reading(method, plot, scales, lang), plane)
    return {part: worded(drawn, part) for part in drawn.construction.equations}
