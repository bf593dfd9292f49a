"""A drawing as far as it is measured: lines, dots, letters, in mm on the page, y up, whatever program saved it.

The mechanism and its polygons are figures of their own, of lines that hang together; letters recur in them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field

import numpy as np

from graphkin.base.boxes import off_lines
from graphkin.base.geometry import Array, Value, cross
from graphkin.base.value import frozen
from graphkin.construction import Plane


@frozen
class PictureText:
    """Letters on the page: they fill a box from `corner` along `right`, `width` long, `below` to `above` of its line.

    right   unit vector in which it is read; `up` is the one across it, towards the letters' tops
    """

    text: str
    corner: complex
    right: complex
    up: complex
    width: float
    above: float
    below: float = 0.0

    def distance(self, place: complex) -> float:
        """From its box [mm]; 0 within."""
        to = place - self.corner
        along, across = (to * self.right.conjugate()).real, (to * self.up.conjugate()).real
        return abs(complex(max(-along, along - self.width, 0.0), max(-self.below - across, across - self.above, 0.0)))


@frozen
class Dot:
    """A marked point; `name` where the file itself names it, `plane` where it says the plane as well."""

    place: complex
    name: str = ""
    plane: Plane | None = None


@frozen
class PictureArrow:
    """A vector that bears a name in the file; left_out: of one drawn broken, by what the file says [mm]."""

    name: str
    tail: complex
    head: complex
    left_out: float = 0.0


@frozen
class PagePicture:
    """The marks on a page.

    lines   straight pieces; scales: those the file states as data, SI per mm
    """

    lines: tuple[tuple[complex, complex], ...] = ()
    dots: tuple[Dot, ...] = ()
    texts: tuple[PictureText, ...] = ()
    arrows: tuple[PictureArrow, ...] = ()
    scales: Mapping[Plane, float] = field(default_factory=dict)


_TOUCH = 0.2  # lines nearer to each other are joined [mm]
_LARGEST = 2_000  # lines of a figure that are followed at most; of a larger one nothing is told

Line = tuple[complex, complex]


def lines_about(place: complex, lines: Sequence[Line]) -> Sequence[Line]:
    """The lines that hang together with a place, one through another; none where no line is there."""
    both = np.array(lines, dtype=complex).reshape(-1, 2)
    tails, heads = both[:, 0], both[:, 1]
    figure = abs(off_lines(place, tails, heads)) <= _TOUCH
    new = np.flatnonzero(figure)
    while new.size:
        if figure.sum() > _LARGEST:
            return ()
        touched = np.zeros(len(figure), dtype=bool)
        for tail, head in both[new]:  # the lines that end on this one or cross it, or on which it ends
            for end in (tail, head):
                touched |= abs(off_lines(end, tails, heads)) <= _TOUCH
            for ends in (tails, heads):
                touched |= abs(off_lines(ends, tail, head)) <= _TOUCH
            touched |= _parted(tails, heads, tail, head) & _parted(tail, head, tails, heads)
        new = np.flatnonzero(touched & ~figure)
        figure |= touched
    return [line for line, belongs in zip(lines, figure, strict=True) if belongs]


def _parted(tail: Value, head: Value, start: Value, end: Value) -> Array:
    """Flags of pairs of points that lie on either side of a line."""
    return np.asarray(cross(end - start, tail - start) * cross(end - start, head - start) < 0)
