"""All records of a marking in one JSON file, written one after another so that a large class takes no memory."""

from __future__ import annotations

import json
from collections.abc import Iterable
from pathlib import Path

from graphkin.errors import Lang
from graphkin.marking.graded import Graded
from graphkin.outputs.files import beside
from graphkin.outputs.marks_json import FORMAT, record

KIND = "graphkin marks"


def write(path: Path, records: Iterable[Graded], lang: Lang, force: bool = False) -> None:
    """A line for each submission. Raises FileInTheWay, NoFolder, CannotWrite."""
    with beside(path, force, [KIND.encode()]) as draft, draft.open("w", encoding="utf-8") as file:
        file.write(f'{{"kind": {_text(KIND)}, "format": {FORMAT},\n"results": [')
        for k, graded in enumerate(records):
            file.write((",\n" if k else "\n") + _text(record(graded, lang)))
        file.write("\n]}\n")


def _text(value: object) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False)
