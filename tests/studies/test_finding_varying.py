"""A condition over values of a dimension; positions side by side on a sheet."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest
import shapely

from graphkin import api
from graphkin import files as loading
from graphkin.errors import GraphkinError
from graphkin.files import library
from graphkin.outputs import svg
from graphkin.say.finding import finding_table
from graphkin.sheet.finding_sheet import drawn as drawn_positions
from graphkin.sheet.lettering import box
from graphkin.sheet.marks import Text
from graphkin.sheet.obstacles import bounds
from graphkin.studies import finding
from graphkin.studies.finding.varying import dimension, replaced


def test_strokes_over_the_screw_of_the_engine() -> None:
    table = finding.vary(api.load("p3-21"), "screw=55:125:35", "stroke s piston")
    assert [row.value for row in table.rows] == pytest.approx([0.055, 0.090, 0.125])
    swings = [row.found.swing for row in table.rows if row.found is not None]
    assert swings == pytest.approx([0.084087, 0.077660, 0.043324], abs=1.5e-6)


def test_a_length_is_varied_as_if_the_file_were_rewritten() -> None:
    mechanism = api.load("p3-13")
    table = finding.vary(mechanism, "AB=50:70:5", "range theta 4")
    for row in table.rows:
        rewritten = loading.loads(mechanism.text.replace("AB = 60", f"AB = {row.value * 1000!r}"))
        alone = finding.find(api.plan(rewritten), "range theta 4")
        assert row.found is not None
        assert row.found.swing == pytest.approx(alone.swing, rel=1e-12)
        assert [p.drivers for p in row.found.positions] == [pytest.approx(p.drivers) for p in alone.positions]


def test_the_assembly_is_kept_far_from_the_sketch() -> None:
    """The sketch of p3-13 is nearer to the crossed assembly once CD is long; the open one goes on."""
    table = finding.vary(api.load("p3-13"), "DC=90:190:10", "theta 3 = 40")
    turned = []
    for row in table.rows:
        assert row.found is not None
        method = api.plan(row.found.mechanism)
        plot = api.replay(method)
        b, c, d = (plot.position[p] for p in "BCD")
        turned.append(float(np.sign(((c - b).conjugate() * (d - b)).imag)))
    assert len(set(turned)) == 1


def test_what_cannot_be_assembled_has_a_row_that_says_so() -> None:
    table = finding.vary(api.load("p3-13"), "BC=20:120:20", "range theta 4")
    failed = [row for row in table.rows if row.error is not None]
    assert 0 < len(failed) < len(table.rows)
    for lang in ("en", "zh"):
        lines = list(finding_table(table, lang))
        assert len(lines) == len(table.rows) + 2
        for row, line in zip(table.rows, lines[2:], strict=True):
            assert (row.error is None) or row.error.message(lang) in line
    data = finding.table_json(table)
    assert json.loads(json.dumps(data, allow_nan=False)) == data


@pytest.mark.parametrize("condition", [
    "stroke theta 4", "range theta 4", "max v C", "v C = 0", "v C > 0.5", "slowest BC", "v C = 1 by AB",
])  # fmt: skip
def test_every_condition_fills_its_columns(condition: str) -> None:
    table = finding.vary(api.load("p3-13"), "AB=50:60:10", condition)
    for lang in ("en", "zh"):
        head, *rows = list(finding_table(table, lang))[1:]
        assert "AB [mm]" in head
        assert [row.split()[0] for row in rows] == ["50", "60"]


TEXT = """
[frame]
name = "4"
A = [0, 0]
D = [0.12, 0]   # not a length AB = 60
[links]
1 = { AB = "6 cm" } # AB = 60
"2" = { BC = 120, "CE'" = 40, "BE'" = 100, ccw = ["B", "C", "E'"] }
3 = { DC = 90 }
[[driver]]
vector = "AB"
angle = 165
omega = 10
[sketch]
C = [45, 60]
"""


def test_only_the_one_number_of_a_file_changes() -> None:
    mechanism = loading.loads(TEXT.replace("0.12", "120"))
    for name, value, was in (("AB", 0.05, '"6 cm"'), ("BE'", 0.09, "100"), ("links.2.CB", 0.1, None), ("CB", 0.1, "120, "),
                             ("links.3.DC", 0.08, "90"), ("E\u2019C", 0.05, "40")):
        if was is None:
            with pytest.raises(GraphkinError):
                dimension(mechanism, name)
            continue
        text = replaced(mechanism, dimension(mechanism, name), value)
        assert len(text.splitlines()) == len(TEXT.splitlines())
        changed = [k for k, (one, other) in enumerate(zip(mechanism.text.splitlines(), text.splitlines())) if one != other]
        assert len(changed) == 1
        links = loading.loads(text).links
        tail, head = loading_points(name)
        lengths = [abs(link.points[tail] - link.points[head]) for link in links.values() if {tail, head} <= set(link.points)]
        assert lengths == [pytest.approx(value)]


def loading_points(name: str) -> tuple[str, ...]:
    from graphkin.files.values import split_points, tidy

    return split_points(tidy(name.split(".")[-1]))


@pytest.mark.parametrize("name", library.names())
def test_every_measure_of_the_library_can_be_varied(name: str) -> None:
    mechanism = library.load(name)
    for path in mechanism.lines:
        if path[0] != "links" or len(path) != 3 or path[2] in ("points", "ccw", "shape"):
            continue
        place = dimension(mechanism, ".".join(map(str, path)))
        text = replaced(mechanism, place, 0.0301)
        assert sum(a != b for a, b in zip(mechanism.text.splitlines(), text.splitlines(), strict=True)) == 1


@pytest.mark.parametrize(("text", "condition", "error"), [
    ("AB", "v C = 0", "BadRange"),
    ("AB=1:2", "v C = 0", "BadRange"),
    ("AB=60:20:-1", "v C = 0", "BadRange"),
    ("AB=1:1e9:1", "v C = 0", "BadRange"),
    ("AB=1 s:2:1", "v C = 0", "UnknownUnit"),
    ("AB=20 deg:60 deg:1 deg", "v C = 0", "OtherDimension"),
    ("XY=1:2:1", "v C = 0", "NoDimension"),
    ("D=1:2:1", "v C = 0", "NoDimension"),
    ("AB=50:60:5", "v Q = 0", "UnknownPoint"),
    ("AB=50:60:5", "nonsense", "BadCondition"),
])  # fmt: skip
def test_wrong_dimensions_get_one_message(text: str, condition: str, error: str) -> None:
    with pytest.raises(GraphkinError) as caught:
        finding.vary(api.load("p3-13"), text, condition)
    assert type(caught.value).__name__ == error
    assert caught.value.message("en") != caught.value.message("zh")


# --- the sheet --------------------------------------------------------------------------------

SHEETS = [
    ("p3-4a", "a_k B3B2 = 0", 4), ("p3-13", "v C = 0", 2), ("p3-19", "range theta 3", 2), ("p3-21", "stroke s piston", 2),
    ("p3-15", "omega 3 = 0", 4), ("p3-13", "slowest BC", 1), ("p3-13", "v C = 1.2", 1), ("p3-22", "v S = 0.2", 2),
]  # fmt: skip


@pytest.mark.many
@pytest.mark.parametrize(("name", "condition", "count"), SHEETS)
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_positions_stand_side_by_side(name: str, condition: str, count: int, lang) -> None:
    method = api.plan(api.load(name))
    found = finding.find(method, condition)
    sheet, left_out = drawn_positions(found, lang)
    assert sheet is not None
    assert (len(found.shown) or 1, left_out) == (count, 0)
    texts = [mark for mark in sheet.marks if isinstance(mark, Text)]
    said = ["".join(run.text for run in mark.label) for mark in texts]
    assert [text[:3] for text in said if text.startswith("(")] == [f"({letter})" for letter in "abcdefgh"[:count]]
    left, top, right, bottom = bounds(sheet.marks)
    assert left >= sheet.paper.margin - 1e-9
    assert top >= sheet.paper.margin - 1e-9
    assert right <= sheet.paper.width - sheet.paper.margin + 1e-9
    assert bottom <= sheet.paper.height - sheet.paper.margin + 1e-9
    assert overlaps(texts) == []
    assert svg.svg(sheet) == svg.svg(drawn_positions(found, lang)[0])


def overlaps(texts: list[Text]) -> list[tuple[str, str]]:
    """Pairs of texts whose boxes share an area."""
    boxes = []
    for mark in texts:
        wide, up, down = box(mark.label, mark.size)
        boxes.append(shapely.box(mark.at.real, mark.at.imag - up, mark.at.real + wide, mark.at.imag + down))
    return [
        (str(texts[a].label), str(texts[b].label))
        for a in range(len(boxes)) for b in range(a)
        if boxes[a].intersection(boxes[b]).area > 0.05
    ]  # fmt: skip


def test_true_scale_and_fixed_points_alike() -> None:
    """At the scale in the title, the crank pins of all figures stand their drawn distances from the pivots."""
    from graphkin.sheet.finding_sheet import positions_sheet
    from graphkin.sheet.marks import Disc

    method = api.plan(api.load("p3-13"))
    plots = [api.replay(method, [angle]) for angle in (20, 100, 200)]
    sheet = positions_sheet(method, plots, ["one", "two", "three"])
    scale = sheet.scales["position"]
    centres = [mark.centre for mark in sheet.marks if isinstance(mark, Disc)]
    for plot in plots:
        arms = [complex(plot.position[p] - plot.position["A"]).conjugate() / scale for p in "BCD"]
        fits = [all(min(abs(c - (a + arm)) for c in centres) < 1e-6 for arm in arms) for a in centres]
        assert any(fits)


def test_more_than_a_sheet_holds_are_said_to_be_left_out() -> None:
    method = api.plan(api.load("p3-13"))
    found = finding.find(method, "slowest BC", ("AB=0:340:20",))
    drawn = drawn_positions(found)
    assert drawn[0] is not None
    assert drawn[1] == len(found.slow) - 12 == 6


def test_nothing_to_draw_is_no_sheet() -> None:
    method = api.plan(api.load("ex3-1"))
    found = finding.find(method, "omega 2 = omega 3")
    assert drawn_positions(replace(found, positions=()))[0] is None
