"""Answers as students hand them in: numbers, names of quantities, files and whole classes."""

from __future__ import annotations

import cmath
import csv
import io
import json
import math
import os
import pickle
import signal
import sys
import time
import zipfile
from pathlib import Path

import pytest
from reading_all import read

from graphkin import api
from graphkin.errors import (
    NOWHERE,
    AnsweredTwice,
    HandedTwice,
    NoPaperScale,
    OtherDimension,
    TooMuch,
    TwoNames,
    UnknownStudent,
    WantsExtra,
)
from graphkin.submissions import Handed, Limits, ReadableProblem, guarded, handed_in, limited, pool, read_one, safe_name
from graphkin.submissions.answers import answers
from graphkin.submissions.archives import decoded
from graphkin.submissions.documents import read_lines
from graphkin.submissions.grammar import parsed_value
from graphkin.submissions.numbers import scale
from graphkin.submissions.questions import Questions
from graphkin.submissions.students import Roster, Student, owner

MECHANISM = api.load("ex3-1")
ASKED = ReadableProblem(MECHANISM, (*MECHANISM.ask, "v B", "v B3B2"))
TURN, ACCELERATION, SPEED = "rad/s", "rad/s^2", "m/s"

NUMBERS = (
    ("3.92", TURN, 3.92, None), ("−3,92 rad/s", TURN, -3.92, None), ("62 rad/s^2 ccw", ACCELERATION, 62, "ccw"),
    ("62 rad/s² (cw)", ACCELERATION, -62, "cw"), ("顺时针 3.92 rad/s", TURN, -3.92, "cw"),
    ("3.92 弧度/秒，逆时针", TURN, 3.92, "ccw"), ("-62 cw", ACCELERATION, -62, "cw"), ("60°", "rad", math.pi / 3, None),
    ("120 r/min", TURN, 4 * math.pi, None), ("120 转/分", TURN, 4 * math.pi, None), ("3.92 rad/s clockwise", TURN, -3.92, "cw"),
    ("3.92 counter-clockwise", TURN, 3.92, "ccw"), ("anticlockwise 3.92", TURN, 3.92, "ccw"), ("3.92 rad·s⁻¹ ↻", TURN, -3.92, "cw"),
    ("1.25×10⁻³ m/s", SPEED, 1.25e-3, None), ("1.2e3 mm/s", SPEED, 1.2, None), ("1,234.5 mm/s", SPEED, 1.2345, None),
    ("1.234,5 mm/s", SPEED, 1.2345, None), ("1 234,5 mm/s", SPEED, 1.2345, None), ("ω3 = 3.92 rad/s", TURN, 3.92, None),
    ("62 1/s^2", ACCELERATION, 62, None), ("62.2 rad/s/s", ACCELERATION, 62.2, None), ("＋３．９２", TURN, 3.92, None),
    (".5", "1", 0.5, None), ("250", "m", 0.25, None), ("9.84 in", "m", 0.249936, None), ("3.92 RPM", TURN, 3.92 * math.pi / 30, None),
)  # fmt: skip


@pytest.mark.parametrize(("text", "unit", "value", "sense"), NUMBERS)
def test_a_number_as_it_is_written(text, unit, value, sense):
    found = parsed_value(text, unit)
    assert found.value == pytest.approx(value, rel=1e-12)
    assert (found.sense, found.fault) == (sense, None)


@pytest.mark.parametrize("text", [
    "", "abc", "nan", "inf", "-inf", "1e308", "1e999999999", "9" * 150, "3.92.1", "3 92", "5 5", "3.9 - 4.1", "0x10", "1_000",
    "-62 ccw", "3 ccw or cw", "1,2,3", "..", "-", "1e", "3.92 furlong", "=cmd|' /C calc'!A0", "3,92, 4", "x" * 5000,
])  # fmt: skip
def test_what_is_no_number_has_no_value(text):
    found = parsed_value(text, TURN)
    assert found.value is None
    for lang in ("en", "zh"):
        assert found.fault.at(NOWHERE).message(lang)


def test_a_unit_of_another_kind_is_told_beside_the_number():
    found = parsed_value("3.9 m/s", TURN)
    assert found.value == 3.9
    assert isinstance(found.fault, OtherDimension)


def test_a_direction_beside_a_size():
    for text in ("0.32 m/s ∠ 90°", "0.32 90°", "0.32  90 deg", "32/100 90度"):
        assert parsed_value(text, SPEED).vector == pytest.approx(0.32j)


