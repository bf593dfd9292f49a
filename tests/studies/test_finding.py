"""Positions with a property: the book's own questions, single conditions, messages."""

from __future__ import annotations

import json
import math
import os

import numpy as np
import pytest

from graphkin import Mechanism, api
from graphkin import files as loading
from graphkin.errors import GraphkinError, Lang
from graphkin.say.finding import lines
from graphkin.sheet import finding_sheet
from graphkin.sheet.marks import Disc, Stroke
from graphkin.studies import finding, sweeps
from graphkin.studies.finding.search import Curve, differences, followed, tops, touches, vanishing

PLAIN = """
[frame]
name = "4"
A = [0, 0]
D = [78, 0]
[links.1]
AB = 24
[links.guide]
DC = 48
[links."2'"]
points = ["B"]
[[slide]]
name = "ram"
block = "2'"
point = "B"
guide = "guide"
through = "C"
from = "DC"
angle = 100
[[driver]]
vector = "AB"
angle = 60
omega = 10
[sketch]
C = [65, 46]
"""


def found_by(name: str, condition: str, *ranges: str) -> finding.Found:
    return finding.find(api.plan(api.load(name)), condition, ranges)


def degrees(found: finding.Found) -> list[float]:
    return [math.degrees(position.drivers[found.swept]) for position in found.positions]


# --- the book's questions ---------------------------------------------------------------------


POSITIONS = [
    ("p3-4a", "a_k B3B2 = 0", [90, 180 + math.degrees(math.asin(30 / 80)), 270, 360 - math.degrees(math.asin(30 / 80))]),
    ("p3-4a", "a_k B2B3 = 0", [90, 180 + math.degrees(math.asin(30 / 80)), 270, 360 - math.degrees(math.asin(30 / 80))]),
    ("p3-13", "v C = 0", [
        math.degrees(math.acos((180**2 + 120**2 - 90**2) / (2 * 180 * 120))),
        180 + math.degrees(math.acos((60**2 + 120**2 - 90**2) / (2 * 60 * 120))),
    ]),
    ("p3-13", "omega 4 = 0", [
        math.degrees(math.acos((180**2 + 120**2 - 90**2) / (2 * 180 * 120))),
        180 + math.degrees(math.acos((60**2 + 120**2 - 90**2) / (2 * 60 * 120))),
    ]),
    ("p3-13", "omega 3 = omega 4", [0, 180]),
    ("p3-13", "omega 3 / omega 4 = 1", [0, 180]),
]  # fmt: skip


@pytest.mark.parametrize(("name", "condition", "exact"), POSITIONS)
def test_all_positions_are_found_to_the_last_digits(name: str, condition: str, exact: list[float]) -> None:
    assert degrees(found_by(name, condition)) == pytest.approx(exact, abs=360e-10)


def test_shear_blades_meet_and_run_with_the_strip() -> None:
    """Exercise 3-18: the blades stand over each other, CD upright; the strip wants 0.5 m/s along x."""
    upright = degrees(found_by("p3-18", "theta 3 = 90"))
    assert any(angle == pytest.approx(280, abs=1e-6) for angle in upright)
    assert any(angle == pytest.approx(280, abs=1e-6) for angle in degrees(found_by("p3-18", "x E = x E'")))
    for blade, omega in (("E", 4.031), ("E'", 4.222)):
        for driver in ("omega 1", "AB"):
            speeds = found_by("p3-18", f"v_x {blade} = 0.5 by {driver}").speeds
            assert [entry.rates[0] for entry in speeds] == [pytest.approx(omega, abs=5e-4)]


def test_slowest_point_of_the_coupler() -> None:
    (slow,) = found_by("p3-13", "slowest BC").slow
    assert slow.along == pytest.approx(0.188811, abs=5e-7)
    assert slow.speed == pytest.approx(0.36094, abs=5e-6)
    assert slow.along > slow.length
    (back,) = found_by("p3-13", "slowest CB").slow
    assert back.place == pytest.approx(slow.place, abs=1e-12)
    (whole,) = found_by("p3-13", "slowest 3").slow
    assert whole == slow


