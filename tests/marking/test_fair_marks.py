"""Marks as a fair teacher gives them: a mistake costs one item, a slip is told as one, what follows is carried."""

from __future__ import annotations

import cmath
import json
import math
import re
from dataclasses import replace
from functools import cache

import pytest

from graphkin.files import library, loads
from graphkin.homework.grading import key_for
from graphkin.marking.consequences import combined
from graphkin.marking.diagnosis import rarity
from graphkin.marking.marker import Marker
from graphkin.marking.records import HandedNumber, Marked, StudentWork
from graphkin.model.mechanism import Mechanism
from graphkin.say.marks import mistake

EVERY = ("v B3B2", "omega 3", "a_n B3D", "a_k B3B2", "a_r B3B2", "alpha 3")


def asking(name: str, *questions: str) -> Mechanism:
    """A library mechanism that asks for something else."""
    bare = re.sub(r"(?m)^ask\s*=.*$", "", library.load(name).text)
    return loads(f"ask = {json.dumps(questions)}\n{bare}", name=name)


@cache
def marker(name: str, *questions: str) -> Marker:
    return Marker(key_for(asking(name, *questions)))


def marked(one: Marker, **values: float) -> Marked:
    numbers = {text.replace("__", " "): HandedNumber(value) for text, value in values.items()}
    return one.mark([StudentWork("s", numbers)])[0]


def verdicts(found: Marked) -> dict[str, str]:
    return {one.text: one.verdict for one in found.judged if one.given is not None}


def ids(found: Marked) -> tuple[str, ...]:
    return tuple(id for one in found.diagnosis.explanations for id in one.ids)


def of_ex3_1(v: float, omega: float, a_n: float, a_k: float, a_r: float, alpha: float) -> Marked:
    return marked(marker("ex3-1", *EVERY), **dict(zip(EVERY, (v, omega, a_n, a_k, a_r, alpha), strict=True)))


# example 3-1 drawn by hand with one mistake: v_B3B2, omega 3, a^n_B3D, a^k, a^r, alpha 3
BY_HAND = {
    "driver-along-crank": (0.0712, -2.683, 0.498, 0.382, 6.54, 12.5),
    "coriolis-reversed": (0.321, -3.92, 1.06, 2.515, 4.52, -37.3),
    "coriolis-half": (0.321, -3.92, 1.06, 1.257, 1.00, 37.3),
    "coriolis-omitted": (0.321, -3.92, 1.06, 0.0, 2.168, 12.46),
    "wrong-length": (0.321, -5.65, 2.21, 3.63, 0.27, 68.7),
}


@pytest.mark.parametrize("id", ["coriolis-reversed", "coriolis-half", "coriolis-omitted"])
def test_one_mistake_costs_one_item(id: str):
    found = of_ex3_1(*BY_HAND[id])
    assert id in ids(found)
    assert list(verdicts(found).values()).count("wrong") == 1
    assert found.score == pytest.approx(5 / 6)
    following = [one for one in found.judged if one.verdict == "carried"]
    assert following
    assert all(one.credit == 1.0 for one in following)


def test_the_first_value_in_the_order_of_the_drawing_is_the_one_that_costs():
    """Though alpha is asked for first."""
    one = marker("ex3-1", "alpha 3", "omega 3", "a_k B3B2")
    found = marked(one, **{"alpha 3": 19.1, "omega 3": 2.868, "a_k B3B2": 1.97})
    assert "sliding-across" in ids(found)
    assert verdicts(found) == {"alpha 3": "carried", "omega 3": "wrong", "a_k B3B2": "carried"}
    assert all(one.carried is None for one in found.judged if one.verdict == "wrong")


@pytest.mark.parametrize(("follows", "score"), [(1.0, 5 / 6), (0.5, 4.5 / 6), (0.0, 4 / 6)])
def test_what_follows_is_worth_what_the_teacher_says(follows: float, score: float):
    one = marker("ex3-1", *EVERY)
    key = replace(one.key, marking=replace(one.key.marking, follows=follows))
    found = marked(Marker(key, one.method), **dict(zip(EVERY, BY_HAND["coriolis-reversed"], strict=True)))
    assert found.score == pytest.approx(score)


def test_nothing_is_gained_by_nought():
    found = of_ex3_1(0.321, -3.92, 1.06, 0.0, 0.0, 12.46)
    assert verdicts(found)["a_r B3B2"] == "wrong"


# --- slips ------------------------------------------------------------------------------------


