"""Linkages of four links: the book's examples, kinds, what is found in mechanisms, inversions, words, sheets."""

from __future__ import annotations

import itertools
import json
import math
import re
from dataclasses import replace

import numpy as np
import pytest
from just_reaching import STRETCHED

from graphkin.analytic import motion
from graphkin.api import Drawing
from graphkin.errors import CannotClose, CannotDriveBy, GraphkinError, NoFixing, NoLinkage, NotALength, OnlyStretched
from graphkin.files import library, loads
from graphkin.outputs.svg import svg
from graphkin.say.catalogue import phrase
from graphkin.say.linkages import family_lines, held, kind_name, lines, titled
from graphkin.sheet.lettering import box
from graphkin.sheet.linkage_sheet import family_sheet, limit_sheet
from graphkin.sheet.marks import PointMark, Stroke, Text
from graphkin.studies.linkages import (
    FAMILY,
    KINDS,
    FourBar,
    GuideBar,
    SliderCrank,
    as_json,
    found_in,
    from_lengths,
    inverted,
    report,
    reported,
    some_found_in,
)
from graphkin.studies.linkages.assembled import posed
from graphkin.studies.linkages.triangles import whole

deg = math.degrees


def measured(kind, *mm, **more):
    return report(from_lengths(kind, *(length / 1e3 for length in mm), **more))


def read(text, name="test"):
    return loads(text, name=name, file=f"{name}.toml")


# --- the book ------------------------------------------------------------------------------------


@pytest.mark.parametrize("found", [measured("fourbar", 15, 48, 55, 45), report(found_in(library.load("s2-2"))[0].linkage)])
def test_example_2_2(found):
    assert (found.kind, found.grashof) == ("crank-rocker", True)
    assert (found.sums.sum_ends, found.sums.sum_middle) == pytest.approx((0.070, 0.093))
    assert {*found.sums.ends} == {"AB", "CD"}
    assert (deg(found.swing), deg(found.theta)) == pytest.approx((40.535, 29.859), abs=5e-4)
    assert found.k == pytest.approx(1.39775, abs=5e-6)
    assert [deg(end.gamma) for end in found.critical] == pytest.approx([32.984, 70.885], abs=5e-4)
    assert deg(found.least[0].driver) == pytest.approx(0, abs=1e-9)
    assert found.dead["AB"] == ()
    assert len(found.dead["CD"]) == 2


@pytest.mark.parametrize("found", [measured("slider", 20, 65, -15), report(found_in(library.load("s2-4"))[0].linkage)])
def test_example_2_4(found):
    assert (found.kind, found.family) == ("slider-crank", "offset")
    assert found.stroke * 1e3 == pytest.approx(41.2396, abs=5e-5)
    assert (deg(found.theta), found.k) == pytest.approx((9.3070, 1.10905), abs=1e-4)
    assert deg(found.alpha_max) == pytest.approx(32.579, abs=5e-4)
    assert deg(found.least[0].driver) == pytest.approx(90)
    assert sorted(90 - deg(end.gamma) for end in found.limits) == pytest.approx([10.165, 19.471], abs=1e-3)
    assert found.dead["AB"] == ()
    assert [end * 1e3 for end in found.dead["C"]] == pytest.approx([math.sqrt(45**2 - 15**2), math.sqrt(85**2 - 15**2)])


def test_design_of_example_2_3_comes_out():
    found = report(found_in(library.load("s2-3"))[0].linkage)
    assert (deg(found.swing), found.k) == pytest.approx((40, 1.3), abs=1e-6)


def test_guide_bar_without_offset():
    found = measured("guide", 100, 300, 0)
    assert found.swing == pytest.approx(2 * math.asin(1 / 3))
    assert found.theta == pytest.approx(found.swing)
    assert found.gamma_min == pytest.approx(math.pi / 2)
    assert as_json(found)["gamma_min_at"] is None


