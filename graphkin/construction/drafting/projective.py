"""Points and lines as three homogeneous coordinates: a join and a meeting are one product, and infinity is a place.

A point is (x, y, w), a direction where w = 0; a line is (a, b, c) with a x + b y + c w = 0. Each is (3,), or (3, n)
over positions; what two that coincide would give is NaN.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from graphkin.base.geometry import Value

Homogeneous = Any
"""Three coordinates (3,) or (3, n)."""

INFINITE = 1e-9
"""A point farther off than the unit of coordinates divided by this counts as at infinity."""


def proper(at: Value) -> Homogeneous:
    """A point at a finite place."""
    return np.array([np.real(at), np.imag(at), np.ones_like(np.real(at))])


def improper(direction: Value) -> Homogeneous:
    """The point at infinity in a direction (unit vector)."""
    return np.array([np.real(direction), np.imag(direction), np.zeros_like(np.real(direction))])


def balanced(found: Homogeneous) -> Homogeneous:
    """The same point or line, its coordinates of length 1."""
    with np.errstate(divide="ignore", invalid="ignore"):
        return found / np.linalg.norm(found, axis=0)


def product(one: Homogeneous, other: Homogeneous) -> Homogeneous:
    """The line through two points, or the point on two lines."""
    (a, b, c), (d, e, f) = one, other
    return np.array(np.broadcast_arrays(b * f - c * e, c * d - a * f, a * e - b * d))


def joined(one: Homogeneous, other: Homogeneous) -> Homogeneous:
    """The line through two points; NaN where they are one but for rounding, as at infinity in one direction."""
    found = product(balanced(one), balanced(other))
    return np.where(np.linalg.norm(found, axis=0) > INFINITE, found, np.nan)


def place(point: Homogeneous, origin: complex = 0j, size: float = 1.0) -> Value:
    """Where a point is; infinite at infinity, NaN where it is nowhere."""
    x, y, w = point
    with np.errstate(divide="ignore", invalid="ignore"):
        far = np.abs(w) <= INFINITE * np.hypot(x, y)
        return scalar(np.where(far, np.where(np.hypot(x, y) > 0, np.inf, np.nan), origin + size * (x + 1j * y) / w))


def along(line: Homogeneous) -> Value:
    """The direction of a line (unit vector), from the first to the second of two points that it joins."""
    a, b, _ = line
    with np.errstate(divide="ignore", invalid="ignore"):
        return scalar((b - 1j * a) / np.hypot(a, b))


def foot(line: Homogeneous) -> Value:
    """The point of a line that is nearest to the origin of coordinates."""
    a, b, c = line
    with np.errstate(divide="ignore", invalid="ignore"):
        return scalar(-c * (a + 1j * b) / (a * a + b * b))


def scalar(value: Value) -> Value:
    """An array as it is, a single value as Python's own."""
    return value if np.ndim(value) else np.asarray(value).item()
