"""The path of a mechanism along a line of driver values: how far it leads from the drawn position, and through what.

Two circles (or a line and a circle) that touch on the path and part again are a dead point: there the path ends.
Where they touch without parting, all links of the group in line, it is a change point: the mechanism goes through
smoothly, and from there on the other crossing is the right one. Two lines that become parallel end the path, too.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field, replace

import numpy as np

from graphkin.base.geometry import Value
from graphkin.base.value import Lazy, frozen
from graphkin.construction import Plot, replay, slide_key
from graphkin.planning.method import Method

STEP_DEG, STEP_PART = 3.0, 0.02
"""The longest step from one position to the next that is found from it [deg, of the mechanism's size]."""


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

    def values(self, t: Value) -> tuple[Value, ...]:
        """The drivers' values [rad, m]."""
        return tuple(start + pace * t if pace else start for start, pace in zip(self.start, self.pace, strict=True))

    def leads_to(self, t: Value) -> Value:
        """Whether the positions are reached."""
        after = [stop.at for stop in self.stops if stop.at > 0]
        before = [stop.at for stop in self.stops if stop.at < 0]
        return np.all([np.less(t, at) for at in after] + [np.greater(t, at) for at in before], axis=0)

    def crossings(self, t: Value) -> dict[int, Value]:
        """Which crossing is right at each t, for those choices that change over on the path."""
        found: dict[int, Value] = {**self.sides}
        for change in self.changes:
            beyond = np.greater(t, change.at) if change.at > 0 else np.less(t, change.at)
            for choice in change.choices:
                found[choice] = np.where(beyond, -1, 1) * found[choice]
        return found

    def near(self, t: Value) -> Mapping[str, Value]:
        """Angles and displacements close by, where fitting starts and from where angles count."""
        if self.nodes is None:
            return {}
        at, tables = self.nodes
        return Lazy(tables, lambda name: np.interp(t, at, tables[name])[()])


def with_nodes(path: DriverPath, t: np.ndarray, tables: Mapping[str, np.ndarray]) -> DriverPath:
    """The path with what is found at t (m,), which goes on from the drawn position to one side; nodes there go."""
    assert path.nodes is not None
    at, before = path.nodes
    kept = at < t[0] if t[-1] > t[0] else at > t[0]
    order = np.argsort(found := np.concatenate([at[kept], t]))
    joined = {name: np.concatenate([before[name][kept], table])[order] for name, table in tables.items()}
    return replace(path, nodes=(found[order], joined))


def along(method: Method, path: DriverPath, t: Value) -> Plot:
    """The positions at t, scalar or (n,), on the path."""
    plot = Plot(method.facts(path.values(t)), dict(path.near(t)))
    return replay(method.position, plot, path.crossings(t))


def stride(method: Method, pace: Sequence[float], deg: float, part: float) -> float:
    """How far t goes while no driver goes farther than an angle, or a part of the mechanism's size."""
    units = [method.size * part if driver.kind == "slide" else float(np.radians(deg)) for driver in method.drivers]
    return min((unit / abs(p) for unit, p in zip(units, pace, strict=True) if p), default=1.0)


def turned(method: Method, plot: Plot) -> dict[str, Value]:
    """Angles by base link, and displacements by `slide_key`."""
    return {base: plot.theta[base] for base in method.structure.bases} | by_slide_key(plot.s)


def by_slide_key(displacements: Mapping[str, Value]) -> dict[str, Value]:
    """Displacements, or how fast they change, named as `near` has them."""
    return {slide_key(slide): value for slide, value in displacements.items()}
