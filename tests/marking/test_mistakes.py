"""Mistakes as rewrites: every consequence as a student measures it, to the digits in which a teacher would print it."""

from __future__ import annotations

from functools import cache, partial

import numpy as np
import pytest

from graphkin import files as loading
from graphkin.analytic import motion
from graphkin.base.geometry import Value
from graphkin.files import library
from graphkin.marking import (
    MISTAKES,
    Consequences,
    PolygonHand,
    Redrawing,
    Rewrite,
    arrows_of,
    combined,
    consequences,
    drawn_answer,
    other_methods,
    other_ways,
    redraw,
    replay_with,
    rewrites,
    rewritten,
)
from graphkin.marking.diagnosis import SLIP
from graphkin.model.quantities import Moving, Quantity, read
from graphkin.planning import Method, plan
from graphkin.proof.readings import readings
from graphkin.running import replay_all
from graphkin.say.marks import mistake
from graphkin.say.phrases.marking import PHRASES

ASKED = {
    "ex3-1": ("omega 2", "omega 3", "v B3", "v B3B2", "a B2", "a_n B3D", "a_t B3D", "a_k B3B2", "a_r B3B2", "a B3",
              "alpha 2", "alpha 3"),
    "ex3-5": ("omega 2", "omega 3", "v C", "v CB", "v E", "a_n CB", "a_n CD", "alpha 2", "alpha 3", "a E"),
    "ex3-7": ("omega 3", "omega 4", "v D", "v E", "a D", "a E", "alpha 3", "alpha 4"),
}  # fmt: skip


@cache
def led_to(name: str) -> Consequences:
    method, quantities = prepared(name)
    return consequences(method, replay_all(method), quantities)


def prepared(name: str, *texts: str) -> tuple[Method, list[Quantity]]:
    mechanism = library.load(name)
    found = [read(mechanism, text) for text in texts or ASKED[name]]
    return plan(mechanism), [quantity for quantity in found if quantity is not None]


def row_of(name: str, *words: str | tuple[str, ...]) -> int:
    """The one column whose id, way, arrow and form are these (or begin with them)."""
    rows = [k for k, (rewrite,) in enumerate(led_to(name).columns) if rewrite.name[: len(words)] == words]
    assert len(rows) == 1, (words, [led_to(name).columns[k][0].name for k in rows])
    return rows[0]


def value(name: str, row: int, text: str) -> float:
    k = [quantity.text for quantity in led_to(name).quantities].index(text)
    return float(led_to(name).values[row, k])


RIGHT = [
    ("ex3-1", {"omega 3": "-3.919", "v B3B2": "0.3208", "a_k B3B2": "2.515", "alpha 3": "62.22", "a_r B3B2": "0.185"}),
    ("ex3-5", {"omega 2": "-2.624", "omega 3": "2.853", "alpha 2": "35.06", "alpha 3": "52.45", "v E": "0.1943",
               "a E": "3.542"}),
    ("ex3-7", {"v D": "0.1027"}),
]  # fmt: skip

