"""The sheet of instant centres: drawn, measured against velocities of the other road, step by step."""

from __future__ import annotations

import cmath
import re
import xml.etree.ElementTree as ET
from functools import cache
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import random_mechanisms

from graphkin import files as loading
from graphkin import motion
from graphkin.check import RulerReport, measure
from graphkin.check.ruler import pole_of, ways_to_move
from graphkin.files import library
from graphkin.model.mechanism import Mechanism
from graphkin.outputs.svg import svg
from graphkin.planning import plan
from graphkin.running import replay_all
from graphkin.sheet import PAPERS, Sheet
from graphkin.sheet.centre_figure import spots
from graphkin.sheet.centre_sheet import centre_sheet
from graphkin.sheet.marks import PointMark, Stroke, Text, VectorMark
from graphkin.sheet.obstacles import obstacles
from graphkin.sheet.page import step_sheets
from graphkin.studies.centres import Centres, centres

SVG = "{http://www.w3.org/2000/svg}"
EACH_KIND = ("fig3-4", "p3-11a", "p3-11b", "fig3-5", "p3-8", "p3-15", "ex3-3", "p3-14", "s4-ex3")
"""Hinges, slides, two slides, cams, a centre far off the sheet, gears, several freedoms, pins in slots."""

ODD = """
[frame]
name = "base"
A = [0, 0]
D = [90, 10]

[links."1'"]
AB = 30

[links.guide]
"BC'" = 80

[links.10]
"DC'" = 55

[[driver]]
vector = "AB"
angle = 70

[sketch]
B = [10, 28]
"C'" = [85, 60]
"""
"""Words, primes and two digits for links; the driver stands still."""


def found_in(mechanism: Mechanism) -> Centres:
    method = plan(mechanism)
    return centres(method, replay_all(method))


@cache
def found(name: str) -> Centres:
    return found_in(library.load(name))


@cache
def sheet(name: str) -> Sheet:
    return centre_sheet(found(name))


def measured(folder: Path, text: str) -> RulerReport:
    path = folder / "centres.svg"
    path.write_text(text, encoding="utf-8")
    return measure(path)


def shown(drawn: Sheet) -> list[str]:
    """The centres that have a mark or an arrow."""
    marks = [mark for mark in drawn.marks if isinstance(mark, PointMark | VectorMark) and mark.plane == "centres"]
    return sorted(mark.name for mark in marks)


# --- beside the other road ----------------------------------------------------------------------


@pytest.mark.many(5)
@pytest.mark.parametrize("name", library.names())
def test_every_centre_is_drawn_and_where_velocities_have_it(name: str, tmp_path: Path):
    drawn = sheet(name)
    assert shown(drawn) == sorted(found(name).centring.links)
    report = measured(tmp_path, svg(drawn))
    assert sorted(entry.name for entry in report.measured if entry.plane == "centres") == shown(drawn)
    assert report.faults == ()
    assert max(entry.off_mm for entry in report.measured) < 1e-3


@pytest.mark.many(5)
@pytest.mark.parametrize("name", EACH_KIND)
@pytest.mark.parametrize("shift", [0.02, 0.02j, -0.015 + 0.015j])
def test_a_moved_mark_is_caught(name: str, shift: complex, tmp_path: Path):
    text = svg(sheet(name))
    root = ET.fromstring(text)
    ET.register_namespace("", SVG.strip("{}"))
    for circle in root.iter(f"{SVG}circle"):
        if circle.get("data-plane") != "centres":
            continue
        place = circle.get("cx"), circle.get("cy")
        circle.set("cx", f"{float(place[0]) + shift.real:.4f}")
        circle.set("cy", f"{float(place[1]) + shift.imag:.4f}")
        report = measured(tmp_path, ET.tostring(root, encoding="unicode"))
        assert not report.passed(0.01)
        wrong = [entry.name for entry in report.measured if entry.off_mm > 0.01]
        assert wrong == [circle.get("data-name")]
        circle.set("cx", place[0])
        circle.set("cy", place[1])
    assert measured(tmp_path, ET.tostring(root, encoding="unicode")).passed(0.01)


@pytest.mark.parametrize("name", ["p3-11a", "p3-11b", "fig3-5", "p3-14", "p3-15", "p3-3c", "p3-21"])
def test_an_arrow_to_infinity_points_as_the_table_says(name: str):
    """At an angle from 0 to 180 degrees."""
    told = {spot.name: spot.direction for spot in spots(found(name)) if spot.place is None}
    arrows = [mark for mark in sheet(name).marks if isinstance(mark, VectorMark) and mark.head == "∞"]
    assert {arrow.name for arrow in arrows} == {*told}
    for arrow in arrows:
        along = (arrow.end - arrow.start).conjugate() / abs(arrow.end - arrow.start)
        assert abs(along - told[arrow.name]) < 1e-6
        assert 0 <= round(cmath.phase(told[arrow.name]), 9) < round(cmath.pi, 9)


