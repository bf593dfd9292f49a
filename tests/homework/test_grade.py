"""`grade` and `tolerance` as commands: what programs get of each submission, and what is told of it."""

from __future__ import annotations

import json
import random
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result

from graphkin.cli import main
from graphkin.errors import Lang
from graphkin.homework.grading import key_from
from graphkin.outputs.key_json import key_text
from graphkin.say import say
from graphkin.say.names import in_signs

Json = dict[str, Any]
LANGS: tuple[Lang, ...] = ("en", "zh")


pytestmark = pytest.mark.usefixtures("own_folder")


def run(*words: str) -> Result:
    return CliRunner().invoke(main, list(words))


def handed(answers: str, student: str = "s1") -> str:
    name = f"{student}.toml"
    Path(name).write_text(f'student = "{student}"\n[answers]\n{answers}\n', encoding="utf-8")
    return name


def lines(*words: str) -> list[Json]:
    result = run("grade", *words, "--json")
    assert result.exit_code == 0, result.output
    return [json.loads(line) for line in result.stdout.splitlines()]


CORIOLIS = '"omega 3" = "3.92 cw"\n"alpha 3" = 12.5\n"a_k B3B2" = 0\n"v B3B2" = 0.32'


def test_the_line_of_a_submission():
    (line,) = lines("ex3-1", handed(CORIOLIS))
    assert set(line) == {"format", "student", "file", "status", "score", "quantities", "mistakes"}
    assert (line["format"], line["student"], line["file"], line["status"]) == (1, "s1", "s1.toml", "marked")
    assert line["score"] == pytest.approx(0.4)  # alpha 3 follows from the term that is left out
    assert set(line["quantities"]) == {"omega 2", "omega 3", "alpha 2", "alpha 3", "a_k B3B2", "v B3B2"}
    for one in line["quantities"].values():
        assert set(one) == {"given", "right", "carried", "tolerance", "verdict", "sense"}
        assert one["tolerance"] > 0
    omega = line["quantities"]["omega 3"]
    assert omega == {"given": -3.92, "right": pytest.approx(-3.91933, rel=1e-5), "carried": None, "sense": "right",
                     "tolerance": pytest.approx(0.19, rel=0.1), "verdict": "right"}  # fmt: skip
    assert line["quantities"]["omega 2"]["given"] is None
    assert line["quantities"]["omega 2"]["verdict"] == "missing"
    (mistake,) = line["mistakes"]
    assert set(mistake) == {"ids", "probability", "margin", "explains"}
    assert mistake["ids"][0] == "coriolis-omitted"
    assert mistake["explains"] == ["alpha 3", "a_k B3B2"]
    assert 0.5 < mistake["probability"] <= 1


@pytest.mark.parametrize("lang", LANGS)
def test_the_teacher_is_told_once_what_paper_cannot_tell(lang: Lang):
    files = [handed('"alpha 4" = 0.2', student) for student in ("s1", "s2")]
    told, other = (run("grade", name, *files, "--json", "--lang", lang).stderr for name in ("s3-shaper", "ex3-1"))
    words = {"en": "`graphkin grade` calls an answer", "zh": "graphkin grade 既不判对也不判错"}[lang]
    assert (told.count(words), other.count(words)) == (1, 0)


@pytest.mark.parametrize(("asked", "like"), [("omega 3", "3.92 rad/s cw"), ("v E", "0.271 m/s 72.5°"), ("theta 3", "105.6°")])
def test_an_unread_answer_is_told_how_one_of_its_kind_is_written(asked: str, like: str):
    told = run("grade", "ex3-5", handed(f'"{asked}" = "furlongs"')).stdout
    (note,) = (line for line in told.splitlines() if "does not read as a value" in line)
    assert f'"{like}"' in note


def test_carried_values_in_the_line():
    (line,) = lines("ex3-1", handed('"omega 3" = -5.65\n"a_k B3B2" = 3.63'))
    one = line["quantities"]["a_k B3B2"]
    assert one["verdict"] == "carried"
    assert one["carried"] == pytest.approx(3.625, rel=1e-3)


def test_nothing_wrong_has_no_mistakes():
    (line,) = lines("ex3-1", handed('"omega 3" = -3.9\n"alpha 3" = "62 rad/s^2 ccw"\n"a_k B3B2" = 2.5'))
    assert line["mistakes"] == []


