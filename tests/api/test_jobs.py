"""Ten jobs of a program's author, each as `graphkin help api` tells to do it."""

from __future__ import annotations

import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

import graphkin
from graphkin.model.readout import Readable
from graphkin.model.units import Number, Numbers, Vector, Vectors
from graphkin.sheet.marks import PointMark, VectorMark


def four_bar() -> graphkin.Mechanism:
    builder = graphkin.Mechanism.new("mine").fix(A=(0, 0), D=(60, 0)).link(1, AB=20).link(2, BC=50, BE=30, CE=30, ccw="BCE")
    return builder.link(3, DC=40).drive("AB", angle=60, omega=10).sketch(C=(45, 38)).asking("omega 3", "v E").done()


def test_a_four_bar_in_code_as_a_table_and_a_diagram(tmp_path: Path):
    swept = graphkin.sweep(four_bar(), "0:360:30", "omega 3, v E")
    assert swept.save(tmp_path / "table.csv").read_text("utf-8").startswith("AB [deg],omega 3 [rad/s]")
    assert swept.save(tmp_path / "diagram.svg").stat().st_size > 10_000
    assert swept.columns()["omega 3 [rad/s]"] == pytest.approx(graphkin.motion(four_bar(), [swept.theta["1"]]).omega["3"])


def test_the_path_of_a_point():
    path = graphkin.sweep(four_bar(), "0:360:30").position["E"]
    assert np.ptp(path.x.mm) > 20
    assert path[0].x.mm == pytest.approx(path[-1].x.mm)


def test_many_files(tmp_path: Path):
    for k in range(6):
        (tmp_path / f"{k}.toml").write_text(four_bar().with_(AB=15 + k).to_toml(), encoding="utf-8")
    (tmp_path / "bad.toml").write_text("frame = 3", encoding="utf-8")
    solved = {one.name: one for one in graphkin.solve_many(sorted(tmp_path.glob("*.toml")))}
    assert solved["3"]["omega 3"] == pytest.approx(graphkin.motion(four_bar().with_(AB=18)).omega["3"])
    assert isinstance(solved["bad"].error, graphkin.GraphkinError)


def test_an_optimum():
    trial = graphkin.trial(four_bar(), "BE", "CE", over="0:360:5")
    goal = trial(32, 27).position["E"].si

    def miss(lengths: np.ndarray) -> float:
        return float(np.abs(trial(*lengths).position["E"].si - goal).max())

    optimize = pytest.importorskip("scipy.optimize")
    best = optimize.minimize(miss, [30, 30], method="Nelder-Mead", options={"xatol": 1e-6, "fatol": 1e-10})
    assert best.x == pytest.approx([32, 27], abs=1e-3)
    assert trial.taken(*best.x).mechanism.links["2"].arm("B", "E") is not None


def test_tolerances_by_many_mechanisms():
    lengths = np.random.default_rng(1).normal(20, 0.02, 500)
    found = graphkin.replay(four_bar().variants(AB=lengths)).omega["3"]
    slope = (graphkin.replay(four_bar().with_(AB=20.01)).omega["3"] - graphkin.replay(four_bar().with_(AB=19.99)).omega["3"]) / 0.02
    assert found.std() == pytest.approx(abs(slope) * lengths.std(), rel=1e-2)


def test_polygons_as_arrays():
    drawn = graphkin.replay("ex3-1", [[60, 90, 120]])
    assert drawn.plot is not None
    assert np.array(drawn.v["B3"]) == pytest.approx(drawn.plot.velocity["b3"])
    assert drawn.plot.acceleration["b3'"].shape == (3,)


def test_an_output_of_ones_own():
    """Every arrow and every point with their names, in millimetres on paper."""
    sheet = graphkin.Drawing.of("ex3-1").sheet()
    arrows = {mark.name: mark for mark in sheet.marks if isinstance(mark, VectorMark)}
    points = {mark.name: mark.at for mark in sheet.marks if isinstance(mark, PointMark) and mark.plane == "velocity"}
    assert arrows["v_B3"].end == points["b3"]
    size = arrows["v_B3"].length * sheet.scales["velocity"]
    assert size == pytest.approx(graphkin.motion("ex3-1").v["B3"].magnitude)


def test_a_service_with_threads():
    def answer(name: str) -> tuple[str, bytes]:
        return graphkin.Drawing.of(name).sheet().svg(), graphkin.sweep(name, "0:90:30").figure().to_png()

    with ThreadPoolExecutor(8) as threads:
        first, second = threads.map(answer, ["ex3-1", "ex3-1"])
    assert first == second


def test_what_is_read_has_a_type():
    """Numbers of one position, arrays of many: editors complete `v["C"].direction`."""
    assert Readable[Number, Vector] in graphkin.Drawing.__orig_bases__  # type: ignore[attr-defined]
    assert Readable[Numbers, Vectors] in graphkin.Sweep.__orig_bases__  # type: ignore[attr-defined]
    drawing = graphkin.Drawing.of("ex3-1", 60)
    read = drawing.omega["3"], drawing.v["C"], drawing["a_k B3B2"], graphkin.sweep("ex3-1", "0:90:30").v["C"]
    assert [*map(type, read)] == [Number, Vector, Vector, Vectors]


