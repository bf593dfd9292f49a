"""The sheet: true to scale, inside its paper, and its letters on nothing."""

from __future__ import annotations

import cmath
import gc
import re
import weakref
from collections.abc import Iterator
from functools import cache

import book
import pytest
import shapely
from every_family import FAMILIES
from large_mechanisms import dyads
from library_sheets import library_sheet, plain_text, solved

from graphkin import Drawing
from graphkin.base.rooms import Room
from graphkin.base.scales import finer, finest
from graphkin.construction import LETTER, Drawn, Given, LayOff, Plane, Plot
from graphkin.files import library, loads
from graphkin.planning import Method, plan
from graphkin.planning.needed import without_aids
from graphkin.running import replay_all
from graphkin.sheet import PAPERS, Sheet, TooLargeForPaper, UnknownPaper, mechanism_sheet, scales_of, sheet, step_sheets
from graphkin.sheet.composition import SheetContents
from graphkin.sheet.label_candidates import LabelScene
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.labels import settle
from graphkin.sheet.lettering import (
    advance,
    between,
    box,
    number,
    plain,
    point_label,
    scripts,
    vector_label,
    width,
)
from graphkin.sheet.marks import ArcMark, PointMark, Stroke, Text, VectorMark
from graphkin.sheet.obstacles import bounds

SOLVED = list(library.names())[::3]


def vector(page: Sheet, name: str) -> VectorMark:
    return next(mark for mark in page.marks if isinstance(mark, VectorMark) and mark.name == name)


# --- true to scale ----------------------------------------------------------------------------


def test_example_3_1_has_the_lengths_of_the_book() -> None:
    method = plan(book.example())
    page = sheet(method, replay_all(method))
    assert vector(page, "v_B3").length == pytest.approx(27.12, abs=0.005)  # p b3 [mm]
    assert vector(page, "v_B3B2").length == pytest.approx(32.08, abs=0.005)  # b2 b3
    assert vector(page, "a^k_B3B2").length == pytest.approx(25.149, abs=0.005)
    assert page.scales == {"position": 0.001, "velocity": 0.01, "acceleration": 0.1}


@pytest.mark.many
@pytest.mark.parametrize("name", SOLVED)
def test_points_and_arrows_lie_where_the_replay_puts_them(name: str) -> None:
    _, plot = solved(name)
    page = library_sheet(name)
    pieces = {(m.plane, m.head): m.broken * (m.end - m.start) / m.length
              for m in page.marks if isinstance(m, VectorMark) and m.broken}  # fmt: skip
    for mark in page.marks:
        if getattr(mark, "plane", "") == "detail":
            continue
        if isinstance(mark, PointMark):
            value = plot.points(mark.plane)[mark.name]
            place = page.origins[mark.plane] + value.conjugate() / page.scales[mark.plane]
            assert mark.at + pieces.get((mark.plane, mark.name), 0) == pytest.approx(place, abs=1e-6)
        if isinstance(mark, VectorMark):
            points = plot.points(mark.plane)
            arrow = (points[mark.head] - points[mark.tail]).conjugate() / page.scales[mark.plane]
            piece = pieces.get((mark.plane, mark.head), 0) if mark.broken else 0
            assert mark.end - mark.start + piece == pytest.approx(arrow, abs=1e-6)


@pytest.mark.parametrize("name", SOLVED)
def test_every_moving_point_has_its_absolute_arrow(name: str) -> None:
    """From the pole, or from a point that a driver at rest holds there; or shares that of one that moves as it does."""
    method = without_aids(solved(name)[0])
    marks = library_sheet(name).marks
    poles = {m.plane: m.at for m in marks if isinstance(m, PointMark) and m.of == "pole"}
    vectors = [m for m in marks if isinstance(m, VectorMark) and m.plane != "detail"]
    tails = [m.start + 1j * m.aside * (m.end - m.start) / max(m.length, 1e-9) for m in vectors]  # where they belong
    arrows = {(m.plane, m.head) for m, tail in zip(vectors, tails, strict=True) if abs(tail - poles[m.plane]) < 1e-6}
    also = {name for mark in vectors for name in mark.also}
    for construction in (method.velocity, method.acceleration):
        fixed = {name for step in construction.steps if isinstance(step, Given) for name in (step.point, *step.also)}
        for node in construction.nodes.values():
            if node.site is not None and node.name not in fixed and node.site.point[0].isupper():
                shared = f"{LETTER[construction.plane]}_{node.of}" in also
                assert shared or (construction.plane, node.name) in arrows


