"""Letters: how the field writes its names (b₃′, a^n_CB), and how wide that is.

A label is a tuple of runs. Widths are those of Times (equal to Liberation Serif and Tinos), so a box around a label is
right on every machine that has one of them; Chinese characters are one em wide.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cache, lru_cache
from typing import Literal, NamedTuple

from graphkin.model.naming import spelled
from graphkin.model.units import significant

TITLE, LABEL, LEAST = 5.0, 3.5, 2.5
"""The three sizes of letters, steps of ISO 3098 [mm, the em of the font]: the title; all that may have subscripts, as
labels, headings, equations, and tables; numbers of steps, and plain words on the rim."""
SMALL = 0.7  # size of sub- and superscripts, against the letters they belong to
_DROP, _RISE = 0.22, -0.40
_ASCENT, _DESCENT = 0.68, 0.20
_BOLD = 1.08  # the width of bold letters, as a part of plain ones; figures are as wide

_ROMAN = (
    "250 333 408 500 500 833 778 180 333 333 500 564 250 333 250 278 500 500 500 500 500 500 500 500 500 500 278 278 "
    "564 564 564 444 921 722 667 667 722 611 556 722 722 333 389 722 611 889 722 722 556 722 667 556 611 722 722 944 "
    "722 722 611 333 278 333 469 500 333 444 500 444 500 444 333 500 500 278 278 500 278 778 500 500 500 500 333 389 "
    "278 500 500 722 500 500 444 480 200 480 541"
)
_ITALIC = (
    "250 333 420 500 500 833 778 214 333 333 500 675 250 333 250 278 500 500 500 500 500 500 500 500 500 500 333 333 "
    "675 675 675 500 920 611 611 667 722 611 611 722 722 333 444 667 556 833 667 722 611 722 611 500 556 722 611 833 "
    "611 556 556 389 278 389 422 500 333 500 500 444 500 444 278 500 500 278 278 444 278 722 500 500 500 500 389 389 "
    "278 500 444 667 444 444 389 400 275 400 541"
)
_OTHERS = (
    "ω658,706 α524,525 μ536,502 θ479,491 φ577,553 ψ626,621 γ442,394 °400,400 ·250,250 →1000,1000 "
    "×564,675 ²300,300 ³300,300 ′219,219 −564,675 ⊥1000,1000 ∥500,500 √1000,1000 ∽1000,1000 "
    "ṡ389,389 \u03080,0 ∆612,612 ∠896,896 …1000,1000"
)

_ALL = (
    *((chr(32 + k), *pair) for k, pair in enumerate(zip(_ROMAN.split(), _ITALIC.split(), strict=True))),
    *((entry[0], *entry[1:].split(",")) for entry in _OTHERS.split()),
)
_WIDTHS = {letter: (int(roman) / 1000, int(italic) / 1000) for letter, roman, italic in _ALL}
"""Roman and italic width of each letter [em]."""
_CORNER = re.compile(r"([a-z])_([^\W\d_]\w*?)(?:_(\d+))?('*)")
_WIDE = (("\u2160", "\u217f"), ("\u2460", "\u2473"), ("\u2e80", "\u9fff"), ("\uff00", "\uffef"))
"""Ranges of characters that are one em wide."""


class Run(NamedTuple):
    """Letters in one style. `back`: it stands over the subscript before it (a^n_CB, stacked); `bold`: asked for."""

    text: str
    italic: bool = False
    place: Literal["base", "sub", "sup"] = "base"
    back: bool = False
    bold: bool = False


Label = tuple[Run, ...]


@cache
def advance(text: str, italic: bool = False) -> float:
    """Width of letters [em]; what the table does not hold counts as half an em, a wide character as one."""
    return sum(1.0 if is_wide(c) else _WIDTHS.get(c, (0.5, 0.5))[italic] for c in text)


def is_wide(letter: str) -> bool:
    """True where a character is as wide as high, as Chinese ones are."""
    return letter > "\u2100" and any(first <= letter <= last for first, last in _WIDE)


def run_width(run: Run, size: float) -> float:
    """Width of a run of a label lettered at `size` [mm]."""
    return advance(run.text, run.italic) * run_size(run, size) * (_BOLD if run.bold and run.text[:1].isalpha() else 1.0)


def run_size(run: Run, size: float) -> float:
    """Size of the letters of a run of a label [mm]."""
    return size if run.place == "base" else SMALL * size


def bold(label: Label) -> Label:
    return tuple(run._replace(bold=True) for run in label)


def scripts(label: Label, size: float) -> list[tuple[Run, float, float]]:
    """Each run with where it starts and its height above the base line [mm, y down]."""
    placed: list[tuple[Run, float, float]] = []
    pen, low_start = 0.0, 0.0
    before = ""
    for run in label:
        if run.place == "sub" and before != "sub":
            low_start = pen
        start = low_start if run.back and before == "sub" else pen
        placed.append((run, start, {"base": 0.0, "sub": _DROP, "sup": _RISE}[run.place] * size))
        pen = max(pen, start + run_width(run, size))
        before = run.place
    return placed


@lru_cache(4096)
def width(label: Label, size: float) -> float:
    """Width of a whole label [mm]."""
    return max((start + run_width(run, size) for run, start, _ in scripts(label, size)), default=0.0)


@lru_cache(4096)
def box(label: Label, size: float) -> tuple[float, float, float]:
    """Width, height above the base line, depth below it [mm]."""
    places = {run.place for run in label}
    up = _ASCENT if "sup" not in places else -_RISE + _ASCENT * SMALL
    hanging = any(letter in "fgjpqyμφψγ,;()Q∥" for run in label for letter in run.text)
    down = _DROP + 0.05 if "sub" in places else (_DESCENT if hanging else 0.04)
    return width(label, size), up * size, down * size


def plain(text: str, italic: bool = False) -> Label:
    """A text as a label, upright or italic."""
    return (Run(text, italic),) if text else ()


def joined(labels: list[Label], between: str = ", ") -> Label:
    """`p, a, d`: several names of one place."""
    return tuple(run for k, label in enumerate(labels) for run in ((Run(between), *label) if k else label))


def _mixed(text: str, place: Literal["base", "sub", "sup"]) -> Label:
    """Letters italic, digits and signs upright, primes as primes."""
    parts = re.findall(r"[^\W\d_]+|[^A-Za-z]+", text.replace("'", "′"))
    upright = "min", "max"
    return tuple(Run(part, part[0].isalpha() and part.isascii() and part not in upright, place) for part in parts)


@lru_cache(4096)
def point_label(name: str) -> Label:
    """A point of the mechanism or of a polygon: `B`, `O1`, `b3'`, `n'`, `b'@guide''`: digits and links as subscripts.
    Points have one letter, and primes before their link; at a corner the link's word follows the letter: `n_boom'`."""
    name = spelled(name).replace("_", "@", 1) if " " in name else name
    if corner := _CORNER.fullmatch(name):
        letter, link, more, primes = corner.groups()
        low = f"{link},{more}" if more else link
        return (*plain(letter, italic=True), *_mixed(low, "sub"), *plain("′" * len(primes)))
    match = re.fullmatch(r"([A-Za-z^]+)(\d*(?:_\d+)?)('*)@?([^']*)('*)", name)
    if match is None:
        return _mixed(name, "base")
    letters, digits, own, link, primes = match.groups()
    first = (*plain(letters, italic=True), *_mixed(digits.replace("_", ","), "sub"), *plain("′" * len(own)))
    return (*first, *_mixed(link, "sub"), *plain("′" * len(primes)))


@lru_cache(4096)
def vector_label(name: str) -> Label:
    """`v_CB`, `a^n_B3D`, `v_B@guide`: the part stands above the subscript; `v_DG+v_S4D` are two in one."""
    if "+" in name:
        return joined([vector_label(half) for half in name.split("+")], " + ")
    match = re.fullmatch(r"(\w)(?:\^(\w+))?_(.+)", name)
    if match is None:
        return _mixed(name, "base")
    letter, part, low = match.groups()
    return quantity_label(letter, low.replace(",", ", ").replace("@", " "), part or "")


def link_label(name: str) -> Label:
    """A link's number, or its word, in italics."""
    return tuple(run._replace(italic=run.text != "′") for run in _mixed(name, "base"))


def between(names: Sequence[str]) -> str:
    """Links of a relative motion: `32`, but `r1/c1` where names are longer than a sign."""
    return ("/" if any(len(name.rstrip("'")) > 1 for name in names) else "").join(names)


def quantity_label(letter: str, low: str, part: str = "") -> Label:
    """`ω` and `3` as ω₃; `μ` and `v` as μ_v."""
    label = (Run(letter, True), *_mixed(low, "sub"))
    return (*label, Run(part, True, "sup", back=True)) if part else label


def number(value: float, digits: int = 4) -> Label:
    """A figure as people write it: 0.2712, −3.919, 0, 2×10⁻⁵; four digits are what paper gives."""
    mantissa, _, exponent = significant(value, digits).replace("-", "−").partition("e")
    if mantissa in ("0", "−0") or abs(value) < 1e-300:
        return plain("0")
    if not exponent:
        return plain(mantissa)
    power = exponent.replace("+", "").replace("−0", "−").lstrip("0")
    return (Run("10" if mantissa == "1" else f"{mantissa}×10"), Run(power, place="sup"))


def valued(name: Label, value: float, unit: str, digits: int = 4) -> Label:
    """`ψ = 40.54°`: what is called so, with its value."""
    return (*name, Run(" = "), *number(value, digits), *plain(unit))


_RAISED = dict(zip("ⁿᵗᵏʳ²³", "ntkr23", strict=True))
_LOW = r"(?:[^\s()（）/|²³·→、。，；：:,;.]|[,.](?=\w))+"
_SIGN = (
    r"(?P<letter>[A-Za-zα-ωṡ]\u0308?)(?P<part>[ⁿᵗᵏʳ]*)"
    rf"(?:_(?P<low>{_LOW})|(?P<digits>\d+)|(?<=[ⁿᵗᵏʳ]))(?P<power>[²³]?)(?![A-Za-z])"
)
_POINT = re.compile(r"[A-Z][0-9]*′*")
_POINTS = rf"(?:(?<=[⊥∥→·∆])|(?<=× )|(?<=[A-Z\d]/))(?:{_POINT.pattern})+|(?<![A-Za-z_])(?:{_POINT.pattern})+(?=→| =)"
_NUMBERED = rf"(?<![A-Za-z_])(?=[A-Z]*[\d′])(?:{_POINT.pattern}){{2,}}(?![A-Za-z])"
_NODE = re.compile(r"[a-z]\d*(?:_\d+|,\d+(?=′))?′*(?:(?<=′)\d+′*)?")
_CORNER_LETTER = r"(?:[a-z](?=_[a-z])|(?![ervxy]_[A-Z])[b-km-ru-z])"  # of n_lever′, n_OA′; v_E′ is a motion of E′
_WITH_WORD = rf"[A-Za-z]\d*′+_[^\W\d_]\w*′*|{_CORNER_LETTER}_[^\W\d_]\w*′+"  # b′_lever″, too
_WORDED = rf"(?<![A-Za-z])(?:[a-z]\d*′+)*(?:{_WITH_WORD})+(?:[a-z]\d*′+)*"
_EACH = re.compile(rf"{_WITH_WORD}|[a-z]\d*′+")
_STRETCH = (
    r"(?<![A-Za-z])(?:[a-z](?=[a-z][\d′])|[a-z]\d*(?:,\d+)?′+(?:\d+′*)?|[a-z]\d+(?:_\d+)?′*)+(?![A-Za-z\d²³])"
    r"|(?<=[·∆])(?:[a-z]\d*)+(?![A-Za-z_])|(?<=[∥⊥])[xy]\b|(?<![A-Za-z/])(?<!\d )[a-z]\d*[a-z]\d*(?= = )"
    r"|(?<== )[a-z]\d*(?:[a-z]\d*(?= ×)|(?=[a-z]_\w+ ×))|(?<=将 |段 )[a-z]\d*[a-z]\d*(?= )"
    r"|(?<= on )[a-z]\d*[a-z]\d*(?=[,.] )|(?<=: )[a-z]\d*[a-z]\d*(?=, carried)"
)
_ALONE = (  # `θ`, `K`, `AD`, `p`, `A` and `a` of a sentence where they are no words
    r"[α-ωΑ-Ω](?!\w)|(?<!\w)(?:m?C[mn](?!\w)|[av](?=²))"
    r"|(?<![\w°′’'\-])(?:[B-HJ-Z]|[A-HK-S]{2}|[A-H]{3,4}|A(?=[,.;:)、，。；）]|$| [\u4e00-\u9fff(（]))"
    r"(?![\w'’\-])|(?<=[^\s.:;] )A(?![\w'’\-])|A(?= (?:is|lies|moves|stays|above|below) )"
    r"|(?<![\w'’./(（°\-])(?<![^a-z]\d )(?<!^\d )(?:[b-ln-rt-z]"
    r"|a(?=[,;:)、，。；）]| ?[⊥∥\u4e00-\u9fff]| (?:lies|is|[=∽]) | and [a-z]\d*′*[ ,.]))′*(?![\w'’\-]|/min|\.[A-Za-z])"
)
_ANY = re.compile(f"(?P<worded>{_WORDED})|(?P<points>{_POINTS}|{_NUMBERED}|{_STRETCH})|{_SIGN}|(?P<alone>{_ALONE})")


@lru_cache(4096)
def formula(text: str) -> Label:
    """Quantities with their subscripts, powers raised, points in italics; what is neither stays as it is."""
    text = text.replace("\u2034", 3 * "\u2032").replace("\u2033", 2 * "\u2032")  # fonts have but one prime
    text = text.replace("△", "∆")  # a small one, in few fonts
    runs: list[Run] = []
    at = 0
    for match in _ANY.finditer(text):
        runs += plain(text[at : match.start()])
        if match["worded"]:
            for name in _EACH.findall(match["worded"]):
                runs += point_label(name.replace("′_", "'@").replace("′", "'"))
        elif match["alone"]:
            runs.append(Run(match["alone"], True))
        else:
            runs += _points(match["points"]) if match["points"] else _sign(match)
        at = match.end()
    return (*runs, *plain(text[at:]))


def points_label(text: str) -> Label:
    """`AB`, `O1B`: points one after another; a name in small letters as it is, in italics."""
    return tuple(_points(text)) or (Run(text, True),)


def _sign(match: re.Match[str]) -> list[Run]:
    """A letter, its subscript in italics (not so digits, Chinese, min and max), and its part or power above that."""
    letter, part, low, digits, power = match.group("letter", "part", "low", "digits", "power")
    low = low or digits or ""  # points that bear the number of their link after a digit: `{B1_3,B1_2}`, as in labels
    several = low.startswith("{") or ("_" in low and "," in low)
    low = low.strip("{}").replace("_", " ").replace(",", ", ") if several else low.replace("@", " ")
    runs = quantity_label(letter, low, "".join(_RAISED[c] for c in part))
    return [*runs, Run(_RAISED[power], place="sup")] if power else [*runs]


def _points(text: str) -> list[Run]:
    """`BD`, `O1B`, `n3′b3′`: each point with its digits below it."""
    names = _POINT.findall(text) or _NODE.findall(text)
    return [run for name in names for run in point_label(name.replace("′", "'").replace(",", "_"))]
