"""From lengths and angles to coordinates: known figures, random figures, and figures that cannot be."""

from __future__ import annotations

import cmath
import math
from itertools import combinations, pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from graphkin.errors import (
    CcwContradicts,
    CcwOnLine,
    Contradiction,
    GraphkinError,
    MissingCcw,
    NoTriangle,
    TooFewMeasures,
    TooManyPoints,
    Where,
)
from graphkin.files.links import link_points, read_measures
from graphkin.files.shapes import ShapeMeasures, solve_shape


def shape(table: dict[str, object], *ccw: str) -> dict[str, complex]:
    """The solved shape of a link, in mm."""

    def where(*path: object) -> Where:
        return Where("test.toml", list(table).index(str(path[-1])) + 1, str(path[-1]))

    measures, problems = read_measures({"1": table}, where)
    assert not problems
    places = {"": Where("test.toml", 1)} | {key: where(key) for key in table}
    triples = tuple((a, b, c) for a, b, c in ccw)
    solved = solve_shape(ShapeMeasures("1", link_points(table), tuple(measures["1"]), triples, places))
    return {point: place * 1e3 for point, place in solved.items()}


ROOT3 = math.sqrt(3)

KNOWN: list[tuple[str, dict[str, object], tuple[str, ...], dict[str, complex]]] = [
    ("a point", {"points": ["B"]}, (), {"B": 0}),
    ("a bar", {"DC": 48}, (), {"D": 0, "C": 48}),
    ("three lengths", {"AB": 3, "BC": 4, "CA": 5}, ("ABC",), {"A": 0, "B": 3, "C": 3 + 4j}),
    ("mirrored", {"AB": 3, "BC": 4, "CA": 5}, ("ACB",), {"A": 0, "B": 3, "C": 3 - 4j}),
    ("sides and angle", {"BD": 50, "DE": 40, "BDE": 90}, ("BDE",), {"B": 0, "D": 50, "E": 50 + 40j}),
    ("angle first", {"BDE": 90, "DE": 40, "BD": 50}, ("BDE",), {"B": 0, "D": 50, "E": 50 + 40j}),
    ("two angles", {"AB": 2, "BAC": 60, "ABC": 60}, ("ABC",), {"A": 0, "B": 2, "C": 1 + ROOT3 * 1j}),
    ("angle at the new point", {"AB": 2, "BAC": 60, "ACB": 60}, ("ABC",), {"A": 0, "B": 2, "C": 1 + ROOT3 * 1j}),
    ("right angle at the new point", {"AB": 5, "AC": 4, "ACB": 90}, ("ABC",), {"A": 0, "B": 5, "C": 3.2 + 2.4j}),
    ("obtuse", {"AB": ROOT3, "AC": 1, "ACB": 120}, ("ABC",), {"A": 0, "B": ROOT3, "C": ROOT3 / 2 + 0.5j}),
    ("on one line", {"AB": 20, "BC": 20, "AC": 40}, (), {"A": 0, "B": 20, "C": 40}),
    ("on one line, decimals", {"AB": 0.1, "BC": 0.2, "AC": 0.3}, (), {"A": 0, "B": 0.1, "C": 0.3}),
    ("on one line, the other way", {"AB": 20, "BC": 50, "AC": 30}, (), {"A": 0, "B": 20, "C": -30}),
    ("straight angle", {"AB": 20, "BC": 30, "ABC": 180}, (), {"A": 0, "B": 20, "C": 50}),
    ("no angle", {"AB": 20, "AC": 30, "BAC": 0}, (), {"A": 0, "B": 20, "C": 30}),
    (
        "two triangles",
        {"AB": 2, "BC": 2, "CA": 2, "CD": 2, "BD": 2},
        ("ABC", "BDC"),
        {"A": 0, "B": 2, "C": 1 + ROOT3 * 1j, "D": 3 + ROOT3 * 1j},
    ),
    (
        "all six lengths need one triple",
        {"AB": 1, "BC": 1, "CD": 1, "DA": 1, "AC": math.sqrt(2), "BD": math.sqrt(2)},
        ("ACD",),
        {"A": 0, "B": 1, "C": 1 + 1j, "D": 1j},
    ),
    (
        "a triple of points that come late",
        {"AB": 1, "BC": 1, "CA": math.sqrt(2), "AD": 1, "DC": 1, "DB": math.sqrt(2)},
        ("BCD",),
        {"A": 0, "B": 1, "C": 1 + 1j, "D": 1j},
    ),
    (
        "a chain of angles",
        {"AB": 1, "BC": 1, "ABC": 90, "CD": 1, "BCD": 90},
        ("ABC", "BCD"),
        {"A": 0, "B": 1, "C": 1 + 1j, "D": 1j},
    ),
    (
        "the only length comes last",
        {"BAC": 60, "ABC": 60, "BCD": 60, "CBD": 60, "CD": 2},
        ("ABC", "BDC"),
        {"B": 0, "A": 2, "C": 1 - ROOT3 * 1j, "D": -1 - ROOT3 * 1j},
    ),
]


