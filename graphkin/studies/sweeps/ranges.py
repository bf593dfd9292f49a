"""What is asked of each driver: `--driver AB=0:360:10` read, a text, a number, or an array of numbers."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from graphkin.base.value import frozen
from graphkin.errors import BadRange, BadValues, GivenTwice, GraphkinError, NoSuchDriver, Where
from graphkin.files.values import LARGEST, UNITS, read_quantity
from graphkin.model.mechanism import Dimension
from graphkin.model.naming import driver_number
from graphkin.planning import Method

Ranges = Sequence[str] | Mapping[str, Any] | np.ndarray | Sequence[float]
"""Texts as on the command line; or by driver a text, a number, numbers [deg, mm]; or numbers for the first driver."""
TURN = 2 * math.pi
WHERE = Where("--driver")
MOST_TURNS, MOST_STEPS = 1000, 1e7
ROWS = 36
"""Rows of a table over the reachable range of a slide, and over a turn."""


@frozen
class DriverValues:
    """What is asked of a driver [rad, m]: its values, from the first to the last; one that is held has one value."""

    values: np.ndarray
    begin: float
    end: float
    moves: bool
    listed: bool = False

    @classmethod
    def held(cls, value: float) -> DriverValues:
        return cls(np.array([value]), value, value, False)


def given_ranges(method: Method, ranges: Ranges) -> dict[int, DriverValues]:
    """By driver, what is asked of it."""
    found: dict[int, DriverValues] = {}
    for name, span, written in _named(ranges):
        number = _number(method, name) if name else _unnamed(method, found, written)
        if number in found:
            raise GivenTwice(WHERE, method.drivers[number].name)
        found[number] = _wanted(method, number, span, written)
    return found


def first_free(method: Method, taken: Collection[int]) -> int | None:
    """The first driver that moves of those that nothing is asked of; None where there is none left."""
    free = [k for k in range(len(method.drivers)) if k not in taken]
    return next((k for k in free if method.drivers[k].rate), free[0] if free else None)


def in_proportion(method: Method, given: dict[int, DriverValues], moving: list[int]) -> dict[int, DriverValues]:
    """Several drivers go on one straight way: where values are listed, from the least of the first driver's on."""
    if not any(given[k].listed for k in moving):
        return given
    first = given[moving[0]].values
    low, high = int(np.argmin(first)), int(np.argmax(first))
    if first[high] == first[low]:
        raise BadValues(WHERE, method.drivers[moving[0]].name)
    part = (first - first[low]) / (first[high] - first[low])
    found = dict(given)
    for k in moving:
        values = given[k].values
        begin, end = float(values[low]), float(values[high])
        if not np.allclose(values, begin + (end - begin) * part, rtol=0, atol=1e-9 * max(abs(begin), abs(end))):
            raise BadValues(WHERE, method.drivers[k].name)
        found[k] = DriverValues(values, begin, end, True, True)
    return found


Written = Callable[[], str]
"""A range as it was written: long arrays are only told where something is wrong with them."""


def _named(ranges: Ranges) -> Iterator[tuple[str, object, Written]]:
    """Each range with its driver's name, "" where none is given, and as it was written."""
    if isinstance(ranges, Mapping):
        yield from ((name, span, partial(_told, span, f"{name}=")) for name, span in ranges.items())
    elif not isinstance(ranges, str) and any(not isinstance(each, str) for each in ranges):
        yield "", ranges, partial(_told, ranges)
    else:
        for text in [ranges] if isinstance(ranges, str) else ranges:
            name, _, span = str(text).rpartition("=")
            yield name.strip(), span, partial(str, text)


def _told(span: object, name: str = "") -> str:
    return f"{name}{span}"[:60]


def _number(method: Method, name: str) -> int:
    number = driver_number(method.mechanism, name)
    if number is None:
        raise NoSuchDriver(WHERE, name, tuple(driver.name for driver in method.drivers))
    return number


def _unnamed(method: Method, found: dict[int, DriverValues], written: Written) -> int:
    number = first_free(method, found)
    if number is None:
        raise NoSuchDriver(WHERE, written(), ())
    return number


def _wanted(method: Method, number: int, span: object, written: Written) -> DriverValues:
    dimension: Dimension = "length" if method.drivers[number].kind == "slide" else "angle"
    return _read(dimension, span, written) if isinstance(span, str) else _listed(dimension, span, written)


def _listed(dimension: Dimension, span: object, written: Written) -> DriverValues:
    """Of a number, or of numbers, in the units of plain numbers."""
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


def _read(dimension: Dimension, span: str, written: Written) -> DriverValues:
    try:
        numbers = [read_quantity(_plain(part), dimension) for part in span.split(":")]
    except GraphkinError as error:
        raise error.at(WHERE) from None
    if len(numbers) == 1:
        return DriverValues.held(numbers[0])
    if len(numbers) == 2:
        numbers.append(abs(numbers[1] - numbers[0]) / ROWS)
    if len(numbers) == 3 and numbers[1] < numbers[0]:
        numbers[2] = abs(numbers[2])
    if len(numbers) != 3 or numbers[0] == numbers[1] or not numbers[2] > 0:
        raise BadRange(WHERE, written())
    far = MOST_TURNS * TURN if dimension == "angle" else math.inf
    if abs(numbers[1] - numbers[0]) > min(far, MOST_STEPS * numbers[2]) or max(map(abs, numbers)) > far:
        raise BadRange(WHERE, written())
    return DriverValues(_steps(*numbers), numbers[0], numbers[1], True)


def _plain(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text


def _steps(begin: float, end: float, step: float) -> np.ndarray:
    """From, and on by steps, to and with the end where a step comes to it."""
    count = math.floor(abs(end - begin) / step + 1e-9)
    return begin + math.copysign(step, end - begin) * np.arange(count + 1)
