"""What a mechanism file may say, and what is answered to everything else: sentence, file, line and key."""

from __future__ import annotations

import ast
import cmath
import math
import os
import re
import tomllib
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import graphkin.errors as errors
from graphkin.errors import GraphkinError, Several, Where
from graphkin.files import load, loads
from graphkin.files.source import LARGEST_FILE
from graphkin.files.toml import key_positions
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.pairs import Cam, CircularSlot
from graphkin.outputs.json_schema import json_schema_text

FOURBAR = """\
[frame]
name = "4"
A = [0, 0]
D = [80, 0]
[links.1]
AB = 30
[links.2]
BC = 70
[links.3]
DC = 60
[[driver]]
vector = "AB"
angle = 60
omega = 10
"""

SLIDER = """\
[frame]
name = "4"
A = [0, 0]
[links.1]
AB = 100
[links.2]
BC = 300
[links.3]
points = ["C"]
[[slide]]
name = "piston"
block = "3"
point = "C"
guide = "frame"
through = [0, 30]
[[driver]]
vector = "AB"
angle = 60
omega = 10
"""

YOKE = """\
[frame]
A = [0, 0]
[links.1]
AB = 30
[links.2]
points = ["B"]
[links.3]
PQ = 45
[[slide]]
block = "2"
point = "B"
guide = "3"
through = "P"
toward = "Q"
[[slide]]
block = "3"
point = "P"
guide = "frame"
through = [0, 0]
tilt = 90
[[driver]]
vector = "AB"
angle = 50
"""

GEARS = """\
[frame]
name = "3"
O = [0, 0]
[links.1]
points = ["O"]
[links.2]
points = ["P"]
[links.H]
OP = 50
[[gear]]
links = ["1", "2"]
centres = ["O", "P"]
radii = [30, 20]
[[gear]]
links = ["2", "3"]
centres = ["P", "O"]
radii = [20, 70]
internal = true
[[driver]]
vector = "OP"
angle = 40
"""

ROLL = """\
[frame]
O = [0, 0]
[links.1]
OE = 500
[links.2]
CM = 50
[[roll]]
wheel = "2"
centre = "C"
radius = 50
on = "1"
name = "along"
through = "O"
toward = "E"
[[driver]]
vector = "OE"
angle = 20
[[driver]]
slide = "along"
at = 300
"""

CAM = """\
[frame]
A = [0, 0]
D = [50, 0]
[links.1]
AB = 15
[links.2]
DH = 70
[[cam]]
links = ["1", "2"]
profiles = [
  { centre = "B", radius = 25 },
  { through = "D", toward = "H", side = "right" },
]
[[driver]]
vector = "AB"
angle = 90
"""


def edit(text: str, old: str, new: str) -> str:
    assert text.count(old) >= 1, old
    return text.replace(old, new, 1)


# ---------------------------------------------------------------- what can be said


def test_a_four_bar() -> None:
    mechanism = loads(FOURBAR, name="four", file="four.toml")
    assert mechanism.name == "four"
    assert mechanism.frame == "4"
    assert list(mechanism.links) == [FRAME, "1", "2", "3"]
    assert mechanism.links[FRAME].points == {"A": 0, "D": 0.08}
    assert mechanism.links["3"].points == {"D": 0, "C": 0.06}
    (driver,) = mechanism.drivers
    assert (driver.kind, driver.link, driver.vector, driver.from_link) == ("angle", "1", ("A", "B"), FRAME)
    assert (driver.value, driver.rate) == (pytest.approx(math.pi / 3), 10)
    assert mechanism.text == FOURBAR
    assert mechanism.where("driver", 0, "angle") == Where("four.toml", 13, "driver.0.angle")


def test_titles_sketch_scales_and_questions() -> None:
    text = 'title = "Shaper"\nsource = "p. 7"\nask = ["omega 3", "why?"]\n' + FOURBAR
    mechanism = loads(text + '[sketch]\nC = [65, "4 cm"]\n[scales]\nlength = 0.001\nvelocity = 1\n')
    assert mechanism.title == {"en": "Shaper", "zh": "Shaper"}
    assert (mechanism.credit("zh"), mechanism.ask) == ("p. 7", ("omega 3", "why?"))
    assert mechanism.sketch == {"C": 0.065 + 0.04j}
    assert mechanism.scales == {"length": 0.001, "velocity": 1}
    assert loads('title = { zh = "刨床" }\n' + FOURBAR).title == {"zh": "刨床"}
    told = loads('text = { en = "A crank.", zh = "曲柄。" }\n' + FOURBAR)
    assert [told.story(lang) for lang in ("en", "zh")] == ["A crank.", "曲柄。"]
    assert loads('text = "A crank."\n' + FOURBAR).story("zh") == "A crank."


def test_units_wherever_a_number_stands() -> None:
    text = edit(edit(FOURBAR, "AB = 30", 'AB = "3 cm"'), "omega = 10", 'omega = "60 rpm"\nalso = ["0.5 rev", 90]')
    mechanism = loads(edit(text, "[80, 0]", '["0.08 m", 0]'))
    assert mechanism.links["1"].points["B"] == 0.03
    assert mechanism.links[FRAME].points["D"] == 0.08
    assert mechanism.drivers[0].rate == pytest.approx(2 * math.pi)
    assert mechanism.drivers[0].also == pytest.approx((math.pi, math.pi / 2))


def test_velocity_of_the_tip_stands_for_omega() -> None:
    (driver,) = loads(edit(FOURBAR, "omega = 10", "velocity = 0.3\nacceleration = 6")).drivers
    assert (driver.rate, driver.acceleration) == (pytest.approx(10), pytest.approx(200))


def test_a_relative_driver() -> None:
    (driver,) = loads(edit(FOURBAR, 'vector = "AB"', 'vector = "BC"\nfrom = "BA"')).drivers
    assert (driver.link, driver.from_link, driver.from_vector) == ("2", "1", ("B", "A"))
    assert driver.name == "BC/BA"


def test_a_slide_on_a_line_of_the_frame() -> None:
    mechanism = loads(SLIDER)
    (slide,) = mechanism.slides
    assert (slide.name, slide.named, slide.point, slide.block, slide.tilt) == ("piston", True, "C", "3", 0)
    assert (slide.line.link, slide.line.origin, slide.line.direction) == (FRAME, "s0", 1)
    assert mechanism.links[FRAME].points == {"A": 0, "s0": 0.03j}
    assert "s0" not in mechanism.points


@pytest.mark.parametrize(
    ("lines", "direction"),
    [
        ("angle = 90", 1j),
        ('angle = "0.5 rev"', -1),
        ('toward = "A"', -1j),
        ('from = "EA"', 1j),
        ('from = "AE"\nangle = 90', 1),
    ],
)
def test_directions_of_a_line_of_the_frame(lines: str, direction: complex) -> None:
    text = edit(edit(SLIDER, "[0, 30]", f"[0, 30]\n{lines}"), "A = [0, 0]", "A = [0, 0]\nE = [0, -7]")
    assert loads(text).slides[0].line.direction == pytest.approx(direction)


def test_a_slide_on_a_moving_link() -> None:
    yoke, rail = loads(YOKE).slides
    assert (yoke.name, yoke.named, yoke.guide, yoke.line.origin, yoke.line.direction) == ("s0", False, "3", "P", 1)
    assert (rail.name, rail.block, rail.tilt) == ("s1", "3", pytest.approx(math.pi / 2))
    assert rail.line.origin == "s1"
    turned = loads(edit(YOKE, 'toward = "Q"', 'from = "QP"\nangle = 30')).slides[0]
    assert turned.line.direction == pytest.approx(-cmath.rect(1, math.pi / 6))


