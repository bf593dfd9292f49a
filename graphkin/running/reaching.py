"""Other positions: whether a mechanism gets there from the drawn one, and how, where each hangs on the one before."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from graphkin.base.geometry import Value
from graphkin.construction import Plot, replay
from graphkin.errors import NotReached
from graphkin.model.quantities import EDGE, driven
from graphkin.planning.method import Method
from graphkin.running.many_positions import along_in_parts
from graphkin.running.path import STEP_DEG, STEP_PART, DriverPath, along, stride, turned
from graphkin.running.tracing import trace

SURPRISE = 0.02
"""How far a link may turn beside what its turning so far foretold [rad]; more, and the step is halved."""
SHORTEST = 1 / 256
"""Steps are not halved below this part of the longest, for many positions at once."""


# --- single positions -------------------------------------------------------------------------


def reached(method: Method, values: Sequence[Value]) -> tuple[DriverPath, float]:
    """The path to a position, and how far on it; the other way round where only that one is free of dead points."""
    path, t = _to(method, values)
    if not path.leads_to(t):
        other = _other_way_round(method, values)
        second, far = _to(method, other)
        if method.structure.contacts or not second.leads_to(far):
            raise _not_reached(method, path, t)
        return second, far
    return path, t


def _to(method: Method, values: Sequence[Value]) -> tuple[DriverPath, float]:
    """The straight path from the drawn position: t counts the driver that goes farthest."""
    start = np.array([float(value) for value in method.facts(None).values])
    change = np.array([float(value) for value in values]) - start
    t = float(np.max(np.abs(change), initial=0.0))
    pace = change / t if t else np.zeros_like(change)
    return trace(method, tuple(pace), 0.0, t), t


def _other_way_round(method: Method, values: Sequence[Value]) -> Sequence[Value]:
    start = method.facts(None).values
    return [
        end - np.copysign(2 * np.pi, end - begin) if driver.kind == "angle" and end != begin else end
        for begin, end, driver in zip(start, values, method.drivers, strict=True)
    ]


def _not_reached(method: Method, path: DriverPath, t: float) -> NotReached:
    moving = int(np.argmax(np.abs(path.pace)))
    driver = method.drivers[moving]
    unit = EDGE[driven(driver.kind == "slide")]
    start, end, stop = (unit.shown(float(path.values(at)[moving])) for at in (0.0, t, path.last))
    return NotReached(method.mechanism.where("driver", moving), driver.name, start, end, stop)


# --- positions --------------------------------------------------------------------------------


def moved_to(method: Method, values: Sequence[Value]) -> Plot:
    """One position, reached from the drawn one; or many, all at once.

    Where each position hangs on the one before (a fit, rolling) the many are reached by moving on, too.
    """
    if not any(np.ndim(value) for value in values):
        return along(method, *reached(method, values))
    if not method.moves_on:
        return replay(method.position, Plot(method.facts(values)))
    way = on_one_way(method, values)
    return _fanned(method, values) if way is None else along_in_parts(method, *way)


def on_one_way(method: Method, values: Sequence[Value]) -> tuple[DriverPath, np.ndarray] | None:
    """Many positions on one path, where each hangs on the one before; nan where it does not lead. None: on no one."""
    if not method.moves_on or not any(np.ndim(value) for value in values):
        return None
    start = np.array(method.facts(None).values)
    change = np.array([value - begin for value, begin in zip(np.broadcast_arrays(*values), start, strict=True)])
    far = change.reshape(len(start), -1)
    line = far[:, int(np.argmax(np.abs(far).sum(axis=0)))]
    along_it = np.tensordot(line, change, 1) / max(float(line @ line), np.finfo(float).tiny)
    if not np.allclose(np.multiply.outer(line, along_it), change, rtol=0, atol=1e-12):
        return None
    path = trace(method, tuple(line), float(min(along_it.min(), 0.0)), float(max(along_it.max(), 0.0)))
    return path, np.where(path.leads_to(along_it), along_it, np.nan)[()]


def _fanned(method: Method, values: Sequence[Value]) -> Plot:
    """Every position on its own straight path, step by step, each foretold from the two before; a step that surprises
    one of them is halved for all."""
    facts = method.facts(values)
    start = method.facts(None).values
    changes = [np.asarray(end) - begin for begin, end in zip(start, facts.values, strict=True)]
    farthest = tuple(float(np.max(np.abs(change))) for change in changes)
    longest = min(1.0, stride(method, farthest, STEP_DEG, STEP_PART))
    done, step = 0.0, longest
    near: dict[str, Value] = {**method.near}
    slope: dict[str, Value] = dict.fromkeys(near, 0.0)
    while True:
        there = min(1.0, done + step)
        at = tuple(begin + change * there for begin, change in zip(start, changes, strict=True))
        guess = {name: near[name] + slope[name] * (there - done) for name in near}
        plot = replay(method.position, Plot(replace(facts, values=at), guess))
        now = turned(method, plot)
        if _surprise(now, guess, method.structure.bases) > SURPRISE and step > longest * SHORTEST:
            step /= 2
            continue
        if there == 1.0:
            return plot
        slope = {name: np.nan_to_num((now[name] - near[name]) / (there - done)) for name in now}
        near, done, step = now, there, min(longest, 1.5 * step)


def _surprise(now: Mapping[str, Value], guess: Mapping[str, Value], bases: Sequence[str]) -> float:
    """The largest angle between where links are and where they were expected."""
    return max((float(np.nanmax(np.abs(now[b] - guess[b]), initial=0.0)) for b in bases), default=0.0)
