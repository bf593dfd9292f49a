"""kinepy: solids and joints, positions only (its rates come from differences, with the forces); reported only."""

from __future__ import annotations

import contextlib
import io
import warnings
from typing import Any

import numpy as np

from graphkin.planning import Method
from peers.lengths import Lengths

with warnings.catch_warnings():
    warnings.simplefilter("ignore")
    import kinepy

__all__ = ["four_bar"]


def four_bar(method: Method, side: int) -> tuple[Any, Any]:
    """The four-bar, compiled, and its joint C; side +1 or -1 picks the assembly."""
    known = Lengths(method)
    with contextlib.redirect_stdout(io.StringIO()):
        system = kinepy.System()
        crank, coupler, rocker = (system.add_solid() for _ in range(3))
        driven = system.add_revolute(system.ground, crank)
        system.add_revolute(crank, coupler, (known.length("1", "A", "B"), 0.0))
        hinge = system.add_revolute(coupler, rocker, (known.length("2", "B", "C"), 0.0))
        pivot = known.place("D")
        system.add_revolute(rocker, system.ground, (-known.length("3", "C", "D"), 0.0), (pivot.real, pivot.imag))
        system.pilot(driven)
        system.compile()
        system.change_signs([side])
    return system, hinge


def turn(system: Any, angles: np.ndarray) -> None:
    """Solve a turn; kinepy writes into the angles it is given."""
    system.solve_kinematics(angles[None].copy())