@pytest.mark.parametrize("name", SOLVED)
def test_no_arrow_is_drawn_twice_but_one_carried_to_its_point(name: str) -> None:
    method, _ = solved(name)
    carried = [
        (construction.plane, step.term.name(construction.plane))
        for construction in (method.velocity, method.acceleration)
        for step in construction.steps
        if isinstance(step, LayOff) and isinstance(step.term.size, Drawn)
    ]
    names = [(m.plane, m.name) for m in library_sheet(name).marks if isinstance(m, VectorMark) and m.plane != "detail"]
    assert {one for one in names if names.count(one) > 1} <= set(carried)


# --- on the paper -----------------------------------------------------------------------------


@pytest.mark.parametrize("name", SOLVED)
def test_everything_is_inside_the_drawing_frame(name: str) -> None:
    page = library_sheet(name)
    left, top, right, bottom = bounds(page.marks)
    margin = page.paper.margin - 1e-6
    assert left >= margin
    assert top >= margin
    assert right <= page.paper.width - margin
    assert bottom <= page.paper.height - margin


def boxes(page: Sheet) -> list[tuple[str, shapely.Polygon]]:
    """Each text with the box that it takes, turned as it is."""
    areas = []
    for mark in (mark for mark in page.marks if isinstance(mark, Text)):
        wide, up, down = box(mark.label, mark.size)
        corners = [mark.at + cmath.rect(1, mark.turn) * c for c in (-1j * up, wide - 1j * up, wide + 1j * down, 1j * down)]
        areas.append((plain_text(mark.label), shapely.Polygon([(c.real, c.imag) for c in corners])))
    return areas


def lying_on_another(placed: list[tuple[str, shapely.Polygon]], less: float) -> Iterator[str]:
    """Texts that lie on a later one with more than so much of their rim."""
    areas = [area for _, area in placed]
    for one, two in shapely.STRtree(areas).query(shapely.buffer(areas, -less), "intersects").T:
        if one < two:
            yield f"{placed[one][0]} lies on {placed[two][0]}"


@pytest.mark.many
@pytest.mark.parametrize("name", SOLVED)
def test_no_letters_lie_on_letters(name: str) -> None:
    assert list(lying_on_another(boxes(library_sheet(name)), 0.01)) == []


@pytest.mark.parametrize("name", SOLVED)
def test_no_letters_lie_on_arrows(name: str) -> None:
    page = library_sheet(name)
    arrows = [m for m in page.marks if isinstance(m, VectorMark)]
    lines = [shapely.LineString([(m.start.real, m.start.imag), (m.end.real, m.end.imag)]) for m in arrows]
    for text, area in boxes(page):
        for arrow, line in zip(arrows, lines, strict=True):
            assert not line.intersects(area), f"{text} lies on {arrow.name}"


def test_same_input_same_sheet() -> None:
    assert sheet(*solved("p3-7")).marks == library_sheet("p3-7").marks


def test_chinese_headings() -> None:
    texts = [plain_text(m.label) for m in sheet(*solved("ex3-1"), lang="zh").marks if isinstance(m, Text)]
    assert {"机构运动简图", "速度多边形", "加速度多边形"} <= set(texts)
    assert solved("ex3-1")[0].mechanism.title["zh"] in texts


def test_only_some_planes() -> None:
    page = sheet(*solved("ex3-1"), only="velocity")
    assert {m.plane for m in page.marks if isinstance(m, VectorMark | PointMark)} == {"velocity"}
    assert set(page.scales) == {"velocity"}


# --- steps ------------------------------------------------------------------------------------


STEPPED = ("ex3-1", "fig3-1", "p3-14", "s3-sieve", "p3-12", "p3-8")


@pytest.mark.parametrize("name", STEPPED)
def test_steps_build_up_the_whole_drawing(name: str) -> None:
    method, plot = solved(name)
    whole = {(m.plane, m.name) for m in library_sheet(name).marks if isinstance(m, VectorMark)}
    before: set[tuple[Plane, str]] = set()
    for step, page in enumerate(step_sheets(method, plot), start=1):
        now = {(m.plane, m.name) for m in page.marks if isinstance(m, VectorMark)}
        assert before <= now
        assert all(m.step is None or m.step <= step for m in page.marks)
        assert all(m.new == (m.step == step) for m in page.marks)
        before = now
    assert before == whole


