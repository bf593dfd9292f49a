"""Lines of links held against the links: bars by points, guides and blocks by the line they lie on, wheels by radius;
and the curve of a point held against its motion.

Each mark gives a place that should be where it is drawn, the worst one: [mm on paper, y up].
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import cast

import numpy as np
import shapely

from graphkin.analytic import motion
from graphkin.analytic.loops import size_of
from graphkin.base.geometry import number
from graphkin.base.value import frozen
from graphkin.check.expected import Widened, lines_of
from graphkin.check.shown import ShownMark
from graphkin.errors import GraphkinError
from graphkin.model.mechanism import Driver, Mechanism
from graphkin.model.pairs import Rod

Pair = tuple[complex, complex]  # where something is drawn, and where it should be


def link_name(attributes: Mapping[str, str]) -> str:
    """`link 3: A B`."""
    on = attributes.get("data-line", "") if attributes.get("data-form") != "bar" else attributes.get("data-points", "")
    return f"{attributes.get('data-link', '')}: {on or attributes.get('data-points', '')}"


def worst_place(mark: ShownMark, exact: Widened, at: Callable[[str], complex], scale: float) -> Pair | None:
    """The place of a link's line that is farthest off; None for a mark that says nothing known.

    at  where a point of its plane should be on paper [mm]; raises KeyError.  scale  [m/mm]
    """
    form, points = mark.attributes.get("data-form", ""), mark.attributes.get("data-points", "").split()
    if not mark.lines or mark.attributes.get("data-link", "") not in {*exact.mechanism.links, *exact.bodies}:
        return None
    if form == "wheel":
        pairs = list(_wheel(mark, exact.mechanism, at, scale)) if mark.tag == "circle" else []
    elif not mark.plain or len(mark.lines) > 1:
        return None
    elif form == "arc":
        pairs = list(_arc(mark, exact.mechanism, [at(point) for point in points], scale))
    elif form in ("omega", "alpha", "push", "thrust"):
        pairs = [_sense(mark, form, exact, [at(point) for point in points])]
    elif form == "bar":
        corners = _corners(mark)
        pairs = list(zip(corners, map(at, points), strict=True)) if len(corners) == len(points) else []
    else:
        pairs = list(_on_line(mark, form, exact, at, points))
    return max(pairs, key=lambda pair: abs(pair[0] - pair[1]), default=None)


def _corners(mark: ShownMark) -> list[complex]:
    places = list(mark.lines[0])
    return places[:-1] if len(places) > 2 and abs(places[0] - places[-1]) < 1e-9 else places


def _wheel(mark: ShownMark, mechanism: Mechanism, at: Callable[[str], complex], scale: float) -> Iterator[Pair]:
    """The circle's middle, and its radius beside the nearest one that its link has there."""
    link, centre = mark.attributes["data-link"], mark.attributes.get("data-points", "")
    middle, radius = mark.middle, abs(mark.lines[0][0] - mark.middle)
    yield middle, at(centre)
    radii = {r / scale for pair in mechanism.pairs for *on, r in pair.circles if on == [link, centre]}
    if not radii or mark.scale <= 0:
        raise KeyError(centre)
    yield middle + radius, middle + min(radii, key=lambda right: abs(right - radius))


def _arc(mark: ShownMark, mechanism: Mechanism, points: list[complex], scale: float) -> Iterator[Pair]:
    """Every corner at its radius from the centre, a slot's half a width off it; and the pin between the ends."""
    centre, pin = points
    (radius,) = (pair.equivalent.length for pair in mechanism.pairs
                 if pair.name == mark.attributes.get("data-line", "") and isinstance(pair.equivalent, Rod))  # fmt: skip
    corners = _corners(mark)
    off = [abs(place - centre) - radius / scale for place in corners]
    half = (max(off) - min(off)) / 2 if len(corners) < len(mark.lines[0]) else 0.0
    for place, beyond in zip(corners, off, strict=True):
        yield place, place + (centre - place) / abs(centre - place) * (beyond - min(max(beyond, -half), half))
    turns = [cmath.phase((place - centre) / (pin - centre)) for place in corners]
    if min(turns) > 0 or max(turns) < 0:
        yield corners[0], pin


