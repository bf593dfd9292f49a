"""Where the quantities of a plot are found after a run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from graphkin.construction.kinds import Fit
from graphkin.geometry import Value
from graphkin.value import frozen


@frozen
class Column:
    """Where one real quantity, or its negative, is found: a row of the block, one of what was given, else a number.

    alone   it is that row, and no other quantity is found there
    """

    row: int | None = None
    given: int | None = None
    number: float = 0.0
    sign: int = 1
    alone: bool = False

    @property
    def known(self) -> float | None:
        """The number that it is at all positions."""
        return self.sign * self.number if self.row is None and self.given is None else None

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

    @property
    def known(self) -> complex | None:
        """The vector that it is at all positions."""
        x, y = self.x.known, self.y.known
        return None if x is None or y is None else complex(x, y)


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
class Columns:
    """Where the quantities of a table come from; of most there is nothing to be done where they are read.

    known       those that are the same at all positions
    pairs, rows names, and what they are alone in
    """

    places: Mapping[Any, Place]
    known: Mapping[Any, Value]
    pairs: tuple[tuple[Any, int], ...]
    rows: tuple[tuple[Any, int], ...]

    @classmethod
    def of(cls, places: Mapping[Any, Place]) -> Columns:
        known = {name: place.known for name, place in places.items() if isinstance(place, Column | Vector)}
        alone = [(name, place) for name, place in places.items() if isinstance(place, Column | Pair) and place.alone]
        return cls(
            places,
            {name: value for name, value in known.items() if value is not None},
            tuple((name, place.number) for name, place in alone if isinstance(place, Pair)),
            tuple((name, place.row) for name, place in alone if isinstance(place, Column) and place.row is not None),
        )
