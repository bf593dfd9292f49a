"""What is asked, handed in under another name that means the same."""

from __future__ import annotations

import pytest

from graphkin import files as loading
from graphkin.homework.grading import key_for
from graphkin.marking.marker import Marker
from graphkin.marking.records import HandedNumber, StudentWork

GUIDE_BESIDE_ITS_PIVOT = """
ask = ["omega 3", "alpha 3", "a_k B3B2", "v B3B2"]
frame = { name = "4", A = [0, 0], D = [80, 10] }
links = { 1 = { AB = 30 }, 2 = { points = ["B"] }, 3 = { DF = 15 } }
slide = [{ block = "2", point = "B", guide = "3", through = "F", from = "DF", angle = 90 }]
driver = [{ vector = "AB", angle = 110, omega = -8 }]
sketch = { F = [85, 24] }
"""
PIN_IN_A_SLOT = """
ask = ["omega 3", "a_k B1B3", "v B1B3"]
frame = { name = "4", A = [0, 0], D = [0, -90] }
links = { 1 = { AB = 35 }, 3 = { DC = 160 } }
slide = [{ pin = "B", guide = "3", through = "D", toward = "C" }]
driver = [{ vector = "AB", angle = 30, omega = -6 }]
sketch = { C = [40, 60] }
"""


def verdicts(text: str, **numbers: float) -> dict[str, str]:
    work = StudentWork("s1", {name.replace("__", " "): HandedNumber(value) for name, value in numbers.items()})
    [marked] = Marker(key_for(loading.loads(text, name="it"))).mark([work])
    return {one.text: one.verdict for one in marked.judged}


@pytest.mark.parametrize("numbers", [
    {"omega__2": -0.99, "alpha__2": 14.9, "a_k__B2B3": 0.411, "v__B2B3": 0.208},
    {"omega__3": -0.99, "alpha__2": 14.9, "a_k__F3F2": 0.411, "v__F2F3": 0.208},
])  # fmt: skip
def test_another_name_of_the_same_answers_what_is_asked(numbers):
    found = verdicts(GUIDE_BESIDE_ITS_PIVOT, **numbers)
    assert found == dict.fromkeys(["omega 3", "alpha 3", "a_k B3B2", "v B3B2"], "right")


def test_what_stands_for_it_may_be_wrong_and_what_is_asked_for_comes_first():
    assert verdicts(GUIDE_BESIDE_ITS_PIVOT, v__B2B3=0.3)["v B3B2"] == "wrong"
    both = verdicts(GUIDE_BESIDE_ITS_PIVOT, v__B2B3=0.208, v__B3B2=0.3)
    assert (both["v B3B2"], both["v B2B3"]) == ("wrong", "right")


def test_a_pin_takes_the_rotation_of_its_slot_either_way_round():
    """The Coriolis acceleration of a pin in a slot takes the slot's rotation, as the construction writes it."""
    found = verdicts(PIN_IN_A_SLOT, a_k__B3B1=0.395, v__B3B1=0.1465, omega__1=-1.347)
    assert (found["a_k B1B3"], found["v B1B3"]) == ("right", "right")
    assert found["omega 3"] == "missing"
