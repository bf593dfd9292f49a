"""The two roads over many positions: the construction replayed, or the analysis; and the proof that they agree.

At a change point all lines of a group coincide: there velocities are 0/0 on paper, though the motion itself is smooth.
Such positions get the value that their neighbours on both sides lead to; the analysis does so by itself. Where a
special point goes far off, its lines are nearly parallel, and another special point is taken.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Literal

import numpy as np

from graphkin.base.cache import kept
from graphkin.base.geometry import Array, Value, weights_of
from graphkin.base.value import Lazy, frozen
from graphkin.construction import Plot, replay
from graphkin.errors import RoadsDiffer
from graphkin.model.kinematic_state import Motions
from graphkin.planning import Method, with_other_points
from graphkin.proof.readings import readings
from graphkin.proof.roads import AGREE, apart
from graphkin.proof.roads import PLACES as PROVED
from graphkin.running import replay_all
from graphkin.running.other_positions import replay_along
from graphkin.running.path import DriverPath, along, stride
from graphkin.running.recorder import Entry
from graphkin.studies.centres import centres, over
from graphkin.studies.sweeps.course import Course

Road = Literal["construction", "analysis"]

ASIDE_DEG, ASIDE_PART = 1.2, 0.02
"""Distance between the neighbours of a change point [deg, of the mechanism's size]."""
ALIKE, NEARER = 1e-7, 4
"""Neighbours are nearer by half, so often at most, where all and the inner six lead farther apart [of the size]."""
CLEAR = 10  # another change point, or a stop, is as many times their distance away
PLACES = np.array([-4, -3, -2, -1, 1, 2, 3, 4], dtype=float)
INNER = weights_of(np.zeros(1), PLACES)[0]
INNER[1:-1] -= weights_of(np.zeros(1), PLACES[1:-1])[0]
"""Weights of the neighbours for the difference between what the inner six lead to and what all do."""
FAR_SINE, OTHER_POINTS = 0.05, 4
"""Another special point is taken if lines meet under a smaller angle; so often at most."""
STOP_DEG, STOP_PART = 0.5, 0.005
"""The roads are compared no nearer to a stop: speeds grow without bound there, and digits are lost."""
BESIDE = 4
"""They are compared so many times as far from a change point, where motions are those that neighbours lead to."""


def moving(
    method: Method, path: DriverPath, t: np.ndarray, by: Road,
    asked: set[Entry] | None = None, compiled: bool | None = None,
) -> Motions:  # fmt: skip
    """Position, velocity and acceleration at t (n,) on the path, by one of the roads; `asked`, `compiled`: as
    `ReplayProgram.run` has them."""
    if by == "analysis":
        from graphkin.analytic import motion

        return motion(method.mechanism, [np.broadcast_to(value, t.shape) for value in path.values(t)])
    rows, patches = _constructed(method, path, t, asked, compiled)
    patches += [patch for change in path.changes if (patch := _beside(method, path, t, change.at))]
    return mended(rows, t.size, tuple(patches)) if patches else rows


def _constructed(
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
        neighbours, patches = _constructed(method, path, centre + aside * PLACES)
        if patches:
            neighbours = mended(neighbours, PLACES.size, tuple(patches))
        points = [neighbours.position[point] for point in method.mechanism.points]
        places = np.array([np.broadcast_to(point, PLACES.shape) for point in points])
        if np.max(np.abs(places @ INNER)) < ALIKE * method.size:
            break
        aside /= 2
    rows = np.flatnonzero(np.abs(t - centre) < aside)
    if not rows.size:
        return None
    numbers = np.broadcast_to(np.arange(PLACES.size), (rows.size, PLACES.size))
    return Patch(rows, neighbours, numbers, weights_of((t[rows] - centre) / aside, PLACES))


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
    """Rows that are taken from other motions: each a weighted sum of some of theirs.

    rows    their numbers (m,); places  numbers of the others' positions (m, k); weights (m, k)
    """

    rows: np.ndarray
    others: Motions
    places: np.ndarray
    weights: np.ndarray


def mended(rows: Motions, count: int, patches: tuple[Patch, ...]) -> Motions:
    """Motions of which some of the `count` rows are patched; only what is read is put together."""

    def put(value: Value, others: Callable[[Motions], Value], turning: bool = False) -> Array:
        mended_rows = np.array(np.broadcast_to(value, (count,)))
        for patch in patches:
            other = others(patch.others)
            at = other[patch.places] if isinstance(other, np.ndarray) and other.ndim else other
            at = np.broadcast_to(at, patch.places.shape)
            mended_rows[patch.rows] = np.sum(patch.weights * (np.unwrap(at, axis=1) if turning else at), axis=1)
        return mended_rows

    def table(read: Callable[[Motions], Mapping[str, Value]], turning: bool = False) -> Mapping[str, Array]:
        own = read(rows)
        return Lazy(own, lambda name: put(own[name], lambda other: read(other)[name], turning))

    def vectors(at: Callable[[Motions, str, str], Value]) -> Mapping[str, Mapping[str, Value]]:
        """By link, then by any point: that of the link which lies under it."""

        def entry(point: str, link: str) -> Value:
            with np.errstate(invalid="ignore", over="ignore"):  # of rows that are patched
                return put(at(rows, point, link), lambda other: at(other, point, link))

        return Lazy(rows.omega, lambda link: Lazy(rows.position, lambda point: entry(point, link)))

    return Motions(
        rows.mechanism, table(lambda of: of.theta, turning=True), table(lambda of: of.omega),
        table(lambda of: of.alpha), table(lambda of: of.s), table(lambda of: of.s_rate),
        table(lambda of: of.s_acceleration), table(lambda of: of.position),
        vectors(Motions.velocity_at), vectors(Motions.acceleration_at),
    )  # fmt: skip


def centre_path(method: Method, path: DriverPath, t: np.ndarray, links: tuple[str, str]) -> np.ndarray:
    """The instant centre of two links at t (n,) on the path, by construction [m]; infinite at infinity."""
    there = over(centres(method, replay_all(method)), path, t)
    return np.array(np.broadcast_to(there.place(*links), t.shape))


def prove(course: Course) -> float:
    """The worst relative difference of the two roads at twelve places of a course. Raises RoadsDiffer."""
    worst = _worst(course.path, course.method, float(course.t.min()), float(course.t.max()))
    if not worst < AGREE:
        where = course.method.mechanism.where("driver", course.swept)
        raise RoadsDiffer(where, worst if np.isfinite(worst) else 1.0)  # one road does not lead there: wholly
    return worst


@kept(16, objects=2)
def _worst(path: DriverPath, method: Method, low: float, high: float) -> float:
    """The worst difference at places from low to high on a path; 0 where all of it is right beside its stops."""
    aside = min(stride(method, path.pace, STOP_DEG, STOP_PART), (path.last - path.first) / 4)
    for stop in path.stops:
        low, high = (low, min(high, stop.at - aside)) if stop.at > 0 else (max(low, stop.at + aside), high)
    if low > high:
        return 0.0
    t = np.linspace(low, high, PROVED)
    for change in path.changes:
        near = np.abs(t - change.at) < BESIDE * aside
        t[near] = change.at + BESIDE * aside * np.where(t[near] < change.at, -1.0, 1.0)
    t = np.array(sorted({*np.clip(t, low, high).tolist()}))
    constructed, exact = (moving(method, path, t, by) for by in ("construction", "analysis"))
    return apart(method.mechanism, constructed, exact)
