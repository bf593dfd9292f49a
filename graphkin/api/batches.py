"""Many mechanisms, on any executor of `concurrent.futures`: threads, processes, or a cluster's.

>>> [len(result.driven) for result in sweep_many(["ex3-1", "ex3-5"], ["0:90:30"])]
[4, 4]
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import field
from functools import partial
from pathlib import Path
from typing import TypeVar

import numpy as np

from graphkin import api
from graphkin.api.drawing import Source, load
from graphkin.base.value import bulky, frozen
from graphkin.base.worklist import ahead, batched
from graphkin.errors import GraphkinError, NotAMechanism, NotSwept, Where
from graphkin.files.variants import Variants
from graphkin.model import quantities
from graphkin.model.mechanism import Mechanism
from graphkin.model.units import Number, Vector
from graphkin.studies.sweeps import Ranges, Road, Series

__all__ = ["Solved", "Swept", "solve_many", "sweep_many"]

Each = Source | partial[Mechanism]  # the last reads one of `Mechanism.variants`
_Done = TypeVar("_Done")
_Value = TypeVar("_Value", covariant=True)


@frozen
class _ByName(Mapping[str, _Value]):
    """Values of one of many mechanisms by their names; each raises the error that the mechanism met."""

    name: str
    found: Mapping[str, _Value]
    error: GraphkinError | None = None

    def __getitem__(self, name: str) -> _Value:
        if self.error is not None:
            raise self.error
        if name not in self.found:
            raise NotSwept(Where(self.name), str(name), tuple(self))
        return self.found[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.found)

    def __len__(self) -> int:
        return len(self.found)


@bulky
class Swept(_ByName[Series]):
    """The sweep of one of many mechanisms, as data that goes between processes; or the error that it met.

    A mapping from quantities to their series, as `Sweep` is.

    driven  values of the driver that names the positions (n,) [rad, m]; empty where there was an error
    reach   the least and the greatest value of that driver that is reached [rad, m]
    """

    driver: str = ""
    driven: np.ndarray = field(default_factory=partial(np.empty, 0))
    reach: tuple[float, float] = (np.nan, np.nan)


@bulky
class Solved(_ByName[Number | Vector]):
    """One of many mechanisms at its drawn position, proved by both roads; or the error that it met.

    A mapping from quantities to their values with units, vectors as vectors.
    """


def sweep_many(
    mechanisms: Iterable[Each], ranges: Ranges = (), of: Sequence[str] = (), by: Road = "construction", *,
    executor: Executor | None = None, batch: int = 16, in_flight: int = 8,
) -> Iterator[Swept]:  # fmt: skip
    """Sweep mechanisms one after another, in their order, each over `ranges` with the quantities `of`.

    mechanisms  mechanisms, files or library names, taken from the iterable a batch at a time, as they are needed; or
                `Mechanism.variants`
    executor    where it is done; None: here. Its workers must be able to import graphkin
    batch       mechanisms that go to a worker at once
    in_flight   batches that are sent and not yet given out, at most: memory stays bounded however many there are

    A mechanism that cannot be read, planned or moved gives one `Swept` with its error and stops nothing.
    """
    return _each(mechanisms, partial(_swept, ranges=ranges, of=of, by=by), executor, batch, in_flight)


def solve_many(
    mechanisms: Iterable[Each], of: Sequence[str] = (), *, executor: Executor | None = None, batch: int = 64,
    in_flight: int = 8,
) -> Iterator[Solved]:  # fmt: skip
    """Draw mechanisms in their order, each held against the analysis, and read off quantities `of`.

    of      `["omega 3", "v C"]`; nothing: what each file asks. The rest as `sweep_many` has it.

    >>> slotted = api.load("ex3-1")
    >>> [round(found["omega 3"], 3) for found in solve_many(slotted.variants(AB=[20, 24, 28]), ["omega 3"])]
    [-3.273, -3.919, -4.514]
    """
    return _each(mechanisms, partial(_solved, of=of), executor, batch, in_flight)


def _each(
    items: Iterable[Each], work: Callable[[Each], _Done], executor: Executor | None, batch: int, in_flight: int
) -> Iterator[_Done]:
    """The work done with each, in their order."""
    if isinstance(items, str | Path | Mechanism):
        items = [items]
    if not isinstance(items, Iterable) or (isinstance(items, np.ndarray) and not items.ndim):
        raise NotAMechanism(Where("mechanisms"), type(items).__name__)
    if isinstance(items, Variants):
        items = map(items.reader, range(len(items)))
    if executor is None:
        return map(work, items)
    return ahead(executor, partial(_all, work), batched(items, batch), in_flight)


def _all(work: Callable[[Each], _Done], some: list[Each]) -> list[_Done]:
    return [*map(work, some)]


def _mechanism(source: Each) -> Mechanism:
    if isinstance(source, partial):
        return source()
    return source if isinstance(source, Mechanism) else load(source)


def _name(source: Each) -> str:
    if isinstance(source, partial):
        return str(source.keywords["name"])
    return Path(source).stem if isinstance(source, str | Path) else getattr(source, "name", "")


def _swept(source: Each, ranges: Ranges, of: Sequence[str], by: Road) -> Swept:
    try:
        mechanism = _mechanism(source)
        swept = api.sweep(mechanism, ranges, of, by)
    except GraphkinError as error:
        return Swept(_name(source), {}, error)
    return Swept(mechanism.name, dict(swept), None, swept.driver, swept.driven, swept.course.reach)


def _solved(source: Each, of: Sequence[str]) -> Solved:
    try:
        drawing = api.Drawing.of(_mechanism(source))
        names = of or [name for name in drawing.mechanism.ask if quantities.read(drawing.mechanism, name) is not None]
        return Solved(drawing.mechanism.name, {name: drawing.quantity(name) for name in names})
    except GraphkinError as error:
        return Solved(_name(source), {}, error)
