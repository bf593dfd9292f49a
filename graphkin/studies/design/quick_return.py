"""Quick-return linkages from the time ratio K: crank-rocker, slider-crank, guide bar (按行程速比系数设计).

Rocker: C1 and C2 are its limits about D. The crank's centre A sees C1C2 under theta, so it lies on the circle through
C1, C2 and P, where C2P is at right angles to C1C2 and the angle C2C1P is 90 deg - theta. AC1 = b - a, AC2 = b + a.
A second circle lies beyond C1C2; its crank-rockers have their slow stroke the other way round. Slider: C1C2 is the
stroke; the linkage lies on one assembly where A is not between the lines at right angles to the guide through C1 and
C2. Guide bar: its swing is theta itself; at its limits it touches the crank's circle, and a = d sin(theta/2).

A design stands or falls with its two limits: C1 and C2 must be reached on one assembly, and the crank must turn
180 deg + theta between them.
Source: 孙桓《机械原理》连杆机构设计; example 2.3 of the notes on planar linkages.
"""

from __future__ import annotations

import cmath
import math

import numpy as np

from graphkin.base import geometry
from graphkin.base.geometry import Array, Real, Value, cross, number
from graphkin.construction.drafting import Board, ChosenPoint, Drafting, DraftLayOff, DraftMeasure, DraftMeet, replay
from graphkin.construction.drafting.pencil import theta_of
from graphkin.construction.drafting.steps import Parallel, Perpendicular, Reckon, Slanted, Stage, Step, Through
from graphkin.errors import NoQuickReturn
from graphkin.studies.design import model
from graphkin.studies.design.crank_circle import Chord, bounds, family, steps_to_centre, worth_of
from graphkin.studies.design.model import Design, Family, Kind, Reason, Solution

LOW = math.radians(40)  # a least transmission angle below this is said to be small (教材：一般 gamma_min >= 40 deg)
CHANGE = 1e-4
"""A least transmission angle this small is a change point: limits are known to half of all figures only [rad]."""
_PARTS = (0.5, 0.35, 0.65, 0.25, 0.75)
"""The parts of the slow stroke at which a position is looked for that shows the linkage well."""
_MOST_K = 719.0
"""K where the bar swings through 179.5°: no drawing tells lines apart that meet under less than half a degree."""

_THETA = Stage("theta", (Reckon("theta", "theta", ("K",)),))
_CRANK_AND_COUPLER: tuple[Step, ...] = (
    DraftMeasure("AC1", "A", "C1"), DraftMeasure("AC2", "A", "C2"), Reckon("a", "half difference", ("AC2", "AC1")),
    Reckon("b", "half sum", ("AC2", "AC1")),
)  # fmt: skip


def rocker(
    length: float, swing: float, k: float, *, frame: float | None = None, crank: float | None = None,
    coupler: float | None = None, gamma_min: float | None = None, ac1: float | None = None,
) -> Design:  # fmt: skip
    """Crank-rockers whose rocker has a length [m], swings through an angle [rad], and returns k times as fast.

    One condition more picks them from the family: length of frame, crank or coupler, the distance AC1 [m], or the
    least transmission angle [rad]. With none, the one with the largest least transmission angle is taken.

    Raises WantedRange, OneCondition.

    >>> best = rocker(0.080, math.radians(40), 1.3, frame=0.071).best
    >>> round(best.a * 1e3, 3), round(best.b * 1e3, 3)
    (20.773, 89.96)
    """
    conditions = {"frame": frame, "crank": crank, "coupler": coupler, "gamma_min": gamma_min, "ac1": ac1}
    model.positive(length=length, frame=frame, crank=crank, coupler=coupler, ac1=ac1)
    model.angle_within("swing", swing, math.pi)
    model.angle_within("gamma_min", gamma_min, math.pi / 2)
    model.ratio_within(k)
    name = model.one_of(conditions)
    values = {"c": length, "psi": swing, "K": k} | ({name: conditions[name] or 0.0} if name else {})
    chord = _rocker_chord(length, swing, k)
    limits: tuple[Step, ...] = (
        ChosenPoint("D", 0j), Reckon("upright", "above", ("psi",)), DraftLayOff("C1", "D", "c", "", "upright"),
        DraftLayOff("C2", "D", "c", "C1", "psi", -1.0),
    )  # fmt: skip
    stages = Stage("rocker limits", limits), Stage("rocker lengths", (*_CRANK_AND_COUPLER, DraftMeasure("d", "A", "D")))
    return _design("rocker", values, chord, (family(chord, 1.0), family(chord, -1.0)), name, gamma_min, stages)


