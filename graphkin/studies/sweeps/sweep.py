"""A sweep: quantities over the positions of a course, all at once or part by part."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from graphkin.base.value import frozen
from graphkin.errors import NOWHERE, NotSwept, Where
from graphkin.model.mechanism import Mechanism
from graphkin.model.quantities import EDGE, Centre, Quantity, Quotient, named
from graphkin.model.readout import Readable
from graphkin.model.units import Numbers
from graphkin.planning import Method
from graphkin.running.in_numpy import lent
from graphkin.running.other_positions import MANY
from graphkin.running.path import stride
from graphkin.running.recorder import Entry
from graphkin.running.replay_program import VERY_MANY
from graphkin.studies.sweeps.course import Course, course
from graphkin.studies.sweeps.proof import prove
from graphkin.studies.sweeps.quantities import Series, asked, series
from graphkin.studies.sweeps.ranges import Ranges
from graphkin.studies.sweeps.roads import Road, centre_path, moving

Wanted = Mapping[str, Quantity]
"""Quantities, by what they were asked for as."""

PART = 8192
"""Positions done at once: what they need stays in the processor's cache, and memory stays flat."""
FINE_DEG, FINE_PART = 0.5, 0.002
"""How closely angles are followed, so that none jumps by a turn [deg, of the mechanism's size]."""


@frozen
class Sweep(Readable, Mapping[str, Series]):
    """Quantities over positions: a mapping from what was asked for, as it was written, to its `Series`.

    By name it has any other, too, as `Readable` says: `sweep.omega["3"]`, `sweep.v["C"]`, arrays (n,) with their unit.

    t       where on the path (n,)
    driven  values of the driver that names the positions (n,) [rad, m]; `driver` is its name
    undefined   its values at positions that are reached but have no definite motion, and are left out

    >>> import graphkin
    >>> sweep = graphkin.sweep(graphkin.load("ex3-7"), {"AB": [0, 10, 20]}, ["omega 4", "v E"])
    >>> list(sweep), len(sweep.driven), sweep["omega 4"].rpm.round(3)
    (['omega 4', 'v E'], 3, array([2.758, 3.093, 3.171]))
    >>> sweep.theta["4"].degrees.round(3)
    array([168.938, 172.027, 175.327])
    """

    course: Course
    t: np.ndarray
    driven: np.ndarray
    series: tuple[Series, ...]
    undefined: np.ndarray
    by: Road = "construction"

    @property
    def mechanism(self) -> Mechanism:
        return self.course.method.mechanism

    @property
    def driver(self) -> str:
        return self.course.driver.name

    def __getitem__(self, name: str) -> Series:
        found = next((entry for entry in self.series if entry.name == name), None)
        if found is None:
            raise NotSwept(Where("sweep"), str(name), tuple(self))
        return found

    def __iter__(self) -> Iterator[str]:
        return (entry.name for entry in self.series)

    def __len__(self) -> int:
        return len(self.series)

    def quantity(self, text: str) -> Numbers:
        """Whatever `ask` can name, over the positions (n,): of a vector the vectors."""
        found = next((entry for entry in self.series if entry.name == text), None)
        return (found or quantities_at(self.course, [text], self.t, self.by).series[0]).measured

    def __repr__(self) -> str:
        low, high = (f"{end * EDGE[self.course.unit].factor:.6g}" for end in (self.driven.min(), self.driven.max()))
        about = f"{self.mechanism.name}: {self.driver} = {low} to {high} {EDGE[self.course.unit].name}"
        return f"<Sweep of {about}, {self.t.size} positions: {', '.join(self)}>"


def sweep(
    method: Method, ranges: Ranges = (), of: Sequence[str] = (), by: Road = "construction", compiled: bool | None = None
) -> Sweep:
    """Quantities `of` a mechanism over the driver values of `ranges`; see `course` and `asked` for what is usual, and
    `Course` for `compiled`.

    Angles are continuous along the sweep, from between 0 and a full turn at its first position. Raises RoadsDiffer
    where the two roads do not agree.
    """
    found, names = replace(course(method, ranges), compiled=compiled), asked(method.mechanism, of)
    prove(found)
    return sweep_over(found, names, by)


def sweep_over(course: Course, names: Sequence[str], by: Road = "construction") -> Sweep:
    """The same over a course."""
    parts = in_parts(course, names, by)
    return next(parts) if course.t.size <= PART else _joined(parts, course.t.size)


def in_parts(course: Course, names: Sequence[str], by: Road = "construction", size: int = PART) -> Iterator[Sweep]:
    """The same, some positions at a time: a sweep of any length needs no more memory."""
    wanted = _read(course, names)
    turned = _Turned(course, wanted, by)
    course = replace(course, compiled=course.t.size >= VERY_MANY or None) if course.compiled is None else course
    asked = _asked(course, wanted, by, turned) if course.t.size > size else None
    for begin in range(0, course.t.size, size):
        here = slice(begin, begin + size)
        yield _defined(replace(_at(course, wanted, course.t[here], by, turned, asked), driven=course.values[here]))


