"""Sheets of mechanisms of other textbooks: what is written stands where it is read as meant."""

from __future__ import annotations

import cmath
import math
import re
from itertools import combinations, pairwise

import pytest
from library_sheets import library_sheet, plain_text, textbook_sheet

from graphkin import Drawing
from graphkin.base.lines import crossing, off_stretch
from graphkin.files import library
from graphkin.sheet import Sheet
from graphkin.sheet.lettering import box
from graphkin.sheet.marks import ArcMark, PointMark, Stroke, Text, VectorMark
from graphkin.sheet.obstacles import arc_places


def middle(mark: Text) -> complex:
    wide, up, down = box(mark.label, mark.size)
    return mark.at + cmath.rect(1, mark.turn) * complex(wide, down - up) / 2


def texts(page: Sheet, word: str) -> list[Text]:
    return [mark for mark in page.marks if isinstance(mark, Text) and plain_text(mark.label) == word]


def point(page: Sheet, name: str) -> complex:
    return next(mark.at for mark in page.marks
                if isinstance(mark, PointMark) and mark.plane == "position" and mark.name == name)  # fmt: skip


def turning(page: Sheet) -> list[ArcMark]:
    return [mark for mark in page.marks if isinstance(mark, ArcMark) and mark.pen == "vector"]


@pytest.mark.parametrize(("lang", "words"), [("en", "α3 and αarm solved together"), ("zh", "α3、αarm 联立求解")])
def test_what_is_solved_together_stands_over_the_equations(lang: str, words: str) -> None:
    page = textbook_sheet("differential", lang)
    [row] = texts(page, words)
    [layer] = [layer.plane for layer in page.layers if row in layer.marks]
    assert layer == "acceleration"
    below = [mark.at.imag - row.at.imag for mark in texts(page, "=") if mark.at.imag > row.at.imag]
    assert min(below) < 8
    footer = [mark for mark in page.marks if isinstance(mark, Text) and mark.at.imag > page.paper.height - 24]
    assert not any("μ" in plain_text(mark.label) for mark in footer)


def test_arcs_of_drivers_about_one_point_are_apart() -> None:
    """Of two wheels about one centre, of which one is accelerated the other way."""
    page = textbook_sheet("differential")
    own = [arc for arc in turning(page) if abs(arc.centre - point(page, "O")) < 0.05 and arc.accent is None]
    assert len(own) == 3
    for one, other in combinations(own, 2):
        ends = min(abs(a - b) for a in arc_places(one) for b in arc_places(other))
        assert ends > 2.5


def test_a_length_that_no_bar_shows_has_a_dimension_line() -> None:
    """The master rod's own, from its crank pin inside its outline."""
    page = textbook_sheet("radial")
    [length] = texts(page, "152 mm")
    along = point(page, "C") - point(page, "A")
    lines = [mark.places for mark in page.marks if isinstance(mark, Stroke) and mark.pen == "thin" and len(mark.places) == 2]
    beside = [(a, b) for a, b in lines if off_stretch(middle(length), a, b) < 4 and abs(((b - a) / along).imag) < 1e-6]
    assert any(abs(abs(b - a) - abs(along)) < 0.05 for a, b in beside)


def test_the_letter_of_a_joint_is_on_its_side_of_all_bars() -> None:
    page = textbook_sheet("radial")
    at, [letter] = point(page, "O"), texts(page, "O")
    bars = [mark.outline for mark in page.marks if isinstance(mark, Stroke) and mark.shows and mark.shows.form == "bar"
            and "O" not in mark.shows.points]  # fmt: skip
    assert len(bars) > 3
    assert all(crossing(middle(letter), at, *side) is None for bar in bars for side in pairwise(bar))


def test_letters_of_arcs_are_nearest_to_them() -> None:
    page = textbook_sheet("wiper")
    blue = [arc for arc in turning(page) if arc.accent == "velocity"]
    assert len(blue) == 2
    for word, pivot in (("ω4", "D"), ("ω6", "F")):
        [name] = [mark for mark in texts(page, word) if mark.accent == "velocity"]
        near = min(blue, key=lambda arc: min(abs(at - middle(name)) for at in arc_places(arc)))
        assert abs(near.centre - point(page, pivot)) < 0.05


def test_the_arc_of_an_angle_is_apart_from_that_of_its_driver() -> None:
    """Of an angle that goes nearly all round, over the ground under its pivot."""
    page = textbook_sheet("wiper", paper="A3")
    about = [mark for mark in page.marks if isinstance(mark, ArcMark) and abs(mark.centre - point(page, "O")) < 0.05]
    assert {mark.pen for mark in about} == {"vector", "thin"}
    [drive], angles = [mark for mark in about if mark.pen == "vector"], [mark for mark in about if mark.pen == "thin"]
    assert min(abs(drive.radius - angle.radius) for angle in angles) > 1.9
    assert max(abs(angle.sweep) for angle in angles) > math.radians(300)


def test_a_knotted_polygon_is_rather_larger_than_full_of_details() -> None:
    page = textbook_sheet("slotting")
    arrows = [mark for mark in page.marks if isinstance(mark, VectorMark) and mark.plane == "acceleration"]
    assert max(abs(one.end - other.end) for one in arrows for other in arrows) > 70
    assert sum(" : 1)" in plain_text(mark.label) for mark in page.marks if isinstance(mark, Text)) == 1


def _nearest_head(page: Sheet, name: Text) -> tuple[str, str]:
    heads = [(mark.places[0], mark.shows) for mark in page.marks if isinstance(mark, Stroke) and mark.shows]
    turns = [(abs(tip - middle(name)), shows.form, shows.link) for tip, shows in heads if shows.form in ("omega", "alpha")]
    return min(turns)[1:]


@pytest.mark.parametrize(("omega", "alpha"), [(10, -20), (-10, 20)])
def test_a_crank_that_is_braked_has_each_letter_at_its_own_head(omega: float, alpha: float) -> None:
    page = Drawing.of(library.load("s3-four").with_(omega=omega, alpha=alpha)).sheet(only="position")
    for word, form in (("ω1", "omega"), ("α1", "alpha")):
        assert [_nearest_head(page, mark) for mark in texts(page, word)] == [(form, "1")]


@pytest.mark.parametrize("name", ["s3-four", "ex3-7", "s4-ex2", "s4-ex5"])
def test_the_letter_of_an_asked_turn_is_nearest_to_its_own_head(name: str) -> None:
    page = library_sheet(name)
    coloured = [mark for mark in page.marks if isinstance(mark, Text) and mark.accent in ("velocity", "acceleration")]
    names = [(mark, word) for mark in coloured if re.fullmatch(r"[ωα]\d+", word := plain_text(mark.label))]
    assert len(names) > 1
    for mark, word in names:
        assert _nearest_head(page, mark) == ({"ω": "omega", "α": "alpha"}[word[0]], word[1:])


def test_the_arc_of_an_angle_is_off_that_of_a_short_crank() -> None:
    """A crank of 7 mm on paper: its arm is drawn on to the arc of its angle."""
    page = Drawing.of(library.load("s3-four").with_(AB=4)).sheet()
    arcs = [mark for mark in page.marks if isinstance(mark, ArcMark) and abs(mark.centre - point(page, "A")) < 0.05]
    assert {arc.pen for arc in arcs} == {"thin", "vector"}
    assert abs(point(page, "B") - point(page, "A")) < 8.5
    assert min(one.radius for one in arcs if one.pen == "thin") > 2 + max(one.radius for one in arcs if one.pen == "vector")