def _sense(mark: ShownMark, form: str, exact: Widened, points: list[complex]) -> Pair:
    """The middle of an arrow head's back, behind its tip on the side from which the motion comes."""
    tip, *back = _corners(mark)
    foot = sum(back) / len(back)
    link, line, long = mark.attributes["data-link"], mark.attributes.get("data-line", ""), abs(tip - foot)
    if form in ("push", "thrust"):
        rate = number((exact.s_rate if form == "push" else exact.s_acceleration)[line])
        way = lines_of(exact.mechanism)[line].direction * cmath.rect(1, number(exact.theta[link]))
        return foot, tip - long * way * float(np.sign(rate))
    turning = exact.turning if form == "omega" else exact.swing
    rate = number(turning(link)) - (number(turning(line)) if line else 0.0)
    arm = tip - sum(points) / len(points)
    chord = arm - arm * cmath.rect(1, -float(np.sign(rate)) * long / abs(arm))
    return foot, tip - long * chord / abs(chord)


def _on_line(
    mark: ShownMark, form: str, exact: Widened, at: Callable[[str], complex], points: list[str]
) -> Iterator[Pair]:
    """Ends or middle on the line, sides along it, over its points; a block's middle on its point."""
    line = lines_of(exact.mechanism)[mark.attributes.get("data-line", "")]
    foot, along = at(line.origin), exact.along(line)
    corners = _corners(mark)
    middle = sum(corners) / len(corners)
    for place in corners if len(corners) == 2 else [middle]:
        yield place, foot + along * ((place - foot) / along).real
    sides = list(zip(corners, [*corners[1:], corners[0]], strict=True))
    if form == "block":
        yield middle, at(points[0])
        for start, end in sides:  # a side's end, and where it would be along or across the line
            run = (end - start) / along
            yield end, start + along * (run.real if abs(run.real) > abs(run.imag) else 1j * run.imag)
    else:
        longest = max(sides, key=lambda side: abs(side[1] - side[0]))
        yield longest[1], longest[0] + along * ((longest[1] - longest[0]) / along).real
    stretch = [((corner - foot) / along).real for corner in corners]
    for point in points:
        t = ((at(point) - foot) / along).real
        yield foot + along * min(max(t, min(stretch)), max(stretch)), foot + along * t


# --- curves of points --------------------------------------------------------------------------


Places = Callable[[np.ndarray], np.ndarray]
"""Where a point is on paper [mm] at values of a driver [rad, m]; nan where these are not reached."""
_LOOK, _SOUGHT = 361, 4
"""Positions of the first look, and how often the end of what is reached is sought between two."""
_FINE, _HALVED = 0.002, 4
"""Distance of chords from their curve [mm], and the number of halvings, at most."""
_GONE = 0.2
"""A place farther from all that is drawn is missing [mm]: chords stand off, and a curve ends a little before dead
points."""
_SLID = 2.001
"""A slide is followed so many lengths of the longest link to either side, or as far as the curve is wide and high."""
_NEAR = 3.0  # sizes of the mechanism within which a curve is drawn, from where its point is; farther off it may end
_BEYOND = 2.0  # how far a curve is followed beside what is drawn of it, in sizes of that


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
    corners, at = np.array(mark.lines[0]), names.index(driver)
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
        course = _PaperCourse(
            lambda value: cast(np.ndarray, placed([point], value)[0]), values[at], mechanism.drivers[at],
            _width_and_height(drawn) or math.inf, size_of(mechanism), _width_and_height(corners),
        )  # fmt: skip
        value, curve = _curve(course.places, *_reached(course, max(_SLID * course.longest, course.across * scale)))
    except GraphkinError:
        return None
    # all must be drawn, but what runs off, or goes on with a slide, may end anywhere
    here = min(int(np.searchsorted(value, course.here)), value.size - 1)
    onward, back = slice(here, None), slice(here, None if here else 0, -1)
    after, before = (_drawn(course, corners, value[side], curve[side]) for side in (onward, back))
    visible = curve[slice(here - max(before - 1, 0), here + after)]
    return max(_deviations(corners, curve, visible), key=lambda pair: abs(pair[0] - pair[1]))


