"""The triangles that linkages of four links come down to: their angles and corners."""

from __future__ import annotations

import cmath
import math

from graphkin.model.mechanism import ROUNDING
from graphkin.studies.linkages.equal import even
from graphkin.studies.linkages.linkage import MotionRange

_ROUNDING = 1e-7
"""Lines at a smaller angle lie in line: positions are laid in line from 4e-5 on (`EVEN`)."""


def apex(first: complex, second: complex, near: float, far: float, side: float) -> complex:
    """The third corner of a triangle: `near` from the first, `far` from the second, to the left (side 1) of the two.

    On their line where it is nearly there: a link at its end, or a change point.
    """
    base = abs(second - first)
    along = (near * near - far * far + base * base) / (2 * base)
    gap = even(near - abs(along), near)
    height = math.sqrt(max(0.0, gap * (near + abs(along))))
    return first + complex(along, side * height) * (second - first) / base


def angles(one: float, other: float, far: float, farther: float) -> tuple[float, float]:
    """Least and greatest angle between two links that meet at a hinge of a four-bar; 0 and pi where nothing stops them.

    one, other    the two links; far, farther: the two opposite [m]
    """
    size = one + other + far + farther
    first = even(one + far - farther - other, size)
    second = even(one + farther - far - other, size)
    least = (far - farther) ** 2 if first * second < 0 else (one - other) ** 2
    stretched = even(one + other - far - farther, size) > 0
    return (
        _angle(one, other, least) if first * second < 0 else 0.0,
        _angle(one, other, (far + farther) ** 2) if stretched else math.pi,
    )


def _angle(one: float, other: float, square: float) -> float:
    """The angle between two sides of a triangle, the square of the third given."""
    return math.acos(limited((one * one + other * other - square) / (2 * one * other)))


def passes(length: float, other: float, offset: float) -> bool:
    """Whether a link turns fully against a line at an offset from its pivot, the other link reaching the line."""
    return even(length + abs(offset) - other, length + other) <= 0


def limited(cosine: float) -> float:
    """A sine or cosine that is at most 1 but for rounding."""
    return max(-1.0, min(1.0, cosine))


def spanned(least: float, greatest: float, drawn: float) -> MotionRange:
    """The directions of a link whose angle to a line goes from least to greatest (0 and pi: it passes the line).

    drawn   the link's angle at the drawn position [rad]: it tells on which side of the line a link stays
    """
    if least == 0 and greatest == math.pi:
        return MotionRange(0.0, math.tau, True)
    if least == 0:
        return MotionRange(-greatest, greatest)
    if greatest == math.pi:
        return MotionRange(least, math.tau - least)
    return MotionRange(least, greatest) if math.sin(drawn) >= 0 else MotionRange(-greatest, -least)


def folded(one: complex, other: complex) -> float:
    """The angle between two lines, 0 to pi/2 [rad]; 0 where it is 0 but for rounding."""
    product = one.conjugate() * other
    angle = math.atan2(abs(product.imag), abs(product.real))
    return 0.0 if angle < _ROUNDING else angle


def whole(angle: float) -> float:
    """The same direction from 0 to 2 pi; 0 or 2 pi but for rounding is 0."""
    turned = angle % math.tau
    return 0.0 if min(turned, math.tau - turned) <= ROUNDING else turned


def phase(vector: complex) -> float:
    """The direction of a vector, 0 to 2 pi."""
    return whole(cmath.phase(vector))