@pytest.mark.parametrize("lines", ["", 'through = "A"\n', "angle = 0\n"])
def test_a_guide_of_one_point_is_its_own_line(lines: str) -> None:
    text = edit(SLIDER, "[links.1]\nAB = 100", '[links.1]\npoints = ["A"]\n[links.5]\npoints = ["B"]')
    text += f'[[slide]]\nname = "cylinder"\nblock = "5"\npoint = "B"\nguide = "1"\n{lines}'
    text = edit(text, 'vector = "AB"\nangle = 60\nomega = 10', 'slide = "cylinder"\nat = 90\nvelocity = 1')
    mechanism = loads(text)
    assert mechanism.slides[1].line.direction == 1
    assert mechanism.slides[1].line.origin == "A"
    driver = mechanism.drivers[0]
    assert (driver.kind, driver.link, driver.value, driver.rate) == ("slide", "cylinder", 0.09, 1)


def test_a_pin_in_a_slot() -> None:
    text = edit(FOURBAR, "[links.2]\nBC = 70", '[[slide]]\npin = "B"\nguide = "3"\nthrough = "D"\ntoward = "C"')
    (slide,) = loads(text).slides
    assert (slide.block, slide.point, slide.joins) == (None, "B", ("3",))


def test_a_pin_in_a_circular_slot() -> None:
    (slot,) = loads(IN_ARC).pairs
    assert slot == CircularSlot("c0", "3", "C", 0.07, "1", "B")


@pytest.mark.parametrize(("centre", "point", "others"), [
    ("[20, -30]", "O", ""), ("[80, 0]", "D", ""), ("[20, -30]", "O'", "O = [1, 1]"),
])  # fmt: skip
def test_a_circular_slot_of_the_frame_has_a_point_at_its_centre(centre: str, point: str, others: str) -> None:
    text = edit(FOURBAR, "[links.3]", f'[[slide]]\npin = "C"\nguide = "frame"\ncentre = {centre}\nradius = 60\n[links.3]')
    mechanism = loads(edit(text, "DC = 60", 'points = ["C"]').replace("D = [80, 0]", f"D = [80, 0]\n{others}"))
    (slot,) = mechanism.of(CircularSlot)
    assert slot.centre == point
    assert mechanism.links[FRAME].points[point] * 1000 == pytest.approx(complex(*ast.literal_eval(centre)))
    assert point in mechanism.points


def test_a_block_of_one_point_in_two_slides_has_a_tilt_in_the_second() -> None:
    text = edit(YOKE, "tilt = 90", 'tilt = 90\n[[slide]]\nblock = "2"\npoint = "B"\nguide = "frame"\nthrough = "A"')
    tilted = edit(text, 'through = "A"', 'through = "A"\ntilt = -20')
    assert loads(tilted).slides[2].tilt == pytest.approx(-math.pi / 9)
    with pytest.raises(errors.NeedsSecondTilt, match=r"that of the line on link 3 along which it slides, too.* 90 or -90"):
        loads(text)


def test_gears_with_the_frame_by_its_name() -> None:
    sun, ring = loads(GEARS).pairs
    assert (sun.links, sun.centres, sun.radii, sun.internal) == (("1", "2"), ("O", "P"), (0.03, 0.02), False)
    assert (ring.links, ring.internal) == (("2", FRAME), True)


def test_rolling_on_a_line() -> None:
    mechanism = loads(ROLL)
    (roll,) = mechanism.pairs
    assert (roll.name, roll.named, roll.wheel, roll.centre, roll.radius) == ("along", True, "2", "C", 0.05)
    assert (roll.track, roll.left, roll.track_centre) == ("1", True, None)
    assert roll.line is not None
    assert roll.line.direction == 1
    assert mechanism.drivers[1].link == "along"


def test_rolling_on_a_circle() -> None:
    text = edit(
        ROLL, 'name = "along"\nthrough = "O"\ntoward = "E"', 'on_centre = "O"\non_radius = 300\ninternal = true'
    )
    (roll,) = loads(text.split("[[driver]]\nslide")[0]).pairs
    assert (roll.name, roll.named, roll.line) == ("r0", False, None)
    assert (roll.track_centre, roll.track_radius, roll.internal) == ("O", 0.3, True)


def test_a_cam_of_a_circle_and_a_line() -> None:
    (cam,) = loads(CAM).of(Cam)
    disc, face = cam.profiles
    assert (disc.centre, disc.radius, disc.line) == ("B", 0.025, None)
    assert (face.centre, face.left) == (None, False)
    assert face.line is not None
    assert (face.line.link, face.line.origin) == ("2", "D")
    edge = loads(edit(CAM, '{ through = "D", toward = "H", side = "right" }', '{ centre = "H", radius = 0 }'))
    assert edge.of(Cam)[0].profiles[1].radius == 0


def test_a_flat_cam_fixed_to_the_frame() -> None:
    text = edit(edit(CAM, '["1", "2"]', '["1", "frame"]'), 'through = "D", toward = "H"', "through = [0, -40]")
    assert loads(text).links[FRAME].points["c0_1"] == -0.04j


def test_a_spinning_wheel_and_a_pose() -> None:
    text = edit(GEARS, 'vector = "OP"\nangle = 40', 'link = "1"\nomega = 3\n[[pose]]\nvector = "OP"\nangle = 40')
    mechanism = loads(text)
    assert (mechanism.drivers[0].kind, mechanism.drivers[0].value, mechanism.drivers[0].rate) == ("spin", None, 3)
    assert mechanism.poses[0].vector == ("O", "P")


def test_a_pose_stands_for_a_driver_s_value() -> None:
    text = edit(SLIDER, "angle = 60\n", "") + '[[pose]]\nslide = "piston"\nat = 350\n'
    mechanism = loads(text)
    assert mechanism.drivers[0].value is None
    assert (mechanism.poses[0].kind, mechanism.poses[0].link, mechanism.poses[0].value) == ("slide", "piston", 0.35)


@pytest.mark.parametrize("prime", ["'", "’", "′"])
def test_primes_however_they_are_printed(prime: str) -> None:
    text = edit(FOURBAR, "BC = 70", f'"BC{prime}" = 70').replace("DC = 60", f'"DC{prime}" = 60')
    mechanism = loads(text + f'[sketch]\n"C{prime}" = [60, 60]\n')
    assert mechanism.links["2"].points == {"B": 0, "C'": 0.07}
    assert mechanism.sketch == {"C'": 0.06 + 0.06j}
    assert mechanism.where("links", "2", "BC'").line == 8


def test_points_with_digits() -> None:
    text = FOURBAR.replace("A = [", "O1 = [").replace("AB", "O1B10").replace("BC", "B10C")
    assert loads(text).links["2"].points == {"B10": 0, "C": 0.07}


def test_shape_and_its_axes() -> None:
    text = edit(FOURBAR, "BC = 70", "shape = { B = [10, 10], C = [10, 80], E = [-20, 10] }")
    assert list(loads(text).links["2"].points.values()) == pytest.approx([0, 0.07, 0.03j])


def test_points_of_a_link_come_in_the_order_of_the_file() -> None:
    text = edit(FOURBAR, "BC = 70", 'ccw = ["B", "C", "E"]\nBE = 50\nBC = 70\nCE = 45')
    points = loads(text).links["2"].points
    assert list(points) == ["B", "E", "C"]
    assert points["E"] == 0.05
    assert points["C"].imag < 0


