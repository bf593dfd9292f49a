"""The best explanation of each of many students' values, as arrays.

It is one to which every value is near, which outweighs right work and "none", and which is hit no likely by chance. All
that the values cannot tell from it are given with it, as one set.
"""

from __future__ import annotations

from collections.abc import Iterator
from copy import copy

import numpy as np

from graphkin.marking.key import Hypotheses, Key
from graphkin.marking.verdicts import Columns, agrees, columns_of, differences
from graphkin.marking.weights import FITS, Scale, Weighed
from graphkin.value import frozen

MARGIN = 3.0
"""Explanations whose weights differ by less cannot be told apart: a factor of 20."""
_LIKELY = 0.5
_SAME = 0.5
"""Explanations whose values differ by less, in standard deviations, are one."""
_CHANCE = 0.008
"""A hit that random numbers make more often is no hint."""
_AT_ONCE, _STUDENTS = 1 << 16, 256
"""Weights that are held at once, and students: as many as one core does best."""


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
    names  of the m explanations that can be seen in them; texts: of the quantities
    """

    def __init__(self, key: Key, table: Columns, there: np.ndarray, hypotheses: Hypotheses, met: float) -> None:
        """met: logarithm of how often one of the hypotheses is met."""
        self.there, self._scale = there, Scale(key, table, there, hypotheses, met)
        rows = self._scale.rows
        self.names = tuple(hypotheses.names[row] for row in rows)
        self.texts = tuple(entry.text for entry, handed in zip(key.entries, there, strict=True) if handed)
        self._table = columns_of(table, there)
        self._values, self._scatters = (some[np.ix_(rows, there)] for some in (hypotheses.values, hypotheses.scatters))

    def only(self, k: int) -> Explainer:
        """Who knows of explanation k alone."""
        one = copy(self)
        one._scale, one.names = self._scale.only(k), (self.names[k],)
        one._values, one._scatters = self._values[[k]], self._scatters[[k]]
        return one

    def drawn(self, k: int, errors: np.ndarray) -> np.ndarray:
        """What those who make mistake k hand in (students, quantities of the key); errors: standard normal."""
        given = np.full((len(errors), len(self.there)), np.nan)
        given[:, self.there] = self._scale.drawn(k, errors)
        return given

    def best(self, given: np.ndarray, wrong: np.ndarray) -> Iterator[Best]:
        """Of values of which some are wrong (students, quantities of the key), as many as are held at once."""
        step = min(max(_AT_ONCE // max(len(self.names), 1), 1), _STUDENTS)
        for k in range(0, len(given), step):
            yield self._best(given[k : k + step, self.there], wrong[k : k + step, self.there])

    def _best(self, given: np.ndarray, wrong: np.ndarray) -> Best:
        weighed = self._scale.weigh(given)
        same = self._sets(weighed)
        together, every = _sums(weighed.weights, same)
        others = np.maximum(weighed.right, weighed.none)
        rest = np.where(same, -np.inf, weighed.weights).max(axis=1, initial=-np.inf)
        with np.errstate(invalid="ignore"):
            total = np.logaddexp(every, np.logaddexp(weighed.right, weighed.none))
            margin, probability = together - np.maximum(others, rest), np.exp(together - total)
        same[(probability < _LIKELY) | (together < weighed.right + MARGIN)] = False
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
