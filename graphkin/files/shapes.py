"""From a link's lengths and angles to the places of its points, as one would lay it out with compass and protractor.

Two points with a known distance are put down first. Then every further point is put where two curves cross: a
length is a circle about a placed point, an angle at a placed point is a line through it, an angle at the new
point is the circle of equal angles over two placed ones. Mirror images are told apart by `ccw`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field
from itertools import combinations, islice

from graphkin.base.tolerances import ROUNDED
from graphkin.base.value import frozen
from graphkin.errors import (
    CcwContradicts,
    CcwOnLine,
    Contradiction,
    GraphkinError,
    MissingCcw,
    NoTriangle,
    OneSpot,
    TooFewMeasures,
    TooManyPoints,
    Where,
)
from graphkin.files.curves import Length, Measure, Places, Triple, crossings, gap

MOST_POINTS = 50
"""Links of more points than this need coordinates."""

MOST_TRIALS = 300
"""Partial layouts looked at before the search for a shape is given up."""

MOST_CURVES = 20
"""Of more curves than this for one point, the first are crossed and the others only held against the result."""


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


def solve_shape(given: ShapeMeasures) -> dict[str, complex]:
    """The points in the link's own axes [m]. Errors: see `graphkin.errors.shapes`."""
    if len(given.points) == 1:
        return {given.points[0]: 0j}
    if len(given.points) > MOST_POINTS:
        raise TooManyPoints(given.where, given.link, MOST_POINTS)
    found = _LayoutSearch(given, given.ccw).first_two()
    if not found:
        raise _why_not_round(given)
    if len(found) > 1:
        raise _what_is_open(given, *found)
    return own_axes({point: found[0][point] for point in given.points}, given)


def own_axes(places: Places, given: ShapeMeasures) -> dict[str, complex]:
    """The same figure with its first point in the origin and the next distinct one on +x."""
    origin = next(iter(places.values()))
    arms = {point: place - origin for point, place in places.items()}
    size = max(abs(arm) for arm in arms.values())
    axis = next((arm for arm in arms.values() if abs(arm) > 1e-9 * size), 0j)
    if axis == 0 and len(arms) > 1:
        raise OneSpot(given.where, given.link)
    turn = axis.conjugate() / abs(axis) if axis.imag or axis.real < 0 else 1 + 0j
    return {point: complex(abs(arm), 0) if arm == axis else arm * turn for point, arm in arms.items()}


