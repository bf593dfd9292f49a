"""Results for platforms: every format from one record, totals equal, overrides kept, nothing outside the folder."""

from __future__ import annotations

import csv
import io
import json
import re
import tomllib
import zipfile
from dataclasses import replace
from decimal import Decimal
from pathlib import Path
from random import Random

import pytest
from click.testing import CliRunner
from defusedxml.ElementTree import fromstring

from graphkin.cli import main as graphkin
from graphkin.cli.marking import RESULT_FORMATS
from graphkin.errors import CannotWrite, NoFile, NotAnOverride, NotAResult, Unreadable, Where
from graphkin.homework.platforms import from_record, read_results, write_results
from graphkin.homework.platforms.class_report import class_report, report_record, report_text, write_class_figure
from graphkin.homework.platforms.class_table import read_overrides
from graphkin.homework.platforms.feedback import Feedback, diagnosis, next_step, under_table
from graphkin.homework.platforms.learning_platforms import LARGEST, canvas, moodle
from graphkin.homework.platforms.markup import one_line
from graphkin.homework.platforms.result import ResultPicture, points_of
from graphkin.homework.platforms.result_formats import RESULTS
from graphkin.homework.platforms.tables import harmless, unharmed
from graphkin.outputs.files import FileInTheWay
from graphkin.say import say
from graphkin.say.catalogue import in_both

MOODLE = "class.zip!Li Lei_{k}_assignsubmission_file_/answers.toml"
CANVAS = "class.zip!leili_{k}_2077{k}_answers.svg"
HOSTILE = (
    "=cmd|' /C calc'!A0", "+1", "-2", "@a", "../../etc/passwd", "C:\\x", "con", "a/b", "\x00\x1b[2J", "\ud800", "学生", "<b>",
    "a\"b,c;d", "two\nlines", "'=1", "''=1", "'", "", "A" * 400, "s1", "S1", "\u202e1", "{", "007",
)  # fmt: skip


def quantity(worth: float, credit: float, unit: str, **values) -> dict:
    plain = {"given": None, "right": 0.5, "carried": None, "tolerance": 0.01, "verdict": "missing", "sense": None}
    return {**plain, "unit": unit, "unit_right": True, "own": {}, "refused": [], "points": worth, "credit": credit, **values}


def name(id: str, of: str = "omega 3", form: str = "l_CD") -> dict:
    return {"id": id, "way": "", "of": of, "form": form}


def record(k: int, file: str = "s{k}.toml", student: str = "", **changes) -> dict:
    """A marked submission with points that need rounding."""
    told = {
        "format": 1, "student": student or f"s{k}", "file": file.format(k=k), "status": "marked", "score": 0.6,
        "quantities": {
            "omega 3": quantity(4 / 3, 0.25, "rad/s", given=-5.65, right=-3.919, tolerance=0.05, verdict="wrong"),
            "a_k B3B2": quantity(1.005, 1.0, "m/s^2", given=3.63, right=2.515, carried=3.625, tolerance=0.04,
                                 verdict="carried", own={"omega 3": -5.65}),
            "alpha 3": quantity(1.0, 0.5, "rad/s^2", given=-62.0, right=62.2, tolerance=2.0, verdict="wrong", sense="wrong"),
            "v B3": quantity(0.0, 0.0, "m/s", given=0.1, carried=0.7071, own={"omega 3": -5.65}, verdict="wrong"),
        },
        "mistakes": [{"ids": ["wrong-length", "omega-sense"], "probability": 0.9, "margin": 3.0,
                      "explains": ["omega 3", "alpha 3"], "names": [[name("wrong-length")], [name("omega-sense")]]}],
        "place": "", "notes": ["passed over"], "evidence": {},
    }  # fmt: skip
    return {**told, **changes}


TOTAL, MOST = Decimal("1.84"), Decimal("3.34")


def unmarked(k: int, file: str = "s{k}.toml") -> dict:
    return {
        "format": 1, "student": f"s{k}", "file": file.format(k=k), "status": "not marked", "reason": "not TOML",
        "score": None, "quantities": {}, "mistakes": [],
    }  # fmt: skip


def stored(path: Path, *lines: str, head: str = "") -> Path:
    """A file of marks with these records."""
    head = head or '{"kind": "graphkin marks", "format": 1,\n"results": ['
    path.write_text(head + ",".join("\n" + line for line in lines) + "\n]}\n")
    return path


def results(*records: dict) -> list:
    return [from_record(each, Where("marks.json", k)) for k, each in enumerate(records, 1)]


def rows(path: Path) -> list[list[str]]:
    return [*csv.reader(io.StringIO(path.read_text("utf-8-sig"), newline=""))]


def table(path: Path) -> list[dict[str, str]]:
    head, *rest = rows(path)
    assert all(len(row) == len(head) for row in rest)
    return [dict(zip(head, row, strict=True)) for row in rest]


