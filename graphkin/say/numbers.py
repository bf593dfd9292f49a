"""Figures in print: four significant digits where they are read off paper, six where they are computed.

One rule for all: zeros at the end are kept, so that a figure of fewer digits is exact. 9.1 is 9.1; 9.1002 is 9.100.

    number, degrees             in a construction and about instant centres
    given_figure, stated_figure, sensed   what a problem gives
    exact, quantity, at_edge    in tables and answers, in the units of the edge
    millimetres, angle          of a linkage
    SentenceNumber              in a sentence that says itself how its figures are written: `{theta:deg}`, `{a:mm}`
"""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from itertools import pairwise

from graphkin.errors import Lang
from graphkin.model.quantities import EDGE, IN_GRAVITY
from graphkin.model.units import significant
from graphkin.say.catalogue import is_phrase, say, say_close

DIGITS = 4  # of what is read off paper
_COMPUTED = 6
MOST_TYPED = 7  # of a figure that somebody writes
_DESIGNED = 5
_PLAIN = range(-6, 9)  # powers of ten that are still written out
_NONE = 1e-6  # the part of a place's distance up to which a coordinate is rounding noise
_LEVEL = 0.5  # what rises by more than this part of its length is above, or below


_NOTED: ContextVar[list[float] | None] = ContextVar("noted", default=None)
_FIRST = 0xE100  # of the letters that stand for numbers that are noted; no font has them


@contextmanager
def noted() -> Iterator[list[float]]:
    """Texts that are made in here bear `noted_letter(k)` for the k-th of these numbers, who writes it later."""
    numbers: list[float] = []
    before = _NOTED.set(numbers)
    try:
        yield numbers
    finally:
        _NOTED.reset(before)


def noting() -> bool:
    return _NOTED.get() is not None


def noted_letter(k: int) -> str:
    return chr(_FIRST + k)


def number(value: float, zero: float = 0.0, digits: int = DIGITS) -> str:
    """`27.12`, `69.2`, `−3.919`, `0`; `1.2e−12` only where nobody would count the zeros.

    zero  sizes up to this are rounding noise, and 0
    """
    if (numbers := _NOTED.get()) is not None and digits == DIGITS:
        numbers.append(0.0 if abs(value) <= zero else value)
        return noted_letter(len(numbers) - 1)
    if abs(value) <= zero or value == 0:
        return "0"
    text = significant(value, digits)
    mantissa, _, exponent = text.partition("e")
    if exponent and int(exponent) in _PLAIN:
        from decimal import Decimal

        text = format(Decimal(text), "f")  # with all its zeros
    elif exponent:
        text = f"{mantissa}e{int(exponent)}"
    return text.replace("-", "−")


def given_figure(value: float) -> str:
    """A figure of the problem itself: in full where six digits are all it has, `113.72`; else with four."""
    whole = math.isclose(float(f"{value:.{_COMPUTED}g}"), value, rel_tol=1e-9)
    return number(value, 0.0, _COMPUTED if whole else DIGITS)


def stated_figure(value: float) -> str:
    """A figure of a file, as it is typed; one of more digits than are typed was computed, and has six."""
    typed = math.isclose(float(f"{value:.{MOST_TYPED}g}"), value, rel_tol=1e-9)
    return number(value, 0.0, MOST_TYPED if typed else _COMPUTED)


def sense(value: float, lang: Lang) -> str:
    """The sense of a rotation in a word; never a sign with it."""
    return say("common.ccw" if value > 0 else "common.cw", lang)


def sensed(name: str, value: float, unit: str, lang: Lang) -> str:
    """`ω1 = 10 rad/s (counter-clockwise)`; nothing has no sense."""
    if value == 0:
        return f"{name} = 0"
    note = say("common.note", lang, note=sense(value, lang))
    return f"{name} = {given_figure(abs(value))} {unit}{note}"


def direction(vector: complex, read: Callable[[float], float] = float) -> float:
    """Of a vector, counter-clockwise from +x, from 0 to 360 [deg]; as a protractor reads it."""
    return read(round(cmath.phase(vector) * 180 / cmath.pi, 6) % 360) % 360


