"""A part of a figure that is too small for its letters is drawn once more, magnified."""

from __future__ import annotations

import cmath
from collections import Counter
from collections.abc import Callable

import pytest

from graphkin.sheet.detail import detailed
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import plain
from graphkin.sheet.marks import Disc, VectorMark
from graphkin.sheet.page import Panel
from graphkin.sheet.paper import Room
from graphkin.sheet.window import Figure, Window

ROOM = Room(0.0, 0.0, 200.0, 160.0)
WINDOW = Window(60 + 120j, 1.0)


def fan(count: int, size: float) -> Callable[[Window], Figure]:
    """Arrows of this size [mm] from the origin, and one that is far longer."""
    tips = {f"v_{k}": cmath.rect(size, 6.2 * k / count) for k in range(count)} | {"v_long": 100 + 60j}

    def draw(window: Window) -> Figure:
        start = window(0)
        arrows = [VectorMark("velocity", name, "p", name, start, window(tip)) for name, tip in tips.items()]
        names = [LabelRequest(plain(arrow.name), arrow.start, arrow.end, of=arrow.name) for arrow in arrows]
        return Figure([*arrows], names)

    return draw


def panel(draw: Callable[[Window], Figure]) -> Panel:
    return Panel(draw(WINDOW), WINDOW, ROOM)


@pytest.mark.parametrize(("count", "size"), [(2, 3.0), (8, 40.0), (0, 1.0)])
def test_what_has_room_is_left_as_it_is(count: int, size: float) -> None:
    draw = fan(count, size)
    before = panel(draw)
    assert detailed(before, draw, "velocity") is before


@pytest.mark.parametrize("size", [1.0, 2.0, 4.0])
def test_a_knot_is_drawn_once_more(size: float) -> None:
    draw = fan(12, size)
    before = panel(draw)
    after = detailed(before, draw, "velocity")
    assert [mark for mark in after.figure.marks if mark in before.figure.marks] == before.figure.marks
    part, shown = (mark for mark in after.figure.marks if isinstance(mark, Disc))
    assert abs(part.centre - WINDOW(0)) < part.radius
    again = {mark.name: mark for mark in after.figure.marks if isinstance(mark, VectorMark) and mark.plane == "detail"}
    times = shown.radius / part.radius
    for name, mark in again.items():
        if name != "v_long":
            assert mark.length == pytest.approx(times * size)
        assert abs(mark.end - shown.centre) <= shown.radius + 0.1


def test_each_arrow_is_named_once() -> None:
    draw = fan(12, 2.0)
    after = detailed(panel(draw), draw, "acceleration")
    names = Counter(want.of for want in after.figure.wanted if want.of)
    assert set(names.values()) == {1}
    assert len(names) == 13
    assert [want.label for want in after.figure.wanted if not want.of] == [plain("I\u2032")]


def test_a_detail_saves_leaders() -> None:
    draw = fan(14, 2.0)
    before, after = (one.near for one in (panel(draw), detailed(panel(draw), draw, "velocity")))
    assert after.clashes + len(after.marks) < before.clashes + len(before.marks) or after.clashes < before.clashes