def plain_zip(path: Path) -> dict[str, bytes]:
    """An archive's files; none of them would be unpacked elsewhere."""
    with zipfile.ZipFile(path) as archive:
        assert archive.testzip() is None
        for name in archive.namelist():
            assert not name.startswith("/")
            assert not {"..", ""} & set(name.split("/"))
            assert "\\" not in name
        return {name: archive.read(name) for name in archive.namelist()}


def workbook(path: Path) -> list[list[str]]:
    """The cells of a workbook as text; none of them is a formula."""
    tree = fromstring(plain_zip(path)["xl/worksheets/sheet1.xml"])
    place = "{http://schemas.openxmlformats.org/spreadsheetml/2006/main}"
    assert not [*tree.iter(f"{place}f")]
    found = []
    for row in tree.iter(f"{place}row"):
        cells = {re.sub("[0-9]", "", cell.attrib["r"]): "".join(cell.itertext()) for cell in row}
        found.append(cells)
    return found


# --- the record -------------------------------------------------------------------------------


def test_a_record_is_read():
    (found,) = results(record(1))
    assert (found.student, found.file, found.total, found.most) == ("s1", "s1.toml", TOTAL, MOST)
    assert found.score == Decimal("0.550898")
    assert [points_of(line) for line in found.lines] == [Decimal("0.33"), Decimal("1.01"), Decimal("0.5"), 0]


@pytest.mark.parametrize(
    "changes",
    [
        {"format": 2}, {"status": "lost"}, {"quantities": {"v": {}}}, {"quantities": 3}, {"mistakes": [{}]}, {"student": 3},
        {"quantities": {"v": quantity(1, 1, "", verdict="fine")}}, {"quantities": {"v": quantity(float("nan"), 1, "")}},
        {"quantities": {"v": quantity(1, 1.5, "")}}, {"quantities": {"v": quantity(-1, 1, "")}}, {"notes": [1]},
        {"quantities": {"v": quantity(1, 1, "", given=True)}}, {"reason": 3}, {"quantities": {"v": quantity(10**400, 1, "")}},
        {"mistakes": [{"ids": ["a"], "explains": [], "names": [["a"]]}]},
    ],
)  # fmt: skip
def test_what_is_no_record_is_refused(changes):
    with pytest.raises(NotAResult, match=r"marks\.json:1"):
        results(record(1, **changes))


def test_a_file_of_marks_is_read(tmp_path: Path):
    path = tmp_path / "marks.json"
    there = read_results(stored(path, json.dumps(record(1)), json.dumps(unmarked(2))))
    assert json.loads(path.read_text())["format"] == 1
    assert [*there] == results(record(1), unmarked(2))
    assert read_results(stored(path)) == ()


@pytest.mark.parametrize("line", ["{", "[]", "3", '{"format": 1}', "[" * 100_000, ""])
def test_a_broken_file_of_marks_is_refused(line, tmp_path: Path):
    with pytest.raises(NotAResult, match=r"marks\.json:4"):
        read_results(stored(tmp_path / "marks.json", json.dumps(record(1)), line))


@pytest.mark.parametrize(
    "head", ["[", "{}", '{"kind": "graphkin key", "format": 1,\n"results": [', '{"kind": "graphkin marks", "format": 9,\n"results": ['],
)  # fmt: skip
def test_what_is_no_file_of_marks_is_refused(head, tmp_path: Path):
    with pytest.raises(NotAResult, match=r"marks\.json"):
        read_results(stored(tmp_path / "marks.json", json.dumps(record(1)), head=head))


def test_a_cut_file_of_marks_is_refused(tmp_path: Path):
    path = tmp_path / "marks.json"
    stored(path, json.dumps(record(1)))
    path.write_text(path.read_text()[:-4])
    with pytest.raises(NotAResult):
        read_results(path)
    path.write_bytes(b"\xff\xfe")
    with pytest.raises(Unreadable):
        read_results(path)


def test_no_file_of_marks(tmp_path: Path):
    with pytest.raises(NoFile):
        read_results(tmp_path / "none.json")


# --- totals -----------------------------------------------------------------------------------


def totals(folder: Path, kind: str, count: int) -> list[tuple[Decimal | None, Decimal]]:
    """Total and maximum of each student, as a format's own files have them."""
    if kind == "csv":
        return [(_of(row["total"]), Decimal(row["out of"])) for row in table(folder / "class.csv")]
    if kind == "xlsx":
        head, *rest = workbook(folder / "class.xlsx")
        by_name = {name: letter for letter, name in head.items()}
        return [(_of(row.get(by_name["total"])), Decimal(row[by_name["out of"]])) for row in rest]
    if kind == "moodle":
        return [(_of(row["Grade"]), Decimal(row["Maximum grade"])) for row in table(folder / "moodle-grades.csv")]
    if kind == "canvas":
        _, most, *rest = rows(folder / "canvas-grades.csv")
        return [(_of(row[5]), Decimal(most[5])) for row in rest]
    paths = [folder / kind / f"s{k}" / "results.json" for k in range(1, count + 1)]
    told = [json.loads(path.read_text()) for path in paths]
    if kind == "gradescope":
        return [(_of(each.get("score")), sum(_of(test.get("max_score", 0)) for test in each["tests"])) for each in told]
    return [(_of(each.get("score")), sum(_of(test["max_points"]) for test in each.get("tests", []))) for each in told]


