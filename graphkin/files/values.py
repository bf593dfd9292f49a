"""Single values of a mechanism file: names, and quantities in the units of a closed table. `"24 in"` -> 0.6096 m.

A bare number stands in the first unit of its quantity's table (mm, deg, rad/s, rad/s², m/s, m/s²). Each reader gives
the value or raises an error at `NOWHERE`; who knows the key fills the place in.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from contextlib import suppress
from datetime import date, datetime, time

from graphkin import errors
from graphkin.errors import NOWHERE
from graphkin.model.mechanism import Dimension

_POINT = r"[A-Z][0-9]*'*"
POINT = re.compile(_POINT)
LINK = re.compile(r"[\w']+")
SLIDE = re.compile(r"(?!c[0-9]+\Z)[\w'-]+")  # `c0`, `c1` .. are what graphkin calls the slots that stand for cams

LONGEST = 36  # a name of so many letters finds room on every sheet

_POINTS = re.compile(rf"(?:{_POINT})+")
_PRIMES = str.maketrans({"\u2019": "'", "\u2032": "'", "\u2033": "''", "\u2034": "'''"})


def tidy(name: str) -> str:
    """A name with its primes as typed on a keyboard, however they were printed."""
    return name if name.isascii() else name.translate(_PRIMES)


def split_points(word: str) -> tuple[str, ...]:
    """`O1AD'` -> O1, A, D'; nothing if the word is not made of points' names."""
    return tuple(POINT.findall(word)) if _POINTS.fullmatch(word) else ()


def name_reader(pattern: re.Pattern[str], kind: str) -> Callable[[str], str]:
    """A reader of names that must match a pattern, and that a drawing has room for."""

    def checked(value: str) -> str:
        name = tidy(value)
        if pattern.fullmatch(name) is None:
            raise errors.BadName(NOWHERE, kind, shown_value(value))
        letters = len(name)  # Chinese characters are as wide as two
        if not name.isascii():
            import unicodedata

            letters += sum(unicodedata.east_asian_width(letter) in "WF" for letter in name)
        if letters > LONGEST:
            raise errors.LongName(NOWHERE, shown_value(value), LONGEST)
        return name

    return checked


_LENGTH = {"mm": (1, 1000), "cm": (1, 100), "m": (1, 1), "in": (254, 10000), "ft": (3048, 10000)}
_TURN = {"rad/s": (1, 1), "deg/s": (math.pi, 180), "°/s": (math.pi, 180), "rev/s": (2 * math.pi, 1)}
_PER_MINUTE = (2 * math.pi, 60)

UNITS: Mapping[Dimension, Mapping[str, tuple[float, float]]] = {
    "length": _LENGTH,
    "angle": {"deg": (math.pi, 180), "°": (math.pi, 180), "rad": (1, 1), "rev": (2 * math.pi, 1)},
    "angular velocity": {**_TURN, "rpm": _PER_MINUTE, "r/min": _PER_MINUTE, "rev/min": _PER_MINUTE},
    "angular acceleration": {
        **{f"{unit}²": size for unit, size in _TURN.items()}, "rpm/s": _PER_MINUTE, "r/min/s": _PER_MINUTE,
        "rev/min/s": _PER_MINUTE,
    },
    "velocity": {"m/s": (1, 1), **{f"{unit}/s": size for unit, size in _LENGTH.items()}, "km/h": (1000, 3600)},
    "acceleration": {"m/s²": (1, 1), **{f"{unit}/s²": size for unit, size in _LENGTH.items()}},
}  # fmt: skip
"""By quantity: what one of the unit is in SI, as (times, divided by) so that 24 mm is exactly 0.024 m."""

DIMENSIONS: Mapping[str, Dimension] = {
    "rad": "angle", "rad/s": "angular velocity", "rad/s^2": "angular acceleration",
    "m": "length", "m/s": "velocity", "m/s^2": "acceleration",
}  # fmt: skip
"""By the SI unit of a quantity."""

LARGEST = 1e12  # no quantity of a mechanism is larger than this, in SI
LARGEST_ANGLE = 2 * math.pi * 10_000  # nor an angle, which is a direction, or some turns on from one
SMALLEST_LENGTH = 1e-9  # lengths and radii are at least this [m]
SMALLEST_SCALE = 1e-12

_QUANTITY = r"(?s)\s*([+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)\s*(.*?)\s*"


def si_quantity(value: object, dimension: Dimension) -> float:
    """A number or a text with a unit, in SI."""
    if is_range(value):
        raise errors.RangeHere(NOWHERE)
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        raise errors.WrongType(NOWHERE, "quantity", shown_value(value))
    return read_quantity(value, dimension)


def is_range(value: object) -> bool:
    """`{ from = 20, to = 30 }`, which a template has in place of a number, or what is meant as one."""
    return isinstance(value, dict) and not value.keys().isdisjoint(("to", "step"))


def quantity_at(where: str | errors.Where, dimension: Dimension, written: float | str) -> float:
    """A number of an option or an argument, in mm or deg or with a unit, in SI; what is wrong names that."""
    with suppress(ValueError, TypeError, OverflowError):
        written = float(written)
    try:
        return read_quantity(written, dimension)
    except errors.GraphkinError as error:
        raise error.at(errors.Where(where) if isinstance(where, str) else where) from None


def read_quantity(written: float | str, dimension: Dimension) -> float:
    """A number in the dimension's first unit, or a text with a unit, in SI."""
    possible = tuple(UNITS[dimension])
    number, unit = written, possible[0]
    if isinstance(written, str):  # `"120 r/min"` -> 120.0, "r/min"
        match = re.fullmatch(_QUANTITY, written)
        if match is None:
            raise errors.NotANumber(NOWHERE, written[:40])
        number, unit = float(match[1]), re.sub(r"\^?2$", "²", "".join(match[2].split()))
        if not unit:
            raise errors.NoUnit(NOWHERE, written.strip()[:40], possible)
        for other, units in UNITS.items():
            if unit in units and unit not in possible:
                raise errors.OtherDimension(NOWHERE, unit, possible, dimension, other)
        if unit not in possible:
            raise errors.UnknownUnit(NOWHERE, unit[:40], possible, dimension)
    times, divided = UNITS[dimension][unit]
    try:
        value = float(number) * times / divided
    except OverflowError:
        value = math.inf
    if not abs(value) <= (LARGEST_ANGLE if dimension == "angle" else LARGEST):
        raise errors.OutOfRange(NOWHERE, written.strip() if isinstance(written, str) else short_number(written))
    return value


