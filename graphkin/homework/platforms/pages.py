"""The page of feedback that goes back to a student: HTML, a drawing, plain text, or a table, as the platform wants."""

from __future__ import annotations

import base64
import io
import json
import re
import xml.etree.ElementTree as ET
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from html import escape

from graphkin.errors import Lang
from graphkin.homework.platforms import feedback
from graphkin.homework.platforms.feedback import Feedback
from graphkin.homework.platforms.markup import clean, element, in_html, one_line, pack
from graphkin.homework.platforms.result import ResultPicture
from graphkin.homework.platforms.tables import line, workbook_files
from graphkin.outputs.typesetting import LATIN, html_words, runs
from graphkin.say.catalogue import say
from graphkin.sheet.lettering import Label, formula, plain, width
from graphkin.sheet.marks import Text

PAGE = b'<meta name="generator" content="graphkin">'  # by this a page is known as graphkin's own
_SVG = "image/svg+xml"
_STYLE = """
body { font: 16px/1.5 "Helvetica Neue", Arial, "Noto Sans CJK SC", "PingFang SC", "Microsoft YaHei", sans-serif;
  color: #1c2430; max-width: 180mm; margin: 0 auto; padding: 16px }
i, mi, mn, mtext { font-family: "Times New Roman", "Liberation Serif", Tinos, serif }
math { font: 1.06em "DejaVu Math TeX Gyre", "STIX Two Math", math } mi { font-style: italic; text-transform: none }
header { border-bottom: 2px solid #1f4e79; margin-bottom: 14px } .who { margin: 0; color: #55606e }
h1 { font-size: 1.35em; line-height: 1.25; margin: 2px 0 8px } h2 { font-size: 1.05em; color: #1f4e79 }
.start { display: flex; flex-wrap: wrap; gap: 8px 24px; align-items: center } .start > div { flex: 1 1 240px }
.total { font-size: 1.3em; font-weight: bold; margin: 0 } .praise { margin: 4px 0 }
.next { border-left: 4px solid #1f4e79; background: #eef4fa; padding: 8px 12px; margin: 10px 0 }
.next b { display: block; color: #1f4e79 } figure { margin: 8px 0; max-width: 100%; overflow-x: auto }
figure svg, figure img { display: block; max-width: 100%; height: auto }
.pictures { display: flex; flex-wrap: wrap; gap: 4px 8px; align-items: flex-start }
.pictures p { flex: 1 0 100%; margin: 6px 0 0 } .pictures figure { flex: 0 1 88mm }
table { border-collapse: collapse; width: 100% } th { color: #55606e; font-weight: normal; font-size: .9em }
th, td { border-bottom: 1px solid #d5dbe2; padding: 5px 8px; text-align: left; vertical-align: top }
th.number, td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap }
span { white-space: nowrap } tr.not.read td { white-space: normal; overflow-wrap: anywhere }
.right .verdict, .carried .verdict { color: #1b6e3c } .not.read .verdict { color: #8a5a00 }
.wrong .verdict, .missing .verdict { color: #a61b1b; font-weight: bold } .note { font-size: .9em; color: #434d59 }
@media (max-width: 520px) { body { font-size: 15px; padding: 12px } th, td { padding: 5px 4px } }
@media print { @page { size: A4; margin: 15mm } body { max-width: none; padding: 0; font-size: 10.5pt }
  figure, tr, .next { break-inside: avoid } h2 { break-after: avoid } }
"""

Page = Callable[[Feedback], bytes]


def html(page: Feedback) -> bytes:
    """A page that needs nothing but itself: points and the next step, the quantities, the diagnosis, pictures."""
    lang = page.lang
    points = enumerate(feedback.points_that_count(page.result, lang))
    begin = "".join(_paragraph(text, "praise" if k else "total") for k, text in points)
    begin += _paragraph(feedback.praise(page.result, lang), "praise")
    if step := feedback.next_step(page):
        begin += f'<div class="next"><b>{say("feedback.next", lang)}</b>{typeset(step)}</div>'
    figure, title, who = "", feedback.title(page), ""
    heading = title
    if (problem := page.problem) is not None:
        heading, who = problem.label, f'<p class="who">{in_html(title)}</p>'
        label = say("feedback.problem", lang, title=problem.label)
        figure = figure_element(replace(problem, label=label)) if problem.data else ""
        figure = figure.replace("</figure>", f"<figcaption>{escape(problem.note)}</figcaption></figure>")
    body = [f'<div class="start"><div>{begin}</div>{figure}</div>']
    body += [_html_table(page)] if page.result.lines else []
    body += [_paragraph(text, "note") for text in feedback.under_table(page)]
    found = [text for text in feedback.diagnosis(page.result, lang, page.reveal) if text != step]
    if found or page.pictures:
        body += [f"<h2>{in_html(say('feedback.diagnosis', lang))}</h2>", *map(_paragraph, found)]
        body += [f'<div class="pictures">{"".join(map(figure_element, page.pictures))}</div>'] if page.pictures else []
    body += [_paragraph(text, "note") for text in feedback.at_the_end(page)]
    return document(title, f"<header>{who}<h1>{in_html(heading)}</h1></header>\n" + "\n".join(body), lang)


