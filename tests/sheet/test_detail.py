"""A part of a figure that is too small for its letters is drawn once more, magnified."""

from __future__ import annotations

import cmath
from collections import Counter
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from every_family import FAMILIES

from graphkin import Drawing
from graphkin.base.rooms import Room
from graphkin.errors import Lang
from graphkin.files import library, loads
from graphkin.sheet.arrows import side_by_side
from graphkin.sheet.detail import detailed
from graphkin.sheet.label_candidates import Arrows
from graphkin.sheet.label_requests import LabelRequest, tangled
from graphkin.sheet.lettering import plain
from graphkin.sheet.marks import Disc, PointMark, Shows, Stroke, Text, VectorMark
from graphkin.sheet.page import Panel
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


def test_arrows_of_a_bundle_are_named_where_the_detail_shows_their_heads() -> None:
    """Each beside its own arrow: where they run side by side no letter tells whose it is."""
    heads = {f"a_{k}": 70 + 10j + 1.6 * cmath.rect(1, 1.3 * k) for k in range(5)}

    def draw(window: Window) -> Figure:
        arrows = [VectorMark("acceleration", name, "p'", name, window(0), window(tip)) for name, tip in heads.items()]
        arrows += [VectorMark("acceleration", f"b_{k}", f"a_{k}", f"a_{k + 1}", window(heads[f"a_{k}"]), window(heads[f"a_{k + 1}"]))
                   for k in range(4)]  # fmt: skip
        return Figure(arrows, [LabelRequest(plain(one.name), one.start, one.end, of=one.name) for one in arrows])

    before = panel(draw)
    after = detailed(before, draw, "acceleration")
    _, shown = (mark for mark in after.figure.marks if isinstance(mark, Disc))
    own = [want for want in after.figure.wanted if want.of.startswith("a_") and abs(want.place - shown.centre) < shown.radius]
    assert own
    drawn = {mark.name: mark for mark in after.figure.marks if isinstance(mark, VectorMark) and mark.plane == "detail"}
    assert all((want.start, want.end) == (drawn[want.of].start, drawn[want.of].end) for want in own)
    assert max(Counter(want.of for want in after.figure.wanted if want.of).values()) == 1
    lettered = {mark.label: mark for mark in after.lettering if isinstance(mark, Text)}
    assert all(abs(lettered[want.label].at - shown.centre) < shown.radius + 6 for want in own)


def test_a_detail_that_relieves_nothing_alone_is_drawn_with_that_of_its_knot() -> None:
    """Arrows of a twentieth of a millimetre are seen in none that has room."""
    draw = fan(9, 0.05)
    after = detailed(panel(draw), draw, "velocity")
    assert len(after.magnified) == 2
    assert not after.near.led


def test_a_detail_saves_leaders() -> None:
    draw = fan(14, 2.0)
    before, after = (one.near for one in (panel(draw), detailed(panel(draw), draw, "velocity")))
    now, then = len(after.clashing), len(before.clashing)
    assert now + len(after.marks) < then + len(before.marks) or now < then


def test_the_pole_has_its_name_outside_a_detail_too() -> None:
    arrows, pole = fan(12, 2.0), LabelRequest(plain("p"), WINDOW(0), gap=0.5)

    def draw(window: Window) -> Figure:
        figure, at = arrows(window), window(0)
        return Figure([*figure.marks, PointMark("velocity", "p", "pole", at)], [*figure.wanted, replace(pole, start=at)])

    after = detailed(panel(draw), draw, "velocity")
    assert [want.label for want in after.figure.wanted].count(pole.label) == 2
    assert pole in after.figure.wanted


def test_several_points_close_together_are_a_knot() -> None:
    names = [LabelRequest(plain("v_B"), 0j, 50 + 0j, of="v_B"), *(LabelRequest(plain("b"), k + 0j) for k in (0, 3, 5, 7))]
    assert all(tangled(names)[1:] > 0)
    assert not tangled(names[:-1]).any()


# --- arrows on one line -----------------------------------------------------------------------


def on_one_line(*ends: tuple[complex, complex]) -> Figure:
    arrows = [VectorMark("velocity", f"v_{k}", "p", f"{k}", *each) for k, each in enumerate(ends)]
    return side_by_side(Figure([*arrows], [LabelRequest(plain(v.name), v.start, v.end, of=v.name) for v in arrows]))


