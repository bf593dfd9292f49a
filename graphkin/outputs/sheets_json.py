"""Printed sheets as JSON, which of them are to be photographed, and what was measured on photographs, to be looked at,
corrected, and marked without any picture. Version 1; on paper mm from the left upper corner, y down, points of a
drawing mm from the pole, y up."""

from __future__ import annotations

import contextlib
import json
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

from graphkin.base.plain import Plain, built, plain
from graphkin.errors import NoSheetList, Where
from graphkin.outputs import files
from graphkin.photo.readings import SheetReading
from graphkin.photo.sheets import PrintedSheet

SHEETS, READINGS, FORMAT = "graphkin sheets", "graphkin readings", 1
NAME = "sheets.json"  # in a folder; beside NAME.pdf it is NAME.sheets.json
MARKS = (SHEETS.encode(),)
_GLANCE = 200


def write_sheets(path: Path, sheets: Iterable[PrintedSheet], force: bool = False) -> None:
    """The file with these sheets, and those that it has: they are on paper. Raises FileInTheWay, CannotWrite; where it
    is not whole any more, and is not to be replaced, NoSheetList."""
    files.refuse(path, force, MARKS)
    before = list[PrintedSheet]()
    with contextlib.suppress(*[NoSheetList] if force else []):
        before = read_sheets(path) if path.is_file() else []
    known = {sheet.number: sheet for sheet in (*before, *sheets)}
    lines = (json.dumps(plain(sheet), ensure_ascii=False) for _, sheet in sorted(known.items()))
    head = f'{{"kind": "{SHEETS}", "format": {FORMAT}, "list": [\n'
    files.write(path, head + ",\n".join(lines) + "\n]}\n", force, MARKS)


def read_sheets(path: Path) -> list[PrintedSheet]:
    """The sheets of a file. Raises NoSheetList, OSError."""
    return _read(path, SHEETS, PrintedSheet)


def is_readings(path: Path) -> bool:
    """True where a file says that it holds what was measured."""
    try:
        with path.open("rb") as file:
            return f'"{READINGS}"'.encode() in file.read(_GLANCE)
    except (OSError, ValueError):
        return False


def readings_data(readings: Sequence[SheetReading]) -> dict[str, Plain]:
    """All of a file of readings."""
    return {"kind": READINGS, "format": FORMAT, "list": plain(readings)}


def read_readings(path: Path) -> list[SheetReading]:
    """The readings of a file. Raises NoSheetList, OSError."""
    return _read(path, READINGS, SheetReading)


def _read(path: Path, kind: str, each: Any) -> list[Any]:
    try:
        data = json.loads(path.read_text("utf-8-sig"))
        if data["kind"] != kind or data["format"] != FORMAT:
            raise ValueError(data["kind"])
        return [built(each, one) for one in data["list"]]
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        raise NoSheetList(Where(str(path))) from None
