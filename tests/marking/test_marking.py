"""Marking: what a pencil allows, verdicts, carried values, keys, and the mistake behind wrong values."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from graphkin import api
from graphkin.errors import NOWHERE, BadKey
from graphkin.homework.grading import Pencils, key_for, key_from, marking_of
from graphkin.homework.grading.keys import key_drawn
from graphkin.marking import key_making as making
from graphkin.marking.diagnosis import Trace, added, independent
from graphkin.marking.key_making import half_digit
from graphkin.marking.marker import Marker
from graphkin.marking.pencil import Mark, Pencil, Slips
from graphkin.marking.records import HandedNumber, Judged, Marked, StudentWork
from graphkin.marking.tolerances import Drawings, drawings_of, spread, tolerances
from graphkin.model.quantities import named
from graphkin.outputs.key_json import key_data, key_of, key_text

CASES = Path(__file__).parents[1] / "cases"


@cache
def marker(name: str = "ex3-1") -> Marker:
    return Marker(key_from(name))


def marked(values: dict[str, float | HandedNumber], name: str = "ex3-1") -> Marked:
    numbers = {text: value if isinstance(value, HandedNumber) else HandedNumber(value) for text, value in values.items()}
    return marker(name).mark([StudentWork("s", numbers)])[0]


def judged(values: dict[str, float | HandedNumber], name: str = "ex3-1") -> dict[str, Judged]:
    return {one.text: one for one in marked(values, name).judged}


def ids(values: dict[str, float | HandedNumber], name: str = "ex3-1") -> set[str]:
    found = marked(values, name).diagnosis.explanations
    return set(found[0].ids) if found else set()


# --- the pencil -------------------------------------------------------------------------------


def values_by(mark: Mark | None, count: int = 4000, **pencil: float) -> dict[str, np.ndarray]:
    """What ex3-1 gives over many drawings, with one error of the pencil alone."""
    method = api.plan(api.load("ex3-1"))
    scales = {"position": 0.001, "velocity": 0.01, "acceleration": 0.1}
    lengths = {plane: pencil.get("length", 0.0) * scale for plane, scale in scales.items()}
    slips = Slips(7, count, None if mark is None else lambda one: one == mark)
    texts = ("v B2", "v B3", "omega 3", "theta 3", "a_k B3B2", "alpha 3")
    quantities = [named(method.mechanism, text, NOWHERE) for text in texts]
    drawings = Drawings.of(method, Pencil(lengths, pencil.get("angle", 0.0)), slips)
    return dict(zip(texts, drawings.values(quantities)[0].T, strict=True))


def test_an_arrow_laid_off_too_long_makes_the_polygon_larger():
    """v_B2 is 24 mm long: an error of 0.25 mm is 1.04 % of it and of all that is similar to it."""
    found = values_by(Mark("velocity", "arrow", ("Turning", "1", "A", "B")), length=0.25)
    part = 0.25 / 24
    for text, power_of in (("v B2", 1), ("v B3", 1), ("omega 3", 1), ("a_k B3B2", 2)):
        values = np.abs(found[text])
        assert np.std(values) / np.mean(values) == pytest.approx(power_of * part, rel=0.05), text


def test_a_pencil_without_errors_gives_the_right_values():
    found = values_by(None, 10)
    assert np.ptp(found["alpha 3"]) < 1e-9
    assert found["alpha 3"][0] == pytest.approx(62.2239, rel=1e-5)


def test_a_length_read_wrong_and_an_angle_read_wrong():
    read = values_by(Mark("velocity", "reading", ("p", "b3")), length=0.25)["omega 3"]
    assert np.std(read) == pytest.approx(0.25 * 0.01 / 0.0692, rel=0.06)  # of pb3, over l_BD
    angle = values_by(Mark("position", "reading", ("theta 3",)), angle=0.01)["theta 3"]
    assert np.std(angle) == pytest.approx(0.01, rel=0.05)


def test_scatter_grows_with_the_pencil():
    marking = marking_of(marker().method)
    entries, method = marker().key.entries, marker().method
    right, sorts = np.array([entry.right for entry in entries]), [entry.sort for entry in entries]
    small, large = (
        spread(drawings_of(method, marking_of(method, Pencils(k, k)), 500).values(marker().quantities)[0], right, sorts)
        for k in (0.02, 0.04)
    )
    assert marking.lengths["velocity"] == pytest.approx(0.25 * 0.006)
    assert large / small == pytest.approx(np.full(len(entries), 2.0), rel=0.05)


def test_slips_hang_on_the_seed_and_the_mark_alone():
    mark = Mark("velocity", "line", ("p",))
    assert np.array_equal(Slips(1, 5).of(mark), Slips(1, 5).of(mark))
    assert not np.array_equal(Slips(1, 5).of(mark), Slips(2, 5).of(mark))
    assert not np.array_equal(Slips(1, 5).of(mark), Slips(1, 5).of(mark, 1))


@pytest.mark.parametrize(("value", "unit", "half"), [(3.919, "rad/s", 0.005), (0.3208, "m/s", 0.0005),
                                                     (62.2, "rad/s^2", 0.05), (0.5056, "rad", math.radians(0.05)),
                                                     (0.0589, "m", 5e-5)])  # fmt: skip
def test_three_printed_digits(value: float, unit: str, half: float):
    assert half_digit(value, unit) == pytest.approx(half)
    assert half_digit(-value, unit) == pytest.approx(half)


def test_three_digits_are_right_without_any_scatter():
    exact = Marker(key_for(api.load("ex3-1"), Pencils(0.0, 0.0)))
    found = exact.mark([StudentWork("s", {"omega 3": HandedNumber(-3.92), "alpha 3": HandedNumber(62.3)})])[0].judged
    assert [one.verdict for one in found if one.given is not None] == ["right", "right"]
    assert exact.mark([StudentWork("s", {"omega 3": HandedNumber(-3.95)})])[0].judged[1].verdict == "wrong"


def test_parts_of_the_scatter_add_up():
    """One error at a time, squared and added, is about the whole: they are independent and small."""
    found = tolerances(marker().key, marker().method)
    for text in ("omega 3", "alpha 3", "a_k B3B2"):
        assert sum(cost.parts[text] for cost in found.costs) == pytest.approx(1.0, abs=0.25), text
    worst = found.worst("omega 3")
    assert worst is not None
    assert worst.name == "v_B2"


def test_an_error_of_a_line_or_a_link_alone_reaches_a_group_that_is_fitted():
    """With one error at a time nothing differs before a group of Class III but its own guides and links."""
    method = api.plan(api.load(CASES / "three-sided-link-on-guides.toml"))
    found = tolerances(key_for(method.mechanism), method)
    assert sum(cost.parts["omega 4"] for cost in found.costs) == pytest.approx(1.0, abs=0.25)
    felt = {cost.mark for cost in found.costs if cost.parts["omega 4"] > 0.01}
    assert felt >= {Mark("position", "guide", ("s0",)), Mark("position", "point", ("4", "E"))}


def test_fixed_tolerances():
    key = key_for(api.load("ex3-1"), Pencils(relative=0.02))
    of = {entry.text: entry for entry in key.entries}
    assert of["omega 3"].tolerance == pytest.approx(0.02 * 3.91933, rel=1e-4)
    wide = key_for(api.load("ex3-1"), Pencils(sigmas=6))
    assert wide.entries[1].tolerance == pytest.approx(2 * marker().key.entries[1].tolerance)


# --- verdicts ---------------------------------------------------------------------------------

RIGHT = {"omega 2": -3.92, "omega 3": -3.92, "alpha 2": 62.2, "alpha 3": 62.2, "a_k B3B2": 2.51}


def test_right_work():
    found = marked(RIGHT)
    assert {one.verdict for one in found.judged} == {"right"}
    assert found.score == 1.0
    assert found.diagnosis.explanations == ()


def test_other_right_ways():
    """The other order of two coincident points, another coincident point, sizes with a sign."""
    found = marked({"v B2B3": 0.321, "a_k B2B3": 2.51, "v B3B2": -0.321, "v C3C2": 0.32, "v C": 0.188, "omega 3": -3.92})
    assert {one.verdict for one in found.judged if one.given is not None} == {"right"}
    assert found.diagnosis.explanations == ()


@pytest.mark.parametrize("values", [
    {"omega 3": -5.65, "a_k B3B2": 3.63, "alpha 3": 68.7},
    {"omega 3": -3.0, "a_k B3B2": 1.925},
    {"v B3B2": 0.25, "a_k B3B2": 1.96},
    {"a_k B3B2": 1.25, "alpha 3": 37.1},
])  # fmt: skip
def test_what_follows_is_carried(values: dict[str, float]):
    first, *rest = (judged(values)[text] for text in values)
    assert first.verdict == "wrong"
    for one in rest:
        assert one.verdict == "carried", one.text
        assert one.credit == 1.0
        assert first.text in one.own
        assert one.carried == pytest.approx(one.given, rel=0.02)


def test_the_right_value_counts_first():
    """A slip in writing one value down takes nothing from the next, though that does not follow from it."""
    found = judged({"omega 3": -9.0, "a_k B3B2": 2.51, "alpha 3": 62.2})
    assert [found[text].verdict for text in ("omega 3", "a_k B3B2", "alpha 3")] == ["wrong", "right", "right"]


@pytest.mark.parametrize("own", [0.0, 10.0, -10.0, 25.0, -0.5, 1e308, -1e300])
def test_guard(own: float):
    """Nought, the crank's own omega, what is far off: nothing follows from them."""
    follows = 2 * own * 0.3208 if abs(own) < 1e10 else 1.0
    found = judged({"omega 3": own, "a_k B3B2": abs(follows)})
    assert found["a_k B3B2"].verdict == "wrong"
    assert "omega 3" in found["a_k B3B2"].refused


