"""Four-bars through given positions: of the coupler (按连杆给定位置), or of both side links (按两连架杆对应位置设计).

The moving hinges B and C are given at every position. A is as far from B1 as from B2 and B3: it lies on the
perpendicular bisectors; so does D for C. Three positions give one linkage, two leave A and D free on a bisector each.

Freudenstein's equation cos(phi - psi) = R1 cos psi - R2 cos phi + R3 with R1 = d/a, R2 = d/c,
R3 = (a^2 + c^2 + d^2 - b^2)/(2ac) is linear in R1, R2, R3: three pairs of angles give one linkage. Where a crank length
is given instead of the output's own direction, the method of inversion (反转法) finds C: D's frame is turned back with
the rocker, and C1 is the centre of the circle through the three places of B.
Source: 孙桓《机械原理》连杆机构设计; Freudenstein 1955.
"""

from __future__ import annotations

import cmath
from collections.abc import Sequence
from itertools import combinations

import numpy as np

from graphkin.base import geometry
from graphkin.base.geometry import Array, cross, dot, number, unit
from graphkin.base.tolerances import ROUNDED
from graphkin.construction.drafting import Bisector, Board, ChosenPoint, CircleThrough, Drafting, DraftLayOff, replay
from graphkin.construction.drafting.steps import DraftMeasure, DraftMeet, DraftTurn, MeasureAngle, Reckon, Stage, Step
from graphkin.errors import CouplerChanges, NotOnBisector, SameWanted, WrongNumber
from graphkin.studies.design.model import Design, Reason, Solution, gamma_four, one_of, passing, positive, shown

Hinges = Sequence[tuple[complex, complex]]  # B and C [m], position by position

_HINGE = {"A": "B", "D": "C"}
_COUNT = 161
_REACH = 2.5  # pivots are looked for so far from C1C2 and B1B2, in lengths of coupler and moves together
_SMALL = 0.15  # no link shorter than this part of the longest
_SINGULAR = 1e-10


def hinges(places: Sequence[complex], turns: Sequence[float], length: float) -> list[tuple[complex, complex]]:
    """B and C from B, the direction of BC [rad], and its length [m], position by position."""
    return [(at, at + cmath.rect(length, turn)) for at, turn in zip(places, turns, strict=True)]


def coupler_positions(points: Hinges, *, pivot_a: complex | None = None, pivot_d: complex | None = None) -> Design:
    """Four-bars that take hinges B, C of their coupler through positions [(B1, C1), (B2, C2), (B3, C3)] [m].

    pivot_a, pivot_d   fixed pivots A, D, for two positions only: points of the bisectors of B1B2 and C1C2. What is
           left out is chosen so that the crank turns fully, no branch changes, and the transmission angle is large.

    Raises WrongNumber, SameWanted, CouplerChanges, NotOnBisector.

    >>> design = coupler_positions(hinges([0.02j, 0.01 + 0.025j, 0.025 + 0.022j], [0.2, 0.1, -0.2], 0.05))
    >>> round(design.solutions[0].a * 1e3, 3), round(design.solutions[0].c * 1e3, 3)
    (20.425, 19.545)
    """
    _check_positions(points, pivot_a, pivot_d)
    values = {f"b{k}": abs(c - b) for k, (b, c) in enumerate(points, start=1)}
    laid = [ChosenPoint(f"{name}{k}", z) for k, pair in enumerate(points, start=1) for name, z in zip("BC", pair)]
    if len(points) == 3:
        pivots = [_centre("A", "B"), _centre("D", "C")]
    else:
        pivots = []
        for pivot, at, known in zip("AD", _free_pivots(points, pivot_a, pivot_d), (pivot_a, pivot_d)):
            hinge, say = _HINGE[pivot], "chosen" if known is None else "given"
            bisector = Bisector(f"{hinge}12", f"{hinge}1", f"{hinge}2")
            pivots.append(Stage(say, (bisector, ChosenPoint(pivot, at))))
    bars = [DraftMeasure(name, f"B{k}", f"C{k}") for k, name in enumerate(("b", "b2", "b3")[: len(points)], start=1)]
    measured = DraftMeasure("a", "A", "B1"), DraftMeasure("c", "C1", "D"), DraftMeasure("d", "A", "D")
    stages = (Stage("coupler laid", (*laid, *bars)), *pivots, Stage("coupler lengths", measured))
    construction = Drafting(values, stages)
    board = replay(construction)
    lost = [name for name in "AD" if not cmath.isfinite(geometry.place(board.at(name)))]
    if lost:
        why = (Reason("in line", (("pivot", name), ("hinge", _HINGE[name]))) for name in lost)
        return Design("coupler", values, why=tuple(why))
    return Design("coupler", values, (_solution(construction, board, len(points)),))