class _LayoutSearch:
    """All layouts that fulfil the measures and run the right way round, at most two of them."""

    def __init__(self, given: ShapeMeasures, ccw: Sequence[Triple]) -> None:
        self.given = given
        self.ccw = ccw
        self.by_point: dict[str, list[Measure]] = {}
        for measure in given.measures:
            for point in measure.points:
                self.by_point.setdefault(point, []).append(measure)
        self.trials = 0
        self.problem: GraphkinError | None = None
        self.stuck: tuple[str, ...] = ()

    def first_two(self) -> list[Places]:
        """Two layouts if there are so many, none if `ccw` forbids all.

        Raises if the measures are too few or contradict each other.
        """
        starts = [measure for measure in self.given.measures if isinstance(measure, Length)]
        for start in starts:
            first, second = start.points
            complete = self._complete({first: 0j, second: complex(start.value)})
            if found := list(islice(complete, 2)):
                return found
            if self.problem is not None:
                raise self.problem
        if self.stuck or not starts:
            raise TooFewMeasures(self.given.where, self.given.link, self.stuck or self.given.points)
        return []

    def _complete(self, placed: Places) -> Iterator[Places]:
        """Every way to put down the points that are not placed yet."""
        self.trials += 1
        missing = tuple(point for point in self.given.points if point not in placed)
        if not missing:
            yield placed
            return
        choice = self._clearest(missing, placed)
        if choice is None or self.trials > MOST_TRIALS:
            self.stuck = min(self.stuck or missing, missing, key=len)
            return
        point, found = choice
        for place in found:
            yield from self._complete({**placed, point: place})

    def _clearest(self, missing: Sequence[str], placed: Places) -> tuple[str, list[complex]] | None:
        """The point with the fewest places, the first that has one only; None if no point has any telling."""
        best: tuple[str, list[complex]] | None = None
        for point in missing:
            found = self._candidates(point, placed)
            if found is not None and (best is None or len(found) < len(best[1])):
                best = point, found
            if best is not None and len(best[1]) < 2:
                break
        return best

    def _candidates(self, point: str, placed: Places) -> list[complex] | None:
        """Where the point can lie; None while fewer than two measures tell."""
        telling = self._telling(point, placed)
        options = [measure.curves(point, placed) for measure in telling]
        apart, crossed = 0.0, False
        for one, other in combinations(options[:MOST_CURVES], 2):
            places = [place for a in one for b in other for place in crossings(a, b)]
            if good := self._fitting(point, places, telling, placed):
                return [place for place in good if self._right_way_round({**placed, point: place})]
            if places and not crossed:
                crossed = True
                worst = self._worst(point, places, telling, placed)
            apart = max(apart, min((gap(a, b) for a in one for b in other), default=0.0))
        if not crossed and apart <= ROUNDED * _size(placed):
            return None
        self.problem = self.problem or (worst if crossed else self._no_crossing(point, telling, placed))
        return []

    def _telling(self, point: str, placed: Places) -> list[Measure]:
        """The measures whose only point not placed is this one."""
        return [
            measure
            for measure in self.by_point.get(point, ())
            if all(other in placed or other == point for other in measure.points)
        ]

    def _fitting(self, point: str, places: list[complex], telling: list[Measure], placed: Places) -> list[complex]:
        """Those of the places, each once, that all measures agree with."""
        good: list[complex] = []
        for place in places:
            layout = {**placed, point: place}
            allowed = ROUNDED * _size(layout)
            fits = all(measure.miss(layout) <= allowed for measure in telling)
            if fits and all(abs(place - other) > allowed for other in good):
                good.append(place)
        return good

    def _right_way_round(self, layout: Places) -> bool:
        placed = (triple for triple in self.ccw if all(point in layout for point in triple))
        return all(orientation(layout, triple) > 0 for triple in placed)

    def _worst(self, point: str, places: list[complex], telling: list[Measure], placed: Places) -> Contradiction:
        """Of the best layout, the measure that is furthest off."""
        layouts = [{**placed, point: place} for place in places]
        best = min(layouts, key=lambda layout: max(measure.miss(layout) for measure in telling))
        worst = max(telling, key=lambda measure: measure.miss(best))
        return Contradiction(self.given.place(worst.key), self.given.link, worst.key, worst.miss(best) * 1e3)

    def _no_crossing(self, point: str, telling: list[Measure], placed: Places) -> GraphkinError:
        """The two measures that leave least place for the point."""

        def apart(pair: tuple[Measure, Measure]) -> float:
            one, other = (measure.curves(point, placed) for measure in pair)
            return min((gap(a, b) for a in one for b in other), default=0.0)

        one, other = max(combinations(telling, 2), key=apart)
        last = max(one, other, key=lambda measure: self._line(measure.key))
        gap_mm = apart((one, other)) * 1e3
        if isinstance(one, Length) and isinstance(other, Length):
            a, b = (next(end for end in length.points if end != point) for length in (one, other))
            return NoTriangle(self.given.place(last.key), (self._key(a, b), one.key, other.key), gap_mm)
        return Contradiction(self.given.place(last.key), self.given.link, last.key, gap_mm)

    def _line(self, key: str) -> int:
        return self.given.place(key).line or 0

    def _key(self, a: str, b: str) -> str:
        """The distance ab as the file writes it, if it does."""
        return next((m.key for m in self.given.measures if set(m.points) == {a, b}), a + b)


def _size(layout: Places) -> float:
    places = list(layout.values())
    return max(abs(place - places[0]) for place in places)


def orientation(layout: Places, triple: Sequence[str]) -> int:
    """1 if the three points run counter-clockwise, -1 if clockwise, 0 on one line."""
    a, b, c = (layout[point] for point in triple)
    area = ((b - a).conjugate() * (c - a)).imag
    sides = abs(b - a) * abs(c - a)
    return 0 if abs(area) <= 1e-9 * sides else int(math.copysign(1, area))


def check_round(given: ShapeMeasures, places: Places) -> None:
    """Whether given coordinates run the way `ccw` says."""
    for number, triple in enumerate(given.ccw):
        turn = orientation(places, triple)
        if turn != 1:
            raise (CcwContradicts if turn else CcwOnLine)(given.place(f"ccw {number}"), triple)


def _why_not_round(given: ShapeMeasures) -> GraphkinError:
    """No layout runs the way `ccw` says: which triple cannot."""
    layouts = _LayoutSearch(given, ()).first_two()
    for number, triple in enumerate(given.ccw):
        where = given.place(f"ccw {number}")
        if all(orientation(layout, triple) == 0 for layout in layouts):
            return CcwOnLine(where, triple)
    done: list[Triple] = []
    for number, triple in enumerate(given.ccw):
        done.append(triple)
        if not _LayoutSearch(given, done).first_two():
            return CcwContradicts(given.place(f"ccw {number}"), triple)
    return CcwContradicts(given.where, given.ccw[-1])


def _what_is_open(given: ShapeMeasures, one: Places, other: Places) -> GraphkinError:
    """Two layouts are left: either some triple tells them apart, or measures are lacking."""
    for a, b, c in combinations(given.points, 3):
        turns = orientation(one, (a, b, c)), orientation(other, (a, b, c))
        if turns[0] != turns[1] and 0 not in turns:
            return MissingCcw(given.where, (a, b, c))
    moved = tuple(p for p in given.points if abs(one[p] - other[p]) > ROUNDED * _size(one))
    return TooFewMeasures(given.where, given.link, moved)
