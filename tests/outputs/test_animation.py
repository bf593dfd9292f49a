"""`draw --animate`: a whole motion as one moving file, played moment by moment and measured."""

from __future__ import annotations

import io
import re
import xml.etree.ElementTree as ET
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from just_reaching import STRETCHED
from PIL import Image
from playing import still

import graphkin
from graphkin import analytic
from graphkin.cli import main
from graphkin.errors import DeadPoint
from graphkin.outputs import drawings
from graphkin.outputs.animation import animation
from graphkin.outputs.svg import svg
from graphkin.sheet import Sheet
from graphkin.sheet.marks import PointMark, Text, VectorMark
from graphkin.sheet.motion_frames import motion_frames
from graphkin.sheet.obstacles import bounds

SVG = "{http://www.w3.org/2000/svg}"
NAMES = ("ex3-7", "ex3-2")
"""A full turn; fitted, between dead points."""
COUNT = 12


@cache
def _frames(name: str) -> list[Sheet]:
    return motion_frames(graphkin.plan(graphkin.load(name)), COUNT)


def _absolute(root: ET.Element) -> list[ET.Element]:
    """The arrows of absolute motions."""
    seen = [line for line in root.iter(f"{SVG}line") if "data-plane" in line.attrib and "data-of" in line.attrib]
    return [line for line in seen if not {"data-seen-from", "data-part", "data-over"} & set(line.attrib)]


@pytest.mark.parametrize("name", NAMES)
def test_plays_as_the_analysis_has_it(name: str):
    """Arrows read off the drawing at moments of its turn are those of the analysis there."""
    machine, frames = graphkin.load(name), _frames(name)
    text, held = animation(frames), 0
    for number in (0, 2, 5, 11):
        sheet = frames[number]
        exact = analytic.motion(machine, sheet.drivers)
        for line in _absolute(ET.fromstring(still(text, number / COUNT))):
            x1, y1, x2, y2 = (float(line.attrib[key]) for key in ("x1", "y1", "x2", "y2"))
            point, _, link = line.attrib["data-of"].partition("@")
            plane = line.attrib["data-plane"]
            if point not in machine.points:
                continue
            wanted = (exact.velocity_at if plane == "velocity" else exact.acceleration_at)(point, link)
            assert abs(complex(x2 - x1, y1 - y2) - complex(wanted) / sheet.scales[plane]) < 0.03, (number, line.attrib)
            held += 1
    assert held > 8


@pytest.mark.parametrize("name", NAMES)
def test_scales_stand_but_of_large_polygons_which_say_so_and_all_fits(name: str):
    frames, usual = _frames(name), _frames(name)[0].scales
    for frame in frames:
        times = sorted(round(scale / usual[plane], 9) for plane, scale in frame.scales.items() if scale != usual[plane])
        notes = [re.fullmatch(r"drawn(\d+)timessmallerhere", re.sub(r"\s", "", _said(mark)))
                 for mark in frame.marks if isinstance(mark, Text)]  # fmt: skip
        assert times == sorted(float(note[1]) for note in notes if note), frame.drivers
        left, top, right, bottom = bounds(frame.marks)
        assert min(left, top, frame.paper.width - right, frame.paper.height - bottom) > 0


@pytest.mark.parametrize("name", NAMES)
def test_letters_do_not_hop(name: str):
    """The letter of a hinge stands from one moment to the next where the hinge takes it."""
    sheets = _frames(name)
    for letter in graphkin.load(name).points:
        drawn = [sheet.layers[1].marks for sheet in sheets]
        letters = [[m.at for m in marks if isinstance(m, Text) and _said(m) == letter] for marks in drawn]
        points = [[m.at for m in marks if isinstance(m, PointMark) and m.name == letter] for marks in drawn]
        if all(len(found) == 1 for found in letters + points):
            assert np.ptp(np.abs(np.array(letters) - np.array(points))) < 5, letter


def _said(text: Text) -> str:
    return "".join(run.text for run in text.label)


def test_most_polygons_are_as_large_as_one_can_read():
    """The return of a shaper, thrice as large as its forward stroke, does not make that a speck."""
    points = [[mark.at for mark in sheet.marks if isinstance(mark, PointMark) and mark.plane == "acceleration"]
              for sheet in _frames("ex3-7")]  # fmt: skip
    sizes = [max(abs(one - other) for one in each for other in each) for each in points]
    assert sizes[0] > 20 < np.median(sizes)


def test_drawn_position_has_all_its_polygons():
    """Even where that is near a dead point, and its polygons are larger than most."""
    first = motion_frames(graphkin.plan(graphkin.load("p3-22")), 3)[0]
    assert {mark.plane for mark in first.marks if isinstance(mark, VectorMark)} == {"velocity", "acceleration"}


