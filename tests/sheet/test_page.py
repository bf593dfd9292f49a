"""There is one page: what every sheet needs is done in one place of the whole house."""

from __future__ import annotations

import ast
import math
import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path

import book
import numpy as np
import pytest

import graphkin
from graphkin.base.rooms import Room
from graphkin.base.scales import SERIES
from graphkin.files import library, loads
from graphkin.planning import plan
from graphkin.running import replay_all
from graphkin.sheet import PAPERS, Sheet, sheet
from graphkin.sheet.about_sheet import about_sheet
from graphkin.sheet.centre_sheet import centre_sheet
from graphkin.sheet.corners import standing
from graphkin.sheet.finding_sheet import positions_sheet
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import plain, width
from graphkin.sheet.marks import Stroke, Text
from graphkin.sheet.obstacles import bounds
from graphkin.sheet.page import Page, Panel, step_sheets
from graphkin.sheet.window import Extent, Figure, Window
from graphkin.studies.centres import centres
from graphkin.studies.centres.about import about

PACKAGE = Path(graphkin.__file__).parent
TEXTS = {path.relative_to(PACKAGE).as_posix(): path.read_text("utf-8") for path in PACKAGE.rglob("*.py")}


@cache
def trees() -> dict[str, ast.Module]:
    return {path: ast.parse(text) for path, text in TEXTS.items()}


def names_of(tree: ast.AST, module: str, name: str) -> set[str]:
    """What a file calls something: `settle`, or `labels.settle`, or by another name it was imported under."""
    found = {node.name for node in ast.walk(tree) if isinstance(node, ast.ClassDef | ast.FunctionDef)} & {name}
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom):
            for alias in node.names:
                known = alias.asname or alias.name
                if alias.name == name and node.module in (module, module.rpartition(".")[0]):
                    found.add(known)
                elif f"{node.module}.{alias.name}" == module:
                    found.add(f"{known}.{name}")
        elif isinstance(node, ast.Import):
            found |= {f"{alias.asname or alias.name}.{name}" for alias in node.names if alias.name == module}
    return found


def calls(module: str, name: str) -> Iterator[str]:
    """The file of each call of something that a module defines."""
    for path, tree in trees().items():
        known = names_of(tree, module, name) if name in TEXTS[path] else set()
        for node in ast.walk(tree) if known else ():
            if isinstance(node, ast.Call) and ast.unparse(node.func) in known:
                yield path


ONCE = (
    ("graphkin.sheet.page", "Sheet", "page", "a finished drawing is made"),
    ("graphkin.sheet.labels", "settle", "page", "labels find their places"),
)


@pytest.mark.parametrize(("module", "name", "where", "what"), ONCE, ids=lambda word: word.rpartition(".")[2])
def test_done_in_one_line(module: str, name: str, where: str, what: str):
    assert list(calls(module, name)) == [f"sheet/{where}.py"], what


def test_a_figure_is_fitted_in_one_place():
    """Nobody else says through which window a figure is seen."""
    assert {*calls("graphkin.sheet.window", "Window")} == {"sheet/window.py"}


def test_step_sheets_are_made_in_one_line_of_the_page():
    """What a step adds is emphasised there, and nowhere else."""
    words = ((path, node) for path, tree in trees().items() for node in ast.walk(tree) if isinstance(node, ast.keyword))
    assert [path for path, word in words if word.arg == "new"] == ["sheet/page.py"]


def test_a_breach_is_seen():
    """The ways a file may call something are known."""
    lines = (
        "from graphkin.sheet.labels import settle\nsettle()",
        "from graphkin.sheet.labels import settle as placed\nplaced()",
        "from graphkin.sheet import labels\nlabels.settle()",
        "import graphkin.sheet.labels\ngraphkin.sheet.labels.settle()",
    )
    for text in lines:
        tree = ast.parse(text)
        call = next(node for node in ast.walk(tree) if isinstance(node, ast.Call))
        assert ast.unparse(call.func) in names_of(tree, "graphkin.sheet.labels", "settle"), text


# --- scales -----------------------------------------------------------------------------------


def of_a_file(scale: float) -> Iterator[Sheet]:
    """Every sheet of a mechanism whose file gives its scale."""
    method = plan(loads(re.sub(r"(?m)^length = .*", f"length = {scale}", book.TEXT), name="scaled", file="scaled.toml"))
    plot = replay_all(method)
    found = centres(method, plot)
    yield sheet(method, plot)
    yield centre_sheet(found)
    yield about_sheet(about(found, "2"))
    yield positions_sheet(method, [plot], ["here"])


@pytest.mark.parametrize("scale", [0.001, 0.0027, 0.00053])
def test_the_scale_of_the_file_is_kept_where_the_figure_fits(scale: float):
    """A scale that is not of the series, too, and by every sheet."""
    assert [drawn.scales["position"] for drawn in of_a_file(scale)] == [scale] * 4


# --- fitting ----------------------------------------------------------------------------------


def box_of(low: complex, high: complex) -> Callable[[Window], Figure]:
    """A figure of two lines, and a sign that reaches 7 mm to the right and 3 mm up, whatever the scale."""

    def draw(window: Window) -> Figure:
        ends = window(low), window(high)
        return Figure([Stroke(ends), Stroke((ends[1], ends[1] + complex(7, -3)))])

    return draw


