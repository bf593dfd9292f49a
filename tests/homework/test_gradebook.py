"""The class as the teacher gets it: names, those who handed in nothing, totals, what to look at, whose numbers are whose;
and what a page of feedback says to its student."""

from __future__ import annotations

import re
from dataclasses import replace
from html import unescape
from pathlib import Path

import pytest
from test_platform_results import quantity, record, results, rows, table, unmarked

from graphkin.homework.grading import judge_from
from graphkin.homework.grading.sets import set_text
from graphkin.homework.platforms import write_gradebook, write_results
from graphkin.homework.platforms.class_table import with_copies
from graphkin.homework.platforms.feedback import Feedback, next_step, praise, without_place
from graphkin.homework.platforms.pages import html
from graphkin.homework.platforms.result import ResultPicture
from graphkin.submissions import Student

NAMES = {"s1": "Li Lei", "s2": "Han Mei", "s3": ""}
UNREAD = {"omega 3": quantity(0.0, 0.0, "rad/s", written="see drawing", verdict="not read")}


def test_those_who_handed_in_nothing_have_a_row(tmp_path: Path):
    write_results(tmp_path, results(record(1), unmarked(9)), "csv", names=NAMES)
    there = table(tmp_path / "class.csv")
    assert [(one["student"], one["name"], one["status"]) for one in there] == [
        ("s1", "Li Lei", "marked"), ("s9", "", "not marked"), ("s2", "Han Mei", "nothing handed in"),
        ("s3", "", "nothing handed in"),
    ]  # fmt: skip
    assert [one["look at"] for one in there] == ["", "not TOML", "", ""]


def test_a_gradebook_of_several_problems(tmp_path: Path):
    openpyxl = pytest.importorskip("openpyxl")
    book = {"p1": results(record(1), record(2)), "p2": results(record(1), unmarked(2), record(9, quantities=UNREAD))}
    write_results(tmp_path / "p1", book["p1"], "csv", names=NAMES)
    text = (tmp_path / "p1" / "class.csv").read_text("utf-8")
    head = rows(tmp_path / "p1" / "class.csv")[0]
    changed = ",".join("3" if name == "override" else "s2" if name == "student" else "" for name in head)
    (tmp_path / "p1" / "class.csv").write_text(text.splitlines()[0] + "\n" + changed + "\n", encoding="utf-8")
    write_gradebook(tmp_path, book, "csv", names=NAMES)
    assert [row[:5] for row in rows(tmp_path / "class.csv")] == [
        ["student", "name", "p1", "p2", "total"], ["s1", "Li Lei", "1.84", "1.84", "3.68"],
        ["s2", "Han Mei", "3", "not marked", "3"], ["s3", "", "nothing handed in", "nothing handed in", "0"],
        ["s9", "", "nothing handed in", "not marked", ""],
    ]  # fmt: skip
    write_gradebook(tmp_path, book, "xlsx", names=NAMES)
    _, look = openpyxl.load_workbook(tmp_path / "class.xlsx").worksheets
    assert [[cell or "" for cell in row] for row in look.iter_rows(min_row=2, values_only=True)] == [
        ["s2", "Han Mei", "p2", "s2.toml", "not TOML"], ["s9", "", "p2", "s9.toml", "ω3 not read: see drawing"],
    ]  # fmt: skip


def test_the_names_of_a_set(tmp_path: Path):
    assert judge_from("ex3-1").roster is None
    students = [Student("1", (("班级", "1"), ("姓名", "朱霞洋"))), Student("2")]
    (tmp_path / "key.json").write_text(set_text({"1": "1.key.json", "2": "2.key.json"}, students), "utf-8")
    assert judge_from(str(tmp_path)).roster.called == {"1": "朱霞洋", "2": ""}


# --- copies -----------------------------------------------------------------------------------


def numbers(student: str, given: tuple[float, ...], right: float = 5.0, verdict: str = "wrong") -> dict:
    each = {f"v {k}": quantity(1.0, 0.0, "m/s", given=x, right=right, verdict=verdict) for k, x in zip("ABCDE", given)}
    return record(1, student=student, quantities=each, mistakes=[])


OWN = (1.234, 7.771, 3.333, 5.0)


