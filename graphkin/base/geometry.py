"""Complex numbers as vectors of the drawing plane: where lines and circles meet.

Every function takes scalars or arrays alike (broadcast together) and never raises: what cannot meet is
NaN, and the sine of the angle at which two things cross is returned beside the point, so that the caller
decides how close to parallel is too close. No word of mechanisms here.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable
from typing import Any, TypeAlias, overload

import numpy as np
from numpy.typing import NDArray

Array: TypeAlias = NDArray[Any]  # an array over positions, pencils, students

Real: TypeAlias = float | Array  # a real number, or an array of them: lengths, angles, rates

Value: TypeAlias = float | complex | Array
"""A real or a complex number, or an array of either: x + iy is a vector of the plane."""

Leg = Callable[[Real, Real], Real]
"""A function for the other leg of a right-angled triangle: `leg`, or its stand-in where values are no numbers."""

_ROUNDING = 4e-15  # rounding of squares, as part of their size
_HALF_TURN = 1e-9  # angles as near to a half turn are one, whichever way they turn [rad]


def dot(a: Value, b: Value) -> Real:
    """Scalar product of two vectors."""
    return (np.conj(a) * b).real


def cross(a: Value, b: Value) -> Real:
    """z component of the vector product: positive where b is counter-clockwise of a."""
    return (np.conj(a) * b).imag


def unit(a: Value) -> Value:
    """Vector of length 1 along `a`; NaN for the zero vector."""
    with np.errstate(divide="ignore", invalid="ignore"):
        try:
            return a / np.abs(a)
        except ZeroDivisionError:  # of a Python number
            return complex(np.nan, np.nan)


@overload
def phase(a: complex) -> float: ...
@overload
def phase(a: Value) -> Real: ...
def phase(a: Value) -> Real:
    """The angle of a vector from +x, above -pi [rad]."""
    return cmath.phase(a) if isinstance(a, complex | float | int) else np.angle(a)


def wrapped(angle: Real) -> Real:
    """An angle without whole turns, above -pi to pi; what is -pi but for rounding is pi [rad]."""
    turned = np.angle(np.exp(1j * angle))
    return np.where(turned < _HALF_TURN - np.pi, turned + 2 * np.pi, turned)[()]


def leg(hypotenuse: Real, other: Real) -> Real:
    """The other leg of a right-angled triangle; 0 where it is 0 but for rounding, NaN where there is none."""
    square = np.asarray((hypotenuse - other) * (hypotenuse + other), dtype=float)
    with np.errstate(invalid="ignore"):
        return np.sqrt(np.where((square < 0) & (square > -_ROUNDING * hypotenuse * hypotenuse), 0.0, square))[()]


PARALLEL = 1e-6  # lines under a smaller sine meet anywhere: at a dead point half the digits of their angle are lost


def sure_sine(sine: Real) -> Real:
    """The sine of the angle between lines; nan where only rounding tells where they meet."""
    return np.where(np.abs(sine) < PARALLEL, np.nan, sine)[()]


def meet_lines(
    p: Value, u: Value, q: Value, w: Value, known: Callable[[Real], Real] = sure_sine
) -> tuple[Value, Real]:
    """The point in which the line through p along u meets the line through q along w (u, w of length 1).

    Returns the point, nan where there is none, and the sine of the angle between the lines.
    """
    sine = cross(u, w)
    with np.errstate(divide="ignore", invalid="ignore"):
        return p + u * (cross(q - p, w) / known(sine)), np.abs(sine)


def meet_line_circle(p: Value, u: Value, c: Value, r: Real, side: Real, leg: Leg = leg) -> tuple[Value, Real, Real]:
    """A point in which the line through p along u meets the circle about c; side +1 is the crossing farther along u.

    Returns the point, the sine of the angle between line and circle, and by how much they miss each
    other (0 or less where they meet).
    """
    foot = p + u * dot(u, c - p)
    distance = np.abs(c - foot)
    half = leg(r, distance)
    with np.errstate(divide="ignore", invalid="ignore"):
        return foot + side * half * u, half / r, distance - r


def meet_circles(
    c1: Value, r1: Real, c2: Value, r2: Real, side: Real, leg: Leg = leg
) -> tuple[Value, Real, Real]:
    """A point in which two circles meet; side +1 is the crossing to the left of the way from c1 to c2.

    Returns the point, the sine of the angle between the circles, and by how much they miss each other.
    """
    d = np.abs(c2 - c1)
    e = unit(c2 - c1)
    with np.errstate(divide="ignore", invalid="ignore"):
        along = (d * d + r1 * r1 - r2 * r2) / (2 * d)
        height = leg(r1, along)
        sine = d * height / (r1 * r2)
    miss = np.maximum(d - (r1 + r2), np.abs(r1 - r2) - d)
    return c1 + (along + 1j * side * height) * e, sine, miss


def number(value: Value) -> float:
    """A real value at one position, as a plain number."""
    return float(value.real)


def place(value: Value) -> complex:
    """A vector at one position, as a plain number."""
    return complex(value)


def third_corner(first: Value, second: Value, ratio: Value) -> Value:
    """Of a triangle: `ratio` is the way to it from the first corner by that to the second one."""
    return first + (second - first) * ratio


def weights_of(x: np.ndarray, places: np.ndarray) -> np.ndarray:
    """Lagrange's weights of neighbours at places (k,), for x (m,): (m, k). What they lead to is a weighted sum."""
    weights = np.ones((x.size, places.size))
    for k, place in enumerate(places):
        for other in np.delete(places, k):
            weights[:, k] *= (x - other) / (place - other)
    return weights
