"""Sentences one under another, broken into lines that fit a width."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from graphkin.base.value import frozen
from graphkin.sheet.formula import formula
from graphkin.sheet.lettering import width
from graphkin.sheet.marks import Place, Text

LINE = 1.4
"""From base line to base line, as a part of the letters' size."""
_INDENT = 2.5
"""How far the further lines of a sentence stand in [mm]."""
_MOST = 16
"""Lines in a strip; what is longer is cut."""
_STOPS = r"[\u3001\u3002\uff0c\uff1b\uff09]?"
_WORD = r"[^\s\u2e80-\uffef]+"
_PIECE = rf"{_WORD}(?: [=≈<>] {_WORD})*{_STOPS}|[\u2e80-\uffef]{_STOPS}|\s+"


def broken(text: str, room: float, size: float) -> Iterator[str]:
    """Lines that fit a width [mm]: broken at blanks, and between Chinese characters."""
    line = ""
    for piece in re.findall(_PIECE, text):
        if line and width(formula((line + piece).rstrip()), size) > room:
            yield line.rstrip()
            line = piece.lstrip()
        else:
            line += piece
    if line.strip():
        yield line.rstrip()


@frozen
class Paragraphs:
    """Lines with how far each stands in [mm], in letters of one size."""

    lines: tuple[tuple[str, float], ...]
    letters: float

    @classmethod
    def of(cls, texts: Sequence[str], room: float, letters: float) -> Paragraphs:
        """Sentences in a width [mm]; a blank at a text's beginning sets all of it in."""
        found: list[tuple[str, float]] = []
        for text in texts:
            own = _INDENT if text != text.lstrip() else 0.0
            pieces = broken(text.strip(), room - own - _INDENT, letters)
            found += [(line, own + (_INDENT if k else 0.0)) for k, line in enumerate(pieces)]
        kept = found if len(found) <= _MOST else [*found[: _MOST - 1], ("…", 0.0)]
        return cls(tuple(kept), letters)

    @property
    def height(self) -> float:
        """[mm]"""
        return LINE * self.letters * len(self.lines)

    def marks(self, corner: Place) -> Iterator[Text]:
        """From their upper left corner."""
        for k, (line, into) in enumerate(self.lines):
            yield Text(formula(line), corner + into + 1j * self.letters * (LINE * k + 1.1), self.letters)