def test_a_slip_with_all_else_consistent_is_told_as_one():
    """omega 3 = -5.2 by no known mistake, and what is calculated and drawn with it."""
    found = of_ex3_1(0.321, -5.2, 1.871, 3.337, 0.256, 68.1)
    assert ids(found) == ("slip",)
    assert found.diagnosis.explanations[0].names == ((("slip", "", ("omega 3",), ""),),)
    assert list(verdicts(found).values()).count("wrong") == 1
    assert found.departure is None


def test_the_same_number_twice_is_no_slip_that_others_follow():
    """Block and guide turn together: one number is said twice, and nothing follows from it."""
    found = marked(marker("ex3-1", "omega 2", "omega 3", "alpha 3"), **{"omega 2": -7.1, "omega 3": -7.1, "alpha 3": 62.2})
    assert not found.diagnosis.explanations


def test_where_nothing_fits_the_first_step_off_the_way_is_named():
    found = of_ex3_1(0.321, -3.92, 1.06, 6.0, 7.7, 500.0)
    assert not found.diagnosis.explanations
    assert found.departure is not None
    assert found.departure.text == "a_k B3B2"
    assert found.departure.left == ("a^n_B3D", "a^t_B3D")
    assert found.departure.right == ("a_B2", "a^k_B3B2", "a^r_B3B2")


def test_a_link_that_does_not_turn_is_looked_at_after_what_is_drawn():
    """omega 3 of a slider is 0 without a drawing: another number there is no first step of one."""
    asked = "omega 2", "v C", "omega 3"
    right = {entry.text: entry.right for entry in marker("fig3-1", *asked).key.entries}
    found = marked(marker("fig3-1", *asked), **{"omega 2": 1.37 * right["omega 2"], "v C": 5.3 * right["v C"], "omega 3": -2.0})
    assert not found.diagnosis.explanations
    assert found.departure is not None
    assert found.departure.text == "v C"


def test_one_value_that_vetoes_no_other():
    """All six say that the Coriolis term is reversed; that another mistake says little of them does not matter."""
    assert ids(of_ex3_1(0.325, -4.02, 1.11, 2.60, 4.55, -38.5)) == ("coriolis-reversed",)


# --- two mistakes -----------------------------------------------------------------------------


def test_a_mistake_beside_a_value_that_nothing_explains():
    one = marker("ex3-5", "v CB", "v E", "omega 2", "omega 3", "a_n CB", "alpha 2", "alpha 3")
    right = {entry.text: entry.right for entry in one.key.entries if entry.points}
    wrong = {text: -value if text.startswith("omega") else value for text, value in right.items()}
    found = marked(one, **{**wrong, "alpha 3": 7.77 * right["alpha 3"]})
    assert "driver-reversed" in ids(found)
    assert "alpha 3" not in found.diagnosis.explanations[0].explains
    assert verdicts(found)["alpha 3"] == "wrong"
    assert found.score == pytest.approx(5.5 / 7)  # a wrong sense alone is half a mistake


# --- what follows from own rotations ----------------------------------------------------------


WHEEL = asking("s4-ex2", "omega 2", "v B").text.replace('points = ["B"]', "shape = { B = [0, 0], F = [0, 120] }").replace('"v B"', '"v F"') + '\n[[pose]]\nvector = "BF"\nangle = 30\n'


@pytest.mark.parametrize(
    ("name", "own", "follows", "by"),
    [
        ("ex3-1", "omega 3", "v C", None),  # v = omega l of a point of the rocker
        ("p3-5", "v C2C3", "a_k C2C3", None),  # the block turns about a fixed point, at the pole
        ("p3-12", "omega 2", "omega 3", -20 / 25),  # gears: omega 3 by so much of what omega 2 is off
        ("wheel", "omega 2", "v F", None),  # a point of a wheel that rolls
    ],
)
def test_a_value_follows_from_an_own_one(name: str, own: str, follows: str, by: float | None):
    one = Marker(key_for(loads(WHEEL, name="wheel"))) if name == "wheel" else marker(name, own, follows)
    right = {entry.text: entry.right for entry in one.key.entries if entry.points}
    value = 1.4 * right[follows] if by is None else right[follows] + by * 0.4 * right[own]
    found = marked(one, **{own: 1.4 * right[own], follows: value})
    assert verdicts(found) == {own: "wrong", follows: "carried"}
    [carried] = [each for each in found.judged if each.text == follows]
    assert own in carried.own


