"""The family of four-link linkages on one sheet: a sketch of each kind with its name, each at a scale of its own."""

from __future__ import annotations

from dataclasses import replace

from graphkin.errors import Lang
from graphkin.say.linkages import kind_name, titled
from graphkin.sheet.layout import papers_for
from graphkin.sheet.lettering import plain, width
from graphkin.sheet.linkage_figure import drawn_over, pictured
from graphkin.sheet.marks import Mark, Text
from graphkin.sheet.page import Page, Sheet
from graphkin.sheet.paper import TITLE, Paper
from graphkin.sheet.single_figure import Caption, Picture
from graphkin.sheet.titleblock import frame
from graphkin.studies.linkages import FAMILY, report
from graphkin.studies.linkages.family import Member

_COLUMNS = 4
_HEAD, _FOOT = 10.0, 13.0
"""Room for the title, and for the name under each sketch [mm]."""
_TITLE: dict[Lang, str] = {"en": "Linkages of four links", "zh": "平面四杆机构的类型"}


def family_sheet(lang: Lang = "en", *, paper: str | None = None) -> Sheet:
    """Every kind once. Raises UnknownPaper."""
    chosen = papers_for(paper or "A4-landscape")[0]
    cells = chosen.frame.inset(0, _HEAD, 0).cells(len(FAMILY), _COLUMNS)
    pictures = [_picture(member, lang) for member in FAMILY]
    panels = [replace(one.panel(cell, one.scale(cell)), plane=None) for one, cell in zip(pictures, cells)]
    machine = replace(titled(FAMILY[0].linkage), name="linkages", file="linkages.toml", text="")
    drivers = [driver.value or 0.0 for driver in machine.drivers]
    base = [frame(chosen), _headline(chosen, lang)]
    return Page(chosen, panels, machine, drivers, lang, base=base, title=_TITLE[lang]).sheet()


def _headline(paper: Paper, lang: Lang) -> Mark:
    title, room = plain(_TITLE[lang]), paper.frame
    return Text(title, complex(room.middle.real - width(title, TITLE) / 2, room.top + 7.0), TITLE)


def _picture(member: Member, lang: Lang) -> Picture:
    """A sketch of one, and its name."""
    linkage = member.linkage
    caption = Caption((kind_name(report(linkage), lang),), _FOOT)
    return pictured([linkage.drawn], lambda window: drawn_over(linkage, [linkage.drawn], window), caption)
