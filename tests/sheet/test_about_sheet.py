"""Sheets of a link about its pole: nothing leaves the frame, marks lie where they should, labels are there."""

from __future__ import annotations

import cmath

import pytest

from graphkin.files import library
from graphkin.outputs.svg import svg
from graphkin.planning import plan
from graphkin.running import replay_all
from graphkin.sheet import Sheet, UnknownPaper
from graphkin.sheet.about_sheet import about_sheet, bobillier_sheet
from graphkin.sheet.marks import ArcMark, Disc, Stroke, Text
from graphkin.sheet.page import step_sheets
from graphkin.studies.centres import centres
from graphkin.studies.centres.about import About, Circle, about
from graphkin.studies.centres.about_bobillier import bobillier


def seen(name: str, link: str) -> About:
    method = plan(library.load(name))
    return about(centres(method, replay_all(method)), link)


def lettered(sheet: Sheet) -> list[str]:
    return ["".join(run.text for run in mark.label) for mark in sheet.marks if isinstance(mark, Text)]


EVERY = [(name, link) for name in library.names() for link in library.load(name).moving]


@pytest.mark.many
@pytest.mark.parametrize(("name", "link"), EVERY[::3])
def test_nothing_leaves_the_frame(name: str, link: str):
    sheet = about_sheet(seen(name, link), lang="zh")
    edge = sheet.paper.margin - 1e-6
    for mark in sheet.marks:
        places = mark.places if isinstance(mark, Stroke) else (mark.centre,) if isinstance(mark, Disc) else ()
        for place in places:
            assert edge <= place.real <= sheet.paper.width - edge
            assert edge <= place.imag <= sheet.paper.height - edge
    assert svg(sheet)  # the writer refuses what is no number


@pytest.mark.parametrize(("lang", "words"), [("zh", ("拐点圆", "尖点圆")), ("en", ("inflection circle", "cuspidal circle"))])
def test_labels(lang: str, words: tuple[str, str]):
    texts = lettered(about_sheet(seen("ex3-7", "4"), lang=lang))  # type: ignore[arg-type]
    for word in (*words, "P46", "J", "W", "t", "n", "vD", "vE", "KD"):
        assert any(word in text.split(", ") for text in texts)
    assert "KE" not in texts  # the ram's path is straight


def test_circles_on_paper():
    """The inflection circle, measured: its places stand at its radius from its centre."""
    entry = seen("ex3-7", "4")
    sheet = about_sheet(entry)
    origin, scale = sheet.origins["position"], sheet.scales["position"]
    for drawn, pen in ((entry.inflection, "thin"), (entry.returning, "dashed")):
        assert isinstance(drawn, Circle)
        centre, radius = origin + drawn.centre.conjugate() / scale, drawn.radius / scale
        strokes = [mark for mark in sheet.marks if isinstance(mark, Stroke) and mark.pen == pen and len(mark.places) > 40]
        assert strokes
        for place in strokes[0].places[1:-1]:
            assert abs(place - centre) == pytest.approx(radius, abs=0.02)


def test_velocity_arrows_are_to_scale():
    """Each arrow stands at its point, across the ray to the pole, as long as omega times the ray."""
    entry = seen("fig3-4", "3")
    sheet = about_sheet(entry)
    origin, scale = sheet.origins["position"], sheet.scales["position"]
    pace = float(next(text for text in lettered(sheet) if text.startswith("μv")).split("=")[1].split()[0])
    for carried in entry.points.values():
        start = origin + carried.place.conjugate() / scale
        arrow = next(m for m in sheet.marks if isinstance(m, Stroke) and m.pen == "vector" and abs(m.places[0] - start) < 1e-6)
        wanted = start + (1j * entry.omega * (carried.place - entry.pole)).conjugate() / pace
        tips = [mark.places[0] for mark in sheet.marks if isinstance(mark, Stroke) and mark.fill == "ink"]
        assert abs(((arrow.places[1] - start) / (wanted - start)).imag) < 1e-9
        assert min(abs(tip - wanted) for tip in tips) < 1e-6


def test_a_pole_at_infinity_is_an_arrow():
    texts = lettered(about_sheet(seen("s4-ex1", "2"), lang="zh"))
    assert any("→ ∞" in text for text in texts)
    assert "拐点圆（退化为直线）" in texts


def test_paper():
    assert about_sheet(seen("fig3-4", "3"), paper="A4").paper.name == "A4"
    with pytest.raises(UnknownPaper):
        about_sheet(seen("fig3-4", "3"), paper="A9")


def test_same_bytes():
    one, other = (svg(about_sheet(seen("p3-16", "3"))) for _ in range(2))
    assert one == other
    assert cmath.isfinite(seen("p3-16", "3").pole)


@pytest.mark.parametrize(("name", "link", "point"), [("fig3-4", "3", "E"), ("p3-23a", "2", 0.2 + 0.1j), ("s4-ex3", "1", "M")])
def test_bobillier_on_paper(name: str, link: str, point: str | complex):
    """The centre's mark lies where the exact one is; each step adds its own marks."""
    entry = seen(name, link)
    drawn = bobillier(entry, point)
    sheet = bobillier_sheet(drawn, lang="zh")
    place = complex(entry.plot.position[point]) if isinstance(point, str) else point
    centre = sheet.origins["position"] + entry.carried(place).centre.conjugate() / sheet.scales["position"]
    (mark,) = (mark for mark in sheet.marks if isinstance(mark, Disc) and mark.step == len(drawn.construction.stages))
    assert abs(mark.centre - centre) < 1e-6
    steps = list(step_sheets(bobillier_sheet(drawn), range(1, len(drawn.construction.stages) + 1)))
    counts = [len(one.marks) for one in steps]
    assert counts == sorted(counts)
    assert counts[-1] == len(bobillier_sheet(drawn).marks)
    assert all(mark.new == (mark.step == 4) for mark in steps[3].marks)


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_equal_angles_are_two_arcs_and_the_radius_is_told(lang: str):
    drawn = bobillier(seen("fig3-4", "3"), "E")
    sheet = bobillier_sheet(drawn, lang=lang)  # type: ignore[arg-type]
    arcs = [mark for mark in sheet.marks if isinstance(mark, ArcMark) and mark.step == 5]
    assert len(arcs) == 2
    assert arcs[0].radius > arcs[1].radius + 1
    assert arcs[0].sweep == pytest.approx(arcs[1].sweep)
    ticks = [mark for mark in sheet.marks if isinstance(mark, Stroke) and mark.step == 5 and mark.pen == "thin"]
    assert len(ticks) == 2
    radius = abs(drawn.board.at(drawn.answer) - drawn.board.at("E")) * 1e3
    assert any(f"ρ = {radius:.4g}"[:8] in text for text in lettered(sheet))
