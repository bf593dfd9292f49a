"""How points, links and sliding pairs may be called, and how `O1A` reads as O1, A."""

from __future__ import annotations

import re

_POINT = r"[A-Z][0-9]*'*"
POINT = re.compile(_POINT)
LINK = re.compile(r"[\w']+")
SLIDE = re.compile(r"(?!c[0-9]+\Z)[\w'-]+")
"""`c0`, `c1` .. are what graphkin calls the slots that stand for cams."""

LONGEST = 36
"""A name of so many letters finds room on every sheet."""

_POINTS = re.compile(rf"(?:{_POINT})+")
_PRIMES = str.maketrans({"\u2019": "'", "\u2032": "'", "\u2033": "''", "\u2034": "'''"})


def tidy(name: str) -> str:
    """A name with its primes as typed on a keyboard, however they were printed."""
    return name if name.isascii() else name.translate(_PRIMES)


def letters(name: str) -> int:
    """How wide a name is, in letters: Chinese characters are as wide as two."""
    if name.isascii():
        return len(name)
    import unicodedata

    return sum(2 if unicodedata.east_asian_width(letter) in "WF" else 1 for letter in name)


def split_points(word: str) -> tuple[str, ...]:
    """`O1AD'` -> O1, A, D'; nothing if the word is not made of points' names."""
    return tuple(POINT.findall(word)) if _POINTS.fullmatch(word) else ()
