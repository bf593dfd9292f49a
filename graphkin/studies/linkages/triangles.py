"""The triangles that linkages of four links come down to: lengths that close, angles, corners, a first position."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Mapping, Sequence

from graphkin.base.value import frozen
from graphkin.errors import NOWHERE, CannotClose, CannotDriveBy, NotALength, OnlyStretched
from graphkin.model.mechanism import ROUNDING

EVEN = 1e-9  # sums of lengths that differ by less than this part of all lengths together are equal: a change point
_IN_LINE = 1e-7  # lines at a smaller angle lie in line: positions are laid in line from 4e-5 on (`EVEN`)
TURNS = tuple(math.radians(turn) for turn in (60, 100, 35, 140, 80, 15, 165))
"""The crank is drawn at the first of these at which the driver is well off a dead point, if nothing else is said."""
_WELL = math.sin(math.radians(25))


@frozen
class MotionRange:
    """The range of a link or a slider, from low to high [rad or m]; `full`: it turns round and round."""

    low: float
    high: float
    full: bool = False

    @property
    def width(self) -> float:
        return self.high - self.low

    def turned(self, base: float) -> MotionRange:
        """The same range counted from a line that lies at `base` [rad]."""
        return MotionRange(base + self.low, base + self.high, self.full)


def even(difference: float, size: float) -> float:
    """A difference of sums of lengths, 0 where it is 0 but for rounding."""
    return 0.0 if abs(difference) <= EVEN * size else difference


def check_parts(links: Mapping[str, float], driver: str, drivers: tuple[str, ...], offset: float = 0.0) -> None:
    """Raises NotALength for links [m] and an offset, CannotDriveBy."""
    for name, length in links.items():
        if not (math.isfinite(length) and length > 0):
            raise NotALength(NOWHERE, name, f"{length * 1e3:g}")
    if not math.isfinite(offset):
        raise NotALength(NOWHERE, "e", f"{offset:g}")
    if driver not in drivers:
        raise CannotDriveBy(NOWHERE, driver, drivers)


def check_closing(long: str, length: float, others: list[str], rest: float) -> None:
    """Raises CannotClose, OnlyStretched where the others, of length `rest` together, do not span the longest [m]."""
    gap = even(length - rest, length + rest)
    if gap == 0:
        raise OnlyStretched(NOWHERE, long, " + ".join(others), length * 1e3)
    if gap > 0:
        raise CannotClose(NOWHERE, long, length * 1e3, " + ".join(others), rest * 1e3)


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

    def angle(square: float) -> float:
        """The angle at which the corners opposite are so far apart."""
        return math.acos(limited((one * one + other * other - square) / (2 * one * other)))

    size = one + other + far + farther
    first = even(one + far - farther - other, size)
    second = even(one + farther - far - other, size)
    least = (far - farther) ** 2 if first * second < 0 else (one - other) ** 2
    stretched = even(one + other - far - farther, size) > 0
    return angle(least) if first * second < 0 else 0.0, angle((far + farther) ** 2) if stretched else math.pi


def passes(length: float, other: float, offset: float) -> bool:
    """True if a link turns fully against a line at an offset from its pivot, the other link reaching the line."""
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
    return 0.0 if angle < _IN_LINE else angle


def whole(angle: float) -> float:
    """The same direction from 0 to 2 pi; 0 or 2 pi but for rounding is 0."""
    turned = angle % math.tau
    return 0.0 if min(turned, math.tau - turned) <= ROUNDING else turned


def phase(vector: complex) -> float:
    """The direction of a vector, 0 to 2 pi."""
    return whole(cmath.phase(vector))


def well_drawn(positions: Sequence[tuple[complex, ...]], sine: Callable[..., float]) -> tuple[complex, ...]:
    """The first of several positions at which two lines cross well, else the one at which they cross best.

    sine   of the angle between the two, from the places of a position
    """
    good = (places for places in positions if sine(*places) > _WELL)
    return next(good, max(positions, key=lambda places: sine(*places)))


def greatest_between(size: Callable[[float], float], low: float, high: float, rounds: int) -> float:
    """The place of a function's greatest value, by golden section."""
    part = (math.sqrt(5) - 1) / 2
    for _ in range(rounds):
        left, right = high - part * (high - low), low + part * (high - low)
        low, high = (low, right) if size(left) > size(right) else (left, high)
    return (low + high) / 2


def sine(one: complex, other: complex) -> float:
    """Sine of the angle between two lines."""
    size = abs(one) * abs(other)
    return abs((one.conjugate() * other).imag) / size if size else 0.0