def test_missing_lowers_nothing_else():
    found = marked({"alpha 3": 62.2})
    assert {one.text: one.verdict for one in found.judged} == {**dict.fromkeys(RIGHT, "missing"), "alpha 3": "right"}
    assert found.score == pytest.approx(0.2)


def test_sense_and_unit_by_themselves():
    found = judged({"omega 3": 3.92, "alpha 3": 62.2, "omega 2": HandedNumber(-3.92, unit_right=False)})
    assert (found["omega 3"].verdict, found["omega 3"].sense, found["omega 3"].credit) == ("wrong", "wrong", 0.5)
    assert (found["alpha 3"].verdict, found["alpha 3"].sense) == ("right", "right")
    assert (found["omega 2"].verdict, found["omega 2"].unit_right, found["omega 2"].credit) == ("wrong", False, 0.5)


def read(off: float, alpha: float = 12.46) -> Marked:
    """Coriolis left out; alpha 3 read off a photograph, of which so much is not sure."""
    doubtful = HandedNumber(alpha, measured=True, off=off)
    work = StudentWork("s", {"omega 3": HandedNumber(-3.92), "alpha 3": doubtful, "a_k B3B2": HandedNumber(0.0)}, error=0.1)
    return marker().mark([work])[0]


def verdict_of(found: Marked, text: str) -> str:
    return next(one.verdict for one in found.judged if one.text == text)


