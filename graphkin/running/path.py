"""The path of a mechanism along a line of driver values: how far it leads from the drawn position, and through what.

Two circles (or a line and a circle) that touch on the path and part again are a dead point: there the path ends.
Where they touch without parting, all links of the group in line, it is a change point: the mechanism goes through
smoothly, and from there on the other crossing is the right one. Two lines that become parallel end the path, too.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field, replace

import numpy as np
from numpy.typing import NDArray

from graphkin.base.geometry import Real
from graphkin.base.value import Lazy, frozen
from graphkin.construction import Plot, replay, slide_key
from graphkin.planning import Method

STEP_DEG, STEP_PART = 3.0, 0.02
"""The longest step from one position to the next that is found from it [deg, of the mechanism's size]."""

Flags = NDArray[np.bool_]


@frozen
class Event:
    """A stop or a change point on a path.

    at       where on the path
    kind     "in line" (two links), "right angle" (a link and a guide), "tangent" (a guide and its circle),
             "parallel" (two lines), "fit" (a group that is fitted), "two ways" (such a group at a change point)
    links    the links of the group
    choices  crossings that change over, for a change point
    """

    at: float
    kind: str
    links: tuple[str, ...]
    choices: tuple[int, ...] = ()


@frozen
class DriverPath:
    """Driver values start + t pace [rad, m]; t is 0 at the drawn position.

    low, high   how far it was looked; beyond a stop the path does not lead
    stops       where it ends, before the drawn position and after it: at most one each
    changes     change points on it
    nodes       where positions hang on how they are reached: t (m,), angles by base link and displacements (m,) each
    sides       the crossing of each choice at t = 0
    """

    start: tuple[float, ...]
    pace: tuple[float, ...]
    low: float
    high: float
    stops: tuple[Event, ...] = ()
    changes: tuple[Event, ...] = ()
    nodes: tuple[np.ndarray, Mapping[str, np.ndarray]] | None = None
    sides: Mapping[int, int] = field(default_factory=dict)

    @property
    def first(self) -> float:
        """The least t that is reached (a stop itself is not)."""
        return max((stop.at for stop in self.stops if stop.at < 0), default=self.low)

    @property
    def last(self) -> float:
        return min((stop.at for stop in self.stops if stop.at > 0), default=self.high)

    def values(self, t: Real) -> tuple[Real, ...]:
        """The drivers' values [rad, m]."""
        return tuple(start + pace * t if pace else start for start, pace in zip(self.start, self.pace, strict=True))

    def leads_to(self, t: Real) -> Flags:
        """True where the positions are reached."""
        before_stops = [np.less(t, stop.at) if stop.at > 0 else np.greater(t, stop.at) for stop in self.stops]
        reached: Flags = np.all(before_stops, axis=0)
        return reached

    def crossings(self, t: Real) -> dict[int, Real]:
        """The crossing that is right at each t, by choice; arrays for those choices that change over on the path."""
        sides: dict[int, Real] = {**self.sides}
        for change in self.changes:
            beyond = np.greater(t, change.at) if change.at > 0 else np.less(t, change.at)
            for choice in change.choices:
                sides[choice] = np.where(beyond, -1, 1) * sides[choice]
        return sides

    def near(self, t: Real) -> Mapping[str, Real]:
        """Angles and displacements close by, where fitting starts and from where angles count."""
        if self.nodes is None:
            return {}
        at, tables = self.nodes
        return Lazy(tables, lambda name: np.interp(t, at, tables[name])[()])


def with_nodes(path: DriverPath, t: np.ndarray, tables: Mapping[str, np.ndarray]) -> DriverPath:
    """The path with the nodes at t (m,), which go on from the drawn position to one side, in place of those there."""
    assert path.nodes is not None
    at, before = path.nodes
    kept = at < t[0] if t[-1] > t[0] else at > t[0]
    joined = np.concatenate([at[kept], t])
    order = np.argsort(joined)
    nodes = {name: np.concatenate([before[name][kept], table])[order] for name, table in tables.items()}
    return replace(path, nodes=(joined[order], nodes))


def along(method: Method, path: DriverPath, t: Real) -> Plot:
    """The positions at t, scalar or (n,), on the path."""
    plot = Plot(method.facts(path.values(t)), dict(path.near(t)))
    return replay(method.position, plot, path.crossings(t))


def stride(method: Method, pace: Sequence[float], deg: float, part: float) -> float:
    """The length on which no driver goes farther than an angle, or a part of the mechanism's size."""
    units = [method.size * part if driver.kind == "slide" else float(np.radians(deg)) for driver in method.drivers]
    return min((unit / abs(p) for unit, p in zip(units, pace, strict=True) if p), default=1.0)


def turned(method: Method, plot: Plot) -> dict[str, Real]:
    """Angles by base link, and displacements by `slide_key`."""
    return {base: plot.theta[base] for base in method.structure.bases} | by_slide_key(plot.s)


def by_slide_key(displacements: Mapping[str, Real]) -> dict[str, Real]:
    """Displacements, or how fast they change, named as `near` has them."""
    return {slide_key(slide): value for slide, value in displacements.items()}


@frozen
class Nodes:
    """Positions in the order in which they were found: t (m,) on the path, angles and displacements x (m, n) [rad, m],
    how fast they change with t (slope), and signed sines of crossings (m, k)."""

    t: np.ndarray
    x: np.ndarray
    slope: np.ndarray
    sines: np.ndarray

    def __len__(self) -> int:
        return int(self.t.size)

    def __getitem__(self, which: slice | np.ndarray) -> Nodes:
        return Nodes(self.t[which], self.x[which], self.slope[which], self.sines[which])

    def and_then(self, others: Nodes) -> Nodes:
        mine, theirs = ((nodes.t, nodes.x, nodes.slope, nodes.sines) for nodes in (self, others))
        return Nodes(*(np.concatenate(pair) for pair in zip(mine, theirs)))

    def in_order(self) -> Nodes:
        """As they lie on the path."""
        return self[np.argsort(self.t)]

    def expected(self, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The places to which the last two lead at t (k,), and how fast: (k, n) each; one alone goes straight on."""
        if len(self) == 1:
            return self.foretold(t), np.broadcast_to(self.slope, (t.size, self.x.shape[1]))
        return cubic(self[-2:-1], self[-1:], t)

    def foretold(self, t: np.ndarray) -> np.ndarray:
        """The places to which the last three lead at t (k,): (k, n). By divided differences, each node taken twice."""
        last = self[-3:]
        twice, differences = np.repeat(last.t, 2), np.repeat(last.x, 2, axis=0)
        terms = [differences[0]]
        for order in range(1, twice.size):
            widths = (twice[order:] - twice[:-order])[:, None]
            differences = np.diff(differences, axis=0)
            if order == 1:
                differences[::2], widths[::2] = last.slope, 1.0
            differences = differences / widths
            terms.append(differences[0])
        values = np.broadcast_to(terms[-1], (t.size, terms[-1].size))
        for place, term in zip(twice[-2::-1], terms[-2::-1]):
            values = term + (t - place)[:, None] * values
        return values

    def between(self, count: int) -> tuple[np.ndarray, np.ndarray]:
        """So many places from each to the next, t (m,) and x (m, n), and the last one."""
        t = self.t[:-1, None] + np.diff(self.t)[:, None] * (np.arange(count) / count)
        ends = np.repeat(np.arange(len(self)), count)
        x, _ = cubic(self[ends[:-count]], self[ends[count:]], t.ravel())
        return np.append(t.ravel(), self.t[-1]), np.concatenate([x, self.x[-1:]])


def cubic(left: Nodes, right: Nodes, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Hermite's cubics through pairs of nodes, one or (k,), and their slopes at t (k,), between or beyond: (k, n)."""
    width = (right.t - left.t)[:, None]
    u = (t - left.t)[:, None] / width
    v = 1 - u
    x = left.x * ((1 + 2 * u) * v * v) + right.x * (u * u * (3 - 2 * u))
    x = x + width * (left.slope * (u * v * v) - right.slope * (u * u * v))
    slope = (6 * u * v / width) * (right.x - left.x)
    return x, slope + left.slope * (v * (1 - 3 * u)) - right.slope * (u * (2 - 3 * u))
