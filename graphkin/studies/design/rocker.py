"""A crank-rocker from the rocker's length, its swing and K (按行程速比系数设计曲柄摇杆机构).

C1 and C2 are the rocker's limits about D. The crank's centre A sees C1C2 under theta, so it lies on the circle through
C1, C2 and P, where C2P is at right angles to C1C2 and the angle C2C1P is 90 deg - theta. AC1 = b - a, AC2 = b + a.
A second circle lies beyond C1C2; its crank-rockers have their slow stroke the other way round.
Source: 孙桓《机械原理》连杆机构设计; example 2.3 of the notes on planar linkages.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from graphkin.base.geometry import cross
from graphkin.construction.drafting import (
    ChosenPoint,
    Drafting,
    DraftLayOff,
    DraftMeasure,
    Reckon,
    Stage,
    Step,
    replay,
    theta_of,
)
from graphkin.studies.design.arcs import Chord, family, named
from graphkin.studies.design.asked import angle_within, one_of, positive, ratio_within
from graphkin.studies.design.finding import on_circle, ranged
from graphkin.studies.design.judging import quick_four
from graphkin.studies.design.model import Design, Solution, gamma_four


def rocker(
    length: float, swing: float, k: float, *, frame: float | None = None, crank: float | None = None,
    coupler: float | None = None, gamma_min: float | None = None, ac1: float | None = None,
) -> Design:  # fmt: skip
    """Crank-rockers whose rocker has a length [m], swings through an angle [rad], and returns k times as fast.

    One condition more picks them from the family: length of frame, crank or coupler, the distance AC1 [m], or the
    least transmission angle [rad]. With none, the one with the largest least transmission angle is taken.

    Raises WantedRange, OneCondition.

    >>> found = rocker(0.080, math.radians(40), 1.3, frame=0.071).best
    >>> round(found.a * 1e3, 3), round(found.b * 1e3, 3)
    (20.773, 89.96)
    """
    conditions = {"frame": frame, "crank": crank, "coupler": coupler, "gamma_min": gamma_min, "ac1": ac1}
    positive(length=length, frame=frame, crank=crank, coupler=coupler, ac1=ac1)
    angle_within("swing", swing, math.pi)
    angle_within("gamma_min", gamma_min, math.pi / 2)
    ratio_within(k)
    name = one_of(conditions)
    given = {"c": length, "psi": swing, "K": k} | ({name: conditions[name] or 0.0} if name else {})
    chord = _chord(length, swing, k)
    families = family(chord, 1.0), family(chord, -1.0)
    found = [
        _solution(chord, given, side, steps)
        for side, steps in on_circle(chord, families, name, gamma_wanted=gamma_min)
    ]
    solutions = tuple(one for one in found if one is not None and one.valid)
    rejected = tuple(one for one in found if one is not None and not one.valid)
    return Design("rocker", given, solutions, rejected, families, () if solutions else ranged(name, families, chord))


def _chord(length: float, swing: float, k: float) -> Chord:
    """The rocker's limits, about D at the origin, upright."""
    first, second = (length * np.exp(1j * (math.pi / 2 + sign * swing / 2)) for sign in (1, -1))

    def lengths(at: Any) -> tuple[Any, Any, Any, Any]:
        near, far = np.abs(at - first), np.abs(at - second)
        return np.abs(far - near) / 2, (far + near) / 2, np.abs(at), None

    def gamma(at: Any) -> Any:
        a, b, d, _ = lengths(at)
        return gamma_four(a, b, length, d)

    def parted(at: Any) -> Any:
        return cross(at, first) * cross(at, second) <= 0

    corners = (complex(first), complex(-first)), (complex(second), complex(-second))
    return Chord(complex(first), complex(second), theta_of(k), corners, parted, lengths, gamma)


def _first_stages() -> tuple[Stage, ...]:
    limits = (
        ChosenPoint("D", 0j), Reckon("upright", "above", ("psi",)), DraftLayOff("C1", "D", "c", "", "upright"),
        DraftLayOff("C2", "D", "c", "C1", "psi", -1.0),
    )  # fmt: skip
    return Stage("theta", (Reckon("theta", "theta", ("K",)),)), Stage("rocker limits", limits)


def _solution(chord: Chord, given: dict[str, float], side: float, steps: tuple[Stage, ...]) -> Solution | None:
    """Carry the construction out and judge what it gives; None where the lines do not meet."""
    measured: tuple[Step, ...] = (
        DraftMeasure("AC1", "A", "C1"), DraftMeasure("AC2", "A", "C2"), Reckon("a", "half difference", ("AC2", "AC1")),
        Reckon("b", "half sum", ("AC2", "AC1")), DraftMeasure("d", "A", "D"),
    )  # fmt: skip
    construction = Drafting(given, (*_first_stages(), *steps, Stage("rocker lengths", measured)))
    board = replay(construction)
    at = board.at("A")
    if not math.isfinite(abs(at)):
        return None
    return quick_four(construction, board, named(chord, side, at))