def test_a_byte_order_mark_and_windows_lines(tmp_path: Path) -> None:
    path = tmp_path / "four.toml"
    path.write_bytes(b"\xef\xbb\xbf" + FOURBAR.replace("\n", "\r\n").encode())
    mechanism = load(path)
    assert mechanism.text == FOURBAR.replace("\n", "\r\n")
    assert (mechanism.name, mechanism.file) == ("four", str(path))
    assert mechanism.where("links", "3", "DC").line == 10
    assert loads("\ufeff" + FOURBAR).frame == "4"


def test_a_million_kilometres() -> None:
    assert loads(edit(FOURBAR, "AB = 30", "AB = 1e9")).links["1"].points["B"] == 1e6


# ---------------------------------------------------------------- what cannot

Case = tuple[str, str, int | None, str, str, str]
"""Error class, text, line, key, what the English and the Chinese sentence have in them."""


def line_of(text: str, part: str) -> int:
    """The line on which a part of a text first stands."""
    return text[: text.index(part)].count("\n") + 1


def bad(kind: str, text: str, at: str, key: str, english: str, chinese: str) -> Case:
    """A case whose line is given by what stands there."""
    return kind, text, line_of(text, at) if at else None, key, english, chinese


KEYS = [
    bad("UnknownKey", FOURBAR + "[sketches]\nC = [1, 2]\n", "[sketches]", "sketches", "Did you mean sketch?", "是否为 sketch"),
    bad("UnknownKey", edit(FOURBAR, "omega", "omga"), "omga", "driver.0.omga", "Did you mean omega?", "没有 omga"),
    bad("UnknownKey", edit(FOURBAR, "BC = 70", 'point = ["B"]'), "point", "links.2.point", "points, ccw", "可用：points"),
    bad("UnknownKey", edit(CAM, "radius", "r"), "centre", "cam.0.profiles.0.r", "radius", "radius"),
    bad("UnknownKey", 'title = { fr = "x" }\n' + FOURBAR, "title", "title.fr", "Possible: en, zh", "可用：en, zh"),
    bad("MissingKey", FOURBAR.split("[links.1]")[0], "", "links", "links is missing", "缺少 links"),
    bad("MissingKey", "[links]\n" + SLIDER.split("[links.1]")[0], "[links]", "links", "[links.NAME] is missing", "缺少"),
    bad("MissingKey", edit(SLIDER, 'guide = "frame"\n', ""), "[[slide]]", "slide.0.guide", "guide is missing", "缺少 guide"),
    bad("MissingKey", edit(SLIDER, 'point = "C"\n', ""), "[[slide]]", "slide.0", "point is missing", "缺少 point"),
    bad("MissingKey", edit(SLIDER, 'block = "3"\n', ""), "[[slide]]", "slide.0", "block is missing", "缺少 block"),
    bad("MissingKey", edit(SLIDER, "through = [0, 30]\n", ""), "[[slide]]", "slide.0", "through is missing", "缺少 through"),
    bad("MissingKey", edit(CAM, ', radius = 25', ""), "{ centre", "cam.0.profiles.0", "radius is missing", "缺少 radius"),
    bad("MissingKey", GEARS + '[[pose]]\nvector = "OP"\n', "[[pose]]", "pose.0", "angle is missing", "缺少 angle"),
    bad("MissingKey", SLIDER + '[[pose]]\nslide = "piston"\n', "[[pose]]", "pose.0", "at is missing", "缺少 at"),
    bad(
        "MissingKey",
        edit(ROLL, 'name = "along"\nthrough = "O"\ntoward = "E"', 'on_centre = "O"').split("[[driver]]\nslide")[0],
        "[[roll]]", "roll.0", "on_radius is missing", "缺少 on_radius",
    ),
    bad("WrongType", edit(FOURBAR, "AB = 30", "AB = true"), "AB", "links.1.AB", "true stands where a number", "应为数"),
    bad("WrongType", edit(FOURBAR, "AB = 30", "AB = 2026-01-01"), "AB", "links.1.AB", "2026-01-01", "2026-01-01"),
    bad("WrongType", edit(FOURBAR, "AB = 30", "AB = [30]"), "AB", "links.1.AB", "[ .. ] stands", "[ .. ]"),
    bad("WrongType", edit(FOURBAR, "AB = 30", "AB.C = 3"), "AB", "links.1.AB", "{ .. } stands", "{ .. }"),
    bad("RangeHere", edit(FOURBAR, "AB = 30", "AB = { from = 20, to = 30 }"), "AB", "links.1.AB", "graphkin problems", "范围"),
    bad("WrongType", edit(FOURBAR, '"4"', "4"), "name", "frame.name", "4 stands where a name in quotes", "带引号的名称"),
    bad("WrongType", edit(SLIDER, 'block = "3"', "block = 3"), "block", "slide.0.block", "a name in quotes", "带引号"),
    bad("WrongType", edit(FOURBAR, "[80, 0]", "80"), "D =", "frame.D", "[x, y]", "[x, y]"),
    bad("WrongType", edit(FOURBAR, "[80, 0]", "[80, false]"), "D =", "frame.D.1", "false", "false"),
    bad("WrongType", edit(FOURBAR, '"AB"', "7"), "vector", "driver.0.vector", "two different points", "两个不同的点"),
    bad("WrongType", edit(FOURBAR, "[[driver]]", "[driver]"), "[driver]", "driver", "[[slide]]", "双括号"),
    bad("WrongType", edit(FOURBAR, "[links.1]\nAB = 30", "[links]\n1 = 30"), "1 = 30", "links.1", "a table", "应为表"),
    bad("WrongType", "links = 3\n[frame]\nA = [0, 0]\n", "links", "links", "a table", "应为表"),
    bad("UnitAsKey", edit(FOURBAR, "omega = 10", "rpm = 95"), "rpm", "driver.0.rpm", 'omega = "95 rpm"', 'omega = "95 rpm"'),
    bad("WrongType", "ask = [3]\n" + FOURBAR, "ask", "ask.0", "a text in quotes", "带引号的文字"),
    bad("WrongType", 'ask = "v C"\n' + FOURBAR, "ask", "ask", "a list", "列表"),
    bad("WrongType", "title = 3\n" + FOURBAR, "title", "title", "a text in quotes, or", "带引号的文字或"),
    bad("WrongType", edit(GEARS, "internal = true", "internal = 1"), "internal", "gear.1.internal", "true or false", "true 或 false"),
    bad("WrongType", edit(SLIDER, "[0, 30]", "30"), "through", "slide.0.through", "or [x, y]", "或 [x, y]"),
    bad("WrongType", edit(CAM, '{ centre = "B", radius = 25 }', "3"), "3,", "cam.0.profiles.0", "a table", "应为表"),
    bad("WrongType", FOURBAR + "[scales]\nlength = \"1 mm\"\n", "length", "scales.length", "a number", "应为数"),
    bad("WrongType", edit(FOURBAR, "BC = 70", 'BC = 70\nccw = "BCE"'), "ccw", "links.2.ccw", "three points", "三个点"),
    bad("WrongCount", edit(FOURBAR, "[80, 0]", "[80]"), "D =", "frame.D", "needs 2 items, not 1", "有 1 项，应为 2 项"),
    bad("WrongCount", edit(FOURBAR, "[80, 0]", "[80, 0, 0]"), "D =", "frame.D", "needs 2 items, not 3", "有 3 项"),
    bad("WrongCount", edit(GEARS, '["1", "2"]', '["1"]'), "links = ", "gear.0.links", "needs 2", "应为 2 项"),
    bad("WrongCount", edit(FOURBAR, "BC = 70", 'BC = 70\nccw = ["B", "C"]'), "ccw", "links.2.ccw.0", "needs 3", "应为 3 项"),
    bad("BadName", edit(FOURBAR, "D = [", "d = ["), "d = [", "frame.d", "a capital letter", "大写字母"),
    bad("BadName", edit(FOURBAR, "BC = 70", "BCDE = 70"), "BCDE", "links.2.BCDE", "two points for a length", "两点表示长度"),
    bad("BadName", edit(FOURBAR, "BC = 70", "BB = 70"), "BB", "links.2.BB", "two points for a length", "两点表示长度"),
    bad("BadName", edit(FOURBAR, "[links.2]", '[links."2+"]'), "2+", "links.2+", "letters, digits", "字母、数字"),
    bad("LongName", edit(FOURBAR, "[links.2]", f"[links.{'rod' * 13}]"), "rodrod", f"links.{'rod' * 13}", "to 36 letters", "36 个字母"),
    bad("LongName", edit(SLIDER, '"piston"', f'"{"活塞" * 10}"'), "活塞", "slide.0.name", "to 36 letters", "汉字按两个计"),
    bad("BadName", edit(FOURBAR, '"AB"', '"AA"'), "vector", "driver.0.vector", "two different points", "两个不同的点"),
    bad("BadName", edit(SLIDER, '"piston"', '"c1"'), "name = \"c1\"", "slide.0.name", "c0, c1", "保留名"),
    bad("BadName", edit(SLIDER, 'point = "C"', 'point = "c"'), "point = ", "slide.0.point", "a capital letter", "大写字母"),
    bad("BadName", FOURBAR + "[sketch]\nc = [1, 2]\n", "c = [", "sketch.c", "a capital letter", "大写字母"),
    bad("UnknownUnit", edit(FOURBAR, "AB = 30", 'AB = "30 yd"'), "AB", "links.1.AB", "mm, cm, m, in, ft", "不认识单位 yd"),
    bad("OtherDimension", edit(FOURBAR, "omega = 10", 'omega = "10 rad"'), "omega", "driver.0.omega", "unit of an angle", "角度的单位"),
    bad("OtherDimension", edit(FOURBAR, "omega = 10", 'also = ["10 mm"]'), "also", "driver.0.also.0", "unit of a length", "长度的单位"),
    bad("NoUnit", edit(FOURBAR, "AB = 30", 'AB = "30"'), "AB", "links.1.AB", "has no unit", "没有单位"),
    bad("NotANumber", edit(FOURBAR, "AB = 30", 'AB = "long"'), "AB", "links.1.AB", "does not read as a number", "不能读作"),
    bad("OutOfRange", edit(FOURBAR, "AB = 30", "AB = nan"), "AB", "links.1.AB", "nan is not a finite number", "nan"),
    bad("OutOfRange", edit(FOURBAR, "angle = 60", "angle = inf"), "angle", "driver.0.angle", "inf", "inf"),
    bad("OutOfRange", edit(FOURBAR, "AB = 30", "AB = 1e400"), "AB", "links.1.AB", "inf", "inf"),
    bad("OutOfRange", edit(FOURBAR, "AB = 30", f"AB = 1{'0' * 400}"), "AB", "links.1.AB", "1e999", "1e999"),
    bad("OutOfRange", edit(FOURBAR, "AB = 30", f"AB = 0x{'f' * 5000}"), "AB", "links.1.AB", "1e999", "1e999"),
    bad("OutOfRange", FOURBAR + "[scales]\nlength = nan\n", "length", "scales.length", "nan", "nan"),
    bad("TooSmall", edit(FOURBAR, "AB = 30", "AB = 0"), "AB", "links.1.AB", "0 mm will not do", "必须大于 0"),
    bad("TooSmall", edit(FOURBAR, "AB = 30", "AB = -30"), "AB", "links.1.AB", "-30 mm will not do", "-30 mm"),
    bad("TooSmall", edit(FOURBAR, "AB = 30", "AB = 1e-300"), "AB", "links.1.AB", "at least 0.000001 mm", "0.000001 mm"),
    bad("TooSmall", edit(GEARS, "[30, 20]", "[30, 0]"), "radii", "gear.0.radii.1", "greater than 0", "大于 0"),
    bad("TooSmall", FOURBAR + "[scales]\nlength = 0\n", "length", "scales.length", "greater than 0", "大于 0"),
    bad("NotBetween", "ask = ['v C']\npoints = { 'v C' = -3 }\n" + FOURBAR, "points", "points.v C", "from 0 to 1,000,000", "0 到 1000000"),
    bad("Negative", edit(CAM, "radius = 25", "radius = -25"), "{ centre", "cam.0.profiles.0.radius", "-25 mm is negative", "为负"),
    bad("AngleRange", edit(FOURBAR, "BC = 70", "BC = 70\nBCE = 190"), "BCE", "links.2.BCE", "190 deg", "190°"),
    bad("NotOneOf", edit(CAM, '"right"', '"up"'), "{ through", "cam.0.profiles.1.side", "left, right", "left, right"),
    bad("KeyClash", edit(FOURBAR, "BC = 70", "BC = 70\nCB = 70"), "CB", "links.2.CB", "BC and CB", "BC 与 CB"),
    bad("KeyClash", edit(SLIDER, "[0, 30]", '[0, 30]\ntoward = "A"\nangle = 3'), "angle", "slide.0.angle", "toward and angle", "toward 与 angle"),
    bad("KeyClash", edit(SLIDER, 'block = "3"', 'pin = "C"\nblock = "3"'), "block", "slide.0.block", "pin and block", "pin 与 block"),
    bad("KeyClash", FOURBAR + "velocity = 3\n", "velocity", "driver.0.velocity", "omega and velocity", "omega 与 velocity"),
    bad("KeyClash", FOURBAR + "alpha = 3\nacceleration = 3\n", "acceleration", "driver.0.acceleration", "alpha and", "alpha 与"),
    bad("KeyClash", FOURBAR + 'link = "1"\n', 'link = "1"', "driver.0.link", "vector and link", "vector 与 link"),
    bad("DuplicateName", edit(FOURBAR, "[links.3]", '[links."2\'"]\nBC = 3\n[links."2’"]\nCD = 2\n[links.3]'), '"2’"', "links.2'", "2' is used", "2' 已被使用"),
    bad("DuplicateName", SLIDER + '[[slide]]\nname = "piston"\npin = "B"\nguide = "frame"\nthrough = "A"\n',
        'name = "piston"\npin', "slide.1.name", "piston is used already", "piston 已被使用"),
]  # fmt: skip

