"""The page of feedback that goes back to a student: HTML, a drawing, plain text, or a table, as the platform wants."""

from __future__ import annotations

import base64
import io
import json
import re
import xml.etree.ElementTree as ET
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import partial

from graphkin.homework.platforms.feedback import Feedback, at_the_end, lines, table, title, under_table
from graphkin.homework.platforms.markup import clean, element, in_html, one_line, pack
from graphkin.homework.platforms.result import ResultPicture
from graphkin.homework.platforms.tables import line, workbook_files
from graphkin.say.catalogue import say

PAGE = b'<meta name="generator" content="graphkin">'  # by this a page is known as graphkin's own
_SVG = "image/svg+xml"
_STYLE = """
body { font-family: sans-serif; max-width: 52em; margin: 2em auto; padding: 0 1em; line-height: 1.5 }
table { border-collapse: collapse } th, td { border: 1px solid #999; padding: .2em .7em; text-align: left }
td.number { text-align: right } .wrong td.verdict, .missing td.verdict { font-weight: bold }
figure { margin: 1.2em 0 } figure svg, figure img { max-width: 100%; height: auto }
figcaption { font-size: .9em; color: #444 }
@media print { body { max-width: none; margin: 0; font-size: 10.5pt } figure, tr { break-inside: avoid } }
"""


Page = Callable[[Feedback], bytes]


def html(page: Feedback) -> bytes:
    """A page that needs nothing but itself: a table of quantities, the arithmetic, the diagnosis, pictures."""
    head = in_html(title(page))
    body = [_html_table(page)] if page.result.lines else []
    body += map(_paragraph, under_table(page))
    body += map(_figure, page.pictures)
    body += map(_paragraph, at_the_end(page))
    return (
        f'<!DOCTYPE html>\n<html lang="{page.lang}"><head><meta charset="utf-8">{PAGE.decode()}\n'
        f'<meta name="viewport" content="width=device-width"><title>{head}</title>\n'
        f"<style>{_STYLE}</style></head>\n<body><h1>{head}</h1>\n" + "\n".join(body) + "\n</body></html>\n"
    ).encode()


def _paragraph(text: str) -> str:
    return f"<p>{in_html(text)}</p>"


def _html_table(page: Feedback) -> str:
    head, *rows = table(page)
    rows_html = ["<tr>" + "".join(f"<th>{in_html(name)}</th>" for name in head) + "</tr>"]
    kinds = ["", *["number"] * (len(head) - 3), "verdict", "number"]
    for row, each in zip(rows, page.result.lines, strict=True):
        cells = (f'<td class="{kind}">{in_html(text)}</td>' for text, kind in zip(row, kinds, strict=True))
        rows_html.append(f'<tr class="{each.verdict}">' + "".join(cells) + "</tr>")
    return "<table>\n" + "\n".join(rows_html) + "\n</table>"


def _figure(picture: ResultPicture) -> str:
    """A drawing of graphkin's own within the page; any other picture as its data."""
    if not picture.data:
        return _paragraph(picture.label)
    data = f'<img alt="" src="data:{picture.kind};base64,{base64.b64encode(picture.data).decode()}">'
    drawing = picture.data.decode() if picture.kind == _SVG else data
    return f"<figure>{drawing}\n<figcaption>{in_html(picture.label)}</figcaption></figure>"


# --- a drawing, for platforms that take back drawings -----------------------------------------------------------------

_SIZE, _STEP, _BETWEEN = 4.0, 6.0, 5.0
"""Of letters, of rows, between columns [mm]."""
_LEFT, _WIDTH, _ROOM = 10.0, 210.0, 184.0
_START = re.compile(r'<svg [^>]*?viewBox="0 0 ([\d.]+) ([\d.]+)"[^>]*>')
_SIZES = re.compile(r' (?:width|height)="[^"]*"')
_PIECE = re.compile("[\u2e80-\uffef]|[^\\s\u2e80-\uffef]+\\s*|\\s+")


def drawing(page: Feedback) -> bytes:
    """Lines of text and under them pictures, as wide as A4, as long as it needs."""
    sheet = _SvgPage()
    sheet.write(title(page))
    if page.result.lines:
        sheet.tabulate([*table(page)])
    for text in under_table(page):
        sheet.write(text)
    for picture in page.pictures:
        sheet.show(picture)
    for text in at_the_end(page):
        sheet.write(text)
    return sheet.whole()