def test_steps_lie_over_one_another() -> None:
    method, plot = solved("ex3-5")
    early, late = (sheet(method, plot, upto=step) for step in (5, len(method.acts)))
    places = {(m.plane, m.name): m.at for m in late.marks if isinstance(m, PointMark)}
    assert all(places[m.plane, m.name] == m.at for m in early.marks if isinstance(m, PointMark))


@pytest.mark.parametrize("name", STEPPED)
def test_a_series_of_steps_is_each_step_by_itself(name: str) -> None:
    method, plot = solved(name)
    series = list(step_sheets(method, plot))
    assert len(series) == len(without_aids(method).acts)
    every = 5 if name == STEPPED[0] else max(2, len(series) // 2)
    assert all(page.marks == sheet(method, plot, upto=k).marks for k, page in enumerate(series, 1) if k % every == 0)


def test_crowded_letters_take_a_larger_paper() -> None:
    assert library_sheet("p3-22").paper.name.startswith("A3")
    assert sheet(*solved("p3-22"), paper="A4").paper.name == "A4"


EXCAVATOR = """
title = "Two cylinders"
[frame]
A = [0, 0]
B = [300, -200]
[links.boom]
shape = { A = [0, 0], C = [1000, -50], D = [2500, 200], E = [1200, 300] }
[links.stick]
shape = { D = [0, 0], F = [-400, 150], T = [1800, 0] }
[links.c1]
points = ["B"]
[links.r1]
points = ["C"]
[links.c2]
points = ["E"]
[links.r2]
points = ["F"]
[[slide]]
name = "lift"
block = "r1"
point = "C"
guide = "c1"
[[slide]]
name = "crowd"
block = "r2"
point = "F"
guide = "c2"
[[driver]]
slide = "lift"
at = 850
velocity = 0.1
[[driver]]
slide = "crowd"
at = 1500
velocity = -0.2
acceleration = 0.05
[sketch]
C = [900, 500]
D = [2200, 1200]
F = [2200, 1700]
E = [900, 1000]
T = [3000, -300]
"""


def chain(count: int) -> str:
    """Four-bars one after another: many arrows from one pole."""
    frame = [f"D{k} = [{60 * k}, {(4, 1, 5, 2, 6)[k % 5]}]" for k in range(1, count + 1)]
    links = ["[links.1]", "AB0 = 25"]
    for k in range(1, count + 1):
        links += [f"[links.{2 * k}]", f"B{k - 1}B{k} = 60", f"[links.{2 * k + 1}]", f"D{k}B{k} = {30 + 3 * k}"]
    drive = ["[[driver]]", 'vector = "AB0"', "angle = 70", "omega = 10"]
    sketch = [f"B{k} = [{10 + 60 * k}, {30 + 3 * k}]" for k in range(1, count + 1)]
    return "\n".join(["[frame]", "A = [0, 0]", *frame, *links, *drive, "[sketch]", *sketch])


@cache
def crowd(name: str) -> tuple[Method, Plot]:
    text = EXCAVATOR if name == "excavator" else chain(8)
    method = plan(loads(text, name=name, file=f"{name}.toml"))
    return method, replay_all(method)


@cache
def excavator() -> Sheet:
    return sheet(*crowd("excavator"), paper="A3")


@pytest.mark.parametrize(("name", "paper"), [("excavator", "A3"), ("chain", "A3"), pytest.param("p3-22", "A4-landscape", marks=pytest.mark.further)])
def test_no_label_of_a_crowd_lies_on_another_or_on_an_arrow(name: str, paper: str) -> None:
    page = excavator() if name == "excavator" else sheet(*(crowd(name) if name == "chain" else solved(name)), paper=paper)
    placed = boxes(page)
    assert list(lying_on_another(placed, 0.05)) == []
    drawn_lines = {m: (m.start, m.end) for m in page.marks if isinstance(m, VectorMark)}
    leaders = [m.places for m in page.marks if isinstance(m, Stroke) and m.pen == "leader"]
    lines = [shapely.LineString([(z.real, z.imag) for z in ends]) for ends in [*drawn_lines.values(), *leaders]]
    inner = shapely.STRtree(shapely.buffer([area for _, area in placed], -0.05))
    assert [f"a line runs through {placed[k][0]}" for k in inner.query(lines, "intersects")[1]] == []


def test_figures_alone_that_no_paper_is_large_enough_for() -> None:
    """They are drawn on the largest, as with a title."""
    method = plan(dyads(14, kinds=("RRR",)))
    drawn = sheet(method, replay_all(method), only="acceleration", tight=True)
    assert drawn.paper.name in ("A3", "A3-landscape")
    assert drawn.paper.width < 420


def test_a_crowd_is_the_same_each_time() -> None:
    assert sheet(*crowd.__wrapped__("excavator"), paper="A3").marks == excavator().marks


def test_labels_that_say_nothing_new_are_left_out_where_there_is_no_room() -> None:
    wanted = [LabelRequest(plain(f"a{k}"), 10 + 10j, spare=k > 0) for k in range(9)]
    narrow = Room(6, 6, 14, 14)
    assert len([m for m in settle(LabelScene(wanted, [], narrow)).marks if isinstance(m, Text)]) == 9
    settled = settle(scene := LabelScene(wanted, [], narrow), near := settle(scene))
    assert near.places is not None
    assert near.places.stands.all()  # it stays as it was settled
    kept = ["".join(run.text for run in m.label) for m in settled.marks if isinstance(m, Text)]
    assert not settled.clashing
    assert "a0" in kept
    assert len(kept) < 9


# --- scales and paper -------------------------------------------------------------------------


def example(text: str = "", **changes: str) -> tuple[Method, Plot]:
    """Example 3-1 with other values."""
    text = book.TEXT
    for key, value in changes.items():
        text = re.sub(rf"(?m)^{key}\s*=.*$", f"{key} = {value}", text)
    method = plan(loads(text, name="ex", file="ex.toml"))
    return method, replay_all(method)


@pytest.mark.parametrize(
    ("size", "room", "scale"),
    [
        (78 + 50j, 100 + 100j, 1), (101 + 5j, 100 + 100j, 1.5), (5 + 300j, 100 + 100j, 3), (0.001 + 0j, 100 + 100j, 1e-5),
        (999 + 0j, 100 + 100j, 10), (601 + 0j, 100 + 1j, 10), (7 + 39j, 100 + 100j, 0.4), (2e9 + 0j, 100 + 100j, 2e7), (0j, 100 + 100j, 0.01),
    ],
)  # fmt: skip
def test_finest_scale_of_the_series(size: complex, room: complex, scale: float) -> None:
    assert finest(size, room) == scale


def test_finer_scales() -> None:
    assert [finer(s) for s in (1.0, 5.0, 2.0, 2.5, 0.001, 1e9)] == [0.6, 4.0, 1.5, 2.0, 0.0006, 6e8]


@pytest.mark.parametrize("scale", ["0.0001", "1e-9"])
def test_a_given_scale_too_fine_for_paper_names_one_that_fits(scale: str) -> None:
    method, plot = example(velocity=scale)
    with pytest.raises(TooLargeForPaper, match=r"ex\.toml:\d+, scales\.velocity.*0\.0015 would fit") as caught:
        sheet(method, plot)
    assert "放不进" in caught.value.message("zh")
    method, plot = example(velocity="0.0015")
    assert sheet(method, plot).scales["velocity"] == 0.0015


def test_a_given_scale_may_need_larger_paper() -> None:
    assert sheet(*example(velocity="0.0015")).paper.name.startswith("A3")


def test_papers() -> None:
    assert sheet(*solved("ex3-1"), paper="A3").paper == PAPERS["A3"]
    with pytest.raises(UnknownPaper, match="A4-landscape"):
        sheet(*solved("ex3-1"), paper="A7")


def test_a_mechanism_at_rest_has_polygons_of_one_point() -> None:
    page = sheet(*example(omega="0"))
    assert all(m.length == 0 for m in page.marks if isinstance(m, VectorMark))


def test_fast_mechanisms_have_coarse_scales() -> None:
    method, plot = example(omega="1e6", velocity="1000", acceleration="1e9")
    assert sheet(method, plot).scales["acceleration"] == 1e9


# --- lettering --------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "runs"),
    [
        ("b3'", [("b", True, "base"), ("3", False, "sub"), ("′", False, "base")]),
        ("O1", [("O", True, "base"), ("1", False, "sub")]),
        ("k'", [("k", True, "base"), ("′", False, "base")]),
        ("n_boom'", [("n", True, "base"), ("boom", True, "sub"), ("′", False, "base")]),
        ("n_c1'", [("n", True, "base"), ("c", True, "sub"), ("1", False, "sub"), ("′", False, "base")]),
        ("b@guide'", [("b", True, "base"), ("guide", True, "sub"), ("′", False, "base")]),
    ],
)
def test_point_labels(name: str, runs: list[tuple[str, bool, str]]) -> None:
    assert [(run.text, run.italic, run.place) for run in point_label(name)] == runs


