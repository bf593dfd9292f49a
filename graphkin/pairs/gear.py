"""Gear pair: two pitch circles roll on each other; other links keep the distance of their centres."""

from __future__ import annotations

from typing import ClassVar

from graphkin.value import frozen

__all__ = ["Gear"]


@frozen
class Gear:
    """One `[[gear]]`: two links, their centres and pitch radii [m]; `internal` if one rim encloses the other."""

    table: ClassVar[str] = "gear"

    links: tuple[str, str]
    centres: tuple[str, str]
    radii: tuple[float, float]
    internal: bool

    @property
    def joins(self) -> tuple[str, ...]:
        return self.links
