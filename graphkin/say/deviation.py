"""How far what was read off a drawing is from the exact values, answer by answer."""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.model.quantities import Quantity
from graphkin.say import names
from graphkin.say.answers import AnswerLines
from graphkin.say.asked import Asked
from graphkin.say.entry import Entry, Heading, Sentence
from graphkin.say.numbers import number
from graphkin.say.reading import Reading

_NOISE = 1e-6
"""Parts below this are none [%]."""


def deviations(read: AnswerLines, exactly: Asked) -> Iterator[Entry]:
    """Each answer beside its exact value.

    exactly  the same questions of the drawing that was read
    """
    right = AnswerLines(exactly, {})
    wanted = [quantity for quantity in read.goal.wanted if quantity is not None]
    if wanted:
        yield Heading(read.reading.say("solution.exactly"))
    for quantity in wanted:
        yield Sentence("  " + _beside(read, right, quantity))


def _beside(read: AnswerLines, right: AnswerLines, quantity: Quantity) -> str:
    """`v_C: as drawn 1.225 m/s (at 180° to +x), exactly 1.220 m/s (at 180° to +x), off by 0.44 %.`"""
    shown = {"read": read.result(quantity), "exact": right.result(quantity)}
    name, off = right.goal.symbol(quantity), ""
    if quantity.is_place:
        name = names.point(quantity.text.split()[-1])
    else:
        off = _off(read.reading, read.signed(quantity), right.signed(quantity))
    return read.reading.say("solution.beside", name=name, off=off, **shown)


def _off(reading: Reading, read: float, exactly: float) -> str:
    """By what part of the exact value; nothing beside an exact 0."""
    if not exactly:
        return ""
    return reading.say("solution.off", part=number(abs(read / exactly - 1) * 100, _NOISE, 2))
