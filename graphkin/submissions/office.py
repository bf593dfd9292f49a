"""Numbers in documents: tables and lines of a Word file or a page of HTML, lines of a PDF. No figure is read."""

from __future__ import annotations

import io
import logging
import re
from collections.abc import Callable, Sequence
from functools import partial
from html import unescape
from itertools import islice
from typing import TYPE_CHECKING, Any

from graphkin.errors import NoNumbers, Where
from graphkin.submissions.answers import Entry
from graphkin.submissions.archives import checked_zip, decoded, foreign, opened
from graphkin.submissions.documents import StudentDocument, of_one, read_lines
from graphkin.submissions.numbers import plain, plane_named
from graphkin.submissions.pool import limited
from graphkin.submissions.questions import begins_like_one
from graphkin.submissions.students import FIELDS
from graphkin.submissions.submission import Limits

if TYPE_CHECKING:
    from pypdf import PdfReader

_PAGES = 40  # of a PDF that are looked at
_QUIET = logging.NullHandler()  # what is wrong with a broken file is said in words
_NUMBER = re.compile(r"[-+−–±]?\s*[0-9]")
_WIDE = re.compile(rf"\t|\s{{3,}}|[;；]|\s+(?=(?:{'|'.join(map(re.escape, FIELDS))})\s*[:：])", re.I)
"""Between things that stand beside each other in a line; a head of whose it is begins one."""
_SHORT = 12  # letters of a name
_SYMBOL = re.compile(r"[^\W\d_]+")


Parts = tuple[Sequence[Sequence[Sequence[str]]], Sequence[str]]  # tables, and the lines between them


def _read(
    kind: str, parts_of: Callable[[bytes, Where, Limits], Parts], content: bytes, where: Where, limits: Limits
) -> StudentDocument:
    """The answers in tables and in lines `ω3 = 3.92`, and whose they are; a document has other lines, too.

    Raises WantsExtra, BrokenSubmission, TooMuch, SeveralStudents, NoNumbers."""
    with foreign(where, kind, "graphkin[word]"):
        tables, lines = parts_of(content, where, limits)
    some = [of_one(enumerate(table, 1), where, limits) for table in tables if any(map("".join, table))]
    parts = (part.strip() for line in lines for part in _WIDE.split(line))
    text = read_lines("\n".join(filter(None, parts)), where, limits)
    entries = [*(entry for document in some for entry in document.entries), *filter(_is_answer, text.entries)]
    if not any(map(_is_answer, entries)):
        raise NoNumbers(where, kind)
    return StudentDocument(tuple(name for document in (*some, text) for name in document.called), tuple(entries))


def _of_word(content: bytes, where: Where, limits: Limits) -> Parts:
    from docx import Document

    checked_zip(content, where, limits)
    body = Document(io.BytesIO(content)).element.body
    rows = (table.iter(f"{_W}tr") for table in body.iter(f"{_W}tbl"))
    tables = [[[_text(cell) for cell in row.iterchildren(f"{_W}tc")] for row in table] for table in rows]
    return tables, [_text(each) for each in body.iter(f"{_W}p") if next(each.iterancestors(f"{_W}tc"), None) is None]


def _pdf(content: bytes) -> PdfReader:
    """A PDF's reader, whose own remarks on a broken one stand nowhere."""
    from pypdf import PdfReader

    logging.getLogger("pypdf").addHandler(_QUIET)
    return PdfReader(io.BytesIO(content))


def _of_pdf(content: bytes, where: Where, limits: Limits) -> Parts:
    pages = islice(_pdf(content).pages, _PAGES)
    lines = [line for page in pages for line in page.extract_text().splitlines()]
    return [[cells for line in lines if (cells := _cells(line))]], lines


_W = "{http://schemas.openxmlformats.org/wordprocessingml/2006/main}"
_BREAKS = {f"{_W}tab": "\t", f"{_W}br": "\n"}


def _text(element: Any) -> str:
    """A paragraph's or a cell's, formulas with it, which are text of another name: `a` `B3B2` `k`."""
    parts = (_BREAKS.get(each.tag) or (each.text if str(each.tag).endswith("}t") else "") for each in element.iter())
    return "".join(part or "" for part in parts).strip()


def _of_page(content: bytes, where: Where, limits: Limits) -> Parts:
    text = _UNSEEN.sub("", " ".join(decoded(content, where).split()))
    text = _CELL.sub(lambda cell: "\t" + _TAG.sub("", _BREAK.sub(" ", cell[1])), text)
    lines = unescape(_TAG.sub("", _BREAK.sub("\n", text))).split("\n")
    return [[line.split("\t")[1:] for line in lines if "\t" in line]], [line for line in lines if "\t" not in line]


_UNSEEN = re.compile(r"<(script|style|title)\b.*?</\1\b[^>]*>|<!--.*?-->", re.I)
_CELL = re.compile(r"<t[dh]\b[^>]*>(.*?)(?=</?t[dhr]\b|</table\b|$)", re.I)
_BREAK = re.compile(r"<(?:br|/?(?:p|div|li|h[1-6]|tr|table))\b[^>]*>", re.I)
_TAG = re.compile(r"<[^>]*>")


def _cells(line: str) -> list[str]:
    """`ω2 3.92 rad/s`, a row of a table as a PDF has it: what is asked, and what is answered; none of other lines."""
    words = plain(line).split()
    at = next((k for k, word in enumerate(words) if k and _NUMBER.match(word)), 0)
    if at == 1 and _SYMBOL.fullmatch(words[0]) and len(words) > 2 and _NUMBER.match(words[2]):
        at = 2  # ω 3 3.92
    name = " ".join(words[:at])
    return [name, " ".join(words[at:])] if at and begins_like_one(name) and "=" not in name else []


def picture_in(content: bytes, where: Where, limits: Limits) -> Seen | None:
    """The first picture in a document, or a photograph itself; None where there is none that a browser shows."""
    try:
        with limited(limits.seconds, where):
            if content.startswith(b"PK"):
                checked_zip(content, where, limits)
                with opened(content, where) as archive:
                    found = [archive.read(info) for info in archive.infolist() if "/media/" in info.filename]
            elif content.startswith(b"%PDF"):
                found = [image.data for image in _pdf(content).pages[0].images]
            else:
                found = [content]
    except Exception:  # whatever a file that is none raises: there is nothing to be seen
        return None
    return next(((kind, data) for data in found for kind, start in _SEEN.items() if data.startswith(start)), None)


Seen = tuple[str, bytes]
"""A picture's kind and its bytes."""
_SEEN = {"image/png": b"\x89PNG", "image/jpeg": b"\xff\xd8\xff"}


def _is_answer(entry: Entry) -> bool:
    """True of what is called as quantities are, and of a short name with a number."""
    name, value, _ = entry
    number = len(name) <= _SHORT and _NUMBER.match(str(value).lstrip("(（["))
    return begins_like_one(name) or plane_named(name) is not None or bool(number)


READERS = {".docx": partial(_read, "DOCX", _of_word), ".pdf": partial(_read, "PDF", _of_pdf),
           ".html": partial(_read, "HTML", _of_page)}  # fmt: skip
