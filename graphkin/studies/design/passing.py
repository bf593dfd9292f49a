"""Whether a four-bar moves from one wanted position to the next: assembly, circuit, dead points, order.

A driven crank takes the linkage from one position to another where both have one assembly (C on the same side of BD)
and the crank's way between them lies within what it reaches: then BC and CD are never in line on the way.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise

from graphkin.base.geometry import cross, meet_circles
from graphkin.base.value import frozen
from graphkin.errors import GraphkinError
from graphkin.studies.design.model import Reason
from graphkin.studies.linkages import FourBar, Report, report

_LINE = 1e-7
"""Sine of an angle that counts as none."""
_EDGE = 1e-7
"""So far beyond its range an angle is still at its end [rad]."""
_CLEAR = 0.1
"""A position whose coupler and rocker cross at a smaller sine is not drawn: it is nearly a dead point."""

Positions = Sequence[Mapping[str, complex]]


@frozen
class Passing:
    """What becomes of the wanted positions. found: the linkage's report, None where it cannot move at all."""

    found: Report | None
    why: tuple[Reason, ...]
    notes: tuple[Reason, ...]


def passing(positions: Positions) -> Passing:
    """Judge a four-bar by its wanted positions (A, B, C, D each), driven at AB."""
    try:
        bars = [_bar(places) for places in positions]
        found = report(bars[0])
    except GraphkinError:
        return Passing(None, (Reason("no links"),), ())
    why = tuple(_against(positions, found))
    notes = [Reason("kind", (("kind", found.kind), ("family", found.family)))]
    notes += [] if found.grashof else [Reason("no Grashof")]
    if not found.driver_range.full:
        notes.append(Reason("crank rocks"))
    if not why:
        notes.append(_passed(positions, found))
    else:
        turned = [{"A": p["D"], "B": p["C"], "C": p["B"], "D": p["A"]} for p in positions]
        notes += [] if list(_against(turned, report(_bar(turned[0])))) else [Reason("drive at CD")]
    return Passing(found, why, tuple(notes))


def _bar(places: Mapping[str, complex]) -> FourBar:
    a, b, c, d = (places[name] for name in "ABCD")
    return FourBar(abs(b - a), abs(c - b), abs(d - c), abs(d - a), places=(a, b, c, d))


def _against(positions: Positions, found: Report) -> Iterator[Reason]:
    """What is in the way, with the crank AB as driver."""
    sides = [_side(places) for places in positions]
    for number, side in enumerate(sides, start=1):
        if side == 0:
            yield Reason("dead there", (("position", number),))
    for number, (one, other) in enumerate(pairwise(sides), start=1):
        if one * other < 0:
            yield Reason("branch", (("first", number), ("second", number + 1)))
    if found.driver_range.full or any(a * b <= 0 for a, b in pairwise(sides)):
        return
    low, high = found.driver_range.low, found.driver_range.high
    turned = [low - _EDGE + (cmath.phase(p["B"] - p["A"]) - low + _EDGE) % math.tau for p in positions]
    for number, value in enumerate(turned, start=1):
        if value > high + _EDGE:
            yield Reason("circuit", (("position", number),))
            return
    ways = [other - one for one, other in pairwise(turned)]
    if min(ways) < 0 < max(ways):
        yield Reason("order")


def _passed(positions: Positions, found: Report) -> Reason:
    """All positions lie on one branch, and the crank comes to them in order, turning in one sense."""
    angles = [cmath.phase(places["B"] - places["A"]) for places in positions]
    if found.driver_range.full:
        left = sum((other - one) % math.tau for one, other in pairwise(angles)) < math.tau
    else:
        low = found.driver_range.low - _EDGE
        turned = [(angle - low) % math.tau for angle in angles]
        left = turned[-1] > turned[0]
    return Reason("passed ccw" if left else "passed cw")


def _side(places: Mapping[str, complex]) -> float:
    """1 where C lies to the left of B -> D, -1 to the right, 0 where coupler and rocker are in line."""
    b, c, d = (places[name] for name in "BCD")
    sine = cross(b - c, d - c) / (abs(d - c) * abs(b - c))
    return 0.0 if abs(sine) < _LINE else math.copysign(1.0, sine)


def shown(positions: Positions, found: Report | None) -> Mapping[str, complex]:
    """A position fit to be drawn: the wanted one farthest from a dead point, or a better one that the crank reaches."""
    best = max(positions, key=_clear)
    if found is None or _clear(best) > _CLEAR:
        return best
    at, b, c, d = (best[name] for name in "ABCD")
    low, high, side = found.driver_range.low, found.driver_range.high, _side(best) or 1.0
    others = [dict(best)]
    for part in range(1, 36):
        foot = at + cmath.rect(abs(b - at), low + (high - low) * part / 36)
        others.append(dict(best) | {"B": foot, "C": complex(meet_circles(foot, abs(c - b), d, abs(c - d), side)[0])})
    return max((one for one in others if cmath.isfinite(one["C"])), key=_clear)


def _clear(places: Mapping[str, complex]) -> float:
    """Sine of the angle between coupler and rocker."""
    b, c, d = (places[name] for name in "BCD")
    return abs(float(cross(b - c, d - c))) / (abs(b - c) * abs(d - c))
