"""The letters of a text in spans of one script and style, each at its own place; numbers as an SVG has them."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import groupby

from graphkin.sheet.lettering import advance, is_wide, run_size, run_width, scripts
from graphkin.sheet.marks import Place, Text
from graphkin.value import frozen

LATIN = "Times New Roman, Liberation Serif, Tinos, serif"
_CHINESE = "Noto Serif CJK SC, Source Han Serif SC, Songti SC, SimSun, WenQuanYi Micro Hei, serif"
_SIGNS = "√∥⊥"
"""Signs that the Chinese letters have, and Latin ones may not."""


def mm(value: float) -> str:
    """Four decimals, no trailing zeros."""
    return _bare(value, f"{value:.4f}")


def short(value: float) -> str:
    """Two decimals, which is enough for letters."""
    return _bare(value, f"{value:.2f}")


def _bare(value: float, text: str) -> str:
    if not math.isfinite(value):
        raise ValueError(f"a coordinate is {value}")
    bare = text.rstrip("0").rstrip(".")
    return "0" if bare == "-0" else bare or "0"


@frozen
class Span:
    """Letters of one script and style; where they begin, and how large they are [mm]."""

    text: str
    at: Place
    size: float
    italic: bool
    bold: bool

    def type(self, size: float) -> dict[str, str]:
        """What they are set in, where the letters around them have that size and are upright Latin ones."""
        wide = _is_chinese(self.text[:1])
        found = {"font-family": _CHINESE} if wide else {}
        found |= {"font-size": short(self.size)} if size and self.size != size else {}
        found |= {"font-style": "italic"} if self.italic and not wide else {}
        return found | ({"font-weight": "bold"} if self.bold else {})


def _is_chinese(letter: str) -> bool:
    """Whether it is set in the Chinese letters."""
    return is_wide(letter) or (letter in _SIGNS and letter != "")


def runs(mark: Text) -> list[Span]:
    """The letters of a text. Spaces end a span and never begin one: some viewers drop those."""
    found: list[Span] = []
    for run, start, drop in scripts(mark.label, mark.size):
        size = run_size(run, mark.size)
        for text in _of_one_script(run.text):
            bare = text.lstrip(" ")
            spaces = text[: len(text) - len(bare)]
            if spaces and found:
                found[-1] = replace(found[-1], text=found[-1].text + spaces)
            at = mark.at + complex(start + advance(spaces, run.italic) * size, drop)
            found += [Span(bare, at, size, run.italic, run.bold)] if bare else []
            start += run_width(run._replace(text=text), mark.size) if text != run.text else 0.0
    return found


def _of_one_script(text: str) -> list[str]:
    """Its letters, Chinese and Latin ones apart."""
    return [text] if text.isascii() else ["".join(letters) for _, letters in groupby(text, _is_chinese)]
