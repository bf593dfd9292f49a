"""Every printed formula is read back from the text and holds with the numbers of the analytic solution."""

from __future__ import annotations

import re
import shutil
import subprocess
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from defusedxml import ElementTree
from printed import Equation, Quantity, legend, plain, sections
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
)  # fmt: skip
from redriving import redriven
from si_values import si

import graphkin
from graphkin.equations import document, write_html, write_tex, write_text
from graphkin.equations.formulas import symbol_text
from graphkin.equations.legend import values
from graphkin.equations.model import model_of
from graphkin.equations.written import written
from graphkin.errors import DeadPoint
from graphkin.files import library
from graphkin.model.mechanism import ROUNDING
from graphkin.planning.stages import Group

EPS = 1e-9
"""Relative to what the terms of a formula add up to."""


def positions(mechanism):
    """The drawn position, and two others near it."""
    yield graphkin.motion(mechanism), None
    start = np.array([driver.value for driver in graphkin.plan(mechanism).drivers])
    moves = [[(0.07 if d.kind != "slide" else 0.02 * abs(v) or 1e-4) * k for k in (1, -1)]
             for d, v in zip(mechanism.drivers, start)]  # fmt: skip
    for k in range(2 if len(start) else 0):
        moved = graphkin.motion(mechanism, si(mechanism, [[value + move[k]] for value, move in zip(start, moves)]))
        if np.isfinite(moved.condition[0]) and np.all(np.isfinite([*moved.omega.values()])):
            yield moved, 0


def names_at(model, motion, k) -> dict[str, Quantity]:
    """Values by printed name; a component may be off by what is nothing beside the vectors of its unit."""
    found, most = {}, dict[str, float]()
    for symbol, value in values(model.legend, motion).items():
        found[symbol] = Quantity.of(value if k is None or np.ndim(value) == 0 else value[k])
        unit = model.legend.entries[symbol].unit
        most[unit] = max(most.get(unit, 0.0), float(found[symbol].error))
    for symbol, quantity in found.items():
        if symbol.letter in ("x", "y", "v", "a"):
            quantity.error = np.asarray(most[model.legend.entries[symbol].unit])
    return {plain(symbol_text(symbol)): quantity for symbol, quantity in found.items()}


def is_definition(equation: Equation, names) -> bool:
    """A letter that the legend has not, alone on the left."""
    return equation.sides[0] not in names and re.fullmatch(r"[^\W\d][\w']*", equation.sides[0]) is not None


def rounded(equation: Equation, k: int, names) -> bool:
    """A side of bare numbers: printed to six digits, and 0 for what is nothing beside the machine's largest number."""
    return bool(equation.matrices) and not equation.side(k, names)[1] and "⟦" in equation.sides[k]


def hold(equation: Equation, names, drawn: bool) -> int:
    """All sides are equal; how many were compared."""
    first, _ = equation.side(0, names)
    count = 0
    for k in range(1, len(equation.sides)):
        other, _ = equation.side(k, names)
        gap = np.abs(first.value - other.value)
        if "atan2" in equation.sides[k] or re.fullmatch(r"θ[\w']*", equation.sides[0]):
            gap = np.abs(np.angle(np.exp(1j * gap)))
        if rounded(equation, k, names):
            if drawn:
                nothing = ROUNDING * max(float(np.max(quantity.error)) for quantity in names.values())
                assert np.all(gap <= 5.1e-6 * np.abs(first.value) + nothing + EPS * first.error), equation
                count += 1
            continue
        assert np.all(np.isfinite(gap)), equation
        assert np.all(gap <= EPS * (first.error + other.error)), (equation, first.value, other.value)
        count += 1
    return count


def check(model, text: str, mechanism, moved=None) -> int:
    """`moved`: the mechanism's positions where they are known already."""
    count = 0
    found = sections(text)
    for motion, k in moved or positions(mechanism):
        count += evaluated(found, names_at(model, motion, k), k is None)
    return count


def check_printed(text: str) -> int:
    """With the figures that are printed beside the letters, each formula gives the figure printed of its other side."""
    return evaluated(sections(text), legend(text, EPS), True)


