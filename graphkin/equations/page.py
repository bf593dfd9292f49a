"""A document in the making: blocks one after another, equations numbered as they come."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field

from graphkin.equations.document import Block, Display, DocumentHeading, DocumentSentence, DocumentTable
from graphkin.equations.layout import Node
from graphkin.errors import Lang
from graphkin.say.catalogue import phrase, say


@dataclass
class EquationPage:
    """`say` writes a sentence by its key, `show` an equation; `show` gives the equation's number."""

    lang: Lang
    blocks: list[Block] = field(default_factory=list)
    shown: int = 0

    def head(self, key: str, level: int = 2, /, **words: str | int) -> None:
        self.blocks.append(DocumentHeading(say(key, self.lang, **words), level))

    def say(self, key: str, /, **given: str | int | Node) -> None:
        """A sentence; what is given is put in where the phrase names it."""
        parts: list[str | Node] = []
        for k, piece in enumerate(re.split(r"\{(\w+)\}", phrase(key, self.lang))):
            if k % 2 == 0:
                parts += [piece] if piece else []
                continue
            value = given[piece]
            parts.append(str(value) if isinstance(value, str | int) else value)
        self.blocks.append(DocumentSentence(tuple(parts)))

    def show(self, *rows: Iterable[Node]) -> int:
        self.shown += 1
        self.blocks.append(Display(tuple(tuple(row) for row in rows), self.shown))
        return self.shown

    def table(self, heads: Iterable[str], rows: Iterable[Iterable[str | Node]]) -> None:
        self.blocks.append(DocumentTable(tuple(heads), tuple(tuple(row) for row in rows)))

    def add(self, block: Block) -> None:
        self.blocks.append(block)