def _check_positions(points: Hinges, a: complex | None, d: complex | None) -> None:
    """Raises as `coupler_positions` does."""
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
        if pivot is None:
            continue
        first, second, hinge = points[0][row], points[1][row], _HINGE[letter]
        along = geometry.place(unit(second - first))
        off = number(dot(along, pivot - (first + second) / 2))
        if abs(off) > ROUNDED * abs(second - first):
            nearest = (pivot - off * along) * 1e3
            raise NotOnBisector(letter, abs(off) * 1e3, f"{hinge}1", f"{hinge}2", nearest.real, nearest.imag)


def _centre(pivot: str, hinge: str) -> Stage:
    """A pivot by two bisectors; the circle through all three places of its hinge shows that the third agrees."""
    first, second = f"{hinge}12", f"{hinge}23"
    steps: tuple[Step, ...] = (
        Bisector(first, f"{hinge}1", f"{hinge}2"), Bisector(second, f"{hinge}2", f"{hinge}3"),
        DraftMeet(pivot, first, second), CircleThrough(f"path{hinge}", (f"{hinge}1", f"{hinge}2", f"{hinge}3"), pivot),
    )  # fmt: skip
    return Stage("centre", steps)


def _free_pivots(points: Hinges, a: complex | None, d: complex | None) -> tuple[complex, complex]:
    """A and D: those given, and for one that is free the pair with the largest least transmission angle.

    Free ones are looked for on a grid along both bisectors. Crank-rockers that keep their branch come first, then
    double-cranks, then others that keep it.
    """
    (b1, c1), (b2, c2) = points
    size = abs(c1 - b1) + max(abs(b2 - b1), abs(c2 - c1))

    def bisector(first: complex, second: complex) -> Array:
        steps = np.linspace(-_REACH, _REACH, _COUNT) * size
        return np.asarray((first + second) / 2 + 1j * unit(second - first) * steps)

    along_a = np.array([a]) if a is not None else bisector(b1, b2)
    along_d = np.array([d]) if d is not None else bisector(c1, c2)
    worth = _worth(along_a[:, None], along_d[None, :], points)
    row, column = np.unravel_index(int(np.argmax(worth)), worth.shape)
    return complex(along_a[row]), complex(along_d[column])


def _worth(at: Array, pivot: Array, points: Hinges) -> Array:
    """Least transmission angle [rad] of a crank-rocker; less by 2 for a double-crank, by more for worse linkages."""
    (b1, c1), (b2, c2) = points
    a, c, d, b = np.abs(b1 - at), np.abs(c1 - pivot), np.abs(pivot - at), abs(c1 - b1)
    sides = np.asarray(cross(pivot - c1, b1 - c1)), np.asarray(cross(pivot - c2, b2 - c2))
    one_branch = sides[0] * sides[1] > 0
    shortest, longest = np.minimum(np.minimum(a, b), np.minimum(c, d)), np.maximum(np.maximum(a, b), np.maximum(c, d))
    turning = (shortest + longest < (a + b + c + d) / 2 * (1 - 1e-6)) & (np.minimum(a, d) == shortest)
    gamma = np.where(d > 0, gamma_four(a, b, c, d), 0.0)
    here = np.minimum(*(np.abs(side) / (c * b) for side in sides))
    crank = np.where(a == shortest, gamma, gamma - 2)
    worth = np.where(one_branch & turning, crank, np.where(one_branch, here - 4, here - 6))
    return np.where(shortest < _SMALL * longest, worth - 9, worth)


def angle_pairs(
    pairs: Sequence[tuple[float, float]], frame: float, *, crank: float | None = None, phi0: float = 0.0,
    psi0: float | None = None,
) -> Design:  # fmt: skip
    """Four-bars that turn AB to phi0 + phi while DC stands at psi0 + psi, for three pairs (phi, psi) [rad].

    Both angles are counted from the direction A to D, counter-clockwise; B is to the side the angle says, C likewise.
    frame   AD [m]
    crank   AB [m]: then only the differences of psi count, and psi0 follows (inversion). Else psi0 is 0 if left out.

    Raises WrongNumber, SameWanted, WantedRange, OneCondition.

    >>> import math
    >>> pairs = [(math.radians(phi), math.radians(psi)) for phi, psi in ((40, 60), (70, 75), (110, 100))]
    >>> one = angle_pairs(pairs, 0.1).solutions[0]
    >>> round(one.a * 1e3, 3), round(one.b * 1e3, 3), round(one.c * 1e3, 3)
    (42.318, 106.182, 67.69)
    """
    if len(pairs) != 3:
        raise WrongNumber(len(pairs), "3 (phi, psi)")
    positive(frame=frame, crank=crank)
    one_of({"crank": crank, "psi0": psi0})
    for i, k in combinations(range(3), 2):
        if abs(cmath.rect(1, pairs[i][0]) - cmath.rect(1, pairs[k][0])) < 1e-9:
            raise SameWanted(f"phi{i + 1}", f"phi{k + 1}")
    phis, psis = [phi0 + phi for phi, _ in pairs], [(psi0 or 0.0) + psi for _, psi in pairs]
    values = {f"phi{k + 1}": phis[k] for k in range(3)} | {f"psi{k + 1}": psis[k] for k in range(3)} | {"d": frame}
    return _freudenstein(values, phis, psis, frame) if crank is None else _inverted(values | {"a": crank})


