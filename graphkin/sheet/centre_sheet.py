"""The sheet of instant centres: the mechanism with its centres, the circle diagram, the table.

`centre_sheet` draws all, `centre_step_sheets` one step after the other.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from graphkin.centres import Centres
from graphkin.errors import Lang
from graphkin.sheet import Sheet
from graphkin.sheet.centre_circle import circle_diagram
from graphkin.sheet.centre_figure import centre_figure, split_names
from graphkin.sheet.centre_layout import CentreLayout, layouts
from graphkin.sheet.centre_places import OnPaper
from graphkin.sheet.labels import Room, settle
from graphkin.sheet.layout import HEAD
from graphkin.sheet.lettering import plain, width
from graphkin.sheet.marks import Mark, Stroke, Text
from graphkin.sheet.paper import LABEL
from graphkin.sheet.scales import written
from graphkin.sheet.titleblock import strip
from graphkin.sheet.window import Window
from graphkin.value import frozen

__all__ = ["centre_sheet", "centre_step_sheets"]

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
    drawn: list[_Drawn] = []
    for way in layouts(found, paper, lang, fit)[:_TRIES]:
        drawn.append(_lettered(found, way, lang))
        if drawn[-1].good:
            break
    best = min(drawn, key=lambda one: (one.lost, max(0, one.leaders - _CROWDED)))
    return _sheet(found, _drawn(found, best.layout, lang, far=True) if best.lost > _FEW else best, lang)


def centre_step_sheets(
    found: Centres, *, paper: str | None = None, lang: Lang = "en", fit: bool = False
) -> Iterator[Sheet]:
    """One sheet a centre, in the order in which they are found; what a step adds is emphasised."""
    whole = centre_sheet(found, paper=paper, lang=lang, fit=fit)
    for number in range(1, len(found.centring.stages) + 1):
        marks = (mark for mark in whole.marks if mark.step is None or mark.step <= number)
        yield replace(whole, marks=tuple(replace(m, new=True) if m.step == number else m for m in marks))


@frozen
class _Drawn:
    """A layout filled; how many labels found no place, and how many stand off."""

    layout: CentreLayout
    marks: list[Mark]
    lost: int
    leaders: int

    @property
    def good(self) -> bool:
        return not self.lost and self.leaders <= _CROWDED


def _lettered(found: Centres, layout: CentreLayout, lang: Lang) -> _Drawn:
    """The labels near what they name; where a few find no place, farther off."""
    near = _drawn(found, layout, lang)
    if not 0 < near.lost <= _FEW:
        return near
    return min(near, _drawn(found, layout, lang, far=True), key=lambda one: one.lost)


def _drawn(found: Centres, layout: CentreLayout, lang: Lang, far: bool = False) -> _Drawn:
    field = layout.field
    inner = Room(field.left + 2, field.top + HEAD, field.right - 2, field.bottom - 2)
    paper = OnPaper(found, Window(layout.origin, layout.scale), inner)
    figure = centre_figure(paper)
    settled = settle(figure.wanted, figure.marks, inner, far)
    machine = found.method.mechanism
    marks = strip(machine, [], layout.paper, layout.strip, {"position": layout.scale}, {}, lang)
    marks += layout.table.drawn(complex(layout.strip.left + 3, layout.strip.top + 1.5))
    marks += [*_heading(layout, lang), *_divider(layout), *circle_diagram(found, layout.circle, lang)]
    marks += [*figure.marks, *split_names(settled.marks, paper)]
    leaders = sum(isinstance(mark, Stroke) and mark.pen == "leader" for mark in settled.marks)
    return _Drawn(layout, marks, settled.clashes, leaders)


def _heading(layout: CentreLayout, lang: Lang) -> list[Mark]:
    label, at = plain(_HEADING[lang]), complex(layout.field.left + 3, layout.field.top + 5.5)
    scale = written("position", layout.scale)
    return [Text(label, at, LABEL), Text(scale, at + width(label, LABEL) + 4, LABEL)]


def _divider(layout: CentreLayout) -> Iterator[Mark]:
    """A thin line between figure and circle diagram."""
    room = layout.circle
    if layout.paper.landscape:
        yield Stroke((complex(room.left, room.top), complex(room.left, room.bottom)), "thin")
    else:
        yield Stroke((complex(room.left, room.top), complex(room.right, room.top)), "thin")


def _sheet(found: Centres, drawn: _Drawn, lang: Lang) -> Sheet:
    layout, machine = drawn.layout, found.method.mechanism
    return Sheet(
        paper=layout.paper,
        marks=tuple(drawn.marks),
        scales={"position": layout.scale},
        origins={"position": layout.origin},
        mechanism=machine,
        drivers=tuple(float(value) for value in found.plot.facts.values),
        title=machine.headline(lang),
        lang=lang,
    )
