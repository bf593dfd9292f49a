"""Who handed it in: class lists and archives as platforms write them; names that are nobody's, or two students'."""

from __future__ import annotations

import io
import json
import zipfile
from pathlib import Path

import pytest
from click.testing import CliRunner

from graphkin.cli import main
from graphkin.homework.grading import SetMarker, class_list, grade, judge_from
from graphkin.outputs.marks_json import record
from graphkin.submissions import Roster, Student

RIGHT = b'"omega 3" = -3.92\n"alpha 3" = 62\n"a_k B3B2" = 2.5\n'
LIST = "学号,姓名,邮箱\n20231048,朱霞洋,zxy@x.edu\n20231049,王明,wm@x.edu\n20231050,王明,wm2@x.edu\n20231051,阿卜杜拉·买买提,a@x.edu\n"


pytestmark = pytest.mark.usefixtures("own_folder")


def graded(roster: str | bytes, *given: str, name: str = "list.csv") -> list[dict]:
    Path(name).write_bytes(roster if isinstance(roster, bytes) else roster.encode())
    done = CliRunner().invoke(main, ["grade", "ex3-1", *given, "--roster", name, "--json"])
    records = [json.loads(line) for line in done.stdout.splitlines()]
    assert done.exit_code == (0 if any(one["status"] == "marked" for one in records) else 3), done.output
    return records


def whose(rows: list[dict]) -> list[str]:
    """The student of each that was marked, and the words that tell why another was not."""
    words = ("class has no student", "is the name of", "says", "handed in")
    return [row["student"] if row["status"] == "marked" else next(word for word in words if word in row["reason"]) for row in rows]


def zipped(members: dict[str, bytes], name: str = "class.zip") -> str:
    with zipfile.ZipFile(name, "w") as archive:
        for inner, content in members.items():
            archive.writestr(inner, content)
    return name


def sheet(rows: list[list[object]]) -> bytes:
    openpyxl = pytest.importorskip("openpyxl")
    book, data = openpyxl.Workbook(), io.BytesIO()
    for row in rows:
        book.active.append(row)
    book.save(data)
    return data.getvalue()


@pytest.fixture(scope="module")
def judge(tmp_path_factory: pytest.TempPathFactory) -> SetMarker:
    path = tmp_path_factory.mktemp("class") / "list.csv"
    path.write_text(LIST, "utf-8")
    return judge_from("ex3-1", listed=path)


@pytest.mark.parametrize(("name", "student"), [
    ("20231048-朱霞洋.toml", "20231048"), ("20231048_朱霞洋.toml", "20231048"), ("20231048 朱霞洋.toml", "20231048"),
    ("朱霞洋-20231048.toml", "20231048"), ("20231048朱霞洋.toml", "20231048"), ("朱 霞洋.toml", "20231048"),
    ("２０２３１０４８-朱霞洋.toml", "20231048"), ("第3次作业-朱霞洋-终稿2.toml", "20231048"), ("朱霞洋作业三.toml", "20231048"),
    ("朱霞洋-Li Lei.toml", "20231048"), ("朱霞洋明.toml", "class has no student"), ("王明-作业.toml", "is the name of"),
    ("王明20231050.toml", "20231050"), ("阿卜杜拉买买提.toml", "20231051"), ("zxy@x.edu.toml", "20231048"),
    ("王明.toml", "is the name of"), ("20231049-朱霞洋.toml", "says"), ("朱露洋.toml", "class has no student"),
    ("20231048 20231049.toml", "says"), ("homework 3.toml", "class has no student"),
])  # fmt: skip
def test_a_file_s_name(name: str, student: str, judge: SetMarker):
    Path(name).write_bytes(RIGHT)
    assert whose([record(one) for one in grade(judge, [name])]) == [student]


def test_the_nearest_are_told():
    Path("朱露洋.toml").write_bytes(RIGHT)
    assert "20231048 朱霞洋" in graded(LIST, "朱露洋.toml")[0]["reason"]


WORKSHEET = {
    "en": "Identifier,Full name,Email address,Status,Grade\nParticipant 4460,朱霞洋,z@x.edu,Submitted,-\nParticipant 11,Li Lei,l@x.edu,,\n",
    "zh": "标识符,全名,电子邮件地址,状态,成绩\n参与者 4460,朱霞洋,z@x.edu,已提交,-\n参与者 11,Li Lei,l@x.edu,,\n",
}


