"""A table as an Excel workbook: texts are texts, whatever they begin with; numbers are numbers. Row by row."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from decimal import Decimal
from xml.sax.saxutils import escape

from graphkin.homework.platforms.cells import Cell
from graphkin.homework.platforms.marked_up import clean, element, xml
from graphkin.homework.platforms.numbers import exponentless

_MAIN = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
_OFFICE = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
_LINKS = "http://schemas.openxmlformats.org/package/2006/relationships"
_TYPES = "http://schemas.openxmlformats.org/package/2006/content-types"
_KIND = "application/vnd.openxmlformats-officedocument.spreadsheetml"
_LONGEST = 32_767
"""Letters that a cell of Excel holds."""


def members(rows: Iterable[Iterable[Cell]], name: str) -> Iterator[tuple[str, bytes | Iterable[bytes]]]:
    """The files of the workbook. name: of its one sheet."""
    kinds = (("rels", "application/vnd.openxmlformats-package.relationships+xml"), ("xml", "application/xml"))
    parts = (("/xl/workbook.xml", f"{_KIND}.sheet.main+xml"), ("/xl/worksheets/sheet1.xml", f"{_KIND}.worksheet+xml"))
    yield "[Content_Types].xml", xml(element(
        "Types", *(element("Default", Extension=end, ContentType=kind) for end, kind in kinds),
        *(element("Override", PartName=part, ContentType=kind) for part, kind in parts), xmlns=_TYPES,
    ))  # fmt: skip
    yield "_rels/.rels", _link("officeDocument", "xl/workbook.xml")
    sheet = element("sheet", name=name, sheetId="1", **{"r:id": "rId1"})
    yield "xl/workbook.xml", xml(element("workbook", element("sheets", sheet), xmlns=_MAIN, **{"xmlns:r": _OFFICE}))
    yield "xl/_rels/workbook.xml.rels", _link("worksheet", "worksheets/sheet1.xml")
    yield "xl/worksheets/sheet1.xml", _sheet(rows)


def _link(kind: str, target: str) -> bytes:
    link = element("Relationship", Id="rId1", Type=f"{_OFFICE}/{kind}", Target=target)
    return xml(element("Relationships", link, xmlns=_LINKS))


def _sheet(rows: Iterable[Iterable[Cell]]) -> Iterator[bytes]:
    yield f'<?xml version="1.0" encoding="UTF-8"?>\n<worksheet xmlns="{_MAIN}"><sheetData>'.encode()
    for number, row in enumerate(rows, 1):
        yield f'<row r="{number}">{"".join(_cell(cell, k, number) for k, cell in enumerate(row))}</row>'.encode()
    yield b"</sheetData></worksheet>\n"


def _cell(cell: Cell, column: int, row: int) -> str:
    place = f"{_letters(column)}{row}"
    if cell is None or cell == "":
        return ""
    if isinstance(cell, str):
        text = escape(clean(cell)[:_LONGEST])
        return f'<c r="{place}" t="inlineStr"><is><t xml:space="preserve">{text}</t></is></c>'
    return f'<c r="{place}"><v>{exponentless(Decimal(cell))}</v></c>'


def _letters(column: int) -> str:
    """A, B, .. Z, AA, .."""
    found = ""
    while column >= 0:
        found, column = chr(65 + column % 26) + found, column // 26 - 1
    return found
