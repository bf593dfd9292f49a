"""Picture."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field

import numpy as np

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
        along = (to * self.right.conjugate()).real
        across = (to * self.up.conjugate()).real
        over = max(-along, along - self.width, 0.0)
        off = max(-self.below - across, across - self.above, 0.0)
        return abs(complex(over, off))


@frozen
class Dot:
    """A marked point; `name` where the file itself names it, `plane` where it says the plane as well."""

    place: complex
    name: str = ""
    plane: Plane | None = None


@frozen
class PictureArrow:
    """A vector that bears a name in the file."""

    name: str
    tail: complex
    head: complex


@frozen
class PagePicture:
    """What is on the page.

    lines   straight pieces; scales: those the file states as data, SI per mm
    """

    lines: tuple[tuple[complex, complex], ...] = ()
    dots: tuple[Dot, ...] = ()
    texts: tuple[PictureText, ...] = ()
    arrows: tuple[PictureArrow, ...] = ()
    scales: Mapping[Plane, float] = field(default_factory=dict)


_TOUCH = 0.2
"""Lines nearer to each other are joined [mm]."""
_LARGEST = 2_000
"""Lines of a figure that are followed at most; of a larger one nothing is told."""

Line = tuple[complex, complex]


class Figures:
    """The lines of a page, and what hangs together with a place."""

    def __init__(self, lines: Sequence[Line]) -> None:
        ends = np.array(lines, dtype=complex).reshape(-1, 2)
        self._tails, self._heads = ends[:, 0], ends[:, 1]

    def about(self, place: complex) -> Sequence[Line]:
        """The lines that hang together with a place, one through another; none where no line is there."""
        found = self._off(np.array([place])) <= _TOUCH
        new = np.flatnonzero(found)
        while new.size:
            if found.sum() > _LARGEST:
                return ()
            touched = np.zeros(len(found), dtype=bool)
            for k in new:
                touched |= self._touching(int(k))
            new = np.flatnonzero(touched & ~found)
            found |= touched
        return [(complex(self._tails[k]), complex(self._heads[k])) for k in np.flatnonzero(found)]

    def _touching(self, k: int) -> np.ndarray:
        """Which lines end on line k or cross it, or on which it ends."""
        tail, head = self._tails[k], self._heads[k]
        near = (self._off(np.array([tail])) <= _TOUCH) | (self._off(np.array([head])) <= _TOUCH)
        for ends in (self._tails, self._heads):
            near |= distances(ends, np.array([tail]), np.array([head])) <= _TOUCH
        one, other = _sides(self._tails, self._heads, tail, head), _sides(tail, head, self._tails, self._heads)
        found: np.ndarray = near | (one & other)
        return found

    def _off(self, place: np.ndarray) -> np.ndarray:
        return distances(place, self._tails, self._heads)


def distances(places: np.ndarray, tails: np.ndarray, heads: np.ndarray) -> np.ndarray:
    """Of places from pieces of lines, broadcast [mm]."""
    along = heads - tails
    size = np.abs(along) ** 2
    share = ((places - tails) * along.conj()).real / np.where(size > 0, size, 1.0)
    found: np.ndarray = np.abs(places - tails - np.clip(share, 0.0, 1.0) * along)
    return found


def _sides(tail: np.ndarray, head: np.ndarray, start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Whether two points lie on either side of a line."""
    way = end - start
    one, other = ((way.conj() * (point - start)).imag for point in (tail, head))
    found: np.ndarray = one * other < 0
    return found
