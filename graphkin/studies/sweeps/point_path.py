"""The curve that a point draws as its mechanism moves (a coupler curve), with places at equal steps of the driver."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from graphkin.base.geometry import number
from graphkin.base.scales import round_step
from graphkin.base.value import frozen
from graphkin.errors import StandsStill, UnknownPoint, Where
from graphkin.model.quantities import EDGE
from graphkin.planning import Method
from graphkin.studies.sweeps.course import TURN, Course, course_from
from graphkin.studies.sweeps.roads import prove
from graphkin.studies.sweeps.sweep import quantities_at

_FINE = 2e-4  # a chord may stand so far off the curve, as part of the curve's size
_FIRST, _ROUNDS, _MOST = 181, 7, 20_000
"""Positions at first, the number of times that chords are halved, and positions that are enough."""
_INSIDE = 1e-7  # the curve ends so far inside of dead points, as part of the path
_FAR = 4.0
"""The curve is followed so far off from where the point is drawn, in sizes of the mechanism there (width and height
added): of one that runs off to infinity the rest would leave nothing to be seen of the mechanism."""
_SAME = 1e-6  # ends nearer than this part of its size close a curve
_DEGREES = (30, 10, 5, 2, 1, 0.5, 0.2, 0.1)
"""Steps from tick to tick of an angle: the largest that gives enough of them."""
_ENOUGH = 6
_BESIDE = 1e-3  # nearer to a curve, as a part of its size, is on it


@frozen
class Tick:
    """A place on the curve at a round value of the driver.

    value    the driver's [rad, m]; velocity of the point there [m/s]; way  along the curve, of length 1 or 0
    numbered it is one of those whose value is written; both: the point passes there the other way, too
    """

    value: float
    place: complex
    velocity: complex
    way: complex
    numbered: bool
    both: bool = False


@frozen
class PointPath:
    """The curve of a point in the frame.

    course   of the mechanism: a turn of the driver from the drawn position on, or as far as it gets, or as the
             point stays near
    places   closely enough to be drawn (n,) [m]
    closed   the end is the beginning
    step     of the driver from tick to tick [rad, m]
    """

    course: Course
    point: str
    places: np.ndarray
    closed: bool
    step: float
    ticks: tuple[Tick, ...]

    @property
    def seconds(self) -> float | None:
        """The time from tick to tick; None where the driver stands, or does not move evenly."""
        driver = self.course.driver
        return self.step / abs(driver.rate) if driver.rate and not driver.acceleration else None

    def shown(self, value: float) -> str:
        """`30°`, `20 mm`: a value of the driver."""
        return EDGE[self.course.unit].shown(value).replace("-", "−")


def point_path(method: Method, point: str, values: tuple[float, ...] | None = None) -> PointPath:
    """The curve of a point through the drawn position, or through that of other driver values [rad, m].

    Raises UnknownPoint; StandsStill for a point that does not move; RoadsDiffer where the two roads do not agree.
    """
    where, points = Where(f"path {point}"), method.mechanism.points
    if point not in points:
        raise UnknownPoint(where, point, points)
    course = course_from(method, values)
    prove(course)
    turns = course.turns(point)
    if course.full_turn:  # in the sense in which the driver turns
        low, high = 0.0, math.copysign((turns or 1) * TURN, course.driver.rate or 1.0)
        course = course.on if turns > 1 else course
    else:
        inside = _INSIDE * (course.path.last - course.path.first)
        low, high = course.path.first + inside, course.path.last - inside
    low, high = _near(course, point, low, high)
    places = _curve(course, point, low, high)
    size = float(np.ptp(places.real) + np.ptp(places.imag))
    if size <= _SAME * method.size:
        raise StandsStill(where, point)
    closed = course.full_turn and abs(places[-1] - places[0]) <= _SAME * size
    length = abs(high - low)
    if course.angular:  # the step from tick to tick, and every how many of them one is numbered
        steps = map(math.radians, _DEGREES)
        step, every = next((step for step in steps if length >= _ENOUGH * step), math.radians(_DEGREES[-1])), 3
    else:
        step, every = round_step(length / _ENOUGH), 2
    ticks = _ticks(course, point, (low, high), closed, step, every)
    ticks = (replace(tick, both=_passed_back(places, tick)) for tick in ticks)
    return PointPath(course, point, places, closed, step, tuple(ticks))


def _passed_back(places: np.ndarray, tick: Tick) -> bool:
    """True where a curve also leads through a tick against the velocity there."""
    steps, size = np.diff(places), np.ptp(places.real) + np.ptp(places.imag)
    part = np.clip(((tick.place - places[:-1]) / np.where(steps, steps, 1.0)).real, 0, 1)
    near = abs(places[:-1] + part * steps - tick.place) < _BESIDE * size
    return bool(((steps * np.conj(tick.velocity)).real[near] < 0).any())


def _near(course: Course, point: str, low: float, high: float) -> tuple[float, float]:
    """A span, or as much of it to either side of the drawn position as the point stays near."""
    drawn = np.array([_places(course, each, np.zeros(1))[0] for each in course.method.mechanism.points])
    far = _FAR * float(np.ptp(drawn.real) + np.ptp(drawn.imag)) or math.inf
    here = _places(course, point, np.zeros(1))[0]

    def nearest_end(end: float) -> float:
        t = np.linspace(0.0, end, 4 * _FIRST)
        gone = np.flatnonzero(np.abs(_places(course, point, t) - here) > far)
        return float(t[gone[0] - 1]) if gone.size else end

    ends = (-TURN, TURN) if course.full_turn else (low, high)
    near = nearest_end(ends[0]), nearest_end(ends[1])
    return (low, high) if near == ends else near


def _curve(course: Course, point: str, low: float, high: float) -> np.ndarray:
    """The places (n,) [m]; chords are halved as long as one stands off the curve."""
    t = np.linspace(low, high, _FIRST)
    places = _places(course, point, t)
    for _ in range(_ROUNDS):
        size = float(np.nanmax(np.abs(places - places[0]), initial=0.0)) or 1.0
        middle = (t[1:] + t[:-1]) / 2
        between = _places(course, point, middle)
        off = np.abs(between - (places[1:] + places[:-1]) / 2) > _FINE * size
        if not off.any() or t.size > _MOST:
            break
        at = np.flatnonzero(off) + 1
        t, places = np.insert(t, at, middle[off]), np.insert(places, at, between[off])
    return np.extract(np.isfinite(places), places)


def _vectors(course: Course, name: str, t: np.ndarray) -> np.ndarray:
    vectors = quantities_at(course, [name], t).series[0].vectors
    assert vectors is not None
    return vectors


def _places(course: Course, point: str, t: np.ndarray) -> np.ndarray:
    return _vectors(course, f"path {point}", t)


def _ticks(
    course: Course, point: str, span: tuple[float, float], closed: bool, step: float, every: int
) -> Iterator[Tick]:
    low, high = sorted(number(course.value(end)) for end in span)
    numbers = np.arange(math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) + 1)
    if closed:
        numbers = numbers[: round((high - low) / step)]
    t = np.clip(course.at(numbers * step), min(span), max(span))
    places, velocities = _places(course, point, t), _vectors(course, f"v {point}", t)
    # unit vectors along the curve; 0 where the point rests
    aside, (first, last) = 1e-4 * (max(span) - min(span)), (course.path.first, course.path.last)
    before, after = (_places(course, point, np.clip(t + side, first, last)) for side in (-aside, aside))
    chord = np.nan_to_num(after - before)
    size = np.abs(chord)
    tangents = np.where(size > 1e-9 * course.method.size, chord / np.where(size > 0, size, 1.0), 0.0)
    for count, place, velocity, tangent in zip(numbers, places, velocities, tangents, strict=True):
        if np.isfinite(place) and np.isfinite(velocity):
            value = float(count) * step
            within = value % (high - low) if closed else value
            yield Tick(within, complex(place), complex(velocity), complex(tangent), int(count) % every == 0)