def test_what_is_not_sure_counts_where_it_tells():
    """A value that is surely wrong is, one that may be is not read; none is carried on to others."""
    scatter = next(entry.scatter for entry in marker().key.entries if entry.text == "alpha 3")
    assert verdict_of(read(0.5 * scatter, 62.2), "alpha 3") == "right"
    assert verdict_of(read(2.0 * scatter, 62.2), "alpha 3") == "not read"
    assert verdict_of(read(2.0 * scatter, 62.2 + 6 * scatter), "alpha 3") == "not read"
    assert verdict_of(read(2.0 * scatter, 62.2 + 60 * scatter), "alpha 3") in ("wrong", "carried")


def test_what_is_not_sure_takes_part_in_the_diagnosis():
    """Beside a value that fits no mistake but by what is not sure of it."""
    scatter = next(entry.scatter for entry in marker().key.entries if entry.text == "alpha 3")
    assert "coriolis-omitted" not in {id for one in read(0.0, 12.46 + 8 * scatter).diagnosis.explanations for id in one.ids}
    assert "coriolis-omitted" in {id for one in read(3 * scatter, 12.46 + 8 * scatter).diagnosis.explanations for id in one.ids}


def test_angles_count_modulo_a_turn():
    found = judged({"theta 2": math.radians(28.97 + 360), "theta 3": math.radians(93.59 - 360)}, "ex3-5")
    assert [found[text].verdict for text in ("theta 2", "theta 3")] == ["right", "right"]


