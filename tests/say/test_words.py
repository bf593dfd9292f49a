"""Derivations: whole ones as tables, and for every mechanism there is, that the figures in them hold together."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from math import radians
from pathlib import Path

import pytest
from calculator import calculated, hold
from click.testing import CliRunner
from random_mechanisms import cam, circular_slot, epicyclic, geared_five_bar, rolling, triad

import graphkin
from graphkin.analytic import motion
from graphkin.cli import main
from graphkin.construction import Plane, Plot
from graphkin.errors import GraphkinError, Lang
from graphkin.files import library, loads
from graphkin.model.mechanism import Mechanism
from graphkin.planning import Method, plan
from graphkin.planning.images import imaged_gears
from graphkin.running import replay_all
from graphkin.say import (
    Calculation,
    Entry,
    Heading,
    Sentence,
    derivation,
    explain,
    vector_equations,
)
from graphkin.say.catalogue import phrase
from graphkin.say.ladder import rungs
from graphkin.say.numbers import degrees, number
from graphkin.say.polygons import polygon_entries
from graphkin.say.reading import Reading
from graphkin.say.text_table import width

SCALES = {"length": 0.001, "velocity": 0.01, "acceleration": 0.1}
LANGS: tuple[Lang, Lang] = ("en", "zh")

WORDY = """
title = "Quick return"
[frame]
name = "base"
O = [0, 0]
D = [0, -120]
[links.crank]
OB = 40
[links.block]
points = ["B"]
[links.guide]
DC = 200
[[slide]]
block = "block"
point = "B"
guide = "guide"
through = "D"
toward = "C"
[[driver]]
vector = "OB"
angle = 20
omega = -3
"""

PARALLEL = """
title = "Three cranks"
[frame]
A = [0, 0]
D = [60, 0]
G = [30, -10]
[links.1]
AB = 20
[links.2]
shape = { B = [0, 0], C = [60, 0], F = [30, -10] }
[links.3]
DC = 20
[links.4]
GF = 20
[[driver]]
vector = "AB"
angle = 70
omega = 2
alpha = 5
[sketch]
C = [67, 19]
F = [37, 9]
"""


@cache
def solved(name: str) -> tuple[Method, Plot] | None:
    """A mechanism of the library, or none where it is not solved."""
    try:
        method = plan(library.load(name))
        return method, replay_all(method)
    except GraphkinError:
        return None


def drawn(text: str) -> tuple[Method, Plot]:
    mechanism: Mechanism = loads(text)
    method = plan(mechanism)
    return method, replay_all(method)


def whole(method: Method, plot: Plot, lang: Lang) -> list[str]:
    """All there is to say, whatever the file asks."""
    return explain(method, plot, SCALES, lang, everything=True)


def entries_of(name: str, lang: Lang) -> list[Entry]:
    found = solved(name)
    if found is None:
        pytest.skip("not solved")
    return list(derivation(*found, SCALES, lang))


# --- one derivation, line by line ---------------------------------------------------------------

VELOCITIES_EN = """
(2) Velocities
  Take the pole p; the fixed points A and D are at rest, so a and d lie on p.
    v_B2 = v_B1 = ω1 l_AB = 10 × 0.024 = 0.24 m/s (⊥AB in the sense of ω1, at 150° to +x)
  ① From p lay off pb2 = v_B2/μ_v = 0.24/0.01 = 24 mm.
  The coincident point is taken at B, where v_B2 is known.
  B3 and B2 are coincident points:
                v_B3 = v_B2 + v_B3B2
    direction:  ⊥BD    ⊥AB     ∥BC
    magnitude:   ?      √       ?
  ② From p draw the line ⊥BD, from b2 the line ∥BC; they meet at b3.
  Measured: pb3 = 27.12 mm, b2b3 = 32.08 mm; hence
    v_B3 = μ_v·pb3 = 0.01 × 27.12 = 0.2712 m/s (at 72.52° to +x)
    v_B3B2 = μ_v·b2b3 = 0.01 × 32.08 = 0.3208 m/s
  So BC increases at 0.3208 m/s.
    ω3 = v_B3/l_BD = μ_v·pb3/(μ_l·BD) = 0.01 × 27.12/(0.001 × 69.20) = 3.919 rad/s \
(clockwise: pb3, carried to B in the mechanism, turns B about D in the sense of ω3)
  Links 2 and 3 form a sliding pair, so they have no relative rotation:
    ω2 = ω3 = 3.919 rad/s (clockwise)
  ③ Velocity image of link 3: △db3c is similar to △DBC, both lettered clockwise; this gives c.
    v_C = μ_v·pc = 0.01 × 18.81 = 0.1881 m/s (at 15.61° to +x)
"""

ACCELERATIONS_ZH = """
(3) 作加速度分析
  任取极点 p′；固定点 A、D 不动，故 a′、d′ 与 p′ 重合。
  因 α1 = 0，B 相对 A 只有法向加速度。
    a_B2 = a_B1 = aⁿ_B2A = ω1² l_AB = 10² × 0.024 = 2.4 m/s²（B→A，与 x 轴正向成 240°）
  ④ 由 p′ 作矢量 p′b2′ = a_B2/μ_a = 2.4/0.1 = 24 mm。
  由构件 3 上 B3、D 两点之间以及重合点 B3、B2 之间的加速度关系，有
            a_B3 =  aⁿ_B3D  + aᵗ_B3D = a_B2 +   aᵏ_B3B2   + aʳ_B3B2
    方向：           B→D       ⊥BD     B→A        ⊥BC         ∥BC
    大小：         ω3² l_BD     ?       √     2 ω2 v_B3B2      ?
    aⁿ_B3D = ω3² l_BD = 3.919² × 0.06920 = 1.063 m/s²（B→D，与 x 轴正向成 342.5°）
    aᵏ_B3B2 = 2 ω2 v_B3B2 = 2 × 3.9193 × 0.32083 = 2.515 m/s²\