def _of(value) -> Decimal | None:
    return None if value in (None, "") else Decimal(str(value))


@pytest.mark.parametrize("kind", [kind for kind in RESULTS if kind not in ("pages", "report")])
def test_totals_are_equal(kind, tmp_path: Path):
    file = MOODLE if kind == "moodle" else CANVAS
    there = results(record(1, file), record(2, file), unmarked(3, file))
    write_results(tmp_path, there, "csv")
    override(tmp_path / "class.csv", {"s2": "2.675"})
    write_results(tmp_path, there, kind)
    (first, most), (second, _), (third, _) = totals(tmp_path, kind, 3)
    if kind == "prairielearn":
        first, second = ((score * MOST).quantize(Decimal("0.01")) for score in (first, second))
    assert (first, second, third) == (TOTAL, Decimal("2.68"), None)
    assert most == MOST
    assert there[0].total == TOTAL


def test_random_points_add_up_in_every_format(tmp_path: Path):
    random = Random(3)
    told = []
    for k in range(1, 21):
        each = record(k, CANVAS)
        for line in each["quantities"].values():
            line["points"] = random.choice([0, 1, 2.5, 1 / 3, random.random() * 7])
            line["credit"] = random.choice([0, 0.5, 1])
        told.append(each)
    there = results(*told)
    for kind in ("csv", "xlsx", "gradescope"):
        write_results(tmp_path / kind, there, kind)
        found = totals(tmp_path / kind, kind, 20)
        assert found == [(each.total, each.most) for each in there]


# --- one format after the other ---------------------------------------------------------------


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_class_table(lang, tmp_path: Path):
    write_results(tmp_path, results(record(1), unmarked(2)), "csv", lang)
    head, first, second = rows(tmp_path / "class.csv")
    assert say("platforms.column override", lang) in head
    told = dict(zip(head, first, strict=True))
    assert told["ω3"] == say("verdicts.verdict wrong", lang)
    assert say("verdicts.verdict carried", lang) == told["aᵏ_B3B2"]
    assert ("ω3 from the wrong length l_CD" if lang == "en" else "求 ω3 时误用长度 l_CD") in told[say("platforms.column diagnosis", lang)]
    assert second[head.index(say("platforms.column remarks", lang))] == "not TOML"
    assert second[head.index(say("platforms.column total", lang))] == ""


def test_workbook_opens_in_a_spreadsheet(tmp_path: Path):
    openpyxl = pytest.importorskip("openpyxl")
    there = results(*(record(k, student=text) for k, text in enumerate(HOSTILE)))
    write_results(tmp_path, there, "xlsx")
    sheet = openpyxl.load_workbook(tmp_path / "class.xlsx").active
    column = [cell for (cell,) in sheet.iter_rows(min_row=2, max_col=1)]
    assert all(cell.data_type in ("s", "inlineStr", "n") and not (cell.data_type == "n" and cell.value) for cell in column)
    assert column[0].value == HOSTILE[0]
    assert [cell.value for cell in sheet[2]][7] == 1.84


def test_moodle_files(tmp_path: Path):
    told = write_results(tmp_path, results(record(12, MOODLE), record(13), unmarked(14, MOODLE)), "moodle")
    first, third = table(tmp_path / "moodle-grades.csv")
    assert first["Identifier"] == "Participant 12"
    assert first["Full name"] == "Li Lei"
    assert first["Grade"] == "1.84"
    assert third["Grade"] == ""
    assert "not TOML" in third["Feedback comments"]
    assert [*plain_zip(tmp_path / "moodle-feedback.zip")] == [
        "Li Lei_12_assignsubmission_file_/answers.html", "Li Lei_14_assignsubmission_file_/answers.html",
    ]  # fmt: skip
    (said,) = told.left_out
    assert "1 submissions" in said
    assert "s13.toml" in said


