"""The equations to fill in are those of the printed solution, with its rows among the right choices."""

from __future__ import annotations

import pytest

from graphkin import load, plan
from graphkin.marking.equation_choices import equation_choices
from graphkin.running import replay_all
from graphkin.say.boards import choice_words
from graphkin.say.entry import VectorEquation
from graphkin.say.explained import derivation
from graphkin.say.names import vector

SCALES = {"length": 0.001, "velocity": 0.01, "acceleration": 0.1}


@pytest.mark.parametrize(
    "name",
    ["ex3-1", "ex3-2", "ex3-4", "ex3-7", "fig2-32", "p3-15", "p3-16", "p3-19", "p3-21", "s3-cam", "s3-sieve", "s4-ex6"],
)  # fmt: skip
def test_the_printed_rows_are_right(name):
    method = plan(load(name))
    plot = replay_all(method)
    said = derivation(method, plot, SCALES, "en", everything=False)
    printed = [each for each in said if isinstance(each, VectorEquation)]
    asked = equation_choices(method, plot)
    assert [[vector(term.name) for term in one.terms] for one in asked] == [
        [row.name for row in each.arrows] for each in printed
    ]
    for one, each in zip(asked, printed, strict=True):
        for term, row in zip(one.terms, each.arrows, strict=True):
            directions, sizes = ({choice_words(token, "en") for token in row} for row in (term.directions, term.magnitudes))
            assert row.direction in directions | {"—"} or term.nothing, (term.name, row.direction)
            assert row.size in sizes, (term.name, row.size)
            wrong = len(one.directions) - len(term.directions), len(one.magnitudes) - len(term.magnitudes)
            assert min(wrong) > 3, term.name


def test_parallel_by_chance_is_wrong_and_always_parallel_is_right():
    drawn_across = load("ex3-1").with_({"driver.0.angle": 90.0})  # the crank is parallel to nothing at another angle
    (velocity, acceleration) = equation_choices(method := plan(drawn_across), replay_all(method))
    by_name = {term.name: term for one in (velocity, acceleration) for term in one.terms}
    assert by_name["v_B2"].directions == ("perpendicular AB", "parallel x", "given")  # along x now
    assert by_name["a_B2"].directions[0] == "B to A"
    assert by_name["a^n_B3D"].magnitudes[0] == "omega_3^2*l_BD"
    assert "omega_2^2*l_BD" in by_name["a^n_B3D"].magnitudes  # links 2 and 3 slide on each other and turn alike
    assert by_name["a^n_B3D"].senseless == ("D to B", "parallel BD")
