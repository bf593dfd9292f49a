"""The drawing file: a document that a program can measure."""

from __future__ import annotations

import dataclasses
import json
import re
from pathlib import Path
from xml.etree.ElementTree import Element

import book
import pytest
from defusedxml.ElementTree import fromstring

from graphkin import Drawing
from graphkin.files import library
from graphkin.outputs.drawings import write
from graphkin.outputs.files import FileInTheWay
from graphkin.outputs.svg import Unwritable, svg
from graphkin.outputs.typesetting import mm
from graphkin.planning import plan
from graphkin.running import replay_all
from graphkin.sheet import Sheet, sheet

SVG = "{http://www.w3.org/2000/svg}"


def page(name: str = "ex3-1", **options: str) -> Sheet:
    method = plan(book.example() if name == "ex3-1" else library.load(name))
    return sheet(method, replay_all(method), **options)  # type: ignore[arg-type]


@pytest.fixture(scope="module")
def text() -> str:
    return svg(page())


@pytest.fixture(scope="module")
def root(text: str) -> Element:
    parsed: Element = fromstring(text)
    return parsed


def of_class(root: Element, kind: str) -> list[Element]:
    return [element for element in root.iter() if element.get("class") == kind]


def test_one_unit_is_one_millimetre(root: Element) -> None:
    assert (root.get("width"), root.get("height"), root.get("viewBox")) == ("297mm", "210mm", "0 0 297 210")


def test_nothing_but_letters_is_turned(root: Element) -> None:
    turned = [element for element in root.iter() if "transform" in element.attrib]
    assert {element.tag.rpartition("}")[2] for element in turned} == {"text"}
    assert all(re.fullmatch(r"rotate\(-?[\d.]+ [\d.]+ [\d.]+\)", element.attrib["transform"]) for element in turned)


def test_vectors_are_lines_from_tail_to_head(root: Element) -> None:
    points = {(p.get("data-plane"), p.get("data-name")): p for p in of_class(root, "point")}
    vectors = of_class(root, "vector")
    assert {v.get("data-name") for v in vectors} >= {
        "v_B2",
        "v_B3B2",
        "v_C",
        "a^n_B3D",
        "a^t_B3D",
        "a^k_B3B2",
        "a^r_B3B2",
    }
    for v in vectors:
        assert v.tag == SVG + "line"
        for end, x, y in (("tail", "x1", "y1"), ("head", "x2", "y2")):
            point = points[v.get("data-plane"), v.get(f"data-{end}")]
            assert (v.get(x), v.get(y)) == (point.get("cx"), point.get("cy"))


def test_points_are_circles_with_what_they_belong_to(root: Element) -> None:
    points = {(p.get("data-plane"), p.get("data-name")): p.get("data-of") for p in of_class(root, "point")}
    assert points["position", "B"] == "B"
    assert points["velocity", "b3"] == "B3"
    assert points["acceleration", "b3'"] == "B3"
    assert points["velocity", "p"] == points["acceleration", "p'"] == "pole"
    assert {name for plane, name in points if plane == "position"} == {"A", "B", "C", "D"}


def test_metadata_holds_the_problem(root: Element) -> None:
    (element,) = (e for e in root.iter() if e.tag.endswith("}sheet"))
    data = json.loads(element.text or "")
    assert data["mechanism"] == book.TEXT
    assert data["program"] == "graphkin"
    assert data["scales"] == {"length": 0.001, "velocity": 0.01, "acceleration": 0.1}
    assert len(data["drivers"]) == 1
    pole = next(p for p in of_class(root, "point") if p.get("data-name") == "p")
    assert [float(pole.get(key, "")) for key in ("cx", "cy")] == data["origin"]["velocity"]


def test_zero_vectors_are_lines_of_no_length() -> None:
    root = fromstring(svg(page("p3-6a")))
    (line,) = (v for v in of_class(root, "vector") if v.get("data-name") == "v_B3")
    assert (line.get("x1"), line.get("y1")) == (line.get("x2"), line.get("y2"))
    assert line.get("marker-end") is None


def test_same_input_same_bytes(text: str) -> None:
    assert svg(page()) == text


def test_chinese_stands_in_spans_of_its_own() -> None:
    spans = fromstring(svg(page(lang="zh"))).iter(SVG + "tspan")
    for span in spans:
        wide = [ord(c) > 0x2E80 for c in (span.text or "").rstrip()]
        assert all(wide) or not any(wide)
        if any(wide):
            assert span.get("x") is not None
            assert "CJK" in (span.get("font-family") or "")


@pytest.mark.parametrize("value", [float("nan"), float("inf")])
def test_coordinates_are_numbers(value: float) -> None:
    with pytest.raises(ValueError, match="coordinate"):
        mm(value)


def test_four_decimals() -> None:
    assert [mm(v) for v in (1.0, 0.30000000000000004, -1e-9, 12.34567)] == ["1", "0.3", "0", "12.3457"]


def test_control_characters_are_refused() -> None:
    drawing = page()
    broken = dataclasses.replace(drawing.mechanism, text="title = 'a'\n# \x07", file="a.toml")
    with pytest.raises(Unwritable, match=r"a\.toml:2.*U\+0007"):
        svg(dataclasses.replace(drawing, mechanism=broken))


def test_own_files_are_replaced_and_others_kept(tmp_path: Path, text: str) -> None:
    own, other = tmp_path / "own.svg", tmp_path / "other.svg"
    write(own, text, False)
    write(own, text, False)
    other.write_text("<svg/>")
    with pytest.raises(FileInTheWay, match=r"other\.svg"):
        write(other, text, False)
    assert other.read_text() == "<svg/>"
    write(other, text, force=True)
    assert own.read_text(encoding="utf-8") == other.read_text(encoding="utf-8") == text
    assert sorted(path.name for path in tmp_path.iterdir()) == ["other.svg", "own.svg"]


def test_a_notebook_shows_the_sheet(text: str) -> None:
    drawing = Drawing.of(book.example())
    assert drawing._repr_svg_() == drawing.sheet()._repr_svg_() == text
