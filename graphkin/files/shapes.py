"""From a link's lengths and angles to the places of its points, as one would lay it out with compass and protractor.

Two points with a known distance are put down first. Then every further point is put where two curves cross: a
length is a circle about a placed point, an angle at a placed point is a line through it, an angle at the new
point is the circle of equal angles over two placed ones. Mirror images are distinguished by `ccw`.

Unlike `graphkin.base.geometry` this works on one layout at a time and must decide: curves that touch within 1e-9
of their size touch in one point, as three collinear points want it.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field
from itertools import combinations, islice

from graphkin import errors
from graphkin.base.tolerances import ROUNDED
from graphkin.base.value import frozen
from graphkin.errors import GraphkinError, Where

MOST_POINTS = 50  # links of more points than this need coordinates

MOST_TRIALS = 300  # partial layouts looked at before the search for a shape is given up

MOST_CURVES = 20
"""Of more curves than this for one point, the first are crossed and the others only held against the result."""

TOUCHES = 1e-9  # two curves closer than this part of their size touch


@frozen
class CircleCurve:
    centre: complex
    radius: float


@frozen
class StraightLine:
    """Through `point` along the unit vector `along`."""

    point: complex
    along: complex

    def distance(self, place: complex) -> float:
        return abs(((place - self.point) * self.along.conjugate()).imag)


Curve = CircleCurve | StraightLine
Places = Mapping[str, complex]
Triple = tuple[str, str, str]


@frozen
class Length:
    """`AB = 24`."""

    key: str
    points: tuple[str, str]
    value: float

    def curves(self, point: str, placed: Places) -> list[Curve]:
        """The curves on which `point` may lie, the other point being placed."""
        other = self.points[1] if point == self.points[0] else self.points[0]
        return [CircleCurve(placed[other], self.value)]

    def miss(self, placed: Places) -> float:
        """The distance of a layout from this length [m]."""
        a, b = (placed[point] for point in self.points)
        return abs(abs(b - a) - self.value)


@frozen
class AngleMeasure:
    """`BDE = 90`: the angle at the middle point, 0 to pi."""

    key: str
    points: Triple
    value: float

    def curves(self, point: str, placed: Places) -> list[Curve]:
        """The curves on which `point` may lie, the other two points being placed."""
        first, vertex, last = self.points
        if point == vertex:
            return _equal_angles(placed[first], placed[last], self.value)
        along = placed[last if point == first else first] - placed[vertex]
        if along == 0:
            return []
        turns = {cmath.rect(1, self.value), cmath.rect(1, -self.value)}
        return [StraightLine(placed[vertex], along / abs(along) * turn) for turn in turns]

    def miss(self, placed: Places) -> float:
        """The distance of the end of the shorter arm from this angle [m]."""
        first, vertex, last = (placed[point] for point in self.points)
        one, other = first - vertex, last - vertex
        if one == 0 or other == 0:
            return 0.0
        return abs(abs(cmath.phase(one / other)) - self.value) * min(abs(one), abs(other))


Measure = Length | AngleMeasure


@frozen
class ShapeMeasures:
    """All that is known of one link's shape, and where each of it stands in the file, by key; the whole under ""."""

    link: str
    points: tuple[str, ...]
    measures: tuple[Measure, ...] = ()
    ccw: tuple[Triple, ...] = ()
    places: Mapping[str, Where] = field(default_factory=dict)

    @property
    def where(self) -> Where:
        return self.places[""]

    def place(self, key: str) -> Where:
        return self.places[key if key in self.places else ""]


def solve_shape(shape: ShapeMeasures) -> dict[str, complex]:
    """The points in the link's own axes [m]. Errors: see `graphkin.errors.mechanism`."""
    if len(shape.points) == 1:
        return {shape.points[0]: 0j}
    if len(shape.points) > MOST_POINTS:
        raise errors.TooManyPoints(shape.where, shape.link, MOST_POINTS)
    layouts = _LayoutSearch(shape, shape.ccw).first_two()
    if not layouts:
        raise _why_not_round(shape)
    if len(layouts) > 1:
        raise _what_is_open(shape, *layouts)
    return own_axes({point: layouts[0][point] for point in shape.points}, shape)


def own_axes(places: Places, shape: ShapeMeasures) -> dict[str, complex]:
    """The same figure with its first point in the origin and the next distinct one on +x."""
    origin = next(iter(places.values()))
    arms = {point: place - origin for point, place in places.items()}
    size = max(abs(arm) for arm in arms.values())
    axis = next((arm for arm in arms.values() if abs(arm) > 1e-9 * size), 0j)
    if axis == 0 and len(arms) > 1:
        raise errors.OneSpot(shape.where, shape.link)
    turn = axis.conjugate() / abs(axis) if axis.imag or axis.real < 0 else 1 + 0j
    return {point: complex(abs(arm), 0) if arm == axis else arm * turn for point, arm in arms.items()}


