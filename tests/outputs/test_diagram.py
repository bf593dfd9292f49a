"""Motion diagrams: what is drawn is what moves, and it can be read."""

from __future__ import annotations

import dataclasses
import re
import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from itertools import combinations
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
import pytest
from library_sheets import TEXTBOOK

import graphkin
from graphkin import files as loading
from graphkin.errors import Lang, NoFolder
from graphkin.model.naming import Seen
from graphkin.model.quantities import EDGE, Moving, Quantity, Rotation, centre_of
from graphkin.model.quantities.kinds import Displacement
from graphkin.outputs import diagram
from graphkin.outputs.diagram import fonts
from graphkin.outputs.diagram.curves import Curves, curves, span
from graphkin.outputs.diagram.panels import division, panels
from graphkin.outputs.files import FileInTheWay, UnknownEnding
from graphkin.planning import plan
from graphkin.sheet.results import label_of
from graphkin.studies import sweeps
from graphkin.studies.sweeps import Course

NAMES = (
    "ex3-1", "ex3-7", "p3-15", "p3-19", "p3-20", "p3-21", "p3-22", "p3-23a", "fig3-10", "s4-ex3", "ex3-3", "s3-cam",
    "s3-sieve",
)  # fmt: skip
TURN = 2 * np.pi
chinese = pytest.mark.skipif(fonts.chinese_font() is None, reason="no Chinese font here")


@cache
def moved(name: str, ranges: tuple[str, ...] = (), of: str = "") -> tuple[Course, tuple[str, ...]]:
    method = graphkin.plan(graphkin.load(name))
    names = sweeps.asked(method.mechanism, sweeps.split(of))
    return sweeps.course(method, ranges), tuple(n for n in names if centre_of(method.mechanism, n) is None)


@cache
def sampled(name: str, ranges: tuple[str, ...] = (), of: str = "") -> Curves:
    return curves(*moved(name, ranges, of))


@cache
def drawn(name: str, lang: Lang = "en", ranges: tuple[str, ...] = (), of: str = "") -> Any:
    return diagram.figure(*moved(name, ranges, of), lang)


def lines(page: Any, start: str) -> dict[str, Any]:
    """Lines by their gid."""
    from matplotlib.lines import Line2D

    return {line.get_gid(): line for line in page.findobj(Line2D) if (line.get_gid() or "").startswith(start)}


def texts(page: Any) -> list[tuple[str, Any]]:
    """Every text that is seen, with its box in pixels."""
    from matplotlib.text import Text

    page.draw_without_rendering()
    shown = [t for t in page.findobj(Text) if t.get_visible() and t.get_text().strip()]
    return [(t.get_text(), t.get_window_extent(page.canvas.get_renderer())) for t in shown]


def read(page: Any) -> str:
    """All that is written without its blanks, formulas as plain letters."""
    from matplotlib.text import Text

    signs = {r"\omega": "ω", r"\alpha": "α", r"\theta": "θ", r"\ ": " "}
    text = "".join(each.get_text() for each in page.findobj(Text) if each.get_visible())
    for sign, letter in signs.items():
        text = text.replace(sign, letter)
    return re.sub(r"\\math\w+|[${}_^\s]", "", text)


COMPRESSOR = """
[frame]
A = [0, 0]
[links.1]
AB = "2 in"
[links.2]
BC = "8 in"
[links.3]
points = ["C"]
[[slide]]
block = "3"
point = "C"
guide = "frame"
through = ["0 in", "0.5 in"]
angle = 0
[[driver]]
vector = "AB"
angle = 50
omega = "600 r/min"
alpha = "300 rad/s²"
[sketch]
C = ["9 in", "0.5 in"]
"""


# --- what is drawn ----------------------------------------------------------------------------


