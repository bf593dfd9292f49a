"""Plain text of the speaker, set as the field writes it: `aᵏ_B3B2`, `ω3² l_BD`, `⊥BD`."""

from __future__ import annotations

import re
from functools import lru_cache

from graphkin.sheet.lettering import Label, Run, point_label

_RAISED = dict(zip("ⁿᵗᵏʳ²³", "ntkr23", strict=True))
_LOW = r"(?:[^\s()（）/|²³·、。，；：,;.]|[,.](?=\w))+"
_SIGN = (
    r"(?P<letter>[A-Za-zα-ωṡ]\u0308?)(?P<part>[ⁿᵗᵏʳ]*)"
    rf"(?:_(?P<low>{_LOW})|(?P<digits>\d+))(?P<power>[²³]?)(?![A-Za-z])"
)
_POINT = re.compile(r"[A-Z][0-9]*′*")
_POINTS = rf"(?:(?<=[⊥∥→·△])|(?<=× ))(?:{_POINT.pattern})+|(?<![A-Za-z_])(?:{_POINT.pattern})+(?=→| =)"
_NUMBERED = rf"(?<![A-Za-z_])(?=[A-Z′]*\d)(?:{_POINT.pattern}){{2,}}(?![A-Za-z])"
_NODE = re.compile(r"[a-z]\d*(?:,\d+(?=′))?′*")
_STRETCH = (
    r"(?<![A-Za-z])(?:[a-z](?=[a-z][\d′])|[a-z]\d*(?:,\d+)?′+|[a-z]\d+′*)+(?![A-Za-z²³])"
    r"|(?<=[·△])(?:[a-z]\d*)+(?![A-Za-z])|(?<![A-Za-z/])(?<!\d )[a-z]{2}(?= = )"
)
_ANY = re.compile(f"(?P<points>{_POINTS}|{_NUMBERED}|{_STRETCH})|{_SIGN}")


@lru_cache(4096)
def formula(text: str) -> Label:
    """Quantities with their subscripts, powers raised, points in italics; what is neither stays as it is."""
    text = text.replace("\u2034", 3 * "\u2032").replace("\u2033", 2 * "\u2032")  # fonts have but one prime
    runs: list[Run] = []
    at = 0
    for found in _ANY.finditer(text):
        runs += _upright(text[at : found.start()])
        runs += _points(found["points"]) if found["points"] else _sign(found)
        at = found.end()
    return tuple(runs + _upright(text[at:]))


def points_label(text: str) -> Label:
    """`AB`, `O1B`: points one after another; a name in small letters as it is, in italics."""
    return tuple(_points(text)) or (Run(text, True),)


def _upright(text: str) -> list[Run]:
    return [Run(text)] if text else []


def _sign(found: re.Match[str]) -> list[Run]:
    """A letter, what stands below it, and its part or power above that."""
    letter, part, low, digits, power = found.group("letter", "part", "low", "digits", "power")
    below = re.findall(r"[^\W\d_]+|[^A-Za-z]+", _spaced(low or digits))
    runs = [Run(letter, True), *(Run(piece, _italic(piece), "sub") for piece in below)]
    if part:
        runs.append(Run("".join(_RAISED[c] for c in part), True, "sup", back=True))
    return [*runs, Run(_RAISED[power], place="sup")] if power else runs


def _spaced(low: str) -> str:
    """Points that bear the number of their link after a digit of their own: `{B1_3,B1_2}` as the labels have it."""
    return low.strip("{}").replace("_", " ").replace(",", ", ") if low.startswith("{") else low.replace("@", " ")


def _italic(low: str) -> bool:
    """Names and letters are; digits, Chinese and the words for least and greatest stand upright."""
    return low.isalpha() and low.isascii() and low not in ("min", "max")


def _points(text: str) -> list[Run]:
    """`BD`, `O1B`, `n3′b3′`: each point with its digits below it."""
    names = _POINT.findall(text) or _NODE.findall(text)
    return [run for name in names for run in point_label(name.replace("′", "'").replace(",", "_"))]
