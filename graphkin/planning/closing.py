"""How a vector equation with two unknown scalars is drawn, in any plane.

The two sides run from known points to the point sought. Going in from both ends, what is known is laid
off; then the two direction lines (or circles) of the unknown arrows cross. A known arrow that stands
between the two unknown ones is laid off out of place first, and carried back once the crossing is found.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

from graphkin.base.value import frozen
from graphkin.construction import Arc, Drawn, Equation, Given, LayOff, Meet, Ray, Span, Step, Term

Aside = Callable[[], str]
"""Names a point that only helps the drawing."""


@frozen
class _Signed:
    """A term on the way from the start of the left side to the start of the right side."""

    term: Term
    forward: bool

    @property
    def near(self) -> str:
        return self.term.tail if self.forward else self.term.head

    @property
    def far(self) -> str:
        return self.term.head if self.forward else self.term.tail


def close(
    of: str,
    left: tuple[Term, ...],
    right: tuple[Term, ...],
    reaches: dict[Term, Span],
    aside: Aside,
    choice: Callable[[], int],
    pole: str = "",
) -> Equation:
    """The equation left = right with the steps that draw it.

    reaches  for terms of known length and unknown direction (position plane): their length
    choice   numbers a crossing that leaves two possibilities
    pole     the pole, where nothing is drawn yet: known arrows between the unknown ones are then laid off first,
             from anywhere, and both direction lines meet in the pole (极点后定)
    """
    way, unknown = _way(left, right)
    first, second = unknown
    if pole and _pole_between(way, unknown):
        return Equation(of, left, right, tuple(_pole_last(way, pole)))
    steps = [*_lay_off(way[:first]), *_lay_off(_back(way[second + 1 :]))]
    middle = way[first + 1 : second]
    start = way[first].near
    for signed in middle:
        tip = aside()
        steps.append(LayOff(signed.term, start, tip, backwards=not signed.forward))
        start = tip
    lines = sorted(
        (_locus(way[first].term, start, reaches), _locus(way[second].term, way[second].far, reaches)),
        key=lambda locus: isinstance(locus, Arc),
    )
    chosen = choice() if isinstance(lines[1], Arc) else None
    steps += [*lines, Meet(lines[0], lines[1], way[second].near, choice=chosen)]
    steps += _lay_off(_back(middle))
    return Equation(of, left, right, tuple(steps))


def pole_is_last(left: tuple[Term, ...], right: tuple[Term, ...], pole: str) -> bool:
    """Whether both sides begin with their unknown arrows, with known ones between, and the pole is free."""
    return bool(pole) and _pole_between(*_way(left, right))


def _pole_between(way: list[_Signed], unknown: list[int]) -> bool:
    return unknown == [0, len(way) - 1] and len(way) > 2


def _way(left: tuple[Term, ...], right: tuple[Term, ...]) -> tuple[list[_Signed], list[int]]:
    """From the start of the left side to that of the right one, and where on it the unknown arrows stand."""
    way = [_Signed(term, True) for term in left] + [_Signed(term, False) for term in reversed(right)]
    return way, [k for k, signed in enumerate(way) if signed.term.unknowns]


def _pole_last(way: list[_Signed], pole: str) -> list[Step]:
    first, *middle, second = way if way[1].forward else _back(way)
    assert first.term.direction is not None
    assert second.term.direction is not None
    lines = Ray(first.far, first.term.direction), Ray(second.near, second.term.direction)
    return [Given(first.far), *_lay_off(middle), *lines, Meet(*lines, pole)]


def known_sum(of: str, left: Term, right: tuple[Term, ...]) -> Equation:
    """An equation whose one unknown arrow is the sum of known ones."""
    return Equation(of, (left,), right, tuple(_lay_off([_Signed(term, True) for term in right])))


def _back(way: Iterable[_Signed]) -> list[_Signed]:
    return [_Signed(signed.term, not signed.forward) for signed in reversed(list(way))]


def _lay_off(way: Iterable[_Signed]) -> list[Step]:
    """Known arrows one after another; what is drawn already needs no pencil."""
    return [
        LayOff(signed.term, signed.near, signed.far, backwards=not signed.forward)
        for signed in way
        if not isinstance(signed.term.size, Drawn)
    ]


def _locus(term: Term, through: str, reaches: dict[Term, Span]) -> Ray | Arc:
    if term in reaches:
        return Arc(through, reaches[term])
    assert term.direction is not None
    return Ray(through, term.direction)
