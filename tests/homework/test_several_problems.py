"""Several problems of one student: a mistake that shows in many of them is told as a habit."""

from __future__ import annotations

import csv
import json
import re
import zipfile
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner, Result

from graphkin.cli import main
from graphkin.homework.grading import key_from
from graphkin.marking import MISTAKES
from graphkin.marking.diagnosis import Trace, added, habits
from graphkin.marking.key import Key
from graphkin.outputs.key_json import key_text
from graphkin.say.marks import mistake_kind

NAMES = ("ex3-1", "ex3-4", "s3-guide", "ex3-5")


def run(*words: object) -> Result:
    return CliRunner().invoke(main, ["grade", *map(str, words)])


def answers(key: Key, id: str, rng: np.random.Generator) -> dict[str, str]:
    """The key's quantities with a mistake, drawn by a pencil; all right where it is none of this problem's."""
    rows = [k for k, names in enumerate(key.singles.names) if names[0][0] == id]
    right = np.array([entry.right for entry in key.entries])
    scatters = np.array([entry.scatter for entry in key.entries])
    values = np.where(np.isfinite(key.singles.values[rows[0]]), key.singles.values[rows[0]], right) if rows else right
    drawn = values + 0.5 * scatters * rng.standard_normal(len(right))
    return {entry.text: f"{value:.6g} {entry.unit}" for entry, value in zip(key.entries, drawn, strict=True)}


