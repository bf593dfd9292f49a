"""A sweep: quantities over the positions of a course, one series each, all at once or part by part."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import DTypeLike

from graphkin.base.geometry import Value, dot
from graphkin.base.value import frozen
from graphkin.errors import NOWHERE, NotSwept, Where
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import Mechanism, Usual
from graphkin.model.quantities import EDGE, Centre, Quantity, Quotient, named, read
from graphkin.model.quantities.kinds import Track
from graphkin.model.readout import Readable
from graphkin.model.units import Measured, Numbers, Vectors, measured
from graphkin.planning import Method
from graphkin.running.other_positions import MANY
from graphkin.running.path import stride
from graphkin.running.recorder import Entry
from graphkin.running.replay_program import VERY_MANY
from graphkin.studies.sweeps.course import TURN, Course, Ranges, course
from graphkin.studies.sweeps.roads import Road, centre_path, moving, prove

Quantities = Mapping[str, Quantity]  # quantities, by their names as they were written

PART = 8192  # positions done at once: what they need stays in the processor's cache, and memory stays flat
FINE_DEG, FINE_PART = 0.5, 0.002
"""Angles are followed in such steps, so that none jumps by a turn [deg, of the mechanism's size]."""


@frozen
class Series(Measured):
    """One quantity over positions. As an array it is `signed`; `degrees`, `mm`, `rpm`, `direction`, `x`, `y` as of any
    `graphkin.model.units.Measured`.

    name    of the quantity, as it was written
    values  sizes or signed scalars (n,), in SI
    vectors for velocities and accelerations, and the place of a point or an instant centre: (n,) complex, else None
    """

    name: str
    quantity: Quantity
    values: np.ndarray
    vectors: np.ndarray | None = None

    if not TYPE_CHECKING:

        @property
        def unit(self) -> str:
            """SI."""
            return self.quantity.unit

    @property
    def measured(self) -> Numbers:
        """With its unit: the vectors, else the values (n,)."""
        numbers: Numbers = measured(self.si, self.unit)
        return numbers

    @property
    def si(self) -> np.ndarray:
        return self.values if self.vectors is None else self.vectors

    def _times(self, factor: float, units: tuple[str, ...], name: str) -> np.ndarray:
        """The array in another unit: the signed values, of a place the place."""
        shown = measured(self.si if self.is_place else self.signed, self.unit)
        values: np.ndarray = shown._times(factor, units, name)
        return values

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> np.ndarray:
        own = self.si if self.is_place else self.signed
        return np.asarray(own, dtype) if copy is None else np.array(own, dtype, copy=copy)  # NumPy 1 knows no copy=None

    def __len__(self) -> int:
        return len(self.values)

    def __repr__(self) -> str:
        return f"<Series {self.name} [{self.unit}]: {len(self)} values>"

    @property
    def along(self) -> complex | None:
        """For a point that a guide of the frame leads: the direction along which it counts as positive."""
        return self.quantity.along

    @property
    def is_place(self) -> bool:
        """True for the place of a point or an instant centre; that one at infinity is infinite."""
        return self.quantity.is_place

    def without_noise(self, usual: Usual) -> Series:
        """The same, with 0 for what is but rounding."""
        vectors = None if self.vectors is None else np.asarray(usual.cut(self.vectors, self.unit))
        return replace(self, values=np.asarray(usual.cut(self.values, self.unit)), vectors=vectors)

    @property
    def signed(self) -> np.ndarray:
        """Along its guide for a point that a guide of the frame leads; else the values."""
        if self.along is None or self.vectors is None:
            return self.values
        return np.asarray(dot(self.along, self.vectors))


def series(name: str, quantity: Quantity, motions: Motions, count: int) -> Series:
    """One quantity over `count` positions."""

    def row(value: Value) -> np.ndarray:
        return np.array(np.broadcast_to(value, (count,)))

    with np.errstate(divide="ignore", invalid="ignore"):
        answer = quantity.answer(motions)
    return Series(name, quantity, row(answer.value), None if answer.vector is None else row(answer.vector))


def asked(mechanism: Mechanism, names: Sequence[str] = ()) -> tuple[str, ...]:
    """The quantities of a sweep: those named, else those of the file's `ask`, else theta, omega and alpha of links.

    Raises UnknownQuantity, UnknownLink, UnknownPoint, UnknownSlide for names that mean nothing.
    """
    for name in names:
        named(mechanism, name, Where("--of"))
    names = names or [name for name in mechanism.ask if read(mechanism, name) is not None]
    if not names:
        turned = {d.link for d in mechanism.drivers if d.kind != "slide" and d.from_vector is None}
        links = [link for link in mechanism.moving if link not in turned] or list(mechanism.moving)
        names = [f"{quantity} {link}" for quantity in ("theta", "omega", "alpha") for link in links]
    return tuple(dict.fromkeys(names))


def drawable(mechanism: Mechanism, names: Sequence[str]) -> tuple[str, ...]:
    """The same over the driver's value, a curve each: of a point's place its x and its y."""
    curves: list[str] = []
    for name in names:
        quantity = named(mechanism, name, Where("--of"))
        curves += [f"x {quantity.of}", f"y {quantity.of}"] if isinstance(quantity, Track) else [name]
    return tuple(dict.fromkeys(curves))


@frozen
class Sweep(Readable[Numbers, Vectors], Mapping[str, Series]):
    """Quantities over positions: a mapping from the name of each, as it was written, to its `Series`.

    By name it has any other, too, as `Readable` says: `sweep.omega["3"]`, `sweep.v["C"]`, arrays (n,) with their unit.

    t       of the positions on the path (n,)
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
        for entry in self.series:
            if entry.name == name:
                return entry
        raise NotSwept(Where("sweep"), str(name), tuple(self))

    def __iter__(self) -> Iterator[str]:
        return (entry.name for entry in self.series)

    def __len__(self) -> int:
        return len(self.series)

    def quantity(self, text: str) -> Numbers:
        """Whatever `ask` can name, over the positions (n,): of a vector the vectors."""
        swept = next((entry for entry in self.series if entry.name == text), None)
        return (swept or quantities_at(self.course, [text], self.t, self.by).series[0]).measured

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
    moved, names = replace(course(method, ranges), compiled=compiled), asked(method.mechanism, of)
    prove(moved)
    return sweep_over(moved, names, by)


def sweep_over(course: Course, names: Sequence[str], by: Road = "construction") -> Sweep:
    """Quantities over all positions of a course."""
    parts = in_parts(course, names, by)
    return next(parts) if course.t.size <= PART else _joined(parts, course.t.size)


def in_parts(course: Course, names: Sequence[str], by: Road = "construction") -> Iterator[Sweep]:
    """The same, some positions at a time: a sweep of any length needs no more memory."""
    quantities = _read(course, names)
    turns = _turns(course, quantities, by)
    course = replace(course, compiled=course.t.size >= VERY_MANY or None) if course.compiled is None else course
    entries: set[Entry] | None = None
    if course.t.size > PART:  # the first few positions show from what the quantities are read
        entries = set()
        _at(course, quantities, course.t[:MANY], by, turns, entries)
    for begin in range(0, course.t.size, PART):
        here = slice(begin, begin + PART)
        part = _at(course, quantities, course.t[here], by, turns, entries)
        yield _defined(replace(part, driven=course.values[here]))


def _defined(whole: Sweep) -> Sweep:
    """Without positions at which some quantity has no value; quotients and centres may lie at infinity."""
    finite = [np.isfinite(entry.values) for entry in whole.series if not isinstance(entry.quantity, Centre | Quotient)]
    if all(each.all() for each in finite):
        return whole
    good = np.all(finite, axis=0)
    series = tuple(
        replace(entry, values=entry.values[good], vectors=None if entry.vectors is None else entry.vectors[good])
        for entry in whole.series
    )
    return replace(whole, t=whole.t[good], driven=whole.driven[good], series=series, undefined=whole.driven[~good])


def quantities_at(course: Course, names: Sequence[str], t: np.ndarray, by: Road = "construction") -> Sweep:
    """Quantities at positions t (n,) of the course."""
    quantities = _read(course, names)
    return _at(course, quantities, t, by, _turns(course, quantities, by))


def _read(course: Course, names: Sequence[str]) -> Quantities:
    return {name: named(course.method.mechanism, name, NOWHERE) for name in names}


def _at(
    course: Course, quantities: Quantities, t: np.ndarray, by: Road, turns: Turns, entries: set[Entry] | None = None
) -> Sweep:
    motions = moving(course.method, course.path, t, by, entries, course.compiled)
    rows = []
    for name, quantity in quantities.items():
        if isinstance(quantity, Centre) and by == "construction":
            places = centre_path(course.method, course.path, t, quantity.links)
            rows.append(Series(name, quantity, np.abs(places), places))
        else:
            rows.append(turns.on(series(name, quantity, motions, t.size), t))
    shown = tuple(row.without_noise(course.method.mechanism.usual) for row in rows)
    return Sweep(course, t, np.asarray(course.value(t)), shown, np.empty(0), by)


class Turns:
    """The turns of angles: over many positions they go on beyond a full turn.

    tables  angles (m,) without jumps at places t (m,), by quantity
    """

    def __init__(self) -> None:
        self.tables: dict[str, tuple[np.ndarray, np.ndarray]] = {}

    def follow(self, entries: Iterable[Series], t: np.ndarray, start: float) -> None:
        """Follow angles over places t, close to each other; at `start` they lie between 0 and a full turn."""
        self.tables = {}
        for entry in entries:
            finite = np.isfinite(entry.values)
            if entry.unit == "rad" and finite.any():
                angles = np.unwrap(entry.values[finite])
                begin = np.interp(start, t[finite], angles)
                self.tables[entry.name] = t[finite], angles - TURN * np.floor(begin / TURN + 1e-12)

    def on(self, entry: Series, t: np.ndarray) -> Series:
        """A series at t (n,), its angles continued."""
        if entry.name not in self.tables:
            return entry
        near = np.interp(t, *self.tables[entry.name])
        return Series(entry.name, entry.quantity, entry.values + TURN * np.round((near - entry.values) / TURN))


def _turns(course: Course, quantities: Quantities, by: Road) -> Turns:
    """The turns of a course's angles since its first position."""
    turns, angles = Turns(), {name: quantity for name, quantity in quantities.items() if quantity.unit == "rad"}
    if angles:
        low, high = float(course.t.min()), float(course.t.max())
        count = 2 + int((high - low) / stride(course.method, course.path.pace, FINE_DEG, FINE_PART))
        t = np.linspace(low, high, count)
        motions = moving(course.method, course.path, t, by)
        turns.follow((series(*entry, motions, count) for entry in angles.items()), t, course.t[0])
    return turns


def _joined(parts: Iterable[Sweep], count: int) -> Sweep:
    """One sweep of parts, with `count` positions at most: each is copied as it comes, while it is in the cache."""
    columns: list[np.ndarray] = []
    undefined, end = [], 0
    for part in parts:
        rows = [part.t, part.driven]
        rows += [row for entry in part.series for row in (entry.values, entry.vectors) if row is not None]
        columns = columns or [np.empty(count, row.dtype) for row in rows]
        begin, end = end, end + part.t.size
        for column, row in zip(columns, rows, strict=True):
            column[begin:end] = row
        undefined.append(part.undefined)
    t, driven, *rest = (column[:end] for column in columns)
    own = iter(rest)
    series = tuple(
        replace(entry, values=next(own), vectors=None if entry.vectors is None else next(own)) for entry in part.series
    )
    return Sweep(part.course, t, driven, series, np.concatenate(undefined), part.by)
