"""A plot over many positions whose tables are filled when they are read."""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Mapping, MutableMapping, Sequence
from dataclasses import fields, replace
from typing import Any

import numpy as np

from graphkin.construction.fitting import sense_and_sine
from graphkin.construction.plot import Facts, Plot
from graphkin.geometry import Value
from graphkin.running.compiled.columns import Column, Columns, Judged, Pair, Place, Vector
from graphkin.value import frozen

TABLES = tuple(field.name for field in fields(Plot) if field.name not in ("facts", "near", "follows"))


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
            if column.alone:
                return found
            return np.multiply(column.sign, found) if np.ndim(found) else column.sign * found
        x, y = (part.of(self.block, self.given) for part in (column.x, column.y))
        if not np.ndim(x) and not np.ndim(y):
            return complex(column.x.sign * x, column.y.sign * y)
        vector = np.empty(self.count, dtype=complex)
        np.multiply(column.x.sign, x, out=vector.real)
        np.multiply(column.y.sign, y, out=vector.imag)
        return vector


@frozen
class Told:
    """All that a finished plot is read from.

    standing  facts with the drivers at other values
    columns   where each quantity is found, by table and name
    patches   positions told otherwise
    """

    standing: Facts
    columns: Mapping[str, Columns]
    numbers: Numbers
    patches: Sequence[Patch] = ()

    @property
    def facts(self) -> Facts:
        """With the drivers where they are."""
        given = self.numbers.given[: len(self.standing.values)]
        return replace(self.standing, values=tuple(value[()] for value in given))

    def ready(self, columns: Columns) -> dict[Any, Value]:
        """What of a table is read as it lies there, without any work."""
        if self.patches:
            return {}
        found = {**columns.known}
        found.update((name, self.numbers.vectors[number]) for name, number in columns.pairs)
        found.update((name, self.numbers.block[row]) for name, row in columns.rows)
        return found

    def looked_up(self, table: str, name: Hashable, place: Place) -> Value:
        """A quantity of a table, in an array of its own."""
        if isinstance(place, Judged):
            found = sense_and_sine(place.step, LazyPlot.of(self))[place.which]
        else:
            found = self.numbers.read(place)
        patches = [(patch.rows, getattr(patch.plot, table)[name]) for patch in self.patches]
        return _patched(found, self.numbers.count, patches) if patches else found


class LazyQuantities(MutableMapping[Any, Value]):
    """Quantities by name, each made when it is first read."""

    def __init__(self, told: Told, table: str) -> None:
        self.told, self.table = told, table
        self.columns: dict[Any, Place | None] = {**told.columns[table].places}
        self.read = told.ready(told.columns[table])

    def __getitem__(self, name: Hashable) -> Value:
        if name in self.read:
            return self.read[name]
        if (place := self.columns[name]) is None:
            raise KeyError(name)
        return self.read.setdefault(name, self.told.looked_up(self.table, name, place))

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
    def of(cls, told: Told) -> LazyPlot:
        """The plot of what a program gives."""
        plot = cls.__new__(cls)
        plot.__dict__ |= {"near": {}, "_told": told}
        return plot

    def __getattr__(self, name: str) -> Any:
        """Tables and facts, which a plot has as attributes, when they are first asked for."""
        known = self.__dict__
        if "_told" not in known or name not in ("facts", *TABLES):
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
        told: Told = known["_told"]
        return known.setdefault(name, told.facts if name == "facts" else LazyQuantities(told, name))


def _patched(value: Value, count: int, patches: Sequence[tuple[np.ndarray, Value]]) -> Value:
    """A quantity with other values at some positions; a scalar remains one where they are no other."""
    if not np.ndim(value):
        if all(np.all(np.equal(found, value)) for _, found in patches):
            return value
        value = np.full(count, value)
    for here, found in patches:
        value[here] = found
    return value
