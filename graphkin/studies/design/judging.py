"""Whether a linkage that was constructed has what was wanted: read off the finished board.

A quick-return design stands or falls with its two limits: C1 and C2 must be reached on one assembly, and the crank must
turn 180 deg + theta between them.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

from graphkin.base.geometry import cross, meet_circles
from graphkin.construction.drafting import Board, Drafting
from graphkin.studies.design.model import Reason, Solution, gamma_four, gamma_slider

LOW = math.radians(40)
"""A least transmission angle below this is said to be small (教材：一般 gamma_min >= 40 deg)."""
CHANGE = 1e-4
"""A least transmission angle this small is a change point: limits are known to half of all figures only [rad]."""
_PARTS = (0.5, 0.35, 0.65, 0.25, 0.75)
"""Where in the slow stroke a position is looked for that shows the linkage well."""


def angle_between(one: complex, other: complex) -> float:
    """0 to pi [rad]."""
    return abs(cmath.phase(one.conjugate() * other))


def quick_four(construction: Drafting, board: Board, worth: str) -> Solution:
    """A crank-rocker whose limits are C1 and C2. worth: of A's place on the circle (`Arc.name`)."""
    at, pivot = board.at("A"), board.at("D")
    first, second = board.at("C1"), board.at("C2")
    a, b, c, d = (board.numbers[name] for name in "abcd")
    gamma = float(gamma_four(a, b, c, d))
    why = tuple(_against(worth, a, b + c + d, gamma))
    starts = cranks(at, first, second, a)
    limits = tuple({"A": at, "B": foot, "C": end, "D": pivot} for foot, end in zip(starts, (first, second)))
    pace, theta = _slow(at, *starts, first, second)
    side = 1.0 if cross(pivot - starts[0], first - starts[0]) >= 0 else -1.0
    places = _shown(at, pivot, starts[0], pace, theta, (b, c), side) if not why else dict(limits[0])
    return Solution(
        "four-bar", construction, places, limits, a, b, c, d, None, not why, why, _notes(gamma, why), gamma,
        angle_between(first - pivot, second - pivot), None, theta, (math.pi + theta) / (math.pi - theta), pace,
    )  # fmt: skip


def quick_slider(construction: Drafting, board: Board, worth: str) -> Solution:
    """A slider-crank whose slider's limits are C1 and C2."""
    at, first, second = (board.at(name) for name in ("A", "C1", "C2"))
    a, b = board.numbers["a"], board.numbers["b"]
    way = (second - first) / abs(second - first)
    e = float(cross(way, first - at))
    gamma = float(gamma_slider(a, b, e))
    why = tuple(_against(worth, a, b, gamma))
    starts = cranks(at, first, second, a)
    limits = tuple({"A": at, "B": foot, "C": end} for foot, end in zip(starts, (first, second)))
    pace, theta = _slow(at, *starts, first, second)
    turned = starts[0] - at
    foot = at + turned * cmath.rect(1, pace * (math.pi + theta) / 2)
    places = {"A": at, "B": foot, "C": _on_guide(foot, b, first, way, at)} if not why else dict(limits[0])
    return Solution(
        "slider-crank", construction, places, limits, a, b, None, None, e, not why, why, _notes(gamma, why), gamma,
        None, abs(second - first), theta, (math.pi + theta) / (math.pi - theta), pace, cmath.phase(way),
    )  # fmt: skip


def _on_guide(b: complex, rod: float, first: complex, way: complex, at: complex) -> complex:
    """C on the guide, on the side of A where the limits are."""
    foot = first + way * (way.conjugate() * (b - first)).real
    ahead = 1.0 if (way.conjugate() * (first - at)).real >= 0 else -1.0
    return foot + ahead * way * math.sqrt(max(0.0, rod * rod - abs(b - foot) ** 2))


def cranks(at: complex, first: complex, second: complex, a: float) -> tuple[complex, complex]:
    """B at the two limits: on the far side of A from C where the linkage is folded, else towards C."""
    near = abs(first - at) <= abs(second - at)
    ends = []
    for end, sign in ((first, -1.0 if near else 1.0), (second, 1.0 if near else -1.0)):
        ends.append(at + sign * a * (end - at) / abs(end - at))
    return ends[0], ends[1]


def _slow(at: complex, b1: complex, b2: complex, first: complex, second: complex) -> tuple[float, float]:
    """Which way the crank goes from limit 1 to 2 through more than 180 deg, and theta, seen from A."""
    pace = 1.0 if cross(b1 - at, b2 - at) < 0 else -1.0
    return pace, angle_between(first - at, second - at)


def _against(worth: str, a: float, size: float, gamma: float) -> Iterator[Reason]:
    if worth != "admissible":
        yield Reason(worth)
    if a <= 1e-9 * size:
        yield Reason("no crank")
    if worth == "admissible" and gamma < CHANGE:
        yield Reason("change point")


def _notes(gamma: float, why: tuple[Reason, ...]) -> tuple[Reason, ...]:
    return (Reason("low gamma", (("gamma", gamma),)),) if gamma < LOW and not why else ()


def _shown(
    at: complex, pivot: complex, start: complex, pace: float, theta: float, bars: tuple[float, float], side: float
) -> dict[str, complex]:
    """The linkage in its slow stroke, where coupler and rocker stand best to each other."""
    best: dict[str, complex] = {}
    most = -1.0
    for part in _PARTS:
        b = at + (start - at) * cmath.rect(1, pace * part * (math.pi + theta))
        c = complex(meet_circles(b, bars[0], pivot, bars[1], side)[0])
        sine = abs(math.sin(angle_between(b - c, pivot - c)))
        if sine > most + 0.05:
            best, most = {"A": at, "B": b, "C": c, "D": pivot}, sine
    return best
