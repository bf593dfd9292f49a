"""A document, its headings, sentences with formulas, displayed equations, tables, a figure; and one in the making."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Literal

from graphkin.base.value import bulky, frozen
from graphkin.equations.expressions import Sum, Symbol
from graphkin.equations.formulas import ZERO, Letter, Node, Op, Row
from graphkin.errors import Lang
from graphkin.say.catalogue import phrase, say

if TYPE_CHECKING:
    from graphkin.sheet import Sheet

By = Literal["complex", "matrix"]
Cell = str | Node  # words or a formula


@frozen
class DocumentHeading:
    """The heading of a section (level 2) or of a part of one (3)."""

    text: str
    level: int = 2


@frozen
class DocumentSentence:
    """Words, and formulas in the line."""

    parts: tuple[Cell, ...]


@frozen
class Display:
    """Equations one under another, each a chain of sides that are equal; numbered together."""

    rows: tuple[tuple[Node, ...], ...]
    number: int


@frozen
class DocumentTable:
    """A table with a line of headings."""

    heads: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]


@frozen
class FigureNode:
    """A figure, drawn where it is asked for: text has none."""

    draw: Callable[[], Sheet]


Block = DocumentHeading | DocumentSentence | Display | DocumentTable | FigureNode


@bulky
class Document:
    """The equations of one mechanism by one method."""

    title: str
    blocks: tuple[Block, ...]
    lang: Lang
    name: str


@dataclass
class EquationPage:
    """Blocks one after another: `say` writes a sentence by its key, `show` equations, numbered as they come."""

    lang: Lang
    blocks: list[Block] = field(default_factory=list)
    shown: int = 0

    def head(self, key: str, level: int = 2, /, **words: str | int) -> None:
        self.blocks.append(DocumentHeading(say(key, self.lang, **words), level))

    def say(self, key: str, /, which: int = 0, **words: str | int | Node) -> None:
        """A sentence, its words and formulas put in where the phrase names them."""
        pieces = re.split(r"\{(\w+)\}", phrase(key, self.lang, which))
        parts = (words[piece] if k % 2 else piece for k, piece in enumerate(pieces) if piece)
        self.blocks.append(DocumentSentence(tuple(str(part) if isinstance(part, int) else part for part in parts)))

    def show(self, *rows: Iterable[Node]) -> None:
        self.shown += 1
        self.blocks.append(Display(tuple(tuple(row) for row in rows), self.shown))

    def say_derived(self, sums: Iterable[Sum], again: bool = False) -> None:
        """The sentence before a second derivative, with the rates that are zero in it: `.., with α1 = 0`."""
        pushes = (without_push(symbol) for of in sums for symbol in of.moving)
        zeros = [is_zero(push) for push in dict.fromkeys(pushes) if push is not None]
        if zeros:
            self.say("equations.derived steady", again, zero=listed(zeros))
        else:
            self.say("equations.derived", again)


def motion_of(driver: Symbol) -> list[Node]:
    """θ1, ω1 and α1, or α1 = 0 of a driver at constant speed."""
    moving = replace(driver, steady=False)
    assert moving.rate is not None
    assert moving.rate.rate is not None
    steady = without_push(driver)
    return [Letter(driver), Letter(moving.rate), Letter(moving.rate.rate) if steady is None else is_zero(steady)]


def without_push(symbol: Symbol) -> Symbol | None:
    """α1 of a driver at constant speed; None of what may speed up."""
    rate = symbol if symbol.kind == "rate" else symbol.rate
    return replace(rate, steady=False).rate if rate is not None and rate.kind == "rate" and rate.steady else None


def is_zero(symbol: Symbol) -> Node:
    """α1 = 0."""
    return Row((Letter(symbol), Op("="), ZERO))


def listed(items: Sequence[Symbol | Node]) -> Node:
    """θ2, θ3."""
    nodes = (Letter(item) if isinstance(item, Symbol) else item for item in items)
    return Row(tuple(part for node in nodes for part in (Op(","), node))[1:])