@pytest.mark.many(6)
@pytest.mark.parametrize("name", NAMES)
def test_curves_are_what_the_other_road_finds(name: str):
    """The lines on paper, read back, against the loop equations."""
    found, page = sampled(name), drawn(name)
    across = EDGE[found.course.unit].factor
    read = lines(page, "curve-")
    assert read.keys() == {f"curve-{group[0]}" for group in found.alike}
    for group in found.alike:
        x, y = read[f"curve-{group[0]}"].get_data()
        t = found.course.at(np.asarray(x) / across)
        clear = (t - found.low > 0.01 * (found.high - found.low)) & (found.high - t > 0.01 * (found.high - found.low))
        for k in group:
            entry = found.series[k]
            exact = sweeps.quantities_at(found.course, [entry.name], t[clear], "analysis").series[0].signed
            off = np.asarray(y)[clear] / EDGE[entry.unit].factor - exact
            off = off - TURN * np.round(off / TURN) if entry.unit == "rad" else off
            assert np.abs(off).max() <= 1e-6 * max(np.abs(exact).max(), 1e-3), entry.name


@pytest.mark.parametrize("name", NAMES)
def test_extremes_are_greatest_and_least(name: str):
    """No densely sampled value passes them, and they lie on their curve."""
    found = sampled(name)
    t = np.linspace(found.low, found.high, 20003)[1:-1]
    dense = sweeps.quantities_at(found.course, [entry.name for entry in found.series], t, found.by).series
    for k, entry in enumerate(dense):
        low, high = found.bounds(k)
        for peak in found.peaks[k]:
            at = sweeps.quantities_at(found.course, [entry.name], np.array([peak.t]), found.by).series[0].signed[0]
            assert at == pytest.approx(peak.value, abs=1e-9 * max(abs(low), abs(high)))
            near = np.abs(t - peak.t) < 0.02 * (found.high - found.low) if any(found.unbounded(k)) else np.isfinite(t)
            beyond = peak.sign * (entry.signed[near] - peak.value)
            if not any(found.unbounded(k)):
                assert np.nanmax(beyond) <= 1e-9 * (high - low)
            else:
                around = np.abs(t[near] - peak.t) < 1e-4 * (found.high - found.low)
                assert not around.any() or np.nanmax(beyond[around]) <= 1e-9 * (high - low)


def test_extremes_of_a_shaper():
    """The guide bar's limits are where the crank is at right angles to it: sin = l1/l6."""
    found = sampled("ex3-7", of="theta 3")
    first, second = found.peaks[0]
    half = np.arcsin(125 / 275)
    assert (first.value, second.value) == pytest.approx((np.pi / 2 + half, np.pi / 2 - half), rel=1e-12)
    ends = [float(found.course.value(peak.t)) for peak in (first, second)]
    assert ends == pytest.approx([np.pi + half, TURN - half], abs=1e-7)


def test_dots_lie_at_the_extremes():
    found, page = sampled("ex3-7"), drawn("ex3-7")
    dots = lines(page, "peak-")
    assert len(dots) == sum(len(peaks) for peaks in found.peaks) == 18
    for k, (greatest, least) in enumerate(found.peaks):
        for word, peak in (("greatest", greatest), ("least", least)):
            (x,), (y,) = dots[f"peak-{k}-{word}"].get_data()
            assert x == pytest.approx(np.degrees(found.course.value(peak.t)))
            assert y == pytest.approx(peak.value * EDGE[found.series[k].unit].factor)


def test_steps_of_the_table_do_not_matter():
    coarse, fine = sampled("ex3-7", ("0:360:90",)), sampled("ex3-7", ("0:360:1",))
    assert coarse.t.size >= 721
    np.testing.assert_array_equal(coarse.t, fine.t)
    for one, other in zip(coarse.series, fine.series, strict=True):
        np.testing.assert_array_equal(one.values, other.values)


@pytest.mark.parametrize(
    ("name", "ranges", "low", "high"),
    [
        ("ex3-7", (), 0, 360),
        ("ex3-7", ("0:350:10",), 0, 360),
        ("ex3-7", ("60:100:5",), 60, 100),
        ("ex3-7", ("360:0:10",), 0, 360),
        ("ex3-7", ("0:720:10",), 0, 720),
        ("ex3-7", ("30:40:20",), 0, 360),
    ],
)
def test_span(name: str, ranges: tuple[str, ...], low: float, high: float):
    found = moved(name, ranges)[0]
    assert np.degrees([found.value(t) for t in span(found)]) == pytest.approx([low, high])


