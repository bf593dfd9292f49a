"""Formulas with their figures put in: `0.01 × 27.12/(0.001 × 69.2)`.

What is printed is worth what stands behind it: factors are rounded to four digits, and to more where the result would
come out otherwise by half a unit of its last digit. So every result is the right one to its last digit, whatever road
led to it, and whoever puts the figures into a calculator gets it.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, floor, log10, radians, sin
from typing import Literal

from graphkin.base.value import frozen
from graphkin.say.numbers import DIGITS, noting, number

_LEVEL = {"+": 1, "−": 1, "×": 2, "/": 2}
_MOST_DIGITS = 12
_CLOSE = 1e-9


class Formula:
    """A figure, or two formulas with a sign between."""

    def __mul__(self, other: Formula) -> Formula:
        return Joined("×", self, other)

    def __truediv__(self, other: Formula) -> Formula:
        return Joined("/", self, other)

    def __add__(self, other: Formula) -> Formula:
        return Joined("+", self, other)

    def __sub__(self, other: Formula) -> Formula:
        return Joined("−", self, other)

    def __neg__(self) -> Formula:
        return MinusFormula(self)

    def text(self, digits: int = DIGITS) -> str:
        """Every figure with so many digits at most."""
        raise NotImplementedError

    def worth(self, digits: int) -> float:
        """The number that a calculator makes of `text`."""
        raise NotImplementedError

    @property
    def level(self) -> int:
        """The strength with which its signs bind."""
        return 3

    def bracketed(self, least: int, digits: int) -> str:
        """The text as part of another formula whose sign binds as `least` does."""
        text = self.text(digits)
        return f"({text})" if self.level < least or text.startswith("−") else text


@frozen
class Operand(Formula):
    """A number; `square`: it is multiplied by itself."""

    value: float
    square: bool = False

    def text(self, digits: int = DIGITS) -> str:
        text = number(self.value, digits=digits)
        if not self.square:
            return text
        return f"({text})²" if text.startswith("−") else f"{text}²"

    def worth(self, digits: int) -> float:
        read = to_digits(self.value, digits)
        return read * read if self.square else read


@frozen
class TrigFormula(Formula):
    """`sin 100°`, `cos 60°`; the angle in degrees."""

    function: Literal["sin", "cos"]
    angle: float

    def text(self, digits: int = DIGITS) -> str:
        return f"{self.function} {number(self.angle, digits=digits)}°"

    def worth(self, digits: int) -> float:
        return self.of(to_digits(self.angle, digits))

    @property
    def value(self) -> float:
        return self.of(self.angle)

    def of(self, angle: float) -> float:
        return sin(radians(angle)) if self.function == "sin" else cos(radians(angle))


@frozen
class Joined(Formula):
    """`first sign second`."""

    sign: str
    first: Formula
    second: Formula

    @property
    def level(self) -> int:
        return _LEVEL[self.sign]

    def text(self, digits: int = DIGITS) -> str:
        first = self.first.text(digits)
        if self.first.level < self.level:
            first = f"({first})"
        second = self.second.bracketed(self.level + (self.sign in "/−"), digits)
        return f"{first}/{second}" if self.sign == "/" else f"{first} {self.sign} {second}"

    def worth(self, digits: int) -> float:
        one, other = self.first.worth(digits), self.second.worth(digits)
        match self.sign:
            case "+":
                return one + other
            case "−":
                return one - other
            case "×":
                return one * other
            case _:
                return one / other if other else float("nan")


@frozen
class MinusFormula(Formula):
    """`−formula`."""

    of: Formula

    @property
    def level(self) -> int:
        return 1

    def text(self, digits: int = DIGITS) -> str:
        return f"−{self.of.bracketed(2, digits)}"

    def worth(self, digits: int) -> float:
        return -self.of.worth(digits)


def figures(*values: float) -> tuple[Formula, ...]:
    """Numbers to put together."""
    return tuple(Operand(value) for value in values)


def squared(value: float) -> Formula:
    """A figure with a raised 2."""
    return Operand(value, square=True)


def joined_sum(parts: Sequence[tuple[float, Formula]]) -> Formula:
    """`−0.49 + 2 × 3`, `1.5 − (−2)` of formulas with their signs."""
    (sign, first), *more = parts
    total = first if sign > 0 else -first
    for sign, formula in more:
        total = total + formula if sign > 0 else total - formula
    return total


def written(formula: Formula, result: float, digits: int = DIGITS) -> str:
    """A formula with as many digits as give its result as that is printed, with so many `digits`."""
    return formula.text() if noting() else formula.text(enough(formula, result, digits))


def enough(formula: Formula, result: float, digits: int = DIGITS) -> int:
    """The number of digits by which a formula gives its result as that is printed, with so many `digits`."""
    printed = number(result, digits=digits)
    room = half_unit(printed) * (1 + _CLOSE)
    counts = range(digits, _MOST_DIGITS)
    return next((n for n in counts if abs(formula.worth(n) - as_read(printed)) <= room), _MOST_DIGITS)


def to_digits(value: float, digits: int) -> float:
    """The number that a figure of so many digits says."""
    return float(f"{value:.{digits}g}")


def as_read(text: str) -> float:
    """The number that a figure says."""
    return float(text.replace("−", "-"))


def half_unit(text: str) -> float:
    """Half a unit of the last digit of a figure; of `123500` that of its fourth."""
    mantissa, _, exponent = text.replace("−", "").partition("e")
    after = len(mantissa.partition(".")[2])
    value = float(mantissa)
    if not after and value >= 10**DIGITS:
        after = DIGITS - 1 - floor(log10(value))
    return 0.5 * 10.0 ** (int(exponent.replace("−", "-") or 0) - after)
