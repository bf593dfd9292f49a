"""What is found is saved as by the commands, and wrong objects are told what to give."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import graphkin
from graphkin.cli import main
from graphkin.errors import (
    BadValues,
    NoSuchDriver,
    NotAMechanism,
    NotANumber,
    NothingDrawn,
    SeveralPositions,
    UnknownPaper,
)
from graphkin.outputs.files import FileInTheWay, UnknownEnding


def command(*words: str) -> None:
    result = CliRunner().invoke(main, words)
    assert result.exit_code == 0, result.output


@pytest.mark.parametrize("kind", [".svg", ".pdf", ".tex", ".ggb"])
def test_a_drawing_is_saved_as_the_command_draws_it(kind: str, tmp_path: Path):
    command("draw", "ex3-1", "--angle", "90", "-o", str(tmp_path / f"a{kind}"))
    sheet = graphkin.Drawing.of("ex3-1", 90).sheet()
    assert sheet.save(tmp_path / f"b{kind}").read_bytes() == (tmp_path / f"a{kind}").read_bytes()
    assert sheet.svg() == graphkin.Drawing.of("ex3-1", {"AB": 90})._repr_svg_()


SAME: dict[str, tuple[list[str], Callable[[], object]]] = {
    "centres": (["centres", "fig3-4"], lambda: graphkin.centres("fig3-4")),
    "about": (["centres", "fig3-4", "--about", "3"], lambda: graphkin.centres("fig3-4", about="3")),
    "bobillier": (["centres", "fig3-4", "--about", "3", "--bobillier", "E"],
                  lambda: graphkin.centres("fig3-4", about="3", bobillier="E")),
    "centrodes": (["centres", "fig3-6", "--centrodes", "3,1"], lambda: graphkin.centres("fig3-6", centrodes="3,1")),
    "path": (["centres", "fig3-10", "--path", "P13", "--driver", "0:2:1"],
             lambda: graphkin.centres("fig3-10", path="P13", ranges="0:2:1")),
    "find": (["find", "ex3-7", "max v E"], lambda: graphkin.find("ex3-7", "max v E")),
    "design": (
        ["design", "rocker", "--length", "80", "--swing", "40", "--K", "1.3", "--frame", "71"],
        lambda: graphkin.design("rocker", length=80, swing=40, K=1.3, frame=71),
    ),
}


@pytest.mark.parametrize("name", SAME)
def test_answers_are_those_of_the_commands(name: str, tmp_path: Path):
    words, ask = SAME[name]
    answer = ask()
    assert CliRunner().invoke(main, [*words, "--lang", "zh"]).stdout.splitlines() == graphkin.lines_of(answer, "zh")
    command(*words, "-o", str(tmp_path / "a.svg"))
    assert graphkin.sheet_of(answer).save(tmp_path / "b.svg").read_bytes() == (tmp_path / "a.svg").read_bytes()
    assert len(repr(answer)) < 200


def test_a_sweep_and_a_check_are_told_as_their_commands_tell_them(tmp_path: Path):
    """With what the sweep leaves out, and why."""
    swept = graphkin.sweep("p3-22", "185:300:40", "v C")
    lines = graphkin.lines_of(swept, "zh")
    assert CliRunner().invoke(main, ["sweep", "p3-22", "--driver", "185:300:40", "--of", "v C", "--lang", "zh"]).stdout.splitlines() == lines
    file = graphkin.Drawing.of("s2-4").sheet().save(tmp_path / "a.svg")
    told = graphkin.lines_of(graphkin.measure(file))
    assert CliRunner().invoke(main, ["check", str(file), "--lang", "en"]).stdout.splitlines() == told


@pytest.mark.parametrize("kind", [".csv", ".json", ".svg"])
def test_a_sweep_is_saved_as_the_command_writes_it(kind: str, tmp_path: Path):
    command("sweep", "ex3-7", "--driver", "0:90:30", "--of", "v E", "-o", str(tmp_path / f"a{kind}"))
    swept = graphkin.sweep("ex3-7", "0:90:30", "v E")
    assert swept.save(tmp_path / f"b{kind}").read_bytes() == (tmp_path / f"a{kind}").read_bytes()


def test_the_bytes_of_a_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """What a service sends is what would be saved."""
    monkeypatch.setattr("graphkin.page.player._TOLD", 12)  # of a page with few words
    sheet, figure = graphkin.Drawing.of("ex3-1").sheet(), graphkin.sweep("ex3-1", "0:90:30")
    assert sheet.to_pdf() == sheet.save(tmp_path / "a.pdf").read_bytes()
    assert sheet.to_png() == sheet.save(tmp_path / "a.png").read_bytes()
    assert figure.figure().to_pdf() == figure.save(tmp_path / "b.pdf").read_bytes()
    page, played = graphkin.handout("ex3-1", stage="problem"), graphkin.play("ex3-1")
    assert page.to_pdf("letter") == page.save(tmp_path / "c.pdf", paper="letter").read_bytes()
    assert page.to_html("letter") == page.save(tmp_path / "c.html", paper="letter").read_text("utf-8")
    assert played.text == played.save(tmp_path / "d.html").read_text("utf-8")
    for call in (page.to_pdf, page.to_html):
        with pytest.raises(UnknownPaper):
            call("A9")


def test_steps_are_sheets(tmp_path: Path):
    command("design", "slider", "--stroke", "40", "--K", "1.2", "--offset", "15", "--steps", str(tmp_path))
    steps = graphkin.sheet_of(graphkin.design("slider", stroke=40, K=1.2, offset=15)).step_sheets()
    assert [step.svg().encode() for step in steps] == [path.read_bytes() for path in sorted(tmp_path.iterdir())]


def test_another_file_is_not_replaced(tmp_path: Path):
    own, sheet = tmp_path / "a.svg", graphkin.Drawing.of("ex3-1").sheet()
    own.write_text("mine", encoding="utf-8")
    with pytest.raises(FileInTheWay, match="force=True"):
        sheet.save(own)
    sheet.save(own, force=True)
    for page in (sheet, graphkin.sweep("ex3-1", "0:90:30")):
        with pytest.raises(UnknownEnding, match=r"\.pdf"):
            page.save(tmp_path / "a.gif")
    assert [path.name for path in tmp_path.iterdir()] == ["a.svg"]


@pytest.mark.parametrize("wrong", [None, {"frame": {}}, graphkin.Mechanism.new(), 3], ids=["None", "dict", "Builder", "int"])
def test_what_is_no_mechanism(wrong: object):
    def trial(mechanism: object) -> object:
        return graphkin.trial(mechanism, "AB")  # type: ignore[arg-type]

    calls = (graphkin.load, graphkin.plan, graphkin.Drawing.of, graphkin.replay, graphkin.motion, graphkin.sweep,
             trial, graphkin.centres, graphkin.tolerance, graphkin.handout, graphkin.loads)  # fmt: skip
    for call in calls:
        with pytest.raises(NotAMechanism, match=type(wrong).__name__):
            call(wrong)  # type: ignore[operator]
    [solved] = graphkin.solve_many([wrong])  # type: ignore[list-item]
    assert isinstance(solved.error, NotAMechanism)
    with pytest.raises(NotAMechanism):
        [*graphkin.grade(wrong, "a.toml")]  # type: ignore[arg-type]


def test_values_that_no_driver_takes():
    with pytest.raises(NotANumber, match=r'^values: "a"'):
        graphkin.replay("ex3-1", ["a"])
    with pytest.raises(BadValues):
        graphkin.replay("ex3-1", [object()])  # type: ignore[list-item]
    with pytest.raises(ValueError, match="AB"):
        graphkin.Drawing.of("ex3-1", [1, 2])
    for draw in (graphkin.Drawing.of, graphkin.structure):
        with pytest.raises(SeveralPositions, match=r"^values: \[\[60, 90\]\] are several positions"):
            draw("ex3-1", [[60, 90]])
    for values in ({"XY": 3}, {"AB": 60, "XY": 3}):
        with pytest.raises(NoSuchDriver, match=r"no driver XY to move.* AB"):
            graphkin.Drawing.of("ex3-1", values)
    two = graphkin.Mechanism.new().fix(O=(0, 0)).link("a", OP=200).link("b", PQ=150).drive("OP", angle=40)
    arm = two.drive("PQ", from_="PO", angle=-120).done()
    for read in (graphkin.replay, graphkin.motion):
        assert read(arm, [[10, 20], -90]).position["Q"].shape == (2,)
        for uneven in ([[10, 20], [-90, -91, -92]], [[[10], [20]], [[-90, -91, -92]]]):
            with pytest.raises(BadValues, match=r"^values: .* no values to move through"):
                read(arm, uneven)
    with pytest.raises(NothingDrawn):
        graphkin.sheet_of([])
    for wrong in (3, b"x", [], graphkin.Mechanism.new()):
        with pytest.raises(NotAMechanism):
            graphkin.linkage(wrong)  # type: ignore[arg-type]
    with pytest.raises(NothingDrawn):
        graphkin.lines_of(3)
    at = graphkin.motion("ex3-1", graphkin.replay("ex3-1", [[60, 90]]).theta["1"][None])
    assert at.omega["3"] == pytest.approx(graphkin.motion("ex3-1", [[60, 90]]).omega["3"])


WRONG = [None, -3, [], {}, "nonsense", float("nan"), 10**400, object(), b"x", [None], {1: 2}, np.array("x"), "A" * 3000]
"""Whatever somebody may give in place of what is wanted."""
CALLS: list[tuple[str, tuple[object, ...], dict[str, object]]] = [
    ("load", ("ex3-1",), {}), ("plan", ("ex3-1",), {}), ("replay", ("ex3-1",), {}), ("motion", ("ex3-1",), {}),
    ("trial", ("ex3-1", "AB"), {}), ("structure", ("ex3-1",), {}), ("linkage", ("ex3-5",), {"fourbar": (15, 48, 55, 45)}),
    ("sweep", ("ex3-1", "0:20:10", "omega 3"), {}), ("find", ("ex3-1", "max omega 3", "0:20:5"), {}),
    ("centres", ("fig3-4",), {"about": "3", "bobillier": "E"}), ("centres", ("fig3-6",), {"centrodes": "3,1"}),
    ("design", ("rocker",), {"length": 80, "swing": 40, "K": 1.3, "frame": 71}), ("handout", ("s2-2",), {"stage": "problem"}),
    ("solve_many", (["ex3-1"],), {}), ("sweep_many", (["ex3-1"], "0:20:10"), {}),
    ("tolerance", ("ex3-1",), {}), ("problems", ("no.toml", 2, "set"), {}), ("measure", ("no.svg",), {}),
    ("grade", ("no.json", "no.csv"), {}), ("grade_into", ("results", "no.json", "no.csv"), {}),
]  # fmt: skip


@pytest.mark.parametrize(("name", "given", "named"), CALLS, ids=[f"{call[0]}{k}" for k, call in enumerate(CALLS)])
def test_wrong_objects_get_an_error_of_ours(
    name: str, given: tuple[object, ...], named: dict[str, object], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    """Every argument in turn; what is no error is a result. No other exception leaves a call."""
    monkeypatch.chdir(tmp_path)
    call = getattr(graphkin, name)
    for wrong in WRONG:
        for place in range(len(given)):
            tried(call, (*given[:place], wrong, *given[place + 1 :]), named)
        for word in inspect.signature(call).parameters:
            if bound(call, given, more := {**named, word: wrong}):
                tried(call, given, more)


def bound(call: Callable[..., object], given: tuple[object, ...], named: dict[str, object]) -> bool:
    """False for a word whose place is taken."""
    try:
        inspect.signature(call).bind(*given, **named)
    except TypeError:
        return False
    return True


def tried(call: Callable[..., object], given: tuple[object, ...], named: dict[str, object]) -> None:
    try:
        found = call(*given, **named)
        assert repr([*found] if isinstance(found, Iterator) else found)
    except graphkin.GraphkinError as error:
        assert error.message("en") != error.message("zh")
    except TypeError as error:
        raise AssertionError((call, given, named)) from error
