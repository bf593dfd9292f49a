"""Instant centres at many positions, none of them wrong where Kennedy's lines nearly coincide.

How the centres are found is chosen for one position. Elsewhere two lines may run together; there the centre is taken
from velocities instead, and later centres go on from it.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from graphkin.base.geometry import Value, weights_of
from graphkin.construction import Plot, replay
from graphkin.construction.drafting import Board, draw
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import FRAME
from graphkin.proof.readings import readings
from graphkin.running.path import DriverPath, along, stride
from graphkin.studies.centres.instant_centres import Centres
from graphkin.studies.centres.underlay import board_over, from_velocities, pole_name

LEAN = 0.02
"""Two lines that are less than this far from being one do not tell where they meet."""
BESIDE = np.array([-3.0, -2.0, -1.0, 1.0, 2.0, 3.0])
ASIDE_DEG, ASIDE_PART = 0.05, 0.001
"""Neighbours of a change point, and how far apart they stand [deg, of the mechanism's size]."""


def over(found: Centres, path: DriverPath, t: np.ndarray) -> Centres:
    """The same centres at other positions t (n,) on a way.

    Drivers move as the way goes, whatever their speeds are: with several of them the centres hang on that. At a change
    point velocities are 0/0 on paper: there the centres are what those beside it lead to.
    """
    there = _drawn(found, path, t)
    for change in path.changes:
        aside = _aside(found, path, change.at)
        rows = np.flatnonzero(np.abs(t - change.at) < aside * (1 - 1e-9))
        if rows.size:
            beside = _drawn(found, path, change.at + aside * BESIDE).board
            for name in (found.name(*links) for links in found.pairs):
                if name in beside.points:
                    _led_to(there.board, beside, name, rows, (t[rows] - change.at) / aside, t.size)
    return there


def _aside(found: Centres, path: DriverPath, centre: float) -> float:
    """How far from a change point the neighbours stand, which no other change point or stop is near."""
    others = [abs(event.at - centre) for event in (*path.changes, *path.stops) if event.at != centre]
    return min(stride(found.method, path.pace, ASIDE_DEG, ASIDE_PART), min(others, default=np.inf) / 10)


def _led_to(board: Board, beside: Board, name: str, rows: np.ndarray, x: np.ndarray, count: int) -> None:
    """Put one centre in at rows x asides from a change point (m,), from its neighbours (Lagrange)."""
    near = np.broadcast_to(beside.points[name].reshape(3, -1), (3, BESIDE.size))
    with np.errstate(divide="ignore", invalid="ignore"):
        near = near / np.linalg.norm(near, axis=0)
        near = near * np.where(np.sum(near * near[:, :1], axis=0) < 0, -1.0, 1.0)
    seen = np.array(np.broadcast_to(board.points[name].reshape(3, -1), (3, count)))
    seen[:, rows] = near @ weights_of(x, BESIDE).T
    board.points[name] = seen


def _drawn(found: Centres, path: DriverPath, t: np.ndarray) -> Centres:
    method, centring = found.method, found.centring
    plot = along(method, path, t)
    plot = replace(plot, facts=replace(plot.facts, rates=path.pace))
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        replay(method.velocity, plot)
        board, motions = board_over(method, plot), readings(method, plot)
        for stage in centring.stages:
            links = centring.links[stage.last.name]
            if stage.say == "velocities":
                board.underlay.points[pole_name(*links)] = from_velocities(board, motions, *links)
            draw(stage, board)
            if stage.last.name in board.lean:
                _mend(board, motions, stage.last.name, links)
        for links in centring.together:
            board.points[found.name(*links)] = from_velocities(board, motions, *links)
    return Centres(method, centring, plot, board)


def _mend(board: Board, motions: Motions, centre: str, links: tuple[str, str]) -> None:
    """Where its two lines are nearly one, the centre from velocities."""
    doubtful = ~(board.lean[centre] > LEAN)
    if np.any(doubtful):
        places = from_velocities(board, motions, *links), board.points[centre]
        other, known = (place.reshape(3, -1) for place in places)
        better = doubtful & np.isfinite(other).all(axis=0)
        board.points[centre] = np.where(better, other, known)


def carried_to(plot: Plot, link: str) -> tuple[Value, Value]:
    """Where a link's axes stand: (origin [m], unit vector of its x axis)."""
    if link == FRAME:
        return 0j, 1.0
    turn = np.exp(1j * plot.theta[link])
    shape = plot.facts.shapes[link]
    point = next(name for name in shape if name in plot.position)
    return plot.position[point] - shape[point] * turn, turn
