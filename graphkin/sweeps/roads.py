"""The two roads over many positions: the construction replayed, or the analysis; and places only a limit gives.

At a change point all lines of a group coincide, and where a special point goes far off its lines are parallel:
there velocities are 0/0 on paper and in the matrices alike, though the motion itself is smooth. Such positions get the
value that their neighbours on both sides, found by the same road, lead to.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import Literal

import numpy as np

from graphkin.geometry import Value
from graphkin.methods import Method
from graphkin.methods.way import Way, along, stride
from graphkin.readings import Motions, Readings
from graphkin.steps import Plot, replay
from graphkin.value import frozen

__all__ = ["Road", "moving"]

Road = Literal["construction", "analysis"]

ASIDE_DEG, ASIDE_PART = 1.2, 0.02
"""How far apart the neighbours of a change point are [deg, of the mechanism's size]."""
CLOSER = 1 / 3
"""How much closer they are beside a special point far off, where they lose fewer digits."""
PLACES = np.array([-4, -3, -2, -1, 1, 2, 3, 4], dtype=float)
FAR_SINE = 0.02
"""Lines of a special point under a smaller angle are taken for parallel."""


def moving(method: Method, way: Way, t: np.ndarray, by: Road) -> Motions:
    """Position, velocity and acceleration at t (n,) on the way, by one of the roads."""
    rows, sines = _by(method, way, t, by)
    aside = stride(method, way.pace, ASIDE_DEG, ASIDE_PART)
    index, centres, apart = _to_mend(way, t, sines, aside)
    if not index.size:
        return rows
    places = centres[:, None] + apart[:, None] * PLACES
    neighbours, _ = _by(method, way, places.ravel(), by)
    return Mended(rows, neighbours, t.size, index, _weights((t[index] - centres) / apart))


def _by(method: Method, way: Way, t: np.ndarray, by: Road) -> tuple[Motions, np.ndarray]:
    """Motions, and the least sine of the lines of special points (n,)."""
    if by == "analysis":
        from graphkin.analytic import motion

        return motion(method.mechanism, [np.broadcast_to(value, t.shape) for value in way.values(t)]), np.ones(t.shape)
    plot = replay(method.acceleration, replay(method.velocity, along(method, way, t)))
    return Readings(method, plot), _special_sines(method, plot, t.shape)


def _special_sines(method: Method, plot: Plot, shape: tuple[int, ...]) -> np.ndarray:
    least = np.ones(shape)
    for ternary in method.ternaries.values():
        least = np.fmin(least, plot.sines.get(("position", ternary.name), 1.0))
    return least


def _to_mend(
    way: Way, t: np.ndarray, sines: np.ndarray, aside: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Rows that only their neighbours can tell, about where these are taken, and how far apart: (m,) each."""
    far = np.flatnonzero(sines < FAR_SINE)
    found = [(far, t[far], np.full(far.size, aside * CLOSER))]
    for change in way.changes:
        close = np.flatnonzero(np.abs(t - change.at) < aside)
        found.append((close, np.full(close.size, change.at), np.full(close.size, aside)))
    index, centres, apart = (np.concatenate(column) for column in zip(*found))
    return index, centres, apart


def _weights(x: np.ndarray) -> np.ndarray:
    """Lagrange's weights of the neighbours at x (m,): (m, 8)."""
    weights = np.ones((x.size, PLACES.size))
    for k, place in enumerate(PLACES):
        for other in np.delete(PLACES, k):
            weights[:, k] *= (x - other) / (place - other)
    return weights


@frozen
class Mended:
    """Motions of which some rows are taken from their neighbours.

    index    those rows (m,); weights   of their neighbours (m, 8)
    """

    rows: Motions
    neighbours: Motions
    count: int
    index: np.ndarray
    weights: np.ndarray

    def _mend(self, value: Value, beside: Value, turning: bool = False) -> Value:
        mended = np.array(np.broadcast_to(value, (self.count,)))
        told = np.broadcast_to(beside, (self.weights.size,)).reshape(self.weights.shape)
        if turning:
            told = np.unwrap(told, axis=1)
        mended[self.index] = np.sum(self.weights * told, axis=1)
        return mended

    def _table(self, name: str) -> Mapping[str, Value]:
        rows, beside = getattr(self.rows, name), getattr(self.neighbours, name)
        return {key: self._mend(value, beside[key], name == "theta") for key, value in rows.items()}

    @cached_property
    def theta(self) -> Mapping[str, Value]:
        return self._table("theta")

    @cached_property
    def omega(self) -> Mapping[str, Value]:
        return self._table("omega")

    @cached_property
    def alpha(self) -> Mapping[str, Value]:
        return self._table("alpha")

    @cached_property
    def s(self) -> Mapping[str, Value]:
        return self._table("s")

    @cached_property
    def s_rate(self) -> Mapping[str, Value]:
        return self._table("s_rate")

    @cached_property
    def s_acceleration(self) -> Mapping[str, Value]:
        return self._table("s_acceleration")

    @cached_property
    def position(self) -> Mapping[str, Value]:
        return self._table("position")

    def velocity_at(self, point: str, link: str) -> Value:
        return self._mend(self.rows.velocity_at(point, link), self.neighbours.velocity_at(point, link))

    def acceleration_at(self, point: str, link: str) -> Value:
        return self._mend(self.rows.acceleration_at(point, link), self.neighbours.acceleration_at(point, link))
