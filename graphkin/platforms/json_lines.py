"""Results as graphkin keeps them: a JSON object a line, from which every other format is made."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

from graphkin.errors import NoFile, Unreadable, Where
from graphkin.platforms.complaints import NotAResult
from graphkin.platforms.result import Result, from_record, to_record

__all__ = ["Stored", "line"]


def line(result: Result) -> str:
    """One result on a line of its own, for those, too, that end lines as Unicode does."""
    return json.dumps(to_record(result), ensure_ascii=True, allow_nan=False) + "\n"


class Stored:
    """The results in a file, read again each time they are gone through. Raises NoFile, Unreadable, NotAResult."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def __iter__(self) -> Iterator[Result]:
        try:
            with self.path.open(encoding="utf-8") as file:
                for number, text in enumerate(file, 1):
                    if text.strip():
                        yield _result(text, Where(str(self.path), number))
        except FileNotFoundError:
            raise NoFile(Where(str(self.path)), self.path.name, ()) from None
        except (OSError, UnicodeDecodeError) as error:
            raise Unreadable(Where(str(self.path)), getattr(error, "strerror", None) or "UTF-8") from None


def _result(text: str, where: Where) -> Result:
    try:
        record = json.loads(text)
    except (ValueError, RecursionError):
        raise NotAResult(where, "JSON") from None
    if not isinstance(record, dict):
        raise NotAResult(where, type(record).__name__)
    return from_record(record, where)
