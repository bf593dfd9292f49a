"""The tangent that a text has drawn is the one on which the guide line lies, and not its mirror image."""

from __future__ import annotations

import cmath
import math
import re

import pytest

import graphkin
from graphkin import Drawing

TANGENT = re.compile(r"touches it at T \(D→T→B (clockwise|counter-clockwise)\)")
GUIDE = """
frame = {{ A = [0, 0], D = [78, 0] }}
links = {{ 1.AB = 24, 2 = {{ points = ["B"] }}, 3.DC = 48 }}
slide = [{{ block = "2", point = "B", guide = "3", through = "C", from = "DC", angle = {angle} }}]
driver = [{{ vector = "AB", angle = {crank}, omega = 10 }}]
sketch = {{ C = [65, {side}] }}
"""


@pytest.mark.parametrize("angle", [100, 60, -75, 130])
@pytest.mark.parametrize("side", [46, -46])
@pytest.mark.parametrize("crank", [60, 200])
def test_the_sense_of_a_tangent(angle: int, side: int, crank: int):
    drawing = Drawing.of(graphkin.loads(GUIDE.format(angle=angle, side=side, crank=crank)))
    b, c, d = (complex(drawing.plot.position[point]) for point in "BCD")
    along = cmath.rect(1.0, cmath.phase(c - d) + math.radians(angle))
    t = c + ((d - c) * along.conjugate()).real * along
    (sense,) = TANGENT.findall("\n".join(drawing.explain("en")))
    assert (((t - d).conjugate() * (b - t)).imag > 0) == (sense == "counter-clockwise")


LEVER = """
frame = {{ O2 = [0, 0], O4 = [0, 25] }}
links = {{ 2.O2A = 60, 3 = {{ O4B = 55, O4F = 90, BO4F = {corner}, ccw = ["B", "O4", "F"] }} }}
slide = [{{ pin = "A", guide = "3", through = "O4", toward = "F" }}]
driver = [{{ vector = "O2A", angle = {crank}, omega = 9 }}]
sketch = {{ A = [46, -38], B = [-20, 75] }}
"""


@pytest.mark.parametrize("corner", [30, 150])
@pytest.mark.parametrize("crank", [-40, 100])
def test_an_arm_is_turned_from_the_end_of_the_line_that_is_named(corner: int, crank: int):
    drawing = Drawing.of(graphkin.loads(LEVER.format(corner=corner, crank=crank)))
    o4, a, b = (complex(drawing.plot.position[point]) for point in ("O4", "A", "B"))
    turned = math.degrees(cmath.phase((b - o4) / (a - o4)))
    sense = "counter-clockwise" if turned > 0 else "clockwise"
    assert f"turned by ∠BO4A = {abs(turned):.0f}° {sense} from O4A: B." in "\n".join(drawing.explain("en"))
