"""Formulas as they stand on paper, fractions, roots, powers, matrices, and the notations of text, LaTeX and MathML.

A `Notation` is the table of signs of one kind of file; `in_notation` writes any node by it.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Callable, Sequence
from functools import partial, reduce
from html import escape
from typing import assert_never

from graphkin.base.value import frozen
from graphkin.equations.expressions import Symbol
from graphkin.outputs.typesetting import tex_text

escaped = partial(escape, quote=False)
"""Text between tags, as it is written in XML. That of `xml.sax` loads all that reads from the net."""


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
    """A quotient."""

    top: Node
    bottom: Node


@frozen
class Root:
    """A square root."""

    of: Node


@frozen
class Pow:
    """A whole power."""

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
    """A node in brackets."""

    of: Node


@frozen
class Grid:
    """A matrix; a column where its rows have one entry."""

    rows: tuple[tuple[Node, ...], ...]


Node = Letter | Num | Op | Word | Minus | Row | Frac | Root | Pow | Exp | Call | Paren | Grid

ZERO = Num("0")


@frozen
class Notation:
    """The signs of one kind of file; `%s` stands for what a sign goes around.

    flat       fractions stand on one line, so their parts are bracketed
    space      before a function without a power
    arguments  around several of them, or one that is no letter; `argument` before a letter alone
    """

    flat: bool
    letter: Callable[[Letter], str]
    number: Callable[[str], str]
    operator: Callable[[str], str]
    function: Callable[[str], str]
    row: Callable[[list[str]], str]
    grid: Callable[[list[list[str]]], str]
    power: Callable[[str, int], str]
    word: str
    minus: str
    fraction: str
    root: str
    exponential: str
    bracket: str
    space: str
    call: str
    argument: str
    arguments: str
    comma: str


def in_notation(node: Node, by: Notation) -> str:
    """A formula in one of the notations."""
    match node:
        case Letter():
            return by.letter(node)
        case Num():
            return by.number(node.text)
        case Op():
            return by.operator(node.text)
        case Word():
            return by.word % node.text
        case Minus():
            return by.minus % in_notation(node.of, by)
        case Row():
            return by.row([in_notation(item, by) for item in node.items])
        case Frac():
            parts = (_factor(node.top, product=True), _factor(node.bottom)) if by.flat else (node.top, node.bottom)
            return by.fraction % tuple(in_notation(part, by) for part in parts)
        case Root():
            return by.root % in_notation(node.of, by)
        case Pow(of=Call(name, args)):
            return by.call % (by.power(by.function(name), node.power), _arguments(args, by))
        case Pow():
            return by.power(in_notation(node.of, by), node.power)
        case Exp():
            return by.exponential % in_notation(node.power, by)
        case Call():
            return by.call % (by.space + by.function(node.name), _arguments(node.args, by))
        case Paren():
            return by.bracket % in_notation(node.of, by)
        case Grid():
            return by.grid([[in_notation(entry, by) for entry in row] for row in node.rows])
        case _:
            assert_never(node)


def _arguments(args: Sequence[Node], by: Notation) -> str:
    if len(args) == 1 and isinstance(args[0], Letter):
        return by.argument + in_notation(args[0], by)
    return by.arguments % by.comma.join(in_notation(arg, by) for arg in args)


def _factor(node: Node, product: bool = False) -> Node:
    """One factor, or a bracket round it; above the line a product does without."""
    bare = isinstance(node, Letter | Num | Pow | Call | Paren)
    if product and isinstance(node, Row):
        bare = not any(isinstance(item, Op) for item in node.items)
    return node if bare else Paren(node)


_RAISED = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")
_DOTS = ("", "\u0307", "\u0308")


def symbol_text(symbol: Symbol) -> str:
    """`θ3`, `l3'`, `s_E`, `ω_guide`."""
    letter = unicodedata.normalize("NFC", symbol.letter + _DOTS[symbol.dots])
    low = symbol.low if symbol.low.isdigit() or not symbol.low else "_" + symbol.low
    return letter + low + "'" * symbol.primes


TEXT = Notation(
    flat=True, letter=lambda node: symbol_text(node.symbol), number=str, operator=str, function=str,
    row=lambda items: " ".join(items).replace(" ,", ","),
    grid=lambda rows: "; ".join("  ".join(row) for row in rows),
    power=lambda base, power: base + str(power).translate(_RAISED),
    word="%s", minus="−%s", fraction="%s / %s", root="√(%s)", exponential="e^(%s)", bracket="(%s)",
    space="", call="%s%s", argument=" ", arguments="(%s)", comma=", ",
)  # fmt: skip
"""Products are written side by side, so that every formula can be read back."""

_TEX_LETTERS = {
    "α": r"\alpha", "β": r"\beta", "γ": r"\gamma", "δ": r"\delta", "θ": r"\theta", "φ": r"\varphi", "ω": r"\omega",
    "μ": r"\mu", "π": r"\pi",
}  # fmt: skip
_TEX_FIGURES = (("°", r"^\circ"), ("·10^(", r"\cdot 10^{"), (")", "}"), ("−", "-"))
_TEX_OPERATORS = {"−": "-", "±": r"\pm", "·": r"\cdot"}


def _symbol_latex(node: Letter) -> str:
    r"""\theta_{3}, l_{3}', \dot{s}_{E}, \omega_{\mathrm{guide}}: digits and single letters, words upright."""
    symbol = node.symbol
    letter = ("%s", r"\dot{%s}", r"\ddot{%s}")[symbol.dots] % _TEX_LETTERS.get(symbol.letter, symbol.letter)
    low = symbol.low
    if not low.isdigit() and len(low) > 1:
        low = rf"\mathrm{{{low.replace('_', chr(92) + '_')}}}" if low.isascii() else rf"\text{{{tex_text(low)}}}"
    text = letter + (f"_{{{low}}}" if low else "") + "'" * symbol.primes
    return rf"\boldsymbol{{{text}}}" if node.bold else text


