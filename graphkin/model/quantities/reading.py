"""A quantity read from text: `theta 3`, `s ram`, `x E`, `path E`, `v E`, `a_x E`, `a_k B3B2`, `P13`, `omega 3/omega 1`.

The one reader of what `ask`, `sweep --of`, `find` and `--limit` name.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from graphkin import errors
from graphkin.base.cache import kept
from graphkin.errors import NOWHERE, GraphkinError, Where
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.naming import Seen, clear, pair, seen
from graphkin.model.pairs import RollingContact, Slide
from graphkin.model.quantities import kinds
from graphkin.model.quantities.kinds import Axis, Quantity, has_part

WORDS = (
    "theta", "omega", "alpha", "s", "v", "a", "a_n", "a_t", "a_k", "a_r", "x", "y", "path", "v_x", "v_y", "a_x", "a_y"
)  # fmt: skip
SHAPE = r"\S+ \S+(?: ?/ ?\S+ \S+)?"  # a quantity or a quotient, as a regular expression

_ONE = re.compile(r"(\w+) +(\S+)")
_COMMA = r",\s*(?=[a-z]\w* |P[\w@']+\s*(?:,|$))"
_LONGEST_FIRST = sorted(WORDS, key=len, reverse=True)
_AXES: dict[str, Axis] = {"x": "x", "y": "y"}
_GREEK = {"ω": "omega", "α": "alpha", "θ": "theta", "φ": "theta"}
_OF_LINKS = ("theta", "omega", "alpha")
_OF_NAMES = (*_OF_LINKS, "s")  # of a link or a slide, not of points
_OF_TWO = ("a_n", "a_t", "a_k", "a_r")  # parts of an acceleration seen from another point
_LONGEST = 500  # of a text that may name a quantity, in letters
_APART = r"(@[^\s,，]+)(?:\s*[,，]\s*|\s+)(?=[^\s,，@]+@)"  # two sites that are written `A@yoke A@block`
_AT = r"\s*[#＃]\s*([1-9][0-9]{0,3})(?![0-9])"
_TYPED = (
    r"(?<![A-Za-z0-9_])(?:(?:omega|alpha|theta) (?:e [crg]\d+[a-z]?|[\w'′]+)"
    r"|[sva](?:_[nktrxy])? [\w'′@,]*\w[\w'′@]*)"
)


def named(mechanism: Mechanism, text: str, where: Where) -> Quantity:
    """The quantity that must be there. Raises UnknownQuantity and what `read` raises."""
    if (quantity := read(mechanism, text, where)) is None:
        raise errors.UnknownQuantity(where, text, ())
    return quantity


@kept(32)  # what a file asks is read by everything that shows it
def read(mechanism: Mechanism, text: str, where: Where = NOWHERE) -> Quantity | None:
    """The quantity that a text names; None for a text that is only to be shown. Raises UnknownLink, UnknownPoint,
    UnknownSlide, NeedsTwo, NotOneOf for one that names something that is not there, TurnsAsItLikes for an idle one."""
    halves = [_one(mechanism, part.strip(), where) for part in text.split("/")]
    if len(halves) == 1:
        return halves[0]
    if len(halves) != 2 or halves[0] is None or halves[1] is None:
        return None
    top, bottom = halves[0], halves[1]
    quotable = top.unit == bottom.unit and not top.is_place and not bottom.is_place
    return kinds.Quotient(top.text, bottom.text, top, bottom) if quotable else None


def formed(text: str) -> bool:
    """True of a text that is written as a quantity or a quotient is, though this mechanism may have none of it."""
    words = [_ONE.fullmatch(half.strip()) for half in text.split("/")]
    return len(words) <= 2 and all(match is not None and match[1] in WORDS for match in words)


def parts(mechanism: Mechanism, text: str) -> tuple[Quantity, ...]:
    """Every quantity that a text speaks of, though the whole may be none: both of `v C / omega 3`."""
    halves = (quietly(mechanism, part) for part in text.split("/"))
    return tuple(half for half in halves if half is not None)


def split(text: str) -> list[str]:
    """The quantities of `--of`: between commas that a new one follows; `v B@guide,B@block` is one."""
    return [part.strip() for part in re.split(_COMMA, text) if part.strip()]


def meant(mechanism: Mechanism, question: str) -> str | None:
    """The quantity that a text that is only shown was probably to ask: `omega 3` for `omega3`, `v C` for `v_C`."""
    text = "".join(_GREEK.get(letter, letter) for letter in question.strip())
    for word in (name for name in _LONGEST_FIRST if text[: len(name)].lower() == name):
        of = text[len(word) :].lstrip(" _")
        better = f"{word} {of}"
        if of and " " not in of and better != question.strip() and quietly(mechanism, better) is not None:
            return better
    return None


def centre_of(mechanism: Mechanism, text: str) -> tuple[str, str] | None:
    """The two links that `P13`, `P31` or `P1,3'` means; None for a text that means none."""
    body = text.strip()
    if not body.startswith("P"):
        return None
    called = {mechanism.called(link): link for link in mechanism.links}
    first, comma, second = body[1:].partition(",")
    cuts = [(first, second)] if comma else [(body[1:k], body[k:]) for k in range(2, len(body))]
    for one, other in cuts:
        if one.strip() in called and other.strip() in called and one.strip() != other.strip():
            return called[one.strip()], called[other.strip()]
    return None


def at_position(text: str, number: int) -> str:
    """The name of a quantity at a position; the drawn one is the first, and is not said.

    >>> at_position("omega 3", 1), at_position("omega 3", 2)
    ('omega 3', 'omega 3 #2')
    """
    return text if number == 1 else f"{text} #{number}"


def position_of(text: str) -> tuple[str, int]:
    """The quantity's own name, with whatever else stands there, and the number of the position; 1 where none is said.

    >>> position_of("omega 3 #2"), position_of("ω3 #2 (rad/s)"), position_of("omega 3")
    (('omega 3', 2), ('ω3 (rad/s)', 2), ('omega 3', 1))
    """
    number = re.search(_AT, text)
    return (text, 1) if number is None else (text[: number.start()] + text[number.end() :], int(number[1]))


def respelled(text: str, write: Callable[[str], str]) -> str:
    """A running text with each quantity in it, typed as `omega 3` or `a_k B3B2`, as `write` has it."""
    return re.sub(_TYPED, lambda typed: write(typed[0]), text)


def spelled_out(mechanism: Mechanism, text: str) -> str:
    """A text with the points of links that are words as they are written everywhere: `v B@guide,B@block`."""

    def write(typed: str) -> str:
        word, of = typed.split(" ", 1)
        return typed if word in _OF_NAMES else f"{word} {clear(mechanism, of)}"

    return respelled(re.sub(_APART, r"\1,", text), write)


def quietly(mechanism: Mechanism, text: str) -> Quantity | None:
    """The quantity of `read`, None also for a text that names nothing."""
    try:
        return read(mechanism, text)
    except GraphkinError:
        return None


def _one(mechanism: Mechanism, text: str, where: Where) -> Quantity | None:
    if (links := centre_of(mechanism, text)) is not None:
        return kinds.Centre("P", text[1:], links)
    words = _ONE.fullmatch(text := re.sub(_APART, r"\1,", text)) if len(text) <= _LONGEST else None
    if words is None:
        return None
    word, of = words.groups()
    if word not in WORDS:
        # raises NotOneOf for a word that is nearly one, of something that is there
        import difflib

        near = len(word) > 3 and difflib.get_close_matches(word, WORDS, 1, 0.7)
        if near and (of in mechanism.links or seen(mechanism, of) is not None):
            raise errors.NotOneOf(where, word, WORDS)
        return None
    of = of if word in _OF_NAMES else clear(mechanism, of)
    if word in _OF_LINKS:
        # of a moving link; the frame's is only shown
        if of not in mechanism.moving and of != mechanism.frame:
            raise errors.UnknownLink(where, of, mechanism.moving)
        if of in mechanism.idle:
            raise errors.TurnsAsItLikes(where, text, of)
        return kinds.Rotation(word, of, of) if of in mechanism.moving else None
    if word == "s":
        # of a sliding pair, or of a wheel on a line; that of a wheel on a circle is only shown
        paths = {pair.name: pair.path for pair in mechanism.pairs if isinstance(pair, Slide | RollingContact)}
        if of not in paths:
            raise errors.UnknownSlide(where, of, tuple(paths))
        return kinds.Displacement("s", of, of) if paths[of] is not None else None
    if word == "path":
        return kinds.Track(word, of, _site(mechanism, where, of))
    head, _, last = word.rpartition("_")
    axis = _AXES.get(last)
    if axis is None:
        return _moving(mechanism, where, word, of)
    if not head:
        return kinds.Place(word, of, axis, _site(mechanism, where, of))
    whole = _moving(mechanism, where, head, of)
    return None if whole is None else kinds.Component(word, of, axis, whole)


def _site(mechanism: Mechanism, where: Where, of: str) -> Seen:
    site = seen(mechanism, of)
    if site is None:
        raise errors.UnknownPoint(where, of, _moving_there(mechanism, of) or mechanism.points)
    return site


def _moving(mechanism: Mechanism, where: Where, word: str, of: str) -> kinds.Moving | None:
    """A vector of one point or of two; a part that there is not of these two is only shown."""
    alone, two, part = seen(mechanism, of), pair(mechanism, of), word.partition("_")[2]
    if word in _OF_TWO:
        if alone is not None and two is None:
            raise errors.NeedsTwo(where, word, of, _others(mechanism, alone, word))
        alone = None
    if alone is not None:
        # the frame's guide on which the point stays
        guides = [slide for slide in mechanism.slides if slide.guide == FRAME and not alone.explicit]
        blocks = (() if slide.block is None else mechanism.links[slide.block].points for slide in guides)
        held = (slide.line.direction for slide, block in zip(guides, blocks, strict=True)
                if alone.point == slide.point or alone.point in block)  # fmt: skip
        return kinds.Moving(word, of, alone, along=next(held, None))
    if two is None:
        raise errors.UnknownPoint(where, of, _meant_points(mechanism, of, word))
    return kinds.Moving(word, of, *two, part) if has_part(mechanism, part, *two) else None


def _meant_points(mechanism: Mechanism, of: str, word: str) -> tuple[str, ...]:
    """The texts that may be meant by one that names no point: what moves there, or coincident points."""
    if moving := _moving_there(mechanism, of):
        return moving
    if word in ("a_n", "a_t"):
        return mechanism.points
    sites = [seen(mechanism, point) for point in mechanism.points if of.startswith(point) and of != point]
    return tuple(name for site in sites if site for name in _others(mechanism, site, "a_k")) or mechanism.points


def _moving_there(mechanism: Mechanism, of: str) -> tuple[str, ...]:
    """All points of a link of this name; the point of a sliding pair, a block's as its moving guide sees it."""
    for slide in mechanism.slides:
        if slide.name == of:
            moving = slide.block is not None and slide.guide != FRAME
            return (_coincident(mechanism, slide.point, slide.block or "", slide.guide) if moving else slide.point,)
    return mechanism.named(of) if of in mechanism.moving else ()


def _others(mechanism: Mechanism, of: Seen, word: str) -> tuple[str, ...]:
    """The texts that may be meant: the point of another link under this one, or another point of the same link."""
    if word in ("a_n", "a_t"):
        links = [mechanism.named(link) for link in mechanism.owners[of.point] if link != FRAME]
        return tuple(dict.fromkeys(of.point + point for points in links for point in points if point != of.point))
    return tuple(
        _coincident(mechanism, of.point, link, slide.guide)
        for slide in mechanism.slides if slide.point == of.point
        for link in ((slide.block,) if slide.block else mechanism.owners[of.point]) if link not in (FRAME, slide.guide)
    )  # fmt: skip


def _coincident(mechanism: Mechanism, point: str, *links: str) -> str:
    """`P1P2`, or `P@pin,P@wheel`, as it would be read again."""
    names = [mechanism.called(link) for link in links]
    short = "".join(point + name for name in names)
    both = pair(mechanism, short) if all(map(str.isdigit, names)) else None
    plain = both is not None and tuple((site.point, site.link) for site in both) == tuple((point, x) for x in links)
    return short if plain else ",".join(f"{point}@{name}" for name in names)