def test_the_part_of_a_vector_stands_above_its_subscript() -> None:
    label = vector_label("a^n_B3D")
    assert plain_text(label) == "aB3Dn"
    placed = scripts(label, 10.0)
    assert placed[-1][1] == placed[1][1]  # n begins where the subscript begins
    assert placed[-1][2] < 0 < placed[1][2]


def test_two_arrows_on_one_line_have_two_names() -> None:
    assert plain_text(vector_label("a^t_DG+a^t_S4D")) == "aDGt + aS4Dt"


@pytest.mark.parametrize(
    ("name", "text"), [("n4_2'", "n4,2′"), ("ne c0'", "ne′"), ("ne c1'", "ne2′"), ("b3'", "b3′"), ("g@H", "gH")]
)
def test_points_of_the_equivalent_and_second_normals(name: str, text: str) -> None:
    assert plain_text(point_label(name)) == text


def test_widths_are_those_of_times() -> None:
    assert advance("v", italic=True) == 0.444
    assert advance("ω", italic=True) == 0.706
    assert advance("速度") == 2.0
    assert width(point_label("b3"), 10.0) == pytest.approx(5.0 + 3.5)


@pytest.mark.parametrize(
    ("value", "text"),
    [(0.27120, "0.2712"), (-3.91934, "−3.919"), (0.0, "0"), (2e-5, "2×10−5"), (1e9, "109"), (100.0, "100")],
)
def test_numbers(value: float, text: str) -> None:
    assert plain_text(number(value)) == text


