"""The document as plain text. Products are written side by side, so that every formula can be read back."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Sequence
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
from graphkin.equations.layout import (
    Call,
    Exp,
    Frac,
    Grid,
    Letter,
    Minus,
    Node,
    Num,
    Op,
    Paren,
    Pow,
    Root,
    Row,
    Word,
)  # fmt: skip
from graphkin.equations.symbols import Symbol
from graphkin.say.text_table import aligned, padded, width

_DOTS = {0: "", 1: "\u0307", 2: "\u0308"}
_POWERS = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")
_NUMBERED_AT = 88
_PIECES = re.compile(r"[\u4e00-\u9fff][，。；：、）]*\s*|[^\s\u4e00-\u9fff]+\s*")
"""Words, and Chinese characters with the signs that may not begin a line."""


def write_text(document: Document) -> str:
    """The whole document, ending in a newline; no line ends in blanks."""
    lines = [document.title, "=" * width(document.title)]
    for block in document.blocks:
        lines += ["", *written] if (written := _block(block)) else []
    return "\n".join(line.rstrip() for line in lines) + "\n"


def _block(block: Block) -> list[str]:
    match block:
        case DocumentHeading():
            return [block.text, ("-" if block.level == 2 else "·") * width(block.text)]
        case DocumentSentence():
            return _wrapped("".join(part if isinstance(part, str) else inline(part) for part in block.parts))
        case Display():
            return _display(block)
        case DocumentTable():
            return _table(block)
        case FigureNode():
            return []
        case _:
            assert_never(block)


def _wrapped(text: str) -> list[str]:
    """Lines of a terminal's width, broken at blanks or between Chinese characters."""
    lines = [""]
    for word in _PIECES.findall(text):
        if lines[-1] and width(lines[-1] + word.rstrip()) > _NUMBERED_AT:
            lines.append("")
        lines[-1] += word
    return lines


def _display(block: Display) -> list[str]:
    lines = [line for row in block.rows for line in _beside([*_sides(row)])]
    number = f"({block.number})"
    lines[-1] += " " * max(3, _NUMBERED_AT - 4 - width(lines[-1])) + number
    return ["    " + line for line in lines]


def _sides(row: Sequence[Node]) -> list[Node]:
    """A chain of equal sides as nodes; products with matrices in them taken apart."""
    found: list[Node] = []
    for k, side in enumerate(row):
        found += [Op("=")] if k else []
        found += side.items if isinstance(side, Row) and _has_grid(side) else [side]
    return found


def _has_grid(node: Row) -> bool:
    return any(isinstance(item, Grid) or (isinstance(item, Minus) and isinstance(item.of, Grid)) for item in node.items)


def _beside(nodes: Sequence[Node]) -> list[str]:
    """Nodes side by side; matrices make as many lines as they have rows, the rest stands on the middle one."""
    columns = [_matrix(node) if isinstance(node, Grid) else [inline(node)] for node in nodes]
    height = max(len(column) for column in columns)
    lines = [""] * height
    for column in columns:
        top = (height - len(column)) // 2
        wide = max(width(text) for text in column)
        for k in range(height):
            text = column[k - top] if top <= k < top + len(column) else ""
            lines[k] += (" " if lines[k] else "") + padded(text, wide)
    return [line.rstrip() for line in lines] if height == 1 else lines


def _matrix(grid: Grid) -> list[str]:
    rows = aligned([[inline(entry) for entry in row] for row in grid.rows], "<", "   ")
    if len(rows) == 1:
        return [f"[ {rows[0]} ]"]
    ends = [("⎡", "⎤"), *[("⎢", "⎥")] * (len(rows) - 2), ("⎣", "⎦")]
    return [f"{left} {row} {right}" for (left, right), row in zip(ends, rows, strict=True)]


def _table(block: DocumentTable) -> list[str]:
    cells = [list(block.heads), *([_cell(entry) for entry in row] for row in block.rows)]
    return ["    " + line for line in aligned(cells, "<")]


def _cell(entry: str | Node) -> str:
    return entry if isinstance(entry, str) else inline(entry)


def symbol_text(symbol: Symbol) -> str:
    """`θ3`, `l3'`, `s_E`, `ω_guide`."""
    letter = unicodedata.normalize("NFC", symbol.letter + _DOTS[symbol.dots])
    low = symbol.low if symbol.low.isdigit() or not symbol.low else "_" + symbol.low
    return letter + low + "'" * symbol.primes


def inline(node: Node) -> str:
    """A formula on one line."""
    match node:
        case Letter():
            return symbol_text(node.symbol)
        case Num() | Op() | Word():
            return node.text
        case Minus():
            return f"−{inline(node.of)}"
        case Row():
            return " ".join(inline(item) for item in node.items).replace(" ,", ",")
        case Frac():
            return f"{_closed(node.top, product=True)} / {_closed(node.bottom)}"
        case Root():
            return f"√({inline(node.of)})"
        case Pow():
            return _power(node)
        case Exp():
            return f"e^({inline(node.power)})"
        case Call():
            return _call(node.name, node.args)
        case Paren():
            return f"({inline(node.of)})"
        case Grid():
            return "; ".join("  ".join(inline(entry) for entry in row) for row in node.rows)
        case _:
            assert_never(node)


def _power(node: Pow) -> str:
    raised = str(node.power).translate(_POWERS)
    if isinstance(node.of, Call):
        return _call(node.of.name + raised, node.of.args)
    return inline(node.of) + raised


def _call(name: str, args: Sequence[Node]) -> str:
    if len(args) == 1 and isinstance(args[0], Letter):
        return f"{name} {inline(args[0])}"
    return f"{name}({', '.join(inline(arg) for arg in args)})"


def _closed(node: Node, product: bool = False) -> str:
    """One factor, or a bracket round it; above the line a product does without."""
    bare = isinstance(node, Letter | Num | Pow | Call | Paren)
    if product and isinstance(node, Row):
        bare = not any(isinstance(item, Op) for item in node.items)
    return inline(node) if bare else f"({inline(node)})"