def test_points_of_questions():
    key = key_for(replace(api.load("ex3-1"), ask=("omega 3", "alpha 3"), worth={"omega 3": 3.0}))
    found = Marker(key).mark([StudentWork("s", {"omega 3": HandedNumber(-3.92)})])[0]
    assert found.score == pytest.approx(0.75)
    assert [one.text for one in found.judged] == ["omega 3", "alpha 3"]


# --- diagnosis --------------------------------------------------------------------------------


@pytest.mark.parametrize(("values", "expected"), [
    ({"omega 3": -3.92, "alpha 3": 12.46, "a_k B3B2": 0.0, "a_r B3B2": 2.17}, "coriolis-omitted"),
    ({"omega 3": -3.92, "alpha 3": -37.3, "a_k B3B2": 2.51, "a_r B3B2": 4.52}, "coriolis-reversed"),
    ({"omega 3": -3.92, "alpha 3": 37.3, "a_k B3B2": 1.26}, "coriolis-half"),
    ({"omega 3": -5.65, "alpha 3": 68.7, "a_k B3B2": 3.63}, "wrong-length"),
    ({"omega 3": -5.45, "alpha 3": 68.2, "a_k B3B2": 3.50}, "sliding-as-turning"),
    ({"omega 3": 2.868, "alpha 3": 19.1, "a_k B3B2": 1.97}, "sliding-across"),
    ({"omega 3": -2.683, "v B3B2": 0.0712, "a_k B3B2": 0.382, "alpha 3": 12.5}, "driver-along-crank"),
    ({"omega 3": -3.92, "a_k B3B2": 2.51, "alpha 3": 91.0}, "normal-outward"),
    ({"omega 3": -3.92, "a_k B3B2": 2.51, "alpha 3": 76.6}, "normal-omitted"),
    ({"omega 3": -37.4, "a_k B3B2": 2.51, "alpha 3": 62.2}, "conversion"),
    ({"omega 3": -3.92, "alpha 3": 62.2, "v B3B2": 321.0, "a_k B3B2": 2515.0, "a_r B3B2": 185.0}, "conversion"),
    ({"omega 3": -3.92, "v B3B2": 321.0, "a_k B3B2": 2515.0}, "conversion"),
])  # fmt: skip
def test_the_mistake_behind_a_wrong_number(values: dict[str, float], expected: str):
    assert expected in ids(values)


def test_mistakes_of_equal_consequences_are_one_set():
    assert ids({"omega 3": -3.92, "alpha 3": 12.46}) >= {"coriolis-omitted", "block-omega", "coriolis-not-turned"}


def test_what_fits_nothing_gets_nothing():
    assert ids({"omega 3": -3.92, "alpha 3": 20.0, "a_k B3B2": 5.1, "v B3B2": 0.27}) == set()


