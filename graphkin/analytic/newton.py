"""Close the vector loops numerically, for many positions at once, and their rates by the matrix method.

Relations linear in the unknowns are solved once and put into the loops, as a book does it with a driven angle or a
block's angle; what is left to find is y with loop(y) = 0, as many scalars as the loops have to give. `close` is
Newton's method (Gauss-Newton where met constraints repeat each other); `search` is a damped search from far away.

Derived once and twice, the loops give A y' = B and A y'' = -A' y' + B', with the drivers' rates on the right.
Source: Sun Huan, Theory of Machines, section 3-3, (3-21) to (3-29), written for any number of drivers.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from graphkin.analytic.loops import Indices, Loops, Polar, Reals, applied, parts, through
from graphkin.analytic.rules import LinearRelation
from graphkin.base.value import frozen

_ZERO = 1e-9  # a row whose entries all fall below this is a repetition of others
_SETTLED = 1e-13  # Newton steps below this are rounding
_CLOSED = 1e-20
"""A search has closed the loops where the square of the gap is below this [size^2]; Newton does the rest."""
_SLOW = 1e-10  # a search that closes less than this share of the gap in a step has come to its end


# --- relations put in -------------------------------------------------------------------------


@frozen
class Elimination:
    """The general solution of W q = c, for k relations and n unknowns of which y are left: `given` (n, k) what the
    right sides give, `left` (n, y) how all unknowns follow those left, y = q[`free`]. Each row of `spare` (e, k) . c
    must vanish, for relations that repeat others."""

    given: Reals
    left: Reals
    free: Indices
    spare: Reals

    def unknowns(self, y: Reals, c: Reals) -> Reals:
        """All unknowns: (..., n) from y (..., y) and c (..., k)."""
        return np.asarray(applied(self.given, c) + applied(self.left, y))

    def mismatch(self, c: Reals) -> float:
        """The contradiction of repeated relations; whole turns do not count."""
        if not self.spare.size:
            return 0.0
        rest = applied(self.spare, c)
        return float(np.max(np.minimum(abs(rest), abs(np.angle(np.exp(1j * rest)))), initial=0.0))


def eliminate(weights: Reals) -> Elimination:
    """Gauss-Jordan on W (k, n) beside the unit matrix, each row pivoting on its largest entry. A relation has few
    unknowns, so rows are tables of what is not 0, by column."""
    k, n = weights.shape
    rows: list[dict[int, float]] = []
    for number, entries in enumerate(weights.tolist()):
        row = {column: value for column, value in enumerate(entries) if value}
        largest = max(map(abs, row.values()), default=0.0) or 1.0
        rows.append({column: value / largest for column, value in (row | {n + number: 1.0}).items()})
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


@frozen
class EquationSystem:
    """Loops and the relations that hold with them; `c` (..., k) are the relations' right sides."""

    loops: Loops
    weights: Reals
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

    def matrix(self, q: Reals, polar: Polar | None = None) -> Reals:
        """The matrix A of A y' = B: (..., 2r, y)."""
        return through(self.loops.slope(q, polar), self.known.left)

    def move(self, q: Reals, y_step: Reals) -> Reals:
        return np.asarray(q + applied(self.known.left, y_step))


# --- Newton's method --------------------------------------------------------------------------


@frozen
class Closed:
    """The end of Newton's method: unknowns (p, n), loops still open by `gap` (p,), last step (p,)."""

    q: Reals
    gap: Reals
    step: Reals


def close(closure: EquationSystem, q: Reals, c: Reals, steps: int = 12) -> Closed:
    """Newton from q (p, n), with the relations at c. A step is at most 1 rad, or the mechanism's size. Positions that
    have settled are left alone, so a few at dead points do not keep all others busy."""
    q = closure.known.unknowns(q[..., closure.known.free], c)
    last = np.full(len(q), np.inf)
    for _ in range(steps):
        busy = last >= _SETTLED
        if not busy.any():
            break
        polar = closure.loops.vectors.polar(q[busy])
        matrix, gap = closure.matrix(q[busy], polar), closure.loops.gap(q[busy], polar)[..., None]
        try:
            square = matrix.shape[-1] == matrix.shape[-2]
            solution = np.linalg.solve(matrix, gap) if square else pseudo_inverse(matrix) @ gap
        except np.linalg.LinAlgError:  # one position of all is exactly singular
            solution = pseudo_inverse(matrix) @ gap
        step = np.clip(-solution[..., 0], -1, 1)
        q[busy] = closure.move(q[busy], step)
        last[busy] = np.max(np.abs(step), axis=-1, initial=0.0)
    return Closed(q, closure.loops.open_by(q), last)


def pseudo_inverse(matrix: Reals) -> Reals:
    """Moore-Penrose inverse; for no rows or no columns too."""
    if 0 in matrix.shape:
        return np.zeros((*matrix.shape[:-2], matrix.shape[-1], matrix.shape[-2]))
    return np.asarray(np.linalg.pinv(matrix), dtype=np.float64)


