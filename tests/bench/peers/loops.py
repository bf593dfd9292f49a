"""mechanism: vector loops written by the user, solved by fsolve position by position; reported only."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np

from graphkin.planning import Method
from peers.lengths import Lengths

with warnings.catch_warnings():
    warnings.simplefilter("ignore")
    from mechanism import Joint, Mechanism, Vector

__all__ = ["four_bar"]


def four_bar(method: Method, count: int, near: tuple[float, float]) -> tuple[Any, Any]:
    """The four-bar over a turn, not yet solved, and its joint C; `near`: angles of BC and DC at the start [rad]."""
    known = Lengths(method)
    a, b, c, d = (Joint(name) for name in "ABCD")
    crank = Vector((a, b), r=known.length("1", "A", "B"))
    coupler = Vector((b, c), r=known.length("2", "B", "C"))
    frame = Vector((a, d), r=known.place("D").real, theta=0)
    rocker = Vector((d, c), r=known.length("3", "D", "C"))

    def loop(x: np.ndarray, given: float) -> np.ndarray:
        found: np.ndarray = crank(given) + coupler(x[0]) - frame() - rocker(x[1])
        return found

    turn = known.start + np.linspace(0, 2 * np.pi, count)
    rates = np.full(count, known.omega), np.zeros(count)
    guesses = np.array(near), np.ones(2), np.ones(2)
    solved = Mechanism((crank, coupler, frame, rocker), a, loop, turn, *rates, guesses)
    return solved, c
