"""The construction that was drawn: the predicted one whose strokes have the ink, and no ink is left without a stroke.

Where ink runs elsewhere, one arrow, direction or figure of a construction is sought that is otherwise, then another: a
slip that is on no list is found like a mistake that is.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, replace
from itertools import compress

import numpy as np

from graphkin.base.value import bulky
from graphkin.marking.rewrite import Spot
from graphkin.photo.ink import NEAR, STRANGE, Ink
from graphkin.photo.predicted import PredictedStroke, Way

_SHORT = 0.15  # what is shorter is a point [mm]
_EACH = 1.0  # strokes are looked at every so many mm
MISSING = 1.5  # a stroke without ink counts so many times as much as ink without a stroke
SLIP = 8.0  # so much ink must be explained by each place that is otherwise [mm]
_FEW, _TRIED, _MOST, _SLIPS = 5, 3, 15, 3
"""Constructions that are kept; of these, those that are varied; those that are looked at closely; slips in one."""
_COMPLETE = 0.04  # a construction is complete when a smaller part of its strokes has no ink
_TURNS: np.ndarray = np.exp(1j * np.radians(np.arange(-89, 91, 1.0)))
_FINE = np.outer(np.linspace(0.98, 1.02, 9), np.exp(1j * np.radians(np.linspace(-1, 1, 9)))).ravel()
_TIMES = np.r_[-np.geomspace(3.0, 0.1, 60), 0.0, np.geomspace(0.1, 5.0, 200)]


@bulky
class Candidate:
    """A construction that may have been drawn.

    column   of the way; corners (letters,) [mm from the pole, y up]
    score    ink along it less strokes without ink, which are missing [mm]
    factors  of places that are drawn otherwise than the column has them
    """

    way: Way
    column: int
    corners: np.ndarray
    score: float
    missing: float
    factors: Mapping[Spot, complex] = field(default_factory=dict)


def drawn_strokes(way: Way, corners: np.ndarray) -> list[PredictedStroke]:
    """The strokes of a way that are any length."""
    return [stroke for stroke in way.strokes if abs(corners[stroke.head] - corners[stroke.tail]) > _SHORT]


def candidates(ink: Ink, ways: Sequence[Way]) -> list[Candidate]:
    """The likeliest constructions, the best first."""
    found = [one for way in ways for one in _scored(ink, way, way.corners)]
    tried, right = _best(ink, found)[:_TRIED], _scored(ink, ways[0], ways[0].corners[:1])
    if all(one.column or one.way is not ways[0] for one in tried):
        tried += right  # what fits worse as it stands may be nearer
    for one in tried:
        if not _is_complete(ink, one):  # some hand may have drawn what another one did not
            hands = _scored(ink, one.way, one.way.hands(one.column, {}))
            own = max(hands, key=lambda each: each.score, default=one)
            if own.score > one.score:
                one = replace(own, column=one.column)
                found.append(one)
        while not _is_complete(ink, one) and len(one.factors) < _SLIPS:
            other = max(_slipped(ink, one), key=lambda each: each.score, default=one)
            if other.score <= one.score:
                break
            one = other
            found.append(one)
    return _best(ink, found)


def _is_complete(ink: Ink, one: Candidate) -> bool:
    """True where all needed strokes have ink, and no long ink is left."""
    ends = {s: (one.corners[s.tail], one.corners[s.head]) for s in drawn_strokes(one.way, one.corners)}
    needed = sum(abs(head - tail) for stroke, (tail, head) in ends.items() if stroke.needed)
    return one.missing <= _COMPLETE * needed and ink.strange(ends.values()) < STRANGE


def _best(ink: Ink, some: Sequence[Candidate]) -> list[Candidate]:
    """The best few, each of them once."""
    kept: list[Candidate] = []
    for one in sorted(some, key=lambda each: (-round(each.score, 1), len(each.factors), each.column)):
        same = [other for other in kept if one.way is other.way]
        if not any(np.allclose(one.corners, other.corners, atol=NEAR / 3, equal_nan=True) for other in same):
            kept.append(one)
        if len(kept) == _FEW:
            break
    return kept


def _slipped(ink: Ink, one: Candidate) -> Iterator[Candidate]:
    """With one place more drawn otherwise, the best of each; the best of all in finer steps."""
    each = [(best, spot) for spot, arrow in one.way.spots.items() if spot not in one.factors
            and (best := _varied(ink, one, spot, _tries(ink, one, arrow))) is not None]  # fmt: skip
    for rough, spot in sorted(each, key=lambda pair: -pair[0].score)[:2]:
        finer = _FINE if spot[0] != "line" else _FINE / np.abs(_FINE)
        yield rough
        yield from filter(None, [_varied(ink, one, spot, finer * rough.factors[spot])])


def _tries(ink: Ink, one: Candidate, arrow: tuple[str, str] | None) -> np.ndarray:
    """Factors: directions of a line; an arrow along itself, or to wherever a stroke is."""
    if arrow is None:
        return _TURNS
    start, tip = (one.corners[one.way.letters.index(name)] for name in arrow)
    if abs(tip - start) <= _SHORT:
        return np.empty(0)
    return np.asarray(np.r_[_TIMES, (ink.places() - start) / (tip - start)])


def _varied(ink: Ink, one: Candidate, spot: Spot, tries: np.ndarray) -> Candidate | None:
    """The best of a candidate with one place by these factors."""
    if not tries.size:
        return None
    factors = {key: np.full(len(tries), value) for key, value in one.factors.items()} | {spot: tries}
    scored = _scored(ink, one.way, one.way.altered(one.column, factors))
    if not scored:
        return None
    best = max(scored, key=lambda each: each.score)
    own = {**one.factors, spot: complex(tries[best.column])}
    return replace(best, score=best.score - SLIP * len(own), factors=own, column=one.column)


def _scored(ink: Ink, way: Way, corners: np.ndarray) -> list[Candidate]:
    """Corners (n, letters) as candidates, without those that are hopeless or nowhere."""
    rows = np.flatnonzero(np.isfinite(corners).all(axis=1) & (np.abs(corners) < 1e4).all(axis=1))
    if not rows.size:
        return []
    lengths, inked, bare = _along(ink, way, corners[rows])
    needed = np.array([stroke.needed for stroke in way.strokes])
    drawn = needed | (inked > 0.95)
    misses = (bare * lengths)[:, needed].sum(axis=1)
    hits = np.where(drawn, inked * lengths, 0.0).sum(axis=1)
    found = []
    for k in np.argsort(MISSING * misses - hits, kind="stable")[:_MOST]:
        at, miss = corners[rows[k]], float(misses[k])
        some = compress(way.strokes, drawn[k] & (lengths[k] > _SHORT))
        explained = ink.along([(at[stroke.tail], at[stroke.head]) for stroke in some], NEAR)
        found.append(Candidate(way, int(rows[k]), at, explained - MISSING * miss, miss))
    return found


def _along(ink: Ink, way: Way, corners: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Of each stroke of each row (rows, strokes) its length, the part that has ink, and that which has none and is not
    hidden by a printed line."""
    tails, heads = (corners[:, [getattr(s, end) for s in way.strokes]] for end in ("tail", "head"))
    lengths, inked, bare = np.abs(heads - tails), np.zeros(tails.shape), np.zeros(tails.shape)
    for k, longest in enumerate(lengths.max(axis=0)):
        count = max(2, min(120, round(longest / _EACH)))
        places = tails[:, k, None] + (np.arange(count) + 0.5) / count * (heads - tails)[:, k, None]
        near = ink.is_near(places)
        inked[:, k] = near.mean(axis=1)
        bare[:, k] = ((near == 0) & ~ink.is_printed(places)).mean(axis=1)
    return lengths, inked, bare
