"""The contents of a mechanism's sheet, plane by plane, and all of them on a divided paper."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
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
from graphkin.sheet.construction_lines import PolygonConstruction, Rings, pencil_lines
from graphkin.sheet.detail import detailed
from graphkin.sheet.dimension_lines import angles
from graphkin.sheet.layout import Height, Layout, division, lay_out
from graphkin.sheet.lettering import LEAST, Label, plain
from graphkin.sheet.marks import Mark, Place
from graphkin.sheet.mechanism_figure import bare_figure, mechanism_figure, mechanism_places, shown_places
from graphkin.sheet.mechanism_notes import MechanismNotes
from graphkin.sheet.page import HEADINGS, Last, Page, Panel, heading
from graphkin.sheet.paper import KEYS, Paper, Room
from graphkin.sheet.path_figure import NONE, Paths
from graphkin.sheet.polygons import GearImage, PolygonFigure, gear_images, polygon_figure
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.text_blocks import Block, Ladder, WrittenLines, ladder
from graphkin.sheet.titleblock import Strip, Table, TableBlock, strip_height
from graphkin.sheet.window import Extent, Figure, Window, constructions

Style = Literal["construction", "result", "given"]
BlockName = Literal["paths", "equations", "detail", "tables"]
_NARROW = 84.0  # half of a sheet: equations that are longer may be broken [mm]
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

    def skeleton(self, window: Window) -> Skeleton:
        return Skeleton(self.method.mechanism, self.plot, window, births(self.method, "position"))

    def polygon(self, plane: Plane, window: Window) -> PolygonFigure:
        born, gears = births(self.method, plane), self.gears(plane)
        drafted = self.style == "construction"
        held = held_labels(self.method, plane, self.rested)
        return PolygonFigure(
            self.method.mechanism, self.construction(plane), self.plot, window, born, gears, drafted, held
        )

    def last(
        self, plane: Plane, window: Window, scales: Mapping[Plane, float], rings: Rings | None
    ) -> Last | None:
        """What is drawn last on a figure; rings: of its equations."""
        reading = self.reading(scales)
        if plane == "position" and self.style != "result":  # annotations, of what is used for the polygons too
            polygons = self.planes if self.style == "construction" else ()
            return MechanismNotes(self.skeleton(window), reading, self.sizes, polygons)
        if self.style != "construction":
            return None
        acts = [act for act in self.method.acts if act.plane == plane]
        return PolygonConstruction(self.polygon(plane, window), PolygonReading(reading, plane), acts, rings)

    @cached_property
    def rested(self) -> frozenset[Fact]:
        """The motions that drivers at rest hold still."""
        return at_rest(self.method, self.plot.facts)

    @cached_property
    def extents(self) -> dict[Plane, Extent]:
        """The size of each plane's points, and the reach of its signs beyond them."""
        given = self.method.mechanism.scales
        return {plane: Extent.of(self.values(plane), partial(self._outline, plane), given.get(KEYS[plane]))
                for plane in self.planes}  # fmt: skip

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
            entries = polygon_entries(reading, plane, self.construction(plane).parts, 0)
            if (own := ladder(entries, rows, plane, self.method)) is not None:
                ladders[plane] = own
        return ladders

    def reading(self, drawn: Mapping[Plane, float]) -> Reading:
        """The reading of the words, at the scales of the planes that are drawn."""
        return Reading(self.method, self.plot, {key: drawn.get(plane, 1.0) for plane, key in KEYS.items()}, self.lang)


class _DetailRoom:
    """The room for a detail, which finds its place in it when all is lettered."""

    size = 60 + 68j

    def marks(self, corner: Place) -> Iterator[Mark]:
        yield from ()


_FEET: Mapping[BlockName, bool] = {"paths": False, "equations": False, "detail": True, "tables": True}
"""The order in which blocks find their corners; True for those that are meant for the foot of a room."""
_GIVEN_UP: tuple[frozenset[BlockName], ...] = (
    frozenset(), frozenset(("equations",)), frozenset(("equations", "tables")),
)  # fmt: skip
_IN_STRIP: frozenset[BlockName] = frozenset(("equations", "tables"))  # those that may stand there, too


