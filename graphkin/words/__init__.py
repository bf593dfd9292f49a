"""A construction in words: the vector equations with their rows, how each is drawn, and what it gives.

    derivation   steps -> entries (headings, sentences, calculations, vector equations): data for any output
    explain      the same as lines of plain text

Every figure is taken from the plot, that is from the drawing; nothing here solves anything.

Module order: `figures`, `names`, `phrases` (all sentences, both languages side by side), `entries`, `layout`,
`reading` (the mechanism's side), `plane` (a polygon's side), then one reader a subject: `given`, `position`,
`sizes`, `equations`, `rotation`, `polygons`. A new step kind fails the type check in each reader of steps
until it has its words; a new size, in `sizes`; a new direction, in `plane`. `centre_explained` words the instant
centres, from `centre_phrases`, `centre_steps` (how each is found), `centre_levers` (sums between them), `centre_uses`;
`centre_about` a link about its pole, `centre_poles` the pole of two velocities. `linkages` words the linkages of four
links, from `linkage_phrases`; `structure`, what a mechanism is made of, and `redundancy`, what repeats in it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from graphkin.construction import Equation, Plane, Plot
from graphkin.errors import Lang
from graphkin.planning import Method
from graphkin.words.entries import Arrow, Calculation, Entry, Heading, Sentence, VectorEquation
from graphkin.words.equations import worded
from graphkin.words.given import given
from graphkin.words.layout import lines
from graphkin.words.plane import Polygon
from graphkin.words.polygons import polygon
from graphkin.words.position import PositionReader
from graphkin.words.reading import Reading

__all__ = [
    "Arrow",
    "Calculation",
    "Entry",
    "Heading",
    "Sentence",
    "VectorEquation",
    "derivation",
    "explain",
    "vector_equations",
]


def explain(method: Method, plot: Plot, scales: Mapping[str, float], lang: Lang) -> list[str]:
    """The whole solution as lines of plain text.

    plot    one position of the method, all three planes replayed
    scales  "length" [m/mm], "velocity" [(m/s)/mm], "acceleration" [(m/s²)/mm]
    """
    return list(lines(derivation(method, plot, scales, lang), lang))


def derivation(method: Method, plot: Plot, scales: Mapping[str, float], lang: Lang) -> Iterator[Entry]:
    """The whole solution as data: what is given, then the three planes in the order of their constructions."""
    reading = Reading(method, plot, scales, lang)
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