@pytest.mark.parametrize("name", ["fig3-10", "s4-ex3", "p3-22"])
def test_span_goes_on_to_the_stops(name: str):
    found = moved(name)[0]
    assert span(found) == pytest.approx((found.path.first, found.path.last), rel=1e-12)


def test_without_bound():
    """A velocity grows at both dead points: the scale leaves that out, the summit between them is marked."""
    found, page = sampled("fig3-10"), drawn("fig3-10")
    assert found.unbounded(0) == (True, True)
    values = found.series[0].signed
    assert found.bounds(0)[1] < 0.01 * values.max()
    assert page.axes[0].get_ylim()[1] < 0.02 * values.max()
    summit = next(peak for peak in found.peaks[0] if peak.sign > 0)
    assert found.low + 1 < summit.t < found.high - 1


@pytest.mark.parametrize("name", ["ex3-7", "p3-19", "p3-20"])
def test_nothing_is_without_bound_in_a_full_turn(name: str):
    found = sampled(name)
    for k, entry in enumerate(found.series):
        assert found.unbounded(k) == (False, False)
        assert found.bounds(k) == (entry.signed.min(), entry.signed.max())


@pytest.mark.parametrize(("name", "count"), [("fig3-10", 2), ("p3-22", 3), ("ex3-7", 0)])
def test_stops_and_change_points_are_named(name: str, count: int):
    page = drawn(name)
    words = [text for text, _ in texts(page)]
    marked = [text for text in words if text in ("dead point", "change point")]
    assert len(marked) == count * (2 if name == "p3-22" else 1)
    assert len([text for text in words if text.startswith(("Dead point at", "Change point at"))]) == count


def test_curves_that_lie_on_one_another_are_one():
    page = drawn("ex3-1", of="omega 2, omega 3, v B")
    assert list(lines(page, "curve-")) == ["curve-0", "curve-2"]
    assert page.axes[0].get_legend().get_texts()[0].get_text() == (
        r"$\omega_{\mathrm{2}}=\omega_{\mathrm{3}}$"
    )


def test_an_angle_that_turns_on_has_no_extremes():
    found = sampled("ex3-7", of="theta 1, omega 1")
    assert found.peaks == ((), ())


# --- panels and axes --------------------------------------------------------------------------


def test_panels():
    units = dict(enumerate(["rad", "m", "rad/s", "m/s", "rad/s^2", "1"]))
    shown = [(panel.kind, [axis.unit for axis in panel.axes]) for panel in panels(units)]
    assert shown == [
        ("position", ["rad", "m"]),
        ("velocity", ["rad/s", "m/s"]),
        ("acceleration", ["rad/s^2"]),
        ("ratio", ["1"]),
    ]


@pytest.mark.parametrize(("angular", "linear", "sizes"), [(3, 3, [6]), (4, 3, [4, 3]), (7, 0, [4, 3]), (0, 13, [5, 5, 3])])
def test_too_many_curves_are_shared_out(angular: int, linear: int, sizes: list[int]):
    units = dict(enumerate(["rad/s"] * angular + ["m/s"] * linear))
    found = panels(units)
    assert [sum(len(axis.curves) for axis in panel.axes) for panel in found] == sizes
    assert sorted(k for panel in found for axis in panel.axes for k in axis.curves) == list(units)


@pytest.mark.parametrize(
    ("low", "high", "most", "degrees", "ticks"),
    [
        (0, 360, 13, True, [*range(0, 361, 30)]),
        (0, 720, 13, True, [*range(0, 721, 60)]),
        (60, 100, 13, True, [*range(60, 101, 5)]),
        (-0.3, 0.55, 8, False, [-0.2, 0, 0.2, 0.4]),
        (184.9, 1500, 13, False, [*range(200, 1501, 200)]),
    ],
)
def test_division(low: float, high: float, most: int, degrees: bool, ticks: Sequence[float]):
    assert division(low, high, most, degrees) == pytest.approx(ticks, abs=1e-12)


