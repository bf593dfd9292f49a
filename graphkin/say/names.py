"""Points, vectors, links and quantities in plain text: `b3′`, `aᵏ_B3B2`, `ω3`, `l_BD`."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from functools import lru_cache

from graphkin.construction import Plane
from graphkin.model.naming import in_order, spelled
from graphkin.model.quantities.reading import respelled

LETTER: dict[Plane, str] = {"position": "l", "velocity": "v", "acceleration": "a"}
SCALE: dict[Plane, str] = {"position": "μ_l", "velocity": "μ_v", "acceleration": "μ_a"}
UNIT: dict[Plane, str] = {"position": "m", "velocity": "m/s", "acceleration": "m/s²"}
RATE: dict[Plane, str] = {"position": "θ", "velocity": "ω", "acceleration": "α"}
SLIDING: dict[Plane, str] = {"position": "s", "velocity": "ṡ", "acceleration": "s̈"}

_RAISED = {"n": "ⁿ", "t": "ᵗ", "k": "ᵏ", "r": "ʳ"}
_GREEK = {"theta": "θ", "omega": "ω", "alpha": "α"}
_COUNTED = re.compile(r"(?<=[a-z])(\w*\d)_(\d+)(?=')")  # the second corner of one letter and link: n4,1'
_STARTS = " origin"
_OPEN, _CLOSE = "\ue000", "\ue001"
_MARKED = re.compile(f"{_OPEN}(.*?){_CLOSE}")
_DEGREES = r" ?\bdeg\b"
_ARROW = r"(?<![A-Za-z0-9_])[va]\^[nktr]_[\w@]+(?:,[\w@]+)?"
_SURELY = (*(f"{word} " for word in _GREEK), "a_n ", "a_t ", "a_k ", "a_r ")  # no other words begin so


@lru_cache(4096)
def point(name: str) -> str:
    """A point of the mechanism or of a polygon (`B_guide` on a link called by a word), or a link.

    Auxiliary points (`*1`), and where the line of a contact starts (`c0 origin`), have no letter of their own: the
    marks that stand for them here are given letters by `lettered`.

    The links of lower-pair equivalents are called e, e2, ..; those that hold a rolling wheel f, the lines of centres
    of gears g.
    """
    if auxiliary(name) or name.endswith(_STARTS):
        return f"{_OPEN}{name}{_CLOSE}"
    text = _COUNTED.sub(r"\1,\2", spelled(name)).replace("@", "_")
    return text.replace("'''", "‴").replace("''", "″").replace("'", "′")


def auxiliary(name: str) -> bool:
    """It is a point that the mechanism has not (`*1`)."""
    return name.startswith("*")


def lettered(text: str, letters: dict[str, str], free: Iterator[str]) -> str:
    """Points without a letter take the next that is free, and keep it."""

    def letter(mark: re.Match[str]) -> str:
        return letters[mark[1]] if mark[1] in letters else letters.setdefault(mark[1], next(free))

    return _MARKED.sub(letter, text)


def stretch(tail: str, head: str) -> str:
    """The line between two points: `pb3`, `n3′b3′`; longer names stand apart."""
    long = len(_MARKED.sub("O", point(tail) + point(head))) > 8
    between = " " if long or re.search(r"@|_[^\W\d]", tail + head) else ""
    return point(tail) + between + point(head)


def triangle(*corners: str) -> str:
    """`△b2cd`; longer names stand apart."""
    return "△" + (" " if any("@" in corner for corner in corners) else "").join(map(point, corners))


def arrow(tail: str, head: str) -> str:
    """A direction from one point to another: A→B."""
    return f"{point(tail)}→{point(head)}"


def pair(first: str, second: str) -> str:
    """Two points of the mechanism in the order a textbook writes them: AB, BD, CD; OA, O1B."""
    return "".join(map(point, in_order(first, second)))


def vector(name: str) -> str:
    """`a^k_B3B2` as `aᵏ_B3B2`; two on one line as `(v_DG + v_S4D)`."""
    if "+" in name:
        return "(" + " + ".join(vector(half) for half in name.split("+")) + ")"
    parts = re.fullmatch(r"(\w)(?:\^(\w+))?_(.+)", name)
    assert parts is not None, name
    letter, part, low = parts.groups()
    sites = f"{{{point(low)}}}" if "@" in low else point(low)
    return letter + "".join(_RAISED[c] for c in part or "") + "_" + sites


def symbols(text: str) -> str:
    """A question as the field writes it: `aᵏ_B3B2` of `a_k B3B2`, `v_E,x` of `v_x E`, `ω3` of `omega 3`."""
    if " / " in text:
        return " / ".join(map(symbols, text.split(" / ")))
    word, _, of = text.partition(" ")
    letter, _, part = word.partition("_")
    sign = _GREEK.get(letter, letter)
    if not of:
        return text
    if sign != letter:
        return of_link(sign, of)
    if part in ("x", "y"):
        return f"{sign}_{point(of)},{part}"
    return sign + "".join(_RAISED[c] for c in part) + "_" + (f"{{{point(of)}}}" if "@" in of else point(of))


def of_link(symbol: str, link: str) -> str:
    """`ω3`; `ω_guide` for a link called by a word."""
    return symbol + ("" if link[0].isdigit() else "_") + point(link)


def relative(symbol: str, link: str, seen_from: str) -> str:
    """`ω21`; `ω_arm,base` for links called by words."""
    if len(link) == len(seen_from) == 1 and (link + seen_from).isdigit():
        return symbol + link + seen_from
    return f"{symbol}_{point(link)},{point(seen_from)}"


def of_slide(symbol: str, slide: str) -> str:
    """The symbol of a displacement, or of its rate, with the slide's name."""
    return f"{symbol}_{slide}"


def in_signs(text: str, known: Collection[str] | None = None) -> str:
    """Quantities and units that are typed, as they are written: `omega 3` as ω3, `rad/s^2` as rad/s².

    known  in sentences, where `a point` is no acceleration: the points' motions that there are
    """

    def signs(typed: str) -> str:
        sure = known is None or typed in known or typed.startswith(_SURELY) or "@" in typed
        return symbols(typed) if sure else typed

    text = re.sub(_ARROW, lambda arrow: vector(arrow[0]), respelled(text, signs))
    return re.sub(_DEGREES, "°", text).replace("/s^2", "/s²")