def test_no_point_of_the_line_is_slower() -> None:
    method = api.plan(api.load("p3-13"))
    for angle in (0.0, 77.0, 165.0):
        (slow,) = finding.find(method, "slowest BC", (f"AB={angle}",)).slow
        plot = api.replay(method, [angle])
        start, end = plot.position["B"], plot.position["C"]
        along = np.linspace(-1, 1, 2001) + slow.along
        places = along * (end - start) / abs(end - start)
        speeds = np.abs(plot.velocity["b"] + 1j * plot.omega["3"] * places)
        assert slow.speed == pytest.approx(float(speeds.min()), rel=1e-12)
        assert along[np.argmin(speeds)] == pytest.approx(slow.along, abs=1e-9)


@pytest.mark.parametrize(("angle", "dashes"), [(60, 1), (120, 0)])
def test_the_sheet_marks_the_slowest_point(angle: int, dashes: int) -> None:
    method = api.plan(api.load("ex3-7"))
    found = finding.find(method, "slowest ED", (f"AB={angle}",))
    drawn = finding_sheet.drawn(found)
    assert drawn[0] is not None
    marks, scale = drawn[0].marks, drawn[0].scales["position"]
    (dot,) = (m.centre for m in marks if isinstance(m, Disc) and m.radius == finding_sheet._DOT)
    onward = [m.places for m in marks if isinstance(m, Stroke) and m.pen == "dashed" and m.places[-1] == dot]
    assert len(onward) == dashes
    for start, end in onward:
        assert abs(end - start) * scale == pytest.approx(abs(found.slow[0].along or 0.0), rel=1e-9)


@pytest.mark.parametrize(("screw", "stroke"), [(55, 84.087), (90, 77.660), (125, 43.324)])
def test_strokes_of_the_adjustable_engine(screw: int, stroke: float) -> None:
    found = found_by("p3-21", "stroke s piston", f"screw={screw}")
    assert found.swing == pytest.approx(stroke / 1000, abs=1.5e-6)
    assert found.stroke is not None
    assert found.stroke.advance.angle + found.stroke.retreat.angle == pytest.approx(2 * math.pi)
    assert found.stroke.ratio >= 1


def test_wiper_and_rack_swing() -> None:
    assert math.degrees(found_by("p3-19", "range theta 3").swing or 0) == pytest.approx(171.89, abs=5e-3)
    assert math.degrees(found_by("p3-19", "range theta 2").swing or 0) == pytest.approx(39.72, abs=5e-3)


def test_crank_rocker_of_the_course() -> None:
    """s2-2: psi 40.535, theta 29.859, K 1.39775; exact by the two triangles at the limits."""
    found = found_by("s2-2", "stroke theta 3")
    assert math.degrees(found.swing or 0) == pytest.approx(40.535, abs=5e-4)
    assert found.stroke is not None
    assert found.stroke.ratio == pytest.approx(1.39775, abs=5e-6)
    pole = math.degrees(found.stroke.advance.angle) - 180
    assert pole == pytest.approx(29.859, abs=5e-4)


def test_times_and_mean_speeds_of_a_stroke() -> None:
    found = found_by("ex3-7", "stroke theta 3")
    assert found.stroke is not None
    for phase in (found.stroke.advance, found.stroke.retreat):
        assert phase.time == pytest.approx(phase.angle / 1.0)
        assert phase.mean == pytest.approx((found.swing or 0) / phase.angle)


# --- single conditions ------------------------------------------------------------------------


def test_an_angle_is_meant_but_for_whole_turns() -> None:
    one = degrees(found_by("ex3-7", "theta 3 = 100"))
    assert len(one) == 2
    assert degrees(found_by("ex3-7", "theta 3 = 460")) == pytest.approx(one, abs=1e-8)
    assert degrees(found_by("ex3-7", "theta 3 = -4.537856055185257 rad")) == pytest.approx(one, abs=1e-8)


def test_a_crank_stands_once_at_each_angle_even_at_a_turns_seam() -> None:
    assert degrees(found_by("p3-13", "theta 2 = 0")) == pytest.approx([0], abs=1e-9)
    assert degrees(found_by("p3-13", "theta 2 = 360")) == pytest.approx([0], abs=1e-9)
    assert degrees(found_by("p3-13", "theta 2 = 90", "AB=0:720:5")) == pytest.approx([90], abs=1e-9)


def test_only_where_it_is_asked_for() -> None:
    assert degrees(found_by("p3-13", "v C = 0", "AB=0:180:10")) == pytest.approx([26.384329747], abs=1e-8)
    none = found_by("p3-13", "v C = 0", "AB=40:180:10")
    assert none.positions == ()
    assert none.nearest is not None
    assert math.degrees(none.nearest.drivers[0]) == pytest.approx(40)


