"""The best explanation of each of many students' values, as arrays.

It is one to which every value is near, which outweighs right work and "none", and which is hit no likely by chance. All
that the values cannot tell from it are given with it, as one set.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from copy import copy

import numpy as np

from graphkin.base.value import frozen
from graphkin.marking.key import Hypotheses, Key, Name
from graphkin.marking.verdicts import Columns, agrees, columns_of, differences
from graphkin.marking.weights import FITS, ScaledExplanations, Weighed

MARGIN = 3.0
"""Explanations whose weights differ by less cannot be told apart: a factor of 20."""
_LIKELY = 0.5
_SAME = 0.5
"""Explanations whose values differ by less, in standard deviations, are one."""
_CHANCE = 0.008
"""A hit that random numbers make more often is no hint."""
_AT_ONCE = 1 << 16
"""Weights that are held at once."""


Ways = Callable[[], Hypotheses]
"""Makes what right work gives that takes other right ways; called where it is needed."""


@frozen
class Best:
    """The best explanations of some students' values, of m that there are.

    given        whether one is given (students,)
    same         what is in it: all that these values cannot tell from the best (students, m)
    weights      of all of them (students, m); none: of work that nothing explains (students,)
    probability  of what is in it; margin: by how much it outweighs the best of the others (students,)
    follows      for each True of `same`, in its order: which wrong values are as it has them (.., quantities)
    """

    given: np.ndarray
    same: np.ndarray
    weights: np.ndarray
    none: np.ndarray
    probability: np.ndarray
    margin: np.ndarray
    follows: np.ndarray


class Explainer:
    """Explains the values of those who hand in the same quantities by one mistake, or by two.

    there  which of the key's quantities these are
    texts  of these; names: of the m explanations that can be seen in them
    """

    def __init__(
        self, key: Key, table: Columns, there: np.ndarray, hypotheses: Hypotheses, met: float, ways: Ways
    ) -> None:
        """met: logarithm of how often one of the hypotheses is met."""
        self.there, self._scale, self._ways = there, ScaledExplanations(key, table, there, hypotheses, met), ways
        rows, self._hypotheses = self._scale.rows, hypotheses
        self.texts = tuple(entry.text for entry, handed in zip(key.entries, there, strict=True) if handed)
        self._table = columns_of(table, there)
        self._values, self._scatters = (some[np.ix_(rows, there)] for some in (hypotheses.values, hypotheses.scatters))

    @property
    def names(self) -> tuple[tuple[Name, ...], ...]:
        return tuple(self._hypotheses.names[row] for row in self._scale.rows)

    def name(self, k: int) -> tuple[Name, ...]:
        return self._hypotheses.names[self._scale.rows[k]]

    def only(self, k: int) -> Explainer:
        """Who knows of explanation k alone."""
        one = copy(self)
        one._scale = self._scale.only(k)
        one._values, one._scatters = self._values[[k]], self._scatters[[k]]
        return one

    def drawn(self, k: int, errors: np.ndarray) -> np.ndarray:
        """What those who make mistake k hand in (students, quantities of the key); errors: standard normal."""
        given = np.full((len(errors), len(self.there)), np.nan)
        given[:, self.there] = self._scale.drawn(k, errors)
        return given

    def best(self, given: np.ndarray, wrong: np.ndarray) -> Iterator[Best]:
        """Of values of which some are wrong (students, quantities of the key), as many as are held at once."""
        step = max(_AT_ONCE // max(len(self._scale.rows), 1), 1)
        for k in range(0, len(given), step):
            yield self._best(given[k : k + step, self.there], wrong[k : k + step, self.there])

    def _best(self, given: np.ndarray, wrong: np.ndarray) -> Best:
        weighed = self._scale.weigh(given)
        same = self._sets(weighed)
        together, every = _sums(weighed.weights, same)
        right = weighed.right
        if np.any(together > right + MARGIN):
            right = np.maximum(right, self._scale.right_by(given, self._ways()))
        others = np.maximum(right, weighed.none)
        rest = np.where(same, -np.inf, weighed.weights).max(axis=1, initial=-np.inf)
        with np.errstate(invalid="ignore"):
            total = np.logaddexp(every, np.logaddexp(right, weighed.none))
            margin, probability = together - np.maximum(others, rest), np.exp(together - total)
        same[(probability < _LIKELY) | (together < right + MARGIN)] = False
        who, row = np.nonzero(same)
        follows = self._follow(given[who], wrong[who], row)
        # some of a set may say nothing of what is wrong
        told = np.bincount(who[follows.any(axis=1)], minlength=len(given)) > 0
        return Best(told, same & told[:, None], weighed.weights, weighed.none, probability, margin, follows[told[who]])

    def _sets(self, weighed: Weighed) -> np.ndarray:
        """The best of those that fit, with all that cannot be told from it (students, m)."""
        fits = (weighed.worst <= FITS) & (weighed.chance <= _CHANCE)
        who, row = np.nonzero(fits)
        if not who.size:
            return fits
        first = np.where(fits, weighed.weights, -np.inf).argmax(axis=1)[who]
        likely = weighed.weights - self._scale.shares
        alike = likely[who, row] > likely[who, first] - MARGIN
        # what scatters together is known roughly: values as near one by one are not told apart by that
        alike |= weighed.near[who, row] < weighed.near[who, first] + 2 * MARGIN
        fits[who, row] = alike | self._close(row, first)
        return fits

    def _close(self, rows: np.ndarray, others: np.ndarray) -> np.ndarray:
        """Which explanations say nearly the same as others, and judge the same: (pairs,) each."""
        one, other = self._values[rows], self._values[others]
        with np.errstate(invalid="ignore"):
            apart = np.abs(differences(self._table, one, other)) <= _SAME * self._scatters[others]
        found: np.ndarray = np.all(apart | np.isnan(one) & np.isnan(other), axis=1)
        return found

    def _follow(self, given: np.ndarray, wrong: np.ndarray, rows: np.ndarray) -> np.ndarray:
        """Which wrong values (pairs, n) are as explanations have them."""
        reach = np.fmax(self._table.tolerance, FITS * self._scatters[rows])
        found: np.ndarray = wrong & agrees(self._table, given, self._values[rows], reach)
        return found


def _sums(weights: np.ndarray, some: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Of logarithms (students, m): of some of them, and of all."""
    largest = weights.max(axis=1, initial=-np.inf)
    base = np.where(np.isfinite(largest), largest, 0.0)
    parts = np.exp(weights - base[:, None])
    with np.errstate(divide="ignore"):
        return base + np.log(np.einsum("sm,sm->s", parts, some)), base + np.log(parts.sum(axis=1))
