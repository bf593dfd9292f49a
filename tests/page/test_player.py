"""The page that plays, in a browser: dragged, by keys, step by step, in both languages, on paper and on a phone."""

from __future__ import annotations

import math
import os
import random
import re
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest
from browsing import Browsing, axe
from shown_positions import fragment, off, shown

import graphkin
from graphkin import api
from graphkin.analytic import motion
from graphkin.files import library, loads
from graphkin.model.quantities import EDGE, driven
from graphkin.page import knots, player, writer
from graphkin.page.player import play
from graphkin.page.spoken import StepWords
from graphkin.page.writer import joined
from graphkin.planning.needed import without_aids
from graphkin.running import replay_all
from graphkin.say.entry import Sentence
from graphkin.say.explained import derivation
from graphkin.sheet.paper import KEYS
from graphkin.sheet.window import PLANES

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

WIDE = {"width": 1300, "height": 850}
_GO = """hash => new Promise(done => {
  document.activeElement?.blur();
  if (location.hash === hash) return done();
  addEventListener('hashchange', done, { once: true });
  location.hash = hash;
})"""


@pytest.fixture(scope="module")
def ex3_7(browser: Browser, page_of) -> Iterator[Callable[[str], Page]]:
    """The page of a six-bar, opened once, at any hash; the language is English where the hash names none."""
    browsing = Browsing(browser)
    page = browsing.open(page_of("ex3-7"), viewport=WIDE)

    def at_hash(fragment: str) -> Page:
        page.set_viewport_size(WIDE)
        page.emulate_media(media="null", reduced_motion="null")
        page.evaluate(_GO, fragment if "lang=" in fragment else f"{fragment}&lang=en")
        return page

    yield at_hash
    browsing.close()
    assert not browsing.faults


def at(page) -> float:
    return float(page.input_value("input.value"))


def centre(page, locator: str) -> tuple[float, float]:
    box = page.locator(locator).bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


# --- positions ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", library.names() if "GRAPHKIN_RANDOM" in os.environ else ["ex3-7", "ex3-3", "s4-ex2"])
def test_vectors_and_points_are_where_the_analysis_has_them(name, browsing: Browsing, page_of):
    """Ten places of the hash, in the library's every page with GRAPHKIN_RANDOM in the environment; else of a six-bar, of
    gears from more than a turn away to a dead point, of a rolling wheel between dead points."""
    machine, rng = api.load(name), random.Random(name)
    page, seen = browsing.open(page_of(name), viewport=WIDE), 0
    bars = [bar.evaluate("each => [Number(each.min), Number(each.max)]") for bar in page.locator("input[data-driver]").all()]
    units = [EDGE[driven(driver.kind == "slide")].factor for driver in machine.drivers]
    for _ in range(10):
        values = tuple(rng.uniform(*ends) / unit for ends, unit in zip(bars, units, strict=True))
        page.evaluate(_GO, fragment(machine, values))
        planes = shown(page)
        assert planes or len(values) > 1
        worst = off(machine, values, planes) if planes else {}
        assert max(worst.values(), default=0.0) < 0.02, max(worst, key=worst.get)
        seen += len(worst)
    assert seen > 150


# --- driving ------------------------------------------------------------------------------------------------------


def test_the_crank_pin_is_dragged_and_everything_follows(ex3_7):
    page = ex3_7("#AB=30")
    pivot, pin = centre(page, ".point[data-name='A']"), centre(page, ".handle[data-driver='AB']")
    arm, before = math.dist(pivot, pin), page.inner_text("[data-result='omega 3']")
    page.mouse.move(*pin)
    page.mouse.down()
    for angle in range(30, 141, 10):
        page.mouse.move(pivot[0] + 1.3 * arm * math.cos(math.radians(angle)), pivot[1] - 1.3 * arm * math.sin(math.radians(angle)))
    page.mouse.up()
    page.wait_for_function("() => Math.abs(document.querySelector('input.value').value - 140) < 1.5")
    assert "AB=1" in page.url
    assert page.inner_text("[data-result='omega 3']") != before
    assert max(off(api.load("ex3-7"), (math.radians(at(page)),), shown(page)).values()) < 0.05  # the angle is printed to 0.001
    assert math.dist(centre(page, ".handle[data-driver='AB']"), centre(page, ".point[data-name='B']")) < 1


@pytest.mark.parametrize("nothing", ["", "NaN", "1e400", "<b>"])
def test_a_hash_that_is_no_number_leaves_the_driver_where_it_is(nothing, ex3_7):
    before = at(ex3_7("#AB=70"))
    assert at(ex3_7(f"#AB={nothing}&step=-3")) == before == 70