def test_two_mistakes_where_there_are_values_enough():
    """The wrong length for omega 3, and the Coriolis term left out."""
    values = {"v B3": 0.271, "v B3B2": 0.321, "omega 3": -5.65, "omega 2": -5.65, "a_k B3B2": 0.0}
    hypotheses, key = marker().pairs(None), marker().key
    row = next(k for k, names in enumerate(hypotheses.names)
               if {name[0] for name in names} == {"wrong-length", "coriolis-omitted"} and "l_CD" in names[0])  # fmt: skip
    number = {entry.text: k for k, entry in enumerate(key.entries)}
    values |= {text: float(hypotheses.values[row, number[text]]) for text in ("alpha 3", "a_n B3D", "a_t B3D")}
    found = marked(values).diagnosis.explanations
    assert found
    assert any({name[0] for name in names} == {"wrong-length", "coriolis-omitted"} for names in found[0].names)
    assert ids({"omega 3": -5.65, "a_k B3B2": 0.0, "alpha 3": values["alpha 3"]}) == set()


def test_independent_values():
    key = marker().key
    there = np.array([entry.text in ("omega 2", "omega 3", "alpha 2", "alpha 3", "a_k B3B2") for entry in key.entries])
    assert independent(key, there) == 3


def test_explains_and_margin():
    one = marked({"omega 3": -3.92, "alpha 3": -37.3, "a_k B3B2": 2.51, "a_r B3B2": 4.52}).diagnosis.explanations[0]
    assert set(one.explains) == {"alpha 3", "a_r B3B2"}
    assert 0.9 < one.probability <= 1.0
    assert one.margin > 3


@pytest.mark.parametrize(("text", "factor", "expected"), [("alpha 5", 0.1, {"decimal-slip"}), ("omega 5", -1.0, {"omega-sense", "centre-ratio", "slip"})])
def test_what_says_nothing_of_a_wrong_value_or_of_which_a_right_one_is_unlikely_explains_nothing(text, factor, expected):
    """A rotation whose sense a mistake leaves open; lines nearly parallel, whose values are of any size."""
    one = marker(str(CASES / "jaw-crusher.toml"))
    right = {entry.text: entry.right for entry in one.key.entries if entry.points}
    work = StudentWork("s", {each: HandedNumber(value * (factor if each == text else 1.0)) for each, value in right.items()})
    (found,) = one.mark([work])
    wrong = {each.text for each in found.judged if each.verdict != "right"}
    assert wrong == {text}
    assert {id for each in found.diagnosis.explanations for id in each.ids} == expected


def test_evidence_adds_up_over_problems():
    two = [
        marked({"omega 3": -3.92, "alpha 3": -37.3}).diagnosis,
        marked({"omega 3": 2.165, "alpha 3": -8.0}, "p3-4a").diagnosis,
    ]
    total = added(Trace((), one.evidence) for one in two)
    each = [np.logaddexp(np.log(0.8) + one.evidence["coriolis-reversed"], np.log(0.2)) for one in two]
    assert total["coriolis-reversed"] == pytest.approx(sum(each))


def test_a_student_is_marked_alike_alone_and_in_a_class():
    """Whatever the others hand in, who have own values of other quantities, and of the same by other names."""
    key, rng = marker().key, np.random.default_rng(1)
    works = [StudentWork("odd", dict.fromkeys(("v C", "a C", "v_x C", "v_y C", "v B", "x C", "a_n B3D", "a_x B"), HandedNumber(1.0)))]
    for _ in range(40):
        row = key.singles.values[rng.integers(len(key.singles.names))] * rng.uniform(0.6, 1.6, len(key.entries))
        handed = {entry.text: HandedNumber(float(value)) for entry, value in zip(key.entries, row, strict=True) if np.isfinite(value)}
        own = {text: number for text, number in handed.items() if rng.random() < 0.6}
        works.append(StudentWork("s", own | {"v C": HandedNumber(0.2)}))
    works += [StudentWork("many", {f"{letter} {point}": HandedNumber(2.0)}) for point in "ABCD" for letter in
              ("v", "a", "v_x", "v_y", "a_x", "a_y", "x", "y", "a_n", "a_t", "r")]  # fmt: skip
    together = Marker(key).mark(works)[1:]
    assert any(one.own for marked in together for one in marked.judged)
    for work, found in list(zip(works[1:], together, strict=True))[::12]:
        (alone,) = Marker(key).mark([work])
        for one, other in zip(found.judged, alone.judged, strict=True):
            assert (one.verdict, one.credit, one.own, one.refused) == (other.verdict, other.credit, other.own, other.refused)
            assert (one.carried is None) == (other.carried is None)
            assert one.carried is None or one.carried == pytest.approx(other.carried, rel=1e-9)
        assert [one.names for one in found.diagnosis.explanations] == [one.names for one in alone.diagnosis.explanations]


