"""A handout as a page that needs nothing but itself: MathML, drawings in it, printed in true millimetres."""

from __future__ import annotations

from html import escape

from graphkin.handouts.document import (
    Handout,
    HandoutHeading,
    HandoutPicture,
    HandoutTable,
    NewPage,
    Paragraph,
    TermRows,
)
from graphkin.handouts.grid import room_svg
from graphkin.handouts.medium import Medium
from graphkin.handouts.scripted import Sign, signs
from graphkin.outputs.svg import inline
from graphkin.sheet.lettering import Label, Run
from graphkin.sheet.paper import PAPERS

MARK = b"graphkin handout"
_STYLE = """@page{{size:{width}mm {height}mm;margin:15mm 20mm 20mm}}
body,mi,mn,mtext{{font-family:"Times New Roman","Liberation Serif",Tinos,"Noto Serif CJK SC","Source Han Serif SC",
SimSun,serif}}body{{font-size:10.5pt;line-height:1.45;max-width:{room}mm;margin:0 auto}}
h1{{font-size:15pt}}h2{{font-size:12pt;break-after:avoid}}
math{{font-family:"DejaVu Math TeX Gyre","TeX Gyre Termes Math","XITS Math","STIX Two Math",math}}
mi{{font-style:italic;text-transform:none}}
.formula{{margin-left:8mm}}figure{{margin:3mm 0;text-align:center;break-inside:avoid}}svg{{max-width:none}}
table{{border-collapse:collapse;break-inside:avoid}}.filled td,.filled th{{border:.18mm solid;min-width:24mm;height:7mm;
text-align:center;font-weight:normal}}.rows{{margin-left:8mm}}.rows td{{text-align:center;padding:.6mm 1mm}}
.rule{{display:inline-block;width:20mm;height:6mm;border-bottom:.18mm solid}}
footer{{margin-top:8mm;font-size:8pt;display:flex;justify-content:space-between;align-items:flex-end}}
.bar{{width:100mm;height:2mm;border:solid;border-width:.35mm .18mm 0}}
.new{{break-before:page}}.front{{break-before:right}}
small{{font-size:8pt;font-weight:normal}}
.act{{display:inline-block;min-width:3.6mm;line-height:3.6mm;border:.2mm solid;border-radius:2mm;text-align:center;
font-size:7.5pt}}"""


def html(handout: Handout, paper: str = "A4") -> str:
    """The whole page."""
    size = PAPERS[paper]
    style = _STYLE.format(width=size.width, height=size.height, room=size.width - 40)
    body = _PAGE.written(handout.blocks)
    foot, title = handout.foot, escape(handout.title)
    bar = f'<div><div class="bar"></div>{escape(foot.bar)}</div>'
    return (
        f'<!DOCTYPE html>\n<html lang="{handout.lang}"><head><meta charset="utf-8">'
        f'<meta name="generator" content="{MARK.decode()}"><title>{title}</title>\n<style>{style}</style></head>\n'
        f"<body>\n{_contents(handout)}{body}\n<footer>{bar}<span>{escape(foot.words)}</span></footer>\n</body></html>\n"
    )


def _contents(handout: Handout) -> str:
    if not handout.contents:
        return ""
    heads = (block for block in handout.blocks if isinstance(block, HandoutHeading) and block.level == 1)
    items = "".join(f"<li>{_words(head.words)}</li>" for head in heads)
    return f'<h1>{escape(handout.contents)}</h1>\n<ol>{items}</ol>\n'


def _heading(heading: HandoutHeading) -> str:
    said = f' <small>{escape(heading.said)}</small>' if heading.said else ""
    return f"<h{heading.level}>{_words(heading.words)}{said}</h{heading.level}>"


def _text(text: Paragraph) -> str:
    number = f'<span class="act">{escape(text.act)}</span> ' if text.act else ""
    return f"<p>{number}{_words(text.words)}</p>"


def _rows(rows: TermRows) -> str:
    rule = '<span class="rule"></span>'
    lines = ("".join(f"<td>{_words(cell) if cell is not None else rule}</td>" for cell in line) for line in rows.lines)
    return '<table class="rows">' + "".join(f"<tr>{line}</tr>" for line in lines) + "</table>"


def _picture(picture: HandoutPicture) -> str:
    return f'<figure role="img" aria-label="{escape(picture.told)}">{inline(picture.sheet)}</figure>'


def _table(table: HandoutTable) -> str:
    first = "".join(f"<th>{_words(head)}</th>" for head in table.heads)
    lines = ("".join(f"<td>{_words(cell)}</td>" for cell in row) for row in table.rows)
    return f'<table class="filled"><tr>{first}</tr>' + "".join(f"<tr>{line}</tr>" for line in lines) + "</table>"


def _new_page(page: NewPage) -> str:
    return f'<div class="{"front" if page.front else "new"}"></div>'


_PAGE = Medium(
    _heading, _text, lambda formula: f'<p class="formula">{_words(formula.words)}</p>', _rows, _picture,
    lambda room: f"<figure>{room_svg(room)}</figure>", _table, _new_page,
)  # fmt: skip


def _words(label: Label) -> str:
    return "".join(map(_sign, signs(label)))


def _sign(sign: Sign) -> str:
    """Letters as they are; a letter with scripts as MathML."""
    if not sign.low and not sign.high:
        return _letters(sign.base) if sign.base is not None else ""
    base = _token(sign.base) if sign.base is not None else "<mrow></mrow>"
    low, high = ("<mrow>" + "".join(map(_token, runs)) + "</mrow>" for runs in (sign.low, sign.high))
    if sign.low and sign.high:
        return f"<math><msubsup>{base}{low}{high}</msubsup></math>"
    return f"<math><msub>{base}{low}</msub></math>" if sign.low else f"<math><msup>{base}{high}</msup></math>"


def _letters(run: Run) -> str:
    return f"<i>{escape(run.text)}</i>" if run.italic else escape(run.text)


def _token(run: Run) -> str:
    """Browsers set several letters in one `mi` upright; the page's style slants them as the drawings have them."""
    if run.italic:
        return f"<mi>{escape(run.text)}</mi>"
    kind = "mn" if run.text.isdigit() else "mtext"
    return f"<{kind}>{escape(run.text)}</{kind}>"