@dataclass
class _SvgPage:
    """The elements that are on it, and how far down it goes [mm]."""

    parts: list[str] = field(default_factory=list)
    top: float = _STEP

    def whole(self) -> bytes:
        high = f"{self.top + 2 * _STEP:g}"
        return (
            f'<?xml version="1.0" encoding="UTF-8"?>\n<svg xmlns="http://www.w3.org/2000/svg" width="{_WIDTH:g}mm" '
            f'height="{high}mm" viewBox="0 0 {_WIDTH:g} {high}"><rect width="100%" height="100%" fill="#ffffff"/>\n'
            + "\n".join(self.parts) + "</svg>\n"
        ).encode()  # fmt: skip

    def write(self, text: str) -> None:
        """A text in as many rows as it needs."""
        for row in _broken(one_line(text)):
            self.top += _STEP
            self.letter(row, _LEFT)

    def letter(self, text: str, x: float, anchor: str = "start") -> None:
        place = {"x": f"{x:g}", "y": f"{self.top:g}", "text-anchor": anchor}
        letters = element("text", text, **place, **{"font-size": f"{_SIZE:g}", "font-family": "sans-serif"})
        self.parts.append(ET.tostring(letters, encoding="unicode"))

    def tabulate(self, rows: list[tuple[str, ...]]) -> None:
        """Columns side by side, numbers to the right."""
        rows = [tuple(map(one_line, row)) for row in rows]
        widths = [max(map(_width, column)) for column in zip(*rows, strict=True)]
        for row in rows:
            self.top += _STEP
            start = _LEFT
            for k, (text, width) in enumerate(zip(row, widths, strict=True)):
                words = k in (0, len(row) - 2)
                self.letter(text, start if words else start + width, "start" if words else "end")
                start += width + _BETWEEN
        self.top += _STEP / 2

    def show(self, picture: ResultPicture) -> None:
        """A label with a drawing of graphkin's own under it; of another picture the label alone."""
        self.write(picture.label)
        text = picture.data.decode("utf-8", "replace")
        if match := _START.match(text):
            self.top += _STEP
            size = f'<svg x="{_LEFT:g}" y="{self.top:g}" width="{match[1]}" height="{match[2]}" '
            self.parts.append(_SIZES.sub("", match[0]).replace("<svg ", size, 1) + text[match.end() :])
            self.top += float(match[2])


def _width(text: str) -> float:
    """About what a text takes [mm]; a Chinese letter is as wide as high."""
    return sum(_SIZE if ord(letter) > 0x2E7F else 0.53 * _SIZE for letter in text)


def _broken(text: str) -> Iterator[str]:
    """A text in rows, between words where there are some; a word longer than a row is broken."""
    row = ""
    for piece in _PIECE.findall(text):
        while _width(row + piece.rstrip()) > _ROOM:
            if not row:
                count = int(_ROOM / _SIZE)
                row, piece = piece[:count], piece[count:]
            yield row.rstrip()
            row = ""
        row += piece
    yield row.rstrip()


def _as_text(kind: str, page: Feedback) -> bytes:
    """Its lines as plain text, as a table of one column, as JSON, as comments of TOML, as a workbook."""
    texts = [title(page), *lines(page.result, page.lang, page.reveal)]
    match kind:
        case "csv":
            return "".join(line([each]) for each in texts).encode("utf-8-sig")
        case "json":
            return (json.dumps({"feedback": texts}, ensure_ascii=True, indent=1) + "\n").encode()
        case "toml":
            return "".join(f"# {one_line(each)}\n" for each in texts).encode()
        case "xlsx":
            data = io.BytesIO()
            pack(data, workbook_files(([each] for each in texts), say("feedback.title", page.lang)))
            return data.getvalue()
        case _:
            return "".join(clean(each) + "\n" for each in texts).encode()


KINDS: Mapping[str, Page] = {
    ".html": html, ".htm": html, ".svg": drawing,
    **{f".{kind}": partial(_as_text, kind) for kind in ("txt", "md", "csv", "json", "toml", "xlsx")},
}  # fmt: skip
"""By the suffix of what was handed in, for platforms that take back only the same kind of file."""
