"""Arrows that are drawn broken: far longer than the others of their plane, with nothing at their heads."""

from __future__ import annotations

import re
from functools import cache
from statistics import median

import pytest

from graphkin import Drawing
from graphkin.files import library, loads
from graphkin.sheet import Sheet
from graphkin.sheet.marks import Text, VectorMark

SHEETS: dict[str, tuple[tuple[str, str], ...]] = {
    "as it is": (),
    "a longer wiper": (("DW = 60", "DW = 66"),),
    "a corner of an image": (
        ("DW = 60", 'DW = 60\nWV = 8\nDV = 58\nccw = ["D", "V", "W"]'), ("W = [54, 60]", "W = [54, 60]\nV = [60, 57]"),
    ),
    "a dyad at the wiper": (
        ("A = [0, 0]", "A = [0, 0]\nF = [75, 110]"), ("W = [54, 60]", "W = [54, 60]\nE = [58, 60]"),
        ("[[roll]]", "[links.5]\nWE = 4\n\n[links.6]\nFE = 53\n\n[[roll]]"),
    ),
    "a scale of the file": (("[sketch]", "[scales]\nacceleration = 0.002\n\n[sketch]"),),
}  # fmt: skip


def drawing(case: str) -> Drawing:
    text = library.text("p3-19")
    for old, new in SHEETS[case]:
        assert text.count(old) == 1
        text = text.replace(old, new)
    return Drawing.of(loads(text, name="wiper", file="wiper.toml"))


@cache
def drawn(case: str) -> Sheet:
    return drawing(case).sheet(paper="A3")  # choosing it takes longer than all the rest


def arrows(sheet: Sheet) -> list[VectorMark]:
    return [mark for mark in sheet.marks if isinstance(mark, VectorMark) and mark.plane != "detail"]


@pytest.mark.parametrize(("case", "broken"), [
    ("as it is", ["a_W"]), ("a longer wiper", ["v_W", "a_W"]), ("a corner of an image", []), ("a dyad at the wiper", []),
    ("a scale of the file", []),
])  # fmt: skip
def test_only_an_arrow_whose_head_nothing_hangs_on_is_broken(case: str, broken: list[str]) -> None:
    every = arrows(drawn(case))
    accelerations = sorted(whole for m in every if m.plane == "acceleration" and (whole := m.length + m.broken) > 0.1)
    assert accelerations[-1] > 5 * median(accelerations)
    assert [mark.name for mark in every if mark.broken] == broken
    said = ["".join(run.text for run in mark.label) for mark in drawn(case).marks if isinstance(mark, Text)]
    sizes = [(mark.length + mark.broken) * drawn(case).scales[mark.plane] for mark in every if mark.broken]
    values = [float(text.split()[1]) for text in said if re.fullmatch(r" = \S+ m/s²?", text)]
    assert values == pytest.approx(sizes, rel=1e-3)  # each at its name


def test_the_others_choose_the_scale_and_the_broken_one_stays_the_longest() -> None:
    sheet = drawn("as it is")
    (long,) = [mark for mark in arrows(sheet) if mark.broken]
    assert long.length == max(mark.length for mark in arrows(sheet) if mark.plane == "acceleration")
    assert (long.length + long.broken) * sheet.scales["acceleration"] == pytest.approx(0.1323, abs=5e-5)
    alone = drawing("as it is").sheet(only="acceleration", paper="A4")
    *_, last = drawing("as it is").step_sheets(only="acceleration", paper="A4")  # which show arrows whole
    assert long.name in [mark.name for mark in arrows(last)]
    assert not any(mark.broken for mark in arrows(last))
    assert last.scales["acceleration"] > 2 * alone.scales["acceleration"]