TABLE = [
    ("ex3-1", ("driver-reversed", "", ("AB",)), {"omega 3": "3.919", "v B3B2": "0.3208", "alpha 3": "62.22"}),
    ("ex3-1", ("driver-along-crank", ""), {"omega 3": "-2.683", "v B3B2": "0.0712", "a_k B3B2": "0.382", "alpha 3": "12.5"}),
    ("ex3-1", ("driver-along-crank", "back"), {"omega 3": "2.683", "v B3B2": "0.0712", "a_k B3B2": "0.382", "alpha 3": "12.5"}),
    ("ex3-5", ("velocity-along-link", "", ("v_CB",)), {"omega 3": "9.997", "omega 2": "nan", "alpha 3": "nan"}),
    ("ex3-1", ("wrong-radius", "", ("v_B3",), "⊥CD"), {"omega 3": "16.48", "a_k B3B2": "32.56", "alpha 3": "417.0"}),
    ("ex3-1", ("wrong-radius", "", ("v_B3",), "⊥BC"), {"omega 3": "-2.862", "a_k B3B2": "0.776", "alpha 3": "34.52"}),
    ("ex3-1", ("sliding-across",), {"omega 3": "2.868", "a_k B3B2": "1.97", "alpha 3": "19.1"}),
    ("ex3-1", ("orthogonal-split", ""), {"v B3B2": "0.1356", "omega 3": "-2.862"}),
    ("ex3-1", ("orthogonal-split", "length", ("v_B3",), "l_BC"), {"v B3B2": "0.1356", "omega 3": "-3.364"}),
    ("ex3-5", ("absolute-for-relative", "", ("omega 2",), "v_C/l_BC"),
     {"omega 2": "-2.445", "alpha 2": "34.63", "alpha 3": "51.28"}),
    ("ex3-1", ("wrong-length", "", ("omega 3",), "l_CD"), {"omega 3": "-5.650", "a_k B3B2": "3.625", "alpha 3": "68.7"}),
    ("ex3-1", ("wrong-length", "", ("omega 3",), "l_BC"), {"omega 3": "-4.607", "alpha 3": "65.5"}),
    ("ex3-1", ("sliding-as-turning",), {"omega 3": "-5.450", "a_k B3B2": "3.50", "alpha 3": "68.2"}),
    ("ex3-1", ("omega-sense",), {"omega 3": "3.919", "alpha 3": "-37.3", "a_r B3B2": "4.52"}),
    ("ex3-1", ("block-omega", "", ("a^k_B3B2",), "0"), {"omega 2": "0.0", "alpha 3": "12.46", "a_r B3B2": "2.168"}),
    ("ex3-1", ("block-omega", "", ("a^k_B3B2",), "ω1"), {"omega 2": "10.0", "a_k B3B2": "6.417", "alpha 3": "-114.5"}),
    ("ex3-1", ("block-omega", "", ("a^k_B3B2",), "±ω1"), {"omega 2": "-10.0", "alpha 3": "139.4"}),
    ("ex3-1", ("block-omega", "", ("a^k_B3B2",), "v_B2/l_BD"), {"alpha 3": "56.50"}),
    ("ex3-5", ("image-mirrored", "", ("△BCE",), "v, a"), {"v E": "0.2650", "a E": "2.118"}),
    ("ex3-5", ("image-mirrored", "swapped", ("△BCE",), "v, a"), {"v E": "0.2650", "a E": "2.118"}),
    ("ex3-7", ("image-wrong-point", "", ("△CBD",), "v"), {"v D": "0.2483"}),
    ("ex3-1", ("normal-omitted", "", ("a^n_B3D",)), {"alpha 3": "76.6"}),
    ("ex3-5", ("normal-omitted", "", ("a^n_CB",)), {"alpha 2": "31.8", "alpha 3": "43.6"}),
    ("ex3-5", ("normal-omitted", "", ("a^n_CD",)), {"alpha 2": "42.8", "alpha 3": "56.3"}),
    ("ex3-1", ("normal-outward", "", ("a^n_B3D",)), {"alpha 3": "91.0"}),
    ("ex3-1", ("normal-outward", "", ("a_B2",)), {"alpha 3": "8.57"}),
    ("ex3-5", ("normal-outward", "", ("a^n_CB",)), {"alpha 2": "28.5", "alpha 3": "34.7"}),
    ("ex3-5", ("normal-outward", "", ("a^n_CD",)), {"alpha 2": "50.5", "alpha 3": "60.2"}),
    ("ex3-1", ("normal-doubled", "", ("a^n_B3D",)), {"alpha 3": "47.85", "omega 3": "-3.919"}),
    ("ex3-5", ("normal-doubled", "", ("a^n_CB",)), {"alpha 2": "38.3", "alpha 3": "61.3"}),
    ("ex3-1", ("normal-not-laid-off", "", ("a^n_B3D",)), {"a_n B3D": "1.063", "alpha 3": "76.6"}),
    ("ex3-5", ("normal-not-laid-off", "", ("a^n_CD",)), {"alpha 2": "42.8", "alpha 3": "56.3"}),
    ("ex3-1", ("diameter-for-radius", "", ("omega 3",), "2 l_BD"), {"omega 3": "-1.960", "omega 2": "-1.960"}),
    ("ex3-1", ("coriolis-not-laid-off",), {"omega 3": "-3.919", "a_k B3B2": "2.515", "alpha 3": "12.46",
                                          "a_r B3B2": "2.168"}),
    ("ex3-1", ("degrees-for-radians", "", ("ω", "α"), "180/π"), {"omega 3": "-224.6", "alpha 3": "3565.2"}),
    ("ex3-1", ("decimal-slip", "", ("alpha 3",), "1/10"), {"alpha 3": "6.222", "omega 3": "-3.919"}),
    ("ex3-1", ("sense-not-given",), {"omega 3": "3.919", "omega 2": "3.919", "alpha 3": "62.22"}),
    ("ex3-1", ("coriolis-omitted",), {"a_k B3B2": "0.0", "alpha 3": "12.46", "a_r B3B2": "2.168"}),
    ("ex3-1", ("coriolis-reversed",), {"alpha 3": "-37.3", "a_r B3B2": "4.52"}),
    ("ex3-1", ("coriolis-half",), {"a_k B3B2": "1.257", "alpha 3": "37.3"}),
    ("ex3-1", ("coriolis-crank-omega", "sense"), {"a_k B3B2": "6.417", "alpha 3": "139.4"}),
    ("ex3-1", ("coriolis-crank-omega", ""), {"a_k B3B2": "6.417", "alpha 3": "-114.5"}),
    ("ex3-1", ("coriolis-absolute-velocity", "", ("a^k_B3B2",), "v_B2"), {"a_k B3B2": "1.881", "alpha 3": "49.7"}),
    ("ex3-1", ("coriolis-absolute-velocity", "", ("a^k_B3B2",), "v_B3"), {"a_k B3B2": "2.126", "alpha 3": "54.5"}),
    ("ex3-1", ("coriolis-not-turned",), {"alpha 3": "12.46", "a_r B3B2": "0.347"}),
    ("ex3-1", ("normal-size", "", ("a^n_B3D",), "ω3 l_BD"), {"alpha 3": "72.9"}),
    ("ex3-1", ("normal-size", "", ("a^n_B3D",), "ω3² l_CD"), {"alpha 3": "66.6"}),
    ("ex3-1", ("normal-size", "", ("a^n_B3D",), "ω3²"), {"alpha 3": "-131.1"}),
    ("ex3-1", ("normal-size", "", ("a^n_B3D",), "v_B3B2²/l_BD"), {"alpha 3": "56.48"}),
    ("ex3-1", ("normal-size", "", ("a^n_B3D",), "ω3² l_BC"), {"alpha 3": "64.37"}),
    ("ex3-5", ("normal-size", "", ("a^n_CB",), "v_C²/l_BC"), {"alpha 2": "34.63", "alpha 3": "51.28"}),
    ("ex3-5", ("normal-size", "", ("a^n_CB",), "ω2 l_BC"), {"alpha 2": "33.0", "alpha 3": "46.9"}),
    ("ex3-5", ("tangential-along", "", ("a^t_CB",)), {"alpha 3": "-43.0", "alpha 2": "nan"}),
    ("ex3-5", ("tangential-along", "", ("a^t_CD",)), {"alpha 2": "-69.8", "alpha 3": "nan"}),
    ("ex3-1", ("tangential-along", "crank", ("a_B2",)), {"alpha 3": "-3.8"}),
    ("ex3-1", ("wrong-tail", "", ("a^k_B3B2",)), {"alpha 3": "35.4"}),
    ("ex3-5", ("wrong-tail", "", ("a^n_CB",)), {"alpha 2": "-4.45", "alpha 3": "5.03"}),
    ("ex3-1", ("wrong-tail", "segment", ("alpha 3",), "p'b3'"), {"alpha 3": "64.09"}),
    ("ex3-5", ("wrong-tail", "segment", ("alpha 2",), "b'c'"), {"alpha 2": "35.73"}),
    ("ex3-5", ("wrong-tail", "image", ("△BCE",), "n2'c'"), {"a E": "3.767"}),
]


