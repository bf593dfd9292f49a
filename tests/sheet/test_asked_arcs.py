"""Arcs of the angular velocities and accelerations that are asked for: none is missing where others are drawn."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import chain, combinations

import pytest
from every_family import FAMILIES
from library_sheets import library_sheet, textbook_sheet

from graphkin.base.lines import off_stretch
from graphkin.errors import Lang
from graphkin.files import loads
from graphkin.planning import plan
from graphkin.running import replay_all
from graphkin.say.reading import Reading
from graphkin.sheet import Sheet, sheet
from graphkin.sheet.marks import ArcMark, PointMark, Stroke, Text

BOWL = """
ask = ["omega wheel", "alpha wheel", "v P", "a P"]
[frame]
O = [0, 0]
[links.arm]
OC = 300
[links.wheel]
CP = 100
[[roll]]
wheel = "wheel"
centre = "C"
radius = 100
on = "frame"
on_centre = "O"
on_radius = 400
internal = true
[[driver]]
vector = "OC"
angle = -60
omega = "30 deg/s"
alpha = "20 deg/s²"
[[pose]]
vector = "CP"
from = "OC"
angle = 90
"""
PLANET = """
ask = ["omega 2", "v P", "a P", "omega 3"]
[frame]
name = "0"
A = [0, 0]
[links.1]
points = ["A"]
[links.H]
AB = 90
[links.2]
BP = 30
[links.3]
points = ["A"]
[[gear]]
links = ["1", "2"]
centres = ["A", "B"]
radii = [60, 30]
[[gear]]
links = ["2", "3"]
centres = ["B", "A"]
radii = [30, 120]
internal = true
[[driver]]
link = "1"
omega = "90 rpm"
[[driver]]
vector = "AB"
angle = 120
omega = "-30 rpm"
[[pose]]
vector = "BP"
angle = 30
"""
COLLAR = """
ask = ["omega rod", "alpha rod", "v E", "a E"]
[frame]
A = [0, 0]
C = ["-1.2 ft", "1 ft"]
[links.crank]
AB = "0.6 ft"
[links.rod]
shape = { B = [0, 0], M = ["1.5 ft", 0], E = ["2.5 ft", "0.4 ft"] }
[links.collar]
points = ["C"]
[[slide]]
name = "collar"
block = "collar"
point = "C"
guide = "rod"
through = "B"
toward = "M"
[[driver]]
vector = "AB"
angle = "35°"
velocity = "-3 ft/s"
[sketch]
B = [150, 100]
M = [-100, 200]
E = [-400, 400]
"""


@pytest.mark.parametrize(("text", "asked"), [
    (BOWL, {("wheel", "omega"), ("wheel", "alpha")}), (PLANET, {("2", "omega"), ("3", "omega")}),
    (COLLAR, {("rod", "omega"), ("rod", "alpha")}),
])  # fmt: skip
def test_each_asked_turn_has_its_arc(text: str, asked: set[tuple[str, str]]) -> None:
    method = plan(loads(text))
    shown = [shows for mark in sheet(method, replay_all(method)).marks if (shows := getattr(mark, "shows", None))]
    assert asked <= {(shows.link, shows.form) for shows in shown}
    for link in {link for link, _ in asked}:  # about one middle
        assert len({shows.points for shows in shown if shows.link == link and shows.form in ("omega", "alpha")}) == 1


def turning_arcs(page: Sheet) -> Iterator[tuple[Stroke, ArcMark]]:
    """The head of each asked turn with its arc."""
    arcs = [mark for mark in page.marks if isinstance(mark, ArcMark)]
    for head in (mark for mark in page.marks if isinstance(mark, Stroke) and mark.shows is not None):
        if head.shows and head.shows.form in ("omega", "alpha") and head.accent:
            ends = {arc: arc.centre + cmath.rect(arc.radius, arc.start + arc.sweep) for arc in arcs}
            yield head, min(arcs, key=lambda arc: min(abs(place - ends[arc]) for place in head.places))


@pytest.mark.parametrize("name", ["ex3-5", "p3-5", "p3-22", "p3-23a", "p3-6c", "s2-2", "s3-four", "s4-ex1", "s4-ex2"])
def test_no_arc_of_a_link_without_a_pivot_can_be_read_about_another_place(name: str) -> None:
    """It goes far around the middle of its link, which nothing marks, or about a point of the link near by."""
    page = library_sheet(name)
    points = [mark.at for mark in page.marks if isinstance(mark, PointMark) and mark.plane == "position"]
    seen = 0
    for head, arc in turning_arcs(page):
        assert head.shows is not None
        seen += 1
        marked = min(abs(point - arc.centre) for point in points) < 0.05
        length = arc.radius * abs(arc.sweep)
        assert marked or abs(arc.sweep) > math.radians(95) or length > 11, (head.shows.link, arc)
        crossing = arc.centre + cmath.rect(arc.radius, arc.start + arc.sweep / 2)
        near = min(points, key=lambda point: abs(point - crossing))
        about_it = abs(near - arc.centre) < 0.05 or abs(near - crossing) > 4 or abs(arc.sweep) > math.radians(95)
        assert about_it, (head.shows.link, near, crossing)
    assert seen


def test_the_arc_of_a_wheel_is_about_its_centre() -> None:
    """A planet with a bar from its middle to the pin of a connecting rod."""
    page = textbook_sheet("hypocycloid")
    centre = next(mark.at for mark in page.marks if isinstance(mark, PointMark) and mark.name == "A")
    [own] = [arc for head, arc in turning_arcs(page) if head.shows and head.shows.link == "2"]
    assert abs(own.centre - centre) < 0.05


def test_the_number_of_a_wheel_stands_off_the_bars_of_others() -> None:
    page = textbook_sheet("gearfive")
    bars = {mark.shows.link: mark.places for mark in page.marks
            if isinstance(mark, Stroke) and mark.shows and mark.shows.form == "bar"}  # fmt: skip
    letters = [mark for mark in page.marks if isinstance(mark, Text) and mark.accent == "position"]
    numbers = {mark.label[0].text: mark.at for mark in letters if len(mark.label) == 1}
    for wheel, others in (("2", "34"), ("5", "34")):
        for other in others:
            assert off_stretch(numbers[wheel] + 1 - 1.2j, *bars[other]) > 5, (wheel, other)


def test_a_chinese_sheet_takes_the_paper_of_the_english_one() -> None:
    english, chinese = textbook_sheet("gearfive"), textbook_sheet("gearfive", "zh")
    assert (english.paper.name, english.scales) == (chinese.paper.name, chinese.scales)


@pytest.mark.parametrize("name", ["s3-1-18b", "p3-7", "ex3-5"])
def test_the_head_of_a_driver_s_arc_is_off_its_ground(name: str) -> None:
    marks = library_sheet(name).marks
    heads = [mark.places for mark in marks if isinstance(mark, Stroke) and mark.shows and not mark.accent
             and mark.shows.form in ("omega", "alpha")]  # fmt: skip
    ground = [mark.places for mark in marks if isinstance(mark, Stroke) and mark.pen in ("hatch", "outline")
              and len(mark.places) == 2]  # fmt: skip
    assert heads
    assert all(off_stretch(place, *line) > 0.8 for head in heads for place in head for line in ground)


SHORT = """
ask = ["omega coupler", "alpha coupler", "omega rocker", "alpha rocker"]
[frame]
A = [0, 0]
D = [100, 0]
[links.crank]
AB = 55
[links.coupler]
BC = 18
BM = 9
CM = 9
[links.rocker]
DC = 75
[[driver]]
vector = "AB"
angle = 40
omega = 4
alpha = 3
[sketch]
B = [42, 35]
C = [58, 60]
M = [50, 46]
"""


@pytest.mark.parametrize(("family", "paper", "lang"), [
    ("cylinder", "A3-landscape", "en"), ("PPR", "A3-landscape", "zh"), ("six_bar", "A4", "en"), ("train", "A3", "zh"),
    *(pytest.param(*case, marks=pytest.mark.further) for case in (
        ("cylinder", "A3-landscape", "zh"), ("PPR", "A3-landscape", "en"), ("six_bar", "A4", "zh"), ("train", "A3", "en"))),
])  # fmt: skip
def test_asked_turns_have_arcs_where_links_are_short_and_crowded(family: str, paper: str, lang: Lang) -> None:
    """For which the number of a link moves, or is left out where the letter tells it; in the densest one letter is alone."""
    machine = FAMILIES[family](8401)
    driven = {driver.link for driver in machine.drivers}
    links = [machine.called(link) for link in machine.moving if link not in driven]
    asked = [f"{turn} {link}" for link in links for turn in ("omega", "alpha")]
    method = plan(replace(machine, ask=tuple(asked)))
    plot = replay_all(method)
    turns = Reading(method, plot, {}, "en").asked_turns(("velocity", "acceleration"))
    page = sheet(method, plot, lang=lang, paper=paper)
    shown = {(head.shows.link, head.shows.form) for head, _ in turning_arcs(page) if head.shows}
    bare = [turn for turn in turns if (turn.link, {"ω": "omega", "α": "alpha"}[turn.letter]) not in shown]
    written = ["".join(run.text for run in mark.label) for mark in page.marks if isinstance(mark, Text)]
    assert all(any(turn.letter in text and turn.link in text for text in written) for turn in bare)
    assert len(shown) == len(turns) - len(bare) > 1
    assert len(bare) <= (family == "six_bar")


def bar_of(page: Sheet, link: str) -> tuple[complex, complex]:
    """The longest side of a link."""
    lines = [mark.outline for mark in page.marks if isinstance(mark, Stroke) and mark.shows
             and (mark.shows.link, mark.shows.form, mark.shows.plane) == (link, "bar", "position")]  # fmt: skip
    return max(combinations(chain(*lines), 2), key=lambda ends: abs(ends[0] - ends[1]))


def test_arcs_cross_a_short_coupler_with_a_point_in_its_middle() -> None:
    method = plan(loads(SHORT))
    page = sheet(method, replay_all(method))
    start, end = bar_of(page, "coupler")
    arcs = [arc for head, arc in turning_arcs(page) if head.shows and head.shows.link == "coupler"]
    assert len(arcs) == 2
    for arc in arcs:
        turns = (arc.start, arc.start + arc.sweep)
        offs = [(arc.centre + cmath.rect(arc.radius, turn) - start) / (end - start) for turn in turns]
        assert off_stretch(arc.centre, start, end) < 0.05
        assert offs[0].imag * offs[1].imag < 0
        assert all(0 < off.real < 1 for off in offs)


def test_the_arc_of_a_driver_crosses_its_link_where_its_vector_is_short() -> None:
    """A crank with three points, driven by the direction to one that is close to its pivot."""
    text = SHORT.replace("AB = 55", "shape = { A = [0, 0], B = [55, 0], E = [2, 1] }").replace('"AB"', '"AE"')
    method = plan(loads(text.replace("angle = 40", "angle = 66").replace("M = [50, 46]", "M = [50, 46]\nE = [1, 2]")))
    page = sheet(method, replay_all(method))
    pivot = next(mark.at for mark in page.marks if isinstance(mark, PointMark) and mark.name == "A")
    far = max(bar_of(page, "crank"), key=lambda place: abs(place - pivot))
    [arc] = [mark for mark in page.marks if isinstance(mark, ArcMark) and abs(mark.centre - pivot) < 0.05
             and mark.pen == "vector"]  # fmt: skip
    assert 0 < cmath.phase((far - pivot) * cmath.rect(1, -arc.start)) / arc.sweep < 1


def test_both_arcs_of_a_pivoted_link_are_about_its_pivot() -> None:
    """About another place of the link an arc looks as if it turned the other way: here alpha goes against omega."""
    text = """
