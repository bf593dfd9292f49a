"""Gear pair: two pitch circles roll on each other; other links keep the distance of their centres."""

from __future__ import annotations

from typing import ClassVar

from graphkin.base.value import frozen
from graphkin.model.pairs.pair import Circle, Pair, Rod, Rolling, centre_distance


@frozen
class Gear(Pair):
    """One `[[gear]]`: two links, their centres and pitch radii [m]; `internal` if one rim encloses the other."""

    table: ClassVar[str] = "gear"

    name: str
    links: tuple[str, str]
    centres: tuple[str, str]
    radii: tuple[float, float]
    internal: bool

    @property
    def joins(self) -> tuple[str, ...]:
        return self.links

    @property
    def equivalent(self) -> Rod:
        """The line of centres; other links keep their distance."""
        return Rod(self.links, self.centres, centre_distance(self.radii, self.internal), carried=True, follows=True)

    @property
    def rolling(self) -> Rolling:
        return Rolling(self.links, self.centres, self.radii, self.internal)

    @property
    def circles(self) -> tuple[Circle, ...]:
        return tuple(zip(self.links, self.centres, self.radii, strict=True))
