"""The mistake behind wrong values: every explanation weighed by all handed-in values together.

One mistake is tried before two. An explanation is given where every value is near to what it says, where it outweighs
right work and "none", and where so near a hit is no likely coincidence. All that the values cannot tell from it are
given with it, as one set. A mistake that shows in many problems of one student is a habit.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from copy import copy
from dataclasses import field
from functools import cached_property, lru_cache

import numpy as np

from graphkin.base.value import frozen
from graphkin.marking.key import Columns, Hypotheses, Key, Name, agrees, columns_of, differences
from graphkin.marking.weights import FITS, ONE, TWO, ScaledExplanations, SlipOutcomes, Weighed, shifts

MARGIN = 3.0  # explanations whose weights differ by less cannot be told apart: a factor of 20
_LIKELY = 0.5
_SURE = 0.9  # so probable is a mistake that does not explain all
_SAME = 0.5  # explanations whose values differ by less, in standard deviations, are one
_STAYS = 1.0  # a value that is moved by fewer standard deviations is left as it is
_CHANCE = 0.008  # a hit that random numbers make more often is no hint
_BESIDE_SLIP = 6.0  # a mistake and a slip whose weights differ by less are one set
_AT_ONCE = 1 << 16  # weights that are held at once


OtherMethods = Callable[[], Hypotheses]
"""Makes the outcomes of right work by other right methods; called where it is needed."""
SlipsOf = Callable[[np.ndarray, np.ndarray, np.ndarray], SlipOutcomes]
"""Gives the outcomes of slips in values (students, quantities of the key), of which some are wrong; for those of the
quantities that are handed in."""
PairsOf = Callable[[Name | None], Hypotheses]
"""Makes the outcomes of two mistakes: of a first one with each other, or of any two."""
SLIP = "slip"  # the id of a value that is off, with all after it as it follows
COMMON = (
    "coriolis-omitted", "coriolis-reversed", "relative-as-absolute", "arm-ignored", "normal-omitted", "image-mirrored",
    "image-wrong-point", "wrong-radius", "absolute-for-relative", "normal-outward", "omega-sense", "coriolis-half",
    "wrong-length", "sliding-across", "centre-ratio", "moves-as-centre", "driver-acceleration-dropped",
    "tangential-omitted", "driver-acceleration-reversed", "driver-reversed", "driver-reversed-one", SLIP,
    "velocity-along-link", "tangential-along", "driver-along-crank", "conversion",
)  # fmt: skip
"""Mistakes of students, the most frequent first."""
_PLAINER = {"coriolis-not-laid-off": "coriolis-omitted", "normal-not-laid-off": "normal-omitted"}
"""Of two that give the same numbers the one that a teacher names."""


def rarity(id: str) -> int:
    """The place of a mistake among all, the most frequent first."""
    return COMMON.index(id) if id in COMMON else len(COMMON)


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
        self, key: Key, table: Columns, there: np.ndarray, hypotheses: Hypotheses, met: float,
        other_methods: OtherMethods, slips: SlipsOf | None = None,
    ) -> None:  # fmt: skip
        """met: logarithm of how often one of the hypotheses is met; slips: beside them."""
        self.there, self._other_methods, self._hypotheses, self._slips = there, other_methods, hypotheses, slips
        self._scale = ScaledExplanations(key, table, there, hypotheses, met)
        rows = self._scale.rows
        self.texts = tuple(entry.text for entry, handed in zip(key.entries, there, strict=True) if handed)
        self._table = columns_of(table, there)
        self._values, self._scatters = (some[np.ix_(rows, there)] for some in (hypotheses.values, hypotheses.scatters))

    @cached_property
    def names(self) -> tuple[tuple[Name, ...], ...]:
        """Of the hypotheses that can be seen; then slips in each of the quantities, where these are looked for."""
        slips = () if self._slips is None else (((SLIP, "", (text,), ""),) for text in self.texts)
        return (*(self._hypotheses.names[row] for row in self._scale.rows), *slips)

    def only(self, k: int) -> Explainer:
        """An explainer that knows of explanation k alone."""
        one = copy(self)
        one._scale, one._slips = self._scale.only(k), None
        one._values, one._scatters = self._values[[k]], self._scatters[[k]]
        return one

    def drawn(self, k: int, errors: np.ndarray) -> np.ndarray:
        """Values handed in by those who make mistake k (students, quantities of the key); errors: standard normal."""
        given = np.full((len(errors), len(self.there)), np.nan)
        given[:, self.there] = self._scale.drawn(k, errors)
        return given

    def best(self, given: np.ndarray, wrong: np.ndarray) -> Iterator[Best]:
        """Of values of which some are wrong (students, quantities of the key), as many as are held at once."""
        step = max(_AT_ONCE // max(len(self._scale.rows), 1), 1)
        for k in range(0, len(given), step):
            yield self._best(given[k : k + step], wrong[k : k + step])

    def _best(self, given: np.ndarray, wrong: np.ndarray) -> Best:
        slips = None if self._slips is None else self._slips(given, wrong, self.there)
        given, wrong = given[:, self.there], wrong[:, self.there]
        weighed = self._scale.weigh(given)
        if slips is not None:
            weighed = weighed.beside(self._scale.weigh_slips(given, slips))
        outcomes = _Outcomes(self._values, self._scatters, slips)
        same = self._sets(weighed, outcomes, given, wrong)
        # logarithms of the sums of those in the set, and of all
        largest = weighed.weights.max(axis=1, initial=-np.inf)
        base = np.where(np.isfinite(largest), largest, 0.0)
        parts = np.exp(weighed.weights - base[:, None])
        with np.errstate(divide="ignore"):
            together, every = (base + np.log(s) for s in (np.einsum("sm,sm->s", parts, same), parts.sum(axis=1)))
        right = weighed.right
        if np.any(together > right + MARGIN):
            right = np.maximum(right, self._scale.right_by(given, self._other_methods()))
        others = np.maximum(right, weighed.none)
        rest = np.where(same, -np.inf, weighed.weights).max(axis=1, initial=-np.inf)
        with np.errstate(invalid="ignore"):
            total = np.logaddexp(every, np.logaddexp(right, weighed.none))
            margin, probability = together - np.maximum(others, rest), np.exp(together - total)
        same[(probability < _LIKELY) | (together < right + MARGIN)] = False
        follows = self._follows(outcomes, given, wrong, *np.nonzero(same))
        return Best(np.asarray(same.any(axis=1)), same, weighed.weights, weighed.none, probability, margin, follows)

    def _follows(
        self, outcomes: _Outcomes, given: np.ndarray, wrong: np.ndarray, who: np.ndarray, row: np.ndarray
    ) -> np.ndarray:
        """The wrong values that are as an explanation has them, of pairs of a student and an explanation (pairs, n)."""
        values, scatters = outcomes.of(who, row)
        reach = np.fmax(self._table.tolerance, FITS * scatters)
        follows = agrees(self._table, given[who], values, reach) & ~(shifts(self._table, values) < _STAYS)
        return np.asarray(wrong[who] & (follows | outcomes.slip_at(row)))

    def partly(self, given: np.ndarray, wrong: np.ndarray) -> Iterator[Explanation | None]:
        """For each student's values (students, quantities of the key) the mistake that explains two of the wrong ones
        or more, though not all of them."""
        step = max(_AT_ONCE // max(len(self._scale.rows) * int(self.there.sum()), 1), 1)
        for k in range(0, len(given), step):
            some, off = (each[k : k + step][:, self.there] for each in (given, wrong))
            weighed = self._scale.weigh_partly(some, off)
            fits = weighed.chance <= _CHANCE
            for weights, row_fits, explained, none in zip(
                weighed.weights, fits, weighed.explained, weighed.none, strict=True
            ):
                yield self._part(weights, row_fits, explained, float(none))

    def _part(self, weights: np.ndarray, fits: np.ndarray, explained: np.ndarray, none: float) -> Explanation | None:
        if not fits.any():
            return None
        best = int(np.where(fits, weights, -np.inf).argmax())
        likely = weights - self._scale.shares
        same = fits & (likely > likely[best] - MARGIN)
        together = float(np.logaddexp.reduce(weights[same]))
        others = max(none, float(weights[~same].max(initial=-np.inf)))
        probability = float(np.exp(together - np.logaddexp(np.logaddexp.reduce(weights), none)))
        if together < others + MARGIN or probability < _SURE:
            return None
        rows = [k for k in np.argsort(-weights, kind="stable") if same[k]]
        explains = tuple(self.texts[n] for n in np.flatnonzero(explained[best]))
        return Explanation(tuple(self.names[row] for row in rows), probability, together - others, explains)

    def _sets(self, weighed: Weighed, outcomes: _Outcomes, given: np.ndarray, wrong: np.ndarray) -> np.ndarray:
        """The best of those that fit, with all that cannot be told from it (students, m). What says nothing of
        the wrong values explains nothing."""
        fits = (weighed.worst <= FITS) & (weighed.chance <= _CHANCE)
        who, row = np.nonzero(fits)
        says = self._follows(outcomes, given, wrong, who, row).any(axis=1)
        fits[who[~says], row[~says]] = False
        who, row = who[says], row[says]
        if not who.size:
            return fits
        first = np.where(fits, weighed.weights, -np.inf).argmax(axis=1)[who]
        shares = np.append(self._scale.shares, np.zeros(fits.shape[1] - len(self._scale.shares)))
        likely = weighed.weights - shares
        alike = likely[who, row] > likely[who, first] - MARGIN
        # what scatters together is known roughly: values as likely one by one are not told apart by that
        alike |= weighed.apart[who, row] > weighed.apart[who, first] - MARGIN
        # so are those that say nearly the same as the best, and judge the same
        (one, scatters), (other, _) = outcomes.of(who, row), outcomes.of(who, first)
        with np.errstate(invalid="ignore"):
            close = np.abs(differences(self._table, one, other)) <= _SAME * scatters
        alike |= np.all(close | np.isnan(one) & np.isnan(other), axis=1)
        # a slip may be of any size: beside a mistake it stands by its weight alone
        mistakes = len(self._scale.rows)
        outweighed = np.abs(weighed.weights[who, row] - weighed.weights[who, first]) > _BESIDE_SLIP
        fits[who, row] = np.where((row < mistakes) & (first < mistakes), alike, (row == first) | ~outweighed)
        return fits


class _Outcomes:
    """The outcomes of hypotheses (m, n), which are the same for all students, and of slips after them."""

    def __init__(self, values: np.ndarray, scatters: np.ndarray, slips: SlipOutcomes | None) -> None:
        self._values, self._scatters, self._slips = values, scatters, slips

    def of(self, who: np.ndarray, row: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Values and scatters for pairs of a student and an explanation (pairs, n)."""
        if self._slips is None or not len(row):
            return self._values[row], self._scatters[row]
        slip = row >= len(self._values)
        values, scatters = np.empty((2, len(row), self._slips.values.shape[2]))
        values[~slip], scatters[~slip] = self._values[row[~slip]], self._scatters[row[~slip]]
        at = who[slip], row[slip] - len(self._values)
        values[slip], scatters[slip] = self._slips.values[at], self._slips.scatters[at]
        return values, scatters

    def slip_at(self, row: np.ndarray) -> np.ndarray:
        """The quantity in which each explanation has a slip, as booleans (pairs, n)."""
        if self._slips is None:
            return np.zeros((len(row), 1), dtype=bool)
        return np.asarray(np.arange(self._slips.values.shape[2]) == (row - len(self._values))[:, None])