def evaluated(found, names, drawn: bool) -> int:
    count = 0
    for section in found:
        known = dict(names)
        for equation in section.equations:
            if is_definition(equation, known):
                known[equation.sides[0]] = equation.side(1, known)[0]
        count += sum(hold(equation, known, drawn) for equation in section.equations)
    return count


def written_for(mechanism, by, lang="en"):
    model = model_of(graphkin.plan(mechanism))
    return model, write_text(written(model, by, lang))


@pytest.mark.many(6)
@pytest.mark.parametrize("name", library.names())
def test_printed_formulas_hold(name: str):
    """By either method, in either language."""
    mechanism = graphkin.load(name)
    hold_in_all(mechanism, graphkin.plan(mechanism), ("en", "zh"))


def hold_in_all(mechanism, method, languages):
    """Positions are solved once for both methods; in every language the same formulas and figures are printed."""
    moved = [*positions(mechanism)]
    for by in ("complex", "matrix"):
        model = model_of(method)
        text = write_text(written(model, by, languages[0]))
        assert check(model, text, mechanism, moved) >= 3 * len(model.unknowns), by
        assert check_printed(text) >= len(model.unknowns), by
        for lang in languages[1:]:
            assert formulas(write_text(written(model_of(method), by, lang))) == formulas(text), (by, lang)


def formulas(text: str) -> tuple[list[list[Equation]], dict[str, complex]]:
    """All that is printed but words."""
    figures = {name: complex(quantity.value) for name, quantity in legend(text, EPS).items()}
    return [section.equations for section in sections(text)], figures


KINDS = {make.__name__: make for make in (cylinder, relative_angle, coupler_angle, chain, triad, six_bar,
                                          geared_five_bar, epicyclic, rolling, cam, circular_slot)}  # fmt: skip


@pytest.mark.many(6)
@pytest.mark.parametrize(("kind", "seed"), [(kind, seed) for kind in (*DYADS, *KINDS) for seed in range(4)])
def test_printed_formulas_hold_for_random_mechanisms(kind: str, seed: int):
    mechanism = dyad(kind, seed) if kind in DYADS else KINDS[kind](seed)
    try:
        method = graphkin.plan(mechanism)
        model_of(method)
    except DeadPoint as error:
        assert error.angle_deg < 0.5
        return
    hold_in_all(mechanism, method, ("en",))


@pytest.mark.parametrize("seed", range(40))
def test_printed_formulas_hold_where_links_are_closed_in_themselves(seed: int):
    """Such links give their angles to one another before any of them has a place."""
    if (found := redriven("cylinder", "link", seed)) is None:
        return
    method = graphkin.plan(found[0])
    if any(stage.floating for stage in method.stages if isinstance(stage, Group)):
        hold_in_all(found[0], method, ("en",))


ARM = """
ask = ["v E", "a E"]
[frame]
A = [0, 0]
[links.1]
AB = 30
[links.2]
BC = 25
[links.3]
shape = { C = [0, 0], D = [20, 0], E = [25, 8] }
[[driver]]
vector = "AB"
angle = 20
omega = 2
alpha = 3
[[driver]]
vector = "BC"
from = "AB"
angle = 30
omega = -3
[[driver]]
vector = "CD"
from = "CB"
angle = 130
omega = 4
alpha = -1
"""


def test_a_point_of_an_arm_moves_as_each_link_turns():
    """However many drivers stand behind a link's own ω."""
    mechanism = graphkin.loads(ARM)
    hold_in_all(mechanism, graphkin.plan(mechanism), ("en",))
    _, text = written_for(mechanism, "complex")
    point = [line for line in text.splitlines() if line.strip().startswith(("v_E =", "a_E ="))]
    assert len(point) == 2
    assert "l2 ω2 sin θ2" in point[0]
    assert not any("ω1 ω2" in line or "ω21" in line or "θ21" in line for line in point)


