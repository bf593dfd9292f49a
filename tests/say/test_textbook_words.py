"""What a solution says of mechanisms as textbooks have them, in the words of their files."""

from __future__ import annotations

import re

import pytest

import graphkin
from graphkin.equations import document
from graphkin.equations.document import DocumentSentence
from graphkin.errors import Lang
from graphkin.files import library, loads
from graphkin.handouts.markup import solution
from graphkin.outputs.typesetting import signs
from graphkin.planning import plan
from graphkin.say.catalogue import say_close

WHITWORTH = """
ask = ["alpha 4", "a E", "v A4A2", "a_k A4A2", "a_k A5A2"]
frame = { name = "1", O2 = [0, 0], O4 = [60, 0] }
links = { 2 = { O2A = 150 }, 3 = { points = ["A"] }, 4 = { O4D = 90 }, 5 = { DE = 300 }, 6 = { points = ["E"] } }
slide = [
    { block = "3", point = "A", guide = "4", through = "O4", from = "DO4", angle = 0 },
    { block = "6", point = "E", guide = "frame", through = "O4", angle = 90 },
]
driver = [{ vector = "O2A", angle = 200, omega = "120 rpm" }]
sketch = { A = [-140, -50], D = [147, 22], E = [60, 308] }
"""
SLIDER_CRANK = """
ask = ["omega 连杆", "alpha 连杆", "v C"]
frame = { name = "机架", A = [0, 0] }
links = { 曲柄 = { AB = 30 }, 连杆 = { BC = 100 }, 滑块 = { points = ["C"] } }
slide = [{ block = "滑块", point = "C", guide = "frame", through = [0, 10], angle = 240 }]
driver = [{ vector = "AB", angle = 100, omega = -20, alpha = 30 }]
sketch = { C = [-50, -80], B = [-5, 30] }
"""
for word in ("曲柄", "连杆", "滑块"):
    SLIDER_CRANK = SLIDER_CRANK.replace(f"{word} = ", f'"{word}" = ')
PLANET = """
ask = ["omega 2", "alpha 2"]
frame = { name = "环", O = [0, 0] }
links = { H = { OA = 40 }, 2 = { AB = 24 } }
gear = [{ links = ["frame", "2"], centres = ["O", "A"], radii = [70, 30], internal = true }]
pose = [{ vector = "AB", angle = 190 }]
driver = [{ vector = "OA", angle = 160, omega = 6 }]
"""
BOOM = """
ask = ["v T", "a T"]
frame = { A = [0, 0], C = ["-0.9 m", "0.5 m"] }
links = { 2 = { points = ["A"] }, 3 = { points = ["B"] }, 4 = { CB = "1.7 m", CT = "3.6 m", BT = "2 m", ccw = ["T", "B", "C"] } }
slide = [{ name = "cylinder", block = "3", point = "B", guide = "2" }]
driver = [{ slide = "cylinder", at = "1.5 m", velocity = "120 mm/s", acceleration = "-50 mm/s^2" }]
sketch = { B = [600, 1380], T = [2600, 1400] }
"""
RACK = """
ask = ["v R", "a R"]
frame = { name = "5", A = [0, 0], D = [95, -20] }
links = { 1 = { AB = 28 }, 2 = { BC = 85 }, 3 = { DC = 50 }, 4 = { RS = 90 } }
slide = [{ name = "rack", block = "4", point = "R", guide = "frame", through = [60, -45], tilt = 0 }]
roll = [{ wheel = "3", centre = "D", radius = 25, on = "4", through = "R", toward = "S", side = "left" }]
pose = [{ slide = "rack", at = 0 }]
driver = [{ vector = "AB", angle = 110, omega = -8 }]
sketch = { B = [-9, 26], C = [72, 25], R = [60, -45], S = [150, -45] }
"""
PUSHED = """
ask = ["omega 3", "alpha 3"]
frame = { name = "5", D = [95, -20] }
links = { 3 = { DC = 50 }, 4 = { RS = 90 } }
slide = [{ name = "rack", block = "4", point = "R", guide = "frame", through = [60, -45], tilt = 0 }]
roll = [{ wheel = "3", centre = "D", radius = 25, on = "4", through = "R", toward = "S", side = "left" }]
pose = [{ vector = "DC", angle = 120 }]
driver = [{ slide = "rack", at = 0, velocity = -0.1 }]
"""
WHEEL = """
ask = ["omega 3"]
frame = { name = "1", E = [0, 0] }
links = { 2 = { CA = "0.3 m" }, 3 = { AB = "1.6 m" }, 4 = { points = ["B"] } }
roll = [{ name = "wheel", wheel = "2", centre = "C", radius = "0.45 m", on = "frame", through = "E", angle = 200, side = "right" }]
slide = [{ block = "4", point = "B", guide = "frame", through = "E", angle = 200 }]
pose = [{ vector = "CA", angle = 75 }]
driver = [{ slide = "wheel", at = "0.8 m", velocity = 2, acceleration = -1.5 }]
sketch = { C = [-900, 150], A = [-830, 440], B = [-2200, -800] }
"""
ALL = (WHITWORTH, SLIDER_CRANK, PLANET, BOOM, RACK, WHEEL)


