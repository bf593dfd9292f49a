"""An offset slider-crank from stroke and K (按行程速比系数设计曲柄滑块机构).

C1C2 is the stroke; A sees it under theta, so it lies on the circle through C1, C2 and P, as for a rocker. The linkage
lies on one assembly where A is not between the lines at right angles to the guide through C1 and C2.
Source: 孙桓《机械原理》连杆机构设计.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

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
from graphkin.studies.design.judging import quick_slider
from graphkin.studies.design.model import Design, Solution, gamma_slider


def slider(
    stroke: float, k: float, *, offset: float | None = None, crank: float | None = None, rod: float | None = None,
    gamma_min: float | None = None,
) -> Design:  # fmt: skip
    """Slider-cranks with a stroke [m] that return k times as fast.

    One condition more picks one from the family: offset (negative: the guide passes on the other side of A), length of
    crank or rod [m], or the least transmission angle [rad]. With none, the one with the largest of these is taken.

    Raises WantedRange, OneCondition.

    >>> found = slider(0.040, 1.2, offset=0.015).best
    >>> round(found.a * 1e3, 3), round(found.b * 1e3, 3)
    (18.891, 49.865)
    """
    conditions = {"offset": offset, "crank": crank, "rod": rod, "gamma_min": gamma_min}
    size = abs(offset) if offset is not None else None
    positive(stroke=stroke, offset=size, crank=crank, rod=rod)
    angle_within("gamma_min", gamma_min, math.pi / 2)
    ratio_within(k)
    name = one_of(conditions)
    side = -1.0 if (offset or 0.0) < 0 else 1.0
    given = {"H": stroke, "K": k} | ({name: abs(conditions[name] or 0.0)} if name else {})
    chord = _chord(stroke, k)
    families = (family(chord, side),)
    found = [
        _solution(chord, given, where, steps)
        for where, steps in on_circle(chord, families, name, gamma_wanted=gamma_min)
    ]
    solutions = tuple(one for one in found if one is not None and one.valid)
    rejected = tuple(one for one in found if one is not None and not one.valid)
    return Design("slider", given, solutions, rejected, families, () if solutions else ranged(name, families, chord))


def _chord(stroke: float, k: float) -> Chord:
    """The slider's limits on a level guide, C1 at the origin."""
    first, second = 0j, complex(stroke)

    def lengths(at: Any) -> tuple[Any, Any, Any, Any]:
        near, far = np.abs(at - first), np.abs(at - second)
        return np.abs(far - near) / 2, (far + near) / 2, None, np.abs(np.imag(at))

    def gamma(at: Any) -> Any:
        a, b, _, e = lengths(at)
        return gamma_slider(a, b, e)

    def parted(at: Any) -> Any:
        return (np.real(at) >= 0) & (np.real(at) <= stroke)

    return Chord(first, second, theta_of(k), ((first, 1j), (second, 1j)), parted, lengths, gamma)


def _solution(chord: Chord, given: dict[str, float], side: float, steps: tuple[Stage, ...]) -> Solution | None:
    start: tuple[Step, ...] = (ChosenPoint("C1", 0j), DraftLayOff("C2", "C1", "H"))
    measured: tuple[Step, ...] = (
        DraftMeasure("AC1", "A", "C1"), DraftMeasure("AC2", "A", "C2"), Reckon("a", "half difference", ("AC2", "AC1")),
        Reckon("b", "half sum", ("AC2", "AC1")),
    )  # fmt: skip
    head = Stage("theta", (Reckon("theta", "theta", ("K",)),)), Stage("slider limits", start)
    construction = Drafting(given, (*head, *steps, Stage("slider lengths", measured)))
    board = replay(construction)
    at = board.at("A")
    if not math.isfinite(abs(at)):
        return None
    return quick_slider(construction, board, named(chord, side, at))
