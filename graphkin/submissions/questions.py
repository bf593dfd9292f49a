"""Names of quantities as students write them, made into what `quantities` reads: a normaliser, not a second reader.

`w3`, `ω₃`, `omega_3`, `aB3B2k`, `a^k_B3B2`, `v_{B3B2}`, `v C/B`, `α3 (rad/s²)`. Of several readings the first that
means something in the mechanism counts, and the one nearest to what was typed comes first.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import lru_cache
from typing import assert_never

from graphkin.files.values import split_points, tidy
from graphkin.model import quantities as kinds
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.naming import Seen
from graphkin.model.quantities import Centre, Quantity
from graphkin.model.quantities.reading import quietly
from graphkin.submissions.numbers import plain, unaccented, unit_named

LONGEST = 120  # no question is longer
_KINDS = {
    "angular velocity": "omega", "角速度": "omega", "angular acceleration": "alpha", "角加速度": "alpha",
    "velocity": "v", "速度": "v", "acceleration": "a", "加速度": "a",
}  # fmt: skip
_IN_WORDS = re.compile(rf"(.*?)({'|'.join(_KINDS)})(.*)", re.I)
_OF = re.compile(r"\b(?:of|the|link|point|speed)\b|构件|连杆|滑块|曲柄|[导摇]?杆件?|[点的]|大小", re.I)
_HEADS = (
    (r"omega|w|角速度", "omega"), (r"alpha|epsilon|角加速度", "alpha"), (r"theta|phi|转角", "theta"),
    (r"velocity of|velocity|速度|v", "v"), (r"acceleration of|acceleration|加速度|a", "a"),
    (r"displacement|位移|s", "s"), (r"x", "x"), (r"y", "y"),
)  # fmt: skip
_GREEK = str.maketrans({
    "ω": "omega", "Ω": "omega", "ϖ": "omega", "α": "alpha", "ɑ": "alpha", "ε": "epsilon", "ϵ": "epsilon",
    "θ": "theta", "ϑ": "theta", "φ": "phi", "ϕ": "phi", "τ": "t", "υ": "v", "ν": "v",
})  # fmt: skip
_DRESS = re.compile(r"\\(?:vec|overline|bar|mathrm|mathbf|boldsymbol|text|var)?\b|[{}$|\"\\]")
_PARTS = {"n": "n", "t": "t", "tau": "t", "k": "k", "c": "k", "cor": "k", "coriolis": "k", "r": "r", "x": "x", "y": "y"}
_PART = "coriolis|cor|tau|[ntkcrxy]"
_IN_UNIT = re.compile(
    r"^(.+?)\s*(?:[(\[]([^()\[\]]+(?:\([^()]*\))?[^()\[\]]*)[)\]]"
    r"|/ ?\(([^()]+)\)|, ?([^,]+)|/ ?([a-z°/^0-9*-]+)| in (.+))$",
    re.I,
)
"""`ω3 (rad/s)`, `ω3 [rad/s]`, `ω3/(rad·s^-1)`, `ω3, rad/s`, `ω3/rad/s`, `ω3 in rad/s`."""


class Questions:
    """The quantities of one mechanism, by whatever name; what was read once is remembered."""

    def __init__(self, mechanism: Mechanism, asked: tuple[str, ...] = ()) -> None:
        self.mechanism = mechanism
        self.asked: dict[object, str] = {}
        self._words: dict[str, list[str]] = {}
        self.read = lru_cache(10_000)(self._read)
        for text in asked:
            if (quantity := quietly(mechanism, text)) is not None:
                self.asked.setdefault(_meaning(mechanism, quantity), text)
                self._words.setdefault(quantity.word, []).append(text)

    def _read(self, text: str) -> tuple[str, Quantity, str] | None:
        """The key's words for what a text names, the quantity, and the unit that stands with it ("" for none)."""
        unit, quantity = "", self._quantity(text) if len(text) <= LONGEST else None
        if quantity is None and len(text) <= LONGEST and (cut := _IN_UNIT.match(plain(text))) is not None:
            unit = unit_named(next(unit for unit in cut.groups()[1:] if unit))
            quantity = self._quantity(cut[1])
        if quantity is None:
            return None
        own = quantity.text.replace(" ", "") if isinstance(quantity, Centre) else quantity.text
        return self.asked.get(_meaning(self.mechanism, quantity), own), quantity, unit

    def _quantity(self, text: str) -> Quantity | None:
        """By any of its spellings; by two points of a link, `omega BC`; by a word that the key asks once, `a^k`."""
        for candidate in spelled(text):
            if (quantity := quietly(self.mechanism, candidate)) is not None:
                return quantity
            word, _, of = candidate.partition(" ")
            points = split_points(of)
            if word in ("omega", "alpha") and len(points) == 2:
                links = self.mechanism.links.items()
                fits = [name for name, link in links if set(points) <= set(link.points) and name != FRAME]
                if len(fits) == 1:
                    return quietly(self.mechanism, f"{word} {fits[0]}")
        word = re.sub(r"[ ^{}_$\\]", "", plain(text).translate(_GREEK)).lower()
        asked = [texts for name, texts in self._words.items() if name.replace("_", "") == word]
        return quietly(self.mechanism, asked[0][0]) if len(asked) == 1 and len(asked[0]) == 1 else None