def _asked(course: Course, wanted: Wanted, by: Road, turned: _Turned) -> set[Entry]:
    """What the quantities are read from, as the first few positions show."""
    found = set[Entry]()
    _at(course, wanted, course.t[:MANY], by, turned, found)
    return found


def _defined(found: Sweep) -> Sweep:
    """Without positions at which some quantity has no value; quotients and centres may lie at infinity."""
    own = [entry.values for entry in found.series if not isinstance(entry.quantity, Centre | Quotient)]
    finite = [np.isfinite(values) for values in own]
    if all(each.all() for each in finite):
        return found
    good = np.all(finite, axis=0)
    series = tuple(
        replace(entry, values=entry.values[good], vectors=None if entry.vectors is None else entry.vectors[good])
        for entry in found.series
    )
    return replace(found, t=found.t[good], driven=found.driven[good], series=series, undefined=found.driven[~good])


def quantities_at(course: Course, names: Sequence[str], t: np.ndarray, by: Road = "construction") -> Sweep:
    """Quantities at positions t (n,) of the course."""
    wanted = _read(course, names)
    return _at(course, wanted, t, by, _Turned(course, wanted, by))


def _read(course: Course, names: Sequence[str]) -> Wanted:
    return {name: named(course.method.mechanism, name, NOWHERE) for name in names}


def _at(
    course: Course, wanted: Wanted, t: np.ndarray, by: Road, turned: _Turned, asked: set[Entry] | None = None
) -> Sweep:
    motions = moving(course.method, course.path, t, by, asked, course.compiled)
    found = []
    for name, quantity in wanted.items():
        if isinstance(quantity, Centre) and by == "construction":
            places = centre_path(course.method, course.path, t, quantity.links)
            found.append(Series(name, quantity, np.abs(places), places))
        else:
            found.append(turned.on(series(name, quantity, motions, t.size), t))
    series_there = tuple(entry.without_noise(course.method.mechanism.usual) for entry in found)
    return Sweep(course, t, np.asarray(course.value(t)), series_there, np.empty(0), by)


class _Turned:
    """How far links have turned since the first position: angles that go on beyond a full turn."""

    def __init__(self, course: Course, wanted: Wanted, by: Road) -> None:
        self.tables: dict[str, np.ndarray] = {}
        angles = {name: quantity for name, quantity in wanted.items() if quantity.unit == "rad"}
        if not angles:
            return
        low, high = float(course.t.min()), float(course.t.max())
        count = 2 + int((high - low) / stride(course.method, course.path.pace, FINE_DEG, FINE_PART))
        self.t = np.linspace(low, high, count)
        motions = moving(course.method, course.path, self.t, by)
        first = np.interp(course.t[0], self.t, np.arange(count))
        for name, quantity in angles.items():
            table = _unwrapped(series(name, quantity, motions, count).values)
            start = np.interp(first, np.arange(count), table)
            self.tables[name] = table - 2 * np.pi * np.floor(start / (2 * np.pi) + 1e-12)

    def on(self, entry: Series, t: np.ndarray) -> Series:
        if entry.name not in self.tables:
            return entry
        near = np.interp(t, self.t, self.tables[entry.name])
        values = entry.values + 2 * np.pi * np.round((near - entry.values) / (2 * np.pi))
        return Series(entry.name, entry.quantity, values)


def _unwrapped(angles: np.ndarray) -> np.ndarray:
    """Without jumps of a turn; positions that are not reached are passed over."""
    there = np.isfinite(angles)
    found = np.array(angles)
    found[there] = np.unwrap(angles[there])
    found[~there] = np.interp(np.flatnonzero(~there), np.flatnonzero(there), found[there])
    return found


def _joined(parts: Iterable[Sweep], count: int) -> Sweep:
    """One sweep of parts, with `count` positions at most: each is copied as it comes, while it is in the cache."""
    columns: list[np.ndarray] = []
    undefined, end = [], 0
    for part in parts:
        found = _columns(part)
        columns = columns or _room(found, count)
        begin, end = end, end + part.t.size
        for column, values in zip(columns, found, strict=True):
            column[begin:end] = values
        undefined.append(part.undefined)
    t, driven, *rest = (column[:end] for column in columns)
    own = iter(rest)
    series = tuple(
        replace(entry, values=next(own), vectors=None if entry.vectors is None else next(own)) for entry in part.series
    )
    return Sweep(part.course, t, driven, series, np.concatenate(undefined), part.by)


def _columns(part: Sweep) -> list[np.ndarray]:
    """All that has an entry a position."""
    found = [column for entry in part.series for column in (entry.values, entry.vectors) if column is not None]
    return [part.t, part.driven, *found]


def _room(columns: Sequence[np.ndarray], count: int) -> list[np.ndarray]:
    """For columns like these with so many entries, in one piece of memory."""
    sizes = [count * (column.itemsize // 8) for column in columns]
    rooms = np.split(lent(sum(sizes)), np.cumsum(sizes)[:-1])
    return [room.view(column.dtype) for room, column in zip(rooms, columns, strict=True)]