QUESTIONS = {
    "omega 3": "w3|ω3|omega_3|ω₃|OMEGA 3|\\omega_{3}|$\\omega_3$|ω3 (rad/s)|ω3/(rad·s^-1)|ω3 [r/min]|omega DC|角速度3|w_3, rad/s"
               "|角速度 ω3|构件3的角速度|摇杆的角速度 ω3|构件3的角速度 ω3|angular velocity of link 3|angular velocity ω3",
    "alpha 3": "alpha3|ε3|α_3|α₃ (rad/s²)|角加速度 3",
    "a_k B3B2": "aB3B2k|a^k_B3B2|a_B3B2^k|akB3B2|a_k_B3B2|a^{k}_{B_3B_2}|ak|aᵏB3B2|akb3b2|ab3b2k|a_cor B3B2|a_k B3/B2",
    "v B3B2": "vB3B2|v_{B3B2}|v B3/B2|vb3b2|v_{B_3B_2}|V_B3B2|v⃗_B3B2|速度 B3B2|v_r B3B2|v^r_B3B2|v_{B3B2}^r|vrB3B2",
    "v B": "vB|v_B2|v B1|v_{B}|B点的速度|点B速度大小|B点速度 vB|velocity of point B (m/s)",
    "a C": "C点加速度|加速度 a_C",
    "a_n B3D": "aⁿB3D|a^n_B3D|aB3Dn|a_n B3/D",
    "a_t B3D": "aτB3D|a^τ_B3D|a^t_{B3D}|aB3Dt",
    "v_x C": "vCx|v_C_x|v_x_C",
    "theta 3": "θ3|φ3|theta_3",
    "P13": "p_13|P_{13}|P 13",
    "omega 3/omega 1": "ω3/ω1|omega 3 / omega 1|w3/w1",
    "a_r B2B3": "a^r_B2B3|arB2B3",
}


@pytest.mark.parametrize(("key", "text"), [(key, text) for key, texts in QUESTIONS.items() for text in [key, *texts.split("|")]])
def test_a_question_as_it_is_typed(key, text):
    found = Questions(MECHANISM, ASKED.questions).read(text)
    assert found is not None
    assert found[0] == key


@pytest.mark.parametrize("text", ["hello", "omega", "a", "B3", "omega 9", "v Z", "", "student", "x" * 500, "a_k B", "v_r B", "{" * 50,
                                  "角速度 v_C", "B点速度 vC", "C点法向加速度", "构件2的角速度 ω3", "速度"])
def test_what_names_nothing(text):
    assert Questions(MECHANISM, ASKED.questions).read(text) is None


@pytest.mark.parametrize("text", [
    "0.01", "0.01 (m/s)/mm", "0.01 m/s/mm", "1 mm = 0.01 m/s", "100 mm : 1 m/s", "10 mm/s per mm", "0.01 m/(s·mm)",
    "0.01 m·s⁻¹/mm", "1cm=0.1m/s",
])  # fmt: skip
def test_a_scale_as_it_is_stated(text):
    assert scale(text, "velocity") == pytest.approx(0.01)


def test_lengths_on_paper():
    questions = Questions(api.load("ex3-5"), ())
    found = answers([("v C", "32 mm", NOWHERE), ("a C", "32 mm", NOWHERE), ("μv", "0.02 (m/s)/mm", NOWHERE)], questions, Limits())
    assert found.values["v C"].value == pytest.approx(0.64)
    stated = "acceleration" in questions.mechanism.scales
    assert stated or isinstance(found.values["a C"].fault, NoPaperScale)


def test_one_question_answered_twice():
    found = answers([("w3", 3.92, NOWHERE), ("ω3", "3.92 ccw", NOWHERE), ("ω2", 1, NOWHERE), ("w2", 2, NOWHERE)], Questions(MECHANISM), Limits())
    assert found.values["omega 3"].value == 3.92
    assert isinstance(found.values["omega 2"].fault, AnsweredTwice)
    assert found.values["omega 2"].text == "1; 2"


def test_a_direction_beside_its_size_in_a_table_of_its_own():
    raw = {"value": 0.271, "unit": "m/s", "direction": 252.5}
    entries = [("v B", raw, NOWHERE), ("v C", {**raw, "direction": "左"}, NOWHERE), ("v B3B2", [-0.08, -0.26], NOWHERE)]
    found = answers(entries, Questions(MECHANISM), Limits()).values
    assert math.degrees(cmath.phase(found["v B"].vector)) == pytest.approx(252.5 - 360)
    assert (found["v C"].vector, found["v B3B2"].vector) == (-0.271, -0.08 - 0.26j)