def test_in_line_slider_has_no_quick_return():
    found = measured("slider", 20, 65, 0)
    assert (found.theta, found.k, found.slow) == (0.0, 1.0, None)
    assert [deg(end.driver) for end in found.least] == pytest.approx([90, 270])


# --- kinds -----------------------------------------------------------------------------------------

NAMED = [
    (("fourbar", 15, 48, 55, 45), {}, "crank-rocker", ""),
    (("fourbar", 15, 48, 55, 45), {"driver": "rocker"}, "rocker-crank", ""),
    (("fourbar", 55, 48, 15, 45), {}, "rocker-crank", ""),
    (("fourbar", 50, 40, 45, 20), {}, "double-crank", ""),
    (("fourbar", 30, 10, 28, 25), {}, "double-rocker", ""),
    (("fourbar", 30, 50, 40, 90), {}, "triple-rocker", ""),
    (("fourbar", 30, 60, 30, 60), {}, "change-point", "parallelogram"),
    (("fourbar", 30, 30, 60, 60), {}, "change-point", "kite"),
    (("fourbar", 30, 60, 60, 30), {}, "change-point", "kite"),
    (("fourbar", 30, 30, 30, 30), {}, "change-point", "rhombus"),
    (("fourbar", 10, 40, 20, 30), {}, "change-point", "crank-rocker"),
    (("slider", 20, 65, 15), {}, "slider-crank", "offset"),
    (("slider", 20, 65, 0), {}, "slider-crank", "in-line"),
    (("slider", 65, 20, 15), {}, "rocker-slider", "turning rod"),
    (("slider", 50, 60, 30), {}, "rocker-slider", "no full turn"),
    (("slider", 50, 50, 0), {}, "change-point", "isosceles"),
    (("slider", 50, 65, 15), {}, "change-point", "slider-crank"),
    (("guide", 100, 300, 20), {}, "oscillating guide bar", "bar"),
    (("guide", 300, 100, 20), {}, "rotating guide bar", "bar"),
    (("guide", 100, 120, 50), {}, "rocking guide bar", "bar"),
    (("guide", 100, 100, 0), {}, "change-point", "bar"),
]


@pytest.mark.parametrize(("lengths", "more", "kind", "family"), NAMED)
def test_kinds(lengths, more, kind, family):
    found = measured(*lengths, **more)
    assert (found.kind, found.family) == (kind, family)


@pytest.mark.parametrize("lengths", [
    ("fourbar", 30, 60, 50, 80), ("fourbar", 20, 50, 20, 50), ("fourbar", 40, 40, 70, 70), ("fourbar", 50, 50, 50, 50),
    ("slider", 30, 50, 20), ("slider", 30, 50, -20), ("slider", 40, 40, 0),
    ("guide", 40, 40, 0), ("guide", 40, 50, 10), ("guide", 50, 40, -10),
])  # fmt: skip
def test_where_links_come_to_lie_in_line_no_driver_moves_them(lengths):
    """At a change point the motion goes on in two ways, so that each driver has a dead point there."""
    found = measured(*lengths)
    assert "change-point" in (found.kind, found.family)
    assert found.dead
    assert all(found.dead.values()), found.dead


def test_crossed_parallelogram():
    bar = FourBar(0.03, 0.06, 0.03, 0.06)
    a, b, c, d = bar.places
    mirrored = b + ((c - b) / (d - b)).conjugate() * (d - b)
    assert report(FourBar(*bar.lengths, places=(a, b, mirrored, d))).family == "antiparallelogram"


DRIVEN = [*NAMED, (("slider", 20, 65, 15), {"driver": "slider"}, "", ""), (("guide", 100, 300, 20), {"driver": "bar"}, "", ""),
          (("guide", 100, 300, 20), {"driver": "slide"}, "", ""), (("fourbar", 15, 48, 55, 45), {"driver": "coupler"}, "", "")]  # fmt: skip