class _LayoutSearch:
    """All layouts that fulfil the measures and run the right way round, at most two of them."""

    def __init__(self, shape: ShapeMeasures, ccw: Sequence[Triple]) -> None:
        self.shape = shape
        self.ccw = ccw
        self.by_point: dict[str, list[Measure]] = {}
        for measure in shape.measures:
            for point in measure.points:
                self.by_point.setdefault(point, []).append(measure)
        self.trials = 0
        self.problem: GraphkinError | None = None
        self.stuck: tuple[str, ...] = ()

    def first_two(self) -> list[Places]:
        """Two layouts if there are so many, none if `ccw` forbids all. Raises if the measures are too few or contradict
        each other."""
        starts = [measure for measure in self.shape.measures if isinstance(measure, Length)]
        for start in starts:
            first, second = start.points
            complete = self._complete({first: 0j, second: complex(start.value)})
            if layouts := list(islice(complete, 2)):
                return layouts
            if self.problem is not None:
                raise self.problem
        if self.stuck or not starts:
            raise errors.TooFewMeasures(self.shape.where, self.shape.link, self.stuck or self.shape.points)
        return []

    def _complete(self, placed: Places) -> Iterator[Places]:
        """Every way to put down the points that are not placed yet."""
        self.trials += 1
        missing = tuple(point for point in self.shape.points if point not in placed)
        if not missing:
            yield placed
            return
        # the point with the fewest places, the first that has one only; None if the measures fix no point yet
        choice: tuple[str, list[complex]] | None = None
        for point in missing:
            places = self._candidates(point, placed)
            if places is not None and (choice is None or len(places) < len(choice[1])):
                choice = point, places
            if choice is not None and len(choice[1]) < 2:
                break
        if choice is None or self.trials > MOST_TRIALS:
            self.stuck = min(self.stuck or missing, missing, key=len)
            return
        point, places = choice
        for place in places:
            yield from self._complete({**placed, point: place})

    def _candidates(self, point: str, placed: Places) -> list[complex] | None:
        """The places at which the point can lie; None while fewer than two measures fix it."""
        measures = self.by_point.get(point, ())
        fixing = [each for each in measures if all(other in placed or other == point for other in each.points)]
        options = [measure.curves(point, placed) for measure in fixing]
        apart, crossed = 0.0, False
        for one, other in combinations(options[:MOST_CURVES], 2):
            places = [place for a in one for b in other for place in curve_crossings(a, b)]
            if good := self._fitting(point, places, fixing, placed):
                layouts = ((place, {**placed, point: place}) for place in good)
                return [place for place, layout in layouts  # those that run the right way round
                        if all(orientation(layout, t) > 0 for t in self.ccw if {*t} <= layout.keys())]  # fmt: skip
            if places and not crossed:
                crossed = True
                worst = self._worst(point, places, fixing, placed)
            apart = max(apart, min((gap(a, b) for a in one for b in other), default=0.0))
        if not crossed and apart <= ROUNDED * _size(placed):
            return None
        self.problem = self.problem or (worst if crossed else self._no_crossing(point, fixing, placed))
        return []

    def _fitting(self, point: str, places: list[complex], fixing: list[Measure], placed: Places) -> list[complex]:
        """Those of the places, each once, that all measures agree with."""
        good: list[complex] = []
        for place in places:
            layout = {**placed, point: place}
            allowed = ROUNDED * _size(layout)
            fits = all(measure.miss(layout) <= allowed for measure in fixing)
            if fits and all(abs(place - other) > allowed for other in good):
                good.append(place)
        return good

    def _worst(self, point: str, places: list[complex], fixing: list[Measure], placed: Places) -> errors.Contradiction:
        """Of the best layout, the measure that is furthest off."""
        layouts = [{**placed, point: place} for place in places]
        best = min(layouts, key=lambda layout: max(measure.miss(layout) for measure in fixing))
        worst = max(fixing, key=lambda measure: measure.miss(best))
        return errors.Contradiction(self.shape.place(worst.key), self.shape.link, worst.key, worst.miss(best) * 1e3)

    def _no_crossing(self, point: str, fixing: list[Measure], placed: Places) -> GraphkinError:
        """The two measures that leave least place for the point."""

        def apart(pair: tuple[Measure, Measure]) -> float:
            one, other = (measure.curves(point, placed) for measure in pair)
            return min((gap(a, b) for a in one for b in other), default=0.0)

        one, other = max(combinations(fixing, 2), key=apart)
        last = max(one, other, key=lambda measure: self.shape.place(measure.key).line or 0)
        gap_mm = apart((one, other)) * 1e3
        if isinstance(one, Length) and isinstance(other, Length):
            a, b = (next(end for end in length.points if end != point) for length in (one, other))
            base = next((measure.key for measure in self.shape.measures if set(measure.points) == {a, b}), a + b)
            return errors.NoTriangle(self.shape.place(last.key), (base, one.key, other.key), gap_mm)
        return errors.Contradiction(self.shape.place(last.key), self.shape.link, last.key, gap_mm)


def _size(layout: Places) -> float:
    places = list(layout.values())
    return max(abs(place - places[0]) for place in places)