def test_homework(tmp_path: Path):
    text = four_bar().to_toml().replace("AB = 20", "AB = { from = 18, to = 22, step = 1 }")
    (tmp_path / "rocker.toml").write_text(text, encoding="utf-8")
    made = graphkin.problems(tmp_path / "rocker.toml", 2, tmp_path / "set", formats=["board", "moodle", "csv"])
    first, second = made
    names = {path.name for path in (tmp_path / "set").rglob("*") if path.is_file()}
    assert {f"{first.student.id}.board.html", f"{second.student.id}.board.html"} <= names
    assert [name for name in names if "moodle" in name]
    with pytest.raises(graphkin.GraphkinError, match="formats: canvas"):
        graphkin.problems(tmp_path / "rocker.toml", 2, tmp_path / "other", formats="canvas")
    assert not (tmp_path / "other").exists()
    assert first.mechanism.text != second.mechanism.text
    right = graphkin.motion(first.mechanism)
    answers = f'student = "{first.student.id}"\n"omega 3" = {right.omega["3"] * 1.5}\n"v E" = {right.v["E"].magnitude}\n'
    (tmp_path / "1.toml").write_text(answers, encoding="utf-8")
    [graded] = graphkin.grade(tmp_path / "set", tmp_path / "1.toml")
    assert graded.marked is not None
    assert {one.text: one.verdict for one in graded.marked.judged} == {"omega 3": "wrong", "v E": "right"}
    assert graphkin.lines_of(graded)[0].startswith(first.student.id)
    written = graphkin.grade_into(tmp_path / "results", tmp_path / "set", tmp_path / "1.toml", ["csv", "pages"])
    assert {"marks.json", "class.csv"} < {path.name for path in written}
    assert all(path.exists() for path in written)
    page = graphkin.handout(first.mechanism, stage="blank")
    assert page.save(tmp_path / "page.html").read_text("utf-8") == page._repr_html_()


def test_the_words_of_the_commands(tmp_path: Path):
    """Every answer says itself, is plain data, and is drawn where there is a figure; what is wrong names an argument."""
    mechanism = graphkin.load("ex3-5")
    drawing = graphkin.Drawing.of(mechanism, 90)
    varied = graphkin.find("p3-21", "stroke s piston", vary="DH=90:100:10")
    assert [row.found is not None for row in varied.rows] == [True, True]
    for answer, word in (
        (graphkin.structure(mechanism), "Class II"), (graphkin.linkage(mechanism)[0], "crank-rocker"), (varied, "stroke"),
        (graphkin.power(mechanism, trials=5), "mistake"), (graphkin.linkage(fourbar=("15 mm", 48, 55, 45))[0], "AB = 15 mm"),
    ):  # fmt: skip
        assert word in "\n".join(graphkin.lines_of(answer))
        assert graphkin.data_of(answer)
        assert len(repr(answer)) < 200
    [position] = graphkin.data_of(drawing)["positions"]
    assert position["drivers"] == pytest.approx([np.pi / 2])
    assert "<svg" in graphkin.sheet_of(graphkin.linkage(mechanism)).svg()
    assert any(line.split()[0] == "θ1" and line.endswith("90°") for line in str(drawing.equations()).splitlines() if line)
    assert drawing.equations(method="matrix").save(tmp_path / "e.tex").read_text("utf-8").startswith("\\documentclass")
    for wrong, name in ((lambda: graphkin.linkage(guide=(1, 2)), "guide"), (lambda: graphkin.find(mechanism, "max v E", vary="XX=1"), "vary"),
                        (lambda: graphkin.trial(mechanism, "AB", over="a:b:c"), "ranges"), (lambda: graphkin.design("rocker", K=1.2, length="x"), "length")):  # fmt: skip
        with pytest.raises(graphkin.GraphkinError, match=f"^{name}:"):
            wrong()


def test_short_reprs():
    mechanism = four_bar()
    trial = graphkin.trial(mechanism, "AB", over=[[10, 20, 30]])
    assert repr(trial) == "<Trial of mine: AB at 3 position(s)>"
    assert repr(graphkin.Mechanism.new("mine").fix(A=(0, 0))) == "<Builder of mine: frame>"
    assert repr(graphkin.Drawing.of(mechanism)) == "<Drawing of mine at AB = 60°>"
    assert repr(graphkin.Drawing.of(mechanism).sheet(tight=True)).startswith("<Sheet of mine on ")
    assert len(repr(graphkin.motion(mechanism).motions)) < 200


# --- beside another program ---------------------------------------------------------------------


OURS = """
import graphkin
mechanism = graphkin.Mechanism.new().fix(A=(0, 0), D=(60, 0)).link(1, AB=20).link(2, BC=50).link(3, DC=40)
mechanism = mechanism.drive("AB", angle=0, omega=10).sketch(C=(45, 38)).done()
places = graphkin.sweep(mechanism, "0:359:1").position["C"].mm
"""
THEIRS = """
import math
from pylinkage.actuators import Crank
from pylinkage.components import Ground
from pylinkage.dyads import RRRDyad
from pylinkage.simulation import Linkage
A, D = Ground(0, 0, name="A"), Ground(60, 0, name="D")
step = math.tau / 360
crank = Crank(A, 20, angular_velocity=step, initial_angle=-step, name="B")
hinge = RRRDyad(crank.output, D, 50, 40, x=45, y=38, name="C")
linkage = Linkage([A, D, crank, hinge])
places = [complex(*coordinates[-1]) for coordinates in linkage.step(360)]
"""


@pytest.mark.further
def test_lines_and_times_beside_pylinkage(capsys: pytest.CaptureFixture[str]):
    """The same four-bar over a turn: the same places."""
    pytest.importorskip("pylinkage")
    found, told = [], []
    for name, source in (("graphkin", OURS), ("pylinkage", THEIRS)):
        names: dict[str, object] = {}
        exec(source, names)  # what is imported once is not counted
        start = time.perf_counter()
        exec(source, names)
        told.append(f"{name}: {len(source.split(chr(10))) - 2} lines, {1e3 * (time.perf_counter() - start):.1f} ms")
        found.append(np.array(names["places"]))
    with capsys.disabled():
        print("\na four-bar over a turn: " + "; ".join(told), end="")
    assert found[0] == pytest.approx(found[1], abs=1e-6)
