"""`ask`: a question that names a link, a point or a slide must name one that is there. Other texts are free."""

from __future__ import annotations

import re

from graphkin.errors import GraphkinError, NotOneOf, UnknownLink, UnknownPoint, UnknownSlide, Where
from graphkin.loading.draft import Draft
from graphkin.mechanism import Mechanism
from graphkin.naming import pair, seen

__all__ = ["QUANTITIES", "check_questions", "misnamed"]

QUANTITIES = ("theta", "omega", "alpha", "s", "v", "a", "a_n", "a_t", "a_k", "a_r")


def check_questions(draft: Draft, mechanism: Mechanism) -> None:
    """Note every question about something that is not there."""
    for number, question in enumerate(mechanism.ask):
        for part in question.split("/"):
            problem = misnamed(mechanism, part, draft.where("ask", number))
            if problem is not None:
                draft.problems.append(problem)


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
    alone = seen(mechanism, of) if quantity in ("v", "a") else None
    return None if alone or pair(mechanism, of) else UnknownPoint(where, of, mechanism.points)