def orientation(layout: Places, triple: Sequence[str], least: float = 1e-9) -> int:
    """1 if the three points run counter-clockwise, -1 if clockwise, 0 on one line; least: the sine under which they
    are."""
    a, b, c = (layout[point] for point in triple)
    area = ((b - a).conjugate() * (c - a)).imag
    sides = abs(b - a) * abs(c - a)
    return 0 if abs(area) <= least * sides else int(math.copysign(1, area))


def check_round(shape: ShapeMeasures, places: Places) -> None:
    """Raise an error where coordinates do not run the way round that `ccw` says."""
    for number, triple in enumerate(shape.ccw):
        turn = orientation(places, triple)
        if turn != 1:
            raise (errors.CcwContradicts if turn else errors.CcwOnLine)(shape.place(f"ccw {number}"), triple)


def _why_not_round(shape: ShapeMeasures) -> GraphkinError:
    """No layout runs the way `ccw` says: which triple cannot."""
    layouts = _LayoutSearch(shape, ()).first_two()
    for number, triple in enumerate(shape.ccw):
        where = shape.place(f"ccw {number}")
        if all(orientation(layout, triple) == 0 for layout in layouts):
            return errors.CcwOnLine(where, triple)
    done: list[Triple] = []
    for number, triple in enumerate(shape.ccw):
        done.append(triple)
        if not _LayoutSearch(shape, done).first_two():
            return errors.CcwContradicts(shape.place(f"ccw {number}"), triple)
    return errors.CcwContradicts(shape.where, shape.ccw[-1])


def _what_is_open(shape: ShapeMeasures, one: Places, other: Places) -> GraphkinError:
    """Two layouts are left: either some triple tells them apart, or measures are lacking."""
    for a, b, c in combinations(shape.points, 3):
        turns = orientation(one, (a, b, c)), orientation(other, (a, b, c))
        if turns[0] != turns[1] and 0 not in turns:
            return errors.MissingCcw(shape.where, (a, b, c))
    moved = tuple(p for p in shape.points if abs(one[p] - other[p]) > ROUNDED * _size(one))
    return errors.TooFewMeasures(shape.where, shape.link, moved)


def _equal_angles(a: complex, b: complex, angle: float) -> list[Curve]:
    """The points that see the stretch ab under an angle."""
    if a == b:
        return []
    if math.sin(angle) < 1e-9:
        return [StraightLine(a, (b - a) / abs(b - a))]
    offset = (b - a) / 2j / math.tan(angle)
    return [CircleCurve((a + b) / 2 + side * offset, abs(b - a) / 2 / math.sin(angle)) for side in (1, -1)]


def curve_crossings(one: Curve, other: Curve) -> list[complex]:
    """The points two curves share: none, one or two; none if they coincide."""
    if isinstance(one, CircleCurve):
        return _two_circles(one, other) if isinstance(other, CircleCurve) else _line_and_circle(other, one)
    return _line_and_circle(one, other) if isinstance(other, CircleCurve) else _two_lines(one, other)


def gap(one: Curve, other: Curve) -> float:
    """The distance of two curves that do not cross; 0 if they coincide."""
    if isinstance(one, StraightLine):
        return one.distance(other.point) if isinstance(other, StraightLine) else gap(other, one)
    if isinstance(other, StraightLine):
        return max(other.distance(one.centre) - one.radius, 0.0)
    apart = abs(one.centre - other.centre)
    return max(apart - one.radius - other.radius, abs(one.radius - other.radius) - apart, 0.0)


def _two_circles(one: CircleCurve, other: CircleCurve) -> list[complex]:
    between = other.centre - one.centre
    apart = abs(between)
    size = max(apart, one.radius, other.radius)
    if apart <= TOUCHES * size:
        return []
    along = between / apart
    outside = apart - one.radius - other.radius
    inside = abs(one.radius - other.radius) - apart
    if max(outside, inside) > TOUCHES * size:
        return []
    if abs(outside) <= TOUCHES * size:
        return [one.centre + one.radius * along]
    if abs(inside) <= TOUCHES * size:
        return [one.centre + (one.radius if one.radius > other.radius else -one.radius) * along]
    foot = (apart + (one.radius - other.radius) * (one.radius + other.radius) / apart) / 2
    height = math.sqrt(max((one.radius - foot) * (one.radius + foot), 0.0))
    return [one.centre + along * complex(foot, side * height) for side in (1, -1)]


def _line_and_circle(line: StraightLine, circle: CircleCurve) -> list[complex]:
    offset = (circle.centre - line.point) * line.along.conjugate()
    foot = line.point + offset.real * line.along
    room = circle.radius - abs(offset.imag)
    if abs(room) <= TOUCHES * circle.radius:
        return [foot]
    if room < 0:
        return []
    half = math.sqrt(room * (circle.radius + abs(offset.imag)))
    return [foot + half * line.along, foot - half * line.along]


def _two_lines(one: StraightLine, other: StraightLine) -> list[complex]:
    sine = (one.along.conjugate() * other.along).imag
    if abs(sine) <= TOUCHES:
        return []
    reach = ((other.point - one.point) * other.along.conjugate()).imag / -sine
    return [one.point + reach * one.along]
