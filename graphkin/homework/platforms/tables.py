"""Numbers as platforms print them, and tables of them: CSV that no spreadsheet runs, and Excel workbooks.

Numbers are rounded once, as decimals, so that no format rounds again. In CSV a text that would be a formula gets an
apostrophe, and loses it when read; in a workbook texts are texts, whatever they begin with.
"""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from decimal import ROUND_HALF_UP, ROUND_UP, Decimal
from pathlib import Path
from xml.sax.saxutils import escape

from graphkin.errors import Where
from graphkin.homework.platforms.markup import OFFICE, clean, element, office_link, office_package, one_line, xml
from graphkin.submissions.documents import csv_cells

HUNDREDTH = Decimal("0.01")  # points are given in these
_FINER = 3  # a number is rounded to this many digits finer than its tolerance
_ALL = 12  # digits of a number without tolerance


def points(value: float) -> Decimal:
    """Points in hundredths, half a hundredth up."""
    return Decimal(repr(float(value))).quantize(HUNDREDTH, ROUND_HALF_UP)


def tolerated(tolerance: float) -> Decimal:
    """A tolerance in three digits, never less than it is."""
    if tolerance == 0:
        return Decimal(0)
    return _plain(Decimal(repr(float(tolerance))).quantize(_step(tolerance, _FINER - 1), ROUND_UP))


def rounded(number: float, tolerance: float) -> Decimal:
    """A number, off by less than a thousandth of its tolerance."""
    if number == 0:
        return Decimal(0)
    step = _step(tolerance, _FINER) if tolerance else _step(number, _ALL - 1)
    return _plain(Decimal(repr(float(number))).quantize(step, ROUND_HALF_UP))


def _step(size: float, digits: int) -> Decimal:
    """The unit of a number's digit that comes so many after its first."""
    return Decimal(1).scaleb(math.floor(math.log10(abs(size))) - digits)


def _plain(number: Decimal) -> Decimal:
    """Without zeros at its end, and without a sign of nothing."""
    return number.normalize() if number else Decimal(0)


def printed(number: Decimal) -> str:
    """`-1.25`, `3.2E-9`: as Moodle reads numbers; no plus before it, no power of a usual size."""
    number = _plain(number)
    if not number or -7 <= number.adjusted() < 15:
        return format(number, "f")
    return str(number).replace("E+", "E")


def exponentless(number: Decimal) -> str:
    """`0.0000025`: always in full."""
    return format(_plain(number), "f")


Cell = str | Decimal | int | None
BOM = "\ufeff"  # by this Excel knows UTF-8
_FORMULA = ("=", "+", "-", "@", "\t", "\r", "\n", "＝", "＋", "－", "＠")


def line(cells: Iterable[Cell]) -> str:
    """One row of a CSV file."""
    texts = (exponentless(Decimal(cell)) if isinstance(cell, Decimal | int) else harmless(cell or "") for cell in cells)
    row = io.StringIO()
    csv.writer(row, lineterminator="\r\n").writerow(texts)
    return row.getvalue()


def harmless(text: str) -> str:
    """A text that is no formula; apostrophes before one count as its own, so that it can be read back."""
    text = one_line(text)
    return "'" + text if text.lstrip("'").startswith(_FORMULA) else text


def unharmed(text: str) -> str:
    """The text that `harmless` was given."""
    return text[1:] if text.startswith("'") and text.lstrip("'").startswith(_FORMULA) else text


def read_table(path: Path) -> Iterator[list[str]]:
    """The rows of a CSV file as a spreadsheet may have saved it: UTF-8 or GBK; commas, semicolons or tabs."""
    with path.open("rb") as file:
        for _, row in csv_cells(file, Where(str(path))):
            yield [unharmed(clean(str(cell))) for cell in row]


# --- workbooks --------------------------------------------------------------------------------------------------------

_MAIN = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
_KIND = "application/vnd.openxmlformats-officedocument.spreadsheetml"
_WIDEST = 60  # letters of a column that are shown
_LONGEST = 32_767  # letters that a cell of Excel holds


def workbook_files(sheets: Mapping[str, Iterable[Iterable[Cell]]]) -> Iterator[tuple[str, bytes | Iterable[bytes]]]:
    """The files of the workbook: sheets by name, each whose head stays when it is moved."""
    paths = [f"worksheets/sheet{k}.xml" for k in range(1, len(sheets) + 1)]
    parts = [("/xl/workbook.xml", f"{_KIND}.sheet.main+xml")]
    parts += [(f"/xl/{path}", f"{_KIND}.worksheet+xml") for path in paths]
    yield from office_package(parts, "xl/workbook.xml")
    names = (element("sheet", name=name, sheetId=f"{k}", **{"r:id": f"rId{k}"}) for k, name in enumerate(sheets, 1))
    yield "xl/workbook.xml", xml(element("workbook", element("sheets", *names), xmlns=_MAIN, **{"xmlns:r": OFFICE}))
    yield "xl/_rels/workbook.xml.rels", office_link("worksheet", *paths)
    for path, rows in zip(paths, sheets.values(), strict=True):
        yield f"xl/{path}", _sheet([[*row] for row in rows])


def _sheet(rows: Sequence[Sequence[Cell]]) -> Iterator[bytes]:
    yield f'<?xml version="1.0" encoding="UTF-8"?>\n<worksheet xmlns="{_MAIN}">'.encode()
    if len(rows) > 1:
        texts = [[one_line(str(row[k])) for row in rows if k < len(row)] for k in range(len(rows[0]))]
        widths = (min(_WIDEST, 2 + max(len(text) + sum(letter > "\u2e7f" for letter in text) for text in column))
                  for column in texts)  # fmt: skip
        yield (
            '<sheetViews><sheetView workbookViewId="0"><pane ySplit="1" topLeftCell="A2" state="frozen"/></sheetView>'
            "</sheetViews><cols>"
            + "".join(f'<col min="{k}" max="{k}" width="{wide}" customWidth="1"/>' for k, wide in enumerate(widths, 1))
            + "</cols>"
        ).encode()
    yield b"<sheetData>"
    for number, row in enumerate(rows, 1):
        yield f'<row r="{number}">{"".join(_cell(cell, k, number) for k, cell in enumerate(row))}</row>'.encode()
    yield b"</sheetData></worksheet>\n"


def _cell(cell: Cell, column: int, row: int) -> str:
    letters = ""  # A, B, .. Z, AA, ..
    while column >= 0:
        letters, column = chr(65 + column % 26) + letters, column // 26 - 1
    place = f"{letters}{row}"
    if cell is None or cell == "":
        return ""
    if isinstance(cell, str):
        text = escape(clean(cell)[:_LONGEST])
        return f'<c r="{place}" t="inlineStr"><is><t xml:space="preserve">{text}</t></is></c>'
    return f'<c r="{place}"><v>{exponentless(Decimal(cell))}</v></c>'
