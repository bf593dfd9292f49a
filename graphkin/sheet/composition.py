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
from graphkin.say.dimensions import sizes
from graphkin.say.plane import PolygonReading
from graphkin.say.polygons import polygon_entries as polygon_entries
from graphkin.say.reading import Reading
from graphkin.say.sizes import Size
from graphkin.sheet.arrows import heads_apart, named_apart
from graphkin.sheet.construction_lines import PolygonConstruction, pencil_lines
from graphkin.sheet.detail import detailed
from graphkin.sheet.dimension_lines import angles
from graphkin.sheet.free_room import FreeRoom
from graphkin.sheet.label_candidates import LabelScene
from graphkin.sheet.layout import HEAD_LEFT, Height, Layout, headed, lay_out, under_heading
from graphkin.sheet.lettering import Label, plain
from graphkin.sheet.marks import Mark
from graphkin.sheet.mechanism_figure import bare_figure, mechanism_figure, mechanism_places, shown_places
from graphkin.sheet.mechanism_notes import MechanismNotes
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
_NARROW = 84.0  # half of a sheet: equations that are longer may be broken [mm]
_LENS = 60 + 68j  # the room for a detail [mm]
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
            return heads_apart(named_apart(polygon_figure(self.polygon(plane, window))))
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

    @cached_property
    def panels(self) -> dict[tuple[object, ...], Panel]:
        """Panels, by all they hang on: they are lettered once, with details and without."""
        return {}

    @cached_property
    def tables(self) -> dict[tuple[object, ...], list[Mark] | None]:
        """The tables of planes, by all that their place hangs on; None where there is none."""
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
    given     tables of the strip; tables: with their planes, in the shapes that they may have
    in_strip  the planes whose equations stand there, not with their polygons; lensed: those with room for a detail
    footed    the planes whose tables have a room of their own under the figure; low: those whose tables go to the strip
    said      room in the strip for the sentence of a single step, in place of tables [mm]; scales: that are kept then
    """

    drawing: Planes
    tables: Mapping[Plane, Sequence[TableBlock]]
    given: Sequence[Table] = ()
    tight: bool = False
    in_strip: Collection[Plane] = ()
    footed: Collection[Plane] = ()
    low: Collection[Plane] = ()
    said: float = 0.0
    scales: Mapping[Plane, float] = field(default_factory=dict)
    lensed: Collection[Plane] = ()

    @property
    def planes(self) -> tuple[Plane, ...]:
        return self.drawing.planes

    @cached_property
    def extents(self) -> dict[Plane, Extent]:
        """With what stands beside each figure: its equations, a detail, its tables."""
        extents = dict[Plane, Extent]()
        for plane, extent in self.drawing.extents.items():
            lens = _LENS if plane in self.lensed else 0j
            shapes = [own.size for own in self.ladders.get(plane, ())] or [0j] * (plane in self.lensed)
            beside = [(complex(own.real + lens.real, max(own.imag, lens.imag)),
                       complex(max(own.real, lens.real), own.imag + lens.imag)) for own in shapes]  # fmt: skip
            feet = [block.size for block in self.tables[plane]] if plane in self.footed and not self.said else ()
            given = self.scales.get(plane, extent.given)
            extents[plane] = replace(extent, beside=tuple(beside), tables=tuple(feet), given=given)
        return extents

    @cached_property
    def ladders(self) -> dict[Plane, list[Ladder]]:
        """The equations that stand with their polygons, whole and with long ones broken."""
        every = ((plane, own) for plane, own in self.drawing.ladders.items() if plane not in self.in_strip)
        return {plane: list(dict.fromkeys((own, own.within(_NARROW)))) for plane, own in every}

    def without_head(self, layout: Layout) -> list[Plane]:
        """Planes whose equations have no room of their own with their figure."""
        return [plane for plane in self.ladders if plane not in layout.headed]

    def without_room(self, layout: Layout) -> list[Plane]:
        """Those of them for whose equations there is no room even while nothing is lettered."""
        return [plane for plane in self.without_head(layout) if not self._equations(layout, plane)]

    def _equations(self, layout: Layout, plane: Plane) -> list[Mark]:
        """A plane's equations: under its heading, else where its figure leaves room; none where it does not."""
        room, shapes = layout.rooms[plane], self.ladders.get(plane, [])
        if plane in layout.headed and shapes:
            at = complex(room.left + HEAD_LEFT, under_heading(room).top)
            return [*shapes[layout.shape(plane, self.extent(layout, plane))].marks(at)]
        lowest = self._lowest(layout, plane)
        free = self._free(layout, plane, (), lowest.size.imag + AIR if lowest else 0.0) if shapes else None
        for own in shapes if free is not None else ():
            if free is not None and (corner := free.corner(own.size + 2 * complex(AIR, AIR))) is not None:
                return [*own.marks(corner + complex(AIR, AIR))]
        return []

    def _free(self, layout: Layout, plane: Plane, before: Sequence[Mark], foot: float = 0.0) -> FreeRoom:
        """The room over its foot that a plane's figure and heading leave, and what else stands there before letters."""
        room, window = layout.rooms[plane], layout.window(plane, self.extent(layout, plane))
        marks = [*heading(HEADINGS[self.drawing.lang][plane], plane, window.printed, room), *before]
        return FreeRoom(LabelScene([], marks + self.drawing.figure(plane, window).marks, room.inset(1, 1, 1 + foot)))

    def _tables_at(self, layout: Layout, plane: Plane) -> list[Mark] | None:
        """A plane's tables as low in its room as its figure and equations allow; None where they do not."""
        place = self._place(layout, plane)
        if place not in self.drawing.tables:
            self.drawing.tables[place] = self._low_tables(layout, plane)
        return self.drawing.tables[place]

    def _low_tables(self, layout: Layout, plane: Plane) -> list[Mark] | None:
        free = self._free(layout, plane, self._equations(layout, plane))
        air, room = complex(AIR, AIR), layout.rooms[plane]
        for block in self.tables[plane]:
            if (corner := free.corner(block.size + 2 * air, from_below=True)) is not None:
                return block.marks(corner + air)
        lowest = self._lowest(layout, plane)
        return None if lowest is None else lowest.marks(complex(room.left + HEAD_LEFT, room.bottom - lowest.size.imag))

    def _lowest(self, layout: Layout, plane: Plane) -> TableBlock | None:
        """A plane's tables in the lowest shape for which its room is wide enough, where they stand at its foot."""
        wide = layout.rooms[plane].size.real - 2 * HEAD_LEFT
        narrow = [block for block in self.tables.get(plane, ()) if block.size.real <= wide and plane in self.footed]
        return min(narrow, key=lambda block: block.size.imag, default=None)

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
        low = (self.tables[plane][0] for plane in self.planes if plane in self.low)
        return [*self.given, *(table for block in low for tier in block.tiers for table in tier)]

    def layout(self, papers: Sequence[Paper], weights: Mapping[Plane, int]) -> Layout:
        """The best division of the smallest paper that holds all; a plane counts by its labels times its weight."""
        key = (*(paper.name for paper in papers), *weights.items())
        if key not in self._layouts:
            extents = {p: replace(e, labels=e.labels * weights.get(p, 1)) for p, e in self.extents.items()}
            papers = [replace(paper, margin=0.0) for paper in papers] if self.tight else papers
            free = {plane: replace(extent, beside=()) for plane, extent in extents.items()}
            bare = lay_out(free, self.height, papers)
            self._layouts[key] = headed(bare, extents, self.height, papers, _COARSER)
        return self._layouts[key]

    @cached_property
    def _layouts(self) -> dict[tuple[object, ...], Layout]:
        return {}

    def extent(self, layout: Layout, plane: Plane) -> Extent:
        """With its equations, where they have a room of their own."""
        return self.extents[plane] if plane in layout.headed else replace(self.extents[plane], beside=())

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
        panels, detail = self.drawing.panels, details and plane != "position"
        place = detail, stages, *self._place(layout, plane), *layout.scales.items()
        if place not in panels and detail:
            plain_one = self._panel(layout, plane, stages, details=False)
            panels[place] = detailed(plain_one, partial(self.drawing.figure, plane), plane)
        elif place not in panels:
            window = layout.window(plane, self.extent(layout, plane))
            panels[place] = self._plain_panel(layout, plane, stages, window)
        return panels[place]

    def _place(self, layout: Layout, plane: Plane) -> tuple[object, ...]:
        """All that equations and tables of a plane hang on."""
        choices = (plane in planes for planes in (layout.headed, self.in_strip, self.footed, self.low, self.lensed))
        return plane, layout.rooms[plane], layout.window(plane, self.extent(layout, plane)), *choices

    def _plain_panel(self, layout: Layout, plane: Plane, stages: bool, window: Window) -> Panel:
        """One plane's figure under its heading."""
        drawing, room = self.drawing, layout.rooms[plane]
        before = [*heading(HEADINGS[drawing.lang][plane], plane, window.printed, room)]
        corner = complex(room.left + HEAD_LEFT, under_heading(room).top)
        if plane == "position":
            before += drawing.paths.written(corner)
        before += self._equations(layout, plane)
        if plane in self.tables and plane not in self.low and not stages:
            before += self._tables_at(layout, plane) or []
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
            spoken = PolygonReading(drawing.reading(layout.scales), plane)
            more = PolygonConstruction(drawing.polygon(plane, window), spoken, acts)
        return Panel(drawing.figure(plane, window), window, room.inset(1, 1, 1), tuple(before), (), plane, more)
