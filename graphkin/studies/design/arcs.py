"""The circle of crank centres: every A on it sees C1C2 under theta, and so gives the wanted K.

Two circles pass through C1 and C2 for one theta, mirrored in the line C1C2. Of each, only the arc that sees C1C2 under
theta itself serves, and of that not the part between F and G, where C1 and C2 would be reached on different
assemblies: the lines C1D and C2D cut it off for a rocker (at right angles to the guide for a slider).
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable
from itertools import pairwise
from typing import Any

import numpy as np

from graphkin.base.value import frozen
from graphkin.studies.design.model import CentreArc, Family

_COUNT = 721
"""Directions looked at on an arc."""
_HALVINGS = 80


@frozen
class Chord:
    """C1, C2 and what makes an A good: `parted(A)` is whether C1 and C2 lie on different assemblies.

    theta   the angle under which A sees C1C2 [rad]
    lengths a, b, d, e of the linkage with its crank centre at A, arrays alike; gamma: its least transmission angle
    """

    first: complex
    second: complex
    theta: float
    corners: tuple[tuple[complex, complex], ...]
    parted: Callable[[Any], Any]
    lengths: Callable[[Any], tuple[Any, Any, Any, Any]]
    gamma: Callable[[Any], Any]

    def circle(self, side: float) -> tuple[complex, float]:
        """Centre and radius; side 1: to the right of the way from C1 to C2."""
        half = (self.second - self.first) / 2
        return self.first + half - 1j * side * half / math.tan(self.theta), abs(half) / math.sin(self.theta)


def family(chord: Chord, side: float) -> Family:
    """Everything on one circle."""
    centre, radius = chord.circle(side)
    arcs = tuple(_arcs(chord, side))
    good = [arc for arc in arcs if arc.name == "admissible"]
    angle = np.concatenate([_inside(arc) for arc in good]) if good else np.zeros(0)
    at = centre + radius * np.exp(1j * angle)
    a, b, d, e = chord.lengths(at)

    def least(turn: Any) -> Any:
        return chord.gamma(centre + radius * np.exp(1j * turn))

    tops = [highest(least, arc) for arc in good if _left(chord, arc)]
    best = max(tops, key=lambda found: found[1], default=(math.nan, math.nan))
    return Family(side, centre, radius, arcs, angle, at, a, b, d, e, chord.gamma(at), best)


def _left(chord: Chord, arc: CentreArc) -> bool:
    """Whether A is nearer to C1 than to C2 there; the other half mirrors it."""
    middle = cmath.rect(1, (arc.start + arc.end) / 2)
    return ((chord.second - chord.first).conjugate() * middle).real < 0


def _inside(arc: CentreArc) -> Any:
    """Directions inside an arc, denser towards its ends."""
    part = (1 - np.cos(np.linspace(0, math.pi, _COUNT + 2)[1:-1])) / 2
    return arc.start + (arc.end - arc.start) * part


def _arcs(chord: Chord, side: float) -> list[CentreArc]:
    """The circle from C2 all around, cut at C1, C2, F and G. The axis of C1C2 passes between F and G."""
    centre, radius = chord.circle(side)
    cuts = [chord.first, chord.second, *_corners(chord, centre, radius)]
    start = cmath.phase(chord.second - centre)
    turns = sorted({round((cmath.phase(cut - centre) - start) % math.tau, 15) % math.tau for cut in cuts})
    found: list[CentreArc] = []
    for low, high in pairwise([*turns, math.tau]):
        if high - low > 1e-9:
            name = named(chord, side, centre + cmath.rect(radius, start + (low + high) / 2))
            found.append(CentreArc(start + low, start + high, name))
    return found


def _corners(chord: Chord, centre: complex, radius: float) -> list[complex]:
    """F and G: where the lines through C1 and C2 that part the assemblies meet the circle again."""
    return [at + along * 2 * ((centre - at) * along.conjugate()).real / abs(along) ** 2 for at, along in chord.corners]


def named(chord: Chord, side: float, at: complex) -> str:
    """What a point of the circle is worth."""
    way = chord.second - chord.first
    right = -side * (way.conjugate() * (at - chord.first)).imag > 0
    if not right:
        return "minor"
    return "FG" if chord.parted(at) else "admissible"


def highest(size: Callable[[Any], Any], arc: CentreArc) -> tuple[float, float]:
    """Where on an arc a function is largest, and that value: looked for in steps, then narrowed by golden section."""
    turns = [arc.start, *_inside(arc).tolist(), arc.end]
    k = 1 + int(np.argmax(size(np.array(turns[1:-1]))))
    low, high, part = turns[k - 1], turns[k + 1], (math.sqrt(5) - 1) / 2
    for _ in range(_HALVINGS):
        left, right = high - part * (high - low), low + part * (high - low)
        low, high = (low, right) if size(left) > size(right) else (left, high)
    middle = (low + high) / 2
    return middle, float(size(middle))


def roots(size: Callable[[Any], Any], arc: CentreArc) -> list[float]:
    """Where on an arc a function is 0: between steps of different sign, halved until nothing is left."""
    peak, _ = highest(size, arc)
    turns = sorted([*_inside(arc).tolist(), peak])
    values = size(np.array(turns)).tolist()
    return [_halved(size, one, other) for (one, u), (other, w) in pairwise(zip(turns, values)) if (u < 0) != (w < 0)]


def _halved(size: Callable[[Any], Any], low: float, high: float) -> float:
    below = bool(size(low) < 0)
    while low < (middle := (low + high) / 2) < high or high < middle < low:
        low, high = (middle, high) if bool(size(middle) < 0) == below else (low, middle)
    return (low + high) / 2


def found_at(chord: Chord, families: tuple[Family, ...], wanted: Callable[[Any], Any]) -> list[tuple[Family, float]]:
    """Where on the admissible arcs, left half, something of A becomes 0: the circle and the direction of A."""
    found: list[tuple[Family, float]] = []
    for one in families:
        for arc in one.arcs:
            if arc.name == "admissible" and _left(chord, arc):
                def size(turn: Any, one: Family = one) -> Any:
                    return wanted(one.centre + one.radius * np.exp(1j * turn))

                found += [(one, turn) for turn in roots(size, arc)]
    return found
