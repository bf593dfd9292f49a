"""Relations linear in the unknowns, solved once: q = given c + left y, where y are some of the unknowns.

So a driven angle or a block's angle is put into the loops as a book does it, and what is left to
find (y) is as many scalars as the loops have to give.
"""

from __future__ import annotations

import numpy as np

from graphkin.analytic.vectors import Indices, Real, applied
from graphkin.value import frozen

_ZERO = 1e-9
"""A row whose entries all fall below this is a repetition of others."""


@frozen
class Elimination:
    """The general solution of W q = c, for k relations and n unknowns of which y are left.

    given  (n, k)       what the right sides give
    left   (n, y)       how all unknowns follow those left
    free   (y,)         which unknowns are left: y = q[free]
    spare  (e, k)       each row . c must vanish, for relations that repeat others
    """

    given: Real
    left: Real
    free: Indices
    spare: Real

    def unknowns(self, y: Real, c: Real) -> Real:
        """All unknowns: (..., n) from y (..., y) and c (..., k)."""
        return np.asarray(applied(self.given, c) + applied(self.left, y))

    def of_some(self, which: Indices | int) -> Elimination:
        """That of some of many mechanisms, or of one."""
        return Elimination(self.given[which], self.left[which], self.free, self.spare[which])

    def mismatch(self, c: Real) -> float:
        """How much repeated relations contradict each other; whole turns do not count."""
        rest = applied(self.spare, c)
        return float(np.max(np.minimum(abs(rest), abs(np.angle(np.exp(1j * rest)))), initial=0.0))


def eliminate(weights: Real) -> Elimination:
    """Gauss-Jordan on W (k, n) beside the unit matrix, each row pivoting on its largest entry.

    Of many mechanisms (b, k, n) on the entry that is the largest where it is smallest.
    """
    k, n = weights.shape[-2:]
    table = np.concatenate([weights, np.broadcast_to(np.eye(k), (*weights.shape[:-1], k))], axis=-1)
    largest = np.max(abs(weights), axis=-1, initial=0.0, keepdims=True)
    table /= largest + (largest == 0)
    pivots: dict[int, int] = {}
    for row in range(k):
        sizes = abs(table[..., row, :n]).reshape(-1, n).min(axis=0)
        column = int(np.argmax(sizes)) if n else 0
        if n == 0 or sizes[column] < _ZERO:
            continue
        table[..., row, :] /= table[..., row, column, None]
        shares = table[..., column].copy()
        shares[..., row] = 0.0
        if shares.any():
            table -= shares[..., None] * table[..., None, row, :]
        pivots[row] = column
    return _solution(table, pivots, n)


def _solution(table: Real, pivots: dict[int, int], n: int) -> Elimination:
    """Read the solution off the reduced table; `pivots` gives each row's column."""
    many, k = table.shape[:-2], table.shape[-2]
    free = np.array([column for column in range(n) if column not in pivots.values()], dtype=np.intp)
    given, left = np.zeros((*many, n, k)), np.zeros((*many, n, len(free)))
    left[..., free, np.arange(len(free))] = 1.0
    for row, column in pivots.items():
        given[..., column, :] = table[..., row, n:]
        left[..., column, :] = -table[..., row, free]
    spare = table[..., [row for row in range(k) if row not in pivots], n:]
    return Elimination(given, left, free, spare)
