"""What moves in a sweep, and how far it gets: `--driver 0:360:10` made into positions."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property

import numpy as np

from graphkin.base.geometry import Value
from graphkin.base.value import frozen
from graphkin.errors import BadRange, NoPosition, NoSuchDriver
from graphkin.model.mechanism import Driver
from graphkin.model.quantities import EDGE, driven
from graphkin.planning import Method
from graphkin.running.other_positions import reached
from graphkin.running.path import DriverPath, Event
from graphkin.running.tracing import trace
from graphkin.studies.sweeps.ranges import (
    ROWS,
    TURN,
    WHERE,
    DriverValues,
    Ranges,
    first_free,
    given_ranges,
    in_proportion,
)


@frozen
class Course:
    """A mechanism moved along a path, and the positions asked for on it.

    swept   number of the driver by whose value positions are named
    t       where on the path the positions are (n,)
    values  of the swept driver there, as they were asked for (n,) [rad, m]
    dropped values of the swept driver that were asked for and are not reached [rad, m]
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
        """Whether positions are named by an angle, else by a displacement."""
        return self.driver.kind != "slide"

    @property
    def unit(self) -> str:
        """SI unit of the swept driver's values."""
        return driven(not self.angular)

    def value(self, t: Value) -> Value:
        """The swept driver's value [rad, m]."""
        return self.path.start[self.swept] + self.path.pace[self.swept] * t

    def at(self, value: Value) -> Value:
        """Where on the path the swept driver has a value."""
        return (value - self.path.start[self.swept]) / self.path.pace[self.swept]

    @cached_property
    def reach(self) -> tuple[float, float]:
        """The least and the greatest value of the swept driver on the path [rad, m]."""
        ends = self.value(self.path.first), self.value(self.path.last)
        return min(ends), max(ends)

    @property
    def stops(self) -> tuple[Event, ...]:
        """Dead points at which the path ends, in the order of the swept driver's values."""
        return tuple(sorted(self.path.stops, key=lambda stop: float(self.value(stop.at))))

    @property
    def changes(self) -> tuple[Event, ...]:
        """Change points among the positions, in the order of the swept driver's values."""
        margin = 1e-9 * (self.path.high - self.path.low)
        low, high = float(self.t.min()) - margin, float(self.t.max()) + margin
        return tuple(sorted((c for c in self.path.changes if low <= c.at <= high), key=lambda change: change.at))

    @property
    def full_turn(self) -> bool:
        """Whether the swept driver goes all round."""
        return self.angular and not self.path.stops

    def fine(self, count: int) -> np.ndarray:
        """t at `count` positions evenly over what is asked for, as far as it is reached."""
        low, high = (float(self.t.min()), float(self.t.max())) if self.t.size else (self.path.first, self.path.last)
        return np.linspace(low, high, count)


def course(method: Method, ranges: Ranges = ()) -> Course:
    """The path that a sweep takes.

    ranges   `0:360:10`, `AB=0:360:10`, `ram=50 mm:90 mm:5 mm`, or `DH=90`: for each driver named, or in their order.
             None: the first driver that moves, a full turn or as far as it gets; the others keep pace with it.
             From a program also by name, `{"AB": np.linspace(0, 360, 361), "ram": 80}`, or an array for the first
             driver: deg and mm as in the file, in any order; what is one number holds its driver still.

    Raises BadRange, NoSuchDriver, NotReached; NoPosition where none of the positions is reached.
    """
    given = given_ranges(method, ranges)
    moving = [k for k, wanted in given.items() if wanted.moves]
    if not method.drivers:
        raise NoSuchDriver(method.mechanism.where("driver"), "", ())
    if moving and len(given) > 1:
        return _together(method, given, moving)
    before = _moved(method, given)
    swept = moving[0] if moving else first_free(method, given)
    if swept is None:
        raise BadRange(WHERE, ", ".join(map(str, ranges)))
    pace = _pace(method, swept, tuple(given) if before is not None else ())
    return _over(method, swept, pace, given[swept] if moving else None, before)


def course_from(method: Method, values: Sequence[float] | None = None) -> Course:
    """The usual course, on through other driver values than the drawn ones [rad, m]. Raises NotReached."""
    if values is None or not method.drivers:
        return course(method)
    swept = first_free(method, ()) or 0
    return _over(method, swept, _pace(method, swept, ()), None, reached(method, list(values)))


def _pace(method: Method, swept: int, still: tuple[int, ...]) -> tuple[float, ...]:
    """The others keep pace with the swept driver as their speeds are; all stand still where it has none."""
    rate = method.drivers[swept].rate
    paces = [0.0 if k in still or not rate else driver.rate / rate for k, driver in enumerate(method.drivers)]
    paces[swept] = 1.0
    return tuple(paces)


# --- one driver, and those that keep pace with it ---------------------------------------------


