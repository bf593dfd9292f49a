"""Many mechanisms, on any executor of `concurrent.futures`: threads, processes, or a cluster's.

>>> [len(result.driven) for result in sweep_many(["ex3-1", "ex3-5"], ["0:90:30"])]
[4, 4]
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Executor, Future
from itertools import islice
from pathlib import Path

import numpy as np

from graphkin import api
from graphkin.errors import GraphkinError, NotSwept, Where
from graphkin.mechanism import Mechanism
from graphkin.sweeps import Ranges, Road, Series
from graphkin.value import frozen

__all__ = ["Swept", "sweep_many"]

Source = Mechanism | str | Path


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

    mechanisms  mechanisms, files or library names; taken from the iterable only as they are needed
    executor    where it is done; None: here. Its workers must be able to import graphkin
    batch       mechanisms sent to a worker at once
    in_flight   batches that are sent and not yet given out, at most: memory stays bounded however many there are

    A mechanism that cannot be read, planned or moved gives one `Swept` with its error and stops nothing.
    """
    waiting = iter(mechanisms)
    if executor is None:
        for source in waiting:
            yield _swept(source, ranges, of, by)
        return
    sent: deque[Future[list[Swept]]] = deque()
    try:
        while True:
            while len(sent) < in_flight and (some := list(islice(waiting, batch))):
                sent.append(executor.submit(_batch, some, ranges, of, by))
            if not sent:
                return
            yield from sent.popleft().result()
    finally:
        for future in sent:
            future.cancel()


def _batch(sources: list[Source], ranges: Ranges, of: Sequence[str], by: Road) -> list[Swept]:
    return [_swept(source, ranges, of, by) for source in sources]


def _swept(source: Source, ranges: Ranges, of: Sequence[str], by: Road) -> Swept:
    try:
        mechanism = source if isinstance(source, Mechanism) else api.load(source)
        found = api.sweep(mechanism, ranges, of, by)
    except GraphkinError as error:
        name = source.name if isinstance(source, Mechanism) else Path(source).stem
        return Swept(name, "", np.empty(0), (), (np.nan, np.nan), error)
    return Swept(mechanism.name, found.course.driver.name, found.driven, found.series, found.course.reach)
