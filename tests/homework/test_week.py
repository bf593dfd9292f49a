"""A week with a class and three problems, from the problems to the last gradebook, by the command line: nothing
handed in is lost, nothing is given to another, and all that is not read is shown to the teacher.
"""

from __future__ import annotations

import csv
import json
import re
import shutil
import zipfile
from collections import Counter
from pathlib import Path

import openpyxl
import pytest
from click.testing import CliRunner, Result
from the_week import (
    FATES,
    LATE,
    LEAST,
    MADE,
    MANY,
    STRANGER,
    TEMPLATES,
    HomeworkClass,
    packed,
    pupils,
    school_list,
    worksheet,
)

from graphkin.cli import main

Json = dict
PROBLEMS = {name: text for name, text in TEMPLATES.items() if MANY > LEAST or name != "p1"}
"""The first is left out for the small class: its drawings are handed in elsewhere."""
CLASS = HomeworkClass(tuple(pupils()), Path("week"))
POINTS = {"right": 4, "late": 4, "again": 4, "photograph": 4, "mistake": 3, "slip": 3}
"""In the end, of 4; what follows rightly from a slip is right."""
AT_FIRST = {**POINTS, "late": "", "again": 3, "photograph": ""}
BOOKS = ("--format", "csv", "--format", "xlsx", "--lang", "zh")


@pytest.fixture(autouse=True)
def in_a_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("docx", reason="needs graphkin[word]")
    monkeypatch.chdir(tmp_path)


def run(*words: str) -> Result:
    done = CliRunner().invoke(main, list(words))
    assert done.exit_code == 0, done.output
    return done


def grade(*words: str) -> Result:
    return run("grade", *words, "--roster", "worksheet.csv", *BOOKS)


def records(problem: str) -> list[Json]:
    return json.loads(Path("res", problem, "marks.json").read_text("utf-8"))["results"]


def rows(path: str) -> dict[str, dict[str, str]]:
    """The rows of a class table by student; where there are several of one, the one with points."""
    with Path(path).open(encoding="utf-8-sig", newline="") as file:
        table = [*csv.DictReader(file)]
    return {row["学号"]: row for row in sorted(table, key=lambda row: bool(row.get("总分")))}


def whose(file: str) -> str:
    """The student in whose folder a file lies; nobody of the class for a stranger."""
    number = int(re.search(r"_(\d+)_assignsubmission_file_/", file)[1])
    return next((one.id for one in CLASS.them if one.number == number), "")


def handed_out() -> None:
    """Monday: each has a problem of their own, and no key."""
    Path("list.csv").write_text(school_list(CLASS.them), "utf-8")
    Path("worksheet.csv").write_text(worksheet(CLASS.them), "utf-8")
    for problem, template in PROBLEMS.items():
        Path(f"{problem}.toml").write_text(template, "utf-8")
        run("problems", f"{problem}.toml", "--students", "list.csv", "--seed", "2028", "-o", f"week/{problem}", "--lang", "zh")
        there = {path.name for path in Path("week", problem, "students").iterdir()}
        assert there == {*(f"{one.id}.html" for one in CLASS.them), "_answers.xlsx", "_hand-in.html"}


def nothing_is_lost(problem: str, archives: list[Path]) -> None:
    """Each file of the archives has one record, and none is anybody's but the folder's; of no student there are two."""
    there = Counter(one["file"] for one in records(problem))
    assert set(there.values()) == {1}
    handed_in = [f"{path}!{name}" for path in archives for name in zipfile.ZipFile(path).namelist()]
    replaced = CLASS.of(problem, "again", "photograph") if len(archives) > 1 else []
    assert {*there} == {file for file in handed_in if "in/" not in file or whose(file) not in replaced}
    for one in records(problem):
        assert one["status"] == "not marked" if STRANGER in one["file"] else one["student"] == whose(one["file"])


def due() -> None:
    """Thursday: what Moodle has packed is marked; what could not be read is told, and the rest is right."""
    for problem in PROBLEMS:
        packed(Path("in", f"{problem}.zip"), CLASS.on_time(problem))
    grade("week", "in", "-o", "res")
    for problem in PROBLEMS:
        nothing_is_lost(problem, [Path("in", f"{problem}.zip")])
        there = {one["student"]: one for one in records(problem)}
        table = rows(f"res/{problem}/class.csv")
        for _, one, fate in CLASS.fates(problem):
            told, mine = table[one.id], there.get(one.id)
            assert told["姓名"] == one.name
            assert (told["状态"] == "未交") == (mine is None) == (fate in ("nothing", "late")), (problem, one, fate)
            assert told["总分"] == str(AT_FIRST.get(fate, "")) or fate == "copy", (problem, one, fate)
            if fate in ("mistake", "again"):
                assert MADE[problem] in mine["mistakes"][0]["ids"]
            if fate == "slip":
                assert [each["verdict"] for each in mine["quantities"].values() if each["points"]].count("carried") == 2
            if fate == "right":
                assert not mine.get("remarks")
            if fate == "copy":
                copied = CLASS.them[(CLASS.them.index(one) + 7) % MANY].id
                assert f"4 个量中有 4 个与 {copied} 的题目相符（前三位数字）" in told["请核对"]


def doubtful_in_the_terminal() -> str:
    """The lines of those whose work cannot be read."""
    for problem in PROBLEMS:
        doubtful = {"", *CLASS.of(problem, "unread", "photograph", "another's name")}
        packed(Path("doubtful", f"{problem}.zip"), {name: own for name, own in CLASS.on_time(problem).items() if whose(name) in doubtful})
    return run("grade", "week", "doubtful", "--roster", "worksheet.csv", "--lang", "zh").stdout


