"""Numbers in documents: tables and lines of a Word file, lines of a PDF. A figure or a formula in them is not read."""

from __future__ import annotations

import io
import re
from collections.abc import Iterator, Sequence
from itertools import islice
from typing import Any

from graphkin.errors import BrokenSubmission, GraphkinError, NoAnswers, NoNumbers, WantsExtra, Where
from graphkin.submissions.archives import checked_zip
from graphkin.submissions.documents import StudentDocument, of_one, read_text
from graphkin.submissions.numbers import plain, plane_named
from graphkin.submissions.questions import begins_like_one
from graphkin.submissions.students import FIELDS
from graphkin.submissions.submission import Limits

_PAGES = 40  # of a PDF that are looked at
_NUMBER = re.compile(r"[-+−–±]?\s*[0-9]")
_WIDE = re.compile(rf"\t|\s{{3,}}|[;；]|\s+(?=(?:{'|'.join(map(re.escape, FIELDS))})\s*[:：])", re.I)
"""Between things that stand beside each other in a line; a head of whose it is begins one."""
_SYMBOL = re.compile(r"[^\W\d_]+")


def read_docx(content: bytes, where: Where, limits: Limits) -> StudentDocument:
    """Raises WantsExtra, BrokenSubmission, TooMuch, SeveralStudents, NoNumbers."""
    try:
        from docx import Document
    except ImportError:
        raise WantsExtra(where, "DOCX", "graphkin[word]") from None
    checked_zip(content, where, limits)
    try:
        body = Document(io.BytesIO(content)).element.body
        lines = [_text(each) for each in body.iter(f"{_W}p") if next(each.iterancestors(f"{_W}tc"), None) is None]
        tables = [
            [[_text(cell) for cell in row.iterchildren(f"{_W}tc")] for row in table.iter(f"{_W}tr")]
            for table in body.iter(f"{_W}tbl")
        ]
    except (MemoryError, RecursionError):
        raise
    except Exception as problem:  # python-docx raises whatever it meets in a file that is none
        raise BrokenSubmission(where, "DOCX", type(problem).__name__) from None
    return _joined([*_of_tables(tables, where, limits), _of_lines(lines, where, limits)], "DOCX", where)


_W = "{http://schemas.openxmlformats.org/wordprocessingml/2006/main}"
_BREAKS = {f"{_W}tab": "\t", f"{_W}br": "\n"}


def _text(element: Any) -> str:
    """A paragraph's or a cell's, formulas with it, which are text of another name: `a` `B3B2` `k`."""
    parts = (_BREAKS.get(each.tag) or (each.text if str(each.tag).endswith("}t") else "") for each in element.iter())
    return "".join(part or "" for part in parts).strip()


def _of_tables(
    tables: Sequence[Sequence[Sequence[str]]], where: Where, limits: Limits
) -> Iterator[StudentDocument]:
    for table in tables:
        try:
            yield of_one(enumerate(table, 1), where, limits)
        except NoAnswers:
            continue


def read_pdf(content: bytes, where: Where, limits: Limits) -> StudentDocument:
    """Raises WantsExtra, BrokenSubmission, TooMuch, NoNumbers."""
    try:
        from pypdf import PdfReader
    except ImportError:
        raise WantsExtra(where, "PDF", "graphkin[word]") from None
    try:
        pages = [page.extract_text() for page in islice(PdfReader(io.BytesIO(content)).pages, _PAGES)]
    except (MemoryError, RecursionError, GraphkinError):
        raise
    except Exception as problem:  # pypdf raises whatever it meets in a file that is none
        raise BrokenSubmission(where, "PDF", type(problem).__name__) from None
    lines = [line for page in pages for line in page.splitlines()]
    rows = (cells for line in lines if (cells := _cells(line)) is not None)
    return _joined([*_of_tables([[*rows]], where, limits), _of_lines(lines, where, limits)], "PDF", where)


def _cells(line: str) -> list[str] | None:
    """`ω2 3.92 rad/s`, a row of a table as a PDF has it: what is asked, and what is answered; None of other lines."""
    words = plain(line).split()
    at = next((k for k, word in enumerate(words) if k and _NUMBER.match(word)), 0)
    if at == 1 and _SYMBOL.fullmatch(words[0]) and len(words) > 2 and _NUMBER.match(words[2]):
        at = 2  # ω 3 3.92
    name = " ".join(words[:at])
    return [name, " ".join(words[at:])] if at and begins_like_one(name) and "=" not in name else None


def _of_lines(lines: Sequence[str], where: Where, limits: Limits) -> StudentDocument:
    """Those of `ω3 = 3.92`, and of whose it is; a text has others, too."""
    parts = [part.strip() for line in lines for part in _WIDE.split(line)]
    document = read_text("\n".join(part for part in parts if part), where, limits)
    entries = (entry for entry in document.entries if begins_like_one(entry[0]) or plane_named(entry[0]) is not None)
    return StudentDocument(document.called, tuple(entries))


def _joined(documents: Sequence[StudentDocument], kind: str, where: Where) -> StudentDocument:
    entries = tuple(entry for document in documents for entry in document.entries)
    if not any(begins_like_one(name) for name, _, _ in entries):
        raise NoNumbers(where, kind)
    return StudentDocument(tuple(text for document in documents for text in document.called), entries)


READERS = {".docx": read_docx, ".pdf": read_pdf}
