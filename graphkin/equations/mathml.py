"""Formulas as MathML Core: what browsers set by themselves, without a script."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from html import escape
from typing import assert_never

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
)

_DOTS = {1: "˙", 2: "¨"}

escaped = partial(escape, quote=False)
"""Text between tags, as it is written in XML. That of `xml.sax` loads all that reads from the net."""


def mathml(node: Node, display: bool = False) -> str:
    """A whole `math` element."""
    kind = ' display="block"' if display else ""
    return f"<math{kind}>{inner(node)}</math>"


def row(nodes: Sequence[Node]) -> str:
    return f"<mrow>{''.join(inner(node) for node in nodes)}</mrow>"


def inner(node: Node) -> str:
    """One element."""
    match node:
        case Letter():
            return _letter(node)
        case Num():
            return f"<mn>{escaped(node.text)}</mn>"
        case Op():
            return f"<mo>{escaped(node.text)}</mo>"
        case Word():
            return f'<mi mathvariant="normal">{escaped(node.text)}</mi>'
        case Minus():
            return f'<mrow><mo form="prefix">−</mo>{inner(node.of)}</mrow>'
        case Row():
            return row(node.items)
        case Frac():
            return f"<mfrac>{inner(node.top)}{inner(node.bottom)}</mfrac>"
        case Root():
            return f"<msqrt>{inner(node.of)}</msqrt>"
        case Pow():
            return _power(node)
        case Exp():
            return f'<msup><mi mathvariant="normal">e</mi>{inner(node.power)}</msup>'
        case Call():
            return f"<mrow>{_name(node.name)}{_args(node.args)}</mrow>"
        case Paren():
            return f"<mrow><mo>(</mo>{inner(node.of)}<mo>)</mo></mrow>"
        case Grid():
            return _grid(node)
        case _:
            assert_never(node)


def _letter(node: Letter) -> str:
    symbol = node.symbol
    style = ' style="font-weight:bold"' if node.bold else ""
    base = f"<mi{style}>{escaped(symbol.letter)}</mi>"
    if symbol.dots:
        base = f'<mover accent="true">{base}<mo>{_DOTS[symbol.dots]}</mo></mover>'
    tag = "mn" if symbol.low.isdigit() else "mi"
    low = f"<{tag}>{escaped(symbol.low)}</{tag}>"
    primes = f"<mo>{'′' * symbol.primes}</mo>"
    if symbol.low and symbol.primes:
        return f"<msubsup>{base}{low}{primes}</msubsup>"
    if symbol.low:
        return f"<msub>{base}{low}</msub>"
    return f"<msup>{base}{primes}</msup>" if symbol.primes else base


def _power(node: Pow) -> str:
    power = f"<mn>{node.power}</mn>"
    if isinstance(node.of, Call):
        return f"<mrow><msup>{_name(node.of.name, False)}{power}</msup>{_args(node.of.args)}</mrow>"
    return f"<msup>{inner(node.of)}{power}</msup>"


def _name(name: str, space: bool = True) -> str:
    return f'<mspace width="0.17em"/><mi>{name}</mi>' if space else f"<mi>{name}</mi>"


def _args(args: Sequence[Node]) -> str:
    if len(args) == 1 and isinstance(args[0], Letter):
        return f'<mspace width="0.17em"/>{inner(args[0])}'
    return f"<mrow><mo>(</mo>{'<mo>,</mo>'.join(inner(arg) for arg in args)}<mo>)</mo></mrow>"


def _grid(grid: Grid) -> str:
    rows = "".join("<mtr>" + "".join(f"<mtd>{inner(entry)}</mtd>" for entry in row) + "</mtr>" for row in grid.rows)
    return f'<mtable class="matrix">{rows}</mtable>'