def test_a_carried_value_has_a_tolerance_of_its_own():
    """Once omega is known a^n is calculated: what the pencil errs by in omega is no excuse any more."""
    one = marker("ex3-1", *EVERY)
    entry = next(entry for entry in one.key.entries if entry.text == "a_n B3D")
    right = 3.6**2 * 0.0692  # omega² l_BD
    assert verdicts(marked(one, **{"omega 3": -3.6, "a_n B3D": right}))["a_n B3D"] == "carried"
    assert verdicts(marked(one, **{"omega 3": -3.6, "a_n B3D": right - entry.tolerance}))["a_n B3D"] == "wrong"


@pytest.mark.parametrize(("off", "verdict", "score"), [(0.1, "right", 1.0), (0.2, "too small", 1.0), (0.5, "wrong", 0.5)])
def test_a_value_that_a_pencil_hardly_tells_is_right_within_15_percent(off: float, verdict: str, score: float):
    """A pencil errs by up to a quarter of it there: what is off by so much counts neither way."""
    one = marker("s3-shaper", "alpha 4", "v E")
    right = {entry.text: entry.right for entry in one.key.entries if entry.points}
    found = marked(one, **{**right, "alpha 4": (1 - off) * right["alpha 4"]})
    assert verdicts(found) == {"alpha 4": verdict, "v E": "right"}
    assert found.score == score


MOTOR = """
ask = ["alpha crank", "a G"]
[frame]
O = [0, 0]
[links.crank]
OA = 50
[links.rod]
AP = 180
AG = 60
GP = 120
[links.piston]
points = ["P"]
[[slide]]
name = "piston"
block = "piston"
point = "P"
guide = "frame"
through = [15, 0]
angle = 90
[[driver]]
slide = "piston"
at = 205
velocity = -1.2
[sketch]
A = [45, 25]
"""
DOOR = """
ask = ["omega pinion", "omega door", "v B"]
[frame]
O = [0, 0]
D = [120, 40]
[links.pinion]
OA = 35
[links.rod]
AB = 110
[links.door]
DB = 70
[links.rack]
RS = 100
[[roll]]
wheel = "pinion"
centre = "O"
radius = 25
on = "rack"
through = "R"
toward = "S"
side = "left"
[[slide]]
name = "rack"
block = "rack"
point = "R"
guide = "frame"
through = [0, -25]
angle = 0
tilt = 0
[[driver]]
slide = "rack"
at = -40
velocity = -0.09
[[pose]]
vector = "OA"
angle = 80
[sketch]
B = [90, 100]
"""


def turned(size: float, degrees: float) -> HandedNumber:
    return HandedNumber(size, vector=cmath.rect(size, math.radians(degrees)))


def of_text(text: str, follows: float, numbers: dict[str, HandedNumber]) -> Marked:
    return Marker(key_for(replace(loads(text), follows=follows))).mark([StudentWork("s", numbers)])[0]


@pytest.mark.parametrize("follows", [1.0, 0.0])
@pytest.mark.parametrize(
    ("text", "before", "asked", "size", "right"),
    [
        (MOTOR, {"alpha crank": -240.7}, "a G", 23.9, 188.0),  # by the mistake: the normal acceleration outward
        (DOOR, {"omega pinion": 3.6, "omega door": 1.22}, "v B", 0.0854, 24.1),  # by own values
    ],
)
def test_a_reversed_vector_of_the_right_size_follows_and_is_not_right(
    text: str, before: dict[str, float], asked: str, size: float, right: float, follows: float
):
    numbers = {name: HandedNumber(value) for name, value in before.items()}
    reversed_ = of_text(text, follows, {**numbers, asked: turned(size, right + 180)}).judged
    one = next(one for one in reversed_ if one.text == asked)
    assert (one.verdict, one.credit) == ("carried", max(follows, 0.5))
    assert one.of_mistake or one.own
    one = next(one for one in of_text(text, follows, {**numbers, asked: turned(size, right)}).judged if one.text == asked)
    assert (one.verdict, one.credit) == ("right", 1.0)


def test_a_sense_in_words_is_given():
    ways = [
        ids(of_text(DOOR, 1.0, {text: HandedNumber(value, worded=worded) for text, value in (("omega pinion", 3.6), ("omega door", 1.22))}))
        for worded in (False, True)
    ]
    assert ["sense-not-given" in each for each in ways] == [True, False]


