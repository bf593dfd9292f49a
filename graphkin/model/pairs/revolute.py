"""Revolute pair (hinge): links share a point."""

from __future__ import annotations

from typing import ClassVar

from graphkin.base.value import frozen
from graphkin.model.pairs.pair import Pair


@frozen
class Revolute(Pair):
    """`links` (the frame may be one) all turn about `point`; three or more make a multiple hinge."""

    table: ClassVar[str] = ""

    point: str
    links: tuple[str, ...]

    @property
    def joins(self) -> tuple[str, ...]:
        return self.links

    @property
    def lower(self) -> bool:
        return True