ask = ["omega 3", "alpha 3"]
frame = { D = [0, 0] }
links = { 1.points = ["B"], 2.BC = 100, 3 = { DC = 70, DE = 150, CE = 80 } }
slide = [{ name = "s", block = "1", point = "B", guide = "frame", through = [0, -20], angle = 180 }]
driver = [{ slide = "s", at = 120, velocity = "200 mm/s", acceleration = -0.5 }]
sketch = { B = [-120, -20], C = [-40, 55], E = [-90, 120] }
"""
    method = plan(loads(text))
    page = sheet(method, replay_all(method))
    at = next(mark.at for mark in page.marks if isinstance(mark, PointMark) and mark.name == "D")
    arcs = [mark for mark in page.marks if isinstance(mark, ArcMark) and mark.accent in ("velocity", "acceleration")]
    assert {arc.accent for arc in arcs} == {"velocity", "acceleration"}
    assert all(abs(arc.centre - at) < 1e-9 for arc in arcs)


ROCKER = """
frame = { A = [0, 0], D = [100, 0], G = [190, 20] }
links = { 1.AB = 35, 2.BC = 95, 3 = { DC = 60, CE = 45, DE = 75, ccw = ["D", "E", "C"] }, 4.EF = 80, 5.GF = 65 }
driver = [{ vector = "AB", angle = 60, omega = 10 }]
sketch = { C = [108, 60], E = [153, 54], F = [231, 71] }
ask = ["omega 5", "alpha 5"]
"""


def test_an_arc_crosses_no_other_link_where_a_smaller_one_has_room() -> None:
    method = plan(loads(ROCKER))
    page = sheet(method, replay_all(method))
    names = {mark.name: mark.at for mark in page.marks if isinstance(mark, PointMark) and mark.plane == "position"}
    about = [mark for mark in page.marks if isinstance(mark, ArcMark) and mark.accent in ("velocity", "acceleration")]
    assert len(about) == 2
    for arc in about:
        assert abs(arc.centre - names["G"]) < 0.1
        turns = (arc.centre + cmath.rect(arc.radius, arc.start + part * arc.sweep / 20) for part in range(21))
        assert all(off_stretch(at, names["E"], names["F"]) > 1 for at in turns)
