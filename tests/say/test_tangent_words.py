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
