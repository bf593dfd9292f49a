"""Entries -> lines of plain text for a terminal, with the two rows of each equation under its terms."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import assert_never

from graphkin.errors import Lang
from graphkin.say.catalogue import close, say
from graphkin.say.entry import Calculation, Entry, Heading, Sentence, VectorEquation
from graphkin.say.numbers import circled
from graphkin.say.text_table import aligned, padded, width


def lines(entries: Iterable[Entry], lang: Lang) -> Iterator[str]:
    """One line an entry; three a vector equation."""
    for k, entry in enumerate(entries):
        match entry:
            case Heading(text):
                yield from ([""] if k else [])
                yield text
            case Sentence(text, act):
                number = f"{circled(act.number)} " if act is not None and act.numbered else ""
                yield f"  {number}{text}"
            case Calculation():
                note = say("common.note", lang, note=entry.note) if entry.note else ""
                yield f"    {entry.text}{close(note) if lang == 'zh' else note}"
            case VectorEquation():
                yield from _equation(entry, lang)
            case _:
                assert_never(entry)


def _equation(equation: VectorEquation, lang: Lang) -> Iterator[str]:
    """The terms, and their rows under them, each column centred."""
    rows = aligned([*zip(*_columns(equation), strict=True)], "^", " ")
    labels = ["", say("derivation.direction row", lang), say("derivation.size row", lang)]
    room = max(map(width, labels))
    for label, row in zip(labels, rows, strict=True):
        yield f"    {padded(label, room)}  {row}".rstrip()


def _columns(equation: VectorEquation) -> Iterator[tuple[str, str, str]]:
    """Terms with what stands under them, and the signs between with nothing under them."""
    if equation.front:
        yield equation.front, "", ""
    for k, side in enumerate(equation.sides):
        if k or equation.front:
            yield "=", "", ""
        for n, arrow in enumerate(side):
            if n:
                yield "+", "", ""
            yield arrow.name, arrow.direction, arrow.size
