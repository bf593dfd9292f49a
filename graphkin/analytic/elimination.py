"""Relations linear in the unknowns, solved once: q = given c + left y, where y are some of the unknowns.

So a driven angle or a block's angle is put into the loops as a book does it, and what is left to
find (y) is as many scalars as the loops have to give.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from graphkin.analytic.vectors import Indices, Real, applied
from graphkin.base.value import frozen

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

    def mismatch(self, c: Real) -> float:
        """How much repeated relations contradict each other; whole turns do not count."""
        if not self.spare.size:
            return 0.0
        rest = applied(self.spare, c)
        return float(np.max(np.minimum(abs(rest), abs(np.angle(np.exp(1j * rest)))), initial=0.0))


def eliminate(weights: Real) -> Elimination:
    """Gauss-Jordan on W (k, n) beside the unit matrix, each row pivoting on its largest entry.

    A relation has few unknowns, so rows are tables of what is not 0, by column.
    """
    k, n = weights.shape
    rows = [_row(weights[number].tolist()) | {n + number: 1.0} for number in range(k)]
    for number, row in enumerate(rows):
        largest = max((abs(value) for column, value in row.items() if column < n), default=0.0) or 1.0
        rows[number] = {column: value / largest for column, value in row.items()}
    pivots: dict[int, int] = {}
    for number, row in enumerate(rows):
        sizes = {column: abs(value) for column, value in row.items() if column < n}
        column = max(sorted(sizes), key=lambda each: sizes[each], default=None)
        if column is None or sizes[column] < _ZERO:
            continue
        pivot = row.pop(column)
        rows[number] = row = {other: value / pivot for other, value in row.items()}
        for other in rows:
            share = other.pop(column, None)
            if share is not None:
                other.update({each: other.get(each, 0.0) - share * value for each, value in row.items()})
        pivots[number] = column
    return _solution(k, n, rows, pivots)


def _row(entries: list[float]) -> dict[int, float]:
    """What is not 0 of a row, by column."""
    return {column: value for column, value in enumerate(entries) if value}


def _solution(k: int, n: int, rows: Sequence[Mapping[int, float]], pivots: dict[int, int]) -> Elimination:
    """Read the solution off the reduced rows; `pivots` gives each row's column, which it has no more."""
    free = np.array([column for column in range(n) if column not in pivots.values()], dtype=np.intp)
    spare = [row for number, row in enumerate(rows) if number not in pivots]
    given, left, rest = np.zeros((n, k)), np.zeros((n, len(free))), np.zeros((len(spare), k))
    place = {column: at for at, column in enumerate(free.tolist())}
    for column, at in place.items():
        left[column, at] = 1.0
    for number, column in pivots.items():
        for at, value in rows[number].items():
            if at < n:
                left[column, place[at]] = -value
            else:
                given[column, at - n] = value
    for number, row in enumerate(spare):
        for at, value in row.items():
            if at >= n:
                rest[number, at - n] = value
    return Elimination(given, left, free, rest)
