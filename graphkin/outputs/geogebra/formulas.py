"""Formulas of GeoGebra for what a construction counts with: complex numbers as pairs of formulas.

Sums and products leave out noughts and ones, so that a reader who opens an object sees what it comes from.
"""

from __future__ import annotations

import cmath
import re

from graphkin.base.value import frozen

_SIMPLE = re.compile(r"[\w.{}']+|\w+\([^()]*\)")
"""A number, a label, or a function of one: what needs no brackets."""

_NUMBER = re.compile(r"-?[0-9.]+")


def value(number: float) -> str:
    """A number as GeoGebra reads it, which knows no `1e-05`."""
    text = repr(float(number) + 0.0).removesuffix(".0")
    mantissa, _, power = text.partition("e")
    return f"{mantissa} * 10^({int(power)})" if power else text


def grouped(formula: str) -> str:
    """In brackets, where it is more than one thing."""
    return formula if _SIMPLE.fullmatch(formula) else f"({formula})"


def plus(one: str, other: str) -> str:
    if one == "0" or other == "0":
        return one if other == "0" else other
    return f"{one} + {grouped(other)}"


def minus(one: str, other: str) -> str:
    if other == "0":
        return one
    return f"-{grouped(other)}" if one == "0" else f"{one} - {grouped(other)}"


def product(one: str, other: str) -> str:
    if "0" in (one, other):
        return "0"
    if "1" in (one, other):
        return one if other == "1" else other
    if "-1" in (one, other):
        return minus("0", one if other == "-1" else other)
    return f"{grouped(one)} * {grouped(other)}"


@frozen
class FormulaPair:
    """A vector of the plane: two formulas, x and y."""

    x: str
    y: str

    def __add__(self, other: FormulaPair) -> FormulaPair:
        return FormulaPair(plus(self.x, other.x), plus(self.y, other.y))

    def times(self, factor: str) -> FormulaPair:
        """Longer by a factor."""
        return FormulaPair(product(factor, self.x), product(factor, self.y))

    @property
    def turned(self) -> FormulaPair:
        """By 90 deg, counter-clockwise."""
        return FormulaPair(minus("0", self.y), self.x)

    def by(self, other: FormulaPair) -> FormulaPair:
        """The product of complex numbers."""
        across, along = product(self.y, other.y), product(self.x, other.x)
        return FormulaPair(minus(along, across), plus(product(self.x, other.y), product(self.y, other.x)))

    @property
    def square(self) -> str:
        """The square of its length."""
        return self.dot(self)

    def dot(self, other: FormulaPair) -> str:
        return plus(product(self.x, other.x), product(self.y, other.y))

    def cross(self, other: FormulaPair) -> str:
        """Positive where the other is counter-clockwise of it."""
        return minus(product(self.x, other.y), product(self.y, other.x))

    @property
    def angle(self) -> str:
        """Its direction [rad], between -90 and 270 deg."""
        return f"atan({grouped(self.y)} / {grouped(self.x)}) + If[{self.x} < 0, pi, 0]"

    @property
    def point(self) -> str:
        return f"({self.x}, {self.y})"


NOTHING = FormulaPair("0", "0")


def known(number: complex) -> FormulaPair:
    return FormulaPair(value(number.real), value(number.imag))


def along(angle: str) -> FormulaPair:
    """The unit vector at an angle [rad]."""
    if _NUMBER.fullmatch(angle):
        return known(cmath.rect(1.0, float(angle)))
    return FormulaPair(f"cos({angle})", f"sin({angle})")


def between(tail: str, head: str) -> FormulaPair:
    """From a point to a point, both by label."""
    return FormulaPair(minus(f"x({head})", f"x({tail})"), minus(f"y({head})", f"y({tail})"))
