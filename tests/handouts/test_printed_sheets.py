"""The list of what is printed where, held against what is painted on the pages."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from library_sheets import loaded

from graphkin.cli import main
from graphkin.construction import SCALES
from graphkin.errors import NoSheetList
from graphkin.files import library
from graphkin.handouts import handout
from graphkin.handouts.document import GridRoom
from graphkin.homework.grading import key_from
from graphkin.outputs.sheets_json import read_sheets
from graphkin.photo.sheets import PrintedSheet, SheetRoom

pdfium = pytest.importorskip("pypdfium2")
pytest.importorskip("typst")
_DPI = 300


def painted(path: Path, page: int) -> np.ndarray:
    """A page in grey, 0 is black."""
    return np.array(pdfium.PdfDocument(path)[page].render(scale=_DPI / 72).to_pil().convert("L"))


def dark(picture: np.ndarray, at: complex, half: float, darker: int = 60) -> complex | None:
    """The middle of what is black about a place on paper [mm]."""
    x, y = (round(part * _DPI / 25.4) for part in (at.real, at.imag))
    reach = round(half * _DPI / 25.4)
    rows, columns = np.nonzero(picture[y - reach : y + reach + 1, x - reach : x + reach + 1] < darker)
    if not rows.size:
        return None
    return complex(columns.mean() + x - reach + 0.5, rows.mean() + y - reach + 0.5) * 25.4 / _DPI


def light(picture: np.ndarray, room: SheetRoom, aside: float) -> float:
    """How light it is beside the line through a pole, all along it in its room."""
    along = np.exp(-1j * room.direction)
    places = room.pole + along * (np.arange(-300, 300, 0.2) + 1j * aside)
    inside = [(room.low.real + 1 < at.real < room.high.real - 1) and (room.low.imag + 1 < at.imag < room.high.imag - 1) for at in places]
    return float(np.mean([picture[round(at.imag * _DPI / 25.4), round(at.real * _DPI / 25.4)] for at in places[inside]]))


def ordered(*words: str) -> None:
    done = CliRunner().invoke(main, ["handout", *words])
    assert done.exit_code == 0, done.output


@pytest.mark.parametrize(("name", "paper"), [*(pytest.param(name, "A4", marks=pytest.mark.further) for name in ("ex3-1", "ex3-3")), ("ex3-5", "letter"), ("p3-16", "A4")])
def test_rooms_lie_where_they_are_painted(name: str, paper: str, tmp_path: Path):
    path = tmp_path / "a.pdf"
    ordered(name, "--stage", "blank", "--scan", "7", "--paper", paper, "--both", "-o", str(path))
    sheets = read_sheets(tmp_path / "a.sheets.json")
    assert [sheet.number for sheet in sheets] == [*range(7, 7 + len(sheets))]
    assert {(sheet.problem, sheet.student) for sheet in sheets} == {(loaded(name).name, "")}
    rooms = [(k, room) for k, sheet in enumerate(sheets) for room in sheet.rooms]
    blocks = handout([loaded(name)], "blank", "en").blocks
    assert [room.plane for _, room in rooms] == 2 * [block.plane for block in blocks if isinstance(block, GridRoom)]
    for k, room in rooms:
        picture, sheet = painted(path, k), sheets[k]
        assert (sheet.width, sheet.height) == pytest.approx((picture.shape[1] * 25.4 / _DPI, picture.shape[0] * 25.4 / _DPI), abs=0.1)
        pole = dark(picture, room.pole, 0.6)
        assert pole is not None
        assert abs(pole - room.pole) < 0.05
        assert light(picture, room, 0.0) < min(light(picture, room, aside) for aside in (-1.5, -0.8, 0.8, 1.5)) - 10
        for corner, out in ((room.low, -1 - 1j), (room.high, 1 + 1j)):  # the frame is 0.35 mm wide, and nothing is black beyond it
            assert dark(picture, corner, 0.15) is not None
            assert dark(picture, corner + 1.2 * out, 0.8) is None


def test_scales_are_those_that_are_said(tmp_path: Path):
    ordered("ex3-1", "--stage", "blank", "--scan", "0", "-o", str(tmp_path / "a.pdf"))
    scales = {room.plane: room.scale for sheet in read_sheets(tmp_path / "a.sheets.json") for room in sheet.rooms}
    marked_by = key_from("ex3-1").marking.scales
    assert scales == {plane: marked_by[key] for plane, key in SCALES.items()}


def test_a_folder_has_one_list_that_grows(tmp_path: Path):
    """What was printed before is still on paper."""
    ordered("ex3-1", "ex3-5", "--stage", "blank", "--scan", "300", "-o", str(tmp_path))
    first = read_sheets(tmp_path / "sheets.json")
    assert [sheet.problem for sheet in first] == ["ex3-1"] * 4 + ["ex3-5"] * (len(first) - 4)
    ordered("ex3-7", "--stage", "blank", "--scan", "100", "-o", str(tmp_path))
    ordered("ex3-7", "--stage", "blank", "--scan", "300", "--force", "-o", str(tmp_path))
    every = {sheet.number: sheet for sheet in read_sheets(tmp_path / "sheets.json")}
    assert every[100].problem == every[300].problem == "ex3-7"
    assert every[first[-1].number] == first[-1]


def test_pages_of_a_class_are_each_students(tmp_path: Path):
    (tmp_path / "class.csv").write_text("id,name\ns 1,Li Lei\ns2,Han Meimei\n", encoding="utf-8")
    template = tmp_path / "slide.toml"
    template.write_text(library.text("ex3-1").replace("AB = 24", "AB = { from = 20, to = 28, step = 1 }"), encoding="utf-8")
    command = ["problems", str(template), "--students", str(tmp_path / "class.csv"), "-o", str(tmp_path / "set")]
    assert CliRunner().invoke(main, command).exit_code == 0
    ordered(str(tmp_path / "set"), "--stage", "blank", "--scan", "60000", "--duplex", "-o", str(tmp_path / "print.pdf"))
    sheets = read_sheets(tmp_path / "print.sheets.json")
    assert [sheet.student for sheet in sheets if sheet.rooms] == ["s 1"] * 3 + ["s2"] * 3


def test_a_page_without_a_number_has_no_list(tmp_path: Path):
    ordered("ex3-1", "--stage", "blank", "-o", str(tmp_path / "a.pdf"))
    assert [path.name for path in tmp_path.iterdir()] == ["a.pdf"]


def test_another_file_is_not_lost(tmp_path: Path):
    (tmp_path / "a.sheets.json").write_text("my own", encoding="utf-8")
    done = CliRunner().invoke(main, ["handout", "ex3-1", "--stage", "blank", "--scan", "1", "-o", str(tmp_path / "a.pdf")])
    assert done.exit_code == 3
    assert [path.name for path in tmp_path.iterdir()] == ["a.sheets.json"]


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"kind": "graphkin sheets", "format": 2, "sheets": []}'])
def test_a_list_that_is_none_is_said(text: str, tmp_path: Path):
    path = tmp_path / "sheets.json"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(NoSheetList):
        read_sheets(path)


def test_a_list_with_anything_else_in_it_is_said(tmp_path: Path):
    ordered("ex3-1", "--stage", "blank", "--scan", "1", "-o", str(tmp_path / "a.pdf"))
    data = json.loads((tmp_path / "a.sheets.json").read_text("utf-8"))
    path = tmp_path / "b.json"
    for spoil in ({"plane": "colour"}, {"pole": [1]}, {"pole": ["x", 1]}, {"scale": None}):
        sheet = next(each for each in data["list"] if each["rooms"])
        spoiled = {**sheet, "rooms": [{**sheet["rooms"][0], **spoil}]}
        path.write_text(json.dumps({**data, "list": [spoiled]}), encoding="utf-8")
        with pytest.raises(NoSheetList):
            read_sheets(path)
    assert isinstance(read_sheets(tmp_path / "a.sheets.json")[0], PrintedSheet)
