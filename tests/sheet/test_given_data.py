"""What a file gives is on the picture or in the list, each datum by a symbol of its own."""

from __future__ import annotations

import math
import re
from cmath import phase
from collections import Counter

import pytest
from library_sheets import library_sheet, plain_text, textbook_sheet

from graphkin.base.geometry import place
from graphkin.base.lines import crossing, off_stretch
from graphkin.construction import Plot
from graphkin.errors import Lang
from graphkin.files import loads
from graphkin.planning import Method, plan
from graphkin.running import replay_all
from graphkin.say.dimensions import measured_lengths, sizes
from graphkin.say.entry import Sentence
from graphkin.say.explained import derivation
from graphkin.say.problem_data import problem_data
from graphkin.say.reading import Reading
from graphkin.say.sizes import DrawnLength
from graphkin.sheet import sheet
from graphkin.sheet.marks import ArcMark, PointMark, Stroke, Text

ROLLER = """
frame = { }
[links.wheel]
CA = "0.5 ft"
[links.rod]
AB = "3 ft"
[links.collar]
points = ["B"]
[[roll]]
name = "roll"
wheel = "wheel"
centre = "C"
radius = "0.75 ft"
on = "frame"
through = [0, 0]
angle = 0
[[slide]]
block = "collar"
point = "B"
guide = "frame"
through = ["4 ft", "0 ft"]
angle = 120
[[driver]]
slide = "roll"
at = "1 ft"
velocity = "2 ft/s"
[[pose]]
vector = "CA"
angle = 60
[sketch]
B = [1000, 400]
C = [300, 225]
"""
FLAT = """
ask = ["v F"]
frame = { A = [0, 0] }
links = { 1.AB = 25, 2.points = ["F"] }
[[cam]]
links = ["1", "2"]
profiles = [{ centre = "B", radius = 45 }, { through = "F", angle = 0 }]
[[slide]]
block = "2"
point = "F"
guide = "frame"
through = "A"
angle = 90
[[driver]]
vector = "AB"
angle = 35
omega = -12
[sketch]
F = [0, 60]
"""
DOOR = """
ask = ["omega 1", "v C"]
frame = { A = [0, 0] }
[links]
1.AB = 800
2 = { PB = 1000, BC = 1000, PC = 2000 }
roller.points = ["P"]
[[slide]]
name = "roller"
block = "roller"
point = "P"
guide = "frame"
through = [0, 900]
angle = 0
[[driver]]
slide = "roller"
at = 450
velocity = 0.25
[sketch]
B = [-500, 620]
C = [-1500, 400]
"""
TAPPET = """
[frame]
name = "1"
O = [0, 0]
[links.2]
OC = 18
[links.3]
points = ["E"]
[[slide]]
block = "3"
point = "E"
guide = "frame"
through = "O"
angle = 75
[[cam]]
links = ["2", "3"]
profiles = [{ centre = "C", radius = 35 }, { through = "E", angle = 165 }]
[[driver]]
vector = "OC"
angle = 30
omega = "300 rpm"
[sketch]
E = [15, 50]
"""


RACK = """
frame = { A = [0, 0] }
[links]
2.AB = 14
9 = { CD = 60 }
[[slide]]
name = "rack"
block = "9"
point = "C"
guide = "frame"
through = [0, 25]
tilt = 0
[[roll]]
wheel = "2"
centre = "A"
radius = 25
on = "9"
through = "C"
toward = "D"
side = "right"
[[driver]]
vector = "AB"
angle = 130
omega = 4
[[pose]]
slide = "rack"
at = -32.5
[sketch]
C = [-32.5, 25]
D = [27.5, 25]
"""


def solved(text: str) -> tuple[Method, Plot]:
    method = plan(loads(text))
    return method, replay_all(method)


