"""The positions of a sweep, as far as the mechanism gets: `--driver AB=0:360:10` read, and laid along a path.

The values are a text, a number, or an array of numbers.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property, partial

import numpy as np

from graphkin.base.geometry import Real, number
from graphkin.base.scales import multiples, round_step
from graphkin.base.value import bulky, frozen
from graphkin.errors import BadRange, BadValues, GivenTwice, NoPosition, NoSuchDriver, Where
from graphkin.files.values import LARGEST, UNITS, quantity_at
from graphkin.model.mechanism import Dimension, Driver
from graphkin.model.naming import driver_number
from graphkin.model.quantities import EDGE, driven
from graphkin.planning import Method
from graphkin.running.other_positions import reached
from graphkin.running.path import DriverPath, Event, along
from graphkin.running.tracing import trace

Ranges = Sequence[str] | Mapping[str, object] | np.ndarray | Sequence[float]
"""Texts as on the command line; or by driver a text, a number, numbers [deg, mm]; or numbers for the first driver."""
TURN = 2 * math.pi
WHERE = Where("--driver")
MOST_TURNS, MOST_STEPS = 1000, 1e7
_SHORT_OF_STOP = 1e-3  # the distance from a dead point at which a motion ends [of the path between two of them]
SEEN = 6  # turns after which a mechanism is looked for where it was
ROWS = 36  # rows of a table over the reachable range of a slide, and over a turn


@frozen
class DriverValues:
    """The values of a driver [rad, m], from the first to the last; one that is held has one value."""

    values: np.ndarray
    begin: float
    end: float
    moves: bool
    listed: bool = False

    @classmethod
    def held(cls, value: float) -> DriverValues:
        return cls(np.array([value]), value, value, False)


def given_ranges(method: Method, ranges: Ranges) -> dict[int, DriverValues]:
    """The values of each driver for which a range is given."""
    spans: dict[int, DriverValues] = {}
    for name, span, written in _each_range(ranges):
        number = driver_number(method.mechanism, name) if name else first_free(method, spans)
        if number is None:
            names = tuple(driver.name for driver in method.drivers) if name else ()
            raise NoSuchDriver(WHERE, name or written(), names)
        if number in spans:
            raise GivenTwice(WHERE, method.drivers[number].name)
        dimension: Dimension = "length" if method.drivers[number].kind == "slide" else "angle"
        read = _from_text(dimension, span, written) if isinstance(span, str) else _listed(dimension, span, written)
        spans[number] = read
    return spans


def first_free(method: Method, ranged: Collection[int]) -> int | None:
    """The first driver that moves of those without a range; None where there is none left."""
    free = [k for k in range(len(method.drivers)) if k not in ranged]
    return next((k for k in free if method.drivers[k].rate), free[0] if free else None)


def aligned(method: Method, spans: dict[int, DriverValues], moving: list[int]) -> dict[int, DriverValues]:
    """Several drivers go along one straight line: where values are listed, from the least of the first driver's on."""
    if not any(spans[k].listed for k in moving):
        return spans
    first = spans[moving[0]].values
    low, high = int(np.argmin(first)), int(np.argmax(first))
    if first[high] == first[low]:
        raise BadValues(WHERE, method.drivers[moving[0]].name)
    part = (first - first[low]) / (first[high] - first[low])
    straight = dict(spans)
    for k in moving:
        values = spans[k].values
        begin, end = float(values[low]), float(values[high])
        if not np.allclose(values, begin + (end - begin) * part, rtol=0, atol=1e-9 * max(abs(begin), abs(end))):
            raise BadValues(WHERE, method.drivers[k].name)
        straight[k] = DriverValues(values, begin, end, True, True)
    return straight


Written = Callable[[], str]
"""A range as it was written: long arrays are only written where something is wrong with them."""