def test_keys_drive_and_step(ex3_7):
    page = ex3_7("#AB=359")
    for key, place in (("ArrowRight", 0), ("ArrowRight", 1), ("Shift+ArrowLeft", 0.9)):
        page.keyboard.press(key)
        page.wait_for_function(f"() => Math.abs(document.querySelector('input.value').value - {place}) < 1e-6")
    page.focus("input[type=range]")
    page.keyboard.press("ArrowLeft")
    page.wait_for_function("() => Math.abs(document.querySelector('input.value').value - 359.9) < 1e-6")
    page.keyboard.press("PageDown")
    assert page.locator("[data-step-sentence]").count() == 1
    page.evaluate("() => document.activeElement.blur()")  # on a bar Home goes to its end
    page.keyboard.press("Home")
    assert page.locator("[data-step-sentence]").count() == 0
    page.click("[data-action=run]")
    before = at(page)
    page.wait_for_function(f"() => Math.abs(document.querySelector('input.value').value - {before}) > 2")
    page.click("[data-action=run]")


def test_a_field_left_empty_shows_the_driver_again(ex3_7):
    page = ex3_7("#AB=70")
    page.fill("input.value", "")
    page.keyboard.press("Tab")
    assert page.input_value("input.value") == "70"


def test_a_step_of_the_hash_that_is_not_told_is_the_next(browsing: Browsing, page_of):
    page = browsing.open(page_of("ex3-7"), "#step=999", viewport=WIDE)
    last = int(re.search(r"step=(\d+)", page.url)[1])
    assert page.locator("[data-step-sentence]").count() == 1
    assert last < 30


def test_dead_points_at_both_ends_are_said(browsing: Browsing, page_of):
    page = browsing.open(page_of("s4-ex2"), "#wall=5000", viewport=WIDE)
    assert "dead point" in page.inner_text(".event")
    assert at(page) == pytest.approx(float(page.get_attribute("input[type=range]", "max")), abs=1e-3)
    page.evaluate("() => { location.hash = '#wall=-5000&lang=zh' }")
    page.wait_for_selector(".event:has-text('死点')")
    assert page.locator(".tick").count() == 2


_PARALLELOGRAM = """
ask = ["omega 4"]
frame = {A = [0, 0], D = [60, 0]}
links = {2 = {AB = 30}, 3 = {BC = 60}, 4 = {DC = 30}}
driver = [{vector = "AB", angle = 70, omega = 10}]
sketch = {C = [70, 28]}
"""


def test_change_points_are_said_and_passed(browsing: Browsing, tmp_path, monkeypatch):
    monkeypatch.setattr(player, "_TOLD", 12)  # its steps are not read
    machine = loads(_PARALLELOGRAM)
    (tmp_path / "page.html").write_text(play(api.plan(machine)).text, "utf-8")
    page = browsing.open(tmp_path / "page.html", "#AB=180", viewport=WIDE)
    assert page.inner_text(".event").startswith("Change point at AB = 180°: links 3 and 4 lie in line")
    for degrees in (178, 182):  # link 4 goes on with the crank, it does not turn back
        page.evaluate(_GO, f"#AB={degrees}&lang=en")
        assert page.inner_text("[data-result='omega 4']") == "10 rad/s"
        assert max(off(machine, (math.radians(degrees),), shown(page)).values()) < 0.02
    page.evaluate(_GO, "#AB=90&lang=zh")
    assert page.inner_text(".event") == ""


def test_a_finger_drags_the_crank_pin(browsing: Browsing, page_of):
    phone = {"viewport": {"width": 390, "height": 844}, "has_touch": True, "is_mobile": True}
    page = browsing.open(page_of("ex3-7"), "#AB=30", **phone)
    pivot, pin = centre(page, ".point[data-name='A']"), centre(page, ".handle[data-driver='AB']")
    arm = math.dist(pivot, pin)
    fingers = page.context.new_cdp_session(page)
    for kind, angle in [("touchStart", 30), *(("touchMove", angle) for angle in range(40, 121, 10)), ("touchEnd", None)]:
        place = [] if angle is None else [{"x": pivot[0] + arm * math.cos(math.radians(angle)),
                                           "y": pivot[1] - arm * math.sin(math.radians(angle))}]  # fmt: skip
        fingers.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": place})
    page.wait_for_function("() => Math.abs(document.querySelector('input.value').value - 120) < 3")
    assert page.evaluate("scrollY") == 0


# --- steps --------------------------------------------------------------------------------------------------------


def sentences(lang: str, angle: float) -> dict[int, str]:
    """What explain says of each step, at the scales of the page."""
    drawing = graphkin.Drawing.of("ex3-7", angle)
    scales = {"length": 0.01, "velocity": 0.005, "acceleration": 0.006}
    entries = derivation(drawing.method, drawing.plot, scales, lang)
    return {entry.act.page: entry.text for entry in entries if isinstance(entry, Sentence) and entry.act is not None}