@pytest.mark.parametrize(("table", "ccw", "expected"), [k[1:] for k in KNOWN], ids=[k[0] for k in KNOWN])
def test_known_figures(table: dict[str, object], ccw: tuple[str, ...], expected: dict[str, complex]) -> None:
    found = shape(table, *ccw)
    assert list(found) == list(expected)
    assert list(found.values()) == pytest.approx(list(expected.values()), abs=1e-9)


def test_a_bar_lies_exactly_on_its_axis() -> None:
    found = shape({"BC": 85.44003745317531, "CE": 30, "BE": 70}, "BCE")
    assert found["B"] == 0
    assert found["C"].imag == 0


BAD: list[tuple[type[GraphkinError], dict[str, object], tuple[str, ...], int, str, str]] = [
    (TooFewMeasures, {"AB": 3, "points": ["A", "B", "C"]}, (), 1, "nothing fixes C in link 1", "点 C 未定"),
    (TooFewMeasures, {"points": ["A", "B"]}, (), 1, "nothing fixes A, B", "点 A, B 未定"),
    (TooFewMeasures, {"AB": 3, "BC": 4}, (), 1, "nothing fixes C", "点 C"),
    (TooFewMeasures, {"AB": 3, "CD": 4}, (), 1, "nothing fixes C, D", "点 C, D"),
    (TooFewMeasures, {"ABC": 90, "BCA": 45}, (), 1, "nothing fixes A, B, C", "点 A, B, C"),
    (TooFewMeasures, {"AB": 5, "AC": 6, "ACB": 30}, ("ABC",), 1, "nothing fixes C", "点 C"),
    (NoTriangle, {"AB": 3, "BC": 4, "CA": 8}, (), 3, "AB, BC, CA cannot close a triangle: 1 mm", "差 1 mm"),
    (NoTriangle, {"AB": 9, "BC": 4, "CA": 3}, (), 3, "2 mm are lacking", "差 2 mm"),
    (MissingCcw, {"AB": 3, "BC": 4, "CA": 5}, (), 1, '["A", "B", "C"] or ccw = ["A", "C", "B"]', "镜像"),
    (
        MissingCcw,
        {"AB": 2, "BC": 2, "CA": 2, "CD": 2, "BD": 1},
        ("ABC",),
        1,
        'ccw = ["A", "B", "D"]',
        "逆时针顺序",
    ),
    (CcwOnLine, {"AB": 1, "BC": 1, "CA": 2}, ("ABC",), 1, "A, B, C lie on one line", "三点共线"),
    (CcwOnLine, {"AB": 3, "BC": 4, "CA": 5}, ("ABC", "AAB"), 1, "A, A, B lie on one line", "三点共线"),
    (CcwContradicts, {"AB": 3, "BC": 4, "CA": 5}, ("ABC", "BAC"), 1, "B, A, C cannot run", "不可能是逆时针"),
    (
        Contradiction,
        {"AB": 1, "BC": 1, "CD": 1, "DA": 1, "AC": math.sqrt(2), "BD": 1.5},
        ("ABC",),
        6,
        "BD disagrees with the other measures of link 1 by 0.0858 mm",
        "相差 0.0858 mm",
    ),
    (Contradiction, {"AB": 3, "BC": 4, "CA": 5, "ABC": 80}, ("ABC",), 4, "ABC disagrees", "ABC 与构件 1"),
    (Contradiction, {"AB": 3, "AC": 2, "ABC": 90}, ("ABC",), 3, "ABC disagrees", "ABC 与构件 1"),
    (Contradiction, {"AB": 3, "BAC": 90, "ABC": 90}, ("ABC",), 3, "ABC disagrees", "ABC 与构件 1"),
]


