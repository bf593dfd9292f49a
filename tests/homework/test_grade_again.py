"""Marks given anew from a file of marks, without the submissions."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from graphkin.cli import main

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