def document(title: str, body: str, lang: Lang) -> bytes:
    """A whole page, of graphkin's own."""
    return (
        f'<!DOCTYPE html>\n<html lang="{lang}"><head><meta charset="utf-8">{PAGE.decode()}\n'
        f'<meta name="viewport" content="width=device-width, initial-scale=1"><title>{in_html(title)}</title>\n'
        f"<style>{_STYLE}</style></head>\n<body>{body}\n</body></html>\n"
    ).encode()


def typeset(text: str) -> str:
    """A sentence with its quantities in the letters of the sheet."""
    lines = "<br>".join(html_words(formula(clean(line))) for line in text.split("\n"))
    return re.sub("<math>(?:(?!</math>).)*</math>[,.;:)、，。；：）]+", r"<span>\g<0></span>", lines)


def _paragraph(text: str, kind: str = "") -> str:
    attribute = f' class="{kind}"' if kind else ""
    return f"<p{attribute}>{typeset(text)}</p>" if text else ""


def _html_table(page: Feedback) -> str:
    head, *rows = feedback.table(page)
    kinds = ["name", *["number"] * (len(head) - 3), "verdict", "number"]
    lines = [_row("", map(in_html, head), kinds, 'th scope="col"')]
    for (name, given, *others), each in zip(rows, page.result.lines, strict=True):
        own = in_html(given) if each.written else typeset(given)  # the student's own words stay as they are
        lines.append(_row(each.verdict, (typeset(name), own, *map(typeset, others)), kinds, "td"))
    return "<table>\n" + "\n".join(lines) + "\n</table>"


def _row(kind: str, cells: Iterable[str], kinds: Sequence[str], tag: str) -> str:
    pairs = zip(cells, kinds, strict=True)
    texts = (f'<{tag} class="{of}">{text}</{tag.split(" ")[0]}>' for text, of in pairs)
    return f'<tr class="{kind}">' + "".join(texts) + "</tr>"


def figure_element(picture: ResultPicture) -> str:
    """A drawing of graphkin's own within the page, described for those who hear it; any other picture as its data."""
    if not picture.data:
        return _paragraph(picture.label)
    label = escape(clean(picture.label))
    if picture.kind != _SVG:
        data = base64.b64encode(picture.data).decode()
        image = f'<img alt="" src="data:{picture.kind};base64,{data}">'
        return f"<figure>{image}<figcaption>{label}</figcaption></figure>"
    text = picture.data.decode()
    return "<figure>" + text.replace("<svg ", f'<svg role="img" aria-label="{label}" ', 1) + "</figure>"


# --- a drawing, for platforms that take back drawings -----------------------------------------------------------------

_SIZE, _STEP, _BETWEEN = 4.0, 6.0, 5.0
"""Of letters, of rows, between columns [mm]."""
_LEFT, _WIDTH, _ROOM = 10.0, 210.0, 184.0
_START = re.compile(r'<svg [^>]*?viewBox="0 0 ([\d.]+) ([\d.]+)"[^>]*>')
_SIZES = re.compile(r' (?:width|height)="[^"]*"')
_PIECE = re.compile("[\u2e80-\uffef]|[^\\s\u2e80-\uffef]+\\s*|\\s+")