def test_a_guide_through_a_place_without_a_name_is_told() -> None:
    """On a frame without named points by its distance from where the first line begins, which is in the picture."""
    page = sheet(*solved(ROLLER), style="given")
    written = ["".join(run.text for run in mark.label) for mark in page.marks if isinstance(mark, Text)]
    assert "4 ft" in written
    assert any("xB,0 = 4 ft" in text for text in written)


def test_a_named_track_through_a_pivot_is_told_where_its_displacement_begins() -> None:
    """Beside the pivot it runs through, from which its distance is none."""
    every = sizes(Reading(*solved(ROLLER.replace("frame = { }", "frame = { F = [900, 0] }")), {}, "en"))
    assert {size.symbol: size.value for size in every}["x_K,0"] == -900.0


def test_what_only_translates_has_no_lever() -> None:
    """The follower of an eccentric: no distance in it is used."""
    reading = Reading(*solved(FLAT), {}, "en")
    assert measured_lengths(reading) == []


def test_a_displacement_is_measured_from_a_pivot_in_line_with_its_beginning() -> None:
    """The guide begins over the pivot A, where nothing is drawn."""
    page = sheet(*solved(DOOR))
    points = {mark.name: mark.at for mark in page.marks if isinstance(mark, PointMark) and mark.plane == "position"}
    upright = [mark.places for mark in page.marks if isinstance(mark, Stroke) and mark.pen == "thin"
               and all(abs((place - points["A"]).real) < 0.1 for place in mark.places)]  # fmt: skip
    assert any(abs(place - points["A"]) < 4 for places in upright for place in places)


def test_two_lines_at_one_point_have_angles_with_two_symbols() -> None:
    """The guide of a tappet and its face."""
    symbols = Counter(size.symbol for size in sizes(Reading(*solved(TAPPET), {}, "en")))
    assert symbols["β_E"] == symbols["β3"] == 1
    assert max(symbols.values()) == 1


def test_an_extension_line_begins_at_what_is_measured() -> None:
    """Not at a joint of other links that happens to be in line with it, from which nothing is measured."""
    page = textbook_sheet("crusher")
    points = {mark.name: mark.at for mark in page.marks if isinstance(mark, PointMark) and mark.plane == "position"}
    assert abs((points["C"] - points["A"]).real) < 0.1, "they are in line"
    level = [mark.places for mark in page.marks if isinstance(mark, Stroke) and mark.pen == "thin"
             and abs(mark.places[0].real - points["A"].real) < 0.1 and mark.places[0].real == mark.places[-1].real]  # fmt: skip
    lettered = " ".join(plain_text(mark.label) for mark in page.marks if isinstance(mark, Text))
    assert level or "xD = −380 mm" in lettered, "a line that passes that joint would be no better"
    assert all(abs(place - points["C"]) > 8 for places in level for place in places)


POSED = """
ask = ["theta 1", "omega 3"]
frame = { A = [0, 0], D = [71, -23] }
links = { 1.AB = 27.5, 2.BC = 88, 3.DC = 63 }
[[driver]]
vector = "AB"
omega = -7.7
[[pose]]
vector = "DC"
angle = 104
[sketch]
B = [-20, -18]
C = [56, 38]
"""


def test_a_pose_that_is_not_the_one_drawn_stands_by_its_symbol() -> None:
    """A problem that asks for an angle is drawn at another one: there the given one has another value, too."""
    method = plan(loads(POSED))
    for values, words in ((None, "φ3 = 104°"), ([math.radians(230)], "φ3")):
        plot = replay_all(method, values)
        page = sheet(method, plot, style="given")
        assert words in {plain_text(mark.label) for mark in page.marks if isinstance(mark, Text)}
        [arc] = [mark for mark in page.marks if isinstance(mark, ArcMark) and mark.pen == "thin"]
        seen = phase(place(plot.position["C"] - plot.position["D"]))
        assert abs(abs(arc.sweep) - seen) * arc.radius < 4.5, "but for the heads at its ends"