def test_canvas_files(tmp_path: Path):
    others = [record(k, f"class.zip!leili_{k}_9{k}_a.{end}") for k, end in ((21, "csv"), (22, "xlsx"), (23, "toml"), (24, "json"))]
    there = results(record(20, CANVAS), *others, record(25, "class.zip!li_25_925_a.ggb"), record(26))
    told = write_results(tmp_path, there, "canvas", assignment="Homework 3 (77)")
    head, most, *rest = rows(tmp_path / "canvas-grades.csv")
    assert head == ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", "Homework 3 (77)"]
    assert most[5] == "3.34"
    assert [(row[0], row[1], row[5]) for row in rest][:2] == [("leili", "20", "1.84"), ("leili", "21", "1.84")]
    files = plain_zip(tmp_path / "canvas-feedback.zip")
    assert [*files] == [f"leili_{k}_9{k}_a.{end}".replace("_920_a", "_207720_answers") for k, end in
                        ((20, "svg"), (21, "csv"), (22, "xlsx"), (23, "toml"), (24, "json"))]  # fmt: skip
    assert fromstring(files["leili_20_207720_answers.svg"]).tag.endswith("svg")
    assert "Total" in files["leili_21_921_a.csv"].decode()
    assert "Total" in json.loads(files["leili_24_924_a.json"])["feedback"][-1]
    assert tomllib.loads(files["leili_23_923_a.toml"].decode()) == {}
    assert zipfile.is_zipfile(io.BytesIO(files["leili_22_922_a.xlsx"]))
    assert ["s26.toml" in told.left_out[0], ".ggb" in told.left_out[1]] == [True, True]
    assert len(told.left_out) == 2


@pytest.mark.parametrize(
    ("file", "id", "who", "name"),
    [
        ("c.zip!Ann Lee_5_assignsubmission_file_/d/a.svg", "5", "Ann Lee", "Ann Lee_5_assignsubmission_file_/d/a.html"),
        ("c.ZIP!Ann Lee_5_assignsubmission_file_a.svg", "5", "Ann Lee", "Ann Lee_5_assignsubmission_file_a.html"),
        ("Ann_5_assignsubmission_file_/a", "5", "Ann", "Ann_5_assignsubmission_file_/a.html"),
        ("c.zip!x/Ann!_5_assignsubmission_file_/a.b.c", "5", "Ann!", "Ann!_5_assignsubmission_file_/a.b.html"),
    ],
)
def test_names_of_moodle(file, id, who, name):
    found = moodle(file)
    assert (found.id, found.who, found.name) == (id, who, name)


@pytest.mark.parametrize(
    "file",
    ["a.svg", "A_x_assignsubmission_file_/a.svg", "A_5_assignsubmission_file_/../a.svg", "A_5_assignsubmission_file_/C:\\a",
     "A_5_assignsubmission_file_//a", "A_5_assignsubmission_file_/a\x00b", "A_5_assignsubmission_file_/.. /a"],
)  # fmt: skip
def test_what_is_no_name_of_moodle(file):
    assert moodle(file) is None


@pytest.mark.parametrize(
    ("file", "id", "who"),
    [("leili_3143_207797_a.svg", "3143", "leili"), ("c.zip!leili_LATE_3143_207797_my_1_a.svg", "3143", "leili"),
     ("a_b_3143_207797_.svg", "3143", "a_b")],
)  # fmt: skip
def test_names_of_canvas(file, id, who):
    found = canvas(file)
    assert (found.id, found.who) == (id, who)
    assert found.name == file.removeprefix("c.zip!")


@pytest.mark.parametrize("file", ["a.svg", "lei_3143_a.svg", "3143_207797_a.svg", "lei_1_2_a\\b.svg"])
def test_what_is_no_name_of_canvas(file):
    assert canvas(file) is None


def test_gradescope(tmp_path: Path):
    write_results(tmp_path, results(record(1)), "gradescope")
    told = json.loads((tmp_path / "results.json").read_text())
    assert all(test["status"] in ("passed", "failed") for test in told["tests"])
    assert [test["status"] for test in told["tests"]] == ["failed", "passed", "failed", "failed", "failed"]
    assert Decimal(str(round(sum(test.get("score", 0) for test in told["tests"]), 2))) == TOTAL
    assert "score" not in told["tests"][-1]
    assert "ω3 from the wrong length" in told["tests"][-1]["output"]


@pytest.mark.parametrize("kind", ["gradescope", "prairielearn"])
def test_two_submissions_of_a_student(kind, tmp_path: Path):
    write_results(tmp_path, results(record(1), record(2, student="s1"), record(3)), kind)
    assert len([*tmp_path.rglob("results.json")]) == 3


@pytest.mark.parametrize("kind", ["gradescope", "prairielearn"])
def test_not_marked_is_no_zero(kind, tmp_path: Path):
    write_results(tmp_path, results(unmarked(1)), kind)
    told = json.loads((tmp_path / "results.json").read_text())
    assert "score" not in told
    assert "not TOML" in json.dumps(told)
    if kind == "prairielearn":
        assert told["gradable"] is False
        assert told["format_errors"]


def test_a_teacher_marks_what_was_not_marked(tmp_path: Path):
    there = results(unmarked(1), record(2))
    write_results(tmp_path, there, "csv")
    override(tmp_path / "class.csv", {"s1": "1.67"})
    write_results(tmp_path, there, "prairielearn")
    told = json.loads((tmp_path / "prairielearn" / "s1" / "results.json").read_text())
    assert told["gradable"] is True
    assert told["score"] == 0.5


