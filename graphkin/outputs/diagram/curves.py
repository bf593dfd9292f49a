"""The numbers that a motion diagram shows: finely sampled curves, and their greatest and least values.

Nothing here draws. Times of the path (`t`) are as in `graphkin.studies.sweeps`: driver values are `course.value(t)`.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

import numpy as np

from graphkin.base.geometry import Array, number
from graphkin.base.value import frozen
from graphkin.model.units import Unit
from graphkin.running.path import Event
from graphkin.say.sizes import files_unit
from graphkin.studies import sweeps
from graphkin.studies.sweeps import Course, Road, Series

TURN = 2 * np.pi
POSITIONS = 721
NEAR = 10.0 ** np.linspace(-8, -2.6, 55)
"""Distances from a stop at which positions are put, as parts of the range: velocities grow without bound there."""
BEND = 0.06  # where a curve turns by more than this between two positions, as drawn, more are put in [rad]
MOST = 8000
ROUNDS, PLACES = 7, 33  # rounds in which a greatest value is closed in on, and positions looked at in each
ZERO = 1e-9  # differences smaller than this part of the size of like quantities are rounding
CLEAR = 0.05
"""Distance from a stop, as a part of the range, from which values count for the scale where they grow without bound."""


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
    t: Array
    series: tuple[Series, ...]

    def shown(self, unit: str) -> Unit:
        """The unit in which values of an SI unit are shown: by the file's unit of length."""
        return files_unit(self.course.method.mechanism, unit)

    @property
    def events(self) -> tuple[Event, ...]:
        """Stops and change points that are shown, in their order."""
        margin, path = 1e-6 * (self.high - self.low), self.course.path
        shown = (e for e in (*path.stops, *path.changes) if self.low - margin <= e.at <= self.high + margin)
        return tuple(sorted(shown, key=lambda event: event.at))

    @cached_property
    def alike(self) -> tuple[tuple[int, ...], ...]:
        """Numbers of curves that lie on one another, together: links 2 and 3 that slide on each other turn alike."""
        groups: list[list[int]] = []
        for k, entry in enumerate(self.series):
            for group in groups:
                first, like = self.series[group[0]], self.like(group[0])
                clear = np.abs(first.signed) <= 10 * like
                close = np.isclose(first.signed, entry.signed, rtol=0, atol=ZERO * like, equal_nan=True)
                if first.unit == entry.unit and close[clear].all() and clear.any():
                    group.append(k)
                    break
            else:
                groups.append([k])
        return tuple(map(tuple, groups))

    def unbounded(self, k: int) -> tuple[bool, bool]:
        """True where a curve grows without bound, towards the low and the high end of what is shown."""
        size, values = self.high - self.low, np.abs(self.series[k].signed)
        growing = []
        for end in (self.low, self.high):
            part = np.abs(self.t - end) / size
            known = np.isfinite(values) & (part < 1e-3)
            stops = any(abs(end - stop.at) <= 1e-6 * size for stop in self.course.path.stops)
            nearest, farther = values[known & (part < 1e-6)], values[known & (part > 1e-4)]
            seen = stops and nearest.size and farther.size
            growing.append(bool(seen and nearest.max() > 2 * farther.max()))
        return growing[0], growing[1]

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
        brackets: list[tuple[int, int, float, float]] = []  # curve, sign, from and to around its extreme sample
        for k, values in enumerate(entry.signed for entry in self.series):
            there, (low, high) = np.flatnonzero(np.isfinite(values)), self.bounds(k)
            if not there.size or high - low <= ZERO * self.like(k):
                continue
            for sign in (1, -1):
                at = self._highest(k, sign * values[there], there, ZERO * (high - low))
                if at is not None:
                    before, after = there[max(at - 1, 0)], there[min(at + 1, there.size - 1)]
                    brackets.append((k, sign, float(self.t[before]), float(self.t[after])))
        by_curve: list[list[Peak]] = [[] for _ in self.series]
        for (owner, *_), peak in zip(brackets, self._polished(brackets) if brackets else (), strict=True):
            by_curve[owner].append(peak)
        return tuple(map(tuple, by_curve))

    def _highest(self, k: int, heights: Array, there: Array, rounding: float) -> int | None:
        """The first of the highest places; where a curve rises without bound, the highest of its summits, if any."""
        at = int(np.flatnonzero(heights >= heights.max() - rounding)[0])
        # an end of what is shown counts where the curve stops there, not where it goes on round or without bound
        grows, values = self.unbounded(k), self.series[k].signed[there]
        if 0 < at < there.size - 1:
            ends = [end for end, without_bound in zip((self.low, self.high), grows, strict=True) if without_bound]
            is_peak = all(abs(self.t[there[at]] - end) > 1e-3 * (self.high - self.low) for end in ends)
        elif self.course.full_turn and self.high - self.low > TURN - 1e-9:
            is_peak = bool(abs(values[0] - values[-1]) < 1e-6 * np.ptp(values))
        else:
            is_peak = not grows[0 if at == 0 else 1]
        if is_peak:
            return at
        if not any(grows):
            return None
        rise = np.diff(heights)
        summits = 1 + np.flatnonzero((rise[:-1] > 0) & (rise[1:] <= 0))
        if not summits.size:
            return None
        return int(summits[heights[summits] >= heights[summits].max() - rounding][0])

    def like(self, k: int) -> float:
        """The greatest size among quantities of one unit."""
        same = [j for j, entry in enumerate(self.series) if entry.unit == self.series[k].unit]
        return max((abs(end) for j in same for end in self.bounds(j)), default=0.0)

    def _polished(self, brackets: Sequence[tuple[int, int, float, float]]) -> list[Peak]:
        """All of them closed in on together: each round looks at some positions in every bracket."""
        names = [entry.name for entry in self.series]
        owner, sign, low, high = (np.array(column) for column in zip(*brackets))
        rows = np.arange(len(brackets))
        for _ in range(ROUNDS):
            t = np.linspace(low, high, PLACES, axis=1)
            series = sweeps.quantities_at(self.course, names, t.ravel(), self.by).series
            values = np.array([series[k].signed.reshape(t.shape)[row] for row, k in enumerate(owner)])
            heights = np.where(np.isfinite(values), sign[:, None] * values, -np.inf)
            best = heights.argmax(axis=1)
            low, high = t[rows, np.maximum(best - 1, 0)], t[rows, np.minimum(best + 1, PLACES - 1)]
        peaks = []
        for row, k in enumerate(owner):
            value = float(values[row, best[row]])
            rounded = 0.0 if abs(value) <= ZERO * self.like(k) else value
            peaks.append(Peak(float(t[row, best[row]]), rounded, int(sign[row])))
        return peaks