@pytest.mark.parametrize(
    ("other", "told"),
    [
        (OWN, "in 4 of 4"), ((*OWN[:3], 5.1), "in 3 of 4"), (tuple(x * 1.001 for x in OWN), ""), (OWN[:2], ""),
        ((5.0, 5.01, 4.99, 5.0), ""),
    ],
)  # fmt: skip
def test_the_same_wrong_numbers_are_told_to_the_teacher_of_both(other, told):
    first, second = with_copies(results(numbers("a", OWN), numbers("b", other)), "en")
    for result, whose in ((first, "b"), (second, "a")):
        assert result.remarks == ((f"the same numbers as {whose}, digit by digit, {told}",) if told else ())


def test_what_many_have_is_no_copy():
    """The right values; a common mistake's, calculated; and those of another student's problem are copies of a pair."""
    assert not any(one.remarks for one in with_copies(results(*(numbers(s, (5.0,) * 4, verdict="right") for s in "abc")), "en"))
    assert not any(one.remarks for one in with_copies(results(*(numbers(s, OWN) for s in "abcdef")), "en"))
    right = numbers("a", OWN[:3], 5.0, "right")
    for k, one in enumerate(right["quantities"].values()):
        one["right"] = OWN[k]
    assert all(one.remarks for one in with_copies(results(right, numbers("b", OWN[:3])), "en"))


# --- a page -----------------------------------------------------------------------------------


def page(told: dict, lang: str, reveal: str = "answer") -> Feedback:
    (result,) = results(told)
    problem = ResultPicture("Title <1>", "image/svg+xml", b'<svg width="9mm" viewBox="0 0 9 9"></svg>')
    return Feedback(result, lang, reveal, (), {result.student: "Li Lei"}, problem)  # type: ignore[arg-type]


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_a_page_has_a_name_a_title_and_letters_of_the_sheets(lang):
    note = "C:\\marks\\sub/class.csv:26, answers.omega 3: 'x' is off. Also sub/other.svg:3 of it."
    whole = html(page(record(1, notes=[note]), lang)).decode()
    shown = unescape(re.sub("<style>.*?</style>|<[^>]*>", "", whole, flags=re.S))
    for text in ("Li Lei", "Title <1>", "ω3", "'x' is off. Also other.svg of it."):
        assert text in shown
    for text in ("a_k", "a^k", "omega 3", "sub/", "marks", ".csv"):
        assert text not in shown
    assert '<svg role="img" aria-label="' in whole


@pytest.mark.parametrize(
    ("changes", "step", "good"),
    [
        ({}, "Look again at how angular velocities are read off. Then find ω3, α3 again.", "0 of 3 values are right; 2 follow"),
        ({"mistakes": []}, "Check the sense (sign) of α3.", "1 of 3 values are right; 1 follow"),
        ({"quantities": UNREAD}, "Write ω3 again as a number with its unit", ""),
        ({"quantities": {"omega 3": quantity(1.0, 1.0, "rad/s", given=0.5, verdict="right")}, "mistakes": []}, "", "Well done"),
    ],
)  # fmt: skip
def test_one_next_step_and_a_word_to_good_work(changes, step, good):
    told = record(1, **changes)
    if not changes.get("quantities"):
        told["quantities"]["alpha 3"]["verdict"] = "wrong" if "mistakes" in changes else "carried"
        told["quantities"]["omega 3"] |= {"verdict": "right", "credit": 1.0} if "mistakes" in changes else {}
        told["quantities"]["v B3"]["verdict"] = "right"
    if changes.get("quantities") is UNREAD:
        told["mistakes"] = []
    one = page(told, "en")
    assert next_step(one).startswith(step)
    assert bool(next_step(one)) == bool(step)
    assert good in praise(one.result, "en")
    assert next_step(replace(one, reveal="hint")).count("Look again") == bool(told["mistakes"])


@pytest.mark.parametrize(
    ("text", "rest"),
    [
        ("sub/class.csv:26: no number", "no number"), ("a b.svg: the letter k: twice", "the letter k: twice"),
        ("class.zip!x/y.toml, omega 3: no", "omega 3: no"), ("passed over", "passed over"),
        ("sub/class.csv:26，omega 3：不是", "不是"),
    ],
)  # fmt: skip
def test_no_path_of_the_teachers_machine(text, rest):
    assert without_place(text, "en").endswith(rest)
    assert "csv" not in without_place(text, "en")
