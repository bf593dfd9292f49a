"""Mistakes with what is given, centres, wheels and assemblies, against what each means worked out on its own."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
import random_mechanisms

from graphkin import files as loading
from graphkin.analytic import motion
from graphkin.base.geometry import cross
from graphkin.files import library
from graphkin.homework.grading import key_for
from graphkin.marking import Consequences, consequences
from graphkin.marking.marker import Marker
from graphkin.marking.records import HandedNumber, StudentWork
from graphkin.model.mechanism import Mechanism
from graphkin.model.quantities import Quantity, read
from graphkin.planning import plan
from graphkin.running import replay_all


def led_to(mechanism: Mechanism, *texts: str, scales: dict[str, float] | None = None) -> Consequences:
    quantities: list[Quantity] = [quantity for text in texts if (quantity := read(mechanism, text)) is not None]
    assert len(quantities) == len(texts)
    method = plan(mechanism)
    return consequences(method, replay_all(method), quantities, scales)


def values(found: Consequences, *words: str | tuple[str, ...]) -> np.ndarray:
    """What the one rewrite of this id, way, arrow and form gives."""
    rows = [row for row, (rewrite,) in enumerate(found.columns) if rewrite.name[: len(words)] == words]
    assert len(rows) == 1, (words, [rewrite.name for (rewrite,) in found.columns if rewrite.id == words[0]])
    return found.values[rows[0]]


def right(mechanism: Mechanism, *texts: str) -> list[float]:
    """What is right for a mechanism, by the analysis."""
    exact = motion(mechanism)
    return [float(quantity.answer(exact).value) for text in texts if (quantity := read(mechanism, text)) is not None]


def driven(mechanism: Mechanism, **changes: float) -> Mechanism:
    (driver,) = mechanism.drivers
    return replace(mechanism, drivers=(replace(driver, **changes),))


ALL = ("omega 2", "omega 3", "alpha 2", "alpha 3", "v C", "a C")
MOVED = ("omega 2", "alpha 2", "v E", "a E", "v C", "a C")


# --- what is given ------------------------------------------------------------------------------


@pytest.mark.parametrize(("name", "texts"), [("fig3-1", MOVED), ("s3-four", ALL)])
def test_a_driver_s_acceleration_dropped(name: str, texts: tuple[str, ...]):
    mechanism = library.load(name)
    found = values(led_to(mechanism, *texts), "driver-acceleration-dropped")
    assert np.abs(found) == pytest.approx(np.abs(right(driven(mechanism, acceleration=0.0), *texts)), rel=1e-9)


@pytest.mark.parametrize(("form", "factor"), [("30/π", 30 / np.pi), ("60", 60.0), ("1/2π", 0.5 / np.pi)])
def test_a_driver_s_speed_not_converted(form: str, factor: float):
    mechanism = library.load("ex3-5")
    found = values(led_to(mechanism, *ALL), "conversion", "given", ("AB",), form)
    assert found == pytest.approx(right(driven(mechanism, rate=10.0 * factor), *ALL), rel=1e-9)


def test_an_angle_measured_clockwise():
    mechanism = library.load("ex3-5")
    value = mechanism.drivers[0].value
    assert value is not None
    there = replay_all(plan(mechanism), [-value])
    found = values(led_to(mechanism, *ALL[:4]), "angle-clockwise")
    assert found == pytest.approx([getattr(there, text.split()[0])[text.split()[1]] for text in ALL[:4]], rel=1e-9)


def test_the_other_assembly():
    """As if the sketch had C on the other side of BD."""
    mechanism = library.load("ex3-5")
    plot = replay_all(plan(mechanism))
    b, c, d = (complex(plot.position[point]) for point in "BCD")
    mirrored = d + (b - d) * np.conj((c - d) / (b - d))
    other = replace(mechanism, sketch={"C": mirrored})
    found = values(led_to(mechanism, *ALL), "other-assembly", "", ("C",))
    assert found == pytest.approx(right(other, *ALL), rel=1e-9)


@pytest.mark.parametrize("seed", range(3))
def test_a_relative_rotation_taken_for_an_absolute_one(seed: int):
    mechanism = random_mechanisms.relative_angle(seed)
    (driver,) = [one for one in mechanism.drivers if one.from_link != "frame"]
    found = values(led_to(mechanism, f"omega {driver.link}", f"alpha {driver.link}"), "relative-as-absolute")
    assert found == pytest.approx([driver.rate, driver.acceleration])


# --- centres ------------------------------------------------------------------------------------


def test_a_centre_of_velocities_without_acceleration():
    """a_E = sqrt(alpha² + omega⁴) PE about P, where the lines AB and DC cross."""
    mechanism = library.load("ex3-5")
    exact = motion(mechanism)
    a, b, c, d, e = (complex(exact.position[point]) for point in "ABCDE")
    u, w = b - a, c - d
    place = a + u * cross(d - a, w) / cross(u, w)
    wrong = np.hypot(exact.alpha["2"], exact.omega["2"] ** 2) * abs(e - place)
    assert values(led_to(mechanism, "a E"), "centre-acceleration-zero", "", ("a E",), "P42") == pytest.approx([wrong])


def test_a_contact_without_acceleration():
    """A wheel that rolls on the ground: its contact has v = 0, and an acceleration towards its centre."""
    found = led_to(library.load("s4-ex2"), "omega 2", "alpha 2")
    assert [rewrite.of for (rewrite,) in found.columns if rewrite.name[:2] == ("centre-acceleration-zero", "point")] == [("a_K2",)]


def test_a_ratio_upside_down():
    """omega_1² / omega_3, where omega_3 / omega_1 is meant; the quotient itself inverted."""
    mechanism = library.load("ex3-5")
    found = led_to(mechanism, "omega 3", "omega 3 / omega 1")
    omega = right(mechanism, "omega 3")[0]
    assert values(found, "centre-ratio", "", ("omega 3",))[0] == pytest.approx(100 / omega)
    assert values(found, "centre-ratio", "sense", ("omega 3",))[0] == pytest.approx(-omega)
    assert values(found, "centre-ratio", "", ("omega 3/omega 1",))[1] == pytest.approx(10 / omega)


def test_lines_of_a_wrong_pair():
    """Of the lines AB, BC, CD and DA of a four-bar linkage: P24 for P13, and where AC and BD cross."""
    mechanism = library.load("p3-13")
    found = led_to(mechanism, "P13", "P24")
    place = {quantity.text: answer.vector for quantity, answer in zip(found.quantities, found.right, strict=True)}
    exact = motion(mechanism)
    a, b, c, d = (complex(exact.position[point]) for point in "ABCD")
    u, w = c - a, d - b
    diagonal = a + u * cross(b - a, w) / cross(u, w)
    rows = [row for row, (one,) in enumerate(found.columns) if one.id == "centre-ratio" and one.of == ("P13",)]
    places = [found.vectors[row, 0] for row in rows]
    assert sorted(places, key=abs) == pytest.approx(sorted([complex(place["P24"]), diagonal], key=abs))


# --- wheels, sliders, units ---------------------------------------------------------------------


def test_an_arm_that_is_ignored():
    """Gear 2 on the arm 4 beside gear 1: omega 2 = -10 * 30 / 20; gear 3 from it: omega 3 = -omega 2 * 20 / 25."""
    mechanism = library.load("p3-12")
    found = led_to(mechanism, "omega 2", "omega 3")
    omega_2 = right(mechanism, "omega 2")[0]
    arm = right(mechanism, "omega 5")[0]
    assert values(found, "arm-ignored", "", ("omega 2",)) == pytest.approx([-15.0, (15.0 * 20 + arm * 45) / 25])
    assert values(found, "arm-ignored", "", ("omega 3",))[1] == pytest.approx(-omega_2 * 20 / 25)
    assert values(found, "arm-ignored", "", ("omega 2", "omega 3")) == pytest.approx([-15.0, 12.0])


@pytest.mark.parametrize("seed", [1, 6, 11])
def test_an_arm_that_is_ignored_among_equations_solved_together(seed: int):
    """A planet on a coupler about a fixed sun, driven at the far rocker: without the arm's turning it turns as it does on
    the arm; the links still join, in velocities and in accelerations."""
    mechanism = random_mechanisms.geared_five_bar(seed)
    found = values(led_to(mechanism, "omega 1", "omega 2", "omega 3", "alpha 1", "alpha 2", "alpha 3"), "arm-ignored", "")
    exact = motion(mechanism)
    places = [complex(exact.position[_joining(mechanism, *pair)]) for pair in pairwise(("frame", *"1234", "frame"))]
    arms = dict(zip("1234", (head - tail for tail, head in pairwise(places)), strict=True))
    ratio = float(exact.omega["2"]) / float(exact.omega["1"]) - 1
    assert found[[1, 4]] == pytest.approx(ratio * found[[0, 3]])
    omega = {"1": found[0], "2": found[1], "3": found[2], "4": float(exact.omega["4"])}
    alpha = {"1": found[3], "2": found[4], "3": found[5], "4": float(exact.alpha["4"])}
    assert abs(sum(1j * omega[link] * arms[link] for link in "1234")) < 1e-9 * abs(omega["4"])
    parts = [(1j * alpha[link] - omega[link] ** 2) * arms[link] for link in "1234"]
    assert abs(sum(parts)) < 1e-9 * sum(map(abs, parts))


DRUM = """
frame = { O = [0, 0] }
links = { 1 = { OA = 90 }, 2 = { AB = 25 } }
roll = [{ wheel = "2", centre = "A", radius = 30, on = "frame", on_centre = "O", on_radius = 60 }]
driver = [{ vector = "OA", angle = 160, omega = -3 }]
pose = [{ vector = "AB", angle = 100 }]
"""


def test_an_arm_that_is_ignored_of_a_wheel_on_a_fixed_drum():
    """omega 2 = omega 1 * 60 / 30, and the rim with it; or of the other sense, as if the arm were the drum and its pivots
    fixed."""
    found = led_to(loading.loads(DRUM, name="drum"), "omega 2", "v B")
    arm, rim = 90 * np.exp(1j * np.radians(160)), 25 * np.exp(1j * np.radians(100))
    for way, omega in {"": -6.0, "fixed": 6.0}.items():
        assert values(found, "arm-ignored", way) == pytest.approx([omega, abs(-3 * arm + omega * rim) / 1000])


PLANETARY_TRAIN = """
ask = ["omega 2", "omega H"]
frame = { name = "3", O = [0, 0] }
links = { 1 = { points = ["O"] }, 2 = { points = ["P"] }, H = { OP = 36 } }
gear = [{ links = ["1", "2"], centres = ["O", "P"], radii = [20, 16] },
        { links = ["2", "frame"], centres = ["P", "O"], radii = [16, 52], internal = true }]
