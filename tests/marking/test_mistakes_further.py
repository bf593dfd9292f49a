"""Mistakes of drawing, of lengths, of units and with wheels, against what each means worked out by hand."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from every_family import FAMILIES

from graphkin import files as loading
from graphkin.analytic import motion
from graphkin.files import library
from graphkin.homework.grading import marking_of
from graphkin.marking import Consequences, consequences
from graphkin.marking.consequences import compare_drawings
from graphkin.marking.tolerances import drawings_of
from graphkin.model.mechanism import Mechanism
from graphkin.model.quantities import Quantity, read
from graphkin.planning import plan
from graphkin.running import replay_all


def led_to(mechanism: Mechanism, *texts: str) -> Consequences:
    quantities: list[Quantity] = [quantity for text in texts if (quantity := read(mechanism, text)) is not None]
    assert len(quantities) == len(texts)
    method = plan(mechanism)
    return consequences(method, replay_all(method), quantities)


def row_of(found: Consequences, *words: str | tuple[str, ...]) -> int:
    rows = [row for row, (rewrite,) in enumerate(found.columns) if rewrite.name[: len(words)] == words]
    assert len(rows) == 1, (words, [rewrite.name for (rewrite,) in found.columns if rewrite.id == words[0]])
    return rows[0]


def values(found: Consequences, *words: str | tuple[str, ...]) -> np.ndarray:
    """What the one rewrite of this id, way, arrow and form gives."""
    return found.values[row_of(found, *words)]


def right(mechanism: Mechanism, *texts: str) -> list[float]:
    """What is right for a mechanism, by the analysis."""
    exact = motion(mechanism)
    return [float(quantity.answer(exact).value) for text in texts if (quantity := read(mechanism, text)) is not None]


# --- example 3-1, by its two equations -----------------------------------------------------------

LEVER = ("omega 3", "v B3B2", "a_n B3D", "a_k B3B2", "alpha 3", "a_r B3B2")


@cache
def lever() -> Consequences:
    return led_to(library.load("ex3-1"), *LEVER)


def by_hand(
    v_crank: float = 1, a_crank: float = 1, omega: float = 1, normal: float = 1, coriolis: float = 1, alpha: float = 1,
    calculated: float | None = None,
) -> list[float]:  # fmt: skip
    """omega k × DB = v_B2 + v_r, alpha k × DB - omega² DB = a_B2 + 2 omega k × v_r + a_r, each so many times what is right
    where it is used; `calculated`: so much of the normal and the Coriolis acceleration is handed in, whatever is drawn."""
    exact = motion(library.load("ex3-1"))
    a, b, c, d = (complex(exact.position[point]) for point in "ABCD")
    guide, arm, spin = (c - b) / abs(c - b), b - d, float(exact.omega["1"])

    def parts(known: complex) -> tuple[float, float]:
        """x and y of x k × DB - y guide = known."""
        columns = (1j * arm, -guide)
        found = np.linalg.solve([[z.real for z in columns], [z.imag for z in columns]], [known.real, known.imag])
        return float(found[0]), float(found[1])

    turning, sliding = parts(v_crank * 1j * spin * (b - a))
    turning *= omega
    a_n, a_k = -(turning**2) * arm, 2j * turning * sliding * guide
    tangential, a_r = parts(a_crank * -(spin**2) * (b - a) + coriolis * a_k - normal * a_n)
    of_n, of_k = (normal, coriolis) if calculated is None else (calculated, calculated)
    return [turning, abs(sliding), abs(of_n * a_n), abs(of_k * a_k), alpha * tangential, abs(a_r)]


@pytest.mark.parametrize(("words", "factors"), [
    (("coriolis-not-laid-off", "", ("a^k_B3B2",)), {"coriolis": 0, "calculated": 1}),
    (("coriolis-omitted", "", ("a^k_B3B2",)), {"coriolis": 0}),
    (("coriolis-reversed", "", ("a^k_B3B2",)), {"coriolis": -1}),
    (("normal-not-laid-off", "", ("a^n_B3D",)), {"normal": 0, "calculated": 1}),
    (("normal-not-laid-off", "", ("a_B2",)), {"a_crank": 0}),
    (("normal-doubled", "", ("a^n_B3D",)), {"normal": 2}),
    (("normal-doubled", "", ("a_B2",)), {"a_crank": 2}),
    (("diameter-for-radius", "", ("omega 3",), "2 l_BD"), {"omega": 0.5}),
    (("diameter-for-radius", "", ("omega 3",), "l_BD/2"), {"omega": 2}),
    (("diameter-for-radius", "", ("alpha 3",), "2 l_BD"), {"alpha": 0.5}),
    (("diameter-for-radius", "", ("alpha 3",), "l_BD/2"), {"alpha": 2}),
    (("diameter-for-radius", "", ("v_B2",), "2 l_AB"), {"v_crank": 2}),
    (("diameter-for-radius", "", ("v_B2", "a_B2"), "l_AB/2"), {"v_crank": 0.5, "a_crank": 0.5}),
    (("diameter-for-radius", "", ("a_B2",), "2 l_AB"), {"a_crank": 2}),
    (("diameter-for-radius", "", ("a^n_B3D",), "l_BD/2"), {"normal": 0.5}),
    (("degrees-for-radians", "carried", ("omega 3",), "180/π"), {"omega": 180 / np.pi}),
    (("decimal-slip", "carried", ("omega 3",), "1/10"), {"omega": 0.1}),
    (("decimal-slip", "carried", ("alpha 3",), "10"), {"alpha": 10}),
])  # fmt: skip
def test_what_follows_in_a_lever(words: tuple[str, ...], factors: dict[str, float]):
    found = values(lever(), *words)
    assert np.abs(found) == pytest.approx(np.abs(by_hand(**factors)), rel=1e-9, abs=1e-12)
    assert np.sign(found[[0, 4]]) == pytest.approx(np.sign(np.array(by_hand(**factors))[[0, 4]]))


def test_what_is_not_laid_off_is_seen_beside_the_right_drawing():
    found = lever()
    method = plan(library.load("ex3-1"))
    shown = compare_drawings(method, replay_all(method), found.columns[row_of(found, "coriolis-not-laid-off")])
    assert shown.planes == ("acceleration",)
    assert shown.arrows == {"velocity": frozenset(), "acceleration": frozenset({frozenset({"b2'", "k'"})})}


# --- what is written down ------------------------------------------------------------------------


def test_answers_as_they_are_written_down():
    """Only what the problem asks for is exchanged or has its decimal point elsewhere."""
    mechanism = library.load("ex3-5")
    texts = (*mechanism.ask, "v C")
    found = led_to(mechanism, *texts)
    answers = {quantity.text: answer.value for quantity, answer in zip(found.quantities, found.right, strict=True)}
    degree = 180 / np.pi
    for words, changed in {
        ("answers-swapped", "", ("omega 2",), "omega 3"): {"omega 2": answers["omega 3"], "omega 3": answers["omega 2"]},
        ("answers-swapped", "", ("alpha 2",), "alpha 3"): {"alpha 2": answers["alpha 3"], "alpha 3": answers["alpha 2"]},
        ("decimal-slip", "", ("a E",), "1/10"): {"a E": answers["a E"] / 10},
        ("decimal-slip", "", ("alpha 2",), "10"): {"alpha 2": answers["alpha 2"] * 10},
        ("degrees-for-radians", "", ("ω", "α"), "180/π"): {t: answers[t] * degree for t in texts if t[:2] in ("om", "al")},
        ("degrees-for-radians", "", ("α",), "π/180"): {t: answers[t] / degree for t in texts if t[:2] == "al"},
        ("degrees-for-radians", "", ("omega 3",), "180/π"): {"omega 3": answers["omega 3"] * degree},
        ("sense-not-given",): {"omega 2": -answers["omega 2"]},
    }.items():  # fmt: skip
        expected = [changed.get(text, answers[text]) for text in texts]
        assert values(found, *words) == pytest.approx(expected, rel=1e-12), words
    of = {(rewrite.of, rewrite.form) for (rewrite,) in found.columns if rewrite.id in ("answers-swapped", "decimal-slip")}
    assert not any("v C" in each for each in of)
    assert not of & {("v E", "a E"), ("theta 2", "10")}
    assert not any(rewrite.form.endswith("180/π") for (rewrite,) in found.columns if rewrite.id == "conversion")


def test_exchanged_answers_are_vectors_and_scatter_as_the_other_does():
    mechanism = replace(library.load("ex3-5"), ask=("v C", "v E", "omega 2"))
    method = plan(mechanism)
    found = led_to(mechanism, *mechanism.ask)
    row = row_of(found, "answers-swapped")
    assert found.vectors[row, :2] == pytest.approx([found.right[1].vector, found.right[0].vector])
    drawings = drawings_of(method, marking_of(method), 50)
    plain, swapped = drawings.values(found.quantities, [(), found.columns[row]])
    assert np.array_equal(swapped, plain[:, [1, 0, 2]])


def test_without_senses_all_are_one_row():
    found = led_to(library.load("ex3-1"), "omega 3", "omega 2", "alpha 3", "omega 3 / omega 1", "v B3")
    assert values(found, "sense-not-given") == pytest.approx([abs(float(answer.value)) for answer in found.right])
    assert not [one for (one,) in led_to(library.load("ex3-1"), "alpha 3").columns if one.id == "sense-not-given"]


# --- drivers ------------------------------------------------------------------------------------


def test_one_of_two_drivers_reversed():
    mechanism, texts = library.load("s4-ex6"), ("v C", "a C", "omega 2", "alpha 2")
    found = led_to(mechanism, *texts)
    for k, driver in enumerate(mechanism.drivers):
        drivers = [replace(one, rate=-one.rate) if n == k else one for n, one in enumerate(mechanism.drivers)]
        expected = right(replace(mechanism, drivers=tuple(drivers)), *texts)
        assert values(found, "driver-reversed-one", "", (driver.name,)) == pytest.approx(expected, rel=1e-9, abs=1e-9)
    assert [one.way for (one,) in found.columns if one.id == "driver-reversed"] == ["all"]
    assert not [one for (one,) in lever().columns if one.id == "driver-reversed-one"]


def test_a_driver_s_acceleration_reversed():
    mechanism, texts = library.load("s3-four"), ("omega 3", "alpha 2", "alpha 3", "a C")
    (driver,) = mechanism.drivers
    expected = right(replace(mechanism, drivers=(replace(driver, acceleration=-driver.acceleration),)), *texts)
    found = values(led_to(mechanism, *texts), "driver-acceleration-reversed")
    assert found == pytest.approx(expected, rel=1e-9)
    assert driver.acceleration


# --- wheels -------------------------------------------------------------------------------------

GEARS = """
ask = ["omega 2", "alpha 2", "v E", "a E", "a_n EP"]
frame = { name = "3", O = [0, 0], P = [36, 0] }
links = { 1 = { OF = 20 }, 2 = { PE = 16 } }
gear = [{ links = ["1", "2"], centres = ["O", "P"], radii = [20, 16] }]
driver = [{ vector = "OF", angle = 20, omega = -15, alpha = 10 }]
pose = [{ vector = "PE", angle = 100 }]
"""
TRAIN = """
ask = ["omega 2", "alpha 2", "omega H", "alpha H", "v E", "a E"]
frame = { name = "3", O = [0, 0] }
links = { 1 = { points = ["O"] }, 2 = { PE = 16 }, H = { OP = 36 } }
gear = [{ links = ["1", "2"], centres = ["O", "P"], radii = [20, 16] },
        { links = ["2", "frame"], centres = ["P", "O"], radii = [16, 52], internal = true }]
