"""The sheet of groups that no compass reaches, of wheels, and of cams."""

from __future__ import annotations

import math
import re
import xml.etree.ElementTree as ET
from itertools import accumulate
from typing import Literal

import pytest
from gallery import FIGURES
from library_sheets import library_sheet, plain_text, solved

from graphkin.files import library, loads
from graphkin.model.quantities import Centre, read
from graphkin.planning import plan
from graphkin.proof.readings import readings
from graphkin.running import replay_all
from graphkin.say.entry import Sentence
from graphkin.say.explained import derivation
from graphkin.sheet import Sheet, sheet
from graphkin.sheet.marks import Disc, PointMark, Stroke, Text


def dots(page: Sheet) -> dict[str, PointMark]:
    return {mark.name: mark for mark in page.marks if isinstance(mark, PointMark) and mark.plane == "position"}


def circles(page: Sheet, pen: str) -> list[Disc]:
    return [mark for mark in page.marks if isinstance(mark, Disc) and mark.pen == pen]


@pytest.mark.parametrize("name", library.names())
def test_no_name_of_the_equivalent_is_lettered(name: str) -> None:
    """In the gallery, which holds what is drawn now."""
    for each in ET.parse(FIGURES / name / f"{name}.svg").iter("{http://www.w3.org/2000/svg}text"):
        text = "".join(each.itertext())
        assert not re.search(r"origin|\be? ?c0|\br0|pin \w\d|_|\^", text), text


@pytest.mark.parametrize(("name", "of"), [("ex3-2", "S4"), ("s3-sieve", "S3"), ("p3-15", "S3"), ("p3-17", "S3")])
def test_the_special_point_lies_on_the_lines_of_two_legs(name: str, of: str) -> None:
    page = library_sheet(name)
    point = dots(page)["S"]
    assert point.of == of
    through = [
        mark for mark in page.marks
        if isinstance(mark, Stroke) and mark.pen == "thin" and len(mark.places) == 2 and mark.step == point.step
        and abs(((mark.places[1] - mark.places[0]).conjugate() * (point.at - mark.places[0])).imag) < 1e-6
    ]  # fmt: skip
    assert len(through) == 2


@pytest.mark.parametrize(
    ("name", "letters"),
    [("ex3-3", "KL"), ("p3-12", "KL"), ("p3-16", "KL"), ("p3-19", "L"), ("s4-ex2", "K"), ("s4-ex4", "KL"),
     ("s4-ex5", "K"), ("s4-ex6", "L")],
)  # fmt: skip
def test_contacts_lie_on_the_wheels(name: str, letters: str) -> None:
    """None is K where a guide turns: k' may be the tip of a Coriolis acceleration."""
    page = library_sheet(name)
    rims = circles(page, "centre") + circles(page, "outline")
    for letter in letters:
        mark = dots(page)[letter]
        assert mark.of == letter
        assert any(abs(abs(mark.at - rim.centre) - rim.radius) < 1e-6 for rim in rims)


def test_the_image_of_a_gear_is_a_circle_of_radius_omega_r() -> None:
    page, (_, plot) = library_sheet("p3-12"), solved("p3-12")
    points = [m for m in page.marks if isinstance(m, PointMark) and m.plane == "velocity"]  # without those of details
    scale, places = page.scales["velocity"], {m.name: m.at for m in points}
    found = {(disc.centre, round(disc.radius, 6)) for disc in circles(page, "thin")}
    radii = {"1": 0.030, "2": 0.020, "3": 0.025}
    for link, centre in (("1", "b"), ("2", "c"), ("3", "p")):
        assert (places[centre], round(abs(float(plot.omega[link])) * radii[link] / scale, 6)) in found
    assert {"g1", "g2", "g3"} <= {plain_text(m.label) for m in page.marks if isinstance(m, Text)}


def test_the_image_of_a_fixed_gear_is_a_point() -> None:
    texts = {plain_text(m.label) for m in library_sheet("s4-ex4").marks if isinstance(m, Text)}
    assert "p, o1, g3" in texts
    assert len(circles(library_sheet("s4-ex4"), "thin")) == 2


def test_wheels_are_drawn_once() -> None:
    discs = [
        (disc.centre, disc.radius) for disc in circles(library_sheet("p3-16"), "centre") + circles(library_sheet("p3-16"), "outline")
        if disc.shows is not None
    ]
    assert len(discs) == len(set(discs)) == 2


@pytest.mark.parametrize("name", ["fig2-32", "fig3-5", "p3-8", "s3-1-18a", "s3-1-18b", "s3-cam"])
def test_a_cam_has_its_equivalent_over_it_in_dashes(name: str) -> None:
    assert [mark for mark in library_sheet(name).marks if isinstance(mark, Stroke) and mark.pen == "dashed"]


