"""A construction laid over the ink: all its corners at once, by the lines that are seen and by how a hand draws.

Unknown are the corners. Each line says how far those at its ends lie beside it, an end of ink how far along; and hands
that draw the same construction again and again say, weakly, how corners lie to each other. What is known of each comes
out with it: a short line, or a flat crossing, is measured where its neighbours hold it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from graphkin.base.geometry import unit
from graphkin.base.value import frozen
from graphkin.photo.ink import STEP, Ink
from graphkin.photo.lines import WIDER, SeenLine, free_end, line_near
from graphkin.photo.predicted import PredictedStroke
from graphkin.photo.searching import Candidate, drawn_strokes

_REACHES = (2.0, 1.2, 0.8)  # a line is sought so far from where it is expected, closer each time [mm]
_TELLS = 20.0  # lines that are longer tell how the hand wobbles [mm]
ONE = 0.15  # corners so near each other are one [mm]
_BESIDE = 0.9  # strokes that are no farther from each other are seen as one [mm]
_ASTRAY = 0.1  # a line that need not be drawn is another one so much farther off than half of where it is sought [mm]
_ASIDE, _SHORT = 0.35, 4.0  # a line that is not short passes no farther beside its corners [mm]
_DISTRUST = 3.0  # so many times less than it lays corners the hand counts where it is told how well they are known
_AROUND = 0.4  # a line has no ink farther from its edges, all in all, beside the hand's wobble [mm]
_LEFT, _CLOSE = 5.0, 1.2  # longer ink, and no farther off, may be a line [mm]
_DRAWN, COVERED = 0.5, 0.75  # a line has ink over so much of its length; one that is surely there, over so much
_THROUGH = 0.03  # a line goes so near by the corners at its ends, beside the hand's wobble [mm]
_END = 0.15, 0.4  # where a line ends is known so well; the same where others do, too [mm]
_AHEAD = np.cos(np.radians(35))  # strokes that leave under a smaller angle hide where a line ends
_ODD = 3.0  # what is farther off, in standard deviations, counts for less


@frozen
class _Row:
    """An observation: the real part of a sum of corners by number, each times a complex number, is `value`, +- off."""

    times: Mapping[int, complex]
    value: float
    off: float


class FittedCandidate:
    """A candidate with its lines refined.

    lines    by stroke; at: corners by number; off: how well each is known [mm]
    hand     the covariance of corners as hands draw them
    wobble   of this hand [mm]
    ends     corners at which a single line ends
    spread   how corners may be off together: the covariance of all x, then all y [mm^2]
    odd      corners by number that lie beside their lines; strain: by how many standard deviations, all in all, beyond
             what is usual; departs: by how many all of it is less likely than what hands draw usually is
    """

    def __init__(self, ink: Ink, candidate: Candidate) -> None:
        self.ink, self.candidate, self.way = ink, candidate, candidate.way
        self.pole = self.way.pole
        self.at = candidate.corners.copy()
        self.lines: dict[PredictedStroke, SeenLine] = {}
        self.ends, self.odd = set[int](), set[int]()
        self.hand = self.way.spread(candidate.column, candidate.factors)
        for reach in _REACHES:
            self.wobble = self._refine(reach)
            self.off, self.spread = self._solve(2.5 * reach + 1)

    def _refine(self, reach: float) -> float:
        """Lines where strokes are expected; by how much the hand wobbles [mm]."""
        long = [line.spread for line in self.lines.values() if line.length > _TELLS]
        spread = float(np.quantile(long, 0.3)) if long else np.inf
        self.lines = {}
        for stroke in self._apart(drawn_strokes(self.way, self.at)):
            ends = self.at[[stroke.tail, stroke.head]]
            line = line_near(self.ink, ends, reach, spread, stroke.goes_on)
            if line.covered < COVERED and self.ink.is_printed(ends).all():
                line = SeenLine.printed(ends, self.ink.printed)
            astray = max(abs(line.beside(end)) for end in ends) > reach / 2 + _ASTRAY
            if stroke.needed or (line.covered > 0.95 and not astray):
                self.lines[stroke] = line
        long = [line.scatter for line in self.lines.values() if line.length > _TELLS]
        wobble = float(np.median(long)) if long else 0.0
        self.lines = {stroke: line.drawn_by(wobble, self._beside_others(stroke)) for stroke, line in self.lines.items()}
        if reach == _REACHES[-1]:
            self._doubt(spread, wobble)
        return wobble

    def drawn(self, spread: float = np.inf) -> list[tuple[complex, complex]]:
        """Two places on each line that is seen, and is no wider than this is [mm]."""
        lines = [line for line in self.lines.values() if line.covered > _DRAWN and line.spread <= WIDER * spread]
        return [(line.middle, line.middle + line.along) for line in lines]

    def _doubt(self, spread: float, wobble: float) -> None:
        """Ink beside a line that no line explains, but some one among several, may be this line."""
        sizes, places = self.ink.left(self.drawn(spread), self.ink.pencil + _AROUND + 4 * wobble)
        places = places[sizes > _LEFT]
        for stroke, line in self.lines.items():
            own = (places - line.middle) * np.conj(line.along)
            aside = np.abs(own.imag[(np.abs(own.real) < line.length / 2) & (np.abs(own.imag) < _CLOSE)])
            if aside.size * STEP**2 / self.ink.pencil > _LEFT / 2:
                self.lines[stroke] = line.known(float(np.hypot(line.off, np.median(aside))))

    def _beside_others(self, stroke: PredictedStroke) -> float:
        """The part of a stroke along which another one runs, so that the ink of both is one."""
        tail, head = self.at[[stroke.tail, stroke.head]]
        places, most = tail + np.linspace(0.1, 0.9, 17) * (head - tail), 0.0
        for other in self.lines:
            if other is not stroke:
                start, end = self.at[[other.tail, other.head]]
                own = (places - start) / (end - start)
                there = (np.abs(own.imag) * abs(end - start) < _BESIDE) & (own.real > 0) & (own.real < 1)
                most = max(most, float(there.mean()))
        return most

    def _apart(self, strokes: Sequence[PredictedStroke]) -> list[PredictedStroke]:
        """Without those that lie on another one, needed ones first."""
        found: list[PredictedStroke] = []
        for one in sorted(strokes, key=lambda each: not each.needed):
            ends = self.at[[one.tail, one.head]]
            others = (self.at[[other.tail, other.head]] for other in found)
            if all(min(np.abs(ends - there).max(), np.abs(ends - there[::-1]).max()) > ONE for there in others):
                found.append(one)
        return found

    def _solve(self, far_off: float) -> tuple[np.ndarray, np.ndarray]:
        """The corners that fit best; their standard deviations, and covariance. One that would move farther [mm] is not
        known."""
        drawn = {stroke: line for stroke, line in self.lines.items() if line.covered > _DRAWN}
        seen = [row for stroke, line in drawn.items() for row in self._beside(stroke, line)]
        rows, free = [*seen, *self._ending()], [k for k in range(len(self.at)) if k != self.pole]
        both, corners = np.r_[free, np.array(free) + len(self.at)], self.candidate.corners[free]
        prior = np.linalg.inv(self.hand[np.ix_(both, both)])
        times = np.array([[row.times.get(k, 0j) / row.off for k in free] for row in rows]).reshape(-1, len(free))
        told, values = np.hstack([times.real, -times.imag]), np.array([row.value / row.off for row in rows])
        found, far, weight = _weighed(told, values, prior, expected := np.r_[corners.real, corners.imag])
        there, off = self.at.copy(), np.zeros(len(self.at))
        there[free] = found[: len(free)] + 1j * found[len(free) :]
        cover = np.linalg.inv((told.T * weight) @ told + prior / _DISTRUST**2)
        alone = _worst(cover)
        off[free] = alone * _torn(times, far)  # a hand may have drawn what no construction has
        off[np.abs(there - self.at) > far_off] = np.inf
        self.at = np.where(np.isfinite(off), there, self.at)
        for k in free:  # those on one place are known alike
            off[k] = off[np.abs(self.at - self.at[k]) < ONE].max()
        far, gap, count = far[: len(seen)], found - expected, max(1, len(seen))  # where one ends may be misread
        self.strain = float(np.clip(far - _ODD, 0.0, 10.0).sum())
        self.departs = float((weight[: len(seen)] @ far**2 + gap @ prior @ gap - count) / np.sqrt(2 * count))
        self.odd = {k for row, size in zip(seen, far, strict=True) if size > 1.5 * _ODD for k in row.times}
        ends = ((k, line) for stroke, line in drawn.items() for k in (stroke.tail, stroke.head) if line.length > _SHORT)
        self.odd = (self.odd | {k for k, line in ends if abs(line.beside(self.at[k])) > _ASIDE}) - {self.pole}
        more = np.tile(np.where(np.isfinite(off[free]), off[free] / alone, 1.0), 2)
        spread = np.zeros((2 * len(off),) * 2)
        spread[np.ix_(both, both)] = cover * np.outer(more, more)
        return off, spread

    def _beside(self, stroke: PredictedStroke, line: SeenLine) -> Iterator[_Row]:
        """Both ends of a line lie on it, as well as it is known: off alike, and by its turn times their distance."""
        numbers = (stroke.tail, stroke.head)
        s = np.array([line.beyond(self.at[k]) for k in numbers])
        through = np.hypot(_THROUGH, self.wobble)
        cover = line.off**2 + line.turned**2 * np.outer(s, s) + np.eye(2) * through**2
        across = -1j * line.along.conjugate()
        value = (across * line.middle).real
        for whiten in np.linalg.cholesky(np.linalg.inv(cover)).T:
            yield _Row({k: across * w for k, w in zip(numbers, whiten, strict=True)}, float(whiten.sum() * value), 1.0)

    def _ending(self) -> Iterator[_Row]:
        """The places where arrows end beyond which no other stroke goes on, one that lies on another neither."""
        self.ends = set()
        away: dict[int, list[complex]] = {}  # by corner, the directions of strokes that leave its place
        for stroke in (s for s in drawn_strokes(self.way, self.at) if s.needed or s in self.lines):
            along = complex(unit(self.at[stroke.head] - self.at[stroke.tail]))
            for there, way in ((stroke.tail, along), (stroke.head, -along)):
                for k in map(int, np.flatnonzero(np.abs(self.at - self.at[there]) < ONE)):
                    away.setdefault(k, []).extend([way, -way] if stroke.goes_on else [way])
        for stroke, line in self.lines.items():
            if stroke.goes_on or line.covered <= _DRAWN:
                continue
            for k, other in ((stroke.head, stroke.tail), (stroke.tail, stroke.head)):
                out = unit(self.at[k] - self.at[other])
                if k == self.pole or max((way * out.conjugate()).real for way in away[k]) > _AHEAD:
                    continue
                end = free_end(self.ink, line, complex(self.at[k]), complex(self.at[other]))
                if end is not None:
                    alone = len(away[k]) == 1
                    self.ends |= {k} if alone else set()
                    yield _Row({k: line.along.conjugate()}, (line.along.conjugate() * end).real, _END[not alone])


def _weighed(
    told: np.ndarray, values: np.ndarray, prior: np.ndarray, expected: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The unknowns that fit observations `told @ found = values` and what is expected best; by how many standard
    deviations each observation is off, and what it counts for: less where it is far off."""
    weight = np.ones(len(values))
    for _ in range(4):
        pull = told.T * weight
        found = np.linalg.solve(pull @ told + prior, pull @ values + prior @ expected)
        far = np.abs(told @ found - values)
        weight = np.minimum(1.0, _ODD / np.maximum(far, 1e-9))
    return found, far, weight


def _worst(cover: np.ndarray) -> np.ndarray:
    """Standard deviations of corners in the direction in which each is known worst, by the covariance of all x, then
    all y."""
    half = len(cover) // 2
    return np.sqrt([np.linalg.eigvalsh(cover[np.ix_([n, half + n], [n, half + n])])[1] for n in range(half)])


def _torn(times: np.ndarray, far: np.ndarray) -> np.ndarray:
    """So many times worse corners are known where observations contradict each other; times: what each has to do with
    each corner (rows, corners), far: by how much it is off (rows,)."""
    share = np.abs(times) ** 2 / np.maximum((np.abs(times) ** 2).sum(axis=1, keepdims=True), 1e-12)
    torn = (share.T @ far**2) / np.maximum(share.sum(axis=0), 1.0)
    return np.asarray(np.sqrt(np.maximum(1.0, torn)))