pose = [{ vector = "PE", angle = 100 }, { vector = "OP", angle = 40 }]
"""
BY_THE_SUN = TRAIN + 'driver = [{ link = "1", omega = -15, alpha = 10 }]'
BY_THE_ARM = TRAIN.replace("omega H", "omega 1").replace("alpha H", "alpha 1").replace(
    ', { vector = "OP", angle = 40 }', "") + 'driver = [{ vector = "OP", angle = 40, omega = -15, alpha = 10 }]'  # fmt: skip
ROLLING = """
ask = ["a_n EB", "a E", "alpha 2"]
links = { 1 = { AB = 100 }, 2 = { BE = 20 } }
slide = [{ pin = "A", guide = "frame", through = [0, 0], angle = 90, name = "wall" }]
roll = [{ wheel = "2", centre = "B", radius = 20, on = "frame", through = [0, 0], angle = 0 }]
driver = [{ slide = "wall", at = 60, velocity = 0.2, acceleration = 0.1 }]
pose = [{ vector = "BE", angle = 30 }]
sketch = { A = [0, 60], B = [80, 20] }
"""


def made_of(text: str) -> Consequences:
    mechanism = loading.loads(text, name="wheels")
    return led_to(mechanism, *mechanism.ask)


@pytest.mark.parametrize(("way", "ratio"), [("radii", -16 / 20), ("meshing", 20 / 16)])
def test_a_ratio_of_two_gears(way: str, ratio: float):
    """And the rim of the second turns so: v = omega r, a = r sqrt(alpha² + omega⁴)."""
    omega, alpha = -15 * ratio, 10 * ratio
    expected = [omega, alpha, abs(omega) * 0.016, 0.016 * np.hypot(alpha, omega**2), 0.016 * omega**2]
    assert values(made_of(GEARS), "centre-ratio", way, ("omega 2",), "1, 2") == pytest.approx(expected)


@pytest.mark.parametrize(("way", "contact", "planet", "arm"), [
    # of the sun's omega; right: planet -2.25 arm, arm 20/72 sun. 16 (1 - h) + 20 (p - h) = 0, 4 p = -9 h
    ("radii", "1, 2", -2.25 * 16 / 81, 16 / 81),
    # 20 (1 - h) - 16 (p - h) = 0, 4 p = -9 h
    ("meshing", "1, 2", 2.25 * 20 / 32, -20 / 32),
    # 20 (1 - h) + 16 (p - h) = 0, 13 p = 9 h
    ("radii", "2, 3", 20 / (36 * 13 / 9 - 16), 20 / (36 - 16 * 9 / 13)),
    # 20 (1 - h) + 16 (p - h) = 0, 4 p = 17 h
    ("meshing", "2, 3", -20 / (16 - 36 * 4 / 17), -20 / (16 * 17 / 4 - 36)),
])  # fmt: skip
def test_ratios_in_a_train_whose_contacts_hold_together(way: str, contact: str, planet: float, arm: float):
    p, p_alpha, h, h_alpha, v_e, a_e = values(made_of(BY_THE_SUN), "centre-ratio", way, ("omega 2",), contact)
    assert [p, h] == pytest.approx([-15 * planet, -15 * arm])
    assert [p_alpha, h_alpha] == pytest.approx([10 * planet, 10 * arm])
    assert [v_e, a_e] == pytest.approx(rim_of_the_planet(p, p_alpha, h, h_alpha))


def rim_of_the_planet(p: float, p_alpha: float, h: float, h_alpha: float) -> list[float]:
    """v_E and a_E, E about P and P about O."""
    arm, rim = 0.036 * np.exp(1j * np.radians(40)), 0.016 * np.exp(1j * np.radians(100))
    return [abs(h * arm + p * rim), abs((1j * h_alpha - h**2) * arm + (1j * p_alpha - p**2) * rim)]


def test_a_ratio_in_a_train_is_carried_on():
    """The ring's: 52 (p - 1) = 16 of the arm's, and the sun by that; the rim by its own rotation about the arm's end."""
    planet, sun = 1 - 16 / 52, 1 + 16 / 20 * 16 / 52
    found = values(made_of(BY_THE_ARM), "centre-ratio", "radii", ("omega 2",), "2, 3")
    assert found[:4] == pytest.approx([-15 * planet, 10 * planet, -15 * sun, 10 * sun])
    assert found[4:] == pytest.approx(rim_of_the_planet(-15 * planet, 10 * planet, -15, 10))
    found = values(made_of(BY_THE_ARM), "centre-ratio", "meshing", ("omega 1",), "1, 2")
    assert found[:4] == pytest.approx([15 * 2.25, -10 * 2.25, -15 * (1 - 0.8 * 3.25), 10 * (1 - 0.8 * 3.25)])