_KEPT = 60  # so many explainers are kept
_PAIRS_FROM = 4  # so many independent values, before two mistakes are looked for


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
    """The mistakes behind wrong values; `evidence`: by a mistake's id, how it outweighs "none" here (a logarithm).

    Evidence of several problems of one student is added up (`habits`).
    """

    explanations: tuple[Explanation, ...] = ()
    evidence: Mapping[str, float] = field(default_factory=dict)

    @property
    def likeliest(self) -> tuple[Name, ...]:
        """The mistakes of the likeliest explanation; none where nothing is explained."""
        return self.explanations[0].names[0] if self.explanations else ()


class Diagnostician:
    """Diagnoses by a key those who have handed in the same quantities; what is made ready for these is kept.

    other_methods  makes the outcomes of right work by other methods, where needed; pairs, slips likewise
    """

    def __init__(self, key: Key, table: Columns, pairs: PairsOf, other_methods: OtherMethods, slips: SlipsOf) -> None:
        self._key, self._table, self._pairs = key, table, pairs
        self._other_methods, self._slips = other_methods, slips
        self._explainer = lru_cache(maxsize=_KEPT)(self._made)

    def diagnoses(self, given: np.ndarray, wrong: np.ndarray) -> list[Diagnosis]:
        """Of values, some of them wrong (students, quantities)."""
        there = np.isfinite(given).all(axis=0)
        if not len(given) or not there.any():
            return [Diagnosis() for _ in given]
        one = self._explainer(there.tobytes(), 1)
        first_ids = np.array([names[0][0] for names in one.names], dtype=object)
        ids = [id for id in dict.fromkeys(first_ids) if id != SLIP]
        by_one = []
        for best in one.best(given, wrong):
            # by how much the best of each mistake's forms outweighs "none", for each student
            evidence = [best.weights[:, first_ids == id].max(axis=1) - best.none for id in ids]
            rows = np.stack(evidence, axis=1).tolist() if ids else [[] for _ in best.none]
            for explanations, values in zip(_explanations(one, best), rows, strict=True):
                by_one.append(Diagnosis(explanations, dict(zip(ids, values, strict=True))))
        rest = np.array([k for k, diagnosis in enumerate(by_one) if not diagnosis.explanations], dtype=int)
        if rest.size and independent(self._key, there) >= _PAIRS_FROM:
            parts = one.partly(given[rest], wrong[rest])
            for k, explanations in zip(rest, self._by_two(there, given[rest], wrong[rest], list(parts)), strict=True):
                by_one[k] = Diagnosis(explanations, by_one[k].evidence)
        return by_one

    def _by_two(
        self, there: np.ndarray, given: np.ndarray, wrong: np.ndarray, parts: Sequence[Explanation | None]
    ) -> list[tuple[Explanation, ...]]:
        """One mistake that explains a part, with a second beside it where that explains the rest; or any two."""
        firsts = [None if part is None else part.names[0][0] for part in parts]
        found: list[tuple[Explanation, ...]] = [() if part is None else (part,) for part in parts]
        for first in dict.fromkeys(firsts):
            students = [k for k, name in enumerate(firsts) if name == first]
            two = self._explainer(there.tobytes(), 2, first)
            each = (some for best in two.best(given[students], wrong[students]) for some in _explanations(two, best))
            for k, explanations in zip(students, each, strict=True):
                found[k] = explanations or found[k]
        return found

    def _made(self, which: bytes, count: int, first: Name | None = None) -> Explainer:
        """By one mistake, or by two, of the quantities that are there."""
        hypotheses, met = (self._key.singles, ONE) if count == 1 else (self._pairs(first), TWO)
        there, slips = np.frombuffer(which, dtype=bool), self._slips if count == 1 else None
        return Explainer(self._key, self._table, there, hypotheses, met, self._other_methods, slips)