def curves(course: Course, names: Sequence[str], by: Road = "construction") -> Curves:
    """Quantities over the shown part of a course, finely sampled whatever the steps of its table are. First evenly, and
    ever closer to where the path stops, never on a stop itself; then more where curves bend."""
    low, high = span(course)
    names = sweeps.drawable(course.method.mechanism, names)
    size = high - low
    turns = size / TURN if course.angular else 1.0
    t = np.linspace(low, high, int(min(max(POSITIONS, turns * POSITIONS / 2), 40 * POSITIONS)))
    for stop in course.path.stops:
        if abs(stop.at - low) < 1e-9 * size:
            t = np.append(t[t > low], low + NEAR * size)
        if abs(stop.at - high) < 1e-9 * size:
            t = np.append(t[t < high], high - NEAR * size)
    t = np.unique(t)
    for _ in range(4):
        more = _where_bent(Curves(course, by, low, high, t, sweeps.quantities_at(course, names, t, by).series))
        if not more.size or t.size + more.size > max(MOST, 2 * t.size):
            break
        t = np.union1d(t, more)
    return Curves(course, by, low, high, t, sweeps.quantities_at(course, names, t, by).series)


def span(course: Course) -> tuple[float, float]:
    """The shown part of the path: that asked for; to a full turn, or to the path's end, if only a step is missing."""
    path, t = course.path, np.unique(course.t)
    low, high = float(t[0]), float(t[-1])
    step = 1.01 * float(np.diff(t).max()) if t.size > 1 else np.inf
    if course.full_turn and t.size == 1:
        low = high = min(number(course.at(TURN * np.floor(number(course.value(low)) / TURN))), path.high - TURN)
    if course.full_turn and TURN - step <= high - low < TURN:
        low, high = (low, low + TURN) if low + TURN <= path.high + 1e-9 else (high - TURN, high)
    if not course.full_turn:
        low = path.first if low - path.first <= step else low
        high = path.last if path.last - high <= step else high
    return low, high


def _where_bent(curves: Curves) -> Array:
    """Positions to put in where a curve, drawn twice as wide as high, turns much from one position to the next."""
    size, steps = curves.high - curves.low, np.diff(curves.t)
    bent = np.zeros(steps.shape, dtype=bool)
    for k, entry in enumerate(curves.series):
        low, high = curves.bounds(k)
        if high - low <= ZERO * curves.like(k):
            continue
        across, up = steps / size * 2, np.diff(np.clip(entry.signed, low, high)) / (high - low)
        sharp = np.nan_to_num(np.abs(np.diff(np.arctan2(up, across)))) > BEND
        bent[1:] |= sharp
        bent[:-1] |= sharp
    return ((curves.t[1:] + curves.t[:-1]) / 2)[bent & (steps > 1e-6 * size)]
