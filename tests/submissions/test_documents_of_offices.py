"""Numbers in Word files and PDFs: graphkin's answer table filled in, lines; what holds none is to be looked at."""

from __future__ import annotations

import base64
import io
import json
import subprocess
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
    line = json.loads(done.stdout.splitlines()[0])
    assert done.exit_code == (0 if line["status"] == "marked" else 3), done.output
    return line


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


def test_a_package_s_own_remarks_on_a_broken_file_stand_nowhere():
    Path("a.pdf").write_bytes(b"%PDF-1.4\nbroken")
    done = subprocess.run([sys.executable, "-m", "graphkin", "grade", "ex3-1", "a.pdf"], capture_output=True, text=True, check=False)
    assert done.returncode == 3
    assert "EOF marker" not in done.stdout + done.stderr


def test_a_file_beside_answers_that_is_not_read_is_the_teacher_s_to_look_at():
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w") as archive:
        archive.writestr("s1/a.toml", '"omega 3" = -3.92')
        archive.writestr("s1/sheet.jpg", b"\xff\xd8")
        archive.writestr("s2/a.toml", "v = 1")
    record = graded("class.zip", data.getvalue())
    assert (record["status"], len(record["remarks"])) == ("marked", 1)
    assert "sheet.jpg" in record["remarks"][0]["text"]


@pytest.mark.parametrize(
    "text",
    [
        "<p>&omega;<sub>3</sub> = -3.92 rad/s<br>alpha 3 = 62 rad/s<sup>2</sup></p><div>a_k B3B2: 2.5</div>",
        "<style>p { top: 9 }</style><table><thead><tr><th>quantity<th>value</thead><tr><td>ω<sub>3</sub></td><td><p>-3.92&nbsp;rad/s</p>"
        "</td></tr><tr><td>alpha 3</td>\n<td>62</td></tr><tr><td>a_k B3B2</td><td>2.5</td></tr></table><!-- alpha 3 = 9 -->",
    ],
)  # fmt: skip
def test_the_text_that_moodle_keeps_of_a_form(text: str):
    folder = Path("Li Lei_4460_assignsubmission_onlinetext_")
    folder.mkdir()
    record = graded(f"{folder}/onlinetext.html", text.encode())
    assert told(record) == {"omega 3": "right", "alpha 3": "right", "a_k B3B2": "right"}


PNG = b"\x89PNG\r\n\x1a\n" + bytes(40)


def test_the_picture_of_what_was_not_read_stands_in_the_report():
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w") as archive:
        archive.writestr("word/media/image1.png", PNG)
    files = {"s1.png": PNG, "s2.docx": data.getvalue(), "s3.pdf": b"%PDF-1.4 broken", "s4.csv": b"omega 3,-3.92"}
    for name, content in files.items():
        Path(name).write_bytes(content)
    done = CliRunner().invoke(main, ["grade", "ex3-1", *files, "-o", "res", "--format", "report", "--lang", "en"])
    assert done.exit_code == 0, done.output
    page = Path("res/class-report.html").read_text("utf-8")
    assert [page.count(f"<figcaption>{name}<") for name in ("s1", "s2", "s3", "s4")] == [1, 1, 0, 0]
    assert page.count(f"data:image/png;base64,{base64.b64encode(PNG).decode()}") == 2
    assert "<h1>Four-bar with a sliding pair on the rocker</h1>" in page


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
