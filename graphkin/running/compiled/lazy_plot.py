"""A plot over many positions whose tables are filled when they are read."""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Mapping, MutableMapping, Sequence
from dataclasses import fields, replace
from typing import Any

import numpy as np

from graphkin.construction.fitting import sense_and_sine
from graphkin.construction.kinds import Fit
from graphkin.construction.plot import Facts, Plot
from graphkin.geometry import Value
from graphkin.value import frozen

TABLES = tuple(field.name for field in fields(Plot) if field.name not in ("facts", "near", "follows"))


@frozen
class Column:
    """Where one real quantity, or its negative, is found: a row of the block, one of what was given, else a number.

    alone   no other quantity is found in that row
    """

    row: int | None = None
    given: int | None = None
    number: float = 0.0
    sign: int = 1
    alone: bool = False

    def of(self, rows: Sequence[np.ndarray] | np.ndarray, given: Sequence[np.ndarray]) -> Value:
        """The quantity without its sign, () or (n,)."""
        if self.row is not None:
            return rows[self.row]
        return self.number if self.given is None else given[self.given][()]


@frozen
class Vector:
    """A complex quantity."""

    x: Column
    y: Column


@frozen
class Pair:
    """A vector whose parts lie side by side, by its number among these; `alone`: no other quantity is this vector."""

    number: int
    alone: bool = False


@frozen
class Judged:
    """What is worked out from all the rest where somebody wants to know: a group's sense (0) or its sine (1)."""

    step: Fit
    which: int


Place = Column | Vector | Pair | Judged
"""Where a quantity of the plot comes from."""


@frozen
class Patch:
    """Positions that were replayed plainly: their numbers (m,), and what that gave."""

    rows: np.ndarray
    plot: Plot


@frozen
class Numbers:
    """What a program gives: real numbers (rows, n) and vectors (pairs, n), beside what it was given, () or (n,).

    What is one quantity alone is handed out as it lies there, all else as a copy: what is done with an array that was
    read changes no other.
    """

    block: np.ndarray
    vectors: np.ndarray
    given: tuple[np.ndarray, ...]

    @property
    def count(self) -> int:
        """Of positions."""
        return int(self.block.shape[1])

    def read(self, column: Column | Vector | Pair) -> Value:
        """A scalar, or an array of its own (n,)."""
        if isinstance(column, Pair):
            found = self.vectors[column.number]
            return found if column.alone else found.copy()
        if isinstance(column, Column):
            found = column.of(self.block, self.given)
            if column.alone and column.sign == 1:
                return found
            return np.multiply(column.sign, found) if np.ndim(found) else column.sign * found
        x, y = (part.of(self.block, self.given) for part in (column.x, column.y))
        if not np.ndim(x) and not np.ndim(y):
            return complex(column.x.sign * x, column.y.sign * y)
        vector = np.empty(self.count, dtype=complex)
        np.multiply(column.x.sign, x, out=vector.real)
        np.multiply(column.y.sign, y, out=vector.imag)
        return vector


class LazyQuantities(MutableMapping[Any, Value]):
    """Quantities by name, each made when it is first read."""

    def __init__(self, plot: LazyPlot, table: str, columns: Mapping[Any, Place]) -> None:
        self.plot, self.table = plot, table
        self.columns: dict[Any, Place | None] = {**columns}
        self.read: dict[Any, Value] = {}

    def __getitem__(self, name: Hashable) -> Value:
        if name not in self.read and (place := self.columns[name]) is not None:
            return self.read.setdefault(name, self.plot.looked_up(self.table, name, place))
        return self.read[name]

    def __setitem__(self, name: Hashable, value: Value) -> None:
        self.columns.setdefault(name, None)
        self.read[name] = value

    def __delitem__(self, name: Hashable) -> None:
        del self.columns[name]
        self.read.pop(name, None)

    def __iter__(self) -> Iterator[Any]:
        return iter(self.columns)

    def __len__(self) -> int:
        return len(self.columns)

    def __repr__(self) -> str:
        return repr(dict(self))


class LazyPlot(Plot):
    """A finished plot; of what it holds, only what is read is put into arrays by itself."""

    @classmethod
    def of(
        cls, standing: Facts, columns: Mapping[str, Mapping[Any, Place]], numbers: Numbers,
        patches: Sequence[Patch] = (),
    ) -> LazyPlot:  # fmt: skip
        """The plot of what a program gives.

        standing  facts with the drivers at other values
        columns   where each quantity is found, by table and name
        patches   positions told otherwise
        """
        plot = cls.__new__(cls)
        plot.__dict__ |= {"near": {}, "_standing": standing, "_columns": columns, "_numbers": numbers}
        plot.__dict__["_patches"] = patches
        return plot

    def looked_up(self, table: str, name: Hashable, place: Place) -> Value:
        """A quantity of a table, in an array of its own."""
        known = self.__dict__
        numbers: Numbers = known["_numbers"]
        found = sense_and_sine(place.step, self)[place.which] if isinstance(place, Judged) else numbers.read(place)
        patches = [(patch.rows, getattr(patch.plot, table)[name]) for patch in known["_patches"]]
        return _patched(found, numbers.count, patches) if patches else found

    def __getattr__(self, name: str) -> Any:
        """Tables and facts, which a plot has as attributes, when they are first asked for."""
        known = self.__dict__
        if "_numbers" not in known or name not in ("facts", *TABLES):
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
        numbers: Numbers = known["_numbers"]
        found: Any
        if name == "facts":
            standing: Facts = known["_standing"]
            found = replace(standing, values=tuple(value[()] for value in numbers.given[: len(standing.values)]))
        else:
            found = LazyQuantities(self, name, known["_columns"][name])
        return known.setdefault(name, found)


def _patched(value: Value, count: int, patches: Sequence[tuple[np.ndarray, Value]]) -> Value:
    """A quantity with other values at some positions; a scalar remains one where they are no other."""
    if not np.ndim(value):
        if all(np.all(np.equal(found, value)) for _, found in patches):
            return value
        value = np.full(count, value)
    for here, found in patches:
        value[here] = found
    return value