@pytest.mark.parametrize(
    ("quantity", "tex"),
    [
        (Rotation("theta", "3", "3"), r"$\theta_{\mathrm{3}}$"),
        (Moving("v", "E", Seen("E", "5", explicit=False)), r"$\mathit{v}_{\mathit{E}}$"),
        (Moving("a_k", "B3B2", Seen("B", "3", explicit=True), Seen("B", "2", explicit=True), "k"), r"$\mathit{a}_{\mathit{B}\mathrm{3}\mathit{B}\mathrm{2}}^{\mathit{k}}$"),
        (Rotation("omega", "滑块", "滑块"), "ω 滑块"),
        (Displacement("s", "slide-1", "slide-1"), r"$\mathit{s}_{\mathit{slide}\mathrm{\text{-}1}}$"),
    ],
)
@chinese
def test_labels(quantity: Quantity, tex: str):
    assert fonts.typeset(label_of(quantity)) == tex


def test_axes_of_a_shaper():
    page = drawn("ex3-7")
    labels = [axes.get_ylabel() for axes in page.axes]
    assert [label for label in labels if "theta" in label or "mm" in label] == [r"$\theta$ [°]", r"$\mathit{s}$ [mm]"]
    bottom = page.axes[-2]
    assert [tick.get_text() for tick in bottom.get_xticklabels()] == [str(k) for k in range(0, 361, 30)]
    assert bottom.get_xlim() == pytest.approx((0, 360))


def test_zeros_of_both_axes_are_level():
    velocity = [axes for axes in drawn("ex3-7").axes if "omega" in axes.get_ylabel() or "{v}" in axes.get_ylabel()]
    heights = [axes.transData.transform((0, 0))[1] for axes in velocity]
    assert len(heights) == 2
    assert heights[0] == pytest.approx(heights[1])


# --- texts ------------------------------------------------------------------------------------

CROWDED = (
    "theta 2, theta 3, theta 4, omega 3, omega 4, alpha 3, alpha 4, s ram, v E, a E, v B, v D, a D, a_k B3B2, "
    "a_r B3B2, v E/v B"
)


@pytest.mark.many(7)
@pytest.mark.parametrize("lang", ["en", pytest.param("zh", marks=chinese)])
@pytest.mark.parametrize(
    ("name", "ranges", "of"),
    [*((name, (), "") for name in NAMES), ("ex3-7", (), CROWDED), ("ex3-7", ("60:100:5",), ""), ("p3-21", ("screw=60:120:3",), "")],
)
def test_no_text_on_another_nor_cut_off(name: str, ranges: tuple[str, ...], of: str, lang: Lang):
    page = drawn(name, lang, ranges, of)
    found = texts(page)
    for text, box in found:
        assert page.bbox.x0 <= box.x0 < box.x1 <= page.bbox.x1, text
        assert page.bbox.y0 <= box.y0 < box.y1 <= page.bbox.y1, text
    for (first, one), (second, other) in combinations(found, 2):
        assert not one.padded(-1.0).overlaps(other.padded(-1.0)), (first, second)


def test_no_tick_on_another_at_the_corner():
    """An axis on the right whose least tick is at the very bottom."""
    found = texts(drawn("p3-6c"))
    for (first, one), (second, other) in combinations(found, 2):
        assert not one.padded(-1.0).overlaps(other.padded(-1.0)), (first, second)


@pytest.mark.parametrize("name", ["ex3-7", "p3-20", "p3-23a", "p3-19", "fig3-10"])
def test_values_hide_no_curve(name: str):
    page = drawn(name)
    notes = [box for text, box in texts(page) if text.endswith(("°)", "mm)"))]
    for line in lines(page, "curve-").values():
        path = line.get_transform().transform_path(line.get_path())
        assert notes
        assert not any(path.intersects_bbox(box.padded(-1.0), filled=False) for box in notes)


