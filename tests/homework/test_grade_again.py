"""Marks given anew from a file of marks, without the submissions."""

from __future__ import annotations

import json
import pickle
from pathlib import Path

import pytest
from click.testing import CliRunner

from graphkin import files as loading
from graphkin.cli import main
from graphkin.errors import NOWHERE
from graphkin.files import library
from graphkin.homework.grading import Pencils, judge_from, key_for, key_from, pencils_of, set_text
from graphkin.outputs.key_json import key_of, key_text

ANSWERS = "student,omega 3,alpha 3,a_k B3B2\ns1,-3.92,62,2.5\ns2,-5.65,68.7,3.62\ns3,-3.7 m/s,,2.6\ns4,-3.75,60,what\n"


def marks(path: Path) -> list[dict]:
    return json.loads(path.read_text("utf-8"))["results"]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A marked class, whose submissions are gone."""
    (tmp_path / "class.csv").write_text(ANSWERS)
    (tmp_path / "bad.toml").write_text("= = =")
    done = CliRunner().invoke(
        main, ["grade", "ex3-1", str(tmp_path / "class.csv"), str(tmp_path / "bad.toml"), "-o", str(tmp_path / "first.json")]
    )
    assert done.exit_code == 0, done.output
    (tmp_path / "class.csv").unlink()
    (tmp_path / "bad.toml").unlink()
    return tmp_path


def again(folder: Path, *options: str, out: str = "second.json"):
    words = ["grade", "ex3-1", str(folder / "first.json"), "-o", str(folder / out), "--lang", "en", *options]
    return CliRunner().invoke(main, words)


def test_the_same_key_gives_the_same_marks(folder: Path):
    assert again(folder).exit_code == 0
    first, second = marks(folder / "first.json"), marks(folder / "second.json")
    assert [each["status"] for each in first] == ["marked"] * 4 + ["not marked"]
    assert first == second


def test_another_tolerance_gives_other_marks(folder: Path):
    assert again(folder, "--relative", "0.001").exit_code == 0
    first, second = marks(folder / "first.json"), marks(folder / "second.json")
    assert [each["student"] for each in first] == [each["student"] for each in second]
    assert first[3]["quantities"]["omega 3"]["verdict"] == "right"
    assert second[3]["quantities"]["omega 3"]["verdict"] == "wrong"
    assert second[4]["reason"] == first[4]["reason"]


def test_the_file_itself_may_be_written_anew(folder: Path):
    before = (folder / "first.json").read_bytes()
    assert again(folder, out="first.json").exit_code == 0
    assert (folder / "first.json").read_bytes() == before


@pytest.mark.parametrize("wrong", ['{"format": 1}', '{"format": 9, "student": ""}', '{"format": ['])
def test_a_spoilt_file_of_marks_is_refused(wrong: str, folder: Path):
    path = folder / "first.json"
    path.write_text(path.read_text("utf-8").replace('\n]}', f",\n{wrong}\n]}}"), "utf-8")
    done = again(folder)
    assert done.exit_code == 3
    assert "first.json:" in done.stderr
    assert not (folder / "second.json").exists()


# --- a stored key, and what is said of the pencil beside it ---------------------------------------------------------------


@pytest.fixture(scope="module")
def keys(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A key for all, also at a second position, and a set of keys with it; each in its own folder."""
    folder = tmp_path_factory.mktemp("keys")
    text = library.load("ex3-1").text.replace("omega = 10", "omega = 10\nalso = [120]")
    machine = loading.loads("points.'omega 3' = 2\npoints.follows = 'half'\n" + text, name="it")
    (folder / "one.key.json").write_text(key_text(key_for(machine)), encoding="utf-8")
    (folder / "key.json").write_text(set_text({"s1": "one.key.json"}), encoding="utf-8")
    return folder