def letters(text: str) -> str:
    """Without signs that are set above or below, and without rounding."""
    return re.sub(r"[\s_^′'{}¹²ⁿᵗᵏʳntkr]|(?<=\d\.\d\d)\d+", "", text)


_TWO_CRANKS = """
ask = ["theta 2", "v C"]
frame = {A = [0, 0], E = [60, 0]}
links = {1 = {AB = 25}, 2 = {BC = 60}, 3 = {CD = 55}, 4 = {ED = 30}}
driver = [{vector = "AB", angle = 110, omega = 4}, {vector = "ED", angle = 60, omega = -3}]
sketch = {C = [30, 75]}
"""
_NUMBER = re.compile(r"(?<![\w.−])\d+\.?\d*(?![\w.])")


@pytest.fixture(scope="module")
def two_cranks(tmp_path_factory) -> Path:
    """A page of two drivers with few positions that are calculated."""
    path = tmp_path_factory.mktemp("cranks") / "page.html"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(knots, "_OF_SEVERAL", 800)
        patch.setattr(knots, "_OF_GRID", (10, 16))
        patch.setattr(player, "_WORD_KNOTS", 8)
        path.write_text(play(loads(_TWO_CRANKS)).text, "utf-8")
    return path


def test_between_positions_of_two_drivers_what_is_not_exact_is_said(browsing: Browsing, two_cranks: Path):
    """Neither drawn nor told, and each plane that is not there has its reason."""
    machine, rng, page = loads(_TWO_CRANKS), random.Random(3), browsing.open(two_cranks, viewport=WIDE)
    drawn, told, reasons = 0, 0, Counter[str]()
    for _ in range(15):
        values = (rng.uniform(0, 2 * math.pi), rng.uniform(0, 2 * math.pi))
        page.evaluate(_GO, f"{fragment(machine, values)}&lang=en")
        planes, exact = shown(page), motion(machine, values)
        worst = off(machine, values, planes) if planes else {}
        assert max(worst.values(), default=0.0) < 0.02, values
        drawn += len(worst)
        for name in ("theta 2", "v C"):
            if (text := page.inner_text(f"[data-result='{name}']")) != "–":
                right = math.degrees(exact.theta["2"]) % 360 if name == "theta 2" else abs(exact.velocity["C"])
                assert float(re.match(r"[\d.]+", text)[0]) == pytest.approx(right, rel=5e-3), (name, values)
                told += 1
        notes = page.locator(".figure .note:visible").all_inner_texts()
        assert len(planes) + len(notes) == len(PLANES)
        reasons.update(notes)
    assert drawn > 50
    assert told > 5
    assert any("between the calculated positions" in text for text in reasons)


def test_two_drivers_are_told_what_is_known_well_enough(browsing: Browsing, two_cranks: Path):
    """All numbers at the drawn position; between the positions that are calculated those that are sure, and no others."""
    method = without_aids(api.plan(loads(_TWO_CRANKS)))
    page = browsing.open(two_cranks, viewport=WIDE)
    scales = [float(page.get_attribute(f"svg.drawing[data-plane={plane}]", "data-scale")) for plane in PLANES]
    words = StepWords(method, dict(zip(KEYS.values(), scales, strict=True)))
    for degrees in ((110, 60), (142.58, 55.79), (351, 288.16)):
        plot = replay_all(method, np.radians(degrees))
        told, missing = 0, 0
        for step, entries in words.at(plot, "en").items():
            page.evaluate(_GO, f"#AB={degrees[0]}&ED={degrees[1]}&step={step}&lang=en")
            text = page.inner_text(".step-text")
            right = [abs(value) for entry in entries for value in entry.numbers]
            right += [float(each) for entry in entries for each in _NUMBER.findall(str(entry.words))]
            for number in map(float, _NUMBER.findall(text)):
                assert any(abs(number - each) <= 0.005 * each for each in right), (degrees, step, number, text)
                told += 1
            missing += text.count("= –") + text.count("– ×")
        assert told > 60
        assert (missing == 0) == (degrees == (110, 60)), missing


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_steps_go_both_ways_in_the_words_of_explain(lang, ex3_7):
    page, right = ex3_7(f"#AB=61.3&step=1&lang={lang}"), sentences(lang, 61.3)
    told = {}
    for _ in right:
        step = int(re.search(r"step=(\d+)", page.url)[1])
        told[step] = page.inner_text("[data-step-sentence]")
        assert page.evaluate("step => [...document.querySelectorAll('.drawing [data-step]')].every(e => (Number(e.dataset.step) > step)"
                             " === (getComputedStyle(e).display === 'none' && e.classList.contains('later')))", step)  # fmt: skip
        page.click("[data-action=next]")
    assert {step: letters(text) for step, text in told.items()} == {step: letters(text) for step, text in right.items()}
    for step in sorted(right, reverse=True)[1:]:
        page.click("[data-action=back]")
        assert f"step={step}" in page.url
        assert page.inner_text("[data-step-sentence]") == told[step]


