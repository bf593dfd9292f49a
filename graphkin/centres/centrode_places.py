"""Instant centres at many positions, none of them wrong where Kennedy's lines nearly coincide.

How the centres are found is chosen for one position. Elsewhere two lines may run together; there the centre is taken
from velocities instead, and later centres go on from it.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from graphkin.centres.beneath import board_over, from_velocities, pole_name
from graphkin.centres.found import Centres
from graphkin.drafting import Board, draw
from graphkin.geometry import Value
from graphkin.mechanism import FRAME
from graphkin.methods.way import Way, along
from graphkin.readings import Readings
from graphkin.steps import Plot, replay

__all__ = ["carried_to", "over"]

LEAN = 0.02
"""Two lines that are less than this far from being one do not tell where they meet."""


def over(found: Centres, way: Way, t: np.ndarray) -> Centres:
    """The same centres at other positions t (n,) on a way.

    Drivers move as the way goes, whatever their speeds are: with several of them the centres hang on that.
    """
    method, centring = found.method, found.centring
    plot = along(method, way, t)
    plot = replace(plot, facts=replace(plot.facts, rates=way.pace))
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        replay(method.velocity, plot)
        board, readings = board_over(method, plot), Readings(method, plot)
        for stage in centring.stages:
            links = centring.links[stage.last.name]
            if stage.say == "velocities":
                board.beneath.points[pole_name(*links)] = from_velocities(board, readings, *links)
            draw(stage, board)
            if stage.last.name in board.lean:
                _mend(board, readings, stage.last.name, links)
        for links in centring.together:
            board.points[found.name(*links)] = from_velocities(board, readings, *links)
    return Centres(method, centring, plot, board)


def _mend(board: Board, readings: Readings, centre: str, links: tuple[str, str]) -> None:
    """Where its two lines are nearly one, the centre from velocities."""
    doubtful = ~(board.lean[centre] > LEAN)
    if np.any(doubtful):
        places = from_velocities(board, readings, *links), board.points[centre]
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