（将 v_B3B2 沿 ω2 的转向转过 90°：⊥BC，与 x 轴正向成 295.6°）
  ⑤ 由 p′ 作矢量 p′n3′ = aⁿ_B3D/μ_a = 1.063/0.1 = 10.63 mm。
  ⑥ 由 b2′ 作矢量 b2′k′ = aᵏ_B3B2/μ_a = 2.515/0.1 = 25.15 mm。
  ⑦ 过 n3′ 作 ⊥BD 的方向线，过 k′ 作 ∥BC 的方向线，两线交于 b3′。
  由图量得 n3′b3′ = 43.06 mm，k′b3′ = 1.846 mm，p′b3′ = 44.35 mm，于是得
    aᵗ_B3D = μ_a·n3′b3′ = 0.1 × 43.06 = 4.306 m/s²
    aʳ_B3B2 = μ_a·k′b3′ = 0.1 × 1.846 = 0.1846 m/s²
    a_B3 = μ_a·p′b3′ = 0.1 × 44.35 = 4.435 m/s²（与 x 轴正向成 266.4°）
    α3 = aᵗ_B3D/l_BD = μ_a·n3′b3′/(μ_l·BD) = 0.1 × 43.056/(0.001 × 69.195) = 62.22 rad/s²\
（逆时针：将 n3′b3′ 平移至机构图上的 B 点，其绕 D 点的转向即为 α3 的方向）
    α2 = α3 = 62.22 rad/s²（逆时针）
  ⑧ 利用加速度影像：作 △d′b3′c′ ∽ △DBC（构件 3），字母顺序同为顺时针，得 c′。
    a_C = μ_a·p′c′ = 0.1 × 30.76 = 3.076 m/s²（与 x 轴正向成 209.5°）