def above_zero(value: float) -> float:
    """A length that is no rounding noise [m]."""
    if value < SMALLEST_LENGTH * (1 - 1e-9):  # 0.000001 mm itself rounds in metres
        raise errors.TooSmall(NOWHERE, f"{value * 1e3:.6g} mm", "0.000001 mm")
    return value


def zero_or_more(value: float) -> float:
    """A length that may be 0 [m]."""
    if value < 0:
        raise errors.Negative(NOWHERE, f"{value * 1e3:.6g} mm")
    return value


def scale_value(value: object) -> float:
    """A scale of the paper: a plain number above zero."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise errors.WrongType(NOWHERE, "number", shown_value(value))
    if not value >= SMALLEST_SCALE:
        is_number = value == value
        raise errors.TooSmall(NOWHERE, shown_value(value), "1e-12") if is_number else errors.OutOfRange(NOWHERE, "nan")
    if value > LARGEST:
        raise errors.OutOfRange(NOWHERE, shown_value(value))
    return float(value)


def shown_value(value: object) -> str:
    """A wrong value in a message: short, and the same in every language."""
    match value:
        case bool():
            return str(value).lower()
        case int() | float():
            return short_number(value)
        case str():
            return f'"{value[:40]}"'
        case list():
            return "[ .. ]"
        case dict():
            return "{ .. }"
        case date() | datetime() | time():
            return value.isoformat()
        case _:
            return type(value).__name__


def short_number(number: float) -> str:
    """The number in a message; an integer may be too long even to be printed."""
    try:
        return f"{number:.6g}"
    except OverflowError:
        return "1e999" if number > 0 else "-1e999"