def _over(
    method: Method,
    swept: int,
    pace: tuple[float, ...],
    wanted: DriverValues | None,
    before: tuple[DriverPath, float] | None,
) -> Course:
    start = float(before[0].values(before[1])[swept]) if before else float(method.facts(None).values[swept])
    driver = method.drivers[swept]
    low, high = _ends(method, driver, start, wanted)
    path = trace(method, pace, low - start, high - start, before)
    values = wanted.values if wanted else _usual(method, driver, path, swept)
    t, there = _turned_back(method, path, driver, values - start)
    return _of_those(Course(method, path, swept, t, values, values[:0]), there)


def _of_those(whole: Course, there: np.ndarray) -> Course:
    """The course without the positions that are not reached; most often all are, and no array is copied."""
    if there.all():
        return whole
    found = replace(whole, t=whole.t[there], values=whole.values[there], dropped=whole.values[~there])
    if not there.any():
        raise _none(found)
    return found


def _ends(method: Method, driver: Driver, start: float, wanted: DriverValues | None) -> tuple[float, float]:
    """How far to look: a turn to either side, or as far as a slide of the mechanism's size may go; farther if asked."""
    if driver.kind == "slide":
        usual = start - 2 * method.size, start + 2 * method.size
    else:
        usual = min(start - TURN, 0.0), max(start + TURN, TURN)
    asked = (wanted.begin, wanted.end) if wanted else ()
    return min((usual[0], *asked)), max((usual[1], *asked))


def _turned_back(method: Method, path: DriverPath, driver: Driver, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Positions whole turns away are the same ones, where nothing rolls; and which of all are reached."""
    turns_alike = driver.kind != "slide" and not method.structure.contacts and sum(map(bool, path.pace)) == 1
    if turns_alike and path.stops:
        middle = (path.first + path.last) / 2
        turned = t - TURN * np.round((t - middle) / TURN)
        t = np.where(path.leads_to(t), t, turned)
    return t, np.broadcast_to(path.leads_to(t), t.shape)


def _usual(method: Method, driver: Driver, path: DriverPath, swept: int) -> np.ndarray:
    """Every 10 degrees of a turn, or of what is reached; of a slide's range, some forty round values."""
    start = path.start[swept]
    if driver.kind != "slide":
        step = math.radians(10)
        if not path.stops:
            return _multiples(0.0, TURN, step)
        low, high = start + path.first, start + path.last
        while (high - low) / step < 12:
            step /= 2
        return _inside(_multiples(low, high, step), low, high)
    low, high = start + path.first, start + path.last
    return _inside(_multiples(low, high, _round_step((high - low) / ROWS)), low, high)


def _multiples(low: float, high: float, step: float) -> np.ndarray:
    return np.arange(math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) + 1) * step


def _inside(values: np.ndarray, low: float, high: float) -> np.ndarray:
    margin = 1e-9 * (high - low)
    return values[(values > low + margin) & (values < high - margin)]


def _round_step(step: float) -> float:
    """The next of 1, 2, 5 times a power of ten."""
    power = 10.0 ** math.floor(math.log10(step))
    return next(power * k for k in (1, 2, 5, 10) if power * k >= step * (1 - 1e-9))


def _none(found: Course) -> NoPosition:
    driver, method = found.driver, found.method
    low, high = map(EDGE[found.unit].shown, found.reach)
    return NoPosition(method.mechanism.where("driver", found.swept), driver.name, low, high)


# --- several drivers told apart ---------------------------------------------------------------


def _moved(method: Method, given: dict[int, DriverValues]) -> tuple[DriverPath, float] | None:
    """The path to where drivers that are given one value stand."""
    held = {k: wanted.begin for k, wanted in given.items() if not wanted.moves}
    if not held:
        return None
    values = list(method.facts(None).values)
    return reached(method, [held.get(k, value) for k, value in enumerate(values)])


def _together(method: Method, given: dict[int, DriverValues], moving: list[int]) -> Course:
    """Drivers that go from one value to another at once, from where they begin; others stand."""
    swept = moving[0]
    counts = {given[k].values.size for k in moving}
    if len(counts) > 1:
        raise BadRange(WHERE, ", ".join(str(count) for count in sorted(counts)))
    given = in_proportion(method, given, moving)
    begin = [given[k].begin if k in given else value for k, value in enumerate(method.facts(None).values)]
    before = reached(method, begin)
    wanted = given[swept].values - begin[swept]
    length = given[swept].end - given[swept].begin
    paces = [(given[k].end - given[k].begin) / length if k in moving else 0.0 for k in range(len(begin))]
    ends = min(0.0, float(wanted.min())), max(0.0, float(wanted.max()))
    path = trace(method, paces, *ends, before)
    there = np.broadcast_to(path.leads_to(wanted), wanted.shape)
    values = wanted + begin[swept]
    return _of_those(Course(method, path, swept, wanted, values, values[:0]), there)