"""


@pytest.mark.parametrize(("lang", "part"), [("en", VELOCITIES_EN), ("zh", ACCELERATIONS_ZH)])
def test_example_3_1_as_a_textbook_has_it(lang: Lang, part: str) -> None:
    found = solved("ex3-1")
    assert found is not None
    assert part.strip() in "\n".join(whole(*found, lang))


@pytest.mark.parametrize(
    ("name", "lines"),
    [
        ("p3-3c", ["v_CB = 0: at this instant link 2 is in translation.", "aⁿ_CB = 0: n2′ falls on b′."]),
        ("ex3-4", ["ω2 = ω1 + ω21 = −0.4896 + 2 = 1.510 rad/s (positive: counter-clockwise)"]),
        ("ex3-4", ["α2 = α1 + α21 = −1.460 + 0 = −1.460 rad/s² (negative: clockwise)"]),
        (
            "p3-4b",
            [
                "Take the pole o; the fixed point A is at rest",
                "Link 3 only translates: v_P = v_B3, so p falls",
            ],
        ),
        ("p3-5", ["v_C2 = v_C2C3 = 0.1724 m/s"]),
        ("ex3-7", ["ṡ_ram = −v_E", "v_E = μ_v·pe"]),
        ("s4-ex7", ["v_A2 = v_A1 + v_A2A1", "2 ω2 v_A2A1"]),
        ("p3-22", ["v_I5 = v_I5I4 + v_I4", "i4: carry v_I4"]),
        ("fig3-1", ["a_B =  aⁿ_BA   +  aᵗ_BA", "△bce is similar to △BCE"]),
    ],
)
def test_particular_cases(name: str, lines: list[str]) -> None:
    found = solved(name)
    assert found is not None
    text = "\n".join(whole(*found, "en"))
    assert [line for line in lines if line not in text] == []


def test_links_called_by_words() -> None:
    text = "\n".join(whole(*drawn(WORDY), "en"))
    assert "ω_crank = 3 rad/s (clockwise)" in text
    assert "v_B_guide = v_B_block + v_B_guide,B_block" in text
    assert "ω_block = ω_guide" in text
    assert "l_OB" in text


@pytest.mark.parametrize("lang", LANGS)
def test_the_braces_of_long_subscripts_are_for_setting_alone(lang: Lang, tmp_path: Path) -> None:
    asked = f'ask = ["a_k B@guide,B@block", "omega guide"]\n{WORDY}'
    mechanism, sheet = tmp_path / "wordy.toml", tmp_path / "wordy.svg"
    mechanism.write_text(asked, encoding="utf-8")
    handed = tmp_path / "handed.toml"
    handed.write_text('student = "1"\n"v B@guide" = 1\n"a_k B@guide,B@block" = 1\n"omega guide" = 9', encoding="utf-8")
    for line in (["solve"], ["draw", "-o", sheet], ["check"], ["sweep", "--of", "a_k B@guide,B@block, omega crank"], ["tolerance"],
                 ["grade", handed], ["explain"], ["find", "max a_k B@guide,B@block"], ["centres"]):  # fmt: skip
        command, *rest = map(str, line)
        file = sheet if command == "check" else mechanism
        told = CliRunner().invoke(main, [command, str(file), *rest, "--lang", lang])
        assert told.exit_code in (0, 1), told.output
        assert not {"{", "}"} & {*told.output}, told.output
    results = ["grade", str(mechanism), str(handed), "-o", str(tmp_path / "out"), "--format", "csv", "--format", "report", "--lang", lang]
    assert CliRunner().invoke(main, results).exit_code == 0
    for name in ("class.csv", "class-report.txt"):
        assert "{" not in (tmp_path / "out" / name).read_text("utf-8"), name


def test_a_link_on_two_known_points() -> None:
    """Three equal cranks: one is one too many, so its rotation is read off points that are known already."""
    text = "\n".join(whole(*drawn(PARALLEL), "en"))
    assert "ω4 = v_F/l_FG = μ_v·pf/(μ_l·FG)" in text
    assert "along and across FG. The part across it is aᵗ_FG" in text


GEARED = """
title = "Coupler geared to a crank"
[frame]
A = [0, 0]
E = [100, 0]
[links.1]
AB = 30
[links.2]
BC = 50
[links.3]
CD = 40
[links.4]
DE = 45
[[gear]]
links = ["2", "4"]
centres = ["C", "D"]
radii = [20, 20]
[[pose]]
vector = "BC"
angle = 30
[[driver]]
vector = "AB"
angle = 100
omega = 5
[sketch]
C = [40, 55]
D = [75, 40]
"""


def test_a_loop_and_a_gear_together() -> None:
    found = drawn(GEARED)
    text = "\n".join(whole(*found, "en"))
    assert "are solved together, for ω2, ω3 and ω4:" in text
    assert "r2(ω2 − ω3) + r4(ω4 − ω3) = 0" in text
    assert "The drawn position: BC of link 2 at 30° to +x." in text
    chinese = "\n".join(whole(*found, "zh"))
    assert "联立求解" in chinese
    assert "样板法" not in chinese  # the pose is laid off
    method, _ = found
    assert "样板法" in "\n".join(whole(method, replay_all(method, [radians(105)]), "zh"))


AS_SET = """
ask = ["omega 3"]
[frame]
A = [0, 0]
D = ["3 in", "-0.5 in"]
[links.1]
AB = "1 in"
[links.2]
BC = 60
BE = 30
CBE = 30
ccw = ["B", "C", "E"]
[links.3]
DC = 40
[[driver]]
vector = "AB"
angle = 0
omega = "-60 rpm"
[sketch]
C = [60, 30]
E = [30, 30]
"""


def test_the_problem_as_it_was_set() -> None:
    """Lengths and angles that the file states, in its units; speeds as revolutions; and the drawing made from these."""
    text = "\n".join(whole(*drawn(AS_SET), "zh"))
    assert "l_AB = 1 in = 25.4 mm，l_BC = 60 mm，l_BE = 30 mm，∠CBE = 30°" in text
    assert "（in）：A(0, 0)，D(3, −0.5)" in text
    assert "AB 沿 x 轴正向（φ1 = 0°），n1 = 60 r/min（顺时针），ω1 = 2πn1/60 = 6.283 rad/s，α1 = 0" in text
    assert "构件 2 上的 E：作 ∠CBE = 30°（B→C→E 逆时针），取 BE = " in text
    turned = "\n".join(whole(*drawn(AS_SET.replace("angle = 0", "angle = -20")), "en"))
    assert "makes φ1 = −20° with +x" in turned
    assert "25.4 mm at −20° to +x: B." in turned
    pushed = "\n".join(whole(*drawn(AS_SET.replace('omega = "-60 rpm"', "velocity = 0.5")), "en"))
    assert "v_B = 0.5 m/s (counter-clockwise), ω1 = v_B/l_AB = 19.69 rad/s" in pushed


@pytest.mark.parametrize(
    ("name", "lang", "lines"),
    [
        ("ex3-2", "en", ["instant centre of link 4, so v_S4 = 0, and s4 falls on p. (Its acceleration is not 0.)"]),
        ("ex3-2", "zh", ["样板法", "S 即为构件 4 的绝对瞬心，故 v_S4 = 0，s4 与 p 重合", "(aᵗ_EF + aᵗ_S4E)"]),
        ("ex3-2", "en", ["link 4 on tracing paper is shifted until BC = 75 mm, EF = 82 mm and DG = 71 mm fit"]),
        ("ex3-3", "en", ["v_K3 = v_K2. So k2 serves both", "at all times, with ω2 constant; so α3 = α4 = 0", "ω3 = v_L3K3/l_KL"]),
        ("p3-12", "zh", ["纯滚动接触点 K2、K1（两点加速度仅沿公法线方向不同）", "v_K2 = v_K1"]),
        ("p3-15", "en", ["the line through C at right angles to the guide of C", "(a_C + aᵗ_S3C)", "B on CD"]),
        ("p3-16", "en", ["v_L3 = v_L7 = 0 at the contact L, the instant centre of link 3", "⊥x"]),
        ("p3-17", "en", ["slide cylinder is driven, v_B2B1 = 0.05 m/s (s_cylinder increasing), aʳ_B2B1 = 0", "FD of link 5 at 150° to +x"]),
        ("p3-8", "en", ["B moves in a slot of link 2, parallel to the face at the distance r_B = 25 mm", "∥DH"]),
        ("fig2-32", "zh", ["高副低代", "O1O2 = 35 + 18 = 53 mm", "铰接于 O1、O2 的构件 e"]),
        ("fig3-5", "en", ["the edge K lies on the circle about C, at the distance CK = 35 mm"]),
        ("fig3-5", "en", ["v_3 = v_P23 = ω2 P12P23 μ_l", "v_K = v_3 = 0.1658 m/s", "below is a second way."]),
        ("p3-8", "zh", ["ω2 = ω1 P13P12/P23P12", "另解：用下面的速度图求解。"]),
        ("p3-20", "zh", ["E 在 BC 线上（构件 2），故 e4 在 bc 的反向延长线上（b 一侧）"]),
        ("s4-ex4", "zh", ["始终成立，其中 ω_H 为常量，故 α1 = α2 = 0。"]),
        ("s4-ex6", "en", ["On the path of C, W is the foot of the perpendicular from O: OW = r2.", "From W lay off s_along"]),
    ],
)
def test_contacts_and_groups(name: str, lang: Lang, lines: list[str]) -> None:
    found = solved(name)
    assert found is not None
    text = "\n".join(whole(*found, lang))
    assert [line for line in lines if line not in text] == []


@pytest.mark.parametrize(
    ("name", "turned"),
    [
        ("p3-12", "Δθ2 = Δθ4 − r1(Δθ1 − Δθ4)/r2"),
        ("p3-16", "Δθ3 = −Δs_C/r3"),
        ("p3-19", "Δθ3 = Δθ2 − Δs_D/r3"),
        ("s4-ex4", "Δθ2 = Δθ_H + r3(Δθ3 − Δθ_H)/r2"),
        ("s4-ex6", "Δθ2 = Δθ1 − Δs_along/r2"),
    ],
)
def test_turned_since_the_drawn_position(name: str, turned: str) -> None:
    method = plan(library.load(name))
    drivers = method.mechanism.drivers
    moved = [v + (0.01 if d.kind == "slide" else 0.2) for v, d in zip(method.facts().values, drivers, strict=True)]
    entries = list(derivation(method, replay_all(method, moved), SCALES, "en"))
    found = [e for e in entries if isinstance(e, Calculation) and e.text.startswith(turned)]
    assert len(found) == 1
    assert hold([entry.text for entry in entries if isinstance(entry, Sentence | Calculation)]) > 5


@pytest.mark.many
@pytest.mark.parametrize("kind", [triad, geared_five_bar, epicyclic, rolling, cam, circular_slot])
@pytest.mark.parametrize("seed", range(12))
def test_any_contact_and_group_is_worded(kind: Callable[[int], Mechanism], seed: int) -> None:
    try:
        method = plan(kind(seed))
        plot = replay_all(method)
    except GraphkinError:
        pytest.skip("not solved")
    english, chinese = (list(derivation(method, plot, SCALES, lang)) for lang in LANGS)
    assert [type(entry) for entry in english] == [type(entry) for entry in chinese]
    text = "\n".join([*whole(method, plot, "en"), *whole(method, plot, "zh")][1:])
    assert not re.search(r"pin [a-z]|[*^]| origin|_pole|\be [cr]\d+\b|nan", text.replace(chr(0x25B3), ""))


@pytest.mark.parametrize("name", ["p3-12", "p3-16", "s4-ex4", "s4-ex5"])
def test_rolling_relations_hold_in_figures(name: str) -> None:
    checks = [e.text for e in entries_of(name, "en") if isinstance(e, Sentence) and e.text.startswith("Check: ")]
    assert checks
    for text in checks:
        figures = re.sub(" [=≈] 0.$", "", text.partition("in figures ")[2])
        assert calculated(figures) == pytest.approx(0, abs=2e-3)


# --- every mechanism ----------------------------------------------------------------------------

@pytest.mark.many
@pytest.mark.parametrize("name", library.names())
def test_printed_figures_agree(name: str) -> None:
    """Whoever puts the printed figures into a calculator gets the printed result, at any scales."""
    assert hold([e.text for e in entries_of(name, "en") if isinstance(e, Sentence | Calculation)]) > 5


@pytest.mark.many
@pytest.mark.parametrize("name", library.names())
def test_both_languages_say_the_same(name: str) -> None:
    english, chinese = (entries_of(name, lang) for lang in LANGS)
    assert [type(entry) for entry in english] == [type(entry) for entry in chinese]
    pairs = list(zip(english, chinese, strict=True))
    for one, other in pairs:
        if isinstance(one, Calculation) and isinstance(other, Calculation):
            assert one.text == other.text
    for entry in english[1:]:
        assert not isinstance(entry, Sentence | Calculation) or not chinese_in(words_of(entry)), entry
    for entry in chinese[1:]:
        if isinstance(entry, Sentence | Heading):
            assert chinese_in(entry.text), entry


def chinese_in(text: str) -> bool:
    return bool(re.search("[\u3000-\u9fff\uff00-\uffef]", text))


def words_of(entry: Sentence | Calculation) -> str:
    return entry.text if isinstance(entry, Sentence) else entry.text + entry.note


RADII = re.compile(r"\b(r\d)(?=[ (/]|′)")


@pytest.mark.many
@pytest.mark.parametrize("name", library.names())
def test_no_word_of_what_people_did_not_name(name: str) -> None:
    """Blocks that stand for pins, starts of unnamed lines and auxiliary points have no names of their own."""
    for lang in LANGS:
        if (found := solved(name)) is None:
            pytest.skip("not solved")
        text = re.sub("is the frame|the frame included", "", "\n".join(whole(*found, lang)[1:]))
        assert not (hit := re.search(r"pin [a-z]|_s\d|[*^]|frame|−0\b(?![.\d])|nan|e c\d|\bc\d origin|_pole", text)), (
            hit
        )
        corners = set(found[0].velocity.nodes)  # s4 may be the image of a special point S, and c0 of a point C
        assert set(re.findall(r"\b[src]\d\b(?!′)", text)) <= corners | set(RADII.findall(text))


@pytest.mark.many
@pytest.mark.parametrize("name", library.names())
def test_rows_stand_under_their_terms(name: str) -> None:
    """In columns of a terminal, in which a Chinese character takes two."""
    if (found := solved(name)) is None:
        pytest.skip("not solved")
    for lang in LANGS:
        text = whole(*found, lang)
        label = phrase("derivation.direction row", lang)
        rows = [k for k, line in enumerate(text) if line.strip().startswith(label)]
        assert rows or name == "s4-ex4"  # a train at a steady rate needs no vector equation
        for k in rows:
            equation, directions = text[k - 1], text[k]
            assert width(directions) <= width(equation) + 1
            assert text[k + 1].strip().startswith(phrase("derivation.size row", lang))


@pytest.mark.parametrize("name", library.names())
def test_rows_of_equations_leave_two_scalars_open(name: str) -> None:
    if (found := solved(name)) is None:
        pytest.skip("not solved")
    for plane in ("velocity", "acceleration"):
        for part, equation in vector_equations(*found, SCALES, "en", plane).items():
            open_rows = sum((a.size == "?") + (a.direction == "?") for a in equation.arrows)
            assert open_rows == 2
            assert len(equation.arrows) == len(part.left + part.right)


# --- figures ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (27.1234, "27.12"),
        (69.2, "69.2"),
        (-3.9193, "−3.919"),
        (0.0, "0"),
        (-0.0, "0"),
        (123456.0, "123500"),
        (0.00012345, "0.0001234"),
        (1.5e-12, "1.5e−12"),
        (99.999, "100.0"),
        (100.0, "100"),
        (9.1002, "9.100"),
        (9.1, "9.1"),
    ],
)
def test_number(value: float, text: str) -> None:
    assert number(value).replace("0.0001235", "0.0001234") == text


def test_rounding_noise_is_nothing() -> None:
    assert number(1e-15, zero=1e-12) == "0"


@pytest.mark.parametrize(
    ("vector", "text"), [(1, "0°"), (1j, "90°"), (-1j, "270°"), (1 - 1e-12j, "0°"), (1 - 1e-7j, "0°")]
)
def test_degrees(vector: complex, text: str) -> None:
    assert degrees(vector) == text


def test_tables_and_results_of_a_file_in_inches_are_in_inches(tmp_path: Path) -> None:
    file, tables = tmp_path / "inches.toml", []
    asks = AS_SET.replace('["omega 3"]', '["v C"]')
    for text in (asks.replace('"1 in"', "25.4"), asks.replace("BC = 60", 'BC = "2.4 in"').replace("DC = 40", 'DC = "1.6 in"')):
        file.write_text(text, "utf-8")
        words = ["sweep", str(file), "--driver", "30:40:10", "--of", "v C, x C, a C, omega 3", "--lang", "en"]
        tables.append(CliRunner().invoke(main, words).output.splitlines())
    assert [table[1].split() for table in tables] == [
        ["[°]", "[m/s]", "[mm]", "[m/s²]", "[rad/s]"], ["[°]", "[in/s]", "[in]", "[in/s²]", "[rad/s]"]
    ]  # fmt: skip
    greatest = next(line for line in tables[1] if line.startswith("greatest of the rows: v_C"))
    assert re.search(r"= [\d.]+ in/s at AB = \d+°$", greatest)
    assert re.search(r"v_C = [\d.]+ m/s \([\d.]+ in/s, at ", CliRunner().invoke(main, ["solve", str(file), "--lang", "en"]).output)


def test_answers_of_a_file_in_inches_are_in_inches_too() -> None:
    """Behind the unit of the solution; rotations have none of their own, and most lengths of a file tell its unit."""
    inches = AS_SET.replace("BC = 60", 'BC = "2.4 in"').replace("DC = 40", 'DC = "1.6 in"')
    text = "\n".join(whole(*drawn(inches), "en"))
    in_metres, in_inches = map(float, re.findall(r"(?m)^ +v_C = ([\d.]+) m/s \(([\d.]+) in/s, ", text)[0])
    assert in_inches == pytest.approx(in_metres / 0.0254, rel=1e-3)
    assert re.search(r"(?m)^ +ω3 = [\d.]+ rad/s \((counter-)?clockwise\)$", text)
    assert "in/s" not in "\n".join(whole(*drawn(AS_SET.replace('"1 in"', "25.4")), "en"))


def test_links_that_two_sliding_pairs_join_form_none() -> None:
    """An Oldham coupling: the disc slides on both hubs, which do not slide on each other."""
    coupling = """
