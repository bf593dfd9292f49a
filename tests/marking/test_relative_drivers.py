"""Joints that are driven against a moving link: what the file gives stays, whatever a student has of his own after it."""

from __future__ import annotations

import cmath
import math

import pytest

from graphkin import files as loading
from graphkin.homework.grading import key_for
from graphkin.marking.marker import Marker
from graphkin.marking.records import HandedNumber, Marked, StudentWork

MANIPULATOR = """
ask = ["omega 2", "alpha 2", "v C", "a C"]
frame = { A = [0, 0] }
links = { 1 = { AB = 400 }, 2 = { BC = 300 } }
driver = [{ vector = "AB", angle = 35, omega = 1.5, alpha = 2 },
          { vector = "BC", from = "AB", angle = 70, omega = -2.5, alpha = 1 }]
"""
THREE_JOINTS = """
ask = ["omega 2", "omega 3", "v D"]
frame = { A = [0, 0] }
links = { 1 = { AB = 400 }, 2 = { BC = 300 }, 3 = { CD = 200 } }
driver = [{ vector = "AB", angle = 35, omega = 1.5 }, { vector = "BC", from = "AB", angle = 70, omega = -4 },
          { vector = "CD", from = "BC", angle = 40, omega = 0.7 }]
"""
AB, BC, CD = (length * cmath.exp(1j * math.radians(angle)) for length, angle in ((0.4, 35), (0.3, 105), (0.2, 145)))


def handed_in(omega: float, alpha: float, tangential: float = 1.0) -> dict[str, complex]:
    """The manipulator with an own rotation of link 2, and so many times the tangential acceleration of B."""
    a = (2j * tangential - 1.5**2) * AB + (1j * alpha - omega**2) * BC
    return {"omega 2": omega, "alpha 2": alpha, "v C": 1.5j * AB + 1j * omega * BC, "a C": a}


def marked(text: str, values: dict[str, complex]) -> Marked:
    numbers = {
        name: HandedNumber(abs(value), vector=value) if isinstance(value, complex) else HandedNumber(value)
        for name, value in values.items()
    }
    [found] = Marker(key_for(loading.loads(text, name="it"))).mark([StudentWork("s", numbers)])
    return found


def verdicts(found: Marked) -> dict[str, str]:
    return {one.text: one.verdict for one in found.judged}


def names(found: Marked) -> list[tuple[str, str]]:
    return [name[:2] for one in found.diagnosis.explanations for each in one.names for name in each]


@pytest.mark.parametrize("omega", [-3.0, 0.4, 2.0])
def test_the_given_rotation_stays_beside_an_own_one(omega: float):
    """2 rad/s is no copy of the 2 rad/s² that are given, either."""
    found = marked(MANIPULATOR, handed_in(omega, 3.0))
    assert verdicts(found) == {"omega 2": "wrong", "alpha 2": "right", "v C": "carried", "a C": "carried"}
    assert found.score == pytest.approx(3 / 4)


def test_a_link_that_is_driven_against_one_with_an_own_rotation_follows():
    omega_2 = -1.7
    values = {"omega 2": omega_2, "omega 3": omega_2 + 0.7}
    speed = 1.5j * AB + 1j * omega_2 * BC + 1j * (omega_2 + 0.7) * CD
    assert verdicts(marked(THREE_JOINTS, {**values, "v D": speed})) == {"omega 2": "wrong", "omega 3": "carried", "v D": "carried"}


@pytest.mark.parametrize(("omega", "alpha", "way"), [(-2.5, 1.0, ""), (-4.0, -1.0, "difference")])
def test_a_relative_rotation_taken_for_the_sum_or_less_that_of_what_carries_it(omega: float, alpha: float, way: str):
    found = marked(MANIPULATOR, handed_in(omega, alpha))
    assert names(found) == [("relative-as-absolute", way)]
    assert verdicts(found) == {"omega 2": "wrong", "alpha 2": "carried", "v C": "carried", "a C": "carried"}


def test_links_driven_against_one_whose_relative_rotation_was_taken_for_its_own():
    values = {"omega 2": -4.0, "omega 3": -3.3, "v D": 1.5j * AB - 4j * BC - 3.3j * CD}
    found = marked(THREE_JOINTS, values)
    assert names(found) == [("relative-as-absolute", "")]
    assert verdicts(found) == {"omega 2": "wrong", "omega 3": "carried", "v D": "carried"}


def test_a_tangential_acceleration_left_out_though_alpha_is_right():
    assert names(marked(MANIPULATOR, handed_in(-1.0, 3.0, tangential=0.0))) == [("tangential-omitted", "")]


def test_centres_give_no_ratio_of_rotations_that_two_drivers_change():
    key = key_for(loading.loads(MANIPULATOR, name="it"))
    assert "centre-ratio" not in {row[0][0] for row in key.singles.names}
    assert ("conversion", "sense", ("omega 2",), "") in {row[0] for row in key.singles.names}


@pytest.mark.parametrize(("angle", "named"), [(188.0, True), (20.0, True), (214.2, False), (95.0, False)])
def test_an_arrow_points_as_a_mistake_has_it_or_just_the_other_way(angle: float, named: bool):
    """With omega 1² l_BC for omega 1² l_AB the acceleration of C is 1.821 at 188°."""
    values = {**handed_in(-1.0, 3.0), "a C": 1.821 * cmath.exp(1j * math.radians(angle))}
    assert (("normal-size", "") in names(marked(MANIPULATOR, values))) == named
