"""The two roads over many positions: the construction replayed, or the analysis; and places only a limit gives.

At a change point all lines of a group coincide: there velocities are 0/0 on paper, though the motion itself is smooth.
Such positions get the value that their neighbours on both sides lead to; the analysis does so by itself. Where a
special point goes far off, its lines are nearly parallel, and another special point is taken.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Literal

import numpy as np

from graphkin.base.geometry import Value, weights_of
from graphkin.base.value import Lazy, frozen
from graphkin.construction import Plot, replay
from graphkin.model.kinematic_state import Motions
from graphkin.planning import Method, with_other_points
from graphkin.proof.readings import readings
from graphkin.running import replay_all
from graphkin.running.other_positions import replay_along
from graphkin.running.path import DriverPath, along, stride
from graphkin.running.recorder import Entry
from graphkin.studies.centres import centres, over

Road = Literal["construction", "analysis"]

ASIDE_DEG, ASIDE_PART = 1.2, 0.02
"""How far apart the neighbours of a change point are [deg, of the mechanism's size]."""
ALIKE, NEARER = 1e-7, 4
"""How far all neighbours and the inner six may tell a change point apart [of the size]; else nearer ones are taken."""
CLEAR = 10
"""Another change point, or a stop, is as many times their distance away."""
PLACES = np.array([-4, -3, -2, -1, 1, 2, 3, 4], dtype=float)
FAR_SINE, OTHER_POINTS = 0.05, 4
"""Where the lines of a special point meet under a smaller angle, another one is taken; so often at most."""


def moving(
    method: Method,
    path: DriverPath,
    t: np.ndarray,
    by: Road,
    asked: set[Entry] | None = None,
    compiled: bool | None = None,
) -> Motions:
    """Position, velocity and acceleration at t (n,) on the path, by one of the roads; `asked`, `compiled`: as
    `ReplayProgram.run` has them."""
    if by == "analysis":
        from graphkin.analytic import motion

        return motion(method.mechanism, [np.broadcast_to(value, t.shape) for value in path.values(t)])
    rows, patches = _drawn(method, path, t, asked, compiled)
    patches += [patch for change in path.changes if (patch := _beside(method, path, t, change.at))]
    return mended(rows, t.size, tuple(patches)) if patches else rows


def _drawn(
    method: Method, path: DriverPath, t: np.ndarray, asked: set[Entry] | None = None, compiled: bool | None = None
) -> tuple[Motions, list[Patch]]:
    """Motions by the construction, but for change points."""
    plot = replay_along(method, path, t, asked, compiled)
    return readings(method, plot), _by_other_points(method, path, t, plot)


def _beside(method: Method, path: DriverPath, t: np.ndarray, centre: float) -> Patch | None:
    """The rows at a change point, by their neighbours on both sides, which no other change point or stop is near."""
    others = [event.at for event in (*path.changes, *path.stops) if event.at != centre]
    clear = min((abs(centre - other) for other in others), default=np.inf)
    aside = min(stride(method, path.pace, ASIDE_DEG, ASIDE_PART), clear / CLEAR)
    if not np.any(np.abs(t - centre) < aside):
        return None
    for _ in range(NEARER):
        neighbours, patches = _drawn(method, path, centre + aside * PLACES)
        if patches:
            neighbours = mended(neighbours, PLACES.size, tuple(patches))
        if _alike(method, neighbours):
            break
        aside /= 2
    rows = np.flatnonzero(np.abs(t - centre) < aside)
    if not rows.size:
        return None
    places = np.broadcast_to(np.arange(PLACES.size), (rows.size, PLACES.size))
    return Patch(rows, neighbours, places, weights_of((t[rows] - centre) / aside, PLACES)) if rows.size else None


def _alike(method: Method, neighbours: Motions) -> bool:
    """Whether all neighbours tell a change point as the inner ones do."""
    zero, middle = np.zeros(1), slice(1, -1)
    weights = weights_of(zero, PLACES)[0]
    weights[middle] -= weights_of(zero, PLACES[middle])[0]
    points = method.mechanism.points
    places = np.array([np.broadcast_to(neighbours.position[point], PLACES.shape) for point in points])
    return bool(np.max(np.abs(places @ weights)) < ALIKE * method.size)


# --- special points far off -------------------------------------------------------------------


def _by_other_points(method: Method, path: DriverPath, t: np.ndarray, plot: Plot) -> list[Patch]:
    """Rows at which the lines of a special point hardly meet, by other special points."""
    if not method.ternaries:
        return []
    sines = _special_sines(method, plot, t.shape)
    rows, patches = np.flatnonzero(sines < FAR_SINE), []
    for _ in range(OTHER_POINTS):
        if not rows.size:
            break
        worst = float(t[rows[np.argmin(sines[rows])]])
        other = with_other_points(method, along(method, path, worst))
        there = replay(other.acceleration, replay(other.velocity, along(other, path, t[rows])))
        better = _special_sines(other, there, rows.shape)
        good = np.flatnonzero(better > sines[rows])
        patches.append(Patch(rows[good], readings(other, there), good[:, None], np.ones((good.size, 1))))
        rows = rows[better < FAR_SINE]
    return [patch for patch in patches if patch.rows.size]


def _special_sines(method: Method, plot: Plot, shape: tuple[int, ...]) -> np.ndarray:
    """The least sine of the angle between the lines of special points (n,)."""
    least = np.ones(shape)
    for ternary in method.ternaries.values():
        least = np.fmin(least, plot.sines.get(("position", ternary.name), 1.0))
    return least


@frozen
class Patch:
    """Rows that are told by other motions: each a weighted sum of some of theirs.

    rows    which they are (m,); places  which of the others' positions (m, k); weights (m, k)
    """

    rows: np.ndarray
    others: Motions
    places: np.ndarray
    weights: np.ndarray


def mended(rows: Motions, count: int, patches: tuple[Patch, ...]) -> Motions:
    """Motions of which some of the `count` rows are told otherwise; only what is read is put together."""
    mend = _Mend(rows, count, patches)
    return Motions(
        rows.mechanism, mend.table("theta"), mend.table("omega"), mend.table("alpha"),
        mend.table("s"), mend.table("s_rate"), mend.table("s_acceleration"),
        mend.table("position"), mend.vectors(Motions.velocity_at), mend.vectors(Motions.acceleration_at),
    )  # fmt: skip


@frozen
class _Mend:
    """Rows put into others."""

    rows: Motions
    count: int
    patches: tuple[Patch, ...]

    def table(self, name: str) -> Mapping[str, Value]:
        def entry(key: str) -> Value:
            others = [getattr(patch.others, name)[key] for patch in self.patches]
            return self._put(own[key], others, turning=name == "theta")

        own: Mapping[str, Value] = getattr(self.rows, name)
        return Lazy(own, entry)

    def vectors(self, at: Callable[[Motions, str, str], Value]) -> Mapping[str, Mapping[str, Value]]:
        """By link, then by any point: that of the link which lies under it."""

        def entry(point: str, link: str) -> Value:
            with np.errstate(invalid="ignore", over="ignore"):  # of rows that are mended
                return self._put(at(self.rows, point, link), [at(patch.others, point, link) for patch in self.patches])

        return Lazy(self.rows.omega, lambda link: Lazy(self.rows.position, lambda point: entry(point, link)))

    def _put(self, value: Value, others: Sequence[Value], turning: bool = False) -> Value:
        found = np.array(np.broadcast_to(value, (self.count,)))
        for patch, other in zip(self.patches, others, strict=True):
            told = other[patch.places] if np.ndim(other) else np.broadcast_to(other, patch.places.shape)
            found[patch.rows] = np.sum(patch.weights * (np.unwrap(told, axis=1) if turning else told), axis=1)
        return found


# --- instant centres --------------------------------------------------------------------------


def centre_path(method: Method, path: DriverPath, t: np.ndarray, links: tuple[str, str]) -> np.ndarray:
    """Where the instant centre of two links lies at t (n,) on the path, by construction [m]; infinite at infinity."""
    found = over(centres(method, replay_all(method)), path, t)
    return np.array(np.broadcast_to(found.place(*links), t.shape))
