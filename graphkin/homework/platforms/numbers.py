"""Numbers as platforms print them: rounded once, as decimals, so that no format rounds again."""

from __future__ import annotations

import math
from decimal import ROUND_HALF_UP, ROUND_UP, Decimal

HUNDREDTH = Decimal("0.01")
"""Points are given in these."""
_FINER = 3
"""A number is rounded to this many digits finer than its tolerance."""
_ALL = 12
"""Digits of a number without tolerance."""


def points(value: float) -> Decimal:
    """Points in hundredths, half a hundredth up."""
    return Decimal(repr(float(value))).quantize(HUNDREDTH, ROUND_HALF_UP)


def tolerated(tolerance: float) -> Decimal:
    """A tolerance in three digits, never less than it is."""
    if tolerance == 0:
        return Decimal(0)
    return _plain(Decimal(repr(float(tolerance))).quantize(_step(tolerance, _FINER - 1), ROUND_UP))


def rounded(number: float, tolerance: float) -> Decimal:
    """A number, off by less than a thousandth of its tolerance."""
    if number == 0:
        return Decimal(0)
    step = _step(tolerance, _FINER) if tolerance else _step(number, _ALL - 1)
    return _plain(Decimal(repr(float(number))).quantize(step, ROUND_HALF_UP))


def _step(size: float, digits: int) -> Decimal:
    """The unit of a number's digit that comes so many after its first."""
    return Decimal(1).scaleb(math.floor(math.log10(abs(size))) - digits)


def _plain(number: Decimal) -> Decimal:
    """Without zeros at its end, and without a sign of nothing."""
    return number.normalize() if number else Decimal(0)


def printed(number: Decimal) -> str:
    """`-1.25`, `3.2E-9`: as Moodle reads numbers; no plus before it, no power of a usual size."""
    number = _plain(number)
    if not number or -7 <= number.adjusted() < 15:
        return format(number, "f")
    return str(number).replace("E+", "E")


def exponentless(number: Decimal) -> str:
    """`0.0000025`: always in full."""
    return format(_plain(number), "f")
