"""The mistake behind wrong values: every explanation weighed by all handed-in values together.

One mistake is tried before two. An explanation is given where every value is near to what it says, where it outweighs
right work and "none", and where so near a hit is no likely coincidence. All that the values cannot tell from it are
given with it, as one set.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field

import numpy as np

from graphkin.marking.key import Hypotheses, Key, Name
from graphkin.marking.verdicts import Columns, agrees, differences
from graphkin.marking.weights import ONE, TWO, Weighed, weigh
from graphkin.value import frozen

MARGIN = 3.0
"""Explanations whose weights differ by less cannot be told apart: a factor of 20."""
_FITS = 4.5
"""A value that is off by more standard deviations is not explained."""
_LIKELY = 0.5
_SAME = 0.5
"""Explanations whose values differ by less, in standard deviations, are one."""
_CHANCE = 0.008
"""A hit that random numbers make more often is no hint."""
_PAIRS_FROM = 4
"""So many independent values, before two mistakes are looked for."""


@frozen
class Explanation:
    """One explanation, or several that the values cannot tell apart.

    names        the mistakes: one or two of them for each way in which they explain the values
    probability  of all these together
    margin       by how much they together outweigh the best of the others, as a logarithm to base e
    explains     the wrong values that follow
    """

    names: tuple[tuple[Name, ...], ...]
    probability: float
    margin: float
    explains: tuple[str, ...]

    @property
    def ids(self) -> tuple[str, ...]:
        """The mistakes' ids, each once."""
        return tuple(dict.fromkeys(name[0] for names in self.names for name in names))


@frozen
class Diagnosis:
    """What the wrong values come from; `evidence`: by a mistake's id, how it outweighs "none" here (a logarithm).

    Evidence of several problems of one student is added up (`habits`).
    """

    explanations: tuple[Explanation, ...] = ()
    evidence: Mapping[str, float] = field(default_factory=dict)


def diagnoses(
    key: Key, table: Columns, given: np.ndarray, wrong: np.ndarray, pairs: Callable[[], Hypotheses | None]
) -> list[Diagnosis]:
    """For students who have handed in the same quantities: given, wrong (students, n).

    pairs  makes what two mistakes give; called where it is needed
    """
    there = np.isfinite(given).all(axis=0)
    if not len(given) or not there.any():
        return [Diagnosis() for _ in given]
    one = weigh(key, table, given, key.singles, ONE)
    ids, evidence = _evidence(one, key.singles)
    found = []
    for k in range(len(given)):
        explanations = _explanations(key, table, given[k], wrong[k], one, k, key.singles)
        found.append(Diagnosis(explanations, dict(zip(ids, evidence[k].tolist(), strict=True))))
    rest = np.array([k for k, one in enumerate(found) if not one.explanations], dtype=int)
    if rest.size and independent(key, there) >= _PAIRS_FROM and (two := pairs()) is not None:
        weighed = weigh(key, table, given[rest], two, TWO, near_only=True)
        for row, k in enumerate(rest):
            found[k] = Diagnosis(_explanations(key, table, given[k], wrong[k], weighed, row, two), found[k].evidence)
    return found


def independent(key: Key, there: np.ndarray) -> int:
    """How many of the handed-in values say something of their own."""
    if not there.any():
        return 0
    return int(np.sum(np.linalg.eigvalsh(key.together[np.ix_(there, there)]) > 1e-3))


def _explanations(
    key: Key, table: Columns, given: np.ndarray, wrong: np.ndarray, weighed: Weighed, k: int, hypotheses: Hypotheses
) -> tuple[Explanation, ...]:
    """Of one student, whose weights are in row k: one explanation, or none."""
    weights = weighed.weights[k]
    if not weights.size:
        return ()
    others = np.logaddexp(weighed.right[k], weighed.none[k])
    fits = (weighed.worst[k] <= _FITS) & (weighed.chance[k] <= _CHANCE)
    if not fits.any():
        return ()
    first = int(np.flatnonzero(fits)[np.argmax(weights[fits])])
    likely = weights - weighed.shares
    alike = _close(table, hypotheses, weighed.rows, first, given)
    # what scatters together in a wrong drawing is known roughly: values as near one by one are not told apart by that
    alike |= weighed.near[k] < weighed.near[k, first] + 2 * MARGIN
    same = fits & (alike | (likely > likely[first] - MARGIN))
    total = np.logaddexp(np.logaddexp.reduce(weights), others)
    together = np.logaddexp.reduce(weights[same])
    margin = together - max(weighed.right[k], weighed.none[k], weights[~same].max(initial=-np.inf))
    probability = float(np.exp(together - total))
    if probability < _LIKELY or together < weighed.right[k] + MARGIN:
        return ()
    order = np.flatnonzero(same)[np.argsort(-weights[same], kind="stable")]
    each = (_explained(key, table, given, wrong, hypotheses, int(weighed.rows[row])) for row in order)
    explains = next(filter(None, each), ())  # some of the set may say nothing of what is wrong
    if not explains:
        return ()
    names = tuple(hypotheses.names[weighed.rows[row]] for row in order)
    return (Explanation(names, probability, float(margin), explains),)


def _close(
    table: Columns, hypotheses: Hypotheses, rows: np.ndarray, first: int, given: np.ndarray
) -> np.ndarray:
    """Which rows say nearly the same of all that is handed in, and judge the same."""
    there = np.isfinite(given)
    values, scatters = hypotheses.values[rows], hypotheses.scatters[rows[first]]
    apart = np.abs(differences(table, values, values[first])) <= _SAME * scatters
    found: np.ndarray = np.all((apart | np.isnan(values) & np.isnan(values[first]))[:, there], axis=1)
    return found


def _evidence(weighed: Weighed, hypotheses: Hypotheses) -> tuple[list[str], np.ndarray]:
    """Ids of single mistakes, and by how much the best of each one's forms outweighs "none" (students, ids)."""
    of = np.array([hypotheses.names[row][0][0] for row in weighed.rows], dtype=object)
    ids = list(dict.fromkeys(of))
    found = [weighed.weights[:, of == id].max(axis=1) - weighed.none for id in ids]
    return ids, np.stack(found, axis=1) if found else np.empty((len(weighed.none), 0))


def _explained(
    key: Key, table: Columns, given: np.ndarray, wrong: np.ndarray, hypotheses: Hypotheses, row: int
) -> tuple[str, ...]:
    """The wrong values that are as the mistake has them."""
    value, reach = hypotheses.values[row], np.fmax(table.tolerance, _FITS * hypotheses.scatters[row])
    follows = wrong & agrees(table, given, value, reach)
    return tuple(key.entries[k].text for k in np.flatnonzero(follows))