def test_words_and_arrows_light_up_together(ex3_7):
    page = ex3_7("#AB=60&step=6")
    term = page.locator(".step-text .term[data-vector='v_B3B2']").first
    term.hover()
    assert page.locator("g.arrow.lit line.vector").get_attribute("data-name") == "v_B3B2"
    page.locator("g.arrow[data-vector='v_B3'] .vector").hover()
    assert page.locator(".step-text .term.lit").first.get_attribute("data-vector") == "v_B3"
    size = float(re.search(r"([\d.]+) m/s", page.inner_text(".told"))[1])
    right = next(v for v in shown(page) if v["plane"] == "velocity")
    x1, y1, x2, y2 = next(m["at"] for m in right["marks"] if m["data"]["data-name"] == "v_B3")
    assert size == pytest.approx(math.dist((x1, y1), (x2, y2)) * right["scale"], rel=1e-3)


# --- everywhere ---------------------------------------------------------------------------------------------------


def test_a_lecture_in_both_languages(browsing: Browsing, page_of):
    page = browsing.open(page_of("ex3-7", "s4-ex2"), "#lang=en", viewport=WIDE)
    assert page.locator("#contents li").count() == 2
    page.click("#contents summary")
    page.click("#contents [data-show='s4-ex2']")
    page.wait_for_selector("#contents [data-show='s4-ex2'][aria-current]")
    title = page.inner_text("h1")
    page.click("[data-action=language]")
    assert page.inner_text("h1") != title
    assert re.search("[\u4e00-\u9fff]", page.inner_text("h1"))
    assert page.get_attribute("html", "lang") == "zh-CN"
    assert "lang=zh" in page.url
    assert "show=s4-ex2" in page.url
    again = browsing.open(page_of("ex3-7", "s4-ex2"), "#" + page.url.partition("#")[2], viewport=WIDE)
    assert again.inner_text("h1") == page.inner_text("h1")


def test_a_watched_page_is_read_again_while_nobody_works_on_it(browsing: Browsing, tmp_path, monkeypatch):
    """At the same hash; not under a hand. Every 0.2 s here, not every two."""
    own = writer.joined(["watched"])
    assert own.count("2000") == 1
    monkeypatch.setattr(writer, "joined", lambda names: own.replace("2000", "200") if names == ["watched"] else joined(names))
    path, text = tmp_path / "page.html", writer.page("one", "en", scripts=["words"], styles=[], data={"words": {}})
    writer.write(path, writer.watched(text))
    page = browsing.open(path, "#AB=70")
    writer.write(path, writer.watched(text.replace("<title>one", "<title>two")))
    page.wait_for_function("() => document.title === 'two'")
    assert page.url.endswith("#AB=70")
    page.mouse.click(100, 100)
    page.evaluate("window.isSame = true")
    page.wait_for_timeout(500)
    assert page.evaluate("window.isSame")
    page.evaluate("dispatchEvent(new Event('blur'))")
    page.wait_for_function("() => !window.isSame")


def test_it_is_printed_to_scale(ex3_7):
    page = ex3_7("#AB=100")
    page.emulate_media(media="print")
    for plane in ("position", "velocity", "acceleration"):
        box, view = page.locator(f"svg.drawing[data-plane={plane}]").evaluate(
            "e => [e.getBoundingClientRect().width / 96 * 25.4, e.viewBox.baseVal.width]")  # fmt: skip
        assert box == pytest.approx(view, abs=0.05), plane
    assert not page.is_visible(".handle")


@pytest.mark.parametrize("size", [(390, 844), (844, 390), (1300, 850)], ids=["upright", "across", "wide"])
def test_it_fits_any_screen_and_reader(size, ex3_7):
    page = ex3_7("#AB=100&step=9")
    page.set_viewport_size({"width": size[0], "height": size[1]})
    page.emulate_media(reduced_motion="reduce")
    assert page.evaluate("() => document.documentElement.scrollWidth <= innerWidth")
    assert page.locator("svg.drawing[data-plane=position]").bounding_box()["height"] > 120
    assert page.locator("input[type=range]").bounding_box()["y"] < size[1]
    assert axe(page) == []
