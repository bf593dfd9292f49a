"""What moves in a sweep, and how far it gets: `--driver 0:360:10` made into positions."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cached_property

import numpy as np

from graphkin.errors import BadRange, GivenTwice, GraphkinError, NoPosition, NoSuchDriver, Where
from graphkin.geometry import Value
from graphkin.loading.units import read_quantity
from graphkin.mechanism import Driver
from graphkin.naming import driver_number
from graphkin.planning import Method
from graphkin.quantities import EDGE, driven
from graphkin.running.path import Event, Path
from graphkin.running.reaching import reached
from graphkin.running.tracing import trace
from graphkin.value import frozen

TURN = 2 * math.pi
WHERE = Where("--driver")
MOST_TURNS, MOST_STEPS = 1000, 1e7
ROWS = 36
"""Rows of a table over the reachable range of a slide, and over a turn."""


@frozen
class Course:
    """A mechanism moved along a path, and the positions asked for on it.

    swept   number of the driver by whose value positions are named
    t       where on the path the positions are (n,)
    values  of the swept driver there, as they were asked for (n,) [rad, m]
    dropped values of the swept driver that were asked for and are not reached [rad, m]
    """

    method: Method
    path: Path
    swept: int
    t: np.ndarray
    values: np.ndarray
    dropped: np.ndarray

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


def course(method: Method, ranges: Sequence[str] = ()) -> Course:
    """The path that a sweep takes.

    ranges   `0:360:10`, `AB=0:360:10`, `ram=50 mm:90 mm:5 mm`, or `DH=90`: for each driver named, or in their order.
             None: the first driver that moves, a full turn or as far as it gets; the others keep pace with it.

    Raises BadRange, NoSuchDriver, NotReached; NoPosition where none of the positions is reached.
    """
    given = _given(method, ranges)
    moving = [k for k, spec in given.items() if len(spec) > 1]
    if not method.drivers:
        raise NoSuchDriver(method.mechanism.where("driver"), "", ())
    if moving and len(given) > 1:
        return _together(method, given, moving)
    before = _moved(method, given)
    swept = moving[0] if moving else _first_moving(method, given, ranges)
    pace = _pace(method, swept, tuple(given) if before is not None else ())
    return _over(method, swept, pace, given[swept] if moving else (), before)


def _first_moving(method: Method, given: dict[int, tuple[float, ...]], ranges: Sequence[str]) -> int:
    free = [k for k in range(len(method.drivers)) if k not in given]
    if not free:
        raise BadRange(WHERE, ", ".join(ranges))
    return next((k for k in free if method.drivers[k].rate), free[0])


def _pace(method: Method, swept: int, still: tuple[int, ...]) -> tuple[float, ...]:
    """The others keep pace with the swept driver as their speeds are; all stand still where it has none."""
    rate = method.drivers[swept].rate
    paces = [0.0 if k in still or not rate else driver.rate / rate for k, driver in enumerate(method.drivers)]
    paces[swept] = 1.0
    return tuple(paces)


# --- one driver, and those that keep pace with it ---------------------------------------------


def _over(
    method: Method, swept: int, pace: tuple[float, ...], wanted: tuple[float, ...], before: tuple[Path, float] | None
) -> Course:
    start = float(before[0].values(before[1])[swept]) if before else float(method.facts(None).values[swept])
    driver = method.drivers[swept]
    low, high = _ends(method, driver, start, wanted)
    path = trace(method, pace, low - start, high - start, before)
    values = _steps(wanted) if wanted else _usual(method, driver, path, swept)
    t, there = _turned_back(method, path, driver, values - start)
    found = Course(method, path, swept, t[there], values[there], values[~there])
    if not there.any():
        raise _none(found)
    return found


def _ends(method: Method, driver: Driver, start: float, wanted: tuple[float, ...]) -> tuple[float, float]:
    """How far to look: a turn to either side, or as far as a slide of the mechanism's size may go; farther if asked."""
    if driver.kind == "slide":
        usual = start - 2 * method.size, start + 2 * method.size
    else:
        usual = min(start - TURN, 0.0), max(start + TURN, TURN)
    return min((usual[0], *wanted[:2])), max((usual[1], *wanted[:2]))


