"""A sweep never leaves its branch: whatever rolls along, through change points, there and back, by both roads."""

from __future__ import annotations

import math
import os
from collections.abc import Callable
from importlib import import_module

import numpy as np
import pytest
from continuity import hold_continuous
from folding import KINDS, folding
from random_mechanisms import (
    DYADS,
    cam,
    chain,
    circular_slot,
    coupler_angle,
    cylinder,
    dyad,
    epicyclic,
    geared_five_bar,
    relative_angle,
    rolling,
    six_bar,
    triad,
)

from graphkin.errors import DeadPoint, RoadsDiffer
from graphkin.files import loads
from graphkin.model.mechanism import Mechanism
from graphkin.planning import plan
from graphkin.proof.roads import apart
from graphkin.say.sweeps import change_line, left_out, remarks
from graphkin.studies.sweeps import course, in_parts, prove, sweep
from graphkin.studies.sweeps.roads import moving

COUNT = int(os.environ.get("GRAPHKIN_RANDOM", "0"))
"""Mechanisms of each kind; 0: one of some kinds."""
FAMILIES = {f.__name__: f for f in (cylinder, relative_angle, coupler_angle, chain, triad, six_bar, geared_five_bar, epicyclic, rolling, cam,
                                       circular_slot)}  # fmt: skip
SOME = KINDS if COUNT else KINDS[1::3]


@pytest.mark.many
@pytest.mark.parametrize(("linkage", "wheel"), SOME)
def test_linkages_that_fold_go_on_smoothly(linkage: str, wheel: str):
    for seed in range(max(COUNT, 1)):
        hold_continuous(folding(linkage, wheel, seed))


SCISSORS = """
frame = {{ name = "1", A = [0, 0], Q = [520, -45] }}
[links]
2.shape = {{ A = [0, 0], M = [640, 0], N = [910, 0], C = [1280, 0] }}
3.shape = {{ B = [0, 0], M = [640, 0], D = [1280, 0] }}
4.shape = {{ D = [0, 0], P = [400, 160], E = [1200, 0] }}
5.points = ["B"]
6.points = ["C"]
{links}
[[slide]]
name = "floor"
block = "5"
point = "B"
guide = "frame"
through = "A"
angle = 0
[[slide]]
name = "table"
block = "6"
point = "C"
guide = "4"
through = "D"
toward = "E"
{driver}
[sketch]
B = [1150, 0]
C = [1150, 560]
D = [0, 560]
M = [575, 280]
N = [820, 400]
P = [400, 720]
{sketch}
"""
JACK = """
[links.7]
points = ["Q"]
[[slide]]
name = "jack"
block = "8"
point = "N"
guide = "7"
tilt = 180
[[driver]]
slide = "jack"
at = 520
velocity = "25 mm/s"
"""
LEVER = '[[driver]]\nvector = "AC"\nangle = 30\nomega = 1'
SECOND = "9.CF = 900\n10.DF = 900"


@pytest.mark.parametrize(("links", "driver", "sketch"), [
    ("8.NN1 = 300", JACK, ""), ("", LEVER, ""), (SECOND, LEVER, "F = [575, 1300]"),
])  # fmt: skip
def test_what_touches_only_on_the_way_through_a_change_point_is_gone_through_with_it(links: str, driver: str, sketch: str):
    """Upright scissors: B meets A, and C meets D, though the old crossing would leave C and D together from there on."""
    scissors = loads(SCISSORS.format(links=links, driver=driver, sketch=sketch))
    moved = course(plan(scissors))
    assert [change.kind for change in moved.path.changes] == ["right angle"] * len(moved.path.changes) != []
    hold_continuous(scissors, turns=1)


@pytest.mark.parametrize(("lang", "told"), [
    ("en", "link 3 stands at right angles there to the guide along which link 5 slides on link 1"), ("zh", "构件 3 垂直于构件 5 在构件 1 上滑动的导路"),
])  # fmt: skip
def test_a_bar_at_right_angles_to_a_guide_is_named(lang, told: str):
    moved = course(plan(loads(SCISSORS.format(links="", driver=LEVER, sketch=""))))
    assert told in change_line(moved, moved.path.changes[0], lang)


@pytest.mark.many
@pytest.mark.parametrize("family", [*(DYADS if COUNT else ()), *FAMILIES])
def test_random_mechanisms_go_on_smoothly(family: str):
    make: Callable[[int], Mechanism] = FAMILIES.get(family) or (lambda seed: dyad(family, seed))
    for seed in range(max(COUNT, 1)):
        try:
            hold_continuous(make(seed), turns=2 if COUNT else 1)
        except DeadPoint:
            continue


@pytest.mark.parametrize("by", ["construction", "analysis"])
def test_there_and_back_is_the_same(by: str):
    """Down as up, past change points on both sides of the drawn position, a geared wheel too."""
    method = plan(folding("parallelogram", "bar on a planet", 3))
    names = ["omega 2", "omega 3", "omega 9", "alpha 9", "v N", "a N"]
    up, down = (sweep(method, [span], names, by) for span in ("-720:720:8", "720:-720:-8"))
    assert np.allclose(down.driven[::-1], up.driven, rtol=0, atol=1e-12)
    for name in names:
        assert np.allclose(down[name].values[::-1], up[name].values, rtol=1e-9, atol=1e-9), name
    later = sweep(method, ["696:720:8"], names, by)
    assert np.allclose(later["a N"].values, up["a N"].values[-4:], rtol=1e-9)


