"""Other positions: whether a mechanism gets there from the drawn one, and how, where each hangs on the one before."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from graphkin.errors import NotReached
from graphkin.geometry import Value
from graphkin.methods.assembly import DEAD_SINE
from graphkin.steps import Facts, Plot, replay

if TYPE_CHECKING:
    from graphkin.methods import Method

__all__ = ["positioned", "reached"]

WAY_DEG, WAY_PART = 0.5, 0.002
"""How closely the way to another position is looked at for dead points [deg, of the mechanism's size]."""
STEP_DEG, STEP_PART = 3.0, 0.02
"""How far a mechanism is moved at once where its position is found from the one before [deg, of its size]."""
SURPRISE = 0.02
"""How far a link may turn beside what its turning so far foretold [rad]; more, and the step is halved."""


# --- dead points on the way -------------------------------------------------------------------


def reached(method: Method, values: Sequence[Value]) -> Sequence[Value]:
    """The values, or the same angles the other way round where only that way is free of dead points."""
    try:
        _refuse_dead_points_between(method, values)
    except NotReached:
        other = _other_way_round(method, values)
        if method.structure.contacts or not _free(method, other):
            raise
        return other
    return values


def _other_way_round(method: Method, values: Sequence[Value]) -> Sequence[Value]:
    start = method.facts(None).values
    return [
        end - np.copysign(2 * np.pi, end - begin) if driver.kind == "angle" and end != begin else end
        for begin, end, driver in zip(start, values, method.drivers, strict=True)
    ]


def _free(method: Method, values: Sequence[Value]) -> bool:
    """Whether no dead point lies between the drawn position and this one."""
    try:
        _refuse_dead_points_between(method, values)
    except NotReached:
        return False
    return True


def _refuse_dead_points_between(method: Method, values: Sequence[Value]) -> None:
    """Whether the mechanism gets from the drawn position to this one by moving on."""
    start = np.array([float(value) for value in method.facts(None).values])
    way = np.array([float(value) for value in values]) - start
    units = _units(method, WAY_DEG, WAY_PART)
    count = int(np.ceil(np.max(np.abs(way) / units))) if way.size else 0
    if count == 0:
        return
    shares = np.linspace(0.0, 1.0, count + 1)
    for _ in range(3):
        sines = _least_sines(method, start, way, shares)
        bad = np.flatnonzero(~(sines >= DEAD_SINE))
        if bad.size:
            raise _not_reached(method, start, way, float(shares[bad[0]]))
        low = int(np.argmin(sines))
        if sines[low] > 0.3:
            return
        shares = np.linspace(shares[max(low - 1, 0)], shares[min(low + 1, shares.size - 1)], 201)


def _least_sines(method: Method, start: np.ndarray, way: np.ndarray, shares: np.ndarray) -> np.ndarray:
    """The least angle at which lines meet, at each share of the way; NaN where they do not."""
    values = [begin + go * shares for begin, go in zip(start, way, strict=True)]
    plot = positioned(method, values)
    names = {step.name for step in method.ternaries.values()}
    sines = [
        np.broadcast_to(sine, shares.shape)
        for (plane, point), sine in plot.sines.items()
        if plane == "position" and point not in names
    ]
    least: np.ndarray = np.min([np.ones_like(shares), *sines], axis=0)
    return least


def _not_reached(method: Method, start: np.ndarray, way: np.ndarray, share: float) -> NotReached:
    moving = int(np.argmax(np.abs(way)))
    driver = method.drivers[moving]

    def told(value: float) -> str:
        return f"{value * 1000:.6g} mm" if driver.kind == "slide" else f"{np.degrees(value):.6g}°"

    where = method.mechanism.where("driver", moving)
    end, stop = start[moving] + way[moving], start[moving] + share * way[moving]
    return NotReached(where, driver.name, told(start[moving]), told(end), told(stop))


# --- moving on --------------------------------------------------------------------------------


def positioned(method: Method, values: Sequence[Value] | None) -> Plot:
    """Positions, all at once; where they hang on those before (a fit, rolling) by moving on from the drawn one."""
    facts = method.facts(values)
    if values is None or not method.moves_on:
        return replay(method.position, Plot(facts, method.near if method.moves_on else {}))
    return _moved_on(method, facts)


def _moved_on(method: Method, facts: Facts) -> Plot:
    """Step by step, each position foretold from the two before; a step that surprises is halved."""
    start = method.facts(None).values
    ways = [np.asarray(end) - begin for begin, end in zip(start, facts.values, strict=True)]
    longest = 1.0 / _stretches(method, ways)
    done, step = 0.0, longest
    near: dict[str, Value] = {**method.near}
    slope: dict[str, Value] = dict.fromkeys(near, 0.0)
    while True:
        there = min(1.0, done + step)
        values = tuple(begin + way * there for begin, way in zip(start, ways, strict=True))
        guess = {name: near[name] + slope[name] * (there - done) for name in near}
        plot = replay(method.position, Plot(replace(facts, values=values), guess))
        now = {base: plot.theta[base] for base in method.structure.bases} | dict(plot.s)
        if _surprise(now, guess, method.structure.bases) > SURPRISE and step > longest / 256:
            step /= 2
            continue
        if there == 1.0:
            return plot
        slope = {name: np.nan_to_num((now[name] - near[name]) / (there - done)) for name in now}
        near, done, step = now, there, min(longest, 1.5 * step)


def _stretches(method: Method, ways: Sequence[Value]) -> int:
    """In how many steps the drivers go their way."""
    units = _units(method, STEP_DEG, STEP_PART)
    return max(1, *(int(np.ceil(np.max(np.abs(way)) / unit)) for way, unit in zip(ways, units, strict=True)))


def _units(method: Method, deg: float, part: float) -> list[float]:
    """For each driver an angle, or for a slide a part of the mechanism's size [rad, m]."""
    size = max(abs(z) for shape in method.structure.shapes.values() for z in shape.values()) or 1.0
    return [size * part if driver.kind == "slide" else float(np.radians(deg)) for driver in method.drivers]


def _surprise(now: Mapping[str, Value], guess: Mapping[str, Value], bases: Sequence[str]) -> float:
    """The largest angle between where links are and where they were expected."""
    return max((float(np.nanmax(np.abs(now[b] - guess[b]), initial=0.0)) for b in bases), default=0.0)
