"""Where it is looked: the part of a course between two ends, and quantities there, closely enough to miss nothing."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import replace
from functools import cached_property

import numpy as np

from graphkin.base.geometry import Value
from graphkin.base.value import frozen
from graphkin.running.path import stride
from graphkin.running.tracing import trace
from graphkin.studies.finding.answers import Kind, Position
from graphkin.studies.finding.quantities import Reader
from graphkin.studies.finding.rates import pace_of, rate
from graphkin.studies.finding.search import Function, differences
from graphkin.studies.sweeps import Course, Road, Series

TURN = 2 * math.pi
LEAST, MOST = 1441, 40_001
"""Positions looked at, at least and at most."""
FINE_DEG, FINE_PART = 0.25, 0.001
"""How far apart they are at most [deg, of the mechanism's size]."""
HALVINGS = 24
"""Before a dead point they lie each half as far from it as the one before."""
ROUNDING = 1e-11
"""What stays below this part of its like is rounding."""
SECOND = 100.0
"""Accelerations, read off a second polygon, have so much more of it beside a change point."""
BEYOND = 4
"""Places looked at beyond an end, so that what happens right at the end is seen."""


@frozen
class Stretch:
    """A part of a course.

    low, high   its ends; stopped: whether each is a dead point, which is not reached itself
    """

    course: Course
    by: Road
    names: tuple[str, ...]
    low: float
    high: float
    stopped: tuple[bool, bool]

    @cached_property
    def step(self) -> float:
        fine = stride(self.course.method, self.course.path.pace, FINE_DEG, FINE_PART)
        return (self.high - self.low) / (min(max(LEAST, math.ceil((self.high - self.low) / fine)), MOST) - 1)

    @cached_property
    def places(self) -> np.ndarray:
        """Where it is looked first: evenly, ever closer towards a dead point, a little beyond other ends."""
        even = np.linspace(self.low, self.high, round((self.high - self.low) / self.step) + 1)
        closer = self.step * 0.5 ** np.arange(1, HALVINGS + 1)
        beyond = self.step * np.arange(1, BEYOND + 1)
        begin, end = (even[1:] if self.stopped[0] else even), (-1 if self.stopped[1] else None)
        path = self.course.path
        low = self.low + closer[::-1] if self.stopped[0] else self.low - beyond[::-1]
        high = self.high - closer if self.stopped[1] else self.high + beyond
        t = np.concatenate([low[::-1] if self.stopped[0] else low, begin[:end], high])
        t = np.unique(t[(t >= path.low) & (t <= path.high)])
        return np.asarray(t[np.broadcast_to(path.leads_to(t), t.shape)])

    @cached_property
    def reader(self) -> Reader:
        """Reads the quantities; angles are followed all the way."""
        reader = Reader(self.course, self.names, self.by)
        reader.follow(self.places, self.low + self.step if self.stopped[0] else self.low)
        return reader

    def read(self, t: np.ndarray) -> list[Series]:
        return self.reader.read(t)

    def values(self, number: int = 0, *, size: bool = False) -> Function:
        """One quantity as a function of t; `size`: whatever its sense."""

        def function(t: np.ndarray) -> np.ndarray:
            entry = self.read(t)[number]
            return np.abs(entry.signed) if size else entry.signed

        return function

    def slope(self, number: int = 0, *, size: bool = False) -> Function:
        """How one quantity changes with t: read off the drawing where it tells it, else by differences."""
        by_differences = differences(self.values(number, size=size), self.step / 2)
        pace = pace_of(self.course)

        def exact(t: np.ndarray) -> np.ndarray | None:
            motions = self.reader.motions(t)
            entry = self.reader.read(t, motions)[number]
            assert pace is not None
            found = rate(motions, entry, pace)
            if found is None:
                return None
            sense = np.sign(entry.signed) if size else 1.0
            return np.asarray(np.broadcast_to(found, t.shape) * sense)

        told = pace is not None and exact(self.places[:1]) is not None
        if not told:
            return by_differences

        def slope(t: np.ndarray) -> np.ndarray:
            found = exact(t) if t.size else t
            assert found is not None
            return found

        return slope

    def position(self, t: float, kind: Kind, values: tuple[float, ...] | None = None) -> Position:
        drivers = tuple(float(value) for value in self.course.path.values(t))
        if values is None:
            values = tuple(float(entry.signed[0]) for entry in self.read(np.array([t])))
        return Position(float(t), drivers, values, kind)

    @cached_property
    def _usual(self) -> dict[str, float]:
        """How large the quantities of each unit are in this mechanism: what moves fastest, what is longest."""
        motions, drivers = self.reader.motions(self.places), self.course.method.drivers
        length = self.course.method.size
        rates = [*motions.omega.values(), *(driver.rate for driver in drivers if driver.kind != "slide")]
        turning = _greatest(rates)
        slides = [driver for driver in drivers if driver.kind == "slide"]
        speed = max(turning * length, *(abs(driver.rate) for driver in slides), _greatest(motions.s_rate.values()))
        alphas = [*motions.alpha.values(), *(driver.acceleration for driver in drivers if driver.kind != "slide")]
        quick = max(_greatest(alphas), turning**2)
        pull = max(quick * length, speed**2 / length, *(abs(driver.acceleration) for driver in slides))
        return {"rad": 1.0, "1": 1.0, "m": length, "rad/s": turning, "rad/s^2": quick, "m/s": speed, "m/s^2": pull}

    def noise(self, unit: str) -> float:
        """What a quantity of this unit may be by rounding alone, though it is zero."""
        return ROUNDING * (SECOND if unit.endswith("s^2") else 1.0) * self._usual.get(unit, 0.0)

    # --- which places count -------------------------------------------------------------------

    @cached_property
    def closed(self) -> bool:
        """Whether both ends are one and the same position, a turn apart."""
        if not self.course.angular or any(self.stopped) or abs(self.high - self.low - TURN) > 1e-9:
            return False
        return self._same(self.low, self.high)

    def _same(self, one: float, other: float) -> bool:
        """Whether every point is at the same place."""
        places = self.reader.motions(np.array([one, other])).position
        size = self.course.method.size
        points = self.course.method.mechanism.points
        both = (np.broadcast_to(places[point], (2,)) for point in points if point in places)
        return all(abs(place[0] - place[1]) <= 1e-7 * size for place in both)

    def within(self, t: np.ndarray) -> np.ndarray:
        """Those between the ends, in their order, each once: a turn's end is its beginning."""
        margin = 1e-9 * (self.high - self.low)
        inside = np.sort(np.clip(t[(t >= self.low - margin) & (t <= self.high + margin)], self.low, self.high))
        if inside.size > 1:
            inside = inside[np.concatenate([[True], np.diff(inside) > 1e-8 * (self.high - self.low)])]
        if inside.size > 1 and self.closed and inside[-1] - inside[0] > TURN - 1e-7:
            inside = inside[:-1]
        return inside


def _greatest(values: Iterable[Value]) -> float:
    """Of sizes as three quarters of the places have them: beside a stop speeds grow without bound. 0 of none."""
    sizes = (np.abs(np.ravel(np.asarray(value, dtype=float))) for value in values)
    finite = (size[np.isfinite(size)] for size in sizes)
    return max((float(np.percentile(size, 75)) for size in finite if size.size), default=0.0)


def stretch(course: Course, ranges: tuple[str, ...], names: tuple[str, ...], by: Road) -> Stretch:
    """What a course asks for: from the first to the last position, and on to a dead point that is close behind."""
    t = np.unique(course.t)
    low, high = float(t[0]), float(t[-1])
    course = _looked_far_enough(course, low, high)
    gap = float(np.max(np.diff(t))) * 1.5 if t.size > 1 else math.inf
    before, after = False, False
    if course.dropped.size or not ranges:
        for stop in course.path.stops:
            if stop.at > high and stop.at - high <= gap:
                high, after = stop.at, True
            elif stop.at < low and low - stop.at <= gap:
                low, before = stop.at, True
    turn = course.angular and not course.path.stops and sum(map(bool, course.path.pace)) == 1
    if turn and not course.method.structure.contacts and high - low > TURN:
        high = low + TURN
    return Stretch(course, by, names, low, high, (before, after))


def _looked_far_enough(course: Course, low: float, high: float) -> Course:
    """The same course on a way that was looked along as far as its positions lie."""
    path = course.path
    if path.low <= low and high <= path.high:
        return course
    farther = trace(course.method, path.pace, min(path.low, low), max(path.high, high), (path, 0.0))
    return replace(course, path=farther)
