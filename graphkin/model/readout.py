"""Values read by name: what a drawing, a sweep or the analysis answers, as numbers with their unit.

>>> import graphkin
>>> drawing = graphkin.Drawing.of(graphkin.load("ex3-1"))
>>> drawing.omega["3"], drawing.v["C"].magnitude
(-3.91933 rad/s, 0.188128 m/s)
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import field
from functools import cached_property
from typing import TYPE_CHECKING, Any, Generic, TypeAlias, TypeVar, assert_never, cast

import numpy as np

from graphkin.base.cache import kept
from graphkin.base.geometry import Value
from graphkin.base.value import frozen
from graphkin.construction import Plot
from graphkin.errors import GraphkinError, NoSuchName, Where
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.quantities import Quantity, kinds, named
from graphkin.model.units import Measured, Number, Numbers, Vector, Vectors, measured

_M = TypeVar("_M", bound=Measured, covariant=True)
_N = TypeVar("_N", bound=Measured, covariant=True)  # what is read of signed quantities
_V = TypeVar("_V", bound=Measured, covariant=True)  # and of vectors
MeasuredValue: TypeAlias = Number | Vector | Numbers  # a value with its unit, of one position or of many (n,)

_TURNS = {"theta": "rad", "omega": "rad/s", "alpha": "rad/s^2"}
"""Tables of links: the frame, by the name that it always has, stands still."""


class NamedValues(Mapping[str, _M]):
    """Values by the name of a link, a point or a slide; a name that is not there raises KeyError and says which are."""

    def __init__(self, owner: Readable[Any, Any], word: str) -> None:
        self._owner, self._word = owner, word

    @property
    def _names(self) -> tuple[str, ...]:
        mechanism = self._owner.mechanism
        if self._word == "s":
            return tuple(pair.name for pair in mechanism.pairs if pair.path is not None)
        return mechanism.moving if self._word in _TURNS else mechanism.points

    def __getitem__(self, name: str) -> _M:
        if name == FRAME and self._word in _TURNS:
            return cast(_M, measured(0.0, _TURNS[self._word]))
        try:
            return cast(_M, self._owner.quantity(f"{self._word} {name}"))
        except GraphkinError as problem:
            if isinstance(problem, KeyError) or not hasattr(problem, "possible"):
                raise
            where = Where("position" if self._word == "path" else self._word)
            raise NoSuchName(where, str(name), self._names) from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)

    def __repr__(self) -> str:
        return "{" + ", ".join(f"{name!r}: {self[name]!r}" for name in self) + "}"


class _Table:
    """A table of a readable, by the word of its quantities."""

    def __init__(self, word: str) -> None:
        self._word = word

    def __set__(self, owner: object, value: object) -> None:
        raise AttributeError(f"{self._word} is read off and cannot be set")


class _SignedTable(_Table):
    def __get__(self, owner: Readable[_N, _V], kind: type) -> NamedValues[_N]:
        return NamedValues(owner, self._word)


class _VectorTable(_Table):
    def __get__(self, owner: Readable[_N, _V], kind: type) -> NamedValues[_V]:
        return NamedValues(owner, self._word)


class Readable(Generic[_N, _V]):
    """A thing that is read by name: a drawing, a sweep, a state.

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

    def quantity(self, text: str) -> _N | _V:
        raise NotImplementedError

    theta, omega, alpha = _SignedTable("theta"), _SignedTable("omega"), _SignedTable("alpha")
    s, x, y = _SignedTable("s"), _SignedTable("x"), _SignedTable("y")
    position, v, a = _VectorTable("path"), _VectorTable("v"), _VectorTable("a")


@frozen
class State(Readable[Number | Numbers, Vector | Vectors]):
    """Positions, velocities and accelerations at one position or at many, by one of the two roads.

    source      all of it as plain tables, or what reads them off when they are first asked for
    plot        the finished drawing, where this was drawn (`graphkin.replay`)
    places      by text where that holds a quantity as it is: the table, the name there and the unit, or an empty table
    refused     of `Mechanism.variants`, by its number, what is wrong with one: its values are nan
    """

    source: Motions | Callable[[], Motions]
    plot: Plot | None = None
    places: Mapping[str, tuple[str, str, str]] | None = None
    refused: Mapping[int, GraphkinError] = field(default_factory=dict)

    @cached_property
    def motions(self) -> Motions:
        """All of it as plain tables."""
        return self.source() if callable(self.source) else self.source

    @property
    def values(self) -> tuple[Value, ...]:
        """Each driver's value, in their order [rad or m]."""
        return tuple(getattr(self.source if self.plot is None else self.plot.facts, "values"))  # noqa: B009

    @property
    def mechanism(self) -> Mechanism:
        return self.motions.mechanism

    def quantity(self, text: str) -> Number | Numbers | Vector | Vectors:
        """Whatever `ask` can name, as a number with its unit. Raises what a wrong name raises."""
        if self.places is not None:
            table, name, unit = self.places[str(text)]
            if table:
                value = getattr(self.plot, table)[name]
                return measured(value if isinstance(value, np.ndarray) else value + 0, unit)  # never -0
        return read_off(self.motions, text)

    def __getitem__(self, text: str) -> MeasuredValue:
        return self.quantity(text)

    def __getattr__(self, name: str) -> Any:
        """Whatever else there is: `velocity_at`, of the analysis `condition`, of a drawing its polygons' `velocity`."""
        if name.startswith("_"):
            raise AttributeError(name)
        return getattr(self.motions if hasattr(self.motions, name) else self.plot, name)

    def __repr__(self) -> str:
        by = "construction" if self.plot is not None else "analysis"
        drivers = ", ".join(driver.name for driver in self.mechanism.drivers)
        size = max((np.size(value) for value in self.values), default=1)
        return f"<State of {self.mechanism.name} by {by}: {size} position(s) of {drivers}>"


def read_off(motions: Motions, text: str) -> MeasuredValue:
    """The value that a text names in any motions, with its unit: of a vector the vector."""
    quantities = _quantities_by_text(motions.mechanism)
    text = str(text)
    if (quantity := quantities.get(text)) is None:
        quantity = quantities[text] = named(motions.mechanism, text, Where("quantity"))
    return measured(_value(quantity, motions), quantity.unit)


@kept(4)
def _quantities_by_text(mechanism: Mechanism) -> dict[str, Quantity]:
    """Quantities of a mechanism by their texts, as far as they were read."""
    return {}


def _value(quantity: Quantity, motions: Motions) -> Value:
    """Of a vector the vector alone: its size is not asked for."""
    match quantity:
        case kinds.Moving():
            return quantity.vector(motions)
        case kinds.Track():
            return motions.position[quantity.site.point]
        case kinds.Centre():
            return quantity.place(motions)
        case kinds.Component() | kinds.Displacement() | kinds.Place() | kinds.Quotient() | kinds.Rotation():
            return quantity.answer(motions).value
        case _:
            assert_never(quantity)
