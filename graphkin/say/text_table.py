"""Text in columns, as a terminal shows it."""

from __future__ import annotations

import unicodedata
from collections.abc import Sequence
from functools import cache


def width(text: str) -> int:
    """Columns that a text takes: two for a Chinese character, none for an accent."""
    return len(text) if text.isascii() else sum(map(_columns, text))


@cache
def _columns(letter: str) -> int:
    return 0 if unicodedata.combining(letter) else 2 if unicodedata.east_asian_width(letter) in "WF" else 1


def padded(text: str, room: int, side: str = "<") -> str:
    """A text with blanks after it (`<`), before it (`>`), or on both sides (`^`)."""
    spare = room - width(text)
    before = {"<": 0, "^": spare // 2, ">": spare}[side]
    return " " * before + text + " " * (spare - before)


def aligned(rows: Sequence[Sequence[str]], sides: str = "<>", gap: str = "  ") -> list[str]:
    """Rows with their columns aligned. sides: of the first column, the second, ..; the last one holds on."""
    rooms = [max(width(row[k]) for row in rows) for k in range(len(rows[0]))]
    to = [sides[min(k, len(sides) - 1)] for k in range(len(rooms))]
    return [gap.join(map(padded, row, rooms, to)) for row in rows]


def table(rows: Sequence[Sequence[str]]) -> list[str]:
    """The first column to the left, the others to the right."""
    return [line.rstrip() for line in aligned(rows)]
