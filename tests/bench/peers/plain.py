"""A plain C loop (gcc -O3) over the three mechanisms: how far from the metal the others are."""

from __future__ import annotations

import ctypes
import subprocess
from pathlib import Path

import numpy as np

from graphkin.planning import Method
from peers.lengths import Lengths

__all__ = ["Loop", "built"]

SOURCE = Path(__file__).with_name("sweep.c")
POINTS = {"ex3-5": "BCE", "p3-23a": "BC", "ex3-7": "BDE"}
TURNS = {"ex3-5": "23", "p3-23a": "2-", "ex3-7": "34--"}
"""What follows the points in `out`, three columns each: links, - for a displacement."""


def built(folder: Path) -> ctypes.CDLL:
    """The three functions, compiled."""
    made = folder / "sweep.so"
    subprocess.run(["gcc", "-O3", "-shared", "-fPIC", "-o", str(made), str(SOURCE), "-lm"], check=True)
    return ctypes.CDLL(str(made))


class Loop:
    """One mechanism in C, for given crank angles; results lie in `out`, a row a column of the C file."""

    def __init__(self, library: ctypes.CDLL, name: str, method: Method, angles: np.ndarray, side: int) -> None:
        known = Lengths(method)
        function = SIZES[name].__name__
        self.function = getattr(library, function)
        self.function.restype = None
        self.points = POINTS[name]
        self.sizes = np.array([*SIZES[name](known), side])
        self.angles = np.ascontiguousarray(angles)
        self.rows = 6 * len(self.points) + 3 * len(TURNS[name])
        self.turns = TURNS[name]
        self.omega, self.alpha = known.omega, float(known.facts.accelerations[0])

    def run(self) -> np.ndarray:
        """All columns: (rows, n)."""
        out = np.empty((self.rows, self.angles.size))
        double = ctypes.POINTER(ctypes.c_double)
        where = (self.sizes.ctypes.data_as(double), self.angles.ctypes.data_as(double))
        rates = ctypes.c_double(self.omega), ctypes.c_double(self.alpha)
        self.function(*where, *rates, ctypes.c_long(self.angles.size), out.ctypes.data_as(double))
        return out

    def of(self, point: str, out: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Place, velocity and acceleration of a point as complex numbers."""
        first = 6 * self.points.index(point)
        place, velocity, acceleration = (out[k] + 1j * out[k + 1] for k in range(first, first + 6, 2))
        return place, velocity, acceleration

    @property
    def links(self) -> str:
        """The links whose rates it gives."""
        return self.turns.replace("-", "")

    def rates(self, link: str, out: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Angular velocity and acceleration of a link [rad/s, rad/s^2]."""
        first = 6 * len(self.points) + 3 * self.turns.index(link)
        return out[first + 1], out[first + 2]


def xy(*vectors: complex) -> list[float]:
    return [part for vector in vectors for part in (vector.real, vector.imag)]


def four_bar(known: Lengths) -> list[float]:
    coupler = known.arm("2", "B", "E") / known.arm("2", "B", "C") * known.length("2", "B", "C")
    lengths = [known.length("1", "A", "B"), known.length("2", "B", "C"), known.length("3", "D", "C")]
    return [*xy(known.place("A"), known.place("D")), *lengths, *xy(coupler)]


def slider_crank(known: Lengths) -> list[float]:
    (slide,) = known.facts.lines
    lengths = [known.length("1", "A", "B"), known.length("2", "B", "C")]
    return [*xy(known.place("A"), *known.line(slide)), *lengths]


def shaper(known: Lengths) -> list[float]:
    lengths = [known.length("1", "A", "B"), known.length("3", "C", "D"), known.length("4", "D", "E")]
    return [*xy(known.place("A"), known.place("C"), *known.line("ram")), *lengths]


SIZES = {"ex3-5": four_bar, "p3-23a": slider_crank, "ex3-7": shaper}
