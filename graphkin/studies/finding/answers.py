"""What was found, as data: SI units, radians."""

from __future__ import annotations

from typing import Literal

from graphkin.base.value import frozen
from graphkin.model.mechanism import Driver, Mechanism
from graphkin.studies.finding.conditions import Condition

Kind = Literal["zero", "touch", "max", "min", "largest", "end", "stop", "pole", "nearest", "here"]
"""zero: the condition holds there, and the difference changes its sign; touch: it comes to hold and turns back;
max, min: an extreme; largest: the greatest size, against the sense that counts as positive; end: of what was asked
for; stop: a dead point, where the value is what it tends to; pole: it grows without limit there; nearest: where the
condition comes nearest to holding; here: a position that was given."""


@frozen
class Position:
    """One position.

    t        where on the way
    drivers  their values [rad, m]
    values   of the quantities of the condition; infinite at a pole
    factors  of a Coriolis acceleration that is 0: which of its factors are, `omega 3`, `v B3B2`
    """

    t: float
    drivers: tuple[float, ...]
    values: tuple[float, ...]
    kind: Kind
    factors: tuple[str, ...] = ()


@frozen
class Interval:
    """Positions from `begin` to `end` at all of which the condition holds; `peak`: where it is passed the most."""

    begin: Position
    end: Position
    peak: Position


@frozen
class Phase:
    """The way of an output from one end of its stroke to the other.

    angle  how far the driver turns meanwhile [rad]
    time   [s], mean: mean speed of the output [m/s, rad/s]; None where the driver's speed is not constant, or zero
    up     whether the quantity grows
    """

    up: bool
    angle: float
    time: float | None
    mean: float | None


@frozen
class OutputStroke:
    """Advance (the slower one) and return of an output, and the coefficient of travel speed variation K."""

    advance: Phase
    retreat: Phase
    ratio: float


@frozen
class SlowPoint:
    """The slowest point of the line of two points of a link.

    along   its distance from the first point towards the second [m]; None where all points are equally fast
    length  distance of the two points [m]
    place   where it is [m]
    speed   [m/s]
    """

    position: Position
    points: tuple[str, str]
    along: float | None
    length: float
    place: complex
    speed: float


@frozen
class Speeds:
    """What the drivers' speeds must be.

    factor  times what they are in the file; rates [rad/s, m/s]; value of the quantity as it was
    """

    position: Position
    factor: float
    rates: tuple[float, ...]
    value: float


@frozen
class Findings:
    """The answer to one condition.

    swept       number of the driver by whose value positions are named; looked: from where to where [rad, m]
    turn        whether that is a full turn, which brings all back
    stopped     whether it ends at a dead point, at its beginning and at its end
    units       of `values` of a position, by quantity; guided: which of them count along a guide of the frame
    everywhere  whether the condition holds at every position (an extreme: the quantity never changes)
    zero        whether the quantity is zero throughout, but for rounding
    swing       greatest less least value, for `range` and `stroke`; None where it has none
    notes       further remarks, as the catalogue has them: `finding.note ..`
    """

    condition: Condition
    mechanism: Mechanism
    drivers: tuple[Driver, ...]
    swept: int
    looked: tuple[float, float] | None
    turn: bool
    stopped: tuple[bool, bool]
    quantities: tuple[str, ...]
    units: tuple[str, ...]
    guided: tuple[bool, ...]
    positions: tuple[Position, ...] = ()
    intervals: tuple[Interval, ...] = ()
    nearest: Position | None = None
    everywhere: bool = False
    zero: bool = False
    swing: float | None = None
    stroke: OutputStroke | None = None
    slow: tuple[SlowPoint, ...] = ()
    speeds: tuple[Speeds, ...] = ()
    notes: tuple[str, ...] = ()

    @property
    def shown(self) -> tuple[Position, ...]:
        """Positions that can be drawn, each once."""
        found = [*self.positions, *(p for i in self.intervals for p in (i.begin, i.peak, i.end))]
        found += [slow.position for slow in self.slow] + [speeds.position for speeds in self.speeds]
        each = {position.t: position for position in found if position.kind not in ("stop", "pole")}
        return tuple(each[t] for t in sorted(each))
