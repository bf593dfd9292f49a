"""A whole derivation in words: what is given, then the mechanism and its polygons in the order they are drawn."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from graphkin.construction import Equation, Plane, Plot
from graphkin.errors import Lang
from graphkin.planning import Method
from graphkin.say.entry import Entry, VectorEquation
from graphkin.say.equations import worded
from graphkin.say.given import given
from graphkin.say.layout import lines
from graphkin.say.plane import Polygon
from graphkin.say.polygons import polygon
from graphkin.say.position import PositionReader
from graphkin.say.reading import Reading

if TYPE_CHECKING:
    from graphkin.marking.ruler import Ruler


def explain(
    method: Method, plot: Plot, scales: Mapping[str, float], lang: Lang, ruler: Ruler | None = None
) -> list[str]:
    """The whole solution as lines of plain text.

    plot    one position of the method, all three planes replayed
    scales  "length" [m/mm], "velocity" [(m/s)/mm], "acceleration" [(m/s²)/mm]
    ruler   reads what is measured; the plot then follows from its readings
    """
    return list(lines(derivation(method, plot, scales, lang, ruler), lang))


def derivation(
    method: Method, plot: Plot, scales: Mapping[str, float], lang: Lang, ruler: Ruler | None = None
) -> Iterator[Entry]:
    """The whole solution as data: what is given, then the three planes in the order of their constructions."""
    reading = Reading(method, plot, scales, lang, ruler)
    yield from given(reading)
    yield from PositionReader(reading).entries()
    yield from polygon(reading, "velocity")
    yield from polygon(reading, "acceleration")


def vector_equations(
    method: Method, plot: Plot, scales: Mapping[str, float], lang: Lang, plane: Plane
) -> dict[Equation, VectorEquation]:
    """The equations of one polygon as they are printed, by the equations of its construction."""
    drawn = Polygon(Reading(method, plot, scales, lang), plane)
    return {part: worded(drawn, part) for part in drawn.construction.equations}