def _freudenstein(values: dict[str, float], phis: list[float], psis: list[float], frame: float) -> Design:
    phi, psi = np.array(phis), np.array(psis)
    rows = np.stack([np.cos(psi), -np.cos(phi), np.ones(3)], axis=-1)
    if np.linalg.cond(rows) > 1 / _SINGULAR:
        return Design("angles", values, why=(Reason("no ratios"),))
    r1, r2, r3 = (float(value) for value in np.linalg.solve(rows, np.cos(phi - psi)))
    if min(abs(r1), abs(r2)) < _SINGULAR:
        return Design("angles", values, why=(Reason("endless"),))
    a, c = frame / r1, frame / r2
    if a * a + c * c + frame * frame - 2 * a * c * r3 <= 0:
        return Design("angles", values, why=(Reason("no coupler"),))
    values |= {"R1": r1, "R2": r2, "R3": r3}
    turned = tuple(Reason("turned", (("link", link), ("mm", x * 1e3))) for link, x in (("AB", a), ("DC", c)) if x < 0)
    laid: list[Step] = []  # b is the same at every position
    for k in (1, 2, 3):
        laid += [DraftLayOff(f"B{k}", "A", "a", "", f"phi{k}"), DraftLayOff(f"C{k}", "D", "c", "", f"psi{k}")]
        laid.append(DraftMeasure(f"b{k}", f"B{k}", f"C{k}"))
    stages = (
        Stage("ratios", (Reckon("a", "over", ("d", "R1")), Reckon("c", "over", ("d", "R2")))), _frame_laid(),
        Stage("angles laid", tuple(laid)), Stage("angles coupler", (DraftMeasure("b", "B1", "C1"),)),
    )  # fmt: skip
    construction = Drafting(values, stages)
    return Design("angles", values, (_solution(construction, replay(construction), 3, turned),))


def _frame_laid() -> Stage:
    return Stage("frame laid", (ChosenPoint("A", 0j), DraftLayOff("D", "A", "d")))


def _inverted(values: dict[str, float]) -> Design:
    laid = tuple(DraftLayOff(f"B{k}", "A", "a", "", f"phi{k}") for k in (1, 2, 3))
    back: list[Step] = []
    measured: list[Step] = [
        DraftMeasure("b", "B1", "C1"), DraftMeasure("c", "C1", "D"), MeasureAngle("psi01", "D", "", "C1")
    ]  # fmt: skip
    for k in (2, 3):
        back += [Reckon(f"psi1{k}", "difference", ("psi1", f"psi{k}")), DraftTurn(f"B{k}'", f"B{k}", "D", f"psi1{k}")]
        measured += [Reckon(f"psi{k}1", "difference", (f"psi{k}", "psi1")), DraftTurn(f"C{k}", "C1", "D", f"psi{k}1")]
    centre: tuple[Step, ...] = (
        Bisector("B12", "B1", "B2'"), Bisector("B23", "B2'", "B3'"), DraftMeet("C1", "B12", "B23"),
        CircleThrough("pathB", ("B1", "B2'", "B3'"), "C1"),
    )  # fmt: skip
    stages = (
        _frame_laid(), Stage("crank laid", laid), Stage("turned back", tuple(back)),
        Stage("inverted centre", centre), Stage("inverted lengths", tuple(measured)),
    )  # fmt: skip
    construction = Drafting(values, stages)
    board = replay(construction)
    if not cmath.isfinite(geometry.place(board.at("C1"))):
        return Design("angles", values, why=(Reason("inverted in line"),))
    return Design("angles", values, (_solution(construction, board, 3),))


def _solution(construction: Drafting, board: Board, count: int, turned: tuple[Reason, ...] = ()) -> Solution:
    """The linkage on a board, judged by `count` positions; turned: links that are laid off backwards."""
    at = {name: geometry.place(place) for name, place in board.places.items()}
    positions = tuple({"A": at["A"], "B": at[f"B{k}"], "C": at[f"C{k}"], "D": at["D"]} for k in range(1, count + 1))
    whole, against, notes = passing(positions)
    why = (*turned, *against)
    a, b, c, d = (abs(number(board.numbers[name])) for name in "abcd")
    return Solution(
        "four-bar", construction, shown(positions, whole), positions, a, b, c, d, None, not why, why, notes,
        None if whole is None else whole.gamma_min, swing=None if whole is None else whole.swing,
        theta=None if whole is None else whole.theta, k=None if whole is None else whole.k,
    )  # fmt: skip