@pytest.mark.parametrize("lang", WORKSHEET)
def test_moodle_s_download_with_its_worksheet(lang: str):
    folder = "_assignsubmission_file_/"
    rows = graded(WORKSHEET[lang], zipped({
        f"朱霞洋_4460{folder}20231048.toml": RIGHT, f"Lei Li_11{folder}work.toml": RIGHT,
        f"Zhang San_12{folder}work.toml": b'student = "z@x.edu"\n' + RIGHT,
        f"朱霞洋_11{folder}a.toml": RIGHT,
    }))  # fmt: skip
    first, second = [line.split(",")[0] for line in WORKSHEET[lang].splitlines()[1:]]
    assert whose(rows) == [first, second, "class has no student", "says"]


@pytest.mark.parametrize("roster", ["id,name,identifier\ns7,李 雷,77\ns8,Zhang,11\n", "id\ns7\ns8\n"])
def test_a_line_does_not_outrank_a_platform_s_folder(roster: str):
    """One student writes another's id into the file: the other is marked, or, where nothing else tells whose the
    folders are, neither."""
    claims = b'student = "s7"\n[answers]\n"omega 3" = %s\n'
    rows = graded(roster, zipped({
        "Zhang_11_assignsubmission_file_/work.toml": claims % b"99", "李 雷_77_assignsubmission_file_/work.toml": claims % b"-3.92",
    }))  # fmt: skip
    assert whose(rows) == (["says", "s7"] if "name" in roster else ["says", "says"])


def test_a_line_does_not_outrank_another_file_s_name():
    claims = b'student = "s7"\n[answers]\n"omega 3" = %s\n'
    rows = graded("id\ns7\ns8\n", zipped({"a_evil.toml": claims % b"99", "s7.toml": claims % b"-3.92"}))
    assert whose(rows) == ["says", "s7"]


def test_a_platform_s_folder_in_other_letters_tells_nothing():
    """Then the files' names do, where one folder alone has them."""
    folder = "_assignsubmission_file_/"
    rows = graded(LIST, zipped({
        f"Zhu Xiayang_1{folder}20231048.toml": RIGHT, f"Wang Ming_2{folder}20231049-王明.toml": RIGHT,
        f"Eve_3{folder}20231049.toml": RIGHT, f"朱露洋_4{folder}20231050.toml": RIGHT,
    }))  # fmt: skip
    assert whose(rows) == ["20231048", "says", "says", "class has no student"]


def test_canvas_with_its_gradebook():
    roster = 'Student,ID,SIS User ID,SIS Login ID,Section,Homework\n    Points Possible,,,,,10\n"Zhu, Xia Yang",3143,20231048,zxy,A,\n"Doe, Jo",3144,20231049,jd,A,\n'
    rows = graded(roster, zipped({
        "zhuxiayang_3143_207797_name.toml": RIGHT, "doejo_LATE_3144_207798_20231049.toml": RIGHT, "eve_3999_207799_20231048.toml": RIGHT,
    }))  # fmt: skip
    assert whose(rows) == ["20231048", "20231049", "class has no student"]


def test_gradescope_with_its_roster():
    roster = "First Name,Last Name,SID,Email,Role\nXiayang,Zhu,20231048,z@x.edu,Student\nJo,Doe,20231049,j@x.edu,Student\n"
    metadata = """---
submission_1:
  :submitters:
  - :name: Xiayang Zhu
    :sid: '20231048'
    :email: z@x.edu
  :created_at: 2026-03-01 12:00:00
submission_2:
  :submitters:
  - :name: Jo Doe
    :sid: ''
    :email: j@x.edu
submission_3:
  :submitters:
  - :name: Xiayang Zhu
    :sid: '20231048'
    :email: z@x.edu
  - :name: Jo Doe
    :sid: '20231049'
    :email: j@x.edu
"""
    top = "assignment_9_export/"
    rows = graded(roster, zipped({
        f"{top}submission_metadata.yml": metadata.encode(), f"{top}submission_1/work.toml": RIGHT,
        f"{top}submission_2/20231048.csv": b"question,value\nomega 3,-3.92\n", f"{top}submission_3/work.toml": RIGHT,
    }))  # fmt: skip
    assert whose(rows) == ["20231048", "says", "says"]


def test_folders_of_students_and_answers_beside_a_drawing():
    """学习通's folders; and two files of a student's at the top."""
    roster = sheet([["机械原理 2026"], ["序号", "学号/工号", "姓名", "班级"], [1, 20231048, "朱霞洋", "A"], [2, 20231049, "李雷", "A"]])
    rows = graded(roster, zipped({
        "作业3/20231048-朱霞洋/图/a.toml": RIGHT, "作业3/20231048-朱霞洋/b.md": b"v B3 = 0.1",
        "作业3/李雷-20231049-答案.toml": RIGHT, "作业3/李雷-20231049-补充.md": b"v B3 = 0.1",
    }), name="list.xlsx")  # fmt: skip
    assert whose(rows) == ["20231048", "20231049"]


