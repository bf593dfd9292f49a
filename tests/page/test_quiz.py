"""The page's questions: right answers by the analysis, wrong ones by the mistakes that are named for them."""

from __future__ import annotations

import math

import pytest

from graphkin import api
from graphkin.analytic import motion
from graphkin.errors import NOWHERE
from graphkin.marking import rewrites, rewritten
from graphkin.model.quantities import EDGE, named
from graphkin.page.quiz import TOLERANCE_DEG, quiz
from graphkin.running import replay_all

NAMES = ("ex3-1", "ex3-7", "ex3-2", "fig3-4", "p3-21", "scotch-yoke", "s3-sieve", "p3-17")


def apart(one: float, other: float, turn: float) -> float:
    return abs((one - other + turn / 2) % turn - turn / 2)


@pytest.fixture(scope="module")
def asked():
    made = {}

    def of(name: str):
        if name not in made:
            method = api.plan(api.load(name))
            made[name] = method, quiz(method, replay_all(method), {"length": 1e-3, "velocity": 0.01, "acceleration": 0.1})
        return made[name]

    return of


@pytest.mark.parametrize("name", NAMES)
def test_right_answers_are_those_of_the_analysis(name, asked):
    method, data = asked(name)
    moved, plot = motion(method.mechanism), replay_all(method)
    kinds = set()
    for question in data["questions"]:
        kinds.add(question["kind"])
        if question["kind"] == "value":
            answer = named(method.mechanism, question["quantity"], NOWHERE).answer(moved)
            value = answer.value if answer.vector is None else abs(answer.vector)
            shown = float(value) * EDGE[question["dimension"]].factor
            assert math.isclose(abs(shown), abs(question["right"]), rel_tol=1e-5, abs_tol=1e-9), question["quantity"]
        else:
            turn = 180.0 if question["kind"] == "line" else 360.0
            points = plot.points(question["plane"])
            angles = [math.degrees(math.atan2(v.imag, v.real)) for t, h in _arrows(method, question["plane"])
                      if (v := complex(points[h] - points[t])) and question["point"] in (t, h)]  # fmt: skip
            assert any(apart(angle, question["right"], turn) < 0.01 for angle in angles), question
    assert "value" in kinds


def _arrows(method, plane):
    construction = method.velocity if plane == "velocity" else method.acceleration
    return [(term.tail, term.head) for term in construction.vectors().values()]


@pytest.mark.parametrize("name", NAMES)
def test_no_wrong_answer_is_right(name, asked):
    _, data = asked(name)
    for question in data["questions"]:
        turn = {"line": 180.0, "arrow": 360.0}.get(question["kind"])
        for value, numbers in question["wrong"]:
            assert numbers
            assert all(0 <= k < len(data["mistakes"]) for k in numbers)
            if turn:
                assert 0 <= value < turn + 0.01
                assert apart(value, question["right"], turn) > TOLERANCE_DEG - 0.01
            else:
                assert abs(value - question["right"]) > question["tolerance"] * 0.99


def test_a_mistake_is_named_for_what_it_draws(asked):
    """Each mistake with the Coriolis acceleration of ex3-1, drawn by itself."""
    method, data = asked("ex3-1")
    plot = replay_all(method)
    question = next(q for q in data["questions"] if q["kind"] == "arrow" and "<mi>k</mi>" in q["name"])
    made = {one.id: one for one in rewrites(method, plot) if one.id.startswith("coriolis")}
    for id, words in (("coriolis-reversed", "pointing the other way"), ("coriolis-not-turned", "along the velocity of sliding")):
        laid = rewritten(method, plot, [made[id]]).points("acceleration")
        arrow = complex(laid["k'"] - laid["b2'"])
        angle = math.degrees(math.atan2(arrow.imag, arrow.real)) % 360
        (numbers,) = [numbers for value, numbers in question["wrong"] if apart(value, angle, 360) < 0.01]
        assert any(words in data["mistakes"][k]["en"] for k in numbers)


def test_questions_are_in_the_order_of_the_drawing(asked):
    for name in NAMES:
        method, data = asked(name)
        acts = [question["act"] for question in data["questions"]]
        assert acts == sorted(acts)
        assert max(acts) <= max(act.page for act in method.acts)