@pytest.mark.parametrize(("lengths", "more", "kind", "family"), DRIVEN)
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_words_and_data_of_every_kind(lengths, more, kind, family, lang):
    found = measured(*lengths, **more)
    said = list(lines(found, lang))
    assert not re.search(r"[{}]|nan|None|inf\b", " ".join(said))
    assert kind_name(found, lang) in said[0]
    assert (lang == "zh") == bool(re.search("[\u4e00-\u9fff]", said[3]))
    data = json.loads(json.dumps(as_json(found), allow_nan=False))
    assert data["format"] == 1
    assert (data["gamma_min"] is None) == (more.get("driver") == "coupler")


@pytest.mark.many
@pytest.mark.parametrize(("lengths", "more", "kind", "family"), DRIVEN)
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_sheet_of_every_kind(lengths, more, kind, family, lang):
    """All on the paper, letters apart from each other, the same bytes again."""
    found = measured(*lengths, **more)
    drawing = limit_sheet([found], lang)
    boxes = []
    for mark in drawing.marks:
        if isinstance(mark, Text):
            wide, up, down = box(mark.label, mark.size)
            boxes.append((mark.at.real, mark.at.imag - up, mark.at.real + wide, mark.at.imag + down))
    assert all(left > 10 and right < 287 and top > 10 and low < 200 for left, top, right, low in boxes)
    for one, other in itertools.combinations(boxes, 2):
        apart = one[2] <= other[0] or other[2] <= one[0] or one[3] <= other[1] or other[3] <= one[1]
        assert apart, (one, other)
    assert svg(drawing) == svg(limit_sheet([found], lang))


# --- against the analysis ------------------------------------------------------------------------

FILES = ["s2-2", "s2-4", "s2-1a", "p3-5", "ex3-1", "p3-4a", "fig3-6", "s4-ex7"]


@pytest.mark.parametrize("name", FILES)
def test_limits_and_ranges_against_the_analysis(name):
    """At a limit the output stands still; beyond the driver's range there is no position."""
    machine = library.load(name)
    one = found_in(machine)[0]
    found = report(one.linkage)
    last = one.links[2] if isinstance(one.linkage, FourBar | SliderCrank) else machine.slides[0].guide
    there = 0
    for end in found.limits:
        now = motion(machine, [end.driver])
        if not found.driver_span.full and abs(now.position[one.linkage.names[2]] - end.places[2]) > 1e-6:
            continue  # it lies beyond a dead point of the driver, where the analysis does not go
        there += 1
        rate = now.s_rate[machine.slides[0].name] if isinstance(one.linkage, SliderCrank) else now.omega[last]
        assert abs(rate) < 1e-6 * abs(machine.drivers[0].rate)
    assert there >= min(1, len(found.limits))
    span = found.driver_span
    if not span.full:
        inside, outside = (motion(machine, [[span.high + step]]) for step in (-1e-3, 1e-3))
        assert np.isfinite(inside.theta[last]).all()
        assert np.isnan(outside.theta[last]).all()


@pytest.mark.parametrize("name", ["s2-2", "s2-1a", "p3-18", "s2-4"])
def test_mechanical_advantage_against_the_analysis(name):
    machine = library.load(name)
    one = found_in(machine)[0]
    found = report(one.linkage)
    turned = np.linspace(0, math.tau, 721)

    def ratios(values):
        now, driver = motion(machine, [values]), machine.drivers[0]
        out = now.s_rate[machine.slides[0].name] if isinstance(one.linkage, SliderCrank) else now.omega["3"]
        return np.abs(driver.rate / np.where(out == 0, 1e-300, out))

    assert ratios(np.array([found.advantage.at]))[0] == pytest.approx(found.advantage.least, rel=1e-9)
    assert ratios(turned).min() == pytest.approx(found.advantage.least, rel=1e-3)
    assert (ratios(turned) >= found.advantage.least * (1 - 1e-9)).all()


