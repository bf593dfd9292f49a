"""Pin in a circular slot: a point of one link stays on an arc of another, about a point of it."""

from __future__ import annotations

from typing import ClassVar

from graphkin.base.value import frozen
from graphkin.model.pairs.pair import Pair, Rod


@frozen
class CircularSlot(Pair):
    """One `[[slide]]` with a circle: `point` of `link` at `radius` [m] from `centre`, a point of the guide."""

    table: ClassVar[str] = "slide"

    name: str
    guide: str
    centre: str
    radius: float
    link: str
    point: str

    @property
    def joins(self) -> tuple[str, ...]:
        return (self.guide, self.link)

    @property
    def known_by(self) -> tuple[str, str]:
        return "circular slot", self.point

    @property
    def pin(self) -> str:
        return self.point

    @property
    def equivalent(self) -> Rod:
        """A bar from the slot's centre to the pin, for the whole motion."""
        return Rod((self.guide, self.link), (self.centre, self.point), self.radius)