def test_links_with_words_stand_apart_in_relative_motions() -> None:
    assert between(["3", "2"]) == "32"
    assert between(["r1", "c1"]) == "r1/c1"
    texts = {plain_text(m.label) for m in excavator().marks if isinstance(m, Text)}
    assert "nboom′" in texts


@pytest.mark.parametrize("seen_from", ["", 'from = "DC"\n'])
@pytest.mark.parametrize(("omega", "alpha"), [(10, 0), (0, -3), (10, 3), (-10, -3), (10, -3), (-10, 3)])
def test_a_driver_s_arrow_has_the_sense_of_each_of_its_letters(omega: float, alpha: float, seen_from: str) -> None:
    """As clockwise and counter-clockwise, by how the head of each arc lies about the pivot; one arc for what agrees."""
    text = f"""
[frame]
A = [0, 0]
D = [80, 0]
[links.1]
AB = 30
[links.2]
BC = 70
[links.3]
DC = 60
[[driver]]
vector = "AB"
{seen_from}angle = {-60 if seen_from else 30}
omega = {omega}
alpha = {alpha}
[sketch]
B = [26, 15]
C = [80, 60]
"""
    marks = Drawing.of(loads(text)).sheet(style="given").marks
    heads = [mark for mark in marks if (shows := getattr(mark, "shows", None)) and shows.form in ("omega", "alpha")]
    arcs = [mark for mark in marks if isinstance(mark, ArcMark)]
    assert len(heads) == (2 if omega * alpha < 0 else 1)
    wanted = {"omega": omega, "alpha": alpha}
    for head in heads:
        arc = min(arcs, key=lambda arc: abs(abs(head.places[0] - arc.centre) - arc.radius))
        assert (arc.sweep < 0) == (wanted[head.shows.form] > 0), head


@pytest.mark.many(8)
@pytest.mark.parametrize("name", library.names())
def test_a_solution_has_the_scales_of_its_sheet(name: str):
    drawing = Drawing.of(library.load(name))
    assert scales_of(drawing.method, drawing.plot) == drawing.sheet().scales


@pytest.fixture
def arranged(monkeypatch: pytest.MonkeyPatch) -> list[SheetContents]:
    """The contents of sheets that are arranged anew."""
    contents: list[SheetContents] = []
    cheapest = mechanism_sheet.cheapest

    def counted(own: SheetContents, paper: str | None) -> mechanism_sheet.Arrangement:
        contents.append(own)
        return cheapest(own, paper)

    monkeypatch.setattr(mechanism_sheet, "cheapest", counted)
    return contents


