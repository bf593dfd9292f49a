"""Redundant constraints (虚约束): found by rank, set aside, and held on both roads; near misses are refused."""

from __future__ import annotations

import math
import os
import random

import numpy as np
import pytest
from repeating import FAMILIES

from graphkin.analytic import mobility, motion
from graphkin.api import Drawing, plan
from graphkin.errors import NotRepeated, TooManyDrivers, TurnsAsItLikes
from graphkin.files import loads
from graphkin.model.mechanism import Mechanism
from graphkin.model.quantities import read
from graphkin.planning import Method
from graphkin.planning.equivalent import contacts, lower_pairs
from graphkin.planning.redundancy import redundant_constraints
from graphkin.planning.structure import Topology
from graphkin.proof.roads import compare
from graphkin.results import results
from graphkin.running import replay_all
from graphkin.say.structure import structure_lines
from graphkin.studies.assur import structure

COUNT = max(2, int(os.environ.get("GRAPHKIN_RANDOM", "400")) // 200)
"""Random mechanisms of each kind; more of them with GRAPHKIN_RANDOM=20000 in the environment."""

NEAR = {name: off for name, (_, off) in FAMILIES.items() if off}


def make(name: str, seed: int, off: float = 0.0) -> Mechanism:
    return loads(FAMILIES[name][0](random.Random(seed), off), name=name)


def equations_set_aside(method: Method) -> int:
    """How many equations repeat others: all of a pair's; of a link on two hinges the one that its length is."""
    return sum(1 if each.part == "link" else len(each.rows) for each in method.aside)


@pytest.mark.parametrize("name", FAMILIES)
def test_both_roads_agree_on_what_repeats(name: str) -> None:
    for seed in range(COUNT):
        mechanism = make(name, seed)
        method, exact = plan(mechanism), motion(mechanism)
        plot = replay_all(method)
        assert equations_set_aside(method) == mobility(mechanism).repeated, seed
        assert compare(method, plot, exact) < 1e-9, seed
        assert exact.s.keys() <= plot.s_rate.keys() & plot.s_acceleration.keys(), seed


@pytest.mark.parametrize("name", FAMILIES)
def test_both_roads_agree_on_the_way(name: str) -> None:
    mechanism = make(name, 5)
    method = plan(mechanism)
    steps = np.linspace(-1, 1, 5)
    spans = [0.02 if driver.kind == "slide" else math.radians(12) for driver in method.drivers]
    values = [(driver.value or 0.0) + span * steps for driver, span in zip(method.drivers, spans, strict=True)]
    assert compare(method, replay_all(method, values), motion(mechanism, values)) < 1e-9


@pytest.mark.parametrize("name", NEAR)
def test_what_contradicts_is_refused_with_how_much(name: str) -> None:
    for seed in range(COUNT):
        with pytest.raises(NotRepeated) as error:
            plan(make(name, seed, NEAR[name]))
        assert 0 < error.value.off < 2
        assert str(f"{error.value.off:.4g}") in error.value.message("zh")


def test_the_amount_is_what_was_put_in() -> None:
    for name, unit in (("table_on_guides", "deg"), ("wheel_between_plates", "mm"), ("breadth_cam", "mm"),
                       ("trammel", "mm"), ("wheel_on_belt", "deg")):  # fmt: skip
        with pytest.raises(NotRepeated) as error:
            plan(make(name, 4, NEAR[name]))
        assert error.value.unit == unit
        assert error.value.off == pytest.approx(NEAR[name], rel=1e-6)


@pytest.mark.many
@pytest.mark.usefixtures("one_paper")
@pytest.mark.parametrize("name", FAMILIES)
def test_it_is_named_and_explained(name: str) -> None:
    mechanism = make(name, 6)
    drawing = Drawing.of(mechanism)
    for lang in ("en", "zh"):
        told, found = "\n".join(structure_lines(structure(drawing.method), lang)), structure(drawing.method)
        rolled = found.rolls
        assert ("  repeats a constraint: " if lang == "en" else "  虚约束：") in told
        assert found.formula + found.repeated - found.uncounted == found.mobility.freedoms
        assert all(f"{count}" in told and "–".join(links) in told for links, count in rolled)
        assert any(("Redundant" if lang == "en" else "虚约束") in line for line in drawing.explain(lang))


def test_repeated_slides_have_their_values_on_both_roads() -> None:
    mechanism = make("table_on_guides", 2)
    (position,) = results(mechanism, plan(mechanism))["positions"]
    for quantity in ("s", "v", "a"):
        drawn, exact = (position[road]["slides"]["high"][quantity] if road else position["slides"]["high"][quantity]
                        for road in ("", "analytic"))  # fmt: skip
        assert drawn == pytest.approx(exact, rel=1e-9, abs=1e-12)


WHEEL = """
[frame]
O = [0, 0]
[links.low]
DG = 300
[links.high]
EF = 300
[links.wheel]
CP = 50
[[slide]]
name = "d"
block = "low"
point = "D"
guide = "frame"
through = "O"
tilt = 0
[[slide]]
name = "e"
block = "high"
point = "E"
guide = "frame"
through = [0, 100]
tilt = 0
[[roll]]
name = "c"
wheel = "wheel"
centre = "C"
radius = 50
on = "low"
through = "D"
toward = "G"
[[roll]]
wheel = "wheel"
centre = "C"
radius = 50
on = "high"
through = "E"
toward = "F"
side = "right"
[[driver]]
slide = "d"
at = -150
velocity = 0.25
acceleration = 1
[[driver]]
slide = "e"
at = -150
velocity = -0.4
acceleration = 3
[[pose]]
slide = "c"
at = 150
[[pose]]
vector = "CP"
angle = 0
[sketch]
D = [-150, 0]
G = [150, 0]
E = [-150, 100]
F = [150, 100]
C = [0, 50]
"""


def test_wheel_between_two_plates_as_a_textbook_solves_it() -> None:
    """omega = (v_bottom - v_top) / 2r counter-clockwise, the centre moves by the mean; so do the accelerations along."""
    method = plan(loads(WHEEL))
    plot = replay_all(method)
    assert plot.omega["wheel"] == pytest.approx((0.25 + 0.4) / 0.1)
    assert plot.alpha["wheel"] == pytest.approx((1 - 3) / 0.1)
    assert plot.s_rate["c"] + 0.25 == pytest.approx((0.25 - 0.4) / 2)
    assert plot.s_acceleration["c"] + 1 == pytest.approx((1 + 3) / 2)
    (found,) = method.aside
    assert (found.pair, found.part, set(found.held)) == (("roll", 1), "line", {("slide", 0), ("slide", 1), ("roll", 0)})


def aside_of(mechanism: Mechanism) -> list[tuple[object, str]]:
    lower = lower_pairs(mechanism)
    found = redundant_constraints(mechanism, Topology(lower, tuple(contacts(mechanism, lower))))
    return [(each.pair, each.part) for each in found]


TABLE = """
[frame]
O = [0, 0]
[links.1]
OA = 30
[links.2]
AB = 100
[links.3]
shape = {{ B = [0, 0], C = [0, 50] }}
[[slide]]
name = "low"
block = "3"
point = "B"
guide = "frame"
through = "O"
tilt = 90
[[slide]]
name = "high"
block = "3"
point = "C"
guide = "frame"
through = [0, 50]
tilt = 90
[[driver]]
{driver}
[sketch]
A = {a}
B = {b}
C = [{c}, 50]
"""
CRANK = 'vector = "OA"\nangle = 70\nomega = 5'


def table(driver: str, phi: float = 70.0) -> Mechanism:
    a = 30 * complex(math.cos(math.radians(phi)), math.sin(math.radians(phi)))
    x = a.real + math.sqrt(100**2 - a.imag**2)
    places = {"a": [a.real, a.imag], "b": [x, 0.0], "c": x}
    return loads(TABLE.format(driver=driver.format(s=x), **places))


@pytest.mark.parametrize(("driver", "phi", "aside"), [
    (CRANK, 70.0, 1),                                         # of two, the later one in the file
    ('slide = "high"\nat = {s!r}\nvelocity = 1', 70.0, 0),    # never the one that is driven
    ('slide = "low"\nat = {s!r}\nvelocity = 1', 70.0, 1),
    (CRANK.replace("70", "0"), 0.0, 1),                       # at a dead point no more repeats than elsewhere
])  # fmt: skip
def test_which_of_two_guides_goes(driver: str, phi: float, aside: int) -> None:
    assert aside_of(table(driver, phi)) == [(("slide", aside), "whole")]


def test_what_is_asked_for_stays() -> None:
    text = TABLE.format(driver=CRANK, a=[10, 28], b=[106, 0], c=106)
    assert aside_of(loads('ask = ["s high"]\n' + text)) == [(("slide", 0), "whole")]


def test_a_dead_point_is_no_redundancy() -> None:
    """A slider-crank that stands stretched, and a parallelogram that lies flat, repeat nothing."""
    flat = """
[frame]
O = [0, 0]
D = [80, 0]
[links.1]
OA = 30
[links.2]
AB = 80
[links.3]
DB = 30
[[driver]]
vector = "OA"
angle = 0
omega = 1
[sketch]
A = [30, 0]
B = [110, 0]
"""
    third = flat.replace("D = [80, 0]", "D = [80, 0]\nH = [40, 0]").replace("AB = 80", "AB = 80\nAC = 40\nBC = 40")
    third = third.replace("[[driver]]", "[links.4]\nHC = 30\n[[driver]]").replace("B = [110", "C = [70, 0]\nB = [110")
    assert aside_of(loads(flat)) == []
    assert aside_of(loads(third)) == [(("links", "4"), "link")]


ROLLERS = """
[frame]
O = [0, 0]
[links.1]
OA = 20
[links.2]
BC = 100
[links.3]
points = ["B"]
[links.4]
points = ["C"]
[[cam]]
links = ["1", "3"]
profiles = [{ centre = "A", radius = 30 }, { centre = "B", radius = 10 }]
[[slide]]
name = "f"
block = "2"
point = "B"
guide = "frame"
through = "O"
tilt = 0
[[slide]]
name = "roller"
pin = "C"
guide = "frame"
through = "O"
[[driver]]
vector = "OA"
angle = 30
omega = 2
alpha = 1
[sketch]
A = [17, 10]
B = [56, 0]
C = [156, 0]
"""


def test_rollers_may_turn_as_they_like() -> None:
    """Two rollers of a follower: their own turning is an idle freedom, and the second one in the guide repeats it."""
    mechanism = loads(ROLLERS)
    method = plan(mechanism)
    plot = replay_all(method)
    assert method.mechanism.idle == ("3", "4")
    assert [(each.pair, each.part) for each in method.aside] == [(("slide", 1), "whole")]
    assert compare(method, plot, motion(mechanism)) < 1e-9
    assert plot.s_rate["roller"] == pytest.approx(plot.s_rate["f"])


@pytest.mark.parametrize("quantity", ["omega 3", "alpha 4", "theta 3", "omega 3 / omega 1"])
def test_how_an_idle_roller_turns_is_no_question(quantity: str) -> None:
    with pytest.raises(TurnsAsItLikes):
        read(loads(ROLLERS), quantity)


def test_too_many_drivers_are_no_contradicting_pair() -> None:
    """A second crank's driver is too much; the rod between the two is not to blame."""
    text = TABLE.format(driver=CRANK, a=[10, 28], b=[106, 0], c=106)
    text = text[: text.index('[[slide]]\nname = "high"')] + text[text.index("[[driver]]") :]
    more = text.replace("[sketch]", '[[driver]]\nslide = "low"\nat = 110\nvelocity = 1\n[sketch]')
    with pytest.raises(TooManyDrivers):
        plan(loads(more))