@chinese
def test_chinese():
    words = [text for text, _ in texts(drawn("p3-22", "zh"))]
    assert words.count("死点") == 4
    assert {"速度线图", "加速度线图", "变点"} <= set(words)
    title = graphkin.load("p3-22").slide_title("lift", "zh")
    assert title != "lift"
    assert f"{title}的位移 /mm" in "".join(words)
    assert any(f"原动件{title}" in word for word in words)


MACHINE = """
title = {{ zh = "曲柄滑块" }}
[frame]
name = "机架"
A = [0, 0]
[links."曲柄"]
"AB'" = 100
[links."{rod}"]
"B'C" = 300
[links.guide_block]
points = ["C"]
[[slide]]
block = "guide_block"
point = "C"
guide = "frame"
through = [0, 30]
angle = 0
[[driver]]
vector = "AB'"
angle = 60
omega = {omega}
[sketch]
C = [345, 30]
"""


def own(omega: float = 10.0, rod: str = "连杆") -> Course:
    method = graphkin.plan(loading.loads(MACHINE.format(omega=omega, rod=rod)))
    return sweeps.course(method)


@chinese
def test_chinese_names_in_an_english_diagram():
    page = diagram.figure(own(), ["theta 连杆", "v C", "v B'"], "en")
    words = [text for text, _ in texts(page)]
    assert "曲柄滑块" in words
    assert "θ 连杆" in words
    assert r"$\mathit{v}_{\mathit{B}\mathrm{′}}$" in words


def test_letters_that_no_font_has():
    """Nothing is drawn as an empty box, and no warning is printed."""
    course = own(rod="rod")
    mechanism = dataclasses.replace(course.method.mechanism, title={"en": "Crank \U0001fa80\x01\nand $slider$"})
    course = dataclasses.replace(course, method=dataclasses.replace(course.method, mechanism=mechanism))
    assert "Crank ?? and $slider$" in [text for text, _ in texts(diagram.figure(course, ["v C"]))]


@pytest.mark.parametrize("omega", [1e6, 1e-6])
def test_large_and_small_numbers(omega: float):
    """Ticks stay short: a power of ten stands at the axis."""
    page = diagram.figure(own(omega, "rod"), ["omega rod", "v C", "a C"], "en")
    ticks = [tick.get_text() for axes in page.axes for tick in axes.get_yticklabels()]
    assert ticks
    assert max(map(len, ticks)) <= 6
    assert all("10^" in axes.get_ylabel() for axes in page.axes if axes.get_ylabel())


def test_without_chinese_font(monkeypatch: pytest.MonkeyPatch, tmp_path: Path):
    """Said, and drawn in English."""
    for module in (diagram, fonts):
        monkeypatch.setattr(module, "chinese_font", lambda: None)
    course, names = moved("fig3-10")
    said = diagram.write(tmp_path / "a.png", course, names, "zh")
    assert isinstance(said, fonts.NoChineseFont)
    assert "Velocity" in [text for text, _ in texts(diagram.figure(course, names, "zh"))]
    assert diagram.write(tmp_path / "a.png", course, names, "en") is None
    assert isinstance(diagram.write(tmp_path / "b.png", own(), ["omega 连杆"], "en"), fonts.NoChineseFont)


# --- files ------------------------------------------------------------------------------------


@pytest.mark.parametrize("suffix", diagram.FORMATS)
@pytest.mark.parametrize("lang", ["en", pytest.param("zh", marks=chinese)])
def test_same_bytes(tmp_path: Path, suffix: str, lang: Lang):
    course, names = moved("fig3-10")
    first, second = tmp_path / f"a{suffix}", tmp_path / f"b{suffix}"
    assert diagram.write(first, course, names, lang) is None
    assert diagram.write(second, course, names, lang) is None
    assert first.read_bytes() == second.read_bytes()
    assert sorted(path.name for path in tmp_path.iterdir()) == [first.name, second.name]


