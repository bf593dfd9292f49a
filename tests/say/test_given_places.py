"""What a sheet says is given fixes the place of everything that does not move by itself."""

from __future__ import annotations

import pytest

from graphkin import Drawing, loads
from graphkin.files import library
from graphkin.planning import plan
from graphkin.running import replay_all
from graphkin.say.dimensions import dimensions
from graphkin.say.problem_data import problem_data
from graphkin.say.reading import Reading

SHIFTED = """
[frame]
A = [10, 5]
D = [60, 25]
[links.1]
AB = 20
[links.2]
BC = 60
[links.3]
CD = 40
[[driver]]
vector = "AB"
angle = 70
omega = 1
[sketch]
C = [70, 65]
"""


def said(machine) -> list[str]:
    method = plan(machine)
    return dimensions(Reading(method, replay_all(method), {}, "en"))


@pytest.mark.parametrize(("name", "texts"), [
    ("ex3-1", ["l_AD = 78 mm", "γ = 100°"]),  # level
    ("p3-4a", ["l_AC = 80 mm"]),  # upright
    ("p3-16", ["x_AF = 185 mm", "y_AF = 55 mm"]),
    ("p3-11b", ["β_B = 70°", "s_left = −50 mm"]),
    ("p3-21", ["l_AG = 20 mm", "x_H = 130 mm", "y_H = 50 mm", "s_screw = 90 mm"]),
])  # fmt: skip
def test_places_of_the_frame_and_of_driven_slides(name: str, texts: list[str]) -> None:
    assert set(texts) <= set(said(library.load(name)))


def test_coordinates_count_from_the_first_point() -> None:
    assert said(loads(SHIFTED))[:2] == ["x_AD = 50 mm", "y_AD = 20 mm"]


RAM = """
frame = { O = [0, 0] }
[links.1]
points = ["B"]
[links.2]
BC = 90
[links.3]
points = ["C"]
[[slide]]
name = "ram"
block = "1"
point = "B"
guide = "frame"
through = %s
angle = %s
[[slide]]
block = "3"
point = "C"
guide = "frame"
through = "O"
angle = 0
[[driver]]
slide = "ram"
at = 12
velocity = "10 mm/s"
[sketch]
C = [90, 0]
B = [10, 20]
"""


@pytest.mark.parametrize(("through", "angle", "texts"), [
    ("[-20, 10]", 40, ["x_B,0 = −20 mm", "y_B,0 = 10 mm"]),
    ("[15, 25]", 0, ["x_B,0 = 15 mm", "e_B = 25 mm"]),  # how far off it lies is the other coordinate
])  # fmt: skip
def test_the_start_of_a_guide_is_told_as_the_file_states_it(through: str, angle: int, texts: list[str]) -> None:
    """Of a line without a letter the distance alone does not tell where a displacement begins."""
    told = [text for text in said(loads(RAM % (through, angle))) if text[:2] in ("x_", "y_", "e_")]
    assert told[: len(texts)] == texts
    assert len(told) == (3 if angle else 2)


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_coordinates_of_a_start_are_said_once(lang: str) -> None:
    method = plan(loads(RAM % ("[-20, 10]", 40)))
    told = [str(entry) for entry in problem_data(Reading(method, replay_all(method), {}, lang))]
    assert sum(text.count("(−20, 10)") for text in told) == 1


STATED = """
[frame]
A = [0, 0]
D = ["5 in", "-1 in"]
[links.1]
AB = "2.50 in"
[links.2]
BC = "0.15 m"
BE = 60
CBE = 30
ccw = [["B", "C", "E"]]
[links.3]
CD = "5 in"
[[driver]]
vector = "AB"
angle = "1.2 rad"
omega = "-60 rpm"
[sketch]
C = [160, 100]
E = [80, 120]
"""


def test_data_are_stated_as_the_file_states_them() -> None:
    """Values, angles and units of the file; derived lengths, such as l_CE, are none."""
    assert said(loads(STATED)) == [
        "x_D = 5 in", "y_D = −1 in", "l_AB = 2.50 in", "l_BC = 0.15 m", "l_BE = 60 mm", "∠CBE = 30°", "l_CD = 5 in",
        "φ1 = 1.2 rad", "n1 = 60 r/min",
    ]  # fmt: skip


WHEEL = """
[frame]
[links.W]
CA = "0.8 ft"
[links.AB]
AB = "3 ft"
[links.B]
points = ["B"]
[[roll]]
name = "x"
wheel = "W"
centre = "C"
radius = "1.2 ft"
on = "frame"
through = [0, 0]
[[slide]]
block = "B"
point = "B"
guide = "frame"
through = [0, "0.5 ft"]
[[pose]]
slide = "x"
at = 0
[[driver]]
vector = "CA"
angle = 90
velocity = "3 m/s"
acceleration = "2 m/s²"
also = [120, 150]
[sketch]
C = [0, 366]
A = [0, 610]
B = [770, 152]
"""


def test_a_guide_beside_a_track_has_its_height_and_a_tip_its_tangential_acceleration() -> None:
    texts = said(loads(WHEEL))
    assert {"e_B = 0.5 ft", "also φ_W = 120°, 150°", "v_A = 3 m/s", "aᵗ_A = 2 m/s²"} <= set(texts)
    through = WHEEL.replace("[frame]", '[frame]\nD = [0, 0]').replace('[0, "0.5 ft"]', '"D"')
    assert not any(text.startswith("e_") for text in said(loads(through)))


FLAT = """
frame = { O = [0, 0], X = [40, 0] }
links = { 1.OC = 20, 2.points = ["F"] }
slide = [{ name = "lift", block = "2", point = "F", guide = "frame", through = "O", angle = 90 }]
cam = [{ links = ["1", "2"], profiles = [{ centre = "C", radius = 50 }, { through = "F", from = "OX", angle = 0 }] }]
driver = [{ vector = "OC", angle = 30, omega = 5 }]
sketch = { F = [0, 60] }
"""


@pytest.mark.parametrize(("turned", "said"), [("angle = 0", "parallel to O→X"), ("angle = 10", "makes 10° with O→X")])
def test_a_face_of_one_point_is_said_by_the_points_that_it_is_measured_from(turned: str, said: str) -> None:
    told = "\n".join(Drawing.of(loads(FLAT.replace("angle = 0", turned))).explain())
    assert said in told


def test_a_changed_size_is_not_said_to_be_as_stated() -> None:
    machine = loads(STATED).with_({"links.1.AB": 70})
    assert "l_AB = 70 mm" in said(machine)
