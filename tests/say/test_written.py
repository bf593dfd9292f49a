"""Mechanisms written from the page of the file alone, held against what one works out by hand."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import graphkin
from graphkin.results import results

WRITTEN = Path(__file__).parents[1] / "cases" / "written"
SIXTH = math.radians(30)
EXPECTED = {
    "scotch-yoke": {"v C": -0.05 * 10 * math.sin(SIXTH), "a C": -0.05 * 100 * math.cos(SIXTH)},
    "flat-face": {"v C": -0.02 * 95 * math.tau / 60 * math.sin(SIXTH)},
    "elliptic-trammel": {"v B": -0.2 * 60 / 80},
    "oldham-coupling": {"omega 3": 10.0},
    "driven-ring": {"omega 4": 100 * math.tau / 60 * 70 / 100, "omega 1 / omega 4": 100 / 70},
    "wheel-on-the-ground": {},
}


@pytest.mark.parametrize("name", EXPECTED)
def test_a_written_mechanism(name: str) -> None:
    mechanism = graphkin.load(WRITTEN / f"{name}.toml")
    (position,) = results(mechanism, graphkin.plan(mechanism))["positions"]
    for question, value in EXPECTED[name].items():
        answer = position["ask"][question]
        parts = answer.get("vector", [answer["value"]])
        assert max(parts, key=abs) == pytest.approx(value, rel=1e-12)
    if name == "wheel-on-the-ground":
        along = position["ask"]["v C"]["vector"][0]
        assert position["ask"]["omega 3"]["value"] == pytest.approx(-along / 0.025, rel=1e-12)


def test_all_that_is_written_is_tried() -> None:
    assert {file.stem for file in WRITTEN.glob("*.toml")} == set(EXPECTED)
