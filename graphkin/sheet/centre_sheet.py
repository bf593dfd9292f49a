"""The sheet of instant centres: the mechanism with its centres, the circle diagram, the table.

A step is a centre, in the order in which they are found.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial

from graphkin.base.value import frozen
from graphkin.errors import Lang
from graphkin.sheet.centre_figure import OnPaper, bare_mechanism, centre_figure, spots
from graphkin.sheet.centre_table import centre_table, circle_diagram, circle_size
from graphkin.sheet.layout import HEAD
from graphkin.sheet.marks import Stroke
from graphkin.sheet.mechanism_figure import mechanism_places
from graphkin.sheet.page import Lettered, Page, Panel, Sheet, heading
from graphkin.sheet.paper import Paper, Room, papers_for
from graphkin.sheet.single_figure import SheetGrid
from graphkin.sheet.titleblock import FOOT, TableBlock, tables_room
from graphkin.sheet.window import Extent, Window, corners
from graphkin.studies.centres import Centres

_HEADING: dict[Lang, str] = {"en": "Mechanism and instant centres", "zh": "机构的速度瞬心"}
_CROWDED = 10  # with more labels at the end of leaders than this, another layout is tried
_FEW = 4  # so many labels without a place are put farther off at once; with more of them other layouts are tried first
_TRIES = 3
_TRIAL = 80.0  # size of the mechanism when it is drawn to see how far its signs reach [mm]
_LETTERS = 7.0  # room for labels and arrows around the figure [mm]
_LARGE_ENOUGH = 14.0
"""The mechanism is to be so large, times the root of how many centres there are, which want letters in it [mm]."""
_SHOWN, _LARGER_PAPER = 16, 30
"""Worth of a centre on the sheet, and cost of a larger paper, which fewer printers have."""
_NEAR, _FIT = 2.0, 20.0
"""Centres so many times the mechanism's size away are looked for room for; and where all are to be on the sheet."""


def centre_sheet(found: Centres, *, paper: str | None = None, lang: Lang = "en", fit: bool = False) -> Sheet:
    """Draw a mechanism with all its instant centres, the circle diagram, and the table of centres.

    found  at one position
    paper  a key of `PAPERS`; the smallest that serves where left out
    fit    so small that all finite centres within 20 times the mechanism's size are on the sheet;
           else those farther off are told by an arrow and their coordinates

    Raises UnknownPaper.
    """
    layouts = [layout for one in papers_for(paper) for layout in _layouts(found, one, lang, fit)]
    tried: list[Lettered] = []
    for layout in sorted(layouts, key=lambda one: -one.worth)[:_TRIES]:
        page = _page(found, layout, lang)
        near = page.lettered(far=False)
        tried.append(min(near, page.lettered(), key=lambda one: one.lost) if 0 < near.lost <= _FEW else near)
        if not tried[-1].lost and tried[-1].crowded <= _CROWDED:
            break
    best = min(tried, key=lambda one: (one.lost, max(0, one.crowded - _CROWDED)))
    return best.page.sheet() if best.lost > _FEW else best.sheet


def _page(found: Centres, layout: CentreLayout, lang: Lang) -> Page:
    """Table, heading, and the circle diagram beyond a thin line; then the figure."""
    grid, circle, scale = layout.grid, layout.circle, layout.window.scale
    base = [*layout.table.marks(complex(grid.strip.room.left + 3, grid.strip.room.top + 1.5))]
    base += heading(_HEADING[lang], "position", scale, layout.figure)
    edge = Stroke((complex(circle.left, circle.top), complex(circle.left, circle.bottom)), "thin")
    base += [edge, *circle_diagram(found, circle, lang)]
    room = layout.figure.inset(2, HEAD, 2)
    panel = Panel(centre_figure(OnPaper(found, layout.window, room)), layout.window, room)
    return grid.page([panel], found.method.mechanism, lang, drivers=found.plot.facts.values, base=base)


# --- layouts ----------------------------------------------------------------------------------


@frozen
class CentreLayout:
    """A paper divided, the window through which the figure is seen, and what that is worth."""

    grid: SheetGrid
    figure: Room
    circle: Room
    table: TableBlock
    window: Window
    worth: float


def _layouts(found: Centres, paper: Paper, lang: Lang, fit: bool) -> Iterator[CentreLayout]:
    """On one paper, with more or fewer centres outside the mechanism: the circle diagram beside the table in the strip
    at the foot, or beside the figure."""
    size, most, wide = circle_size(found), 0.4 * paper.height, tables_room(paper)
    for beside in (wide - size.real - 3, wide):
        table = centre_table(found, lang, beside, most)
        grid = SheetGrid.over(paper, least=max(table.size.imag, size.imag if beside < wide else 0.0))
        column = replace(grid.field, left=grid.field.right - size.real)
        figure, circle = replace(grid.field, right=column.left), column
        if beside < wide:
            foot = grid.strip.room
            figure, circle = grid.field, replace(foot, left=column.left, bottom=foot.bottom - FOOT)
        room = figure.inset(0, HEAD, 0)
        for window, shown, longest in _windows(found, room, fit):
            large, larger = longest / window.scale, paper.width * paper.height > 80_000
            small = max(0.0, _LARGE_ENOUGH * len(found.centring.stages) ** 0.5 - large)
            worth = _SHOWN * shown + min(large, 100) / 8 - 3 * small - _LARGER_PAPER * larger - 40 * table.lost
            yield CentreLayout(grid, figure, circle, table, window, worth)


def _windows(found: Centres, room: Room, fit: bool) -> Iterator[tuple[Window, int, float]]:
    """Windows on the mechanism with the nearest of its centres, one for each scale; how many are seen through each, and
    the mechanism's size [m]."""
    places, given = mechanism_places(found.method, found.plot), found.method.mechanism.scales.get("length")
    alone = Extent.of(places, partial(bare_mechanism, found), given, letters=_LETTERS, trial=_TRIAL)
    if min((room.size - alone.reach).real, (room.size - alone.reach).imag) < 15:
        return
    (low, high), longest = (alone.low, alone.high), alone.longest or 1.0

    def off(centre: complex) -> float:
        """The distance of a place from the mechanism's box, in its larger sides."""
        x = max(low.real - centre.real, centre.real - high.real, 0.0)
        y = max(low.imag - centre.imag, centre.imag - high.imag, 0.0)
        return max(x, y) / longest

    finite = [spot.place for spot in spots(found) if spot.place is not None]
    near = sorted((centre for centre in finite if off(centre) <= (_FIT if fit else _NEAR)), key=off)
    boxes = dict[float, Extent]()
    for count in range(len(near) if fit else 0, len(near) + 1):
        low_end, high_end = corners([*places, *near[:count]])
        box = replace(alone, low=low_end, high=high_end)
        boxes[box.scale(room)] = box
    if given in boxes and not fit:  # the file's own scale is kept where the mechanism fits at that
        boxes = {given: boxes[given]}
    for scale, box in boxes.items():
        window = box.window(room, scale)
        yield window, sum(room.holds(window(centre)) for centre in finite), longest
