"""The contents of a mechanism's sheet, plane by plane, and all of them on a divided paper."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cache, cached_property, partial
from typing import Literal

from graphkin.base.value import frozen
from graphkin.construction import Construction, Fit, Plane, Plot, Simultaneous
from graphkin.errors import Lang
from graphkin.planning import Method
from graphkin.planning.at_rest import at_rest, held_labels
from graphkin.planning.method import births, pages
from graphkin.planning.needed import Fact
from graphkin.say.catalogue import say
from graphkin.say.dimensions import sizes
from graphkin.say.plane import PolygonReading
from graphkin.say.polygons import polygon_entries as polygon_entries
from graphkin.say.reading import Reading
from graphkin.say.sizes import Size
from graphkin.sheet.arrows import heads_apart, side_by_side
from graphkin.sheet.construction_lines import PolygonConstruction, pencil_lines
from graphkin.sheet.detail import detailed
from graphkin.sheet.dimension_lines import angles
from graphkin.sheet.free_room import FreeRoom
from graphkin.sheet.layout import HEAD_LEFT, Height, Layout, headed, lay_out, under_heading
from graphkin.sheet.lettering import Label, plain
from graphkin.sheet.mechanism_figure import bare_figure, mechanism_figure, mechanism_places, shown_places
from graphkin.sheet.mechanism_notes import MechanismNotes
from graphkin.sheet.page import HEADINGS, Last, Page, Panel, heading
from graphkin.sheet.paper import KEYS, Paper
from graphkin.sheet.path_figure import NONE, Paths
from graphkin.sheet.polygons import GearImage, PolygonFigure, gear_images, polygon_figure
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.text_blocks import EquationBlock, equation_blocks, head_of, laid_out
from graphkin.sheet.titleblock import Strip, Table, strip_height
from graphkin.sheet.window import Extent, Figure, Window, constructions

Style = Literal["construction", "result", "given"]
_COARSER = 1.34  # so much coarser a figure may be drawn to have room for its equations over it
_FITTED: dict[Lang, str] = {"en": "fitted by trial", "zh": "样板法试凑"}
_TOGETHER: dict[Lang, str] = {"en": "solved together", "zh": "联立求解"}


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
        values = [complex(v) for name, v in points.items() if name in names]
        return values + [corner for image in self.gears(plane) for corner in image.corners]

    def gears(self, plane: Plane) -> list[GearImage]:
        return gear_images(self.method, self.plot) if plane == "velocity" else []

    def figure(self, plane: Plane, window: Window) -> Figure:
        """Drawn once through each window: many divisions of a paper show one figure alike."""
        if (plane, window) not in self._drawn:
            figure = self._outline(plane, window)
            if plane == "position" and self.style != "result":
                figure = angles(self.sizes, self.skeleton(window), figure.marks) + figure
            self._drawn[plane, window] = figure
        return self._drawn[plane, window]

    def _outline(self, plane: Plane, window: Window) -> Figure:
        """Without the arcs of given angles, for which there is room beside links."""
        if plane != "position":
            return heads_apart(side_by_side(polygon_figure(self.polygon(plane, window))))
        skeleton = self.skeleton(window)
        if self.style == "given":
            return bare_figure(self.method, skeleton)
        return self.paths.figure(window) + mechanism_figure(skeleton, self.method, self.values(plane))

    @cached_property
    def sizes(self) -> list[Size]:
        """What is given of the mechanism."""
        return sizes(self.reading({}))

    @cached_property
    def _drawn(self) -> dict[tuple[Plane, Window], Figure]:
        return {}

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
        """The motions that drivers at rest hold still."""
        return at_rest(self.method, self.plot.facts)

    @cached_property
    def extents(self) -> dict[Plane, Extent]:
        """The size of each plane's points, and the reach of its signs beyond them."""
        given, extents = self.method.mechanism.scales, dict[Plane, Extent]()
        for plane in self.planes:
            extent = Extent.of(self.values(plane), partial(self._outline, plane), given.get(KEYS[plane]))
            over = self.paths.height if plane == "position" else 0.0
            extents[plane] = replace(extent, top=extent.top + over)
        return extents

    @cached_property
    def equations(self) -> dict[Plane, list[EquationBlock]]:
        """The equations of each polygon as the words print them."""
        if self.style != "construction":
            return {}
        rows = say("derivation.direction row", self.lang), say("derivation.size row", self.lang)
        reading = self.reading({})
        polygons = [plane for plane in self.planes if plane != "position"]
        parts = {plane: self.construction(plane).parts for plane in polygons}
        return {plane: equation_blocks(polygon_entries(reading, plane, parts[plane], 0), rows) for plane in polygons}

    def reading(self, drawn: Mapping[Plane, float]) -> Reading:
        """The reading of the words, at the scales of the planes that are drawn."""
        return Reading(self.method, self.plot, {key: drawn.get(plane, 1.0) for plane, key in KEYS.items()}, self.lang)