@pytest.mark.parametrize(("kind", "table", "ccw", "line", "english", "chinese"), BAD)
def test_figures_that_cannot_be(
    kind: type[GraphkinError],
    table: dict[str, object],
    ccw: tuple[str, ...],
    line: int,
    english: str,
    chinese: str,
) -> None:
    with pytest.raises(kind) as caught:
        shape(table, *ccw)
    assert caught.value.where.line == line  # type: ignore[attr-defined]
    assert english in caught.value.message("en")
    assert chinese in caught.value.message("zh")


def test_a_chain_of_very_many_points() -> None:
    def strip(count: int) -> dict[str, object]:
        names = [f"A{n}" for n in range(count)]
        sides: dict[str, object] = {f"{a}{b}": 1 for a, b in pairwise(names)}
        return sides | {f"{a}{b}": 2 for a, b in zip(names, names[2:])}

    assert shape(strip(50))["A49"] == pytest.approx(49)
    with pytest.raises(TooManyPoints, match="more than 50 points"):
        shape(strip(51))


def test_very_many_mirror_images_end() -> None:
    table: dict[str, object] = {"BC": 70} | {f"{a}E{n}": 60 for n in range(45) for a in "BC"}
    with pytest.raises(MissingCcw):
        shape(table)
    with pytest.raises(TooFewMeasures):
        shape(table | {"points": ["F"]})


PLACES = st.lists(st.builds(complex, st.integers(-50, 50), st.integers(-50, 50)), min_size=3, max_size=6, unique=True)


def _turn(places: dict[str, complex], triple: str) -> float:
    a, b, c = (places[point] for point in triple)
    return ((b - a).conjugate() * (c - a)).imag


@settings(deadline=None, max_examples=150)
@given(PLACES, st.randoms(use_true_random=False))
def test_a_measured_figure_is_found_again(places: list[complex], shuffle: st.DataObject) -> None:
    """Measure a random figure with all lengths and triples, in any order: the same figure comes out."""
    drawn = dict(zip("ABCDEF", places))
    pairs = list(combinations(drawn, 2))
    shuffle.shuffle(pairs)  # type: ignore[attr-defined]
    table: dict[str, object] = {a + b: abs(drawn[b] - drawn[a]) for a, b in pairs}
    ccw = ["".join(t) if _turn(drawn, "".join(t)) > 0 else t[0] + t[2] + t[1] for t in combinations(drawn, 3)]
    found = shape(table, *(triple for triple in ccw if abs(_turn(drawn, triple)) > 0.5))
    first, second = list(found)[:2]
    turn = drawn[second] - drawn[first]
    for point, place in found.items():
        assert place == pytest.approx((drawn[point] - drawn[first]) * abs(turn) / turn, abs=1e-6)


@settings(deadline=None, max_examples=150)
@given(st.floats(5, 100), st.floats(5, 100), st.floats(5, 175))
def test_a_triangle_by_any_three_measures(one: float, other: float, angle_deg: float) -> None:
    """Side-angle-side, side-side-side and angle-side-angle give the same triangle."""
    corner = cmath.rect(other, math.radians(angle_deg))
    third = abs(corner - one)
    angle_b = math.degrees(cmath.phase((0 - one) / (corner - one)))
    for table in (
        {"AB": one, "AC": other, "BAC": angle_deg},
        {"AB": one, "BC": third, "AC": other},
        {"AB": one, "BAC": angle_deg, "ABC": abs(angle_b)},
    ):
        assert shape(dict(table), "ABC")["C"] == pytest.approx(corner, rel=1e-6, abs=1e-5)
