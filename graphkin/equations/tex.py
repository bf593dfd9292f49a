"""The document as LaTeX: one file that compiles as it is, in Chinese with the ctex class."""

from __future__ import annotations

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
from graphkin.equations.latex import latex
from graphkin.equations.layout import Grid, Node, Row
from graphkin.outputs.tex_words import tex_text
from graphkin.outputs.tikz import LIBRARIES, picture

_PREAMBLE = "\n".join(LIBRARIES) + r"""
\usepackage[margin=20mm]{geometry}
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
    """A whole document, for xelatex or lualatex (English also for pdflatex)."""
    body = "\n\n".join(_block(block) for block in document.blocks)
    kind = r"\documentclass[a4paper]{article}"
    if any("\u2e80" <= c <= "\uffef" for c in document.title + body):
        kind = r"\documentclass[a4paper]{ctexart}"
    return (
        f"{kind}\n{_PREAMBLE}\\begin{{document}}\n{{\\Large\\bfseries {tex_text(document.title)}\\par}}\n\n"
        f"{body}\n\\end{{document}}\n"
    )


def _block(block: Block) -> str:
    match block:
        case DocumentHeading():
            return rf"\{'section' if block.level == 2 else 'subsection'}*{{{tex_text(block.text)}}}"
        case DocumentSentence():
            return "".join(_part(part) for part in block.parts)
        case Display():
            return _display(block)
        case DocumentTable():
            return _table(block)
        case FigureNode():
            sheet = block.draw()
            return f"\\begin{{center}}\n{picture(sheet, 'black')}\n\n{tex_text(sheet.title)}\n\\end{{center}}"
        case _:
            assert_never(block)


def _part(part: str | Node) -> str:
    return tex_text(part) if isinstance(part, str) else f"${latex(part)}$"


def _display(block: Display) -> str:
    """Rows as paragraphs of formulas: TeX breaks the long ones at their signs; matrices are fitted."""
    rows = []
    for row in block.rows:
        formula = " = ".join(latex(side) for side in row)
        shown = rf"\fit{{{formula}}}" if _has_grid(row) else rf"$\displaystyle {formula}$"
        rows.append(rf"\hspace*{{2em}}{shown}")
    return "\\par\n".join(rows) + rf"\numbered{{{block.number}}}"


def _has_grid(row: tuple[Node, ...]) -> bool:
    return any(isinstance(side, Grid) or (isinstance(side, Row) and _has_grid(side.items)) for side in row)


def _table(block: DocumentTable) -> str:
    columns = "l" * (len(block.heads) - 2) + r"p{0.55\linewidth}l"
    heads = " & ".join(tex_text(head) for head in block.heads)
    rows = "".join(" & ".join(_part(cell) for cell in row) + " \\\\\n" for row in block.rows)
    return f"\\begin{{longtable}}{{@{{}}{columns}}}\n{heads} \\\\\n\\hline\n{rows}\\end{{longtable}}"
