"""The sheet of instant centres: the mechanism with its centres, the circle diagram, the table.

A step is a centre, in the order in which they are found.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import cached_property, partial

from graphkin.base.value import frozen
from graphkin.errors import Lang
from graphkin.sheet.centre_figure import OnPaper, bare_mechanism, centre_figure, spots
from graphkin.sheet.centre_table import CentreTable, centre_table, circle_diagram, circle_size
from graphkin.sheet.layout import HEAD
from graphkin.sheet.marks import Stroke
from graphkin.sheet.mechanism_figure import mechanism_places
from graphkin.sheet.page import Lettered, Page, Panel, Sheet, heading
from graphkin.sheet.paper import Paper, Room, papers_for
from graphkin.sheet.single_figure import SheetGrid
from graphkin.sheet.titleblock import tables_room
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
_NEAR = (2.0, 1.3, 0.9, 0.6, 0.3, 0.0)  # centres so many times the mechanism's size away are looked for room for
_FIT = 20.0  # the same, where all centres are to be on the sheet
"""Width of the title block; height of the check bar under the table [mm]."""


def centre_sheet(found: Centres, *, paper: str | None = None, lang: Lang = "en", fit: bool = False) -> Sheet:
    """Draw a mechanism with all its instant centres, the circle diagram, and the table of centres.

    found  at one position
    paper  a key of `PAPERS`; the smallest that serves where left out
    fit    so small that all finite centres within 20 times the mechanism's size are on the sheet;
           else those farther off are told by an arrow and their coordinates

    Raises UnknownPaper.
    """
    measures = CentreExtent(found)
    layouts = [layout for one in papers_for(paper) for layout in _layouts(measures, one, lang, fit)]
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
    base = [*layout.table.drawn(complex(grid.strip.room.left + 3, grid.strip.room.top + 1.5))]
    base += heading(_HEADING[lang], "position", scale, layout.figure)
    beside = circle.left > layout.figure.left
    other = complex(circle.left, circle.bottom) if beside else complex(circle.right, circle.top)
    base += [Stroke((complex(circle.left, circle.top), other), "thin"), *circle_diagram(found, circle, lang)]
    room = layout.figure.inset(2, HEAD, 2)
    panel = Panel(centre_figure(OnPaper(found, layout.window, room)), layout.window, room)
    return grid.page([panel], found.method.mechanism, lang, drivers=found.plot.facts.values, base=base)


# --- layouts ----------------------------------------------------------------------------------


@frozen
class CentreExtent:
    """Places of a mechanism and its centres, and how far signs reach beyond them, on any paper."""

    found: Centres

    @cached_property
    def places(self) -> list[complex]:
        return mechanism_places(self.found.method, self.found.plot)

    @cached_property
    def extent(self) -> Extent:
        """Of the mechanism alone."""
        given = self.found.method.mechanism.scales.get("length")
        return Extent.of(self.places, partial(bare_mechanism, self.found), given, letters=_LETTERS, trial=_TRIAL)

    @property
    def longest(self) -> float:
        """The mechanism's larger side [m]."""
        return self.extent.longest or 1.0

    @cached_property
    def finite(self) -> list[complex]:
        """Centres that are not at infinity, the nearest first [m]."""
        places = [spot.place for spot in spots(self.found) if spot.place is not None]
        return sorted(places, key=lambda place: (self.off(place), place.real, place.imag))

    def off(self, place: complex) -> float:
        """Distance of a place from the mechanism's box, in its larger sides."""
        low, high = self.extent.low, self.extent.high
        x = max(low.real - place.real, place.real - high.real, 0.0)
        y = max(low.imag - place.imag, place.imag - high.imag, 0.0)
        return max(x, y) / self.longest

    def box(self, places: Iterable[complex]) -> Extent:
        """The box that holds the mechanism and more places."""
        low, high = corners([*self.places, *places])
        return replace(self.extent, low=low, high=high)


@frozen
class CentreLayout:
    """A paper divided, the window through which the figure is seen.

    shown   how many centres lie in its room
    large   size of the mechanism, and least: what it is to be [mm]
    """

    grid: SheetGrid
    figure: Room
    circle: Room
    table: CentreTable
    window: Window
    shown: int
    large: float
    least: float

    @property
    def worth(self) -> float:
        """Centres on the sheet count, and that the mechanism is not small; larger paper only where it helps."""
        small, paper = max(0.0, self.least - self.large), self.grid.paper
        costs = 3 * small + _LARGER_PAPER * (paper.width * paper.height > 80_000) + 40 * self.table.lost
        return _SHOWN * self.shown + min(self.large, 100) / 8 - costs


def _layouts(measures: CentreExtent, paper: Paper, lang: Lang, fit: bool) -> Iterator[CentreLayout]:
    """On one paper, with more or less room for centres outside the mechanism.

    The circle diagram stands at the right, on upright paper beside the table in the strip at the foot; where both have
    no room there, over it.
    """
    size, wide, most = circle_size(measures.found), paper.frame.size.real, 0.4 * paper.height
    table = centre_table(measures.found, lang, tables_room(paper), most)
    beside = centre_table(measures.found, lang, wide - size.real - 6, most)
    if not paper.landscape and not beside.lost and beside.height < table.height + size.imag:
        grid = SheetGrid.over(paper, least=max(size.imag, beside.height))
        foot, table, figure = grid.strip.room, beside, grid.field
        circle = Room(foot.right - size.real, foot.top, foot.right, foot.top + size.imag)
    else:
        grid = SheetGrid.over(paper, least=table.height)
        field, right, bottom = grid.field, grid.field.right - size.real, grid.field.bottom - size.imag
        figure, circle = replace(field, bottom=bottom), replace(field, top=bottom)
        if paper.landscape:
            figure, circle = replace(field, right=right), replace(field, left=right)
    room = figure.inset(0, HEAD, 0)
    inner = room.size - measures.extent.reach
    if min(inner.real, inner.imag) < 15:
        return
    least = _LARGE_ENOUGH * len(measures.found.centring.stages) ** 0.5
    scales, given = set[float](), measures.extent.given
    for near in (_FIT,) if fit else _NEAR:
        box = measures.box(place for place in measures.finite if measures.off(place) <= near)
        # the finest at which all fits; the file's own, where the mechanism (to fit: all) fits at that
        kept = given is not None and (box if fit else measures.extent).fits(given, room)
        scales.add(given if given is not None and kept else box.finest(room))
    for scale in sorted(scales):
        shown, held = list[complex](), inner * scale * (1 + 1e-9)
        for place in measures.finite:  # as many as it holds beside the mechanism [m], the nearest first
            size = measures.box([*shown, place]).size
            if size.real <= held.real and size.imag <= held.imag:
                shown.append(place)
        window = measures.box(shown).window(room, scale)
        yield CentreLayout(grid, figure, circle, table, window, len(shown), measures.longest / scale, least)
