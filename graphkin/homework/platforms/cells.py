"""Tables as CSV that no spreadsheet runs: a text that would be a formula gets an apostrophe, and loses it when read."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Iterator, Sequence
from decimal import Decimal
from pathlib import Path

from graphkin.homework.platforms.marked_up import clean, one_line
from graphkin.homework.platforms.numbers import exponentless

Cell = str | Decimal | int | None
BOM = "\ufeff"
"""By this Excel knows UTF-8."""
_FORMULA = ("=", "+", "-", "@", "\t", "\r", "\n", "＝", "＋", "－", "＠")
_SEPARATORS = ",;\t"


def line(cells: Iterable[Cell]) -> str:
    """One row of a CSV file."""
    written = io.StringIO()
    csv.writer(written, lineterminator="\r\n").writerow([_written(cell) for cell in cells])
    return written.getvalue()


def write_lines(path: Path, lines: Iterable[str]) -> None:
    """Lines, with their ends, into a file."""
    with path.open("w", encoding="utf-8", newline="") as file:
        file.writelines(lines)


def _written(cell: Cell) -> str:
    if cell is None:
        return ""
    if isinstance(cell, str):
        return harmless(cell)
    return exponentless(Decimal(cell))


def harmless(text: str) -> str:
    """A text that is no formula; apostrophes before one count as its own, so that it can be read back."""
    text = one_line(text)
    return "'" + text if text.lstrip("'").startswith(_FORMULA) else text


def unharmed(text: str) -> str:
    """The text that `harmless` was given."""
    return text[1:] if text.startswith("'") and text.lstrip("'").startswith(_FORMULA) else text


def read_table(path: Path) -> Iterator[list[str]]:
    """The rows of a CSV file as a spreadsheet may have saved it: UTF-8 or GBK; commas, semicolons or tabs."""
    with path.open(encoding=_encoding(path), errors="replace", newline="") as file:
        head = file.readline()
        file.seek(0)
        for row in csv.reader(file, delimiter=max(_SEPARATORS, key=head.count)):
            yield [unharmed(clean(cell)) for cell in row]


def _encoding(path: Path) -> str:
    """The first in which all of a file can be read."""
    for encoding in ("utf-8-sig", "gb18030"):
        try:
            with path.open(encoding=encoding, newline="") as file:
                while file.read(1 << 16):
                    pass
        except UnicodeDecodeError:
            continue
        return encoding
    return "utf-8-sig"


def columns_of(head: Sequence[str]) -> dict[str, int]:
    """Where each column is, by its header; the first of several."""
    return {name.strip(): k for k, name in reversed(list(enumerate(head)))}
