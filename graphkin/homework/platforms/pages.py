"""The page of feedback that goes back to a student: HTML, plain text, a drawing, or a table, as the platform wants."""

from __future__ import annotations

import io
import json
from collections.abc import Callable, Iterator, Mapping

from graphkin.homework.platforms import xlsx
from graphkin.homework.platforms.archive import pack
from graphkin.homework.platforms.cells import line
from graphkin.homework.platforms.feedback import Feedback, lines, title
from graphkin.homework.platforms.marked_up import clean, one_line
from graphkin.homework.platforms.svg_page import drawing
from graphkin.homework.platforms.web_page import html
from graphkin.say.catalogue import say

Page = Callable[[Feedback], bytes]


def text(told: Feedback) -> bytes:
    """Lines of text."""
    return "".join(clean(each) + "\n" for each in _told(told)).encode()


def table(told: Feedback) -> bytes:
    """The lines as a CSV file, a line a row."""
    return "".join(line([each]) for each in _told(told)).encode("utf-8-sig")


def listed(told: Feedback) -> bytes:
    """The lines as JSON."""
    return (json.dumps({"feedback": [*_told(told)]}, ensure_ascii=True, indent=1) + "\n").encode()


def commented(told: Feedback) -> bytes:
    """The lines as TOML: nothing but comments."""
    return "".join(f"# {one_line(each)}\n" for each in _told(told)).encode()


def workbook(told: Feedback) -> bytes:
    """The lines as an Excel workbook, a line a row."""
    made = io.BytesIO()
    pack(made, xlsx.members(([each] for each in _told(told)), say("feedback.title", told.lang)))
    return made.getvalue()


KINDS: Mapping[str, Page] = {
    ".html": html, ".htm": html, ".txt": text, ".md": text, ".svg": drawing, ".csv": table, ".json": listed,
    ".toml": commented, ".xlsx": workbook,
}  # fmt: skip
"""By the suffix of what was handed in, for platforms that take back only the same kind of file."""


def _told(told: Feedback) -> Iterator[str]:
    yield title(told)
    yield from lines(told.result, told.lang, told.reveal)
