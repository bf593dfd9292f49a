"""Paths of points on the sheet: where the analysis has the point, at true scale, within the figure."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from library_sheets import TEXTBOOK, plain_text
from si_values import si

import graphkin
from graphkin.check.ruler import measure
from graphkin.cli import main
from graphkin.errors import GraphkinError, Lang
from graphkin.files import library
from graphkin.outputs.svg import svg
from graphkin.planning import plan
from graphkin.sheet.marks import PointMark, Stroke, Text
from graphkin.sheet.motion_frames import motion_frames
from graphkin.studies.sweeps import PointPath, point_path

TRAMMEL = """
frame = { O = [0, 0] }
[links]
2.points = ["X"]
3.points = ["Y"]
4 = { XY = 120.65, YM = 80, XM = 200.65 }
[[slide]]
name = "bed"
block = "2"
point = "X"
guide = "frame"
through = "O"
angle = 0
[[slide]]
block = "3"
point = "Y"
guide = "frame"
through = "O"
angle = 90
[[driver]]
slide = "bed"
at = 70
velocity = -0.2
[sketch]
Y = [0, 95]
M = [-50, 157]
"""
TURNING_WITHOUT_RATE = '''[frame]
A = [0, 0]
D = [80, 0]
[links.1]
AB = 30
[links.2]
BC = 70
[links.3]
CD = 60
[[driver]]
vector = "AB"
angle = 60
[sketch]
C = [80, 60]
'''


def exact(path: PointPath, t: np.ndarray) -> graphkin.State:
    """The analysis at t on the way."""
    return graphkin.motion(path.course.method.mechanism, si(path.course.method, [np.broadcast_to(v, t.shape) for v in path.course.path.values(t)]))


@pytest.mark.parametrize(
    ("name", "point", "values", "closed", "step"),
    [
        ("ex3-5", "E", None, True, "30°"),
        ("ex3-5", "E", (math.radians(200),), True, "30°"),
        ("p3-7", "D", None, False, "10°"),
        ("p3-14", "E", None, False, "5 mm"),
        ("s4-ex5", "B", None, False, "30°"),
    ],
)
def test_a_path_is_where_the_analysis_has_the_point(
    name: str, point: str, values: tuple[float, ...] | None, closed: bool, step: str
) -> None:
    path = point_path(graphkin.plan(graphkin.load(name)), point, values)
    assert path.closed == closed
    assert path.shown(path.step) == step
    t = np.array([path.course.at(tick.value) for tick in path.ticks])
    found, size = exact(path, t), float(np.ptp(path.places.real) + np.ptp(path.places.imag))
    fastest = max(abs(tick.velocity) for tick in path.ticks)
    assert np.abs(found[f"path {point}"].si - [tick.place for tick in path.ticks]).max() < 1e-7 * size
    assert np.abs(found.v[point].si - [tick.velocity for tick in path.ticks]).max() < 1e-7 * fastest
    ways = [tick.way for tick in path.ticks if abs(tick.velocity) > 1e-3 * fastest]
    moving = [tick.velocity / abs(tick.velocity) for tick in path.ticks if abs(tick.velocity) > 1e-3 * fastest]
    assert np.abs(np.abs((np.array(ways) * np.conj(moving)).real) - 1).max() < 1e-4
    assert np.abs(np.diff(path.places)).max() < 0.05 * size


def test_a_sheet_shows_the_path_to_scale_and_is_still_measured() -> None:
    drawing = graphkin.Drawing.of(graphkin.load("ex3-5"))
    sheet = drawing.sheet(paths=["E"], arrows=True, only="position")
    curve = max((mark for mark in sheet.marks if isinstance(mark, Stroke)), key=lambda mark: len(mark.places))
    scale, origin = sheet.scales["position"], sheet.origins["position"]
    places = np.conj(np.array([*curve.places, curve.places[0]]) - origin) * scale
    there = exact(point_path(drawing.method, "E"), np.linspace(0, 2 * np.pi, 720))["path E"].si
    near = np.array([_nearest(place, places) for place in there])
    assert near.max() < 0.03 * scale, "0.03 mm on paper"
    frame = sheet.paper.frame
    assert all(frame.holds(place) for place in curve.places)
    arrows = [m for m in sheet.marks if isinstance(m, Stroke) and m.accent == "velocity" and m.pen == "hatch"]
    assert len(arrows) == 12
    assert "path of " in svg(sheet)


@pytest.mark.parametrize(
    ("name", "point"), [("ex3-5", "E"), ("p3-7", "D"), ("s4-ex6", "C"), ("curved-slot", "B")]
)
def test_a_ruler_measures_the_path(name: str, point: str, tmp_path: Path) -> None:
    """A turn, between dead points, drivers that keep pace, under a link; then one corner aside, and a part cut off."""
    text = svg(graphkin.Drawing.of(graphkin.load(name)).sheet(paths=[point], only="position", paper="A3"))
    found = re.search(r'<(?:path|polyline|polygon)[^>]*data-form="path"[^>]*>', text)
    assert found is not None
    places = re.search(r' (?:d|points)="([^"]+)"', found[0])
    assert places is not None
    corners = re.findall(r"-?[0-9.]+[ ,]-?[0-9.]+", places[1])
    x, y = re.split("[ ,]", corners[len(corners) // 3])
    aside = found[0].replace(corners[len(corners) // 3], f"{float(x) + 0.1:.4f} {float(y) + 0.05:.4f}")
    gone = places[1][: places[1].index(corners[len(corners) // 4])]
    shorter = found[0].replace(gone, gone.rstrip("-0123456789. ,")[:1])
    there_and_back = name == "curved-slot"
    for tag, right in ((found[0], True), (aside, False), (shorter, there_and_back)):
        (tmp_path / "a.svg").write_text(text.replace(found[0], tag), encoding="utf-8")
        report = measure(tmp_path / "a.svg")
        assert any(each.kind == "link" and each.off_mm > 0.01 for each in report.measured) is not right
        assert report.passed(0.01) is right


@pytest.mark.parametrize(("case", "point"), [("pin-that-runs-off", "P"), ("disc-with-a-rod", "A")])
def test_a_path_without_an_end_is_drawn_as_far_as_the_mechanism_is_seen(case: str, point: str, tmp_path: Path) -> None:
    """The pin runs off to infinity, the disc rolls on for ever; a ruler does not miss what no sheet has room for."""
    drawing = graphkin.Drawing.of(graphkin.load(Path(__file__).parents[1] / "cases" / f"{case}.toml"))
    places = point_path(drawing.method, point).places
    assert 0.5 < np.ptp(places.real) < 6
    (tmp_path / "a.svg").write_text(svg(drawing.sheet(paths=[point], only="position", paper="A3")), encoding="utf-8")
    assert measure(tmp_path / "a.svg").passed(0.01)


def test_how_far_a_slide_goes_does_not_hang_on_the_origin() -> None:
    """Coordinates of a machine hall: the disc still rolls as far as its links are long."""
    disc = graphkin.load(Path(__file__).parents[1] / "cases" / "disc-with-a-rod.toml")
    away = disc.with_({"sketch.A": (1e6 + 20, 140 - 2e6)}, Q=(1e6, -2e6), B=(1e6 + 250, -2e6))
    near, far = (graphkin.sweep(each, (), "omega AB") for each in (disc, away))
    assert np.array_equal(near.driven, far.driven)
    assert near["omega AB"].signed == pytest.approx(far["omega AB"].signed, rel=1e-6)


def _nearest(place: complex, line: np.ndarray) -> float:
    """How far a place is from a line through places."""
    start, way = line[:-1], np.diff(line)
    share = np.clip(((place - start) * np.conj(way)).real / np.abs(way) ** 2, 0, 1)
    return float(np.abs(start + share * way - place).min())


@pytest.mark.parametrize(
    ("options", "status", "said"),
    [
        (["ex3-5", "--path", "Q"], 3, "path Q: there is no point Q"),
        (["ex3-5", "--path", "A"], 3, "A stays where it is"),
        (["-", "--path", "C", "--arrows"], 3, "driver AB has no omega"),
        (["ex3-5", "--arrows"], 2, "--path E"),
        (["ex3-5", "--path", "E", "--style", "given"], 2, "leave out --style given"),
        (["ex3-5", "--path", "E", "--only", "velocity"], 2, "leave out --style given, --only"),
        (["ex3-5", "--path", "E", "-o", "x.ggb"], 2, "Locus"),
        *((["ex3-5", "--only", only, "-o", "x.ggb"], 2, "leave out --only") for only in ("position", "velocity", "acceleration")),
    ],
)
def test_what_cannot_be_drawn_is_said(options: list[str], status: int, said: str) -> None:
    result = CliRunner().invoke(main, ["draw", *options, *(() if "-o" in options else ("-o", "-"))], input=TURNING_WITHOUT_RATE)
    assert result.exit_code == status
    assert said in result.output.replace("\n", " ")


def test_a_path_of_a_point_in_python_names_it() -> None:
    with pytest.raises(GraphkinError, match="no point Q"):
        graphkin.Drawing.of(graphkin.load("ex3-5")).sheet(paths=["Q"])


@pytest.mark.parametrize(
    ("ask", "answers"),
    [
        ('["path C"]', ["C is at (65.08, 46.23) mm.", "ω3 = 3.919 rad/s (clockwise)"]),
        ('["x C", "path C", "omega 3"]', ["x_C, the place of C and ω3.", "x_C = 65.08 mm", "C is at (65.08, 46.23) mm."]),
    ],
)
def test_a_solution_answers_where_a_point_is(ask: str, answers: list[str]) -> None:
    text = re.sub("(?m)^ask *= .*", f"ask = {ask}", library.text("ex3-1"))
    said = CliRunner().invoke(main, ["explain", "-", "--lang", "en"], input=text).stdout
    assert all(answer in said for answer in answers)



def test_a_path_goes_on_until_the_mechanism_repeats() -> None:
    method = plan(graphkin.load(TEXTBOOK / "gearfive.toml"))  # gears of 2 in and 3 in
    whole, crank = point_path(method, "P"), point_path(method, "A")
    assert whole.closed
    assert sorted(round(math.degrees(tick.value)) for tick in whole.ticks) == [*range(0, 1080, 30)]
    assert crank.closed
    assert len(crank.ticks) == 12
    first = {tick.value: tick.place for tick in whole.ticks}
    assert abs(first[0.0] - first[min(first, key=lambda value: abs(value - 2 * math.pi))]) > 0.01
    assert whole.shown(-math.pi / 6) == "−30°"


def test_frames_of_several_turns_end_where_they_began() -> None:
    method = plan(graphkin.load(TEXTBOOK / "gearfive.toml"))
    frames = motion_frames(method, 12, only="position")
    places = [[mark.at for mark in sheet.marks if isinstance(mark, PointMark)] for sheet in frames]
    round_about = zip(places, [*places[1:], places[0]], strict=True)
    steps = [max(abs(a - b) for a, b in zip(*two, strict=True)) for two in round_about]
    assert len(frames) == 36
    assert 0 < steps[-1] < 1.1 * max(steps[:-1])


def test_velocities_near_a_dead_point_do_not_shrink_the_others() -> None:
    """A trammel driven along one guide comes to rest in neither of its ends: there the tracing point is without bound."""
    drawing = graphkin.Drawing.of(graphkin.loads(TRAMMEL))
    page = drawing.sheet(paths=["M"], arrows=True, only="position")
    ticks = sorted(abs(tick.velocity) for tick in point_path(drawing.method, "M").ticks)
    heads = [mark for mark in page.marks if isinstance(mark, Stroke) and mark.pen == "hatch" and mark.accent == "velocity"]
    assert ticks[-1] > 5 * ticks[len(ticks) // 2]
    assert 0.6 * len(ticks) < len(heads) < len(ticks)
    words = [plain_text(mark.label) for mark in page.marks if isinstance(mark, Text)]
    assert "arrows of over 16 mm are left out" in words


def test_arrows_of_a_way_gone_to_and_fro_keep_apart():
    """Those of one sense on one side of the path, the others beyond it; on a loop they start at their ticks."""
    for name, point, aside in (("ex3-1", "C", True), ("ex3-5", "E", False)):
        drawing = graphkin.Drawing.of(graphkin.load(name))
        path, sheet = point_path(drawing.method, point), drawing.sheet(paths=[point], arrows=True, only="position")
        scale, origin = sheet.scales["position"], sheet.origins["position"]
        ticks = [origin + tick.place.conjugate() / scale for tick in path.ticks]
        arrows = [mark for mark in sheet.marks if isinstance(mark, Stroke) and mark.accent == "velocity" and mark.pen == "vector"]
        assert arrows
        for mark in arrows:
            apart = min(abs(mark.places[0] - at) for at in ticks)
            assert (apart > 2) == aside, (name, apart)


@pytest.mark.parametrize(("name", "point", "words"), [
    ("ex3-1", "C", {"en": "a tick every 30° of AB", "zh": "AB 每转 30° 标一刻度"}),
])  # fmt: skip
def test_ticks_are_told_as_people_say_it(name: str, point: str, words: dict[Lang, str]):
    for lang, wanted in words.items():
        sheet = graphkin.Drawing.of(graphkin.load(name)).sheet(paths=[point], only="position", lang=lang)
        assert wanted in ["".join(run.text for run in mark.label) for mark in sheet.marks if isinstance(mark, Text)]
        sizes = [mark.size for mark in sheet.marks if isinstance(mark, Text) and "".join(run.text for run in mark.label) == "90°"]
        assert sizes
        assert min(sizes) >= 3.5
