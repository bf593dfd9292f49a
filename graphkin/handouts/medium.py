"""A medium: how each kind of block is written in it. Which writer a block wants is known here alone."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, NoReturn, assert_never

from graphkin.base.value import frozen
from graphkin.handouts.document import (
    Block,
    FormulaLine,
    GridRoom,
    HandoutHeading,
    HandoutPicture,
    HandoutTable,
    NewPage,
    Paragraph,
    TermRows,
)


def _nowhere(block: Any) -> NoReturn:
    raise AssertionError(f"{type(block).__name__} has no place in a solution of words alone")


@frozen
class Medium:
    """One writer a kind of block; a medium of words alone leaves the last four out."""

    heading: Callable[[HandoutHeading], str]
    text: Callable[[Paragraph], str]
    formula: Callable[[FormulaLine], str]
    rows: Callable[[TermRows], str]
    picture: Callable[[HandoutPicture], str] = _nowhere
    room: Callable[[GridRoom], str] = _nowhere
    table: Callable[[HandoutTable], str] = _nowhere
    new_page: Callable[[NewPage], str] = _nowhere

    def written(self, blocks: Iterable[Block], between: str = "\n") -> str:
        """The blocks one after the other."""
        return between.join(map(self._written, blocks))

    def _written(self, block: Block) -> str:
        match block:
            case HandoutHeading():
                return self.heading(block)
            case Paragraph():
                return self.text(block)
            case FormulaLine():
                return self.formula(block)
            case TermRows():
                return self.rows(block)
            case HandoutPicture():
                return self.picture(block)
            case GridRoom():
                return self.room(block)
            case HandoutTable():
                return self.table(block)
            case NewPage():
                return self.new_page(block)
            case _:
                assert_never(block)