def test_each_student_is_an_archive():
    """As 学习通 packs a class, `学号-姓名.zip` for each; an archive that a student handed in is in that once more."""
    def packed(name: str, content: bytes) -> bytes:
        with zipfile.ZipFile(whole := io.BytesIO(), "w") as archive:
            archive.writestr(name, content)
        return whole.getvalue()

    one = packed("答案.toml", RIGHT)
    roster = "学号,姓名\n20231048,朱霞洋\n20231049,李雷\n"
    rows = graded(roster, zipped({"作业/20231048-朱霞洋.zip": one, "作业/20231049-李雷.zip": packed("作业.zip", one)}))
    assert [row["status"] for row in rows] == ["marked", "marked"]
    assert whose(rows) == ["20231048", "20231049"]
    Path("20231049-李雷.zip").write_bytes(one)
    assert whose(graded(roster, "20231049-李雷.zip")) == ["20231049"]


@pytest.mark.parametrize("rows", [
    [["姓名", "朱霞洋"], ["ω3", -3.92]], [["姓名", "朱霞洋"], ["学号", 20231048], ["omega 3", -3.92]],
    [["答题表"], ["姓名", "朱霞洋", "学号", "20231048"], ["量", "答案", "单位", "转向"], ["ω3", 3.92, "rad/s", "顺时针"], ["akB3B2", 2.5, "m/s²", "—"]],
    [["学号：20231048"], ["ω3 = -3.92 rad/s"]],
])  # fmt: skip
def test_a_sheet_of_one_student_is_no_class(rows: list[list[object]]):
    Path("work.xlsx").write_bytes(sheet(rows))
    (found,) = graded(LIST, "work.xlsx")
    assert (found["student"], found["quantities"]["omega 3"]["verdict"]) == ("20231048", "right")


def test_a_class_table_with_names():
    Path("class.csv").write_text("机械原理\n姓名,学号,ω3\n朱霞洋,20231048,-3.92\n王明,20231050,-3.92\n朱霞洋,20231049,-3.92\n王明,,-3.92\n", "utf-8")
    assert whose(graded(LIST, "class.csv")) == ["20231048", "20231050", "says", "is the name of"]


def test_a_set_of_keys_knows_the_names_it_was_made_for():
    case = Path(__file__).parents[1] / "cases" / "homework" / "rocker.toml"
    Path("class.csv").write_text(LIST, "utf-8")
    assert CliRunner().invoke(main, ["problems", str(case), "--students", "class.csv", "-o", "set"]).exit_code == 0
    key = next(Path("set").rglob("*20231048*.key.json"))
    first = next(iter(json.loads(key.read_text("utf-8"))["quantities"]))
    Path("朱霞洋.toml").write_text(f'"{first["text"]}" = {first["right"]}\n', "utf-8")
    done = CliRunner().invoke(main, ["grade", str(next(Path("set").rglob("key.json"))), "朱霞洋.toml", "--json"])
    assert whose([json.loads(done.stdout)]) == ["20231048"]


# --- the matcher by itself --------------------------------------------------------------------


def test_names_in_either_order_and_any_writing():
    roster = Roster([Student("s1", (("name", "José María Núñez"),)), Student("s2", (("name", "O'Neil, Max"),))])
    for text in ("Núñez José María", "jose maria nunez", "NUÑEZ, JOSÉ MARÍA", "nunezjosemaria"):
        assert roster.named(text) == (frozenset({"s1"}),)
    assert roster.named("hw Max O'Neil") == (frozenset({"s2"}),)
    assert roster.named("Max O'Neil-final (2)") == roster.named("hw3_oneil_max") == (frozenset({"s2"}),)
    assert roster.named("Max O'Neil Smith") == roster.named("José María Núñez de la Cruz") == ()
    assert roster.named("max velocity") == roster.named("s12") == roster.named("") == ()


def test_short_numbers_tell_nothing_in_the_midst():
    roster = Roster(map(Student, ("1", "12")))
    assert roster.named("12") == (frozenset({"12"}),)
    assert roster.named("homework 1 12") == ()


@pytest.mark.parametrize("text", ["", "学号\n", "\n,\n"])
def test_a_list_of_nobody_is_refused(text: str):
    Path("list.csv").write_text(text, "utf-8")
    Path("x.toml").write_bytes(RIGHT)
    done = CliRunner().invoke(main, ["grade", "ex3-1", "x.toml", "--roster", "list.csv"])
    assert done.exit_code == 3
    assert "list.csv" in done.stderr


def test_a_list_without_heads():
    Path("list.csv").write_text("20231048,朱霞洋\n20231049,李雷\n", "gb18030")
    assert class_list(Path("list.csv"))[0] == Student("20231048", (("name", "朱霞洋"),))
