"""The three figures of a mechanism at any position, each on a paper of its own, as a sheet would draw them.

Layers are marks that a page shows or hides together.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property

from graphkin.base.rooms import Room
from graphkin.base.value import bulky
from graphkin.construction import Plane, Plot
from graphkin.planning import Method
from graphkin.planning.method import births, pages
from graphkin.planning.polygon_arrows import arrows
from graphkin.say.plane import PolygonReading
from graphkin.say.reading import Reading
from graphkin.sheet.construction_lines import PolygonConstruction, pencil_lines
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.marks import Mark, PointMark, Stroke, Text, VectorMark
from graphkin.sheet.motion_frames import MotionFigure, lettered
from graphkin.sheet.paper import KEYS
from graphkin.sheet.polygons import PolygonFigure, named_site
from graphkin.sheet.window import PLANES, Extent, Figure, Window

_ROOMS: Mapping[Plane, Room] = {
    "position": Room(0, 0, 125, 100), "velocity": Room(0, 0, 100, 90), "acceleration": Room(0, 0, 100, 90),
}  # fmt: skip
_LOOKED_AT = 150  # positions of a grid of several drivers, at which letters are tried
_PENCIL = ("construction", "measured")


OWN = ("names", "images", "coriolis")
"""Letters, velocity and acceleration images, Coriolis terms; their names are the phrases `page.layer ..`."""


def layer_of(mark: Mark) -> str:
    """The layer in which a mark of a figure is; "" for one that is always shown."""
    if isinstance(mark, Text):
        return "names"
    if isinstance(mark, Stroke) and mark.pen in _PENCIL:
        return "pencil"
    if isinstance(mark, Stroke) and mark.shows is not None and mark.shows.plane != "position":
        return "images"
    return "coriolis" if isinstance(mark, VectorMark) and mark.part == "k" else ""


@bulky
class PageFigures:
    """The figures of a method; usual: positions all along its motion, which tell how large they are."""

    method: Method
    usual: Sequence[Plot]

    @cached_property
    def motion(self) -> dict[Plane, MotionFigure]:
        return {plane: MotionFigure(self.method, self.usual, plane) for plane in PLANES}

    @cached_property
    def _cut(self) -> dict[Plane, tuple[Window, Room]]:
        cut: dict[Plane, tuple[Window, Room]] = {}
        for plane in PLANES:
            usual = {k: times for k, times in self.motion[plane].smaller.items() if times == 1}
            extent: Extent = replace(self.motion[plane].extent(usual), blocks=())
            scale = extent.scale(_ROOMS[plane])
            room = extent.cut_out(scale)
            cut[plane] = extent.window(room, scale), room
        return cut

    def window(self, plane: Plane) -> Window:
        return self._cut[plane][0]

    def room(self, plane: Plane) -> Room:
        return self._cut[plane][1]

    @property
    def scales(self) -> dict[str, float]:
        """The scales as a solution has them."""
        return {key: self.window(plane).scale for plane, key in KEYS.items()}

    def figure(self, plane: Plane, plot: Plot | None) -> Figure:
        """A plane's figure at a position, with the lines of the pencil, without its letters; nothing where it is
        endless."""
        if plot is None or not self.motion[plane].fits(plot):
            return Figure()
        window = self.window(plane)
        figure = self.motion[plane].figure(window, plot)
        wanted: Sequence[LabelRequest] = figure.wanted
        if plane == "position":
            marks = [*pencil_lines(self.method.position, plot, window, pages(self.method)), *figure.marks]
        else:
            born = births(self.method, plane)
            polygon = PolygonFigure(self.method.mechanism, self.method.construction(plane), plot, window, born)
            rest = [mark for mark in figure.marks if not isinstance(mark, VectorMark | PointMark)]
            points = [replace(mark, step=None if mark.of == "pole" else mark.step)
                      for mark in figure.marks if isinstance(mark, PointMark)]  # fmt: skip
            marks = [*self._pencil(polygon, plot), *rest, *self._vectors(polygon), *points]
            named = [[name for name in group if name in polygon.named] for group in self.motion[plane].as_one]
            steps = [None if polygon.construction.pole in group else born.get(group[0]) for group in named if group]
            wanted = [replace(want, step=step) for want, step in zip(wanted, steps, strict=True)]
        return Figure(marks, [*wanted])

    def _pencil(self, polygon: PolygonFigure, plot: Plot) -> Iterator[Mark]:
        plane = polygon.construction.plane
        spoken = PolygonReading(Reading(self.method, plot, self.scales, "en"), plane)
        acts = [act for act in self.method.acts if act.plane == plane]
        return PolygonConstruction(polygon, spoken, acts).lines()

    def _vectors(self, polygon: PolygonFigure) -> Iterator[VectorMark]:
        """Each arrow, whatever lies on it here; those that lie on one another all along the motion are one."""
        places = polygon.points
        for one, *others in self._arrows[polygon.construction.plane]:
            if one.tail in places and one.head in places:
                yield replace(one, start=places[one.tail], end=places[one.head], also=tuple(o.name for o in others))

    @cached_property
    def _arrows(self) -> dict[Plane, list[list[VectorMark]]]:
        """The arrows of each polygon, those that are one together, the one that is drawn first foremost."""
        every: dict[Plane, list[list[VectorMark]]] = {}
        for plane in PLANES[1:]:
            construction, born = self.method.construction(plane), births(self.method, plane)
            there = self.usual[0].points(plane)
            one = {name: group[0] for group in self.motion[plane].as_one for name in group}
            groups: dict[tuple[str, str], list[VectorMark]] = {}
            for arrow in arrows(self.method.mechanism, construction, there):
                step = max((born[name] for name in (arrow.tail, arrow.head) if name in born), default=None)
                sites = tuple(map(named_site, arrow.sites))
                mark = VectorMark(plane, arrow.name, arrow.tail, arrow.head, 0j, 0j, step, sites=sites, part=arrow.part)
                groups.setdefault((one[arrow.tail], one[arrow.head]), []).append(mark)
            every[plane] = [sorted(group, key=lambda mark: mark.step or 0) for (tail, head), group in groups.items()
                            if tail != head]  # fmt: skip
        return every

    def lettered(self, plane: Plane, figures: Sequence[Figure], in_a_row: bool) -> list[list[Mark]]:
        """The figure of each position, with its letters; of a grid with each on the side that suits some of them."""
        return lettered(figures, self.room(plane), step=None if in_a_row else max(1, len(figures) // _LOOKED_AT))