@frozen
class _PaperCourse:
    """The course of a point on paper as its driver moves.

    here  the driver's value as drawn; size  of the mechanism there [mm]; longest  of its links [m]
    across  of what is drawn of the curve [mm]
    """

    places: Places
    here: float
    driver: Driver
    size: float
    longest: float
    across: float


def _width_and_height(places: np.ndarray) -> float:
    """Width and height."""
    return float(np.ptp(places.real) + np.ptp(places.imag))


def _reached(course: _PaperCourse, slid: float) -> tuple[float, float]:
    """Values of the driver: a turn from here on in its sense, or from end to end of what it reaches."""
    far = slid if course.driver.kind == "slide" else math.tau
    # its reach in either sense: between the last value reached and the first that is not
    ends = [(course.here, course.here - far), (course.here, course.here + far)]
    for _ in range(_SOUGHT):
        values = np.array([np.linspace(*end, _LOOK) for end in ends])
        # not reached, or far off all that is drawn
        away = np.abs(course.places(values.ravel()) - course.places(np.array([course.here])))
        gone = ~(away <= _BEYOND * course.across).reshape(values.shape)
        first = np.where(gone.any(axis=1), gone.argmax(axis=1), _LOOK)
        ends = [(row[min(k, _LOOK) - 1], row[min(k, _LOOK - 1)]) for row, k in zip(values, first, strict=True)]
        if not gone.any():
            break
    low, high = float(ends[0][0]), float(ends[1][0])
    if course.driver.kind != "slide" and high - low >= 2 * math.tau:
        return course.here, course.here + math.copysign(math.tau, course.driver.rate or 1.0)
    return low, high


def _curve(places: Places, low: float, high: float) -> tuple[np.ndarray, np.ndarray]:
    """The curve by values of the driver, as a line so fine that no chord stands off it [mm]."""
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


def _drawn(course: _PaperCourse, corners: np.ndarray, values: np.ndarray, curve: np.ndarray) -> int:
    """The number of places from here on that must be drawn."""
    away = np.nan_to_num(np.abs(curve - curve[:1])) > _NEAR * course.size
    on = course.driver.kind == "slide" and float(np.abs(values - course.here).max(initial=0.0)) > course.longest
    if curve.size < 2 or not (on or away.any()):
        return curve.size
    ends = shapely.points(_xy(corners[[0, -1], None]))
    chords = shapely.linestrings(_xy(np.stack([curve[:-1], curve[1:]], axis=-1)))
    met = np.flatnonzero((shapely.distance(chords, ends) <= _GONE).any(axis=0))
    return int(met[0]) + 1 if met.size else curve.size


def _deviations(corners: np.ndarray, curve: np.ndarray, visible: np.ndarray) -> Iterator[Pair]:
    """Each corner beside the curve; and the visible place farthest off what is drawn."""
    line = shapely.linestrings(_xy(curve[np.isfinite(curve)]))
    there = shapely.line_interpolate_point(line, shapely.line_locate_point(line, shapely.points(_xy(corners))))
    yield from zip(corners, shapely.get_x(there) + 1j * shapely.get_y(there), strict=True)
    drawn, visible = shapely.linestrings(_xy(corners)), visible[np.isfinite(visible)]
    off = shapely.distance(drawn, shapely.points(_xy(visible)))
    if off.max(initial=0.0) > _GONE:
        place = complex(visible[int(off.argmax())])
        next_to = drawn.interpolate(drawn.project(shapely.Point(place.real, place.imag)))
        yield complex(next_to.x, next_to.y), place


def _xy(places: np.ndarray) -> np.ndarray:
    return np.stack([places.real, places.imag], axis=-1)
