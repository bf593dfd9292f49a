"""Text in columns, as a terminal shows it."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Sequence


def unbraced(text: str) -> str:
    """Without the braces that keep a long subscript together where it is typeset."""
    return re.sub(r"_\{([^{}]*)\}", r"_\1", text)


def width(text: str) -> int:
    """Columns that a text takes: two for a Chinese character, none for an accent."""
    if text.isascii():
        return len(text)
    wide = sum(unicodedata.east_asian_width(letter) in "WF" for letter in text)
    return len(text) + wide - sum(bool(unicodedata.combining(letter)) for letter in text)


_PIECES = re.compile(r"[\u4e00-\u9fff][，。；：、）”]*\s*|[^\s\u4e00-\u9fff]+\s*")
"""Words, and Chinese characters with the signs that may not begin a line."""


def in_lines(text: str, most: int, indent: str = "") -> list[str]:
    """A text in lines of so many columns, broken at blanks or between Chinese characters."""
    lines = [indent]
    for word in _PIECES.findall(text):
        lines += [indent] if lines[-1].strip() and width(lines[-1] + word.rstrip()) > most else []
        lines[-1] += word
    return [line.rstrip() for line in lines]


def padded(text: str, room: int, side: str = "<") -> str:
    """A text with blanks after it (`<`), before it (`>`), or on both sides (`^`)."""
    spare = room - width(text)
    before = {"<": 0, "^": spare // 2, ">": spare}[side]
    return " " * before + text + " " * (spare - before)


def aligned(rows: Sequence[Sequence[str]], sides: str = "<>", gap: str = "  ") -> list[str]:
    """Rows with their columns aligned. sides: of the first column, the second, ..; the last one holds on."""
    rows = [[unbraced(cell) for cell in row] for row in rows]
    rooms = [max(width(row[k]) for row in rows) for k in range(len(rows[0]))]
    to = [sides[min(k, len(sides) - 1)] for k in range(len(rooms))]
    return [gap.join(map(padded, row, rooms, to)) for row in rows]


def table(rows: Sequence[Sequence[str]]) -> list[str]:
    """The first column to the left, the others to the right."""
    return [line.rstrip() for line in aligned(rows)]