def test_one_drawing_is_arranged_once(arranged: list[SheetContents]):
    """For its solution, its sheet in both languages and step by step, though it be drawn twice."""
    mechanism = library.load("ex3-1")
    first = Drawing.of(mechanism)
    first.explain("zh")
    whole = [first.sheet(lang=lang).svg() for lang in ("zh", "en")]
    [*first.step_sheets(lang="zh")]
    assert len(arranged) == 1
    assert [Drawing.of(mechanism).sheet(lang=lang).svg() for lang in ("zh", "en")] == whole
    assert len(arranged) == 1
    assert [Drawing.of(library.load("ex3-1")).sheet(lang=lang).svg() for lang in ("zh", "en")] == whole


@pytest.mark.usefixtures("one_paper")
def test_few_sheets_are_kept(monkeypatch: pytest.MonkeyPatch):
    """Of a class with a problem for each no more than a handout has."""
    made, cheapest = list[weakref.ref[mechanism_sheet.Arrangement]](), mechanism_sheet.cheapest

    def noted(contents: SheetContents, paper: str | None) -> mechanism_sheet.Arrangement:
        best = cheapest(contents, paper)
        made.append(weakref.ref(best))
        return best

    monkeypatch.setattr(mechanism_sheet, "cheapest", noted)
    for length in range(20, 32):
        drawing = Drawing.of(library.load("ex3-1").with_({"links.1.AB": length}))
        scales_of(drawing.method, drawing.plot)
    gc.collect()
    assert len(made) >= 12
    assert sum(each() is not None for each in made) < 12


def test_what_stands_still_is_neither_lettered_nor_numbered_at_the_pole():
    """The slide of exercise 3-21 is at rest: of its steps only the points at the pole are left, and the ladder."""
    drawing = Drawing.of(library.load("p3-21"))
    sheet = drawing.sheet(only="acceleration")
    written = {plain_text(mark.label) for mark in sheet.marks if isinstance(mark, Text)}
    assert not {"⊥DG", "⊥DH", ", m6′", ", m8′", ", k′"} & written
    rings = {number for text in written if re.fullmatch(r"[\d–, ]+", text) for number in _steps(text)}
    assert rings >= {act.number for act in without_aids(drawing.method).acts if act.plane == "acceleration"}


def _steps(text: str) -> Iterator[int]:
    """`4, 6–8`, one by one."""
    for part in text.split(", "):
        first, _, last = part.partition("–")
        yield from range(int(first), int(last or first) + 1)


@pytest.mark.parametrize(("family", "seed", "paper", "count"), [("line_of_centres", 202, "A3-landscape", 16), ("chain", 101, "A3", 20)])
def test_data_that_have_no_room_together_are_written_in_parts(family: str, seed: int, paper: str, count: int):
    """In letters as large as those of a link's length: they were small, or left out. What is drawn counts, too."""
    texts = [mark for mark in Drawing.of(FAMILIES[family](seed)).sheet(paper=paper).marks if isinstance(mark, Text)]
    usual = max(mark.size for mark in texts if any(run.text.endswith(" mm") for run in mark.label))
    written = [mark for mark in texts if re.search("= .* (mm|rad/s²?|°)|= .*°", "".join(run.text for run in mark.label))]
    assert {mark.size for mark in written} == {usual}
    drawn = [mark for mark in texts if re.fullmatch(r"[\d.]+ mm", plain_text(mark.label))]
    assert sum(plain_text(mark.label).count(" = ") for mark in written) + len(drawn) >= count


def test_no_bar_goes_to_a_point_inside_a_plate() -> None:
    """A bar over the plate looks like another link: thin lines tell where the point is."""
    text = """
frame = { A = [0, 0], B = [60, -25] }
links = { 2.shape = { A = [0, 0], C = [180, 25], D = [210, 65], E = [420, 0] }, 3.CF = 90, 4.BF = 200 }
driver = [{ vector = "AE", angle = 25, omega = 1 }]
sketch = { C = [153, 99], F = [230, 60] }
"""
    method = plan(loads(text))
    page = sheet(method, replay_all(method))
    bars = [mark for mark in page.marks if isinstance(mark, Stroke) and mark.shows and mark.shows.link == "2"]
    assert any(mark.pen == "outline" for mark in bars if mark.closed)
    assert {mark.pen for mark in bars if not mark.closed and mark.shows and mark.shows.form == "bar"} == {"thin"}
