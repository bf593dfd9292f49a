"""The results of a marking, read from graphkin's own file of marks one after another, as often as they are wanted."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any, TextIO

from graphkin.errors import NoFile, NotAResult, Unreadable, Where
from graphkin.outputs.marks_file import KIND
from graphkin.platforms.result import FORMAT, Result, from_record

_BEGIN, _END = '"results": [', "]}"


class Stored:
    """The results in a file of marks: after its head, a record a line.

    Going through them raises NoFile, Unreadable, NotAResult.
    """

    def __init__(self, path: Path) -> None:
        self.path = path

    def __iter__(self) -> Iterator[Result]:
        try:
            with self.path.open(encoding="utf-8") as file:
                yield from self._results(file)
        except FileNotFoundError:
            raise NoFile(Where(str(self.path)), self.path.name, ()) from None
        except (OSError, UnicodeDecodeError) as error:
            raise Unreadable(Where(str(self.path)), getattr(error, "strerror", None) or "UTF-8") from None

    def _results(self, file: TextIO) -> Iterator[Result]:
        lines = enumerate(file, 1)
        self._head(lines)
        for number, text in lines:
            text = text.strip().removesuffix(",")
            if text == _END:
                return
            yield from_record(self._data(text, number), Where(str(self.path), number))
        raise NotAResult(Where(str(self.path)), _END)

    def _head(self, lines: Iterator[tuple[int, str]]) -> None:
        """What comes before the records: that they are some, and of this version."""
        head = ""
        for number, text in lines:
            if text.strip() == _BEGIN:
                data = self._data(head + '"end": 0}', number)
                if data.get("kind") != KIND or data.get("format") != FORMAT:
                    raise NotAResult(Where(str(self.path), 1), f"{data.get('kind')!r} {data.get('format')!r}")
                return
            head += text
        raise NotAResult(Where(str(self.path)), _BEGIN)

    def _data(self, text: str, number: int) -> dict[str, Any]:
        try:
            data = json.loads(text)
        except (ValueError, RecursionError):
            raise NotAResult(Where(str(self.path), number), "JSON") from None
        if not isinstance(data, dict):
            raise NotAResult(Where(str(self.path), number), type(data).__name__)
        return data
