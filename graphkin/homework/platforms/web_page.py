"""The page of feedback as HTML: a table of quantities, the arithmetic, the diagnosis, pictures. All is in one file."""

from __future__ import annotations

import base64
from collections.abc import Iterator

from graphkin.homework.platforms.feedback import Feedback, at_the_end, table, title, under_table
from graphkin.homework.platforms.marked_up import in_html
from graphkin.homework.platforms.result import ResultPicture

PAGE = b'<meta name="generator" content="graphkin">'
"""By this a page is known as graphkin's own."""
_SVG = "image/svg+xml"
_STYLE = """
body { font-family: sans-serif; max-width: 52em; margin: 2em auto; padding: 0 1em; line-height: 1.5 }
table { border-collapse: collapse } th, td { border: 1px solid #999; padding: .2em .7em; text-align: left }
td.number { text-align: right } .wrong td.verdict, .missing td.verdict { font-weight: bold }
figure { margin: 1.2em 0 } figure svg, figure img { max-width: 100%; height: auto }
figcaption { font-size: .9em; color: #444 }
@media print { body { max-width: none; margin: 0; font-size: 10.5pt } figure, tr { break-inside: avoid } }
"""


def html(told: Feedback) -> bytes:
    """A page that needs nothing but itself."""
    head = in_html(title(told))
    body = "\n".join(_body(told))
    return (
        f'<!DOCTYPE html>\n<html lang="{told.lang}"><head><meta charset="utf-8">{PAGE.decode()}\n'
        f'<meta name="viewport" content="width=device-width"><title>{head}</title>\n'
        f"<style>{_STYLE}</style></head>\n<body><h1>{head}</h1>\n{body}\n</body></html>\n"
    ).encode()


def _body(told: Feedback) -> Iterator[str]:
    if told.result.lines:
        yield _table(told)
    yield from map(_paragraph, under_table(told))
    yield from map(_figure, told.pictures)
    yield from map(_paragraph, at_the_end(told))


def _paragraph(text: str) -> str:
    return f"<p>{in_html(text)}</p>"


def _table(told: Feedback) -> str:
    head, *rows = table(told)
    lines = (_row(row, line.verdict) for row, line in zip(rows, told.result.lines, strict=True))
    first = "".join(f"<th>{in_html(name)}</th>" for name in head)
    return f"<table>\n<tr>{first}</tr>\n" + "\n".join(lines) + "\n</table>"


def _row(row: tuple[str, ...], verdict: str) -> str:
    kinds = ["", *["number"] * (len(row) - 3), "verdict", "number"]
    cells = (f'<td class="{kind}">{in_html(text)}</td>' for text, kind in zip(row, kinds, strict=True))
    return f'<tr class="{verdict}">' + "".join(cells) + "</tr>"


# --- pictures ---------------------------------------------------------------------------------


def _figure(picture: ResultPicture) -> str:
    if not picture.data:
        return _paragraph(picture.label)
    return f"<figure>{_drawn(picture)}\n<figcaption>{in_html(picture.label)}</figcaption></figure>"


def _drawn(picture: ResultPicture) -> str:
    """A drawing of graphkin's own within the page; any other picture as its data."""
    if picture.kind == _SVG:
        return picture.data.decode()
    return f'<img alt="" src="data:{picture.kind};base64,{base64.b64encode(picture.data).decode()}">'