@pytest.mark.parametrize(("name", "words", "printed"), TABLE, ids=str)
def test_a_mistake_gives_what_a_student_gets(name: str, words: tuple[str, ...], printed: dict[str, str]):
    row = row_of(name, *words)
    for text, digits in printed.items():
        hold_printed(value(name, row, text), digits)


@pytest.mark.parametrize(("name", "printed"), RIGHT)
def test_the_right_values(name: str, printed: dict[str, str]):
    answers = {q.text: a.value for q, a in zip(led_to(name).quantities, led_to(name).right, strict=True)}
    for text, digits in printed.items():
        hold_printed(float(answers[text]), digits)


def hold_printed(found: float, digits: str):
    """Equal to a number as far as it is printed: half a unit of the last digit."""
    if digits == "nan":
        assert np.isnan(found)
        return
    unit = 10.0 ** -len(digits.partition(".")[2])
    assert abs(found - float(digits)) <= 0.5 * unit + 1e-12, (found, digits)


def test_every_mistake_is_in_the_table_or_beyond():
    beyond = {"centre-ratio", "centre-acceleration-zero", "arm-ignored", "moves-as-centre", "relative-as-absolute", "slider-normal-term",
              "driver-acceleration-dropped", "driver-acceleration-reversed", "driver-reversed-one", "other-assembly",
              "angle-clockwise", "answers-swapped", "conversion", "tangential-omitted"}  # fmt: skip
    assert {words[0] for _, words, _ in TABLE} | beyond == set(MISTAKES), "a row of TABLE for each, or a test beyond it"


