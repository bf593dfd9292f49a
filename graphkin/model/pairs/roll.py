"""Rolling pair: a wheel rolls without slip on a line or a circle of another link and stays in contact."""

from __future__ import annotations

from typing import ClassVar

from graphkin.base.value import frozen
from graphkin.model.pairs.pair import Circle, Line, Pair, Rod, Rolling, Slot, centre_distance


@frozen
class RollingContact(Pair):
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

    @property
    def given(self) -> str:
        return self.name if self.named else ""

    @property
    def lower(self) -> bool:
        return True

    @property
    def equivalent(self) -> Rod | Slot:
        """The wheel's centre stays beside a line, or at one distance from a circle's centre."""
        if (path := self.path) is not None:
            return path
        assert self.track_centre is not None
        length = centre_distance((self.track_radius, self.radius), self.internal)
        return Rod((self.track, self.wheel), (self.track_centre, self.centre), length, carried=True)

    @property
    def rolling(self) -> Rolling:
        centres, radii = (self.track_centre or "", self.centre), (self.track_radius, self.radius)
        return Rolling((self.track, self.wheel), centres, radii, self.internal, self.line, self.left)

    @property
    def path(self) -> Slot | None:
        """On a line, the slot in which the wheel's centre moves."""
        return None if self.line is None else Slot(self.line, self.centre, self.radius if self.left else -self.radius)

    @property
    def circles(self) -> tuple[Circle, ...]:
        rim = ((self.track, self.track_centre, self.track_radius),) if self.track_centre is not None else ()
        return (*rim, (self.wheel, self.centre, self.radius))

    @property
    def lines(self) -> tuple[Line, ...]:
        return () if self.line is None else (self.line,)