@frozen
class SheetContents:
    """All that a mechanism's sheet shows, whatever its paper.

    tight   without frame, tables and title
    given   tables of the strip; tables: of the planes, in the shapes that they may have
    low     the blocks that stand in the strip, not with their figures
    without   the blocks for which no paper is large enough
    detailed  the planes in which what lies too close together is drawn once more, magnified
    stages  over the lines of the pencil, for single steps; said: room in the strip for the sentence of one [mm];
            scales: that are kept then
    """

    drawing: Planes
    tables: Mapping[Plane, Sequence[TableBlock]]
    given: Sequence[Table] = ()
    tight: bool = False
    low: frozenset[tuple[Plane, BlockName]] = frozenset()
    without: frozenset[BlockName] = frozenset()
    detailed: Collection[Plane] = ()
    stages: bool = False
    said: float = 0.0
    scales: Mapping[Plane, float] = field(default_factory=dict)

    @property
    def planes(self) -> tuple[Plane, ...]:
        return self.drawing.planes

    @cached_property
    def blocks(self) -> dict[Plane, dict[BlockName, Sequence[Block]]]:
        """What stands with each figure, in all its shapes."""
        blocks = dict[Plane, dict[BlockName, Sequence[Block]]]()
        for plane in self.planes:
            own = self.drawing.ladders.get(plane)
            lines = self.drawing.paths.lines if plane == "position" else ()
            every: dict[BlockName, Sequence[Block]] = {
                "paths": [WrittenLines(tuple(lines), LEAST)] if lines else [],
                "equations": [] if own is None else [*dict.fromkeys((own, own.within(_NARROW)))],
                "detail": [_DetailRoom()] if plane in self.detailed else [],
                "tables": self.tables.get(plane, ()),
            }
            away = {name for where, name in self.low if where == plane} | self.without
            blocks[plane] = {name: every[name] for name in _FEET if every[name] and name not in away}
        return blocks

    @cached_property
    def extents(self) -> dict[Plane, Extent]:
        """With what stands beside each figure."""
        extents = dict[Plane, Extent]()
        for plane, extent in self.drawing.extents.items():
            blocks = tuple((tuple(s.size for s in shapes), _FEET[name]) for name, shapes in self.blocks[plane].items())
            extents[plane] = replace(extent, blocks=blocks, given=self.scales.get(plane, extent.given))
        return extents

    @cached_property
    def height(self) -> Height:
        """The height of the strip on a paper [mm], reckoned once for each."""
        if self.tight:
            return lambda _: 0.0
        if self.said:
            return partial(strip_height, least=self.said)
        return cache(partial(strip_height, found=self.in_foot, equations=self.ladders_in_foot))

    @property
    def in_foot(self) -> list[Table]:
        """The tables of the strip."""
        low = (self.tables[plane][0] for plane in self._low("tables"))
        return [*self.given, *(table for block in low for tier in block.tiers for table in tier)]

    @property
    def ladders_in_foot(self) -> list[Ladder]:
        return [self.drawing.ladders[plane] for plane in self._low("equations")]

    def _low(self, name: BlockName) -> list[Plane]:
        """The planes whose block of this name stands in the strip."""
        return [plane for plane in self.planes if (plane, name) in self.low and name not in self.without]

    def laid_out(self, papers: Sequence[Paper]) -> tuple[SheetContents, Layout]:
        """The best division of the smallest paper that holds all figures; blocks for which they would be drawn much
        coarser than bare stand in the strip, one more at a time."""
        papers = [replace(paper, margin=0.0) for paper in papers] if self.tight else papers
        bare = lay_out({p: replace(e, blocks=()) for p, e in self.extents.items()}, self.height, papers)
        tries = [self]
        while standing := tries[-1].movable:
            tries.append(replace(tries[-1], low=tries[-1].low | {max(standing)[2:]}))
        sizes = sorted({paper.area for paper in papers})
        for size, most in (*((size, bare) for size in sizes), *((size, None) for size in sizes[::-1])):
            same = [paper for paper in papers if paper.area == size]
            for contents in tries:
                if layout := division(same, contents.extents, contents.height, most):
                    return contents, layout
        for without in _GIVEN_UP:  # too much for any paper
            last = replace(tries[-1], detailed=(), without=without)
            for size in sizes[::-1]:
                if layout := division([p for p in papers if p.area == size], last.extents, last.height):
                    return last, layout
        return last, lay_out(last.extents, last.height, papers)

    @property
    def movable(self) -> list[tuple[bool, float, Plane, BlockName]]:
        """Blocks that may stand in the strip, too: tables rather than equations, large ones rather than small ones."""
        every = ((plane, name, own[name]) for plane, own in self.blocks.items() for name in _IN_STRIP & own.keys())
        return [] if self.tight else [
            (_FEET[name], min(shape.size.real * shape.size.imag for shape in shapes), plane, name)
            for plane, name, shapes in every
        ]  # fmt: skip

    def page(self, layout: Layout) -> Page:
        """Everything on a divided paper."""
        drawing = self.drawing
        panels = [self._panel(layout, plane) for plane in self.planes]
        notes: dict[Plane, Label] = {}  # how that was found which ruler and compass do not give
        for plane in self.planes if drawing.style != "given" else ():
            steps = drawing.construction(plane).steps
            if any(isinstance(step, Fit) and step.closures for step in steps):  # else a train's ratios give it
                notes[plane] = plain(_FITTED[drawing.lang])
            elif any(isinstance(step, Simultaneous) for step in steps):
                notes[plane] = plain(_TOGETHER[drawing.lang])
        tables, equations = ([], []) if self.said else (self.in_foot, self.ladders_in_foot)
        strip = None if self.tight else Strip(layout.strip, tables, notes, equations=equations)
        return Page(layout.paper, panels, drawing.method.mechanism, drawing.plot.facts.values, drawing.lang, strip)

    def _panel(self, layout: Layout, plane: Plane) -> Panel:
        """One plane's figure; lettered once for all divisions that show it alike."""
        panels, extent = self.drawing.panels, self.extents[plane]
        window, corners = layout.window(plane, extent), layout.corners(plane, extent)
        place = (
            self.stages, plane, layout.rooms[plane], window, *corners, *self.blocks[plane], *layout.scales.items()
        )  # fmt: skip
        if place not in panels:
            panel = self._plain_panel(layout, plane, window, corners)
            draw = partial(self.drawing.figure, plane)
            panels[place] = detailed(panel, draw, plane) if plane in self.detailed else panel
        return panels[place]

    def _plain_panel(
        self, layout: Layout, plane: Plane, window: Window, corners: Sequence[tuple[int, Place]]
    ) -> Panel:
        """One plane's figure under its heading, with its blocks."""
        drawing, room = self.drawing, layout.rooms[plane]
        before = [*heading(HEADINGS[drawing.lang][plane], plane, window.printed, room)]
        blocks = [(shapes[k], at) for shapes, (k, at) in zip(self.blocks[plane].values(), corners, strict=True)]
        taken = list[Room]()
        rings: Rings | None = None
        for block, at in blocks:
            if isinstance(block, Ladder):
                rings = partial(block.rings, at)
            before += (marks := [*(block.rows(at) if isinstance(block, Ladder) else block.marks(at))])
            end = at + block.size
            taken += [Room(at.real, at.imag, end.real, end.imag)] * bool(marks)
        if self.stages and plane == "position":
            before += pencil_lines(drawing.construction(plane), drawing.plot, window, pages(drawing.method))
        return Panel(
            drawing.figure(plane, window), window, room.inset(1, 1, 1), tuple(before), (), plane,
            drawing.last(plane, window, layout.scales, rings), tuple(taken),
        )  # fmt: skip