def test_a_mistake_that_turns_an_arrow_otherwise_than_it_was_handed_in_is_none():
    """The Coriolis acceleration is drawn reversed (or right); drawn along the velocity of sliding it would be astray."""
    one = marker("ex3-1", "omega 3", "a_k B3B2", "alpha 3")
    along, right = next(
        (dict(zip((e.text for e in one.key.entries), row, strict=True)), one.directions.right["a_k B3B2"][1])
        for names, row in zip(one.key.singles.names, one.key.singles.values, strict=True)
        if names[0][0] == "coriolis-not-turned"
    )
    numbers = {text: HandedNumber(along[text]) for text in ("omega 3", "alpha 3")}
    found = {}
    for turn in (0, 90, -90, 180):
        vector = abs(right) * cmath.exp(1j * (cmath.phase(right) + math.radians(turn)))
        work = StudentWork("s", {**numbers, "a_k B3B2": HandedNumber(abs(right), vector=vector)})
        found[turn] = "coriolis-not-turned" in ids(one.mark([work])[0])
    assert not found[0]
    assert not found[180]
    assert found[90] != found[-90]


def with_mistake(one: Marker, *name: str) -> tuple[str, dict[str, HandedNumber]]:
    """All that is asked as a mistake has it, with directions; and of which arrow or rotation it is."""
    (made,) = [rewrite for known, rewrite in one.known.items() if known[: len(name)] == name]
    found = combined(one.method, one.plot, one.quantities, [(made,)])
    each = zip(one.key.entries, found.values[0], found.vectors[0], strict=True)
    numbers = {entry.text: HandedNumber(abs(size), vector=vector) if cmath.isfinite(vector) else HandedNumber(size)
               for entry, size, vector in each if entry.points}  # fmt: skip
    return made.of, numbers


@pytest.mark.parametrize(("turn", "named"), [(0, True), (10, True), (40, False), (130, False), (180, True)])
def test_a_direction_that_contradicts_a_mistake(turn: float, named: bool):
    """Of the acceleration of E in example 3-5 the size is as with a^n_CD outward; the sense alone may be another."""
    one = marker("ex3-5", "omega 2", "omega 3", "a E")
    _, numbers = with_mistake(one, "normal-outward", "", ("a^n_CD",))
    turned = (numbers["a E"].vector or 0) * cmath.exp(1j * math.radians(turn))
    found = one.mark([StudentWork("s", {**numbers, "a E": replace(numbers["a E"], vector=turned)})])[0]
    assert ("normal-outward" in ids(found)) == named


COLLAR = """
ask = ["omega 3", "alpha 3", "v B3B2", "a_k B3B2", "a_r B3B2"]
frame = { A = [0, 0], D = [0, 400] }
links = { 1 = { AB = "0.5656854249492381 m" }, 2 = { points = ["B"] }, 3 = { DE = 700 } }
slide = [{ block = "2", point = "B", guide = "3", through = "D", toward = "E" }]
driver = [{ vector = "AB", angle = 45, omega = -3, alpha = -4 }]
sketch = { E = [700, 400] }
"""


def test_an_arrow_that_a_mistake_reverses_follows_from_it():
    """-3.6 = -5.2 + a^r with alpha 1 the other way round: a^r = 1.6 to the right, as large as the right one."""
    one = Marker(key_for(loads(COLLAR, name="collar")))
    _, numbers = with_mistake(one, "driver-acceleration-reversed")
    assert numbers["a_r B3B2"].vector == pytest.approx(1.6)
    found = one.mark([StudentWork("s", numbers)])[0]
    assert ids(found) == ("driver-acceleration-reversed",)
    (a_r,) = [each for each in found.judged if each.text == "a_r B3B2"]
    assert (a_r.verdict, a_r.credit, a_r.reversed) == ("carried", 1.0, False)
    assert [text for text, verdict in verdicts(found).items() if verdict == "wrong"] == ["alpha 3"]


INCHES = """
ask = ["omega 3", "v B", "alpha 3", "a B"]
frame = { name = "1", O = [0, 0] }
links = { 2 = { OA = "1.4 in" }, 3 = { AB = "4 in" }, 4 = { points = ["B"] } }
slide = [{ block = "4", point = "B", guide = "frame", through = [0, "1 in"], angle = 0 }]
driver = [{ vector = "OA", angle = 45, omega = 10 }]
sketch = { B = ["5 in", "1 in"] }
"""