def independent(key: Key, there: np.ndarray) -> int:
    """The number of handed-in values that say something of their own."""
    if not there.any():
        return 0
    return int(np.sum(np.linalg.eigvalsh(key.together[np.ix_(there, there)]) > 1e-3))


def _explanations(explainer: Explainer, best: Best) -> Iterator[tuple[Explanation, ...]]:
    """Of each student: one, its most frequent mistakes first, or none."""
    sizes, names = best.same.sum(axis=1), explainer.names
    for k, (end, size) in enumerate(zip(np.cumsum(sizes), sizes, strict=True)):
        if not best.given[k]:
            yield ()
            continue
        rows = np.flatnonzero(best.same[k])
        rare = [max(rarity(name[0]) for name in names[row]) for row in rows]
        order = np.lexsort((-best.weights[k, rows], rare))
        explains = next(some for some in best.follows[end - size : end][order] if some.any())
        yield (Explanation(
            _plainest([names[row] for row in rows[order]]), float(best.probability[k]), float(best.margin[k]),
            tuple(explainer.texts[n] for n in np.flatnonzero(explains)),
        ),)  # fmt: skip


def _plainest(names: Sequence[tuple[Name, ...]]) -> tuple[tuple[Name, ...], ...]:
    """Without mistakes that are another of them at further places, too, or an arrow left out that was calculated."""
    alone = [each[0] for each in names if len(each) == 1]
    return tuple(each for each in names if len(each) > 1 or not any(_is_more(each[0], other) for other in alone))


