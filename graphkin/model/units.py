"""Numbers with their unit: what a program reads off a drawing, a sweep or the analysis.

A `Number` is a float, a `Vector` a complex number, `Numbers` and `Vectors` are arrays over positions: all in SI, and
ready to be calculated with. `.degrees`, `.mm`, `.rpm` give them in other units, `.magnitude` and `.direction` take
vectors apart. What is calculated from them is a plain number again.

>>> import graphkin
>>> drawing = graphkin.Drawing.of(graphkin.load("ex3-1"))
>>> drawing.omega["3"], round(drawing.omega["3"].rpm, 2)
(-3.91933 rad/s, -37.43)
>>> round(drawing.theta["3"].degrees, 3), drawing.v["C"].magnitude, round(drawing.v["C"].direction, 3)
(105.61, 0.188128 m/s, 15.61)
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from graphkin.base.geometry import Value
from graphkin.model.quantities import EDGE

__all__ = ["Measured", "Number", "Numbers", "Vector", "Vectors", "measured"]

_TURNING = ("rad", "rad/s", "rad/s^2")
_MOVING = ("m", "m/s", "m/s^2")


class Measured:
    """A value, or an array of them, in the SI `unit`: "rad", "rad/s", "rad/s^2", "m", "m/s", "m/s^2", "1"."""

    unit: str = ""

    @property
    def si(self) -> Any:
        """The value as a plain number or array."""
        raise NotImplementedError

    @property
    def degrees(self) -> Any:
        """An angle in degrees; of angular velocities and accelerations, degrees per second (squared)."""
        return self._times(180 / math.pi, _TURNING, "degrees")

    @property
    def rpm(self) -> Any:
        """An angular velocity in revolutions per minute."""
        return self._times(30 / math.pi, ("rad/s",), "rpm")

    @property
    def mm(self) -> Any:
        """A length in millimetres; of velocities and accelerations, millimetres per second (squared)."""
        return self._times(1000.0, _MOVING, "mm")

    @property
    def magnitude(self) -> Any:
        """The size: of a vector its length, of a signed number that without its sign."""
        return measured(np.abs(self.si), self.unit)

    @property
    def direction(self) -> Any:
        """Where a vector points, in degrees from +x, counter-clockwise, from 0 to below 360."""
        return _plain(np.mod(np.degrees(np.angle(self._vector("direction"))), 360.0) % 360.0)

    @property
    def x(self) -> Any:
        """Of a vector or a place, the part along x."""
        return measured(np.real(self._vector("x")), self.unit)

    @property
    def y(self) -> Any:
        """Of a vector or a place, the part along y."""
        return measured(np.imag(self._vector("y")), self.unit)

    def _times(self, factor: float, units: tuple[str, ...], name: str) -> Any:
        if self.unit not in units:
            raise AttributeError(f"{name} is of a value in {', '.join(units)}; this one is in {self.unit or 'no unit'}")
        return _plain(self.si * factor)

    def _vector(self, name: str) -> Any:
        if not np.iscomplexobj(self.si):
            raise AttributeError(f"{name} is of a vector; this is a number with a sign. `v C` and `path C` are vectors")
        return self.si


class Number(Measured, float):
    """A float with its unit."""

    def __new__(cls, value: float, unit: str) -> Number:
        made = float.__new__(cls, value)
        made.unit = unit
        return made

    @property
    def si(self) -> float:
        return float(self)

    def __repr__(self) -> str:
        shown = EDGE.get(self.unit)
        beside = f" ({shown.shown(float(self))})" if shown is not None and self.unit in ("rad", "m") else ""
        return f"{float(self):.6g} {self.unit}".removesuffix(" 1") + beside

    def __reduce__(self) -> Any:
        return Number, (float(self), self.unit)


class Vector(Measured, complex):
    """A complex number with its unit: x + y j."""

    def __new__(cls, value: complex, unit: str) -> Vector:
        made = complex.__new__(cls, value)
        made.unit = unit
        return made

    @property
    def si(self) -> complex:
        return complex(self)

    def __repr__(self) -> str:
        if self.unit == "m":
            return f"({self.real * 1e3:.6g}, {self.imag * 1e3:.6g}) mm"
        return f"{self.magnitude!r} at {self.direction:.4f}°"

    def __reduce__(self) -> Any:
        return Vector, (complex(self), self.unit)


class Numbers(Measured, np.ndarray):
    """An array (n,) with its unit, over positions.

    It shares the memory of what it was made of, and cannot be written into, as what is read off later hangs on it, too;
    `numpy.array` makes a copy.
    """

    def __new__(cls, values: Any, unit: str) -> Numbers:
        made: Numbers = np.asarray(values).view(cls)
        made.unit, made.flags.writeable = unit, False
        return made

    @property
    def si(self) -> np.ndarray:
        return self.view(np.ndarray)

    def __array_wrap__(self, array: Any, context: Any = None, return_scalar: bool = False) -> Any:
        """What is calculated from it has no unit any more."""
        return np.asarray(array)[()]

    def __getitem__(self, key: Any) -> Any:
        return measured(self.si[key], self.unit)

    def __iter__(self) -> Iterator[Any]:
        return (measured(value, self.unit) for value in self.si)

    def __reduce__(self) -> Any:
        return type(self), (self.si, self.unit)

    def __repr__(self) -> str:
        return f"{self.si!r} {self.unit}".removesuffix(" 1")


class Vectors(Numbers):
    """An array of complex numbers with its unit, over positions."""


def measured(value: Value, unit: str) -> Any:
    """A `Number`, a `Vector`, or an array of either."""
    if isinstance(value, np.ndarray) and value.ndim:
        made = value.view(Vectors if value.dtype.kind == "c" else Numbers)
        made.unit, made.flags.writeable = unit, False
        return made
    number = value.item() if isinstance(value, np.generic | np.ndarray) else value
    return Vector(number, unit) if isinstance(number, complex) else Number(number, unit)


def _plain(value: Any) -> Any:
    return value if np.ndim(value) else float(value)
