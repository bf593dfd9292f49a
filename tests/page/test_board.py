"""The drawing board: drawn on with the pointer alone, by keys and by touch, kept, opened again, and without any answer."""

from __future__ import annotations

import json
import math
import re
import xml.etree.ElementTree as ET
from functools import cache
from html import escape as html_text
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from board_student import StudentHand
from browsing import Browsing, axe
from rolling_machines import FAMILIES
from student import Student

from graphkin import grade, load, loads
from graphkin.base.geometry import number, place
from graphkin.handouts.markup import html
from graphkin.handouts.problem import HandoutProblem, drawn_problem
from graphkin.handouts.stages import handout
from graphkin.homework.grading.keys import key_for
from graphkin.homework.grading.sets import OneKey
from graphkin.marking.marker import Marker
from graphkin.model.quantities import EDGE
from graphkin.page.board import board_page
from graphkin.proof.readings import readings

SEED = 3
WIDE, PHONE = {"width": 1400, "height": 1000}, {"width": 390, "height": 844}
_NUMBER = re.compile(r"(?<![\w.#])\d+\.?\d*(?:e-?\d+)?(?![\w.])")


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    folder, written = tmp_path_factory.mktemp("boards"), {}

    def page(name: str) -> Path:
        if name not in written:
            written[name] = folder / f"{name}.html"
            written[name].write_text(board_page(load(name), "en"), "utf-8")
        return written[name]

    return page


# --- nothing that is asked for


def numbers(text: str) -> set[str]:
    """All numbers of four figures and more."""
    return {one for one in _NUMBER.findall(text) if len(one.replace(".", "").strip("0")) >= 4}


def answers(problem) -> list[float]:
    """What is asked, and where the polygons' points are, in SI units and those of the edge, on paper and off it."""
    plot, values = problem.drawing.plot, []
    motions = readings(problem.drawing.method, plot)
    for quantity in filter(None, problem.asked.wanted):
        answer = quantity.answer(motions)
        sizes = [number(answer.value)] if answer.vector is None else [abs(place(answer.vector)), *_parts(answer.vector)]
        values += [each * by for each in sizes for by in (1.0, EDGE[quantity.unit].factor)]
    for plane in problem.polygons:
        scale, points = problem.scales[plane], plot.points(plane)
        values += [
            part * by for at in points.values() for part in (abs(place(at)), *_parts(at)) for by in (1.0, 1 / scale)
        ]
    return [abs(value) for value in values if math.isfinite(value) and abs(value) > 1e-9]


def _parts(vector) -> tuple[float, float]:
    return place(vector).real, place(vector).imag


def held_answers(page: str, problem, posed: str) -> set[str]:
    """The numbers of a page that are one of the answers to four figures, and stand in no printed problem; `posed`:
    that, and the places of the points of its figure."""
    right = np.array(answers(problem))
    own = sorted(numbers(page) - numbers(posed))
    return {one for one in own if np.any(np.abs(right / float(one) - 1) < 1e-4)}


@cache
def problem_of(name: str) -> HandoutProblem:
    return drawn_problem(load(name), "en")


@cache
def judge_of(name: str) -> OneKey:
    return OneKey(Marker(key_for(load(name))))


@pytest.mark.parametrize("name", ["ex3-1", "ex3-7", "ex3-2", "p3-16", "p3-14"])
def test_no_answer_is_on_the_page(name):
    mechanism, problem = load(name), problem_of(name)
    page, posed = board_page(mechanism, "en"), html(handout([mechanism], "problem", "en"))
    data = page[page.index('id="board"') :]
    data = data[data.index("{") : data.index("</script>")]
    posed += json.dumps(json.loads(data)["given"]["points"])
    assert not held_answers(data, problem, posed)
    betrayed = next(text for value in answers(problem) if numbers(text := f"{value:.6g}"))
    assert held_answers(f"{data} {betrayed}", problem, posed) == {betrayed}
    assert not re.search(r"graphkin key|tolerance|verdict|answers?:", data)


def test_a_position_that_only_a_template_gives_is_given(pages):
    given = {name: held(pages(name))["given"] for name in ("ex3-1", "ex3-2", "ex3-7")}
    assert {name: bool(each["corner"] and each["points"]) for name, each in given.items()} == {
        "ex3-1": True, "ex3-2": True, "ex3-7": False  # angles are asked: the figure stands elsewhere
    }  # fmt: skip
    assert [line for line in given["ex3-7"]["lines"] if line["at"]] == []


