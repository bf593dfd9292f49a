"""Quantities at any place of a course, and how they change on the way.

What `ask` can name.
Sizes of vectors count as they are; for a point that a guide of the frame leads they count along that guide, and may
be negative.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from graphkin.errors import UnknownQuantity, Where
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import Mechanism
from graphkin.model.quantities import Quantity, named
from graphkin.studies.finding.conditions import WHERE
from graphkin.studies.sweeps import Course, Road, Series
from graphkin.studies.sweeps.roads import moving
from graphkin.studies.sweeps.sweep import series


def checked(mechanism: Mechanism, names: Sequence[str], where: Where = WHERE) -> tuple[Series, ...]:
    """The quantities at the drawn position.

    Raises UnknownQuantity, UnknownLink, UnknownPoint, UnknownSlide for names that mean nothing.
    """
    from graphkin.analytic import motion

    still = motion(mechanism)
    return tuple(series(name, looked_for(mechanism, name, where), still, 1) for name in names)


def looked_for(mechanism: Mechanism, name: str, where: Where = WHERE) -> Quantity:
    """A quantity that can be looked for: places can't, `x E` and `y E` can. Raises what `quantities.named` raises."""
    found = named(mechanism, name, where)
    if found.is_place:
        raise UnknownQuantity(where, name, tuple(f"{axis} {found.of}" for axis in ("x", "y") if found.sites))
    return found


class Reader:
    """Reads quantities at places t of a course; angles go on beyond a full turn.

    tables  angles (m,) without jumps at places t (m,), by quantity
    """

    def __init__(self, course: Course, names: Sequence[str], by: Road) -> None:
        self.course, self.by = course, by
        self.wanted = [(name, looked_for(course.method.mechanism, name)) for name in names]
        self.tables: dict[str, tuple[np.ndarray, np.ndarray]] = {}

    def motions(self, t: np.ndarray) -> Motions:
        return moving(self.course.method, self.course.path, t, self.by)

    def read(self, t: np.ndarray, motions: Motions | None = None) -> list[Series]:
        """Every quantity at places t (n,), from the motions there where these are known."""
        if not t.size:
            return [
                replace(entry, values=t, vectors=None if entry.vectors is None else t + 0j)
                for entry in self.read(np.zeros(1))
            ]
        motions = motions or self.motions(t)
        return [self._turned(series(*entry, motions, t.size), t) for entry in self.wanted]

    def follow(self, t: np.ndarray, start: float) -> None:
        """Follow angles over places t, close to each other, so that none jumps; at `start` they are 0 to a turn."""
        self.tables = {}
        for entry in self.read(t):
            there = np.isfinite(entry.values)
            if entry.unit != "rad" or not there.any():
                continue
            angles = np.unwrap(entry.values[there])
            begin = np.interp(start, t[there], angles)
            self.tables[entry.name] = t[there], angles - 2 * np.pi * np.floor(begin / (2 * np.pi) + 1e-12)

    def _turned(self, entry: Series, t: np.ndarray) -> Series:
        if entry.name not in self.tables:
            return entry
        near = np.interp(t, *self.tables[entry.name])
        turns = np.round((near - entry.values) / (2 * np.pi))
        return Series(entry.name, entry.quantity, entry.values + 2 * np.pi * turns)
