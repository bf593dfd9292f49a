"""The family of four-link linkages on one sheet: a sketch of each kind with its name. Each in a size of its own."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from graphkin.errors import Lang
from graphkin.linkages import FAMILY, Linkage, report
from graphkin.linkages.family import Member
from graphkin.sheet import Sheet
from graphkin.sheet.labels import Room, settle
from graphkin.sheet.layout import papers_for
from graphkin.sheet.lettering import plain, width
from graphkin.sheet.linkage_figure import drawn_over
from graphkin.sheet.marks import Mark, Stroke, Text
from graphkin.sheet.obstacles import bounds
from graphkin.sheet.paper import BODY, TITLE, Paper
from graphkin.sheet.titleblock import broken
from graphkin.sheet.window import Figure, Window
from graphkin.words.linkages import kind_name, titled

__all__ = ["family_sheet"]

_COLUMNS = 4
_HEAD, _FOOT = 10.0, 13.0
"""Room for the title, and for the name under each sketch [mm]."""
_LETTERS = 6.0
_TITLE: dict[Lang, str] = {"en": "Linkages of four links", "zh": "平面四杆机构的类型"}


def family_sheet(lang: Lang = "en", *, paper: str | None = None) -> Sheet:
    """Every kind once. Raises UnknownPaper."""
    chosen = papers_for(paper or "A4-landscape")[0]
    marks: list[Mark] = list(_frame(chosen, lang))
    for member, cell in zip(FAMILY, _cells(chosen)):
        marks += _cell(member, cell, lang)
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


def _figure(linkage: Linkage, window: Window) -> Figure:
    return drawn_over(linkage, [linkage.drawn], window)


def _cell(member: Member, cell: Room, lang: Lang) -> list[Mark]:
    """The sketch as large as its cell lets it be, in the middle, and its name."""
    room = complex(cell.right - cell.left - 2 * _LETTERS, cell.bottom - cell.top - _FOOT - 2 * _LETTERS)
    scale = 0.0005
    left, top, right, bottom = bounds(_figure(member.linkage, Window(0j, scale)).marks)
    while right - left > room.real or bottom - top > room.imag:
        scale *= 1.1
        left, top, right, bottom = bounds(_figure(member.linkage, Window(0j, scale)).marks)
    middle = complex(cell.left + cell.right, cell.top + cell.bottom - _FOOT) / 2
    figure = _figure(member.linkage, Window(middle - complex(left + right, top + bottom) / 2, scale))
    inner = Room(cell.left + 1, cell.top + 1, cell.right - 1, cell.bottom - _FOOT)
    marks = [*figure.marks, *settle(figure.wanted, figure.marks, inner).marks]
    pen = cell.bottom - _FOOT + 5.0
    for line in broken(kind_name(report(member.linkage), lang), BODY, cell.right - cell.left - 4):
        label = plain(line)
        marks.append(Text(label, complex((cell.left + cell.right - width(label, BODY)) / 2, pen), BODY))
        pen += 1.3 * BODY
    return marks