@frozen
class SheetContents:
    """All that a mechanism's sheet shows, whatever its paper.

    tight     without frame, tables and title
    in_strip  equations that stand there, not over their polygons
    """

    drawing: Planes
    tables: Sequence[Table]
    tight: bool = False
    in_strip: Sequence[EquationBlock] = ()

    @property
    def planes(self) -> tuple[Plane, ...]:
        return self.drawing.planes

    @cached_property
    def extents(self) -> dict[Plane, Extent]:
        """With the equations over each polygon."""
        over = {plane: head_of(blocks) for plane, blocks in self.blocks.items() if blocks}
        return {plane: replace(extent, over=over.get(plane)) for plane, extent in self.drawing.extents.items()}

    @cached_property
    def blocks(self) -> dict[Plane, list[EquationBlock]]:
        """The equations that stand with their polygons."""
        every = self.drawing.equations.items()
        return {plane: [block for block in blocks if block not in self.in_strip] for plane, blocks in every}

    def moved(self, blocks: Sequence[EquationBlock]) -> SheetContents:
        """With some more equations in the strip."""
        every = [block for own in self.drawing.equations.values() for block in own]
        return replace(self, in_strip=[block for block in every if block in blocks or block in self.in_strip])

    def without_head(self, layout: Layout) -> list[EquationBlock]:
        """Equations that have no place of their own over a figure."""
        return [block for plane, blocks in self.blocks.items() if plane not in layout.headed for block in blocks]

    def without_room(self, layout: Layout) -> list[EquationBlock]:
        """Those of them for which there is no room even while nothing is lettered."""
        roomless: list[EquationBlock] = []
        for plane in self.planes:
            if loose := [] if plane in layout.headed else self.blocks.get(plane, []):
                free = FreeRoom(self._panel(layout, plane, stages=False, details=False).scene)
                roomless += [block for block in loose if free.corner(block.size) is None]
        return roomless

    @cached_property
    def height(self) -> Height:
        """The height of the strip on a paper [mm], reckoned once for each."""
        height = partial(strip_height, found=self.tables, equations=self.in_strip)
        return cache(height) if not self.tight else lambda _: 0.0

    def layout(self, papers: Sequence[Paper], weights: Mapping[Plane, int]) -> Layout:
        """The best division of the smallest paper that holds all; a plane counts by its labels times its weight."""
        key = (*(paper.name for paper in papers), *weights.items())
        if key not in self._layouts:
            extents = {p: replace(e, labels=e.labels * weights.get(p, 1)) for p, e in self.extents.items()}
            papers = [replace(paper, margin=0.0) for paper in papers] if self.tight else papers
            free = {plane: replace(extent, over=None) for plane, extent in extents.items()}
            bare = lay_out(free, self.height, papers)
            self._layouts[key] = headed(bare, extents, self.height, papers, _COARSER)
        return self._layouts[key]

    @cached_property
    def _layouts(self) -> dict[tuple[object, ...], Layout]:
        return {}

    def extent(self, layout: Layout, plane: Plane) -> Extent:
        """With its equations over it, where they have room there."""
        return self.extents[plane] if plane in layout.headed else replace(self.extents[plane], over=None)

    def page(self, layout: Layout, stages: bool, details: bool) -> Page:
        """Everything on a divided paper; with `stages`, over the lines of the pencil and without results."""
        drawing = self.drawing
        panels = [self._panel(layout, plane, stages, details) for plane in self.planes]
        notes: dict[Plane, Label] = {}  # how that was found which ruler and compass do not give
        for plane in self.planes if drawing.style != "given" else ():
            steps = drawing.construction(plane).steps
            if any(isinstance(step, Fit) and step.closures for step in steps):  # else a train's ratios give it
                notes[plane] = plain(_FITTED[drawing.lang])
            elif any(isinstance(step, Simultaneous) for step in steps):
                notes[plane] = plain(_TOGETHER[drawing.lang])
        tables, equations = ([], []) if stages else (self.tables, self.in_strip)
        strip = None if self.tight else Strip(layout.strip, tables, notes, equations=equations)
        return Page(layout.paper, panels, drawing.method.mechanism, drawing.plot.facts.values, drawing.lang, strip)

    def _panel(self, layout: Layout, plane: Plane, stages: bool, details: bool) -> Panel:
        window = layout.window(plane, self.extent(layout, plane))
        place = plane, stages, plane in layout.headed, layout.rooms[plane], window, *layout.scales.items()
        if place not in self._panels:
            self._panels[place] = self._plain_panel(layout, plane, stages, window)
        panel = self._panels[place]
        return detailed(panel, partial(self.drawing.figure, plane), plane) if details and plane != "position" else panel

    @cached_property
    def _panels(self) -> dict[tuple[object, ...], Panel]:
        """Panels without details, by all they hang on: they are lettered once, with details and without."""
        return {}

    def _plain_panel(self, layout: Layout, plane: Plane, stages: bool, window: Window) -> Panel:
        """One plane's figure under its heading."""
        drawing, room = self.drawing, layout.rooms[plane]
        before = [*heading(HEADINGS[drawing.lang][plane], plane, window.scale, room)]
        corner = complex(room.left + HEAD_LEFT, under_heading(room).top)
        if plane == "position":
            before += drawing.paths.written(corner)
        if plane in layout.headed:
            before += laid_out(self.blocks[plane], corner, room.size.real - 2 * HEAD_LEFT)
        if stages and plane == "position":
            before += pencil_lines(drawing.construction(plane), drawing.plot, window, pages(drawing.method))
        more: Last | None = None
        if drawing.style == "construction" and plane == "position":  # annotations of what is used for the polygons
            reading = drawing.reading(layout.scales)
            more = MechanismNotes(drawing.skeleton(window), reading, drawing.sizes, self.planes)
        elif drawing.style == "given":
            more = MechanismNotes(drawing.skeleton(window), drawing.reading(layout.scales), drawing.sizes)
        elif drawing.style == "construction":
            acts = [act for act in drawing.method.acts if act.plane == plane]
            loose, spoken = [] if plane in layout.headed else self.blocks[plane], drawing.reading(layout.scales)
            more = PolygonConstruction(drawing.polygon(plane, window), PolygonReading(spoken, plane), acts, loose)
        return Panel(drawing.figure(plane, window), window, room.inset(1, 1, 1), tuple(before), (), plane, more)
