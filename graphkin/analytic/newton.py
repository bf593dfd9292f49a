"""Close the vector loops numerically, for many positions at once.

`Closure` is loops with relations put in: what is left is y with loop(y) = 0. `close` is Newton's method
(Gauss-Newton where met constraints repeat each other); `search` is a damped search from far away.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from graphkin.analytic.elimination import Elimination, eliminate
from graphkin.analytic.loops import Loops
from graphkin.analytic.rules import LinearRelation
from graphkin.analytic.vectors import Polar, Real, applied, through
from graphkin.base.value import frozen

_SETTLED = 1e-13
"""Newton steps below this are rounding."""
_CLOSED = 1e-20
"""A search has closed the loops where the square of the gap is below this [size^2]; Newton does the rest."""
_SLOW = 1e-10
"""A search that closes less than this share of the gap in a step has come to its end."""


@frozen
class EquationSystem:
    """Loops and the relations that hold with them; `c` (..., k) are the relations' right sides."""

    loops: Loops
    weights: Real
    known: Elimination

    @classmethod
    def of(
        cls, loops: Loops, relations: Sequence[LinearRelation], like: EquationSystem | None = None
    ) -> EquationSystem:
        """The system of these relations: `like`, if that has the same."""
        weights = loops.weights(relations)
        if like is not None and np.array_equal(weights, like.weights):
            return like
        return cls(loops, weights, eliminate(weights))

    def matrix(self, q: Real, polar: Polar | None = None) -> Real:
        """The matrix A of A y' = B: (..., 2r, y)."""
        return through(self.loops.slope(q, polar), self.known.left)

    def move(self, q: Real, y_step: Real) -> Real:
        return np.asarray(q + applied(self.known.left, y_step))


@frozen
class Closed:
    """Where Newton ended: unknowns (p, n), loops still open by `gap` (p,), last step (p,)."""

    q: Real
    gap: Real
    step: Real


def close(closure: EquationSystem, q: Real, c: Real, steps: int = 12) -> Closed:
    """Newton from q (p, n), with the relations at c. A step is at most 1 rad, or the mechanism's size.

    Positions that have settled are left alone, so a few at dead points do not keep all others busy.
    """
    q = closure.known.unknowns(q[..., closure.known.free], c)
    last = np.full(len(q), np.inf)
    for _ in range(steps):
        busy = last >= _SETTLED
        if not busy.any():
            break
        step = _newton_step(closure, q[busy])
        q[busy] = closure.move(q[busy], step)
        last[busy] = np.max(np.abs(step), axis=-1, initial=0.0)
    return Closed(q, closure.loops.open_by(q), last)


def _newton_step(closure: EquationSystem, q: Real) -> Real:
    polar = closure.loops.vectors.polar(q)
    matrix, gap = closure.matrix(q, polar), closure.loops.gap(q, polar)[..., None]
    if matrix.shape[-1] == matrix.shape[-2]:
        try:
            return np.asarray(np.clip(-np.linalg.solve(matrix, gap)[..., 0], -1, 1))
        except np.linalg.LinAlgError:  # one position of all is exactly singular
            pass
    return np.asarray(np.clip(-(pseudo_inverse(matrix) @ gap)[..., 0], -1, 1))


def pseudo_inverse(matrix: Real) -> Real:
    """Moore-Penrose inverse; for no rows or no columns too."""
    if 0 in matrix.shape:
        return np.zeros((*matrix.shape[:-2], matrix.shape[-1], matrix.shape[-2]))
    return np.asarray(np.linalg.pinv(matrix), dtype=np.float64)


def inverse(matrix: Real) -> tuple[Real, Real]:
    """The (pseudo-)inverse of A (p, 2r, y), and the reciprocal condition number (p,): 1 best, 0 singular.

    The condition is |A| |A^-1| / y in the Frobenius norm.
    """
    rows, columns = matrix.shape[-2:]
    if rows == columns > 0:
        try:
            inverted = np.asarray(np.linalg.inv(matrix), dtype=np.float64)
        except np.linalg.LinAlgError:  # one position of all is exactly singular
            pass
        else:
            other = np.linalg.norm(inverted, axis=(-2, -1))
            return inverted, columns / (np.linalg.norm(matrix, axis=(-2, -1)) * other)
    return pseudo_inverse(matrix), _condition(matrix)


def _condition(matrix: Real) -> Real:
    """By singular values, for a pseudo-inverse leaves out those that vanish: (p,)."""
    rows, columns = matrix.shape[-2:]
    if columns == 0 or rows < columns:
        return np.full(matrix.shape[:-2], float(columns == 0))
    values = np.linalg.svd(matrix, compute_uv=False)
    inverted = np.sqrt((1 / np.maximum(values, 1e-150) ** 2).sum(axis=-1))
    return np.asarray(columns / np.maximum(np.sqrt((values**2).sum(axis=-1)) * inverted, 1.0))


def search(closure: EquationSystem, q: Real, c: Real, steps: int = 60) -> Real:
    """Levenberg-Marquardt from many starts q (b, n): where each ends.

    A step that opens the loops further is taken back and damped more, each start for itself; one that has
    closed the loops, or finds no way to close them further, is left alone.
    """
    q = closure.known.unknowns(q[..., closure.known.free], c)
    damping, busy, gaps = np.full(len(q), 0.1), np.arange(len(q)), closure.loops.gap(q)
    for _ in range(steps):
        if not len(busy):
            break
        gap = gaps[busy]
        tried = closure.move(q[busy], _damped_step(closure.matrix(q[busy]), gap, damping[busy]))
        ahead = closure.loops.gap(tried)
        before, after = np.sum(gap**2, axis=-1), np.sum(ahead**2, axis=-1)
        better = after < before
        q[busy], gaps[busy] = np.where(better[:, None], tried, q[busy]), np.where(better[:, None], ahead, gap)
        damping[busy] = np.clip(np.where(better, damping[busy] / 5, damping[busy] * 4), 1e-12, 1e6)
        slow = np.where(better, before - after < _SLOW * before, damping[busy] >= 1e6)
        busy = busy[~(slow | (np.minimum(before, after) < _CLOSED))]
    return q


def _damped_step(matrix: Real, gap: Real, damping: Real) -> Real:
    transposed = np.swapaxes(matrix, -1, -2)
    normal, diagonal = transposed @ matrix, np.arange(matrix.shape[-1])
    normal[:, diagonal, diagonal] += damping[:, None]
    return np.asarray(-np.linalg.solve(normal, transposed @ gap[..., None])[..., 0])
