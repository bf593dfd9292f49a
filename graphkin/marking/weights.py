"""How well explanations go with handed-in values: all of them at once, as arrays.

An explanation is a row: what each value is, and how it scatters. A further one, "none", says nothing: each value is
right or anything. Weights are logarithms of likelihoods times how often such work is met.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from math import lgamma

import numpy as np

from graphkin.marking.key import Hypotheses, Key, Name
from graphkin.marking.verdicts import Columns, columns_of, differences
from graphkin.value import frozen

_RIGHT, ONE, TWO, _NONE = np.log((0.05, 0.35, 0.05, 0.1))
"""How often one mistake, two mistakes and other work are met where a value is beyond its tolerance, and right work:
that has gone astray there by the pencil alone."""
MOVED = 3.0
"""A mistake that moves no handed-in value by more standard deviations cannot be seen."""
_COMMON = (0.5, 0.9)
"""What part of the scatter of several values may come from what they are all read off, beside none; the rest is each
value's own."""
_FAR = 8.0
"""Explanations in which a value is off by more standard deviations are not looked at closely."""
_REACH = 5.0
_AT_ONCE = 4_000_000
"""Differences that are held at once."""


@frozen
class Weighed:
    """The weights of explanations of some students' values.

    rows    of the hypotheses that can be seen in what is handed in, (m,)
    weights (students, m); `right`, `none`: of right work, and of work that nothing explains (students,)
    shares  what of the weights is not from the values: how often each row is met, as a logarithm (m,)
    worst   by how many standard deviations the worst value is off (students, m)
    near    sum of the squares of all values' deviations, in standard deviations (students, m)
    chance  how often random numbers come as near to any of the explanations (students, m)
    """

    rows: np.ndarray
    weights: np.ndarray
    shares: np.ndarray
    worst: np.ndarray
    near: np.ndarray
    chance: np.ndarray
    right: np.ndarray
    none: np.ndarray


def weigh(
    key: Key, table: Columns, given: np.ndarray, hypotheses: Hypotheses, met: float, near_only: bool = False
) -> Weighed:
    """For students who have handed in the same quantities: given (students, n), NaN where one is not.

    met        logarithm of how often one of the hypotheses is met
    near_only  those that are far from all students' values have no weight
    """
    there = np.isfinite(given).all(axis=0)
    short, handed, together = columns_of(table, there), given[:, there], key.together[np.ix_(there, there)]
    rows = np.flatnonzero(visible(short, hypotheses.values[:, there]))
    values, scatters = hypotheses.values[np.ix_(rows, there)], hypotheses.scatters[np.ix_(rows, there)]
    nothing = _nothing(short, handed)
    found = _Found(len(handed), len(rows), near_only)
    judged = np.isfinite(values) & np.isfinite(scatters)
    for which, some in _alike(judged):
        found.put(some, short, handed, values[some], scatters[some], together, nothing, which)
    right = _Found(len(handed), 1)
    everything = np.ones(len(short.right), dtype=bool)
    right.put(np.array([0]), short, handed, short.right[None], short.scatter[None], together, nothing, everything)
    shares = met + _shares([hypotheses.names[k] for k in rows])
    return Weighed(
        rows, found.weights + shares, shares, found.worst, found.near, found.chance(),
        right.weights[:, 0] + _RIGHT, nothing.sum(axis=1) + _NONE,
    )  # fmt: skip


def visible(table: Columns, values: np.ndarray) -> np.ndarray:
    """Which rows of values (m, n) move one by more than a pencil might."""
    with np.errstate(invalid="ignore"):
        found: np.ndarray = np.any(shifts(table, values) > MOVED, axis=1)
        return found


def shifts(table: Columns, values: np.ndarray) -> np.ndarray:
    """By how many standard deviations values (.., n) are off the right ones; NaN where there is none."""
    found: np.ndarray = np.abs(differences(table, values, table.right)) / table.scatter
    return found


def _shares(names: list[tuple[Name, ...]]) -> np.ndarray:
    """Logarithms of the rows' shares: the same for each mistake, divided among its places and forms."""
    kinds = [tuple(name[0] for name in row) for row in names]
    count = Counter(kinds)
    return -np.log([len(count) * count[kind] for kind in kinds])


