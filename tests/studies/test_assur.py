"""The structure report: freedoms by formula and by rank, groups in the order they are solved."""

from __future__ import annotations

import pytest

from graphkin import api
from graphkin.files import library, loads
from graphkin.planning import plan
from graphkin.say.structure import structure_lines
from graphkin.studies.assur import structure

THREE_CRANKS = """
[frame]
A = [0, 0]
D = [60, 0]
G = [30, 0]
[links.1]
AB = 40
[links.2]
shape = { B = [0, 0], C = [60, 0], F = [30, 0] }
[links.3]
DC = 40
[links.4]
GF = 40
[[driver]]
vector = "AB"
angle = 70
omega = 2
[sketch]
C = [74, 38]
"""


def report(name: str, lang: str = "en") -> str:
    return "\n".join(structure_lines(structure(api.plan(library.load(name))), lang))


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("ex3-1", ["Class II, RPR: links 2, 3", "Mechanism of Class II", "coincident points"]),
        ("ex3-2", ["Class III: links 3, 4, 5, 6; special point S on link 4", "Mechanism of Class III"]),
        ("p3-3b", ["multiple hinge C", "Class II, RRP", "Class II, RRR: links 6, 7"]),
        ("p3-14", ["p_h = 3 × 6 − 2 × 8 − 0 = 2"]),
        ("p3-8", ["cam pair: links 1, 2", "lower-pair equivalent", "p_h = 3 × 2 − 2 × 2 − 1 = 1"]),
        ("s4-ex4", ["gear pair: links 1, 2", "rolling contact"]),
        ("ex3-7", ["Class II, RPR: links 2, 3", "Class II, RRP: links 4, 5"]),
    ],
)
def test_reports(name: str, said: list[str]):
    for words in said:
        assert words in report(name)


@pytest.mark.parametrize("name", library.names())
def test_formula_and_rank_agree(name: str):
    lines = report(name).splitlines()
    formula = next(line for line in lines if "by the formula" in line).rpartition("=")[2]
    rank = next(line for line in lines if "by rank" in line).rpartition(":")[2]
    assert int(formula) == int(rank) == len(library.load(name).drivers)


def test_a_redundant_crank_is_named():
    method = api.plan(loads(THREE_CRANKS, name="cranks"))
    text = "\n".join(structure_lines(structure(method), "en"))
    assert "p_h = 3 × 4 − 2 × 6 − 0 = 0" in text
    assert "by rank: 1" in text
    assert "redundant constraints: 1" in text
    assert "repeats a constraint: link 4" in text


def test_chinese():
    assert "Ⅲ级机构" in report("p3-15", "zh")


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
side = "left"
[[slide]]
name = "rack"
block = "2"
point = "C"
guide = "frame"
through = [0, -40]
angle = 0
tilt = 0
[[pose]]
slide = "rack"
at = -50
[[driver]]
vector = "AB"
angle = 30
omega = 5
[sketch]
C = [-50, -40]
Q = [50, -40]
"""


def test_rolling_takes_one_freedom_where_other_pairs_keep_the_distance():
    held, rolling = structure(plan(loads(RACK))), structure(plan(library.load("p3-16")))
    assert (held.formula, held.repeated, [taken for _, taken in held.rolls]) == (1, 0, [1])
    assert (rolling.formula, rolling.repeated, [taken for _, taken in rolling.rolls]) == (1, 0, [2])


PLANET = """
frame = { O = [0, 0] }
links = { 1.OA = 90, 2.AB = 25 }
roll = [{ wheel = "2", centre = "A", radius = 30, on = "frame", on_centre = "O", on_radius = 60 }]
driver = [{ vector = "OA", angle = 160, omega = -3 }]
pose = [{ vector = "AB", angle = 100 }]
"""


def test_the_arm_of_a_wheel_that_rolls_on_a_circle_repeats_nothing():
    planet = structure(plan(loads(PLANET)))
    assert (planet.formula, planet.repeated, planet.rolls[0][1]) == (1, 0, 1)


@pytest.mark.parametrize(("name", "said"), [
    ("p3-8", "RPR: links 2 and the block that replaces cam pair 1–2"),
    ("s3-cam", "PRR: links 2 and the link that replaces cam pair 1–2"),
    ("p3-17", "Class III: links 4, 3, 5, 1+2 (+: one link"),
    ("ex3-4", "RRR: links 1+2, 3 (+: one link"),
])  # fmt: skip
def test_a_group_has_as_many_links_as_its_class_wants(name: str, said: str):
    assert any(said in line for line in structure_lines(structure(plan(library.load(name))), "en"))


@pytest.mark.parametrize("name", library.names())
def test_groups_have_no_freedom_of_their_own(name: str):
    """Two links in a dyad, four in a triad: 3 n = 2 p."""
    for group in structure(plan(library.load(name))).groups:
        links = len(group.links) + len(group.added) - len(group.merged)
        assert group.kind not in ("dyad", "triad") or links == (2 if group.kind == "dyad" else 4), group
