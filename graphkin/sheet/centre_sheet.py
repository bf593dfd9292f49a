"""The sheet of instant centres: the mechanism with its centres, the circle diagram, the table.

`centre_sheet` draws all, `centre_step_sheets` one step after the other.
"""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.errors import Lang
from graphkin.sheet.centre_circle import circle_diagram
from graphkin.sheet.centre_figure import centre_figure
from graphkin.sheet.centre_layout import CentreLayout, layouts
from graphkin.sheet.centre_places import OnPaper
from graphkin.sheet.layout import HEAD
from graphkin.sheet.marks import Stroke
from graphkin.sheet.page import Lettered, Page, Panel, Sheet, heading, step_sheets
from graphkin.sheet.titleblock import Strip
from graphkin.studies.centres import Centres

_HEADING: dict[Lang, str] = {"en": "Mechanism and instant centres", "zh": "机构的速度瞬心"}
_CROWDED = 10
"""With more labels at the end of leaders than this, another layout is tried."""
_FEW = 4
"""So many labels without a place are put farther off at once; with more of them other layouts are tried first."""
_TRIES = 3


def centre_sheet(found: Centres, *, paper: str | None = None, lang: Lang = "en", fit: bool = False) -> Sheet:
    """Draw a mechanism with all its instant centres, the circle diagram, and the table of centres.

    found  at one position
    paper  a key of `PAPERS`; the smallest that serves where left out
    fit    so small that all finite centres within 20 times the mechanism's size are on the sheet;
           else those farther off are told by an arrow and their coordinates

    Raises UnknownPaper.
    """
    tried: list[Lettered] = []
    for way in layouts(found, paper, lang, fit)[:_TRIES]:
        tried.append(_lettered(_page(found, way, lang)))
        if not tried[-1].lost and tried[-1].crowded <= _CROWDED:
            break
    best = min(tried, key=lambda one: (one.lost, max(0, one.crowded - _CROWDED)))
    return best.page.sheet() if best.lost > _FEW else best.sheet


def centre_step_sheets(
    found: Centres, *, paper: str | None = None, lang: Lang = "en", fit: bool = False
) -> Iterator[Sheet]:
    """One sheet a centre, in the order in which they are found; what a step adds is emphasised."""
    whole = centre_sheet(found, paper=paper, lang=lang, fit=fit)
    yield from step_sheets(whole, range(1, len(found.centring.stages) + 1))


def _lettered(page: Page) -> Lettered:
    """The labels near what they name; where a few find no place, farther off."""
    near = page.lettered(far=False)
    return min(near, page.lettered(), key=lambda one: one.lost) if 0 < near.lost <= _FEW else near


def _page(found: Centres, layout: CentreLayout, lang: Lang) -> Page:
    field, machine = layout.field, found.method.mechanism
    room = field.inset(2, HEAD, 2)
    base = [*layout.table.drawn(complex(layout.strip.left + 3, layout.strip.top + 1.5))]
    base += heading(_HEADING[lang], "position", layout.window.scale, field)
    base += [_divider(layout), *circle_diagram(found, layout.circle, lang)]
    panel = Panel(centre_figure(OnPaper(found, layout.window, room)), layout.window, room)
    return Page(layout.paper, [panel], machine, found.plot.facts.values, lang, Strip(layout.strip), base)


def _divider(layout: CentreLayout) -> Stroke:
    """A thin line between figure and circle diagram."""
    room, corner = layout.circle, complex(layout.circle.left, layout.circle.top)
    other = complex(room.left, room.bottom) if layout.paper.landscape else complex(room.right, room.top)
    return Stroke((corner, other), "thin")
