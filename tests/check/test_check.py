"""The drawing file, read by nothing but an XML parser, and what a ruler must catch in it."""

from __future__ import annotations

import json
import os
import re
import xml.etree.ElementTree as ET
from collections.abc import Callable
from pathlib import Path

import book
import pytest

from graphkin import Drawing
from graphkin.check import measure
from graphkin.errors import BadDrawing, GraphkinError, NoDrawing
from graphkin.files import library
from graphkin.outputs.svg import svg

SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module")
def example() -> str:
    return svg(Drawing.of(book.example()).sheet())


def put(folder: Path, text: str) -> Path:
    path = folder / "drawing.svg"
    path.write_text(text, encoding="utf-8")
    return path


def vectors(text: str) -> dict[str, tuple[float, float, float, float]]:
    return {
        line.get("data-name"): tuple(float(line.get(key)) for key in ("x1", "y1", "x2", "y2"))
        for line in ET.fromstring(text).iter(f"{SVG}line")
        if line.get("class") == "vector"
    }


def length(place: tuple[float, float, float, float]) -> float:
    x1, y1, x2, y2 = place
    return ((x2 - x1) ** 2 + (y2 - y1) ** 2) ** 0.5


def test_example_3_1_on_paper(example: str):
    """Sun Huan, example 3-1: lengths laid off and measured, at the book's own scales."""
    found = vectors(example)
    assert length(found["v_B3"]) == pytest.approx(27.12, abs=0.005)
    assert length(found["v_B3B2"]) == pytest.approx(32.08, abs=0.005)
    assert length(found["a^k_B3B2"]) * 0.1 == pytest.approx(2.5149, abs=5e-4)
    assert length(found["a^n_B3D"]) * 0.1 == pytest.approx(1.0629, abs=5e-4)
    root = ET.fromstring(example)
    width, height = root.get("width"), root.get("height")
    assert root.get("viewBox") == f"0 0 {width.removesuffix('mm')} {height.removesuffix('mm')}"
    assert not [e for e in root.iter() if e.get("transform") and e.get("class") in ("vector", "point")]


def test_lines_join_points(example: str):
    root = ET.fromstring(example)
    points = {
        (c.get("data-plane"), c.get("data-name")): (c.get("cx"), c.get("cy"))
        for c in root.iter(f"{SVG}circle") if c.get("class") == "point"
    }  # fmt: skip
    assert points["velocity", "b3"] is not None
    for line in root.iter(f"{SVG}line"):
        if line.get("class") == "vector":
            plane = line.get("data-plane")
            assert points[plane, line.get("data-tail")] == (line.get("x1"), line.get("y1"))
            assert points[plane, line.get("data-head")] == (line.get("x2"), line.get("y2"))


def moved(text: str) -> list[tuple[str, str]]:
    """The drawing with one coordinate of one vector or point moved by 0.02 mm, for every one there is."""
    found = []
    elements = re.finditer(r"<(?:line|circle)\b[^>]*class=\"(?:vector|point)\"[^>]*>", text)
    for element in elements:
        for coordinate in re.finditer(r'\b(x1|y1|x2|y2|cx|cy)="([^"]*)"', element.group()):
            new = f'{coordinate[1]}="{float(coordinate[2]) + 0.02:.4f}"'
            whole = element.group().replace(coordinate[0], new, 1)
            found.append((whole, text[: element.start()] + whole + text[element.end() :]))
    return found


@pytest.mark.parametrize("name", ["ex3-1", "p3-6a", "s4-ex7"])
def test_a_ruler_sees_anything_moved(name: str, tmp_path: Path):
    text = svg(Drawing.of(library.load(name)).sheet())
    changes = moved(text)
    assert len(changes) > 40
    for what, changed in changes if "GRAPHKIN_MOVED" in os.environ else changes[::5]:  # x and y of both ends in turns
        assert not measure(put(tmp_path, changed)).passed(0.01), what


def claims(text: str) -> tuple[re.Match[str], dict[str, object]]:
    found = re.search(r"(?<=<gk:sheet>)(.*?)(?=</gk:sheet>)", text, re.S)
    unescaped = found[0].replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&")
    return found, json.loads(unescaped)


def with_claims(text: str, data: dict[str, object]) -> str:
    found, _ = claims(text)
    new = json.dumps(data).replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    return text[: found.start()] + new + text[found.end() :]


