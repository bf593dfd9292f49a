"""Cams of every two profiles, moving and fixed, inside and outside: solved by both roads, told, handed out, drawn by steps."""

from __future__ import annotations

import pytest
from calculator import hold

from graphkin import loads
from graphkin.api import Drawing
from graphkin.errors import Lang
from graphkin.handouts import handout
from graphkin.say import Calculation, Sentence, derivation

LANGS: tuple[Lang, ...] = ("en", "zh")
SCALES = {"length": 0.001, "velocity": 0.002, "acceleration": 0.01}
CRANK = """
[frame]
O = [0, 0]
D = [110, 0]
[links.1]
OA = 30
[[driver]]
vector = "OA"
angle = 50
omega = 4
alpha = 3
"""
BODIES = {
    "turning": '[links.2]\nDE = 90\n',
    "sliding": '[links.2]\npoints = ["E"]\n[[slide]]\nblock = "2"\npoint = "E"\nguide = "frame"\nthrough = [0, 0]\nangle = 90\n',
    "coupler": '[links.2]\nAB = 60\n',
    "plate": '[links.2]\nEF = 90\n[[slide]]\nblock = "2"\npoint = "E"\nguide = "frame"\nthrough = [0, 0]\nangle = 90\ntilt = -80\n',
}
"""The link that touches another beside the crank."""


def disc(centre: str, radius: float) -> str:
    return f'{{ centre = "{centre}", radius = {radius} }}'


def face(through: str, rest: str) -> str:
    return f'{{ through = {through}, {rest} }}'


CASES = {
    "on a bar": ("turning", ("1", "2"), "A", face('"D"', 'toward = "E"'), "E = [70, 75]"),
    "beside a bar": ("turning", ("1", "2"), "A", face('"E"', 'from = "DE", angle = 20'), "E = [70, 75]"),
    "of a block": ("sliding", ("1", "2"), "A", face('"E"', "angle = 15"), "E = [0, 40]"),
    "of a plate": ("plate", ("1", "2"), "A", face('"E"', 'toward = "F"'), "E = [0, 40]\nF = [90, 50]"),
    "on the crank": ("turning", ("2", "1"), "E", face('"O"', 'toward = "A"'), "E = [40, 45]"),
    "of the frame": ("coupler", ("2", "frame"), "B", face("[0, -10]", "angle = 5"), "B = [70, -10]"),
    "through a pivot of the frame": ("coupler", ("2", "frame"), "B", face('"O"', 'toward = "D"'), "B = [70, 5]"),
    "round": ("turning", ("1", "2"), "A", disc("E", 25), "E = [40, 50]"),
    "an edge": ("turning", ("1", "2"), "A", disc("E", 0), "E = [30, 45]"),
    "round the crank": ("turning", ("1", "2"), "A", disc("E", 45), "E = [40, 50]"),
    "a groove of the frame": ("coupler", ("2", "frame"), "B", disc("D", 70), "B = [70, 20]"),
}
"""The bodies, the links that touch, the centre of the first, what it touches, and roughly where that stands."""


def machine(case: str, radius: float, internal: bool) -> str:
    body, links, centre, other, sketch = CASES[case]
    more = "internal = true\n" if internal else ""
    cam = f'[[cam]]\nlinks = ["{links[0]}", "{links[1]}"]\nprofiles = [{disc(centre, radius)}, {other}]\n{more}'
    return f"{CRANK}{BODIES[body]}{cam}[sketch]\n{sketch}\n"


ALL = [
    (case, radius, internal)
    for case, (_, _, _, other, _) in CASES.items()
    for radius in (0, 12)
    for internal in (False, True)
    if not (internal and "radius" not in other) and not (case == "an edge" and (internal or not radius))
]


@pytest.mark.many
@pytest.mark.parametrize(("case", "radius", "internal"), ALL)
def test_any_two_profiles(case: str, radius: float, internal: bool) -> None:
    drawing = Drawing.of(loads(machine(case, radius, internal)))
    kinds = []
    for lang in LANGS:
        entries = list(derivation(drawing.method, drawing.plot, SCALES, lang, everything=True))
        kinds.append([type(entry) for entry in entries])
        assert hold([entry.text for entry in entries if isinstance(entry, Sentence | Calculation)]) > 5
    assert kinds[0] == kinds[1]
    if radius or internal:
        assert len(list(drawing.step_sheets(lang=LANGS[radius > 0]))) > 3
    else:
        assert handout([drawing.mechanism], "solution", "zh").blocks