@pytest.mark.parametrize("suffix", diagram.FORMATS)
def test_only_own_files_are_replaced(tmp_path: Path, suffix: str):
    course, names = moved("p3-19")
    path = tmp_path / f"a{suffix}"
    path.write_text("mine")
    with pytest.raises(FileInTheWay):
        diagram.write(path, course, names)
    assert path.read_text() == "mine"
    diagram.write(path, course, names, force=True)
    diagram.write(path, course, names)


def test_what_cannot_be_written(tmp_path: Path):
    course, names = moved("p3-19")
    with pytest.raises(UnknownEnding):
        diagram.write(tmp_path / "a.gif", course, names)
    with pytest.raises(NoFolder):
        diagram.write(tmp_path / "none" / "a.svg", course, names)


def test_settings_stay_as_they_were():
    with matplotlib.rc_context({"font.size": 17.0, "axes.grid": True, "mathtext.fontset": "cm"}):
        before = dict(matplotlib.rcParams)
        diagram.figure(*moved("p3-19"))
        assert dict(matplotlib.rcParams) == before


SOME = {"ex3-1": "omega 3", "ex3-5": "v E", "ex3-7": "theta 4, a E"}


def test_diagrams_made_in_threads_are_those_made_alone():
    """Six at a time, while the user goes on reading and writing settings of their own."""
    swept = [graphkin.sweep(graphkin.load(name), (), asked) for name, asked in SOME.items()]
    alone = [one._repr_svg_() for one in swept]
    with matplotlib.rc_context({"axes.grid": True, "font.size": 20.0, "svg.hashsalt": None}):
        before, read, usual = dict(matplotlib.rcParams), [], type(matplotlib.rcParams)
        with ThreadPoolExecutor(9) as threads:
            drawn = [threads.submit(one._repr_svg_) for one in swept * 2]
            while not all(one.done() for one in drawn):
                matplotlib.rcParams["lines.linewidth"] = float(len(read) % 7)
                read.append((matplotlib.rcParams["font.size"], matplotlib.rcParams["lines.linewidth"] == len(read) % 7))
                time.sleep(1e-4)
        matplotlib.rcParams["lines.linewidth"] = before["lines.linewidth"]
        assert (dict(matplotlib.rcParams), type(matplotlib.rcParams)) == (before, usual)
    assert {*read} == {(20.0, True)}
    assert [one.result() for one in drawn] == alone * 2


def test_a_figure_has_its_own_settings_wherever_it_is_saved():
    """A notebook saves it later, under whatever the user has set by then."""
    import io

    page, there = diagram.figure(*moved("p3-19")), {key: io.BytesIO() for key in "ab"}
    page.savefig(there["a"], format="png")
    with matplotlib.rc_context({"text.hinting": "default", "savefig.facecolor": "red", "path.sketch": (5, 9, 3)}):
        page.savefig(there["b"], format="png")
        assert page._repr_svg_() == diagram.figure(*moved("p3-19"))._repr_svg_()
    assert there["a"].getvalue() == there["b"].getvalue()


def test_the_users_settings_do_not_show(tmp_path: Path):
    course, names = moved("p3-19")
    diagram.write(tmp_path / "a.svg", course, names)
    with matplotlib.rc_context({"font.size": 17.0, "axes.facecolor": "red", "lines.linewidth": 9, "savefig.dpi": 30}):
        diagram.write(tmp_path / "b.svg", course, names)
    assert (tmp_path / "a.svg").read_bytes() == (tmp_path / "b.svg").read_bytes()


def test_both_roads_draw_the_same():
    course, names = moved("p3-23a")
    one, other = (curves(course, names, by) for by in ("construction", "analysis"))
    for first, second in zip(one.peaks, other.peaks, strict=True):
        assert [peak.value for peak in first] == pytest.approx([peak.value for peak in second], rel=1e-9, abs=1e-12)


ROCKER = """
ask = ["omega 3", "v C", "alpha 3", "a C"]
[frame]
A = [0, 0]
D = [100, 0]
[links.1]
AB = 30
[links.2]
BC = 90
[links.3]
DC = 80
[[driver]]
vector = "AB"
angle = 45
omega = 8
[sketch]
C = [60, 70]
"""