def _each_range(ranges: Ranges) -> Iterator[tuple[str, object, Written]]:
    """Each range with its driver's name, "" where none is given, and as it was written."""

    def shortened(span: object, name: str = "") -> str:
        return f"{name}{span}"[:60]

    if not isinstance(ranges, str | Mapping | Sequence) and not np.ndim(ranges):
        raise BadValues(WHERE, shortened(ranges))
    if isinstance(ranges, Mapping):
        yield from ((name, span, partial(shortened, span, f"{name}=")) for name, span in ranges.items())
    elif not isinstance(ranges, str) and any(not isinstance(each, str) for each in ranges):
        several = ranges if np.ndim(ranges[0]) else [ranges]
        yield from (("", span, partial(shortened, span)) for span in several)
    else:
        for text in [ranges] if isinstance(ranges, str) else ranges:
            name, _, span = str(text).rpartition("=")
            yield name.strip(), span, partial(str, text)


def _listed(dimension: Dimension, span: object, written: Written) -> DriverValues:
    """Values from a number, or from numbers, in the units of plain numbers."""
    try:
        numbers = np.asarray(span, dtype=float)
    except (TypeError, ValueError):
        raise BadValues(WHERE, written()) from None
    times, divided = next(iter(UNITS[dimension].values()))
    values = numbers * times / divided
    far = MOST_TURNS * TURN if dimension == "angle" else LARGEST
    if values.ndim > 1 or not values.size or values.size > MOST_STEPS or not np.all(np.abs(values) <= far):
        raise BadValues(WHERE, written())
    if not values.ndim:
        return DriverValues.held(float(values.flat[0]))
    return DriverValues(values, float(values.min()), float(values.max()), True, True)


def _from_text(dimension: Dimension, span: str, written: Written) -> DriverValues:
    """Values from `begin:end:step`, `begin:end`, or one value that is held."""
    numbers = [quantity_at(WHERE, dimension, part) for part in span.split(":")]
    if len(numbers) == 1:
        return DriverValues.held(numbers[0])
    if len(numbers) == 2:
        numbers.append(abs(numbers[1] - numbers[0]) / ROWS)
    if len(numbers) == 3 and numbers[1] < numbers[0]:
        numbers[2] = abs(numbers[2])
    if len(numbers) != 3 or numbers[0] == numbers[1] or not numbers[2] > 0:
        raise BadRange(WHERE, written())
    begin, end, step = numbers
    far = MOST_TURNS * TURN if dimension == "angle" else math.inf
    if abs(end - begin) > min(far, MOST_STEPS * step) or max(map(abs, numbers)) > far:
        raise BadRange(WHERE, written())
    count = math.floor(abs(end - begin) / step + 1e-9)
    return DriverValues(begin + math.copysign(step, end - begin) * np.arange(count + 1), begin, end, True)