# --- what cannot be told apart ------------------------------------------------------------------

A_PART = ("a B2", "a_n B3D", "a_t B3D", "a_k B3B2", "a_r B3B2", "a B3", "alpha 2", "alpha 3")
ALL_BUT_THE_BLOCK = tuple(text for text in ASKED["ex3-1"] if text != "omega 2")
ALIKE = [
    ("ex3-1", A_PART, [("omega-sense",), ("coriolis-reversed",)]),
    ("ex3-1", ALL_BUT_THE_BLOCK, [("coriolis-omitted",), ("block-omega", "", ("a^k_B3B2",), "0")]),
    ("ex3-1", ("alpha 2", "alpha 3"), [("coriolis-omitted",), ("coriolis-not-turned",),
                                       ("block-omega", "", ("a^k_B3B2",), "0")]),
    ("ex3-1", ALL_BUT_THE_BLOCK, [("coriolis-crank-omega", ""), ("block-omega", "", ("a^k_B3B2",), "ω1")]),
    ("ex3-1", ALL_BUT_THE_BLOCK, [("coriolis-crank-omega", "sense"), ("block-omega", "", ("a^k_B3B2",), "±ω1")]),
    ("ex3-1", ASKED["ex3-1"], [("wrong-radius", "", ("v_B3",), "⊥BC"), ("orthogonal-split", "")]),
    ("ex3-5", ("alpha 2", "alpha 3"), [("absolute-for-relative", "", ("omega 2",), "v_C/l_BC"),
                                       ("normal-size", "", ("a^n_CB",), "v_C²/l_BC")]),
    ("ex3-1", ("alpha 2", "alpha 3"), [("wrong-tail", "", ("a^k_B3B2",)), ("normal-omitted", "", ("a_B2",))]),
    ("ex3-5", ("alpha 2", "alpha 3"), [("wrong-tail", "", ("a^n_CB",)), ("normal-omitted", "", ("a_B",))]),
    ("ex3-5", ASKED["ex3-5"], [("image-mirrored", "", ("△BCE",), "v, a"), ("image-mirrored", "swapped", ("△BCE",), "v, a")]),
]  # fmt: skip


