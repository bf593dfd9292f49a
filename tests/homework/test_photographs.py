"""Photographs of paper from the command line: drawn on, taken, measured, marked, confirmed."""

from __future__ import annotations

import json
import sys
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest
from click.testing import CliRunner

sys.path.append(str(Path(__file__).parents[1] / "photo"))

from cameras import CAMERAS
from printed_pages import Printed, photographed

from graphkin import Drawing
from graphkin.cli import main
from graphkin.marking.consequences import rewrites

pytest.importorskip("typst")

EIGHT_MILLION = replace(CAMERAS["flat"], size=(3264, 2448))
"""So many pixels are soon looked through, and enough."""
WRONG = "normal-omitted", ("a^n_CD",)
TEMPLATE = """
title = "Crank and rocker"
ask = ["omega 3", "omega 4", "v C", "alpha 4"]
frame = { A = [0, 0], D = [90, 0] }
links = { 3.BC = 80, 4.DC = 60, 2.AB = { from = 29, to = 33, step = 1 } }
driver = [{ vector = "AB", angle = 75, omega = 10 }]
sketch = { C = [90, 70] }
"""


def ran(*words: object, status: int = 0) -> str:
    done = CliRunner().invoke(main, [*map(str, words), "--lang", "en"])
    assert done.exit_code == status, (words, done.output, done.exception)
    assert "Traceback" not in done.output
    return done.output


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A set of two students, its paper, and their pictures: `one` right, of whose velocities there are two pictures; `two`
    with a mistake, upside down."""
    folder = tmp_path_factory.mktemp("photographs")
    (folder / "rocker.toml").write_text(TEMPLATE, "utf-8")
    (folder / "class.csv").write_text("id,name\none,Li Lei\ntwo,Han Mei\n", "utf-8")
    ran("problems", folder / "rocker.toml", "--students", folder / "class.csv", "-o", folder / "hw")
    ran("handout", folder / "hw", "--stage", "blank", "--scan", 100, "-o", folder / "paper.pdf")
    printed = Printed(folder / "paper.pdf", folder / "hw" / "teacher")
    (folder / "in").mkdir()
    for sheet in (sheet for sheet in printed.sheets if sheet.rooms):
        drawing = Drawing.of(str(folder / "hw" / "teacher" / f"{sheet.problem}.toml"))
        (wrong,) = (one for one in rewrites(drawing.method, drawing.plot) if one.name[::2] == WRONG)
        page, work = printed.drawn(sheet.number, 3, (wrong,) if sheet.student == "two" else ())
        assert work.fits()
        upside_down = np.pi if sheet.student == "two" else 0.0
        picture = photographed(page, camera=EIGHT_MILLION, seed=sheet.number, turned=upside_down)
        plane = sheet.rooms[0].plane
        if plane == "velocity":
            at = work.corners[plane]["c"]
            (folder / f"{sheet.student}.truth").write_text(f"{at.real} {at.imag}", "utf-8")
        names = "a" if plane != "velocity" else "b" if upside_down else "bc"
        for name in names:
            (folder / "in" / f"{name}-{sheet.number}.jpg").write_bytes(picture.content)
    return folder


@pytest.fixture(scope="module")
def records(folder: Path) -> dict[str, dict[str, object]]:
    ran("grade", folder / "hw", folder / "in", "-o", folder / "marks.json", "--confirm", folder / "look.html")
    return {one["student"]: one for one in json.loads((folder / "marks.json").read_text("utf-8"))["results"]}


def test_right_work_is_right_and_a_mistake_is_named(records):
    assert {text: one["verdict"] for text, one in records["one"]["quantities"].items() if one["points"]} == dict.fromkeys(
        ("omega 3", "omega 4", "v C", "alpha 4"), "right"
    )
    assert records["one"]["score"] == 1
    assert records["two"]["quantities"]["omega 4"]["verdict"] == "right"
    assert WRONG[0] in records["two"]["mistakes"][0]["ids"]


def test_the_record_says_what_was_measured(records, folder: Path):
    """Where the student's lines truly cross, which is not where they should."""
    for student, record in records.items():
        x, y = map(float, (folder / f"{student}.truth").read_text("utf-8").split())
        assert record["measured"]["velocity"]["c"] == pytest.approx([x, y], abs=0.3)
        assert 0 < record["error"] < 0.3
        assert isinstance(record["unsure"], list)