def degrees(vector: complex, read: Callable[[float], float] = float) -> str:
    """The same in print: `153.4°`."""
    angle = direction(vector, read)
    if noting() and angle % 90 == 0:  # said by the name of the axis
        return f"{angle:g}°"
    return f"{number(angle if float(f'{angle:.4g}') < 360 else 0.0)}°"


def heading(angle: str, lang: Lang) -> str:
    """`at 153.4° to +x`, `vertically downwards`: a direction with its angle from +x in words."""
    key = f"derivation.at direction {angle}"
    return say_close(key if is_phrase(key) else "derivation.at direction", lang, angle=angle)


def inclination(angle: str, lang: Lang) -> str:
    """`at 60° to +x`, `horizontally`: the same of a line that nothing is counted along."""
    key = f"derivation.line at {angle}"
    return say_close(key, lang) if is_phrase(key) else heading(angle, lang)


def side(away: complex) -> int:
    """The side on which what is so far away lies: above, below, to the left, to the right."""
    return int(away.imag <= 0) if abs(away.imag) > _LEVEL * abs(away) else 2 + (away.real > 0)


def coordinates(at: complex, lang: Lang, least: float = 0.0, figure: Callable[[float, float], str] = number) -> str:
    """`(34.5, −20)`: a place; a coordinate up to `least`, or a millionth of the other, is none."""
    least = max(least, _NONE * abs(at))
    return say("common.place", lang, x=figure(at.real, least), y=figure(at.imag, least))


_CIRCLED = ((1, 0x2460), (21, 0x3251), (36, 0x32B1), (51, 0))  # from which number on the signs begin at which code


def circled(count: int) -> str:
    """A number in a circle, ① to ㊿; in brackets beyond."""
    for (first, code), (end, _) in pairwise(_CIRCLED):
        if first <= count < end:
            return chr(code + count - first)
    return f"({count})"


def exact(value: float | None, zero: float = 1e-12) -> str:
    """Six significant digits, zero without a sign; `-` where there is none."""
    return "-" if value is None else number(value, zero, _COMPUTED)


def quantity(value: float, unit: str, *, gravity: bool = False) -> str:
    """`26.38 deg`, `188.8 mm`, `0.4 m/s`; accelerations in g, too, where `gravity`."""
    if math.isinf(value):
        return "∞" if value > 0 else "−∞"
    shown = EDGE[unit]
    text = f"{exact(value * shown.factor)} {shown.name}".rstrip()
    return f"{text} ({exact(value * IN_GRAVITY.factor)} {IN_GRAVITY.name})" if gravity and unit == "m/s^2" else text


_MINUS = r"(?<![\w)])-(?=\d)"


def in_print(text: str) -> str:
    """A text with the signs of print: a minus sign, °, ²."""
    return re.sub(_MINUS, "−", text.replace(" deg", "°").replace("^2", "²"))


def at_edge(value: float, unit: str) -> str:
    """`41.2°`, `20 mm`, `0.36 m/s`."""
    name = "°" if unit == "rad" else f" {EDGE[unit].name}".rstrip()
    return f"{number(value * EDGE[unit].factor, 1e-9, _COMPUTED)}{name}"


def millimetres(length: float) -> str:
    """`20 mm`; less than a millionth of one is none."""
    return f"{number(length * 1e3, 1e-6, _COMPUTED)} mm"


def angle(value: float) -> str:
    """`32.984°`."""
    degrees, text = math.degrees(value), f"{math.degrees(value):.3f}"
    if abs(float(text) - degrees) <= 1e-7:
        text = text.rstrip("0").rstrip(".")
    return f"{'0' if text == '-0' else text}°".replace("-", "−")


class SentenceNumber(float):
    """A number in a sentence: `mm` a length, `deg` an angle, `n` as it is, with five figures; `read` with four."""

    def __format__(self, spec: str) -> str:
        if spec == "mm":
            return f"{number(self * 1e3, 1e-9, _DESIGNED)} mm"
        if spec == "deg":
            return f"{number(math.degrees(self), 1e-9, _DESIGNED)}°"
        if spec == "read":
            return number(self)
        if spec == "n":
            return number(self, 1e-9, _DESIGNED)
        return format(round(self) if spec == "d" else float(self), spec)
