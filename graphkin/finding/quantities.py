"""Quantities at any place of a course, and how they change on the way.

What `ask` can name, and `x C`, `y C`: the place of a point. Sizes of vectors count as they are; for a point that a
guide of the frame leads they count along that guide, and may be negative.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np

from graphkin.errors import GraphkinError, UnknownPoint, UnknownQuantity, Where
from graphkin.finding.conditions import WHERE
from graphkin.loading.questions import misnamed
from graphkin.mechanism import Mechanism
from graphkin.naming import Seen, seen
from graphkin.readings import Motions
from graphkin.sweeps import Course, Road, Series
from graphkin.sweeps.quantities import series
from graphkin.sweeps.roads import moving

__all__ = ["Reader", "checked", "measured"]


def measured(mechanism: Mechanism, motions: Motions, name: str, count: int) -> Series | None:
    """One quantity over `count` positions; None for a text that names none."""
    if (site := _placed(mechanism, name)) is None:
        return series(mechanism, motions, name, count)
    place = np.broadcast_to(motions.position[site.point], (count,))
    return Series(name, "m", np.array(place.real if name[0] == "x" else place.imag, dtype=float))


def _placed(mechanism: Mechanism, name: str) -> Seen | None:
    """The point of `x C` or `y C`."""
    words = re.fullmatch(r"([xy]) +(\S+)", name.strip())
    site = seen(mechanism, words[2]) if words else None
    return None if site is None or site.explicit else site


def checked(mechanism: Mechanism, names: Sequence[str], where: Where = WHERE) -> tuple[Series, ...]:
    """The quantities at the drawn position.

    Raises UnknownQuantity, UnknownLink, UnknownPoint, UnknownSlide for names that mean nothing.
    """
    from graphkin.analytic import motion

    still = motion(mechanism)
    found = []
    for name in names:
        entry = None if (problem := _problem(mechanism, name, where)) else measured(mechanism, still, name, 1)
        if entry is None:
            raise problem or UnknownQuantity(where, name, ())
        found.append(entry)
    return tuple(found)


def _problem(mechanism: Mechanism, name: str, where: Where) -> GraphkinError | None:
    if words := re.fullmatch(r"[xy] +(\S+)", name.strip()):
        return None if _placed(mechanism, name) else UnknownPoint(where, words[1], mechanism.points)
    parts = (misnamed(mechanism, part, where) for part in name.split("/"))
    return next((problem for problem in parts if problem is not None), None)


class Reader:
    """Reads quantities at places t of a course; angles go on beyond a full turn.

    tables  angles (m,) without jumps at places t (m,), by quantity
    """

    def __init__(self, course: Course, names: Sequence[str], by: Road) -> None:
        self.course, self.names, self.by = course, tuple(names), by
        self.tables: dict[str, tuple[np.ndarray, np.ndarray]] = {}

    def motions(self, t: np.ndarray) -> Motions:
        return moving(self.course.method, self.course.way, t, self.by)

    def read(self, t: np.ndarray) -> list[Series]:
        """Every quantity at places t (n,)."""
        motions, mechanism = self.motions(t), self.course.method.mechanism
        found = [measured(mechanism, motions, name, t.size) for name in self.names]
        return [self._turned(entry, t) for entry in found if entry is not None]

    def follow(self, t: np.ndarray, start: float) -> None:
        """Follow angles over places t, close to each other, so that none jumps; at `start` they are 0 to a turn."""
        self.tables = {}
        for entry in self.read(t):
            if entry.unit != "rad":
                continue
            there = np.isfinite(entry.values)
            angles = np.unwrap(entry.values[there])
            begin = np.interp(start, t[there], angles)
            self.tables[entry.name] = t[there], angles - 2 * np.pi * np.floor(begin / (2 * np.pi) + 1e-12)

    def _turned(self, entry: Series, t: np.ndarray) -> Series:
        if entry.name not in self.tables:
            return entry
        near = np.interp(t, *self.tables[entry.name])
        return Series(entry.name, entry.unit, entry.values + 2 * np.pi * np.round((near - entry.values) / (2 * np.pi)))
