"""Rolling pair: a wheel rolls without slip on a line or a circle of another link and stays in contact."""

from __future__ import annotations

from typing import ClassVar

from graphkin.pairs.line import Line
from graphkin.value import frozen

__all__ = ["Roll"]


@frozen
class Roll:
    """One `[[roll]]`; lengths in metres.

    line                            the track, for a wheel on a line (`left`: its centre lies left of it), else None
    track, track_centre, track_radius  the circle rolled on, for a wheel on a circle (`internal`: inside it)
    """

    table: ClassVar[str] = "roll"

    name: str
    named: bool
    wheel: str
    centre: str
    radius: float
    track: str
    line: Line | None
    left: bool
    track_centre: str | None
    track_radius: float
    internal: bool

    @property
    def joins(self) -> tuple[str, ...]:
        return (self.track, self.wheel)
