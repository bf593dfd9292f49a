"""Units: SI inside, mm and degrees at the edge, and numbers with their unit that a program reads off.

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
from typing import TYPE_CHECKING, Any, TypeVar, cast, overload

import numpy as np

from graphkin.base.geometry import Array, Real, Value
from graphkin.base.value import frozen
from graphkin.errors import NotAVector, OtherUnit

_Plain = TypeVar("_Plain", bound=np.ndarray)

GRAVITY = 9.80665  # standard acceleration of gravity [m/s^2]


@frozen
class Unit:
    """A unit at the edge.

    name    in plain text, as files and tables have it: "deg", "mm", "rad/s^2"; nothing for a quotient
    sign    in print: "°", "mm", "rad/s²"
    factor  by what SI values are multiplied
    """

    name: str
    sign: str
    factor: float = 1.0

    @property
    def after(self) -> str:
        """The sign as it stands after a number: degrees close to it, nothing for a quotient."""
        return self.sign if self.sign in ("°", "") else f" {self.sign}"

    def shown(self, value: float) -> str:
        """`41.2°`, `20 mm`: an SI value in six digits."""
        return significant(value * self.factor, 6) + self.after


EDGE = {
    "rad": Unit("deg", "°", 180 / math.pi), "m": Unit("mm", "mm", 1000.0),
    "rad/s": Unit("rad/s", "rad/s"), "m/s": Unit("m/s", "m/s"),
    "rad/s^2": Unit("rad/s^2", "rad/s²"), "m/s^2": Unit("m/s^2", "m/s²"), "1": Unit("", ""),
}  # fmt: skip
"""By SI unit, how results are shown."""

IN_GRAVITY = Unit("g", "g", 1 / GRAVITY)  # the second unit in which accelerations are shown


def driven(slides: bool) -> str:
    """The SI unit of a driver's value: of one that slides, else of one that turns."""
    return "m" if slides else "rad"


_EXACT = 1e-9  # a figure that is off by no more than this part is exact


def significant(value: float, digits: int) -> str:
    """A figure in so many digits as Python writes them, `1.200e-05`; fewer only of what is exact with fewer. Zeros at
    its end are kept: 9.1 is 9.1, and 9.1002 to four digits is 9.100."""
    text = f"{value:.{digits}g}"
    if math.isfinite(value) and not math.isclose(float(text), value, rel_tol=_EXACT):
        text = f"{value:#.{digits}g}"
    mantissa, mark, exponent = text.partition("e")
    return mantissa.removesuffix(".") + mark + exponent


_TURNING = ("rad", "rad/s", "rad/s^2")
_MOVING = ("m", "m/s", "m/s^2")


class Measured:
    """A value, or an array of them, in the SI `unit`: "rad", "rad/s", "rad/s^2", "m", "m/s", "m/s^2", "1"."""

    unit: str = ""

    @property
    def si(self) -> Value:
        """The value as a plain number or array."""
        raise NotImplementedError

    @property
    def degrees(self) -> Value:
        """An angle in degrees; of angular velocities and accelerations, degrees per second (squared)."""
        return self._times(180 / math.pi, _TURNING, "degrees")

    @property
    def rpm(self) -> Value:
        """An angular velocity in revolutions per minute."""
        return self._times(30 / math.pi, ("rad/s",), "rpm")

    @property
    def mm(self) -> Value:
        """A length in millimetres; of velocities and accelerations, millimetres per second (squared)."""
        return self._times(1000.0, _MOVING, "mm")

    @property
    def magnitude(self) -> Number | Numbers:
        """The size: of a vector its length, of a signed number that without its sign."""
        return measured(np.abs(self.si), self.unit)

    @property
    def direction(self) -> Real:
        """The direction of a vector, in degrees from +x, counter-clockwise, from 0 to below 360."""
        degrees = np.mod(np.degrees(np.angle(self._vector("direction"))), 360.0) % 360.0
        return degrees if np.ndim(degrees) else float(degrees)

    @property
    def x(self) -> Number | Numbers:
        """Of a vector or a place, the part along x."""
        return measured(np.real(self._vector("x")), self.unit)

    @property
    def y(self) -> Number | Numbers:
        """Of a vector or a place, the part along y."""
        return measured(np.imag(self._vector("y")), self.unit)

    def _times(self, factor: float, units: tuple[str, ...], name: str) -> Value:
        if self.unit not in units:
            raise OtherUnit(name, units, self.unit)
        return self.si * factor

    def _vector(self, name: str) -> Value:
        if not np.iscomplexobj(self.si):
            raise NotAVector(name)
        return self.si


