"""The family of four-link linkages on one sheet: a sketch of each kind with its name, each at a scale of its own."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from graphkin.errors import Lang
from graphkin.linkages import FAMILY, report
from graphkin.linkages.family import Member
from graphkin.say.linkages import kind_name, titled
from graphkin.sheet import Sheet
from graphkin.sheet.labels import Room
from graphkin.sheet.layout import papers_for
from graphkin.sheet.lettering import plain, width
from graphkin.sheet.linkage_figure import drawn_over
from graphkin.sheet.linkage_panel import Panel
from graphkin.sheet.marks import Mark, Stroke, Text
from graphkin.sheet.paper import TITLE, Paper

_COLUMNS = 4
_HEAD, _FOOT = 10.0, 13.0
"""Room for the title, and for the name under each sketch [mm]."""
_TITLE: dict[Lang, str] = {"en": "Linkages of four links", "zh": "平面四杆机构的类型"}


def family_sheet(lang: Lang = "en", *, paper: str | None = None) -> Sheet:
    """Every kind once. Raises UnknownPaper."""
    chosen = papers_for(paper or "A4-landscape")[0]
    marks: list[Mark] = list(_frame(chosen, lang))
    for member, cell in zip(FAMILY, _cells(chosen)):
        panel = _panel(member, lang)
        marks += panel.drawn(cell, panel.scale(cell))
    machine = replace(titled(FAMILY[0].linkage), name="linkages", file="linkages.toml")
    drivers = tuple(float(driver.value or 0.0) for driver in machine.drivers)
    return Sheet(chosen, tuple(marks), {}, {}, machine, drivers, _TITLE[lang], lang)


def _frame(paper: Paper, lang: Lang) -> Iterator[Mark]:
    left = top = paper.margin
    right, foot = paper.width - left, paper.height - top
    corners = (complex(left, top), complex(right, top), complex(right, foot), complex(left, foot))
    yield Stroke(corners, "outline", closed=True)
    title = plain(_TITLE[lang])
    yield Text(title, complex((left + right - width(title, TITLE)) / 2, top + 7.0), TITLE)


def _cells(paper: Paper) -> Iterator[Room]:
    rows = -(-len(FAMILY) // _COLUMNS)
    wide = (paper.width - 2 * paper.margin) / _COLUMNS
    high = (paper.height - 2 * paper.margin - _HEAD) / rows
    for k in range(len(FAMILY)):
        left, top = paper.margin + k % _COLUMNS * wide, paper.margin + _HEAD + k // _COLUMNS * high
        yield Room(left, top, left + wide, top + high)


def _panel(member: Member, lang: Lang) -> Panel:
    """A sketch of one, and its name."""
    linkage = member.linkage
    name = kind_name(report(linkage), lang)
    return Panel((linkage.drawn,), lambda window: drawn_over(linkage, [linkage.drawn], window), (name,), _FOOT)
