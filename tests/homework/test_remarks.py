"""Remarks that are for the teacher alone, and what students are told instead: how sure, and where it goes astray."""

from __future__ import annotations

import json
import re
import zipfile
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from test_platform_results import name, quantity, record, results

from graphkin import api, loads
from graphkin.cli import main
from graphkin.cli.marking import RESULT_FORMATS
from graphkin.files import library
from graphkin.homework.grading import SetMarker, judge_from, key_for
from graphkin.homework.grading.sets import Neighbours, set_text
from graphkin.homework.platforms.feedback import lines
from graphkin.marking.diagnosis import Diagnosis
from graphkin.marking.marker import Marker
from graphkin.marking.records import Departure, Graded, HandedNumber, Judged, Marked, StudentWork
from graphkin.outputs import marks_json
from graphkin.outputs.key_json import key_text
from graphkin.say import say
from graphkin.say.marks import grade_lines

ASKED = ("v B3", "omega 3", "a_n B3D", "a_k B3B2", "alpha 3")
ANGLES = {"20231001": 50, "20231002": 55, "20231003": 60, "20231004": 65, "20231005": 70}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A set of problems: example 3-1 at other angles of the crank."""
    folder = tmp_path_factory.mktemp("set")
    text = re.sub(r"(?m)^ask .*$", f"ask = {json.dumps(ASKED)}", library.load("ex3-1").text)
    for student, angle in ANGLES.items():
        own = text.replace("angle = 60", f"angle = {angle}")
        (folder / f"{student}.key.json").write_text(key_text(key_for(loads(own, name=student))), "utf-8")
    (folder / "key.json").write_text(set_text({student: f"{student}.key.json" for student in ANGLES}), "utf-8")
    return folder


@pytest.fixture(scope="module")
def judge(folder: Path) -> SetMarker:
    return judge_from(str(folder))


def right(judge: SetMarker, student: str) -> dict[str, float]:
    return {entry.text: entry.right for entry in judge.marker(student).key.entries if entry.points}


def remark(judge: SetMarker, student: str, numbers: dict[str, float]) -> list[str]:
    work = StudentWork(student, {text: HandedNumber(x) for text, x in numbers.items()})
    return [one.message("en") for one in judge.remarks(judge.marker(student).mark([work])[0])]


def test_another_students_numbers(judge: SetMarker):
    own, other = (right(judge, student) for student in ("20231001", "20231005"))
    printed = {text: float(f"{value:.3g}") for text, value in other.items()}
    assert remark(judge, "20231001", printed) == ["agrees with 20231005's problem to three digits in 5 of 5"]
    assert remark(judge, "20231005", printed) == []
    assert remark(judge, "20231001", own) == []
    one_own = {**printed, "omega 3": own["omega 3"]}
    assert remark(judge, "20231001", one_own) == ["agrees with 20231005's problem to three digits in 4 of 5"]
    assert remark(judge, "20231001", {**one_own, "alpha 3": own["alpha 3"]}) == []
    assert remark(judge, "20231001", dict([*printed.items()][:2])) == []  # two numbers agree with somebody's soon


def test_wrong_work_is_not_taken_for_anothers(judge: SetMarker):
    chance = np.random.default_rng(3)
    own = right(judge, "20231003")
    for _ in range(20):
        assert remark(judge, "20231003", {text: value * chance.uniform(0.5, 2) for text, value in own.items()}) == []
    for factor in (0.5, 2, -1):
        assert remark(judge, "20231003", {**own, "omega 3": factor * own["omega 3"]}) == []


def test_a_key_that_cannot_be_read_is_no_neighbour(folder: Path, tmp_path: Path):
    (tmp_path / "bad.json").write_text('{"quantities": [{"text": 1}]}')
    neighbours = Neighbours({"a": tmp_path / "none.json", "b": tmp_path / "bad.json", "c": folder / "20231001.key.json"})
    assert neighbours.students == ("c",)


def run(*words: str) -> str:
    done = CliRunner().invoke(main, ["grade", *words, "--lang", "en"])
    assert done.exit_code == 0, done.output
    return done.stdout


def texts_in(path: Path) -> str:
    if zipfile.is_zipfile(path):
        with zipfile.ZipFile(path) as archive:
            return "".join(archive.read(member).decode("utf-8") for member in archive.namelist())
    return path.read_text("utf-8-sig")


def test_only_the_teacher_sees_remarks(folder: Path, judge: SetMarker, tmp_path: Path):
    """In the terminal, the records, the class table and the report; on nothing that goes back to a student."""
    values = right(judge, "20231001")
    drawing = api.Drawing.of(judge.marker("20231003").method.mechanism)
    with zipfile.ZipFile(tmp_path / "class.zip", "w") as archive:
        archive.writestr("Li Lei_20231003_assignsubmission_file_/a.svg", drawing.sheet()._repr_svg_())
        archive.writestr("Han Mei_20231005_assignsubmission_file_/a.toml", "[answers]\n" + "".join(f'"{k}" = {v:.4g}\n' for k, v in values.items()))
    told = "agrees with 20231001's problem to three digits in 5 of 5"
    sheet = "graphkin's own sheet"
    text = run(str(folder), str(tmp_path / "class.zip"))
    assert (text.count(f"look: {told}"), text.count(sheet)) == (1, 1)
    out = tmp_path / "out"
    run(str(folder), str(tmp_path / "class.zip"), "-o", str(out), *(word for kind in RESULT_FORMATS for word in ("--format", kind)))
    seen = {str(path.relative_to(out)): texts_in(path) for path in sorted(out.rglob("*")) if path.is_file()}
    there = {name for name, text in seen.items() if "20231001" in text or sheet in text}
    assert there == {"marks.json", "class.csv", "class.xlsx", "class-report.txt", "class-report.json", "class-report.html"}
    data = {one["student"]: one for one in json.loads(seen["marks.json"])["results"]}
    lines_of = map(json.loads, run(str(folder), str(tmp_path / "class.zip"), "--json").splitlines())
    assert {line["student"]: line["remarks"] for line in lines_of} == {student: one["remarks"] for student, one in data.items()}
    assert data["20231005"]["remarks"] == [{"id": "another-student", "text": told}]
    assert [one["id"] for one in data["20231003"]["remarks"]] == ["own-sheet"]
    run(str(folder), str(out / "marks.json"), "-o", str(tmp_path / "again.json"))
    again = {one["student"]: one["remarks"] for one in json.loads((tmp_path / "again.json").read_text("utf-8"))["results"]}
    assert again == {student: one["remarks"] for student, one in data.items()}


# --- what a student is told -------------------------------------------------------------------


def told(told: dict, reveal: str, lang: str = "en") -> list[str]:
    (result,) = results(told)
    return [*lines(result, lang, reveal)]  # type: ignore[arg-type]


def mistake(probability: float, *ids: str) -> dict:
    names = [[name(id)] for id in ids]
    return {"ids": [*ids], "probability": probability, "margin": 3.0, "explains": ["omega 3"], "names": names}


@pytest.mark.parametrize(
    ("probability", "ids", "sure"),
    [(0.995, ("wrong-length",), "certainly"), (0.995, ("wrong-length", "omega-sense"), "probably"),
     (0.98, ("wrong-length",), "probably"), (0.6, ("wrong-length",), "possibly")],
)  # fmt: skip
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_how_sure_it_is_stands_in_words(probability, ids, sure, lang):
    text = "\n".join(told(record(1, mistakes=[mistake(probability, *ids)]), "mistake", lang))
    assert [level for level in ("certainly", "probably", "possibly") if say(f"marks.sure {level}", lang) in text] == [sure]


@pytest.mark.parametrize(
    ("sets", "topics"),
    [
        ([["image-mirrored", "omega-sense"], ["image-mirrored", "centre-ratio sense"]], ["image", "rotation"]),
        ([["image-mirrored", "omega-sense"], ["image-mirrored", "normal-size"]], ["image", "", "rotation", "normal"]),
        ([["image-mirrored"], ["image-mirrored", "normal-size"]], ["image"]),
        ([["omega-sense"], ["normal-size"]], ["", "rotation", "normal"]),
    ],
)
def test_what_all_sets_of_mistakes_share_is_sure(sets: list[list[str]], topics: list[str]):
    """Of the rest one is wrong: "" here."""
    names = [[dict(zip(("id", "way"), f"{each} ".split(" ")[:2], strict=True), of="omega 3", form="v") for each in some] for some in sets]
    found = told(record(1, mistakes=[{**mistake(0.9), "ids": [], "names": names}]), "mistake")
    looks = [say(f"mistakes.look {topic}", "en") if topic else say("feedback.next one of", "en", places="").strip() for topic in topics]
    assert any(" ".join(looks) + " Then find" in line for line in found)


def test_where_nothing_fits_the_first_value_astray_is_told():
    astray = {"quantity": "omega 3", "left": ["v_B3"], "right": ["v_B2", "v_B3B2"]}
    one = record(1, mistakes=[], departure=astray)
    there = "ω3 is the first value that leaves the right way: there v_B3 = v_B2 + v_B3B2 was to be drawn"
    for reveal, full in (("hint", False), ("mistake", True), ("answer", True)):
        text = "\n".join(told(one, reveal))
        assert "ω3 is the first value that leaves the right way" in text
        assert (there in text) is full
    assert "leaves the right way" not in "\n".join(told(record(1, departure=astray), "answer"))
    without = "\n".join(told(record(1, mistakes=[], departure={**astray, "left": [], "right": []}), "answer"))
    assert "look at it again" in without


def test_the_departure_is_in_the_record():
    astray = Departure("omega 3", ("v_B3",), ("v_B2", "v_B3B2"))
    judged = Judged("omega 3", "rad/s", -5.0, -3.9, 0.2, "wrong", points=1.0)
    graded = Graded("s1", "s1.toml", "", Marked("s1", (judged,), Diagnosis(), astray))
    written = marks_json.record(graded)
    assert written["departure"] == {"quantity": "omega 3", "left": ["v_B3"], "right": ["v_B2", "v_B3B2"]}
    assert results(written)[0].departure == astray
    assert "  ω3 is the first value that leaves the right way: there v_B3 = v_B2 + v_B3B2" in "\n".join(grade_lines(graded, "en"))


def test_what_follows_from_the_mistake_is_told_as_that():
    values = {
        "omega 3": quantity(1.0, 0.0, "rad/s", given=-5.65, verdict="wrong"),
        "alpha 3": quantity(1.0, 0.0, "rad/s^2", given=68.7, carried=9.458, own={"v B3": 1.0}, verdict="wrong"),
        "a_k B3B2": quantity(1.0, 1.0, "m/s^2", given=3.63, carried=3.625, verdict="carried", of_mistake=True),
    }
    explained = {**mistake(0.995, "slip"), "explains": ["omega 3", "alpha 3"]}
    text = "\n".join(told(record(1, quantities=values, mistakes=[explained]), "answer"))
    assert "aᵏ_B3B2: carried; you: 3.63 m/s²; follows from the mistake (3.625 m/s²): yes" in text
    assert "9.458" not in text
    assert "a slip in ω3 (everything after it follows from it) (almost certainly)" in text
    alone = "\n".join(told(record(1, quantities=values, mistakes=[]), "answer"))
    assert "it should be 9.458 rad/s²: yours is not" in alone
    assert "follows from the mistake" not in "\n".join(told(record(1, quantities=values), "hint"))


def test_an_arrow_that_is_reversed_is_told_to_be():
    """180° off, and no sign to check."""
    work = StudentWork("s", {"v B3": HandedNumber(0.2712, vector=-0.2712 * np.exp(1j * np.radians(72.52)))})
    text = re.sub(r"(?m)^ask .*$", 'ask = ["v B3"]', library.load("ex3-1").text)
    (marked,) = Marker(key_for(loads(text))).mark([work])
    written = marks_json.record(Graded("s", "s.toml", "", marked))
    assert written["quantities"]["v B3"]["reversed"] is True
    for reveal in ("mistake", "answer"):
        text = "\n".join(told(written, reveal))
        assert "180° off: the arrow is reversed" in text
        assert "Turn the arrow of v_B3 round" in text
        assert "sign" not in text


@pytest.mark.parametrize(("asked", "other"), [("v B3", ""), ("a_k B3B2", "a_k B2B3")])
def test_a_direction_that_is_the_opposite_one_is_told_with_its_motion(asked: str, other: str):
    text = re.sub(r"(?m)^ask .*$", f'ask = ["{asked}"]', library.load("ex3-1").text)
    one = Marker(key_for(loads(text)))
    right = one.directions.right[asked][1]
    (marked,) = one.mark([StudentWork("s", {asked: HandedNumber(abs(right), vector=-right)})])
    assert marked.judged[0].other == other
    told = "\n".join(grade_lines(Graded("s", "s.toml", "", marked), "en"))
    assert ("size right, direction reversed" + (": that of aᵏ_B2B3" if other else "")) in told
    assert "leaves the right way" not in told
    assert marked.score == 0.5


def test_a_decimal_point_is_told_without_the_equation():
    values = {"omega 3": quantity(1.0, 0.0, "rad/s", given=39.2, right=3.92, verdict="wrong")}
    departure = {"quantity": "omega 3", "left": ["v_B3"], "right": ["v_B2", "v_B3B2"]}
    text = "\n".join(told({**record(1, quantities=values, mistakes=[]), "departure": departure}, "mistake"))
    assert "look at the decimal point" in text
    assert "Check the decimal point of ω3." in text
    assert "leaves the right way" not in text
