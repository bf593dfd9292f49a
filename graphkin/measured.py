"""Numbers with their unit: what a program reads off a drawing, a sweep or the analysis, by the same names.

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
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from graphkin.errors import GraphkinError, NoSuchName, UnknownQuantity, Where
from graphkin.geometry import Value
from graphkin.mechanism import FRAME, Mechanism
from graphkin.motions import Motions
from graphkin.quantities import EDGE, named
from graphkin.value import frozen

__all__ = ["Measured", "Number", "Numbers", "Readable", "State", "Table", "Vector", "Vectors", "measured"]

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
        made = np.asarray(values).view(cls)
        made.unit = unit
        made.flags.writeable = False
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
    array = np.asarray(value)
    if array.ndim:
        return (Vectors if np.iscomplexobj(array) else Numbers)(array, unit)
    return Vector(complex(array), unit) if np.iscomplexobj(array) else Number(float(array), unit)


def _plain(value: Any) -> Any:
    return value if np.ndim(value) else float(value)


# --- by name ----------------------------------------------------------------------------------


_TURNS = {"theta": "rad", "omega": "rad/s", "alpha": "rad/s^2"}
"""Tables of links: the frame, by the name that it always has, stands still."""


class Table(Mapping[str, Any]):
    """Values by the name of a link, a point or a slide; a name that is not there raises KeyError and says which are."""

    def __init__(self, names: Iterable[str], read: Callable[[str], Any], where: str) -> None:
        self._names, self._read, self._where = tuple(names), read, where

    def __getitem__(self, name: str) -> Any:
        if name == FRAME and self._where in _TURNS:
            return measured(0.0, _TURNS[self._where])
        try:
            return self._read(str(name))
        except UnknownQuantity:
            raise NoSuchName(Where(self._where), str(name), self._names) from None
        except GraphkinError as problem:
            if isinstance(problem, KeyError) or not hasattr(problem, "possible"):
                raise
            raise NoSuchName(Where(self._where), str(name), self._names) from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)

    def __repr__(self) -> str:
        return "{" + ", ".join(f"{name!r}: {self[name]!r}" for name in self) + "}"


class Readable:
    """What can be read by name: a drawing, a sweep, a state.

    theta, omega, alpha   of a link: angle [rad], angular velocity [rad/s], angular acceleration [rad/s^2]
    s                     of a named slide, or a wheel on a line: displacement [m]
    position, x, y        of a point [m]
    v, a                  of a point `C`, of the point of link 3 there `B3`, of one seen from another `CB`, `B3B2`:
                          complex [m/s, m/s^2]
    quantity(text)        whatever `ask` can name: `a_k B3B2`, `omega 1 / omega 3`, `v_x E`
    """

    if TYPE_CHECKING:

        @property
        def mechanism(self) -> Mechanism: ...

    def quantity(self, text: str) -> Any:
        raise NotImplementedError

    @property
    def theta(self) -> Table:
        return self._table("theta", self.mechanism.moving)

    @property
    def omega(self) -> Table:
        return self._table("omega", self.mechanism.moving)

    @property
    def alpha(self) -> Table:
        return self._table("alpha", self.mechanism.moving)

    @property
    def s(self) -> Table:
        return self._table("s", [pair.name for pair in self.mechanism.pairs if pair.path is not None])

    @property
    def position(self) -> Table:
        return self._table("path", self.mechanism.points, "position")

    @property
    def x(self) -> Table:
        return self._table("x", self.mechanism.points)

    @property
    def y(self) -> Table:
        return self._table("y", self.mechanism.points)

    @property
    def v(self) -> Table:
        return self._table("v", self.mechanism.points)

    @property
    def a(self) -> Table:
        return self._table("a", self.mechanism.points)

    def _table(self, word: str, names: Iterable[str], where: str = "") -> Table:
        return Table(names, lambda name: self.quantity(f"{word} {name}"), where or word)


@frozen
class State(Readable):
    """Positions, velocities and accelerations at one position or at many, by one of the two roads.

    source      all of it as plain tables, or what reads them off when they are first asked for
    plot        the finished drawing, where this was drawn (`graphkin.replay`)
    """

    source: Motions | Callable[[], Motions]
    plot: Any = None

    @cached_property
    def motions(self) -> Motions:
        """All of it as plain tables."""
        return self.source() if callable(self.source) else self.source

    @property
    def values(self) -> tuple[Any, ...]:
        """Each driver's value, in their order [rad or m]."""
        holding: Any = self.source if self.plot is None else self.plot.facts
        return tuple(holding.values)

    @property
    def mechanism(self) -> Mechanism:
        return self.motions.mechanism

    def quantity(self, text: str) -> Any:
        """Whatever `ask` can name, as a number with its unit. Raises what a wrong name raises."""
        return read_off(self.motions, text)

    def __getitem__(self, text: str) -> Any:
        return self.quantity(text)

    def __getattr__(self, name: str) -> Any:
        """Whatever else there is: `velocity_at`, of the analysis `condition`, of a drawing its polygons' `velocity`."""
        if name.startswith("_"):
            raise AttributeError(name)
        return getattr(self.motions if hasattr(self.motions, name) else self.plot, name)

    @cached_property
    def _size(self) -> int:
        return max((np.size(value) for value in self.values), default=1)

    def __repr__(self) -> str:
        by = "construction" if self.plot is not None else "analysis"
        drivers = ", ".join(driver.name for driver in self.mechanism.drivers)
        return f"<State of {self.mechanism.name} by {by}: {self._size} position(s) of {drivers}>"


def read_off(motions: Motions, text: str) -> Any:
    """What a text names in any motions, with its unit: of a vector the vector."""
    quantity = named(motions.mechanism, text, Where("quantity"))
    found = quantity.answer(motions)
    return measured(found.value if found.vector is None else found.vector, found.unit)