NAMES = [
    bad("UnknownPoint", edit(SLIDER, 'point = "C"', 'point = "E"'), 'point = "E"', "slide.0.point", "no point E here. Possible: A, B, C", "没有点 E"),
    bad("UnknownPoint", edit(SLIDER, 'point = "C"', 'point = "B"'), 'point = "B"', "slide.0.point", "Possible: C.", "可用：C。"),
    bad("UnknownPoint", edit(FOURBAR, '"AB"', '"AE"'), "vector", "driver.0.vector", "no point E", "没有点 E"),
    bad("UnknownPoint", FOURBAR + "[sketch]\nF = [1, 2]\n", "F =", "sketch.F", "Possible: A, D, B, C.", "A, D, B, C"),
    bad("UnknownPoint", edit(FOURBAR, "BC = 70", 'BC = 70\nccw = ["B", "C", "E"]'), "ccw", "links.2.ccw", "no point E", "没有点 E"),
    bad("UnknownPoint", edit(SLIDER, "[0, 30]", '"D1"'), "through", "slide.0.through", "no point D1", "没有点 D1"),
    bad("UnknownPoint", edit(YOKE, 'through = "P"', "through = [0, 0]"), "through", "slide.0.through", "P, Q", "P, Q"),
    bad("UnknownPoint", edit(GEARS, '["O", "P"]', '["P", "O"]'), "centres", "gear.0.centres.0", "no point P here", "没有点 P"),
    bad("UnknownPoint", edit(CAM, '"B", radius', '"H", radius'), "{ centre", "cam.0.profiles.0.centre", "no point H", "没有点 H"),
    bad("UnknownLink", edit(SLIDER, 'block = "3"', 'block = "5"'), "block", "slide.0.block", "1, 2, 3, frame", "没有构件 5"),
    bad("UnknownLink", edit(SLIDER, '"frame"', '"fram"'), "guide", "slide.0.guide", "Did you mean frame?", "是否为 frame"),
    bad("UnknownLink", edit(GEARS, '["1", "2"]', '["1", "9"]'), "links = ", "gear.0.links.1", "no link 9", "没有构件 9"),
    bad("UnknownLink", edit(ROLL, 'on = "1"', 'on = "7"'), 'on = "7"', "roll.0.on", "no link 7", "没有构件 7"),
    bad("UnknownLink", edit(GEARS, 'vector = "OP"\nangle = 40', 'link = "9"'), 'link = "9"', "driver.0.link", "no link 9", "没有构件 9"),
    bad("UnknownSlide", edit(SLIDER, 'vector = "AB"\nangle = 60\nomega = 10', 'slide = "pisto"'), 'slide = "', "driver.0.slide",
        "Did you mean piston?", "是否为 piston"),
    bad("UnknownSlide", edit(YOKE, 'vector = "AB"\nangle = 50', 'slide = "s7"'), 'slide = "', "driver.0.slide", "give it one with name", "为其命名"),
    bad("FrameNameTaken", edit(FOURBAR, "[links.3]", "[links.4]"), "[links.4]", "links.4", "4 is the name of the frame", "机架的名称"),
    bad("FrameNameTaken", edit(FOURBAR, "[links.3]", "[links.frame]"), "[links.frame]", "links.frame", "the name of the frame", "机架"),
    bad("FrameNameTaken", edit(YOKE, "[links.3]", "[links.0]").replace('"3"', '"0"'), "[links.0]", "links.0", "give [frame] another", "改 name"),
]  # fmt: skip