def held(page: Path) -> dict[str, Any]:
    text = page.read_text("utf-8").partition('id="board">')[2]
    return json.loads(text[: text.index("</script>")])


# --- drawn as a student would


@pytest.mark.parametrize("name", [pytest.param("ex3-1", marks=pytest.mark.further), "ex3-7", "ex3-2"])
def test_drawn_with_the_pointer(name, browsing: Browsing, pages, tmp_path):
    page = browsing.open(pages(name), viewport=WIDE)
    problem = problem_of(name)
    path = worked_out(page, problem, tmp_path)
    assert path.name == "20270001.svg"
    root = ET.fromstring(path.read_text("utf-8"))
    assert_drawn(root, problem)
    marks = (each for each in root.iter() if each.get("class") in ("vector", "point", "construction"))
    assert not any("transform" in mark.attrib for mark in marks)
    record = json.loads(next(each.text for each in root.iter() if each.get("id") == "graphkin-board"))
    assert record["problem"]["student"] == "20270001"
    assert [step["step"] for step in record["steps"]] == [*range(1, len(record["steps"]) + 1)]
    assert all(term["direction"] and term["magnitude"] for one in record["equations"] for term in one["terms"])
    assert_full_marks(marked_by(judge_of(name), path))
    again = browsing.open(pages(name), viewport=WIDE)
    again.locator("#file").set_input_files(path)
    again.wait_for_function("document.querySelectorAll('line.vector').length > 2")
    assert json_of(Student(again, problem).hand_in(tmp_path / "again")) == record


@pytest.mark.many(5)
@pytest.mark.parametrize("family", ["crosshead", "on_the_rim", "pinion_drives", "rack_in_a_slot", "road"])
def test_random_mechanisms_are_drawn_with_the_pointer(family, browsing: Browsing, tmp_path):
    """Their files ask for nothing: what counts is what the board has boxes for."""
    mechanism = loads(FAMILIES[family](SEED))
    (tmp_path / "board.html").write_text(board_page(mechanism, "en"), "utf-8")
    page = browsing.open(tmp_path / "board.html", viewport=WIDE)
    problem = drawn_problem(mechanism, "en")
    path = worked_out(page, problem, tmp_path)
    assert_drawn(ET.fromstring(path.read_text("utf-8")), problem, least=2)
    assert_full_marks(marked_by(mechanism, path))


def worked_out(page, problem, folder: Path) -> Path:
    student = Student(page, problem)
    student.draw()
    student.fill_equations()
    student.fill_answers()
    return student.hand_in(folder, "20270001")


def assert_full_marks(marked) -> None:
    assert (marked.score, marked.faults, marked.step) == (1, (), None)


@pytest.mark.parametrize("change", [{"tool": "zzz"}, {"name": 5}, {"tool": "parallel", "point": "q"}])
def test_a_file_that_cannot_be_drawn_leaves_the_work_as_it_was(change, browsing: Browsing, pages, tmp_path):
    page, path = browsing.open(pages("ex3-1"), viewport=WIDE), tmp_path / "other.svg"
    student = Student(page, problem_of("ex3-1"))
    student.tool("line")
    student.drag("velocity", 0j, 30 + 20j)
    handed_in = student.hand_in(tmp_path).read_text("utf-8")
    record = json.loads(re.search(r'id="graphkin-board">(.*?)</metadata>', handed_in)[1])
    record["steps"][0] |= change
    root = ET.Element("svg", xmlns="http://www.w3.org/2000/svg")
    ET.SubElement(root, "metadata", id="graphkin-board").text = json.dumps(record)
    ET.ElementTree(root).write(path)
    before = steps_of(page)
    page.locator("#file").set_input_files(path)
    page.wait_for_function("document.querySelector('#said').textContent.includes('other.svg')")
    assert page.locator("#said").text_content() == "other.svg is no file of a drawing board."
    assert steps_of(page) == before
    page.reload()
    assert steps_of(page) == before


def marked_by(judge, path: Path):
    (graded,) = grade(judge, path)
    assert graded.marked is not None
    return graded.marked


