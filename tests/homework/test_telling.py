"""What the answers of a set of problems tell of mistakes, and that its problems are the better ones for it."""

from __future__ import annotations

import json
import re
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from template_text import TEXT, variants

from graphkin import api
from graphkin import files as loading
from graphkin.cli import main
from graphkin.construction import SCALES
from graphkin.files import library
from graphkin.homework.grading import key_for
from graphkin.homework.grading.keys import USUAL, marking_of
from graphkin.homework.problems import Variant, draws, read_template, roster, well_posed
from graphkin.homework.problems.posed import shown_at
from graphkin.marking.discriminability import (
    Always,
    MistakeVisibility,
    compared,
    mistake_visibility,
    set_discriminability,
)
from graphkin.marking.key import TELLS, KeyEntry, columns, part_off
from graphkin.marking.key_making import asked_alone
from graphkin.model.quantities import at_position
from graphkin.running import replay_all
from graphkin.say.tolerances import discriminability_lines
from graphkin.sheet import scales_of

SENSE, SIZE = (KeyEntry(text, "rad/s", sort, 10.0, 0.1, 0.3) for text, sort in (("omega 3", "sense"), ("v C", "size")))
NAN = float("nan")


def told(*rows: tuple[str, float, float]) -> MistakeVisibility:
    """Mistakes by id, and what they give."""
    return compared((SENSE, SIZE), [(id, "", "", "") for id, *_ in rows], np.array([row[1:] for row in rows]))


@pytest.mark.parametrize(
    ("one", "other", "near", "same"),
    [
        (("a", 12.0, 10.0), ("b", 12.0, 10.0), True, True),
        (("a", 12.0, 10.0), ("b", 12.2, 10.0), True, False),
        (("a", 12.0, 10.0), ("b", 12.0, 11.0), False, False),
        (("a", 40.0, 10.0), ("b", 41.0, 10.0), True, False),  # four times as large, four times as far off
        (("a", 12.0, 10.0), ("b", 12.0, NAN), True, True),
        (("a", 12.0, NAN), ("b", NAN, 12.0), True, True),
        (("a", -10.0, 10.0), ("b", 10.0, -20.0), False, False),
        (("a", 12.0, 11.0), ("b", 12.0, -11.0), True, True),  # a size has no sign
        (("a", 12.0, 10.0), ("a", 12.0, 10.0), False, False),  # of one kind
        (("a", 10.2, 10.0), ("b", 10.2, 10.0), False, True),  # neither is seen
    ],
)  # fmt: skip
def test_two_mistakes(one: tuple[str, float, float], other: tuple[str, float, float], near: bool, same: bool):
    found = told(one, other)
    assert (bool(found.near[0, 1]), bool(found.same[0, 1])) == (near, same)
    assert np.array_equal(found.near, found.near.T)


def test_a_mistake_beside_the_right_answer():
    found = told(("a", 10.0, 10.0), ("b", 10.2, 10.0), ("c", 10.4, 10.0), ("d", NAN, NAN), ("e", 10.0, -10.0))
    assert [name[0] for name in found.names] == ["a", "b", "c", "e"]
    assert found.still.tolist() == [True, False, False, True]
    assert found.seen.tolist() == [False, False, True, False]


def test_what_is_always_the_same_counts_for_nothing():
    one = told(("a", 12.0, 10.0), ("b", 12.0, 10.0), ("c", 12.0, 10.0), ("d", 10.0, 10.0), ("e", 10.0, 10.0))
    other = told(("a", 15.0, 10.0), ("b", 15.0, 10.0), ("c", 17.0, 10.0), ("d", 10.0, 10.0), ("e", 14.0, 10.0))
    always = Always([one, other])
    assert always.told(one).lost == 4  # a and b beside c, c, and e beside the right answer
    assert always.told(one).sets == {("a", "b"): 1}
    assert always.told(one).rivals == {("a", "c"): 1, ("b", "c"): 1}
    assert always.told(other).lost == 0
    assert always.told(other).kinds["c"] == (1, 1, 1)
    assert always.told(other).kinds["a"] == (1, 1, 0)
    found = set_discriminability([always.told(one), always.told(other)], (0.25, 0.25))
    assert (found.places, found.seen, found.apart, found.lost) == (5, 0.7, 0.2, 0.4)
    assert found.rivals == {("a", "c"): 0.5, ("b", "c"): 0.5}


@pytest.mark.parametrize("name", ["ex3-1", "ex3-5"])
def test_answers_alone_are_those_of_the_key(name: str):
    method = api.plan(api.load(name))
    key, found = key_for(method.mechanism), mistake_visibility(method, replay_all(method), marking_of(method))
    alone = asked_alone(method, replay_all(method), marking_of(method))[1]
    asked = [entry for entry in key.entries if entry.points]
    assert [entry.right for entry in alone] == pytest.approx([entry.right for entry in asked])
    assert [entry.tolerance for entry in alone] == pytest.approx([entry.tolerance for entry in asked], rel=0.15)
    whole = {row[0][0] for row, values in zip(key.singles.names, key.singles.values, strict=True) if np.isfinite(values).any()}
    assert {name[0] for name in found.names} <= whole


