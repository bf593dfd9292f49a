"""The sheet of instant centres: the mechanism with its centres, the circle diagram, the table.

A step is a centre, in the order in which they are found.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cache, partial

from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.errors import Lang
from graphkin.sheet.centre_figure import OnPaper, bare_mechanism, centre_figure, spots
from graphkin.sheet.centre_table import centre_table, circle_diagram, circle_size
from graphkin.sheet.layout import HEAD, Layout, division
from graphkin.sheet.mechanism_figure import mechanism_places
from graphkin.sheet.page import Page, Panel, Sheet, heading
from graphkin.sheet.paper import Paper, papers_for
from graphkin.sheet.titleblock import Strip, TableBlock, tables_room
from graphkin.sheet.window import Extent, Window, corners, enlarged
from graphkin.studies.centres import Centres

_HEADING: dict[Lang, str] = {"en": "Mechanism and instant centres", "zh": "机构的速度瞬心"}
_CROWDED = 10  # with more labels at the end of leaders than this, another layout is tried
_TRIES = 3
_SLACK = 5 + 5j  # of the room about the circle, which no figure's points need [mm]
_LARGE_ENOUGH = 14.0
"""The mechanism is to be so large, times the root of how many centres there are, which want letters in it [mm]."""
_SHOWN, _LARGER_PAPER = 16, 80
"""Worth of a centre on the sheet, and cost of a larger paper, which fewer printers have."""
_TIMES, _FIT = [1.12**k for k in range(15)], 20.0
"""So many times larger than the mechanism the figure may become for its centres; and where all are to be on it."""


def centre_sheet(found: Centres, *, paper: str | None = None, lang: Lang = "en", fit: bool = False) -> Sheet:
    """Draw a mechanism with all its instant centres, the circle diagram, and the table of centres. Raises UnknownPaper.

    found  at one position
    paper  a key of `PAPERS`; the smallest that serves where left out
    fit    so small that all finite centres are on the sheet for which the figure becomes at most 20 times as large;
           else those farther off are told by an arrow and their coordinates
    """
    tried = list[tuple[int, int, int, Page]]()
    layouts = {(one.layout.paper, one.window, one.worth): one for one in _layouts(found, papers_for(paper), lang, fit)}
    for layout in sorted(layouts.values(), key=lambda one: -one.worth)[:_TRIES]:
        page = layout.page(found, lang)
        labels = page.panels[0].far
        tried.append((len(labels.clashing), max(0, len(labels.led) - _CROWDED), len(tried), page))
        if not any(tried[-1][:2]):
            break
    return min(tried)[-1].sheet()


@frozen
class CentreLayout:
    """A paper divided, the window through which the figure is seen, and what that is worth; the circle diagram has the
    room that a velocity polygon has on other sheets."""

    layout: Layout
    window: Window
    table: TableBlock
    worth: float

    def page(self, found: Centres, lang: Lang) -> Page:
        """Table, headings and circle diagram; then the figure."""
        layout, strip = self.layout, self.layout.strip
        whole, circle = layout.rooms["position"], layout.rooms["velocity"]
        base = [*self.table.marks(complex(strip.left + 3, strip.top + 1.5)), *circle_diagram(found, circle, lang)]
        base += heading(_HEADING[lang], "position", self.window.printed, whole)
        room = whole.inset(2, HEAD, 2)
        panel = Panel(centre_figure(OnPaper(found, self.window, room)), self.window, room, tuple(base))
        below = Strip(least=self.table.size.imag)
        return Page(layout.paper, [panel], found.method.mechanism, found.plot.facts.values, lang, below)


def _layouts(found: Centres, papers: list[Paper], lang: Lang, fit: bool) -> Iterator[CentreLayout]:
    """With more or fewer centres outside the mechanism, at the file's own scale where it fits at that."""
    places, given = mechanism_places(found.method, found.plot), found.method.mechanism.scales.get("length")
    alone = Extent.of(places, partial(bare_mechanism, found), given)
    middle, finite = (alone.low + alone.high) / 2, [spot.place for spot in spots(found) if spot.place is not None]
    near = sorted(finite, key=lambda centre: abs(centre - middle))
    figures = dict.fromkeys(corners(enlarged(places, near, times)) for times in ((_FIT,) if fit else _TIMES))
    half = (circle_size(found) - _SLACK) / 2
    diagram = Extent(0j, 0j, half.real, half.imag, half.real, half.imag, labels=0)  # of one size at any scale
    table = cache(lambda paper: centre_table(found, lang, tables_room(paper), 0.4 * paper.height))
    none = True
    for scale in (given, None) if given and not fit else (None,):
        for one, (low, high) in ((one, ends) for one in papers for ends in figures) if none else ():
            extent = replace(alone, low=low, high=high, given=scale)
            extents: dict[Plane, Extent] = {"position": extent, "velocity": diagram}
            layout = division([one], extents, lambda paper: Strip(least=table(paper).size.imag).height(paper))
            if layout is not None:
                none = False
                window, room = layout.placed("position", extent)[0], layout.rooms["position"].inset(2, HEAD, 2)
                large = (alone.longest or 1.0) / window.scale
                small = max(0.0, _LARGE_ENOUGH * len(found.centring.stages) ** 0.5 - large)
                worth = _SHOWN * sum(room.holds(window(centre)) for centre in finite) + min(large, 100) / 8 - 3 * small
                worth -= _LARGER_PAPER * (one.area > 80_000) + 40 * table(layout.paper).lost
                yield CentreLayout(layout, window, table(layout.paper), worth)
