"""Instant centres at many positions, none of them wrong where Kennedy's lines nearly coincide.

How the centres are found is chosen for one position. Elsewhere two lines may run together; there the centre is taken
from velocities instead, and later centres go on from it.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from graphkin.centres.found import Centres
from graphkin.geometry import Value
from graphkin.mechanism import FRAME
from graphkin.methods.way import Way, along, stride
from graphkin.readings import Readings
from graphkin.steps import Plot, replay
from graphkin.steps.centring import STILL, Kennedy, Pole, axes_of, take

__all__ = ["at_many", "carried_to", "over"]

LEAN = 0.02
"""Two lines that are less than this far from being one do not tell where they meet."""
BESIDE = np.array([-3.0, -2.0, -1.0, 1.0, 2.0, 3.0])
ASIDE_DEG, ASIDE_PART = 0.05, 0.001
"""Neighbours of a change point, and how far apart they stand [deg, of the mechanism's size]."""


def over(found: Centres, way: Way, t: np.ndarray) -> Centres:
    """The same centres at other positions t (n,) on a way."""
    return Centres(found.method, found.centring, at_many(found, way, t))


def at_many(found: Centres, way: Way, t: np.ndarray) -> Plot:
    """A plot of the positions t (n,) on the way, with velocities along it and all centres.

    Drivers move as the way goes, whatever their speeds are: with several of them the centres hang on that. At a change
    point velocities are 0/0 on paper: there the centres are what those beside it lead to.
    """
    plot = _at_many(found, way, t)
    for change in way.changes:
        aside = _aside(found, way, change.at)
        rows = np.flatnonzero(np.abs(t - change.at) < aside * (1 - 1e-9))
        if rows.size:
            beside = _at_many(found, way, change.at + aside * BESIDE)
            for name in plot.centres:
                _led_to(plot, beside, name, rows, (t[rows] - change.at) / aside, t.size)
    return plot


def _aside(found: Centres, way: Way, centre: float) -> float:
    """How far from a change point the neighbours stand, which no other change point or stop is near."""
    others = [abs(event.at - centre) for event in (*way.changes, *way.stops) if event.at != centre]
    return min(stride(found.method, way.pace, ASIDE_DEG, ASIDE_PART), min(others, default=np.inf) / 10)


def _led_to(plot: Plot, beside: Plot, name: str, rows: np.ndarray, x: np.ndarray, count: int) -> None:
    """Put one centre in at rows x asides from a change point (m,), from its neighbours (Lagrange)."""
    near = np.broadcast_to(beside.centres[name].reshape(3, -1), (3, BESIDE.size))
    with np.errstate(divide="ignore", invalid="ignore"):
        near = near / np.linalg.norm(near, axis=0)
        near = near * np.where(np.sum(near * near[:, :1], axis=0) < 0, -1.0, 1.0)
    weights = [np.prod([(x - other) / (node - other) for other in BESIDE if other != node], axis=0) for node in BESIDE]
    seen = np.array(np.broadcast_to(plot.centres[name].reshape(3, -1), (3, count)))
    seen[:, rows] = near @ np.array(weights)
    plot.centres[name] = seen


def _at_many(found: Centres, way: Way, t: np.ndarray) -> Plot:
    method = found.method
    plot = along(method, way, t)
    plot = replace(plot, facts=replace(plot.facts, rates=way.pace), centres={}, lean={})
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        replay(method.velocity, plot)
        readings = Readings(method, plot)
        for step in found.centring.steps:
            if isinstance(step, Pole):  # by each position's own pace: one that is broken must not spoil the others
                plot.centres[step.centre] = _from_velocities(readings, *found.centring.links[step.centre])
                continue
            take(step, plot)
            if isinstance(step, Kennedy):
                _mend(readings, step.centre, found.centring.links[step.centre])
        for links in found.centring.together:
            plot.centres[found.name(*links)] = _from_velocities(readings, *links)
    return plot


def _mend(readings: Readings, centre: str, links: tuple[str, str]) -> None:
    """Where its two lines are nearly one, the centre from velocities."""
    plot = readings.plot
    with np.errstate(invalid="ignore"):
        doubtful = ~(plot.lean[centre] > LEAN)
    if np.any(doubtful):
        other, known = (place.reshape(3, -1) for place in (_from_velocities(readings, *links), plot.centres[centre]))
        better = doubtful & np.isfinite(other).all(axis=0)
        plot.centres[centre] = np.where(better, other, known)


def _from_velocities(readings: Readings, first: str, second: str) -> Value:
    """Where two links have one velocity, homogeneous; NaN where they do not move against each other."""
    (one, turn), (other, turned) = (_motion(readings, link) for link in (first, second))
    moving, turning = one - other, turn - turned
    pace = np.max(np.broadcast_arrays(*(np.abs(value) for value in readings.plot.omega.values())), axis=0)
    turning = np.where(np.abs(turning) <= STILL * pace, 0.0, turning)
    across = 1j * np.where((np.abs(moving) <= STILL * pace) & (turning == 0), 0.0, moving)
    found = np.array(np.broadcast_arrays(np.real(across), np.imag(across), turning))
    return found / np.linalg.norm(found, axis=0)


def _motion(readings: Readings, link: str) -> tuple[Value, Value]:
    """Velocity of the link's place at the origin of coordinates, in units of size, and its rotation."""
    if link == FRAME:
        return 0j, 0.0
    plot = readings.plot
    origin, size = axes_of(plot)
    point = next(name for name in readings.method.mechanism.links[link].points if name in plot.position)
    omega = plot.omega[link]
    return (readings.velocity_at(point, link) + 1j * omega * (origin - plot.position[point])) / size, omega


def carried_to(found: Centres, plot: Plot, link: str) -> tuple[Value, Value]:
    """Where a link's axes stand: (origin [m], unit vector of its x axis)."""
    if link == FRAME:
        return 0j, 1.0
    turn = np.exp(1j * plot.theta[link])
    shape = plot.facts.shapes[link]
    point = next(name for name in shape if name in plot.position)
    return plot.position[point] - shape[point] * turn, turn
