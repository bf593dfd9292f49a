"""Formulas as LaTeX."""

from __future__ import annotations

from collections.abc import Sequence
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
from graphkin.equations.symbols import Symbol
from graphkin.outputs.tex_words import tex_text

_GREEK = {
    "α": r"\alpha", "β": r"\beta", "γ": r"\gamma", "δ": r"\delta", "θ": r"\theta", "φ": r"\varphi", "ω": r"\omega",
    "μ": r"\mu", "π": r"\pi",
}  # fmt: skip
_OPS = {"−": "-", "±": r"\pm", "·": r"\cdot"}


def latex(node: Node) -> str:
    """A formula, for math mode."""
    match node:
        case Letter():
            return rf"\boldsymbol{{{symbol_latex(node.symbol)}}}" if node.bold else symbol_latex(node.symbol)
        case Num():
            return node.text.replace("°", r"^\circ").replace("·10^(", r"\cdot 10^{").replace(")", "}").replace("−", "-")
        case Op():
            return _OPS.get(node.text, node.text)
        case Word():
            return rf"\mathrm{{{node.text}}}"
        case Minus():
            return f"-{latex(node.of)}"
        case Row():
            return " ".join(latex(item) for item in node.items)
        case Frac():
            return rf"\frac{{{latex(node.top)}}}{{{latex(node.bottom)}}}"
        case Root():
            return rf"\sqrt{{{latex(node.of)}}}"
        case Pow():
            return _power(node)
        case Exp():
            return rf"\mathrm{{e}}^{{{latex(node.power)}}}"
        case Call():
            return _name(node.name) + _args(node.args)
        case Paren():
            return f"({latex(node.of)})"
        case Grid():
            return _grid(node)
        case _:
            assert_never(node)


def symbol_latex(symbol: Symbol) -> str:
    r"""\theta_{3}, l_{3}', \dot{s}_{E}, \omega_{\mathrm{guide}}."""
    letter = _GREEK.get(symbol.letter, symbol.letter)
    letter = {0: letter, 1: rf"\dot{{{letter}}}", 2: rf"\ddot{{{letter}}}"}[symbol.dots]
    return letter + (f"_{{{_low(symbol.low)}}}" if symbol.low else "") + "'" * symbol.primes


def _low(low: str) -> str:
    """Digits and single letters as they are, words upright."""
    if low.isdigit() or len(low) == 1:
        return low
    return rf"\mathrm{{{low.replace('_', chr(92) + '_')}}}" if low.isascii() else rf"\text{{{tex_text(low)}}}"


def _power(node: Pow) -> str:
    if isinstance(node.of, Call):
        return f"{_name(node.of.name)}^{{{node.power}}}{_args(node.of.args)}"
    inner = latex(node.of)
    return f"{{{inner}}}^{{{node.power}}}" if "'" in inner else f"{inner}^{{{node.power}}}"


def _name(name: str) -> str:
    return rf"\{name}" if name in ("sin", "cos", "tan") else rf"\operatorname{{{name}}}"


def _args(args: Sequence[Node]) -> str:
    if len(args) == 1 and isinstance(args[0], Letter):
        return f" {latex(args[0])}"
    return f"({', '.join(latex(arg) for arg in args)})"


def _grid(grid: Grid) -> str:
    rows = r" \\ ".join(" & ".join(latex(entry) for entry in row) for row in grid.rows)
    columns = "c" * len(grid.rows[0])
    return rf"\left[\begin{{array}}{{{columns}}} {rows} \end{{array}}\right]"