def told(text: str, lang: Lang = "en") -> str:
    return "\n".join(graphkin.Drawing.of(loads(text, name="textbook")).explain(lang))


def test_a_coriolis_term_asked_of_the_crank_is_the_one_that_was_worked_out() -> None:
    text = told(WHITWORTH)
    worked = re.search(r"aᵏ_A4A3 = 2 ω3 v_A4A3 = .* = (\S+) m/s²", text)
    assert worked is not None
    assert f"aᵏ_A4A2 = aᵏ_A4A3 = {worked[1]} m/s²" in text
    assert "v_A4A2 = v_A4A3 = " in text
    assert "aᵏ_A5A2 = 2 ω2 v_A5A2 = 2 × 12.566 × 2.9043 = 72.99 m/s²" in text  # no arrow: a line of its own


@pytest.mark.parametrize("text", [SLIDER_CRANK, PLANET], ids=["crank", "planet"])
def test_a_subscript_ends_where_the_name_of_the_link_ends(text: str) -> None:
    drawing = graphkin.Drawing.of(loads(text, name="textbook"))
    links = {*drawing.mechanism.links, drawing.mechanism.called("frame")}
    labels = [block.words for _, blocks in solution(drawing, "zh").parts for block in blocks if hasattr(block, "words")]
    lows = ["".join(run.text for run in sign.low) for label in labels if not isinstance(label, str) for sign in signs(label)]
    words = {word for low in lows for word in re.findall("[\u4e00-\u9fff]+", low)}
    assert words
    assert words <= links


def test_an_acceleration_points_towards_where_the_displacement_grows_or_shrinks() -> None:
    assert "v_B3B2 = 120 mm/s (s_cylinder increasing)" in told(BOOM)
    assert "aʳ_B3B2 = 50 mm/s² (towards decreasing s_cylinder)" in told(BOOM)
    assert "aʳ_B3B2 = 50 mm/s²（指向 s_cylinder 减小的方向）" in told(BOOM, "zh")


@pytest.mark.parametrize(("text", "en", "zh"), [
    (WHITWORTH, "a fixed guide through O4, vertically.", "导路过 O4，竖直。"),
    (SLIDER_CRANK, "a fixed guide through (0, 10) mm, at 240° to +x.", "导路过 (0, 10) mm，与 x 轴正向成 240°。"),
    (RACK, "through (60, −45) mm, displacement s_rack counted from there horizontally to the right;",
     "导路过 (60, −45) mm，位移 s_rack 自该处起算，正向水平向右；"),
])  # fmt: skip
def test_a_guide_has_a_sense_only_where_something_is_counted_along_it(text: str, en: str, zh: str) -> None:
    assert en in told(text)
    assert zh in told(text, "zh")
    assert re.search("The guide of [A-Z] runs through .*, (vertically|horizontally|at 240° to [+]x)[.]", told(text))


