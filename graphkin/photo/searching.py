"""The construction that was drawn: the predicted one whose strokes have the ink, and no ink is left without a stroke.

Where ink runs elsewhere, one arrow, direction or figure of a construction is sought that is otherwise, then another: a
slip that is on no list is found like a mistake that is.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, replace

import numpy as np

from graphkin.base.geometry import unit
from graphkin.base.value import bulky
from graphkin.marking.rewrite import Spot
from graphkin.photo.ink import NEAR, STRANGE, Ink
from graphkin.photo.predicted import Predicted, Stroke, Way

_SHORT = 0.15  # what is shorter is a point [mm]
_EACH = 0.5  # strokes are looked at every so many mm
MISSING = 1.5  # a stroke without ink counts so many times as much as ink without a stroke
SLIP = 8.0  # so much ink must be explained by each place that is otherwise [mm]
_FEW, _MOST, _SLIPS = 5, 40, 3
"""Constructions that are kept; those that are looked at closely; slips in one."""
_COMPLETE = 0.04  # a construction is complete when a smaller part of its strokes has no ink
_TURNS = np.exp(1j * np.radians(np.arange(-89, 91, 1.0)))
_ONCE = np.ones(1)
_FINE = np.outer(np.linspace(0.98, 1.02, 9), np.exp(1j * np.radians(np.linspace(-1, 1, 9)))).ravel()
_TIMES = np.r_[-np.geomspace(3.0, 0.1, 60), 0.0, np.geomspace(0.1, 5.0, 200)]


@bulky
class Candidate:
    """A construction that may have been drawn.

    column   of the way; corners (letters,) [mm from the pole, y up]
    score    ink along it less strokes without ink [mm]; missing, explained: both
    factors  of places that are drawn otherwise than the column has them
    """

    way: Way
    column: int
    corners: np.ndarray
    score: float
    missing: float
    explained: float
    factors: Mapping[Spot, complex] = field(default_factory=dict)

    @property
    def strokes(self) -> list[Stroke]:
        return drawn_strokes(self.way, self.corners)


def drawn_strokes(way: Way, corners: np.ndarray) -> list[Stroke]:
    """The strokes of a way that are any length."""
    return [stroke for stroke in way.strokes if abs(corners[stroke.head] - corners[stroke.tail]) > _SHORT]


def candidates(ink: Ink, predicted: Predicted) -> list[Candidate]:
    """The likeliest constructions, the best first."""
    every = [one for way in predicted.ways for one in _scored(ink, way, way.corners)]
    right = _scored(ink, predicted.ways[0], predicted.ways[0].corners[:1])
    best, found = _best(ink, every), [*every]
    best += [one for one in right if all(one.column != other.column for other in best)]
    for one in best:
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
    best = _best(ink, found)
    known = {other.column for other in best if other.way is predicted.ways[0] and not other.factors}
    return best + [one for one in right if one.column not in known]


def _is_complete(ink: Ink, one: Candidate) -> bool:
    """True where all needed strokes have ink, and no long ink is left."""
    ends = {s: (one.corners[s.tail], one.corners[s.head]) for s in one.strokes}
    needed = sum(abs(head - tail) for stroke, (tail, head) in ends.items() if stroke.needed)
    longer = [(tail - 400 * unit(head - tail), head + 400 * unit(head - tail)) for tail, head in ends.values()]
    return one.missing <= _COMPLETE * needed and ink.strange(longer) < STRANGE


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
    """With one place more drawn otherwise, the best of each."""
    for spot in one.way.spots:
        if spot in one.factors:
            continue
        if spot[0] == "line":
            tries = _TURNS
        else:  # along the arrow, or to wherever a stroke is
            start, tip = (one.corners[one.way.letters.index(name)] for name in one.way.arrow(spot))
            if abs(tip - start) < _SHORT:
                continue
            tries = np.r_[_TIMES, (ink.places() - start) / (tip - start)]
        for finer in (_ONCE, _FINE if spot[0] != "line" else _FINE / np.abs(_FINE)):
            tries = np.outer(finer, tries).ravel()
            factors = {key: np.full(len(tries), value) for key, value in one.factors.items()} | {spot: tries}
            scored = _scored(ink, one.way, one.way.altered(one.column, factors))
            best = max(scored, key=lambda each: each.score, default=None)
            if best is None:
                break
            own = {**one.factors, spot: complex(tries[best.column])}
            yield replace(best, score=best.score - SLIP * len(own), factors=own, column=one.column)
            tries = tries[best.column : best.column + 1]


def _scored(ink: Ink, way: Way, corners: np.ndarray) -> list[Candidate]:
    """Corners (n, letters) as candidates, without those that are hopeless or nowhere."""
    whole = np.flatnonzero(np.isfinite(corners).all(axis=1) & (np.abs(corners) < 1e4).all(axis=1))
    if not whole.size:
        return []
    hits, misses = _along(ink, way, corners[whole])
    order = np.argsort(-(hits - MISSING * misses), kind="stable")[:_MOST]
    found = []
    for k in order:
        at = corners[whole[k]]
        lines = [(at[s.tail], at[s.head]) for s in drawn_strokes(way, at) if s.needed or _has_ink(ink, at, s)]
        explained = ink.along(lines, NEAR)
        miss = float(misses[k])
        found.append(Candidate(way, int(whole[k]), at, explained - MISSING * miss, miss, explained))
    return found


def _has_ink(ink: Ink, at: np.ndarray, stroke: Stroke) -> bool:
    share = np.linspace(0, 1, 60)
    return bool(ink.is_near(at[stroke.tail] + share * (at[stroke.head] - at[stroke.tail])).mean() > 0.95)


def _along(ink: Ink, way: Way, corners: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Millimetres of the strokes of each row that have ink, and of the needed ones that have none."""
    hits, misses = np.zeros(len(corners)), np.zeros(len(corners))
    for stroke in way.strokes:
        tail, arrow = corners[:, stroke.tail], corners[:, stroke.head] - corners[:, stroke.tail]
        longest = float(np.abs(arrow).max(initial=0.0))
        share = (np.arange(max(2, min(120, round(longest / _EACH)))) + 0.5) / max(2, min(120, round(longest / _EACH)))
        places = tail[:, None] + share * arrow[:, None]
        part, length = ink.is_near(places).mean(axis=1), np.abs(arrow)
        if stroke.needed:
            hits += part * length
            misses += (~ink.is_near(places) & ~ink.is_printed(places)).mean(axis=1) * length
        else:
            hits += np.where(part > 0.95, length, 0.0)
    return hits, misses
