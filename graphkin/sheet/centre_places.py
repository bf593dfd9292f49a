"""Instant centres on paper: those on it, beyond its edge and at infinity, and the lines they lie on.

Source: Sun Huan, 机械原理, section 3-2.2.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from functools import cached_property

from graphkin.base import geometry
from graphkin.base.value import frozen
from graphkin.construction.drafting import LineStep, Stage, drawn_through
from graphkin.model.pairs import Cam, Pair, Rod
from graphkin.sheet.lettering import Label, Run, number, quantity_label
from graphkin.sheet.marks import Place
from graphkin.sheet.paper import Room
from graphkin.sheet.window import Window
from graphkin.studies.centres import Centres

SAME = 0.05  # places closer than this are one on paper [mm]


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
    every = []
    for step, stage in enumerate(found.centring.stages, start=1):
        name, place = stage.last.name, geometry.place(found.board.at(stage.last.name))
        finite = cmath.isfinite(place)
        direction = 0j if finite else cmath.rect(1, geometry.number(found.board.direction(name)))
        every.append(Spot(name, step, stage, place if finite else None, direction))
    return every


def centre_label(name: str) -> Label:
    """`P13` with its numbers as a subscript."""
    return quantity_label("P", name[1:])


def coordinates(found: Centres, place: complex) -> Label:
    """`(34.37, −115.6)`: in mm; what is smaller than rounding is 0."""
    shown = 1000 * geometry.place(found.method.mechanism.usual.cut(place, "m"))
    return (Run("("), *number(shown.real), Run(", "), *number(shown.imag), Run(")"))


@frozen
class CentreLine:
    """A line on paper: a place on it and its unit direction, and the places of centres on it.

    normal  it is the common normal of two profiles, and no join of centres
    """

    at: Place
    direction: complex
    stops: tuple[Place, ...]
    normal: bool = False

    def along(self, place: Place) -> float:
        """Distance of a place along the line [mm]."""
        return ((place - self.at) * self.direction.conjugate()).real


@frozen
class OnPaper:
    """The centres through a window on the mechanism, in a room of the paper."""

    found: Centres
    window: Window
    room: Room

    @cached_property
    def spots(self) -> list[Spot]:
        return spots(self.found)

    def at(self, spot: Spot) -> Place:
        """The place of a centre that is not at infinity, on the paper or beyond it."""
        assert spot.place is not None
        return self.window(spot.place)

    def shown(self, spot: Spot) -> bool:
        """True for a centre in the room."""
        return spot.place is not None and self.room.holds(self.at(spot))

    def lines(self, spot: Spot) -> Iterator[CentreLine]:
        """The lines that give a centre, but for the line at infinity."""
        for line in spot.stage.lines if spot.stage.say == "two lines" else ():
            normal = self.found.centring.normals.get(line.name)
            own = () if spot.place is None else (self.at(spot),)
            if normal is not None:
                start = self._point(normal.line.through)
                along = self.window.turned(geometry.place(self.found.plot.direction(normal.line.direction)))
                stops = (start, *self._contact(normal.pair), *own)
                yield CentreLine(start, along / abs(along), stops, normal=True)
            elif (join := self._join(line, own)) is not None:
                yield join

    def _point(self, name: str) -> Place:
        return self.window(geometry.place(self.found.plot.position[name]))

    def _join(self, line: LineStep, own: tuple[Place, ...]) -> CentreLine | None:
        by_name = {spot.name: spot for spot in self.spots}
        ends = [by_name[end] for end in drawn_through(line)]
        places = [self.at(end) for end in ends if end.place is not None]
        if not places:
            return None
        infinite = [self.window.turned(end.direction) for end in ends if end.place is None]
        along = infinite[0] if infinite else places[1] - places[0]
        near = min(places, key=lambda place: abs(place - self.room.middle))
        return CentreLine(near, along / abs(along), (*places, *own))

    def _contact(self, pair: Pair) -> Iterator[Place]:
        """The contact of a pair's links, unless the normal is drawn from there; of a rod, the end it keeps off."""
        if not isinstance(pair, Cam):
            yield from map(self._point, pair.slipping.points[1:] if isinstance(pair.slipping, Rod) else ())
            return
        position = self.found.plot.position
        (one, radius), *others = [(geometry.place(position[centre]), radius) for _, centre, radius in pair.circles]
        if others:
            other, less = others[0]
            side = -1 if pair.internal and radius < less else 1
            yield self.window(one + side * radius * (other - one) / abs(other - one))
        for straight in pair.lines:
            turn = geometry.number(self.found.plot.theta.get(straight.link, 0.0))
            along = straight.direction * cmath.exp(1j * turn)
            off = geometry.place(position[straight.origin]) - one
            yield self.window(one + off - along * (off * along.conjugate()).real)


@frozen
class Laid:
    """A stretch of a line that is drawn, from start to end [mm along it]."""

    line: CentreLine
    start: float
    end: float

    @property
    def ends(self) -> tuple[Place, Place]:
        return self.line.at + self.start * self.line.direction, self.line.at + self.end * self.line.direction


def clipped(line: CentreLine, room: Room) -> tuple[float, float] | None:
    """The ends of a line in a room [mm along it]; None where it does not cross it."""
    low, high = -math.inf, math.inf
    at, along = line.at, line.direction
    for start, step, least, most in (
        (at.real, along.real, room.left, room.right), (at.imag, along.imag, room.top, room.bottom)
    ):  # fmt: skip
        if abs(step) < 1e-12:
            if not least <= start <= most:
                return None
            continue
        first, second = sorted(((least - start) / step, (most - start) / step))
        low, high = max(low, first), min(high, second)
    return (low, high) if low < high else None