def test_the_place_of_a_rack_that_only_a_wheel_touches_is_told() -> None:
    """Without it nobody draws the same figure: as a dimension, or by its symbol with its sign."""
    page = sheet(*solved(RACK), style="given")
    written = ["".join(run.text for run in mark.label) for mark in page.marks if isinstance(mark, Text)]
    assert any(text == "32.5 mm" or "srack = −32.5 mm" in text for text in written)


ON_A_LINE = """
ask = ["v S"]
frame = { A = [0, 0] }
links = { 1.AB = 30, 2 = { BC = 110, BS = 45, CBS = 0 }, 3.points = ["C"] }
slide = [{ block = "3", point = "C", guide = "frame", through = [0, 20], angle = 0 }]
driver = [{ vector = "AB", angle = 135, omega = -31 }]
sketch = { C = [90, 20], S = [30, 20] }
"""
LINES = {
    ("BS = 45", "CBS = 0"): ("S lies on BC.", "S 在 BC 上。"),
    ("BS = 145", "CBS = 0"): ("S lies on BC produced.", "S 在 BC 的延长线上。"),
    ("BS = 45", "CBS = 180"): ("S lies on CB produced.", "S 在 CB 的延长线上。"),
    ("CS = 45", "BCS = 180"): ("S lies on BC produced.", "S 在 BC 的延长线上。"),
}
"""A point on the line of two others: how a file has it, and in words."""


@pytest.mark.parametrize(("stated", "words"), LINES.items())
def test_a_point_on_the_line_of_two_others_has_no_angle(stated: tuple[str, str], words: tuple[str, str]) -> None:
    """The drawing shows it, and words say it: an angle of 0 or 180 degrees stands nowhere."""
    text = ON_A_LINE.replace("BS = 45, CBS = 0", ", ".join(stated))
    text = text.replace("S = [30, 20]", "S = [-60, 30]") if words[0].startswith("S lies on CB") else text
    method, plot = solved(text)
    lettered = {plain_text(mark.label) for mark in sheet(method, plot).marks if isinstance(mark, Text)}
    assert not {"0°", "180°"} & lettered
    langs: tuple[Lang, ...] = ("en", "zh")
    for lang, words_ in zip(langs, words, strict=True):
        texts = [entry.text for entry in problem_data(Reading(method, plot, {}, lang)) if isinstance(entry, Sentence)]
        assert words_ in texts
        assert not [line for line in texts if "∠" in line]


OLDHAM = """
ask = ["omega 3"]
frame = { A = [0, 0], B = [20, 0] }
links = { 1.AD = 40, 2.shape = { C = [0, 0], E = [30, 0], F = [0, 30] }, 3.BG = 40 }
slide = [
    { block = "2", point = "C", guide = "1", through = "A", toward = "D", tilt = 0 },
    { block = "2", point = "C", guide = "3", through = "B", toward = "G", tilt = -90 },
]
driver = [{ vector = "AD", angle = 35, omega = 60 }]
sketch = { C = [14, 10], D = [32, 23], E = [40, 28], F = [0, 35], G = [0, 34] }
"""


def test_a_right_angle_between_guides_is_drawn_and_told() -> None:
    """As a square about the blocks; a length that another link's bar covers stands with its symbol."""
    method, plot = solved(OLDHAM)
    page = sheet(method, plot)
    points = {mark.name: mark.at for mark in page.marks if isinstance(mark, PointMark) and mark.plane == "position"}
    squares = [mark.places for mark in page.marks if isinstance(mark, Stroke) and mark.pen == "construction"
               and len(mark.places) == 3 and abs(abs(mark.places[1] - points["C"]) - 7.3 * math.sqrt(2)) < 0.1]  # fmt: skip
    [(one, corner, other)] = squares
    assert abs(((one - corner) * (other - corner).conjugate()).real) < 1e-9
    lettered = {plain_text(mark.label) for mark in page.marks if isinstance(mark, Text)}
    assert "lCE = 30 mm" in lettered
    assert not {"30 mm", "40 mm"} & lettered