@pytest.mark.many(2)
@pytest.mark.parametrize("name", ["p3-11a", "p3-11b", "fig3-5", "p3-14", "p3-15", "p3-3c", "p3-21"])
def test_a_turned_arrow_is_caught(name: str, tmp_path: Path):
    root = ET.fromstring(svg(sheet(name)))
    ET.register_namespace("", SVG.strip("{}"))
    arrows = [line for line in root.iter(f"{SVG}line") if line.get("data-plane") == "centres"]
    assert arrows
    for line in arrows:
        start, end = (complex(float(line.get(f"x{k}")), float(line.get(f"y{k}"))) for k in (1, 2))
        moved = end + 0.02j * (end - start) / abs(end - start)
        line.set("x2", f"{moved.real:.4f}")
        line.set("y2", f"{moved.imag:.4f}")
        report = measured(tmp_path, ET.tostring(root, encoding="unicode"))
        assert [entry.name for entry in report.measured if entry.off_mm > 0.01] == [line.get("data-name")]
        line.set("x2", f"{end.real:.4f}")
        line.set("y2", f"{end.imag:.4f}")


def test_a_mark_left_out_or_renamed_is_caught(tmp_path: Path):
    text = svg(sheet("fig3-4"))
    without = re.sub(r'<circle[^>]*data-name="P13"[^>]*/>', "", text)
    assert without != text
    assert [fault.kind for fault in measured(tmp_path, without).faults] == ["missing"]
    swapped = text.replace('data-name="P13"', 'data-name="P00"').replace('data-name="P24"', 'data-name="P13"')
    swapped = swapped.replace('data-name="P00"', 'data-name="P24"')
    assert not measured(tmp_path, swapped).passed(0.01)


# --- the sheet --------------------------------------------------------------------------------


@pytest.mark.many
@pytest.mark.parametrize("name", library.names())
def test_no_name_of_a_centre_lies_on_anything(name: str):
    """Every label in the figure is clear of all that is drawn there, and of the other labels."""
    drawn = sheet(name)
    rules = [m.places for m in drawn.marks if isinstance(m, Stroke) and m.pen == "outline" and len(m.places) == 2]
    table = min(low.imag for low, high in rules if abs(high - low) > 150)
    texts = [mark for mark in drawn.marks if isinstance(mark, Text) and mark.at.imag < table]
    names = [mark for mark in texts if _names_a_centre(mark)]
    figure = [m for m in drawn.marks if not isinstance(m, Text) and not (isinstance(m, Stroke) and m.pen == "leader")]
    known = obstacles(figure)
    boxes = [_box(mark) for mark in names]
    low = np.array([(left, top) for left, top, _, _ in boxes])
    high = np.array([(right, bottom) for _, _, right, bottom in boxes])
    hit = {names[row].label for row in np.flatnonzero(known.touched(low.T + 0.1, high.T - 0.1))}
    assert not hit
    for k, one in enumerate(boxes):
        for other in boxes[:k]:
            apart = one[2] <= other[0] + 0.05 or other[2] <= one[0] + 0.05 or one[3] <= other[1] or other[3] <= one[1]
            assert apart


def _names_a_centre(mark: Text) -> bool:
    text = "".join(run.text for run in mark.label)
    return 3.4 < mark.size < 4 and re.match(r"(, )?P[\w,′]+", text) is not None and mark.step is not None


def _box(mark: Text) -> tuple[float, float, float, float]:
    from graphkin.sheet.lettering import box

    wide, up, down = box(mark.label, mark.size)
    return mark.at.real, mark.at.imag - up, mark.at.real + wide, mark.at.imag + down


@pytest.mark.many
@pytest.mark.parametrize("name", library.names())
def test_arrows_stay_in_their_figure(name: str):
    """None crosses the drawing frame, the strip, or the line to the circle diagram."""
    drawn = sheet(name)
    ruled = [mark for mark in drawn.marks if isinstance(mark, Stroke) and mark.step is None and not mark.shows]
    ruled = [mark for mark in ruled if abs(mark.places[1] - mark.places[0]) > 100 and mark.pen in ("outline", "thin")]
    assert ruled
    arrows = [mark for mark in drawn.marks if isinstance(mark, VectorMark)]
    assert not obstacles(arrows).touched(*(ends.T for ends in _spans(ruled))).any()


def _spans(strokes: list[Stroke]) -> tuple[np.ndarray, np.ndarray]:
    """Lower and upper corners of the sides of rectangles."""
    sides = [pair for s in strokes for pair in pairwise((*s.places, *(s.places[:1] if s.closed else ())))]
    low = [(min(a.real, b.real), min(a.imag, b.imag)) for a, b in sides]
    high = [(max(a.real, b.real), max(a.imag, b.imag)) for a, b in sides]
    return np.array(low), np.array(high)


@pytest.mark.parametrize("name", ["fig3-4", "p3-15", "ex3-3"])
def test_same_bytes(name: str):
    assert svg(sheet(name)) == svg(centre_sheet(found_in(library.load(name))))