# --- files ------------------------------------------------------------------------------------

TOML = 'student = "s1"\n[answers]\n"omega 3" = 3.92\n"alpha 3" = "62 rad/s^2 ccw"\n"a_k B3B2" = 2.5\n'
OWN = {
    "a.toml": TOML.encode(),
    "b.json": json.dumps({"学号": "s1", "answers": {"ω3": "3,92", "α3": {"value": 62, "unit": "rad/s^2", "sense": "ccw"}, "ak": 2.5}}).encode(),
    "c.csv": "学号;ω3 (rad/s);α3;ak\ns1;3,92;62 逆时针;2,5\n".encode("gb18030"),
    "d.csv": "question,value,unit,sense\nstudent,s1\nomega 3,3.92,rad/s,\nalpha3,62,rad/s^2,ccw\nak,2.5,,\n".encode("utf-16"),
    "e.csv": "student,s1\nomega 3,3.92\nalpha 3,62 ccw\nak,2.5\n".encode("utf-8-sig"),
    "f.txt": "学号：s1\nω3 = 3.92 rad/s\nα3 = 62 rad/s² 逆时针\na^k_B3B2 = 2500 mm/s²\n".encode(),
}


@pytest.mark.parametrize("name", OWN)
def test_one_students_file(tmp_path: Path, name: str):
    (tmp_path / name).write_bytes(OWN[name])
    (found,) = read([tmp_path / name], ASKED)
    assert (found.student, found.reason) == ("s1", None)
    values = {question: value.value for question, value in found.values.items()}
    assert values == pytest.approx({"omega 3": 3.92, "alpha 3": 62, "a_k B3B2": 2.5})
    assert found.values["alpha 3"].sense == "ccw"
    assert pickle.loads(pickle.dumps(found)) == found


def test_a_class_in_one_table_streams(tmp_path: Path):
    path = tmp_path / "class.csv"
    with path.open("w", encoding="utf-8-sig", newline="") as stream:
        table = csv.writer(stream)
        table.writerow(["Student ID", "name", "ω3", "α3 (deg/s²)"])
        table.writerows([f"s{k}", "x", f"{k / 100} cw", ""] for k in range(1, 1001))
    found = list(read([path], ASKED))
    assert [(s.student, s.place) for s in found[:2]] == [("s1", "2"), ("s2", "3")]
    assert [s.values["omega 3"].value for s in found] == [-k / 100 for k in range(1, 1001)]
    assert all("alpha 3" not in s.values for s in found)
    assert next(iter(handed_in([path], Limits()))).row.student == "s1"


def test_a_workbook(tmp_path: Path):
    openpyxl = pytest.importorskip("openpyxl", reason="openpyxl reads workbooks; it is an extra")
    book = openpyxl.Workbook()
    for row in (["学号", "ω3", "α3"], [1001, -3.92, 62.2], ["x7", "3.9 rad/s cw", None]):
        book.active.append(row)
    book.save(tmp_path / "class.xlsx")
    found = list(read([tmp_path / "class.xlsx"], ASKED))
    assert [(s.student, {q: v.value for q, v in s.values.items()}) for s in found] == [
        ("1001", {"omega 3": -3.92, "alpha 3": 62.2}), ("x7", {"omega 3": -3.9}),
    ]  # fmt: skip