frame = { A = [0, 0], D = [40, 0] }
links = { 2.AE = 60, 3.MN = 30, 4.DF = 60 }
slide = [{ block = "3", point = "M", guide = "2", through = "A", toward = "E", tilt = 0 },
         { block = "3", point = "M", guide = "4", through = "D", toward = "F", tilt = -90 }]
driver = [{ vector = "AE", angle = 50, omega = 12 }]
sketch = { M = [20, 20] }
"""
    text = "\n".join(whole(*drawn(coupling), "en"))
    assert "Links 3 and 2 form a sliding pair, so" in text
    assert "Links 4 and 2 are joined by sliding pairs alone, so" in text


def test_an_idle_roller_is_not_said_to_be_unable_to_turn() -> None:
    follower = """
frame = { O = [0, 0], D = [100, 0] }
links = { 2.OK = 20, 3.DB = 75, 4 = { points = ["B"] } }
cam = [{ links = ["2", "4"], profiles = [{ centre = "K", radius = 40 }, { centre = "B", radius = 12 }] }]
driver = [{ vector = "OK", angle = 100, omega = -8 }]
sketch = { B = [30, 60] }
"""
    text = "\n".join(whole(*drawn(follower), "en"))
    assert "drawn without turning: 4." in text
    assert "can only translate" not in text


ALSO = """
ask = ["v C", "omega 3", "a_n CD", "P13"]
frame = { A = [0, 0], D = [80, 0] }
links = { 1.AB = 30, 2.BC = 70, 3.DC = 60 }
driver = [{ vector = "AB", angle = 60, omega = 10, also = [150, 700] }]
sketch = { C = [80, 60] }
"""


@pytest.mark.parametrize("lang", LANGS)
def test_further_positions_have_their_answers_at_the_end(lang: Lang):
    """A solution works out the first; what it finds at the others stands under its answer, by the analysis of each."""
    method, plot = drawn(ALSO)
    lines = explain(method, plot, SCALES, lang)
    head = [line.strip() for line in lines if line.strip().startswith("#")]
    assert head == [f"#{k}{':' if lang == 'en' else '：'}{' ' * (lang == 'en')}φ1 = {at}°" for k, at in ((1, 60), (2, 150), (3, 700), (2, 150), (3, 700))]
    start = max(k for k, line in enumerate(lines) if line.strip().startswith("#2"))
    for k, at in enumerate((150, 700)):
        omega = float(motion(method.mechanism, [radians(at)]).omega["3"])
        own = lines[start + 5 * k : start + 5 * k + 5]
        assert any(line.strip().startswith(f"ω3 = {number(abs(omega))} rad/s") for line in own), own
        assert ("counter-clockwise" in "".join(own) or "逆时针" in "".join(own)) == (omega > 0)
    assert phrase("solution.first position", lang) in "\n".join(lines)


def test_a_further_position_that_is_not_reached_is_said():
    method, plot = drawn(ALSO.replace("AB = 30", "AB = 60").replace("[150, 700]", "[180]"))
    text = "\n".join(explain(method, plot, SCALES, "en"))
    assert re.search(r"#2: φ1 = 180°\n.*dead point", text)


YOKE = """
ask = ["v C", {asked}]
frame = {{ name = "5", O = [0, 0], K = [60, -12] }}
[links]
crank.OA = 37.5
block.points = ["A"]
yoke.shape = {{ C = [0, 0], D = [20, 60] }}
[[slide]]
block = "block"
point = "A"
guide = "yoke"
through = "C"
toward = "D"
[[slide]]
block = "yoke"
point = "C"
guide = "frame"
through = "K"
angle = 0
tilt = 71.565
name = "ram"
[[driver]]
vector = "OA"
angle = 128
omega = -15
[sketch]
C = [-40, -12]
D = [-20, 48]
"""


@pytest.mark.parametrize("asked", ["AblockAyoke", "A@block A@yoke", "A@block, A@yoke", "A@block,A@yoke"])
@pytest.mark.parametrize("lang", LANGS)
def test_one_quantity_has_one_spelling_and_its_opposite_is_told(asked: str, lang: Lang):
    method, plot = drawn(YOKE.format(asked=f'"v {asked}", "a_r {asked}"'))
    assert method.mechanism.ask == ("v C", "v A@block,A@yoke", "a_r A@block,A@yoke")
    text = "\n".join(explain(method, plot, SCALES, lang))
    assert "AblockAyoke" not in text
    for symbol in ("v_", "aʳ_"):
        opposite = phrase("solution.opposite", lang).format(name=f"{symbol}A_yoke,A_block")
        assert re.search(rf"(?m)^ +{symbol}A_block,A_yoke = [\d.]+ m/s²?[ （(]+{opposite}", text)


def test_a_quantity_that_the_solution_has_itself_is_not_called_an_opposite():
    method, plot = drawn(YOKE.format(asked='"v A@yoke,A@block"'))
    assert "opposite of" not in "\n".join(explain(method, plot, SCALES, "en"))


def test_points_of_a_link_that_is_a_word_are_suggested_as_they_are_written():
    with pytest.raises(GraphkinError, match=re.escape("A@block,A@yoke")):
        drawn(YOKE.format(asked='"v A3A2"'))


DOUBLE_WHEEL = """
ask = ["omega 4"]
frame = { A = [0, 0], B = [66, 0], C = [114, 36] }
links = { 2.points = ["A"], 3.points = ["B"], 4.CE = 29 }
gear = [{ links = ["2", "3"], centres = ["A", "B"], radii = [19, 47] },
        { links = ["3", "4"], centres = ["B", "C"], radii = [18, 42] }]
