"""All figures of a sheet together: drawn once to see how far they reach, laid out, drawn, lettered."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from graphkin.errors import Lang
from graphkin.methods import Method
from graphkin.sheet.labels import Room, settle
from graphkin.sheet.layout import HEAD, Extent, Layout, lay_out
from graphkin.sheet.lettering import plain, width
from graphkin.sheet.marks import Mark, Place, Text
from graphkin.sheet.mechanism_figure import mechanism_figure
from graphkin.sheet.obstacles import bounds
from graphkin.sheet.paper import LABEL
from graphkin.sheet.pencil import pencil_lines
from graphkin.sheet.polygons import Polygon, polygon_figure
from graphkin.sheet.results import tables
from graphkin.sheet.scales import KEYS, finest, written
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.titleblock import strip, strip_heights
from graphkin.sheet.window import Figure, Window, births, constructions, first_steps
from graphkin.steps import Construction, Plane, Plot

__all__ = ["Composed", "compose"]

_TRIAL = 100.0
"""Size of a figure when it is drawn to see how far its signs reach [mm]."""
_LETTERS = 6.5
"""What labels need around a figure [mm]."""
HEADINGS: dict[Lang, dict[Plane, str]] = {
    "en": {"position": "Mechanism", "velocity": "Velocity polygon", "acceleration": "Acceleration polygon"},
    "zh": {"position": "机构运动简图", "velocity": "速度多边形", "acceleration": "加速度多边形"},
}


@dataclass(frozen=True)
class Composed:
    """Marks on a laid out paper, and where each plane's origin came to lie."""

    layout: Layout
    marks: list[Mark]
    origins: Mapping[Plane, Place]


@dataclass(frozen=True)
class _Planes:
    """Draws any plane through any window."""

    method: Method
    plot: Plot

    def construction(self, plane: Plane) -> Construction:
        return constructions(self.method)[plane]

    def values(self, plane: Plane) -> list[complex]:
        """The points a plane shows, in SI units."""
        points = self.plot.points(plane)
        if plane == "position":
            return [complex(v) for name, v in points.items() if name in self.method.mechanism.points]
        names = {self.construction(plane).pole, *self.construction(plane).nodes}
        return [complex(v) for name, v in points.items() if name in names]

    def figure(self, plane: Plane, window: Window) -> Figure:
        born = births(self.construction(plane), first_steps(self.method)[plane])
        if plane == "position":
            return mechanism_figure(Skeleton(self.method.mechanism, self.plot, window, born))
        return polygon_figure(Polygon(self.method.mechanism, self.construction(plane), self.plot, window, born))

    def extent(self, plane: Plane) -> Extent:
        """How large the plane's points are, and how far its signs reach beyond them."""
        low, high = _corners(self.values(plane))
        size = high - low
        given = self.method.mechanism.scales.get(KEYS[plane])
        trial = given or finest(size, complex(_TRIAL, _TRIAL))
        figure = self.figure(plane, Window(0j, trial))
        left, top, right, bottom = bounds(figure.marks)
        points = _Box(low.real / trial, -high.imag / trial, high.real / trial, -low.imag / trial)
        more = _LETTERS
        return Extent(
            size, max(0, points.left - left) + more, max(0, points.top - top) + more,
            max(0, right - points.right) + more, max(0, bottom - points.bottom) + more, given, len(figure.wanted),
        )  # fmt: skip


@dataclass(frozen=True, slots=True)
class _Box:
    left: float
    top: float
    right: float
    bottom: float


def _corners(values: Sequence[complex]) -> tuple[complex, complex]:
    """Lower left and upper right corner of what holds all these points."""
    xs, ys = [v.real for v in values] or [0.0], [v.imag for v in values] or [0.0]
    return complex(min(xs), min(ys)), complex(max(xs), max(ys))


def compose(
    method: Method, plot: Plot, planes: tuple[Plane, ...], paper: str | None, lang: Lang, upto: int | None
) -> Composed:
    """Draw, lay out, letter. The layout is the same for every `upto`, so the steps of a series lie over one another."""
    drawing = _Planes(method, plot)
    extents = {plane: drawing.extent(plane) for plane in planes}
    found = tables(method, plot, lang)
    layout = lay_out(extents, strip_heights(found), paper)
    shown = found if upto is None else []
    marks = strip(method.mechanism, shown, layout.paper, layout.strip, layout.scales, lang)
    origins: dict[Plane, Place] = {}
    for plane in planes:
        origins[plane] = _origin(drawing.values(plane), extents[plane], layout, plane)
        marks += _placed(drawing, plane, layout, origins[plane], lang, upto)
    return Composed(layout, marks, origins)


def _origin(values: Sequence[complex], extent: Extent, layout: Layout, plane: Plane) -> Place:
    """The plane's origin on paper, so that the figure with all its signs stands in the middle of its room."""
    room, scale = layout.rooms[plane], layout.scales[plane]
    low, _ = _corners(values)
    whole = extent.size / scale + extent.reach
    x = (room.left + room.right - whole.real) / 2 + extent.left
    y = (room.top + HEAD + room.bottom - whole.imag) / 2 + extent.top + extent.size.imag / scale
    return complex(x, y) - low.conjugate() / scale


def _placed(drawing: _Planes, plane: Plane, layout: Layout, origin: Place, lang: Lang, upto: int | None) -> list[Mark]:
    """One plane with its heading, lines of the pencil and labels."""
    room, window = layout.rooms[plane], Window(origin, layout.scales[plane])
    figure = drawing.figure(plane, window)
    marks = [*_heading(plane, room, layout.scales[plane], lang)]
    if upto is not None:
        before = first_steps(drawing.method)[plane]
        marks += pencil_lines(drawing.construction(plane), drawing.plot, window, room, before)
    marks += figure.marks
    inner = Room(room.left + 1, room.top + 1, room.right - 1, room.bottom - 1)
    marks += settle(figure.wanted, marks, inner)
    if upto is None:
        return marks
    return [_fresh(mark, upto) for mark in marks if mark.step is None or mark.step <= upto]


def _fresh(mark: Mark, upto: int) -> Mark:
    return replace(mark, new=True) if mark.step == upto else mark


def _heading(plane: Plane, room: Room, scale: float, lang: Lang) -> list[Mark]:
    """What the figure is, and its scale."""
    label, at = plain(HEADINGS[lang][plane]), complex(room.left + 3, room.top + 5.5)
    return [Text(label, at, LABEL), Text(written(plane, scale), at + width(label, LABEL) + 4, LABEL)]