def test_one_bad_file_is_one_row():
    Path("bad.toml").write_bytes(b"\xff\xfe\x00[")
    Path("odd.xyz").write_text("?")
    found = lines("ex3-1", "bad.toml", "odd.xyz", "none.toml", handed(CORIOLIS))
    assert [line["status"] for line in found] == ["not marked", "not marked", "not marked", "marked"]
    for line in found[:3]:
        assert line["reason"]
        assert line["score"] is None
        assert line["mistakes"] == []
        assert line["quantities"] == {}


def test_a_path_written_wrongly_is_no_student():
    done = CliRunner().invoke(main, ["grade", "ex3-1", "clas.zip", "-o", "results", "--format", "csv"])
    assert (done.exit_code, done.stderr) == (3, "clas.zip: there is no such file. Check the path.\n")
    assert not Path("results").exists()


def test_a_class_table():
    Path("class.csv").write_text("student,omega 3,alpha 3\na,-3.92,62.2\nb,3.92 cw,-37.3\nc,x,\n", encoding="utf-8")
    found = lines("ex3-1", "class.csv")
    assert [line["student"] for line in found] == ["a", "b", "c"]
    assert {line["file"] for line in found} == {"class.csv"}
    assert found[1]["quantities"]["alpha 3"]["verdict"] == "wrong"
    assert found[2]["quantities"]["omega 3"]["given"] is None


@pytest.mark.parametrize("bad", ["none", "key.json", "empty.json", "broken.toml"])
def test_a_bad_key_ends_it(bad: str):
    Path("empty.json").write_text("{}")
    Path("broken.toml").write_text("[frame")
    result = run("grade", bad, handed(CORIOLIS), "--json")
    assert result.exit_code == 3
    assert result.stdout == ""
    assert bad in result.stderr or "JSON" in result.stderr


def test_a_key_file_marks_as_its_mechanism_does():
    Path("key.json").write_text(key_text(key_from("ex3-1")), encoding="utf-8")
    name = handed(CORIOLIS)
    assert lines("key.json", name) == lines("ex3-1", name)


def test_results_file():
    result = run("grade", "ex3-1", handed(CORIOLIS), handed('"omega 3" = -5.65\n"a_k B3B2" = 3.63', "s2"), "-o", "r.json")
    assert result.exit_code == 0
    data = json.loads(Path("r.json").read_text("utf-8"))
    assert [one["student"] for one in data["results"]] == ["s1", "s2"]
    assert data["results"][1]["quantities"]["a_k B3B2"]["own"] == {"omega 3": -5.65}
    assert data["results"][0]["mistakes"][0]["names"][0][0]["of"] == ["a^k_B3B2"]
    assert run("grade", "ex3-1", "s1.toml", "-o", "r.json").exit_code == 0
    Path("other.json").write_text('{"mine": 1}')
    assert run("grade", "ex3-1", "s1.toml", "-o", "other.json").exit_code == 3
    assert run("grade", "ex3-1", "s1.toml", "-o", "r.txt").exit_code == 2


TEMPLATE = """
ask = ["omega 3", "alpha 3"]
[points]
"omega 3" = 3
[frame]
A = [0, 0]
D = [80, 0]
[links.1]
AB = { from = 24, to = 30, step = 1 }
[links.2]
BC = 70
[links.3]
DC = 60
[[driver]]
vector = "AB"
angle = { from = 50, to = 70, step = 1 }
omega = 10
[sketch]
C = [80, 60]
[scales]
length = 0.001
velocity = 0.01
acceleration = 0.1
"""


def test_each_student_has_a_key():
    Path("t.toml").write_text(TEMPLATE, encoding="utf-8")
    Path("roster.csv").write_text("id\nann\n../bob\n", encoding="utf-8")
    assert run("problems", "t.toml", "--students", "roster.csv", "-o", "set").exit_code == 0
    keys = json.loads(Path("set/teacher/key.json").read_text("utf-8"))["students"]
    assert set(keys) == {"ann", "../bob"}
    for student, name in keys.items():
        key = key_from(f"set/teacher/{name}")
        row = {entry.text: entry.right for entry in key.entries}
        handed_in = {"student": student, "answers": {"omega 3": round(row["omega 3"], 3), "alpha 3": row["alpha 3"] * 2}}
        Path(f"{name}.in.json").write_text(json.dumps(handed_in))
    Path("stranger.json").write_text('{"student": "eve", "answers": {"omega 3": 1}}')
    files = [f"{name}.in.json" for name in keys.values()]
    for key in ("set", "set/teacher", "set/teacher/key.json"):
        found = lines(key, *files, "stranger.json")
        assert [line["status"] for line in found] == ["marked", "marked", "not marked"]
        for line in found[:2]:
            assert line["quantities"]["omega 3"]["verdict"] == "right"
            assert line["score"] == pytest.approx(0.75)
        assert found[0]["quantities"]["omega 3"]["right"] != found[1]["quantities"]["omega 3"]["right"]


