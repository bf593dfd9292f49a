"""The stretch that each driver gets along, and the position at any of its values.

Along each driver runs a parameter u in which the motion is smooth up to a dead point: there links move as the root of
the way that is left, so the driver's value goes like a cosine of u.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Literal

import numpy as np

from graphkin.base.value import bulky, frozen
from graphkin.construction import Plot, replay
from graphkin.errors import GraphkinError
from graphkin.model.mechanism import Driver
from graphkin.model.quantities import EDGE, driven
from graphkin.planning import Method
from graphkin.running.other_positions import reached
from graphkin.running.path import along, stride
from graphkin.studies.sweeps import Course, course, prove

Ends = Literal["line", "low", "high", "both"]  # where dead points are
_SHORT_OF_STOP = 1e-3  # the distance from a dead point at which the page ends [of the range]
_TURN = 2 * np.pi
_ASIDE_DEG, _ASIDE_PART = 0.05, 0.001  # nearer to a change point polygons are 0/0: as the motion of a sheet has it
_BESIDE = 1e-9  # beside the drawn position, which is told as its file has it, any is told alike [rad, m]


@frozen
class DriverRange:
    """A driver's way from `low` to `high` [rad, m]; `round`: high is low again, all positions alike."""

    driver: Driver
    low: float
    high: float
    ends: Ends
    round: bool = False

    @cached_property
    def wave(self) -> tuple[float, float] | None:
        """Middle and half of a cosine: at u the driver's value is middle - half cos u; None where it is u itself."""
        size = self.high - self.low
        match self.ends:
            case "line":
                return None
            case "both":
                return (self.low + self.high) / 2, size / 2
            case "low":
                return self.high, size
            case "high":
                return self.low, size

    @cached_property
    def span(self) -> tuple[float, float]:
        """The least and the greatest u."""
        if self.wave is None:
            return self.low, self.high
        short = float(np.arccos(1 - _SHORT_OF_STOP * (self.high - self.low) / self.wave[1]))
        return np.pi / 2 if self.ends == "high" else short, np.pi / 2 if self.ends == "low" else np.pi - short

    def value(self, u: float) -> float:
        """The driver's value [rad, m]."""
        return u if self.wave is None else self.wave[0] + self.wave[1] * float(np.sin(u - np.pi / 2))

    def u_at(self, value: float) -> float:
        """The parameter of a value: within a turn, or at most the ends'."""
        if self.round:
            return self.low + (value - self.low) % (self.high - self.low)
        middle, half = self.wave or (0.0, 1.0)
        u = value if self.wave is None else float(np.arccos(np.clip((middle - value) / half, -1.0, 1.0)))
        return min(max(u, self.span[0]), self.span[1])

    @property
    def reached(self) -> tuple[float, float]:
        """The least and the greatest value that the page shows [rad, m]."""
        return (self.low, self.high) if self.round else (self.value(self.span[0]), self.value(self.span[1]))

    def even(self, count: int) -> np.ndarray:
        """So many places, from end to end; round and round without the last, which is the first again."""
        return np.linspace(*self.span, count, endpoint=not self.round)

    @property
    def turns(self) -> float:
        """Its length [turns]; of a slide half of that."""
        return (self.high - self.low) / _TURN if self.driver.kind != "slide" else 0.5


@bulky
class Reach:
    """A method's reachable positions by the values of its drivers; courses: of each driver alone."""

    method: Method
    courses: tuple[Course, ...]

    @classmethod
    def of(cls, method: Method) -> Reach:
        drawn = method.facts(None).values
        units = [EDGE[driven(driver.kind == "slide")].factor for driver in method.drivers]
        courses = list[Course]()
        for k, driver in enumerate(method.drivers):
            others = {other.name: float(drawn[n]) * units[n] for n, other in enumerate(method.drivers) if n != k}
            one = course(method, others)
            assert one.driver == driver
            courses.append(one)
            prove(one)
        return cls(method, tuple(courses))

    @cached_property
    def axes(self) -> tuple[DriverRange, ...]:
        return tuple(map(self._axis, self.courses))

    @cached_property
    def drawn(self) -> tuple[float, ...]:
        """The parameters of the drawn position."""
        values = self.method.facts(None).values
        return tuple(axis.u_at(float(value)) for axis, value in zip(self.axes, values, strict=True))

    def _axis(self, one: Course) -> DriverRange:
        if one.full_turn:
            return DriverRange(one.driver, 0.0, _TURN, "line", self._comes_round(one))
        low, high = one.reach
        stops = [float(one.value(stop.at).real) for stop in one.stops]
        dead = low in stops, high in stops
        if one.driver.kind == "slide":  # what slides without an end is shown near by, or all else were small
            start, size = one.path.start[one.swept], self.method.size
            low, high = low if dead[0] else max(low, start - size / 2), high if dead[1] else min(high, start + size / 2)
        ends: Ends = "both" if all(dead) else "low" if dead[0] else "high" if dead[1] else "line"
        return DriverRange(one.driver, low, high, ends)

    def _comes_round(self, one: Course) -> bool:
        """True if all points are after a turn where they were."""
        if len(self.courses) > 1:
            return not self.method.moves_on
        start, end = (along(self.method, one.path, one.at(value)) for value in (0.01, 0.01 + _TURN))
        near = 1e-7 * self.method.size
        same = all(abs(complex(end.position[name]) - complex(place)) < near for name, place in start.position.items())
        return same and not self.method.structure.contacts

    def clear(self, driver: int, us: Sequence[float] | np.ndarray) -> np.ndarray:
        """Places along one driver, those at its change points beside them: there polygons are 0/0."""
        one, axis = self.courses[driver], self.axes[driver]
        aside, clear = stride(self.method, one.path.pace, _ASIDE_DEG, _ASIDE_PART), np.array(us, dtype=float)
        for k, value in enumerate(map(axis.value, us)):
            near = (change.at for change in one.path.changes if abs(float(one.at(value)) - change.at) < aside)
            if (at := next(near, None)) is not None:
                beside = [float(one.value(at + way * aside).real) for way in (2, -2)]
                there = next((each for each in beside if axis.round or axis.low < each < axis.high), value)
                clear[k] = axis.u_at(there) if axis.wave else clear[k] + there - value
        return clear

    def values(self, us: Sequence[float]) -> tuple[float, ...]:
        """The drivers' values, beside the drawn ones."""
        values = (axis.value(u) for axis, u in zip(self.axes, us, strict=True))
        drawn = map(float, self.method.facts(None).values)
        return tuple(value + _BESIDE * (abs(value - own) < _BESIDE) for value, own in zip(values, drawn, strict=True))

    def plot(self, us: Sequence[float]) -> Plot | None:
        """The position, and the polygons to it; None where the mechanism does not get."""
        values = self.values(us)
        try:
            if len(values) == 1:
                path, t = self.courses[0].path, float(self.courses[0].at(values[0]))
            else:
                path, t = reached(self.method, values)
            plot = along(self.method, path, t)
            return replay(self.method.acceleration, replay(self.method.velocity, plot))
        except GraphkinError:
            return None