def test_a_workbook_without_its_reader(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setitem(sys.modules, "openpyxl", None)
    (tmp_path / "class.xlsx").write_bytes(b"PK")
    (found,) = read([tmp_path / "class.xlsx"], ASKED)
    assert isinstance(found.reason, WantsExtra)
    assert "pip install openpyxl" in found.reason.message("zh")


def zipped(path: Path, members: dict[str, bytes]) -> Path:
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in members.items():
            archive.writestr(name, content)
    return path


ANSWER = TOML.replace('student = "s1"', "").encode()


def test_moodles_download(tmp_path: Path):
    members = {
        "First Last_123_assignsubmission_file_/answers.toml": ANSWER,
        "王 小明_124_assignsubmission_file_/sheets/a.pdf": b"%PDF",
        "王 小明_124_assignsubmission_file_/b.toml": ANSWER,
        "Bad One_125_assignsubmission_file_/a.json": b"{",
        "Big One_126_assignsubmission_file_/a.json": b"0" * 3_000_000,
        "__MACOSX/x_127_assignsubmission_file_/._a": b"",
    }
    found = list(read([zipped(tmp_path / "m.zip", members)], ASKED))
    assert [(s.student, s.reason is None) for s in found] == [("123", True), ("124", True), ("125", False), ("126", False)]
    assert found[0].file == f"{tmp_path / 'm.zip'}!First Last_123_assignsubmission_file_/answers.toml"
    assert isinstance(found[3].reason, TooMuch)
    assert len(found[1].notes) == 1


def test_canvas_download_and_nested_folders(tmp_path: Path):
    members = {
        "studenttest_3143_207797_name.toml": ANSWER,
        "late_LATE_3144_207798_a.toml": ANSWER,
        "late_LATE_3144_207799_b.csv": b"question,value\nv B3B2,0.3\n",
    }
    found = list(read([zipped(tmp_path / "c.zip", members)], ASKED))
    assert [s.student for s in found] == ["3143", "3144"]
    assert found[1].values["v B3B2"].value == 0.3
    nested = {"hw 3/group a/s1.toml": ANSWER, "hw 3/group a/s2.toml": ANSWER, "hw 3/s3/a.toml": ANSWER, "hw 3/s3/b.json": b'{"v B": 1}'}
    found = list(read([zipped(tmp_path / "n.zip", nested)], ASKED))
    assert sorted(s.student for s in found) == ["s1", "s2", "s3"]


def test_a_key_for_each_student(tmp_path: Path):
    """The platform's word for who handed in goes before the file's."""
    folder = "_assignsubmission_file_/a.toml"
    members = {f"First Last_123{folder}": ANSWER, f"No One_9{folder}": ANSWER, f"Me_124{folder}": TOML.encode(), f"By Id_125{folder}": TOML.encode()}
    archive = zipped(tmp_path / "m.zip", members)
    found = list(read([archive], ASKED, roster=Roster(map(Student, ("Participant 123", "Not Me", "s1")))))
    assert [s.student for s in found] == ["Participant 123", "9", "124", "125"]
    assert [type(s.reason) for s in found] == [type(None), UnknownStudent, UnknownStudent, UnknownStudent]
    by_id = list(read([archive], ASKED, roster=Roster(map(Student, ("s0", "s1")))))
    assert [type(s.reason) for s in by_id] == [UnknownStudent, UnknownStudent, TwoNames, TwoNames]


def test_a_second_submission_is_not_marked_beside_the_first(tmp_path: Path):
    (tmp_path / "a.toml").write_text(TOML)
    (tmp_path / "b.toml").write_text(TOML)
    first, second = read([tmp_path / "a.toml", tmp_path / "b.toml"], ASKED)
    assert first.reason is None
    assert isinstance(second.reason, HandedTwice)


@pytest.mark.parametrize("form", ["files", "folder", "archive", "folders", "platform"])
@pytest.mark.parametrize("other", ["a", "z"])
def test_a_line_inside_makes_nobody_another(form: str, other: str, tmp_path: Path):
    """A file is whose name it bears; one that says it is another's, whose there is, is nobody's, first or last."""
    own, theirs = {
        "folders": ("s1/work.toml", f"{other}/work.toml"),
        "platform": ("s1_77_assignsubmission_file_/work.toml", f"{other}_11_assignsubmission_file_/work.toml"),
    }.get(form, ("s1.toml", f"{other}.toml"))
    members = {own: TOML.encode(), theirs: TOML.replace("3.92", "99").encode()}
    for name, content in members.items():
        (tmp_path / "all" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "all" / name).write_bytes(content)
    paths = [zipped(tmp_path / "m.zip", members)] if form in ("archive", "folders") else [tmp_path / "all"]
    paths = [tmp_path / "all" / name for name in sorted(members)] if form == "files" else paths
    roster = Roster([Student("s1", (("identifier", "77"),))]) if form == "platform" else None
    found = {s.file.endswith(own): s for s in read(paths, ASKED, roster=roster)}
    assert (found[True].student, found[True].reason, found[True].values["omega 3"].value) == ("s1", None, 3.92)
    assert isinstance(found[False].reason, UnknownStudent if form == "platform" else TwoNames)
    assert found[False].student != "s1"
    assert not found[False].values


def test_of_two_students_that_there_are_a_file_is_neither():
    """One named after it, and one in a line, both in the class."""
    handed = Handed(owner("s2.toml"), "s2.toml", files=(("s2.toml", TOML.encode()),))
    assert isinstance(read_one(handed, ASKED, roster=Roster(map(Student, ("s1", "s2")))).reason, TwoNames)
    assert read_one(handed, ASKED, roster=Roster([Student("s1")])).student == "s1"


def test_a_file_with_a_line_keeps_its_drawing(tmp_path: Path):
    for name in ("s1.toml", "s1.json"):
        (tmp_path / name).write_text(TOML if name == "s1.toml" else '{"v B": 1}')
    assert [(s.student, s.reason) for s in read([tmp_path], ASKED)] == [("s1", None)]


def test_what_hangs_is_given_up(tmp_path: Path):
    (tmp_path / "a.txt").write_text(("a" * 400 + "\n") * 2000 + "w3 = 1\n")
    (found,) = (read_one(handed, ASKED, Limits(seconds=1e-6)) for handed in handed_in([tmp_path / "a.txt"], Limits()))
    assert type(found.reason).__name__ == "TookTooLong"


def hangs_or_dies(numbers: list[int]) -> list[int]:
    pool._LATER = 0.3  # in the process that works
    if 3 in numbers:
        os._exit(9)
    while 5 in numbers:
        time.sleep(0.1)
    if 7 in numbers:  # as a library's own code that hears no alarm
        signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGALRM})
        with limited(0.1, NOWHERE):
            time.sleep(60)
    return numbers