@pytest.mark.parametrize(("source", "said", "made"), [
    ("one.key.json", ["--sigmas", "6"], Pencils(sigmas=6)),
    ("key.json", ["--relative", "0.02"], Pencils(relative=0.02)),
    ("key.json", ["--pencil", "0.1,0.1"], Pencils(0.1, 0.1)),
    ("one.key.json", ["--pencil", "0.1,0.1", "--sigmas", "2"], Pencils(0.1, 0.1, 2)),
])  # fmt: skip
def test_a_stored_key_is_as_if_made_so(source: str, said: list[str], made: Pencils, keys: Path):
    """At both positions, with what answers are worth; without a word a stored key keeps its own."""
    options = dict(zip((word[2:] for word in said[::2]), said[1::2], strict=True))
    pencils = pencils_of(options.get("pencil"), *(float(options[o]) if o in options else None for o in ("sigmas", "relative")))
    own, found = (judge_from(str(keys / source), one).marker("s1") for one in (Pencils(), pencils))
    stored = key_of((keys / "one.key.json").read_text("utf-8"), NOWHERE)
    anew = key_for(loading.loads(stored.text, name="it"), made)
    assert own is not None
    assert found is not None
    assert own.key.positions[1].entries == stored.positions[1].entries
    assert found.key.marking.follows == 0.5
    for one, other in zip(found.key.positions, anew.positions, strict=True):
        assert one.marking == other.marking
        assert [(e.text, e.points, e.doubt) for e in one.entries] == [(e.text, e.points, e.doubt) for e in other.entries]
        assert [e.tolerance for e in one.entries] == pytest.approx([e.tolerance for e in other.entries])
    judge = judge_from(str(keys / source), pencils)
    assert judge.key_print("s1") != judge_from(str(keys / source)).key_print("s1")
    assert pickle.loads(pickle.dumps(judge)).marker("s1").key.entries == found.key.entries


def test_records_are_marked_anew_by_another_tolerance(keys: Path, tmp_path: Path):
    (tmp_path / "s1.toml").write_text('student = "s1"\n[answers]\n"omega 3" = -3.75\n', encoding="utf-8")
    verdicts = []
    for said in ([], ["--relative", "0.001"], []):
        words = ["grade", str(keys), str(tmp_path / "s1.toml"), "-o", str(tmp_path / "marks.json"), *said]
        assert CliRunner().invoke(main, words).exit_code == 0
        verdicts.append(marks(tmp_path / "marks.json")[0]["quantities"]["omega 3"]["verdict"])
    assert verdicts == ["right", "wrong", "right"]


# --- what answers are worth, in a plain mechanism file --------------------------------------------------------------------


@pytest.mark.parametrize(("points", "told"), [
    ('follows = "third"', "it.toml:2"), ('"omega 3" = -1', "it.toml:2"), ('"omega 3" = true', "it.toml:2"),
    ('"omega 9" = 1', "omega 9"), ('follow = "full"', "follow"),
])  # fmt: skip
def test_points_that_mean_nothing_are_refused(points: str, told: str, tmp_path: Path):
    text = library.load("ex3-1").text
    (tmp_path / "it.toml").write_text(text + f"\n[points]\n{points}\n", encoding="utf-8")
    done = CliRunner().invoke(main, ["grade", str(tmp_path / "it.toml"), str(tmp_path), "--lang", "en"])
    assert done.exit_code == 3
    assert told.replace(":2", f":{text.count(chr(10)) + 3}") in done.stderr


def test_points_of_a_plain_file(tmp_path: Path):
    text = library.load("ex3-1").text + '\n[points]\nfollows = "none"\n"omega 3" = 2\n"alpha 2" = 0\n'
    (tmp_path / "it.toml").write_text(text, encoding="utf-8")
    key = key_of(key_text(key_from(str(tmp_path / "it.toml"))), NOWHERE)
    worth = {entry.text: entry.points for entry in key.entries}
    assert (worth["omega 3"], worth["alpha 2"], worth["alpha 3"], key.marking.follows) == (2, 0, 1, 0)
    old = json.loads(key_text(key))
    del old["marking"]["follows"]
    assert key_of(json.dumps(old), NOWHERE).marking.follows == 1