driver = [{ link = "1", omega = -15 }]
pose = [{ vector = "OP", angle = 40 }]
"""


def test_an_arm_that_is_ignored_where_the_points_of_contact_give_the_velocities():
    """The planet of a fixed ring as of a fixed arm: omega 2 = 15 * 20 / 16."""
    found = led_to(loading.loads(PLANETARY_TRAIN, name="train"), "omega 2", "omega H")
    assert values(found, "arm-ignored", "", ("omega 2",)) == pytest.approx([18.75, -15 * 20 / (2 * 36)])


RACK = """
frame = { O = [0, 0] }
[links]
1.OA = 40
2.AB = 130
3.points = ["B"]
4.points = ["R"]
[[slide]]
name = "rack"
block = "4"
point = "R"
guide = "frame"
through = [0, 25]
angle = 0
[[roll]]
wheel = "3"
centre = "B"
radius = 25
on = "frame"
through = [0, -25]
angle = 0
side = "left"
[[roll]]
wheel = "3"
centre = "B"
radius = 25
on = "4"
through = "R"
angle = 0
side = "right"
[[driver]]
vector = "OA"
angle = 125
omega = 12
[[pose]]
slide = "rack"
at = 100
[sketch]
B = [100, 0]
"""


def test_a_rack_taken_to_move_as_the_centre_of_its_pinion():
    """Which rolls on a fixed rack, too, so that the moving one is twice as fast."""
    asked = ("omega 3", "v B", "v R", "a B", "a R")
    found = led_to(loading.loads(RACK, name="rack"), *asked)
    omega, v_b, v_r, a_b, a_r = (abs(float(answer.value)) for answer in found.right)
    assert (v_r, a_r) == pytest.approx((2 * v_b, 2 * a_b))
    assert np.abs(values(found, "moves-as-centre")) == pytest.approx([omega, v_b, v_b, a_b, a_b])


def test_a_value_follows_where_a_wheel_rolls_on_racks():
    """The pinion between a driven rack and a fixed one: omega = v_R / d, v_B = omega r."""
    driven = 'slide = "rack"\nat = 100\nvelocity = "0.2 m/s"\n[[pose]]\nslide = "low"\nat = 100\n'
    text = re.sub(r"1.OA.*\n.*\n", "", RACK[: RACK.index('vector = "OA"')]).replace("[[roll]]", '[[roll]]\nname = "low"', 1)
    one = Marker(key_for(loading.loads(f'ask = ["omega 3", "v B"]\n{text}{driven}', name="racks")))
    (found,) = one.mark([StudentWork("s", {"omega 3": HandedNumber(-5.0), "v B": HandedNumber(0.125)})])
    assert [one.verdict for one in found.judged] == ["wrong", "carried"]


@pytest.mark.parametrize(("unit", "factor"), [("in", 39.37), ("cm", 100.0), ("mm", 1000.0)])
def test_answers_in_another_unit_of_length_are_one_mistake(unit: str, factor: float):
    text = library.load("ex3-5").text.replace("= 30", f'= "{30 * factor / 1000:.6f} {unit}"')
    one = Marker(key_for(loading.loads(text, name="inches")))
    right = {entry.text: entry.right for entry in one.key.entries if entry.points}
    given = {text: HandedNumber(value * (factor if text[0] in "va" and text[1] == " " else 1.0)) for text, value in right.items()}
    (found,) = one.mark([StudentWork("s", given)])
    assert {name[0][:2] for name in found.diagnosis.explanations[0].names} == {("conversion", "lengths")}
    assert [one.verdict for one in found.judged].count("wrong") == 1


def _joining(mechanism: Mechanism, first: str, second: str) -> str:
    return next(point for point in mechanism.links[first].points if point in mechanism.links[second].points)


@pytest.mark.parametrize("name", ["p3-23a", "p3-11a"])
def test_a_normal_term_at_the_slider(name: str):
    """n + s u = a_B + a^n_CB + alpha k × BC, where n is omega² l towards A."""
    mechanism = library.load(name)
    exact = motion(mechanism)
    a, b, c = (complex(exact.position[point]) for point in "ABC")
    rod, omega, u = c - b, float(exact.omega["2"]), 1.0 + 0j
    known = exact.acceleration_at("B", "1") - omega**2 * rod - omega**2 * abs(rod) * (a - c) / abs(a - c)
    _, alpha = np.linalg.solve([[u.real, -(1j * rod).real], [u.imag, -(1j * rod).imag]], [known.real, known.imag])
    assert values(led_to(mechanism, "alpha 2"), "slider-normal-term") == pytest.approx([alpha])


def test_factors_of_units_and_scales():
    """Each of one value, of all of a kind, and of a rotation that is carried on."""
    scales = {"length": 0.0005, "velocity": 0.005, "acceleration": 0.05}
    found = led_to(library.load("ex3-5"), "omega 2", "omega 3", "alpha 3", "v C", "a C", scales=scales)
    answers = np.array([answer.value for answer in found.right])
    for words, factors in {
        ("conversion", "", ("omega 2",), "30/π"): (30 / np.pi, 1, 1, 1, 1),
        ("conversion", "kind", ("rad/s",), "60"): (60, 60, 1, 1, 1),
        ("conversion", "lengths", ("m/s", "m/s^2"), "10³"): (1, 1, 1, 1e3, 1e3),
        ("conversion", "paper", ("m/s", "m/s^2"), "1/μ_v, 1/μ_a"): (1, 1, 1, 200, 20),
        ("conversion", "sense", ("alpha 3",)): (1, 1, -1, 1, 1),
        ("conversion", "", ("v C",), "10³"): (1, 1, 1, 1e3, 1),
        ("conversion", "", ("v C",), "1/μ_v"): (1, 1, 1, 200, 1),
        ("conversion", "", ("a C",), "μ_v/μ_a"): (1, 1, 1, 1, 0.1),
        ("conversion", "", ("omega 3",), "μ_l"): (1, 0.0005, 1, 1, 1),
        ("conversion", "", ("alpha 3",), "30/π"): (1, 1, 30 / np.pi, 1, 1),
    }.items():
        assert values(found, *words) == pytest.approx(answers * factors, rel=1e-12), words
    carried = values(found, "conversion", "carried", ("omega 2",), "2π")
    assert carried[0] == pytest.approx(2 * np.pi * answers[0])
    assert carried[2] != pytest.approx(answers[2], rel=0.1)