# --- in mechanisms ---------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "kinds"),
    [
        ("s2-1a", ["oscillating guide bar"]), ("s2-1b", ["slider-crank"]), ("p3-3a", ["crank-rocker", "rocker-slider"]),
        ("p3-3b", ["slider-crank", "slider-crank"]), ("p3-22", ["change-point", "change-point"]), ("s3-cam", []),
        ("s4-ex7", ["oscillating guide bar"]), ("s3-ic", ["slider-crank"]),
    ],
)  # fmt: skip
def test_found_in_the_library(name, kinds):
    assert [report(found.linkage).kind for found in found_in(library.load(name))] == kinds


def test_every_library_mechanism_can_be_asked():
    for name in library.names():
        for found in found_in(library.load(name)):
            for lang in ("en", "zh"):
                assert "{" not in " ".join(lines(reported(found), lang))


WHITWORTH = """
[frame]
A = [0, 0]
C = [0, {c}]
[links.1]
AB = 60
[links.2]
points = ["B"]
[links.3]
DC = 50
[links.4]
DE = 160
[links.5]
points = ["E"]
[[slide]]
block = "2"
point = "B"
guide = "3"
through = "C"
toward = "D"
[[slide]]
name = "ram"
block = "5"
point = "E"
guide = "frame"
through = [0, {guide}]
[[driver]]
vector = "AB"
angle = 200
omega = 5
[sketch]
D = [{d}, 0]
E = [150, {guide}]
"""
DRAG_LINK = """
[frame]
A = [0, 0]
D = [20, 0]
[links.1]
AB = 50
[links.2]
BC = 40
[links.3]
shape = {{ D = [0, 0], C = [45, 0], F = [-15, 20] }}
[links.4]
FG = 120
[links.5]
points = ["G"]
[[slide]]
name = "ram"
block = "5"
point = "G"
guide = "frame"
through = [0, {guide}]
[[driver]]
vector = "AB"
angle = 80
omega = 5
[sketch]
C = [{c}, -30]
F = [40, 20]
G = [150, {guide}]
"""
CHAINS = [
    *(library.text(name) for name in ("s3-shaper", "ex3-7", "p3-3a")), WHITWORTH.format(c=-25, guide=-40, d=40),
    WHITWORTH.format(c=30, guide=30, d=40), DRAG_LINK.format(guide=5, c=60), DRAG_LINK.format(guide=-30, c=60),
]  # fmt: skip


@pytest.mark.parametrize("text", CHAINS, ids=range(len(CHAINS)))
def test_a_ram_behind_another_linkage(text):
    """Stroke and K of the whole mechanism: how far the ram goes, and for how long each way."""
    machine = read(text)
    first, second = found_in(machine)
    found = reported(second)
    assert second.before is first
    turned = np.linspace(0, math.tau, 7201)
    s = motion(machine, [turned + machine.drivers[0].value]).s[machine.slides[-1].name]
    assert found.stroke == pytest.approx(np.ptp(s), rel=1e-5)
    share = max((np.diff(s) > 0).mean(), (np.diff(s) < 0).mean())
    assert share == pytest.approx((math.pi + found.theta) / math.tau, abs=4 / 7200)
    assert found.timed_by == "AB"
    one, other = (found.limits[number].output for number in found.slow)
    slow = 1 if (np.diff(s) > 0).mean() > 0.5 else -1
    assert (slow > 0) == (other > one)


TURNED = """
[frame]
name = "base"
O1' = [30, 40]
K = [{x}, {y}]
[links.guide]
"O1'E" = 15
"EF'" = 5
"O1'F'" = 20
[links.2]
EG = 48
[links.rocker]
KG = 55
[[driver]]
vector = "{vector}"
angle = {angle}
omega = -3
[sketch]
E = [{ex}, {ey}]
G = [{gx}, {gy}]
"""