@pytest.mark.parametrize(("factor", "form"), [(100, "100"), (1000, "10³"), (1 / 0.0254, "39.37")])
def test_lengths_in_another_unit(factor: float, form: str):
    """As cm, mm or inches written for m, in a file of inches."""
    one = Marker(key_for(loads(INCHES, name="inches")))
    right = {entry.text: entry.right for entry in one.key.entries if entry.points}
    off = {text: float(f"{value * (factor if text[1] == ' ' else 1):.4g}") for text, value in right.items()}
    found = marked(one, **off)
    assert all(each.carried == pytest.approx(each.given, rel=1e-3) for each in found.judged if each.verdict == "carried")
    assert found.diagnosis.explanations[0].names == ((("conversion", "lengths", ("m/s", "m/s^2"), form),),)
    assert verdicts(found) == {"omega 3": "right", "v B": "wrong", "alpha 3": "right", "a B": "carried"}


def test_the_usual_mistakes_come_first_and_each_once():
    """Of an acceleration alone much may be wrong: a normal one left out first, not again as one calculated and not laid
    off, nor with another one that changes nothing."""
    one = marker("ex3-5", "omega 2", "omega 3", "a E")
    of, numbers = with_mistake(one, "normal-omitted", "", ("a^n_CD",))
    (explanation,) = one.mark([StudentWork("s", {text: replace(each, vector=None) for text, each in numbers.items()})])[0].diagnosis.explanations
    assert explanation.names[0] == (("normal-omitted", "", of, ""),)
    assert "normal-not-laid-off" not in explanation.ids
    places = [rarity(names[0][0]) for names in explanation.names]
    assert places == sorted(places)


def test_several_arrows_in_words():
    several = mistake(("normal-omitted", "", ("a^n_CB", "a^n_CD"), ""), "en")
    assert several == "the normal accelerations a^n_CB and a^n_CD left out"
    assert mistake(("normal-omitted", "", ("a^n_CB",), ""), "en") == "the normal acceleration a^n_CB left out"
    assert mistake(("coriolis-omitted", "", ("a^k_CB", "a^k_DE"), ""), "zh") == "漏掉科氏加速度 a^k_CB、a^k_DE"


ROLLING = """
ask = ["omega 2", "v B", "omega 3", "a B", "alpha 3"]
frame = { O = [0, 0] }
links = { 1 = { OA = 40 }, 2 = { AB = 130 }, 3 = { points = ["B"] } }
roll = [{ wheel = "3", centre = "B", radius = 25, on = "frame", through = [0, -25], angle = 0, side = "left" }]
driver = [{ vector = "OA", angle = 60, omega = 5 }]
sketch = { B = [150, 0] }
"""


def test_a_diameter_for_the_radius_of_a_wheel_is_one_mistake():
    """omega 3 = v_B / 50 mm, alpha 3 = a_B / 50 mm."""
    one = Marker(key_for(loads(ROLLING, name="rolling")))
    right = {entry.text: entry.right for entry in one.key.entries if entry.points}
    found = marked(one, **{text: value / 2 if text.endswith("a 3") else value for text, value in right.items()})
    assert ids(found) == ("diameter-for-radius",)
    assert verdicts(found) == {**dict.fromkeys(right, "right"), "omega 3": "wrong", "alpha 3": "carried"}


EPICYCLIC = """
ask = ["omega 2", "omega H", "v P"]
frame = { name = "3", O = [0, 0] }
links = { 1 = { points = ["O"] }, 2 = { points = ["P"] }, H = { OP = 36 } }
gear = [{ links = ["1", "2"], centres = ["O", "P"], radii = [20, 16] },
        { links = ["2", "frame"], centres = ["P", "O"], radii = [16, 52], internal = true }]
driver = [{ link = "1", omega = 10 }]
pose = [{ vector = "OP", angle = 40 }]
"""


def test_a_direction_that_is_calculated_from_an_own_rotation():
    """A train as if its axes were fixed: omega H = -12.5 * 16 / 52, and v_P = omega H l_OP points as that has it."""
    one, omega = Marker(key_for(loads(EPICYCLIC, name="train"))), -12.5 * 16 / 52
    v = 1j * omega * 0.036 * cmath.exp(1j * math.radians(40))
    numbers = {"omega 2": HandedNumber(-12.5), "omega H": HandedNumber(omega), "v P": HandedNumber(abs(v), vector=v)}
    found = one.mark([StudentWork("s", numbers)])[0]
    assert verdicts(found) == {"omega 2": "wrong", "omega H": "carried", "v P": "carried"}
