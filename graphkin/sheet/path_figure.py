"""Curves on paper, cut off at the edge of their room; paths of points with ticks and velocities."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from graphkin.base.rooms import Room, corners
from graphkin.base.scales import finest
from graphkin.base.value import frozen
from graphkin.errors import Lang
from graphkin.say import names
from graphkin.say.catalogue import say, say_close
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import LABEL, Label, formula, number, plain
from graphkin.sheet.marks import Disc, Place, Shows, Stroke
from graphkin.sheet.paper import PenName
from graphkin.sheet.symbols import arrow
from graphkin.sheet.window import Entry, Figure, Window

if TYPE_CHECKING:
    from graphkin.studies.sweeps import PointPath

FINE = 0.01  # how far a drawn curve may stand off from the true one [mm]
_TICK, _NUMBERED = 0.9, 1.5  # half of a tick [mm]
_LONGEST, _GREAT = 16.0, 3.0  # the longest velocity [mm]; so many times most others it is left out
_LANE = 2.2  # how far arrows keep to the right of a way that is gone to and fro [mm]


def clipped(
    places: Sequence[Place] | np.ndarray, room: Room, pen: PenName, step: int | None = None
) -> Iterator[Stroke]:
    """A curve on paper as far as it lies in the room, with no more places than it needs."""
    import shapely

    if len(places) < 2:
        return
    line = shapely.LineString([(z.real, z.imag) for z in places]).simplify(FINE)
    inside = shapely.clip_by_rect(line, room.left, room.top, room.right, room.bottom)
    for part in getattr(inside, "geoms", [inside]):
        if part.geom_type == "LineString" and part.length > 0.1:
            yield Stroke(tuple(complex(x, y) for x, y in part.coords), pen, step=step)


@frozen
class Paths:
    """Paths of points on one figure; arrows: with the velocity at each tick, all to one scale."""

    curves: tuple[PointPath, ...] = ()
    arrows: bool = False
    lang: Lang = "en"

    @property
    def places(self) -> list[complex]:
        """Two corners of each [m]."""
        return [corner for curve in self.curves for corner in corners(curve.places.tolist())]

    @cached_property
    def scale(self) -> float:
        """Of the velocities, but for those that are far greater than most, as near a dead point [(m/s)/mm]."""
        speeds = self._speeds or [0.0]
        usual = min(speeds[-1], _GREAT * speeds[len(speeds) // 2])
        return finest(complex(usual, 0.0), complex(_LONGEST, _LONGEST))

    @cached_property
    def _speeds(self) -> list[float]:
        return sorted(abs(tick.velocity) for curve in self.curves for tick in curve.ticks)

    def figure(self, window: Window) -> Figure:
        return Figure.of(entry for curve in self.curves for entry in self._entries(curve, window))

    def _entries(self, curve: PointPath, window: Window) -> Iterator[Entry]:
        import shapely

        whole = window.origin + np.conj(curve.places) / window.scale
        line = shapely.LineString(np.stack([whole.real, whole.imag], axis=-1)).simplify(FINE)
        places = tuple(complex(x, y) for x, y in line.coords)[: -1 if curve.closed else None]
        owner = curve.course.method.mechanism.owners[curve.point][0]
        shows = Shows(owner, "path", (curve.point,), curve.course.driver.name)
        yield Stroke(places, "outline", closed=curve.closed, shows=shows)
        middle, at = complex(np.mean(places)), places[len(places) // 8]
        name = formula(say("sheet.path of", self.lang, point=names.point(curve.point)))
        yield LabelRequest(name, at, gap=1.2, away=at - middle, size=LABEL)
        for tick in curve.ticks:
            at, across = window(tick.place), window.turned(tick.way) * 1j
            half = _NUMBERED if tick.numbered else _TICK
            yield Stroke((at - half * across, at + half * across), "thin") if across else Disc(at, half / 2, "thin")
            if tick.numbered:
                value = plain(curve.shown(tick.value))
                yield LabelRequest(value, at, gap=1.6, away=at - middle, size=LABEL, spare=True)
            if self.arrows and abs(tick.velocity) <= _LONGEST * self.scale:
                along = window.turned(tick.velocity) / (self.scale * window.times)
                start = at + _LANE * 1j * along / abs(along) if tick.both else at
                yield from arrow(start, start + along, "velocity")

    @property
    def lines(self) -> list[Label]:
        """From tick to tick, and the scale of the velocities."""
        lines: list[Label] = []
        for one in self.curves[:1]:
            driver, machine = one.course.driver, one.course.method.mechanism
            step, name = one.shown(one.step), machine.driver_title(driver, self.lang)
            which = ("angle", "spin", "slide").index(driver.kind)
            lines.append(formula(say_close("sheet.ticks", self.lang, which=which, step=step, driver=name)))
            if self.arrows:
                lines.append((*plain(say("sheet.arrows", self.lang)), *number(self.scale), *plain(" m/s")))
                if self._speeds[-1] > _LONGEST * self.scale:
                    lines.append(plain(say("sheet.left out", self.lang, length=f"{_LONGEST:g}")))
            if self.arrows and one.seconds is not None:
                lines.append((*plain(say("sheet.every", self.lang)), *number(one.seconds), *plain(" s")))
        return lines


NONE = Paths()
