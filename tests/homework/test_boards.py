"""Files of the drawing board, graded: right ones, each of eight mistakes, files that are broken."""

from __future__ import annotations

import json
from functools import lru_cache
from pathlib import Path

import pytest
from board_student import BoardStudent, StudentHand
from click.testing import CliRunner

from graphkin import load, loads
from graphkin.cli import main
from graphkin.errors import Where
from graphkin.files import MechanismFile
from graphkin.homework.grading import OneKey, grade, key_for
from graphkin.homework.platforms.result import from_record
from graphkin.marking.marker import Marker
from graphkin.marking.records import Graded
from graphkin.outputs.marks_json import record
from graphkin.say.boards import choice_words, step_line
from graphkin.say.marks import grade_lines
from graphkin.submissions.board import work_data, work_of


@lru_cache(maxsize=8)
def judge(text: str) -> OneKey:
    return OneKey(Marker(key_for(loads(text))))


@lru_cache(maxsize=4)
def library(name: str) -> MechanismFile:
    return load(name)


def graded(tmp_path: Path, mechanism: MechanismFile, text: str) -> Graded:
    (tmp_path / "s1.svg").write_text(text, encoding="utf-8")
    one, *none = grade(judge(mechanism.text), tmp_path / "s1.svg")
    assert not none
    return one


def marked(tmp_path: Path, student: BoardStudent):
    one = graded(tmp_path, student.source, student.file())
    assert one.marked is not None, one.reason and one.reason.message("en")
    return one.marked


def assert_right(one) -> None:
    assert one.faults == ()
    assert one.step is None
    assert not one.diagnosis.explanations
    asked = [line for line in one.judged if line.points]
    assert {line.verdict for line in one.judged if line.given is not None} == {"right"}
    assert len(asked) > 2


# --- right work


@pytest.mark.parametrize("name", ["ex3-1", "ex3-7", "ex3-2"])
def test_right_boards_have_full_marks(tmp_path, name):
    one = marked(tmp_path, BoardStudent(library(name)))
    assert_right(one)
    assert one.score == 1
    equations = [line for line in one.judged if line.of_equations]
    assert [line.text for line in equations] == ["equations velocity", "equations acceleration"][: len(equations)]
    assert all(line.given == line.right and line.points == 1 for line in equations)


# --- mistakes: named by the numbers, and by the first step that leaves the right way

MISTAKES = {
    "driver-reversed": ("ex3-1", StudentHand(arrows={"v_B2": -1}),
                        "step 1: v_B2 was laid off the other way round: it points at 150.0° to +x",
                        "第 1 步：v_B2 的指向画反，应与 +x 成 150.0°"),
    "sliding-across": ("ex3-1", StudentHand(turned={("b3", "b2"): 1j}),
                       "step 4: the line through b2 was drawn across BC, it goes along BC",
                       "第 4 步：过 b2 的方向线画成 ⊥BC，应为 ∥BC"),
    "velocity-along-link": ("ex3-7", StudentHand(turned={("e", "d"): 1j}),
                            "step 8: the line through d was drawn along DE, it goes across DE",
                            "第 8 步：过 d 的方向线画成 ∥DE，应为 ⊥DE"),
    "normal-not-laid-off": ("ex3-1", StudentHand(through_others={("b3'", "n3'"): "p'"}),
                            "step 15: the line across BD was drawn through p′, it goes through n3′",
                            "第 15 步：方向线 ⊥BD 画成过 p′，应过 n3′"),
    "normal-outward": ("ex3-1", StudentHand(arrows={"a^n_B3D": -1}),
                       "step 11: aⁿ_B3D was laid off the other way round: it points B→D",
                       "第 11 步：aⁿ_B3D 的指向画反，应为 B→D"),
    "coriolis-reversed": ("ex3-1", StudentHand(sizes={"Coriolis": -1}),
                          "step 13: aᵏ_B3B2 was laid off the other way round: it points at 295.6° to +x",
                          "第 13 步：aᵏ_B3B2 的指向画反，应与 +x 成 295.6°"),
    "coriolis-half": ("ex3-1", StudentHand(sizes={"Coriolis": 0.5}),
                      "step 13: aᵏ_B3B2 was laid off 38.4 mm long, it is 76.7 mm",
                      "第 13 步：aᵏ_B3B2 画成 38.4 mm 长，应为 76.7 mm"),
    "image-mirrored": ("ex3-5", StudentHand(mirrored=frozenset({"e", "e'"})),
                       "step 6: e is not where the image of its link has it", "第 6 步：e 的位置与影像不符"),
}  # fmt: skip