def begins_like_one(text: str) -> bool:
    """True where a text begins as quantities do, of whatever mechanism: `ω3`, `aB3B2k`, `v_C`; and no id such as s1."""
    bare = plain(text[:LONGEST]).translate(_GREEK)
    for pattern, word in _HEADS:
        head = re.match(pattern, bare, re.I)
        after = "[ _^{0-9]" if word in ("omega", "alpha", "theta") else "[ _^{]|[ntkr]? ?[A-Z]"
        if head is not None and re.match(after, bare[head.end() :]) is not None:
            return True
    return False


def spelled(text: str) -> Iterator[str]:
    """Texts that `quantities` may read, the nearest to what was typed first."""
    bare = tidy(text.strip())
    yield bare
    bare = unaccented(_DRESS.sub(" ", plain(bare).translate(_GREEK)))
    bare = re.sub(r"\s+", " ", bare).strip()
    yield bare
    top, slash, bottom = bare.partition("/")
    if slash:
        yield from (f"{one} / {other}" for one in _one(top.strip()) for other in _one(bottom.strip()))
        bare = f"{top.rstrip()}{bottom.lstrip()}"
    yield from _in_words(bare)
    yield from _one(bare)


def _in_words(text: str) -> Iterator[str]:
    """`D点的速度`, `angular velocity of link 2`, `连杆的角速度 ω2`: a kind in words and what it is of."""
    if (match := _IN_WORDS.fullmatch(text)) is None:
        return
    word = _KINDS[match[2].lower()]
    before, after = (_OF.sub(" ", part).strip(" _:=") for part in match.group(1, 3))
    for candidate in _one(after):
        head, _, of = candidate.partition(" ")
        if head.partition("_")[0] == word and before in ("", of):
            yield candidate
    if not before or not after:
        yield from _one(f"{word} {before or after}")


def _one(text: str) -> Iterator[str]:
    """One quantity: the points as typed, then in capitals."""
    if re.match(r"[Pp][ _]?\S", text):
        yield "P" + text[1:].lstrip(" _").replace(" ", "")
    for pattern, word in _HEADS:
        head = re.match(pattern, text, re.I)
        if head is None or head.group() in ("A", "S", "X", "Y"):
            continue
        rest = text[head.end() :]
        if word in ("v", "a"):
            yield from _of_moving(word, rest)
            for candidate in _of_moving(word, rest):  # names of links after an @ stay
                head_word, _, of = candidate.partition(" ")
                yield f"{head_word} " + re.sub(r"(@[^,]*)|([^@]+)", lambda run: run[1] or run[2].upper(), of)
        else:
            of = rest.strip(" _^=:")
            yield f"{word} {of}"
            yield f"{word} {re.sub('[ _^]', '', of)}"
            if word in ("x", "y"):
                yield f"{word} {of.upper()}"


def _of_moving(word: str, rest: str) -> Iterator[str]:
    """The part may stand before the points or after them, raised or not."""
    tight = re.sub(r"[ _]", "", rest)
    marked = re.search(rf"\^\(?({_PART})\)?", tight, re.I)
    if marked is None:
        yield f"{word} {tight}"
    before, after = re.match(rf"({_PART})(?=[A-Za-z])", tight, re.I), re.search(rf"(?<=[\w']),?({_PART})$", tight, re.I)
    for part in (marked,) if marked else filter(None, (before, after)):
        which, of = _PARTS[part[1].lower()], tight[: part.start()] + tight[part.end() :]
        # of two points v is the velocity of sliding, which some write v_r
        yield f"v {of}" if (word, which, len(split_points(of))) == ("v", "r", 2) else f"{word}_{which} {of}"


def _meaning(mechanism: Mechanism, quantity: Quantity) -> object:
    """A quantity itself, however it is written: B2 is B where link 2 has the point."""

    def place(site: Seen) -> tuple[str, str]:
        by_link = site.explicit and site.link not in mechanism.owners.get(site.point, ())
        return site.point, site.link if by_link else ""

    match quantity:
        case kinds.Quotient(_, _, top, bottom):
            return _meaning(mechanism, top), _meaning(mechanism, bottom)
        case kinds.Component(word, _, _, whole):
            return word, _meaning(mechanism, whole)
        case kinds.Moving(word, _, site, seen_from):
            return word, place(site), seen_from and place(seen_from)
        case kinds.Place(word, _, _, site):
            return word, site.point
        case Centre(word, _, links):
            return word, frozenset(links)
        case kinds.Rotation(word, of) | kinds.Displacement(word, of):
            return word, of
        case kinds.Track():
            return quantity.text
        case _:
            assert_never(quantity)
