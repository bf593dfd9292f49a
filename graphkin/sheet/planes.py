"""What a mechanism's sheet shows, plane by plane: its places, its figure through any window, its equations."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property, partial
from typing import Literal

from graphkin.base.value import frozen
from graphkin.construction import Construction, Plane, Plot
from graphkin.errors import Lang
from graphkin.planning import Method
from graphkin.planning.at_rest import at_rest, held_labels
from graphkin.planning.method import births
from graphkin.planning.needed import Fact
from graphkin.say.catalogue import say
from graphkin.say.polygons import polygon_entries as told
from graphkin.say.reading import Reading
from graphkin.sheet.arrows import heads_apart, side_by_side
from graphkin.sheet.equation_rows import EquationBlock, equation_blocks
from graphkin.sheet.fit import Extent
from graphkin.sheet.gear_images import GearImage, gear_images
from graphkin.sheet.mechanism_figure import mechanism_figure
from graphkin.sheet.path_figure import NONE, Paths
from graphkin.sheet.plain_mechanism import bare_figure, mechanism_places, shown_places
from graphkin.sheet.polygons import PolygonFigure, polygon_figure
from graphkin.sheet.scales import KEYS
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.window import Figure, Window, constructions

Style = Literal["construction", "result", "given"]


@frozen
class Planes:
    """Draws any plane through any window; planes: those the sheet shows."""

    method: Method
    plot: Plot
    planes: tuple[Plane, ...]
    style: Style
    lang: Lang
    paths: Paths = NONE

    def construction(self, plane: Plane) -> Construction:
        return constructions(self.method)[plane]

    def values(self, plane: Plane) -> list[complex]:
        """The points a plane shows, in SI units."""
        if plane == "position":
            places = mechanism_places if self.style == "given" else shown_places
            return [*places(self.method, self.plot), *self.paths.places]
        points = self.plot.points(plane)
        names = {self.construction(plane).pole, *self.construction(plane).nodes}
        found = [complex(v) for name, v in points.items() if name in names]
        return found + [corner for image in self.gears(plane) for corner in image.corners]

    def gears(self, plane: Plane) -> list[GearImage]:
        return gear_images(self.method, self.plot) if plane == "velocity" else []

    def figure(self, plane: Plane, window: Window) -> Figure:
        """Drawn once through each window: many divisions of a paper show one figure alike."""
        if (plane, window) not in self._drawn:
            self._drawn[plane, window] = self._figure(plane, window)
        return self._drawn[plane, window]

    @cached_property
    def _drawn(self) -> dict[tuple[Plane, Window], Figure]:
        return {}

    def _figure(self, plane: Plane, window: Window) -> Figure:
        if plane == "position" and self.style == "given":
            return bare_figure(self.method, self.skeleton(window))
        if plane == "position":
            return self.paths.figure(window) + mechanism_figure(
                self.skeleton(window), self.method, self.values(plane)
            )
        return heads_apart(side_by_side(polygon_figure(self.polygon(plane, window))))

    def skeleton(self, window: Window) -> Skeleton:
        return Skeleton(self.method.mechanism, self.plot, window, births(self.method, "position"))

    def polygon(self, plane: Plane, window: Window) -> PolygonFigure:
        born, gears = births(self.method, plane), self.gears(plane)
        drafted = self.style == "construction"
        held = held_labels(self.method, plane, self.rested)
        return PolygonFigure(
            self.method.mechanism, self.construction(plane), self.plot, window, born, gears, drafted, held
        )

    @cached_property
    def rested(self) -> frozenset[Fact]:
        """What drivers at rest hold still."""
        return at_rest(self.method, self.plot.facts)

    @cached_property
    def extents(self) -> dict[Plane, Extent]:
        """How large each plane's points are, and how far its signs reach beyond them."""
        return {plane: self._extent(plane) for plane in self.planes}

    def _extent(self, plane: Plane) -> Extent:
        given = self.method.mechanism.scales.get(KEYS[plane])
        extent = Extent.of(self.values(plane), partial(self.figure, plane), given)
        return replace(extent, top=extent.top + self.paths.height) if plane == "position" else extent

    @cached_property
    def equations(self) -> dict[Plane, list[EquationBlock]]:
        """The equations of each polygon as the words print them."""
        if self.style != "construction":
            return {}
        rows = say("derivation.direction row", self.lang), say("derivation.size row", self.lang)
        reading = self.reading({})
        polygons = [plane for plane in self.planes if plane != "position"]
        parts = {plane: self.construction(plane).parts for plane in polygons}
        return {plane: equation_blocks(told(reading, plane, parts[plane], 0), rows) for plane in polygons}

    def reading(self, drawn: Mapping[Plane, float]) -> Reading:
        """What the words read, at the scales of the planes that are drawn."""
        return Reading(self.method, self.plot, {key: drawn.get(plane, 1.0) for plane, key in KEYS.items()}, self.lang)
