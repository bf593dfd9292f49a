"""A problem that asks for further positions (`also`): each is marked by its own key, and all are told as one."""

from __future__ import annotations

import json
import tomllib
import zipfile
from pathlib import Path

import pytest
from click.testing import CliRunner

from graphkin import api
from graphkin import files as loading
from graphkin.cli import main
from graphkin.errors import NoKeyAtPosition, Where
from graphkin.files import library
from graphkin.handouts.problem import drawn_problem
from graphkin.handouts.worksheet import answer_rows
from graphkin.homework.grading import OneKey, grade, judge_from, key_for
from graphkin.homework.grading.keys import further_methods
from graphkin.homework.platforms import PolygonPictures
from graphkin.homework.platforms.question import question_of
from graphkin.homework.platforms.result import from_record
from graphkin.marking.key import Key
from graphkin.marking.marker import Marker
from graphkin.model.mechanism import Mechanism
from graphkin.outputs.key_json import key_of, key_text
from graphkin.outputs.marks_json import record
from graphkin.results import results
from graphkin.running import driver_values
from graphkin.say.entry import text_lines

NAMES = ("ex3-1", "scotch-yoke", "curved-slot")


def moved(name: str) -> Mechanism:
    """A library mechanism that asks for two more positions near the drawn one."""
    document = tomllib.loads(library.load(name).text)
    document["driver"][0]["also"] = [document["driver"][0]["angle"] + turn for turn in (7, -11)]
    return loading.from_dict(document, name=name)


@pytest.fixture(scope="module")
def key() -> Key:
    return key_for(moved("ex3-1"))


@pytest.mark.parametrize("name", NAMES)
def test_each_position_is_the_mechanism_moved_on(name: str):
    """A mechanism drawn there and the drawn one moved there, the one by construction, the other by analysis."""
    method = api.plan(moved(name))
    there = [results(one.mechanism, one)["positions"][0] for one in further_methods(method)]
    for one, values in zip(there, list(driver_values(method))[1:], strict=True):
        (other,) = results(method.mechanism, method, values=values)["positions"]
        for link, motion in other["analytic"]["links"].items():
            for rate in ("omega", "alpha"):
                assert one["links"][link][rate] == pytest.approx(motion[rate], rel=1e-9, abs=1e-9)


@pytest.mark.parametrize(("name", "value"), [("s4-ex6", 30), ("p3-19", 60), ("p3-17", 785)])
def test_poses_move_on_too(name: str, value: float):
    """Wheels, and a cylinder, whose place at the drawn position a pose gives."""
    document = tomllib.loads(library.load(name).text)
    document["driver"][0]["also"] = [value]
    assert len(list(further_methods(api.plan(loading.from_dict(document, name=name))))) == 1


def test_one_that_is_not_reached_is_said():
    document = tomllib.loads(library.load("p3-17").text)
    document["driver"][0]["also"] = [303]
    with pytest.raises(NoKeyAtPosition) as found:
        list(further_methods(api.plan(loading.from_dict(document))))
    assert "#2" in found.value.message("en")
    assert "also" in found.value.message("zh")


def test_a_key_with_positions_is_written_and_read(key: Key, tmp_path: Path):
    path = tmp_path / "key.json"
    path.write_text(key_text(key), encoding="utf-8")
    again = key_of(path.read_text("utf-8"), Where(str(path)))
    assert [one.entries for one in again.positions] == [one.entries for one in key.positions]
    assert judge_from(str(path)).key_print("s")


def answered(key: Key, wrong: dict[str, float] | None = None) -> dict[str, float]:
    """What is right at each position, but for some."""
    found = {
        f"{entry.text} #{at}": entry.right
        for at, one in enumerate(key.positions, 1)
        for entry in one.entries
        if entry.points
    }
    return found | (wrong or {})


def written(folder: Path, kind: str, values: dict[str, float]) -> Path:
    """The answers in one of the formats."""
    path = folder / f"s1.{kind}"
    if kind == "toml":
        path.write_text("[answers]\n" + "".join(f'"{name}" = {value}\n' for name, value in values.items()))
    elif kind == "json":
        path.write_text(json.dumps({"student": "s1", "answers": values}))
    elif kind == "txt":
        path.write_text("".join(f"{name} = {value}\n" for name, value in values.items()))
    elif kind == "csv":
        path.write_text("student," + ",".join(values) + "\ns1," + ",".join(map(str, values.values())) + "\n")
    else:
        openpyxl = pytest.importorskip("openpyxl")
        book = openpyxl.Workbook()
        for row in (["quantity", "value"], *values.items()):
            book.active.append(row)
        book.save(path)
    return path


