"""Two positions leave A and D free on their bisectors: a good choice, looked for on a grid of both."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from graphkin.base.geometry import cross, unit
from graphkin.studies.design.model import gamma_four

_COUNT = 161
_REACH = 2.5
"""How far from C1C2 and B1B2 pivots are looked for, in lengths of coupler and moves together."""
_SMALL = 0.15
"""No link shorter than this part of the longest."""


def chosen(
    points: Sequence[tuple[complex, complex]], a: complex | None, d: complex | None
) -> tuple[complex, complex]:
    """A and D: those given, and for what is free the pair with the largest least transmission angle.

    Crank-rockers that keep their branch come first, then double-cranks, then others that keep it.
    """
    (b1, c1), (b2, c2) = points
    size = abs(c1 - b1) + max(abs(b2 - b1), abs(c2 - c1))
    along_a = np.array([a]) if a is not None else _bisector(b1, b2, size)
    along_d = np.array([d]) if d is not None else _bisector(c1, c2, size)
    at, pivot = along_a[:, None], along_d[None, :]
    worth = _worth(at, pivot, points)
    row, column = np.unravel_index(int(np.argmax(worth)), worth.shape)
    return complex(along_a[row]), complex(along_d[column])


def _bisector(first: complex, second: complex, size: float) -> Any:
    way = np.linspace(-_REACH, _REACH, _COUNT) * size
    return (first + second) / 2 + 1j * unit(second - first) * way


def _worth(at: Any, pivot: Any, points: Sequence[tuple[complex, complex]]) -> Any:
    """Least transmission angle [rad] of a crank-rocker; less by 2 for a double-crank, by more for what is worse."""
    (b1, c1), (b2, c2) = points
    a, c, d, b = np.abs(b1 - at), np.abs(c1 - pivot), np.abs(pivot - at), abs(c1 - b1)
    sides = cross(pivot - c1, b1 - c1), cross(pivot - c2, b2 - c2)
    kept = sides[0] * sides[1] > 0
    shortest, longest = np.minimum(np.minimum(a, b), np.minimum(c, d)), np.maximum(np.maximum(a, b), np.maximum(c, d))
    turning = (shortest + longest < (a + b + c + d) / 2 * (1 - 1e-6)) & (np.minimum(a, d) == shortest)
    gamma = np.where(d > 0, gamma_four(a, b, c, d), 0.0)
    here = np.minimum(*(np.abs(side) / (c * b) for side in sides))
    worth = np.where(kept & turning, np.where(a == shortest, gamma, gamma - 2), np.where(kept, here - 4, here - 6))
    return np.where(shortest < _SMALL * longest, worth - 9, worth)
