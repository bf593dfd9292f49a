"""The writers of a document: plain text, one HTML file, one LaTeX file."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import assert_never

from graphkin.equations import document as parts
from graphkin.equations.document import Block, Document
from graphkin.equations.formulas import LATEX, MATHML, TEXT, Grid, Minus, Node, Op, Row, escaped, in_notation
from graphkin.outputs.typesetting import tex_text
from graphkin.say.text_table import aligned, in_lines, padded, width


def _has_grid(nodes: Sequence[Node]) -> bool:
    """True where a matrix stands among the nodes, or among those of a row of them."""
    return any(
        isinstance(node.of if isinstance(node, Minus) else node, Grid)
        or (isinstance(node, Row) and _has_grid(node.items)) for node in nodes
    )  # fmt: skip


_NUMBERED_AT = 88


def write_text(document: Document) -> str:
    """The whole document, ending in a newline; no line ends in blanks."""
    lines = [document.title, "=" * width(document.title)]
    for block in document.blocks:
        lines += ["", *text] if (text := _block_lines(block)) else []
    return "\n".join(line.rstrip() for line in lines) + "\n"


def _block_lines(block: Block) -> list[str]:
    match block:
        case parts.DocumentHeading():
            return [block.text, ("-" if block.level == 2 else "·") * width(block.text)]
        case parts.DocumentSentence():
            return in_lines("".join(_text(part) for part in block.parts), _NUMBERED_AT)
        case parts.Display():
            lines = []
            for row in block.rows:  # a chain of equal sides; products with matrices in them taken apart
                nodes: list[Node] = []
                for k, side in enumerate(row):
                    nodes += [Op("=")] if k else []
                    nodes += side.items if isinstance(side, Row) and _has_grid(side.items) else [side]
                lines += _side_by_side(nodes)
            lines[-1] += " " * max(3, _NUMBERED_AT - 4 - width(lines[-1])) + f"({block.number})"
            return ["    " + line for line in lines]
        case parts.DocumentTable():
            cells = [list(block.heads), *([_text(entry) for entry in row] for row in block.rows)]
            return ["    " + line for line in aligned(cells, "<")]
        case parts.FigureNode():
            return []
        case _:
            assert_never(block)


def _text(part: str | Node) -> str:
    return part if isinstance(part, str) else in_notation(part, TEXT)


def _side_by_side(nodes: Sequence[Node]) -> list[str]:
    """Nodes on one line; matrices make as many lines as they have rows, the rest stands on the middle one."""
    columns: list[list[str]] = []
    for node in nodes:
        column = [in_notation(node, TEXT)]
        if isinstance(node, Grid):
            rows = aligned([[in_notation(entry, TEXT) for entry in row] for row in node.rows], "<", "   ")
            ends = [("⎡", "⎤"), *[("⎢", "⎥")] * (len(rows) - 2), ("⎣", "⎦")] if len(rows) > 1 else [("[", "]")]
            column = [f"{left} {row} {right}" for (left, right), row in zip(ends, rows, strict=True)]
        columns.append(column)
    height = max(len(column) for column in columns)
    lines = [""] * height
    for column in columns:
        top = (height - len(column)) // 2
        wide = max(width(text) for text in column)
        for k in range(height):
            text = column[k - top] if top <= k < top + len(column) else ""
            lines[k] += (" " if lines[k] else "") + padded(text, wide)
    return [line.rstrip() for line in lines] if height == 1 else lines


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
    """One HTML page: MathML and an SVG inside, no script, nothing loaded from elsewhere. It is XML, too."""
    body = "\n".join(_block_html(block) for block in document.blocks)
    return (
        f'<!DOCTYPE html>\n<html xmlns="http://www.w3.org/1999/xhtml" lang="{document.lang}">\n<head>\n'
        f'<meta charset="utf-8"/>\n<meta name="generator" content="graphkin"/>\n'
        f"<title>{escaped(document.title)}</title>\n<style>{_STYLE}</style>\n</head>\n"
        f"<body>\n<h1>{escaped(document.title)}</h1>\n{body}\n</body>\n</html>\n"
    )


def _block_html(block: Block) -> str:
    match block:
        case parts.DocumentHeading():
            return f"<h{block.level}>{escaped(block.text)}</h{block.level}>"
        case parts.DocumentSentence():
            return f"<p>{''.join(_html(part) for part in block.parts)}</p>"
        case parts.Display():
            chains = (Row(tuple([node for side in row for node in (Op("="), side)][1:])) for row in block.rows)
            rows = "".join(f'<math display="block">{in_notation(chain, MATHML)}</math>' for chain in chains)
            return f'<div class="equation"><div class="rows">{rows}</div><span>({block.number})</span></div>'
        case parts.DocumentTable():
            heads = "".join(f"<th>{escaped(head)}</th>" for head in block.heads)
            lines = ("".join(f"<td>{_html(cell)}</td>" for cell in row) for row in block.rows)
            rows = "".join(f"<tr>{line}</tr>\n" for line in lines)
            return f"<table>\n<thead><tr>{heads}</tr></thead>\n<tbody>\n{rows}</tbody>\n</table>"
        case parts.FigureNode():
            from graphkin.outputs.svg import inline

            sheet = block.draw()
            titled = f'<svg role="img" aria-label="{escape(sheet.title)}" '
            drawing = inline(sheet).replace("<svg ", titled, 1)
            return f"<figure>{drawing}<figcaption>{escaped(sheet.title)}</figcaption></figure>"
        case _:
            assert_never(block)


def _html(part: str | Node) -> str:
    return escaped(part) if isinstance(part, str) else f"<math>{in_notation(part, MATHML)}</math>"


_PREAMBLE = r"""\usepackage[margin=20mm]{geometry}
\usepackage{amsmath}
\usepackage{graphicx}
\usepackage{longtable}
\setlength{\parindent}{0pt}
\raggedright
\setlength{\parskip}{0.6ex}
\newsavebox{\wide}
% a matrix that is wider than the page is made smaller
\newcommand{\fit}[1]{\sbox{\wide}{$\displaystyle #1$}%
  \ifdim\wd\wide>0.88\linewidth\resizebox{0.88\linewidth}{!}{\usebox{\wide}}\else\usebox{\wide}\fi}
\newcommand{\numbered}[1]{\hspace*{\fill}\mbox{(#1)}\par}
"""


def write_tex(document: Document) -> str:
    """A whole document for xelatex or lualatex, in Chinese with the ctex class; English also for pdflatex."""
    from graphkin.outputs.tikz import LIBRARIES

    libraries = "\n".join(LIBRARIES)
    body = "\n\n".join(_block_tex(block) for block in document.blocks)
    chinese = any("\u2e80" <= c <= "\uffef" for c in document.title + body)
    return (
        rf"\documentclass[a4paper]{{{'ctexart' if chinese else 'article'}}}"
        f"\n{libraries}\n{_PREAMBLE}\\begin{{document}}\n{{\\Large\\bfseries {tex_text(document.title)}\\par}}\n\n"
        f"{body}\n\\end{{document}}\n"
    )


def _block_tex(block: Block) -> str:
    match block:
        case parts.DocumentHeading():
            return rf"\{'section' if block.level == 2 else 'subsection'}*{{{tex_text(block.text)}}}"
        case parts.DocumentSentence():
            return "".join(_tex(part) for part in block.parts)
        case parts.Display():
            lines = []  # TeX breaks a long formula at its signs; matrices are fitted to the line
            for row in block.rows:
                text = " = ".join(in_notation(side, LATEX) for side in row)
                lines.append(r"\hspace*{2em}" + (rf"\fit{{{text}}}" if _has_grid(row) else rf"$\displaystyle {text}$"))
            return "\\par\n".join(lines) + rf"\numbered{{{block.number}}}"
        case parts.DocumentTable():
            columns = "l" * (len(block.heads) - 2) + r"p{0.55\linewidth}l"
            heads = " & ".join(tex_text(head) for head in block.heads)
            rows = "".join(" & ".join(_tex(cell) for cell in row) + " \\\\\n" for row in block.rows)
            return f"\\begin{{longtable}}{{@{{}}{columns}}}\n{heads} \\\\\n\\hline\n{rows}\\end{{longtable}}"
        case parts.FigureNode():
            from graphkin.outputs.tikz import picture

            sheet = block.draw()
            return f"\\begin{{center}}\n{picture(sheet, 'black')}\n\n{tex_text(sheet.title)}\n\\end{{center}}"
        case _:
            assert_never(block)


def _tex(part: str | Node) -> str:
    return tex_text(part) if isinstance(part, str) else f"${in_notation(part, LATEX)}$"