@pytest.mark.parametrize(("name", "texts", "words"), ALIKE)
def test_equal_consequences(name: str, texts: tuple[str, ...], words: list[tuple[str, ...]]):
    """As sizes and as vectors."""
    method, quantities = prepared(name, *texts)
    rows = [led_to(name).columns[row_of(name, *each)] for each in words]
    found = combined(method, replay_all(method), quantities, rows)
    assert are_alike(found)


def are_alike(found: Consequences) -> bool:
    """True where all columns change what is asked, by the same sizes and the same vectors."""
    near = (np.isclose(each, each[0], 1e-9, 1e-9 * found.sizes, True) for each in (found.values, found.vectors))
    return bool(found.moves.all()) and all(each.all() for each in near)


def test_a_driver_s_sense_is_not_seen_in_accelerations():
    method, quantities = prepared("ex3-1", *A_PART)
    found = combined(method, replay_all(method), quantities, [led_to("ex3-1").columns[row_of("ex3-1", "driver-reversed")]])
    assert not found.moves.any()


# --- planes, and several mistakes ----------------------------------------------------------------


def test_a_velocity_image_alone_leaves_accelerations():
    row = row_of("ex3-5", "image-mirrored", "", ("△BCE",), "v")
    hold_printed(value("ex3-5", row, "a E"), "3.542")


def test_a_guide_through_its_pivot_may_be_split():
    """There the parts along and across the guide are the velocities sought: no mistake."""
    assert not [rewrite for (rewrite,) in led_to("ex3-7").columns if rewrite.id == "orthogonal-split"]


def test_what_a_ruler_reads_is_the_whole_arrow():
    """Not its part across BD, which would give 9.0 and -2.09 rad/s."""
    rows = [row_of("ex3-1", "wrong-radius", "", ("v_B3",), form) for form in ("⊥CD", "⊥BC")]
    for row, part in zip(rows, (9.0, 2.09), strict=True):
        assert abs(value("ex3-1", row, "omega 3")) > part + 0.5


@pytest.mark.parametrize("words", [("coriolis-half",), ("other-assembly", "", ("3",)), ("wrong-tail", "", ("a^k_B3B2",))])
def test_a_rewritten_drawing_of_its_own(words: tuple[str, ...]):
    """Scalars, as the column of all at once has them."""
    method, _ = prepared("ex3-1")
    row = row_of("ex3-1", *words)
    drawn = rewritten(method, replay_all(method), led_to("ex3-1").columns[row])
    assert all(np.ndim(place) == 0 for place in (*drawn.acceleration.values(), *drawn.position.values()))
    assert drawn.alpha["3"] == pytest.approx(value("ex3-1", row, "alpha 3"))


def test_a_pair_of_mistakes_is_made_together():
    """Half the Coriolis term, and that the other way: -1/2 of it."""
    half, turned = (led_to("ex3-1").columns[row_of("ex3-1", word)][0] for word in ("coriolis-half", "coriolis-reversed"))
    method, quantities = prepared("ex3-1", "a_k B3B2", "alpha 3")
    both = combined(method, replay_all(method), quantities, [(half, turned), (turned, half), (half,)])
    omitted = value("ex3-1", row_of("ex3-1", "coriolis-omitted"), "alpha 3")
    assert both.vectors[0, 0] == both.vectors[1, 0] == -both.vectors[2, 0]
    assert both.values[0, 1] - omitted == pytest.approx(omitted - both.values[2, 1])
    assert both.columns[0] == (half, turned)


