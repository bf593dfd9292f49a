"""Instant centres seen on paper: which lie on it, which beyond its edge, which at infinity, and on which lines.

Source: Sun Huan, 机械原理, section 3-2.2.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from functools import cached_property

import numpy as np

from graphkin.base.value import frozen
from graphkin.construction.drafting import LineStep, Stage, drawn_through
from graphkin.model.pairs import Cam, Pair, Rod
from graphkin.sheet.lettering import Label, Run, number, quantity_label
from graphkin.sheet.marks import Place
from graphkin.sheet.paper import Room
from graphkin.sheet.window import Window
from graphkin.studies.centres import Centres
from graphkin.studies.centres.underlay import CommonNormal

SAME = 0.05
"""Places closer than this are one on paper [mm]."""


@frozen
class Spot:
    """A centre at one position: the stage that finds it (the first is 1) and where it is.

    place   [m]; None at infinity. direction  where a centre at infinity lies, a unit vector; 0 for others
    """

    name: str
    number: int
    stage: Stage
    place: complex | None
    direction: complex = 0j


def spots(found: Centres) -> list[Spot]:
    """All centres in the order in which they are found."""
    return [_spot(found, stage, number) for number, stage in enumerate(found.centring.stages, start=1)]


def _spot(found: Centres, stage: Stage, number: int) -> Spot:
    name = stage.last.name
    place = complex(found.board.at(name))
    if cmath.isfinite(place):
        return Spot(name, number, stage, place)
    return Spot(name, number, stage, None, cmath.rect(1, float(found.board.direction(name))))


def centre_label(name: str) -> Label:
    """`P13` with its numbers as a subscript."""
    return quantity_label("P", name[1:])


def coordinates(found: Centres, place: complex) -> Label:
    """`(34.37, −115.6)`: in mm; what is smaller than rounding is 0."""
    shown = 1000 * complex(found.method.mechanism.usual.cut(place, "m"))
    return (Run("("), *number(shown.real), Run(", "), *number(shown.imag), Run(")"))


@frozen
class CentreLine:
    """A line on paper: a place on it and its unit direction, and the places of centres on it.

    normal  it is the common normal of two profiles, and no join of centres
    """

    at: Place
    way: complex
    stops: tuple[Place, ...]
    normal: bool = False

    def along(self, place: Place) -> float:
        """How far along the line a place lies [mm]."""
        return ((place - self.at) * self.way.conjugate()).real

    def point(self, t: float) -> Place:
        return self.at + t * self.way


@frozen
class OnPaper:
    """The centres through a window on the mechanism, in a room of the paper."""

    found: Centres
    window: Window
    room: Room

    @cached_property
    def spots(self) -> list[Spot]:
        return spots(self.found)

    @cached_property
    def by_name(self) -> dict[str, Spot]:
        return {spot.name: spot for spot in self.spots}

    def at(self, spot: Spot) -> Place:
        """Where a centre that is not at infinity lies, on the paper or beyond it."""
        assert spot.place is not None
        return self.window(spot.place)

    def shown(self, spot: Spot) -> bool:
        """Whether a centre lies in the room."""
        return spot.place is not None and self.room.holds(self.at(spot))

    def lines(self, spot: Spot) -> Iterator[CentreLine]:
        """The lines that give a centre, but for the line at infinity."""
        for line in spot.stage.lines if spot.stage.say == "two lines" else ():
            normal = self.found.centring.normals.get(line.name)
            seen = self._join(line, spot) if normal is None else self._normal(normal, spot)
            if seen is not None:
                yield seen

    def _own(self, spot: Spot) -> tuple[Place, ...]:
        return () if spot.place is None else (self.at(spot),)

    def _normal(self, normal: CommonNormal, spot: Spot) -> CentreLine:
        line = normal.line
        start = self.window(complex(self.found.plot.position[line.through]))
        way = self.window.turned(complex(self.found.plot.direction(line.direction)))
        return CentreLine(start, way / abs(way), (start, *self._contact(normal.pair), *self._own(spot)), normal=True)

    def _join(self, line: LineStep, spot: Spot) -> CentreLine | None:
        ends = [self.by_name[end] for end in drawn_through(line)]
        places = [self.at(end) for end in ends if end.place is not None]
        if not places:
            return None
        if len(places) == 2:
            way = places[1] - places[0]
        else:
            way = self.window.turned(next(end.direction for end in ends if end.place is None))
        near = min(places, key=lambda place: abs(place - self.room.middle))
        return CentreLine(near, way / abs(way), (*places, *self._own(spot)))

    def _contact(self, pair: Pair) -> Iterator[Place]:
        """Where the links of a pair touch, unless the normal is drawn from there."""
        position = self.found.plot.position
        if not isinstance(pair, Cam):
            yield from (self.window(complex(position[end])) for end in _far_end(pair))
            return
        (one, radius), *others = [(position[centre], radius) for _, centre, radius in pair.circles]
        if others:
            other, less = others[0]
            side = -1 if pair.internal and radius < less else 1
            yield self.window(complex(one + side * radius * (other - one) / np.abs(other - one)))
        for straight in pair.lines:
            way = straight.direction * np.exp(1j * self.found.plot.theta.get(straight.link, 0.0))
            off = position[straight.origin] - one
            yield self.window(complex(one + off - way * np.real(off * np.conj(way))))


def _far_end(pair: Pair) -> tuple[str, ...]:
    """The point that a rod keeps at its distance."""
    return pair.slipping.points[1:] if isinstance(pair.slipping, Rod) else ()


# --- rooms ------------------------------------------------------------------------------------


@frozen
class Laid:
    """A stretch of a line that is drawn, from start to end [mm along it]."""

    line: CentreLine
    start: float
    end: float

    @property
    def ends(self) -> tuple[Place, Place]:
        return self.line.point(self.start), self.line.point(self.end)


def clipped(line: CentreLine, room: Room) -> tuple[float, float] | None:
    """From where to where a line runs in a room [mm along it]; None where it does not cross it."""
    low, high = -np.inf, np.inf
    sides = ((line.at.real, line.way.real, room.left, room.right), (line.at.imag, line.way.imag, room.top, room.bottom))
    for at, way, least, most in sides:
        if abs(way) < 1e-12:
            if not least <= at <= most:
                return None
            continue
        first, second = sorted(((least - at) / way, (most - at) / way))
        low, high = max(low, first), min(high, second)
    return (float(low), float(high)) if low < high else None