def test_a_line_that_turns_with_one_that_is_drawn_lies_across_it() -> None:
    """Not under an angle that comes from nowhere; a guide between two points that are drawn is their line."""
    method, plot = solved(OLDHAM)
    scales = {"length": 5e-4, "velocity": 0.01, "acceleration": 1.0}
    texts = [entry.text for entry in derivation(method, plot, scales, "en") if isinstance(entry, Sentence)]
    assert any("BG = " in text and text.endswith("at 125° to +x, ⊥AD: G.") for text in texts)
    assert any("CE = " in text and text.endswith("at 35° to +x, ∥AD: E.") for text in texts)
    assert "Draw the line AD; draw the line BG. They cross at C." in texts


STEPHENSON = """
ask = ["omega 3"]
frame = { A = [0, 0], B = [95, 0], C = [150, 60] }
links = { 2.AD = 32, 3 = { DG = 90, DE = 70, GDE = 40, ccw = ["D", "G", "E"] }, 4.BG = 75, 5.EF = 80, 6.CF = 62 }
driver = [{ vector = "AD", angle = 70, omega = 12 }]
sketch = { G = [89, 75], E = [36, 97], F = [115, 108] }
"""


def test_both_coordinates_of_a_point_are_dimensions_or_both_are_written() -> None:
    """Half of a place in the drawing, half of it below: one looks for the other."""
    lettered = " ".join(plain_text(mark.label) for mark in sheet(*solved(STEPHENSON)).marks if isinstance(mark, Text))
    written = {axis: f"{axis}C = " in lettered for axis in "xy"}
    drawn = {axis: re.search(rf"(?<!= ){size} mm", lettered) is not None for axis, size in (("x", 150), ("y", 60))}
    assert drawn == {axis: not told for axis, told in written.items()}
    assert written["x"] == written["y"]


HYPOCYCLIC = """
ask = ["v D"]
frame = { O = [0, 0] }
links = { 1.OC = 60, 2.CD = 30 }
gear = [{ links = ["2", "frame"], centres = ["C", "O"], radii = [30, 90], internal = true }]
driver = [{ vector = "OC", angle = 50, omega = 10 }]
pose = [{ vector = "CD", angle = -40 }]
sketch = { D = [60, 30] }
"""


def test_a_radius_is_told_beside_a_bar_that_is_as_long() -> None:
    """Both are given: that a point lies on the rim is not."""
    lettered = " ".join(plain_text(mark.label) for mark in sheet(*solved(HYPOCYCLIC)).marks if isinstance(mark, Text))
    assert "r2 = 30 mm" in lettered
    assert len(re.findall("30 mm", lettered)) == 2


@pytest.mark.parametrize("name", ["crusher", "atkinson", "draglink"])
def test_no_extension_line_passes_a_joint_or_crosses_two_bars(name: str) -> None:
    """What has no better place is written in the line of givens."""
    page = textbook_sheet(name)
    joints = [mark.at for mark in page.marks if isinstance(mark, PointMark) and mark.plane == "position"]
    strokes = [mark for mark in page.marks if isinstance(mark, Stroke) and mark.places]
    bars = [mark.places for mark in strokes if mark.shows is not None and mark.shows.form == "bar" and len(mark.places) == 2]
    thin = [mark.places for mark in strokes if mark.pen == "thin" and len(mark.places) == 2 and mark.accent is None]
    assert bars
    assert thin
    for start, end in thin:
        assert sum(crossing(start, end, *bar) is not None for bar in bars) < 2
        inside = [at for at in joints if min(abs(at - start), abs(at - end)) > 1.3]
        assert all(off_stretch(at, start, end) > 1.2 for at in inside)


def test_a_wheel_s_displacement_is_measured_from_where_its_track_begins() -> None:
    """From the point with its letter, not from the air above it."""
    text = ROLLER.replace("frame = { }", "frame = { F = [90, 0] }").replace("through = [0, 0]", 'through = "F"')
    method, plot = solved(text)
    [size] = [size for size in sizes(Reading(method, plot, {}, "en")) if size.symbol == "s_roll"]
    assert size.shape is not None
    assert isinstance(size.shape, DrawnLength)
    assert abs(size.shape.start - 0.09) < 1e-12
    assert abs(abs((size.shape.end - size.shape.start).real) - 0.3048) < 1e-9