def _rocker_chord(length: float, swing: float, k: float) -> Chord:
    """The rocker's limits, about D at the origin, upright."""
    first, second = (complex(length * np.exp(1j * (math.pi / 2 + sign * swing / 2))) for sign in (1, -1))

    def lengths(at: Value) -> dict[str, Real]:
        return {**_crank_and_coupler(at, first, second), "d": np.abs(at), "ac1": np.abs(at - first)}

    def gamma(at: Value) -> Real:
        of = lengths(at)
        return model.gamma_four(of["a"], of["b"], length, of["d"])

    def parted(at: Value) -> bool | Array:
        return cross(at, first) * cross(at, second) <= 0

    return Chord(first, second, theta_of(k), ((first, -first), (second, -second)), parted, lengths, gamma)


def slider(
    stroke: float, k: float, *, offset: float | None = None, crank: float | None = None, rod: float | None = None,
    gamma_min: float | None = None,
) -> Design:  # fmt: skip
    """Slider-cranks with a stroke [m] that return k times as fast.

    One condition more picks one from the family: offset (negative: the guide passes on the other side of A), length of
    crank or rod [m], or the least transmission angle [rad]. With none, the one with the largest of these is taken.

    Raises WantedRange, OneCondition; NoQuickReturn for K = 1.

    >>> best = slider(0.040, 1.2, offset=0.015).best
    >>> round(best.a * 1e3, 3), round(best.b * 1e3, 3)
    (18.891, 49.865)
    """
    conditions = {"offset": offset, "crank": crank, "rod": rod, "gamma_min": gamma_min}
    model.positive(stroke=stroke, offset=abs(offset) if offset is not None else None, crank=crank, rod=rod)
    model.angle_within("gamma_min", gamma_min, math.pi / 2)
    if k == 1:
        raise NoQuickReturn
    model.ratio_within(k)
    name = model.one_of(conditions)
    values = {"H": stroke, "K": k} | ({name: abs(conditions[name] or 0.0)} if name else {})
    chord = _slider_chord(stroke, k)
    limits = Stage("slider limits", (ChosenPoint("C1", 0j), DraftLayOff("C2", "C1", "H")))
    families = (family(chord, -1.0 if (offset or 0.0) < 0 else 1.0),)
    stages = limits, Stage("slider lengths", _CRANK_AND_COUPLER)
    return _design("slider", values, chord, families, name, gamma_min, stages)


def _slider_chord(stroke: float, k: float) -> Chord:
    """The slider's limits on a level guide, C1 at the origin."""
    first, second = 0j, complex(stroke)

    def lengths(at: Value) -> dict[str, Real]:
        return {**_crank_and_coupler(at, first, second), "e": np.abs(np.asarray(at).imag)}

    def gamma(at: Value) -> Real:
        of = lengths(at)
        return model.gamma_slider(of["a"], of["b"], of["e"])

    def parted(at: Value) -> bool | Array:
        x = np.asarray(at).real
        return (x >= 0) & (x <= stroke)

    return Chord(first, second, theta_of(k), ((first, 1j), (second, 1j)), parted, lengths, gamma)


def _crank_and_coupler(at: Value, first: complex, second: complex) -> dict[str, Real]:
    """AC1 = b - a, AC2 = b + a, or the other way round."""
    near, far = np.abs(at - first), np.abs(at - second)
    return {"a": np.abs(far - near) / 2, "b": (far + near) / 2}


def _design(
    kind: Kind, values: dict[str, float], chord: Chord, families: tuple[Family, ...], name: str,
    gamma_min: float | None, stages: tuple[Stage, Stage],
) -> Design:  # fmt: skip
    """The design of all A that the pencil gives; without a solution, with the bounds of the condition. `stages`: what
    is drawn before A and behind it."""
    limits, lengths = stages
    every = [_solution(Drafting(values, (_THETA, limits, *steps, lengths)), chord, side)
             for side, steps in steps_to_centre(chord, families, name, gamma_min)]  # fmt: skip
    valid = tuple(one for one in every if one is not None and one.valid)
    rejected = tuple(one for one in every if one is not None and not one.valid)
    return Design(kind, values, valid, rejected, families, () if valid else bounds(name, families, chord))