@pytest.mark.parametrize(("wide", "high"), [(0.2, 0.1), (3.0, 0.004), (0.0, 0.05), (1e-5, 4e-5), (0.0, 0.0)])
@pytest.mark.parametrize("corner", [0j, 5 - 2j, -0.3 + 0.1j])
def test_a_figure_stands_in_the_middle_of_its_room_at_the_finest_scale(wide: float, high: float, corner: complex):
    draw, room = box_of(corner, corner + complex(wide, high)), Room(10, 20, 130, 90)
    extent = Extent.of([corner, corner + complex(wide, high)], draw, letters=4.0)
    scale = extent.scale(room)
    left, top, right, bottom = bounds(draw(extent.window(room, scale)).marks)
    assert (left - room.left, top - room.top) == pytest.approx((room.right - right, room.bottom - bottom), abs=1e-6)
    assert left - room.left >= 4 - 1e-6
    assert top - room.top >= 4 - 1e-6
    series = [float(f"{first}e{power}") for power in range(-12, 3) for first in SERIES]
    finer = max(each for each in series if each < 0.99 * scale)
    assert not abs(extent.size) or replace(extent, given=finer).scale(room) == scale
    assert math.isclose(float(f"{scale:.1e}"), scale)
    assert float(f"{scale:.1e}".partition("e")[0]) in SERIES


def test_a_given_scale_is_kept_where_it_fits():
    draw, room = box_of(0j, 0.1 + 0.05j), Room(0, 0, 120, 90)
    assert Extent.of([0j, 0.1 + 0.05j], draw, 0.0013).scale(room) == 0.0013
    assert Extent.of([0j, 0.1 + 0.05j], draw, 0.0009).scale(room) == 0.001


@pytest.mark.parametrize("foot", [False, True])
def test_blocks_keep_off_the_sides_of_their_room_and_off_one_another(foot: bool):
    """At every width at which they fit: 1 mm off a side, 1.5 mm between two that stand side by side."""
    draw, sizes = box_of(0j, 0.1 + 0.05j), (50 + 20j, 60 + 16j)
    extent = replace(Extent.of([0j, 0.1 + 0.05j], draw), blocks=tuple(((size,), foot) for size in sizes))
    beside = 0
    for wide in np.arange(50.0, 150.0, 0.5):
        for high in (55.0, 90.0):
            room = Room(20.0, 10.0, 20.0 + wide, 10.0 + high)
            stands = standing(np.array([[room.left], [room.top], [room.right], [room.bottom]]), extent)
            if np.isfinite(stands.scales[0]):
                ends = [(at, at + size) for (_, at), size in zip(stands.corners(room), sizes, strict=True)]
                assert all(low.real - room.left >= 1 and room.right - far.real >= 1 for low, far in ends)
                (_, left), (right, _) = sorted(ends, key=lambda each: each[0].real)
                if len({low.imag == room.top for low, _ in ends}) == 1:
                    beside += 1
                    assert right.real - left.real >= 1.5
    assert beside


def test_a_paper_is_cut_to_its_figure():
    ends = 1 + 1j, 1.2 + 1.1j
    draw = box_of(*ends)
    extent = Extent.of(ends, draw, 0.002, letters=9.0)
    whole = extent.cut_out(0.002)
    window = extent.window(whole, 0.002)
    left, top, right, bottom = bounds(draw(window).marks)
    assert (left, top, whole.right - right, whole.bottom - bottom) == pytest.approx((9.0,) * 4)
    assert whole.size == pytest.approx(complex(18 + 107, 18 + 53))


@pytest.mark.parametrize(("count", "columns"), [(1, 1), (5, 3), (6, 3), (7, 2)])
def test_cells_tile_their_room(count: int, columns: int):
    room = Room(10, 20, 130, 90)
    cells = room.cells(count, columns)
    assert len(cells) == count
    assert {cell.size for cell in cells} == {cells[0].size}
    assert cells[0].left == room.left
    assert cells[0].top == room.top
    assert max(cell.right for cell in cells) == pytest.approx(room.right if count >= columns else cells[-1].right)
    assert cells[-1].bottom == pytest.approx(room.bottom)
    middles = [cell.middle for cell in cells]
    assert all(sum(cell.holds(at) for cell in cells) == 1 for at in middles)


# --- a page of one's own ----------------------------------------------------------------------


def test_a_page_tells_the_first_of_each_plane_and_takes_its_steps():
    """Two figures of one plane and one of no plane; steps 1 and 2; a label in two parts."""
    name = LabelRequest(plain("A, B"), 40 + 40j, step=1, parts=((plain("A"), 1), (plain(", B"), 2)))
    first = Figure([Stroke((30 + 30j, 50 + 30j), step=1)], [name])
    room, window = Room(0, 0, 100, 90), Window(3 + 4j, 0.002)
    panels = [
        Panel(first, window, room, before=(Text(plain("head"), 5 + 5j, 3.8),)),
        Panel(Figure([Stroke((80 + 30j, 90 + 30j), step=2)]), Window(0j, 0.5), room),
        Panel(Figure(), Window(0j, 7.0), room, plane=None),
    ]
    machine = library.load("ex3-1")
    whole = Page(PAPERS["A4"], panels, machine, (np.float64(0.5),), "en").sheet()
    assert (whole.scales, whole.origins) == ({"position": 0.002}, {"position": 3 + 4j})
    assert whole.drivers == (0.5,)
    assert whole.title == machine.headline("en")
    texts = [mark for mark in whole.marks if isinstance(mark, Text)]
    assert [("".join(run.text for run in text.label), text.step) for text in texts] == [("head", None), ("A", 1), (", B", 2)]
    assert texts[2].at == pytest.approx(texts[1].at + width(plain("A"), texts[1].size))
    one, two = step_sheets(whole, (1, 2))
    assert [(mark.step, mark.new) for mark in one.marks] == [(None, False), (1, True), (1, True)]
    assert [(mark.step, mark.new) for mark in two.marks] == [
        (None, False), (1, False), (2, True), (1, False), (2, True),
    ]  # fmt: skip