ROLLER_ON_A_PIN = """
ask = ["v C"]
frame = { A = [0, 0] }
links = { 1.AB = 20, 2.points = ["C"], 3.points = ["C"] }
cam = [{ links = ["1", "3"], profiles = [{ centre = "B", radius = 40 }, { centre = "C", radius = 12 }] }]
slide = [{ block = "2", point = "C", guide = "frame", through = [15, 0], angle = 90 }]
driver = [{ vector = "AB", angle = 20, omega = 12 }]
sketch = { C = [15, 58] }
"""


def test_a_follower_with_a_roller_on_a_pin_is_guided_beyond_its_roller() -> None:
    """A stem from the pin, not a block with its guide within the roller."""
    method, plot = solved(ROLLER_ON_A_PIN)
    page = sheet(method, plot)
    [centre] = [mark.at for mark in page.marks if isinstance(mark, PointMark) and mark.name == "C"]
    walls = [mark.places for mark in page.marks if isinstance(mark, Stroke) and mark.pen == "hatch" and not mark.closed]
    above = [places for places in walls if abs(places[0] - centre) < 40 and places[0].imag < centre.imag]
    assert above
    assert all(abs(place - centre) > 12 for places in above for place in places)
    assert not [mark for mark in page.marks if isinstance(mark, Stroke) and mark.shows is not None
                and mark.shows.form == "block"]  # fmt: skip


def test_a_length_that_follows_from_coordinates_is_derived_along_the_first_arm_too() -> None:
    """Only what lies along an axis of the file stands in the file."""
    text = OLDHAM.replace("E = [30, 0], F = [0, 30]", "E = [30, 40], F = [0, 30]")
    every = {size.symbol: size for size in sizes(Reading(*solved(text), {}, "en"))}
    assert [every[symbol].derived for symbol in ("l_CE", "l_CF", "l_EF", "l_AD")] == [True, False, True, False]


LIFT = """
ask = ["omega 3", "alpha 3", "v S", "a S"]
frame = { name = "5", D = [0, 0] }
slide = [
    { name = "s", block = "1", point = "B", guide = "frame", through = [0, -20], angle = 180 },
    { block = "4", point = "E", guide = "6", through = "S", toward = "T" },
    { block = "6", point = "S", tilt = -90, guide = "frame", through = [-120, 0], angle = 90 },
]
driver = [{ slide = "s", at = 120, velocity = "200 mm/s", acceleration = -0.5 }]
sketch = { B = [-120, -20], C = [-40, 55], E = [-90, 120], S = [-120, 120], T = [-60, 120], U = [-90, 170] }
[links]
1.points = ["B"]
2.BC = 100
3 = { DC = 70, DE = 150, CE = 80 }
4.points = ["E"]
6.shape = { S = [0, 0], T = [60, 0], U = [30, 50] }
"""
PLUNGER = """
ask = ["v T", "a T", "P12"]
frame = { name = "3", A = [0, 0] }
links = { 1.AC = 16, 2.shape = { T = [0, 0], U = [30, 0], V = [0, 50] } }
slide = [{ block = "2", point = "T", tilt = -90, guide = "frame", through = [10, 0], angle = 90 }]
driver = [{ vector = "AC", angle = 30, omega = "300 rpm" }]
sketch = { T = [10, 43] }
[[cam]]
links = ["1", "2"]
profiles = [{ centre = "C", radius = 35 }, { through = "T", toward = "U", side = "right" }]
"""
INCLINED = """
frame = { A = [0, 0] }
links = { 1.AB = 40, 2.BC = 120, 3.points = ["C"] }
slide = [{ block = "3", point = "C", guide = "frame", through = [9.8, -17], angle = 30 }]
driver = [{ vector = "AB", angle = 150, omega = 20 }]
sketch = { C = [90, 30] }
"""