def angle_between(one: complex, other: complex) -> float:
    """0 to pi [rad]."""
    return abs(cmath.phase(one.conjugate() * other))


def _solution(construction: Drafting, chord: Chord, side: float) -> Solution | None:
    """Carry a construction out and judge the linkage that it gives by its limits C1 and C2; None for none."""
    board = replay(construction)
    at = geometry.place(board.at("A"))
    if not math.isfinite(abs(at)):
        return None
    judge = _crank_rocker if "D" in board.points else _slider_crank
    return judge(construction, board, worth_of(chord, side, at))


def _crank_rocker(construction: Drafting, board: Board, worth: str) -> Solution:
    at, pivot, first, second = (geometry.place(board.at(name)) for name in ("A", "D", "C1", "C2"))
    a, b, c, d = (number(board.numbers[name]) for name in "abcd")
    gamma = number(model.gamma_four(a, b, c, d))
    why = _against(worth, a, b + c + d, gamma)
    starts = _cranks(at, first, second, a)
    limits = tuple({"A": at, "B": foot, "C": end, "D": pivot} for foot, end in zip(starts, (first, second)))
    pace = 1.0 if number(cross(starts[0] - at, starts[1] - at)) < 0 else -1.0
    theta = angle_between(first - at, second - at)
    best, most = limits[0], -1.0
    if not why:  # the slow stroke, where coupler and rocker stand best to each other
        side = 1.0 if number(cross(pivot - starts[0], first - starts[0])) >= 0 else -1.0
        for part in _PARTS:
            foot = at + (starts[0] - at) * cmath.rect(1, pace * part * (math.pi + theta))
            end = geometry.place(geometry.meet_circles(foot, b, pivot, c, side)[0])
            sine = abs(math.sin(angle_between(foot - end, pivot - end)))
            if sine > most + 0.05:
                best, most = {"A": at, "B": foot, "C": end, "D": pivot}, sine
    return Solution(
        "four-bar", construction, best, limits, a, b, c, d, None, not why, why, _notes(gamma, why), gamma,
        angle_between(first - pivot, second - pivot), None, theta, (math.pi + theta) / (math.pi - theta), pace,
    )  # fmt: skip


def _slider_crank(construction: Drafting, board: Board, worth: str) -> Solution:
    at, first, second = (geometry.place(board.at(name)) for name in ("A", "C1", "C2"))
    a, b = number(board.numbers["a"]), number(board.numbers["b"])
    along = (second - first) / abs(second - first)
    e = number(cross(along, first - at))
    gamma = number(model.gamma_slider(a, b, e))
    why = _against(worth, a, b, gamma)
    starts = _cranks(at, first, second, a)
    limits = tuple({"A": at, "B": foot, "C": end} for foot, end in zip(starts, (first, second)))
    pace = 1.0 if number(cross(starts[0] - at, starts[1] - at)) < 0 else -1.0
    theta = angle_between(first - at, second - at)
    places = limits[0]
    if not why:  # the middle of the slow stroke, C on the side of A where the limits are
        b_there = at + (starts[0] - at) * cmath.rect(1, pace * (math.pi + theta) / 2)
        foot = first + along * (along.conjugate() * (b_there - first)).real
        ahead = 1.0 if (along.conjugate() * (first - at)).real >= 0 else -1.0
        c = foot + ahead * along * math.sqrt(max(0.0, b * b - abs(b_there - foot) ** 2))
        places = {"A": at, "B": b_there, "C": c}
    return Solution(
        "slider-crank", construction, places, limits, a, b, None, None, e, not why, why, _notes(gamma, why), gamma,
        None, abs(second - first), theta, (math.pi + theta) / (math.pi - theta), pace, cmath.phase(along),
    )  # fmt: skip


