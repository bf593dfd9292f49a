"""The values through which drivers are swept: `--driver AB=0:360:10` read, a text, a number, or an array of numbers."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from functools import partial

import numpy as np

from graphkin.base.value import frozen
from graphkin.errors import BadRange, BadValues, GivenTwice, GraphkinError, NoSuchDriver, Where
from graphkin.files.values import LARGEST, UNITS, read_quantity
from graphkin.model.mechanism import Dimension
from graphkin.model.naming import driver_number
from graphkin.planning import Method

Ranges = Sequence[str] | Mapping[str, object] | np.ndarray | Sequence[float]
"""Texts as on the command line; or by driver a text, a number, numbers [deg, mm]; or numbers for the first driver."""
TURN = 2 * math.pi
WHERE = Where("--driver")
MOST_TURNS, MOST_STEPS = 1000, 1e7
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

    if isinstance(ranges, Mapping):
        yield from ((name, span, partial(shortened, span, f"{name}=")) for name, span in ranges.items())
    elif not isinstance(ranges, str) and any(not isinstance(each, str) for each in ranges):
        yield "", ranges, partial(shortened, ranges)
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
    try:
        numbers = [read_quantity(plain(part), dimension) for part in span.split(":")]
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
    begin, end, step = numbers
    far = MOST_TURNS * TURN if dimension == "angle" else math.inf
    if abs(end - begin) > min(far, MOST_STEPS * step) or max(map(abs, numbers)) > far:
        raise BadRange(WHERE, written())
    count = math.floor(abs(end - begin) / step + 1e-9)
    return DriverValues(begin + math.copysign(step, end - begin) * np.arange(count + 1), begin, end, True)


def plain(text: str) -> float | str:
    """The number, where a text is one; a text with a unit as it stands."""
    try:
        return float(text)
    except ValueError:
        return text
