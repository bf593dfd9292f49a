"""Evidence of several problems of one student: a mistake that shows in many is a habit, not a slip."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from graphkin.base.value import frozen
from graphkin.marking.explaining import MARGIN

_SHOWS = np.log((0.8, 0.2))
"""How often a habit shows in a problem, and how often it does not, as logarithms."""


@frozen
class Trace:
    """What the marking of one problem says.

    named     ids of what its numbers are consistent with; empty where nothing is wrong or nothing fits
    evidence  by a mistake's id, how it outweighs "none" there; empty where nothing is wrong
    """

    named: tuple[str, ...]
    evidence: Mapping[str, float]


@frozen
class Habit:
    """A mistake, or several that cannot be told apart, that shows in `shown` of `of` problems; weight: a logarithm."""

    ids: tuple[str, ...]
    shown: int
    of: int
    weight: float


def added(traces: Iterable[Trace]) -> dict[str, float]:
    """By how much each mistake, as a habit, outweighs "none" in all problems together: log-likelihoods added.

    A habit shows in four problems of five, so that another mistake in one of them, or right work, speaks against it but
    does not rule it out.
    """
    traces = list(traces)
    total = dict.fromkeys((id for one in traces for id in one.evidence), 0.0)
    for one in traces:
        for id in total:
            if not one.evidence:
                total[id] += float(_SHOWS[1])
            elif id in one.evidence:
                total[id] += float(np.logaddexp(_SHOWS[0] + one.evidence[id], _SHOWS[1]))
    return total


def habits(traces: Sequence[Trace]) -> tuple[Habit, ...]:
    """The mistakes that show in two problems or more, the weightiest first; what is explained by one is no other's."""
    where = _where(traces)
    weights = {id: weight for id, weight in added(traces).items() if len(where.get(id, ())) > 1 and weight > MARGIN}
    found = []
    while weights:
        best = max(weights, key=lambda id: (weights[id], len(where[id])))
        alike = [id for id in weights if where[id] == where[best] and weights[id] > weights[best] - MARGIN]
        found.append(Habit(tuple(alike), len(where[best]), len(traces), weights[best]))
        weights = {id: weight for id, weight in weights.items() if not where[id] <= where[best]}
    return tuple(found)


def _where(traces: Sequence[Trace]) -> dict[str, set[int]]:
    """The problems in which each mistake is named."""
    found: dict[str, set[int]] = {}
    for k, one in enumerate(traces):
        for id in one.named:
            found.setdefault(id, set()).add(k)
    return found
