"""The page of feedback that goes back to a student: HTML, plain text, a drawing, or a table, as the platform wants."""

from __future__ import annotations

import io
import json
from collections.abc import Callable, Iterator, Mapping

from graphkin.errors import Lang
from graphkin.platforms import xlsx
from graphkin.platforms.archive import pack
from graphkin.platforms.cells import line
from graphkin.platforms.feedback import Reveal, lines
from graphkin.platforms.marked_up import clean, element, in_html, one_line, xml
from graphkin.platforms.result import Result
from graphkin.say.catalogue import say

Page = Callable[[Result, Lang, Reveal], bytes]
_STYLE = "body{font-family:sans-serif;max-width:48em;margin:2em auto;padding:0 1em;line-height:1.5}"
_STEP = 6.0
_WIDTH, _LETTERS = 210, 80


def html(result: Result, lang: Lang, reveal: Reveal) -> bytes:
    """A page that needs nothing but itself."""
    told = "".join(f"<p>{in_html(text)}</p>\n" for text in lines(result, lang, reveal))
    title = in_html(_title(result, lang))
    return (
        f'<!DOCTYPE html>\n<html lang="{lang}"><head><meta charset="utf-8"><title>{title}</title>\n'
        f"<style>{_STYLE}</style></head>\n<body><h1>{title}</h1>\n{told}</body></html>\n"
    ).encode()


def text(result: Result, lang: Lang, reveal: Reveal) -> bytes:
    """Lines of text."""
    return "".join(clean(each) + "\n" for each in _told(result, lang, reveal)).encode()


def drawing(result: Result, lang: Lang, reveal: Reveal) -> bytes:
    """The lines on a drawing."""
    rows = [piece for each in _told(result, lang, reveal) for piece in _broken(one_line(each))]
    height = f"{_STEP * (len(rows) + 2):g}"
    texts = (
        element("text", row, x="10", y=f"{_STEP * (k + 2):g}", **{"font-size": "4", "font-family": "sans-serif"})
        for k, row in enumerate(rows)
    )
    return xml(element(
        "svg", *texts, xmlns="http://www.w3.org/2000/svg", width=f"{_WIDTH}mm", height=f"{height}mm",
        viewBox=f"0 0 {_WIDTH} {height}",
    ))  # fmt: skip


def table(result: Result, lang: Lang, reveal: Reveal) -> bytes:
    """The lines as a CSV file, a line a row."""
    return "".join(line([each]) for each in _told(result, lang, reveal)).encode("utf-8-sig")


def listed(result: Result, lang: Lang, reveal: Reveal) -> bytes:
    """The lines as JSON."""
    return (json.dumps({"feedback": [*_told(result, lang, reveal)]}, ensure_ascii=True, indent=1) + "\n").encode()


def commented(result: Result, lang: Lang, reveal: Reveal) -> bytes:
    """The lines as TOML: nothing but comments."""
    return "".join(f"# {one_line(each)}\n" for each in _told(result, lang, reveal)).encode()


def workbook(result: Result, lang: Lang, reveal: Reveal) -> bytes:
    """The lines as an Excel workbook, a line a row."""
    made = io.BytesIO()
    pack(made, xlsx.members(([each] for each in _told(result, lang, reveal)), say("feedback.title", lang)))
    return made.getvalue()


KINDS: Mapping[str, Page] = {
    ".html": html, ".htm": html, ".txt": text, ".md": text, ".svg": drawing, ".csv": table, ".json": listed,
    ".toml": commented, ".xlsx": workbook,
}  # fmt: skip
"""By the suffix of what was handed in, for platforms that take back only the same kind of file."""


def _title(result: Result, lang: Lang) -> str:
    return say("feedback.title for", lang, student=one_line(result.student))


def _told(result: Result, lang: Lang, reveal: Reveal) -> Iterator[str]:
    yield _title(result, lang)
    yield from lines(result, lang, reveal)


def _broken(told: str) -> Iterator[str]:
    """A text in rows; a Chinese letter is as wide as two others."""
    row, width = io.StringIO(), 0
    for letter in told:
        width += 2 if ord(letter) > 0x2E7F else 1
        if width > _LETTERS:
            yield row.getvalue()
            row, width = io.StringIO(), 2
        row.write(letter)
    yield row.getvalue()
