"""One figure on a page of its own: the mechanism at scale with more around it, clipped cleanly to its room."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from graphkin.construction import Plane, Plot
from graphkin.errors import Lang
from graphkin.planning import Method
from graphkin.sheet import Sheet
from graphkin.sheet.labels import Room, settle
from graphkin.sheet.layout import HEAD, Extent, Layout, lay_out, papers_for
from graphkin.sheet.lettering import plain, width
from graphkin.sheet.marks import Disc, Mark, Place, PointMark, Stroke, Text
from graphkin.sheet.mechanism_figure import mechanism_figure
from graphkin.sheet.obstacles import bounds
from graphkin.sheet.paper import LABEL, PAPERS, Paper, PenName
from graphkin.sheet.scales import TooLargeForPaper, finest, written
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.specials import named_specials
from graphkin.sheet.titleblock import strip, strip_heights
from graphkin.sheet.wheels import rims
from graphkin.sheet.window import Figure, Window, births, first_steps
from graphkin.value import frozen

__all__ = [
    "Page", "circle", "clipped", "drawn_values", "enlarged", "finished", "mechanism_on", "page", "plainly", "within",
]  # fmt: skip

_TRIAL = 100.0
_LETTERS = 6.5
_LARGE_ENOUGH = 130.0
"""A figure of this size needs no larger paper [mm]."""
_LARGE = [PAPERS["A3-landscape"], PAPERS["A3"]]
_FINE = 0.01
"""How far a drawn curve may stand off from the true one [mm]."""


@frozen
class Page:
    """A paper with room for one figure.

    room  where the figure may be [mm]; window: from SI to paper
    """

    layout: Layout
    room: Room
    window: Window


def drawn_values(method: Method, plot: Plot) -> list[complex]:
    """The places a mechanism's figure shows [m]."""
    machine, points = method.mechanism, plot.position
    drawn = [*(complex(points[p]) for p in machine.points if p in points), *rims(machine, points)]
    return [*drawn, *named_specials(method, plot, drawn).values()]


def enlarged(values: Sequence[complex], more: Iterable[complex], factor: float) -> list[complex]:
    """The values, and of more places, in their order, those that leave the figure at most `factor` times as large."""
    found = list(values)
    size = abs(_high(found) - _low(found)) or 1.0
    for place in more:
        if cmath.isfinite(place) and abs(_high([*found, place]) - _low([*found, place])) <= factor * size:
            found.append(place)
    return found


def _low(values: Sequence[complex]) -> complex:
    return complex(min(z.real for z in values), min(z.imag for z in values))


def _high(values: Sequence[complex]) -> complex:
    return complex(max(z.real for z in values), max(z.imag for z in values))


def page(method: Method, plots: Sequence[Plot], values: Sequence[complex], paper: str | None, labels: int = 20) -> Page:
    """The smallest paper, and where the figure stands on it; a given scale that is too fine is not kept.

    values  the places to be shown [m]. Raises UnknownPaper.
    """
    extent = _extent(method, plots, values, labels)
    layout = _laid_out(extent, papers_for(paper))
    if paper is None and _length(extent, layout) < _LARGE_ENOUGH:
        layout = min(layout, _laid_out(extent, _LARGE), key=lambda found: found.scales["position"])
    room, scale = layout.rooms["position"], layout.scales["position"]
    whole = extent.size / scale + extent.reach
    x = (room.left + room.right - whole.real) / 2 + extent.left
    y = (room.top + HEAD + room.bottom - whole.imag) / 2 + extent.top + extent.size.imag / scale
    origin = complex(x, y) - _low(values).conjugate() / scale
    return Page(layout, Room(room.left + 1, room.top + HEAD, room.right - 1, room.bottom - 1), Window(origin, scale))


def _laid_out(extent: Extent, papers: Sequence[Paper]) -> Layout:
    """A given scale is kept where it fits."""
    height = strip_heights([])
    try:
        return lay_out({"position": extent}, height, papers)
    except TooLargeForPaper:
        return lay_out({"position": replace(extent, given=None)}, height, papers)


def _length(extent: Extent, layout: Layout) -> float:
    """How large the figure is on paper [mm]."""
    return max(extent.size.real, extent.size.imag) / layout.scales["position"]


