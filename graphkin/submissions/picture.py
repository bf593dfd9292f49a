"""A drawing as far as it is measured: lines, dots, letters; in mm on the page, y up, whatever program saved it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

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
