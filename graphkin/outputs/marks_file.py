"""All records of a marking in one JSON file, written one after another so that a large class takes no memory."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from graphkin.outputs.files import beside
from graphkin.outputs.marks_json import FORMAT

KIND = "graphkin marks"
MARKS = [KIND.encode()]


def write(path: Path, records: Iterable[Mapping[str, Any]], force: bool = False) -> None:
    """A line for each record. Raises FileInTheWay, NoFolder, CannotWrite."""
    with beside(path, force, MARKS) as draft, draft.open("w", encoding="utf-8") as file:
        file.write(f'{{"kind": {text(KIND)}, "format": {FORMAT},\n"results": [')
        for k, record in enumerate(records):
            file.write((",\n" if k else "\n") + text(record))
        file.write("\n]}\n")


def text(value: object) -> str:
    """A record as it stands in its line."""
    return json.dumps(value, ensure_ascii=False, allow_nan=False)
