"""Paths of points under the mechanism: the curve, a tick at each round value of the driver, velocities if asked."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from graphkin.base.value import frozen
from graphkin.errors import Lang
from graphkin.say.catalogue import say
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import Label, number, plain, point_label, points_label
from graphkin.sheet.marks import Disc, Mark, Place, Shows, Stroke, Text
from graphkin.sheet.paper import LEAST, finest
from graphkin.sheet.symbols import arrow
from graphkin.sheet.window import Figure, Window

if TYPE_CHECKING:
    from graphkin.studies.sweeps import PointPath

_FINE = 0.01
"""How far the drawn curve may stand off from the true one [mm]."""
_TICK, _NUMBERED = 0.9, 1.5
"""Half of a tick [mm]."""
_LONGEST = 16.0
"""The longest velocity [mm]."""
_HERE = "\0"
"""Where a name goes in a text."""
_PITCH = 3.8
"""From line to line of what is said of the paths [mm]."""


@frozen
class Paths:
    """Paths of points on one figure.

    arrows  with the velocity at each tick, all to one scale
    """

    curves: tuple[PointPath, ...] = ()
    arrows: bool = False
    lang: Lang = "en"

    @property
    def places(self) -> list[complex]:
        """What they take up [m]: two corners each."""
        found = []
        for places in (curve.places for curve in self.curves):
            found += [complex(places.real.min(), places.imag.min()), complex(places.real.max(), places.imag.max())]
        return found

    @property
    def scale(self) -> float:
        """Of the velocities [(m/s)/mm]."""
        fastest = max((curve.fastest for curve in self.curves), default=0.0)
        return finest(complex(fastest, 0.0), complex(_LONGEST, _LONGEST))

    def figure(self, window: Window) -> Figure:
        figure = Figure()
        for curve in self.curves:
            figure += Figure.of(self._drawn(curve, window))
        return figure

    def _drawn(self, curve: PointPath, window: Window) -> Iterator[Mark | LabelRequest]:
        places = _on_paper(curve, window)
        owner = curve.course.method.mechanism.owners[curve.point][0]
        shows = Shows(owner, "path", (curve.point,), curve.course.driver.name)
        yield Stroke(places, "outline", closed=curve.closed, shows=shows)
        middle = complex(np.mean(places))
        named = places[len(places) // 8]
        yield LabelRequest(_named(curve, self.lang), named, gap=1.2, away=named - middle, size=LEAST)
        for tick in curve.ticks:
            at, across = window(tick.place), window.turned(tick.way) * 1j
            half = _NUMBERED if tick.numbered else _TICK
            yield Stroke((at - half * across, at + half * across), "thin") if across else Disc(at, half / 2, "thin")
            if tick.numbered:
                yield LabelRequest(
                    plain(curve.shown(tick.value)), at, gap=1.6, away=at - middle, size=LEAST, spare=True
                )
            if self.arrows:
                yield from arrow(at, at + window.turned(tick.velocity) / self.scale, "velocity")

    # --- what is said of them ---------------------------------------------------------------------

    @property
    def lines(self) -> list[Label]:
        """From tick to tick, and the scale of the velocities."""
        said: list[Label] = []
        if self.curves:
            one = self.curves[0]
            driver, step = one.course.driver.name, one.shown(one.step)
            said.append(_around(say("sheet.ticks", self.lang, step=step, driver=_HERE), points_label(driver)))
        if self.arrows:
            said.append((*plain(say("sheet.arrows", self.lang)), *number(self.scale), *plain(" m/s")))
        if self.arrows and self.curves[0].seconds is not None:
            said.append((*plain(say("sheet.every", self.lang)), *number(self.curves[0].seconds), *plain(" s")))
        return said

    @property
    def height(self) -> float:
        """Of those lines [mm]."""
        return _PITCH * len(self.lines)

    def written(self, corner: Place) -> Iterator[Text]:
        """From their upper left corner."""
        for k, line in enumerate(self.lines):
            yield Text(line, corner + 1j * (_PITCH * k + LEAST), LEAST)


NONE = Paths()


def _on_paper(curve: PointPath, window: Window) -> tuple[Place, ...]:
    """The curve with no more places than it needs."""
    import shapely

    places = window.origin + np.conj(curve.places) / window.scale
    line = shapely.LineString(np.stack([places.real, places.imag], axis=-1)).simplify(_FINE)
    found = tuple(complex(x, y) for x, y in line.coords)
    return found[:-1] if curve.closed else found


def _named(curve: PointPath, lang: Lang) -> Label:
    return _around(say("sheet.path of", lang, point=_HERE), point_label(curve.point))


def _around(text: str, name: Label) -> Label:
    """A text with a name in italics put in."""
    before, _, after = text.partition(_HERE)
    return (*plain(before), *name, *plain(after))
