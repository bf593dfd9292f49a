"""Many mechanisms of one file as a program has them: read as any state, refused one by one; trials, and what is taken."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import graphkin
from graphkin.errors import GraphkinError, NoSuchValue, RoadsDiffer, TooSmall, UnevenArrays, WrongCount

AB = [22.0, 24.0, -1.0, 26.0, 300.0]


def lengths() -> graphkin.Mechanism:
    return graphkin.load("ex3-1")


def test_read_as_any_state():
    many = lengths().variants(AB=AB, D=(np.full(5, 80.0), 1), omega="95 rpm")
    found, turned = graphkin.replay(many), graphkin.sweep(many, "60:180:60")
    exact, again = graphkin.motion(many), graphkin.sweep(many, "60:180:60", by="analysis")
    assert isinstance(found.refused[2], TooSmall)
    assert found.refused.keys() == exact.refused.keys() == turned.refused.keys()
    for row, length in enumerate(AB):
        if row in found.refused:
            assert np.isnan(found.omega["3"][row])
            assert np.isnan(found["a_k B3B2"].x[row])
            continue
        single = graphkin.Drawing.of(lengths().with_(AB=length, D=(80, 1), omega="95 rpm"))
        for text in ("omega 3", "v C", "a_k B3B2", "theta 3", "omega 1 / omega 3", "v_x C"):
            assert found[text][row] == pytest.approx(single[text], rel=1e-12)
            assert exact[text][row] == pytest.approx(single[text], rel=1e-9)
        swept = graphkin.sweep(single.mechanism, "60:180:60", "omega 3, a C")
        assert turned.omega["3"][:, row] == pytest.approx(swept["omega 3"].signed, rel=1e-9)
        assert np.array(again.a["C"])[:, row] == pytest.approx(swept["a C"].vectors, rel=1e-9)
    assert found.v["C"].direction.shape == (5,)
    assert turned.v["C"].magnitude.unit == "m/s"


def test_positions_of_each():
    """Values (positions, n): each mechanism where it is asked for."""
    many, at = lengths().variants(AB=[22.0, 24.0]), np.array([[60, 70], [80, 90], [100, 110]])
    found = graphkin.replay(many, [at])
    for row in (0, 1):
        own = graphkin.replay(graphkin.plan(many[row]), [at[:, row]])
        assert found.omega["3"][:, row] == pytest.approx(own.omega["3"], rel=1e-9)


def test_variants_one_by_one():
    many = lengths().variants(AB=AB)
    assert (len(many), many[-1].text) == (5, lengths().with_(AB=300.0).text)
    assert repr(many) == "<Variants of ex3-1: 5 mechanisms, other links.1.AB>"
    with pytest.raises(IndexError):
        many[5]
    answers = [*graphkin.solve_many(many, ["omega 3"])]
    assert [answer.error is not None for answer in answers] == [False, False, True, False, False]
    assert [answer.name for answer in answers] == ["ex3-1"] * 5
    assert [len(each.driven) for each in graphkin.sweep_many(many, "60:180:60", ["omega 3"])] == [3, 3, 0, 3, 3]


@pytest.mark.parametrize("values", [{"AB": ["24 mm", "1 in", "2 cm"]}, {"tilt": [0.0]}, {"alpha": [0.0, 5.0, -3.0]}])
def test_whatever_with_takes(values: dict[str, object]):
    if "tilt" in values:
        with pytest.raises(NoSuchValue):
            lengths().variants(values)
        return
    found = graphkin.replay(lengths().variants(values))
    for row in range(3):
        own = graphkin.Drawing.of(lengths().with_({name: value[row] for name, value in values.items()}))
        assert found.omega["3"][row] == pytest.approx(own.omega["3"], rel=1e-12)
        assert found.a["C"][row] == pytest.approx(own.a["C"], rel=1e-9)


def test_what_is_wrong_is_said():
    for wrong in ({"AB": [1.0, 2.0], "DC": [1.0, 2.0, 3.0]}, {"AB": []}):
        with pytest.raises(UnevenArrays):
            graphkin.replay(lengths().variants(wrong))
    with pytest.raises(TooSmall):
        graphkin.replay(lengths().variants(AB=[-1.0, -2.0]))


# --- trials -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "values"),
    [("ex3-5", {"AB": 28, "DC": 63}), ("s3-four", {"BE": 42, "CE": 36, "D": (71, 2)}), ("ex3-7", {"omega AB": 2, "A": (0, 270)}),
     ("ex3-7", {"driver.0.alpha": 3}), ("p3-22", {"frame.C": (1, 1)}), ("fig2-32", {"omega": 3})],
)  # fmt: skip
def test_a_trial_is_what_is_taken(name: str, values: dict[str, object]):
    mechanism = graphkin.load(name)
    driver = mechanism.drivers[0]
    over = {driver.name: driver.value * (1e3 if driver.kind == "slide" else 180 / np.pi) + np.arange(5.0)}
    trial = graphkin.trial(mechanism, *values, over=over)
    found, proved = trial(*values.values()), trial.taken(*values.values())
    other = mechanism.with_(values)
    for point in mechanism.points:
        assert np.array(found.a[point]) == pytest.approx(np.array(proved.a[point]), rel=1e-9, abs=1e-9)
    assert other.links == proved.mechanism.links
    assert other.drivers == proved.mechanism.drivers


def test_a_trial_keeps_its_branch():
    """A sketch that would mean the other assembly does not matter; what is taken has its sketch where it was drawn."""
    mechanism = graphkin.load("ex3-5")
    trial = graphkin.trial(mechanism, "AB", "DC", over="55:65:5")
    place = trial.taken(28, 63).mechanism.sketch["C"]
    assert abs(place - graphkin.Drawing.of(trial.taken(28, 63).mechanism).position["C"]) < 1e-9
    assert np.isnan(trial(300, 20).position["C"]).all()
    with pytest.raises(GraphkinError):
        trial.taken(300, 20)


def test_what_is_wrong_with_a_trial(tmp_path: Path):
    trial = graphkin.trial(graphkin.load("ex3-5"), "AB")
    for wrong in ("24 kg", None, [24.0, 25.0], object()):
        with pytest.raises(GraphkinError, match=r"links\.1\.AB"):
            trial(wrong)
    with pytest.raises(WrongCount):
        trial(1, 2)
    with pytest.raises(NoSuchValue):
        graphkin.trial(graphkin.load("ex3-5"), "XY")


@pytest.mark.parametrize(("name", "of", "values"), [
    ("ex3-5", "AB", [-1, 0, np.nan, np.inf, 1e300, 1e9]), ("p3-22", "frame.C", [(1e9, 0), (np.nan, 0)]), ("s3-four", "CE", [0, -3]),
])  # fmt: skip
def test_an_optimiser_may_ask_for_what_cannot_be(name: str, of: str, values: list[object]):
    """It goes on from there; why there is no such mechanism is said, and told of what is taken."""
    trial = graphkin.trial(name, of)
    for value in values:
        tried = trial(value)
        assert all(np.isnan(tried.position[point]).all() for point in trial.mechanism.points)
        assert all(np.isnan(tried.omega[link]).all() for link in trial.mechanism.moving)
        assert isinstance(tried.refused[0], GraphkinError)
        with pytest.raises(type(tried.refused[0])):
            trial.taken(value)


def test_a_trial_is_held(monkeypatch: pytest.MonkeyPatch):
    trial = graphkin.trial(graphkin.load("ex3-5"), "AB", over="0:90:30")
    wrong = graphkin.trial(graphkin.load("ex3-5"), "DC", over="0:90:30")
    monkeypatch.setitem(trial.__dict__, "_program", wrong._program)
    with pytest.raises(RoadsDiffer):
        trial.taken(35)


def test_positions_beyond_dead_points_and_change_points_are_held_too():
    """Each of many stands on its own side of them, and the analysis that is assembled there confirms it."""
    mechanism = (graphkin.Mechanism.new("x").fix(A=(0, 0), D=(80, 0)).link(1, AB=30).link(2, BC=70).link(3, DC=60)
                 .drive("AB", angle=60, omega=10).sketch(C=(80, 60)).done())  # fmt: skip
    for lengths in ([75, 30], [50, 30], [30, 65, 30]):
        found = graphkin.sweep(mechanism.variants(AB=lengths), "60:300:60").omega["3"].si
        assert found[:, lengths.index(30)] == pytest.approx([2.852939, 5, 2.727273, -0.670103, -4.077428], abs=1e-6)
        assert np.isfinite(found[[0, -1]]).all()
    many = mechanism.variants(AB=np.random.default_rng(1).normal(45, 20, 500).clip(5))
    assert np.isnan(graphkin.sweep(many, "0:360:60").omega["3"].si).any()


@pytest.mark.parametrize("measures", [{"BE": 40, "CBE": 35}, {"BE": 40, "CE": 45}, {"CE": 40, "BCE": 35}])
def test_a_coupler_given_by_an_angle_is_drawn_many_at_once(measures: dict[str, float]):
    mechanism = (graphkin.Mechanism.new("x").fix(A=(0, 0), D=(80, 0)).link(1, AB=30).link(2, BC=70, ccw="BCE", **measures).link(3, DC=60)
                 .drive("AB", angle=60, omega=10).sketch(C=(80, 60)).done())  # fmt: skip
    trial = graphkin.trial(mechanism, "BC", *measures, over="0:360:10")
    assert trial._program is not None
    values = {"BC": 71.0, **{name: value * 1.02 for name, value in measures.items()}}
    alone = graphkin.replay(mechanism.with_(values), [np.arange(0, 361, 10)])
    assert np.abs(trial(*values.values()).v["E"].si - alone.v["E"].si).max() < 1e-12
    angle = list(measures)[-1]
    assert trial(*list(values.values())[:-1], 200.0).refused.keys() == ({0} if len(angle) == 3 else set())
