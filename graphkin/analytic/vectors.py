"""Closed vector loops are made of arrows; an arrow's angle and length follow the unknowns linearly.

There is one arrow of length 1 for each link, along its axis, and one for each slide, from the line's
origin to the point (length s, turned by the guide). Where anything is, is a sum of these with fixed
complex coefficients, a `row`: r = row . arrows. One row serves position, velocity and acceleration.

Shapes: q is (..., n) for n unknowns, arrows are (..., m), rows are (..., m) or (r, m).
Source: Sun Huan, Theory of Machines, section 3-3 (complex vectors).
"""

from __future__ import annotations

from math import prod
from typing import Any

import numpy as np

from graphkin.base.cache import kept
from graphkin.base.value import frozen

Real = np.ndarray[Any, np.dtype[np.float64]]
Complex = np.ndarray[Any, np.dtype[np.complex128]]
Flags = np.ndarray[Any, np.dtype[np.bool_]]
Indices = np.ndarray[Any, np.dtype[np.intp]]
Numbers = np.ndarray[Any, np.dtype[Any]]
"""Arrays; as `numpy.typing` calls them, which takes its time to load."""


SMALL = 2**13
"""Products of fewer multiplications are done by one thread; dealt out to several, each waits for the slowest."""


def applied(matrix: Numbers, vectors: Numbers) -> Numbers:
    """A matrix (r, m) on vectors (..., m): (..., r)."""
    if vectors.size * len(matrix) < SMALL:
        return np.asarray(vectors @ matrix.T)
    return _sparse(vectors, len(matrix), _entries(matrix, 1))


def through(rows: Numbers, matrix: Numbers) -> Numbers:
    """Rows (.., m) times a matrix (m, n), as one product: of a stack numpy would do each small one by itself."""
    *many, m = rows.shape
    if rows.size * matrix.shape[1] < SMALL:
        return np.asarray((rows.reshape(prod(many), m) @ matrix).reshape(*many, matrix.shape[1]))
    return _sparse(rows, matrix.shape[1], _entries(matrix, 0))


def _sparse(rows: Numbers, count: int, entries: tuple[Numbers, ...]) -> Numbers:
    """The same product from the entries alone that are not 0: few, of a large matrix."""
    sources, values, columns, starts = entries
    found = np.zeros((*rows.shape[:-1], count), np.result_type(rows, values))
    if columns.size:
        found[..., columns] = np.add.reduceat(rows[..., sources] * values, starts, axis=-1)
    return found


@kept(32)
def _entries(matrix: Numbers, summed: int) -> tuple[Numbers, ...]:
    """The entries of a matrix that are not 0, to be summed along an axis: where along it, and value; in order of the
    other axis, the places there that have any, and where each begins."""
    ends = np.nonzero(np.moveaxis(matrix, summed, 1))
    values = np.moveaxis(matrix, summed, 1)[ends]
    return ends[1], values, *np.unique(ends[0], return_index=True)


Polar = tuple[Real, Complex]
"""Length and unit vector of each arrow (.., m)."""


@frozen
class LoopVectors:
    """How arrows hang on the unknowns q: angle = turning q, length = base + stretching q.

    What asks for `polar` works that out itself where it is not given.

    turning, stretching   (m, n)
    base                  (m,): 1 for a link's arrow, 0 for a slide's
    """

    turning: Real
    stretching: Real
    base: Real

    def polar(self, q: Real) -> Polar:
        """Length and unit vector of each arrow."""
        return self.base + applied(self.stretching, q), np.exp(1j * applied(self.turning, q))

    def at(self, q: Real, polar: Polar | None = None) -> Complex:
        length, unit = polar or self.polar(q)
        return length * unit

    def rate(self, q: Real, dq: Real, polar: Polar | None = None) -> Complex:
        """d/dt of each arrow: l' along it, l phi' across it."""
        length, unit = polar or self.polar(q)
        turn, stretch = applied(self.turning, dq), applied(self.stretching, dq)
        return np.asarray(unit * (stretch + 1j * length * turn))

    def acceleration(self, q: Real, dq: Real, ddq: Real, polar: Polar | None = None) -> Complex:
        """d2/dt2 of each arrow: l'' - l phi'^2 along it, l phi'' + 2 l' phi' (Coriolis) across it."""
        length, unit = polar or self.polar(q)
        turn, stretch = applied(self.turning, dq), applied(self.stretching, dq)
        along = applied(self.stretching, ddq) - length * turn**2
        return np.asarray(unit * (along + 1j * (length * applied(self.turning, ddq) + 2 * stretch * turn)))

    def slope(self, rows: Complex, q: Real, polar: Polar | None = None) -> Complex:
        """d(rows . arrows)/dq: (..., r, n) for rows (r, m)."""
        length, unit = polar or self.polar(q)
        turned = (1j * length * unit)[..., None, :] * rows
        stretched = unit[..., None, :] * rows
        return through(turned, self.turning) + through(stretched, self.stretching)