@pytest.mark.parametrize(("span", "same"), [("360:0:-30", "360:0:30"), ("90:-90:-20", "90:-90:20")])
def test_a_range_downwards_may_have_a_step_below_0(span: str, same: str):
    method = plan(folding("rhombus", "none", 0))
    assert np.array_equal(course(method, [span]).values, course(method, [same]).values)


RACK = """
[frame]
O = [0, 0]
[links.1]
OA = 30
[links.2]
CD = 200
[[roll]]
wheel = "1"
centre = "O"
radius = 40
on = "2"
through = "C"
toward = "D"
side = "right"
[[slide]]
name = "end"
pin = "C"
guide = "frame"
through = "O"
angle = 90
[[driver]]
vector = "OA"
angle = 30
omega = 2
[[pose]]
vector = "CD"
angle = -30
[sketch]
A = [26, 15]
C = [0, 46]
D = [173, -54]
"""


def test_a_fit_ends_where_it_stands_at_right_angles():
    """The bar's end comes to where it touches the pinion: s - r atan(s / r) = r turned, flat at s = 0. There the way ends."""
    moved = course(plan(loads(RACK, name="rack", file="rack.toml")), ["0:720:5"])
    s = 0.04 / math.tan(math.radians(60))
    turned = s / 0.04 - math.atan2(s, 0.04)
    (stop,) = moved.path.stops
    assert stop.at == pytest.approx(-turned, abs=1e-6)
    assert prove(moved) < 1e-9


# --- what is told, and what is not ------------------------------------------------------------------


def test_roads_that_differ_give_no_sweep(monkeypatch: pytest.MonkeyPatch):
    module = import_module("graphkin.studies.sweeps.roads")
    moved = course(plan(folding("parallelogram", "crank", 0)), ["0:360:30"])
    assert prove(moved) < 1e-9
    other = course(plan(folding("parallelogram", "crank", 1)), ["0:360:30"])
    told = module.moving
    monkeypatch.setattr(
        module, "moving", lambda method, path, t, by: told(*((other.method, other.path) if by == "analysis" else (method, path)), t, by)
    )
    with pytest.raises(RoadsDiffer):
        prove(course(plan(folding("parallelogram", "crank", 0)), ["0:360:30"]))


def test_positions_without_a_motion_are_left_out(monkeypatch: pytest.MonkeyPatch):
    module = import_module("graphkin.studies.sweeps.sweep")
    told = module.series

    def failing(*words):
        entry = told(*words)
        if entry is not None and entry.name == "omega 3":
            entry.values[2] = np.inf
        return entry

    monkeypatch.setattr(module, "series", failing)
    moved = course(plan(folding("rhombus", "none", 0)), ["0:360:30"])
    (found,) = in_parts(moved, ["omega 3", "v B"])
    assert found.driven.size == found["v B"].values.size == 12
    assert math.degrees(found.undefined[0]) == pytest.approx(60)
    assert "60°" in next(left_out(moved, found.undefined, "en"))


def test_blocks_that_run_off_are_told_by_both_roads():
    """Beside a stop where guides become parallel and displacements grow without bound, though the links hardly turn."""
    method = plan(chain(9))
    moved = course(method, ["0:360:2"])
    prove(moved)
    t = moved.path.first + np.radians([0.2, 1.0, 5.0])
    drawn, exact = (moving(method, moved.path, t, by) for by in ("construction", "analysis"))
    assert max(np.max(np.abs(s)) for s in exact.s.values()) > 5 * method.size
    assert apart(method.mechanism, drawn, exact) < 1e-9


TRAMMEL = """
frame = { name = "1", O = [0, 0] }
links = { 2.points = ["X"], 3.points = ["Y"], 4.XY = 120 }
slide = [{ name = "bed", block = "2", point = "X", guide = "frame", through = "O", angle = 0 },
         { block = "3", point = "Y", guide = "frame", through = "O", angle = 90 }]
driver = [DRIVER]
sketch = { X = [70, 0], Y = [0, 97] }
"""


@pytest.mark.parametrize(("lang", "told"), [("en", "With link 4 as the driver"), ("zh", "若改以构件 4 为原动件")])
def test_at_the_dead_points_of_a_driver_another_link_is_named_that_goes_on(lang, told: str):
    """A trammel that a block draws makes half of its ellipse; by its bar all of it."""
    pulled = course(plan(loads(TRAMMEL.replace("DRIVER", '{ slide = "bed", at = 70, velocity = -9 }'))))
    assert any(told in line for line in remarks(pulled, lang))
    turned = course(plan(loads(TRAMMEL.replace("DRIVER", '{ vector = "XY", angle = 126, omega = 1 }'))))
    assert turned.full_turn
    assert not any(told in line for line in remarks(turned, lang))


def test_limits_of_a_file_in_inches_are_told_in_these_too():
    inches = TRAMMEL.replace("4.XY = 120", '4.XY = "4.75 in"').replace("DRIVER", '{ slide = "bed", at = "2.9 in", velocity = -9 }')
    told = "\n".join(remarks(course(plan(loads(inches))), "en"))
    assert "bed moves from −120.65 mm (−4.75 in) to 120.65 mm (4.75 in)" in told.replace("120.650", "120.65").replace("4.750", "4.75")
    metric = "\n".join(remarks(course(plan(loads(TRAMMEL.replace("DRIVER", '{ slide = "bed", at = 70, velocity = -9 }')))), "en"))
    assert " in)" not in metric