def test_nothing_found_says_how_near_it_came() -> None:
    most = found_by("p3-13", "max v C").positions[0]
    found = found_by("p3-13", "v C = 1.2")
    assert found.nearest is not None
    assert found.nearest.drivers == pytest.approx(most.drivers, abs=1e-9)
    assert found.nearest.values == pytest.approx(most.values)
    touched = found_by("p3-13", f"v C = {most.values[0]!r}")
    assert [entry.kind for entry in touched.positions] == ["touch"]
    assert touched.positions[0].drivers == pytest.approx(most.drivers, abs=1e-9)


def test_a_sign_counts_along_the_guide() -> None:
    """A piston: as fast one way as the other way round, at mirrored places of an in-line slider-crank."""
    out, back = found_by("s3-1-17", "v C = 0.5"), found_by("s3-1-17", "v C = -0.5")
    assert sorted(degrees(out)) == pytest.approx(sorted(360 - angle for angle in degrees(back)), abs=1e-7)
    assert set(degrees(out)).isdisjoint(degrees(back))
    most, least = found_by("s3-1-17", "max v C"), found_by("s3-1-17", "min v C")
    assert most.positions[0].values[0] == pytest.approx(-least.positions[0].values[0])


def test_intervals_go_on_over_the_end_of_a_turn() -> None:
    above, below = found_by("ex3-7", "theta 3 > 95"), found_by("ex3-7", "theta 3 < 95")
    (one,), (other,) = above.intervals, below.intervals
    assert other.begin.drivers == pytest.approx(one.end.drivers)
    assert other.end.drivers[0] == pytest.approx(one.begin.drivers[0] + 2 * math.pi)
    assert one.peak.values[0] == pytest.approx(found_by("ex3-7", "max theta 3").positions[0].values[0])
    assert other.peak.values[0] == pytest.approx(found_by("ex3-7", "min theta 3").positions[0].values[0])


def test_a_limit_in_g_is_passed_where_the_size_is_above_it() -> None:
    method = api.plan(api.load("p3-21"))
    moved = sweeps.course(method)
    found = finding.limit(moved, "a F 0.1 g")
    t = np.linspace(moved.t.min(), moved.t.max(), 721)
    size = sweeps.quantities_at(moved, ["a F"], t, "analysis")["a F"].values
    inside = np.zeros(t.size, dtype=bool)
    for part in found.intervals:
        inside |= (t >= part.begin.t) & (t <= part.end.t)
        inside |= (t + 2 * np.pi >= part.begin.t) & (t + 2 * np.pi <= part.end.t)
    assert np.array_equal(inside, size > 0.1 * 9.80665)
    assert finding.limit(moved, "a F 3 g").intervals == ()
    assert finding.limit(moved, "a F 0.980665").intervals == found.intervals


def test_accelerations_in_g_and_metres() -> None:
    assert degrees(found_by("p3-13", "a C = 1 g")) == pytest.approx(degrees(found_by("p3-13", "a C = 9806.65 mm/s^2")))


def test_held_everywhere_is_said_so() -> None:
    assert found_by("ex3-1", "omega 2 = omega 3").everywhere
    level = found_by("p3-13", "max omega 2")
    assert level.everywhere
    assert level.positions[0].values == (10.0,)


def test_what_is_level_between_dead_points_is_drawn() -> None:
    """Where nothing changes any position will do, but not a dead point, at which nothing can be drawn."""
    rocker = Mechanism.new("rocker").fix(A=(0, 0), D=(80, 0)).link(1, AB=60).link(2, BC=30).link(3, DC=40)
    method = api.plan(rocker.drive("AB", angle=30, omega=-2).sketch(C=(65, 35)).done())
    found = finding.find(method, "max v B")
    assert (found.everywhere, found.stopped) == (True, (True, True))
    assert finding_sheet.drawn(found)[0] is not None


def test_scaling_by_speed_keeps_the_sense_and_knows_squares() -> None:
    mechanism = api.load("p3-13")
    method = api.plan(mechanism)
    (one,) = finding.find(method, "omega 4 = 3 by AB").speeds
    (other,) = finding.find(method, "omega 4 = -3 by AB").speeds
    assert one.factor == pytest.approx(-other.factor)
    (square,) = finding.find(method, "a C = 100 by omega 2").speeds
    (size,) = finding.find(method, "a C = 25 by omega 2").speeds
    assert square.factor == pytest.approx(2 * size.factor)
    faster = loading.loads(mechanism.text.replace("omega = 10", f"omega = {one.rates[0]!r}"))
    assert api.replay(api.plan(faster)).omega["4"] == pytest.approx(3, rel=1e-12)


