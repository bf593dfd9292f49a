"""The curve of a point on a drawing, beside where the point goes by the analysis."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from typing import cast

import numpy as np
import shapely

from graphkin.analytic import motion
from graphkin.analytic.loops import size_of
from graphkin.base.value import frozen
from graphkin.check.shown import ShownMark
from graphkin.errors import GraphkinError
from graphkin.model.mechanism import Driver, Mechanism

Pair = tuple[complex, complex]
"""Where something is drawn, and where it should be."""
Places = Callable[[np.ndarray], np.ndarray]
"""Where a point is on paper [mm] at values of a driver [rad, m]; nan where these are not reached."""
_LOOK, _SOUGHT = 361, 4
"""Positions of the first look, and how often the end of what is reached is sought between two."""
_FINE, _HALVED = 0.002, 4
"""How far chords of the curve may stand off it [mm], and how often they are halved at most."""
_GONE = 0.2
"""What is farther from all that is drawn is missing: chords stand off, and a curve ends a little before dead points
[mm]."""
_SLID = 2.001
"""A slide is followed so many lengths of the longest link to either side, or as far as the curve is wide and high."""
_NEAR = 3.0
"""Sizes of the mechanism within which a curve is drawn, from where its point is; farther off it may end."""
_BEYOND = 2.0
"""How far a curve is followed beside what is drawn of it, in sizes of that."""


def worst_of_path(
    mark: ShownMark, mechanism: Mechanism, values: Sequence[float], scale: float, origin: complex
) -> Pair | None:
    """The corner that is farthest off the curve, or the place of the curve that is missing; None where the mark names
    no point and driver.

    values  of the drivers at the drawn position [rad, m]; scale [m/mm]; origin on paper [mm]
    """
    point, driver = mark.attributes.get("data-points", ""), mark.attributes.get("data-line", "")
    names = [each.name for each in mechanism.drivers]
    if point not in mechanism.points or driver not in names or not mark.plain or len(mark.lines) != 1:
        return None

    corners = np.array(mark.lines[0])
    at = names.index(driver)
    rate = mechanism.drivers[at].rate
    paces = [other.rate / rate if rate else 0.0 for other in mechanism.drivers]

    def placed(names: Sequence[str], value: np.ndarray) -> np.ndarray:
        """The other drivers keep pace with this one."""
        moved = [given + pace * (value - values[at]) for given, pace in zip(values, paces, strict=True)]
        moved[at] = value
        found = motion(mechanism, moved).position
        return np.array([np.asarray(found[name]) / scale + origin for name in names])

    try:
        drawn = placed(mechanism.points, np.array([values[at]]))
        course = _Course(
            lambda value: cast(np.ndarray, placed([point], value)[0]), values[at], mechanism.drivers[at],
            _across(drawn) or math.inf, size_of(mechanism), _across(corners),
        )  # fmt: skip
        value, curve = _curve(course.places, *_reached(course, max(_SLID * course.longest, course.across * scale)))
    except GraphkinError:
        return None
    wanted = curve[_wanted(course, corners, value, curve)]
    return max([*_off(corners, curve), *_missing(corners, wanted)], key=lambda pair: abs(pair[0] - pair[1]))


@frozen
class _Course:
    """Where a point goes on paper as its driver moves.

    here  the driver's value as drawn; size  of the mechanism there [mm]; longest  of its links [m]
    across  of what is drawn of the curve [mm]
    """

    places: Places
    here: float
    driver: Driver
    size: float
    longest: float
    across: float

    def gone(self, values: np.ndarray) -> np.ndarray:
        """Where it is not reached, or far off all that is drawn."""
        away = np.abs(self.places(values) - self.places(np.array([self.here])))
        return np.asarray(~(away <= _BEYOND * self.across))


def _across(places: np.ndarray) -> float:
    """Width and height."""
    return float(np.ptp(places.real) + np.ptp(places.imag))


def _reached(course: _Course, slid: float) -> tuple[float, float]:
    """Values of the driver: a turn from here on in its sense, or from end to end of what it reaches."""
    far = slid if course.driver.kind == "slide" else math.tau
    low, high = _ends(course, far)
    if course.driver.kind != "slide" and high - low >= 2 * math.tau:
        return course.here, course.here + math.copysign(math.tau, course.driver.rate or 1.0)
    return low, high


def _ends(course: _Course, far: float) -> tuple[float, float]:
    """How far the driver gets in either sense: between the last value reached and the first that is not."""
    ends = [(course.here, course.here - far), (course.here, course.here + far)]
    for _ in range(_SOUGHT):
        values = np.array([np.linspace(*end, _LOOK) for end in ends])
        gone = course.gone(values.ravel()).reshape(values.shape)
        first = np.where(gone.any(axis=1), gone.argmax(axis=1), _LOOK)
        ends = [(row[min(k, _LOOK) - 1], row[min(k, _LOOK - 1)]) for row, k in zip(values, first, strict=True)]
        if not gone.any():
            break
    return float(ends[0][0]), float(ends[1][0])


def _curve(places: Places, low: float, high: float) -> tuple[np.ndarray, np.ndarray]:
    """Values of the driver in their order, and the curve there, as a line so fine that no chord stands off it [mm];
    close by dead points, where it runs on fast."""
    value = (low + high) / 2 - (high - low) / 2 * np.cos(np.linspace(0.0, np.pi, 4 * _LOOK))
    begin, end = value[:-1], value[1:]
    values, there = [value], [places(value)]
    first, last = there[0][:-1], there[0][1:]
    for _ in range(_HALVED):
        middle = (begin + end) / 2
        between = places(middle)
        values, there = [*values, middle], [*there, between]
        off = np.abs(between - (first + last) / 2) > _FINE
        begin, end = np.r_[begin[off], middle[off]], np.r_[middle[off], end[off]]
        first, last = np.r_[first[off], between[off]], np.r_[between[off], last[off]]
        if not off.any():
            break
    every = np.concatenate(values)
    order = np.argsort(every, kind="stable")
    return every[order], np.concatenate(there)[order]


def _wanted(course: _Course, corners: np.ndarray, values: np.ndarray, curve: np.ndarray) -> slice:
    """The part of the curve that must be drawn: all, but what runs off, or goes on with a slide, may end anywhere."""
    here = min(int(np.searchsorted(values, course.here)), values.size - 1)
    onward, back = slice(here, None), slice(here, None if here else 0, -1)
    after, before = (_drawn(course, corners, values[side], curve[side]) for side in (onward, back))
    return slice(here - max(before - 1, 0), here + after)


def _drawn(course: _Course, corners: np.ndarray, values: np.ndarray, curve: np.ndarray) -> int:
    """How many of the places from here on must be drawn."""
    away = np.nan_to_num(np.abs(curve - curve[:1])) > _NEAR * course.size
    on = course.driver.kind == "slide" and float(np.abs(values - course.here).max(initial=0.0)) > course.longest
    if curve.size < 2 or not (on or away.any()):
        return curve.size
    ends = shapely.points(_xy(corners[[0, -1], None]))
    chords = shapely.linestrings(_xy(np.stack([curve[:-1], curve[1:]], axis=-1)))
    met = np.flatnonzero((shapely.distance(chords, ends) <= _GONE).any(axis=0))
    return int(met[0]) + 1 if met.size else curve.size


def _off(corners: np.ndarray, curve: np.ndarray) -> Iterator[Pair]:
    """Each corner, and the place of the curve next to it."""
    line = shapely.linestrings(_xy(curve[np.isfinite(curve)]))
    there = shapely.line_interpolate_point(line, shapely.line_locate_point(line, shapely.points(_xy(corners))))
    yield from zip(corners, shapely.get_x(there) + 1j * shapely.get_y(there), strict=True)


def _missing(corners: np.ndarray, curve: np.ndarray) -> Iterator[Pair]:
    """The place of the curve that is too far off what is drawn, beside the drawn place next to it."""
    drawn = shapely.linestrings(_xy(corners))
    curve = curve[np.isfinite(curve)]
    off = shapely.distance(drawn, shapely.points(_xy(curve)))
    if off.max(initial=0.0) > _GONE:
        place = complex(curve[int(off.argmax())])
        next_to = drawn.interpolate(drawn.project(shapely.Point(place.real, place.imag)))
        yield complex(next_to.x, next_to.y), place


def _xy(places: np.ndarray) -> np.ndarray:
    return np.stack([places.real, places.imag], axis=-1)