def _alike(judged: np.ndarray) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Rows that judge the same quantities: which quantities, and which rows."""
    patterns, number = np.unique(judged, axis=0, return_inverse=True)
    for k, which in enumerate(patterns):
        yield which, np.flatnonzero(number.reshape(-1) == k)


# --- densities --------------------------------------------------------------------------------


def _broad(table: Columns, values: np.ndarray) -> np.ndarray:
    """Logarithm of the density of a value of which nothing is known: about as large as the right one, or far off."""
    size = np.maximum(np.abs(table.right), 10 * table.scatter)
    sides = np.where(table.size, 2.0, 1.0)  # a size has no sign
    found: np.ndarray = np.log(sides / (np.pi * size)) - np.log1p((values / size) ** 2)
    return found


def _crowded(table: Columns, values: np.ndarray) -> np.ndarray:
    """Logarithm of how densely random numbers may lie: of any size from a fifth to five times the right one, too."""
    ratio = np.abs(values) / np.maximum(np.abs(table.right), 10 * table.scatter)
    sides = np.where(table.size, 1.0, 2.0)
    with np.errstate(divide="ignore"):
        even = -np.log(2 * np.log(_REACH) * sides * np.abs(values))
    inside = (ratio > 1 / _REACH) & (ratio < _REACH)
    return np.where(inside, np.fmax(even, _broad(table, values)), _broad(table, values))


def _nothing(table: Columns, given: np.ndarray) -> np.ndarray:
    """The same of a value that is right in half of the cases."""
    z = differences(table, given, table.right) / table.scatter
    right = -0.5 * z**2 - np.log(table.scatter * np.sqrt(2 * np.pi))
    found: np.ndarray = np.logaddexp(right, _broad(table, given)) - np.log(2)
    return found


def _normal(together: np.ndarray, part: float) -> tuple[np.ndarray, float]:
    """A normal density of deviations of which a part is common: inverse of their correlation, half its log size."""
    common = part * together + (1 - part) * np.eye(len(together))
    return np.linalg.inv(common), 0.5 * float(np.linalg.slogdet(common)[1])


def _mixed(
    z: np.ndarray, near: np.ndarray, worst: np.ndarray, kinds: list[tuple[np.ndarray, float]]
) -> np.ndarray:
    """Logarithm of the mean of densities of deviations (students, m, n): (students, m).

    near, worst   sum of squares and largest of them; far off, the density of deviations without a common part will do
    """
    found: np.ndarray = -0.5 * (near + z.shape[2] * np.log(2 * np.pi))
    rows = np.flatnonzero((worst < _FAR).any(axis=0))
    close = z[:, rows]
    each = [found[:, rows]]
    for inverse, log_size in kinds:
        square = np.einsum("smi,smi->sm", close @ inverse, close)
        each.append(-0.5 * (square + z.shape[2] * np.log(2 * np.pi)) - log_size)
    found[:, rows] = np.logaddexp.reduce(each, axis=0) - np.log(len(each))
    return found


def _near_any(table: Columns, given: np.ndarray, values: np.ndarray, scatters: np.ndarray) -> np.ndarray:
    """Which rows of values (m, n) have a student (students, n) all of whose values are near, (m,)."""
    near: np.ndarray = np.ones((len(given), len(values)), dtype=bool)
    for k in range(values.shape[1]):
        one = np.arange(values.shape[1]) == k
        off = differences(columns_of(table, one), given[:, None, one], values[:, one])[..., 0]
        near[np.abs(off) > _FAR * scatters[:, k]] = False
    found: np.ndarray = np.logical_or.reduce(near, axis=0)
    return found


class _Found:
    """Weights and fits of rows, filled in group by group."""

    def __init__(self, students: int, rows: int, near_only: bool = False) -> None:
        self.near_only = near_only
        self.weights = np.full((students, rows), -np.inf)
        self.worst = np.full((students, rows), np.inf)
        self.near = np.full((students, rows), np.inf)
        self._cells: dict[int, float] = {}

    def put(
        self, some: np.ndarray, table: Columns, given: np.ndarray, values: np.ndarray, scatters: np.ndarray,
        together: np.ndarray, nothing: np.ndarray, which: np.ndarray,
    ) -> None:  # fmt: skip
        """Rows that judge `which` quantities: normal in these, "none" in the others."""
        short, size = columns_of(table, which), int(which.sum())
        values, scatters, handed = values[:, which], scatters[:, which], given[:, which]
        # a larger value errs as the right one does, whichever way it points
        outward = np.where(short.angle | (values == 0), 1.0, np.sign(values))
        alike = np.where(short.angle | (short.right == 0), 1.0, np.sign(short.right))
        kinds = [_normal(together[np.ix_(which, which)] * np.outer(alike, alike), part) for part in _COMMON]
        own = np.log(scatters).sum(axis=1)
        cells = own + _crowded(short, values).sum(axis=1)
        self._cells[size] = np.logaddexp.reduce([self._cells.get(size, -np.inf), *cells])
        if self.near_only:
            rows = np.flatnonzero(_near_any(short, handed, values, scatters))
            values, scatters, outward, own, some = values[rows], scatters[rows], outward[rows], own[rows], some[rows]
        step = max(_AT_ONCE // max(values.size, 1), 1)
        for k in range(0, len(handed), step):
            z = differences(short, handed[k : k + step, None, :], values) / scatters
            worst, near = np.abs(z).max(axis=2, initial=0.0), np.einsum("smi,smi->sm", z, z)
            rest = nothing[k : k + step][:, ~which].sum(axis=1)[:, None]
            self.weights[k : k + step, some] = _mixed(z * outward, near, worst, kinds) - own + rest
            self.worst[k : k + step, some] = worst
            self.near[k : k + step, some] = near

    def chance(self) -> np.ndarray:
        """How many explanations random numbers come as near to, on average: cells of that size about all of them."""
        total = np.ones_like(self.weights)
        rows = np.flatnonzero(np.isfinite(self.near).any(axis=0))
        near = self.near[:, rows]
        found = np.zeros_like(near)
        with np.errstate(divide="ignore"):
            for size, cells in self._cells.items():
                ball = 0.5 * size * np.log(np.pi * near) - lgamma(size / 2 + 1) if size else 0.0
                found += np.exp(np.minimum(ball + cells, 0.0))
        total[:, rows] = found
        return total
