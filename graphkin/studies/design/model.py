"""A design: the conditions, the linkages that meet them, those that only seem to, and the family they belong to.

Lengths are those of the field: crank a, coupler (rod) b, rocker c, frame d, offset e. SI and radians.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Literal

import numpy as np

from graphkin.base.geometry import Array, Real, cross, meet_circles, number, place
from graphkin.base.value import bulky, frozen
from graphkin.construction.drafting import Board, Drafting, replay
from graphkin.errors import GraphkinError, OneCondition, WantedRange
from graphkin.studies.linkages import FourBar, GuideBar, Linkage, Report, SliderCrank, report

Kind = Literal["rocker", "slider", "guide-bar", "coupler", "angles"]
Shape = Literal["four-bar", "slider-crank", "guide-bar"]


@frozen
class Reason:
    """A reason against a linkage, or a remark on it: a key of the sentences, and the numbers in it."""

    key: str
    data: tuple[tuple[str, float | str], ...] = ()


@bulky
class Solution:
    """A linkage that a construction gives.

    a, b, c, d, e   crank, coupler, rocker, frame, offset [m]; None for a length the kind does not have
    places          A, B, C, D at a position fit to be drawn, as the construction has them [m]
    limits          the construction's positions of (A, B, C, D): two limits, or the given positions
    valid           it meets the conditions, and moves through all positions; why: reasons against it; notes: remarks
    gamma_min       least transmission angle over all that the crank reaches [rad]
    swing, stroke, theta, k   of a quick-return design [rad, m]
    pace            sense of the crank during the slow stroke from the first limit: 1 counter-clockwise
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

    @property
    def way(self) -> float:
        """The sense in which the crank is to be turned: through the slow stroke, or the given positions in their order;
        1 counter-clockwise."""
        return self.pace or (-1.0 if any(note.key == "passed cw" for note in self.notes) else 1.0)

    def board(self) -> Board:
        """The construction, carried out."""
        return replay(self.construction)


@frozen
class CentreArc:
    """A part of a circle of crank centres: from one direction of its centre to another [rad], and its worth by name.

    name   "admissible", "FG" (the limits lie on different branches), "minor" (the crank positions would differ by
           180 deg - theta)
    """

    start: float
    end: float
    name: str


@frozen
class Family:
    """All linkages with the given K: crank centres A on one circle through C1, C2.

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
    angle: Array
    at: Array
    a: Array
    b: Array
    d: Array | None
    e: Array | None
    gamma_min: Array
    best: tuple[float, float]


@bulky
class Design:
    """The conditions of a design and the linkages that meet them.

    given      the conditions by name [m, rad]
    solutions  linkages that meet them; those that cannot move from one position to the next are not `valid`
    rejected   points of the construction that look like solutions and are none, with the reason
    families   where a condition was left free, or to show the possible ones
    why        reasons why there is no solution, and what to change
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
        return min(self.solutions, key=lambda one: (not one.valid, -(one.gamma_min or 0.0)), default=None)


def gamma_four(a: Real, b: Real, c: Real, d: Real) -> Real:
    """Least transmission angle of a crank-rocker over a turn: with the crank in line with the frame [rad]."""
    with np.errstate(divide="ignore", invalid="ignore"):
        inner = (b * b + c * c - (d - a) ** 2) / (2 * b * c)
        outer = (b * b + c * c - (d + a) ** 2) / (2 * b * c)
    return np.arccos(np.minimum(np.maximum(np.abs(inner), np.abs(outer)), 1.0))[()]


def gamma_slider(a: Real, b: Real, e: Real) -> Real:
    """Least transmission angle of a slider-crank over a turn: with the crank at right angles to the guide [rad]."""
    with np.errstate(divide="ignore", invalid="ignore"):
        return math.pi / 2 - np.arcsin(np.minimum((a + np.abs(e)) / b, 1.0))[()]


def positive(**lengths: float | None) -> None:
    """Raises WantedRange for a length that is not positive [m]."""
    for name, value in lengths.items():
        if value is not None and not (math.isfinite(value) and value > 0):
            raise WantedRange(name, f"{value * 1e3:.6g} mm", "0 mm", "∞")


def angle_within(name: str, value: float | None, high: float) -> None:
    """Raises WantedRange for an angle not between 0 and `high` [rad]."""
    if value is not None and not 0 < value < high:
        raise WantedRange(name, f"{math.degrees(value):.6g}°", "0°", f"{math.degrees(high):g}°")


def ratio_within(k: float, high: float = 3.0) -> None:
    """Raises WantedRange for a time ratio outside 1 < K < high: at 1 there is no quick return, at 3 theta is 90 deg."""
    if not 1 < k < high:
        raise WantedRange("K", f"{k:g}", "1", f"{high:g}")


def one_of(conditions: Mapping[str, float | None], least: int = 0) -> str:
    """The one condition that has a value, "" where none has. Raises OneCondition for more, or fewer than `least`."""
    names = [name for name, value in conditions.items() if value is not None]
    if not least <= len(names) <= 1:
        raise OneCondition(", ".join(names), ", ".join(conditions), "1" if least else "≤ 1")
    return names[0] if names else ""


# --- a four-bar judged by the positions it is to pass -----------------------------------------------------------------

