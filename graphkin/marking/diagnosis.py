"""The mistake behind wrong values: every explanation weighed by all handed-in values together.

One mistake is tried before two. An explanation is given where every value is near to what it says, where it outweighs
right work and "none", and where so near a hit is no likely coincidence. All that the values cannot tell from it are
given with it, as one set.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import field

import numpy as np

from graphkin.base.value import frozen
from graphkin.marking.explaining import Best, Explainer, Ways
from graphkin.marking.key import Hypotheses, Key, Name
from graphkin.marking.verdicts import Columns
from graphkin.marking.weights import ONE, TWO

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
    key: Key, table: Columns, given: np.ndarray, wrong: np.ndarray, pairs: Callable[[], Hypotheses | None], ways: Ways
) -> list[Diagnosis]:
    """For students who have handed in the same quantities: given, wrong (students, n).

    pairs  makes what two mistakes give, ways what right work gives by other ways; called where they are needed
    """
    there = np.isfinite(given).all(axis=0)
    if not len(given) or not there.any():
        return [Diagnosis() for _ in given]
    one, found = Explainer(key, table, there, key.singles, ONE, ways), []
    for best in one.best(given, wrong):
        evidence = _evidence(best, one)
        found += [Diagnosis(each, evidence[k]) for k, each in enumerate(_explanations(one, best))]
    rest = np.array([k for k, one in enumerate(found) if not one.explanations], dtype=int)
    if rest.size and independent(key, there) >= _PAIRS_FROM and (two := pairs()) is not None:
        both = Explainer(key, table, there, two, TWO, ways)
        each = (some for best in both.best(given[rest], wrong[rest]) for some in _explanations(both, best))
        for k, explanations in zip(rest, each, strict=True):
            found[k] = Diagnosis(explanations, found[k].evidence)
    return found


def independent(key: Key, there: np.ndarray) -> int:
    """How many of the handed-in values say something of their own."""
    if not there.any():
        return 0
    return int(np.sum(np.linalg.eigvalsh(key.together[np.ix_(there, there)]) > 1e-3))


def _explanations(explainer: Explainer, best: Best) -> Iterator[tuple[Explanation, ...]]:
    """Of each student: one, or none."""
    sizes = best.same.sum(axis=1)
    for k, (end, size) in enumerate(zip(np.cumsum(sizes), sizes, strict=True)):
        yield (_explanation(explainer, best, k, best.follows[end - size : end]),) if best.given[k] else ()


def _explanation(explainer: Explainer, best: Best, k: int, follows: np.ndarray) -> Explanation:
    """Of student k, the likeliest of its set first."""
    rows = np.flatnonzero(best.same[k])
    order = np.argsort(-best.weights[k, rows], kind="stable")
    explains = next(some for some in follows[order] if some.any())
    return Explanation(
        tuple(explainer.name(row) for row in rows[order]), float(best.probability[k]), float(best.margin[k]),
        tuple(explainer.texts[n] for n in np.flatnonzero(explains)),
    )  # fmt: skip


def _evidence(best: Best, explainer: Explainer) -> list[dict[str, float]]:
    """By how much the best of each mistake's forms outweighs "none", by its id, for each student."""
    of = np.array([names[0][0] for names in explainer.names], dtype=object)
    ids = list(dict.fromkeys(of))
    found = [best.weights[:, of == id].max(axis=1) - best.none for id in ids]
    each = np.stack(found, axis=1).tolist() if found else [[] for _ in best.none]
    return [dict(zip(ids, values, strict=True)) for values in each]
