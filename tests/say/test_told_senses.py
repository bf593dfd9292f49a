"""What a solution says of senses and directions is so in its drawing: letters in order, points above lines, arrows, rates."""

from __future__ import annotations

import cmath
import math
import re
from collections import Counter

import pytest
from every_family import FAMILIES

from graphkin import Drawing
from graphkin.base.geometry import cross

POINT = r"([A-Z]\d*)"
NAMES = ("ex3-1", "ex3-2", "ex3-5", "ex3-7", "fig3-1", "p3-3a", "p3-7", "s4-ex5")


def turned(vector: complex, degrees: str, of: float = 360.0) -> float:
    """By how much an angle is off that of a vector [deg]."""
    return abs((math.degrees(cmath.phase(vector)) - float(degrees) + of / 2) % of - of / 2)


def told(drawing: Drawing) -> Counter[str]:
    """How many statements of each kind there are; each is held against places and rates."""
    at, count = {name: complex(place) for name, place in drawing.plot.position.items()}, Counter[str]()
    rates = {"rad/s": drawing.plot.omega, "rad/s²": drawing.plot.alpha}
    for line in drawing.explain("en", everything=True):
        for a, b, c, sense in re.findall(rf"{POINT}→{POINT}→{POINT} (clockwise|counter-clockwise)", line):
            if {a, b, c} <= at.keys():
                count["order"] += 1
                assert (cross(at[b] - at[a], at[c] - at[a]) > 0) == (sense == "counter-clockwise"), line
        for a, side, b, c in re.findall(rf"\({POINT} (above|below) {POINT}{POINT}\)", line):
            if {a, b, c} <= at.keys():
                count["side"] += 1
                along = (at[c] - at[b]) * math.copysign(1.0, (at[c] - at[b]).real)
                assert (cross(along, at[a] - at[b]) > 0) == (side == "above"), line
        for a, b, angle in re.findall(rf"\({POINT}→{POINT}, at ([\d.]+)° to", line):
            if {a, b} <= at.keys():
                count["along"] += 1
                assert turned(at[b] - at[a], angle) < 0.6, line
        for a, b, angle in re.findall(rf"\(⊥{POINT}{POINT} in the sense of ω\w+, at ([\d.]+)° to", line):
            if {a, b} <= at.keys():
                count["across"] += 1
                assert turned(1j * (at[b] - at[a]), angle, 180.0) < 0.6, line
        for link, unit, sense in re.findall(r"^\s+[ωα](\d+) = .* (rad/s²?) \((clockwise|counter-clockwise)", line):
            count["rate"] += 1
            assert (float(rates[unit][link]) > 0) == (sense == "counter-clockwise"), line
    return count


@pytest.mark.parametrize("name", NAMES)
def test_senses_and_directions(name: str):
    assert sum(told(Drawing.of(name)).values()) > 4


@pytest.mark.parametrize("family", ["carriage", "line_of_centres"])
def test_links_at_rest_are_told_where_poses_place_them(family: str) -> None:
    """Whether they always are is seen from other positions, to which drivers move them, not poses."""
    lines = [*Drawing.of(FAMILIES[family](8501)).explain("en", everything=True)]
    assert any("translates" in line or "no rotation" in line or "rest" in line for line in lines)