def test_prairielearn(tmp_path: Path):
    pictures = [ResultPicture("polygon", "image/png", b"\x89PNG")]
    write_results(tmp_path / "grade" / "results", results(record(1)), "prairielearn", pictures=lambda *asked: pictures)
    told = json.loads((tmp_path / "grade" / "results" / "results.json").read_text())
    assert 0 <= told["score"] <= 1
    assert told["images"] == [{"label": "polygon", "url": "data:image/png;base64,iVBORw=="}]
    assert all({"points", "max_points", "images"} <= test.keys() for test in told["tests"])
    assert told["tests"][-1]["max_points"] == 0
    assert told["tests"][-2]["max_points"] == 0


@pytest.mark.parametrize("size", [10, 400_000, 800_000, 1_100_000])
def test_prairielearn_stays_under_a_megabyte(size, tmp_path: Path):
    pictures = [ResultPicture(str(k), "image/png", b"x" * size) for k in range(2)]
    long = record(1)
    if size > LARGEST:
        first, *others = long["quantities"].items()
        long["quantities"] = {f"v {'E' * size}": first[1], **dict(others)}
    write_results(tmp_path, results(long), "prairielearn", pictures=lambda *asked: pictures)
    path = tmp_path / "results.json"
    assert path.stat().st_size < LARGEST
    told = json.loads(path.read_text())
    assert len(told["images"]) == {10: 2, 400_000: 1, 800_000: 0, 1_100_000: 0}[size]
    assert told["score"] == pytest.approx(1.84 / 3.34, abs=1e-6)


# --- what a student is told -------------------------------------------------------------------


@pytest.mark.parametrize(
    ("reveal", "hidden", "told"),
    [
        ("hint", ("−3.919", "wrong length", "3.625"), ("wrong", "−5.65", "Look again at how angular velocities")),
        ("mistake", ("−3.919", "2.515", "0.7071", "0.5 m/s"), ("judged with your own ω3 = −5.65 rad/s: it should be 3.625 m/s²: yours is within what paper allows", "ω3 from the wrong length", "consistent with", "cannot be told apart")),
        ("answer", (), ("−3.919", "3.625", "0.7071", "ω3 from the wrong length")),
    ],
)
def test_stages(reveal, hidden, told, tmp_path: Path):
    there = results(record(1, MOODLE))
    write_results(tmp_path, there, "moodle", reveal=reveal)
    write_results(tmp_path / "g", there, "gradescope", reveal=reveal)
    write_results(tmp_path / "p", there, "prairielearn", reveal=reveal)
    texts = [
        re.sub("<[^>]*>", "", plain_zip(tmp_path / "moodle-feedback.zip").popitem()[1].decode()),
        table(tmp_path / "moodle-grades.csv")[0]["Feedback comments"],
        (tmp_path / "g" / "results.json").read_text().replace("\\u00b2", "²").replace("\\u2212", "−").replace("\\u03c9", "ω"),
        (tmp_path / "p" / "results.json").read_text().replace("\\u00b2", "²").replace("\\u2212", "−").replace("\\u03c9", "ω"),
    ]
    for text in texts:
        assert "you did" not in text
        for word in told:
            assert word in text
        for word in hidden:
            assert word not in re.sub(r"[0-9.]+ of [0-9.]+ points", "", text)


# --- overrides --------------------------------------------------------------------------------


@pytest.mark.parametrize("reveal", ["hint", "mistake", "answer"])
def test_of_mistakes_that_are_not_told_apart_the_next_step_picks_none(reveal):
    slip = {"id": "slip", "way": "", "of": "omega 3", "form": ""}
    mistakes = [{"ids": ["diameter-for-radius", "slip"], "probability": 0.95, "margin": 3.0, "explains": ["omega 3"],
                 "names": [[name("diameter-for-radius", "v_B", "2 l_AB")], [slip]]}]  # fmt: skip
    (result,) = results(record(1, mistakes=mistakes))
    step = next_step(Feedback(result, "en", reveal))
    assert "do not tell which" in step
    assert "Look again at the lengths." in step
    assert "Work the first value that is marked wrong through again." in step
    assert ": (1) v_B with 2 l_AB (diameter for radius, or half a length); (2) a slip in ω3 (everything after it" in "\n".join(
        diagnosis(result, "en", "mistake")
    )


def _in_the_wrong_sense_beside_a_wrong_one() -> dict:
    """omega 5 is wrong, and leaves the right way first; omega 3 has the wrong sense alone; a F is ten times too large."""
    half = {"verdict": "wrong", "sense": "wrong", "tolerance": 0.05}
    quantities = {
        "omega 3": quantity(1.0, 0.5, "rad/s", given=1.82, right=-1.82, **half),
        "a F": quantity(1.0, 0.0, "m/s^2", given=37.0, right=3.704, tolerance=0.1, verdict="wrong"),
        "omega 5": quantity(1.0, 0.0, "rad/s", given=-1.0, right=2.0, tolerance=0.05, verdict="wrong"),
    }
    return record(1, quantities=quantities, mistakes=[], departure={"quantity": "omega 5", "left": [], "right": []})


