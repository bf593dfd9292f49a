"""Many mechanisms, on any executor of `concurrent.futures`: threads, processes, or a cluster's.

>>> [len(result.values) for result in sweep_many(["ex3-1", "ex3-5"], ["0:90:30"])]
[4, 4]
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import Executor
from functools import partial
from pathlib import Path

import numpy as np

from graphkin import api, sweeps
from graphkin.errors import GraphkinError
from graphkin.mechanism import Mechanism
from graphkin.sending import ahead, batched
from graphkin.sweeps import Road, Series
from graphkin.value import frozen

__all__ = ["Swept", "sweep_many"]

Source = Mechanism | str | Path


@frozen
class Swept:
    """The sweep of one of many mechanisms, as data that goes between processes; or the error that it met.

    values  of the driver that names the positions (n,) [rad, m]; empty where there was an error
    reach   the least and the greatest value of that driver that is reached [rad, m]
    """

    name: str
    driver: str
    values: np.ndarray
    series: tuple[Series, ...]
    reach: tuple[float, float]
    error: GraphkinError | None = None

    def __getitem__(self, name: str) -> Series:
        return next(entry for entry in self.series if entry.name == name)


def sweep_many(
    mechanisms: Iterable[Source],
    ranges: Sequence[str] = (),
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
    if executor is None:
        for source in mechanisms:
            yield _swept(source, ranges, of, by)
        return
    work = partial(_batch, ranges=ranges, of=of, by=by)
    yield from ahead(executor, work, batched(mechanisms, batch), in_flight)


def _batch(sources: list[Source], ranges: Sequence[str], of: Sequence[str], by: Road) -> list[Swept]:
    return [_swept(source, ranges, of, by) for source in sources]


def _swept(source: Source, ranges: Sequence[str], of: Sequence[str], by: Road) -> Swept:
    try:
        mechanism = source if isinstance(source, Mechanism) else api.load(source)
        found = sweeps.sweep(api.plan(mechanism), ranges, of, by)
    except GraphkinError as error:
        name = source.name if isinstance(source, Mechanism) else Path(source).stem
        return Swept(name, "", np.empty(0), (), (np.nan, np.nan), error)
    return Swept(mechanism.name, found.course.driver.name, found.values, found.series, found.course.reach)
