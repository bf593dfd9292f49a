"""Quantities at any place of a course, and how they change on the way.

What `ask` can name; `x C`, `y C`: the place of a point; `v_x C`, `a_y C`: components along the frame's axes.
Sizes of vectors count as they are; for a point that a guide of the frame leads they count along that guide, and may
be negative.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

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
    if component := _COMPONENT.fullmatch(name.strip()):
        whole = series(mechanism, motions, f"{component[1]} {component[3]}", count)
        return None if whole is None else Series(name, whole.unit, _along(component[2], whole.vectors))
    if (site := _placed(mechanism, name)) is None:
        return series(mechanism, motions, name, count)
    place = np.broadcast_to(motions.position[site.point], (count,))
    return Series(name, "m", _along(name[0], place))


_COMPONENT = re.compile(r"([va])_([xy]) +(\S+)")


def _along(axis: str, vectors: np.ndarray | None) -> np.ndarray:
    """Components of vectors along the frame's x or y."""
    assert vectors is not None
    return np.array(vectors.real if axis == "x" else vectors.imag, dtype=float)


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
    if component := _COMPONENT.fullmatch(name.strip()):
        name = f"{component[1]} {component[3]}"
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
        if not t.size:
            return [
                replace(entry, values=t, vectors=None if entry.vectors is None else t + 0j)
                for entry in self.read(np.zeros(1))
            ]
        motions, mechanism = self.motions(t), self.course.method.mechanism
        found = [measured(mechanism, motions, name, t.size) for name in self.names]
        return [self._turned(entry, t) for entry in found if entry is not None]

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
        return Series(entry.name, entry.unit, entry.values + 2 * np.pi * np.round((near - entry.values) / (2 * np.pi)))
