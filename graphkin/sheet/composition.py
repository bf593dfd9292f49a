"""The contents of a mechanism's sheet, plane by plane, and all of them on a divided paper."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import field, replace
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
from graphkin.say.plane import PolygonReading
from graphkin.say.polygons import polygon_entries as polygon_entries
from graphkin.say.reading import Reading
from graphkin.sheet.arrows import heads_apart, named_apart
from graphkin.sheet.construction_lines import MechanismNotes, PolygonConstruction, pencil_lines
from graphkin.sheet.detail import detailed
from graphkin.sheet.free_room import FreeRoom
from graphkin.sheet.label_candidates import LabelScene
from graphkin.sheet.layout import HEAD_LEFT, Height, Layout, headed, lay_out, under_heading
from graphkin.sheet.lettering import Label, plain
from graphkin.sheet.marks import Mark, Place
from graphkin.sheet.mechanism_figure import bare_figure, mechanism_figure, mechanism_places, shown_places
from graphkin.sheet.page import HEADINGS, Last, Page, Panel, heading
from graphkin.sheet.paper import KEYS, Paper
from graphkin.sheet.path_figure import NONE, Paths
from graphkin.sheet.polygons import GearImage, PolygonFigure, gear_images, polygon_figure
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.text_blocks import AIR, Ladder, ladder
from graphkin.sheet.titleblock import Strip, Table, TableBlock, strip_height
from graphkin.sheet.window import Extent, Figure, Window, constructions

Style = Literal["construction", "result", "given"]
_COARSER = 1.7  # so much coarser a figure may be drawn to have room for its equations over it
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
            if plane != "position":
                figure = heads_apart(named_apart(polygon_figure(self.polygon(plane, window))))
            elif self.style == "given":
                figure = bare_figure(self.method, self.skeleton(window))
            else:
                machine = mechanism_figure(self.skeleton(window), self.method, self.values(plane))
                figure = self.paths.figure(window) + machine
            self._drawn[plane, window] = figure
        return self._drawn[plane, window]

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
            extent = Extent.of(self.values(plane), partial(self.figure, plane), given.get(KEYS[plane]))
            over = self.paths.height if plane == "position" else 0.0
            extents[plane] = replace(extent, top=extent.top + over)
        return extents

    @cached_property
    def ladders(self) -> dict[Plane, Ladder]:
        """The equations of each polygon as the words print them."""
        if self.style != "construction":
            return {}
        rows = say("derivation.direction row", self.lang), say("derivation.size row", self.lang)
        reading = self.reading({})
        polygons = [plane for plane in self.planes if plane != "position"]
        ladders = dict[Plane, Ladder]()
        for plane in polygons:
            acts = [act for act in self.method.acts if act.plane == plane]
            entries = polygon_entries(reading, plane, self.construction(plane).parts, 0)
            if (own := ladder(entries, rows, acts)) is not None:
                ladders[plane] = own
        return ladders

    def reading(self, drawn: Mapping[Plane, float]) -> Reading:
        """The reading of the words, at the scales of the planes that are drawn."""
        return Reading(self.method, self.plot, {key: drawn.get(plane, 1.0) for plane, key in KEYS.items()}, self.lang)


@frozen
class SheetContents:
    """All that a mechanism's sheet shows, whatever its paper.

    tight     without frame, tables and title
    given     tables of the strip; tables: with their planes
    in_strip  the planes whose equations stand there, not with their polygons
    footed    the planes whose tables have a room of their own under the figure; low: those whose tables go to the strip
    said      room in the strip for the sentence of a single step, in place of tables [mm]; scales: that are kept then
    """

    drawing: Planes
    tables: Mapping[Plane, Sequence[Table]]
    given: Sequence[Table] = ()
    tight: bool = False
    in_strip: Collection[Plane] = ()
    footed: Collection[Plane] = ()
    low: Collection[Plane] = ()
    said: float = 0.0
    scales: Mapping[Plane, float] = field(default_factory=dict)

    @property
    def planes(self) -> tuple[Plane, ...]:
        return self.drawing.planes

    @cached_property
    def extents(self) -> dict[Plane, Extent]:
        """With the equations of each polygon."""
        sizes = {plane: own.size for plane, own in self.ladders.items()}
        feet = {plane: tuple(block.size for block in TableBlock.shapes(self.tables[plane])) for plane in self.footed}
        feet = {} if self.said else feet
        return {plane: replace(extent, ladder=sizes.get(plane), tables=feet.get(plane, ()),
                               given=self.scales.get(plane, extent.given))
                for plane, extent in self.drawing.extents.items()}  # fmt: skip

    @cached_property
    def ladders(self) -> dict[Plane, Ladder]:
        """The equations that stand with their polygons."""
        return {plane: own for plane, own in self.drawing.ladders.items() if plane not in self.in_strip}

    def without_head(self, layout: Layout) -> list[Plane]:
        """Planes whose equations have no room of their own with their figure."""
        return [plane for plane in self.ladders if plane not in layout.headed]

    def without_room(self, layout: Layout) -> list[Plane]:
        """Those of them for whose equations there is no room even while nothing is lettered."""
        return [plane for plane in self.without_head(layout) if self._ladder_at(layout, plane) is None]

    def _ladder_at(self, layout: Layout, plane: Plane) -> Place | None:
        """The upper left corner of a plane's equations: under its heading, else where its figure leaves room."""
        room = layout.rooms[plane]
        if plane in layout.headed:
            return complex(room.left + HEAD_LEFT, under_heading(room).top)
        corner = self._free(layout, plane, ()).corner(self.ladders[plane].size + 2 * complex(AIR, AIR))
        return None if corner is None else corner + complex(AIR, AIR)

    def _free(self, layout: Layout, plane: Plane, before: Sequence[Mark]) -> FreeRoom:
        """The room that a plane's figure and its heading leave, and what else stands there before all letters."""
        room, window = layout.rooms[plane], layout.window(plane, self.extent(layout, plane))
        marks = [*heading(HEADINGS[self.drawing.lang][plane], plane, window.printed, room), *before]
        return FreeRoom(LabelScene([], marks + self.drawing.figure(plane, window).marks, room.inset(1, 1, 1)))

    def _tables_at(self, layout: Layout, plane: Plane) -> list[Mark] | None:
        """A plane's tables as low in its room as its figure and equations allow; None where they do not."""
        at = self._ladder_at(layout, plane) if plane in self.ladders else None
        free = self._free(layout, plane, () if at is None else [*self.ladders[plane].marks(at)])
        air, shapes = complex(AIR, AIR), TableBlock.shapes(self.tables[plane])
        for block in shapes:
            if (corner := free.corner(block.size + 2 * air, from_below=True)) is not None:
                return block.marks(corner + air)
        room = layout.rooms[plane]
        narrow = [block for block in shapes if block.size.real <= room.size.real - 2 * HEAD_LEFT]
        if plane not in self.footed or not narrow:
            return None
        lowest = min(narrow, key=lambda block: block.size.imag)
        return lowest.marks(complex(room.left + HEAD_LEFT, room.bottom - lowest.size.imag))

    def tableless(self, layout: Layout) -> list[Plane]:
        """Planes whose tables have no place with them."""
        planes = (plane for plane in self.tables if plane in self.planes and plane not in self.low)
        return [plane for plane in planes if self._tables_at(layout, plane) is None]

    @cached_property
    def height(self) -> Height:
        """The height of the strip on a paper [mm], reckoned once for each."""
        equations = [self.drawing.ladders[plane] for plane in self.planes if plane in self.in_strip]
        height = partial(strip_height, found=self._in_foot, equations=equations)
        height = partial(strip_height, least=self.said) if self.said else height
        return cache(height) if not self.tight else lambda _: 0.0

    @property
    def _in_foot(self) -> list[Table]:
        """The tables of the strip."""
        return [*self.given, *(table for plane in self.planes if plane in self.low for table in self.tables[plane])]

    def layout(self, papers: Sequence[Paper], weights: Mapping[Plane, int]) -> Layout:
        """The best division of the smallest paper that holds all; a plane counts by its labels times its weight."""
        key = (*(paper.name for paper in papers), *weights.items())
        if key not in self._layouts:
            extents = {p: replace(e, labels=e.labels * weights.get(p, 1)) for p, e in self.extents.items()}
            papers = [replace(paper, margin=0.0) for paper in papers] if self.tight else papers
            free = {plane: replace(extent, ladder=None) for plane, extent in extents.items()}
            bare = lay_out(free, self.height, papers)
            self._layouts[key] = headed(bare, extents, self.height, papers, _COARSER)
        return self._layouts[key]

    @cached_property
    def _layouts(self) -> dict[tuple[object, ...], Layout]:
        return {}

    def extent(self, layout: Layout, plane: Plane) -> Extent:
        """With its equations, where they have a room of their own."""
        return self.extents[plane] if plane in layout.headed else replace(self.extents[plane], ladder=None)

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
        ladders = [drawing.ladders[plane] for plane in self.planes if plane in self.in_strip]
        tables, equations = ([], []) if stages else (self._in_foot, ladders)
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
        before = [*heading(HEADINGS[drawing.lang][plane], plane, window.printed, room)]
        corner = complex(room.left + HEAD_LEFT, under_heading(room).top)
        if plane == "position":
            before += drawing.paths.written(corner)
        if plane in self.ladders and (at := self._ladder_at(layout, plane)) is not None:
            before += self.ladders[plane].marks(at)
        if plane in self.tables and plane not in self.low and not stages:
            before += self._tables_at(layout, plane) or []
        if stages and plane == "position":
            before += pencil_lines(drawing.construction(plane), drawing.plot, window, pages(drawing.method))
        more: Last | None = None
        if drawing.style == "construction" and plane == "position":  # annotations of what is used for the polygons
            more = MechanismNotes(drawing.skeleton(window), drawing.reading(layout.scales), self.planes)
        elif drawing.style == "construction":
            acts = [act for act in drawing.method.acts if act.plane == plane]
            spoken = PolygonReading(drawing.reading(layout.scales), plane)
            more = PolygonConstruction(drawing.polygon(plane, window), spoken, acts)
        return Panel(drawing.figure(plane, window), window, room.inset(1, 1, 1), tuple(before), (), plane, more)