@bulky
class Course:
    """A mechanism moved along a path, and the chosen positions on it.

    swept   number of the driver by whose value positions are named
    t       of the positions on the path (n,)
    values  of the swept driver there, as the ranges have them (n,) [rad, m]
    dropped values of the swept driver in the ranges that are not reached [rad, m]
    compiled  as `ReplayProgram.run` has it; None: by the number of positions
    """

    method: Method
    path: DriverPath
    swept: int
    t: np.ndarray
    values: np.ndarray
    dropped: np.ndarray
    compiled: bool | None = None

    @property
    def driver(self) -> Driver:
        return self.method.drivers[self.swept]

    @property
    def angular(self) -> bool:
        """True if positions are named by an angle, else by a displacement."""
        return self.driver.kind != "slide"

    @property
    def unit(self) -> str:
        """SI unit of the swept driver's values."""
        return driven(not self.angular)

    def evenly(self, count: int, turns: int) -> list[float]:
        """Places on the path in the order of the motion, evenly: so many turns, so many places each; of none there and
        back."""
        sense = -1.0 if self.driver.rate < 0 else 1.0
        if turns:
            return [sense * float(t) for t in np.arange(turns * count) * (TURN / count)]
        short = _SHORT_OF_STOP * (self.path.last - self.path.first)
        low, high = self.path.first + short, self.path.last - short
        ends = [0.0, high, low, 0.0] if sense > 0 else [0.0, low, high, 0.0]
        passed = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(ends)))])
        return [float(t) for t in np.interp(np.arange(count) * (passed[-1] / count), passed, ends)]

    def value(self, t: Real) -> Real:
        """The swept driver's value [rad, m]."""
        return self.path.start[self.swept] + self.path.pace[self.swept] * t

    def at(self, value: Real) -> Real:
        """The t on the path at which the swept driver has a value."""
        return (value - self.path.start[self.swept]) / self.path.pace[self.swept]

    @cached_property
    def reach(self) -> tuple[float, float]:
        """The least and the greatest value of the swept driver on the path [rad, m]."""
        ends = number(self.value(self.path.first)), number(self.value(self.path.last))
        return min(ends), max(ends)

    @property
    def stops(self) -> tuple[Event, ...]:
        """Dead points at which the path ends, in the order of the swept driver's values."""
        return tuple(sorted(self.path.stops, key=lambda stop: number(self.value(stop.at))))

    @property
    def changes(self) -> tuple[Event, ...]:
        """Change points among the positions, in the order of the swept driver's values."""
        margin = 1e-9 * (self.path.high - self.path.low)
        low, high = float(self.t.min()) - margin, float(self.t.max()) + margin
        return tuple(sorted((c for c in self.path.changes if low <= c.at <= high), key=lambda change: change.at))

    @property
    def full_turn(self) -> bool:
        """True if the swept driver goes all round."""
        return self.angular and not self.path.stops

    @cached_property
    def on(self) -> Course:
        """The same from the drawn position on through as many turns as are looked at, in the driver's sense."""
        low, high = (-TURN, SEEN * TURN) if self.driver.rate >= 0 else (-SEEN * TURN, TURN)
        return replace(self, path=trace(self.method, self.path.pace, low, high, (self.path, 0.0)))

    def turns(self, *points: str) -> int:
        """After so many full turns of the driver these points, or all, go their ways again; 0 of more than `SEEN`, and
        where it does not turn fully."""
        return (self._turns(points, 1) or self.on._turns(points, SEEN)) if self.full_turn else 0

    def _turns(self, points: tuple[str, ...], most: int) -> int:
        t = math.copysign(TURN, self.driver.rate or 1.0) * (np.arange(most + 1)[:, None] - np.array([0.02, 0.15, 0.4]))
        positions = along(self.method, self.path, t).position
        places = [np.broadcast_to(positions[point], t.shape) for point in points or self.method.mechanism.points]
        off = np.max([np.abs(place[1:] - place[0]) for place in places], axis=(0, 2))
        return next((int(k) + 1 for k in np.flatnonzero(off < 1e-7 * self.method.size)), 0)


def course(method: Method, ranges: Ranges = ()) -> Course:
    """The path that a sweep takes.

    ranges   `0:360:10`, `AB=0:360:10`, `ram=50 mm:90 mm:5 mm`, or `DH=90`: for each driver named, or in their order.
             None: the first driver that moves, a full turn or as far as it gets; the others keep pace with it.
             From a program also by name, `{"AB": np.linspace(0, 360, 361), "ram": 80}`, or an array for the first
             driver: deg and mm as in the file, in any order; what is one number holds its driver still.

    Raises BadRange, NoSuchDriver, NotReached; NoPosition where none of the positions is reached.
    """
    spans = given_ranges(method, ranges)
    moving = [k for k, span in spans.items() if span.moves]
    if not method.drivers:
        raise NoSuchDriver(method.mechanism.where("driver"), "", ())
    if moving and len(spans) > 1:
        return _together(method, spans, moving)
    held = {k: span.begin for k, span in spans.items() if not span.moves}
    before = None
    if held:
        before = reached(method, [held.get(k, value) for k, value in enumerate(method.facts(None).values)])
    swept = moving[0] if moving else first_free(method, spans)
    if swept is None:
        raise BadRange(WHERE, ", ".join(map(str, ranges)))
    return _over(method, swept, _pace(method, swept, tuple(held)), spans[swept] if moving else None, before)


