"""The results of a marking, read from graphkin's own file of marks."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from graphkin.errors import NoFile, NotAResult, Unreadable, Where
from graphkin.homework.platforms.result import Result, from_record
from graphkin.marking.diagnosis import Trace
from graphkin.outputs.marks_file import END, HEAD, record_of, records_in


def read_results(path: Path) -> tuple[Result, ...]:
    """The results in a file of marks: after its head, a record a line. Raises NoFile, Unreadable, NotAResult."""
    with _refused(path):
        text = path.read_text(encoding="utf-8")
    head, begins, rest = text.partition(HEAD)
    if head or not begins:
        raise NotAResult(Where(str(path), 1), text[:80])
    records, ends, _ = rest.rpartition(f"\n{END}")
    if not ends:
        raise NotAResult(Where(str(path)), END)
    lines = enumerate(records.split("\n")[1:], HEAD.count("\n") + 2)
    return tuple(_result(line, Where(str(path), number)) for number, line in lines)


def _result(line: str, where: Where) -> Result:
    record = record_of(line)
    if record is None:
        raise NotAResult(where, "JSON")
    return from_record(record, where)


def read_traces(path: Path) -> dict[str, Trace]:
    """What a file of marks says of each student's mistakes. Raises NoFile, Unreadable, NotAResult."""
    traces: dict[str, Trace] = {}
    with _refused(path):
        for number, record in records_in(path):
            try:
                if record is not None and record["status"] == "marked":
                    traces[record["student"]] = _trace(record)
            except (ValueError, KeyError, TypeError, AttributeError):
                raise NotAResult(Where(str(path), number), "evidence") from None
    return traces


def _trace(record: Mapping[str, Any]) -> Trace:
    named = dict.fromkeys(str(id) for one in record["mistakes"][:1] for id in one["ids"])
    return Trace(tuple(named), {str(id): float(weight) for id, weight in record["evidence"].items()})


@contextmanager
def _refused(path: Path) -> Iterator[None]:
    """What is wrong with a file that cannot be read, in graphkin's words."""
    try:
        yield
    except FileNotFoundError:
        raise NoFile(Where(str(path)), path.name, ()) from None
    except (OSError, UnicodeDecodeError) as error:
        raise Unreadable(Where(str(path)), getattr(error, "strerror", None) or "UTF-8") from None
