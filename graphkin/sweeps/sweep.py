"""A sweep: quantities over the positions of a course, all at once or part by part."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from graphkin.centres import centre_of
from graphkin.mechanism import Mechanism
from graphkin.planning import Method
from graphkin.running.path import stride
from graphkin.sweeps.course import Course, course
from graphkin.sweeps.held import held
from graphkin.sweeps.quantities import Series, asked, series
from graphkin.sweeps.roads import Road, centre_path, moving
from graphkin.value import frozen

__all__ = ["Sweep", "parts", "sweep", "sweep_over"]

PART = 8192
"""Positions done at once: what they need stays in the processor's cache, and memory stays flat."""
FINE_DEG, FINE_PART = 0.5, 0.002
"""How closely angles are followed, so that none jumps by a turn [deg, of the mechanism's size]."""


@frozen
class Sweep:
    """Quantities over positions.

    t       where on the path (n,)
    values  of the driver that names the positions (n,) [rad, m]
    undefined   its values at positions that are reached but have no definite motion, and are left out
    """

    course: Course
    t: np.ndarray
    values: np.ndarray
    series: tuple[Series, ...]
    undefined: np.ndarray

    @property
    def mechanism(self) -> Mechanism:
        return self.course.method.mechanism

    def __getitem__(self, name: str) -> Series:
        return next(entry for entry in self.series if entry.name == name)


def sweep(method: Method, ranges: Sequence[str] = (), of: Sequence[str] = (), by: Road = "construction") -> Sweep:
    """Quantities `of` a mechanism over the driver values of `ranges`; see `course` and `asked` for what is usual.

    Angles are continuous along the sweep, from between 0 and a full turn at its first position. Raises RoadsDiffer
    where the two roads do not agree.
    """
    found, names = course(method, ranges), asked(method.mechanism, of)
    held(found)
    return sweep_over(found, names, by)


def sweep_over(course: Course, names: Sequence[str], by: Road = "construction") -> Sweep:
    """The same over a course."""
    return _joined(list(parts(course, names, by)))


def parts(course: Course, names: Sequence[str], by: Road = "construction", size: int = PART) -> Iterator[Sweep]:
    """The same, some positions at a time: a sweep of any length needs no more memory."""
    turned = _Turned(course, [name for name in names if name.startswith("theta ")], by)
    for begin in range(0, course.t.size, size):
        here = slice(begin, begin + size)
        yield _defined(replace(_at(course, names, course.t[here], by, turned), values=course.values[here]))


def _defined(found: Sweep) -> Sweep:
    """Without positions at which some quantity has no value; quotients and centres may lie at infinity."""
    own = [entry.values for entry in found.series if not entry.is_place and "/" not in entry.name]
    good = np.all([np.isfinite(values) for values in own], axis=0) if own else np.True_
    if np.all(good):
        return found
    series = tuple(
        replace(entry, values=entry.values[good], vectors=None if entry.vectors is None else entry.vectors[good])
        for entry in found.series
    )
    return replace(found, t=found.t[good], values=found.values[good], series=series, undefined=found.values[~good])


def at(course: Course, names: Sequence[str], t: np.ndarray, by: Road = "construction") -> Sweep:
    """Quantities at positions t (n,) of the course."""
    return _at(course, names, t, by, _Turned(course, [name for name in names if name.startswith("theta ")], by))


def _at(course: Course, names: Sequence[str], t: np.ndarray, by: Road, turned: _Turned) -> Sweep:
    mechanism = course.method.mechanism
    motions = moving(course.method, course.path, t, by)
    found = [_centre(course, name, t, by) or series(mechanism, motions, name, t.size) for name in names]
    told = tuple(turned.on(entry, t) for entry in found if entry)
    return Sweep(course, t, np.asarray(course.value(t)), told, np.empty(0))


def _centre(course: Course, name: str, t: np.ndarray, by: Road) -> Series | None:
    """Where an instant centre lies; None for other quantities."""
    links = centre_of(course.method.mechanism, name)
    if links is None:
        return None
    places = centre_path(course.method, course.path, t, by, links)
    return Series(name, "m", np.abs(places), places)


class _Turned:
    """How far links have turned since the first position: angles that go on beyond a full turn."""

    def __init__(self, course: Course, names: Sequence[str], by: Road) -> None:
        self.tables: dict[str, np.ndarray] = {}
        if not names:
            return
        low, high = float(course.t.min()), float(course.t.max())
        count = 2 + int((high - low) / stride(course.method, course.path.pace, FINE_DEG, FINE_PART))
        self.t = np.linspace(low, high, count)
        motions = moving(course.method, course.path, self.t, by)
        first = np.interp(course.t[0], self.t, np.arange(count))
        for name in names:
            entry = series(course.method.mechanism, motions, name, count)
            if entry is not None and entry.unit == "rad":
                angles = _unwrapped(entry.values)
                start = np.interp(first, np.arange(count), angles)
                self.tables[name] = angles - 2 * np.pi * np.floor(start / (2 * np.pi) + 1e-12)

    def on(self, entry: Series, t: np.ndarray) -> Series:
        if entry.name not in self.tables:
            return entry
        near = np.interp(t, self.t, self.tables[entry.name])
        values = entry.values + 2 * np.pi * np.round((near - entry.values) / (2 * np.pi))
        return Series(entry.name, entry.unit, values)


def _unwrapped(angles: np.ndarray) -> np.ndarray:
    """Without jumps of a turn; positions that are not reached are passed over."""
    there = np.isfinite(angles)
    found = np.array(angles)
    found[there] = np.unwrap(angles[there])
    found[~there] = np.interp(np.flatnonzero(~there), np.flatnonzero(there), found[there])
    return found


def _joined(found: Sequence[Sweep]) -> Sweep:
    if len(found) == 1:
        return found[0]
    entries = tuple(
        Series(
            first.name, first.unit, np.concatenate([part.series[k].values for part in found]),
            None if first.vectors is None else np.concatenate([part.series[k].vectors for part in found]), first.along,
        )
        for k, first in enumerate(found[0].series)
    )  # fmt: skip
    rows = ("t", "values", "undefined")
    t, values, undefined = (np.concatenate([getattr(part, name) for part in found]) for name in rows)
    return Sweep(found[0].course, t, values, entries, undefined)