LATEX = Notation(
    flat=False, letter=_symbol_latex,
    number=lambda text: reduce(lambda text, sign: text.replace(*sign), _TEX_FIGURES, text),
    operator=lambda text: _TEX_OPERATORS.get(text, text),
    function=lambda name: rf"\{name}" if name in ("sin", "cos", "tan") else rf"\operatorname{{{name}}}",
    row=" ".join,
    grid=lambda rows: rf"\left[\begin{{array}}{{{'c' * len(rows[0])}}} "
    + r" \\ ".join(" & ".join(row) for row in rows) + r" \end{array}\right]",
    power=lambda base, power: f"{{{base}}}^{{{power}}}" if "'" in base else f"{base}^{{{power}}}",
    word=r"\mathrm{%s}", minus="-%s", fraction=r"\frac{%s}{%s}", root=r"\sqrt{%s}", exponential=r"\mathrm{e}^{%s}",
    bracket="(%s)", space="", call="%s%s", argument=" ", arguments="(%s)", comma=", ",
)  # fmt: skip
"""For math mode."""


def _symbol_mathml(node: Letter) -> str:
    symbol = node.symbol
    style = ' style="font-weight:bold"' if node.bold else ""
    base = f"<mi{style}>{escaped(symbol.letter)}</mi>"
    if symbol.dots:
        base = f'<mover accent="true">{base}<mo>{" ˙¨"[symbol.dots]}</mo></mover>'
    tag = "mn" if symbol.low.isdigit() else "mi"
    low = f"<{tag}>{escaped(symbol.low)}</{tag}>" if symbol.low else ""
    primes = f"<mo>{'′' * symbol.primes}</mo>" if symbol.primes else ""
    element = {(True, True): "msubsup", (True, False): "msub", (False, True): "msup"}.get((bool(low), bool(primes)))
    return base if element is None else f"<{element}>{base}{low}{primes}</{element}>"


_THIN_SPACE = '<mspace width="0.17em"/>'
MATHML = Notation(
    flat=False, letter=_symbol_mathml,
    number=lambda text: f"<mn>{escaped(text)}</mn>", operator=lambda text: f"<mo>{escaped(text)}</mo>",
    function=lambda name: f"<mi>{name}</mi>", row=lambda items: f"<mrow>{''.join(items)}</mrow>",
    grid=lambda rows: '<mtable class="matrix">' + "".join(
        "<mtr>" + "".join(f"<mtd>{entry}</mtd>" for entry in row) + "</mtr>" for row in rows
    ) + "</mtable>",
    power=lambda base, power: f"<msup>{base}<mn>{power}</mn></msup>",
    word='<mi mathvariant="normal">%s</mi>', minus='<mrow><mo form="prefix">−</mo>%s</mrow>',
    fraction="<mfrac>%s%s</mfrac>", root="<msqrt>%s</msqrt>",
    exponential='<msup><mi mathvariant="normal">e</mi>%s</msup>', bracket="<mrow><mo>(</mo>%s<mo>)</mo></mrow>",
    space=_THIN_SPACE, call="<mrow>%s%s</mrow>", argument=_THIN_SPACE,
    arguments="<mrow><mo>(</mo>%s<mo>)</mo></mrow>", comma="<mo>,</mo>",
)  # fmt: skip
"""MathML Core: what browsers set by themselves, without a script."""
