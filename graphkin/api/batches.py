"""Many mechanisms, on any executor of `concurrent.futures`: threads, processes, or a cluster's.

>>> [len(result.driven) for result in sweep_many(["ex3-1", "ex3-5"], ["0:90:30"])]
[4, 4]
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from functools import partial
from pathlib import Path
from typing import Any, ClassVar, TypeVar

import numpy as np

from graphkin import api
from graphkin.base.value import frozen
from graphkin.base.worklist import ahead, batched
from graphkin.errors import GraphkinError, NotSwept, Where
from graphkin.model import quantities
from graphkin.model.mechanism import Mechanism
from graphkin.studies.sweeps import Ranges, Road, Series

__all__ = ["Solved", "Swept", "solve_many", "sweep_many"]

Source = Mechanism | str | Path
_Done = TypeVar("_Done")
_Value = TypeVar("_Value", covariant=True)


class _ByName(Mapping[str, _Value]):
    """Values of one of many mechanisms by their names; each raises the error that the mechanism met."""

    error: GraphkinError | None
    _function: ClassVar[str]

    @property
    def _values(self) -> Mapping[str, _Value]:
        raise NotImplementedError

    def __getitem__(self, name: str) -> _Value:
        if self.error is not None:
            raise self.error
        if name not in self._values:
            raise NotSwept(Where(self._function), str(name), tuple(self))
        return self._values[name]

    def __contains__(self, name: object) -> bool:
        return name in self._values

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)


@frozen
class Swept(_ByName[Series]):
    """The sweep of one of many mechanisms, as data that goes between processes; or the error that it met.

    A mapping from quantities to their series, as `Sweep` is.

    driven  values of the driver that names the positions (n,) [rad, m]; empty where there was an error
    reach   the least and the greatest value of that driver that is reached [rad, m]
    """

    name: str
    driver: str
    driven: np.ndarray
    series: tuple[Series, ...]
    reach: tuple[float, float]
    error: GraphkinError | None = None
    _function: ClassVar[str] = "sweep_many"

    @property
    def _values(self) -> Mapping[str, Series]:
        return {entry.name: entry for entry in self.series}

    def __repr__(self) -> str:
        what = type(self.error).__name__ if self.error else f"{self.driven.size} positions: {', '.join(self)}"
        return f"<Swept {self.name}: {what}>"


@frozen
class Solved(_ByName[Any]):
    """One of many mechanisms at its drawn position, proved by both roads; or the error that it met.

    A mapping from quantities to their values with units, vectors as vectors.
    """

    name: str
    found: Mapping[str, Any]
    error: GraphkinError | None = None
    _function: ClassVar[str] = "solve_many"

    @property
    def _values(self) -> Mapping[str, Any]:
        return self.found


def sweep_many(
    mechanisms: Iterable[Source], ranges: Ranges = (), of: Sequence[str] = (), by: Road = "construction", *,
    executor: Executor | None = None, batch: int = 16, in_flight: int = 8,
) -> Iterator[Swept]:  # fmt: skip
    """Sweep mechanisms one after another, in their order, each over `ranges` with the quantities `of`.

    mechanisms  mechanisms, files or library names; taken from the iterable a batch at a time, as they are needed
    executor    where it is done; None: here. Its workers must be able to import graphkin
    batch       mechanisms that go to a worker at once
    in_flight   batches that are sent and not yet given out, at most: memory stays bounded however many there are

    A mechanism that cannot be read, planned or moved gives one `Swept` with its error and stops nothing.
    """
    return _each(mechanisms, partial(_swept, ranges=ranges, of=of, by=by), executor, batch, in_flight)


def solve_many(
    mechanisms: Iterable[Source], of: Sequence[str] = (), *, executor: Executor | None = None, batch: int = 64,
    in_flight: int = 8,
) -> Iterator[Solved]:  # fmt: skip
    """Draw mechanisms in their order, each held against the analysis, and read off quantities `of`.

    of      `["omega 3", "v C"]`; nothing: what each file asks. The rest as `sweep_many` has it.

    >>> slotted = api.load("ex3-1")
    >>> variants = (slotted.with_(AB=length) for length in (20, 24, 28))
    >>> [round(found["omega 3"], 3) for found in solve_many(variants, ["omega 3"])]
    [-3.273, -3.919, -4.514]
    """
    return _each(mechanisms, partial(_solved, of=of), executor, batch, in_flight)


def _each(
    items: Iterable[Source], work: Callable[[Source], _Done], executor: Executor | None, batch: int, in_flight: int
) -> Iterator[_Done]:
    """The work done with each, in their order."""
    if executor is None:
        return map(work, items)
    return ahead(executor, partial(_all, work), batched(items, batch), in_flight)


def _all(work: Callable[[Source], _Done], some: list[Source]) -> list[_Done]:
    return [*map(work, some)]


def _name(source: Source) -> str:
    return source.name if isinstance(source, Mechanism) else Path(source).stem


def _swept(source: Source, ranges: Ranges, of: Sequence[str], by: Road) -> Swept:
    try:
        mechanism = source if isinstance(source, Mechanism) else api.load(source)
        swept = api.sweep(mechanism, ranges, of, by)
    except GraphkinError as error:
        return Swept(_name(source), "", np.empty(0), (), (np.nan, np.nan), error)
    return Swept(mechanism.name, swept.course.driver.name, swept.driven, swept.series, swept.course.reach)


def _solved(source: Source, of: Sequence[str]) -> Solved:
    try:
        drawing = api.Drawing.of(source if isinstance(source, Mechanism) else api.load(source))
        names = of or [name for name in drawing.mechanism.ask if quantities.read(drawing.mechanism, name) is not None]
        return Solved(drawing.mechanism.name, {name: drawing.quantity(name) for name in names})
    except GraphkinError as error:
        return Solved(_name(source), {}, error)
