"""pylinkage, by its two fast ways: `step_fast` (positions) and `step_fast_with_kinematics`, both compiled by numba.

A crank is turned by one step before the first position is told, so it starts one step behind.
The guide bar of the shaper is a point at a fixed distance from C on the line through C and B: the same motion.
"""

from __future__ import annotations

import cmath
import os
import warnings
from typing import Any

import numpy as np

from graphkin.planning import Method
from peers.lengths import Lengths

os.environ.setdefault("NUMBA_NUM_THREADS", "1")
with warnings.catch_warnings():
    warnings.simplefilter("ignore")
    from pylinkage.actuators import Crank
    from pylinkage.components import Ground
    from pylinkage.dyads import FixedDyad, RRPDyad, RRRDyad
    from pylinkage.simulation import Linkage

__all__ = ["BUILT", "Peer"]


def ground(place: complex, name: str) -> Any:
    return Ground(place.real, place.imag, name=name)


def crank(known: Lengths, step: float) -> tuple[Any, Any]:
    """The frame point A and the crank AB."""
    anchor = ground(known.place("A"), "A")
    radius = known.length("1", "A", "B")
    return anchor, Crank(anchor, radius, angular_velocity=step, initial_angle=known.start - step, name="B")


def rails(line: tuple[complex, complex]) -> tuple[Any, Any]:
    """Two fixed points of a guide."""
    through, along = line
    return ground(through, "rail 1"), ground(through + along, "rail 2")


def four_bar(known: Lengths, step: float, near: dict[str, complex]) -> list[Any]:
    anchor, driver = crank(known, step)
    pivot, at = ground(known.place("D"), "D"), near["C"]
    lengths = known.length("2", "B", "C"), known.length("3", "C", "D")
    hinge = RRRDyad(driver.output, pivot, *lengths, x=at.real, y=at.imag, name="C")
    coupler = known.arm("2", "B", "E") / known.arm("2", "B", "C")
    reach = known.length("2", "B", "E")
    return [anchor, pivot, driver, hinge, FixedDyad(driver.output, hinge, reach, cmath.phase(coupler), name="E")]


def slider_crank(known: Lengths, step: float, near: dict[str, complex]) -> list[Any]:
    anchor, driver = crank(known, step)
    (slide,) = known.facts.lines
    one, two, at = *rails(known.line(slide)), near["C"]
    block = RRPDyad(driver.output, one, two, known.length("2", "B", "C"), x=at.real, y=at.imag, name="C")
    return [anchor, one, two, driver, block]


def shaper(known: Lengths, step: float, near: dict[str, complex]) -> list[Any]:
    anchor, driver = crank(known, step)
    pivot, at = ground(known.place("C"), "C"), near["E"]
    one, two = rails(known.line("ram"))
    bar = FixedDyad(pivot, driver.output, known.length("3", "C", "D"), 0.0, name="D")
    ram = RRPDyad(bar, one, two, known.length("4", "D", "E"), x=at.real, y=at.imag, name="E")
    return [anchor, pivot, one, two, driver, bar, ram]


BUILT = {"ex3-5": four_bar, "p3-23a": slider_crank, "ex3-7": shaper}


class Peer:
    """A mechanism of the bench in pylinkage, for a turn of `count` positions; built, compiled and warmed once."""

    def __init__(self, name: str, method: Method, count: int, near: dict[str, complex]) -> None:
        known = Lengths(method)
        parts = BUILT[name](known, 2 * np.pi / (count - 1), near)
        self.names, self.count = [part.name for part in parts], count
        self.linkage = Linkage(parts)
        self.linkage.set_input_velocity(next(part for part in parts if part.name == "B"), known.omega)
        self.start: Any = self.linkage.get_coords()
        self.linkage.compile()
        self.linkage.step_fast(2)
        self.linkage.step_fast_with_kinematics(2)
        self.back()

    def back(self) -> None:
        """Put the linkage back to where the turn starts; not timed."""
        self.linkage.set_coords(self.start)

    def positions(self) -> np.ndarray:
        """Places of all points: (count, points, 2)."""
        found: np.ndarray = self.linkage.step_fast(self.count)
        return found

    def everything(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Places, velocities and accelerations of all points: (count, points, 2) each."""
        found: tuple[np.ndarray, np.ndarray, np.ndarray] = self.linkage.step_fast_with_kinematics(self.count)
        return found

    def of(self, point: str, found: np.ndarray) -> np.ndarray:
        """One point as complex numbers: (count,)."""
        column: np.ndarray = found[:, self.names.index(point)]
        return column[:, 0] + 1j * column[:, 1]