FORMS = {
    ("ex3-5", "complex"): (
        "l1 e^(i θ1) + l2 e^(i θ2) = l4 + l3 e^(i θ3)",  # (3-8)
        "l1 sin θ1 + l2 sin θ2 = l3 sin θ3",  # (3-9)
        "A sin θ3 + B cos θ3 + C = 0",  # (3-10)
        "A = 2 l1 l3 sin θ1",
        "B = 2 l3 (l1 cos θ1 − l4)",
        "tan(θ3 / 2) = (A ± √(A² + B² − C²)) / (B − C)",  # (3-11)
        "l1 ω1 e^(i θ1) + l2 ω2 e^(i θ2) = l3 ω3 e^(i θ3)",  # (3-12)
        "ω3 = l1 ω1 sin(θ1 − θ2) / (l3 sin(θ3 − θ2))",  # (3-13)
        "ω2 = −l1 ω1 sin(θ1 − θ3) / (l2 sin(θ2 − θ3))",  # (3-14)
        "i l1 ω1² e^(i θ1) + l2 α2 e^(i θ2) + i l2 ω2² e^(i θ2) = l3 α3 e^(i θ3) + i l3 ω3² e^(i θ3)",  # (3-15)
        "α3 = (l1 ω1² cos(θ1 − θ2) + l2 ω2² − l3 ω3² cos(θ3 − θ2)) / (l3 sin(θ3 − θ2))",  # (3-16)
        "α2 = (l3 ω3² − l1 ω1² cos(θ1 − θ3) − l2 ω2² cos(θ2 − θ3)) / (l2 sin(θ2 − θ3))",  # (3-17)
        "l_E = l1 e^(i θ1) + a e^(i θ2) + b e^(i (θ2 + 90°))",  # (3-18)
    ),
    ("ex3-1", "complex"): (
        "θ2 = θ3 + γ",
        "l1 e^(i θ1) = l4 + l3 e^(i θ3) + s2 e^(i θ2)",
        "ω3 = l1 ω1 cos(θ1 − θ2) / (l3 cos γ + s2)",
    ),
    ("ex3-7", "matrix"): (
        "i l6 + l1 e^(i θ1) = s3 e^(i θ3)",
        "l3 e^(i θ3) + l4 e^(i θ4) = i l6' + s_E",
        "s3 sin θ3 = l6 + l1 sin θ1",
        "l3 cos θ3 + l4 cos θ4 − s_E = 0",
        "⎢ 0        −l3 sin θ3   −l4 sin θ4   −1 ⎥ ⎢ ω4  ⎥      ⎢ 0          ⎥",
        "A α = −Ȧ ω + ω1 Ḃ",
    ),
}
"""What the book prints for its own examples, with its misprints put right."""


@pytest.mark.parametrize(("name", "by"), FORMS)
def test_forms_of_the_book(name: str, by):
    lines = [re.sub(r"\s{3,}\(\d+\)$", "", line).strip() for line in written_for(graphkin.load(name), by)[1].split("\n")]
    for form in FORMS[name, by]:
        assert form in lines


@pytest.mark.parametrize(("old", "new"), [
    ("+ l2 e^(i θ2)", "− l2 e^(i θ2)"), ("B = 2 l3", "B = 3 l3"), ("± = −", "± = +"), ("sin(θ1 − θ2)", "sin(θ1 − θ3)"),
    ("l2 ω2² −", "l2 ω2 −"), ("(θ2 + 90°)", "(θ2 − 90°)"),
])  # fmt: skip
def test_a_wrong_formula_is_found(old: str, new: str):
    mechanism = graphkin.load("ex3-5")
    model, text = written_for(mechanism, "complex")
    assert old in text
    with pytest.raises(AssertionError):
        check(model, text.replace(old, new, 1), mechanism)
    with pytest.raises(AssertionError):
        check_printed(text.replace(old, new, 1))


@pytest.mark.parametrize(("name", "old", "new"), [
    ("ex3-5", "2.85294 rad/s", "2.85304 rad/s"), ("ex3-5", "60 mm", "60.01 mm"), ("ex3-5", "2.10136 i", "2.10146 i"),
])  # fmt: skip
def test_a_wrong_figure_is_found(name: str, old: str, new: str):
    _, text = written_for(graphkin.load(name), "complex")
    assert old in text
    with pytest.raises(AssertionError):
        check_printed(text.replace(old, new, 1))


