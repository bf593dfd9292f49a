"""Boxes and straight lines on paper, many at once: overlaps, crossings, distances.

All are places (2, ..), x and y of each [mm], or complex, that broadcast against one another; a box is its corners low
and high, a line its ends.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from graphkin.base.geometry import Array

_UPON = 0.1  # so near to a line another ends upon it [mm]


def xy(places: Array) -> Array:
    """Complex places (n,) as x and y of each (2, n)."""
    return np.array([places.real, places.imag])


def overlap(low: Array, high: Array, other_low: Array, other_high: Array) -> Array:
    """True where boxes overlap others; those that only touch do not."""
    both = (low < other_high) & (high > other_low)
    return np.asarray(both[0] & both[1])


def through(start: Array, end: Array, low: Array, high: Array) -> Array:
    """True where lines, whose surroundings overlap boxes, pass through these: no box lies on one side of its line. A
    level or upright line is as large as its surroundings, and does."""
    along, half = end - start, (high - low) / 2
    wide = abs(along)
    between = abs(_cross(along, (low + high) / 2 - start)) <= wide[0] * half[1] + wide[1] * half[0]
    return np.asarray(between | ~(wide[0] * wide[1] > 0))


def meet(start: Array, end: Array, other: Array, other_end: Array) -> Array:
    """True where lines cross others: each has its ends on both sides of the other, and none of them upon it."""
    along, other_along, off = end - start, other_end - other, other - start
    first, second, between = _cross(along, off), _cross(other_along, off), _cross(along, other_along)
    return np.asarray((first * (first + between) < 0) & (second * (second + between) < 0))


def cross_some(start: Array, end: Array, first: Array, last: Array) -> Array:
    """True for lines start..end (n,) that cross some of first..last, all complex; one that ends upon them does not."""
    end = end + (start - end) * np.minimum(0.5, _UPON / np.maximum(abs(start - end), _UPON))
    lines = *(xy(at)[..., None] for at in (start, end)), *(xy(at)[:, None] for at in (first, last))
    return np.asarray(meet(*lines).any(axis=1))


def _cross(along: Array, off: Array) -> Array:
    """The side of a line on which a place lies, by its sign."""
    return np.asarray(along[0] * off[1] - along[1] * off[0])


def off_lines(places: Array | complex, start: Array | complex, end: Array | complex) -> Array:
    """From the nearest place of a line to each place, all complex [mm]."""
    along, off = np.asarray(end - start), places - start
    part = np.clip((off * along.conj()).real / np.where(along == 0, 1.0, abs(along) ** 2), 0.0, 1.0)
    return np.asarray(off - part * along)


def off_boxes(low: Array, high: Array, start: Array, end: Array) -> Array:
    """Distance of boxes (m, 1, 2) from lines, complex (n,): (m, n); 0 where an end or a corner lies in the other."""
    (left, top), (right, bottom) = low.transpose(2, 0, 1), high.transpose(2, 0, 1)
    corners = np.array([x + 1j * y for x in (left, right) for y in (top, bottom)])
    ends = np.array([start, end])[:, None]
    across = np.maximum(np.maximum(left - ends.real, ends.real - right), 0.0)
    down = np.maximum(np.maximum(top - ends.imag, ends.imag - bottom), 0.0)
    off = abs(off_lines(corners, start, end)).min(axis=0)
    return np.asarray(np.minimum(off, np.hypot(across, down).min(axis=0)))


def free_about(places: Array | Sequence[complex], lines: Sequence[Sequence[complex]], most: float) -> Array:
    """Distance of each place (n,) from the nearest of some lines, so far as it matters; all complex [mm]."""
    ends = np.array(lines, dtype=complex).reshape(-1, 2).T
    return np.asarray(abs(off_lines(np.asarray(places)[:, None], *ends)).min(axis=1, initial=most))


def beyond(low: Array, high: Array, other_low: Array, other_high: Array) -> Array:
    """The length by which boxes would have to grow to all sides to reach others; less than 0: they overlap [mm]."""
    off = np.maximum(low - other_high, other_low - high)
    return np.asarray(np.maximum(off[0], off[1]))