MISTAKES = {
    "driver-reversed": ("ex3-1", "velocity", 1, StudentHand(arrows={"v_B2": -1})),
    "sliding-across": ("ex3-1", "velocity", 4, StudentHand(turned={("b3", "b2"): 1j})),
    "velocity-along-link": ("ex3-7", "velocity", 14, StudentHand(turned={("e", "d"): 1j})),
    "normal-not-laid-off": ("ex3-1", "acceleration", 7, StudentHand(through_others={("b3'", "n3'"): "p'"})),
    "normal-outward": ("ex3-1", "acceleration", 3, StudentHand(arrows={"a^n_B3D": -1})),
    "coriolis-reversed": ("ex3-1", "acceleration", 5, StudentHand(sizes={"Coriolis": -1})),
    "coriolis-half": ("ex3-1", "acceleration", 5, StudentHand(sizes={"Coriolis": 0.5})),
    "image-mirrored": ("ex3-5", "velocity", 10, StudentHand(mirrored=frozenset({"e", "e'"}))),
}
"""By name: the board, the polygon, the first wrong step, the hand."""


@pytest.mark.parametrize("id", MISTAKES)
def test_mistakes_of_the_pointer_are_named(id, browsing: Browsing, pages, tmp_path):
    name, plane, step, hand = MISTAKES[id]
    student = Student(browsing.open(pages(name), viewport=WIDE), problem_of(name), hand)
    student.polygon(plane)
    marked = marked_by(judge_of(name), student.hand_in(tmp_path, "20270002"))
    assert marked.step is not None
    assert marked.step.step == step
    assert id in {each for one in marked.diagnosis.explanations for each in one.ids}


def test_wrong_choices_of_an_equation_are_named(browsing: Browsing, pages, tmp_path):
    student = Student(browsing.open(pages("ex3-1"), viewport=WIDE), problem_of("ex3-1"))
    wrong = {("a^k_B3B2", "direction"): "parallel BC", ("v_B3B2", "magnitude"): "0"}
    student.fill_equations(wrong)
    faults = marked_by(judge_of("ex3-1"), student.hand_in(tmp_path, "20270002")).faults
    assert {(each.term, each.row): each.written for each in faults} == wrong


def json_of(path: Path) -> dict[str, object]:
    root = ET.fromstring(path.read_text("utf-8"))
    return json.loads(next(each.text for each in root.iter() if each.get("id") == "graphkin-board"))


def assert_drawn(root: ET.Element, problem, least: int = 4) -> None:
    """Every arrow of the file lies as the construction has it."""
    count = 0
    for line in (each for each in root.iter() if each.get("class") == "vector"):
        plane, plot = line.get("data-plane"), problem.drawing.plot
        tail, head = (place(plot.points(plane)[line.get(f"data-{end}")]) for end in ("tail", "head"))
        x1, y1, x2, y2 = (float(line.get(key)) for key in ("x1", "y1", "x2", "y2"))
        drawn = complex(x2 - x1, y1 - y2) * problem.scales[plane]
        assert abs(drawn - (head - tail)) < 0.05 * problem.scales[plane], line.get("data-name")
        count += 1
    assert count >= least


# --- hands


def steps_of(page) -> list[dict[str, object]]:
    key = page.evaluate("Object.keys(localStorage).find((key) => key.startsWith('graphkin board'))")
    return json.loads(page.evaluate("(key) => localStorage.getItem(key)", key))["steps"]


def test_two_clicks_draw_and_undo_takes_back(browsing: Browsing, pages):
    page = browsing.open(pages("ex3-1"), viewport=WIDE)
    student = Student(page, problem_of("ex3-1"))
    student.tool("line")
    student.click("velocity", 0j)
    student.click("velocity", 30 + 20j)
    student.drag("velocity", 30j, 40 - 10j)
    student.tool("point", name="c")
    student.click("velocity", 18 + 12.6j)  # near the crossing
    assert [step["tool"] for step in steps_of(page)] == ["line", "line", "point"]
    (x, y) = steps_of(page)[2]["at"][0]
    assert abs(complex(x, y) - (18 + 12j)) < 0.3
    student.tool("parallel")
    student.click("velocity", 10 + 20j)  # the second line, which has no name
    student.click("velocity", 0j)
    assert steps_of(page)[3]["line"] == "step 2"
    student.tool("erase")
    student.click("velocity", 24 + 16j)
    assert steps_of(page)[2]["line"] == "step 1"
    for _ in range(2):
        student.tool("undo")
    student.tool("erase")
    student.click("velocity", 10 + 20j)
    assert [step["tool"] for step in steps_of(page)] == ["line", "point"]
    student.tool("undo")
    student.tool("undo")
    assert [step["tool"] for step in steps_of(page)] == ["line", "line"]
    page.reload()  # what was drawn is kept
    assert page.locator('svg[data-plane="velocity"] line.construction').count() == 2