UNUSUAL = """
[frame]
name = "bed"
O1 = [0, 0]

[links."2'"]
shape = { "A'" = [2, 0], O1 = [0, 0], K = [1, 0.5] }

[links.rod_1]
"A'B" = "6 in"

[links.ram]
points = ["B"]

[[slide]]
block = "ram"
point = "B"
guide = "frame"
through = [10, 5]
angle = 37

[[driver]]
vector = "O1A'"
angle = "1.2 rad"
omega = "30 rpm"
alpha = -2

[sketch]
B = [150, 110]
"""


@pytest.mark.parametrize("by", ["complex", "matrix"])
def test_unusual_names_units_and_directions(by, tmp_path: Path):
    (tmp_path / "unusual.toml").write_text(UNUSUAL, encoding="utf-8")
    mechanism = replace(graphkin.load(tmp_path / "unusual.toml"), ask=("v B", "a K"))
    model, text = written_for(mechanism, by)
    assert check(model, text, mechanism) > 30
    assert {"θ2'", "ω_rod_1", "α2'"} <= {symbol_text(symbol) for symbol in model.legend.entries}
    ElementTree.fromstring(write_html(written(model_of(graphkin.plan(mechanism)), by, "zh")).split("\n", 1)[1])


@pytest.mark.parametrize("lang", ["en", "zh"])
@pytest.mark.parametrize("by", ["complex", "matrix"])
@pytest.mark.parametrize("name", ["ex3-5", "ex3-7", "p3-22", "ex3-2", "p3-16", "p3-8"])
def test_pages_are_xml_and_stand_alone(name: str, by, lang):
    page = write_html(document(graphkin.plan(graphkin.load(name)), by, lang))
    root = ElementTree.fromstring(page.split("\n", 1)[1])
    assert root.find(".//{*}svg//{*}line[@class='vector']") is not None
    assert root.find(".//{*}math") is not None
    assert root.find(".//{*}script") is None
    links = [value for element in root.iter() for key, value in element.attrib.items() if key in ("href", "src")]
    assert links == []


LATEX = shutil.which("xelatex")
"""A LaTeX is too large to be installed for the tests; where there is one, the files are compiled."""
TEX = [("ex3-5", "complex", "en"), ("p3-22", "matrix", "en"), ("ex3-7", "matrix", "zh"), ("p3-16", "complex", "zh")]


@pytest.mark.parametrize(("name", "by", "lang"), TEX)
def test_latex_is_whole(name: str, by, lang, tmp_path: Path):
    """Braces and environments close in their order; and it compiles, where there is a LaTeX."""
    text = write_tex(document(graphkin.plan(graphkin.load(name)), by, lang))
    waiting: list[str] = []
    for kind, environment, brace in re.findall(r"\\(begin|end)\{(\w+\*?)\}|(?<!\\)([{}])", text):
        if kind == "begin" or brace == "{":
            waiting.append(environment or brace)
        else:
            assert waiting.pop() == (environment or "{")
    assert not waiting
    if LATEX is not None:
        (tmp_path / "equations.tex").write_text(text, encoding="utf-8")
        command = [LATEX, "-interaction=nonstopmode", "-halt-on-error", "equations.tex"]
        run = subprocess.run(command, cwd=tmp_path, capture_output=True, timeout=240, check=False)
        assert run.returncode == 0, run.stdout.decode("utf-8", "replace")[-2000:]


def test_a_direction_is_told_without_whole_turns():
    """Found as a difference of others, as where a link is driven against another, it may come with some."""
    model = model_of(graphkin.plan(library.load("ex3-4")))
    text = write_text(written(model, "complex", "en"))
    (told,) = re.findall(r"θ1 +direction of link 1 +(\S+)°", text)
    (value,) = [np.degrees(value) for symbol, value in model.values.items() if symbol_text(symbol) == "θ1"]
    assert float(told) == pytest.approx(value + 360, abs=1e-3)
