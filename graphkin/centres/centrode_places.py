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
from graphkin.methods.way import Way, along
from graphkin.motions import Motions
from graphkin.readings import readings
from graphkin.steps import Plot, replay
from graphkin.steps.centring import STILL, Kennedy, Pole, axes_of, take

__all__ = ["at_many", "carried_to", "over"]

LEAN = 0.02
"""Two lines that are less than this far from being one do not tell where they meet."""


def over(found: Centres, way: Way, t: np.ndarray) -> Centres:
    """The same centres at other positions t (n,) on a way."""
    return Centres(found.method, found.centring, at_many(found, way, t))


def at_many(found: Centres, way: Way, t: np.ndarray) -> Plot:
    """A plot of the positions t (n,) on the way, with velocities along it and all centres.

    Drivers move as the way goes, whatever their speeds are: with several of them the centres hang on that.
    """
    method = found.method
    plot = along(method, way, t)
    plot = replace(plot, facts=replace(plot.facts, rates=way.pace), centres={}, lean={})
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        replay(method.velocity, plot)
        motions = readings(method, plot)
        for step in found.centring.steps:
            if isinstance(step, Pole):  # by each position's own pace: one that is broken must not spoil the others
                plot.centres[step.centre] = _from_velocities(plot, motions, *found.centring.links[step.centre])
                continue
            take(step, plot)
            if isinstance(step, Kennedy):
                _mend(plot, motions, step.centre, found.centring.links[step.centre])
        for links in found.centring.together:
            plot.centres[found.name(*links)] = _from_velocities(plot, motions, *links)
    return plot


def _mend(plot: Plot, motions: Motions, centre: str, links: tuple[str, str]) -> None:
    """Where its two lines are nearly one, the centre from velocities."""
    with np.errstate(invalid="ignore"):
        doubtful = ~(plot.lean[centre] > LEAN)
    if np.any(doubtful):
        places = _from_velocities(plot, motions, *links), plot.centres[centre]
        other, known = (place.reshape(3, -1) for place in places)
        better = doubtful & np.isfinite(other).all(axis=0)
        plot.centres[centre] = np.where(better, other, known)


def _from_velocities(plot: Plot, motions: Motions, first: str, second: str) -> Value:
    """Where two links have one velocity, homogeneous; NaN where they do not move against each other."""
    (one, turn), (other, turned) = (_motion(plot, motions, link) for link in (first, second))
    moving, turning = one - other, turn - turned
    pace = np.max(np.broadcast_arrays(*(np.abs(value) for value in plot.omega.values())), axis=0)
    turning = np.where(np.abs(turning) <= STILL * pace, 0.0, turning)
    across = 1j * np.where((np.abs(moving) <= STILL * pace) & (turning == 0), 0.0, moving)
    found = np.array(np.broadcast_arrays(np.real(across), np.imag(across), turning))
    return found / np.linalg.norm(found, axis=0)


def _motion(plot: Plot, motions: Motions, link: str) -> tuple[Value, Value]:
    """Velocity of the link's place at the origin of coordinates, in units of size, and its rotation."""
    if link == FRAME:
        return 0j, 0.0
    origin, size = axes_of(plot)
    point = next(name for name in motions.mechanism.links[link].points if name in plot.position)
    omega = plot.omega[link]
    return (motions.velocity_at(point, link) + 1j * omega * (origin - plot.position[point])) / size, omega


def carried_to(found: Centres, plot: Plot, link: str) -> tuple[Value, Value]:
    """Where a link's axes stand: (origin [m], unit vector of its x axis)."""
    if link == FRAME:
        return 0j, 1.0
    turn = np.exp(1j * plot.theta[link])
    shape = plot.facts.shapes[link]
    point = next(name for name in shape if name in plot.position)
    return plot.position[point] - shape[point] * turn, turn
