"""The document as one HTML file: MathML and an SVG inside, no script, nothing loaded from elsewhere. It is XML, too."""

from __future__ import annotations

from html import escape
from typing import assert_never

from graphkin.equations.document import (
    Block,
    Display,
    Document,
    DocumentHeading,
    DocumentSentence,
    DocumentTable,
    FigureNode,
)
from graphkin.equations.layout import Node, Op, Row
from graphkin.equations.mathml import escaped, mathml
from graphkin.outputs.svg import inline
from graphkin.sheet import Sheet

_STYLE = """
body { max-width: 60rem; margin: 2rem auto; padding: 0 1rem; font-family: "Times New Roman", "Liberation Serif",
  "Noto Serif CJK SC", "Songti SC", SimSun, serif; line-height: 1.5; color: #000; background: #fff; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.2rem; border-bottom: 1px solid #999; } h3 { font-size: 1rem; }
figure { margin: 1rem 0; text-align: center; } figure svg { max-width: 100%; height: auto; }
.equation { display: flex; flex-wrap: wrap; align-items: center; margin: 0.6rem 0 0.6rem 2rem; }
.equation > span { margin-left: auto; padding-left: 1rem; } .rows { flex: 1 0 max-content; }
.rows math { display: block; margin: 0.35rem 0; text-align: left; }
table { border-collapse: collapse; } th, td { text-align: left; padding: 0.15rem 1rem 0.15rem 0; }
math { font-family: "STIX Two Math", "Cambria Math", "Latin Modern Math", "Libertinus Math", "XITS Math",
  "TeX Gyre Termes Math", "DejaVu Math TeX Gyre", math; }
mtd { padding: 0.25em 0.6em; }
/* brackets of a matrix: drawn, since they only stretch in fonts made for mathematics */
.matrix { --b: linear-gradient(#000, #000); border: solid #000; border-width: 0 1px; margin: 0 0.25em;
  background: var(--b) top left / 5px 1px, var(--b) top right / 5px 1px, var(--b) bottom left / 5px 1px,
  var(--b) bottom right / 5px 1px; background-repeat: no-repeat; }
@media print { body { max-width: none; margin: 0; } h2, h3 { break-after: avoid; } .equation { break-inside: avoid; } }
"""


def write_html(document: Document) -> str:
    """A whole page."""
    body = "\n".join(_block(block) for block in document.blocks)
    return (
        f'<!DOCTYPE html>\n<html xmlns="http://www.w3.org/1999/xhtml" lang="{document.lang}">\n<head>\n'
        f'<meta charset="utf-8"/>\n<meta name="generator" content="graphkin"/>\n'
        f"<title>{escaped(document.title)}</title>\n<style>{_STYLE}</style>\n</head>\n"
        f"<body>\n<h1>{escaped(document.title)}</h1>\n{body}\n</body>\n</html>\n"
    )


def _block(block: Block) -> str:
    match block:
        case DocumentHeading():
            return f"<h{block.level}>{escaped(block.text)}</h{block.level}>"
        case DocumentSentence():
            return f"<p>{''.join(_part(part) for part in block.parts)}</p>"
        case Display():
            rows = "".join(mathml(_chain(row), display=True) for row in block.rows)
            return f'<div class="equation"><div class="rows">{rows}</div><span>({block.number})</span></div>'
        case DocumentTable():
            return _table(block)
        case FigureNode():
            sheet = block.draw()
            return f"<figure>{svg(sheet)}<figcaption>{escaped(sheet.title)}</figcaption></figure>"
        case _:
            assert_never(block)


def _part(part: str | Node) -> str:
    return escaped(part) if isinstance(part, str) else mathml(part)


def _chain(row: tuple[Node, ...]) -> Node:
    """Sides with their equals signs."""
    items: list[Node] = []
    for k, side in enumerate(row):
        items += [Op("="), side] if k else [side]
    return Row(tuple(items))


def _table(block: DocumentTable) -> str:
    heads = "".join(f"<th>{escaped(head)}</th>" for head in block.heads)
    rows = "".join("<tr>" + "".join(f"<td>{_part(cell)}</td>" for cell in row) + "</tr>\n" for row in block.rows)
    return f"<table>\n<thead><tr>{heads}</tr></thead>\n<tbody>\n{rows}</tbody>\n</table>"


def svg(sheet: Sheet) -> str:
    """A drawing within the page, with its title for who does not see it."""
    return inline(sheet).replace("<svg ", f'<svg role="img" aria-label="{escape(sheet.title)}" ', 1)