def test_what_is_known_to_be_the_same_of_example_3_1():
    """The Coriolis term the other way and the sense of omega 3 misread differ in omega 3 alone; a block that does not
    turn and a Coriolis term left out in nothing."""
    text = re.sub("(?m)^ask .*", 'ask = ["alpha 3", "a_k B3B2"]', library.load("ex3-1").text)
    method = api.plan(loading.loads(text))
    found = mistake_visibility(method, replay_all(method), marking_of(method))
    sets = Always([found]).told(found).sets
    assert ("coriolis-reversed", "omega-sense") in sets
    assert ("block-omega", "coriolis-omitted") in sets
    assert ("coriolis-half", "coriolis-omitted") not in sets


def test_drawings_that_do_not_close_are_counted():
    """The ram of exercise 3-15 stands 2 degrees from where its links do not reach; four-bars far from it all close."""
    for name, part in (("p3-15", 0.4), ("ex3-5", 0.0)):
        method = api.plan(library.load(name))
        assert asked_alone(method, replay_all(method), marking_of(method))[2] == pytest.approx(part, abs=0.08)


# --- sets -------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def template(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("template") / "slide.toml"
    path.write_text(TEXT + "\n[scales]\nlength = 0.001\nvelocity = 0.005\nacceleration = 0.05\n", encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def eight(template: Path) -> tuple[Variant, ...]:
    return variants(read_template(template), roster("8"), "1")


def test_the_problems_taken_are_the_better_ones(template: Path, eight: tuple[Variant, ...]):
    read_one, goal = read_template(template), draws._Goal.of(read_template(template), "1", USUAL)
    others = (one for one in draws._sample(read_one, "others", USUAL).values() if one is not None)
    usual = [goal.always.told(one.tells).lost for one in others if goal.against(one) is None]
    assert len(usual) > 5
    assert np.mean([one.told.lost for one in eight]) < np.mean(usual)


def test_no_answer_of_a_neighbour_is_right(template: Path, eight: tuple[Variant, ...]):
    read_one = read_template(template)
    problems = [draws._drawn(read_one, v.numbers, USUAL) for v in eight]
    for one, other in combinations([columns(drawn.asked[1]) for drawn in problems if not isinstance(drawn, str)], 2):
        assert np.any(np.abs(one.right - other.right) > np.minimum(one.tolerance, other.tolerance))


@pytest.fixture(scope="module")
def written(template: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, str]:
    """A set's folder, and what is printed."""
    out = tmp_path_factory.mktemp("set") / "set"
    result = CliRunner().invoke(main, ["problems", str(template), "--students", "1", "-o", str(out), "--lang", "en"])
    assert result.exit_code == 0, result.output
    return out, result.stdout


def test_what_a_set_tells_is_printed_and_kept(written: tuple[Path, str]):
    out, printed = written
    kept = (out / "teacher" / "set.mistakes.txt").read_text("utf-8")
    assert "One set" in kept
    # in sentences, as in Chinese, not by their ids
    assert "the direction line of a velocity is drawn along the link" in kept
    assert not re.search(r"(?m)^ *(?:[\d%]+ +)*[a-z]+-[a-z]+(?:-[a-z]+)*(?: |$)", kept)
    assert kept.split("\n\n--")[0] in printed
    data = json.loads((out / "teacher" / "set.json").read_text("utf-8"))["told"]
    assert data["problems"] == 1
    assert 0 < data["told apart"] <= data["applicable"] <= 1
    assert data["right work"]["mistake named"] < 0.01


def test_what_a_set_tells_in_chinese(template: Path):
    found = variants(read_template(template), roster("1"), "1")
    lines = list(discriminability_lines(set_discriminability([variant.told for variant in found], (0.25, 0.25)), "zh"))
    assert lines[0].startswith("各题答案能区分哪些错误（1 题")
    assert any(re.fullmatch(r" *1 +100% +0%  漏掉科氏加速度", line) for line in lines)
    assert not any("正确作图" in line for line in lines), "no problem was tried"


# --- what a pencil can tell --------------------------------------------------------------------


def parts(mechanism) -> dict[str, float]:
    """What may be off of each answer that the mechanism's key asks for, as a part of it."""
    keys = key_for(mechanism).positions
    each = ((at_position(e.text, at), e) for at, key in enumerate(keys, 1) for e in key.entries if e.points)
    return {text: part_off(e, mechanism.usual.size(e.unit)) for text, e in each}


CRANKS = """ask = ["omega 3", "alpha 3", "v C"]
frame = { name = "4", A = [0, 0], D = [80, 0] }
links.1.AB = { from = 20, to = 36, step = 1 }
links.2.BC = 70
links.3.DC = 60
driver = [{ vector = "AB", angle = { from = 0, to = 355, step = 5 }, omega = 10 }]
sketch.C = [80, 60]
"""


@pytest.fixture(scope="module")
def four_bars(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("template") / "cranks.toml"
    path.write_text(CRANKS, encoding="utf-8")
    return path


def test_a_pencil_tells_every_answer_and_all_about_as_well(four_bars: Path):
    """By the key that is made of the student's own file: some of the template's problems are told badly, none of the set."""
    read_one = read_template(four_bars)
    sample = [one for one in draws._sample(read_one, "1", USUAL).values() if one is not None]
    assert max(max(one.parts.values()) for one in sample) > TELLS
    found = [parts(loading.loads(variant.mechanism.text)) for variant in variants(read_one, roster("4"), "1")]
    for question in read_one.mechanism([0, 0]).ask:
        own = [one[question] for one in found]
        assert max(own) <= TELLS
        assert max(own) < 3 * min(own)


def test_further_positions_are_told_as_well(four_bars: Path, tmp_path: Path):
    path = tmp_path / "two.toml"
    path.write_text(CRANKS.replace("omega = 10", "also = [100], omega = 10"), encoding="utf-8")
    found = [parts(variant.mechanism) for variant in variants(read_template(path), roster("1"), "1")]
    assert len(found[0]) == 6
    assert max(max(one.values()) for one in found) <= TELLS


def test_numbers_that_promise_well_are_tried_first(four_bars: Path):
    read_one = read_template(four_bars)
    goal = draws._Goal.of(read_one, "1", USUAL)
    tries = [(length, angle) for length in range(0, 17, 4) for angle in range(0, 72, 6)]
    good = []
    for numbers in goal.likely_first(tries):
        drawn = draws._drawn(read_one, numbers, USUAL)
        good.append(not isinstance(drawn, str) and goal.against(drawn) is None)
    assert sorted(goal.likely_first(tries)) == tries
    assert sum(good[:15]) > 2 * sum(good[-15:])


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_a_question_that_no_pencil_tells_is_named(lang, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    for name in ("_TRIES", "_SAMPLE_TRIES"):
        monkeypatch.setattr(draws, name, 15)
    path = tmp_path / "it.toml"
    path.write_text(CRANKS.replace("from = 0, to = 355", "from = 60, to = 100"), encoding="utf-8")
    args = ["problems", str(path), "--students", "1", "-o", str(tmp_path / "set"), "--lang", lang]
    result = CliRunner().invoke(main, [*args, "--pencil", "2,2"])
    assert result.exit_code == 3
    assert re.search(r"(omega 3|alpha 3) (to within|的允差至少为) \d\d%", result.stderr)
    assert not (tmp_path / "set").exists()
    assert CliRunner().invoke(main, args).exit_code == 0


def test_scales_are_in_the_file_and_its_sheet_has_room(four_bars: Path):
    (variant,) = variants(read_template(four_bars), roster("1"), "1")
    stated, method = variant.mechanism.scales, api.plan(variant.mechanism)
    assert sorted(stated) == ["acceleration", "length", "velocity"]
    assert {SCALES[plane]: scale for plane, scale in scales_of(method, replay_all(method)).items()} == stated


# --- figures ----------------------------------------------------------------------------------


def test_the_figure_shows_the_mechanism_and_no_answer(written: tuple[Path, str]):
    figure = (written[0] / "students" / "s1.html").read_text("utf-8").split("<figure")[1].split("</figure>")[0]
    texts = {"".join(re.findall(">([^<]+)<", text)) for text in re.findall("<text.*?</text>", figure)}
    assert {"A", "B", "C", "D", "ω1"} <= texts
    assert not any("rad/s" in text for text in texts)
    assert "alpha" not in figure


@pytest.mark.parametrize("asked", ["theta 3", "P13", "x C", "theta 3 / theta 2"])
def test_a_figure_does_not_lie_where_the_answer_could_be_measured(asked: str):
    text = re.sub("(?m)^ask .*", f'ask = ["omega 3", "{asked}"]', library.load("ex3-5").text)
    posed = well_posed(loading.loads(text))
    assert not isinstance(posed, str)
    shown = shown_at(posed.method, posed.drawn)
    assert shown is not None
    assert not shown[1]
    assert abs(float(shown[0].theta["3"]) - float(posed.drawn.theta["3"])) > np.radians(2)


def test_a_figure_lies_as_it_is_drawn_where_motions_are_asked_for():
    posed = well_posed(library.load("ex3-1"))
    assert not isinstance(posed, str)
    assert shown_at(posed.method, posed.drawn) == (posed.drawn, True)
