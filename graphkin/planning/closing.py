"""The drawing of a vector equation with two unknown scalars, in any plane.

The two sides run from known points to the point sought. Going in from both ends, what is known is laid
off; then the two direction lines (or circles) of the unknown arrows cross. A known arrow that stands
between the two unknown ones is laid off out of place first, and carried back once the crossing is found.

In a polygon a side is first put into the order of the pencil, what is known first, the unknown one last: a sum does not
care for the order of its terms, and so drawn nothing has to be shifted. The points that lie behind the unknown arrow in
the natural order are no corners of the polygon then; they are drawn afterwards, in one line each.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace

from graphkin.base.value import frozen
from graphkin.construction import Arc, Drawn, Equation, Given, LayOff, Meet, Ray, Span, Step, Term

Aside = Callable[[], str]  # names a point that only helps the drawing
Corner = Callable[[Term], str | None]
"""The end of a known arrow that has moved: at a new corner where a point of a link was, None where it was a corner."""


@frozen
class _Signed:
    """A term on the path from the start of the left side to the start of the right side."""

    term: Term
    forward: bool

    @property
    def near(self) -> str:
        return self.term.tail if self.forward else self.term.head

    @property
    def far(self) -> str:
        return self.term.head if self.forward else self.term.tail


def close(
    of: str, left: tuple[Term, ...], right: tuple[Term, ...], reaches: Mapping[Term, Span], aside: Aside | None = None,
    choice: Callable[[], int] | None = None, pole: str = "",
) -> Equation:  # fmt: skip
    """The equation left = right with the steps that draw it.

    reaches  for terms of known length and unknown direction (position plane): their length
    aside    names points between the two unknown arrows; a polygon's sides end in these, and have none
    choice   numbers a crossing that leaves two possibilities; direction lines cross once
    pole     the pole, where nothing is drawn yet: known arrows between the unknown ones are then laid off first,
             from anywhere, and both direction lines meet in the pole (极点后定)
    """
    path, (first, second) = _path(left, right)
    if pole_is_last(left, right, pole):
        one, *between, other = path if path[1].forward else _back(path)
        lines = _line(one.term, one.far), _line(other.term, other.near)
        return Equation(of, left, right, (Given(one.far), *_lay_off(between), *lines, Meet(*lines, pole)))
    steps = [*_lay_off(path[:first]), *_lay_off(_back(path[second + 1 :]))]
    middle, start = path[first + 1 : second], path[first].near
    for signed in middle:
        assert aside is not None
        tip = aside()
        steps.append(LayOff(signed.term, start, tip, backwards=not signed.forward))
        start = tip
    ends = (path[first].term, start), (path[second].term, path[second].far)
    loci = [Arc(at, reaches[term]) if term in reaches else _line(term, at) for term, at in ends]
    one_locus, other_locus = sorted(loci, key=lambda locus: isinstance(locus, Arc))
    chosen = choice() if choice is not None and isinstance(other_locus, Arc) else None
    steps += [one_locus, other_locus, Meet(one_locus, other_locus, path[second].near, choice=chosen)]
    steps += _lay_off(_back(middle))
    return Equation(of, left, right, tuple(steps))


def pole_is_last(left: tuple[Term, ...], right: tuple[Term, ...], pole: str) -> bool:
    """True if both sides begin with their unknown arrows, with known ones between, and the pole is free."""
    path, unknown = _path(left, right)
    return bool(pole) and unknown == [0, len(path) - 1] and len(path) > 2


def _path(left: tuple[Term, ...], right: tuple[Term, ...]) -> tuple[list[_Signed], list[int]]:
    """From the start of the left side to that of the right one, and where on it the unknown arrows stand."""
    path = [_Signed(term, True) for term in left] + [_Signed(term, False) for term in reversed(right)]
    return path, [k for k, signed in enumerate(path) if signed.term.unknowns]


def known_sum(of: str, left: Term, right: tuple[Term, ...]) -> Equation:
    """An equation whose one unknown arrow is the sum of known ones."""
    return Equation(of, (left,), right, tuple(_lay_off([_Signed(term, True) for term in right])))


def _back(path: Iterable[_Signed]) -> list[_Signed]:
    return [_Signed(signed.term, not signed.forward) for signed in reversed(list(path))]


def _lay_off(path: Iterable[_Signed]) -> list[Step]:
    """Known arrows one after another; what is drawn already needs no pencil."""
    return [LayOff(signed.term, signed.near, signed.far, backwards=not signed.forward) for signed in path
            if not isinstance(signed.term.size, Drawn)]  # fmt: skip


def _line(term: Term, through: str) -> Ray:
    assert term.direction is not None
    return Ray(through, term.direction)


Ordered = tuple[tuple[Term, ...], tuple[LayOff, ...], tuple[Term, Term] | None]
"""A side in its new order; the arrows that carry its unknown one back to where its points lie; the unknown term as it
was and as it is now, where it has moved."""


def known_first(side: tuple[Term, ...], corner: Corner) -> Ordered:
    """A side whose one unknown term, if it has one, comes last."""
    at = next((k for k, term in enumerate(side) if term.unknowns), len(side))
    if at >= len(side) - 1:
        return side, (), None
    before, unknown, behind = side[:at], side[at], side[at + 1 :]
    tail, moved = unknown.tail, list[Term]()
    for term in behind:
        moved.append(replace(term, tail=tail, head=corner(term) or term.head))
        tail = moved[-1].head
    last = replace(unknown, tail=tail, head=side[-1].head)
    again = [(unknown, last.tail, last.head, unknown.tail, unknown.head)]
    """Arrows to be drawn again: the unknown one where it belongs, then those behind but the last; where they are, and
    where they are to be."""
    tail, start = unknown.tail, unknown.head
    for term, now in zip(behind[:-1], moved, strict=False):
        if now.head != term.head:
            again.append((term, tail, now.head, start, term.head))
            tail, start = now.head, term.head
    carried = (LayOff(replace(term, size=Drawn(tail, head), direction=None), start, end)
               for term, tail, head, start, end in again)  # fmt: skip
    return (*before, *moved, last), tuple(carried), (unknown, last)
