"""Answers that were not read: shown as written, worth nothing either way; and directions beside sizes, judged."""

from __future__ import annotations

import cmath
import json
import math
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from graphkin.cli import main
from graphkin.homework.grading import key_from
from graphkin.marking.marker import Marker
from graphkin.marking.records import HandedNumber, StudentWork, by_position
from graphkin.outputs.key_json import key_text

Json = dict[str, Any]
MARKER = Marker(key_from("ex3-5"))
KEY = key_text(MARKER.key)


@pytest.fixture(autouse=True)
def in_a_folder(own_folder: Path) -> None:
    Path("key.json").write_text(KEY, encoding="utf-8")


def run(*words: str) -> str:
    done = CliRunner().invoke(main, list(words))
    assert done.exit_code == 0, done.output
    return done.stdout


def graded(answers: dict[str, str]) -> Json:
    """The line of one student's answers."""
    Path("s1.json").write_text(json.dumps({"student": "s1", "answers": answers}), encoding="utf-8")
    return json.loads(run("grade", "key.json", "s1.json", "--json"))


CLASS = "student,omega 2,omega 3,v E\na,-2.62,2.85,0.1943\nb,3 or 4,see drawing,0.1943 m/s up\nc,-2.62,—,0.1943\n"


def test_what_is_not_read_waits_for_the_teacher_and_what_is_missing_costs():
    read, unread, missing = (
        graded({"omega 2": "-2.62", "v E": "0.1943", **more}) for more in ({"omega 3": "2.85"}, {"omega 3": "2.9?"}, {"omega 3": "—"})
    )
    one = unread["quantities"]["omega 3"]
    assert (one["given"], one["verdict"], one["written"]) == (None, "not read", "2.9?")
    assert (missing["quantities"]["omega 3"]["verdict"], "written" in missing["quantities"]["omega 3"]) == ("missing", False)
    assert read["score"] == pytest.approx(3 / 8)
    assert unread["score"] is None  # until the teacher has looked
    assert missing["score"] == pytest.approx(2 / 8)
    assert graded(dict.fromkeys(read["quantities"], "abc"))["score"] is None


def test_it_stands_in_the_terminal_and_in_every_file_of_a_class():
    Path("class.csv").write_text(CLASS, encoding="utf-8")
    rows = [row.split() for row in run("grade", "key.json", "class.csv").splitlines()]
    tolerance = next(entry.tolerance for entry in MARKER.key.entries if entry.text == "omega 3")
    assert ["ω3", "see", "drawing", "2.853", f"±{tolerance:.4f}", "rad/s", "not", "read"] in rows
    run("grade", "key.json", "class.csv", "-o", "out", "--format", "csv")
    table = Path("out/class.csv").read_text("utf-8-sig").splitlines()
    assert '"not read ""3 or 4""",,"not read ""see drawing""",,' in table[2]
    assert table[1].startswith("a,,class.csv,marked,3,8,,3,37.5,")
    assert table[2].startswith("b,,class.csv,marked,0.5,8,,,,")  # no total until the teacher has looked
    assert table[2].endswith(",ω2 not read: 3 or 4; ω3 not read: see drawing,")
    assert "not read" not in table[1] + table[3]
    run("grade", "key.json", "class.csv", "-o", "out", "--format", "report")
    report = Path("out/class-report.txt").read_text("utf-8")
    assert "Look at these: answers that were not read\n  b, ω2: 3 or 4\n  b, ω3: see drawing\n" in report
    assert json.loads(Path("out/class-report.json").read_text("utf-8"))["not_read"][1] == {
        "student": "b", "quantity": "omega 3", "written": "see drawing",
    }  # fmt: skip
    assert "not read" in Path("out/class-report.svg").read_text("utf-8")
    run("grade", "key.json", "class.csv", "-o", "out", "--format", "pages", "--lang", "zh")
    page = Path("out/pages/b.html").read_text("utf-8")
    assert '<td class="number">see drawing</td>' in page
    assert "未能读出" in page


def test_marks_that_are_marked_anew_keep_it():
    Path("class.csv").write_text(CLASS, encoding="utf-8")
    run("grade", "key.json", "class.csv", "-o", "out", "--format", "csv")
    before, again = (
        [json.loads(line)["quantities"] for line in run("grade", "key.json", file, "--json").splitlines()]
        for file in ("class.csv", "out/marks.json")
    )
    assert before == again
    assert before[1]["omega 3"]["written"] == "see drawing"
    assert before[1]["v E"]["verdict"] == "wrong"


def test_it_stays_at_its_position():
    works = by_position(StudentWork("s", {"omega 3": HandedNumber(1.0)}, {"omega 3 #2": "?", "alpha 3": "!"}), 2)
    assert [(dict(work.numbers), dict(work.unread)) for work in works] == [
        ({"omega 3": HandedNumber(1.0)}, {"alpha 3": "!"}), ({}, {"omega 3": "?"}),
    ]  # fmt: skip