def _is_more(one: Name, other: Name) -> bool:
    (id, way, of, form), (plain, *plain_way, place, plain_form) = one, other
    same = plain in (id, _PLAINER.get(id)) and [way, form] == [*plain_way, plain_form]
    return same and one != other and {*place} <= {*of}


_SHOWS = np.log((0.8, 0.2))  # frequencies with which a habit shows in a problem, and does not, as logarithms


@frozen
class Trace:
    """The marking of one problem, as evidence.

    named     ids of the mistakes that its numbers are consistent with; empty where nothing is wrong or nothing fits
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
    """By how much each mistake, as a habit, outweighs "none" in all problems together: log-likelihoods added. A habit
    shows in four problems of five, so that another mistake in one of them, or right work, speaks against it but does
    not rule it out."""
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
    problems: dict[str, set[int]] = {}
    for k, one in enumerate(traces):
        for id in one.named:
            problems.setdefault(id, set()).add(k)
    weights = {id: weight for id, weight in added(traces).items()
               if len(problems.get(id, ())) > 1 and weight > MARGIN}  # fmt: skip
    weightiest = []
    while weights:
        best = max(weights, key=lambda id: (weights[id], len(problems[id])))
        alike = [id for id in weights if problems[id] == problems[best] and weights[id] > weights[best] - MARGIN]
        weightiest.append(Habit(tuple(alike), len(problems[best]), len(traces), weights[best]))
        weights = {id: weight for id, weight in weights.items() if not problems[id] <= problems[best]}
    return tuple(weightiest)
