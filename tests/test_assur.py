"""The structure report: freedoms by formula and by rank, groups in the order they are solved."""

from __future__ import annotations

import pytest

from graphkin import api, library
from graphkin.loading import loads
from graphkin.say.structure import structure_lines

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
    return "\n".join(structure_lines(api.plan(library.load(name)), lang))


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("ex3-1", ["Class II, RPR: links 2, 3", "Mechanism of Class II", "coincident points"]),
        ("ex3-2", ["Class III: links 3, 4, 5, 6; special point S on link 4", "Mechanism of Class III"]),
        ("p3-3b", ["multiple hinge C", "Class II, RRP", "Class II, RRR: links 6, 7"]),
        ("p3-14", ["F = 3 × 6 − 2 × 8 − 0 = 2"]),
        ("p3-8", ["cam pair: 1, 2", "lower-pair equivalent", "F = 3 × 2 − 2 × 2 − 1 = 1"]),
        ("s4-ex4", ["gear pair: 1, 2", "rolling contact"]),
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
    text = "\n".join(structure_lines(method, "en"))
    assert "F = 3 × 4 − 2 × 6 − 0 = 0" in text
    assert "by rank: 1" in text
    assert "redundant constraints: 1" in text
    assert "repeats a constraint: link 4" in text


def test_chinese():
    assert "Ⅲ级机构" in report("p3-15", "zh")
