"""`ask`: a question that names a link, a point or a slide must name one that is there. Other texts are free."""

from __future__ import annotations

import re
from collections.abc import Iterator

from graphkin.errors import (
    NOWHERE,
    GraphkinError,
    NeedsTwo,
    NotOneOf,
    OnlyShown,
    UnknownLink,
    UnknownPoint,
    UnknownSlide,
    Where,
)
from graphkin.loading.draft import Draft
from graphkin.mechanism import FRAME, Mechanism
from graphkin.naming import Seen, pair, seen

__all__ = ["QUANTITIES", "check_questions", "misnamed", "near_miss", "refuse_misnamed", "remarks"]

QUANTITIES = (
    "theta", "omega", "alpha", "s", "v", "a", "a_n", "a_t", "a_k", "a_r", "x", "y", "v_x", "v_y", "a_x", "a_y"
)  # fmt: skip
OF_TWO = ("a_n", "a_t", "a_k", "a_r")
"""Parts of an acceleration seen from another point."""


def check_questions(draft: Draft, mechanism: Mechanism) -> None:
    """Note every question about something that is not there."""
    for number, question in enumerate(mechanism.ask):
        with draft.noting():
            refuse_misnamed(mechanism, question, draft.where("ask", number))


def refuse_misnamed(mechanism: Mechanism, question: str, where: Where) -> None:
    """Raises what is wrong with a quantity, or a quotient of two, that names something that is not there."""
    for part in question.split("/"):
        if (problem := misnamed(mechanism, part, where)) is not None:
            raise problem


def remarks(mechanism: Mechanism) -> Iterator[OnlyShown]:
    """Notes on questions that nearly are some."""
    for number, question in enumerate(mechanism.ask):
        if (meant := near_miss(mechanism, question)) is not None:
            yield OnlyShown(mechanism.where("ask", number), question, meant)


def near_miss(mechanism: Mechanism, question: str) -> str | None:
    """What a text that is only shown was probably to ask: `omega 3` for `omega3`, `v C` for `v_C`."""
    text = "".join(_GREEK.get(letter, letter) for letter in question.strip())
    for quantity in (name for name in _LONGEST_FIRST if text[: len(name)].lower() == name):
        of = text[len(quantity) :].lstrip(" _")
        meant = f"{quantity} {of}"
        if of and " " not in of and meant != question.strip() and misnamed(mechanism, meant, NOWHERE) is None:
            return meant
    return None


_LONGEST_FIRST = sorted(QUANTITIES, key=len, reverse=True)
_GREEK = {"ω": "omega", "α": "alpha", "θ": "theta", "φ": "theta"}


def misnamed(mechanism: Mechanism, text: str, where: Where) -> GraphkinError | None:
    """What is wrong with a text that reads like a quantity, but names nothing that is there."""
    words = re.fullmatch(r"(\w+) +(\S+)", text.strip())
    return _problem(mechanism, where, words[1], words[2]) if words else None


def _problem(mechanism: Mechanism, where: Where, quantity: str, of: str) -> GraphkinError | None:
    if quantity not in QUANTITIES:
        import difflib

        near = len(quantity) > 3 and difflib.get_close_matches(quantity, QUANTITIES, 1, 0.7)
        named = of in mechanism.links or seen(mechanism, of) is not None
        return NotOneOf(where, quantity, QUANTITIES) if near and named else None
    if quantity in QUANTITIES[:3]:
        known = of in mechanism.moving or of == mechanism.frame
        return None if known else UnknownLink(where, of, mechanism.moving)
    if quantity == "s":
        slides = tuple(p.name for p in mechanism.slides) + tuple(p.name for p in mechanism.rolls)
        return None if of in slides else UnknownSlide(where, of, slides)
    alone, two = seen(mechanism, of), pair(mechanism, of)
    if quantity in OF_TWO:
        if alone is not None and two is None:
            return NeedsTwo(where, quantity, of, _others(mechanism, alone, quantity))
        alone = None
    if quantity in ("x", "y"):
        two = None
    return None if alone or two else UnknownPoint(where, of, mechanism.points)


def _others(mechanism: Mechanism, of: Seen, quantity: str) -> tuple[str, ...]:
    """What may be meant: the point of another link under this one, or another point of the same link."""
    if quantity in ("a_n", "a_t"):
        links = [mechanism.links[link].points for link in mechanism.owners[of.point] if link != FRAME]
        return tuple(dict.fromkeys(of.point + point for points in links for point in points if point[0].isupper()
                                   and point != of.point))  # fmt: skip
    return tuple(
        _coincident(mechanism, of.point, link, slide.guide)
        for slide in mechanism.slides if slide.point == of.point
        for link in ((slide.block,) if slide.block else mechanism.owners[of.point]) if link not in (FRAME, slide.guide)
    )  # fmt: skip


def _coincident(mechanism: Mechanism, point: str, *links: str) -> str:
    """`P1P2`, or `P@pin,P@wheel`, as it would be read again."""
    names = [mechanism.called(link) for link in links]
    short = "".join(point + name for name in names)
    read = pair(mechanism, short)
    plain = read is not None and tuple((site.point, site.link) for site in read) == tuple((point, x) for x in links)
    return short if plain else ",".join(f"{point}@{name}" for name in names)
