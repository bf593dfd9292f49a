"""All records of a marking in one JSON file, a line each."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from graphkin.outputs.files import beside
from graphkin.outputs.marks_json import FORMAT

KIND = "graphkin marks"
MARKS = [KIND.encode()]
HEAD = f'{{"kind": "{KIND}", "format": {FORMAT},\n"results": ['
END = "]}"


def write(path: Path, records: Iterable[Mapping[str, Any]], force: bool = False) -> None:
    """A line for each record. Raises FileInTheWay, NoFolder, CannotWrite."""
    with beside(path, force, MARKS) as draft, draft.open("w", encoding="utf-8") as file:
        file.write(HEAD)
        for k, record in enumerate(records):
            file.write((",\n" if k else "\n") + text(record))
        file.write(f"\n{END}\n")


def text(value: object) -> str:
    """A record as it stands in its line."""
    return json.dumps(value, ensure_ascii=False, allow_nan=False)


def records_in(path: Path, errors: str = "strict") -> Iterator[tuple[int, Mapping[str, Any] | None]]:
    """The records of a file, each with the number of its line; None where a line is none any more.

    errors   what is done with bytes that are no UTF-8, as `open` has it
    """
    with path.open(encoding="utf-8", errors=errors) as file:
        for number, line in enumerate(file, 1):
            if line.startswith('{"format"'):
                yield number, record_of(line)


def record_of(line: str) -> Mapping[str, Any] | None:
    """The record in a line; None where there is none."""
    try:
        found = json.loads(line.strip().removesuffix(","))
    except (ValueError, RecursionError):
        return None
    return found if isinstance(found, dict) else None