def test_all_normal_terms_left_out_are_every_one_left_out():
    one, other, every = (led_to("ex3-5").columns[row_of("ex3-5", "normal-omitted", "", name)]
                         for name in (("a^n_CD",), ("a^n_CB",), ("a^n_CD", "a^n_CB")))  # fmt: skip
    method, quantities = prepared("ex3-5")
    found = combined(method, replay_all(method), quantities, [(*one, *other), every])
    assert are_alike(found)


# --- carried on ---------------------------------------------------------------------------------

CARRIED = [
    ("ex3-1", {"omega 3": -5.65}, {"omega 3": "-3.919", "omega 2": "-5.65", "v B3B2": "0.3208", "a_k B3B2": "3.625",
                                  "alpha 3": "68.7"}),
    ("ex3-1", {"omega 2": -5.65}, {"omega 3": "-5.65", "omega 2": "-3.919", "a_k B3B2": "3.625", "alpha 3": "68.7"}),
    ("ex3-1", {"v B3": 0.2}, {"v B3": "0.2712", "omega 3": "-2.890"}),
    ("ex3-1", {"v B3B2": 0.1604}, {"v B3B2": "0.3208", "a_k B3B2": "1.257", "alpha 3": "37.3"}),
    ("ex3-1", {"a_k B3B2": 1.2574}, {"a_k B3B2": "2.515", "alpha 3": "37.3", "a_r B3B2": "0.992"}),
    ("ex3-1", {"a_t B3D": 6.92}, {"a_t B3D": "4.306", "alpha 3": "100.0"}),
    ("ex3-1", {"v B2": 0.48}, {"v B2": "0.24", "v B3": "0.5424", "omega 3": "-7.839"}),
    ("ex3-1", {"alpha 3": 1.0}, {"alpha 3": "62.22", "omega 3": "-3.919"}),
    ("ex3-5", {"omega 2": -2.4454}, {"alpha 2": "34.63", "alpha 3": "51.28", "omega 3": "2.853"}),
    ("ex3-7", {"v D": 0.2054}, {"v D": "0.1027", "omega 3": "0.1712"}),
]  # fmt: skip


@pytest.mark.parametrize(("name", "own", "printed"), CARRIED)
def test_what_follows_from_an_own_value(name: str, own: dict[str, float], printed: dict[str, str]):
    """A quantity's own value does not count for itself: its carried value is what follows from those before."""
    method, quantities = prepared(name, *own, *printed)
    given = dict(zip(quantities, own.values(), strict=False))
    found = replay_with(method, replay_all(method), given)
    for text, digits in printed.items():
        hold_printed(float(found.value(next(q for q in quantities if q.text == text)).value), digits)


def test_many_students_at_once():
    """Each as alone; one without an own value gets what is right."""
    method, quantities = prepared("ex3-1", "omega 3", "v B3B2", "a_k B3B2", "alpha 3")
    plot = replay_all(method)
    own = np.array([-5.65, np.nan, -4.607, 1.0]), np.array([np.nan, 0.3, 0.2, np.nan])
    whole = replay_with(method, plot, {quantities[0]: own[0], quantities[1]: own[1]})
    for k in range(4):
        mine = {q: values[k] for q, values in zip(quantities[:2], own, strict=True) if np.isfinite(values[k])}
        alone = replay_with(method, plot, mine)
        for quantity in quantities:
            assert np.broadcast_to(whole.value(quantity).value, 4)[k] == pytest.approx(alone.value(quantity).value)


def test_a_drawn_vector_moves_its_point():
    """What is drawn from there follows: c by image, omega 3 from the vector's part across the lever."""
    method, (v_b3, v_c, omega) = prepared("ex3-1", "v B3", "v C", "omega 3")
    right = replay_with(method, replay_all(method), {})
    half = replay_with(method, replay_all(method), {v_b3: 0.5 * right.value(v_b3).vector})
    assert half.value(v_b3).vector == pytest.approx(right.value(v_b3).vector)
    assert half.value(v_c).vector == pytest.approx(0.5 * right.value(v_c).vector)
    assert half.value(omega).value == pytest.approx(0.5 * right.value(omega).value)
    assert right.least_sine == pytest.approx(min(s for (plane, _), s in right.plot.sines.items() if plane != "position"))


