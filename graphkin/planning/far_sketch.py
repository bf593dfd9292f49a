"""Links that do not reach each other, and a measure that the sketch has quite differently: probably the wrong one."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

from graphkin.errors import CannotAssemble, FarFromSketch, Where
from graphkin.model.mechanism import FRAME, Mechanism

FAR = 1.4
"""A sketch is rough: so many times longer or shorter than it is no matter."""


def cannot_assemble(
    mechanism: Mechanism, where: Where, called: tuple[str, ...], links: Sequence[str], gap_mm: float
) -> CannotAssemble:
    """The error that says what is open, and where one of these links is far from its sketch, that too."""
    if (worst := max(_apart(mechanism, links), default=None)) is None or worst[0] < FAR:
        return CannotAssemble(where, called, gap_mm)
    return FarFromSketch(where, called, gap_mm, *worst[1:])


def _apart(mechanism: Mechanism, links: Sequence[str]) -> list[tuple[float, str, float, float]]:
    """How many times each distance on a link is off the sketch, its two points, as sketched and as given [mm]."""
    places = {**mechanism.links[FRAME].points, **mechanism.sketch}
    found = []
    for link in links:
        own = mechanism.links[link].points if link in mechanism.moving else {}
        for one, other in combinations([point for point in own if point in places], 2):
            drawn, given = abs(places[other] - places[one]) * 1000, abs(own[other] - own[one]) * 1000
            if drawn > 0 and given > 0:
                found.append((max(drawn / given, given / drawn), one + other, drawn, given))
    return found