def inverse(matrix: Reals) -> tuple[Reals, Reals]:
    """The (pseudo-)inverse of A (p, 2r, y), and the reciprocal condition number (p,): 1 best, 0 singular. The condition
    is |A| |A^-1| / y in the Frobenius norm."""
    rows, columns = matrix.shape[-2:]
    if rows == columns > 0:
        try:
            inverted = np.asarray(np.linalg.inv(matrix), dtype=np.float64)
        except np.linalg.LinAlgError:  # one position of all is exactly singular
            pass
        else:
            other = np.linalg.norm(inverted, axis=(-2, -1))
            return inverted, columns / (np.linalg.norm(matrix, axis=(-2, -1)) * other)
    if columns == 0 or rows < columns:
        return pseudo_inverse(matrix), np.full(matrix.shape[:-2], float(columns == 0))
    values = np.linalg.svd(matrix, compute_uv=False)  # a pseudo-inverse leaves out those that vanish
    other = np.sqrt((1 / np.maximum(values, 1e-150) ** 2).sum(axis=-1))
    condition = columns / np.maximum(np.sqrt((values**2).sum(axis=-1)) * other, 1.0)
    return pseudo_inverse(matrix), np.asarray(condition)


def search(closure: EquationSystem, q: Reals, c: Reals, steps: int = 60) -> Reals:
    """Levenberg-Marquardt from many starts q (b, n): where each ends. A step that opens the loops further is taken back
    and damped more, each start for itself; one that has closed the loops, or finds no way to close them further, is
    left alone."""
    q = closure.known.unknowns(q[..., closure.known.free], c)
    damping, busy, gaps = np.full(len(q), 0.1), np.arange(len(q)), closure.loops.gap(q)
    diagonal = np.arange(len(closure.known.free))
    for _ in range(steps):
        if not len(busy):
            break
        gap, matrix = gaps[busy], closure.matrix(q[busy])
        transposed = np.swapaxes(matrix, -1, -2)
        normal = transposed @ matrix
        normal[:, diagonal, diagonal] += damping[busy][:, None]
        shifted = closure.move(q[busy], np.asarray(-np.linalg.solve(normal, transposed @ gap[..., None])[..., 0]))
        ahead = closure.loops.gap(shifted)
        before, after = np.sum(gap**2, axis=-1), np.sum(ahead**2, axis=-1)
        better = after < before
        q[busy], gaps[busy] = np.where(better[:, None], shifted, q[busy]), np.where(better[:, None], ahead, gap)
        damping[busy] = np.clip(np.where(better, damping[busy] / 5, damping[busy] * 4), 1e-12, 1e6)
        slow = np.where(better, before - after < _SLOW * before, damping[busy] >= 1e6)
        busy = busy[~(slow | (np.minimum(before, after) < _CLOSED))]
    return q


# --- rates ------------------------------------------------------------------------------------


@frozen
class Rates:
    """q', q'' (..., n), and the reciprocal condition number of A (...)."""

    first: Reals
    second: Reals
    condition: Reals


def rates(closure: EquationSystem, q: Reals, first: Reals, second: Reals) -> Rates:
    """Rates of the unknowns at q (..., n), for rates of the relations' right sides (k,)."""
    polar = closure.loops.vectors.polar(q)
    slope = closure.loops.slope(q, polar)
    inverted, condition = inverse(through(slope, closure.known.left))
    dq = _solved(closure, inverted, slope, first, np.zeros(slope.shape[:-1]))
    bend = applied(closure.loops.rows, closure.loops.vectors.acceleration(q, dq, np.zeros_like(dq), polar))
    ddq = _solved(closure, inverted, slope, second, parts(bend, -1))
    return Rates(dq, ddq, condition)


def tangent(closure: EquationSystem, q: Reals, first: Reals) -> tuple[Reals, Reals, Reals]:
    """q' alone (p, n), the reciprocal condition number of A (p,), and its determinant's sign (p,), 1 if it has none.
    `first` (..., k) may differ from position to position. The sign changes only through a change point, or to another
    assembly."""
    slope = closure.loops.slope(q)
    matrix = through(slope, closure.known.left)
    inverted, condition = inverse(matrix)
    square = matrix.shape[-1] == matrix.shape[-2]
    sense = np.asarray(np.linalg.slogdet(matrix)[0]) if square else np.ones(len(q))
    return _solved(closure, inverted, slope, first, np.zeros(slope.shape[:-1])), condition, sense


def reaching(closure: EquationSystem, q: Reals) -> Reals:
    """The reciprocal condition number at q (p, n), far displacements and their loops measured by how far they reach.
    Beside guides that become parallel, blocks run off: rows and columns of many sizes there make A ill-conditioned long
    before it is singular."""
    slides = np.array([unknown.kind == "s" for unknown in closure.loops.unknowns])[closure.known.free]
    reach = np.where(slides, np.maximum(np.abs(q[..., closure.known.free]), 1.0), 1.0)
    matrix = closure.matrix(q) * reach[..., None, :]
    farthest = np.max(np.abs(matrix[..., slides]), axis=-1, initial=1.0, keepdims=True)
    return inverse(matrix / farthest)[1]


def _solved(closure: EquationSystem, inverted: Reals, slope: Reals, given: Reals, rest: Reals) -> Reals:
    """The x with W x = given and slope x + rest = 0."""
    driven = applied(closure.known.given, given)
    right = -(slope @ driven[..., None])[..., 0] - rest
    return np.asarray(driven + applied(closure.known.left, (inverted @ right[..., None])[..., 0]))