def test_dimensions_beyond_all_that_is_drawn_where_nothing_nearer_has_room() -> None:
    """A guide's distance from a pivot is no symbol in a list; a right angle stands where its line leaves the block, and
    nowhere if another block is there."""
    page = sheet(*solved(LIFT))
    lettered = [plain_text(mark.label) for mark in page.marks if isinstance(mark, Text)]
    assert lettered.count("120 mm") == 2  # B from D, and the guide of S
    assert not any("eS" in text for text in lettered)
    squares = [mark for mark in page.marks if isinstance(mark, Stroke) and mark.pen == "construction"]
    assert not [mark for mark in squares if len(mark.places) == 3]


@pytest.mark.parametrize(("lang", "told"), [("en", "eT = 10 mm from A"), ("zh", "eT = 10 mm（距 A）")])
def test_a_distance_that_only_words_tell_says_from_where(lang: Lang, told: str) -> None:
    page = sheet(*solved(PLUNGER), lang=lang)
    assert any(told in plain_text(mark.label) for mark in page.marks if isinstance(mark, Text))


def test_where_a_guide_begins_has_a_cross_on_its_line() -> None:
    """Else the coordinates of that place end at nothing."""
    method, plot = solved(INCLINED)
    page = sheet(method, plot)
    names = {mark.name: mark.at for mark in page.marks if isinstance(mark, PointMark) and mark.plane == "position"}
    scale = page.scales["position"]
    begin = names["A"] + complex(0.0098, 0.017) / scale
    strokes = [mark for mark in page.marks if isinstance(mark, Stroke) and len(mark.places) == 2]
    cross = [mark for mark in strokes if abs(sum(mark.places) / 2 - begin) < 0.01 and abs(mark.places[0] - begin) < 2]
    assert len(cross) == 2
    line = [mark for mark in strokes if mark.pen == "centre" and mark.accent == "grey"]
    assert line
    assert all(off_stretch(end, begin, names["C"]) < 0.05 for mark in line for end in mark.places)


UPHILL = """
ask = ["omega 3"]
frame = { A = [0, 0] }
links.1 = { AB = 50 }
links.2 = { BC = 160 }
links.3 = { CP = 28 }
roll = [{ wheel = "3", centre = "C", radius = 40, on = "frame", through = [60, -60], angle = 15 }]
driver = [{ vector = "AB", angle = 140, omega = -5 }]
pose = [{ vector = "CP", angle = 80 }]
sketch = { C = [115, 0], P = [120, 30] }
"""


def test_where_a_track_begins_has_a_cross_too() -> None:
    """And a line from there to where the track is drawn."""
    page = sheet(*solved(UPHILL))
    at = {mark.name: mark.at for mark in page.marks if isinstance(mark, PointMark) and mark.plane == "position"}
    begin = at["A"] + complex(0.060, 0.060) / page.scales["position"]
    strokes = [mark for mark in page.marks if isinstance(mark, Stroke) and len(mark.places) == 2]
    cross = [mark for mark in strokes if abs(sum(mark.places) / 2 - begin) < 0.01 and abs(mark.places[0] - begin) < 2]
    assert len(cross) == 2
    [track] = [mark for mark in strokes if mark.shows is not None and mark.shows.form == "guide"]
    assert off_stretch(begin, *track.places) > 1
    [line] = [mark for mark in strokes if mark.pen == "centre" and mark.accent == "grey"]
    assert {min(abs(end - place) for place in (begin, *track.places)) < 0.05 for end in line.places} == {True}


def test_a_place_beside_another_by_nothing_to_speak_of_is_told() -> None:
    """The two ends of such a dimension lie at one place: it is written, and the other one is drawn."""
    page = sheet(*solved(UPHILL.replace("through = [60, -60]", "through = [0.007, -60]")))
    told = [plain_text(mark.label) for mark in page.marks if isinstance(mark, Text)]
    assert any("0.007 mm" in text for text in told)
    assert any("60 mm" in text for text in told)