def test_page_and_report_name_the_same_value_first():
    (result,) = results(_in_the_wrong_sense_beside_a_wrong_one())
    assert next_step(Feedback(result, "en", "answer")) == "Go back to ω5 and work on from there."
    assert "ω5 is the first value that leaves the right way" in "\n".join(diagnosis(result, "en", "answer"))
    assert {step.name: step.first for step in class_report([result]).steps} == {"omega 3": 0, "a F": 0, "omega 5": 1}


@pytest.mark.parametrize("reveal", ["hint", "mistake", "answer"])
def test_a_shifted_decimal_point_is_told_beside_other_errors(reveal):
    (result,) = results(_in_the_wrong_sense_beside_a_wrong_one())
    text = "\n".join(under_table(Feedback(result, "en", reveal)))
    assert ("a_F: ten times what it should be: look at the decimal point." in text) == (reveal != "hint")
    assert text.count("decimal point") == (reveal != "hint")


def override(path: Path, points: dict[str, str], encoding: str = "utf-8-sig", separator: str = ",") -> None:
    """A teacher writes into the table, and a spreadsheet saves it in its own way."""
    head, *rest = rows(path)
    for row in rest:
        at = next(k for k, name in enumerate(head) if name in in_both("platforms.column override").values())
        row[at] = points.get(row[0], row[at])
    written = io.StringIO()
    csv.writer(written, delimiter=separator, quoting=csv.QUOTE_ALL).writerows([head, *rest])
    path.write_bytes(written.getvalue().encode(encoding))


@pytest.mark.parametrize(("encoding", "separator"), [("utf-8-sig", ","), ("utf-8", ";"), ("gb18030", "\t")])
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_overrides_survive(encoding, separator, lang, tmp_path: Path):
    there = results(record(1, MOODLE), record(2, MOODLE), unmarked(3, MOODLE))
    write_results(tmp_path, there, "csv", lang)
    override(tmp_path / "class.csv", {"s1": "3", "s3": "0"}, encoding, separator)
    for _ in range(2):
        write_results(tmp_path, there, "csv", "en")
        assert [row["override"] for row in table(tmp_path / "class.csv")] == ["3", "", "0"]
    assert [row["total"] for row in table(tmp_path / "class.csv")] == ["3", "1.84", "0"]
    write_results(tmp_path, there, "moodle")
    assert [row["Grade"] for row in table(tmp_path / "moodle-grades.csv")] == ["3", "1.84", "0"]


def test_an_override_is_taken_back(tmp_path: Path):
    for points in ("2", ""):
        write_results(tmp_path, results(record(1)), "csv")
        override(tmp_path / "class.csv", {"s1": points})
    write_results(tmp_path, results(record(1)), "csv")
    assert table(tmp_path / "class.csv")[0]["override"] == ""


def test_an_override_of_an_absent_student_is_kept_and_said(tmp_path: Path):
    write_results(tmp_path, results(record(1), record(2)), "csv")
    override(tmp_path / "class.csv", {"s2": "1.5"})
    for _ in range(2):
        told = write_results(tmp_path, results(record(1)), "csv")
        assert [(row["student"], row["override"]) for row in table(tmp_path / "class.csv")] == [("s1", ""), ("s2", "1.5")]
        assert "s2" in told.left_out[0]


def test_an_override_is_found_by_its_file_where_a_spreadsheet_spoilt_the_id(tmp_path: Path):
    there = results(record(1, student="007"), record(2, student="008"))
    write_results(tmp_path, there, "csv")
    path = tmp_path / "class.csv"
    path.write_text(path.read_text("utf-8-sig").replace("007", "7"), "utf-8")
    override(path, {"7": "2"})
    write_results(tmp_path, there, "csv")
    assert [row["override"] for row in table(path)] == ["2", ""]


@pytest.mark.parametrize("text", HOSTILE)
def test_overrides_of_hostile_ids(text, tmp_path: Path):
    there = results(record(1, student=text or "?"), record(2, student="other"))
    write_results(tmp_path, there, "csv")
    path = tmp_path / "class.csv"
    override(path, {rows(path)[1][0]: "1"})
    write_results(tmp_path, there, "csv")
    assert [row["override"] for row in table(path)] == ["1", ""]


@pytest.mark.parametrize("given", ["good", "-1", "nan", "1e9", "inf", "="])
def test_what_is_no_override_is_refused(given, tmp_path: Path):
    write_results(tmp_path, results(record(1)), "csv")
    override(tmp_path / "class.csv", {"s1": given})
    before = (tmp_path / "class.csv").read_bytes()
    with pytest.raises(NotAnOverride, match=r"class\.csv:2"):
        write_results(tmp_path, results(record(1)), "csv")
    assert (tmp_path / "class.csv").read_bytes() == before


