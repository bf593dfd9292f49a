"""Answers in TOML, JSON or lines of text: one student's, or a JSON list of students."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from typing import Any

from graphkin.base.value import frozen
from graphkin.errors import BrokenSubmission, GraphkinError, NoAnswers, TooMuch, Where
from graphkin.files.toml import parsed
from graphkin.submissions.answers import Entry
from graphkin.submissions.spelling import short
from graphkin.submissions.submission import Limits
from graphkin.submissions.tables import student_of

_DEEP = re.compile(r"""(?<![\w-])(?:(?:[\w-]++|"[^"\n]*+"|'[^'\n]*+')[ \t]*+\.[ \t]*+){32}""")
_KEY = re.compile(r"""\s*(?:["“”„]([^"“”„]*)["“”„]|'([^']*)'|([^=＝≈:：\s"'“”„][^=＝≈:：]*?))\s*[=＝≈:：]""")
"""Quotes are those that word processors make of plain ones, too; an equals sign may be as wide as a Chinese letter."""
_HEADER = re.compile(r"\s*\[\s*([^\[\]]+?)\s*\]\s*")
_TABLES = ("answers", "answer", "values", "results", "答案")
_SCALES = ("scales", "scale", "比例尺")


@frozen
class StudentDocument:
    """A student's id as stated ("" where none is) and what is answered."""

    student: str
    entries: tuple[Entry, ...]


def read_toml(text: str, where: Where, limits: Limits) -> StudentDocument:
    """Raises BrokenSubmission, TooMuch, NoAnswers."""
    text = text.removeprefix("\ufeff")
    if _DEEP.search(text) is not None:
        raise TooMuch(where, "depth", limits.depth)
    try:
        document = parsed(text)
    except RecursionError:
        raise TooMuch(where, "depth", limits.depth) from None
    except ValueError as problem:
        if _is_filled_form(text):
            return read_lines(text, where, limits)
        raise BrokenSubmission(where, "TOML", str(problem)[:120]) from None
    return _document(document, where, _lines(text))


def _is_filled_form(text: str) -> bool:
    """Whether all of it is headings and `name = ..`, some left open or without quotes, as people fill in a form."""
    lines = [line for line in text.splitlines() if line.strip() and not line.lstrip().startswith("#")]
    return bool(lines) and all(_HEADER.fullmatch(line[:60]) or _KEY.match(line[:400]) for line in lines)


def read_json(text: str, where: Where, limits: Limits) -> StudentDocument:
    """Raises BrokenSubmission, TooMuch, NoAnswers."""
    return _document(_json(text, where, limits), where, {})


def listed(text: str, where: Where, limits: Limits) -> list[StudentDocument] | None:
    """The students of a class in one JSON file; None for a file of one student's."""
    document = _json(text, where, limits)
    if not isinstance(document, list) or not all(isinstance(entry, dict) for entry in document):
        return None
    if len(document) > limits.rows:
        raise TooMuch(where, "rows", limits.rows)
    found = []
    for entry in document:
        try:
            found.append(_document(entry, where, {}))
        except GraphkinError:
            found.append(StudentDocument("", ()))
    return found


def read_lines(text: str, where: Where, limits: Limits) -> StudentDocument:
    """`omega 3 = 3.92` line by line, as in a message. Raises NoAnswers, TooMuch."""
    student, entries, table = "", list[Entry](), ""
    for number, line in enumerate(text.splitlines(), 1):
        if (header := _HEADER.fullmatch(line[:60])) is not None:
            table = "scales." if header[1] in _SCALES else ""
        key = _KEY.match(line[:400])
        if key is None:
            continue
        name, value = next(part for part in key.groups() if part is not None), line[key.end() :].strip(" \t\"'“”„")
        if student_of(name):
            student = value[:200]
        else:
            entries.append((table + name, value, Where(where.file, number, short(name))))
        if len(entries) > limits.answers:
            raise TooMuch(where, "answers", limits.answers)
    return _filled(StudentDocument(student, tuple(entries)), where)


def _json(text: str, where: Where, limits: Limits) -> Any:
    try:
        return json.loads(text.removeprefix("\ufeff"))
    except RecursionError:
        raise TooMuch(where, "depth", limits.depth) from None
    except ValueError as problem:
        raise BrokenSubmission(where, "JSON", str(problem)[:120]) from None


def _document(document: object, where: Where, lines: Mapping[str, int]) -> StudentDocument:
    if not isinstance(document, dict):
        raise NoAnswers(where)
    student = next((value for key, value in document.items() if student_of(key)), "")
    entries = tuple(
        (name, value, Where(where.file, lines.get(name), f"{table}{short(name)}"))
        for table, name, value in _named(document)
    )
    named = str(student) if isinstance(student, str | int) and not isinstance(student, bool) else ""
    return _filled(StudentDocument(named[:200], entries), where)


def _named(document: Mapping[str, Any]) -> Iterator[tuple[str, str, object]]:
    """Answers in their table or at the top, scales in theirs."""
    for key, value in document.items():
        if key in _SCALES and isinstance(value, dict):
            yield from (("", f"scales.{plane}", size) for plane, size in value.items())
        elif key in _TABLES and isinstance(value, dict):
            yield from ((f"{key}.", name, given) for name, given in value.items())
        elif not student_of(key):
            yield "", key, value


def _filled(document: StudentDocument, where: Where) -> StudentDocument:
    if not document.entries:
        raise NoAnswers(where)
    return document


def _lines(text: str) -> dict[str, int]:
    """The line of each key as far as plain sight tells."""
    found: dict[str, int] = {}
    for number, line in enumerate(text.splitlines(), 1):
        if (key := _KEY.match(line[:400])) is not None:
            found.setdefault(next(part for part in key.groups() if part is not None), number)
    return found
