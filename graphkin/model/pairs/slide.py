"""Sliding (prismatic) pair, and pin in a slot.

A block does not turn against its guide and its point stays on the guide's line; a pin's point stays
on the line and may turn. Displacement s is measured along the line from its origin to the point.
"""

from __future__ import annotations

from typing import ClassVar

from graphkin.base.geometry import phase
from graphkin.base.value import frozen
from graphkin.model.pairs.pair import Line, Pair, Slot


@frozen
class Slide(Pair):
    """One `[[slide]]` with a line.

    name    as the file gives it, else `s0`, `s1`, .. by the order of the slides in the file
    named   whether the file gave the name
    line    the path, fixed in the guide `line.link`
    point   the point that stays on the line
    block   the link that slides without turning; None for a pin in a slot
    tilt    angle from the line to the block's axis (its first two points) [rad]; 0 for one point
    stands_for  the pair that it replaces, in a lower-pair equivalent
    """

    table: ClassVar[str] = "slide"

    name: str
    named: bool
    line: Line
    point: str
    block: str | None
    tilt: float
    stands_for: Pair | None = None

    @property
    def guide(self) -> str:
        return self.line.link

    @property
    def joins(self) -> tuple[str, ...]:
        return (self.guide,) if self.block is None else (self.guide, self.block)

    @property
    def given(self) -> str:
        return self.name if self.named else ""

    @property
    def known_by(self) -> tuple[str, str]:
        return "guide", self.point

    @property
    def pin(self) -> str:
        return self.point if self.block is None else ""

    @property
    def lower(self) -> bool:
        return self.block is not None

    @property
    def path(self) -> Slot:
        return Slot(self.line, self.point)

    @property
    def slipping(self) -> Slot | None:
        return None if self.lower else self.path

    @property
    def lines(self) -> tuple[Line, ...]:
        return (self.line,)

    @property
    def turn(self) -> float:
        """Angle from the guide's axis to the block's axis, fixed while the block slides [rad]."""
        return phase(self.line.direction) + self.tilt