def test_a_table_without_the_column_says_nothing(tmp_path: Path):
    path = tmp_path / "class.csv"
    for data in (b"", b"a,b\n1,2\n", b"\xff\xfe\x00", b"override\n3\n", b'"student","override"\n"s1","2'):
        path.write_bytes(data)
        assert len(read_overrides(path).kept) == (b"student" in data)


# --- the command ------------------------------------------------------------------------------


HANDED_IN = "student,omega 3,alpha 3,a_k B3B2\n=cmd,-3.92,62,2.5\ns2,-3.9,-37,2.51\ns3,-5.65,68.7,3.62\ns4,,what,\n"


def grade(folder: Path, *options: str):
    """`graphkin grade` on a class table, into a folder."""
    (folder / "handed.csv").write_text(HANDED_IN)
    words = ["grade", "ex3-1", str(folder / "handed.csv"), "-o", str(folder / "out"), "--lang", "en", *options]
    return CliRunner().invoke(graphkin, words)


def test_the_command_writes_every_format(tmp_path: Path):
    done = grade(tmp_path, *(word for kind in RESULT_FORMATS for word in ("--format", kind)))
    assert done.exit_code == 0, done.output
    out = tmp_path / "out"
    assert {path.name for path in out.iterdir()} == {
        "marks.json", "class.csv", "class.xlsx", "moodle-grades.csv", "moodle-feedback.zip", "canvas-grades.csv",
        "canvas-feedback.zip", "gradescope", "pages", "prairielearn", "class-report.txt", "class-report.json", "class-report.svg",
        "class-report.html",
    }  # fmt: skip
    there = read_results(out / "marks.json")
    assert [each.student for each in there] == ["=cmd", "s2", "s3", "s4"]
    own = [each["score"] for each in json.loads((out / "marks.json").read_text())["results"]]
    for kind in ("csv", "xlsx"):
        *whole, unread = totals(out, kind, 4)
        assert whole == [(each.total, each.most) for each in there[:3]]
        assert unread == (there[3].total, there[0].most)  # of as many as the others
    for each, score in zip(there, own, strict=True):
        if each.score is not None:
            assert float(each.score) == pytest.approx(score, abs=1e-5)
    assert "pointing the other way" in (out / "class-report.txt").read_text()


def test_overrides_survive_the_command(tmp_path: Path):
    grade(tmp_path, "--format", "csv")
    override(tmp_path / "out" / "class.csv", {"s3": "4.5"})
    assert grade(tmp_path, "--format", "csv", "--format", "moodle").exit_code == 0
    assert [row["total"] for row in table(tmp_path / "out" / "class.csv")][2] == "4.5"
    override(tmp_path / "out" / "class.csv", {"s3": "much"})
    marks = (tmp_path / "out" / "marks.json").stat().st_mtime_ns
    done = grade(tmp_path, "--format", "csv")
    assert done.exit_code == 3
    assert "class.csv:4" in done.stderr
    assert (tmp_path / "out" / "marks.json").stat().st_mtime_ns == marks, "said before anything is marked"


def test_use_of_the_command(tmp_path: Path):
    assert set(RESULT_FORMATS) == {"json", *RESULTS}
    assert grade(tmp_path).exit_code == 2
    assert CliRunner().invoke(graphkin, ["grade", "ex3-1", "x", "--format", "csv"]).exit_code == 2
    (tmp_path / "out").write_text("a file")
    assert grade(tmp_path, "--format", "csv").exit_code == 3
    assert (tmp_path / "out").read_text() == "a file"


# --- hard to break ----------------------------------------------------------------------------


