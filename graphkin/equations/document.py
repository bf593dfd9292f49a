"""What the writers write: headings, sentences with formulas in them, displayed equations, tables, a figure."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

from graphkin.base.value import frozen
from graphkin.equations.layout import Node
from graphkin.errors import Lang
from graphkin.sheet import Sheet

By = Literal["complex", "matrix"]
Words = tuple[str | Node, ...]


@frozen
class DocumentHeading:
    text: str
    level: int = 2


@frozen
class DocumentSentence:
    """Words, and formulas in the line."""

    parts: Words


@frozen
class Display:
    """Equations one under another, each a chain of sides that are equal; numbered together."""

    rows: tuple[tuple[Node, ...], ...]
    number: int


@frozen
class DocumentTable:
    heads: tuple[str, ...]
    rows: tuple[tuple[str | Node, ...], ...]


@frozen
class FigureNode:
    """A figure, drawn where it is asked for: text has none."""

    draw: Callable[[], Sheet]


Block = DocumentHeading | DocumentSentence | Display | DocumentTable | FigureNode


@frozen
class Document:
    """The equations of one mechanism by one method."""

    title: str
    blocks: tuple[Block, ...]
    by: By
    lang: Lang
    name: str
