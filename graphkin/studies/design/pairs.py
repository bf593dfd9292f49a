"""A four-bar that matches three pairs of input and output angles (按两连架杆对应位置设计四杆机构).

Freudenstein's equation cos(phi - psi) = R1 cos psi - R2 cos phi + R3 with R1 = d/a, R2 = d/c,
R3 = (a^2 + c^2 + d^2 - b^2)/(2ac) is linear in R1, R2, R3: three pairs give one linkage. Where a crank length is given
instead of the output's own direction, the method of inversion (反转法) finds C: D's frame is turned back with the
rocker, and C1 is the centre of the circle through the three places of B.
Source: Freudenstein 1955; 孙桓《机械原理》连杆机构设计.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from itertools import combinations

import numpy as np

from graphkin.construction.drafting import (
    Bisector,
    Board,
    ChosenPoint,
    CircleThrough,
    Drafting,
    DraftLayOff,
    DraftMeasure,
    DraftMeet,
    DraftTurn,
    MeasureAngle,
    Reckon,
    Stage,
    Step,
    replay,
)
from graphkin.errors import SameWanted, WantedRange, WrongNumber
from graphkin.studies.design.asked import positive
from graphkin.studies.design.model import Design, Reason, Solution
from graphkin.studies.design.passing import passing, shown

_SINGULAR = 1e-10


def angle_pairs(
    pairs: Sequence[tuple[float, float]], frame: float, *, crank: float | None = None, phi0: float = 0.0,
    psi0: float | None = None,
) -> Design:  # fmt: skip
    """Four-bars that turn AB to phi0 + phi while DC stands at psi0 + psi, for three pairs (phi, psi) [rad].

    Both angles are counted from the direction A to D, counter-clockwise; B is to the side the angle says, C likewise.
    frame   AD [m]
    crank   AB [m]: then only the differences of psi count, and psi0 follows (inversion). Else psi0 is 0 if left out.

    Raises WrongNumber, SameWanted, WantedRange.

    >>> pairs = [(math.radians(phi), math.radians(psi)) for phi, psi in ((40, 60), (70, 75), (110, 100))]
    >>> found = angle_pairs(pairs, 0.1).solutions[0]
    >>> round(found.a * 1e3, 3), round(found.b * 1e3, 3), round(found.c * 1e3, 3)
    (42.318, 106.182, 67.69)
    """
    if len(pairs) != 3:
        raise WrongNumber(len(pairs), "3 (phi, psi)")
    positive(frame=frame, crank=crank)
    if crank is not None and psi0 is not None:
        raise WantedRange("psi0", f"{math.degrees(psi0):g}°", "-", "- (crank)")
    for i, k in combinations(range(3), 2):
        if abs(cmath.rect(1, pairs[i][0]) - cmath.rect(1, pairs[k][0])) < 1e-9:
            raise SameWanted(f"phi{i + 1}", f"phi{k + 1}")
    phis, psis = [phi0 + phi for phi, _ in pairs], [(psi0 or 0.0) + psi for _, psi in pairs]
    given = {f"phi{k + 1}": phis[k] for k in range(3)} | {f"psi{k + 1}": psis[k] for k in range(3)} | {"d": frame}
    return _freudenstein(given, phis, psis, frame) if crank is None else _inverted(given | {"a": crank})


# --- Freudenstein ------------------------------------------------------------------------------------


def _freudenstein(given: dict[str, float], phis: list[float], psis: list[float], frame: float) -> Design:
    phi, psi = np.array(phis), np.array(psis)
    rows = np.stack([np.cos(psi), -np.cos(phi), np.ones(3)], axis=-1)
    if np.linalg.cond(rows) > 1 / _SINGULAR:
        return Design("angles", given, why=(Reason("no ratios"),))
    r1, r2, r3 = (float(value) for value in np.linalg.solve(rows, np.cos(phi - psi)))
    if min(abs(r1), abs(r2)) < _SINGULAR:
        return Design("angles", given, why=(Reason("endless"),))
    a, c = frame / r1, frame / r2
    square = a * a + c * c + frame * frame - 2 * a * c * r3
    if square <= 0:
        return Design("angles", given, why=(Reason("no coupler"),))
    given |= {"R1": r1, "R2": r2, "R3": r3}
    turned = tuple(Reason("turned", (("link", link), ("mm", x * 1e3))) for link, x in (("AB", a), ("DC", c)) if x < 0)
    construction = Drafting(given, _laid_stages())
    return Design("angles", given, (_solution(construction, replay(construction), turned),))


def _laid_stages() -> tuple[Stage, ...]:
    """a and c from the ratios, laid off at their angles; b is measured, at every position the same."""
    sides: list[Step] = [ChosenPoint("A", 0j), DraftLayOff("D", "A", "d")]
    laid: list[Step] = []
    for k in (1, 2, 3):
        laid += [DraftLayOff(f"B{k}", "A", "a", "", f"phi{k}"), DraftLayOff(f"C{k}", "D", "c", "", f"psi{k}")]
        laid.append(DraftMeasure(f"b{k}", f"B{k}", f"C{k}"))
    ratios = (Reckon("a", "over", ("d", "R1")), Reckon("c", "over", ("d", "R2")))
    measured = (DraftMeasure("b", "B1", "C1"),)
    return (
        Stage("ratios", ratios), Stage("frame laid", tuple(sides)), Stage("angles laid", tuple(laid)),
        Stage("angles coupler", measured),
    )  # fmt: skip


# --- inversion ---------------------------------------------------------------------------------------


def _inverted(given: dict[str, float]) -> Design:
    sides: tuple[Step, ...] = (ChosenPoint("A", 0j), DraftLayOff("D", "A", "d"))
    laid = tuple(DraftLayOff(f"B{k}", "A", "a", "", f"phi{k}") for k in (1, 2, 3))
    back: list[Step] = []
    for k in (2, 3):
        back += [Reckon(f"psi1{k}", "difference", ("psi1", f"psi{k}")), DraftTurn(f"B{k}'", f"B{k}", "D", f"psi1{k}")]
    centre: tuple[Step, ...] = (
        Bisector("B12", "B1", "B2'"), Bisector("B23", "B2'", "B3'"), DraftMeet("C1", "B12", "B23"),
        CircleThrough("pathB", ("B1", "B2'", "B3'"), "C1"),
    )  # fmt: skip
    measured: list[Step] = [
        DraftMeasure("b", "B1", "C1"),
        DraftMeasure("c", "C1", "D"),
        MeasureAngle("psi01", "D", "", "C1"),
    ]
    for k in (2, 3):
        measured += [Reckon(f"psi{k}1", "difference", (f"psi{k}", "psi1")), DraftTurn(f"C{k}", "C1", "D", f"psi{k}1")]
    construction = Drafting(
        given,
        (
            Stage("frame laid", sides), Stage("crank laid", laid), Stage("turned back", tuple(back)),
            Stage("inverted centre", centre), Stage("inverted lengths", tuple(measured)),
        ),
    )  # fmt: skip
    board = replay(construction)
    if not math.isfinite(abs(board.at("C1"))):
        return Design("angles", given, why=(Reason("inverted in line"),))
    return Design("angles", given, (_solution(construction, board, ()),))


def _solution(construction: Drafting, board: Board, turned: tuple[Reason, ...]) -> Solution:
    at = board.places
    positions = tuple({"A": at["A"], "B": at[f"B{k}"], "C": at[f"C{k}"], "D": at["D"]} for k in (1, 2, 3))
    judged = passing(positions)
    found, why = judged.found, (*turned, *judged.why)
    a, b, c, d = (abs(board.numbers[name]) for name in "abcd")
    return Solution(
        "four-bar", construction, shown(positions, found), positions, a, b, c, d, None, not why, why, judged.notes,
        None if found is None else found.gamma_min, swing=None if found is None else found.swing,
        theta=None if found is None else found.theta, k=None if found is None else found.k,
    )  # fmt: skip