@pytest.mark.parametrize("turn", [0, 37, 123, 180, 250])
@pytest.mark.parametrize("vector", ["O1'E", "EO1'"])
def test_any_names_any_way_round(turn, vector):
    """Example 2.2 turned about, with other letters, and its driver counted the other way."""
    way = np.exp(1j * math.radians(turn))
    at = [30 + 40j + way * z for z in (45, 15 * np.exp(1j * math.pi / 3), 32.978551251 + 53.67014784752j)]
    places = {f"{name}{axis}": getattr(z, part) for name, z in zip(("", "e", "g"), at) for axis, part in (("x", "real"), ("y", "imag"))}
    angle = turn + 60 + (180 if vector == "EO1'" else 0)
    text = TURNED.format(vector=vector, angle=angle, **places).replace("O1' =", '"O1\'" =').replace('"O1\'F\'" = 20', '"O1\'F\'" = 20')
    (one,) = found_in(read(text))
    found = report(one.linkage)
    assert one.links == ("guide", "2", "rocker", "base")
    assert found.driver == "O1'E"
    assert (found.kind, deg(found.swing), deg(found.gamma_min)) == ("crank-rocker", pytest.approx(40.5353, abs=1e-4), pytest.approx(32.9837, abs=1e-4))
    off = (deg(found.least[0].driver) - angle + 60) % 360
    assert min(off, 360 - off) < 1e-6


def test_every_kind_has_its_words():
    assert all(phrase(f"linkages.title {kind}", "en") for kind in KINDS)


DEFINITE = [case for case in DRIVEN if case[2] != "change-point"]


def along(one, other):
    """How far two directions are apart."""
    return abs(math.remainder(one - other, math.tau))


@pytest.mark.parametrize(("lengths", "more", "kind", "family"), DEFINITE)
@pytest.mark.parametrize("turn", [0.0, 2.0])
def test_a_kind_keeps_its_contract(lengths, more, kind, family, turn):
    """Its positions are one another's, and its ratio is how they change."""
    linkage = moved(from_lengths(lengths[0], *(length / 1e3 for length in lengths[1:]), **more), turn)
    here = linkage.direction(linkage.drawn)
    assert linkage.drawn.places == pytest.approx(linkage.places, abs=1e-12)
    assert linkage.position_at(here).places == pytest.approx(linkage.places, abs=1e-9)
    assert {linkage.driver, linkage.output} <= {*linkage.called}
    assert linkage.driver in linkage.drivers
    if linkage.driver not in ("crank", "rocker"):
        return
    behind, ahead = (linkage.position_at(here + step).output for step in (-1e-6, 1e-6))
    change = ahead - behind if linkage.output == "slider" else math.remainder(ahead - behind, math.tau)
    assert change / 2e-6 == pytest.approx(linkage.ratio(here), rel=1e-6, abs=1e-9)
    back = linkage.driver_at(linkage.drawn.output)
    if linkage.output == "slider":
        assert math.isnan(back)
        return
    assert along(linkage.position_at(back).output, linkage.drawn.output) < 1e-9
    assert not linkage.output_range().full or along(back, here) < 1e-9


@pytest.mark.parametrize(("lengths", "more", "kind", "family"), DEFINITE)
@pytest.mark.parametrize("block", [False, True])
def test_a_pose_is_the_mechanism_at_that_position(lengths, more, kind, family, block):
    linkage = moved(from_lengths(lengths[0], *(length / 1e3 for length in lengths[1:]), **more), 1.0)
    linkage = linkage if isinstance(linkage, FourBar) else replace(linkage, block=block)
    machine = linkage.mechanism()
    span, here = linkage.driver_range(), linkage.direction(linkage.drawn)
    turns = linkage.driver in ("crank", "rocker", "bar")
    for step in (0.0, 0.1, -0.2) if turns else (0.0,):
        if turns and not span.full and whole(here + step - span.low) > span.width:
            continue
        pose = posed(linkage, machine, linkage.position_at(here + step))
        now = motion(machine, [machine.drivers[0].value + step])
        for point, place in pose.position.items():
            assert place == pytest.approx(complex(now.position[point]), abs=1e-9), point
        for link, angle in pose.theta.items():
            if len(machine.links[link].points) > 1:
                assert along(angle, float(now.theta[link])) < 1e-9


