"""A four-bar whose coupler takes two or three given positions (按连杆给定位置设计四杆机构).

The moving hinges B and C are given at every position. A is as far from B1 as from B2 and B3: it lies on the
perpendicular bisectors; so does D for C. Three positions give one linkage, two leave A and D free on a bisector each.
Source: 孙桓《机械原理》连杆机构设计.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from itertools import combinations

from graphkin.base.geometry import dot, unit
from graphkin.base.tolerances import ROUNDED
from graphkin.construction.drafting import (
    Bisector,
    Board,
    ChosenPoint,
    CircleThrough,
    Drafting,
    DraftMeasure,
    DraftMeet,
    Stage,
    Step,
    replay,
)
from graphkin.errors import CouplerChanges, NotOnBisector, SameWanted, WrongNumber
from graphkin.studies.design.free import chosen
from graphkin.studies.design.model import Design, Reason, Solution
from graphkin.studies.design.passing import passing, shown


def hinges(places: Sequence[complex], turns: Sequence[float], length: float) -> list[tuple[complex, complex]]:
    """B and C from B, the direction of BC [rad], and its length [m], position by position."""
    return [(at, at + cmath.rect(length, turn)) for at, turn in zip(places, turns, strict=True)]


def coupler_positions(
    points: Sequence[tuple[complex, complex]], *, pivot_a: complex | None = None,
    pivot_d: complex | None = None,
) -> Design:  # fmt: skip
    """Four-bars that take hinges B, C of their coupler through positions [(B1, C1), (B2, C2), (B3, C3)] [m].

    pivot_a, pivot_d   fixed pivots A, D, for two positions only: points of the bisectors of B1B2 and C1C2. What is
           left out is chosen so that the crank turns fully, no branch changes, and the transmission angle is large.

    Raises WrongNumber, SameWanted, CouplerChanges, NotOnBisector.

    >>> found = coupler_positions(hinges([0.02j, 0.01 + 0.025j, 0.025 + 0.022j], [0.2, 0.1, -0.2], 0.05)).solutions[0]
    >>> round(found.a * 1e3, 3), round(found.c * 1e3, 3)
    (20.425, 19.545)
    """
    _asked(points, pivot_a, pivot_d)
    given = {f"b{k}": abs(c - b) for k, (b, c) in enumerate(points, start=1)}
    if len(points) == 3:
        construction = Drafting(given, _by_three(points))
    else:
        a, d = chosen(points, pivot_a, pivot_d)
        free = tuple(name for name, pivot in (("A", pivot_a), ("D", pivot_d)) if pivot is None)
        construction = Drafting(given, _by_two(points, a, d, free))
    board = replay(construction)
    lost = tuple(name for name in "AD" if not math.isfinite(abs(board.at(name))))
    if lost:
        why = (Reason("in line", (("pivot", name), ("hinge", _HINGE[name]))) for name in lost)
        return Design("coupler", given, why=tuple(why))
    return Design("coupler", given, (_solution(construction, board, len(points)),))


_HINGE = {"A": "B", "D": "C"}


def _asked(points: Sequence[tuple[complex, complex]], a: complex | None, d: complex | None) -> None:
    if len(points) not in (2, 3) or (len(points) == 3 and (a, d) != (None, None)):
        raise WrongNumber(len(points), "2 (B, C)" if (a, d) != (None, None) else "2, 3 (B, C)")
    lengths = [abs(c - b) for b, c in points]
    for k, length in enumerate(lengths[1:], start=2):
        if abs(length - lengths[0]) > ROUNDED * lengths[0] or lengths[0] == 0:
            raise CouplerChanges("B1C1", lengths[0] * 1e3, f"B{k}C{k}", length * 1e3)
    for letter, row in (("B", 0), ("C", 1)):
        for i, k in combinations(range(len(points)), 2):
            if abs(points[i][row] - points[k][row]) < 1e-9 * lengths[0]:
                raise SameWanted(f"{letter}{i + 1}", f"{letter}{k + 1}")
    for letter, pivot, row in (("A", a, 0), ("D", d, 1)):
        if pivot is not None:
            _on_bisector(letter, pivot, points[0][row], points[1][row])


def _on_bisector(name: str, pivot: complex, first: complex, second: complex) -> None:
    along = unit(second - first)
    off = float(dot(along, pivot - (first + second) / 2))
    if abs(off) > ROUNDED * abs(second - first):
        nearest = (pivot - off * along) * 1e3
        hinge = _HINGE[name]
        raise NotOnBisector(name, abs(off) * 1e3, f"{hinge}1", f"{hinge}2", float(nearest.real), float(nearest.imag))


def _laid(points: Sequence[tuple[complex, complex]]) -> Stage:
    found = [ChosenPoint(f"{name}{k}", z) for k, pair in enumerate(points, start=1) for name, z in zip("BC", pair)]
    return Stage("coupler laid", tuple(found))


def _by_three(points: Sequence[tuple[complex, complex]]) -> tuple[Stage, ...]:
    """Both centres by two bisectors each; the circle through all three shows that the third agrees."""
    return (_laid(points), _centre("A", "B"), _centre("D", "C"), _lengths())


def _centre(pivot: str, hinge: str) -> Stage:
    first, second = f"{hinge}12", f"{hinge}23"
    steps: tuple[Step, ...] = (
        Bisector(first, f"{hinge}1", f"{hinge}2"), Bisector(second, f"{hinge}2", f"{hinge}3"),
        DraftMeet(pivot, first, second), CircleThrough(f"path{hinge}", (f"{hinge}1", f"{hinge}2", f"{hinge}3"), pivot),
    )  # fmt: skip
    return Stage(f"centre {pivot}", steps)


def _by_two(
    points: Sequence[tuple[complex, complex]], a: complex, d: complex, free: tuple[str, ...]
) -> tuple[Stage, ...]:
    stages = [_laid(points)]
    for pivot, hinge, at in (("A", "B", a), ("D", "C", d)):
        say = f"{pivot} chosen" if pivot in free else f"{pivot} given"
        stages.append(Stage(say, (Bisector(f"{hinge}12", f"{hinge}1", f"{hinge}2"), ChosenPoint(pivot, at))))
    return (*stages, _lengths())


def _lengths() -> Stage:
    measured = (
        DraftMeasure("a", "A", "B1"), DraftMeasure("b", "B1", "C1"),
        DraftMeasure("c", "C1", "D"), DraftMeasure("d", "A", "D"),
    )  # fmt: skip
    return Stage("coupler lengths", measured)


def _solution(construction: Drafting, board: Board, count: int) -> Solution:
    at = board.places
    positions = tuple(
        {"A": at["A"], "B": at[f"B{k}"], "C": at[f"C{k}"], "D": at["D"]} for k in range(1, count + 1)
    )  # fmt: skip
    judged = passing(positions)
    a, b, c, d = (board.numbers[name] for name in "abcd")
    found = judged.found
    return Solution(
        "four-bar", construction, shown(positions, found), positions, a, b, c, d, None, not judged.why, judged.why,
        judged.notes, None if found is None else found.gamma_min, swing=None if found is None else found.swing,
        theta=None if found is None else found.theta, k=None if found is None else found.k,
    )  # fmt: skip

