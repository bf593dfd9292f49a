"""Positions, velocities and accelerations along a sweep, each held to be the slope of the one before."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import Mechanism
from graphkin.planning import plan
from graphkin.proof.roads import apart
from graphkin.studies.sweeps import Course, course, prove
from graphkin.studies.sweeps.roads import moving

BESIDE, SHARP = 0.03, 0.02
"""Two roads are held together this far from events [rad, size], where the matrix is not worse conditioned than this."""


def hold_continuous(mechanism: Mechanism, turns: float = 2, step: float = 1.0) -> None:
    """Over some turns, or as far as it gets: continuous by both roads, which agree, also at change points and backwards."""
    drivers = tuple(replace(driver, acceleration=0.0) for driver in mechanism.drivers)
    method = plan(replace(mechanism, drivers=drivers))
    driver = method.drivers[0]
    ranges: Sequence[str] = ()
    if len(drivers) == 1 and driver.kind != "slide":
        begin = math.degrees(driver.value or 0.0)
        ranges = [f"{begin + 360 * turns!r}:{begin!r}:{-step!r}"]
    moved = course(method, ranges)
    prove(moved)
    t = _places(moved, step)
    roads = [moving(method, moved.path, t, by) for by in ("construction", "analysis")]
    rate = method.drivers[moved.swept].rate / moved.path.pace[moved.swept]
    for road in roads:
        _hold_slopes(method.mechanism, road, t, rate, method.size)
    clear = roads[1].condition > SHARP
    for event in (*moved.path.changes, *moved.path.stops):
        clear &= np.abs(t - event.at) > BESIDE * (1 if moved.angular else method.size)
    if clear.any():
        assert apart(method.mechanism, *(moving(method, moved.path, t[clear], by) for by in ("construction", "analysis"))) < 1e-9


def _places(moved: Course, step: float) -> np.ndarray:
    """Closely over what is asked for, and every change point; not right beside a stop."""
    path = moved.path
    low, high = float(moved.t.min()), float(moved.t.max())
    trim = 0.02 * (path.last - path.first)
    if path.stops:
        low, high = max(low, path.first + trim), min(high, path.last - trim)
    count = 361 if not moved.angular else max(361, round(math.degrees(high - low) / step))
    inside = [change.at for change in path.changes if low <= change.at <= high]
    return np.unique(np.concatenate([np.linspace(low, high, count), inside]))


def _hold_slopes(mechanism: Mechanism, road: Motions, t: np.ndarray, rate: float, size: float) -> None:
    for point in mechanism.points:
        link = mechanism.owners[point][-1]
        place = np.broadcast_to(road.position[point], t.shape)
        speed = np.broadcast_to(road.velocity_at(point, link), t.shape) / rate
        change = np.broadcast_to(road.acceleration_at(point, link), t.shape) / rate**2
        assert np.isfinite(place + speed + change).all(), (mechanism.name, point)
        _hold_slope(place, speed, t, size)
        _hold_slope(speed, change, t, max(float(np.abs(speed).max()), size))


def _hold_slope(value: np.ndarray, slope: np.ndarray, t: np.ndarray, size: float) -> None:
    """A step is the mean slope times its length, but for what the slope itself changes over it."""
    length, change = np.diff(t), np.abs(np.diff(slope))
    change = np.maximum(change, np.maximum(np.append(change[1:], 0), np.append(0, change[:-1])))
    off = np.abs(np.diff(value) - length * (slope[1:] + slope[:-1]) / 2)
    assert (off <= 3 * length * change + 1e-7 * size).all(), float(t[int(np.argmax(off))])