def test_what_was_measured_is_in_the_terminal_s_json(records, folder: Path):
    told = ran("grade", folder / "hw", folder / "marks.json", "--json")
    for line in map(json.loads, told.splitlines()):
        assert {key: line[key] for key in ("measured", "measured at", "error", "unsure")} == {
            key: records[line["student"]][key] for key in ("measured", "measured at", "error", "unsure")
        }


def test_what_is_saved_is_marked_again_without_pictures(records, folder: Path, tmp_path: Path):
    page = (folder / "look.html").read_text("utf-8")
    assert "data:image/jpeg" in page
    assert "Content-Security-Policy" in page
    held = json.loads(page.split('id="photographs">', 1)[1].split("</script>", 1)[0])["readings"]
    saved = tmp_path / "look.json"
    saved.write_text(json.dumps(held), "utf-8")
    ran("grade", folder / "hw", saved, "-o", tmp_path / "again.json", "--sheets", folder / "paper.sheets.json")
    again = {one["student"]: one for one in json.loads((tmp_path / "again.json").read_text("utf-8"))["results"]}
    for student, record in records.items():
        assert again[student]["score"] == record["score"]
    for reading in held["list"]:
        for room in reading["rooms"]:
            if reading["student"] == "one" and room["room"]["plane"] == "velocity":
                room["points"]["c"][0] += 9.0
    saved.write_text(json.dumps(held), "utf-8")
    ran("grade", folder / "hw", saved, "-o", tmp_path / "moved.json", "--sheets", folder / "paper.sheets.json")
    moved = {one["student"]: one for one in json.loads((tmp_path / "moved.json").read_text("utf-8"))["results"]}
    assert moved["one"]["score"] < records["one"]["score"]


def test_what_cannot_be_read_is_one_row(folder: Path, tmp_path: Path):
    picture = sorted((folder / "in").iterdir())[0]
    (tmp_path / "b.heic").write_bytes(b"\0\0\0\x18ftypheic\0\0\0\0mif1heic" + bytes(200))
    (tmp_path / "c.jpg").write_bytes(picture.read_bytes()[:30_000])
    blank = cv2.imencode(".png", np.full((900, 900), 255, np.uint8))[1].tobytes()
    (tmp_path / "d.png").write_bytes(blank)
    told = ran("grade", folder / "hw", tmp_path, "--sheets", folder / "paper.sheets.json", status=3)
    for name in ("b", "c", "d"):
        assert f"{name}  (" in told, told
    assert told.count("not marked") == 3


def test_a_number_of_nobody_is_said(folder: Path, tmp_path: Path):
    sheets = json.loads((folder / "paper.sheets.json").read_text("utf-8"))
    other = tmp_path / "sheets.json"
    other.write_text(json.dumps({**sheets, "list": [{**one, "number": one["number"] + 500} for one in sheets["list"]]}), "utf-8")
    picture = sorted((folder / "in").iterdir())[0]
    told = ran("grade", folder / "hw", picture, "--sheets", other, status=3)
    assert "not marked" in told
    assert "#10" in told


def test_a_page_that_is_there_twice_counts_once(records):
    told = {student: [one["text"] for one in record.get("remarks", ()) if "#10" in one["text"]] for student, record in records.items()}
    assert {student: len(own) for student, own in told.items()} == {"one": 1, "two": 0}
    assert records["one"]["score"] == 1