# --- files and inversions --------------------------------------------------------------------------


def close(one, other):
    return one is other is None or one == pytest.approx(other, rel=1e-9, abs=1e-9)


# a change point may be drawn at its change point, where nothing is definite
@pytest.mark.parametrize(("lengths", "more", "kind", "family"), [case for case in DRIVEN if case[2] != "change-point"])
def test_a_file_of_a_linkage_is_that_linkage(lengths, more, kind, family):
    linkage = from_lengths(lengths[0], *(length / 1e3 for length in lengths[1:]), **more)
    machine = read(titled(linkage).text)
    (one,) = found_in(machine)
    mine, theirs = report(linkage), report(one.linkage)
    assert theirs.kind == mine.kind or {mine.kind, theirs.kind} == {"crank-rocker", "rocker-crank"}
    for name in ("swing", "stroke", "gamma_min", "k"):
        assert close(getattr(theirs, name), getattr(mine, name)), name
    assert Drawing.of(machine).plot is not None


@pytest.mark.parametrize(("lengths", "more", "kind", "family"), DRIVEN)
@pytest.mark.parametrize("block", [False, True])
def test_a_file_says_what_the_mechanism_is(lengths, more, kind, family, block):
    linkage = from_lengths(lengths[0], *(length / 1e3 for length in lengths[1:]), **more)
    machine = titled(linkage if isinstance(linkage, FourBar) else replace(linkage, block=block))
    told = read(machine.text, machine.name)
    assert (told.points, told.title, told.scales) == (machine.points, machine.title, machine.scales)
    for mine, theirs in zip(machine.links.values(), told.links.values(), strict=True):
        assert theirs.name == mine.name
        assert theirs.points == pytest.approx(mine.points, abs=1e-12)
    for mine, theirs in zip(machine.slides, told.slides, strict=True):
        assert theirs.line.direction == pytest.approx(mine.line.direction, abs=1e-12)
        assert theirs.tilt == pytest.approx(mine.tilt, abs=1e-12)
        assert replace(theirs, line=mine.line, tilt=mine.tilt) == mine
        assert theirs.line.origin == mine.line.origin
    for mine, theirs in zip(machine.drivers, told.drivers, strict=True):
        assert theirs.value == pytest.approx(mine.value, abs=1e-12)
        assert replace(theirs, value=mine.value) == mine
    assert told.sketch == pytest.approx(machine.sketch, abs=1e-12)


@pytest.mark.parametrize(
    ("name", "fixed", "kind", "block"),
    [
        ("s2-2", "1", "double-crank", None), ("s2-2", "2", "crank-rocker", None), ("s2-2", "3", "double-rocker", None),
        ("s2-4", "1", "rotating guide bar", False), ("s2-4", "2", "oscillating guide bar", True),
        ("s2-4", "3", "rocker-slider", True), ("s2-1a", "2", "slider-crank", None), ("p3-5", "1", "rotating guide bar", False),
        ("s3-ic", "2", "oscillating guide bar", True),
    ],
)  # fmt: skip
def test_inversions(name, fixed, kind, block):
    machine = library.load(name)
    new = inverted(machine, fixed)
    (one,) = found_in(new)
    assert report(one.linkage).kind == kind
    assert block is None or one.linkage.block is block
    before, after = motion(machine), motion(new)
    for point in set(machine.points) & set(new.points):
        assert after.position[point] == pytest.approx(before.position[point], abs=1e-9)
    seen = before.omega[machine.moving[-1]] - before.omega[machine.moving[0]]
    links = [("frame" if link == fixed else link) for link in (machine.moving[-1], machine.moving[0])]
    assert after.omega[links[0]] - after.omega[links[1]] == pytest.approx(seen, rel=1e-6, abs=1e-9)
    at_frame = machine.drivers[0].kind == "slide" or fixed == machine.drivers[0].link
    assert one.driven == ("driver" if at_frame else "pair")
    assert Drawing.of(new).plot is not None