def test_both_components_are_a_vector():
    method, (v_x, v_y, v_c, omega) = prepared("ex3-1", "v_x B3", "v_y B3", "v B3", "omega 3")
    plot = replay_all(method)
    vector = 0.1 + 0.3j
    whole, parts = ({v_c: vector}, {v_x: vector.real, v_y: vector.imag})
    assert replay_with(method, plot, whole).value(omega) == replay_with(method, plot, parts).value(omega)
    assert replay_with(method, plot, {v_x: 0.1}).value(omega).value == pytest.approx(-3.9193, abs=1e-4)


# --- other right ways ---------------------------------------------------------------------------


def test_other_right_ways():
    method, (coriolis, omega) = prepared("ex3-1", "a_k B3B2", "omega 3")
    plot = replay_all(method)
    ways = {way.quantity.text: way for way in other_ways(method, plot, coriolis)}
    right = coriolis.answer(readings(method, plot)).vector
    assert ways["a_k B2B3"].answer.vector == pytest.approx(-right)
    assert ways["a_k C3C2"].answer.vector == pytest.approx(right)
    assert [way.answer.value for way in other_ways(method, plot, omega)] == [pytest.approx(3.9193, abs=1e-4)]


def test_other_coincident_points_are_planned():
    method, (alpha,) = prepared("ex3-1", "alpha 3")
    others = list(other_methods(method))
    assert [other.velocity.equations[0].of for other in others] == ["D2", "C2"]
    for other in others:
        found = replay_with(other, replay_all(other), {})
        assert found.value(alpha).value == pytest.approx(62.2239, abs=1e-4)


# --- hands --------------------------------------------------------------------------------------


class Trembling(PolygonHand):
    """Every direction off by so many degrees, one a column."""

    def __init__(self, off_deg: np.ndarray) -> None:
        self.turn = np.exp(1j * np.radians(off_deg))

    def line(self, plot: Redrawing, plane: str, number: int, ray: object, right: Value) -> Value:
        return right * self.turn


def test_a_hand_that_errs():
    """Both lines turned alike turn the triangle on its known side."""
    method, (omega,) = prepared("ex3-1", "omega 3")
    off = np.array([-0.5, 0.0, 0.5])
    drawn = redraw(method, replay_all(method), Trembling(off), off.shape)
    found = drawn_answer(method, drawn, omega, arrows_of(method)).value
    assert found[1] == pytest.approx(-3.9193, abs=1e-4)
    assert found[0] != pytest.approx(found[1], abs=1e-3)
    assert found[0] - found[1] == pytest.approx(found[1] - found[2], rel=0.1)


# --- words --------------------------------------------------------------------------------------


def test_every_way_has_its_words():
    found = {(rewrite.id, rewrite.way) for name in ASKED for (rewrite,) in led_to(name).columns}
    assert not [way for id, way in found if way and not {f"mistakes.made {id} {way}", f"mistakes.way {way}"} & {*PHRASES}]
    assert not [id for id, way in found if not way and mistake((id, way, "A", "v"), "zh") == id]
    made = {key.split(" ")[1] for key in PHRASES if key.startswith("mistakes.made ")}
    assert made == {*MISTAKES, SLIP}
    topics = {key.removeprefix("mistakes.look ") for key in PHRASES if key.startswith("mistakes.look ")}
    assert {*(one.topic for one in MISTAKES.values()), SLIP} == topics


def test_an_image_is_called_after_its_polygon():
    name = ("image-mirrored", "", ("△BCE",), "v, a")
    assert mistake(name, "en") == "the velocity and acceleration images of △BCE lettered in the opposite sense"
    assert mistake((*name[:3], "a"), "zh") == "加速度影像 △BCE 的字母绕行方向与原图相反"