def test_all_drivers_are_scaled_together() -> None:
    found = found_by("p3-22", "v S = 0.1 by lift")
    (speeds,) = found.speeds
    ratios = [rate / driver.rate for rate, driver in zip(speeds.rates, found.drivers, strict=True)]
    assert ratios == pytest.approx([speeds.factor] * 2)
    assert any("proportion" in line for line in lines(found))


def test_extremes_without_a_limit_are_no_numbers() -> None:
    found = found_by("p3-22", "max v S")
    assert {position.kind for position in found.positions} == {"pole"}
    assert json.dumps(finding.as_json(found), allow_nan=False)
    quotient = found_by("p3-13", "max omega 3 / omega 4")
    assert degrees(quotient) == pytest.approx(degrees(found_by("p3-13", "omega 4 = 0")), abs=1e-6)


def test_any_names_and_both_roads() -> None:
    method = api.plan(loading.loads(PLAIN))
    conditions = ("s ram = 50", "a_k B@guide,B@2' = 0", "max omega guide", "theta guide = 100", "v B@guide = 0.2")
    for condition in conditions if "GRAPHKIN_RANDOM" in os.environ else conditions[:3]:
        one, other = (finding.find(method, condition, (), by) for by in ("construction", "analysis"))
        assert degrees(one) == pytest.approx(degrees(other), abs=1e-7), condition
        assert one.positions, condition


# --- words, messages --------------------------------------------------------------------------


SAID = [
    ("p3-13", "v C = 0"), ("p3-13", "slowest BC"), ("p3-13", "v C = 1.2"), ("p3-13", "v C > 1"), ("p3-22", "max v S"),
    ("p3-21", "stroke s piston"), ("p3-18", "v_x E = 0.5 by AB"), ("ex3-1", "omega 2 = omega 3"), ("ex3-7", "max v E"),
    ("p3-13", "stroke theta 2"), ("p3-13", "stroke theta 3"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "condition"), SAID)
def test_both_languages_say_the_same_numbers(name: str, condition: str) -> None:
    found = found_by(name, condition)
    english, chinese = (list(lines(found, lang)) for lang in ("en", "zh"))
    assert len(english) == len(chinese) > 1
    assert english != chinese or not found.looked
    for one, other in zip(english, chinese, strict=True):
        assert sorted(numbers(one)) == sorted(numbers(other))
    data = finding.as_json(found)
    assert json.loads(json.dumps(data, allow_nan=False)) == data


def numbers(line: str) -> list[str]:
    import re

    return re.findall(r"\d+\.\d+", line)


def test_words_tell_range_and_dead_points() -> None:
    line = next(lines(found_by("p3-22", "max v S")))
    assert "dead point" in line
    assert next(lines(found_by("p3-13", "v C = 0"))).endswith("(searched from φ_AB = 0° to 360°, a full turn)")
    assert any("nearest" in text for text in lines(found_by("p3-13", "v C = 1.2")))


WRONG = [
    ("nonsense", "BadCondition"),
    ("v C", "BadCondition"),
    ("v C == 0", "BadCondition"),
    ("maximum v C", "BadCondition"),
    ("v Q = 0", "UnknownPoint"),
    ("x Q = 0", "UnknownPoint"),
    ("v_x Q = 0", "UnknownPoint"),
    ("omega 7 = 0", "UnknownLink"),
    ("s ram = 0", "UnknownSlide"),
    ("speed C = 0", "UnknownQuantity"),
    ("v C = fast", "UnknownQuantity"),
    ("v C = 3 mm", "OtherDimension"),
    ("theta 3 = 3 foo", "UnknownUnit"),
    ("omega 3 = 3 g", "UnknownUnit"),
    ("v C = 1.2.3", "UnknownUnit"),
    ("omega 3 / omega 4 = 2 rad/s", "NoUnitHere"),
    ("v C = omega 3", "OtherUnits"),
    ("omega 3 / omega 4 = omega 3", "OtherUnits"),
    ("v C = -1", "NegativeSize"),
    ("v C = 1e400", "OutOfRange"),
    ("slowest BD", "NoLineOf"),
    ("slowest 9", "NoLineOf"),
    ("v C = 1 by omega 3", "NoSuchDriver"),
    ("v C = omega 3 by AB", "BadCondition"),
    ("theta 3 = 30 by AB", "NotScaled"),
    ("omega 3 / omega 4 = 3 by AB", "NotScaled"),
    ("v C = -1 by AB", "NegativeSize"),
    ("alpha 2 = 3 by AB", "CannotScale"),
    ("stroke v C", "BadCondition"),
]


