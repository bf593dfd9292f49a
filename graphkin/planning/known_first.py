"""The terms of one side of a vector equation in the order of the pencil: what is known first, the unknown one last.

A sum does not care for the order of its terms, and so drawn nothing has to be shifted. The points that lie behind the
unknown arrow in the natural order are no corners of the polygon then; they are drawn afterwards, in one line each.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from graphkin.construction import Drawn, LayOff, Term
from graphkin.value import frozen

if TYPE_CHECKING:
    from graphkin.planning.polygon import Polygon


@frozen
class Ordered:
    """A side in its new order, and the arrows that carry its unknown one back to where its points lie."""

    terms: tuple[Term, ...]
    carried: tuple[LayOff, ...] = ()


def known_first(polygon: Polygon, side: tuple[Term, ...]) -> Ordered:
    """A side whose one unknown term, if it has one, comes last; the unknown arrows of `polygon` follow it there."""
    at = next((k for k, term in enumerate(side) if term.unknowns), len(side))
    if at >= len(side) - 1:
        return Ordered(side)
    before, unknown, behind = side[:at], side[at], side[at + 1 :]
    tail, moved = unknown.tail, list[Term]()
    for term in behind:
        moved.append(replace(term, tail=tail, head=_corner(polygon, term)))
        tail = moved[-1].head
    last = replace(unknown, tail=tail, head=side[-1].head)
    polygon.unknown = {hop: last if term is unknown else term for hop, term in polygon.unknown.items()}
    return Ordered((*before, *moved, last), tuple(_carried(polygon, side[at:], moved, last)))


def _corner(polygon: Polygon, term: Term) -> str:
    """Where a known arrow ends that has moved: at its own corner, or at a new one where a point of a link was."""
    if polygon.nodes[term.head].site is None:
        return term.head
    link = polygon.structure.home(term.sites[0].link)
    return polygon.between(term.part[-1:] or "r", link, term.name(polygon.plane))


def _carried(polygon: Polygon, old: tuple[Term, ...], moved: list[Term], last: Term) -> Iterator[LayOff]:
    """The unknown arrow from where it belongs to the point it leads to; then the points behind, but the last."""
    unknown, *behind = old
    start = unknown.head
    yield LayOff(_copy(unknown, last.tail, last.head), unknown.tail, start)
    tail = unknown.tail
    for term, now in zip(behind[:-1], moved, strict=False):
        if polygon.nodes[term.head].site is not None:
            yield LayOff(_copy(term, tail, now.head), start, term.head)
            tail, start = now.head, term.head


def _copy(term: Term, tail: str, head: str) -> Term:
    """An arrow that is drawn already, between two points of the polygon, to be drawn again elsewhere."""
    return replace(term, size=Drawn(tail, head), direction=None)
