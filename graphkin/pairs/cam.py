"""Cam pair: two profiles touch and slide. Each is a circle (radius 0: a knife edge) or a straight line."""

from __future__ import annotations

from typing import ClassVar

from graphkin.pairs.line import Line
from graphkin.value import frozen

__all__ = ["Cam", "Profile"]


@frozen
class Profile:
    """A circle about `centre` with `radius` [m], or a `line` (`left`: the other profile lies left of it)."""

    centre: str | None
    radius: float
    line: Line | None
    left: bool


@frozen
class Cam:
    """One `[[cam]]`: two links and their profiles; circles touch outside unless `internal`."""

    table: ClassVar[str] = "cam"

    links: tuple[str, str]
    profiles: tuple[Profile, Profile]
    internal: bool

    @property
    def joins(self) -> tuple[str, ...]:
        return self.links