def test_values_are_those_of_the_nearest_position():
    """A value changes midway between two positions: it is never behind the drawing by more than half a step."""
    text, shown = animation(_frames("ex3-7")), list[str]()
    for moment in (0.0, 0.4, 0.6, 1.4, 11.4, 11.6):
        texts = ("".join(each.itertext()) for each in ET.fromstring(still(text, moment / COUNT)).iter(f"{SVG}text"))
        shown += [re.sub(r"\s", "", each) for each in texts if each.startswith("φ")]
    assert shown == [f"φ1={angle}°" for angle in (0, 0, 30, 30, 330, 0)]


def test_first_moment_is_a_right_sheet(tmp_path: Path):
    """Without what moves it, a file's drawing passes the ruler, by what its first sheet says of itself."""
    frames = _frames("ex3-7")
    said = [re.search(r"<gk:sheet>.*?</gk:sheet>", text, re.S)[0] for text in (animation(frames), svg(frames[0]))]
    assert '"seal"' not in said[0]
    text = still(animation(frames).replace(*said), 0.0)
    (tmp_path / "first.svg").write_text(text, encoding="utf-8")
    report = graphkin.measure(tmp_path / "first.svg")
    assert report.passed(0.02)


def test_moving_svg_is_written_and_small(tmp_path: Path):
    path = tmp_path / "turn.svg"
    done = CliRunner().invoke(main, ["draw", "s2-2", "--animate", "--only", "position", "-o", str(path)])
    assert done.exit_code == 0, done.output
    assert path.stat().st_size < 80_000
    assert len(ET.fromstring(path.read_text(encoding="utf-8")).findall(f".//{SVG}animate")) > 20


@pytest.mark.parametrize("kind", drawings.MOVING)
def test_same_sheets_give_the_same_bytes(kind: str):
    """And a PNG has them all, over and over."""
    one, two = (drawings.MOVING[kind](_frames("ex3-7")[:3], 30, "accent") for _ in "12")
    assert one == two
    if kind == ".png":
        with Image.open(io.BytesIO(one)) as picture:
            assert (picture.n_frames, picture.info["loop"]) == (3, 0)


@pytest.mark.parametrize("more", [["-o", "a.pdf"], ["--steps", "x"], ["--angle", "3"], ["--tight"], ["--path", "C"]])
def test_what_does_not_go_together_is_said(more: list[str]):
    assert CliRunner().invoke(main, ["draw", "s2-2", "--animate", *more]).exit_code == 2


def test_a_motion_that_starts_at_a_dead_point_is_refused_as_its_sheet_is():
    """A tenth of a micron short of its reach: there is a way to go, of 0.005 deg."""
    with pytest.raises(DeadPoint):
        motion_frames(graphkin.plan(graphkin.loads(STRETCHED)))


@pytest.mark.parametrize(("drive", "told"), [
    ('link = "1"\nomega = "90 rpm"', "φ1 = 30°"), ('vector = "OC"\nangle = 25\nomega = 3', "φH = 25°"),
])  # fmt: skip
def test_the_drivers_place_and_the_sense_of_what_turns_are_told(drive: str, told: str):
    """Of a driver without a direction the angle from the drawn position on; no sign that nobody explains."""
    pose = '[[pose]]\nvector = "OC"\nangle = 25\n' * ("link" in drive)
    machine = graphkin.loads(PLANETARY.format(drive=drive, pose=pose))
    frames = motion_frames(graphkin.plan(machine), 12)
    texts = ["".join(run.text for run in mark.label) for frame in frames for mark in frame.marks if isinstance(mark, Text)]
    assert told in texts
    assert any(text.startswith("ω2 = ") and text.endswith(" cw") for text in texts)
    assert not any("= −" in text for text in texts)


PLANETARY = """
ask = ["omega 2", "v P"]
[frame]
O = [0, 0]
[links.1]
points = ["O"]
[links.H]
OC = 45
[links.2]
CP = 15
[[gear]]
links = ["1", "2"]
centres = ["O", "C"]
radii = [30, 15]
[[gear]]
links = ["2", "frame"]
centres = ["C", "O"]
radii = [15, 60]
internal = true
[[driver]]
{drive}
{pose}[[pose]]
vector = "CP"
angle = 80
"""


def test_a_slide_that_drives_tells_its_displacement():
    frames = motion_frames(graphkin.plan(graphkin.load("p3-22")), 4)
    driver = frames[0].mechanism.drivers[0]
    texts = ["".join(run.text for run in mark.label) for mark in frames[0].marks if isinstance(mark, Text)]
    assert driver.kind == "slide"
    assert any(text.startswith("s") and text.endswith(" mm") for text in texts)
