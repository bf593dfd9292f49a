"""What linkages have in common: ranges of a link's direction, and positions with their transmission angle."""

from __future__ import annotations

import math

from graphkin.value import frozen

__all__ = ["Position", "Range", "Turn", "folded", "spanned", "whole"]

_ROUNDING = 1e-7
"""Lines at a smaller angle lie in line: positions are laid in line from 4e-5 on (`model.EVEN`)."""


@frozen
class Range:
    """What a link or a slider goes through, from low to high [rad or m]; `full`: it turns round and round."""

    low: float
    high: float
    full: bool = False

    @property
    def width(self) -> float:
        return self.high - self.low


@frozen
class Position:
    """The linkage at one position that tells something.

    places   of its points, in the order of its names [m]
    turn     direction of the guide or of the bar [rad]; 0 for a four-bar
    driver   the driver's value, as its scale counts it [rad or m]
    output   the output link's direction or the slider's place [rad or m]
    gamma    transmission angle [rad], 0 to pi/2; None for a driver that has none
    how      "stretched", "folded": driven link and coupler in line; "inner", "outer": driven link in line with the
             frame, towards it or away; "far", "near", "across": see the linkages; "end": the driver's own end
    """

    places: tuple[complex, ...]
    turn: float
    driver: float
    output: float
    gamma: float | None
    how: str


@frozen
class Turn:
    """Whether two links can make a full turn against each other. `hinge`: whether they are neighbours."""

    first: str
    second: str
    full: bool
    hinge: bool


def spanned(least: float, greatest: float, drawn: float) -> Range:
    """The directions of a link whose angle to a line goes from least to greatest (0 and pi: it passes the line).

    drawn   the link's angle at the drawn position [rad]: it tells on which side of the line a link stays
    """
    if least == 0 and greatest == math.pi:
        return Range(0.0, math.tau, True)
    if least == 0:
        return Range(-greatest, greatest)
    if greatest == math.pi:
        return Range(least, math.tau - least)
    return Range(least, greatest) if math.sin(drawn) >= 0 else Range(-greatest, -least)


def folded(one: complex, other: complex) -> float:
    """The angle between two lines, 0 to pi/2 [rad]; 0 where it is 0 but for rounding."""
    product = one.conjugate() * other
    angle = math.atan2(abs(product.imag), abs(product.real))
    return 0.0 if angle < _ROUNDING else angle


def whole(angle: float) -> float:
    """The same direction from 0 to 2 pi, 2 pi itself (but for rounding) being 0."""
    turned = angle % math.tau
    return 0.0 if math.tau - turned < 1e-12 else turned
