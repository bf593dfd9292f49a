"""Arcs of the angular velocities and accelerations that are asked for: none is missing where others are drawn."""

from __future__ import annotations

import pytest

from graphkin.files import loads
from graphkin.planning import plan
from graphkin.running import replay_all
from graphkin.sheet import sheet

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
