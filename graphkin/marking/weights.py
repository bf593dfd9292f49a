"""Likelihoods of explanations, given handed-in values: all of them at once, as arrays.

An explanation is a row: what each value is, and how it scatters. A further one, "none", says nothing: each value is
right or anything. Weights are logarithms of likelihoods times how often such work is met.
"""

from __future__ import annotations

from copy import copy
from functools import cached_property
from math import lgamma

import numpy as np

from graphkin.base.value import frozen
from graphkin.marking.key import Columns, Hypotheses, Key, columns_of, differences, upright

_RIGHT, ONE, TWO, _SLIP, _NONE = np.log((0.05, 0.35, 0.05, 0.35, 0.1))
"""Logarithms of the frequencies, where a value is beyond its tolerance, of right work gone astray by the pencil alone,
of one mistake, of two, of one slip with all else consistent, and of other work."""
MOVED = 3.0  # a mistake that moves no handed-in value by more standard deviations cannot be seen
_ELSE = 0.2  # the part of a mistake's values that come from something else, where others do
_COMMON = (0.5, 0.9)
"""Parts of the scatter of several values that may come from what they are all read off, beside none; the rest is each
value's own."""
FITS = 4.5  # a value that is off by more standard deviations is not explained
_REACH = 5.0  # random numbers are of any size from the right one divided by this to it multiplied by this
LEFT = 0.7  # of a scatter at least so large a part is left, whatever else is known: its own reading and rounding
_TURN = 2 * np.pi


@frozen
class Weighed:
    """The weights of m explanations of some students' values.

    weights (students, m); `right`, `none`: of right work, and of work that nothing explains (students,)
    worst   by how many standard deviations the worst value is off (students, m)
    apart   logarithms of the densities, were each value's deviation its own (students, m)
    chance  how often random numbers come as near to any of as many values (students, m); 1 where that is far
    """

    weights: np.ndarray
    worst: np.ndarray
    apart: np.ndarray
    chance: np.ndarray
    right: np.ndarray
    none: np.ndarray

    def beside(self, slips: Weighed) -> Weighed:
        """With the weights of further explanations of the same students."""
        weights, worst, apart, chance = (
            np.concatenate([getattr(one, name) for one in (self, slips)], axis=1)
            for name in ("weights", "worst", "apart", "chance")
        )
        return Weighed(weights, worst, apart, chance, self.right, self.none)


@frozen
class WeighedPartly:
    """The weights of explanations (students, m) where a part of the wrong values comes from something else.

    chance     how often random numbers come as near to any explanation in as many values (students, m)
    explained  which of the wrong values follow (students, m, n)
    none       weights of work that nothing explains (students,)
    """

    weights: np.ndarray
    chance: np.ndarray
    explained: np.ndarray
    none: np.ndarray


@frozen
class SlipOutcomes:
    """The outcomes of a slip in each quantity: that one is off, all others are as they follow from it.

    values, scatters  (students, n, n), a row for each quantity; NaN at its own, and where there is no slip in it
    """

    values: np.ndarray
    scatters: np.ndarray


