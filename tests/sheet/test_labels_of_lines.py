"""Labels tell what they name: none stands beyond a bar, or across another curve, if there is room elsewhere."""

from __future__ import annotations

from graphkin.files import loads
from graphkin.planning import plan
from graphkin.running import replay_all
from graphkin.sheet import sheet
from graphkin.sheet.drafting_figure import named
from graphkin.sheet.lettering import LABEL, plain, width
from graphkin.sheet.marks import PointMark, Stroke, Text

WHITWORTH = """
ask = ["omega 4", "v F", "a F", "alpha 4"]
[frame]
name = "1"
A = [0, 0]
C = [0, -50]
[links.2]
AB = 120
[links.3]
points = ["B"]
[links.4]
shape = { C = [0, 0], D = [180, 0], E = [-70, 0] }
[links.5]
EF = 300
[links.6]
points = ["F"]
[[slide]]
block = "3"
point = "B"
guide = "4"
through = "C"
toward = "D"
[[slide]]
name = "ram"
block = "6"
point = "F"
guide = "frame"
through = "C"
angle = 180
[[driver]]
vector = "AB"
angle = 25
omega = "-45 rpm"
[sketch]
F = [-340, -50]
E = [-60, -90]
D = [150, 60]
B = [100, 50]
"""


def test_an_angle_s_value_is_not_beyond_its_arm() -> None:
    """Above the crank it would be that of the arrow's arc, which begins there."""
    method = plan(loads(WHITWORTH))
    page = sheet(method, replay_all(method))
    at = {m.name: m.at for m in page.marks if isinstance(m, PointMark) and m.plane == "position"}
    texts = {"".join(run.text for run in m.label): m for m in page.marks if isinstance(m, Text)}
    value = texts["φ2 = 25°"]
    middle = value.at + width(value.label, LABEL) / 2 - LABEL / 4 * 1j
    assert ((middle - at["A"]) / (at["B"] - at["A"])).imag > 0  # below AB on paper, where its arc is


def test_a_curve_is_named_where_its_whole_name_keeps_off_others() -> None:
    """The long piece comes near another one all along; the short one is far from it."""
    label = plain("moving centrode (link 3)")
    long, short = Stroke((0j, 100 + 10j, 200 + 10j)), Stroke((400j, 60 + 400j))
    (want,) = named([long, short], label, [Stroke((-50 + 30j, 250 + 30j))])
    assert want.start.imag == 400
    (want,) = named([long, short], label, [Stroke((-50 + 80j, 250 + 80j))])
    assert want.start.imag < 400


def test_a_corner_that_only_paper_takes_for_the_pole_is_named_there() -> None:
    """The text lays its arrow off, 0.02 mm long, and draws a line from its end."""
    text = """
ask = ["alpha 3"]
frame = { name = "4", O2 = [0, 0], O4 = [90, 15] }
links = { 1.O2A = 30, 2 = { AB = 80, AE = 60, BE = 45, ccw = ["A", "B", "E"] }, 3.O4B = 65 }
driver = [{ vector = "O2A", angle = 235, omega = "-120 rpm" }]
sketch = { B = [55, 70], E = [20, 60] }
"""
    method = plan(loads(text))
    page = sheet(method, replay_all(method))
    texts = {"".join(run.text for run in mark.label) for mark in page.marks if isinstance(mark, Text)}
    assert {", o2′", ", o4′", ", n3′"} <= texts