def test_no_word_stands_before_a_name_that_says_it() -> None:
    text = told(SLIDER_CRANK, "zh")
    assert "  机架上的固定点（mm）：A(0, 0)。" in text
    assert "  滑块上的 C 点沿固定导路移动" in text
    assert "由连杆上 C、B 两点之间的速度关系，有" in text
    assert "环、轮 2 的接触点 K" in told(PLANET, "zh")
    assert "环、齿轮 2（轮心 O、A）内啮合" in told(PLANET, "zh")
    assert "构件 H 的 OA" in told(PLANET, "zh")
    assert say_close("derivation.translates", "zh", link="甲", of="v", seen_from="w", node="a", base="b").startswith("构件甲")
    text = told(WHITWORTH.replace("6 =", "slider =").replace('"6"', '"slider"').replace('name = "1"', 'name = "frame"'))
    assert "  Fixed points (mm): O2(0, 0), O4(60, 0)." in text
    assert "  Slider moves its point E along" in text


def test_a_carrier_is_named_where_there_is_one() -> None:
    def rolling(text: str, lang: Lang) -> list[str]:
        blocks = document(plan(loads(text, name="textbook")), lang=lang).blocks
        said = ("".join(map(str, each.parts)) for each in blocks if isinstance(each, DocumentSentence))
        return [each for each in said if each.startswith(("Rolling", "由无滑动"))]

    constant = "ties the angles; the constant is that of the drawn position:"
    assert rolling(WHEEL, "en") == [f"Rolling without slip {constant}"]
    assert rolling(PLANET, "en") == [f"Rolling without slip, seen from link H, {constant}"]
    assert rolling(WHEEL, "zh") == ["由无滑动滚动条件得转角关系，常数由给定位置确定："]


def test_a_short_line_is_not_said_to_be_missing() -> None:
    """Whether a detail draws it, only the sheet knows."""
    assert re.search(r"d′n5′ = .* = 0\.4920 mm \(very short on paper\)\.", told(WHITWORTH))


def test_a_rack_that_a_pinion_drives_is_as_fast_as_its_rim() -> None:
    text = told(RACK)
    assert "v_R = r3 ω3 = 0.025 × 4.576 = 0.1144 m/s (∥x, horizontally to the left)" in text
    assert "a_R = r3 α3 = 0.025 × 4.431 = 0.1108 m/s² (∥x, horizontally to the left)" in text


def test_the_relation_of_a_driven_rack_has_its_rate_with_its_sign() -> None:
    text = told(PUSHED)
    assert "v_R = 0.1 m/s (s_rack decreasing)" in text
    assert "Pure rolling: r3(ω3 − ω4) − ṡ_rack = 0 at all times, with ṡ_rack constant; so α3 = 0." in text


def test_a_line_cuts_the_guide_that_stands_there() -> None:
    text = told(SLIDER_CRANK)
    assert "= 200 mm; it cuts the guide of C at C (the lower crossing)." in text
    assert "the line parallel to the guide of C, from b the line ⊥BC; they meet at c." in text
    text = told(SLIDER_CRANK, "zh")
    assert "= 200 mm 为半径作弧，与 C 的导路交于 C（取下方的交点）。" in text
    assert "过 p 作平行于 C 的导路的直线，过 b 作 ⊥BC 的方向线，两线交于 c。" in text


@pytest.mark.parametrize("text", ALL)
def test_a_length_is_measured_if_it_is_used(text: str) -> None:
    said = told(text)
    for length in re.findall(r"(l_\w+) = μ_l·", said):
        assert len(re.findall(rf"{length}\b", said)) > 1, length


def test_one_driver_is_one_and_metres_are_as_they_are_calculated_with() -> None:
    assert "  Driver: the rolling contact is at s_wheel = 0.8 m, v_C = 2 m/s" in told(WHEEL)
    assert "  Lengths: l_AC = 0.3 m, l_AB = 1.6 m." in told(WHEEL)
    assert "  Drivers: " in "\n".join(graphkin.Drawing.of(library.load("p3-21")).explain())


@pytest.mark.parametrize(("lang", "head"), [("en", "Sheet 2 of "), ("zh", "第 2 张，共 ")])
def test_sheets_of_single_steps_are_counted_as_sheets(lang: Lang, head: str) -> None:
    """The numbers in circles count the steps."""
    drawing = graphkin.Drawing.of(loads(BOOM, name="textbook"))
    second = [*drawing.step_sheets(lang=lang)][1]
    assert head in second.svg()