@pytest.mark.parametrize(("condition", "error"), WRONG)
def test_wrong_conditions_get_one_clear_message(condition: str, error: str) -> None:
    with pytest.raises(GraphkinError) as caught:
        found_by("p3-13", condition)
    assert type(caught.value).__name__ == error
    messages = {lang: caught.value.message(lang) for lang in ("en", "zh")}
    assert messages["en"] != messages["zh"]
    assert all("{" not in text and text for text in messages.values())


@pytest.mark.parametrize("text", ["", "a C", "3 g", "a C = 3 g", "a C fast"])
def test_wrong_limits(text: str) -> None:
    with pytest.raises(GraphkinError):
        finding.limit(sweeps.course(api.plan(api.load("p3-13"))), text)


# --- numerics ---------------------------------------------------------------------------------


def looked_at(function, low: float = 0.0, high: float = 6.0, count: int = 601) -> Curve:
    t = np.linspace(low, high, count)
    return followed(function, differences(function, (high - low) / count / 2), t)


def test_zeros_touchings_poles_and_pairs_between_two_places() -> None:
    assert looked_at(np.sin).zeros == pytest.approx([0, math.pi], abs=1e-14)
    curve = looked_at(lambda t: (t - 2.123456789) ** 2 * (5.5 - t))
    assert curve.zeros[-1] == pytest.approx(5.5, abs=1e-14)
    assert touches(curve) == pytest.approx([2.123456789], abs=1e-10)
    with np.errstate(divide="ignore"):
        assert looked_at(lambda t: 1 / (t - 1.23456)).zeros.size == 0
    near = 1e-4
    pair = looked_at(lambda t: (t - 3.00123) ** 2 - near**2).zeros
    assert pair == pytest.approx([3.00123 - near, 3.00123 + near], abs=1e-10)


def test_extremes_to_the_last_digits() -> None:
    assert tops(looked_at(lambda t: np.cos(t - 1.7))) == pytest.approx([1.7], abs=1e-10)
    assert tops(looked_at(lambda t: np.abs(t - 2.3)), -1.0) == pytest.approx([2.3], abs=1e-12)


def test_vectors_come_to_nothing_simply_and_twice() -> None:
    t = np.linspace(0, 6, 601)
    for function, zeros in (
        (lambda t: (t - 1.2345) * np.exp(1j * t), [1.2345]),
        (lambda t: (t - 1.2345) ** 2 * np.exp(1j * t), [1.2345]),
        (lambda t: (t - 1.2345) + 1e-6j, []),
    ):
        assert vanishing(t, function(t), function)[0] == pytest.approx(zeros, abs=1e-6)


@pytest.mark.parametrize(("name", "condition", "lang", "first"), [
    ("p3-4a", "a_k B3B2 = 0", "en", "aᵏ_B3B2 = 0 (searched from φ_AB = 0° to 360°, a full turn)"),
    ("ex3-7", "stroke s ram", "zh", "s_ram 的行程（搜索范围：φ_AB = 0° 至 360°，即整周）"),
    ("p3-18", "v_x E = 0.5 by omega 1", "en", "ω1 for v_E,x = 0.5"),
])  # fmt: skip
def test_the_sheet_says_in_signs_what_was_found(name: str, condition: str, lang: Lang, first: str) -> None:
    told = [*lines(found_by(name, condition), lang)]
    assert told[0] == first
    assert all(line.startswith("  ") for line in told[1:])
    assert not [line for line in told if "\0" in line or " deg" in line]


@pytest.mark.parametrize(("condition", "said"), [
    ("v E > 0.1", True), ("v E = -0.1", True), ("v E = 0", False), ("omega 4 = 0.5", False), ("max v E", False),
])  # fmt: skip
def test_which_way_counts_as_positive_is_said(condition: str, said: bool):
    """Of what a guide leads, where a sign decides what is found."""
    import graphkin

    english, chinese = (graphkin.lines_of(graphkin.find("ex3-7", condition), lang) for lang in ("en", "zh"))
    assert ("  along its guide v_E is positive horizontally to the right" in english) is said
    assert ("  v_E 沿导路取值，水平向右为正" in chinese) is said