def course_from(method: Method, values: Sequence[float] | None = None) -> Course:
    """The usual course, on through other driver values than the drawn ones [rad, m]. Raises NotReached."""
    if values is None or not method.drivers:
        return course(method)
    swept = first_free(method, ()) or 0
    return _over(method, swept, _pace(method, swept, ()), None, reached(method, list(values)))


def _pace(method: Method, swept: int, still: tuple[int, ...]) -> tuple[float, ...]:
    """The pace of all drivers: in proportion to their speeds; all but the swept one stand where it has no speed."""
    rate = method.drivers[swept].rate
    paces = [0.0 if k in still or not rate else driver.rate / rate for k, driver in enumerate(method.drivers)]
    paces[swept] = 1.0
    return tuple(paces)


def _over(
    method: Method, swept: int, pace: tuple[float, ...], span: DriverValues | None,
    before: tuple[DriverPath, float] | None,
) -> Course:  # fmt: skip
    """The course of one driver, and of those that keep pace with it, through the drawn position or on from `before`."""
    driver = method.drivers[swept]
    start = number(before[0].values(before[1])[swept]) if before else float(method.facts(None).values[swept])
    if driver.kind == "slide":
        usual = start - 2 * method.size, start + 2 * method.size
    else:
        usual = min(start - TURN, 0.0), max(start + TURN, TURN)
    ends = (*usual, span.begin, span.end) if span else usual
    path = trace(method, pace, min(ends) - start, max(ends) - start, before)
    values = span.values if span else _usual(method, driver, path, swept)
    t = values - start
    if path.stops and driver.kind != "slide" and not method.structure.contacts and sum(map(bool, path.pace)) == 1:
        # positions whole turns away are the same ones
        t = np.where(path.leads_to(t), t, t - TURN * np.round((t - (path.first + path.last) / 2) / TURN))
    return _as_far_as_reached(Course(method, path, swept, t, values, values[:0]))


def _as_far_as_reached(whole: Course) -> Course:
    """The course without the positions that are not reached; most often all are, and no array is copied."""
    on_path = np.broadcast_to(whole.path.leads_to(whole.t), whole.t.shape)
    if on_path.all():
        return whole
    if on_path.any():
        return replace(whole, t=whole.t[on_path], values=whole.values[on_path], dropped=whole.values[~on_path])
    low, high = map(EDGE[whole.unit].shown, whole.reach)
    raise NoPosition(whole.method.mechanism.where("driver", whole.swept), whole.driver.name, low, high)


def _usual(method: Method, driver: Driver, path: DriverPath, swept: int) -> np.ndarray:
    """Every 10 degrees of a turn, or of what is reached; of a slide's range, some forty round values."""
    low, high = path.start[swept] + path.first, path.start[swept] + path.last
    if driver.kind == "slide":
        step = round_step((high - low) / ROWS, up=True)
    elif not path.stops:
        return multiples(0.0, TURN, math.radians(10))
    else:
        step = math.radians(10)
        while (high - low) / step < 12:
            step /= 2
    values, margin = multiples(low, high, step), 1e-9 * (high - low)
    return values[(values > low + margin) & (values < high - margin)]


def _together(method: Method, spans: dict[int, DriverValues], moving: list[int]) -> Course:
    """Drivers that go from one value to another at once, from where they begin; others stand."""
    swept = moving[0]
    counts = {spans[k].values.size for k in moving}
    if len(counts) > 1:
        raise BadRange(WHERE, ", ".join(str(count) for count in sorted(counts)))
    spans = aligned(method, spans, moving)
    begin = [spans[k].begin if k in spans else value for k, value in enumerate(method.facts(None).values)]
    t, length = spans[swept].values - spans[swept].begin, spans[swept].end - spans[swept].begin
    paces = [(spans[k].end - spans[k].begin) / length if k in moving else 0.0 for k in range(len(begin))]
    path = trace(method, paces, min(0.0, float(t.min())), max(0.0, float(t.max())), reached(method, begin))
    values = t + spans[swept].begin
    return _as_far_as_reached(Course(method, path, swept, t, values, values[:0]))
