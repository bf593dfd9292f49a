"""`side` left out is as the sketch has it; where the other side alone closes, the error says so."""

from __future__ import annotations

import cmath
from itertools import product

import pytest

import graphkin
from graphkin import files as loading
from graphkin.errors import OtherSide
from graphkin.model.mechanism import Mechanism
from graphkin.model.pairs import Cam, RollingContact

FOLLOWER = """
[frame]
A = [0, 0]
[links.1]
AB = 20
[links.2]
{link}
[[cam]]
links = ["1", "2"]
profiles = [{{ centre = "B", radius = 40 }}, {{ {face} }}]
[[slide]]
block = "2"
point = "C"
guide = "frame"
through = "A"
angle = {way}
{tilt}
[[driver]]
vector = "AB"
angle = 30
omega = 10
[sketch]
C = [{x}, {y}]
"""
RACK = """
[frame]
A = [0, 0]
[links.1]
AB = 30
[links.2]
CQ = 100
[[roll]]
wheel = "1"
centre = "A"
radius = 40
on = "2"
through = "C"
toward = "Q"
{side}
[[slide]]
name = "rack"
block = "2"
point = "C"
guide = "frame"
through = [{x}, {y}]
angle = {way}
tilt = {tilt}
[[pose]]
slide = "rack"
at = -50
[[driver]]
vector = "AB"
angle = 30
omega = 5
[sketch]
C = [{cx}, {cy}]
"""


def turned(x: float, y: float, degrees: float) -> complex:
    return complex(x, y) * cmath.rect(1, degrees * cmath.pi / 180)


def follower(way: float, up: bool, alone: bool) -> Mechanism:
    """A flat follower that moves along a direction, drawn before or behind the cam's axis."""
    at = turned(50 if up else -50, 0, way)
    link = 'points = ["C"]' if alone else "CH = 30"
    face = f'through = "C", angle = {way - 90}' if alone else 'through = "C", toward = "H"'
    tilt = "" if alone else "tilt = -90"
    return loading.loads(FOLLOWER.format(link=link, face=face, way=way, tilt=tilt, x=at.real, y=at.imag))


def rack(way: float, above: bool, back: bool, side: str = "") -> Mechanism:
    """A rack over or under its pinion; `back`: its own direction runs against the slide's."""
    foot = turned(0, 40 if above else -40, way)
    corner = foot + turned(-50, 0, way)
    text = RACK.format(side=side, x=foot.real, y=foot.imag, way=way, tilt=180 if back else 0, cx=corner.real, cy=corner.imag)
    return loading.loads(text)


@pytest.mark.parametrize(("way", "up", "alone"), [*product((90, 0, 217.0), (True, False), (True, False))])
def test_a_face_lies_where_it_is_sketched(way: float, up: bool, alone: bool) -> None:
    mechanism = follower(way, up, alone)
    plot = graphkin.Drawing.of(mechanism).plot
    along = (complex(plot.position["C"]) / cmath.rect(1, way * cmath.pi / 180)).real
    assert (along > 0) == up
    (cam,) = mechanism.of(Cam)
    assert cam.profiles[1].left != up


@pytest.mark.parametrize(("way", "above", "back"), [*product((0, 130.0), (True, False), (True, False))])
def test_a_rack_lies_where_it_is_sketched(way: float, above: bool, back: bool) -> None:
    mechanism = rack(way, above, back)
    (roll,) = mechanism.of(RollingContact)
    assert roll.left == (above == back)
    assert graphkin.Drawing.of(mechanism).plot.omega["1"] == pytest.approx(5)


def test_without_a_sketch_it_is_left() -> None:
    (cam,) = loading.loads(FOLLOWER.split("[sketch]")[0].format(
        link='points = ["C"]', face='through = "C", angle = 0', way=90, tilt="")).of(Cam)  # fmt: skip
    assert cam.profiles[1].left


HELD = FOLLOWER.format(link='CH = 30\nCL = 60\nHCL = 90\nccw = ["C", "H", "L"]', face='through = "C", toward = "H", side = "left"',
                       way=90, tilt="tilt = -90", x=0, y=50) + """
[links.3]
LM = 70
[links.4]
points = ["M"]
[[slide]]
block = "4"
point = "M"
guide = "frame"
through = [0, 150]
"""  # fmt: skip


def test_the_side_that_closes_is_named() -> None:
    with pytest.raises(OtherSide) as refused:
        graphkin.plan(loading.loads(HELD.replace("[sketch]\nC = [0, 50]", ""), file="held.toml"))
    assert str(refused.value.where).endswith("cam.0.profiles.1.side")
    assert 'side = "right"' in refused.value.message("zh")
    graphkin.plan(loading.loads(HELD.replace('"left"', '"right"').replace("C = [0, 50]", "C = [0, 50]\nM = [60, 150]")))


ACROSS = """
[frame]
A = [0, 0]
D = [0, -100]
[links.1]
AB = 50
[links.2]
points = ["B"]
[links.3]
{link}
[links.4]
DE = 300
[[slide]]
block = "2"
point = "B"
guide = "3"
through = "C"
from = "{base}"
angle = {angle}
[[slide]]
name = "ram"
block = "3"
point = "C"
guide = "4"
through = "D"
toward = "E"
{tilt}
[[driver]]
vector = "AB"
angle = 30
omega = 10
alpha = 3
[[driver]]
vector = "DE"
angle = {bar}
omega = 1
"""


@pytest.mark.parametrize(("angle", "bar"), [*product((60, 90, -45), (80, 110))])
def test_a_slot_at_an_angle_on_a_link_of_one_point(angle: float, bar: float) -> None:
    """The same as with a second point, on a moving guide; the slot is passed either way."""
    one = ACROSS.format(link='points = ["C"]', base="DE", angle=angle, tilt="", bar=bar)
    two = ACROSS.format(link="CQ = 40", base="CQ", angle=angle, tilt="tilt = 0", bar=bar)
    found, like = (graphkin.Drawing.of(loading.loads(text)).plot for text in (one, two))
    assert abs(found.position["C"] - like.position["C"]) < 1e-12
    assert float(found.s["s0"]) == pytest.approx(float(like.s["s0"]))


def test_on_a_moving_guide_the_direction_is_to_be_said() -> None:
    text = ACROSS.format(link='points = ["C"]', base="DE", angle=60, tilt="", bar=80)
    with pytest.raises(graphkin.GraphkinError, match="direction of the line on link 4 is open"):
        loading.loads(text.replace('from = "DE"\n', ""))