@pytest.mark.parametrize("kind", RESULTS)
def test_hostile_names(kind, tmp_path: Path):
    folder = tmp_path / "out"
    files = [f"class.zip!Li {text}_{k}_assignsubmission_file_/{text}.svg" for k, text in enumerate(HOSTILE)]
    names = [*files, *(f"class.zip!{text}_{k}_{k}_a.svg" for k, text in enumerate(HOSTILE)), *HOSTILE]
    told = []
    for k, file in enumerate(names):
        text = HOSTILE[k % len(HOSTILE)]
        each = record(k, "", student=f"{text}{'' if k < len(HOSTILE) else k}")
        each |= {"file": file, "quantities": {text: each["quantities"]["omega 3"]}, "reason": text}
        each["mistakes"] = [{"ids": [text], "explains": [text], "names": [[name(text, text, text)], [name("wrong-length", text)]]}]
        told.append(each)
    there = results(*told)
    write_results(folder, there, kind)
    first = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    write_results(folder, there, kind)
    assert first == {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    assert [*tmp_path.iterdir()] == [folder]
    for path in first:
        assert path.parent == folder / "pages" or path.stem.split(".")[0] in ("results", "class", f"{kind}-grades", f"{kind}-feedback", "class-report")
        if path.suffix == ".zip":
            assert plain_zip(path)
        if path.suffix == ".csv":
            for cell in (cell for row in rows(path) for cell in row):
                assert not cell.startswith(("=", "+", "@", "-", "\t", "\r"))
    if kind in ("gradescope", "prairielearn"):
        assert len(first) == len(there)


@pytest.mark.parametrize("text", HOSTILE)
def test_a_cell_is_read_back(text):
    assert unharmed(harmless(text)) == one_line(text)


@pytest.mark.parametrize("kind", RESULTS)
def test_a_foreign_file_is_not_replaced(kind, tmp_path: Path):
    there = results(record(1, CANVAS))
    write_results(tmp_path, there, kind)
    path = sorted(tmp_path.rglob("*.*"))[-1]
    path.write_bytes(b"another's work")
    with pytest.raises(FileInTheWay):
        write_results(tmp_path, there, kind)
    assert path.read_bytes() == b"another's work"
    write_results(tmp_path, there, kind, force=True)


@pytest.mark.parametrize("kind", RESULTS)
def test_no_half_file_is_left(kind, tmp_path: Path):
    """Results that end in an error, as those of a broken file do."""

    class Broken:
        def __iter__(self):
            yield from results(record(1, CANVAS))
            raise NotAResult(Where("x"), "broken")

    with pytest.raises(NotAResult):
        write_results(tmp_path, Broken(), kind)
    assert [path.name for path in tmp_path.rglob("*") if path.is_file()] == []


def test_a_file_where_the_folder_should_be(tmp_path: Path):
    (tmp_path / "out").write_text("")
    with pytest.raises(CannotWrite):
        write_results(tmp_path / "out", results(record(1)), "json")


@pytest.mark.parametrize("kind", RESULTS)
def test_nobody_handed_in(kind, tmp_path: Path):
    write_results(tmp_path, [], kind)


# --- the class --------------------------------------------------------------------------------


def a_class() -> list:
    right = record(1)
    right["quantities"] = {
        text: {**line, "verdict": "right", "credit": 1.0} for text, line in right["quantities"].items()
    }
    right["mistakes"] = []
    late = record(6)
    late["quantities"]["omega 3"] |= {"given": None, "verdict": "missing"}
    found = results(right, record(2), record(3), record(4, mistakes=[]), unmarked(5), late)
    return [*found[:5], replace(found[5], override=Decimal(0))]


def test_class_report():
    report = class_report(a_class())
    assert (report.marked, report.unmarked, report.overridden, report.unexplained) == (5, 1, 1, 1)
    omega, coriolis, *_ = report.steps
    assert dict(omega.verdicts) == {"right": 1, "wrong": 3, "missing": 1}
    assert [step.first for step in report.steps] == [3, 0, 1, 0]
    assert dict(coriolis.verdicts) == {"right": 1, "carried": 4}
    assert [(one.ids, count) for one, count in report.mistakes] == [(("wrong-length", "omega-sense"), 3)]
    assert report.ranges == (1, 0, 0, 0, 0, 3, 0, 0, 0, 1)
    assert (report.spread["lowest"], report.spread["highest"]) == (0, 1)
    assert float(report.spread["median"]) == pytest.approx(1.84 / 3.34, abs=1e-6)
    assert float(report.spread["mean"]) == pytest.approx((1 + 3 * 1.84 / 3.34) / 5, abs=1e-6)
    assert json.loads(json.dumps(report_record(report), allow_nan=False))["steps"][0]["first_to_fail"] == 3


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_class_report_in_words(lang):
    told = "\n".join(report_text(class_report(a_class()), lang))
    for word in ("ω3", "l_CD", "55.1"):
        assert word in told
    assert [*report_text(class_report([]), lang)]


@pytest.mark.parametrize("end", ["svg", "png", "pdf"])
def test_class_figure(end, tmp_path: Path):
    path = tmp_path / f"class.{end}"
    write_class_figure(path, class_report(a_class()))
    first = path.read_bytes()
    write_class_figure(path, class_report(a_class()))
    assert path.read_bytes() == first


def test_class_figure_of_hostile_names_and_of_nobody(tmp_path: Path):
    told = record(1)
    told["quantities"] = {text or "?": told["quantities"]["omega 3"] for text in (*HOSTILE, "$x$", "$\\frac", "x_1^")}
    told["mistakes"][0]["names"] = [[name("$\\x")], [name("=1")]]
    write_class_figure(tmp_path / "a.svg", class_report(results(told)), "zh")
    write_class_figure(tmp_path / "b.svg", class_report([]))
    assert fromstring((tmp_path / "a.svg").read_bytes()).tag.endswith("svg")