def every_doubt_is_listed() -> None:
    """In the tables, in the sheet of the workbook, and in the terminal: what is not read with what was written."""
    sheet = openpyxl.load_workbook("res/class.xlsx")["请核对"].iter_rows(min_row=2, values_only=True)
    listed = {(problem, student): [] for problem in PROBLEMS for student in ("", *(one.id for one in CLASS.them))}
    for student, _, problem, file, reason in sheet:
        listed[problem, student if student in CLASS.of(problem, *FATES) else ""].append((file, reason))
    whole, printed = rows("res/class.csv"), doubtful_in_the_terminal()
    for problem in PROBLEMS:
        table = rows(f"res/{problem}/class.csv")
        for student, written in CLASS.unread(problem).items():
            (_, reason), = listed[problem, student]
            assert reason.endswith(f"未能读出：{written} {unit}" if (unit := reason.rpartition(" ")[2]) in UNITS else written)
            assert reason in table[student]["请核对"]
            assert f"{problem}：{reason}" in whole[student]["请核对"]
            assert table[student]["总分"] == "" == whole[student][problem].replace("未评阅", "")
            assert written in printed
        for student in ("", *CLASS.of(problem, "photograph", "another's name")):
            (file, reason), = listed[problem, student]
            assert whose(file) == student
            assert file.removeprefix("in/") in printed
            assert reason.rstrip("。") in (whole[student] if student else whole["9001"])["请核对"]
        assert not any(listed[problem, student] for student in CLASS.of(problem, "right", "nothing", "late"))


UNITS = ("rad/s", "rad/s²", "m/s", "m/s²")


def late_work() -> None:
    """Friday: it is added, and takes the place of what the same student handed in before."""
    for problem in PROBLEMS:
        packed(Path("late", f"{problem}.zip"), CLASS.late(problem))
    before = {problem: {one["student"]: one for one in records(problem)} for problem in PROBLEMS}
    said = grade("week", "late", "-o", "res").stderr
    for problem in PROBLEMS:
        nothing_is_lost(problem, [Path("in", f"{problem}.zip"), Path("late", f"{problem}.zip")])
        now, again = {one["student"]: one for one in records(problem)}, CLASS.of(problem, "again", "photograph")
        assert {line.split("：")[0] for line in said.splitlines() if f"late/{problem}" in line} == {*again}
        assert {*now} == {*before[problem], *CLASS.of(problem, "late")}
        assert [now[student]["score"] for student in CLASS.of(problem, *LATE)] == [1.0] * (4 * MANY // LEAST)
        assert all(now[student] == one for student, one in before[problem].items() if student not in again)


def teacher(folder: str, given: dict[str, tuple[str, str]]) -> None:
    """Points and words that a grader writes into the table."""
    with Path(folder, "class.csv").open(encoding="utf-8-sig", newline="") as file:
        head, *table = csv.reader(file)
    for row in table:
        row[head.index("教师改分")], row[head.index("评语")] = given.get(row[0], ("", ""))
    with Path(folder, "class.csv").open("w", encoding="utf-8-sig", newline="") as file:
        csv.writer(file).writerows([head, *table])


def two_graders() -> dict[str, str]:
    """Each looks at some of what was not read, in a copy of their own; one student both of them judge, otherwise. The
    points that hold."""
    first, *rest, last = CLASS.of("p2", "unread", "another's name")
    own = {"A": dict.fromkeys((first, *rest[:2]), ("3.5", "A")), "B": dict.fromkeys((*rest[2:], last, first), ("2.5", "B"))}
    for grader, given in own.items():
        shutil.copytree("res/p2", f"{grader}/p2")
        teacher(f"{grader}/p2", given)
    said = run("grade", "week/p2", "A/p2/marks.json", "B/p2/marks.json", "--roster", "worksheet.csv", "-o", "res/p2", *BOOKS).stderr
    assert first in said
    held = {student: points for given in (own["B"], own["A"]) for student, (points, _) in given.items()}
    assert {student: row["教师改分"] for student, row in rows("res/p2/class.csv").items() if row["教师改分"]} == held
    return held


def a_changed_key() -> None:
    """Sunday: in the third problem v C is worth three points."""
    for path in Path("week/p3/teacher").glob("*.key.json"):
        key = json.loads(path.read_text("utf-8"))
        for each in key["quantities"]:
            each["points"] = 3 if each["text"] == "v C" else each["points"]
        path.write_text(json.dumps(key, ensure_ascii=False), "utf-8")
    grade("week", "late", "-o", "res")


def test_a_week():
    handed_out()
    due()
    every_doubt_is_listed()
    late_work()
    held = two_graders()
    a_changed_key()
    whole = rows("res/class.csv")
    for problem in PROBLEMS:
        for _, one, fate in CLASS.fates(problem):
            if fate in POINTS:
                assert whole[one.id][problem] == str(POINTS[fate] + 2 * (problem == "p3")), (problem, one, fate)
            elif problem == "p2" and one.id in held:
                assert whole[one.id][problem] == held[one.id]
            elif fate != "copy":
                assert whole[one.id][problem] == ("未交" if fate == "nothing" else "未评阅"), (problem, one, fate)
    for one in CLASS.them:
        row = whole[one.id]
        points = [float(row[problem]) for problem in PROBLEMS if row[problem][:1].isdecimal()]
        assert (row["姓名"], float(row["总分"]), row["满分"]) == (one.name, sum(points), str(4 * len(PROBLEMS) + 2))