class ScaledExplanations:
    """Explanations made ready to be weighed by those who hand in the same quantities.

    there   which of the key's quantities are handed in (all of them,); n of them
    rows    of the hypotheses that can be seen in these, (m,)
    shares  logarithm of each row's prior frequency (m,)
    """

    def __init__(self, key: Key, table: Columns, there: np.ndarray, hypotheses: Hypotheses, met: float) -> None:
        """met: logarithm of how often one of the hypotheses is met."""
        self.table, self._there = columns_of(table, there), there
        self.rows = np.flatnonzero(visible(self.table, hypotheses.values[:, there]))
        kinds = hypotheses.kinds[self.rows]
        count = np.bincount(kinds)  # each kind of mistake is as frequent, divided among its places and forms
        self.shares = met - np.log(np.count_nonzero(count) * count[kinds])
        chosen, usual = np.ix_(self.rows, there), key.together[np.ix_(there, there)]
        own = None if hypotheses.together is None else hypotheses.together[np.ix_(self.rows, there, there)]
        self._one = _NormalRows(self.table, hypotheses.values[chosen], hypotheses.scatters[chosen], usual, own)
        self._right = _NormalRows(self.table, self.table.right[None], self.table.scatter[None], usual)

    def only(self, k: int) -> ScaledExplanations:
        """Of explanation k alone, met as often as here, and hit by chance as often as all are."""
        one = copy(self)
        one.rows, one.shares, one._one = self.rows[[k]], self.shares[[k]], self._one.only(k)
        return one

    def weigh_partly(self, given: np.ndarray, wrong: np.ndarray) -> WeighedPartly:
        """For values (students, n) of which some are wrong, and of these some come from something else."""
        table, one = self.table, self._one
        values, scatters = np.where(one.judged, one.size, np.nan), 1 / np.where(one.judged, one.sharp, np.nan)
        z, none = differences(table, given[:, None, :], values) / scatters, _none_density(table, given)
        with np.errstate(invalid="ignore"):
            explained = (np.abs(z) <= FITS) & wrong[:, None, :] & (shifts(table, values) > MOVED)
            own = np.log(1 - _ELSE) - 0.5 * z**2 - np.log(scatters * np.sqrt(2 * np.pi))
            mixed = np.logaddexp(own, np.log(_ELSE) + _broad(table, given)[:, None, :])
        weights = np.where(one.judged, mixed, none[:, None, :]).sum(axis=2) + self.shares
        who, row = np.nonzero(explained.sum(axis=2) > 1)
        hit, chance = explained[who, row], np.ones(weights.shape)
        # how often random numbers hit as many of the wrong values so well
        count, of = hit.sum(axis=1), wrong.sum(axis=1)[who]
        crowded = np.where(one.judged, _crowded(table, values) + np.log(scatters), 0.0)[row]
        cells = np.where(hit, crowded, 0.0).sum(axis=1) + np.log(max(len(self.rows), 1))
        factorial = np.cumsum(np.log(np.maximum(np.arange(given.shape[1] + 1), 1)))
        choices = factorial[of] - factorial[count] - factorial[of - count]
        halves = np.array([0.5 * n * np.log(np.pi) - lgamma(n / 2 + 1) for n in range(given.shape[1] + 1)])
        with np.errstate(divide="ignore"):
            ball = halves[count] + 0.5 * count * np.log(np.where(hit, z[who, row] ** 2, 0.0).sum(axis=1))
        chance[who, row] = np.exp(np.minimum(ball + cells + choices, 0.0))
        return WeighedPartly(weights, chance, explained, none.sum(axis=1) + _NONE)

    def right_by(self, given: np.ndarray, methods: Hypotheses) -> np.ndarray:
        """Weights of right work by the likeliest of some methods (students,), their rows being right values."""
        own = None if methods.together is None else methods.together[:, self._there][:, :, self._there]
        values, scatters = methods.values[:, self._there], methods.scatters[:, self._there]
        rows = _NormalRows(self.table, values, scatters, self._right.usual, own)
        weights = rows.weigh(given, _none_density(self.table, given))[0]
        return np.asarray(weights.max(axis=1, initial=-np.inf) + _RIGHT)

    def drawn(self, k: int, errors: np.ndarray) -> np.ndarray:
        """Values of those who make mistake k (students, n), normal about what it gives; errors: standard normal."""
        return self._one.drawn(k, errors)

    def weigh_slips(self, given: np.ndarray, slips: SlipOutcomes) -> Weighed:
        """Slips in the values of students (students, n): the slip's own value may be anything, the others scatter about
        what follows from it as right values do once it is known."""
        table, own = self.table, np.eye(given.shape[1], dtype=bool)
        off = differences(table, given[:, None, :], slips.values) / slips.scatters
        row, who = np.nonzero((np.isfinite(off) | own).all(axis=2).T)  # row by row
        near, worst, density, chance = self._slips.closely(np.where(own[row], 0.0, off[who, row]), row)
        larger = np.nansum(np.log(slips.scatters[who, row]), axis=1)
        apart = -0.5 * (near + self._slips.count[row] * np.log(2 * np.pi)) - larger + _broad(table, given)[who, row]
        weights = density - larger + _broad(table, given)[who, row] + _SLIP - np.log(len(own))
        every = np.full((4, *given.shape), [[[-np.inf]], [[np.inf]], [[-np.inf]], [[1.0]]])
        every[:, who, row] = weights, worst, apart, chance
        weights, worst, apart, chance = every
        return Weighed(weights, worst, apart, chance, np.empty(0), np.empty(0))

    @cached_property
    def _slips(self) -> _NormalRows:
        """Right values but for one each, scattered as they are once that is known."""
        own = np.eye(len(self.table.right), dtype=bool)
        together = once_known(self._right.usual)[1]
        together[own[:, :, None] | own[:, None, :]] = 0.0
        values, scatters = (np.where(own, np.nan, one) for one in (self.table.right, self.table.scatter))
        return _NormalRows(self.table, values, scatters, self._right.usual, together)

    def weigh(self, given: np.ndarray) -> Weighed:
        """For students' values (students, n)."""
        none = _none_density(self.table, given)
        weights, worst, apart, chance = self._one.weigh(given, none)
        right = self._right.weigh(given, none)[0]
        return Weighed(weights + self.shares, worst, apart, chance, right[:, 0] + _RIGHT, none.sum(axis=1) + _NONE)


