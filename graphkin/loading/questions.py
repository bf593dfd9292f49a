"""`ask`: a question that names a link, a point or a slide must name one that is there. Other texts are free."""

from __future__ import annotations

import re

from graphkin.errors import GraphkinError, NotOneOf, UnknownLink, UnknownPoint, UnknownSlide
from graphkin.loading.draft import Draft
from graphkin.mechanism import Mechanism
from graphkin.naming import pair, seen

__all__ = ["check_questions"]

QUANTITIES = ("theta", "omega", "alpha", "s", "v", "a", "a_n", "a_t", "a_k", "a_r")


def check_questions(draft: Draft, mechanism: Mechanism) -> None:
    """Note every question about something that is not there."""
    for number, question in enumerate(mechanism.ask):
        for part in question.split("/"):
            words = re.fullmatch(r"(\w+) +(\S+)", part.strip())
            problem = _problem(draft, mechanism, number, words[1], words[2]) if words else None
            if problem is not None:
                draft.problems.append(problem)


def _problem(draft: Draft, mechanism: Mechanism, number: int, quantity: str, of: str) -> GraphkinError | None:
    where = draft.where("ask", number)
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