@pytest.fixture(scope="module")
def homework(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Three problems with a Coriolis term, and one without, that a habit cannot show in; a.. make it in all of these."""
    folder = tmp_path_factory.mktemp("homework")
    for name in ("keys", "in"):
        (folder / name).mkdir()
    rng = np.random.default_rng(5)
    made = {
        "habit": ["coriolis-reversed"] * 3 + [""], "once": ["coriolis-reversed", "", "", ""], "right": [""] * 4,
        "other": ["normal-outward", "", "", "normal-outward"], "absent": ["coriolis-reversed", "coriolis-reversed"],
    }  # fmt: skip
    for k, name in enumerate(NAMES):
        key = key_from(name)
        (folder / "keys" / f"p{k}.key.json").write_text(key_text(key), encoding="utf-8")
        rows = {student: answers(key, ids[k], rng) for student, ids in made.items() if k < len(ids)}
        head = ["student", *(entry.text for entry in key.entries)]
        lines = [",".join(f'"{text}"' for text in head)]
        lines += [",".join([student, *(row[text] for text in head[1:])]) for student, row in rows.items()]
        (folder / "in" / f"p{k}.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    return folder


@pytest.fixture(scope="module")
def results(homework: Path) -> Path:
    done = run(homework / "keys", homework / "in", "-o", homework / "out", "--format", "report", "--format", "moodle",
               "--format", "gradescope", "--format", "csv", "--lang", "en")  # fmt: skip
    assert done.exit_code == 0, done.output
    return homework / "out"


HABIT = "In 3 of 4 problems: the Coriolis acceleration pointing the other way."


def told(results: Path, problem: str, student: str) -> str:
    return (results / problem / "gradescope" / student / "results.json").read_text("utf-8")


def test_feedback_tells_a_habit(results: Path):
    for k in range(4):
        assert HABIT in told(results, f"p{k}", "habit")
        for student in ("once", "right"):
            assert "problems:" not in told(results, f"p{k}", student)
    assert "In 2 of 4 problems: the normal acceleration laid off outward." in told(results, "p1", "other")
    assert "In 2 of 2 problems: the Coriolis acceleration pointing the other way." in told(results, "p0", "absent")
    with zipfile.ZipFile(results / "p0" / "moodle-feedback.zip") as archive:
        assert not archive.namelist()  # a class table has no names of Moodle's


def test_the_class_report_tells_habits(results: Path):
    words = (results / "p0" / "class-report.txt").read_text("utf-8")
    assert "in 3 of 4 problems the Coriolis acceleration pointing the other way: 1" in words
    data = json.loads((results / "p0" / "class-report.json").read_text("utf-8"))
    assert {(*each["ids"], each["in_problems"], each["of_problems"], each["count"]) for each in data["habits"]} == {
        ("coriolis-reversed", 3, 4, 1), ("coriolis-reversed", 2, 2, 1), ("normal-outward", 2, 4, 1),
    }  # fmt: skip


def test_the_class_table_has_a_column_of_habits(results: Path):
    with (results / "p0" / "class.csv").open(encoding="utf-8-sig", newline="") as file:
        rows = {row["student"]: row["in several problems"] for row in csv.DictReader(file)}
    assert re.fullmatch(r"the Coriolis acceleration pointing the other way \(3 of 4 problems, evidence \d+\.\d\)", rows["habit"])
    assert rows["once"] == rows["right"] == ""


def test_a_hint_tells_only_where_to_look(homework: Path, results: Path):
    done = run(homework / "keys", homework / "in", "-o", results, "--format", "gradescope", "--reveal", "hint", "--lang", "zh")
    assert done.exit_code == 0, done.output
    text = json.dumps(json.loads(told(results, "p0", "habit")), ensure_ascii=False)
    assert "4 题中有 3 题：检查科氏加速度。" in text
    assert "指向反了" not in text


def test_lines_name_the_problem(homework: Path):
    done = run(homework / "keys", homework / "in" / "p0.csv", homework / "in" / "p3.csv", "--json")
    assert [json.loads(line)["problem"] for line in done.stdout.splitlines()] == ["p0"] * 5 + ["p3"] * 4


def test_what_belongs_to_no_problem_is_refused(homework: Path, tmp_path: Path):
    stray = tmp_path / "p9.csv"
    stray.write_text("student,omega 3\ns1,3\n")
    done = run(homework / "keys", homework / "in", stray, "-o", tmp_path / "out", "--format", "csv", "--lang", "en")
    assert done.exit_code == 3
    assert "'p9'" in done.stderr
    assert "p0" in done.stderr
    assert not (tmp_path / "out").exists()
    assert run(homework / "keys", homework / "in", "-o", tmp_path / "out.json").exit_code == 2


# --- evidence ---------------------------------------------------------------------------------


def test_evidence_is_added():
    weights = added([Trace(("a",), {"a": 10.0, "b": 9.0}), Trace(("a", "b"), {"a": 10.0, "b": -50.0}), Trace((), {})])
    assert weights["a"] == pytest.approx(2 * (10 + np.log(0.8)) + np.log(0.2), abs=1e-3)
    assert weights["b"] == pytest.approx(9 + np.log(0.8) + 2 * np.log(0.2), abs=1e-3)


def test_the_sum_tells_apart_what_one_problem_cannot():
    traces = [Trace(("a", "b"), {"a": 10.0, "b": 10.0}), Trace(("a", "b"), {"a": 12.0, "b": 7.0}), Trace((), {})]
    (found,) = habits(traces)
    assert (found.ids, found.shown, found.of) == (("a",), 2, 3)
    (found,) = habits([traces[0], traces[0]])
    assert found.ids == ("a", "b")


@pytest.mark.parametrize(
    "traces",
    [
        [], [Trace(("a",), {"a": 40.0})], [Trace(("a",), {"a": 40.0}), Trace(("b",), {"b": 40.0})],
        [Trace(("a",), {"a": 3.0})] * 2 + [Trace((), {})] * 8,
    ],
)  # fmt: skip
def test_what_is_no_habit(traces: list[Trace]):
    assert habits(traces) == ()


def test_two_habits():
    both = [Trace(("a",), {"a": 9.0, "b": -9.0}), Trace(("b",), {"a": -9.0, "b": 9.0})] * 2
    assert sorted((one.ids, one.shown, one.of) for one in habits(both)) == [(("a",), 2, 4), (("b",), 2, 4)]


@pytest.mark.parametrize("id", MISTAKES)
def test_every_mistake_is_a_sentence(id: str):
    english, chinese = mistake_kind(id, "en"), mistake_kind(id, "zh")
    assert english != id != chinese != english
    assert english.split()[0] in ("the", "a", "an")
    assert "{" not in english + chinese
