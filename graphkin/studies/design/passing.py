"""A solution handed to the other road; a four-bar from one position to the next: assembly, circuit, dead points, order.

A driven crank takes the linkage from one position to another where both have one assembly (C on the same side of BD)
and the crank's arc between them lies within its range: then BC and CD are never in line between them.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise

from graphkin.base.geometry import cross, meet_circles, number, place
from graphkin.base.value import frozen
from graphkin.errors import GraphkinError
from graphkin.studies.design.model import Reason, Solution
from graphkin.studies.linkages import FourBar, GuideBar, Linkage, Report, SliderCrank, report

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


def proof(solution: Solution) -> Report:
    """The report by lengths alone: swing, stroke, theta, K, transmission angle in closed form, without the drawing."""
    return report(linkage_of(solution))


@frozen
class Passing:
    """A four-bar judged by its positions. report: of the linkage, None where it cannot move at all."""

    report: Report | None
    why: tuple[Reason, ...]
    notes: tuple[Reason, ...]


def passing(positions: Positions) -> Passing:
    """Judge a four-bar by its given positions (A, B, C, D each), driven at AB."""
    try:
        bars = [_bar(places) for places in positions]
        whole = report(bars[0])
    except GraphkinError:
        return Passing(None, (Reason("no links"),), ())
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
    return Passing(whole, why, tuple(notes))


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
    b, c, d = (places[name] for name in "BCD")
    sine = number(cross(b - c, d - c)) / (abs(d - c) * abs(b - c))
    return 0.0 if abs(sine) < _LINE else math.copysign(1.0, sine)


def shown(positions: Positions, whole: Report | None) -> Mapping[str, complex]:
    """A position fit to be drawn: the given one farthest from a dead point, or a better one that the crank reaches."""
    best = max(positions, key=_clear)
    if whole is None or _clear(best) > _CLEAR:
        return best
    at, b, c, d = (best[name] for name in "ABCD")
    low, high, side = whole.driver_range.low, whole.driver_range.high, _side(best) or 1.0
    others = [dict(best)]
    for part in range(1, 36):
        foot = at + cmath.rect(abs(b - at), low + (high - low) * part / 36)
        others.append(dict(best) | {"B": foot, "C": place(meet_circles(foot, abs(c - b), d, abs(c - d), side)[0])})
    return max((one for one in others if cmath.isfinite(one["C"])), key=_clear)


def _clear(places: Mapping[str, complex]) -> float:
    """Sine of the angle between coupler and rocker."""
    b, c, d = (places[name] for name in "BCD")
    return abs(number(cross(b - c, d - c))) / (abs(b - c) * abs(d - c))
