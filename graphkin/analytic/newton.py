"""Close the vector loops numerically, for many positions at once.

`Closure` is loops with relations put in: what is left is y with loop(y) = 0. `close` is Newton's method
(Gauss-Newton where met constraints repeat each other); `search` is a damped search from far away.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from graphkin.analytic.elimination import Elimination, eliminate
from graphkin.analytic.loops import Loops
from graphkin.analytic.rules import Relation
from graphkin.analytic.vectors import Real

__all__ = ["Closed", "Closure", "close", "inverse", "search"]

_SETTLED = 1e-13
"""Newton steps below this are rounding."""


@dataclass(frozen=True)
class Closure:
    """Loops and the relations that hold with them; `c` (..., k) are the relations' right sides."""

    loops: Loops
    weights: Real
    known: Elimination

    @classmethod
    def of(cls, loops: Loops, relations: Sequence[Relation]) -> Closure:
        weights = loops.weights(relations)
        return cls(loops, weights, eliminate(weights))

    def matrix(self, q: Real) -> Real:
        """The matrix A of A y' = B: (..., 2r, y)."""
        return self.loops.slope(q) @ self.known.left

    def move(self, q: Real, y_step: Real) -> Real:
        return q + y_step @ self.known.left.T


@dataclass(frozen=True, slots=True)
class Closed:
    """Where Newton ended: unknowns (..., n), loops still open by `gap` (...), last step (...)."""

    q: Real
    gap: Real
    step: Real


def close(closure: Closure, q: Real, c: Real, steps: int = 12) -> Closed:
    """Newton from q, with the relations at c. A step is at most 1 rad, or the mechanism's size."""
    q = closure.known.unknowns(q[..., closure.known.free], c)
    last = np.zeros(q.shape[:-1])
    for _ in range(steps):
        step = _newton_step(closure, q)
        q = closure.move(q, step)
        last = np.max(np.abs(step), axis=-1, initial=0.0)
        if np.all(last < _SETTLED):
            break
    return Closed(q, np.max(np.abs(closure.loops.gap(q)), axis=-1, initial=0.0), last)


def _newton_step(closure: Closure, q: Real) -> Real:
    matrix, gap = closure.matrix(q), closure.loops.gap(q)[..., None]
    if matrix.shape[-1] == matrix.shape[-2]:
        try:
            return np.clip(-np.linalg.solve(matrix, gap)[..., 0], -1, 1)
        except np.linalg.LinAlgError:  # one position of all is exactly singular
            pass
    return np.clip(-(pseudo_inverse(matrix) @ gap)[..., 0], -1, 1)


def pseudo_inverse(matrix: Real) -> Real:
    """Moore-Penrose inverse; for no rows or no columns too."""
    if 0 in matrix.shape:
        return np.zeros((*matrix.shape[:-2], matrix.shape[-1], matrix.shape[-2]))
    return np.linalg.pinv(matrix)


def inverse(matrix: Real) -> tuple[Real, Real]:
    """The (pseudo-)inverse of A (..., 2r, y), and the reciprocal condition number (...)."""
    inverted = _inverted(matrix)
    size, other = (np.linalg.norm(part, axis=(-2, -1)) for part in (matrix, inverted))
    columns = matrix.shape[-1]
    if columns == 0:
        return inverted, np.ones(matrix.shape[:-2])
    product = np.where(size * other > 0, size * other, np.inf)
    return inverted, columns / product if _full(matrix) else np.zeros_like(product)


def _full(matrix: Real) -> bool:
    """Too few equations can never be well conditioned."""
    return bool(matrix.shape[-2] >= matrix.shape[-1])


def _inverted(matrix: Real) -> Real:
    if matrix.shape[-1] == matrix.shape[-2] and matrix.size:
        try:
            return np.linalg.inv(matrix)
        except np.linalg.LinAlgError:
            pass
    return pseudo_inverse(matrix)


def search(closure: Closure, q: Real, c: Real, steps: int = 60) -> tuple[Real, Real]:
    """Levenberg-Marquardt from many starts q (b, n): where each ends, and its gap (b,), in units of size.

    A step that opens the loops further is taken back and damped more, each start for itself.
    """
    y = q[..., closure.known.free]
    q = closure.known.unknowns(y, c)
    damping, gap = np.full(len(y), 0.1), closure.loops.gap(q)
    for _ in range(steps):
        step = _damped_step(closure.matrix(q), gap, damping)
        tried = closure.move(q, step)
        new = closure.loops.gap(tried)
        better = np.sum(new**2, axis=-1) < np.sum(gap**2, axis=-1)
        q, gap = np.where(better[:, None], tried, q), np.where(better[:, None], new, gap)
        damping = np.clip(np.where(better, damping / 5, damping * 4), 1e-12, 1e6)
    return q, np.max(np.abs(gap), axis=-1, initial=0.0)


def _damped_step(matrix: Real, gap: Real, damping: NDArray[np.float64]) -> Real:
    transposed = np.swapaxes(matrix, -1, -2)
    normal = transposed @ matrix + damping[:, None, None] * np.eye(matrix.shape[-1])
    return -np.linalg.solve(normal, transposed @ gap[..., None])[..., 0]