def once_known(together: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The rest of scatters that go together (n, n) once one of them is known, a row for each: the part of each
    standard deviation (n, n), and the correlations (n, n, n)."""
    left = together - together[:, :, None] * together[:, None, :]
    parts = np.sqrt(np.maximum(np.diagonal(left, axis1=1, axis2=2), LEFT**2))
    correlations = np.clip(left / (parts[:, :, None] * parts[:, None, :]), -1.0, 1.0)
    correlations[:, np.arange(len(together)), np.arange(len(together))] = 1.0
    return parts, correlations


def visible(table: Columns, values: np.ndarray) -> np.ndarray:
    """The rows of values (m, n) that move one by more than a pencil might, as booleans."""
    with np.errstate(invalid="ignore"):
        return np.asarray(np.any(shifts(table, values) > MOVED, axis=1))


def shifts(table: Columns, values: np.ndarray) -> np.ndarray:
    """By how many standard deviations values (.., n) are off the right ones; NaN where there is none."""
    return np.asarray(np.abs(differences(table, values, table.right)) / table.scatter)


def _broad(table: Columns, values: np.ndarray) -> np.ndarray:
    """Logarithm of the density of a value of which nothing is known: about as large as the right one, or far off."""
    size = np.maximum(np.abs(table.right), 10 * table.scatter)
    sides = np.where(table.size, 2.0, 1.0)  # a size has no sign
    return np.asarray(np.log(sides / (np.pi * size)) - np.log1p((values / size) ** 2))


def _crowded(table: Columns, values: np.ndarray) -> np.ndarray:
    """Logarithm of how densely random numbers may lie: of any size from a fifth to five times the right one, too."""
    ratio = np.abs(values) / np.maximum(np.abs(table.right), 10 * table.scatter)
    sides = np.where(table.size, 1.0, 2.0)
    with np.errstate(divide="ignore"):
        even = -np.log(2 * np.log(_REACH) * sides * np.abs(values))
    inside = (ratio > 1 / _REACH) & (ratio < _REACH)
    return np.where(inside, np.fmax(even, _broad(table, values)), _broad(table, values))


def _none_density(table: Columns, given: np.ndarray) -> np.ndarray:
    """Logarithm of the density of a value that is right in half of the cases, and anything in the others."""
    z = differences(table, given, table.right) / table.scatter
    right = -0.5 * z**2 - np.log(table.scatter * np.sqrt(2 * np.pi))
    return np.asarray(np.logaddexp(right, _broad(table, given)) - np.log(2))


def _turned(angles: np.ndarray) -> np.ndarray:
    """Modulo a turn."""
    return np.asarray(angles - _TURN * np.round(angles / _TURN))


class _NormalRows:
    """Explanations: normal in the quantities that they judge, "none" in the others.

    values, scatters (m, n), NaN where one says nothing
    usual     correlation of values where a row has none of its own (n, n)
    together  each row's own (m, n, n); NaN, or None, where it has none
    """

    def __init__(
        self, table: Columns, values: np.ndarray, scatters: np.ndarray, usual: np.ndarray,
        together: np.ndarray | None = None,
    ) -> None:  # fmt: skip
        self.table, self.given, self.usual, self.together = table, (values, scatters), usual, together
        self.judged = np.isfinite(values) & np.isfinite(scatters)
        self.size = np.where(self.judged, upright(table, values), 0.0)
        self.sharp = 1 / np.where(self.judged, scatters, np.inf)
        self.count = self.judged.sum(axis=1)
        self.own = np.where(self.judged, np.log(scatters), 0.0).sum(axis=1)
        self._axes: dict[int, tuple[np.ndarray, ...]] = {}
        # a logarithm of how many rows that judge as many quantities random numbers meet, for balls of radius 1
        crowded = self.own + np.where(self.judged, _crowded(table, self.size), 0.0).sum(axis=1)
        self._cells = np.zeros(len(values))
        for size in np.unique(self.count):
            ball = 0.5 * size * np.log(np.pi) - lgamma(size / 2 + 1)
            self._cells[self.count == size] = ball + np.logaddexp.reduce(crowded[self.count == size])

    def only(self, k: int) -> _NormalRows:
        """Row k alone; chance hits it as often as all of them."""
        values, scatters = (some[[k]] for some in self.given)
        one = _NormalRows(self.table, values, scatters, self.usual)
        one._axes[0], one._cells = self._apart(k), self._cells[[k]]
        return one

    def drawn(self, k: int, errors: np.ndarray) -> np.ndarray:
        """Values (students, n) that scatter as those of a row; errors: standard normal (students, n)."""
        axes, along = self._apart(k)[:2]
        off = errors[:, : len(along)] * along @ axes.T / np.where(self.judged[k], self.sharp[k], 1.0)
        return np.asarray(upright(self.table, self.size[k] + off))

    def weigh(self, given: np.ndarray, none: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Weights, worst deviations, densities without a common part, chance: (students, m) each; weights and densities
        as logarithms. Where some value must be off by more than fits, the worst is infinite, and the density without a
        common part will do."""
        given = upright(self.table, given)
        near = self._near(given)
        worst, chance = np.full_like(near, np.inf), np.ones_like(near)
        row, who = np.nonzero((near < FITS**2 * self.count).T)  # row by row
        off = given[who] - self.size[row]
        if self.table.angle.any():
            off[:, self.table.angle] = _turned(off[:, self.table.angle])
        weights = -0.5 * (near + self.count * np.log(2 * np.pi)) - np.log(1 + len(_COMMON))
        close = self.closely(off * self.sharp[row], row)
        near[who, row], worst[who, row], weights[who, row], chance[who, row] = close
        rest = np.broadcast_to(-self.own, near.shape)
        if not self.judged.all():  # of the quantities that a row does not judge nothing is known
            rest = rest + np.einsum("ns,nm->sm", none.T.copy(), (~self.judged.T).astype(float))
        apart = rest - 0.5 * (near + self.count * np.log(2 * np.pi))
        return weights + rest, worst, apart, chance

    def _near(self, given: np.ndarray) -> np.ndarray:
        """Sums of the squares of the deviations (students, m), multiplied out: near enough for those far off."""
        weight = np.where(self.table.angle, 0.0, self.sharp**2)  # (a - b)^2 = a^2 - 2 a b + b^2
        factors = np.concatenate([weight.T, (-2 * self.size * weight).T])
        rest = (self.size**2 * weight).sum(axis=1)
        # no matrix product: on matrices as small its threads cost more than they give
        near = np.einsum("ks,km->sm", np.concatenate([given.T**2, given.T]), factors) + rest
        for k in np.flatnonzero(self.table.angle):
            near += (_turned(given[:, k, None] - self.size[:, k]) * self.sharp[:, k]) ** 2
        return np.asarray(np.maximum(near, 0.0))

    def closely(self, z: np.ndarray, row: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Of deviations (pairs, n) from rows (pairs,), in their order, in standard deviations: sums of their squares,
        the worst, logarithms of the mean of their densities with and without a common part, chance."""
        near, worst = np.einsum("pn,pn->p", z, z), np.abs(z).max(axis=1, initial=0.0)
        squares = np.empty((len(near), 1 + len(_COMMON)))
        squares[:, 0] = near
        ends = np.flatnonzero(np.diff(row, append=-1)) + 1
        for start, end in zip((0, *ends), ends, strict=False):
            axes, _, sharp, sizes = self._apart(int(row[start]))
            squares[start:end, 1:] = (z[start:end] @ axes) ** 2 @ sharp + sizes
        mean: np.ndarray = np.logaddexp.reduce(-0.5 * squares, axis=1) - np.log(1 + len(_COMMON))
        count = self.count[row]
        with np.errstate(divide="ignore", invalid="ignore"):
            radius = np.where(count, 0.5 * count * np.log(near), 0.0)
        chance = np.exp(np.minimum(self._cells[row] + radius, 0.0))
        return near, worst, mean - 0.5 * count * np.log(2 * np.pi), chance

    def _apart(self, row: int) -> tuple[np.ndarray, ...]:
        """Of a row: deviations along these axes (n, ..) do not hang together, and how far they go (..,); by what their
        squares are multiplied, and what is added, for each part that is common (.., parts), (parts,)."""
        if row not in self._axes:
            judged = self.judged[row]
            own = None if self.together is None else self.together[row]
            if own is None or np.isnan(own).any():  # a larger value errs as the right one does, whichever way it points
                turned = ~self.table.angle & (self.size[row] * upright(self.table, self.table.right) < 0)
                outward = np.where(turned, -1.0, 1.0)
                own = self.usual * np.outer(outward, outward)
            sizes, axes = np.linalg.eigh(own[np.ix_(judged, judged)])
            parts = np.array(_COMMON)
            variances = np.maximum(parts * sizes[:, None] + 1 - parts, 1 - parts)  # smaller ones are rounding
            axes = np.eye(len(judged))[:, judged] @ axes
            along = np.sqrt(np.maximum(sizes, 0.0))
            self._axes[row] = axes, along, 1 / variances, np.log(variances).sum(axis=0)
        return self._axes[row]
