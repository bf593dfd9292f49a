"""The page to look at photographs, as a teacher uses it: points moved, ticked, and saved for `grade`."""

from __future__ import annotations

from pathlib import Path

import pytest
from browsing import Browsing, axe

from graphkin.errors import NOWHERE
from graphkin.outputs.sheets_json import is_readings, read_readings
from graphkin.page.confirm import write_page
from graphkin.photo.readings import RoomReading, SheetReading
from graphkin.photo.sheets import PrintedSheet, SheetRoom, Unsure

ROOM = SheetRoom("velocity", 1, 100 + 100j, 20 + 50j, 180 + 170j, 0.01)
LINES = (("p", "b"), ("p", "c"), ("b", "c"))


def reading(number: int, unsure: tuple[Unsure, ...] = ()) -> SheetReading:
    sheet = PrintedSheet(number, "ex3-5", f"s{number}", 210.0, 297.0, (ROOM,))
    points, shifts = {"p": 0j, "b": 40 + 10j, "c": 30 - 20j}, tuple(dict.fromkeys(one.letters, 0.3 + 0.1j) for one in unsure)
    room = RoomReading(ROOM, points, ("p", "b", "c"), LINES, 0.1, unsure, shifts)
    return SheetReading(sheet, sheet.student, f"IMG_{number}.jpg", (room,))


@pytest.fixture
def path(tmp_path: Path) -> Path:
    path = tmp_path / "look.html"
    write_page(path, [reading(7), reading(8, (Unsure("short", ("c",)),))], [], {"s8": "Li Lei"}, "en")
    return path


def test_a_point_is_moved_ticked_and_saved(browsing: Browsing, path: Path, tmp_path: Path):
    page = browsing.open(path)
    first = page.locator("section").first  # what is unsure comes first
    assert "s8 Li Lei" in first.locator("h2").inner_text()
    assert page.locator("#count").inner_text().startswith("1 ")
    corner = first.locator('[data-letter="c"]')
    corner.focus()
    for key in ("ArrowRight", "ArrowRight", "Shift+ArrowUp"):
        page.keyboard.press(key)
    assert first.locator("input[type=checkbox]").is_checked()
    with page.expect_download() as saved:
        page.click("#save")
    file = tmp_path / "saved.json"
    saved.value.save_as(file)
    assert is_readings(file)
    by_number = {one.sheet.number: one.rooms[0] for one in read_readings(file)}
    assert by_number[8].points["c"] == pytest.approx(30.2 - 19j)
    assert by_number[8].confirmed
    assert by_number[8].unsure == by_number[8].drawing(NOWHERE).shifts == ()
    assert by_number[8].error == pytest.approx(0.15)
    assert by_number[7] == reading(7).rooms[0]


def test_a_point_is_dragged_and_taken_away(browsing: Browsing, path: Path):
    page = browsing.open(path, viewport={"width": 1000, "height": 900})
    first = page.locator("section").first
    before = first.locator('[data-letter="b"]').get_attribute("transform")
    box = first.locator('[data-letter="b"] .grip').bounding_box()
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.mouse.move(box["x"] + 60, box["y"] - 30, steps=3)
    page.mouse.up()
    assert first.locator('[data-letter="b"]').get_attribute("transform") != before
    first.locator('[data-letter="c"]').focus()
    page.keyboard.press("Delete")
    assert first.locator('[data-letter="c"]').count() == 0
    first.locator("[data-put=c]").click()
    assert first.locator('[data-letter="c"]').count() == 1


def test_in_both_languages_and_for_everybody(browsing: Browsing, path: Path):
    page = browsing.open(path)
    page.click("#language")
    assert page.get_attribute("html", "lang").startswith("zh")
    assert axe(page) == []
