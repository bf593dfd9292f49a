"""A medium: how each kind of block is written in it. Which writer a block wants is known here alone."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, NoReturn, assert_never

from graphkin.base.value import frozen
from graphkin.handouts.document import Block, Formula, Heading, NewPage, Picture, Room, Rows, Table, Text


def _nowhere(block: Any) -> NoReturn:
    raise AssertionError(f"{type(block).__name__} has no place in a solution of words alone")


@frozen
class Medium:
    """One writer a kind of block; a medium of words alone leaves the last four out."""

    heading: Callable[[Heading], str]
    text: Callable[[Text], str]
    formula: Callable[[Formula], str]
    rows: Callable[[Rows], str]
    picture: Callable[[Picture], str] = _nowhere
    room: Callable[[Room], str] = _nowhere
    table: Callable[[Table], str] = _nowhere
    new_page: Callable[[NewPage], str] = _nowhere

    def written(self, blocks: Iterable[Block], between: str = "\n") -> str:
        """The blocks one after the other."""
        return between.join(map(self._written, blocks))

    def _written(self, block: Block) -> str:
        match block:
            case Heading():
                return self.heading(block)
            case Text():
                return self.text(block)
            case Formula():
                return self.formula(block)
            case Rows():
                return self.rows(block)
            case Picture():
                return self.picture(block)
            case Room():
                return self.room(block)
            case Table():
                return self.table(block)
            case NewPage():
                return self.new_page(block)
            case _:
                assert_never(block)
