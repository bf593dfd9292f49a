"""Values read by name: what a drawing, a sweep or the analysis answers, as numbers with their unit.

>>> import graphkin
>>> drawing = graphkin.Drawing.of(graphkin.load("ex3-1"))
>>> drawing.omega["3"], drawing.v["C"].magnitude
(-3.91933 rad/s, 0.188128 m/s)
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from graphkin.errors import GraphkinError, NoSuchName, UnknownQuantity, Where
from graphkin.kept import kept
from graphkin.measured import measured
from graphkin.mechanism import FRAME, Mechanism
from graphkin.motions import Motions
from graphkin.quantities import Quantity, named
from graphkin.value import frozen

__all__ = ["Readable", "State", "Table", "read_off"]

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
    found = _meant(motions.mechanism, text).answer(motions)
    return measured(found.value if found.vector is None else found.vector, found.unit)


@kept(256)
def _meant(mechanism: Mechanism, text: str) -> Quantity:
    """A quantity that is read off again and again is parsed once."""
    return named(mechanism, text, Where("quantity"))
