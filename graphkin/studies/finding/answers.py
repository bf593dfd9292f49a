"""Answers to conditions, as data and for JSON: SI units, radians; what is infinite is null there."""

from __future__ import annotations

import math
from typing import Literal

from graphkin.base.plain import Plain
from graphkin.base.value import bulky, frozen
from graphkin.model.mechanism import Driver, Mechanism
from graphkin.planning import Method
from graphkin.studies.finding.conditions import Condition

Kind = Literal["zero", "touch", "max", "min", "largest", "end", "stop", "pole", "nearest", "here"]
"""zero: the condition holds there, and the difference changes its sign; touch: it comes to hold and turns back;
max, min: an extreme; largest: the greatest size, against the sense that counts as positive; end: of the stretch;
stop: a dead point, where the value is what it tends to; pole: it grows without limit there; nearest: where the
condition comes nearest to holding; here: a position that was given."""


@frozen
class Position:
    """One position.

    t        on the path
    drivers  their values [rad, m]
    values   of the quantities of the condition; infinite at a pole
    factors  of a Coriolis acceleration that is 0: those of its factors that are 0, `omega 3`, `v B3B2`
    """

    t: float
    drivers: tuple[float, ...]
    values: tuple[float, ...]
    kind: Kind
    factors: tuple[str, ...] = ()


@frozen
class Interval:
    """Positions from `begin` to `end` at all of which the condition holds; `peak`: the one farthest past it."""

    begin: Position
    end: Position
    peak: Position


@frozen
class Phase:
    """The motion of an output from one end of its stroke to the other.

    angle  by which the driver turns meanwhile [rad]
    time   [s], mean: mean speed of the output [m/s, rad/s]; None where the driver's speed is not constant, or zero
    up     the quantity grows
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
    place   [m]; speed [m/s]
    """

    position: Position
    points: tuple[str, str]
    along: float | None
    length: float
    place: complex
    speed: float


@frozen
class Speeds:
    """Speeds of the drivers that make a quantity have its value.

    factor  by which those of the file are multiplied; rates [rad/s, m/s]; value of the quantity as it was
    """

    position: Position
    factor: float
    rates: tuple[float, ...]
    value: float


@bulky
class Findings:
    """The answer to one condition.

    swept       number of the driver by whose value positions are named; looked: its least and greatest value [rad, m]
    turn        that is a full turn, which brings all back
    stopped     the stretch begins, ends at a dead point
    units       of `values` of a position, by quantity
    everywhere  the condition holds at every position (an extreme: the quantity never changes)
    zero        the quantity is zero throughout, but for rounding
    swing       greatest less least value, for `range` and `stroke`; None where it has none
    notes       further remarks, as the catalogue has them: `finding.note ..`
    """

    condition: Condition
    method: Method
    drivers: tuple[Driver, ...]
    swept: int
    looked: tuple[float, float] | None
    turn: bool
    stopped: tuple[bool, bool]
    quantities: tuple[str, ...]
    units: tuple[str, ...]
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
    def mechanism(self) -> Mechanism:
        return self.method.mechanism

    @property
    def shown(self) -> tuple[Position, ...]:
        """Positions that can be drawn, each once."""
        every = [*self.positions, *(p for i in self.intervals for p in (i.begin, i.peak, i.end))]
        every += [slow.position for slow in self.slow] + [speeds.position for speeds in self.speeds]
        drawable = {position.t: position for position in every if position.kind not in ("stop", "pole")}
        return tuple(drawable[t] for t in sorted(drawable))


def as_json(found: Findings) -> dict[str, Plain]:
    """One object; parts that have nothing to say are left out."""
    data: dict[str, Plain] = {
        "format": 1, "name": found.mechanism.name, "condition": found.condition.text,
        "drivers": [driver.name for driver in found.drivers], "units": dict(zip(found.quantities, found.units)),
    }  # fmt: skip
    if found.looked is not None:
        low, high = found.looked
        data["looked"] = {
            "driver": found.drivers[found.swept].name, "from": low, "to": high,
            "turn": found.turn, "dead_points": list(found.stopped),
        }  # fmt: skip
        data["everywhere"] = found.everywhere
        data["positions"] = [_position(found, position) for position in found.positions]
    parts: dict[str, Plain] = {
        "intervals": [
            {key: _position(found, getattr(part, key)) for key in ("begin", "end", "peak")} for part in found.intervals
        ],
        "nearest": _position(found, found.nearest) if found.nearest else None,
        "range": found.swing,
        "slowest": [
            {
                "drivers": list(slow.position.drivers), "line": list(slow.points), "from_first": slow.along,
                "length": slow.length, "place": [slow.place.real, slow.place.imag], "speed": slow.speed,
            }
            for slow in found.slow
        ],
        "speeds": [_speeds(found, entry) for entry in found.speeds],
        "notes": list(found.notes),
    }  # fmt: skip
    if found.stroke is not None:
        phases: dict[str, Plain] = {
            key: {"growing": phase.up, "angle": phase.angle, "time": phase.time, "mean_speed": phase.mean}
            for key, phase in (("advance", found.stroke.advance), ("return", found.stroke.retreat))
        }
        data["stroke"] = phases | {"K": found.stroke.ratio}
    return data | {key: part for key, part in parts.items() if part not in (None, [])}


def _position(found: Findings, position: Position) -> Plain:
    finite = (value if math.isfinite(value) else None for value in position.values)
    values: dict[str, Plain] = dict(zip(found.quantities, finite))
    return {"drivers": list(position.drivers), "values": values, "kind": position.kind}


def _speeds(found: Findings, entry: Speeds) -> Plain:
    rates = {driver.name: rate for driver, rate in zip(found.drivers, entry.rates)}
    return {"drivers": list(entry.position.drivers), "rates": rates, "factor": entry.factor, "value": entry.value}