def test_names_tell_rewrites_apart():
    method, quantities = prepared("ex3-7")
    found: tuple[Rewrite, ...] = rewrites(method, replay_all(method), quantities)
    assert len({rewrite.name for rewrite in found}) == len(found)
    assert all(isinstance(quantity, Moving) or quantity.unit.startswith("rad") for quantity in quantities)


PIN_IN_A_SLOT = """
ask = ["alpha 3", "a_k B1B3"]
frame = { name = "4", A = [0, 0], D = [0, -90] }
links = { 1 = { AB = 35 }, 3 = { DC = 160 } }
slide = [{ pin = "B", guide = "3", through = "D", toward = "C" }]
driver = [{ vector = "AB", angle = 30, omega = -6 }]
sketch = { C = [40, 60] }
"""


WITH_A_BLOCK = PIN_IN_A_SLOT.replace("1 = {", '2 = { points = ["B"] }, 1 = {').replace("pin =", 'block = "2", point =')


@pytest.mark.parametrize("text", [PIN_IN_A_SLOT, WITH_A_BLOCK], ids=["pin", "block"])
@pytest.mark.parametrize("order", ["B1B3", "B3B1"])
def test_the_coriolis_acceleration_of_a_pin_in_a_slot_is_handed_in_as_it_was_laid_off(text: str, order: str):
    """By the slot's rotation either way round, as the pin's path is straight there, with a block and without."""
    method = plan(loading.loads(text, name="lever"))
    quantities = [read(method.mechanism, f"a_{part} {order}") for part in "kr"]
    exact = motion(method.mechanism)
    slip = exact.velocity_at("B", "1") - exact.velocity_at("B", "3")
    for quantity in (quantities[0], *map(partial(read, method.mechanism), ("a_k B1B3",))):
        assert abs(quantity.vector(exact)) == pytest.approx(abs(2 * exact.omega["3"] * slip))
    found = consequences(method, replay_all(method), quantities)
    right, values = found.right[0].value, {one.id: row[0] for (one,), row in zip(found.columns, found.values, strict=True)}
    assert values["coriolis-half"] == pytest.approx(right / 2)
    assert values["coriolis-omitted"] == pytest.approx(0.0, abs=1e-12)
    assert values["coriolis-reversed"] == pytest.approx(right)


WHEELS = """
ask = ["v M", "omega 5"]
frame = { name = "4", A = [0, 0], D = [90, 0], E = [180, 0] }
links = { 1.AB = 30, 5.DF = 30, 2 = { BC = 180, BF = 90, BM = 50, CBF = 0, CBM = 0 }, 3.EC = 30 }
driver = [{ vector = "AB", angle = 130, omega = -21 }]
sketch = { F = [71, 23], C = [161, 23], M = [30, 23] }
"""
ON_THREE_LEGS = """
ask = ["omega 3", "v D", "alpha 3"]
frame = { name = "6", A = [0, 0], F = [40, -70], G = [130, 10] }
links = { 1.AB = 25, 2.BC = 60, 3 = { CD = 45, DE = 50, CE = 60, ccw = ["C", "D", "E"] }, 4.FD = 65, 5.GE = 55 }
driver = [{ vector = "AB", angle = 100, omega = 9.4 }]
sketch = { C = [50, 45], D = [60, 0], E = [110, 60] }
"""


@pytest.mark.parametrize(("text", "id"), [(WHEELS, "wrong-length"), (ON_THREE_LEGS, "absolute-for-relative")])
def test_nobody_divides_by_the_frame_or_what_is_at_rest(text: str, id: str):
    """No length between fixed points is taken for a link's, and no velocity of a point at rest for a relative one."""
    method = plan(loading.loads(text, name="file"))
    plot = replay_all(method)
    forms = [rewrite.name[1:] for rewrite in rewrites(method, plot, (read(method.mechanism, method.mechanism.ask[0]),)) if rewrite.id == id]
    assert forms
    assert not [form for form in forms if "l_AD" in str(form) or "l_DE" in str(form) or "v_S3" in str(form)]
