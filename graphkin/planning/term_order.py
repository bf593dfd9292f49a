"""The terms of one side of a vector equation in the order of the pencil: what is known first, the unknown one last.

A sum does not care for the order of its terms, and so drawn nothing has to be shifted. The points that lie behind the
unknown arrow in the natural order are no corners of the polygon then; they are drawn afterwards, in one line each.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from graphkin.base.value import frozen
from graphkin.construction import Drawn, LayOff, Term

Corner = Callable[[Term], str | None]
"""Where a known arrow ends that has moved: at a new corner where a point of a link was, None where it was a corner."""


@frozen
class Ordered:
    """A side in its new order.

    carried  the arrows that carry its unknown one back to where its points lie
    moved    the unknown term as it was and as it is now, where it has moved
    """

    terms: tuple[Term, ...]
    carried: tuple[LayOff, ...] = ()
    moved: tuple[Term, Term] | None = None


def known_first(side: tuple[Term, ...], corner: Corner) -> Ordered:
    """A side whose one unknown term, if it has one, comes last."""
    at = next((k for k, term in enumerate(side) if term.unknowns), len(side))
    if at >= len(side) - 1:
        return Ordered(side)
    before, unknown, behind = side[:at], side[at], side[at + 1 :]
    tail, moved = unknown.tail, list[Term]()
    for term in behind:
        moved.append(replace(term, tail=tail, head=corner(term) or term.head))
        tail = moved[-1].head
    last = replace(unknown, tail=tail, head=side[-1].head)
    return Ordered((*before, *moved, last), tuple(_carried(side[at:], moved, last)), (unknown, last))


def _carried(old: tuple[Term, ...], moved: list[Term], last: Term) -> Iterator[LayOff]:
    """The unknown arrow from where it belongs to the point it leads to; then the points behind, but the last."""
    unknown, *behind = old
    start = unknown.head
    yield LayOff(_copy(unknown, last.tail, last.head), unknown.tail, start)
    tail = unknown.tail
    for term, now in zip(behind[:-1], moved, strict=False):
        if now.head != term.head:
            yield LayOff(_copy(term, tail, now.head), start, term.head)
            tail, start = now.head, term.head


def _copy(term: Term, tail: str, head: str) -> Term:
    """An arrow that is drawn already, between two points of the polygon, to be drawn again elsewhere."""
    return replace(term, size=Drawn(tail, head), direction=None)