@pytest.mark.parametrize("key", ["length", "velocity", "acceleration"])
def test_a_changed_scale_is_seen(example: str, key: str, tmp_path: Path):
    _, data = claims(example)
    data["scales"][key] *= 1.01
    assert not measure(put(tmp_path, with_claims(example, data))).passed(0.01)


@pytest.mark.parametrize(
    ("old", "new"),
    [("AB = 24", "AB = 24.1"), ("omega = 10", "omega = 10.1"), ("DC = 48", "DC = 48.1"), ("angle = 100", "angle = 101"),
     ("D = [78, 0]", "D = [78.1, 0]"), ("angle = 60", "angle = 61")],
)  # fmt: skip
def test_a_changed_mechanism_is_seen(example: str, old: str, new: str, tmp_path: Path):
    _, data = claims(example)
    assert old in data["mechanism"]
    data["mechanism"] = data["mechanism"].replace(old, new)
    if new == "angle = 61":
        data["drivers"] = [1.0646508437165410]
    try:
        assert not measure(put(tmp_path, with_claims(example, data))).passed(0.01)
    except GraphkinError:
        pass


def test_changed_drivers_are_seen(example: str, tmp_path: Path):
    _, data = claims(example)
    data["drivers"] = [1.05]
    assert not measure(put(tmp_path, with_claims(example, data))).passed(0.01)


def test_a_transform_is_seen(example: str, tmp_path: Path):
    changed = example.replace('class="vector"', 'class="vector" transform="translate(1,0)"', 1)
    assert not measure(put(tmp_path, changed)).passed(0.01)


@pytest.mark.parametrize(
    "text",
    ["", "not xml", "<svg/>", '<svg xmlns="http://www.w3.org/2000/svg"/>', "<a>" * 5000,
     '<!DOCTYPE l [<!ENTITY a "x">]><svg xmlns="http://www.w3.org/2000/svg">&a;</svg>'],
)  # fmt: skip
def test_what_is_no_drawing(text: str, tmp_path: Path):
    with pytest.raises(BadDrawing):
        measure(put(tmp_path, text))


def test_no_file(tmp_path: Path):
    with pytest.raises(NoDrawing):
        measure(tmp_path / "nothing.svg")
    with pytest.raises(BadDrawing):
        measure(tmp_path)


@pytest.mark.parametrize("key", ["mechanism", "drivers", "scales", "program"])
def test_metadata_spoilt(example: str, key: str, tmp_path: Path):
    _, data = claims(example)
    for spoilt in (None, "x", [], {}, [None], 7, {"length": "a"}, {"length": -1}, ["nan"]):
        data[key] = spoilt
        with pytest.raises(GraphkinError):
            measure(put(tmp_path, with_claims(example, data)))


def test_same_bytes(example: str):
    assert svg(Drawing.of(book.example()).sheet()) == example


@pytest.mark.parametrize(("change", "good"), [
    (lambda aside: aside, True), (lambda aside: f"{-float(aside):.4f}", False), (lambda aside: "0.5000", False),
    (lambda aside: "", False),
])  # fmt: skip
def test_an_arrow_beside_its_line_is_measured_where_it_belongs(
    tmp_path: Path, change: Callable[[str], str], good: bool
) -> None:
    """It says how far aside it is drawn, and says it rightly or its ends are off their points."""
    text = svg(Drawing.of(library.load("ex3-4")).sheet())
    asides = re.findall(r'data-aside="([^"]+)"', text)
    assert asides
    changed = text.replace(f'data-aside="{asides[0]}"', f'data-aside="{change(asides[0])}"', 1)
    assert measure(put(tmp_path, changed)).passed(0.01) is good


@pytest.mark.parametrize(("old", "new", "good"), [
    ("", "", True), (r' data-broken="[^"]+"', "", False), (r'data-broken="(\d)', r'data-broken="1\1', False),
    (r'(data-broken="[^>]*) stroke-dasharray="[^"]+"', r"\1", False),
])  # fmt: skip
def test_an_arrow_that_is_drawn_broken_is_measured_whole(tmp_path: Path, old: str, new: str, good: bool) -> None:
    """It says how much of it is left out, says it rightly, and shows a gap; or it is too short, and its head is off."""
    text = svg(Drawing.of(library.load("p3-19")).sheet())
    changed = re.sub(old, new, text) if old else text
    assert (changed == text) is good
    measured = measure(put(tmp_path, changed))
    assert measured.passed(0.01) is good
    assert {each.name for each in measured.measured if each.off_mm > 0.01} == (set() if good else {"a_W", "w'"})
