"""A plot over many positions whose tables are filled when they are read."""

from __future__ import annotations

from collections.abc import Callable, Mapping, MutableMapping, Sequence
from dataclasses import field, fields, replace
from functools import cached_property, partial
from typing import Any

import numpy as np

from graphkin.construction.fitting import sense_and_sine
from graphkin.construction.plot import Facts, Plot
from graphkin.geometry import Value
from graphkin.running.compiled.columns import Column, Columns, Entry, Judged, Late, LateVector, Pair, Vector
from graphkin.value import Lazy, frozen

TABLES = tuple(each.name for each in fields(Plot) if each.name not in ("facts", "near", "follows"))


@frozen
class Patch:
    """Positions that were replayed plainly: their numbers (m,), and what that gave."""

    rows: np.ndarray
    plot: Plot


@frozen
class Numbers:
    """What a program gives: real numbers (rows, n) and vectors (pairs, n), beside what it was given, () or (n,).

    What belongs to one quantity is handed out as it lies there, and cannot be written into, as what is worked out late
    hangs on it, too; all else is handed out as a copy. `numpy.array` makes one of any.
    """

    block: np.ndarray
    vectors: np.ndarray
    given: tuple[np.ndarray, ...]

    @property
    def count(self) -> int:
        """Of positions."""
        return int(self.block.shape[1])

    def read(self, place: Column | Vector | Pair) -> Value:
        """A scalar, or an array of its own (n,)."""
        if isinstance(place, Pair):
            return self.vectors[place.number].copy()
        if isinstance(place, Column):
            return self._signed(place)
        x, y = self._signed(place.x), self._signed(place.y)
        if not np.ndim(x) and not np.ndim(y):
            return complex(x, y)
        vector = np.empty(self.count, dtype=complex)
        vector.real, vector.imag = x, y
        return vector

    def _signed(self, column: Column) -> Value:
        found = self._unsigned(column)
        return found.copy() if column.sign > 0 and isinstance(found, np.ndarray) else column.sign * found

    def _unsigned(self, column: Column) -> Value:
        if column.row is not None:
            return self.block[column.row]
        if column.part is not None:
            vector = self.vectors[column.part // 2]
            return vector.imag if column.part % 2 else vector.real
        return column.number if column.given is None else self.given[column.given][()]


@frozen
class Told:
    """All that a finished plot is read from.

    standing  facts with the drivers at other values
    columns   where each quantity is found, by table and name
    late      gives what is worked out late (k, n) of what was given
    asked     is told what is read late, by table and name
    patches   positions told otherwise
    judged    senses and sines of groups, once they were asked for
    """

    standing: Facts
    columns: Mapping[str, Columns]
    numbers: Numbers
    late: Callable[[Sequence[np.ndarray]], np.ndarray]
    asked: set[Entry] | None = None
    patches: Sequence[Patch] = ()
    judged: dict[str, tuple[Value, Value]] = field(default_factory=dict)

    @property
    def facts(self) -> Facts:
        """With the drivers where they are."""
        given = self.numbers.given[: len(self.standing.values)]
        for value in given:
            value.flags.writeable = False  # what is worked out late is made of it
        return replace(self.standing, values=tuple(value[()] for value in given))

    def table(self, name: str) -> Mapping[Any, Value]:
        """Quantities by name: most are read as they lie there, the others get arrays of their own."""
        columns, vectors, block = self.columns[name], self.numbers.vectors, self.numbers.block
        found = dict(columns.known)
        for key, number in columns.pairs:
            found[key] = vectors[number]
        for key, row in columns.rows:
            found[key] = block[row]
        for key, place in columns.others:
            found[key] = self.numbers.read(place)
        for key in columns.known if self.patches else ():
            if key not in columns.late:
                found[key] = self._patched(name, key, found[key])
        return Table(found, partial(self._made_late, name)) if columns.late else found

    def _patched(self, table: str, key: Any, value: Value) -> Value:
        for patch in self.patches:
            value = _patched(value, self.numbers.count, patch.rows, getattr(patch.plot, table)[key])
        return value

    def _made_late(self, table: str, key: Any) -> Value:
        if self.asked is not None:
            self.asked.add((table, key))
        return self._patched(table, key, self._worked_out(self.columns[table].late[key]))

    @cached_property
    def _late(self) -> np.ndarray:
        return self.late(self.numbers.given)

    def _worked_out(self, place: Judged | Late | LateVector) -> Value:
        if isinstance(place, Late):
            return place.sign * self._late[place.number]
        if isinstance(place, LateVector):
            return self._part(place.x) + 1j * self._part(place.y)
        if (name := place.step.name) not in self.judged:
            self.judged[name] = sense_and_sine(place.step, LazyPlot.of(self))
        return self.judged[name][place.which]

    def _part(self, place: Late | Column) -> Value:
        return self._worked_out(place) if isinstance(place, Late) else self.numbers.read(place)


class Table(Lazy[Value], MutableMapping[str, Value]):
    """A table of a plot, to be written in as any; what is None is made when it is first read."""

    def __init__(self, found: dict[Any, Value], make: Callable[[Any], Value]) -> None:
        self._made, self._make = found, make

    def __setitem__(self, name: str, value: Value) -> None:
        self._made[name] = value

    def __delitem__(self, name: str) -> None:
        del self._made[name]


class LazyPlot(Plot):
    """A finished plot, whose tables are filled when they are first read."""

    @classmethod
    def of(cls, told: Told) -> LazyPlot:
        """The plot of what a program gives."""
        plot = cls.__new__(cls)
        plot.__dict__ |= {"near": {}, "_told": told}
        return plot

    def __reduce__(self) -> tuple[type[Plot], tuple[Any, ...]]:
        """Sent elsewhere it is a plain plot."""
        return Plot, tuple(getattr(self, each.name) for each in fields(Plot))


class _WhenRead:
    """An attribute of a plot that is made when it is first read."""

    def __init__(self, name: str, make: Callable[[Told], Any]) -> None:
        self.name, self.make = name, make

    def __get__(self, plot: LazyPlot | None, owner: type) -> Any:
        if plot is None or "_told" not in plot.__dict__:
            raise AttributeError(f"{owner.__name__!r} object has no attribute {self.name!r}")
        found = plot.__dict__[self.name] = self.make(plot.__dict__["_told"])
        return found


setattr(LazyPlot, "facts", _WhenRead("facts", lambda told: told.facts))  # noqa: B010
for _name in TABLES:
    setattr(LazyPlot, _name, _WhenRead(_name, partial(Told.table, name=_name)))


def _patched(value: Value, count: int, here: np.ndarray, found: Value) -> Value:
    """A quantity with other values at some positions; a scalar remains one where they are no other."""
    if not np.ndim(value):
        if np.all(np.equal(found, value)):
            return value
        value = np.full(count, value)
    elif not value.flags.writeable:
        value = value.copy()
    value[here] = found
    return value