def test_two_tabs_draw_the_same_work(browsing: Browsing, pages):
    one = browsing.open(pages("ex3-1"), viewport=WIDE)
    other = one.context.new_page()
    other.goto(one.url)
    problem = problem_of("ex3-1")
    for page, end in ((one, 30 + 20j), (other, 40 - 10j)):
        page.bring_to_front()
        student = Student(page, problem)
        student.tool("line")
        student.drag("velocity", 0j, end)
    one.wait_for_function("document.querySelectorAll('svg[data-plane=velocity] line.construction').length === 2")
    assert len(steps_of(one)) == 2
    other.close()


def test_work_that_the_browser_does_not_keep_is_told(browsing: Browsing, pages):
    page = browsing.open(pages("ex3-1"), viewport=WIDE)
    page.evaluate("() => { Storage.prototype.setItem = () => { throw new DOMException('full', 'QuotaExceededError'); }; }")
    student = Student(page, problem_of("ex3-1"))
    student.tool("line")
    student.drag("velocity", 0j, 30 + 20j)
    assert page.locator('svg[data-plane="velocity"] line.construction').count() == 1
    assert page.locator("[role=alert]").inner_text().startswith("This browser does not keep your work.")
    page.reload()
    page.locator('[data-field="student"]').fill("7")
    assert page.locator("[role=alert]").is_hidden()


def test_a_file_gives_only_what_has_its_form(browsing: Browsing, pages, tmp_path):
    page = browsing.open(pages("ex3-1"), viewport=WIDE)
    held = json.loads(page.locator("#board").text_content())
    record = {"kind": "graphkin board", "problem": held["problem"], "answers": {"omega 3": {"value": 5, "sense": "clockwise"}, "x": None},
              "equations": {"a": 1}, "scales": {"velocity": "wide", "acceleration": 0.5}, "steps": []}  # fmt: skip
    (tmp_path / "odd.svg").write_text(f'<svg><metadata id="graphkin-board">{html_text(json.dumps(record))}</metadata><g', "utf-8")
    page.locator("#file").set_input_files(tmp_path / "odd.svg")
    page.wait_for_function("document.querySelector('#said').textContent === 'odd.svg is opened.'")
    assert (page.input_value('[data-answer="omega 3"]'), page.input_value('[data-sense="omega 3"]')) == ("", "clockwise")
    assert (page.input_value('[data-scale="velocity"]'), page.input_value('[data-scale="acceleration"]')) == ("", "0.5")
    handed = json_of(Student(page, problem_of("ex3-1")).hand_in(tmp_path))
    assert handed["equations"] == held["empty"]["equations"]


def test_rulers_read_and_papers_move(browsing: Browsing, pages):
    page = browsing.open(pages("ex3-1"), viewport=WIDE)
    student = Student(page, problem_of("ex3-1"))
    student.tool("measure")
    points = {name: complex(*at) for name, at in student.said["given"]["points"].items()}
    student.drag("position", points["B"], points["D"])  # 115.33 mm on paper, at 0.6 mm each
    assert page.locator("#said").text_content() == "B D: 115.3 mm, by the scale 0.06918 m"
    student.tool("protractor", angle="30")
    student.click("velocity", 0j)
    student.tool("compass", length="40")
    student.click("velocity", 0j)
    student.tool("point", name="b")
    student.click("velocity", 35 + 20.5j)
    assert steps_of(page)[2]["at"][0] == pytest.approx([34.641, 20], abs=1e-3)
    student.tool("protractor", angle="")
    student.drag("velocity", 0j, 34.641 + 20j)
    assert page.locator("#said").text_content() == "p b: 30.0° to +x"
    paper = page.locator('svg[data-plane="velocity"]')
    before = paper.get_attribute("viewBox")
    page.mouse.move(*student.pixel("velocity", 20 + 10j))
    page.keyboard.down("Control")
    page.mouse.wheel(0, -200)
    page.keyboard.up("Control")
    page.wait_for_function(
        "([paper, before]) => paper.getAttribute('viewBox') !== before", arg=[paper.element_handle(), before]
    )
    student.tool("pan")
    near = paper.get_attribute("viewBox")
    student.drag("velocity", 10 + 10j, 20 + 15j)
    assert paper.get_attribute("viewBox") != near
    assert len(steps_of(page)) == 3