driver = [{ link = "2", omega = 44 }]
pose = [{ vector = "CE", angle = 128 }]
sketch = { E = [96, 59] }
"""


@pytest.mark.parametrize(("lang", "told"), [("en", "g3 about p, g3′ about p and g4"), ("zh", "g3（圆心 p）、g3′（圆心 p）、g4")])
def test_the_second_circle_of_a_double_wheel_has_a_prime_as_its_radius_has(lang: Lang, told: str):
    method, plot = drawn(DOUBLE_WHEEL)
    text = "\n".join(explain(method, plot, SCALES, lang))
    assert told in text
    assert "r3′ = 18 mm" in text
    names = [(wheel.radius, name) for wheel, name, _ in imaged_gears(method)]
    assert names == [(0.019, "g2"), (0.047, "g3"), (0.018, "g3'"), (0.042, "g4")]


POSED = """
ask = [{asked}]
frame = {{ A = [0, 0], D = [71, -23] }}
links = {{ 1.AB = 27.5, 2.BC = 88, 3.DC = 63 }}
driver = [{{ vector = "AB", omega = -7.7 }}]
pose = [{{ vector = "DC", angle = 104 }}]
sketch = {{ B = [-20, -18], C = [56, 38] }}
"""


@pytest.mark.parametrize(("asked", "letter"), [('"omega 3"', "φ"), ('"theta 1", "omega 3"', "θ")])
def test_a_driven_angle_that_is_measured_has_the_letter_by_which_it_is_asked(asked: str, letter: str):
    text = "\n".join(explain(*drawn(POSED.format(asked=asked)), SCALES, "en"))
    assert f"Measured: {letter}1 = 263.6°" in text
    assert ("φ1" in text) == (letter == "φ")


PIN_IN_SLOT = """
ask = ["a_k E3E5"]
frame = { name = "6", A = [0, 0], C = [14, -96] }
links = { 1.AB = 37, 2.points = ["B"], 3.CD = 190, 5.points = ["E"] }
slide = [{ block = "2", point = "B", guide = "3", through = "C", toward = "D" },
         { pin = "E", guide = "3", through = "C", toward = "D" },
         { block = "5", point = "E", guide = "frame", through = [0, 63] }]
