"""Layers and diagrams on the page, as they are switched on and moved along."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest
from browsing import Browsing, axe

from graphkin import api
from graphkin.analytic import motion
from graphkin.files import loads
from graphkin.page import player
from graphkin.page.player import play
from graphkin.proof.readings import mechanism_at

WIDE = {"width": 1280, "height": 860}


@pytest.fixture
def page(browsing: Browsing, page_of):
    return browsing.open(page_of("fig3-4"), "#AB=100", viewport=WIDE)


def place(page, selector: str) -> complex:
    """The place of an element's own origin, or of its middle, on the mechanism's paper [mm]."""
    x, y = page.evaluate("""selector => { const e = document.querySelector(selector), m = e.closest('svg').getScreenCTM().inverse()
        .multiply(e.getScreenCTM()), p = new DOMPoint(e.cx?.baseVal.value ?? 0, e.cy?.baseVal.value ?? 0).matrixTransform(m);
        return [p.x, p.y] }""", selector)
    return complex(x, y)


def test_centres_go_along(page):
    """Hinges are centres; the others lie where velocities have them, and centrodes touch there."""
    for kind in ("centres", "centrode", "curve"):
        assert not page.locator(f"[data-shown={kind}]").first.is_visible()
        page.locator(f"[data-toggle={kind}]").first.check()
        assert page.locator(f"[data-shown={kind}]").first.is_visible()
    method = api.plan(api.load("fig3-4"))
    for degrees in (61.3, 100, 163.7):
        page.evaluate("value => { location.hash = `#AB=${value}` }", degrees)
        page.wait_for_function("value => Math.abs(document.querySelector('input[data-driver]').value - value) < 1e-3", arg=degrees)
        there = motion(mechanism_at(method, [math.radians(degrees)]))
        scale = float(page.get_attribute(".position svg", "data-scale"))
        origin = place(page, "circle.point[data-plane=position][data-name=A]")
        for name, right in (("P23", there.position["B"]), ("P13", there.position["B"] + 1j * there.velocity["B"] / there.omega["3"])):
            shown = place(page, f".centre[data-name={name}] circle") - origin
            if abs(right) / scale < 150:
                assert abs(shown - right.conjugate() / scale) < 0.02, (name, degrees)
        near = page.evaluate("""() => { const centre = document.querySelector('.centre[data-name=P13] circle');
            const at = new DOMPoint(0, 0).matrixTransform(centre.getScreenCTM());
            return [...document.querySelectorAll('.centrode-fixed path, .centrode-moving path')].map(path => {
                const m = path.getScreenCTM(), size = path.getTotalLength(); let best = Infinity;
                for (let k = 0; k <= 4000; k++) { const p = path.getPointAtLength(size * k / 4000).matrixTransform(m);
                    best = Math.min(best, Math.hypot(p.x - at.x, p.y - at.y)); } return best / Math.hypot(m.a, m.b) }) }""")
        assert len([off for off in near if off < 0.4]) >= 2, (degrees, near)


def test_diagrams_have_a_cursor(page):
    page.check("[data-toggle=diagrams]")
    names = page.locator("[data-diagram]").evaluate_all("all => all.map(e => e.dataset.diagram)")
    assert names == ["omega 4", "v E"]
    seen = []
    for degrees in (100, 250):
        page.evaluate("value => { location.hash = `#AB=${value}` }", degrees)
        page.wait_for_function("value => Math.abs(document.querySelector('input[data-driver]').value - value) < 1e-3", arg=degrees)
        value = page.inner_text("[data-diagram='omega 4'] output")
        assert value == page.inner_text("[data-result='omega 4']")
        seen.append((value, page.get_attribute("[data-diagram='omega 4'] .diagram-cursor", "x1")))
        off = page.evaluate("""() => { const figure = document.querySelector("[data-diagram='omega 4']"), dot = figure.querySelector('.diagram-dot');
            const path = figure.querySelector('.diagram-curve'), size = path.getTotalLength(); let best = Infinity;
            for (let k = 0; k <= 4000; k++) { const p = path.getPointAtLength(size * k / 4000);
                best = Math.min(best, Math.hypot(p.x - dot.cx.baseVal.value, p.y - dot.cy.baseVal.value)); } return best }""")
        assert off < 0.1
    assert seen[0] != seen[1]


def test_all_of_it_can_be_read_by_everyone(page):
    for box in page.locator(".overlays input").all():
        box.check()
    assert axe(page) == []
    page.click("[data-action=language]")
    assert "瞬心" in page.inner_text(".overlays")
    assert axe(page) == []


def test_what_is_shown_is_printed(page):
    page.check("[data-toggle=centres]")
    page.emulate_media(media="print")
    assert page.locator("[data-shown=centres]").is_visible()
    assert not page.locator(".quiz").is_visible()
    wide = page.evaluate("() => { const s = document.querySelector('.position svg'); return s.getBoundingClientRect().width / s.viewBox.baseVal.width }")
    assert abs(wide - 96 / 25.4) < 0.01


_DOUBLE_CRANK = """
ask = ["theta 4", "omega 4"]
frame = {A = [0, 0], D = [30, 0]}
links = {2 = {AB = 80}, 3 = {BC = 90}, 4 = {DC = 70}}
driver = [{vector = "AB", angle = 70, omega = 10}]
sketch = {C = [90, 40]}
"""


def test_an_angle_that_turns_on_comes_round(browsing: Browsing, tmp_path, monkeypatch):
    """Just before and after the driver has come round, where tracks go on from the last knot to the first."""
    monkeypatch.setattr(player, "_TOLD", 12)  # its steps are not read
    mechanism = loads(_DOUBLE_CRANK)
    method = api.plan(mechanism)
    (tmp_path / "page.html").write_text(play(method).text, "utf-8")
    for degrees in (0.7, 359.3):
        page = browsing.open(tmp_path / "page.html", f"#AB={degrees}")
        right = math.degrees(motion(mechanism_at(method, [math.radians(degrees)])).theta["4"]) % 360
        assert abs(float(page.inner_text("[data-result='theta 4']").strip("°")) - right) < 0.06
    page.check("[data-toggle=diagrams]")
    heights = page.evaluate("""() => { const path = document.querySelector('.diagram-curve'), size = path.getTotalLength();
        return Array.from({length: 400}, (_, k) => path.getPointAtLength(size * k / 399).y) }""")
    assert max(one - other for other, one in pairwise(heights)) < 0.01
