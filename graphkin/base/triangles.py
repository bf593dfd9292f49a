"""Triangles of a plane that lie on one another, many at once."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from graphkin.base.geometry import Array

_SQUARE = np.stack(np.meshgrid(*2 * [np.linspace(0.04, 0.96, 12)])).reshape(2, -1)
_GRID = np.where(_SQUARE.sum(axis=0) > 1, 1 - _SQUARE, _SQUARE)  # places in a triangle, in parts of two of its sides


def shares_of(corners: tuple[complex, complex, complex], others: Array) -> Array:
    """The parts of a triangle, or of smaller ones of others (3, n), that lie in them (n,)."""
    alike, larger = np.array(corners)[:, None] + 0 * others, abs(_across(*corners)) > abs(_across(*others))
    small, large, (u, v) = np.where(larger, others, alike), np.where(larger, alike, others), _GRID[:, :, None]
    inside = small[0] + u * (small[1] - small[0]) + v * (small[2] - small[0])
    sides = np.array([_across(a, b, inside) for a, b in pairwise((*large, large[0]))])
    return np.asarray(((sides >= 0).all(axis=0) | (sides <= 0).all(axis=0)).mean(axis=0))


def _across(a: complex | Array, b: complex | Array, c: complex | Array) -> Array:
    """Twice the area of a triangle, with the sense of its turn."""
    return np.imag((b - a).conjugate() * (c - a))
