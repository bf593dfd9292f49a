"""Numbers in Word files and PDFs: graphkin's answer table filled in, lines; what holds none is to be looked at."""

from __future__ import annotations

import io
import json
import sys
import zipfile
from pathlib import Path

import pytest
from click.testing import CliRunner

from graphkin.cli import main

FORMULA = (
    '<m:oMath xmlns:m="http://schemas.openxmlformats.org/officeDocument/2006/math"><m:sSubSup><m:e><m:r><m:t>a</m:t></m:r></m:e>'
    "<m:sub><m:r><m:t>B3B2</m:t></m:r></m:sub><m:sup><m:r><m:t>k</m:t></m:r></m:sup></m:sSubSup></m:oMath>"
)
ROWS = (("量", "答案", "单位", "转向"), ("ω2", "", "rad/s", ""), ("ω3", "3.92", "rad/s", "顺时针"), ("α3", "约62", "rad/s²", "逆时针"), ("a", "2.5", "m/s²", "—"))


@pytest.fixture(autouse=True)
def in_a_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def graded(name: str, content: bytes) -> dict:
    Path(name).write_bytes(content)
    done = CliRunner().invoke(main, ["grade", "ex3-1", name, "--json", "--lang", "en"])
    assert done.exit_code == 0, done.output
    return json.loads(done.stdout.splitlines()[0])


def told(record: dict) -> dict[str, str]:
    return {text: one["verdict"] for text, one in record["quantities"].items() if one["verdict"] != "missing"}


def word(*rows: tuple[str, ...], lines: tuple[str, ...] = ()) -> bytes:
    docx = pytest.importorskip("docx", reason="needs graphkin[word]")
    from docx.oxml import parse_xml

    document, data = docx.Document(), io.BytesIO()
    for line in lines:
        document.add_paragraph(line)
    table = document.add_table(rows=0, cols=4)
    for row in rows:
        cells = table.add_row().cells
        for cell, text in zip(cells, row):
            if text == "a":
                cell.paragraphs[0]._p.append(parse_xml(FORMULA))
            else:
                cell.text = text
    document.save(data)
    return data.getvalue()


def test_the_answer_table_filled_in_word():
    record = graded("work.docx", word(*ROWS, lines=("学号：20231048 姓名：朱霞洋", "各构件尺寸：lAB = 24 mm", "v_B3 = 0.271 m/s")))
    assert record["student"] == "20231048"
    assert told(record) == {"omega 3": "right", "alpha 3": "right", "a_k B3B2": "right", "v B3": "right"}


def test_the_answer_table_as_a_pdf(tmp_path: Path):
    typst = pytest.importorskip("typst", reason="needs graphkin[pdf]")
    cells = ("Quantity", "Answer", "Unit", "Sense", "ω#sub[3]", "3.92", "rad/s", "cw", "$a_(B 3 B 2)^k$", "2.5", "m/s²", "—", "ω#sub[2]", "", "rad/s", "")
    text = f"Student id: s1 Name: Ann\n\n#table(columns: 4, {','.join(f'[{cell}]' for cell in cells)})\nv_B3 = 0.271 m/s\n"
    (tmp_path / "t.typ").write_text(text, "utf-8")
    record = graded("work.pdf", typst.compile(tmp_path / "t.typ", format="pdf"))
    assert record["student"] == "s1"
    assert told(record) == {"omega 3": "right", "a_k B3B2": "right", "v B3": "right"}
    (tmp_path / "t.typ").write_text("#rect()", "utf-8")
    assert "Look at it" in graded("drawn.pdf", typst.compile(tmp_path / "t.typ", format="pdf"))["reason"]


@pytest.mark.parametrize(("name", "content"), [("a.docx", b"PK\3\4"), ("a.pdf", b"%PDF-1.7\n"), ("a.docx", b""), ("a.doc", b"\xd0\xcf"), ("a.jpg", b"\xff\xd8")])
def test_what_cannot_be_read_is_a_row(name: str, content: bytes):
    record = graded(name, content)
    assert (record["status"], name in record["reason"]) == ("not marked", True)


def test_a_file_beside_answers_that_is_not_read_is_the_teacher_s_to_look_at():
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w") as archive:
        archive.writestr("s1/a.toml", '"omega 3" = -3.92')
        archive.writestr("s1/sheet.jpg", b"\xff\xd8")
        archive.writestr("s2/a.toml", "v = 1")
    record = graded("class.zip", data.getvalue())
    assert (record["status"], len(record["remarks"])) == ("marked", 1)
    assert "sheet.jpg" in record["remarks"][0]["text"]


def test_words_without_numbers_are_to_be_looked_at():
    assert "Look at it" in graded("a.docx", word(lines=("见附图。",)))["reason"]


def test_a_packed_bomb_is_refused():
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("word/document.xml", b"0" * 5_000_000)
    assert "no honest file" in graded("a.docx", data.getvalue())["reason"]


@pytest.mark.parametrize(("name", "module"), [("a.docx", "docx"), ("a.pdf", "pypdf")])
def test_the_extra_is_named_where_it_is_missing(name: str, module: str, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setitem(sys.modules, module, None)
    assert "pip install graphkin[word]" in graded(name, b"%PDF")["reason"]


def test_retyped_in_a_spreadsheet_beside_the_table_of_vectors():
    openpyxl = pytest.importorskip("openpyxl", reason="needs graphkin[xlsx]")
    book, data = openpyxl.Workbook(), io.BytesIO()
    for row in (*ROWS[:3], (), ("矢量", "量得 (mm)", "数值", "矢量", "量得 (mm)", "数值"), ("v_B3", 45.2, 0.2712, "v_B2", 40, 0.24)):
        book.active.append(row)
    book.save(data)
    record = graded("work.xlsx", data.getvalue())
    assert told(record) == {"omega 3": "right", "v B3": "right", "v B2": "right"}
