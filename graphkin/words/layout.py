"""Entries -> lines of plain text for a terminal, with the two rows of each equation under its terms."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterable, Iterator
from typing import assert_never

from graphkin.errors import Lang
from graphkin.words.catalogue import close, say
from graphkin.words.entries import Arrow, Calculation, Entry, Heading, Sentence, VectorEquation

__all__ = ["lines", "width"]


def width(text: str) -> int:
    """Columns that a text takes: two for a Chinese character, none for an accent."""
    return sum(0 if unicodedata.combining(c) else 2 if unicodedata.east_asian_width(c) in "WF" else 1 for c in text)


def lines(entries: Iterable[Entry], lang: Lang) -> Iterator[str]:
    """One line an entry; three a vector equation."""
    for k, entry in enumerate(entries):
        match entry:
            case Heading(text):
                yield from ([""] if k else [])
                yield text
            case Sentence(text):
                yield f"  {text}"
            case Calculation():
                note = say("common.note", lang, note=entry.note) if entry.note else ""
                yield f"    {entry.text}{close(note) if lang == 'zh' else note}"
            case VectorEquation():
                yield from _equation(entry, lang)
            case _:
                assert_never(entry)


def _equation(equation: VectorEquation, lang: Lang) -> Iterator[str]:
    columns = list(_columns(equation))
    rows = zip(*(_centred(column) for column in columns), strict=True)
    labels = _padded(["", say("derivation.direction row", lang), say("derivation.size row", lang)])
    for label, row in zip(labels, rows, strict=True):
        yield f"    {label}  {' '.join(row)}".rstrip()


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
            yield _column(arrow)


def _column(arrow: Arrow) -> tuple[str, str, str]:
    return arrow.name, arrow.direction, arrow.size


def _centred(column: tuple[str, ...]) -> list[str]:
    room = max(width(cell) for cell in column)
    spare = [room - width(cell) for cell in column]
    return [" " * (n // 2) + cell + " " * (n - n // 2) for cell, n in zip(column, spare, strict=True)]


def _padded(labels: list[str]) -> list[str]:
    room = max(width(label) for label in labels)
    return [label + " " * (room - width(label)) for label in labels]