def test_the_answer_table_of_a_handout_retyped():
    """Quantity, answer, unit, sense: a dash where there is no sense, and in rows that are left empty."""
    rows = ("quantity,answer,unit,sense", "ω2,2.62,rad/s,cw", "ω3,2.85,rad/s,ccw", "α2,—,rad/s²,—", "α3,,rad/s²,", "v_E,0.1943,m/s,—")
    Path("s1.csv").write_text("\n".join(rows), encoding="utf-8")
    line = json.loads(run("grade", "key.json", "s1.csv", "--json"))
    verdicts = {text: one["verdict"] for text, one in line["quantities"].items()}
    assert verdicts == {
        "theta 2": "missing", "theta 3": "missing", "omega 2": "right", "omega 3": "right", "alpha 2": "missing",
        "alpha 3": "missing", "v E": "right", "a E": "missing",
    }  # fmt: skip


@pytest.mark.parametrize("head", ["sense, angle to +x", "方向", "转向或与 +x 夹角"])
def test_a_bare_number_in_the_column_of_directions_is_degrees(head: str):
    size, angle = answer("v E").split(" ∠ ")
    for turn, verdict in ((0, "right"), (90, "wrong")):
        row = f"v_E,{size},m/s,{float(angle.rstrip('°')) + turn:g}"
        Path("s1.csv").write_text(f'quantity,answer,unit,"{head}"\n{row}\n', encoding="utf-8")
        assert json.loads(run("grade", "key.json", "s1.csv", "--json"))["quantities"]["v E"]["verdict"] == verdict


def test_a_table_under_the_heads_of_our_own_files():
    Path("s1.csv").write_text("学号,s1\n所求量,结果,单位\nω2,-2.62,rad/s\n", encoding="utf-8")
    assert json.loads(run("grade", "key.json", "s1.csv", "--json"))["quantities"]["omega 2"]["verdict"] == "right"


def test_a_name_that_means_nothing_is_looked_at_where_an_answer_is_missing():
    Path("class.csv").write_text("student,omega 2,E 的快慢\na,-2.62,0.1943\n", encoding="utf-8")
    run("grade", "key.json", "class.csv", "-o", "out", "--format", "csv")
    assert "'E 的快慢' names no quantity" in Path("out/class.csv").read_text("utf-8-sig").splitlines()[1]


# --- directions --------------------------------------------------------------------------------


def answer(text: str, turn: float = 0.0, form: str = "angle") -> str:
    """The right vector of a quantity, turned by so many degrees, as a student writes it."""
    vector = MARKER.directions.right[text][1] * cmath.rect(1, math.radians(turn))
    if form == "angle":
        return f"{abs(vector):.4g} ∠ {math.degrees(cmath.phase(vector)):.4g}°"
    if form == "pair":
        return f"({vector.real:.4g}, {vector.imag:.4g})"
    names = ("right", "up-right", "up", "up-left", "left", "down-left", "down", "down-right")
    return f"{abs(vector):.4g} {names[round(math.degrees(cmath.phase(vector)) / 45) % 8]}"


@pytest.mark.parametrize(("form", "turn", "right"), [
    *(("angle", turn, abs(turn) < 15) for turn in (0, 12, -12, 18, -18, 90, 180)), ("pair", 0, True), ("pair", 180, False),
    ("words", 0, True), ("words", 180, False), ("words", 90, False),
])  # fmt: skip
@pytest.mark.parametrize("text", ["v E", "a E"])
def test_a_direction_that_is_given_is_judged(text: str, form: str, turn: float, right: bool):
    one = graded({text: answer(text, turn, form)})["quantities"][text]
    assert (one["verdict"], one["sense"]) == (("right", "right") if right else ("wrong", "wrong"))


def test_a_size_alone_is_right_and_a_wrong_direction_is_worth_half():
    assert graded({"v E": "0.1943"})["quantities"]["v E"]["sense"] is None
    assert graded({"v E": answer("v E")})["score"] == pytest.approx(1 / 8)
    assert graded({"v E": answer("v E", 180)})["score"] == pytest.approx(1 / 16, abs=1e-6)
    assert "size right, direction reversed" in run("grade", "key.json", "s1.json")
    assert graded({"v E": answer("v E", 90)})["score"] == pytest.approx(1 / 16, abs=1e-6)
    assert "wrong direction" in run("grade", "key.json", "s1.json")


def test_a_direction_that_follows_from_ones_own_is_right():
    """Whoever turns the driver round turns the polygon with it: one direction is wrong, and no further one."""
    own = {text: answer(text, 180) for text in ("v B", "v E", "v C")}
    wrong = [text for text, one in graded(own)["quantities"].items() if one["sense"] == "wrong"]
    assert wrong == ["v B"]
    assert graded({"v E": answer("v E", 180)})["quantities"]["v E"]["sense"] == "wrong"
