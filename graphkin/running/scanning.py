"""A path looked along in positions half a degree apart, for dead points, where it ends, and for change points."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from graphkin.construction import Plot, replay
from graphkin.planning.method import Method
from graphkin.running.path import DriverPath, Event, along, stride, turned, with_nodes
from graphkin.running.singularities import LOOK_DEG, LOOK_PART, Crossing, choice_of, crossings, event_at, first_touching

FAST, HALVINGS = 0.5, 6
"""Where a link turns more between two positions [rad], those between are looked at, too; so often."""


def scanned(method: Method, path: DriverPath, end: float) -> DriverPath:
    """The path with what lies between the drawn position and `end` on it."""
    begin, step = 0.0, stride(method, path.pace, LOOK_DEG, LOOK_PART)
    side = 1.0 if end > 0 else -1.0
    while side * (end - begin) > 1e-6 * step:
        count = int(np.ceil(abs(end - begin) / step)) + 2
        seen, t, plot = _seen(method, path, np.linspace(begin, end, count))
        event = _next_event(method, seen, t, plot)
        if event is None:
            return seen
        path = _as_far_as(seen, event.at)
        if not event.choices:
            return replace(path, stops=(*path.stops, event))
        path = replace(path, changes=(*path.changes, event))
        begin = event.at + side * 1e-3 * step
    return path


def _seen(method: Method, path: DriverPath, t: np.ndarray) -> tuple[DriverPath, np.ndarray, Plot]:
    """The plot at t, from the drawn position on to one side; where rolling counts, each position from the one before.

    There the path gets what is found as its nodes, and more positions where a link turns fast.
    """
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
    return with_nodes(path, t, {name: _filled(t, table) for name, table in tables.items()}), t, plot


def _filled(t: np.ndarray, table: np.ndarray) -> np.ndarray:
    """A table with what lies between where a position has no value of its own."""
    there = np.isfinite(table)
    order = np.argsort(t[there])
    return table if there.all() or not there.any() else np.interp(t, t[there][order], table[there][order])


def _as_far_as(path: DriverPath, end: float) -> DriverPath:
    """The path without nodes beyond `end`."""
    if path.nodes is None:
        return path
    t, tables = path.nodes
    kept = t <= end if end > 0 else t >= end
    return replace(path, nodes=(t[kept], {name: table[kept] for name, table in tables.items()}))


def _next_event(method: Method, path: DriverPath, t: np.ndarray, plot: Plot) -> Event | None:
    """The first stop or change point among positions t, in their order."""
    found: list[tuple[float, Crossing, bool]] = []
    for step in crossings(method):
        if (met := first_touching(method, path, t, step, plot)) is not None:
            found.append((met[0], step, met[1]))
    if not found:
        return None
    nearest = min(abs(place - t[0]) for place, _, _ in found)
    here = [entry for entry in found if abs(entry[0] - t[0]) < nearest + 1e-3 * abs(t[1] - t[0])]
    at, step, passes = here[0]
    choices = tuple(choice for _, other, through in here if through for choice in choice_of(other))
    return event_at(method, step, at, choices if passes else ())