@pytest.mark.parametrize(("words", "drawn", "handed_in"), [
    (("normal-omitted", ""), 0.0, 0.0), (("normal-outward", ""), -1.0, 1.0), (("normal-doubled", ""), 2.0, 2.0),
    (("normal-not-laid-off", ""), 0.0, 1.0), (("diameter-for-radius", ""), 2.0, 2.0),
    (("normal-size", "", ("a^n_EB",), "ω2²"), 50.0, 50.0),
])  # fmt: skip
def test_the_normal_acceleration_of_a_rim(words: tuple[str, ...], drawn: float, handed_in: float):
    """a_E = a_B + alpha k × BE - omega² BE of a wheel that rolls, in so many parts of the last."""
    mechanism = loading.loads(ROLLING, name="wheels")
    exact = motion(mechanism)
    rim = complex(exact.position["E"] - exact.position["B"])
    omega, alpha = float(exact.omega["2"]), float(exact.alpha["2"])
    rest = complex(exact.acceleration_at("B", "2")) + 1j * alpha * rim
    found = values(made_of(ROLLING), *words[:2], ("a^n_EB",), *words[3:] or ("2 l_BE",) * (words[0][0] == "d"))
    assert found == pytest.approx([handed_in * omega**2 * abs(rim), abs(rest - drawn * omega**2 * rim), alpha])


# --- terms that no arrow shows --------------------------------------------------------------------


def test_a_coriolis_term_among_equations_solved_together_is_handed_in_as_it_was_made():
    mechanism = FAMILIES["rack_in_a_slot"](0)
    found = led_to(mechanism, "a_k O7O2", "alpha 2")
    a_k, alpha = (float(answer.value) for answer in found.right)
    by_id = {one.id: row for (one,), row in zip(found.columns, found.values, strict=True) if one.of[0].startswith("a^k")}
    assert by_id["coriolis-omitted"][0] == 0.0
    assert by_id["coriolis-reversed"][0] == by_id["coriolis-not-laid-off"][0] == pytest.approx(a_k)
    assert by_id["coriolis-half"][0] == pytest.approx(a_k / 2)
    without = by_id["coriolis-omitted"][1]
    assert by_id["coriolis-not-laid-off"][1] == pytest.approx(without)
    assert by_id["coriolis-reversed"][1] == pytest.approx(2 * without - alpha)
    assert abs(without - alpha) > 0.1