def drawing(page: Feedback) -> bytes:
    """Lines of text and under them pictures, as wide as A4, as long as it needs."""
    sheet, lang = _SvgPage(), page.lang
    sheet.write(feedback.title(page), plain)
    if page.problem is not None:
        sheet.write(page.problem.label, plain)
        sheet.show(page.problem)
        sheet.write(page.problem.note)
    step = feedback.next_step(page)
    step = step and say("feedback.line", lang, name=say("feedback.next", lang), verdict=step)
    for text in (*feedback.points_that_count(page.result, lang), feedback.praise(page.result, lang), step):
        if text:
            sheet.write(text)
    if page.result.lines:
        sheet.tabulate([*feedback.table(page)])
    for text in (*feedback.under_table(page), *feedback.diagnosis(page.result, lang, page.reveal)):
        sheet.write(text)
    for picture in page.pictures:
        sheet.show(picture)
    for text in feedback.at_the_end(page):
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
            f'height="{high}mm" viewBox="0 0 {_WIDTH:g} {high}" font-family="{LATIN}">'
            '<rect width="100%" height="100%" fill="#ffffff"/>\n'
            + "\n".join(self.parts) + "</svg>\n"
        ).encode()  # fmt: skip

    def write(self, text: str, set_as: Callable[[str], Label] = formula) -> None:
        """A text in as many rows as it needs."""
        for row in _broken(one_line(text)):
            self.top += _STEP
            self.letter(set_as(row), _LEFT)

    def letter(self, label: Label, x: float) -> None:
        """Letters as the sheets set them."""
        for span in runs(Text(label, complex(x, self.top), _SIZE)):
            place = {"x": f"{span.at.real:g}", "y": f"{span.at.imag:g}", **span.type(0)}
            place.setdefault("font-size", f"{span.size:g}")
            self.parts.append(ET.tostring(element("text", span.text, **place), encoding="unicode"))

    def tabulate(self, rows: list[tuple[str, ...]]) -> None:
        """Columns side by side, numbers to the right."""
        labels = [[formula(one_line(cell)) for cell in row] for row in rows]
        widths = [max(width(label, _SIZE) for label in column) for column in zip(*labels, strict=True)]
        for row in labels:
            self.top += _STEP
            start = _LEFT
            for k, (label, wide) in enumerate(zip(row, widths, strict=True)):
                words = k in (0, len(row) - 2)
                self.letter(label, start if words else start + wide - width(label, _SIZE))
                start += wide + _BETWEEN
        self.top += _STEP / 2

    def show(self, picture: ResultPicture) -> None:
        """A drawing of graphkin's own; of another picture, or of none, the label."""
        text = picture.data.decode("utf-8", "replace")
        if not _START.match(text):
            self.write(picture.label)
        if match := _START.match(text):
            self.top += _STEP
            size = f'<svg x="{_LEFT:g}" y="{self.top:g}" width="{match[1]}" height="{match[2]}" '
            self.parts.append(_SIZES.sub("", match[0]).replace("<svg ", size, 1) + text[match.end() :])
            self.top += float(match[2])


def _broken(text: str) -> Iterator[str]:
    """A text in rows, between words where there are some; a word longer than a row is broken."""
    row = ""
    for piece in _PIECE.findall(text):
        while width(formula(row + piece.rstrip()), _SIZE) > _ROOM:
            if not row:
                count = int(_ROOM / _SIZE)
                row, piece = piece[:count], piece[count:]
            yield row.rstrip()
            row = ""
        row += piece
    yield row.rstrip()


def _as_text(kind: str, page: Feedback) -> bytes:
    """Its lines as plain text, as a table of one column, as JSON, as comments of TOML, as a workbook."""
    texts = [feedback.title(page), *feedback.lines(page.result, page.lang, page.reveal)]
    match kind:
        case "csv":
            return "".join(line([each]) for each in texts).encode("utf-8-sig")
        case "json":
            return (json.dumps({"feedback": texts}, ensure_ascii=True, indent=1) + "\n").encode()
        case "toml":
            return "".join(f"# {one_line(each)}\n" for each in texts).encode()
        case "xlsx":
            data = io.BytesIO()
            pack(data, workbook_files({say("feedback.title", page.lang): [[each] for each in texts]}))
            return data.getvalue()
        case _:
            return "".join(clean(each) + "\n" for each in texts).encode()


KINDS: Mapping[str, Page] = {
    ".html": html, ".htm": html, ".svg": drawing,
    **{f".{kind}": partial(_as_text, kind) for kind in ("txt", "md", "csv", "json", "toml", "xlsx")},
}  # fmt: skip
"""By the suffix of what was handed in, for platforms that take back only the same kind of file."""