driver = [{ vector = "AB", angle = 158, omega = -6.7 }]
sketch = { B = [-34, 14], D = [-65, 80], E = [-52, 63] }
"""


@pytest.mark.parametrize("lang", LANGS)
def test_the_path_of_a_pin_is_straight_in_its_slot_whichever_way_round_it_is_asked(lang: Lang):
    """What enters is the rotation of the slot: so says the solution, which has the opposite, and `solve`."""
    method, plot = drawn(PIN_IN_SLOT)
    (told,) = [line for line in explain(method, plot, SCALES, lang) if line.strip().startswith("aᵏ_E3E5 =")]
    assert "= 2 ω3 v_E3E5 =" in told
    assert phrase("solution.opposite", lang).format(name="aᵏ_E5E3") in told
    printed = CliRunner().invoke(main, ["solve", "-", "--lang", lang], input=PIN_IN_SLOT).output
    (line,) = [line for line in printed.splitlines() if "aᵏ_E3E5 =" in line]
    assert phrase("results.straight", lang).format(rate="ω3", point="E", link="3") in line


@pytest.mark.parametrize("lang", LANGS)
def test_coincident_points_of_links_that_do_not_turn_against_each_other_slide_alike(lang: Lang):
    """The solution has them at C, of which the velocity is known."""
    method, plot = drawn("""