def test_no_curve_of_the_other_axis_lies_on_one():
    """The speed of a rocker's end is as its angular velocity, at another scale: at one height it would be unseen."""
    method = graphkin.plan(loading.loads(ROCKER))
    page = diagram.figure(sweeps.course(method, ()), sweeps.asked(method.mechanism, []))
    shown = lines(page, "curve-")
    for one, other in (("curve-0", "curve-1"), ("curve-2", "curve-3")):
        heights = []
        for line in (shown[one], shown[other]):
            low, high = line.axes.get_ylim()
            assert low < 0 < high
            heights.append((np.asarray(line.get_ydata(), dtype=float) - low) / (high - low))
        zero = -shown[one].axes.get_ylim()[0] / np.ptp(shown[one].axes.get_ylim())
        assert zero == pytest.approx(-shown[other].axes.get_ylim()[0] / np.ptp(shown[other].axes.get_ylim()))
        assert np.mean((abs(heights[0] - heights[1]) < 0.01) & (abs(heights[0] - zero) > 0.05)) < 0.05



@pytest.mark.parametrize(("lang", "lines"), [
    ("en", ["One turn of O2A; the mechanism repeats after 3.", ": magnitudes, without sign."]),
    ("zh", ["O2A 转一周的情形；机构每 3 周重复一次。", "为大小，不计正负。"]),
])  # fmt: skip
def test_what_one_does_not_see_in_curves_is_said(lang: Lang, lines: list[str]) -> None:
    method = plan(graphkin.load(TEXTBOOK / "gearfive.toml"))
    words = read(diagram.figure(sweeps.course(method), ["omega 3", "v P", "alpha 3", "a P"], lang))
    assert all(line.replace(" ", "") in words for line in lines)
    assert "O2A" in words
    assert "1.745rad/s" in words


def test_time_that_runs_from_right_to_left_is_said() -> None:
    method = plan(graphkin.load(TEXTBOOK / "draglink.toml"))
    words = read(diagram.figure(sweeps.course(method), ["omega 3"], "en"))
    assert "O2Adecreases:timerunsfromrighttoleft." in words
    assert "ω=−6.283rad/s" in words


@pytest.mark.parametrize("lang", ["en", pytest.param("zh", marks=chinese)])
def test_signs_and_drivers_that_speed_up_are_told_on_the_diagram(lang: Lang) -> None:
    """Which way is positive stands there, not on the console alone; a file in inches is drawn in inches."""
    method = plan(loading.loads(COMPRESSOR))
    page = diagram.figure(sweeps.course(method), ["v C", "omega 2", "a C"], lang)
    words = read(page)
    told = {
        "en": ("ω2: positive counter-clockwise.", "vC, aC: positive horizontally to the right.", "not one motion in time"),
        "zh": ("ω2：逆时针为正。", "vC、aC：水平向右为正。", "并非同一运动过程"),
    }
    assert all(line.replace(" ", "") in words for line in told[lang]), words
    assert [label for axes in page.axes if "in/s" in (label := axes.get_ylabel())]
    heads = [text for text, _ in texts(page) if "mathit{A}" in text or r"\omega" in text or r"\alpha" in text]
    assert len(heads) >= 4  # the driver and its rates in italics, in the title and under the x axis


@pytest.mark.parametrize("lang", ["en", pytest.param("zh", marks=chinese)])
def test_quantities_under_a_diagram_are_written_as_above_it(lang: Lang):
    """Formulas in the line that says which curves are magnitudes, as in the legends; no `v_C`."""
    page = drawn("ex3-1", lang, (), "v C, omega 3, a_k B3B2, alpha 3")
    shown = [text for text, _ in texts(page)]
    assert any(r"$\mathit{v}_{\mathit{C}}$" in text for text in shown)
    assert not [text for text in shown if "v_C" in text or "aᵏ_" in text]
    feet = [text for text in shown if ("magnitudes" if lang == "en" else "不计正负") in text]
    assert len(feet) == 1