def test_every_language_magnifies_the_same_parts() -> None:
    sheets = [Drawing.of(library.load("p3-15")).sheet(lang=lang) for lang in ("en", "zh")]
    circles = [[mark.radius for mark in sheet.marks if isinstance(mark, Disc) and mark.pen == "centre"]
               for sheet in sheets]  # fmt: skip
    english, chinese = (sorted(radii)[: len(radii) // 2] for radii in circles)  # the smaller ones are about the parts
    assert len(english) == 2
    assert chinese == pytest.approx(english)


CRANK = """
frame = { A = [0, 0] }
links = { 1.AB = 30, 2.BC = 100, 3.points = ["C"] }
slide = [{ block = "3", point = "C", guide = "frame", through = [0, 10], angle = 180 }]
driver = [{ vector = "AB", angle = 100, omega = -20, alpha = 30 }]
sketch = { C = [-100, 10], B = [-5, 30] }
scales = { acceleration = 0.15 }
"""


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_a_figure_that_is_cut_has_room_for_its_detail(lang) -> None:
    """The figure of a handout has the detail that the whole sheet has."""
    figure = Drawing.of(loads(CRANK)).sheet(lang=lang, only="acceleration", tight=True)
    assert sum(isinstance(mark, Disc) and mark.pen == "centre" for mark in figure.marks) == 2


@pytest.mark.parametrize("turn", [1, -1j, cmath.rect(1, 2.5)])
def test_an_arrow_with_a_piece_of_its_own_stays_on_its_line(turn: complex) -> None:
    figure = on_one_line((0j, 60 * turn), (0j, 20 * turn), (0j, 40 * turn))
    assert not any(mark.aside for mark in figure.marks if isinstance(mark, VectorMark))
    named = {want.of: (want.start, want.end) for want in figure.wanted}
    for name, low in (("v_0", 40), ("v_1", 0), ("v_2", 20)):  # each where no shorter one lies
        assert named[name] == pytest.approx((low * turn, (low + 20) * turn))


@pytest.mark.parametrize("turn", [1, 1j, -1j, complex(1e-17, 1), complex(-1e-17, 1)])
def test_arrows_to_and_fro_lie_on_two_lanes(turn: complex) -> None:
    marks = on_one_line((0j, 60 * turn), (60 * turn, 0j), (0j, 60.5 * turn)).marks
    lanes = [round(((mark.start / turn).imag + (mark.end / turn).imag) / 2, 3) for mark in marks
             if isinstance(mark, VectorMark)]  # fmt: skip
    assert len(set(lanes)) == 3


def test_no_label_stands_beyond_the_side_of_an_image_or_a_point_beyond_an_arrow() -> None:
    arrow = VectorMark("velocity", "v_B", "p", "b", 0j, 40 + 0j)
    side = Stroke((0 + 2j, 40 + 2j), "thin", shows=Shows("2", "bar", ("b", "c"), plane="velocity"))
    wanted = [LabelRequest(plain("v_B"), 0j, 40 + 0j, of="v_B"), LabelRequest(plain("c"), 20 + 1j)]
    low = np.array([[18.0, 2.5], [18.0, -2.5], [19.0, -3.0], [19.0, 1.2]])
    strange = Arrows([arrow, side]).strange(wanted, np.array([0, 0, 1, 1]), low, low + np.array([4.0, 0.6]))
    assert strange.tolist() == [True, False, True, False]


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_an_arrow_that_its_head_hides_stands_in_a_detail_even_where_that_has_little_room(lang: Lang) -> None:
    page, name = Drawing.of(FAMILIES["PRR"](8402)).sheet(lang=lang, paper="A3-landscape"), "a^k_A2@3,A2@1"
    circles = [mark for mark in page.marks if isinstance(mark, Disc) and mark.pen == "centre"]
    [arrow] = [mark for mark in page.marks if isinstance(mark, VectorMark) and mark.name == name
               and mark.plane == "acceleration"]  # fmt: skip
    magnified = [mark for mark in page.marks if isinstance(mark, VectorMark) and mark.name == name
                 and mark.plane == "detail"]  # fmt: skip
    assert 0 < arrow.length < 1
    assert any(abs(place - one.centre) <= one.radius + 0.1 for one in circles for place in (arrow.start, arrow.end))
    assert any(mark.length > max(0.8, arrow.length * 2) for mark in magnified)


@pytest.mark.parametrize("turn", [1, 1j, cmath.rect(1, 2.5)])
def test_an_arrow_to_whose_tail_a_shorter_one_comes_back_stands_beside_it(turn: complex) -> None:
    """At any size: on that line it would seem to start where the shorter one does."""
    for times in (1.0, 2.5):
        marks = on_one_line((0j, 20 * times * turn), (20 * times * turn, -10 * times * turn)).marks
        short, long = sorted((mark for mark in marks if isinstance(mark, VectorMark)), key=lambda mark: mark.length)
        assert short.aside == 0
        assert long.aside != 0


@pytest.mark.parametrize("size", [0.05, 0.4, 1.0, 2.0, 4.0])
def test_details_have_scales_of_the_standard(size: float) -> None:
    after = detailed(panel(draw := fan(12, size)), draw, "velocity")
    scales = [mark.label[0].text for mark in after.figure.marks if isinstance(mark, Text)]
    assert scales
    first = {float(text.split("(")[1].split(":")[0]) for text in scales}
    assert first <= {digit * ten for digit in (1, 2, 2.5, 4, 5) for ten in (1, 10, 100)}