def test_every_link_of_the_library_can_be_held():
    """The files load, and the analysis puts them together as they were drawn."""
    for name in library.names():
        machine = library.load(name)
        if len(machine.slides) < len(machine.pairs):
            continue
        before = motion(machine)
        for link in machine.moving:
            new = read(held(machine, link).text)
            after = motion(new)
            for point in machine.points:
                assert complex(after.position[point]) == pytest.approx(complex(before.position[point]), abs=1e-8), (name, link)


@pytest.mark.parametrize(
    ("make", "error"),
    [
        (lambda: FourBar(0.01, 0.01, 0.01, 0.05), CannotClose), (lambda: FourBar(0.01, 0.02, 0.03, 0.06), OnlyStretched),
        (lambda: FourBar(0.01, 0.02, 0, 0.02), NotALength), (lambda: FourBar(0.01, math.nan, 0.1, 0.02), NotALength),
        (lambda: SliderCrank(0.01, 0.02, 0.04), CannotClose), (lambda: SliderCrank(0.01, 0.02, -0.03), OnlyStretched),
        (lambda: GuideBar(0.01, 0.02, 0.04), CannotClose), (lambda: GuideBar(0.01, 0.02, math.inf), NotALength),
        (lambda: FourBar(0.015, 0.048, 0.055, 0.045, driver="slider"), CannotDriveBy),
        (lambda: some_found_in(library.load("s3-cam")), NoLinkage), (lambda: inverted(library.load("s2-2"), "9"), NoFixing),
        (lambda: inverted(library.load("s3-cam"), "1"), NoFixing),
    ],
)  # fmt: skip
def test_what_is_refused(make, error):
    with pytest.raises(error) as raised:
        make()
    assert isinstance(raised.value, GraphkinError)
    assert "{" not in raised.value.message("en") + raised.value.message("zh")


# --- the family ------------------------------------------------------------------------------------


def test_the_family_is_what_it_says():
    """Every kind once, and the library's examples are of the kind they stand beside."""
    names = [kind_name(report(member.linkage), "en") for member in FAMILY]
    assert len(set(names)) == len(names)
    assert {report(member.linkage).kind for member in FAMILY} >= {
        "crank-rocker", "double-crank", "double-rocker", "triple-rocker", "change-point", "slider-crank",
        "oscillating guide bar", "rotating guide bar",
    }  # fmt: skip
    for member in FAMILY:
        for name in member.library:
            kinds = [report(found.linkage) for found in found_in(library.load(name))]
            assert kind_name(report(member.linkage), "en") in [kind_name(kind, "en") for kind in kinds], name
    for lang in ("en", "zh"):
        assert len(list(family_lines(lang))) == len(FAMILY)
        assert kind_name(report(FAMILY[0].linkage), lang) in svg(family_sheet(lang))


@pytest.mark.parametrize("lang", ["en", "zh"])
@pytest.mark.parametrize("name", ["s3-shaper", "p3-3a", "s4-ex8"])
def test_sheet_of_a_linkage_behind_another(name, lang):
    for found in found_in(library.load(name)):
        drawing = svg(limit_sheet([reported(found)], lang))
        assert not re.search(r'\bnan\b', drawing)


