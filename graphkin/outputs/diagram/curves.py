"""What a motion diagram shows, as numbers: finely sampled curves, and their greatest and least values.

Nothing here draws. Times of the way (`t`) are as in `graphkin.studies.sweeps`: driver values are `course.value(t)`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property

import numpy as np

from graphkin.base.geometry import number
from graphkin.base.value import frozen
from graphkin.running.path import Event
from graphkin.studies import sweeps
from graphkin.studies.sweeps import Course, Road, Series

TURN = 2 * np.pi
POSITIONS = 721
NEAR = 10.0 ** np.linspace(-8, -2.6, 55)
"""How near to a stop it is looked at, as parts of the range: velocities grow without bound there."""
BEND = 0.06
"""Where a curve turns by more than this between two positions, as drawn, more are put in [rad]."""
MOST = 8000
ROUNDS, PLACES = 7, 33
"""Rounds in which a greatest value is closed in on, and positions looked at in each."""
ZERO = 1e-9
"""Differences smaller than this part of the size of like quantities are rounding."""
CLEAR = 0.05
"""How far from a stop, as a part of the range, values count for the scale where they grow without bound."""


@frozen
class Peak:
    """The greatest (`sign` 1) or least (-1) value of a curve: `value` at `t`."""

    t: float
    value: float
    sign: int


@frozen
class Curves:
    """Quantities over the shown part of a course.

    low, high   the shown part of the way
    t           positions (n,), closer where curves bend and near stops
    series      the quantities there, in SI
    """

    course: Course
    by: Road
    low: float
    high: float
    t: np.ndarray
    series: tuple[Series, ...]

    @property
    def events(self) -> tuple[Event, ...]:
        """Stops and change points that are shown, in their order."""
        margin = 1e-6 * (self.high - self.low)
        found = (event for event in (*self.course.path.stops, *self.course.path.changes))
        return tuple(sorted((e for e in found if self.low - margin <= e.at <= self.high + margin), key=lambda e: e.at))

    @cached_property
    def alike(self) -> tuple[tuple[int, ...], ...]:
        """Numbers of curves that lie on one another, together: links 2 and 3 that slide on each other turn alike."""
        groups: list[list[int]] = []
        for k in range(len(self.series)):
            group = next((group for group in groups if self._same(group[0], k)), None)
            if group is None:
                groups.append([k])
            else:
                group.append(k)
        return tuple(map(tuple, groups))

    def _same(self, one: int, other: int) -> bool:
        first, second = self.series[one], self.series[other]
        if first.unit != second.unit:
            return False
        clear = np.abs(first.signed) <= 10 * self._like(one)
        close = np.isclose(first.signed, second.signed, rtol=0, atol=ZERO * self._like(one), equal_nan=True)
        return bool(close[clear].all() and clear.any())

    def unbounded(self, k: int) -> tuple[bool, bool]:
        """Whether a curve grows without bound towards the low and the high end of what is shown."""
        return self._growing(k, self.low), self._growing(k, self.high)

    def _growing(self, k: int, end: float) -> bool:
        part = np.abs(self.t - end) / (self.high - self.low)
        sizes = np.abs(self.series[k].signed)
        known = np.isfinite(sizes) & (part < 1e-3)
        stops = [stop.at for stop in self.course.path.stops]
        if not known.any() or not any(abs(end - at) <= 1e-6 * (self.high - self.low) for at in stops):
            return False
        nearest, farther = part[known] < 1e-6, part[known] > 1e-4
        return bool(nearest.any() and farther.any()) and bool(
            sizes[known][nearest].max() > 2 * sizes[known][farther].max()
        )

    def bounds(self, k: int) -> tuple[float, float]:
        """The least and greatest value to be shown; where a curve grows without bound, some of the growth."""
        values, clear = self.series[k].signed, np.isfinite(self.series[k].signed)
        wild = np.zeros(clear.shape, dtype=bool)
        for end, grows in zip((self.low, self.high), self.unbounded(k), strict=True):
            if grows:
                wild |= np.abs(self.t - end) < CLEAR * (self.high - self.low)
        if not (clear & ~wild).any():
            return 0.0, 0.0
        low, high = float(values[clear & ~wild].min()), float(values[clear & ~wild].max())
        more = 0.4 * (high - low)
        return max(low - more, float(values[clear].min())), min(high + more, float(values[clear].max()))

    @cached_property
    def peaks(self) -> tuple[tuple[Peak, ...], ...]:
        """By curve: where it is greatest and least. None of a constant, nor where a curve only runs off its end."""
        brackets = [found for k in range(len(self.series)) for found in self._brackets(k)]
        if not brackets:
            return tuple(() for _ in self.series)
        polished = self._polished(brackets)
        return tuple(
            tuple(peak for peak, (owner, *_) in zip(polished, brackets, strict=True) if owner == k)
            for k in range(len(self.series))
        )

    def _brackets(self, k: int) -> Iterator[tuple[int, int, float, float]]:
        """(curve, sign, from, to) around its greatest and its least sampled value."""
        values = self.series[k].signed
        there = np.flatnonzero(np.isfinite(values))
        low, high = self.bounds(k)
        if not there.size or high - low <= ZERO * self._like(k):
            return
        for sign in (1, -1):
            at = self._highest(k, sign * values[there], there, ZERO * (high - low))
            if at is not None:
                before, after = there[max(at - 1, 0)], there[min(at + 1, there.size - 1)]
                yield k, sign, float(self.t[before]), float(self.t[after])

    def _highest(self, k: int, heights: np.ndarray, there: np.ndarray, rounding: float) -> int | None:
        """The first of the highest places; where a curve rises without bound, the highest of its summits, if any."""
        at = int(np.flatnonzero(heights >= heights.max() - rounding)[0])
        if self._is_peak(k, at, there):
            return at
        if not any(self.unbounded(k)):
            return None
        rise = np.diff(heights)
        summits = 1 + np.flatnonzero((rise[:-1] > 0) & (rise[1:] <= 0))
        if not summits.size:
            return None
        best = heights[summits].max()
        return int(summits[heights[summits] >= best - rounding][0])

    def _like(self, k: int) -> float:
        """The greatest size among quantities of one unit."""
        unit = self.series[k].unit
        same = [j for j, entry in enumerate(self.series) if entry.unit == unit]
        return max((abs(end) for j in same for end in self.bounds(j)), default=0.0)

    def _is_peak(self, k: int, at: int, there: np.ndarray) -> bool:
        """An end of what is shown counts where the curve stops there, not where it goes on round or without bound."""
        if 0 < at < there.size - 1:
            t = self.t[there[at]]
            ends = [end for end, grows in zip((self.low, self.high), self.unbounded(k), strict=True) if grows]
            return all(abs(t - end) > 1e-3 * (self.high - self.low) for end in ends)
        values = self.series[k].signed[there]
        if self.course.full_turn and self.high - self.low > TURN - 1e-9:
            return bool(abs(values[0] - values[-1]) < 1e-6 * np.ptp(values))
        return not self.unbounded(k)[0 if at == 0 else 1]

    def _polished(self, brackets: Sequence[tuple[int, int, float, float]]) -> list[Peak]:
        """All of them closed in on together: each round looks at some positions in every bracket."""
        names = [entry.name for entry in self.series]
        low, high = (np.array([bracket[k] for bracket in brackets]) for k in (2, 3))
        owner, sign = (np.array([bracket[k] for bracket in brackets]) for k in (0, 1))
        rows = np.arange(len(brackets))
        for _ in range(ROUNDS):
            t = np.linspace(low, high, PLACES, axis=1)
            found = sweeps.quantities_at(self.course, names, t.ravel(), self.by).series
            values = np.array([found[k].signed.reshape(t.shape)[row] for row, k in enumerate(owner)])
            heights = np.where(np.isfinite(values), sign[:, None] * values, -np.inf)
            best = heights.argmax(axis=1)
            low, high = t[rows, np.maximum(best - 1, 0)], t[rows, np.minimum(best + 1, PLACES - 1)]
        peaks = [self._rounded(k, float(values[row, best[row]])) for row, k in enumerate(owner)]
        return [Peak(float(t[row, best[row]]), value, int(sign[row])) for row, value in enumerate(peaks)]

    def _rounded(self, k: int, value: float) -> float:
        """0 for what is only rounding."""
        return 0.0 if abs(value) <= ZERO * self._like(k) else value


def curves(course: Course, names: Sequence[str], by: Road = "construction") -> Curves:
    """Quantities over the shown part of a course, finely sampled whatever the steps of its table are."""
    low, high = span(course)
    names = sweeps.drawable(course.method.mechanism, names)
    t = _first_positions(course, low, high)
    for _ in range(4):
        series = sweeps.quantities_at(course, names, t, by).series
        more = _where_bent(Curves(course, by, low, high, t, series))
        if not more.size or t.size + more.size > max(MOST, 2 * t.size):
            break
        t = np.union1d(t, more)
    return Curves(course, by, low, high, t, sweeps.quantities_at(course, names, t, by).series)


def span(course: Course) -> tuple[float, float]:
    """The shown part of the way: what is asked for; to a full turn, or to the way's end, if only a step is missing."""
    path, asked = course.path, np.unique(course.t)
    low, high = float(asked[0]), float(asked[-1])
    step = 1.01 * float(np.diff(asked).max()) if asked.size > 1 else np.inf
    if course.full_turn and asked.size == 1:
        low = high = min(number(course.at(TURN * np.floor(number(course.value(low)) / TURN))), path.high - TURN)
    if course.full_turn and TURN - step <= high - low < TURN:
        low, high = (low, low + TURN) if low + TURN <= path.high + 1e-9 else (high - TURN, high)
    if not course.full_turn:
        low = path.first if low - path.first <= step else low
        high = path.last if path.last - high <= step else high
    return low, high