@pytest.mark.parametrize("id", MISTAKES)
def test_mistakes_are_named(tmp_path, id):
    name, hand, en, zh = MISTAKES[id]
    one = marked(tmp_path, BoardStudent(library(name), hand))
    assert one.faults == ()
    assert one.score is not None
    assert id in {id for each in one.diagnosis.explanations for id in each.ids}
    assert one.step is not None
    assert (step_line(one.step, "en"), step_line(one.step, "zh")) == (en, zh)
    assert step_line(one.step, "en", in_full=False).startswith(f"step {one.step.step} of the drawing is the first")


@pytest.mark.parametrize(
    ("name", "hand", "said"),
    [
        ("ex3-1", StudentHand(through_others={("b3'", "k'"): "b2'"}),
         "step 16: the line along BC was drawn through b2′, it goes through k′"),
        ("ex3-1", StudentHand(arrows={"a_B2": 1j}), "step 9: a_B2 was laid off at 330.0° to +x, it points at 240.0°"),
        ("ex3-4", StudentHand(turned={("p", "c1"): 1j}),  # the pole is found at last
         "step 3: the line through c1 was drawn along AC, it goes across AC"),
        ("ex3-4", StudentHand(arrows={"v_C2C1": -1}),
         "step 1: v_C2C1 was laid off the other way round: it points at 67.3° to +x"),
    ],
)  # fmt: skip
def test_the_first_wrong_step(tmp_path, name, hand, said):
    """Further ones, where the numbers may go with several mistakes."""
    one = marked(tmp_path, BoardStudent(library(name), hand))
    assert one.step is not None
    assert step_line(one.step, "en") == said


class OnThePaper(BoardStudent):
    """Draws the mechanism's points, and where BC meets AD its instant centre 13, on its own paper first; one elsewhere."""

    astray = ""

    def data(self):
        whole = super().data()
        places = {name: complex(at) for name, at in self.right.position.items()}
        a, b, c, d = (places[name] for name in "ABCD")
        places["P13"] = a + (d - a) * ((b - a) * (c - b).conjugate()).imag / ((d - a) * (c - b).conjugate()).imag
        at = {name: (there - a) / 0.001 + 3 * (name == self.astray) for name, there in places.items()}
        drawn = [
            {"plane": "position", "tool": "point", "at": [[there.real, there.imag]], "name": name}
            for name, there in at.items()
        ]
        whole["steps"] = [{**step, "step": k} for k, step in enumerate([*drawn, *self.steps], 1)]
        whole["scales"] = {**self.scales, "position": 0.001}
        return whole


@pytest.mark.parametrize("astray", ["", "C", "P13"])
def test_points_of_the_mechanism_are_looked_at(tmp_path, astray):
    student = OnThePaper(loads(_CENTRE))
    student.astray = astray
    one = graded(tmp_path, student.source, student.file())
    assert one.marked is not None
    step = one.marked.step
    assert from_record(json.loads(json.dumps(record(one))), Where("marks.json")).step == step
    assert (step.plane, step.kind, step.what) == ("position", "place", astray) if astray else step is None
    assert not astray or step_line(step, "en").endswith("is not where it belongs on the mechanism")


_CENTRE = """
ask = ["P13", "omega 3"]
frame = {A = [0, 0], D = [60, 0]}
links = {1 = {AB = 20}, 2 = {BC = 50}, 3 = {DC = 40}}
driver = [{vector = "AB", angle = 70, omega = 10}]
sketch = {C = [50, 38]}
"""


class OtherOrder(BoardStudent):
    """Draws the Coriolis term first and the known acceleration from its end, without a letter between."""

    def data(self):
        whole = super().data()
        by_name = {(step["tool"], step.get("name")): step for step in self.steps}
        known, turned = by_name["vector", "a_B2"], by_name["vector", "a^k_B3B2"]
        (_, corner), (start, end) = known["at"], turned["at"]
        middle = [e - s for s, e in zip(start, end, strict=True)]
        known["at"], turned["at"] = [middle, [m + c for m, c in zip(middle, corner, strict=True)]], [[0.0, 0.0], middle]
        lost = (by_name["point", "b2'"], by_name["point", "k'"])
        whole["steps"] = [step for step in self.steps if step not in lost]
        return whole


def test_another_order_is_right(tmp_path):
    assert marked(tmp_path, OtherOrder(library("ex3-1"))).step is None


# --- equations