def _extent(method: Method, plots: Sequence[Plot], values: Sequence[complex], labels: int) -> Extent:
    low, high = _low(values), _high(values)
    trial = finest(high - low, complex(_TRIAL, _TRIAL))
    reach = [bounds(mechanism_on(method, plot, Window(0j, trial)).marks) for plot in plots]
    left, top = min(r[0] for r in reach), min(r[1] for r in reach)
    right, bottom = max(r[2] for r in reach), max(r[3] for r in reach)
    return Extent(
        high - low, max(0.0, low.real / trial - left) + _LETTERS, max(0.0, -high.imag / trial - top) + _LETTERS,
        max(0.0, right - high.real / trial) + _LETTERS, max(0.0, bottom + low.imag / trial) + _LETTERS,
        method.mechanism.scales.get("length"), labels,
    )  # fmt: skip


def mechanism_on(method: Method, plot: Plot, window: Window) -> Figure:
    """The mechanism's own figure; points are plain circles, for such a sheet is looked at, not measured."""
    born: Mapping[str, int] = births(method.position, first_steps(method)["position"])
    figure = mechanism_figure(Skeleton(method.mechanism, plot, window, born), method, drawn_values(method, plot))
    steps = [replace(mark, step=None) for mark in map(plainly, figure.marks)]
    return Figure(steps, [replace(want, step=None) for want in figure.wanted])


def plainly(mark: Mark) -> Mark:
    """A point as a circle and nothing more."""
    if not isinstance(mark, PointMark):
        return mark
    return Disc(mark.at, mark.radius, "outline" if mark.fill == "paper" else "construction", mark.fill)


def finished(
    on: Page, method: Method, plot: Plot, heading: str, figure: Figure, lang: Lang,
    more: Mapping[Plane, float] | None = None,
) -> Sheet:  # fmt: skip
    """The sheet: strip, heading, the figure and its labels. more: further scales to be written."""
    machine, scale = method.mechanism, on.window.scale
    scales: dict[Plane, float] = {"position": scale, **(more or {})}
    paper, foot = on.layout.paper, on.layout.strip
    marks = strip(machine, [], paper, foot, scales, {}, lang)
    label, at = plain(heading), complex(on.room.left + 2, on.room.top - HEAD + 5.5)
    marks += [Text(label, at, LABEL), Text(written("position", scale), at + width(label, LABEL) + 4, LABEL)]
    drawn = marks + figure.marks
    settled = settle(figure.wanted, drawn, on.room)
    if settled.clashes:
        settled = settle(figure.wanted, drawn, on.room, far=True)
    drivers = tuple(float(value) for value in plot.facts.values)
    origins: dict[Plane, Place] = {"position": on.window.origin}
    title = machine.headline(lang)
    return Sheet(paper, (*drawn, *settled.marks), {"position": scale}, origins, machine, drivers, title, lang)


# --- curves -----------------------------------------------------------------------------------


def clipped(places: Sequence[Place] | np.ndarray, room: Room, pen: PenName) -> Iterator[Stroke]:
    """A curve on paper as far as it lies in the room, with no more places than it needs."""
    import shapely

    if len(places) < 2:
        return
    line = shapely.LineString([(z.real, z.imag) for z in places]).simplify(_FINE)
    inside = shapely.clip_by_rect(line, room.left, room.top, room.right, room.bottom)
    for part in getattr(inside, "geoms", [inside]):
        if part.geom_type == "LineString" and part.length > 0.1:
            yield Stroke(tuple(complex(x, y) for x, y in part.coords), pen)


def circle(centre: Place, radius: float, room: Room) -> list[Place]:
    """A circle on paper as a polyline; of a very large one the part about the room."""
    middle = complex(room.left + room.right, room.top + room.bottom) / 2
    reach = abs(complex(room.right - room.left, room.bottom - room.top))
    half = min(math.pi, 2 * reach / radius) if radius > 0 else math.pi
    start = cmath.phase(middle - centre)
    count = max(120, math.ceil(half * math.sqrt(radius / _FINE)))
    return [centre + cmath.rect(radius, start + half * (2 * k / count - 1)) for k in range(count + 1)]


def within(place: Place, room: Room) -> bool:
    """Whether a place on paper lies in the room."""
    return room.left <= place.real <= room.right and room.top <= place.imag <= room.bottom
