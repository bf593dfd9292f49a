"""The quiz as a student takes it, with the pointer and with keys."""

from __future__ import annotations

import json
import math
import re

import pytest
from browsing import Browsing, axe

WIDE = {"width": 1280, "height": 860}
PHONE = {"viewport": {"width": 390, "height": 844}, "has_touch": True, "is_mobile": True, "device_scale_factor": 2}


def data_of(path) -> dict:
    text = path.read_text("utf-8")
    return json.loads(re.search(r'<script type="application/json" id="mechanisms">(.*?)</script>', text)[1])[0]["quiz"]


def drag(page, angle: float) -> None:
    """The handle of the direction, about its point."""
    box = page.locator(".quiz-handle").bounding_box()
    line = page.locator(".quiz-line")
    x, y = page.evaluate("""line => { const m = line.getScreenCTM(), at = line.parentNode.dataset.quizDirection === 'line'
        ? new DOMPoint((line.x1.baseVal.value + line.x2.baseVal.value) / 2, (line.y1.baseVal.value + line.y2.baseVal.value) / 2)
        : new DOMPoint(line.x1.baseVal.value, line.y1.baseVal.value), p = at.matrixTransform(m); return [p.x, p.y] }""", line.element_handle())
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.mouse.move(x + 60 * math.cos(math.radians(angle)), y - 60 * math.sin(math.radians(angle)), steps=3)
    page.mouse.up()


def check(page) -> str:
    page.click("[data-action=check]")
    return page.get_attribute("[data-quiz-verdict]", "data-quiz-verdict")


@pytest.fixture
def taken(browsing: Browsing, page_of):
    """The quiz of ex3-1 at its first question."""
    path = page_of("ex3-1")
    page = browsing.open(path, "#AB=200", viewport=WIDE)
    page.click("[data-action=quiz]")
    return page, data_of(path)


def test_every_question_is_answered_right(taken):
    """Directions by dragging, a degree off; values in their unit and with their sense."""
    page, data = taken
    for number, question in enumerate(data["questions"]):
        assert page.get_attribute("[data-quiz-question]", "data-quiz-question") == str(number)
        if question["kind"] == "value":
            page.fill("[data-quiz-number]", f"{abs(question['right']):.4g}".replace(".", ","))
            page.select_option("[data-quiz-unit]", question["unit"])
            if question["sense"] == "turn":
                page.select_option("[data-quiz-sense]", "ccw" if question["right"] > 0 else "cw")
        else:
            drag(page, question["right"] + 1)
        assert check(page) == "right", question
        shown = page.locator(f"[data-step='{question['act']}']").first
        assert shown.evaluate("e => !e.classList.contains('later')")
        page.click("[data-action=next-question]")
    count = len(data["questions"])
    assert re.findall(r"\d+", page.inner_text("[data-quiz-score]")) == [str(count), str(count)]
    assert page.locator(".quizzing").count() == 0


def test_wrong_answers_are_told_in_the_words_of_mistakes(taken):
    page, data = taken
    for question in data["questions"]:
        value, numbers = question["wrong"][0]
        if question["kind"] == "value":
            page.fill("[data-quiz-number]", f"{abs(value):.10f}")
            page.select_option("[data-quiz-unit]", question["unit"])
            if question["sense"] == "turn":
                page.select_option("[data-quiz-sense]", "ccw" if value > 0 else "cw")
        else:
            page.fill("[data-quiz-angle]", str(value))
        assert check(page) == "wrong"
        told = page.locator("[data-quiz-mistake]").evaluate_all("all => all.map(e => Number(e.dataset.quizMistake))")
        assert told == numbers, question["name"]
        page.click("[data-action=next-question]")


def test_what_is_missing_is_asked_for_and_nothing_is_given_away(taken):
    page, data = taken
    act = data["questions"][0]["act"]
    later = page.locator(f".velocity [data-step='{act}'], .acceleration [data-step]")
    assert later.count() > 5
    assert later.evaluate_all("all => all.every(e => getComputedStyle(e).display === 'none')")
    assert page.locator(".results, .steps, .told, .handle").evaluate_all("all => all.every(e => e.getClientRects().length === 0)")
    page.fill("[data-quiz-angle]", "")
    assert check(page) == "unread"
    page.keyboard.press("PageDown")
    assert later.evaluate_all("all => all.every(e => getComputedStyle(e).display === 'none')")
    value = next(k for k, question in enumerate(data["questions"]) if question["kind"] == "value")
    for _ in range(value):
        page.click("[data-action=next-question]")
    for field, entry in (("number", "3.9"), ("unit", "rad/s"), ("sense", "cw")):
        assert check(page) == "unread"
        locator = page.locator(f"[data-quiz-{field}]")
        locator.fill(entry) if field == "number" else locator.select_option(entry)
    assert check(page) == "right"
    page.select_option("[data-quiz-unit]", "m/s")
    assert check(page) == "wrong"


def test_keys_turn_a_direction_and_languages_switch(taken):
    page, _ = taken
    page.focus(".quiz-handle")
    page.keyboard.press("ArrowLeft")
    page.keyboard.press("PageUp")
    assert page.input_value("[data-quiz-angle]") == page.get_attribute(".quiz-handle", "aria-valuenow") == "11"
    page.click("[data-action=language]")
    assert "方向" in page.inner_text(".quiz") or "矢量" in page.inner_text(".quiz")
    page.click("[data-action=show-answer]")
    assert re.search("[一-鿿]", page.inner_text("[data-quiz-answer]"))
    page.click("[data-action=leave-quiz]")
    assert page.locator(".results").is_visible()


@pytest.mark.parametrize("name", ["s4-ex2", "fig3-4"])
def test_what_is_turned_is_always_in_view(name, browsing: Browsing, page_of):
    """Also where the pole is near the edge of its paper, whatever way it points."""
    page = browsing.open(page_of(name), viewport=WIDE)
    page.click("[data-action=quiz]")
    for angle in (45, 135, 225, 315):
        page.fill("[data-quiz-angle]", str(angle))
        assert page.evaluate("""() => { const [e, p] = ['.quiz-handle', '.quiz-direction'].map(s => document.querySelector(s));
            const [a, b] = [e, p.ownerSVGElement].map(each => each.getBoundingClientRect());
            return a.left >= b.left && a.right <= b.right && a.top >= b.top && a.bottom <= b.bottom }"""), angle


def test_on_a_phone(browsing, page_of):
    page = browsing.open(page_of("ex3-1"), **PHONE)
    page.click("[data-action=quiz]")
    assert axe(page) == []
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    drag(page, 150)
    assert check(page) == "right"
    assert axe(page) == []