SHAPES = [
    bad("TooFewMeasures", edit(FOURBAR, "BC = 70", "BC = 70\nCE = 3"), "[links.2]", "links.2", "nothing fixes E", "点 E 未定"),
    bad("TooFewMeasures", edit(FOURBAR, "BC = 70", 'points = ["E"]\nshape = { B = [0, 0], C = [9, 0] }'), "[links.2]", "links.2", "E", "E"),
    bad("TooManyPoints", edit(FOURBAR, "BC = 70", f"points = {[f'B{n}' for n in range(51)]}"), "[links.2]", "links.2",
        "more than 50 points", "超过 50 个"),
    bad("NoTriangle", edit(FOURBAR, "BC = 70", "BC = 70\nCE = 3\nBE = 60"), "BE", "links.2.BE", "7 mm are lacking", "差 7 mm"),
    bad("MissingCcw", edit(FOURBAR, "BC = 70", "BC = 70\nCE = 30\nBE = 60"), "[links.2]", "links.2", '"B", "C", "E"', "逆时针"),
    bad("CcwOnLine", edit(FOURBAR, "BC = 70", 'BC = 70\nCE = 30\nBE = 100\nccw = ["B", "C", "E"]'), "ccw", "links.2.ccw", "one line", "三点共线"),
    bad("CcwContradicts", edit(FOURBAR, "BC = 70", 'BC = 70\nCE = 30\nBE = 60\nccw = [["B", "C", "E"],\n["C", "B", "E"]]'), '["C", "B"',
        "links.2.ccw.1", "C, B, E cannot run", "不可能是逆时针"),
    bad("CcwContradicts", edit(FOURBAR, "BC = 70", 'ccw = ["B", "C", "E"]\nshape = { B = [0, 0], C = [9, 0], E = [0, -9] }'), "ccw",
        "links.2.ccw", "B, C, E cannot run", "不可能是逆时针"),
    bad("Contradiction", edit(FOURBAR, "BC = 70", 'BC = 70\nCE = 30\nBE = 60\nBCE = 90\nccw = ["B", "C", "E"]'), "BCE", "links.2.BCE",
        "BCE disagrees with the other measures of link 2 by", "BCE 与构件 2 的其他尺寸相差"),
    bad("ShapeAndMeasures", edit(FOURBAR, "BC = 70", "BC = 70\nshape = { B = [0, 0], C = [70, 0] }"), "BC", "links.2.BC", "both shape and BC", "shape 和 BC"),
    bad("OneSpot", edit(FOURBAR, "BC = 70", "shape = { B = [1, 0], C = [1, 0] }"), "[links.2]", "links.2", "lie at one place", "各点重合"),
    bad("NoPoints", edit(FOURBAR, "BC = 70", ""), "[links.2]", "links.2", "link 2 has no points", "没有点"),
    bad("LooseLink", edit(FOURBAR, "[[driver]]", "[links.5]\nEF = 3\n[[driver]]"), "[links.5]", "links.5", "tied to nothing", "没有联系"),
    bad("CannotMove", edit(FOURBAR, "[links.3]\nDC = 60", "[links.3]\nDC = 60\n[links.5]\nAD = 80"), "[links.5]", "links.5",
        "hinged to the frame at A, D", "在 A, D 处都与机架铰接"),
    bad("RigidlyJoined", edit(FOURBAR, "[[driver]]", "[links.5]\nBC = 70\n[[driver]]"), "[links.5]", "links.5", "2 and 5 are rigidly joined at B, C", "刚性相连"),
]  # fmt: skip