class Number(Measured, float):
    """A float with its unit."""

    if TYPE_CHECKING:
        degrees: float
        rpm: float
        mm: float
        magnitude: Number

    def __new__(cls, value: float, unit: str) -> Number:
        made = float.__new__(cls, value)
        made.unit = unit
        return made

    @property
    def si(self) -> float:
        return float(self)

    def __repr__(self) -> str:
        edge = EDGE.get(self.unit)
        beside = f" ({edge.shown(float(self))})" if edge is not None and self.unit in ("rad", "m") else ""
        return f"{float(self):.6g} {self.unit}".removesuffix(" 1") + beside

    def __reduce__(self) -> tuple[object, ...]:
        return Number, (float(self), self.unit)


class Vector(Measured, complex):
    """A complex number with its unit: x + y j."""

    if TYPE_CHECKING:
        mm: complex
        magnitude: Number
        direction: float
        x: Number
        y: Number

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

    def __reduce__(self) -> tuple[object, ...]:
        return Vector, (complex(self), self.unit)


class Numbers(Measured, np.ndarray):
    """An array (n,) with its unit, over positions. It shares the memory of what it was made of, and cannot be written
    into, as what is read off later hangs on it, too; `numpy.array` makes a copy."""

    if TYPE_CHECKING:
        degrees: Array
        rpm: Array
        mm: Array
        magnitude: Numbers
        direction: Array
        x: Numbers
        y: Numbers

        def _times(self, factor: float, units: tuple[str, ...], name: str) -> Array: ...

    def __new__(cls, values: Array, unit: str) -> Numbers:
        made: Numbers = np.asarray(values).view(cls)
        made.unit, made.flags.writeable = unit, False
        return made

    @property
    def si(self) -> np.ndarray:
        return self.view(np.ndarray)

    def __array_wrap__(self, array: _Plain, context: object = None, return_scalar: bool = False) -> _Plain:
        """The result of a calculation as a plain number or array: it has no unit any more."""
        return cast(_Plain, np.asarray(array)[()])

    def __getitem__(self, key: Any) -> Any:
        return measured(self.si[key], self.unit)

    def __iter__(self) -> Iterator[Any]:
        return (measured(value, self.unit) for value in self.si)

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), (self.si, self.unit)

    def __repr__(self) -> str:
        return f"{self.si!r} {self.unit}".removesuffix(" 1")


class Vectors(Numbers):
    """An array of complex numbers with its unit, over positions."""


@overload
def measured(value: float, unit: str) -> Number: ...
@overload
def measured(value: complex, unit: str) -> Number | Vector: ...
@overload
def measured(value: Array, unit: str) -> Numbers: ...
def measured(value: Value, unit: str) -> Number | Vector | Numbers:
    """A `Number`, a `Vector`, or an array of either."""
    if isinstance(value, np.ndarray) and value.ndim:
        made = value.view(Vectors if value.dtype.kind == "c" else Numbers)
        made.unit, made.flags.writeable = unit, False
        return made
    plain = value.item() if isinstance(value, np.generic | np.ndarray) else value
    return Vector(plain, unit) if isinstance(plain, complex) else Number(plain, unit)
