"""Reading single values of the file: a quantity, a name, a vector. Each either gives it or raises an own error.

The errors come with `NOWHERE`; who knows the key fills the place in.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from datetime import date, datetime, time

from graphkin.errors import NOWHERE, BadName, LongName, Negative, OutOfRange, TooSmall, WrongType
from graphkin.files.names import LONGEST, letters, split_points, tidy
from graphkin.files.units import LARGEST, Dimension, read_quantity, short_number

SMALLEST_LENGTH = 1e-9
"""Lengths and radii are at least this [m]."""

SMALLEST_SCALE = 1e-12


def shown(value: object) -> str:
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


def quantity(value: object, dimension: Dimension) -> float:
    """A number or a text with a unit, in SI."""
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        raise WrongType(NOWHERE, "quantity", shown(value))
    return read_quantity(value, dimension)


def above_zero(value: float) -> float:
    if value < SMALLEST_LENGTH:
        raise TooSmall(NOWHERE, f"{value * 1e3:.6g} mm", "0.000001 mm")
    return value


def zero_or_more(value: float) -> float:
    if value < 0:
        raise Negative(NOWHERE, f"{value * 1e3:.6g} mm")
    return value


def scale(value: object) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise WrongType(NOWHERE, "number", shown(value))
    if not value >= SMALLEST_SCALE:
        raise (TooSmall(NOWHERE, shown(value), "1e-12") if value == value else OutOfRange(NOWHERE, "nan"))
    if value > LARGEST:
        raise OutOfRange(NOWHERE, shown(value))
    return float(value)


def formed(pattern: re.Pattern[str], kind: str) -> Callable[[str], str]:
    """A name that must match a pattern, and that a drawing has room for."""

    def checked(value: str) -> str:
        name = tidy(value)
        if pattern.fullmatch(name) is None:
            raise BadName(NOWHERE, kind, shown(value))
        if letters(name) > LONGEST:
            raise LongName(NOWHERE, shown(value), LONGEST)
        return name

    return checked


def vector(value: object) -> tuple[str, str]:
    if not isinstance(value, str):
        raise WrongType(NOWHERE, "vector", shown(value))
    points = split_points(tidy(value))
    if len(points) != 2 or points[0] == points[1]:
        raise BadName(NOWHERE, "vector", shown(value))
    return points[0], points[1]


def triples(value: object) -> object:
    """One triple or a list of them: a list of them."""
    if not isinstance(value, list):
        raise WrongType(NOWHERE, "triple", shown(value))
    return [value] if value and all(not isinstance(item, list) for item in value) else value


def titles(value: object) -> object:
    """One title serves both languages."""
    if not isinstance(value, str | dict):
        raise WrongType(NOWHERE, "title", shown(value))
    return {"en": value, "zh": value} if isinstance(value, str) else value
