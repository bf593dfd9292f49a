"""Whether the mistakes of a problem can be told apart by its answers, and how well its template can do at all.

Some mistakes give the same answers whatever the numbers: these are one set, and count for nothing here. What else lies
within the tolerance, of each other or of the right answers, depends on the numbers: such problems are avoided.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from operator import add

import numpy as np

from graphkin.base.value import frozen
from graphkin.marking.key import Name
from graphkin.marking.telling import Telling

LOOKED_AT = 6
"""So many problems are looked at for one that does as well as the best third of a sample; then the best of them."""


@frozen
class Discriminability:
    """What one problem tells of mistakes.

    lost      how many mistakes it loses that its template can tell
    kinds     by a mistake's id: at how many places it can be made, is seen, and is told from all others
    sets      kinds that answers cannot tell apart, as pairs of ids, with how many places
    rivals    the same of those that lie within the tolerance with these numbers alone
    """

    lost: int
    kinds: Mapping[str, tuple[int, int, int]]
    sets: Mapping[tuple[str, str], int]
    rivals: Mapping[tuple[str, str], int]


class Always:
    """What is the same in all of some problems of one template: mistakes with equal answers, or with the right ones."""

    def __init__(self, found: Sequence[Telling]) -> None:
        self.places = {name: k for k, name in enumerate(dict.fromkeys(n for one in found for n in one.names))}
        count = len(self.places)
        self.same = np.ones((count, count), dtype=bool)
        self.still = np.ones(count, dtype=bool)
        for one in found:
            at = np.array([self.places[name] for name in one.names], dtype=int)
            self.same[np.ix_(at, at)] &= one.same
            self.still[at] &= one.still

    def told(self, telling: Telling) -> Discriminability:
        """Of one problem; a mistake that none of the others had is always told from them."""
        same, still = self._of(telling)
        rivals, sets = telling.near & ~same, telling.near & same
        lost = (~telling.seen & ~still) | rivals.any(axis=1)
        apart = telling.seen & ~telling.near.any(axis=1)
        kinds = np.array([name[0] for name in telling.names], dtype=object)
        counts = {
            kind: (int(of.sum()), int((of & telling.seen).sum()), int((of & apart).sum()))
            for kind in dict.fromkeys(kinds)
            for of in (kinds == kind,)
        }
        return Discriminability(int(lost.sum()), counts, _pairs(telling.names, sets), _pairs(telling.names, rivals))

    def _of(self, telling: Telling) -> tuple[np.ndarray, np.ndarray]:
        at = np.array([self.places.get(name, -1) for name in telling.names], dtype=int)
        known = at >= 0
        if not self.places:
            return np.zeros((len(at), len(at)), dtype=bool), np.zeros(len(at), dtype=bool)
        return self.same[np.ix_(at, at)] & known & known[:, None], self.still[at] & known


def _pairs(names: Sequence[Name], which: np.ndarray) -> dict[tuple[str, str], int]:
    """Pairs of kinds, and of how many places the rarer of both is."""
    places: dict[tuple[str, str], tuple[set[int], set[int]]] = {}
    for row, other in zip(*np.nonzero(which), strict=True):
        first, second = names[row][0], names[other][0]
        if first < second:
            both = places.setdefault((first, second), (set(), set()))
            both[0].add(int(row))
            both[1].add(int(other))
    return {pair: min(map(len, both)) for pair, both in places.items()}


@frozen
class SetTold:
    """What the problems of a set tell of mistakes, on average.

    problems  how many
    pencil    what it errs by [mm, deg]
    places    at how many places a mistake can be made in a problem, and the part of these that is seen and that is
              told from all others
    lost      the part that is lost by the numbers alone
    kinds     by id: places in one problem, the part of them that is seen, and that is told from all others
    sets      ids that the answers of no problem tell apart, with the part of the places that is meant
    rivals    ids that lie within the tolerance in some problems alone, with the part of problems; most first
    tried     how many problems the false alarms come from: part of right work by pencil that has a value judged wrong,
              and that gets a mistake
    """

    problems: int
    pencil: tuple[float, float]
    places: float
    seen: float
    apart: float
    lost: float
    kinds: Mapping[str, tuple[float, float, float]]
    sets: Mapping[tuple[str, str], float]
    rivals: Mapping[tuple[str, str], float]
    tried: int
    alarms: tuple[float, float]


def set_told(
    found: Sequence[Discriminability], pencil: tuple[float, float], alarms: Sequence[tuple[float, float]] = ()
) -> SetTold:
    """Of all problems together; `alarms` of some of them."""
    sums: dict[str, tuple[int, ...]] = {}
    sets: Counter[tuple[str, str]] = Counter()
    rivals: Counter[tuple[str, str]] = Counter()
    for one in found:
        for kind, counts in one.kinds.items():
            sums[kind] = tuple(map(add, sums.get(kind, (0, 0, 0)), counts))
        sets.update(dict(one.sets))
        rivals.update(dict.fromkeys(one.rivals, 1))
    count, (places, seen, apart) = max(len(found), 1), map(sum, zip((0, 0, 0), *sums.values(), strict=True))
    every = max(places, 1)
    wrong, named = (sum(each) / max(len(alarms), 1) for each in zip((0.0, 0.0), *alarms, strict=True))
    return SetTold(
        len(found), pencil, places / count, seen / every, apart / every, sum(one.lost for one in found) / every,
        {kind: (n / count, seen / n, apart / n) for kind, (n, seen, apart) in sums.items()},
        {pair: n / min(sums[kind][0] for kind in pair) for pair, n in sets.most_common()},
        {pair: n / count for pair, n in rivals.most_common()},
        len(alarms), (wrong, named),
    )  # fmt: skip