PAIRS = [
    bad("BlockOrPin", edit(SLIDER, 'block = "3"\npoint = "C"\n', ""), "[[slide]]", "slide.0", "say what slides", "什么在滑动"),
    bad("SlidesOnItself", edit(SLIDER, '"frame"', '"3"'), "block", "slide.0.block", "link 3 would slide on itself", "不能在自身上滑动"),
    bad("SlidesOnItself", edit(SLIDER, 'block = "3"\npoint = "C"', 'pin = "A"').replace("AB = 100", "EB = 100").replace('"AB"', '"EB"'),
        "pin", "slide.0.pin", "link frame would slide", "frame 不能"),
    bad("RigidlyJoined", edit(YOKE, 'points = ["B"]', 'points = ["B"]\nBP = 9') + "", "[[slide]]", "slide.0", "3 and 2 are rigidly joined at P", "刚性相连"),
    bad("NeedsTilt", edit(YOKE, "tilt = 90\n", ""), "[[slide]]\nblock = \"3\"", "slide.1", "its own already, P→Q. Add tilt", "补充 tilt"),
    bad("NeedsSecondTilt", edit(YOKE, "tilt = 90", 'tilt = 90\n[[slide]]\nblock = "2"\npoint = "B"\nguide = "frame"\nthrough = "A"\nangle = 0'),
        '[[slide]]\nblock = "2"\npoint = "B"\nguide = "frame"', "slide.2", "that of the line on link 3", "在构件 3 上滑动的导路方向"),
    bad("NoMeaning", edit(SLIDER, "[0, 30]", "[0, 30]\ntilt = 3"), "tilt", "slide.0.tilt", "a block of one point", "单点滑块"),
    bad("NoMeaning", edit(SLIDER, 'block = "3"\npoint = "C"', 'pin = "C"\ntilt = 3'), "tilt", "slide.0.tilt", "a pin in a slot may turn", "销在槽中"),
    bad("NoMeaning", edit(YOKE, "PQ = 45", 'points = ["P"]'), "toward", "slide.0.toward", "is its own line", "自身轴线"),
    bad("NoMeaning", edit(ROLL, 'through = "O"\ntoward = "E"', 'on_centre = "O"\non_radius = 9'), "name", "roll.0.name", "this is a circle", "此处是圆"),
    bad("NoMeaning", edit(ROLL, 'toward = "E"', 'toward = "E"\ninternal = true'), "internal", "roll.0.internal", "this is a line", "此处是直线"),
    bad("NoMeaning", edit(CAM, "[[driver]]", "internal = true\n[[driver]]"), "internal", "cam.0.internal", "this is a line", "此处是直线"),
    bad("NoMeaning", edit(CAM, "radius = 25", 'radius = 25, side = "left"'), "{ centre", "cam.0.profiles.0.side", "this is a circle", "此处是圆"),
    bad("NeedsDirection", edit(YOKE, 'toward = "Q"\n', ""), "[[slide]]", "slide.0", "Add toward = a second point", "请补充 toward"),
    bad("NeedsDirection", edit(YOKE, 'toward = "Q"\n', "angle = 9\n"), "[[slide]]", "slide.0", "or from = two points", "from（两点）"),
    bad("NoLine", edit(YOKE, 'toward = "Q"\n', 'toward = "P"\n'), "toward", "slide.0.toward", "P and P lie at one place", "重合"),
    bad("SameTwice", edit(GEARS, '["1", "2"]', '["1", "1"]'), "links = ", "gear.0.links", "1 stands there twice", "1 重复"),
    bad("SameTwice", edit(GEARS, 'points = ["P"]', 'points = ["O"]').replace('["O", "P"]', '["O", "O"]'), "centres", "gear.0.centres", "O stands", "O 重复"),
    bad("SameTwice", edit(ROLL, 'on = "1"', 'on = "2"'), 'on = "2"', "roll.0.on", "2 stands there twice", "2 重复"),
    bad("SameCircles", edit(GEARS, "[20, 70]", "[70, 70]"), "radii = [70", "gear.1.radii", "same radius", "半径相等"),
    bad("CircleOrLine", edit(CAM, "radius = 25", 'radius = 25, angle = 3'), "{ centre", "cam.0.profiles.0", "either a circle", "圆（centre, radius）"),
    bad("CircleOrLine", edit(CAM, '{ centre = "B", radius = 25 }', "{}"), "{}", "cam.0.profiles.0", "either a circle", "圆（centre, radius）"),
    bad("CircleOrLine", edit(ROLL, 'toward = "E"', 'on_radius = 9'), "[[roll]]", "roll.0", "either a circle (on_centre", "on_centre"),
    bad("LineOnLine", edit(CAM, 'centre = "B", radius = 25', 'through = "A", toward = "B"'), "profiles", "cam.0.profiles", "a line against a line", "面接触"),
    bad("PointOnPoint", edit(CAM, "radius = 25", "radius = 0").replace('through = "D", toward = "H", side = "right"', 'centre = "H", radius = 0'),
        "profiles", "cam.0.profiles", "two knife edges", "两个尖点"),
]  # fmt: skip

IN_ARC = edit(FOURBAR, "[links.2]\nBC = 70", '[[slide]]\npin = "B"\nguide = "3"\ncentre = "C"\nradius = 70')

ARCS = [
    bad("TooSmall", edit(IN_ARC, "radius = 70", "radius = 0"), "radius", "slide.0.radius", "greater than 0", "大于 0"),
    bad("TooSmall", edit(IN_ARC, "radius = 70", "radius = -3"), "radius", "slide.0.radius", "greater than 0", "大于 0"),
    bad("OutOfRange", edit(IN_ARC, "radius = 70", "radius = nan"), "radius", "slide.0.radius", "not a finite number", "有限数"),
    bad("OtherDimension", edit(IN_ARC, "radius = 70", 'radius = "7 deg"'), "radius", "slide.0.radius", "a length is needed", "应为长度"),
    bad("MissingKey", edit(IN_ARC, "\nradius = 70", ""), "[[slide]]", "slide.0", "radius is missing", "缺少 radius"),
    bad("MissingKey", edit(IN_ARC, '\ncentre = "C"', ""), "[[slide]]", "slide.0", "centre is missing", "缺少 centre"),
    bad("UnknownPoint", edit(IN_ARC, 'centre = "C"', 'centre = "A"'), "centre", "slide.0.centre", "Possible: D, C", "D, C"),
    bad("UnknownPoint", edit(IN_ARC, 'centre = "C"', "centre = [1, 2]"), "centre", "slide.0.centre", "no point [x, y] here", "没有点 [x, y]"),
    bad("SlidesOnItself", edit(IN_ARC, 'guide = "3"\ncentre = "C"', 'guide = "1"\ncentre = "A"'), "pin", "slide.0.pin", "slide on itself", "自身上滑动"),
    bad("CircleOrLine", edit(IN_ARC, "radius = 70", 'radius = 70\nthrough = "D"'), "[[slide]]", "slide.0", "either a circle (centre, radius)", "之一"),
    bad("PinInCircle", edit(IN_ARC, 'pin = "B"', 'block = "1"\npoint = "B"'), "block", "slide.0.block", "let the block's link have the centre", "铰接于圆心"),
    bad("PinInCircle", edit(IN_ARC, 'pin = "B"', 'pin = "B"\nblock = "1"'), "block", "slide.0.block", "give pin and guide", "请写 pin 和 guide"),
    bad("NoMeaning", edit(IN_ARC, "radius = 70", "radius = 70\ntilt = 3"), "tilt", "slide.0.tilt", "a pin in a slot may turn", "可以转动"),
    bad("NoMeaning", edit(IN_ARC, "radius = 70", 'radius = 70\nname = "arc"'), 'name = "arc"', "slide.0.name", "this is a circle", "此处是圆"),
]  # fmt: skip

DRIVERS = [
    bad("NoDriver", FOURBAR.split("[[driver]]")[0], "", "", "nothing is driven", "没有原动件"),
    bad("WhatIsDriven", edit(FOURBAR, 'vector = "AB"\n', ""), "[[driver]]", "driver.0", "vector, link, slide", "vector, link, slide"),
    bad("WhatIsDriven", FOURBAR + "[[pose]]\nangle = 3\n", "[[pose]]", "pose.0", "vector, slide", "vector, slide"),
    bad("NoVector", edit(FOURBAR, '"AB"', '"AC"'), "vector", "driver.0.vector", "no link has both points of AC", "没有哪个构件"),
    bad("DrivenFrame", edit(FOURBAR, '"AB"', '"AD"'), "vector", "driver.0.vector", "AD belongs to the frame", "AD 属于机架"),
    bad("DrivenFrame", edit(GEARS, 'vector = "OP"\nangle = 40', 'link = "3"'), 'link = "3"', "driver.0.link", "3 belongs to the frame", "3 属于机架"),
    bad("SameLink", FOURBAR + 'from = "BA"\n', "from", "driver.0.from", "both directions belong to link 1", "构件 1"),
    bad("SayValue", edit(FOURBAR, "angle = 60\n", ""), "[[driver]]", "driver.0", "Say angle", "请给出 angle"),
    bad("SayValue", edit(SLIDER, 'vector = "AB"\nangle = 60\nomega = 10', 'slide = "piston"'), "[[driver]]", "driver.0", "Say at", "请给出 at"),
    bad("DrivenTwice", FOURBAR + '[[driver]]\nvector = "BA"\nangle = 3\n', '[[driver]]\nvector = "BA"', "driver.1", "BA is driven twice", "BA 被驱动两次"),
    bad("NoMeaning", FOURBAR + "at = 3\n", "at = 3", "driver.0.at", "it belongs to a driven slide", "用于移动副"),
    bad("NoMeaning", edit(SLIDER, 'vector = "AB"\nangle = 60', 'slide = "piston"\nat = 3'), "omega", "driver.0.omega", "turning driver", "转动原动件"),
    bad("NoMeaning", edit(GEARS, 'vector = "OP"', 'link = "1"'), "angle", "driver.0.angle", "has omega and alpha only", "只需 omega"),
]  # fmt: skip