@pytest.mark.parametrize("name", ["p3-15", "p3-21", "ex3-2"])
def test_fit_has_every_finite_centre_near_enough_on_the_sheet(name: str, tmp_path: Path):
    fitted = centre_sheet(found(name), fit=True)
    assert fitted.scales["position"] >= sheet(name).scales["position"]
    off = [mark.name for mark in fitted.marks if isinstance(mark, VectorMark) and mark.head != "∞"]
    assert off == []
    assert measured(tmp_path, svg(fitted)).passed(0.01)


@pytest.mark.parametrize("paper", PAPERS)
def test_every_paper(paper: str, tmp_path: Path):
    drawn = centre_sheet(found("ex3-7"), paper=paper)
    assert drawn.paper.name == paper
    assert shown(drawn) == sorted(found("ex3-7").centring.links)
    assert measured(tmp_path, svg(drawn)).passed(0.01)


@pytest.mark.parametrize("name", ["fig3-4", "p3-11b", "fig3-5", "ex3-7", "ex3-3"])
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_steps_come_one_by_one(name: str, lang):
    names = [stage.last.name for stage in found(name).centring.stages]
    sheets = list(step_sheets(centre_sheet(found(name), lang=lang)))
    assert len(sheets) == len(names)
    for number, (drawn, name_) in enumerate(zip(sheets, names, strict=True), start=1):
        assert shown(drawn) == sorted(names[:number])
        fresh = [m.name for m in drawn.marks if isinstance(m, PointMark | VectorMark) and m.new and m.plane != "detail"]
        assert fresh == [name_]
        assert all(mark.new == (mark.step == number) for mark in drawn.marks)
    last, whole = sheets[-1], centre_sheet(found(name), lang=lang)
    assert len(last.marks) == len(whole.marks)


@pytest.mark.parametrize("degrees", [20.0, 140.0, 301.0])
@pytest.mark.parametrize("name", ["fig3-4", "p3-11a", "ex3-7"])
def test_at_another_position(name: str, degrees: float, tmp_path: Path):
    method = plan(library.load(name))
    drawn = centre_sheet(centres(method, replay_all(method, [np.radians(degrees)])))
    assert measured(tmp_path, svg(drawn)).passed(0.01)


def test_names_of_more_than_a_letter(tmp_path: Path):
    drawn = centre_sheet(found_in(loading.loads(ODD, name="odd")))
    assert "P1',guide" in shown(drawn)
    assert len(shown(drawn)) == 6
    assert measured(tmp_path, svg(drawn)).passed(0.01)


# --- mechanisms nobody has seen -----------------------------------------------------------------

FAMILIES = {
    "RRR": lambda seed: random_mechanisms.dyad("RRR", seed), "RRP": lambda seed: random_mechanisms.dyad("RRP", seed),
    "RPR": lambda seed: random_mechanisms.dyad("RPR", seed), "PRP": lambda seed: random_mechanisms.dyad("PRP", seed),
    "RPP": lambda seed: random_mechanisms.dyad("RPP", seed), "cylinder": random_mechanisms.cylinder,
    "relative angle": random_mechanisms.relative_angle, "chain": random_mechanisms.chain,
    "triad": random_mechanisms.triad, "six-bar": random_mechanisms.six_bar, "gears": random_mechanisms.epicyclic,
    "rolling": random_mechanisms.rolling, "cam": random_mechanisms.cam,
}  # fmt: skip


@pytest.mark.parametrize("seed", range(1))
@pytest.mark.parametrize("family", FAMILIES)
def test_any_mechanism(family: str, seed: int):
    """Each centre has one mark or arrow, and lies where the velocities of the other road have it."""
    machine = FAMILIES[family](seed)
    seen = found_in(machine)
    drawn = centre_sheet(seen)
    assert shown(drawn) == sorted(seen.centring.links)
    ways = ways_to_move(machine, motion(machine))
    size = max(abs(complex(place)) for place in seen.plot.position.values())
    for links in seen.centring.links.values():
        pole, finite = pole_of(machine, ways, *links)
        place = complex(seen.place(*links))
        if finite:
            assert abs(pole - place) < 1e-6 * (size + abs(pole))
        elif pole:
            assert not np.isfinite(place)
            assert abs((pole / abs(pole) * np.exp(-1j * seen.direction(*links))).imag) < 1e-6


BALER = """
frame = { name = "6", A = [0, 0], D = [160, -60] }
[links]
1.AB = 45
2.BC = 150
3 = { DC = 110, CE = 150, DE = 90, ccw = ["C", "D", "E"] }
5.EF = 210
4.points = ["F"]
[[slide]]
block = "4"
point = "F"
guide = "frame"
through = [380, 0]
angle = 90
[[driver]]
vector = "AB"
angle = 130
omega = -8
[sketch]
C = [100, 60]
E = [225, -120]
F = [380, 30]
"""


def test_centres_close_together_are_drawn_once_more():
    """P14, P15 and the pivot lie within 3 mm: their names stood beyond a bar."""
    page = centre_sheet(found_in(loading.loads(BALER, name="baler")))
    again = {mark.name for mark in page.marks if isinstance(mark, PointMark) and mark.plane == "detail"}
    assert {"P14", "P15", "P16"} <= again
