"""Where the quantities of a plot are found after a run."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from graphkin.construction.kinds import Fit
from graphkin.geometry import Value
from graphkin.value import frozen


@frozen
class Column:
    """Where a real quantity, or its negative, is found: in a row, a part of a vector, what was given, or a number."""

    row: int | None = None
    part: int | None = None
    given: int | None = None
    number: float = 0.0
    sign: int = 1

    @property
    def known(self) -> float | None:
        """The number that it is at all positions."""
        return self.sign * self.number if self.row is self.part is self.given is None else None


@frozen
class Vector:
    """A complex quantity."""

    x: Column
    y: Column

    @property
    def known(self) -> complex | None:
        """The vector that it is at all positions."""
        x, y = self.x.known, self.y.known
        return None if x is None or y is None else complex(x, y)


@frozen
class Pair:
    """A vector whose parts lie side by side, by its number among these."""

    number: int


@frozen
class Judged:
    """What is worked out from all the rest where somebody wants to know: a group's sense (0) or its sine (1)."""

    step: Fit
    which: int


@frozen
class Late:
    """What a second run tells where somebody wants to know: a number of its own, or its negative."""

    number: int
    sign: int


@frozen
class LateVector:
    """A vector of which parts are told late."""

    x: Late | Column
    y: Late | Column


Place = Column | Vector | Pair | Judged | Late | LateVector
"""Where a quantity of the plot comes from."""

Entry = tuple[str, Any]
"""A table of a plot, and a name in it."""

Own = Column | Pair
"""What can be handed out as it lies there."""


@frozen
class Columns:
    """Where the quantities of a table come from; of most there is nothing to be done where they are read.

    known        all names; what is the same at all positions has its value already
    pairs, rows  names of what is handed out as it lies there
    others       what is copied, or put together
    late         what is worked out when it is asked for
    """

    known: Mapping[Any, Value]
    pairs: tuple[tuple[Any, int], ...]
    rows: tuple[tuple[Any, int], ...]
    others: tuple[tuple[Any, Column | Vector | Pair], ...]
    late: Mapping[Any, Judged | Late | LateVector]

    @classmethod
    def of(cls, places: Mapping[Any, Place], owned: Mapping[Any, Own]) -> Columns:
        known = {name: place.known if isinstance(place, Column | Vector) else None for name, place in places.items()}
        pairs = tuple((name, place.number) for name, place in owned.items() if isinstance(place, Pair))
        columns = [(name, place.row) for name, place in owned.items() if isinstance(place, Column)]
        rows = tuple((name, row) for name, row in columns if row is not None)
        rest = {name: place for name, place in places.items() if known[name] is None and name not in owned}
        late = {name: place for name, place in rest.items() if isinstance(place, Judged | Late | LateVector)}
        others = tuple((name, place) for name, place in rest.items() if isinstance(place, Column | Vector | Pair))
        return cls(known, pairs, rows, others, late)


def told_apart(tables: Mapping[str, Mapping[Any, Place]]) -> dict[str, Columns]:
    """By table; what lies somewhere is handed out as it is to one quantity, if no other table tells it, too."""
    users: dict[object, set[str]] = {}
    for table, places in tables.items():
        for place in places.values():
            users.setdefault(_where(place), set()).add(table)
    return {
        table: Columns.of(places, {
            name: place for name, place in _first_ones(places).items() if len(users[_where(place)]) == 1
        })
        for table, places in tables.items()
    }  # fmt: skip


def _first_ones(places: Mapping[Any, Place]) -> dict[Any, Own]:
    """The first quantity that is what lies at each place, and nothing is to be done with it."""
    first: dict[object, tuple[Any, Own]] = {}
    for name, place in places.items():
        if isinstance(place, Pair) or (isinstance(place, Column) and place.row is not None and place.sign == 1):
            first.setdefault(_where(place), (name, place))
    return dict(first.values())


def _where(place: Place) -> object:
    """The row or the pair that a quantity lies in; else nothing that could be shared."""
    return (Pair, place.number) if isinstance(place, Pair) else (Column, getattr(place, "row", None))