def _cranks(at: complex, first: complex, second: complex, a: float) -> tuple[complex, complex]:
    """B at the two limits: on the far side of A from C where the linkage is folded, else towards C."""
    sign = -1.0 if abs(first - at) <= abs(second - at) else 1.0
    return at + sign * a * (first - at) / abs(first - at), at - sign * a * (second - at) / abs(second - at)


def _against(worth: str, a: float, size: float, gamma: float) -> tuple[Reason, ...]:
    """The reasons against an A of a worth on its circle (`CentreArc.name`)."""
    keys = [worth] if worth != "admissible" else []
    keys += ["no crank"] if a <= 1e-9 * size else []
    keys += ["change point"] if worth == "admissible" and gamma < CHANGE else []
    return tuple(Reason(key) for key in keys)


def _notes(gamma: float, why: tuple[Reason, ...]) -> tuple[Reason, ...]:
    return (Reason("low gamma", (("gamma", gamma),)),) if gamma < LOW and not why else ()


def guide_bar(k: float, *, frame: float | None = None, crank: float | None = None) -> Design:
    """The oscillating guide bar that returns k times as fast; the length of the frame or of the crank is given [m].

    k may be any number above 1: the swing is theta = 180 deg (K - 1)/(K + 1). Raises WantedRange, OneCondition.

    >>> best = guide_bar(1.5, frame=0.1).best
    >>> round(best.a * 1e3, 4), round(math.degrees(best.swing), 6)
    (30.9017, 36.0)
    """
    model.positive(frame=frame, crank=crank)
    model.ratio_within(k, _MOST_K)
    name = model.one_of({"frame": frame, "crank": crank}, 1)
    values = {"K": k, name: frame or crank or 0.0}
    swing = Stage("theta swing", (Reckon("theta", "theta", ("K",)), Reckon("halved", "half", ("theta",))))
    lengths = Stage("guide lengths", (
        Perpendicular("AB1", "A", "m"), DraftMeet("B1", "AB1", "m"),
        Perpendicular("AB2", "A", "n"), DraftMeet("B2", "AB2", "n"),
        DraftMeasure("a", "A", "B1"), DraftMeasure("d", "A", "C"),
    ))  # fmt: skip
    if name == "frame":  # the bar's two limits lie to both sides of CA
        pivots = (ChosenPoint("A", 0j), DraftLayOff("C", "A", "frame"))
        sides = (Slanted("m", "C", "A", "halved", 1.0), Slanted("n", "C", "A", "halved", -1.0))
        limits = Stage("guide pivots", pivots), Stage("guide limits", sides)
    else:  # C and both limits first; A is where the crank's length fits between them
        placed: tuple[Step, ...] = (
            Reckon("straight", "straight", ()), ChosenPoint("C", 0j), Reckon("one", "same", ("crank",)),
            DraftLayOff("X", "C", "one", "", "straight"),
            Slanted("m", "C", "X", "halved", 1.0), Slanted("n", "C", "X", "halved", -1.0), Through("CX", "C", "X"),
        )  # fmt: skip
        fitted = (Parallel("beside", "m", "crank", -1.0), DraftMeet("A", "beside", "CX"))
        limits = Stage("guide limits alone", placed), Stage("guide crank fits", fitted)
    return Design("guide-bar", values, (_bar_solution(Drafting(values, (swing, *limits, lengths))),))


def _bar_solution(construction: Drafting) -> Solution:
    board = replay(construction)
    a, c, *ends = (geometry.place(board.at(name)) for name in ("A", "C", "B1", "B2"))
    crank, frame, theta = (number(board.numbers[name]) for name in ("a", "d", "theta"))
    swing = angle_between(ends[0] - c, ends[1] - c)
    outward = (a - c) / abs(a - c)
    b = a + crank * outward * complex(math.cos(math.pi / 3), math.sin(math.pi / 3))
    limits = tuple({"A": a, "B": end, "C": c} for end in ends)
    return Solution(
        "guide-bar", construction, {"A": a, "B": b, "C": c}, limits, crank, None, None, frame, 0.0,
        gamma_min=math.pi / 2, swing=swing, theta=theta, k=(math.pi + swing) / (math.pi - swing), pace=-1.0,
        turn=math.atan2((b - c).imag, (b - c).real),
    )  # fmt: skip
