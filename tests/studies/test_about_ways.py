"""The three ways to find a pole from two velocities, and what is refused."""

from __future__ import annotations

import cmath
import math
import random

import pytest
from calculator import hold

from graphkin.errors import UnknownUnit
from graphkin.errors.studies import BadVelocities, NotOneBody, OnePlace
from graphkin.say.centre_about import pole_words
from graphkin.studies.centres.two_velocities import from_text, pole_of

CASES = [  # text, case, pole [mm], omega
    ("A 0,0 1,0.5; B 100,0 1,-0.2", "meet", 500 / 7 - 1000j / 7, -7),
    ("A 0,0 0,0.5; B 100,0 0,-0.2", "similar", 500 / 7, -7),
    ("A 0,0 0,0.5; B 100,0 0,0.2", "similar", 500 / 3, -3),
    ("A 0,0 1,2; B 100,0 1,2", "infinity", math.inf, 0),
    ("A 0,0 0,0; B' 10cm,0 0,1000 mm/s".replace("1000 mm/s", "1000mm/s"), "point", 0, 10),
    ("O1 1in,0 0,0 ； D 5.08cm,0 0,3.6km/h", "point", 25.4, 1 / 0.0254),
]


@pytest.mark.parametrize(("text", "case", "place", "omega"), CASES)
def test_each_way(text: str, case: str, place: complex, omega: float):
    found = from_text(text)
    assert found.case == case
    assert found.omega == pytest.approx(omega, abs=1e-12)
    assert cmath.isinf(found.place) if cmath.isinf(place) else abs(1e3 * found.place - place) < 1e-9


@pytest.mark.parametrize(("case", "en", "zh"), [
    ("meet", "perpendic", "垂线的交点"), ("similar", "similar triangles", "相似三角形"), ("infinity", "translation", "瞬时平动"),
    ("point", "itself", "即为瞬心"),
])  # fmt: skip
def test_words_tell_the_construction(case: str, en: str, zh: str):
    found = from_text(next(entry[0] for entry in CASES if entry[1] == case))
    texts = {lang: " ".join(pole_words(found, lang)) for lang in ("en", "zh")}
    assert en in texts["en"] or (case == "meet" and "across v_A" in texts["en"])
    assert zh in texts["zh"]
    assert not any("{" in text or "nan" in text or "inf " in text for text in texts.values())


def test_words_hold_figures_that_fit():
    """omega = v / arm, from the printed figures."""
    assert all(hold(pole_words(from_text(case[0]), "en")) == 1 for case in CASES[:1])


def test_rest():
    found = from_text("A 0,0 0,0; B 10,0 0,0")
    assert found.case == "rest"
    assert cmath.isnan(found.place)
    assert "stand" in pole_words(found, "en")[-1]


@pytest.mark.parametrize("seed", range(40))
def test_any_rigid_body(seed: int):
    """Turned anyhow, at any size, the pole is where the body was made to turn."""
    rng = random.Random(seed)
    size = 10 ** rng.uniform(-4, 3)
    pole, a, b = (size * complex(rng.uniform(-1, 1), rng.uniform(-1, 1)) for _ in range(3))
    omega = rng.choice((-1, 1)) * 10 ** rng.uniform(-3, 3)
    found = pole_of((a, b), (1j * omega * (a - pole), 1j * omega * (b - pole)))
    assert abs(found.place - pole) < 1e-9 * size
    assert found.omega == pytest.approx(omega, rel=1e-9)


@pytest.mark.parametrize("turn", [0, 30, 90, 200])
def test_direction_of_a_pole_at_infinity(turn: float):
    velocity = cmath.rect(2, math.radians(turn))
    found = pole_of((0, 0.3j), (velocity, velocity))
    assert found.direction is not None
    assert abs((cmath.rect(1, found.direction) * velocity.conjugate()).real) < 1e-12
    assert -math.pi / 2 < found.direction <= math.pi / 2


def test_not_one_body():
    with pytest.raises(NotOneBody) as raised:
        from_text("A 0,0 1,0; B 100,0 2,0.3")
    assert (raised.value.one, raised.value.other) == (1, 2)
    for lang in ("en", "zh"):
        assert "1 m/s" in raised.value.message(lang)
        assert "2 m/s" in raised.value.message(lang)


@pytest.mark.parametrize(("text", "error"), [
    ("", BadVelocities), ("A 0,0 1,0", BadVelocities), ("A 0 0 1 0; B 1 1 1 1", BadVelocities),
    ("A 0,0 1,0; A 1,0 1,0", BadVelocities), ("A 0,0 1,0; B 0,0 1,0", OnePlace), ("A 0,0 1,0; B 1kg,0 1,0", UnknownUnit),
    ("A 0,0 1,0; B 1,0 1,0; C 2,0 1,0", BadVelocities),
])  # fmt: skip
def test_what_is_no_pair_of_velocities(text: str, error: type[Exception]):
    with pytest.raises(error) as raised:
        from_text(text)
    assert "--velocities" in str(raised.value)
