"""A path traced from the drawn position: how far it leads, and through what.

It is looked along in positions half a degree apart, for dead points, where it ends, and for change points; where links
are fitted it is continued from position to position.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from graphkin.base.cache import kept
from graphkin.base.geometry import Real, number
from graphkin.construction import Meet, Plot, Swing, replay
from graphkin.errors import TooFar
from graphkin.model.quantities import EDGE, driven
from graphkin.planning import Method
from graphkin.planning.refusals import Crossing, key_of
from graphkin.running.continuation import continued
from graphkin.running.path import DriverPath, along, stride, turned, with_nodes
from graphkin.running.singularities import LOOK_DEG, LOOK_PART, choice_of, crossings, event_at, first_touching

FAST, HALVINGS = 0.5, 6
"""If a link turns more between two positions [rad], those between are looked at, too; so often."""
MOST = 1e7  # points looked at on a path, at most: some 0.3 GB
FITTING = 30  # the cost of a position where links are fitted, beside another


def trace(
    method: Method, pace: Sequence[float], low: float, high: float, after: tuple[DriverPath, float] | None = None
) -> DriverPath:
    """Look along the path from t = low to t = high (low <= 0 <= high) for stops and change points; from a place on
    another path, where `after` has one, else from the drawn position."""
    ends, pace = (float(low), float(high)), tuple(float(p) for p in pace)
    if after is None:
        return _from_drawn(method, pace, ends)
    before, t = after
    near = {name: number(value) for name, value in before.near(t).items()}
    sides = {choice: int(number(side)) for choice, side in before.crossings(t).items()}
    return _traced(method, _setting_out(method, before.values(t), near, sides, pace, ends))


@kept(16)
def _from_drawn(method: Method, pace: tuple[float, ...], ends: tuple[float, float]) -> DriverPath:
    """The same walk serves many sweeps."""
    steps = (step for step in method.position.steps if isinstance(step, Meet | Swing))
    sides = {step.choice: step.side for step in steps if step.choice is not None}
    return _traced(method, _setting_out(method, method.facts(None).values, method.near, sides, pace, ends))


def _traced(method: Method, path: DriverPath) -> DriverPath:
    """A path of which only the start is known, as far as it leads. Raises TooFar."""
    cost = max(len(method.mechanism.points), 4) * (FITTING if method.fits else 1)
    most = MOST / cost * stride(method, path.pace, LOOK_DEG, LOOK_PART)
    if not path.high - path.low <= most:  # too many positions to be looked at, every half degree
        moving = max(range(len(path.pace)), key=lambda k: abs(path.pace[k]))
        driver = method.drivers[moving]
        unit = EDGE[driven(driver.kind == "slide")]
        start, end = (unit.shown(path.start[moving] + path.pace[moving] * t) for t in (path.low, path.high))
        farthest = abs(path.pace[moving]) * most
        digits = 10.0 ** (math.floor(math.log10(farthest)) - 1)  # two of them, rounded off
        farthest = math.floor(farthest / digits) * digits
        raise TooFar(method.mechanism.where("driver", moving), driver.name, start, end, unit.shown(farthest))
    if path.low == path.high:
        return path
    if method.fits:
        return continued(method, path)
    for to in (path.high, path.low):
        path = _scanned(method, path, to)
    return path


def _setting_out(
    method: Method, start: Sequence[Real], near: Mapping[str, float], sides: Mapping[int, int],
    pace: tuple[float, ...], ends: tuple[float, float],
) -> DriverPath:  # fmt: skip
    nodes = (np.zeros(1), {name: np.full(1, value) for name, value in near.items()})
    return DriverPath(tuple(map(number, start)), pace, *ends, nodes=nodes if method.moves_on else None, sides=sides)


def _scanned(method: Method, path: DriverPath, end: float) -> DriverPath:
    """The path with what lies between the drawn position and `end` on it."""
    begin, step = 0.0, stride(method, path.pace, LOOK_DEG, LOOK_PART)
    side = 1.0 if end > 0 else -1.0
    while side * (end - begin) > 1e-6 * step:
        count = int(np.ceil(abs(end - begin) / step)) + 2
        seen, t, plot = _seen(method, path, np.linspace(begin, end, count))
        touches = _touches(method, seen, t, plot, crossings(method))
        if not touches:
            return seen
        # the first stop or change point among them
        nearest = min(abs(place - t[0]) for place, _, _ in touches)
        close = 1e-3 * abs(t[1] - t[0])
        here = [entry for entry in touches if abs(entry[0] - t[0]) < nearest + close]
        if here[0][2]:
            here = _as_it_goes_through(method, seen, here, close, side * step)
        place, crossing, _ = here[0]
        event, path = event_at(method, crossing, place, _choices(here)), seen
        if path.nodes is not None:  # none beyond the event
            at, tables = path.nodes
            kept = at <= event.at if event.at > 0 else at >= event.at
            path = replace(path, nodes=(at[kept], {name: table[kept] for name, table in tables.items()}))
        if not event.choices:
            return replace(path, stops=(*path.stops, event))
        path = replace(path, changes=(*path.changes, event))
        begin = event.at + side * 1e-3 * step
    return path


Touching = tuple[float, Crossing, bool]
"""Where on a path the loci of a crossing touch, or part, and whether the mechanism goes through."""


def _touches(
    method: Method, path: DriverPath, t: np.ndarray, plot: Plot, looked_at: Iterable[Crossing]
) -> list[Touching]:
    """The first of each crossing that has any at t."""
    found = ((crossing, first_touching(method, path, t, crossing, plot)) for crossing in looked_at)
    return [(met[0], crossing, met[1]) for crossing, met in found if met is not None]


def _choices(here: Sequence[Touching]) -> tuple[int, ...]:
    """The choices that change over there; none where the path ends."""
    return tuple(choice for _, crossing, _ in here for choice in choice_of(crossing)) if here[0][2] else ()


def _as_it_goes_through(
    method: Method, path: DriverPath, here: Sequence[Touching], close: float, step: float
) -> list[Touching]:
    """All crossings that touch at one change point, or what ends the path there. Some are seen only on the way through:
    with the old choices the path goes back beyond it, and there their loci may lie on each other, or part."""
    through = [entry for entry in here if entry[2]]
    place, first, _ = here[0]
    while True:
        event = event_at(method, first, place, _choices(through))
        beyond = replace(path, changes=(*path.changes, event))
        seen, t, plot = _seen(method, beyond, place + step * np.array([-1.0, -0.5, 0.5, 1.0]))
        known = {key_of(crossing) for _, crossing, _ in through}
        others = [crossing for crossing in crossings(method) if key_of(crossing) not in known]
        more = [entry for entry in _touches(method, seen, t, plot, others) if abs(entry[0] - place) < close]
        if not more:
            return through
        if not more[0][2]:
            return more[:1]
        through += more[:1]  # what hangs on it touches, or not, as it goes through


def _seen(method: Method, path: DriverPath, t: np.ndarray) -> tuple[DriverPath, np.ndarray, Plot]:
    """The plot at t, to one side; where rolling counts from position to position, with nodes for the path."""
    if path.nodes is None:
        return path, t, along(method, path, t)
    near = path.near(float(t[0]))
    for halving in range(HALVINGS + 1):
        plot = Plot(method.facts(path.values(t)), near, follows=True)
        replay(method.position, plot, path.crossings(t))
        tables = {name: np.array(np.broadcast_to(value, t.shape)) for name, value in turned(method, plot).items()}
        fast = np.max([np.abs(np.diff(tables[base])) for base in method.structure.bases], axis=0, initial=0.0) > FAST
        if not fast.any() or halving == HALVINGS:
            break
        t = np.insert(t, np.flatnonzero(fast) + 1, (t[:-1] + t[1:])[fast] / 2)
    for name, table in tables.items():  # with what lies between where a position has no value of its own
        if (there := np.isfinite(table)).any() and not there.all():
            order = np.argsort(t[there])
            tables[name] = np.interp(t, t[there][order], table[there][order])
    return with_nodes(path, t, tables), t, plot
