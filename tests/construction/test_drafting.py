"""The drafting language: every kind of step, single and over many positions at once, and at infinity."""

from __future__ import annotations

import typing

import numpy as np
import pytest

from graphkin.construction.drafting import (
    Bisector,
    Board,
    CarriedAngle,
    ChosenPoint,
    CircleAbout,
    CircleThrough,
    Drafting,
    DraftLayOff,
    DraftMeasure,
    DraftMeet,
    DraftTurn,
    Far,
    MarkOn,
    MeasureAngle,
    Parallel,
    Perpendicular,
    Pricked,
    Reckon,
    Slanted,
    Stage,
    Step,
    Through,
    Traced,
    Underlay,
    replay,
)

COUNT = 7
EVERY = Stage("every kind", (
    ChosenPoint("A", 0.1 + 0.2j), DraftLayOff("B", "A", "r"), DraftLayOff("C", "A", "r", "B", "turn", -1.0), Through("AB", "A", "B"),
    Slanted("AT", "A", "B", "turn"), Perpendicular("n", "C", "AB"), Parallel("p", "AB", "r"), Bisector("m", "B", "C"),
    DraftMeet("D", "n", "p"), DraftMeet("E", "AT", "m"), CarriedAngle("AK", "A", "n", "AB", "m"), Traced("guide", "guide"),
    Far("F", "guide"), Through("BF", "B", "F"), Pricked("G", "G"), DraftMeet("H", "BF", "AK"),
    CircleThrough("round", ("A", "B", "D"), "O"), CircleAbout("about", "B", "r"), CircleAbout("again", "A", through="G"),
    DraftMeet("I", "about", "round", near="D"), DraftMeet("J", "AB", "about", far="A"), MarkOn("K", "round", 0.7),
    DraftTurn("L", "G", "O", "turn"), DraftMeasure("GL", "G", "L"), MeasureAngle("LOG", "O", "G", "L"),
    Reckon("twice", "double", ("GL",)), MeasureAngle("GBF", "B", "G", "F"), Reckon("kept", "sense", ("r", "GBF")),
    Reckon("side", "sines", ("r", "GBF", "LOG")), Reckon("kept by two", "sense of sines", ("r", "GBF", "LOG")),
))  # fmt: skip


def over(value: np.ndarray | float) -> Board:
    """The board of one value, or of many."""
    guide = np.array([0.3 * np.ones_like(value), np.cos(value), 0.1 * np.ones_like(value)])
    point = np.array([0.4 + 0.1 * np.sin(value), 0.3 * np.ones_like(value), np.ones_like(value)])
    return Board(0.05 + 0.01j, 0.2, Underlay({"G": point}, {"guide": guide}), numbers={"r": 0.3 + value / 50, "turn": value})


def test_every_kind_of_step_over_many_positions_at_once():
    assert {type(step) for step in EVERY.steps} == {*typing.get_args(Step)}
    values = np.linspace(0.4, 1.2, COUNT)
    many = replay(Drafting({}, (EVERY,)), over(values))
    for k, value in enumerate(values):
        one = replay(Drafting({}, (EVERY,)), over(float(value)))
        for point in one.points:
            assert np.isclose(np.broadcast_to(many.at(point), COUNT)[k], one.at(point), rtol=1e-12, atol=1e-12), point
        for name, number in one.numbers.items():
            assert np.broadcast_to(many.numbers[name], COUNT)[k] == pytest.approx(number, rel=1e-12), name


def test_what_the_steps_say_holds():
    board = replay(Drafting({}, (EVERY,)), over(0.9))
    at = board.places
    assert ((at["D"] - at["C"]) * (at["B"] - at["A"]).conjugate()).real == pytest.approx(0, abs=1e-12)
    assert abs(at["E"] - at["B"]) == pytest.approx(abs(at["E"] - at["C"]))
    assert abs(at["I"] - at["B"]) == pytest.approx(board.numbers["r"])
    assert abs(at["J"] - at["A"]) == pytest.approx(2 * board.numbers["r"])
    assert board.numbers["LOG"] == pytest.approx(0.9)
    assert np.isinf(at["F"])
    ray = (at["G"] - at["B"]) * np.exp(1j * board.numbers["GBF"])
    assert (ray / board.line("BF")[1]).imag == pytest.approx(0, abs=1e-12)
    assert board.numbers["kept"] == pytest.approx(np.sign(np.cos(board.numbers["GBF"])) * board.numbers["r"])
    assert 0 < board.lean["H"] <= 1


@pytest.mark.parametrize(("steps", "point"), [
    ((ChosenPoint("A", 0j), ChosenPoint("B", 1 + 0j), ChosenPoint("C", 2 + 0j), CircleThrough("c", ("A", "B", "C"), "O")), "O"),
    ((ChosenPoint("A", 0j), ChosenPoint("B", 1 + 0j), CircleAbout("a", "A", "r"), CircleAbout("b", "B", "r"), DraftMeet("O", "a", "b")), "O"),
    ((ChosenPoint("A", 0j), ChosenPoint("B", 0j), Through("AB", "A", "B"), Perpendicular("n", "A", "AB"), DraftMeet("O", "AB", "n")), "O"),
])  # fmt: skip
def test_what_does_not_meet_is_nowhere(steps: tuple[Step, ...], point: str):
    assert np.isnan(replay(Drafting({"r": 0.1}, (Stage("", steps),))).at(point))


def test_parallels_meet_at_infinity():
    steps = (
        ChosenPoint("A", 0j), ChosenPoint("B", 1 + 1j), Through("AB", "A", "B"), Parallel("p", "AB", "r"), DraftMeet("O", "AB", "p"),
        ChosenPoint("C", 3 + 0j), Through("CO", "C", "O"),
    )  # fmt: skip
    board = replay(Drafting({"r": 0.1}, (Stage("", steps),)))
    assert np.isinf(board.at("O"))
    assert board.direction("O") == pytest.approx(np.pi / 4)
    assert abs(np.sin(np.angle(board.line("CO")[1]) - np.pi / 4)) < 1e-12
