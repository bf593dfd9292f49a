"""Conditions, read from one line: `v C = 0`, `max v E`, `stroke s ram`, `v E = 0.5 by omega 1`."""

from __future__ import annotations

import re
from typing import Literal

from graphkin.base.value import frozen
from graphkin.errors import BadCondition, NoSuchDriver, NotANumber, NoUnitHere, Where
from graphkin.files.values import DIMENSIONS, quantity_at, tidy
from graphkin.model.mechanism import Mechanism
from graphkin.model.quantities import GRAVITY
from graphkin.model.quantities.reading import SHAPE

WHERE = Where("find")

Sign = Literal["=", ">", "<"]
Which = Literal["max", "min", "range", "stroke"]

_COMPARED: dict[str, Sign] = {"=": "=", ">": ">", "<": "<"}
_WHICH: dict[str, Which] = {"max": "max", "min": "min", "range": "range", "stroke": "stroke"}
_SIGNS = str.maketrans({"＝": "=", "＞": ">", "＜": "<", "−": "-", "，": ",", "　": " "})
_NUMBER = re.compile(r"[+-]?(?:[0-9]|\.[0-9]).*", re.DOTALL)
_IN_GRAVITY = re.compile(r"(.*[0-9.])\s*g", re.DOTALL)


@frozen
class Comparison:
    """A quantity that is to equal, exceed or stay below a value (as written) or another quantity.

    size   its size counts, whatever its sense (a limit)
    """

    text: str
    quantity: str
    sign: Sign
    other: str
    size: bool = False

    @property
    def numeric(self) -> bool:
        """True if the other side is a value."""
        return _NUMBER.fullmatch(self.other) is not None

    @property
    def quantities(self) -> tuple[str, ...]:
        return (self.quantity,) if self.numeric else (self.quantity, self.other)


@frozen
class Extreme:
    """The greatest or least value of a quantity, both (`range`), or both with the time between (`stroke`)."""

    text: str
    quantity: str
    which: Which

    @property
    def quantities(self) -> tuple[str, ...]:
        return (self.quantity,)


@frozen
class Slowest:
    """The point with the least speed of a line of a link: `BC`, or the link's name."""

    text: str
    of: str


@frozen
class Scaling:
    """The speed of the drivers at which a quantity takes a value; `driver` is the one people name it by."""

    text: str
    quantity: str
    value: str
    driver: int


Condition = Comparison | Extreme | Slowest | Scaling


def read(mechanism: Mechanism, text: str) -> Condition:
    """A condition, its names not yet looked up. Raises BadCondition, NoSuchDriver."""
    line = _line(text)
    if extreme := re.fullmatch(r"(max|min|range|stroke) (.+)", line):
        return Extreme(line, extreme[2], _WHICH[extreme[1]])
    if slowest := re.fullmatch(r"slowest (\S+)", line):
        return Slowest(line, slowest[1])
    if scaled := re.fullmatch(r"([^=<>]+?) ?= ?([^=<>]+?) by (.+)", line):
        if _NUMBER.fullmatch(scaled[2]) is None:
            raise BadCondition(WHERE, text)
        return Scaling(line, scaled[1], scaled[2], _driver(mechanism, scaled[3]))
    if compared := re.fullmatch(r"([^=<>]+?) ?([=<>]) ?([^=<>]+)", line):
        return Comparison(line, compared[1], _COMPARED[compared[2]], compared[3])
    raise BadCondition(WHERE, text)


def limit(text: str) -> Comparison:
    """`a E 3 g`: the size of a quantity passes a value. Raises BadCondition."""
    words = re.fullmatch(rf"({SHAPE}) ?>? ?([0-9.].*)", _line(text))
    if words is None:
        raise BadCondition(Where("--limit"), text)
    return Comparison(f"{words[1]} > {words[2]}", words[1], ">", words[2], size=True)


def _line(text: str) -> str:
    """The text with plain signs and single spaces."""
    return " ".join(tidy(text).translate(_SIGNS).split())


def _driver(mechanism: Mechanism, text: str) -> int:
    """The driver called `AB`, `ram`, `omega 1` or `v ram`."""
    names = [driver.name for driver in mechanism.drivers]
    _, space, of = text.partition(" ")
    if not space and text in names:
        return names.index(text)
    for number, driver in enumerate(mechanism.drivers):
        word = "v" if driver.kind == "slide" else "omega"
        if text == f"{word} {driver.link}" or (space and of == names[number]):
            return number
    raise NoSuchDriver(WHERE, text, tuple(names))


def value(text: str, unit: str, where: Where = WHERE) -> float:
    """A value of a quantity measured in `unit`, in SI: `30`, `0.5 m/s`, `3 g`.

    Raises what a wrong unit in a mechanism file raises.
    """
    if unit == "1":
        return _bare(text, where, NoUnitHere)
    dimension = DIMENSIONS[unit]
    if dimension == "acceleration" and (gravity := _IN_GRAVITY.fullmatch(text)):
        return GRAVITY * _bare(gravity[1], where, NotANumber)
    return quantity_at(where, dimension, text)


def _bare(text: str, where: Where, error: type[NoUnitHere | NotANumber]) -> float:
    """A number without a unit; the error where it is none."""
    try:
        return quantity_at(where, "velocity", float(text))
    except ValueError:
        raise error(where, text) from None