TEXTS = [
    bad("EmptyFile", "", "", "", "the file is empty", "文件是空的"),
    bad("EmptyFile", "# nothing\n\n", "", "", "the file is empty", "文件是空的"),
    bad("BrokenToml", FOURBAR + "alpha = = 3\n", "alpha", "", "not valid TOML: Invalid value", "TOML 语法错误"),
    bad("BrokenToml", FOURBAR + "omega = 3\n", "omega = 3", "", "Cannot overwrite a value", "TOML 语法错误"),
    bad("BrokenToml", FOURBAR + 'x = "abc', 'x = "abc', "", "not valid TOML", "TOML 语法错误"),
    bad("BrokenToml", FOURBAR + "x = 1" + "0" * 5000 + "\n", "", "", "4300 digits", "TOML 语法错误"),
    bad("BrokenToml", FOURBAR + "x = 2026-13-41\n", "x = ", "", "not valid TOML", "TOML 语法错误"),
    bad("StrayLetter", FOURBAR + "АB = 3\n", "АB", "", "А (U+0410) cannot stand outside quotes", "字符 А（U+0410）"),
    bad("StrayLetter", FOURBAR + "alpha = “3”\n", "alpha", "", "“ (U+201C) cannot", "字符 “（U+201C）"),
    bad("StrayLetter", FOURBAR + "alpha＝3 # 中\n", "alpha", "", "＝ (U+FF1D) cannot", "字符 ＝（U+FF1D）"),
    bad("BrokenToml", FOURBAR + 'x = "中\n', "x = ", "", "not valid TOML", "TOML 语法错误"),
    bad("BadName", edit(FOURBAR, '"AB"', '"АB"'), "vector", "driver.0.vector", "(А is U+0410) is not formed", "其中 А 是 U+0410"),
    bad("TooDeep", "x = " + "[" * 5000 + "]" * 5000, "", "", "nested far too deep", "嵌套过深"),
    bad("TooDeep", "a" + ".a" * 20_000 + " = 1", "", "", "nested far too deep", "嵌套过深"),
    bad("TooDeep", "a" + ' . "a b"' * 20_000 + " = 1", "", "", "nested far too deep", "嵌套过深"),
    bad("ControlCharacter", 'source = "a\\u0001b"\n' + FOURBAR, "source", "source", "U+0001", "U+0001"),
    bad("ControlCharacter", 'ask = ["v C", "\\u001b[31m"]\n' + FOURBAR, "ask", "ask.1", "U+001B", "U+001B"),
    bad("WrongType", "text = [1]\n" + FOURBAR, "text", "text", "a text in quotes, or", "带引号的文字或"),
    bad("UnknownKey", 'text = { de = "x" }\n' + FOURBAR, "text", "text.de", "Possible: en, zh", "可用：en, zh"),
    bad("ControlCharacter", 'title.en = "\\u202eab"\n' + FOURBAR, "title", "title.en", "U+202E", "U+202E"),
    bad("ControlCharacter", FOURBAR + '"\\u0085x" = 1', '"\\u0085x"', "driver.0.x", "U+0085", "U+0085"),
    bad("ControlCharacter", FOURBAR + "# \ufffe", "# \ufffe", "", "U+FFFE", "U+FFFE"),
    bad("FileTooLarge", "#" * (LARGEST_FILE + 1), "", "", "larger than 1 MB", "超过 1 MB"),
]

CASES = [*KEYS, *NAMES, *SHAPES, *PAIRS, *ARCS, *DRIVERS, *TEXTS]


@pytest.mark.parametrize(
    ("kind", "text", "line", "key", "english", "chinese"), CASES, ids=[f"{c[0]}-{c[3]}" for c in CASES]
)
def test_what_is_wrong_and_where(kind: str, text: str, line: int | None, key: str, english: str, chinese: str) -> None:
    problem = one_problem(text, kind)
    assert problem.where == Where("bad.toml", line, key)  # type: ignore[attr-defined]
    assert english in problem.message("en")
    assert chinese in problem.message("zh")
    assert problem.message("en").startswith(str(problem.where))  # type: ignore[attr-defined]
    assert problem.message("zh").startswith(str(problem.where))  # type: ignore[attr-defined]


def one_problem(text: str, kind: str) -> GraphkinError:
    """The problem of this kind that loading raises, alone or among others."""
    with pytest.raises(GraphkinError) as caught:
        loads(text, file="bad.toml")
    problem = caught.value
    problems = problem.problems if isinstance(problem, Several) else (problem,)
    assert kind in [type(problem).__name__ for problem in problems], str(problem)
    return next(problem for problem in problems if type(problem).__name__ == kind)


ERRORS = [
    thing
    for module in (errors.files, errors.mechanism)
    for thing in vars(module).values()
    if isinstance(thing, type) and thing.__module__ == module.__name__
]
RAISED_ELSEWHERE = {
    "NoFile", "IsFolder", "NotUtf8", "Unreadable", "UnknownMechanism", "TooFewDrivers", "TooManyDrivers", "RepeatedDriver",
    "JoinedToNothing",
}  # fmt: skip
"""By what finds files and reads them; by what plans a mechanism."""


def test_no_error_is_without_a_case() -> None:
    assert {kind.__name__ for kind in ERRORS} - RAISED_ELSEWHERE == {case[0] for case in CASES}


@pytest.mark.parametrize("kind", ERRORS)
def test_every_error_speaks_both_languages_from_the_same_data(kind: type[GraphkinError]) -> None:
    fields = set(re.findall(r"{(\w+)", kind.en))
    assert set(re.findall(r"{(\w+)", kind.zh)) == fields
    assert re.search("[\u4e00-\u9fff]", kind.zh)
    assert kind.en.startswith("{where}") or kind is errors.UnknownMechanism


def test_all_mistakes_at_once_in_the_order_of_the_lines() -> None:
    text = FOURBAR.replace("[80, 0]", "[80]").replace("BC = 70", "BC = -70").replace("omega", "omga")
    with pytest.raises(Several) as caught:
        loads(text.replace('"4"', "4"), file="bad.toml")
    kinds = [type(problem).__name__ for problem in caught.value.problems]
    assert kinds == ["WrongType", "WrongCount", "TooSmall", "UnknownKey"]
    assert [problem.where.line for problem in caught.value.problems] == [2, 4, 8, 14]  # type: ignore[attr-defined]
    assert caught.value.message("en").count("\n") == 3
    assert "bad.toml:8, links.2.BC：-70 mm" in caught.value.message("zh")


