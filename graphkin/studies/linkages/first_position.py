"""A position to draw a linkage at where only its lengths are known: well off its driver's dead points."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

TURNS = tuple(math.radians(turn) for turn in (60, 100, 35, 140, 80, 15, 165))
"""Where the crank is drawn if nothing else is said: the first at which the driver is well off a dead point."""
_WELL = math.sin(math.radians(25))


def well_drawn(drawn: Sequence[tuple[complex, ...]], sine: Callable[..., float]) -> tuple[complex, ...]:
    """The first of several positions at which two lines cross well, else the one at which they cross best.

    sine   of the angle between the two, from the places of a position
    """
    good = (places for places in drawn if sine(*places) > _WELL)
    return next(good, max(drawn, key=lambda places: sine(*places)))


def sine(one: complex, other: complex) -> float:
    """Sine of the angle between two lines."""
    size = abs(one) * abs(other)
    return abs((one.conjugate() * other).imag) / size if size else 0.0
