"""A formula as it stands on paper: fractions, roots, powers, matrices. Three writers read it: text, LaTeX, MathML."""

from __future__ import annotations

from graphkin.base.value import frozen
from graphkin.equations.symbols import Symbol


@frozen
class Letter:
    """A symbol; `bold` for matrices."""

    symbol: Symbol
    bold: bool = False


@frozen
class Num:
    """A number, written; `90°` too."""

    text: str


@frozen
class Op:
    """+, −, ±, =, · or / between two nodes."""

    text: str


@frozen
class Word:
    """Upright letters that are no function: i."""

    text: str


@frozen
class Minus:
    """A sign before a product."""

    of: Node


@frozen
class Row:
    """Nodes side by side: a product, or a sum with its signs."""

    items: tuple[Node, ...]


@frozen
class Frac:
    top: Node
    bottom: Node


@frozen
class Root:
    of: Node


@frozen
class Pow:
    of: Node
    power: int


@frozen
class Exp:
    """e to a power."""

    power: Node


@frozen
class Call:
    """A function by its name: sin, tan, atan2."""

    name: str
    args: tuple[Node, ...]


@frozen
class Paren:
    of: Node


@frozen
class Grid:
    """A matrix; a column where its rows have one entry."""

    rows: tuple[tuple[Node, ...], ...]


Node = Letter | Num | Op | Word | Minus | Row | Frac | Root | Pow | Exp | Call | Paren | Grid
