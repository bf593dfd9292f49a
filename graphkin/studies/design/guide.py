"""An oscillating guide bar from K (按行程速比系数设计摆动导杆机构): its swing is theta itself.

At its limits the bar touches the crank's circle: AB is at right angles to it, and a = d sin(theta/2).
Source: 孙桓《机械原理》连杆机构设计.
"""

from __future__ import annotations

import math

from graphkin.construction.drafting import (
    ChosenPoint,
    Drafting,
    DraftLayOff,
    DraftMeasure,
    DraftMeet,
    Parallel,
    Perpendicular,
    Reckon,
    Slanted,
    Stage,
    Step,
    Through,
    replay,
)
from graphkin.studies.design.asked import one_of, positive, ratio_within
from graphkin.studies.design.judging import angle_between
from graphkin.studies.design.model import Design, Solution

_MOST_K = 719.0
"""K where the bar swings through 179.5°: no drawing tells lines apart that meet under less than half a degree."""


def guide_bar(k: float, *, frame: float | None = None, crank: float | None = None) -> Design:
    """The oscillating guide bar that returns k times as fast; the length of the frame or of the crank is given [m].

    k may be any number above 1: the swing is theta = 180 deg (K - 1)/(K + 1). Raises WantedRange, OneCondition.

    >>> found = guide_bar(1.5, frame=0.1).best
    >>> round(found.a * 1e3, 4), round(math.degrees(found.swing), 6)
    (30.9017, 36.0)
    """
    positive(frame=frame, crank=crank)
    ratio_within(k, _MOST_K)
    name = one_of({"frame": frame, "crank": crank}, 1)
    given = {"K": k, name: frame or crank or 0.0}
    construction = Drafting(given, (*_first_stages(), *(_by_frame() if name == "frame" else _by_crank())))
    return Design("guide-bar", given, (_solution(construction),))


def _first_stages() -> tuple[Stage, ...]:
    return (Stage("theta swing", (Reckon("theta", "theta", ("K",)), Reckon("halved", "half", ("theta",)))),)


def _sides() -> tuple[Step, ...]:
    """The bar's two limits, to both sides of CA."""
    return (Slanted("m", "C", "A", "halved", 1.0), Slanted("n", "C", "A", "halved", -1.0))


def _feet() -> tuple[Step, ...]:
    return (
        Perpendicular("AB1", "A", "m"), DraftMeet("B1", "AB1", "m"),
        Perpendicular("AB2", "A", "n"), DraftMeet("B2", "AB2", "n"),
        DraftMeasure("a", "A", "B1"), DraftMeasure("d", "A", "C"),
    )  # fmt: skip


def _by_frame() -> tuple[Stage, ...]:
    laid = (ChosenPoint("A", 0j), DraftLayOff("C", "A", "frame"))
    return Stage("guide pivots", laid), Stage("guide limits", _sides()), Stage("guide lengths", _feet())


def _by_crank() -> tuple[Stage, ...]:
    """C and both limits first; A is where the crank's length fits between them."""
    fixed: tuple[Step, ...] = (
        ChosenPoint("C", 0j), Reckon("one", "same", ("crank",)), DraftLayOff("X", "C", "one", "", "straight"),
        Slanted("m", "C", "X", "halved", 1.0), Slanted("n", "C", "X", "halved", -1.0), Through("CX", "C", "X"),
    )  # fmt: skip
    fitted = (Parallel("beside", "m", "crank", -1.0), DraftMeet("A", "beside", "CX"))
    straight = Stage("guide limits alone", (Reckon("straight", "straight", ()), *fixed))
    return straight, Stage("guide crank fits", fitted), Stage("guide lengths", _feet())


def _solution(construction: Drafting) -> Solution:
    board = replay(construction)
    a, c = board.at("A"), board.at("C")
    ends = board.at("B1"), board.at("B2")
    swing = angle_between(ends[0] - c, ends[1] - c)
    outward = (a - c) / abs(a - c)
    crank = board.numbers["a"]
    b = a + crank * outward * complex(math.cos(math.pi / 3), math.sin(math.pi / 3))
    turn = b - c
    limits = tuple({"A": a, "B": end, "C": c} for end in ends)
    return Solution(
        "guide-bar", construction, {"A": a, "B": b, "C": c}, limits, crank, None, None, board.numbers["d"], 0.0,
        gamma_min=math.pi / 2, swing=swing, theta=board.numbers["theta"],
        k=(math.pi + swing) / (math.pi - swing), pace=-1.0, turn=math.atan2(turn.imag, turn.real),
    )  # fmt: skip
