"""Many mechanisms, on any executor of `concurrent.futures`: threads, processes, or a cluster's.

>>> [len(result.driven) for result in sweep_many(["ex3-1", "ex3-5"], ["0:90:30"])]
[4, 4]
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from graphkin import api, quantities
from graphkin.agreement import Proved
from graphkin.alike import planned_together, proved_together
from graphkin.errors import GraphkinError, NotSwept, Where
from graphkin.mechanism import Mechanism
from graphkin.planning import Method
from graphkin.sending import ahead, batched
from graphkin.sweeps import Ranges, Road, Series
from graphkin.value import frozen

__all__ = ["Solved", "Swept", "solve_many", "sweep_many"]

Source = Mechanism | str | Path
_Done = TypeVar("_Done")


@frozen
class Swept(Mapping[str, Series]):
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

    def __getitem__(self, name: str) -> Series:
        if self.error is not None:
            raise self.error
        found = next((entry for entry in self.series if entry.name == name), None)
        if found is None:
            raise NotSwept(Where("sweep_many"), str(name), tuple(self))
        return found

    def __contains__(self, name: object) -> bool:
        return any(entry.name == name for entry in self.series)

    def __iter__(self) -> Iterator[str]:
        return (entry.name for entry in self.series)

    def __len__(self) -> int:
        return len(self.series)

    def __repr__(self) -> str:
        what = type(self.error).__name__ if self.error else f"{self.driven.size} positions: {', '.join(self)}"
        return f"<Swept {self.name}: {what}>"


def sweep_many(
    mechanisms: Iterable[Source],
    ranges: Ranges = (),
    of: Sequence[str] = (),
    by: Road = "construction",
    *,
    executor: Executor | None = None,
    batch: int = 16,
    in_flight: int = 8,
) -> Iterator[Swept]:
    """Sweep mechanisms one after another, in their order, each over `ranges` with the quantities `of`.

    mechanisms  mechanisms, files or library names; taken from the iterable a batch at a time, as they are needed
    executor    where it is done; None: here. Its workers must be able to import graphkin
    batch       mechanisms done at once; those of one topology in it share a method
    in_flight   batches that are sent and not yet given out, at most: memory stays bounded however many there are

    A mechanism that cannot be read, planned or moved gives one `Swept` with its error and stops nothing.
    """
    return _each(mechanisms, partial(_swept_all, ranges=ranges, of=of, by=by), executor, batch, in_flight)


@frozen
class Solved(Mapping[str, Any]):
    """One of many mechanisms at its drawn position, proved by both roads; or the error that it met.

    A mapping from quantities to their values with units, vectors as vectors.
    """

    name: str
    found: Mapping[str, Any]
    error: GraphkinError | None = None

    def __getitem__(self, name: str) -> Any:
        if self.error is not None:
            raise self.error
        if name not in self.found:
            raise NotSwept(Where("solve_many"), str(name), tuple(self))
        return self.found[name]

    def __contains__(self, name: object) -> bool:
        return name in self.found

    def __iter__(self) -> Iterator[str]:
        return iter(self.found)

    def __len__(self) -> int:
        return len(self.found)


def solve_many(
    mechanisms: Iterable[Source],
    of: Sequence[str] = (),
    *,
    executor: Executor | None = None,
    batch: int = 64,
    in_flight: int = 8,
) -> Iterator[Solved]:
    """Draw mechanisms in their order, each held against the analysis, and read off quantities `of`.

    of      `["omega 3", "v C"]`; nothing: what each file asks. The rest as `sweep_many` has it.

    >>> slotted = api.load("ex3-1")
    >>> variants = (slotted.with_(AB=length) for length in (20, 24, 28))
    >>> [round(found["omega 3"], 3) for found in solve_many(variants, ["omega 3"])]
    [-3.273, -3.919, -4.514]
    """
    return _each(mechanisms, partial(_solved_all, of=of), executor, batch, in_flight)


def _each(
    items: Iterable[Source], work: Callable[[list[Source]], list[_Done]], executor: Executor | None, batch: int,
    in_flight: int,
) -> Iterator[_Done]:  # fmt: skip
    """What is done with each, in their order."""
    if executor is None:
        for some in batched(items, batch):
            yield from work(some)
        return
    yield from ahead(executor, work, batched(items, batch), in_flight)


def _read_all(sources: Sequence[Source]) -> list[Mechanism | GraphkinError]:
    """The mechanisms, and what is wrong with those that cannot be read."""
    return [_read(source) for source in sources]


def _read(source: Source) -> Mechanism | GraphkinError:
    try:
        return source if isinstance(source, Mechanism) else api.load(source)
    except GraphkinError as error:
        return error


def _name(source: Source) -> str:
    return source.name if isinstance(source, Mechanism) else Path(source).stem


def _swept_all(sources: list[Source], ranges: Ranges, of: Sequence[str], by: Road) -> list[Swept]:
    read = _read_all(sources)
    known = iter(planned_together([each for each in read if isinstance(each, Mechanism)]))
    methods = [next(known) if isinstance(each, Mechanism) else None for each in read]
    return [
        _swept(source, each, method, ranges, of, by)
        for source, each, method in zip(sources, read, methods, strict=True)
    ]


def _swept(
    source: Source, read: Mechanism | GraphkinError, method: Method | None, ranges: Ranges, of: Sequence[str], by: Road
) -> Swept:
    try:
        if isinstance(read, GraphkinError):
            raise read
        found = api.sweep(method or read, ranges, of, by)
    except GraphkinError as error:
        return Swept(_name(source), "", np.empty(0), (), (np.nan, np.nan), error)
    return Swept(read.name, found.course.driver.name, found.driven, found.series, found.course.reach)


def _solved_all(sources: list[Source], of: Sequence[str]) -> list[Solved]:
    read = _read_all(sources)
    known = iter(proved_together([each for each in read if isinstance(each, Mechanism)]))
    found = [next(known) if isinstance(each, Mechanism) else None for each in read]
    return [_solved(source, each, proved, of) for source, each, proved in zip(sources, read, found, strict=True)]


def _solved(
    source: Source, read: Mechanism | GraphkinError, proved: tuple[Method, Proved] | None, of: Sequence[str]
) -> Solved:
    try:
        if isinstance(read, GraphkinError):
            raise read
        drawing = api.Drawing(read, proved[0], proved[1].plot) if proved else api.Drawing.of(read)
        names = of or [name for name in read.ask if quantities.read(read, name) is not None]
        return Solved(read.name, {name: drawing.quantity(name) for name in names})
    except GraphkinError as error:
        return Solved(_name(source), {}, error)