def _first_positions(course: Course, low: float, high: float) -> np.ndarray:
    """Evenly, and ever closer to where the way stops; never on a stop itself."""
    size = high - low
    turns = size / TURN if course.angular else 1.0
    t = np.linspace(low, high, int(min(max(POSITIONS, turns * POSITIONS / 2), 40 * POSITIONS)))
    for stop in course.path.stops:
        if abs(stop.at - low) < 1e-9 * size:
            t = np.append(t[t > low], low + NEAR * size)
        if abs(stop.at - high) < 1e-9 * size:
            t = np.append(t[t < high], high - NEAR * size)
    return np.unique(t)


def _where_bent(found: Curves) -> np.ndarray:
    """Positions to put in where a curve, drawn twice as wide as high, turns much from one position to the next."""
    t, middles = found.t, (found.t[1:] + found.t[:-1]) / 2
    wanted = np.zeros(middles.shape, dtype=bool)
    for k, entry in enumerate(found.series):
        low, high = found.bounds(k)
        if high - low <= ZERO * found._like(k):
            continue
        across, up = np.diff(t) / (found.high - found.low) * 2, np.diff(np.clip(entry.signed, low, high)) / (high - low)
        turn = np.abs(np.diff(np.arctan2(up, across)))
        sharp = np.nan_to_num(turn) > BEND
        wanted[1:] |= sharp
        wanted[:-1] |= sharp
    return np.asarray(middles[wanted & (np.diff(t) > 1e-6 * (found.high - found.low))])