@pytest.mark.parametrize("kind", ["toml", "json", "txt", "csv", "xlsx"])
def test_every_format_names_positions_alike(key: Key, tmp_path: Path, kind: str):
    (found,) = grade(key, [written(tmp_path, kind, answered(key))])
    assert found.marked is not None, found.reason
    assert found.marked.score == pytest.approx(1.0)
    texts = [one.text for one in found.marked.judged if one.points]
    assert "omega 3" in texts
    assert "omega 3 #3" in texts


@pytest.mark.parametrize("name", ["ω3 #2", "omega 3 #2 (rad/s)", "w3 @ 67", "omega_3 @ 67°", "omega 3 ＃2", "ω3 @ 427"])
def test_spellings_of_a_position(key: Key, tmp_path: Path, name: str):
    right = next(one.right for one in key.positions[1].entries if one.text == "omega 3")
    (found,) = grade(key, [written(tmp_path, "toml", {name: right})])
    assert found.marked is not None
    assert [(one.text, one.verdict) for one in found.marked.judged if one.given is not None] == [("omega 3 #2", "right")]


@pytest.mark.parametrize("name", ["omega 3 #4", "omega 3 @ 90", "omega 3 #0"])
def test_a_position_there_is_not_is_said(key: Key, tmp_path: Path, name: str):
    (found,) = grade(key, [written(tmp_path, "toml", {name: 1.0, "omega 3": -3.9})])
    assert found.marked is not None
    assert any(name in note.message("en") for note in found.notes)


def test_a_mistake_at_two_positions_is_told_once(key: Key, tmp_path: Path):
    wrong = {}
    for at, one in enumerate(key.positions, 1):
        row = [names[0][0] for names in one.singles.names].index("coriolis-reversed")
        values = zip(one.entries, one.singles.values[row], strict=True)
        wrong |= {f"{entry.text} #{at}": float(value) for entry, value in values if entry.points}
    (found,) = grade(key, [written(tmp_path, "toml", answered(key, wrong))])
    assert found.marked is not None
    (one,) = found.marked.diagnosis.explanations
    assert "coriolis-reversed" in one.ids
    assert {"alpha 3", "alpha 3 #2", "alpha 3 #3"} <= set(one.explains)
    assert found.marked.diagnosis.evidence["coriolis-reversed"] > 5


def test_own_values_are_carried_within_a_position(key: Key, tmp_path: Path):
    values = answered(key)
    values["omega 3 #2"] *= 1.3
    values["a_k B3B2 #2"] *= 1.3
    (found,) = grade(key, [written(tmp_path, "toml", values)])
    assert found.marked is not None
    carried = {one.text: dict(one.own) for one in found.marked.judged if one.verdict == "carried"}
    assert set(carried) == {"a_k B3B2 #2"}
    assert set(carried["a_k B3B2 #2"]) == {"omega 3 #2"}


def test_drawings_tell_their_position_by_their_name(key: Key, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    Path("p.toml").write_text(moved("ex3-1").text, encoding="utf-8")
    CliRunner().invoke(main, ["draw", "p.toml", "--angle", "67", "--only", "acceleration", "-o", "drawn.svg"])
    with zipfile.ZipFile("class.zip", "w") as archive:
        archive.write("drawn.svg", "s1 #2.svg")
        archive.writestr("s1.txt", "omega 3 = -3.919")
    (found,) = grade(key, ["class.zip"])
    assert found.student == "s1"
    assert found.marked is not None, found.reason
    given = {one.text: one.verdict for one in found.marked.judged if one.given is not None}
    assert set(given.values()) == {"right"}
    assert {"omega 3", "a_k B3B2 #2"} <= set(given)
    assert "a_k B3B2" not in given


def test_platforms_and_the_text_have_every_position(key: Key):
    parts = question_of("s1", key, {"en": "", "zh": ""}).parts
    assert [part.name for part in parts if "omega 3" in part.name] == ["omega 3", "omega 3 #2", "omega 3 #3"]
    for lang in ("en", "zh"):
        problem = drawn_problem(moved("ex3-1"), lang, "s1")
        text = "\n".join(text_lines(problem.posed, lang))
        assert "#2" in text
        assert "φ1 = 67°" in text
        assert [row.symbol for row in answer_rows(problem)] == [part.shown for part in parts]


def test_a_page_shows_the_position_of_the_mistake(key: Key, tmp_path: Path):
    """Made at the third position alone: that is drawn, and said."""
    one = key.positions[2]
    row = [names[0][0] for names in one.singles.names].index("coriolis-reversed")
    wrong = {f"{entry.text} #3": float(v) for entry, v in zip(one.entries, one.singles.values[row], strict=True) if entry.points}
    graded = list(grade(key, [written(tmp_path, "toml", answered(key, wrong))]))
    result = from_record(record(graded[0]), Where(""))
    sentence, picture = PolygonPictures(OneKey(Marker(key)))(result, "en", "answer")
    assert sentence.label.startswith("At position #3.")
    assert picture.data