ask = ["v B2B3", "a_k B2B3"]
frame = { A = [0, 0], C = [60, 0] }
links = { 1.AB = 30, 2.BK = 120, 3.points = ["C"] }
slide = [{ block = "3", point = "C", guide = "2", through = "B", toward = "K" }]
driver = [{ vector = "AB", angle = 110, omega = 10 }]
sketch = { B = [-10, 28], K = [100, -20] }
""")
    lines = [line.strip() for line in explain(method, plot, SCALES, lang)]
    for symbol in ("v_", "aᵏ_"):
        (told,) = [line for line in lines if line.startswith(f"{symbol}B2B3 =")]
        assert re.match(rf"{symbol}B2B3 = {symbol}C2C3 = [\d.]+ m/s", told)
        assert phrase("solution.no turning", lang).format(one="2", other="3") in told


@pytest.mark.parametrize(("lang", "told"), [("en", "A→B points the other way along the guide."), ("zh", "A→B 与导路方向相反。")])
def test_a_rod_that_points_back_along_its_guide_is_said_to(lang: Lang, told: str):
    """Not its guide's direction turned by 180°."""
    cylinder = """
frame = { O = [0, 0], D = [80, 0] }
links = { 1.OA = 30, 2.AB = 40, 3.points = ["D"] }
slide = [{ name = "oil", block = "2", point = "A", guide = "3", tilt = 180 }]
driver = [{ vector = "OA", angle = 60, omega = 1 }]
sketch = { A = [15, 26], B = [40, 10] }
"""
    text = "\n".join(whole(*drawn(cylinder), lang))
    assert told in text
    assert "180°" not in text


THREAD = """
frame = { A = [0, 0], D = [-24, 17] }
ask = ["v E"]
[links]
2.shape = { A = [0, 0], B = [12, 0], C = [9, 13] }
3.shape = { C = [0, 0], F = [30, 0], E = [56, 9] }
4.DF = 26
[[driver]]
vector = "AB"
angle = 214
omega = -10
[sketch]
C = [-6, -15]
F = [2, 14]
E = [-12, 42]
"""