WHITWORTH = """
[frame]
name = "6"
A = [0, 0]
C = [0, -40]
[links.1]
AB = 90
[links.2]
points = ["B"]
[links.3]
CD = 60
[links.4]
DF = 200
[links.5]
points = ["F"]
[[slide]]
block = "2"
point = "B"
guide = "3"
through = "C"
from = "CD"
angle = 180
[[slide]]
name = "ram"
block = "5"
point = "F"
guide = "frame"
through = "C"
angle = 0
[[driver]]
vector = "AB"
angle = 35
omega = "60 r/min"
[sketch]
D = [-50, -85]
F = [-240, -40]
"""


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_each_linkage_tells_its_scale_and_takes_the_room_that_others_leave(lang):
    sheet = limit_sheet([reported(found) for found in found_in(loads(WHITWORTH))], lang)
    told = ["".join(run.text for run in mark.label) for mark in sheet.marks if isinstance(mark, Text)]
    assert not any("(1:" in text for text in told)
    scales = [float(text.split(" = ")[1].split()[0]) for text in told if text.startswith("μl = ")]
    assert len(scales) == 3  # once under each figure, and none for all
    assert max(scales) <= 0.004
    (dead,) = [text for text in told if "sF = " in text]
    assert "from" in dead or "自 C" in dead


def moved(linkage, turn):
    """The same linkage somewhere else, turned."""
    places = tuple(0.03 - 0.02j + z * np.exp(1j * turn) for z in linkage.places)
    if isinstance(linkage, SliderCrank):
        return replace(linkage, places=tuple(map(complex, places)), way=turn)
    if isinstance(linkage, GuideBar):
        return replace(linkage, places=tuple(map(complex, places)), turn=linkage.turn + turn)
    return replace(linkage, places=tuple(map(complex, places)))


@pytest.mark.parametrize("turn", [0.4, 2.0, math.pi, -1.3])
@pytest.mark.parametrize(
    "linkage",
    [
        FourBar(0.015, 0.048, 0.055, 0.045), FourBar(0.03, 0.01, 0.028, 0.025), SliderCrank(0.02, 0.065, -0.015),
        SliderCrank(0.065, 0.02, 0.015), SliderCrank(0.02, 0.065, 0.01, block=True), GuideBar(0.02, 0.06, 0.01),
        SliderCrank(0.02, 0.065, 0.0, block=True), GuideBar(0.06, 0.02, 0.01, block=True), GuideBar(0.05, 0.06, 0.03),
    ],
)  # fmt: skip
def test_turned_and_written_and_found(linkage, turn):
    before, (one,) = report(linkage), found_in(moved(linkage, turn).mechanism())
    after = report(one.linkage)
    assert (after.kind, after.family, after.slow) == (before.kind, before.family, before.slow)
    for name in ("swing", "stroke", "gamma_min", "theta", "k"):
        assert close(getattr(after, name), getattr(before, name)), name

    def turned(ends, by):
        return sorted(round((end.driver + by) % math.tau, 6) % round(math.tau, 6) for end in ends)

    assert turned(after.least, 0) == pytest.approx(turned(before.least, turn), abs=1e-5)
    assert turned(after.limits, 0) == pytest.approx(turned(before.limits, turn), abs=1e-5)


def test_lengths_from_the_command_line_are_named():
    with pytest.raises(CannotClose) as raised:
        from_lengths("fourbar", 0.01, 0.01, 0.01, 0.05)
    assert raised.value.message("en").startswith("--fourbar: ")


@pytest.mark.parametrize("turn", [0.0, 1.1, -2.5])
@pytest.mark.parametrize("offset", [0.010, -0.030])
def test_a_block_on_the_frame_stands_on_the_ground(offset, turn):
    machine = moved(SliderCrank(0.02, 0.065, offset, block=True), turn).mechanism()
    marks = Drawing.of(machine).sheet(only="position").marks
    at = next(mark.at for mark in marks if isinstance(mark, PointMark) and mark.name == "P")
    hatch = [mark for mark in marks if isinstance(mark, Stroke) and mark.pen == "hatch" and len(mark.places) == 2]
    assert sum(abs(mark.places[0] - at) < 8 for mark in hatch) > 5


def test_links_of_a_file_that_just_reach_are_said_at_their_place():
    with pytest.raises(OnlyStretched, match=r"^<text>:5, links\.1: AD = AB \+ BC \+ CD"):
        found_in(loads(STRETCHED))