def test_an_arrow_of_many_names_bears_one_where_all_have_no_room() -> None:
    """The letters at its head, and the equations, tell what moves alike; all names stand where there is room."""
    page = sheet(*solved(LIFT))
    names = {plain_text(mark.label) for mark in page.marks if isinstance(mark, Text)}
    assert {"vE6", " = vS", " = vT", " = vU", "aE6"} <= names
    assert " = aS" not in names


CRUSHER = """
frame = { name = "1", O = [0, 0], D = ["0.94 m", "-1.0 m"], F = ["-1.0 m", "1.0 m"] }
links = { 2.OA = "0.1 m", 3.AB = "1.25 m", 4.DB = "1.0 m", 5.BC = "1.15 m", 6.FC = "1.96 m" }
driver = [{ vector = "OA", angle = 90, omega = "170 r/min" }]
sketch = { A = [0, 100], B = [0, -1150], C = [-1100, -960] }
"""


def test_coordinates_of_one_size_are_both_told() -> None:
    """1.0 m to the left and 1.0 m up are two data, as is 1.0 m down of another pivot, and a link of 1.0 m."""
    lettered = [plain_text(mark.label) for mark in sheet(*solved(CRUSHER)).marks if isinstance(mark, Text)]
    assert lettered.count("1.0 m") == 4


CAM = """
frame = { name = "3", A = [0, 0], D = [90, 20] }
links = { 1.AO = 20, 2.DB = 80 }
cam = [{ links = ["1", "2"], profiles = [{ centre = "O", radius = 40 }, { centre = "B", radius = 10 }] }]
driver = [{ vector = "AO", angle = 150, omega = 10 }]
sketch = { B = [20, 55] }
"""


def test_a_dimension_whose_lines_would_cross_a_roller_and_its_bar_is_written() -> None:
    lettered = [plain_text(mark.label) for mark in sheet(*solved(CAM)).marks if isinstance(mark, Text)]
    assert any("lOA = 20 mm" in text for text in lettered)


GEARED = """
frame = { name = "5", A = [0, 0], E = [100, 0] }
links = { 1.AB = 45, 2.BC = 95, 3.CD = 90, 4.ED = 32 }
gear = [{ links = ["1", "4"], centres = ["A", "E"], radii = [60, 40] }]
driver = [{ vector = "AB", angle = 115, omega = 6 }]
pose = [{ vector = "ED", angle = 40 }]
sketch = { B = [-19, 41], C = [64, 87], D = [125, 21] }
"""


def test_no_dimension_line_lies_farther_off_than_what_it_measures_is_long() -> None:
    """Its extension lines would run along other links; the length is written instead."""
    lettered = [plain_text(mark.label) for mark in sheet(*solved(GEARED)).marks if isinstance(mark, Text)]
    assert "32 mm" not in lettered
    assert any("lDE = 32 mm" in text for text in lettered)


def test_a_displacement_that_only_words_tell_says_between_which_points() -> None:
    lettered = [plain_text(mark.label) for mark in library_sheet("p3-22").marks if isinstance(mark, Text)]
    assert any("slift = 1410.66 mm from G to B" in text for text in lettered)


def test_a_block_may_stand_where_its_guide_begins() -> None:
    """There is no line between the two; the drawing has both."""
    text = INCLINED.replace('driver = [{ vector = "AB", angle = 150, omega = 20 }]',
                            'driver = [{ slide = "ram", at = 0, velocity = 0.1 }]')  # fmt: skip
    text = text.replace("through = [9.8, -17]", 'name = "ram", through = [90, 30]').replace("C = [", "B = [-30, 27], C = [")
    page = sheet(*solved(text))
    assert any(isinstance(mark, PointMark) and mark.name == "C" for mark in page.marks)