@pytest.mark.parametrize(("lang", "fitted", "together"), [
    ("en", "Mechanism: fitted by trial", "solved together"), ("zh", "机构运动简图：样板法试凑", "联立求解"),
])  # fmt: skip
def test_the_sheet_says_what_paper_alone_does_not_give(
    lang: Literal["en", "zh"], fitted: str, together: str
) -> None:  # fmt: skip
    """The ratios of a gear train give its position and its motions; what is solved together is over the equations."""
    for name, said in (("p3-15", {fitted}), ("ex3-3", set())):
        texts = {plain_text(m.label) for m in sheet(*solved(name), lang=lang).marks if isinstance(m, Text)}
        assert {fitted, together} & texts == said


CRANK = '[frame]\nA = [0, 0]\nD = [100, 0]\n[links.1]\nAB = 60\n[[driver]]\nvector = "AB"\nangle = 40\nomega = 1\n'
ALONE, BAR = '[links.3]\npoints = ["D"]\n', '[links.3]\nDE = 50\n'
PIN, BLOCK = '[[slide]]\npin = "B"\n', '[links.2]\npoints = ["B"]\n[[slide]]\nblock = "2"\npoint = "B"\n'


@pytest.mark.parametrize(("guide", "runs", "sign"), [
    (ALONE, PIN, {"slot"}), (BAR, PIN, {"slot"}), (ALONE, BLOCK, set()), (BAR, BLOCK, {"block"}),
])  # fmt: skip
def test_a_pin_runs_in_a_slot_and_a_piston_in_a_cylinder(guide: str, runs: str, sign: set[str]) -> None:
    """Only a block on a link of one point is the piston of a cylinder."""
    line = 'guide = "3"\nthrough = "D"\n' + ('toward = "E"\n' if guide == BAR else "")
    method = plan(loads(CRANK + guide + runs + line))
    shown = [mark.shows for mark in sheet(method, replay_all(method)).marks if getattr(mark, "shows", None)]
    assert {each.form for each in shown} & {"slot", "block"} == sign
    assert any(each.form == "guide" and not each.points for each in shown) == (not sign)


CROSSED = """
[frame]
A = [0, 0]
D = [40, 0]
[links.1]
AB = 80
[links.2]
BC = 40
[links.3]
DC = 80
[[driver]]
vector = "AB"
angle = 60
omega = 10
[sketch]
C = [10, 70]
"""


def test_the_rear_link_is_broken_where_another_goes_over_it() -> None:
    """The bars AB and DC cross in their middle; the gap is in the rear one, from the step on in which both are there."""
    method = plan(loads(CROSSED))
    page = sheet(method, replay_all(method))
    bars = {m.shows.link: m for m in page.marks if isinstance(m, Stroke) and m.shows and m.shows.form == "bar"}
    (broken,) = (mark for mark in bars.values() if mark.dashes)
    assert broken is bars["1"]
    assert broken.dashes[:2] == pytest.approx((0.04 / page.scales["position"] - 1.5, 3.0))
    assert broken.step == 1
    assert not any(mark.breaks for mark in page.upto(1).marks if isinstance(mark, Stroke))


def test_an_eccentricity_stands_on_the_drawing() -> None:
    written = {plain_text(mark.label) for mark in library_sheet("p3-23a").marks if isinstance(mark, Text)}
    assert "30 mm" in written
    assert not any("eA" in text for text in written)


def unnamed(page: Sheet, pen: str) -> list[Stroke]:
    """Lines of the mechanism that show no line of a link."""
    marks = (mark for layer in page.layers if layer.name == "mechanism" for mark in layer.marks)
    return [mark for mark in marks if isinstance(mark, Stroke) and mark.pen == pen and mark.shows is None]


def test_racks_have_teeth_about_their_pitch_line_and_rolling_discs_have_none() -> None:
    teeth = {name: [mark for mark in unnamed(library_sheet(name), "outline") if len(mark.places) > 12]
             for name in ("p3-19", "s4-ex6", "p3-12", "p3-16")}  # fmt: skip
    assert [len(marks) for marks in teeth.values()] == [1, 0, 2, 2]  # of the two wheels of p3-16, one on a fixed rack
    (rack,), points = teeth["p3-19"], dots(library_sheet("p3-19"))
    start, along = points["B"].at, points["Q"].at - points["B"].at
    offs = [(place - start) / along for place in rack.places[:-2]]
    assert all(0 < off.real < 1 for off in offs)
    assert max(off.imag for off in offs) == pytest.approx(-min(off.imag for off in offs))