_LINE = 1e-7  # sine of an angle that counts as none
_EDGE = 1e-7  # so far beyond its range an angle is still at its end [rad]
_CLEAR = 0.1  # a position whose coupler and rocker cross at a smaller sine is not drawn: it is nearly a dead point

Positions = Sequence[Mapping[str, complex]]


def linkage_of(solution: Solution) -> Linkage:
    """The linkage of a solution, as it stands in the construction.

    Raises OnlyStretched, CannotClose for lengths that cannot move (only for what is not valid).
    """
    at = solution.places
    if solution.shape == "four-bar":
        lengths = (solution.a, solution.b or 0.0, solution.c or 0.0, solution.d or 0.0)
        return FourBar(*lengths, places=tuple(at[name] for name in "ABCD"))
    places = tuple(at[name] for name in "ABC")
    if solution.shape == "slider-crank":
        return SliderCrank(solution.a, solution.b or 0.0, solution.e or 0.0, places=places, way=solution.turn)
    return GuideBar(solution.a, solution.d or 0.0, solution.e or 0.0, places=places, turn=solution.turn)


def passing(positions: Positions) -> tuple[Report | None, tuple[Reason, ...], tuple[Reason, ...]]:
    """Judge a four-bar by its given positions (A, B, C, D each), driven at AB: its report, None where it cannot move at
    all, reasons against it, and remarks.

    A driven crank takes the linkage from one position to another where both have one assembly (C on the same side of
    BD) and the crank's arc between them lies within its range: then BC and CD are never in line between them.
    """
    try:
        bars = [_bar(places) for places in positions]
        whole = report(bars[0])
    except GraphkinError:
        return None, (Reason("no links"),), ()
    why = tuple(_against(positions, whole))
    notes = [Reason("kind", (("kind", whole.kind), ("family", whole.family)))]
    notes += [] if whole.grashof else [Reason("no Grashof")]
    if not whole.driver_range.full:
        notes.append(Reason("crank rocks"))
    if not why:  # all positions lie on one branch, and the crank comes to them in order, turning in one sense
        angles = [cmath.phase(places["B"] - places["A"]) for places in positions]
        if whole.driver_range.full:
            left = sum((other - one) % math.tau for one, other in pairwise(angles)) < math.tau
        else:
            low = whole.driver_range.low - _EDGE
            left = (angles[-1] - low) % math.tau > (angles[0] - low) % math.tau
        notes.append(Reason("passed ccw" if left else "passed cw"))
    else:
        swapped = [{"A": p["D"], "B": p["C"], "C": p["B"], "D": p["A"]} for p in positions]
        notes += [] if list(_against(swapped, report(_bar(swapped[0])))) else [Reason("drive at CD")]
    return whole, why, tuple(notes)


def _bar(places: Mapping[str, complex]) -> FourBar:
    a, b, c, d = (places[name] for name in "ABCD")
    return FourBar(abs(b - a), abs(c - b), abs(d - c), abs(d - a), places=(a, b, c, d))


def _against(positions: Positions, whole: Report) -> Iterator[Reason]:
    """The reasons why the crank AB cannot drive it through all positions."""
    sides = [_side(places) for places in positions]
    for count, side in enumerate(sides, start=1):
        if side == 0:
            yield Reason("dead there", (("position", count),))
    for count, (one, other) in enumerate(pairwise(sides), start=1):
        if one * other < 0:
            yield Reason("branch", (("first", count), ("second", count + 1)))
    if whole.driver_range.full or any(a * b <= 0 for a, b in pairwise(sides)):
        return
    low, high = whole.driver_range.low, whole.driver_range.high
    angles = [low - _EDGE + (cmath.phase(p["B"] - p["A"]) - low + _EDGE) % math.tau for p in positions]
    for count, angle in enumerate(angles, start=1):
        if angle > high + _EDGE:
            yield Reason("circuit", (("position", count),))
            return
    steps = [other - one for one, other in pairwise(angles)]
    if min(steps) < 0 < max(steps):
        yield Reason("order")


def _side(places: Mapping[str, complex]) -> float:
    """1 where C lies to the left of B -> D, -1 to the right, 0 where coupler and rocker are in line."""
    sine = _sine(places)
    return 0.0 if abs(sine) < _LINE else math.copysign(1.0, sine)


def shown(positions: Positions, whole: Report | None) -> Mapping[str, complex]:
    """A position fit to be drawn: the given one farthest from a dead point, or a better one that the crank reaches."""
    best = max(positions, key=lambda places: abs(_sine(places)))
    if whole is None or abs(_sine(best)) > _CLEAR:
        return best
    at, b, c, d = (best[name] for name in "ABCD")
    low, high, side = whole.driver_range.low, whole.driver_range.high, _side(best) or 1.0
    others = [dict(best)]
    for part in range(1, 36):
        foot = at + cmath.rect(abs(b - at), low + (high - low) * part / 36)
        others.append(dict(best) | {"B": foot, "C": place(meet_circles(foot, abs(c - b), d, abs(c - d), side)[0])})
    return max((one for one in others if cmath.isfinite(one["C"])), key=lambda places: abs(_sine(places)))


def _sine(places: Mapping[str, complex]) -> float:
    """Sine of the angle between coupler and rocker."""
    b, c, d = (places[name] for name in "BCD")
    return number(cross(b - c, d - c)) / (abs(d - c) * abs(b - c))
