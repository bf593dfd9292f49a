"""Discriminability of mistakes: which of them the answers to a problem tell apart, as far as paper allows.

Mistakes of one kind count as one wherever they are made: to tell them apart helps nobody. Some give the same answers
whatever the numbers: these are one set, and count for nothing. What else lies within the tolerance, of each other or of
the right answers, depends on the numbers: such problems are avoided.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from operator import add

import numpy as np

from graphkin.base.value import frozen
from graphkin.construction import Plot
from graphkin.marking.consequences import SAME, combined, rewrites
from graphkin.marking.diagnosis import Explainer
from graphkin.marking.key import KeyEntry, Marking, Name, columns, columns_of, differences, upright
from graphkin.marking.key_making import AskedAnswers, asked_alone
from graphkin.planning import Method


@frozen
class MistakeVisibility:
    """The visibility of mistakes in the answers to one problem.

    names   of the mistakes that say anything of an answer (m,)
    seen    whether one puts an answer beyond its tolerance (m,)
    still   whether one leaves all answers as they are (m,)
    near    which two of different kinds that are seen lie within the tolerance in all answers (m, m)
    same    which two of different kinds give the very same answers (m, m)
    """

    names: tuple[Name, ...]
    seen: np.ndarray
    still: np.ndarray
    near: np.ndarray
    same: np.ndarray


def mistake_visibility(
    method: Method, plot: Plot, marking: Marking, asked: AskedAnswers | None = None
) -> MistakeVisibility:
    """By what a mechanism asks for, at the position of a plot; asked: these answers, where they are known."""
    quantities, entries, _ = asked or asked_alone(method, plot, marking)
    singles = rewrites(method, plot, quantities, marking.scales)
    values = combined(method, plot, quantities, [(one,) for one in singles]).values
    return compared(entries, [one.name for one in singles], values)


def compared(entries: Sequence[KeyEntry], names: Sequence[Name], values: np.ndarray) -> MistakeVisibility:
    """By the values that mistakes give for answers (mistakes, answers), NaN where one says nothing of an answer."""
    table = columns(entries)
    rows: list[int] = np.flatnonzero(np.isfinite(values).any(axis=1)).tolist()
    values = upright(table, values[rows])
    with np.errstate(invalid="ignore"):
        off = np.abs(differences(table, values, table.right))
        seen = (off > table.tolerance).any(axis=1)
        still = ~(off > SAME * np.maximum(np.abs(table.right), table.tolerance)).any(axis=1)
    # the pairs of rows that are within the tolerance, and that are equal; of what one does not judge it says nothing
    near, same = (np.ones((len(values), len(values)), dtype=bool) for _ in range(2))
    with np.errstate(divide="ignore", invalid="ignore"):
        # a value that is larger than the right one may be off by as much more
        larger = np.nan_to_num(np.abs(values) / np.abs(table.right), nan=1.0, posinf=1.0)
        reach = np.where(table.angle, table.tolerance, table.tolerance * np.maximum(larger, 1.0))
        for k in range(values.shape[1]):
            one, value = columns_of(table, np.arange(len(table.right)) == k), values[:, k : k + 1]
            off = np.abs(differences(one, value[:, None], value))[..., 0]
            near &= ~(off > np.maximum(reach[:, None, k], reach[:, k]))
            same &= ~(off > SAME * np.maximum(np.maximum(np.abs(value), np.abs(value[:, 0])), one.tolerance))
    ids = np.array([names[row][0] for row in rows])
    others, kept = ids[:, None] != ids, tuple(names[row] for row in rows)
    near = near & others & seen[:, None] & seen
    return MistakeVisibility(kept, seen, still, near, same & others)


# --- problems of one template -----------------------------------------------------------------

LOOKED_AT = 3
"""Problems that are looked at for one that does as well as the best third of a sample; then the best of them."""


@frozen
class Discriminability:
    """The mistakes that one problem tells apart.

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
    """The mistakes with equal answers, or with the right ones, in all of some problems of one template."""

    def __init__(self, problems: Sequence[MistakeVisibility]) -> None:
        self.places = {name: k for k, name in enumerate(dict.fromkeys(n for one in problems for n in one.names))}
        count = len(self.places)
        self.same = np.ones((count, count), dtype=bool)
        self.still = np.ones(count, dtype=bool)
        for one in problems:
            at = np.array([self.places[name] for name in one.names], dtype=int)
            self.same[np.ix_(at, at)] &= one.same
            self.still[at] &= one.still

    def told(self, one: MistakeVisibility) -> Discriminability:
        """Of one problem; a mistake that none of the others had is always told from them."""
        at = np.array([self.places.get(name, -1) for name in one.names], dtype=int)
        known = at >= 0
        if self.places:
            same, still = self.same[np.ix_(at, at)] & known & known[:, None], self.still[at] & known
        else:
            same, still = np.zeros((len(at), len(at)), dtype=bool), np.zeros(len(at), dtype=bool)
        rivals = one.near & ~same
        lost = (~one.seen & ~still) | rivals.any(axis=1)
        apart = one.seen & ~one.near.any(axis=1)
        ids = np.array([name[0] for name in one.names], dtype=object)
        kinds = {
            id: (int(of.sum()), int((of & one.seen).sum()), int((of & apart).sum()))
            for id in dict.fromkeys(ids)
            for of in (ids == id,)
        }
        return Discriminability(int(lost.sum()), kinds, _pairs(one.names, one.near & same), _pairs(one.names, rivals))


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
class SetDiscriminability:
    """The mistakes that the problems of a set tell apart, on average.

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


def set_discriminability(
    problems: Sequence[Discriminability], pencil: tuple[float, float], alarms: Sequence[tuple[float, float]] = ()
) -> SetDiscriminability:
    """Of all problems together; `alarms` of some of them."""
    sums: dict[str, tuple[int, ...]] = {}
    sets: Counter[tuple[str, str]] = Counter()
    rivals: Counter[tuple[str, str]] = Counter()
    for one in problems:
        for kind, counts in one.kinds.items():
            sums[kind] = tuple(map(add, sums.get(kind, (0, 0, 0)), counts))
        sets.update(dict(one.sets))
        rivals.update(dict.fromkeys(one.rivals, 1))
    count, (places, seen, apart) = max(len(problems), 1), map(sum, zip((0, 0, 0), *sums.values(), strict=True))
    every = max(places, 1)
    wrong, named = (sum(each) / max(len(alarms), 1) for each in zip((0.0, 0.0), *alarms, strict=True))
    return SetDiscriminability(
        len(problems), pencil, places / count, seen / every, apart / every, sum(one.lost for one in problems) / every,
        {kind: (n / count, seen / n, apart / n) for kind, (n, seen, apart) in sums.items()},
        {pair: n / min(sums[kind][0] for kind in pair) for pair, n in sets.most_common()},
        {pair: n / count for pair, n in rivals.most_common()},
        len(alarms), (wrong, named),
    )  # fmt: skip


# --- an observer of one mistake ---------------------------------------------------------------

WELL = 0.95  # the part of the students who make a mistake that should be told of it
_TRIALS = 400


@frozen
class Observed:
    """The students who make a mistake, to an observer who knows this mistake alone.

    He knows what it gives and how a pencil scatters that, judges by the rules of marking, and chooses between this
    mistake, right work and other numbers: what he misses no judge finds who has more mistakes to choose from.
    One that moves a single value is missed by more than one in 20 where it moves it by less than 3 + 1.64 standard
    deviations. Values are normal, with the variances and correlations of the mistake's drawings; or as they are drawn,
    which near a dead point is not normal. Paper can tell the mistake where either way he finds it.

    beyond  part of the students who have a value beyond its tolerance, where values are normal
    found   part of them in whom he finds the mistake; drawn: the same, where values are as they are drawn
    """

    beyond: float
    found: float
    drawn: float

    @property
    def tellable(self) -> bool:
        return max(self.found, self.drawn) >= WELL


def observed(explainer: Explainer, k: int, drawn: np.ndarray, wrong: Callable[[np.ndarray], np.ndarray]) -> Observed:
    """Of explanation k; drawn: values of students who make this mistake (students, quantities).

    wrong  the values (students, quantities) that are beyond their tolerance, as booleans
    """
    count = int(explainer.there.sum())
    normal = explainer.drawn(k, np.random.default_rng(count).standard_normal((_TRIALS, count)))
    given = np.concatenate([normal, drawn])
    beyond = wrong(given)
    explained = np.concatenate([best.given for best in explainer.only(k).best(given, beyond)])
    parts = beyond[:_TRIALS].any(axis=1), explained[:_TRIALS], explained[_TRIALS:]
    return Observed(*(float(part.mean()) for part in parts))
