"""The sheet of a design, measured: it is at scale, letters lie on nothing, steps come one after the other."""

import cmath
import math
from itertools import pairwise
from xml.etree import ElementTree

import numpy as np
import pytest
from designs import DESIGNS, rad

import graphkin
from graphkin import files as loading
from graphkin.errors import NoDesign
from graphkin.outputs.svg import svg
from graphkin.say.design import judgement, mechanism_of
from graphkin.sheet.design_sheet import design_sheet
from graphkin.sheet.lettering import box, formula
from graphkin.sheet.marks import Stroke, Text
from graphkin.sheet.obstacles import obstacles
from graphkin.sheet.page import step_sheets
from graphkin.studies.design import angle_pairs, coupler_positions, hinges, rocker


def words(mark):
    return "".join(run.text for run in mark.label)


@pytest.mark.parametrize("name", DESIGNS)
def test_links_are_drawn_at_scale(name):
    one = DESIGNS[name].best
    sheet = design_sheet(DESIGNS[name])
    scale = sheet.scales["position"]
    drawn = {mark.shows.link if mark.shows else "": abs(mark.places[1] - mark.places[0]) * scale
             for mark in sheet.marks if isinstance(mark, Stroke) and mark.pen == "visible"}  # fmt: skip
    assert drawn["1"] == pytest.approx(one.a, abs=1e-9)
    if one.shape != "guide-bar":
        assert drawn["2"] == pytest.approx(one.b, abs=1e-9)
    if one.shape == "four-bar":
        assert drawn["3"] == pytest.approx(one.c, abs=1e-9)
    thin = [mark for mark in sheet.marks if isinstance(mark, Stroke) and mark.pen == "thin"]
    for places in one.limits:
        b = (places["B"] - places["A"]).conjugate() / scale
        assert any(abs(mark.places[1] - mark.places[0] - b) < 1e-6 for mark in thin), "a position asked for is missing"


def test_a_linkage_that_does_not_do_says_why():
    design = angle_pairs([(rad(30), rad(50)), (rad(60), rad(75)), (rad(100), rad(110))], frame=0.08)
    assert not design.best.valid
    said = "\n".join(words(mark) for mark in design_sheet(design).marks if isinstance(mark, Text))
    assert "This does not do: AB comes out negative" in said


@pytest.mark.parametrize("lang", ["en", "zh"])
@pytest.mark.parametrize("name", DESIGNS)
def test_what_is_said_of_a_design_stands_on_its_sheet(name, lang):
    one = DESIGNS[name].best
    told = "".join(words(mark) for mark in design_sheet(DESIGNS[name], lang=lang).marks if isinstance(mark, Text))
    for text in judgement(one, lang):
        assert "".join(run.text for run in formula(text)).replace(" ", "") in told.replace(" ", "")
    assert (one.pace is not None) == (("slow stroke" if lang == "en" else "慢行程") in told)


CLOCKWISE = coupler_positions(hinges([0.05j, 0.03 + 0.065j, 0.065 + 0.06j], [0, rad(-15), rad(-40)], 0.05))


@pytest.mark.parametrize("design", [*DESIGNS.values(), CLOCKWISE])
def test_the_crank_turns_as_the_positions_follow_each_other(design):
    one = design.best
    turned = [places["B"] - places["A"] for places in one.limits]
    way = mechanism_of(one, design.kind).drivers[0].rate
    if one.pace is None and one.valid:
        passed = [cmath.phase(other / first) * way % math.tau for first, other in pairwise(turned)]
        assert sum(passed) < math.tau
    elif one.pace is not None:
        slow = cmath.phase(turned[1] / turned[0]) * way % math.tau
        assert slow == pytest.approx(math.pi + one.theta)


def test_one_length_has_one_figure_and_given_positions_have_their_number():
    told = "".join(words(mark) for mark in design_sheet(rocker(0.075, rad(45), 1.25, frame=0.08)).marks if isinstance(mark, Text))
    assert told.count("61.2534") == told.count("111.002") == 3
    assert "111.00 " not in told
    numbers = [words(mark) for mark in design_sheet(CLOCKWISE).marks if isinstance(mark, Text)]
    assert "①" in numbers
    for name in ("rocker", "slider"):
        told = "".join(words(mark) for mark in design_sheet(DESIGNS[name]).marks if isinstance(mark, Text))
        assert "meet it again at F and G" in told


