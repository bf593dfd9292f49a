"""The page of feedback as HTML: a table of quantities, the arithmetic, the diagnosis, pictures. All is in one file."""

from __future__ import annotations

import base64
from collections.abc import Iterator

from graphkin.errors import Lang
from graphkin.platforms.feedback import (
    Feedback,
    arithmetic,
    diagnosis,
    override,
    reason,
    shown,
    title,
    total,
)
from graphkin.platforms.marked_up import in_html
from graphkin.platforms.numbers import exponentless
from graphkin.platforms.result import Line, Picture
from graphkin.say.catalogue import say
from graphkin.say.verdicts import verdict

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
    result, lang = told.result, told.lang
    if result.status == "not marked":
        yield _paragraph(reason(result, lang))
    if result.lines:
        yield _table(told)
    for line in result.lines:
        yield from (_paragraph(f"{line.name}: {text}") for text in arithmetic(result, line, lang, told.reveal))
    if any(line.verdict == "carried" for line in result.lines):
        yield _paragraph(say("verdicts.carried means", lang))
    yield from map(_paragraph, diagnosis(result, lang, told.reveal))
    yield from map(_figure, told.pictures)
    yield from (_paragraph(say("feedback.note", lang, note=note)) for note in result.notes)
    last = (override(result, lang), total(result, lang) if result.total is not None else "")
    yield from (_paragraph(text) for text in last if text)


def _paragraph(text: str) -> str:
    return f"<p>{in_html(text)}</p>"


# --- quantities -------------------------------------------------------------------------------


def _table(told: Feedback) -> str:
    names = ["marks.column quantity", "feedback.column given", "marks.column verdict", "platforms.column points"]
    if told.reveal == "answer":
        names[2:2] = ["marks.column right value", "verdicts.tolerance"]
    head = "".join(f"<th>{in_html(say(name, told.lang))}</th>" for name in names)
    return f"<table>\n<tr>{head}</tr>\n" + "\n".join(_row(told, line) for line in told.result.lines) + "\n</table>"


def _row(told: Feedback, line: Line) -> str:
    numbers = [line.given, *([line.right, line.tolerance] if told.reveal == "answer" else [])]
    cells = [_cell(line.name), *(_cell("" if x is None else shown(x, line.unit), "number") for x in numbers)]
    cells += [_cell(verdict(line, told.lang), "verdict"), _cell(_points(line, told.lang), "number")]
    return f'<tr class="{line.verdict}">' + "".join(cells) + "</tr>"


def _points(line: Line, lang: Lang) -> str:
    if not line.most:
        return ""
    return say("feedback.of", lang, points=exponentless(line.points), most=exponentless(line.most))


def _cell(text: str, kind: str = "") -> str:
    return f'<td class="{kind}">{in_html(text)}</td>' if kind else f"<td>{in_html(text)}</td>"


# --- pictures ---------------------------------------------------------------------------------


def _figure(picture: Picture) -> str:
    if not picture.data:
        return _paragraph(picture.label)
    return f"<figure>{_drawn(picture)}\n<figcaption>{in_html(picture.label)}</figcaption></figure>"


def _drawn(picture: Picture) -> str:
    """A drawing of graphkin's own within the page; any other picture as its data."""
    if picture.kind == _SVG:
        return picture.data.decode()
    return f'<img alt="" src="data:{picture.kind};base64,{base64.b64encode(picture.data).decode()}">'
