"""Late work, and the marks of two graders: added to what is there, nothing lost, nothing replaced unsaid."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from graphkin.cli import main

RIGHT, WRONG = "-3.92,62,2.5", "-5.65,12,0.1"


pytestmark = pytest.mark.usefixtures("own_folder")


def grade(*words: str, key: str = "ex3-1") -> Result:
    done = CliRunner().invoke(main, ["grade", key, *words])
    assert done.exit_code == 0, done.output
    return done


def table(name: str, **work: str) -> str:
    Path(name).write_text("student,omega 3,alpha 3,a_k B3B2\n" + "".join(f"{who},{values}\n" for who, values in work.items()))
    return name


def records(folder: str = "res") -> dict[str, dict]:
    found = json.loads(Path(folder, "marks.json").read_text("utf-8"))["results"]
    assert len({one["student"] for one in found}) == len(found)
    return {one["student"]: one for one in found}


def rows(folder: str = "res") -> dict[str, dict[str, str]]:
    with Path(folder, "class.csv").open(encoding="utf-8-sig", newline="") as file:
        return {row["student"]: row for row in csv.DictReader(file)}


def teacher(folder: str, **given: tuple[str, str]) -> None:
    """Points and words that a grader writes into the table."""
    whole = rows(folder)
    for student, (points, words) in given.items():
        whole[student] |= {"override": points, "comment": words}
    with Path(folder, "class.csv").open("w", encoding="utf-8-sig", newline="") as file:
        writer = csv.DictWriter(file, next(iter(whole.values())).keys())
        writer.writeheader()
        writer.writerows(whole.values())


def test_late_work_adds_and_replaces():
    grade(table("class.csv", **{f"s{k}": WRONG for k in range(45)}), "-o", "res", "--format", "csv")
    teacher("res", s3=("1.5", "see me"))
    said = grade(table("late.csv", s7=RIGHT, s50=RIGHT), "-o", "res", "--format", "csv").stderr
    assert "44 earlier records stay" in said
    assert "s7: late.csv:2 takes the place of class.csv:9" in said
    assert set(records()) == {f"s{k}" for k in (*range(45), 50)} == set(rows())
    assert records()["s7"]["score"] > records()["s8"]["score"]
    assert [(row["student"], row["override"], row["comment"]) for row in rows().values() if row["override"]] == [("s3", "1.5", "see me")]
    again = grade("late.csv", "-o", "res", "--format", "csv").stderr
    assert "takes the place" not in again
    assert set(records()) == set(rows())


def test_a_teacher_s_words_stand_on_that_student_s_page_alone():
    grade(table("class.csv", s1=WRONG, s2=RIGHT, s3=RIGHT), "-o", "res", "--format", "csv")
    teacher("res", s1=("2.5", "see <me>"), s2=("", "neat"))
    grade("class.csv", "-o", "res", "--format", "pages")
    pages = {path.stem: path.read_text("utf-8") for path in Path("res/pages").iterdir()}
    shown = {who: [text for text in ("2.5 of", "see &lt;me&gt;", "neat") if text in page] for who, page in pages.items()}
    assert shown == {"s1": ["2.5 of", "see &lt;me&gt;"], "s2": ["neat"], "s3": []}


def test_marks_are_given_up_for_other_marks_alone():
    """A late file that cannot be read, or a table that is another's by now, loses nobody's marks."""
    grade(table("class.csv", s1=RIGHT, s2=RIGHT), "-o", "r.json")
    Path("s1.toml").write_text("= = =")
    grade("s1.toml", table("class.csv", s9=RIGHT), "-o", "r.json")
    found = json.loads(Path("r.json").read_text("utf-8"))["results"]
    assert [(one["student"], one["status"]) for one in found] == [
        ("s1", "not marked"), ("s9", "marked"), ("s1", "marked"), ("s2", "marked"),
    ]  # fmt: skip
    Path("s1.toml").write_text('"omega 3" = -3.92')
    grade("s1.toml", "-o", "r.json")
    found = json.loads(Path("r.json").read_text("utf-8"))["results"]
    assert [(one["student"], one["file"], one["status"]) for one in found] == [
        ("s1", "s1.toml", "marked"), ("s9", "class.csv", "marked"), ("s2", "class.csv", "marked"),
    ]  # fmt: skip


def test_a_changed_tolerance_holds_for_those_who_are_kept_and_another_key_spoils_nothing():
    grade(table("class.csv", s1="-3.92,62,2.5", s2="-3.8,62,2.5"), "-o", "res", "--format", "csv")
    assert records()["s2"]["quantities"]["omega 3"]["verdict"] == "right"
    grade(table("late.csv", s3=RIGHT), "-o", "res", "--format", "csv", "--relative", "0.001")
    assert records()["s2"]["quantities"]["omega 3"]["verdict"] == "wrong"
    before = records()["s2"]
    grade(table("late.csv", s4=RIGHT), "-o", "res", "--format", "csv", key="ex3-4")
    assert records()["s2"] == before


def test_two_graders():
    for folder, students in (("gA", ("s1", "s2", "s3")), ("gB", ("s3", "s4", "s5"))):
        grade(table("class.csv", **dict.fromkeys(students, WRONG)), "-o", folder, "--format", "csv")
    teacher("gA", s1=("2", "=neat"), s3=("1", "A"))
    teacher("gB", s3=("3", "B"), s5=("", "words alone"))
    said = grade("gA/marks.json", "gB/marks.json", "-o", "gAB", "--format", "report").stderr
    assert "s3: 1 in gA/class.csv, but 3 in gB/class.csv" in said
    given = {who: (row["override"], row["comment"]) for who, row in rows("gAB").items()}
    assert given == {"s1": ("2", "'=neat"), "s2": ("", ""), "s3": ("1", "A; B"), "s4": ("", ""), "s5": ("", "words alone")}
    grade("gA/marks.json", "gB/marks.json", "-o", "gAB", "--format", "csv")
    assert {who: (row["override"], row["comment"]) for who, row in rows("gAB").items()} == given
    assert set(records("gAB")) == {"s1", "s2", "s3", "s4", "s5"}


def test_two_graders_who_read_other_work_of_a_student():
    """Both are there, and the second says so."""
    grade(table("a.csv", s1=RIGHT, s2=RIGHT), "-o", "gA", "--format", "json")
    grade(table("b.csv", s1=WRONG, s2=RIGHT), "-o", "gB", "--format", "json")
    found = [json.loads(line) for line in grade("gA/marks.json", "gB/marks.json", "--json").stdout.splitlines()]
    assert [(one["student"], one["status"]) for one in found] == [("s1", "marked"), ("s2", "marked"), ("s1", "not marked")]
    assert "a.csv" in found[2]["reason"]


def test_an_override_in_a_class_table_is_one_student_s():
    grade(table("class.csv", **{f"0{k}": WRONG for k in range(3, 9)}), "-o", "res", "--format", "csv")
    teacher("res", **{"05": ("4", "")})
    path = Path("res/class.csv")
    path.write_text(path.read_text("utf-8-sig").replace("\n05,", "\n5,"), "utf-8")  # as a spreadsheet spoils it
    grade("class.csv", "-o", "res", "--format", "csv")
    assert {who: row["override"] for who, row in rows().items() if row["override"]} == {"05": "4"}
    teacher("res", **{"05": ("", "")})
    path.write_text(path.read_text("utf-8-sig").replace("\n05,", "\nsomebody,"), "utf-8")
    teacher("res", somebody=("2", ""))
    grade("class.csv", "-o", "res", "--format", "csv")
    assert {who: row["override"] for who, row in rows().items() if row["override"]} == {"somebody": "2"}