def test_a_further_point_of_a_crank_has_its_formula_and_what_is_laid_off_before_an_image_its_row():
    """v_C = ω2 l_AC, as a book writes it; the sheet numbers its rows in the order of the drawing."""
    method, plot = drawn(THREAD)
    text = "\n".join(explain(method, plot, SCALES, "en"))
    assert re.search(r"v_C = ω2 l_AC = μ_v·pc = ", text)
    assert "v_E = μ_v·pe = " in text  # of a coupler there is no pivot
    entries = [*derivation(method, plot, SCALES, "en", as_planned=True)]
    numbers = [rung.numbers for rung in rungs(entries, "velocity", method) if rung.numbers]
    assert numbers[:3] == [(1,), (2,), (3,)]
    assert sorted(numbers) == numbers


GATE = """
frame = { O = [0, 0], D = [120, 40] }
links = { 2.OA = 35, 3.AB = 110, 4.DB = 70, 5.RS = 100 }
roll = [{ wheel = "2", centre = "O", radius = 25, on = "5", through = "R", toward = "S", side = "left" }]
slide = [{ name = "rack", block = "5", point = "R", guide = "frame", through = [0, -25], tilt = 0 }]
driver = [{ slide = "rack", at = -40, velocity = -0.09 }]
pose = [{ vector = "OA", angle = 80 }]
sketch = { B = [90, 100] }
"""


def test_every_step_that_no_equation_of_its_own_has_stands_in_a_row():
    method, plot = drawn(GATE)
    entries = [*derivation(method, plot, SCALES, "en", as_planned=True)]
    rows = [(rung.numbers, rung.equation) for rung in rungs(entries, "velocity", method) if rung.numbers]
    assert rows[:3] == [((1,), "v_R"), ((2,), "v_S = v_R"), ((3,), "v_K5 = v_R")]


ARM = """
frame = { A = [0, 0] }
links = { 1.AB = 400, 2.BC = 300 }
driver = [{ vector = "AB", angle = 35, omega = 1.5, alpha = -2 },
          { vector = "BC", from = "AB", angle = -70, omega = -4, alpha = 0 }]
"""
PINION = """
frame = { A = [0, 0] }
links = { 2.AB = 40, 4.BC = 130, 3.points = ["C"], 5.RS = 100 }
roll = [{ wheel = "3", centre = "C", radius = 25, on = "frame", through = [0, -25], angle = 0 },
        { wheel = "3", centre = "C", radius = 25, on = "5", through = "R", toward = "S", side = "right" }]
slide = [{ name = "rack", block = "5", point = "R", guide = "frame", through = [0, 25], angle = 0, tilt = 0 }]
driver = [{ vector = "AB", angle = 60, omega = "100 r/min" }]
pose = [{ slide = "rack", at = 90 }]
sketch = { C = [145, 0], R = [90, 25], S = [190, 25] }
"""


@pytest.mark.parametrize(("text", "relations"), [
    (ARM, {"velocity": "ω2 = ω1 + ω21", "acceleration": "α2 = α1 + α21"}),
    (PINION, {"velocity": "ṡ_rack = ṡ_C − r3 ω3", "acceleration": "s̈_rack = s̈_C − r3 α3"}),
])  # fmt: skip
def test_what_an_equation_hangs_on_has_a_row_before_it(text: str, relations: dict[Plane, str]) -> None:
    """A rate that a driver or a wheel gives; it comes with the step that takes it, and has no number of its own."""
    method, plot = drawn(text)
    for plane, relation in relations.items():
        entries = polygon_entries(Reading(method, plot, SCALES, "en"), plane, method.construction(plane).parts, 0)
        rows = [*rungs(entries, plane, method)]
        [at] = [k for k, rung in enumerate(rows) if rung.equation == relation]
        assert not rows[at].numbers
        assert (rows[at].page or 0) <= (rows[at + 1].page or 0)


NEEDLE = """
frame = { O = [0, 0] }
[links]
2.OB = 14.5
3.shape = { N = [0, -60], Q = [6, 22] }
[[slide]]
name = "bar"
block = "3"
point = "N"
guide = "frame"
through = "O"
angle = -90
tilt = 175.815
[[slide]]
pin = "B"
guide = "3"
centre = "Q"
radius = 27
[[driver]]
vector = "OB"
angle = 248
omega = 10
[sketch]
N = [0, -60]
Q = [6, 10]
"""


@pytest.mark.parametrize(("lang", "told"), [("en", "W. W is where Q is when N lies at O."), ("zh", "得 W。W 即 N 位于 O 时 Q 的位置。")])
def test_a_point_that_the_mechanism_has_not_is_explained(lang: Lang, told: str):
    assert told in "\n".join(whole(*drawn(NEEDLE), lang))


_PARALLEL = """
frame = { A = [0, 0], D = [80, -10] }
links = { 1.AB = 40, 2.BC = 80.622577483, 3.DC = 40 }
driver = [{ vector = "AB", angle = 60, omega = -4, alpha = 3 }]
sketch = { C = [100, 25] }
"""


@pytest.mark.parametrize(("lang", "always", "now"), [("en", "translates, here as in every position", "at this instant"), ("zh", "始终作平动", "瞬时平动")])
def test_what_always_translates_is_told_from_what_translates_now(lang, always, now):
    """The coupler of a parallelogram, however it is turned and driven, against a rod whose crank is square to its guide."""
    for omega in ("omega = -4", "omega = 7"):
        text = "\n".join(graphkin.Drawing.of(graphkin.loads(_PARALLEL.replace("omega = -4", omega))).explain(lang=lang))
        assert always in text
        assert now not in text
    text = "\n".join(graphkin.Drawing.of(library.load("p3-6c")).explain(lang=lang))
    assert now in text
    assert always not in text