def test_keys_reach_everything(browsing: Browsing, pages):
    page = browsing.open(pages("ex3-1"), viewport=WIDE)
    page.locator('[data-tool="perpendicular"]').focus()
    page.keyboard.press("Enter")
    page.locator('[data-field="line"]').select_option("BD")
    page.locator('svg[data-plane="velocity"]').focus()
    page.keyboard.press("n")
    page.keyboard.press("Enter")
    page.locator('[data-tool="line"]').press("Enter")
    page.locator('svg[data-plane="velocity"]').focus()
    for key in ("Enter", "Shift+ArrowRight", "ArrowUp", "Alt+ArrowUp", "Enter"):
        page.keyboard.press(key)
    first, second = steps_of(page)
    assert (first["tool"], first["line"], first["point"]) == ("perpendicular", "BD", [0, 0])
    assert second["at"][1] == pytest.approx([10, 1.1], abs=0.01)
    assert page.locator("#steps-velocity li").count() == 2
    page.keyboard.press("Control+z")
    assert len(steps_of(page)) == 1


def test_languages_and_screen_readers(browsing: Browsing, pages):
    page = browsing.open(pages("ex3-7"), viewport=WIDE)
    page.locator("details").first.evaluate("(each) => { each.open = true; }")
    assert axe(page) == []
    page.locator('[data-action="language"]').click()
    assert page.locator('[data-tool="perpendicular"]').text_content() == "垂线"
    assert page.locator(".told:visible h1").text_content() == drawn_problem(load("ex3-7"), "zh").title
    assert "Mechanism" not in page.locator("#figure").text_content()  # the page's own heading says it
    assert axe(page) == []


def test_on_a_phone(browsing: Browsing, pages):
    page = browsing.open(pages("ex3-1"), viewport=PHONE, has_touch=True)
    assert page.evaluate("document.documentElement.scrollWidth") <= PHONE["width"]
    paper = page.locator('svg[data-plane="velocity"]')
    paper.scroll_into_view_if_needed()
    box = paper.bounding_box()
    for part in (0.5, 0.8):
        page.touchscreen.tap(box["x"] + part * box["width"], box["y"] + box["height"] / 2)
    (line,) = steps_of(page)
    assert line["at"][0] == [0, 0]  # a finger near the pole means the pole
    assert abs(line["at"][1][0] - 84) < 1


def test_two_fingers_move_the_paper_and_draw_nothing(browsing: Browsing, pages):
    page = browsing.open(pages("ex3-1"), viewport=PHONE, has_touch=True)
    paper = page.locator('svg[data-plane="velocity"]')
    paper.scroll_into_view_if_needed()
    box, fingers = paper.bounding_box(), page.context.new_cdp_session(page)
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2

    def touch(kind: str, *places: tuple[float, float]) -> float:
        at = [{"x": x + aside, "y": y + down, "id": k} for k, (aside, down) in enumerate(places)]
        fingers.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": at})
        return float(paper.get_attribute("viewBox").split()[2])

    whole = touch("touchStart", (-20, 0))
    assert touch("touchStart", (-20, 0), (20, 0)) == whole
    near = touch("touchMove", (-60, 0), (60, 0))
    assert near == pytest.approx(whole / 3, rel=0.02)  # as the fingers part
    touch("touchMove", (-60, 30), (60, 30))
    touch("touchEnd")
    assert paper.locator(".drawn .construction").count() == 0
    assert touch("touchStart", (0, 0)) == near
    touch("touchMove", (50, 20))
    touch("touchEnd")
    assert paper.locator(".drawn .construction").count() == 1  # one finger draws


def test_printed_in_true_millimetres(browsing: Browsing, pages):
    page = browsing.open(pages("ex3-1"), viewport=WIDE)
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.emulate_media(media="print")
    matrix = page.locator('svg[data-plane="velocity"]').evaluate("(each) => each.getScreenCTM().a")
    assert abs(matrix - 96 / 25.4) < 0.05