def test_all_contradictions_at_once() -> None:
    text = SLIDER.replace("BC = 300", "BC = 300\nCE = 7").replace('block = "3"', 'block = "7"').replace('"AB"', '"AE"')
    with pytest.raises(Several) as caught:
        loads(text)
    kinds = [type(problem).__name__ for problem in caught.value.problems]
    assert kinds == ["TooFewMeasures", "UnknownLink", "NoVector"]


# ---------------------------------------------------------------- files


def test_a_missing_file_names_its_neighbours(tmp_path: Path) -> None:
    (tmp_path / "shaper.toml").write_text(FOURBAR, "utf-8")
    with pytest.raises(errors.NoFile) as caught:
        load(tmp_path / "shapr.toml")
    assert "Did you mean shaper.toml?" in caught.value.message("en")
    assert "是否为 shaper.toml" in caught.value.message("zh")
    with pytest.raises(errors.NoFile, match="no such file"):
        load(str(tmp_path / "nowhere" / "x.toml"))


def test_a_folder(tmp_path: Path) -> None:
    with pytest.raises(errors.IsFolder, match="this is a folder"):
        load(tmp_path)


@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-le", "utf-16-be"])
def test_a_file_in_wide_letters(encoding: str, tmp_path: Path) -> None:
    (tmp_path / "wide.toml").write_bytes(FOURBAR.encode(encoding))
    with pytest.raises(errors.NotUtf8) as caught:
        load(tmp_path / "wide.toml")
    assert "UTF-16" in caught.value.message("en")
    assert "而是 UTF-16" in caught.value.message("zh")


def test_the_smallest_length_is_one() -> None:
    assert loads(edit(FOURBAR, "AB = 30", "AB = 0.000001")).links["1"].points["B"] == pytest.approx(1e-9)


def test_a_file_that_is_not_utf8(tmp_path: Path) -> None:
    path = tmp_path / "gbk.toml"
    path.write_bytes(b'source = "x"\n' + 'title = "刨床"\n'.encode("gbk"))
    with pytest.raises(errors.NotUtf8) as caught:
        load(path)
    assert caught.value.where.line == 2
    assert "UTF-8" in caught.value.message("zh")


def test_a_file_that_is_too_large_or_unreadable(tmp_path: Path) -> None:
    path = tmp_path / "large.toml"
    path.write_bytes(b"#" * (LARGEST_FILE + 1))
    with pytest.raises(errors.FileTooLarge):
        load(path)
    with pytest.raises(errors.Unreadable, match="cannot be read"):
        load("a\0b.toml")


# ---------------------------------------------------------------- lines, schema, mutations


def test_every_key_has_its_line() -> None:
    text = 'a.b = [1, # x\n 2,\n {c = """q\n"""""}]\n[[x]]\n[x.y]\nz = \'1\'\n[[x]]\n"k\'" = 1979-05-27 07:32:00\n'
    found = key_positions(text)
    assert set(_paths(tomllib.loads(text))) == set(found)
    assert found["a", "b", 2, "c"] == 3
    assert found["x", 0, "y", "z"] == 7
    assert found["x", 1, "k'"] == 9


def _paths(node: object, path: tuple[str | int, ...] = ()) -> list[tuple[str | int, ...]]:
    items = node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ()
    below = [_paths(value, (*path, key)) for key, value in items]
    return ([path] if path else []) + [inner for part in below for inner in part]


def test_the_json_schema_is_current() -> None:
    shipped = Path(errors.__file__).parent.parent / "files" / "graphkin.schema.json"
    assert shipped.read_text("utf-8") == json_schema_text()


BASES = [FOURBAR, SLIDER, YOKE, GEARS, ROLL, CAM, FOURBAR + "[sketch]\nC = [65, 46]\n[scales]\nlength = 0.001\n"]
VALUES = [
    "nan", "inf", "-inf", "1e400", "-0.0", "0", "-5", "true", "2026-01-01", "07:32:00", '""', '"x"', '"AB"',
    '"frame"', '"5 in"', '"1e999 mm"', "[]", "[[]]", "[1, 2]", '["B"]', "{}", "{ A = 1 }", "1e9", "1e-320",
    "9" * 400, '"B’"', '"\\u0000"', "[nan, 0]", '{ en = "%s {x}" }',
]  # fmt: skip


@st.composite
def broken(draw: st.DrawFn) -> str:
    """A good file after one to four accidents."""
    text = draw(st.sampled_from(BASES))
    for _ in range(draw(st.integers(1, 4))):
        text = draw(st.sampled_from([_characters, _lines, _values, _words]))(text, draw)
    return text


def _characters(text: str, draw: st.DrawFn) -> str:
    at = draw(st.integers(0, len(text)))
    new = draw(
        st.sampled_from(["", '"', "[", "]", "=", "{", "}", "\n", ".", ",", "'", "-", "0", "B", "\x00", "é", "#"])
    )
    return text[:at] + new + text[at + draw(st.integers(0, 2)) :]


def _lines(text: str, draw: st.DrawFn) -> str:
    lines = text.split("\n")
    at, to = draw(st.integers(0, len(lines) - 1)), draw(st.integers(0, len(lines)))
    line = lines[at] if draw(st.booleans()) else lines.pop(at)
    return "\n".join([*lines[:to], line, *lines[to:]]) if draw(st.booleans()) else "\n".join(lines)


def _values(text: str, draw: st.DrawFn) -> str:
    found = list(re.finditer(r"(?<== ).+|[0-9]+(?=[,\]])", text))
    if not found:
        return text
    match = draw(st.sampled_from(found))
    return text[: match.start()] + draw(st.sampled_from(VALUES)) + text[match.end() :]


def _words(text: str, draw: st.DrawFn) -> str:
    """One name or key of the file in another's place."""
    words = list(re.finditer(r"[A-Za-z_0-9]+", text))
    if not words:
        return text
    old, new = draw(st.sampled_from(words)), draw(st.sampled_from(words))
    return text[: old.start()] + new.group() + text[old.end() :]


@settings(deadline=None, max_examples=int(os.environ.get("GRAPHKIN_RANDOM", "250")))
@given(broken())
def test_only_our_own_errors_come_out(text: str) -> None:
    try:
        mechanism = loads(text)
    except GraphkinError as problem:
        sentences = problem.message("en"), problem.message("zh")
        assert all(sentences)
    else:
        assert isinstance(mechanism, Mechanism)
        assert all(cmath.isfinite(p) for link in mechanism.links.values() for p in link.points.values())


@pytest.mark.parametrize(
    ("question", "error", "hint"),
    [
        ("omega 9", errors.UnknownLink, "1, 2, 3"),
        ("v Z", errors.UnknownPoint, "A"),
        ("a_k Z4Z1", errors.UnknownPoint, "A"),
        ("s pistn", errors.UnknownSlide, "piston"),
        ("omgea 3", errors.NotOneOf, "omega"),
        ("omega 1 / omega 9", errors.UnknownLink, "1, 2, 3"),
    ],
)
def test_a_question_about_nothing(question: str, error: type[GraphkinError], hint: str) -> None:
    with pytest.raises(error) as caught:
        loads(f'ask = ["{question}"]\n' + SLIDER)
    assert "ask.0" in str(caught.value)
    assert hint in str(caught.value)


def test_a_free_question() -> None:
    assert loads('ask = ["P13", "why is v C so large?"]\n' + SLIDER).ask == ("P13", "why is v C so large?")


def test_names_like_those_graphkin_gives() -> None:
    text = edit(SLIDER, '"piston"', '"s1"') + '[[slide]]\npin = "B"\nguide = "frame"\nthrough = [0, 0]\n'
    assert [slide.name for slide in loads(text).slides] == ["s1", "s1_"]