def test_what_hangs_or_dies_takes_nobody_with_it(monkeypatch: pytest.MonkeyPatch):
    """A worker that is only slow to start is given its time: none of the others is lost to it."""
    monkeypatch.setattr(pool, "_GRACE", 3.0)
    found = guarded(hangs_or_dies, ([k, k + 1] for k in range(0, 8, 2)), 1, 0.1, lambda number, why: why)
    assert list(found) == [0, 1, 2, "died", 4, "hung", 6, "hung"]


def test_a_table_that_hangs_is_given_up(tmp_path: Path):
    (tmp_path / "a.csv").write_text("student,w3\n" + "," * 2_000_000 + "\n" + ("\n" * 2_000_000))
    (found,) = read([tmp_path / "a.csv"], ASKED, Limits(seconds=0.05))
    assert type(found.reason).__name__ in ("TookTooLong", "BrokenSubmission")


@pytest.mark.parametrize("student", ["s1", "../../etc/passwd", "a/b", "CON", "学号1", "", ".", "x" * 500, "A", "a", "a b", "\ud800", "nul\0"])
def test_no_id_is_a_path(student: str):
    name = safe_name(student)
    assert name == name.strip(". /\\") != ""
    assert not set(name) & set('/\\:*?"<>|\0')
    assert len(name) < 100


def test_ids_that_differ_have_names_that_differ():
    ids = ["A", "a", "a b", "a-b", "a/b", "a\\b", "学", "..", "", "con", "CON"]
    assert len({safe_name(student).lower() for student in ids}) == len(ids)
    assert owner("x/../../y.toml").student != ""


def test_nothing_else_is_needed_to_read_a_row():
    """A class of 100,000 at 300 a second leaves the reader a tenth of its time."""
    table = io.StringIO("student,w3,alpha 3,ak\n" + "".join(f"s{k},3.9 cw,62,2.5\n" for k in range(300)))
    from graphkin.submissions.documents import rows_of
    from graphkin.submissions.handed import Handed

    rows = rows_of(((k, row) for k, row in enumerate(csv.reader(table), 1)), NOWHERE, Limits())
    handed = [Handed(owner("c.csv"), "c.csv", str(row.line), row=row) for row in rows]
    start = time.process_time()
    found = [read_one(each, ASKED) for each in handed]
    assert time.process_time() - start < 1.0
    assert all(len(s.values) == 3 for s in found)


def test_lines_as_they_come_from_a_phone_or_a_word_processor():
    """Wide equals signs, curly quotes; in the encoding of a Chinese system."""
    text = "学号：s1\r\nω3＝3.92 顺时针\r\n“alpha 3” = “62 ccw”\r\nakB3B2≈2.5\r\n"
    found = read_lines(decoded(text.encode("gb18030"), NOWHERE), NOWHERE, Limits())
    assert found.student == "s1"
    assert [entry[:2] for entry in found.entries] == [("ω3", "3.92 顺时针"), ("alpha 3", "62 ccw"), ("akB3B2", "2.5")]