def test_a_range_is_not_called_as_a_direction():
    texts = [words(mark) for mark in design_sheet(DESIGNS["pairs"]).marks if isinstance(mark, Text)]
    assert "ψ1 = 60°" in texts
    assert "Δψ" in texts
    assert "ψ" not in texts


@pytest.mark.parametrize("name", DESIGNS)
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_letters_lie_on_nothing_and_on_the_paper(name, lang):
    sheet = design_sheet(DESIGNS[name], lang=lang)
    texts = [mark for mark in sheet.marks if isinstance(mark, Text)]
    others = obstacles(mark for mark in sheet.marks if not isinstance(mark, Text) and getattr(mark, "pen", "") != "leader")
    low, high = [], []
    for mark in texts:
        wide, up, down = box(mark.label, mark.size)
        low.append((mark.at.real + 0.05, mark.at.imag - up + 0.05))
        high.append((mark.at.real + wide - 0.05, mark.at.imag + down - 0.05))
    low, high = np.array(low), np.array(high)
    assert (low > 10).all()
    assert (high < (sheet.paper.width - 10, sheet.paper.height - 10)).all()
    assert [words(texts[k]) for k in np.flatnonzero(others.touched(low.T, high.T))] == []
    over = (low[:, None] < high[None]).all(-1) & (high[:, None] > low[None]).all(-1)
    np.fill_diagonal(over, False)
    assert not over.any()


@pytest.mark.parametrize("name", DESIGNS)
def test_steps_add_up_to_the_sheet(name):
    design = DESIGNS[name]
    whole = design_sheet(design)
    sheets = list(step_sheets(whole))
    assert len(sheets) >= len(design.best.construction.stages) - 2
    assert [len(s.marks) for s in sheets] == sorted({len(s.marks) for s in sheets})
    assert len(sheets[-1].marks) == len(whole.marks)
    assert all(any(mark.new for mark in sheet.marks) for sheet in sheets)
    assert not any(mark.shows and mark.shows.link for mark in sheets[0].marks if isinstance(mark, Stroke)), "the linkage comes last"


def test_the_drawing_of_example_2_3_tells_its_numbers():
    sheet = design_sheet(DESIGNS["rocker"], lang="zh")
    told = [words(mark) for mark in sheet.marks if isinstance(mark, Text)]
    for text in ("θ = 23.478°", "ψ = 40°", "AB", "20.77 mm", "BC", "89.96 mm", "F", "G", "P", "O", "C1", "C2"):
        assert text in told
    assert sheet.scales["position"] == 0.001


@pytest.mark.many
@pytest.mark.parametrize("name", DESIGNS)
def test_sheets_are_written_and_the_linkage_is_drawn(name):
    design = DESIGNS[name]
    text = svg(design_sheet(design, lang="zh"))
    assert ElementTree.fromstring(text.split("\n", 1)[1]).tag.endswith("svg")
    assert text == svg(design_sheet(design, lang="zh"))
    mechanism = loading.loads(mechanism_of(design.best, design.kind).text)
    assert len(graphkin.Drawing.of(mechanism).sheet(lang="zh").marks) > 20


def test_every_paper_and_size():
    for size in (1e-3, 1.0, 40.0):
        for paper in ("A4", "A3-landscape", None):
            sheet = design_sheet(rocker(0.08 * size, rad(75), 1.15, gamma_min=rad(20)), paper=paper)
            assert paper in (None, sheet.paper.name)
            for mark in sheet.marks:
                places = mark.places if isinstance(mark, Stroke) else ()
                assert all(9.9 <= z.real <= sheet.paper.width - 9.9 for z in places)
                assert all(9.9 <= z.imag <= sheet.paper.height - 9.9 for z in places)


def test_without_a_solution_there_is_no_sheet():
    found = rocker(0.080, math.radians(40), 1.3, frame=0.3)
    with pytest.raises(NoDesign) as caught:
        design_sheet(found)
    assert "179.67 mm" in caught.value.message("en")
    assert "机架" in caught.value.message("zh")