def test_a_dimension_stands_once() -> None:
    for name, figure in (("p3-18", "257.1 mm"), ("p3-21", "90 mm"), ("s4-ex6", "50 mm")):
        written = [plain_text(mark.label) for mark in library_sheet(name).marks if isinstance(mark, Text)]
        assert sum(text.rpartition("= ")[2].startswith(figure) for text in written) == 1, name


def test_a_hinge_is_a_circle_about_its_point_and_a_bar_goes_on_over_it() -> None:
    page = library_sheet("p3-20")
    hinge = dots(page)["B"]
    assert hinge.fill == "paper"
    assert [sum(mark.places) / 2 for mark in unnamed(page, "visible")] == [pytest.approx(hinge.at)]


@pytest.mark.parametrize(("name", "centre"), [("p3-12", "P13"), ("fig3-4", "P24"), ("p3-13", "P13")])
def test_an_asked_centre_is_drawn_where_it_is_and_only_in_the_end(name: str, centre: str) -> None:
    page, (method, plot) = library_sheet(name), solved(name)
    quantity = read(method.mechanism, centre)
    assert isinstance(quantity, Centre)
    at, scale = complex(quantity.place(readings(method, plot))), page.scales["position"]
    place = page.origins["position"] + at.conjugate() / scale
    rings = [mark for mark in circles(page, "thin") if abs(mark.centre - place) < 1e-6]
    assert len(rings) == 2
    assert rings[0] not in page.upto(rings[0].step - 1).marks if rings[0].step else False


def test_a_bar_gives_way_to_a_hinge_that_is_none_of_its() -> None:
    """EF passes C in an engine with an adjustable stroke."""
    page = library_sheet("p3-21")
    hinge = dots(page)["C"]
    bars = [mark for mark in page.marks if isinstance(mark, Stroke) and mark.shows and mark.shows.form == "bar"]
    (bar,) = (mark for mark in bars if mark.shows and mark.shows.link == "4")
    off = (hinge.at - bar.places[0]) / (bar.places[1] - bar.places[0]) * abs(bar.places[1] - bar.places[0])
    half = math.sqrt(max(0.0, hinge.radius**2 - off.imag**2))  # of what lies under the hinge
    ends = [0.0, *accumulate(bar.dashes)]
    gaps = list(zip(ends[1::2], ends[2::2], strict=False))
    for beside in (off.real - half - 0.5, off.real + half + 0.5):
        assert any(low < beside < high for low, high in gaps)


def test_no_gap_cuts_a_crumb_off_the_end_of_a_link() -> None:
    """The bar DC goes over AB just before its end B: it makes way itself."""
    method = plan(loads(CROSSED.replace("AB = 80", "AB = 45").replace("BC = 40", "BC = 37.35").replace("[10, 70]", "[4, 72]")))
    marks = sheet(method, replay_all(method)).marks
    bars = {m.shows.link: m for m in marks if isinstance(m, Stroke) and m.shows and m.shows.form == "bar"}
    assert [link for link, mark in bars.items() if mark.dashes] == ["3"]


PUSHED = """
ask = ["v F"]
frame = { name = "3", A = [0, 0] }
links = { 1.AB = 25, 2.points = ["F"] }
cam = [{ links = ["1", "2"], profiles = [{ centre = "B", radius = 45 }, { through = "F", angle = 0 }] }]
slide = [{ block = "2", point = "F", guide = "frame", through = "A", angle = 90 }]
driver = [{ vector = "AB", angle = 35, omega = -12 }]
sketch = { F = [0, 60] }
"""


@pytest.mark.parametrize(
    ("asked", "shown"), [('["v F"]', 1), ('["v F", "P12"]', 1), ('["a F"]', 0), ("[]", 1), ('["theta 1"]', 1)]
)
def test_the_centre_by_which_a_contact_gives_a_velocity_is_shown(asked: str, shown: int) -> None:
    """With its common normal, where the solution takes that road, and once where it is asked for, too."""
    method = plan(loads(PUSHED.replace('["v F"]', asked)))
    plot = replay_all(method)
    letters = [plain_text(mark.label) for mark in sheet(method, plot).marks if isinstance(mark, Text)]
    entries = derivation(method, plot, {"length": 1e-3, "velocity": 1e-2, "acceleration": 0.1}, "en", everything=False)
    told = any("P12" in entry.text for entry in entries if isinstance(entry, Sentence))
    assert told == bool(shown)
    assert ("P12" in letters) == bool(shown)
    assert letters.count("n") == 2 * shown
    given = [plain_text(mark.label) for mark in sheet(method, plot, style="given").marks if isinstance(mark, Text)]
    assert not {"P12", "n"} & {*given}
