"""The units a mechanism file may use: a closed table. `"24 in"` -> 0.6096 m.

A bare number stands in the first unit of its quantity's table (mm, deg, rad/s, rad/s², m/s, m/s²).
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from typing import Literal

from graphkin.errors import NOWHERE, NotANumber, NoUnit, OtherDimension, OutOfRange, UnknownUnit

Dimension = Literal["length", "angle", "angular velocity", "angular acceleration", "velocity", "acceleration"]

_LENGTH = {"mm": (1, 1000), "cm": (1, 100), "m": (1, 1), "in": (254, 10000), "ft": (3048, 10000)}
_TURN = {"rad/s": (1, 1), "deg/s": (math.pi, 180), "°/s": (math.pi, 180), "rev/s": (2 * math.pi, 1)}
_PER_MINUTE = (2 * math.pi, 60)
_SPEED = {f"{unit}/s": size for unit, size in _LENGTH.items()}
_RATE = {f"{unit}/s²": size for unit, size in _LENGTH.items()}

UNITS: Mapping[Dimension, Mapping[str, tuple[float, float]]] = {
    "length": _LENGTH,
    "angle": {"deg": (math.pi, 180), "°": (math.pi, 180), "rad": (1, 1), "rev": (2 * math.pi, 1)},
    "angular velocity": {**_TURN, "rpm": _PER_MINUTE, "r/min": _PER_MINUTE},
    "angular acceleration": {
        **{f"{unit}²": size for unit, size in _TURN.items()},
        "rpm/s": _PER_MINUTE,
        "r/min/s": _PER_MINUTE,
    },
    "velocity": {"m/s": (1, 1), **_SPEED, "km/h": (1000, 3600)},
    "acceleration": {"m/s²": (1, 1), **_RATE},
}
"""By quantity: what one of the unit is in SI, as (times, divided by) so that 24 mm is exactly 0.024 m."""

LARGEST = 1e12
"""No quantity of a mechanism is larger than this, in SI."""
LARGEST_ANGLE = 2 * math.pi * 10_000
"""Nor an angle, which is a direction, or some turns on from one."""

_TEXT = r"(?s)\s*([+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)\s*(.*?)\s*"


def read_quantity(given: float | str, dimension: Dimension) -> float:
    """What the file gives, in SI. Raises with `NOWHERE`: the place is for the caller to fill in."""
    if isinstance(given, str):
        number, unit = _split(given, dimension)
    else:
        number, unit = given, next(iter(UNITS[dimension]))
    times, divided = UNITS[dimension][unit]
    try:
        value = float(number) * times / divided
    except OverflowError:
        value = math.inf
    if not abs(value) <= (LARGEST_ANGLE if dimension == "angle" else LARGEST):
        raise OutOfRange(NOWHERE, given.strip() if isinstance(given, str) else short_number(number))
    return value


def short_number(number: float) -> str:
    """The number in a message; an integer may be too long even to be printed."""
    try:
        return f"{number:.6g}"
    except OverflowError:
        return "1e999" if number > 0 else "-1e999"


def _split(text: str, dimension: Dimension) -> tuple[float, str]:
    """`"120 r/min"` -> (120.0, "r/min")."""
    match = re.fullmatch(_TEXT, text)
    if match is None:
        raise NotANumber(NOWHERE, text[:40])
    number, unit = match.groups()
    unit = re.sub(r"\^?2$", "²", "".join(unit.split()))
    possible = tuple(UNITS[dimension])
    if not unit:
        raise NoUnit(NOWHERE, text.strip()[:40], possible)
    if unit in possible:
        return float(number), unit
    for found, units in UNITS.items():
        if unit in units:
            raise OtherDimension(NOWHERE, unit, possible, dimension, found)
    raise UnknownUnit(NOWHERE, unit[:40], possible, dimension)
