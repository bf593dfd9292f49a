"""A bar on a hydraulic cylinder, which drives it: a file with a place for each of the two motions."""

from __future__ import annotations

CYLINDER = """
[frame]
name = "1"
D = [0, 0]
C = [800, 0]
[links.4]
DB = 700
[links.2]
points = ["C"]
[links.3]
points = ["B"]
[[slide]]
name = "jack"
block = "3"
point = "B"
guide = "2"
through = "C"
[[driver]]
slide = "jack"
at = 900
velocity = VELOCITY
acceleration = ACCELERATION
[sketch]
B = [400, 650]
"""


def cylinder(velocity: float, acceleration: float) -> str:
    return CYLINDER.replace("VELOCITY", f"{velocity}").replace("ACCELERATION", f"{acceleration}")