# --- keys -------------------------------------------------------------------------------------


def test_a_key_is_read_as_it_was_written():
    key = marker().key
    text = key_text(key)
    again = key_of(text, NOWHERE)
    assert key_text(again) == text
    work = [StudentWork("s", {"omega 3": HandedNumber(-5.65), "a_k B3B2": HandedNumber(3.63), "v C": HandedNumber(0.19)})]
    mine, its = marker().mark(work)[0], Marker(again).mark(work)[0]
    assert [(one.verdict, one.own) for one in mine.judged] == [(one.verdict, one.own) for one in its.judged]
    assert mine.diagnosis.explanations[0].ids == its.diagnosis.explanations[0].ids


def test_the_same_mechanism_gives_the_same_key():
    assert key_text(key_from("ex3-1")) == key_text(marker().key)


def test_a_changed_key_counts():
    entries = [replace(entry, right=-4.5, tolerance=0.1) if entry.text == "omega 3" else entry
               for entry in marker().key.entries]  # fmt: skip
    changed = Marker(replace(marker().key, entries=tuple(entries)))
    assert changed.mark([StudentWork("s", {"omega 3": HandedNumber(-4.45)})])[0].judged[1].verdict == "right"


def broken_keys() -> list[str]:
    whole = key_data(marker().key)
    changes: list[dict[str, object]] = [
        {"kind": "x"}, {"format": 2}, {"quantities": []}, {"quantities": [{}]}, {"together": [[1.0]]},
        {"mistakes": [{"names": [["a"]], "values": [], "scatters": []}]}, {"mistakes": 3}, {"marking": {}}, {"mechanism": 7},
        {"title": []}, {"steps": None}, {"together": None},
    ]  # fmt: skip
    texts = [json.dumps({**whole, **change}) for change in changes]
    nan = json.dumps(whole).replace(str(whole["marking"]["angle"]), "NaN")
    return [*texts, "", "{", "[]", "null", "[" * 100_000, nan, key_text(marker().key)[:-100]]


def test_broken_keys_are_refused():
    for text in broken_keys():
        with pytest.raises(BadKey):
            key_of(text, NOWHERE)



def test_a_key_is_the_same_however_many_mistakes_are_drawn_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    method = api.plan(api.load("ex3-1"))
    whole = key_drawn(method).singles
    monkeypatch.setattr("graphkin.marking.tolerances._NUMBERS", 1)
    one_by_one = key_drawn(method).singles
    for name in ("values", "scatters", "together"):
        assert np.array_equal(getattr(whole, name), getattr(one_by_one, name), equal_nan=True)


@pytest.mark.parametrize(("drawings", "quantities"), [(3, 1), (5, 4), (200, 30), (601, 153)])
def test_scatters_hang_together_as_their_ranks_do(drawings: int, quantities: int):
    """Spearman's correlation; of what stands still, none."""
    rng = np.random.default_rng(quantities)
    drawn = rng.normal(size=(drawings, quantities)) @ rng.normal(size=(quantities, quantities))
    drawn[:, -1] = 7.0
    ranks = np.argsort(np.argsort(drawn[:, :-1], axis=0), axis=0)
    right = np.eye(quantities)
    if quantities > 1:
        right[:-1, :-1] = np.corrcoef(ranks, rowvar=False)
    assert making._together(drawn) == pytest.approx(right, rel=0, abs=1e-6)