def test_equations_are_marked_term_by_term(tmp_path):
    choices = {
        ("velocity", 1, "v_B3B2"): ("C to B", "?"),  # as right: it may point either way
        ("velocity", 1, "v_B2"): ("given", "omega_1*l_AB"),
        ("acceleration", 1, "a^n_B3D"): ("D to B", "omega_2^2*l_BD"),  # links 2 and 3 turn together
        ("acceleration", 1, "a^k_B3B2"): ("parallel BC", "2*omega_3*v_B3B2"),
        ("acceleration", 1, "a_B2"): ("B to A", "omega_1^2*l_AB"),
        ("acceleration", 1, "a^t_B3D"): ("perpendicular BD", ""),
    }
    student = BoardStudent(library("ex3-1"), choices_of=choices)
    one = marked(tmp_path, student)
    by_name = {line.text: line for line in one.judged}
    assert by_name["equations velocity"].credit == 1
    assert by_name["equations acceleration"].credit == 7.5 / 10
    assert [(fault.term, fault.row, fault.written, fault.right, fault.sense) for fault in one.faults] == [
        ("a^n_B3D", "direction", "D to B", "B to D", True),
        ("a^t_B3D", "magnitude", "", "?", False),
        ("a^k_B3B2", "direction", "parallel BC", "perpendicular BC", False),
    ]
    shown = "\n".join(grade_lines(graded(tmp_path, student.source, student.file()), "en"))
    assert "equations acceleration" in shown
    assert "partly right" in shown
    assert "nothing was chosen" in shown
    assert [choice_words(token, "en") for token in ("omega_3^2*l_BD", "2*omega_2*v_B3B2", "parallel guide C", "given")] == [
        "ω3² l_BD", "2 ω2 v_B3B2", "∥guide of C", "√"
    ]  # fmt: skip


def test_points_of_equations_are_the_teachers(tmp_path):
    text = library("ex3-1").text.replace("[frame]", '[points]\n"equations velocity" = 3\n[frame]', 1)
    machine = loads(text, name="ex3-1")
    one = marked(tmp_path, BoardStudent(machine, choices_of={("velocity", 1, "v_B3"): ("", "")}))
    assert {line.text: line.points for line in one.judged if line.of_equations} == {
        "equations velocity": 3.0, "equations acceleration": 1.0
    }  # fmt: skip
    (tmp_path / "s2.toml").write_text('[answers]\n"omega 3" = "-3.92"\n', encoding="utf-8")
    (other,) = grade(judge(machine.text), tmp_path / "s2.toml")
    missed = [line for line in other.marked.judged if line.of_equations]
    assert [(line.text, line.verdict, line.points) for line in missed] == [("equations velocity", "missing", 3.0)]


# --- records and files


def test_records_hold_a_board_and_are_marked_anew(tmp_path):
    mechanism = library("ex3-1")
    choices = {("velocity", 1, "v_B3"): ("parallel BD", "?")}
    student = BoardStudent(mechanism, StudentHand(sizes={"Coriolis": -1}), choices_of=choices)
    one = graded(tmp_path, mechanism, student.file())
    whole = json.loads(json.dumps(record(one)))
    assert work_data(work_of(whole["board"])) == whole["board"]
    assert whole["step"]["kind"] == "reversed"
    assert whole["equations"][0]["right"] == "perpendicular BD"
    (tmp_path / "key.toml").write_text(mechanism.text, encoding="utf-8")
    key, folder = str(tmp_path / "key.toml"), tmp_path / "results"
    words = ["grade", key, str(tmp_path / "s1.svg"), "-o", str(folder), "--format", "csv", "--format", "pages"]
    done = CliRunner().invoke(main, words)
    assert done.exit_code == 0, done.output
    again = CliRunner().invoke(main, ["grade", key, str(folder / "marks.json"), "--json"])
    first, second = (json.loads(text) for text in (json.dumps(whole), again.output.splitlines()[0]))
    assert {key: first[key] for key in ("score", "step", "equations")} == {
        key: second[key] for key in ("score", "step", "equations")
    }
    page = (folder / "pages" / "s1.html").read_text("utf-8")
    assert "equations velocity" in page
    assert "5 of 6" in page
    assert "step 13" in page
    assert "equations velocity points" in (folder / "class.csv").read_text("utf-8-sig")


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('"format": 1', '"format": 2', "not whole (ValueError: format 2, not 1)"),
        ('"steps": [', '"steps": [7, ', "not whole (TypeError: 7)"),
        ('"at": [[', '"at": [[NaN, ', "not whole"),
        ('"problem"', '"problems"', "not whole (KeyError: 'problem')"),
        ('"kind"', '"kind', "not whole (JSONDecodeError"),
        ("A = [0, 0]", "A = [1, 0]", "of another problem"),
        ("A = [0, 0]", "A = [0, 0", "not whole (problem: "),
        ("</metadata>", "</metadat>", "readable SVG file"),
    ],
)
def test_broken_and_foreign_boards_are_a_row_each(tmp_path, old, new, said):
    text = BoardStudent(library("ex3-1")).file()
    assert old in text
    one = graded(tmp_path, library("ex3-1"), text.replace(old, new))
    assert one.marked is None
    assert one.reason is not None
    assert said in one.reason.message("en")
    assert one.reason.message("zh")
    assert len([*grade_lines(one, "zh")]) == 1
