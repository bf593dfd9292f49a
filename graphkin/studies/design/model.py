"""A design: what was wanted, the linkages that have it, those that only seem to, and the family they belong to.

Lengths are those of the field: crank a, coupler (rod) b, rocker c, frame d, offset e. SI and radians.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, Literal

import numpy as np

from graphkin.base.value import frozen
from graphkin.construction.drafting import Board, Drafting, replay

Kind = Literal["rocker", "slider", "guide-bar", "coupler", "angles"]
Shape = Literal["four-bar", "slider-crank", "guide-bar"]


@frozen
class Reason:
    """Why a linkage is none, or what else is to be said of it: a key of the sentences, and the numbers in it."""

    key: str
    data: tuple[tuple[str, float | str], ...] = ()


@frozen
class Solution:
    """A linkage that was found.

    a, b, c, d, e   crank, coupler, rocker, frame, offset [m]; None for a length the kind does not have
    places          A, B, C, D at a position fit to be drawn, as the construction has them [m]
    limits          the construction's positions of (A, B, C, D): two limits, or the wanted positions
    valid           it has what was wanted, and moves through it; why: what is against it; notes: what else to know
    gamma_min       least transmission angle over all that the crank reaches [rad]
    swing, stroke, theta, k   what it has, where it is a quick-return design [rad, m]
    pace            which way the crank turns during the slow stroke from the first limit: 1 counter-clockwise
    turn            direction of the guide (slider) or of the bar (guide bar) at `places` [rad]
    """

    shape: Shape
    construction: Drafting
    places: Mapping[str, complex]
    limits: tuple[Mapping[str, complex], ...]
    a: float
    b: float | None = None
    c: float | None = None
    d: float | None = None
    e: float | None = None
    valid: bool = True
    why: tuple[Reason, ...] = ()
    notes: tuple[Reason, ...] = ()
    gamma_min: float | None = None
    swing: float | None = None
    stroke: float | None = None
    theta: float | None = None
    k: float | None = None
    pace: float | None = None
    turn: float = 0.0

    def board(self) -> Board:
        """The construction, carried out."""
        return replay(self.construction)


@frozen
class CentreArc:
    """A part of a circle of crank centres: from one direction of its centre to another [rad], and what it is worth.

    name   "admissible", "FG" (the limits lie on different branches), "minor" (the crank positions would differ by
           180 deg - theta)
    """

    start: float
    end: float
    name: str


@frozen
class Family:
    """All linkages with the wanted K: crank centres A on one circle through C1, C2.

    side        1: A on the rocker's side of C1C2 (below the slider's line), -1 beyond it
    centre, radius   of the circle [m]
    arcs        its parts in order
    angle       directions of A from the centre [rad] (n,), on the admissible arcs; `at`: A [m] (n,)
    a, b, d, e, gamma_min   along it (n,); d of a four-bar, e of a slider-crank, else None
    best        direction of A with the largest gamma_min, and that gamma_min [rad]; NaN where no arc is admissible
    """

    side: float
    centre: complex
    radius: float
    arcs: tuple[CentreArc, ...]
    angle: Any
    at: Any
    a: Any
    b: Any
    d: Any
    e: Any
    gamma_min: Any
    best: tuple[float, float]


@frozen
class Design:
    """What was asked for and what was found.

    given      the wanted values by name [m, rad]
    solutions  linkages that meet them; those that miss the way from one position to the next are not `valid`
    rejected   points of the construction that look like solutions and are none, with the reason
    families   where a condition was left free, or to show what is possible
    why        why there is no solution, and what to change
    """

    kind: Kind
    given: Mapping[str, float]
    solutions: tuple[Solution, ...] = ()
    rejected: tuple[Solution, ...] = ()
    families: tuple[Family, ...] = ()
    why: tuple[Reason, ...] = ()

    @property
    def best(self) -> Solution | None:
        """The solution to draw: a valid one before others, then the one with the largest least transmission angle."""
        found = sorted(self.solutions, key=lambda one: (not one.valid, -(one.gamma_min or 0.0)))
        return found[0] if found else None


# --- transmission angles, scalars or arrays -----------------------------------------------------------


def folded_least(*cosines: Any) -> Any:
    """The least of angles, each folded to 0..90 deg, from their cosines."""
    greatest = np.max(np.abs(np.stack(np.broadcast_arrays(*cosines))), axis=0)
    return np.arccos(np.minimum(greatest, 1.0))[()]


def gamma_four(a: Any, b: Any, c: Any, d: Any) -> Any:
    """Least transmission angle of a crank-rocker over a turn: with the crank in line with the frame."""
    with np.errstate(divide="ignore", invalid="ignore"):
        inner = (b * b + c * c - (d - a) ** 2) / (2 * b * c)
        outer = (b * b + c * c - (d + a) ** 2) / (2 * b * c)
    return folded_least(inner, outer)


def gamma_slider(a: Any, b: Any, e: Any) -> Any:
    """Least transmission angle of a slider-crank over a turn: with the crank at right angles to the guide, far side."""
    with np.errstate(divide="ignore", invalid="ignore"):
        return math.pi / 2 - np.arcsin(np.minimum((a + np.abs(e)) / b, 1.0))[()]