def _turned_back(method: Method, path: Path, driver: Driver, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Positions whole turns away are the same ones, where nothing rolls; and which of all are reached."""
    turns_alike = driver.kind != "slide" and not method.structure.contacts and sum(map(bool, path.pace)) == 1
    if turns_alike and path.stops:
        middle = (path.first + path.last) / 2
        turned = t - TURN * np.round((t - middle) / TURN)
        t = np.where(path.leads_to(t), t, turned)
    return t, np.broadcast_to(path.leads_to(t), t.shape)


def _usual(method: Method, driver: Driver, path: Path, swept: int) -> np.ndarray:
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


def _moved(method: Method, given: dict[int, tuple[float, ...]]) -> tuple[Path, float] | None:
    """The path to where drivers that are given one value stand."""
    held = {k: spec[0] for k, spec in given.items() if len(spec) == 1}
    if not held:
        return None
    values = list(method.facts(None).values)
    return reached(method, [held.get(k, value) for k, value in enumerate(values)])


def _together(method: Method, given: dict[int, tuple[float, ...]], moving: list[int]) -> Course:
    """Drivers that go from one value to another at once, from where they begin; others stand."""
    swept = moving[0]
    counts = {_steps(given[k]).size for k in moving}
    if len(counts) > 1:
        raise BadRange(WHERE, ", ".join(str(count) for count in sorted(counts)))
    begin = [given[k][0] if k in given else value for k, value in enumerate(method.facts(None).values)]
    before = reached(method, begin)
    wanted = _steps(given[swept]) - begin[swept]
    length = given[swept][1] - given[swept][0]
    paces = [(given[k][1] - given[k][0]) / length if k in moving else 0.0 for k in range(len(begin))]
    ends = min(0.0, float(wanted.min())), max(0.0, float(wanted.max()))
    path = trace(method, paces, *ends, before)
    there = np.broadcast_to(path.leads_to(wanted), wanted.shape)
    values = wanted + begin[swept]
    found = Course(method, path, swept, wanted[there], values[there], values[~there])
    if not there.any():
        raise _none(found)
    return found


# --- reading ----------------------------------------------------------------------------------


def _given(method: Method, ranges: Sequence[str]) -> dict[int, tuple[float, ...]]:
    """By driver: (from, to, step), or the one value it is held at [rad, m]."""
    found: dict[int, tuple[float, ...]] = {}
    for text in ranges:
        name, equals, span = text.rpartition("=")
        number = _number(method, name.strip(), text) if equals else _unnamed(method, found, text)
        if number in found:
            raise GivenTwice(WHERE, method.drivers[number].name)
        found[number] = _read(method, number, span, text)
    return found


def _number(method: Method, name: str, text: str) -> int:
    number = driver_number(method.mechanism, name)
    if number is None:
        raise NoSuchDriver(WHERE, name, tuple(driver.name for driver in method.drivers))
    return number


def _unnamed(method: Method, found: dict[int, tuple[float, ...]], text: str) -> int:
    """The first driver that moves and has no range yet."""
    free = [k for k in range(len(method.drivers)) if k not in found]
    if not free:
        raise NoSuchDriver(WHERE, text, ())
    return next((k for k in free if method.drivers[k].rate), free[0])


def _read(method: Method, number: int, span: str, text: str) -> tuple[float, ...]:
    dimension = "length" if method.drivers[number].kind == "slide" else "angle"
    parts = span.split(":")
    try:
        numbers = [read_quantity(_plain(part), dimension) for part in parts]  # type: ignore[arg-type]
    except GraphkinError as error:
        raise error.at(WHERE) from None
    if len(numbers) == 1:
        return tuple(numbers)
    if len(numbers) == 2:
        numbers.append(abs(numbers[1] - numbers[0]) / ROWS)
    if len(numbers) == 3 and numbers[1] < numbers[0]:
        numbers[2] = abs(numbers[2])
    if len(numbers) != 3 or numbers[0] == numbers[1] or not numbers[2] > 0:
        raise BadRange(WHERE, text)
    far = MOST_TURNS * TURN if dimension == "angle" else math.inf
    if abs(numbers[1] - numbers[0]) > min(far, MOST_STEPS * numbers[2]) or max(map(abs, numbers)) > far:
        raise BadRange(WHERE, text)
    return tuple(numbers)


def _plain(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text


def _steps(wanted: tuple[float, ...]) -> np.ndarray:
    """From, and on by steps, to and with the end where a step comes to it."""
    begin, end, step = wanted
    count = math.floor(abs(end - begin) / step + 1e-9)
    return begin + math.copysign(step, end - begin) * np.arange(count + 1)