@pytest.mark.parametrize("output", [(), ("-o", "r.json"), ("-o", "folder", "--format", "csv"), ("--json",)])
def test_where_nothing_could_be_marked_the_status_says_so(output: tuple[str, ...]):
    """A table with a header alone says that it has no rows; beside one that is marked it is one row of the results."""
    Path("class.csv").write_text("student,omega 3\n", encoding="utf-8")
    Path("hello.txt").write_text("hello", encoding="utf-8")
    done = run("grade", "ex3-1", "class.csv", "hello.txt", *output, "--lang", "en")
    assert done.exit_code == 3
    assert "None of what was handed in could be marked (2)" in done.stderr
    assert run("grade", "ex3-1", "class.csv", handed(CORIOLIS), *output, "--force", "--lang", "en").exit_code == 0


def test_a_table_without_rows_is_told_so():
    Path("class.csv").write_text("student,omega 3\n", encoding="utf-8")
    assert "class.csv: the table has a header and no rows below it." in run("grade", "ex3-1", "class.csv", "--lang", "en").stdout


@pytest.mark.parametrize("lang", LANGS)
def test_told_in_both_languages(lang: Lang):
    text = run("grade", "ex3-1", handed(CORIOLIS), handed('"omega 3" = -5.65\n"a_k B3B2" = 3.63', "s2"), "--lang", lang).stdout
    assert in_signs(say("mistakes.made coriolis-omitted", lang, of="a^k_B3B2", form="")) in text
    assert say("verdicts.verdict carried", lang) in text
    assert in_signs(say("marks.judged with", lang, which=0, own="omega 3 = −5.65", quantity="a_k B3B2", value="3.625")) in text


@pytest.mark.parametrize("pencil", ["x", "1", "1,2,3", "-1,0", "nan,1", "1e9,1"])
def test_a_pencil_that_is_none(pencil: str):
    result = run("tolerance", "ex3-1", f"--pencil={pencil}")
    assert result.exit_code == 3
    assert pencil in result.stderr


@pytest.mark.parametrize("lang", LANGS)
def test_tolerance_is_told(lang: Lang):
    result = run("tolerance", "ex3-1", "--lang", lang)
    assert result.exit_code == 0
    assert "ω3 *" in result.stdout
    assert say("tolerances.step arrow", lang, which=0, of0="v_B2") in result.stdout


def test_tolerance_as_json():
    data = json.loads(run("tolerance", "ex3-1", "--json", "--sigmas", "2").stdout)
    one = data["quantities"]["omega 3"]
    assert one["asked"]
    assert one["tolerance"] == pytest.approx(2 * one["scatter"])
    assert data["steps"][0]["name"] == "v_B2"
    assert data["scales"] == {"length": 0.0006, "velocity": 0.006, "acceleration": 0.05}


def test_power_is_told():
    result = run("tolerance", "s2-1b", "--power", "--asked", "--trials", "2", "--lang", "zh")
    assert result.exit_code == 0
    assert say("tolerances.column mistake", "zh") in result.stdout


def test_hostile_numbers():
    """Whatever is handed in, there is a row for it."""
    rng, rows = random.Random(3), []
    odd = ("nan", "inf", "-inf", "1e308", "-1e308", "1e999", "0", "-0", "", "x" * 300, "../../etc", "１２", "1,2,3", "=1+1", "5e-324")
    texts = ("omega 3", "alpha 3", "a_k B3B2", "v C3C2", "theta 3", "a_n B3D")
    for k in range(60):
        rows.append({text: rng.choice(odd) for text in rng.sample(texts, rng.randint(0, 6))})
        Path(f"h{k}.json").write_text(json.dumps({"student": f"../h{k}", "answers": rows[-1]}), encoding="utf-8")
    found = lines("ex3-1", *(f"h{k}.json" for k in range(60)))
    assert len(found) == 60
    assert {line["status"] for line in found} <= {"marked", "not marked"}


def test_a_wrong_unit_alone_is_no_riddle():
    """It is told by itself; that no mistake explains it says nothing."""
    Path("s1.toml").write_text('student = "s1"\n[answers]\n"omega 3" = "-3.92 m/s"\n"alpha 3" = 62\n', encoding="utf-8")
    told = CliRunner().invoke(main, ["grade", "ex3-1", "s1.toml", "--lang", "en"]).output
    assert "wrong unit" in told
    assert "no known mistake" not in told
