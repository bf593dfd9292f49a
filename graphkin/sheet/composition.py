"""The contents of a mechanism's sheet, plane by plane, and all of them on a divided paper."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, replace
from functools import cache, cached_property, partial
from itertools import product
from typing import Literal

from graphkin.base.cache import kept
from graphkin.base.rooms import Room, enlarged
from graphkin.base.scales import finest
from graphkin.base.value import frozen
from graphkin.construction import Fit, Plane, Plot, Simultaneous
from graphkin.errors import Lang
from graphkin.planning import Method
from graphkin.planning.at_rest import held_labels
from graphkin.planning.method import births, pages
from graphkin.say.catalogue import say
from graphkin.say.dimensions import driven, sizes
from graphkin.say.ladder import rungs
from graphkin.say.plane import PolygonReading
from graphkin.say.polygons import polygon_entries
from graphkin.say.reading import Reading
from graphkin.say.sizes import Size
from graphkin.say.solution_goal import solution_centres
from graphkin.sheet.added_points import touched
from graphkin.sheet.arrows import heads_apart, left_out, side_by_side, with_break_signs
from graphkin.sheet.construction_lines import PolygonConstruction, Rings, pencil_lines
from graphkin.sheet.detail import detailed
from graphkin.sheet.dimension_lines import angles
from graphkin.sheet.layout import Height, Layout, division, lay_out
from graphkin.sheet.lettering import LEAST, Label, Run, plain
from graphkin.sheet.marks import Mark, Place
from graphkin.sheet.mechanism_figure import mechanism_figure, mechanism_places, shown_places
from graphkin.sheet.mechanism_notes import MechanismNotes
from graphkin.sheet.page import Last, Panel, heading
from graphkin.sheet.paper import KEYS, LARGEST, Paper
from graphkin.sheet.path_figure import NONE, Paths
from graphkin.sheet.polygons import GearImage, PolygonFigure, gear_images, polygon_figure
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.text_blocks import Ladder, WrittenLines
from graphkin.sheet.titleblock import Strip, Table, TableBlock
from graphkin.sheet.window import PLANES, Extent, Figure, Window

Style = Literal["construction", "result", "given"]
BlockName = Literal["paths", "equations", "detail", "tables"]
_WIDTHS = (84.0, 68.0)  # half of a sheet and less: equations that are longer may be broken [mm]
_FIXED, _COMMA, _EQUALS = 3, Run(", "), Run(" = ")  # with so many more names a pole's, or an arrow's, may stand alone
_BEYOND = 1.25  # so many times larger a figure may become to show what its dimensions are measured from


@frozen
class Planes:
    """Draws any plane through any window; planes: those the sheet shows; breaks: an arrow that is far longer than the
    others of its plane is drawn broken, where the file gives no scale; told: a text above gives all data."""

    method: Method
    plot: Plot
    planes: tuple[Plane, ...]
    style: Style
    lang: Lang
    paths: Paths = NONE
    breaks: bool = False
    told: bool = False

    def values(self, plane: Plane) -> list[complex]:
        """The points a plane shows, in SI units."""
        if plane == "position":
            places = mechanism_places if self.style == "given" else shown_places
            ends = (end for size in self.sizes for end in size.ends)
            return [*enlarged(places(self.method, self.plot), ends, _BEYOND), *self.paths.places]
        points = self.plot.points(plane)
        names = {self.method.construction(plane).pole, *self.method.construction(plane).nodes}
        values = [complex(v) - self.left_out[plane].get(name, 0) for name, v in points.items() if name in names]
        return values + [corner for image in self.gears(plane) for corner in image.corners]

    def gears(self, plane: Plane) -> list[GearImage]:
        return [*gear_images(self.method, self.plot)] if plane == "velocity" else []

    @kept(32)
    def figure(self, plane: Plane, window: Window) -> Figure:
        """Draws a plane once through each window: many divisions of a paper show one figure alike."""
        figure = self._outline(plane, window)
        if plane != "position":
            return heads_apart(figure)
        arcs = angles(self.sizes, self.skeleton(window), figure.marks) if self.style != "result" else ()
        return Figure.of(arcs) + figure

    def _outline(self, plane: Plane, window: Window) -> Figure:
        """Without what reaches no farther: heads beside one another, and arcs of given angles."""
        if plane != "position":
            return with_break_signs(side_by_side(polygon_figure(self.polygon(plane, window))))
        skeleton = self.skeleton(window)
        if self.style == "given":
            return mechanism_figure(skeleton, self.method, bare=True)  # as a problem gives it
        figure = self.paths.figure(window) + mechanism_figure(skeleton, self.method, self.values(plane))
        if self.style != "construction":
            return figure
        added = [*touched(self.method, self.plot, skeleton)]
        if solution_centres(self.method.mechanism):
            from graphkin.sheet.centre_figure import asked_lines

            added += asked_lines(self.method, skeleton, self.values(plane))
        return Figure.of(added) + figure

    @cached_property
    def left_out(self) -> dict[Plane, dict[str, complex]]:
        """By plane the head of an arrow that is drawn broken, and the piece that is not drawn [SI]."""
        scales = self.method.mechanism.scales
        broken = [plane for plane in PLANES[1:] if self.breaks and KEYS[plane] not in scales]
        return {plane: left_out(self.method, self.method.construction(plane), self.plot, self.gears(plane))
                if plane in broken else {} for plane in PLANES}  # fmt: skip

    @cached_property
    def sizes(self) -> list[Size]:
        """The mechanism's data; drivers that stand elsewhere than the problem says have no value."""
        reading = self.reading({})
        every = sizes(reading)
        if self.style != "given":
            return every
        now, drivers = self.plot.facts.values, self.method.mechanism.drivers
        moved = {driven(reading, k, driver)[0].symbol for k, driver in enumerate(drivers)
                 if driver.value is not None and abs(driver.value - float(now[k])) > 1e-9}  # fmt: skip
        return [replace(size, moved=size.moved or size.symbol in moved) for size in every]

    @cached_property
    def panels(self) -> dict[tuple[object, ...], Panel]:
        """Panels, by all they hang on: they are lettered once, with details and without."""
        return {}

    @kept(2)
    def skeleton(self, window: Window) -> Skeleton:
        return Skeleton(self.method.mechanism, self.plot, window, births(self.method, "position"))

    @kept(4)
    def polygon(self, plane: Plane, window: Window) -> PolygonFigure:
        held = held_labels(self.method, plane, self.reading({}).rested)
        return PolygonFigure(
            self.method.mechanism, self.method.construction(plane), self.plot, window, births(self.method, plane),
            self.gears(plane), self.style == "construction", held, self.left_out[plane],
        )  # fmt: skip

    def last(self, plane: Plane, window: Window, scales: Mapping[Plane, float], rings: Rings | None) -> Last | None:
        """The last marks of a figure; rings: of its equations."""
        reading = self.reading(scales)
        if plane == "position" and self.style != "result":  # annotations, of what is used for the polygons too
            polygons = self.planes if self.style == "construction" else ()
            return MechanismNotes(self.skeleton(window), reading, self.sizes, polygons, self.told)
        if self.style != "construction":
            return None
        acts = [act for act in self.method.acts if act.plane == plane]
        return PolygonConstruction(self.polygon(plane, window), PolygonReading(reading, plane), acts, rings)

    @cached_property
    def extents(self) -> dict[Plane, Extent]:
        """The size of each plane's points, and the reach of its signs beyond them."""
        given = self.method.mechanism.scales
        return {plane: Extent.of(self.values(plane), partial(self._outline, plane), given.get(KEYS[plane]))
                for plane in self.planes}  # fmt: skip

    @cached_property
    def least(self) -> dict[Plane, float]:
        """The finest scales at which a handout's page has room for each."""
        return {plane: extent.given or finest(extent.size, LARGEST[plane]) for plane, extent in self.extents.items()}

    @cached_property
    def ladders(self) -> dict[Plane, Ladder]:
        """The equations of each polygon as the words print them."""
        if self.style != "construction" or self.told:
            return {}
        rows = say("derivation.direction row", self.lang), say("derivation.size row", self.lang)
        reading, polygons = self.reading({}), [plane for plane in self.planes if plane != "position"]
        parts = ((plane, self.method.construction(plane).parts) for plane in polygons)
        entries = ((plane, polygon_entries(reading, plane, own, 0)) for plane, own in parts)
        every = ((plane, Ladder.of(rungs(own, plane, self.method), rows, plane)) for plane, own in entries)
        return {plane: own for plane, own in every if own is not None}

    def reading(self, drawn: Mapping[Plane, float]) -> Reading:
        """The reading of the words, at the scales of the planes that are drawn."""
        return Reading(self.method, self.plot, {key: drawn.get(plane, 1.0) for plane, key in KEYS.items()}, self.lang)


@frozen
class DetailRoom:
    """The room for a detail, which finds its place in it when all is lettered; parts: that another language shows."""

    size: complex
    parts: tuple[tuple[complex, float], ...] = ()

    def marks(self, corner: Place) -> Iterator[Mark]:
        yield from ()


Block = WrittenLines | Ladder | TableBlock | DetailRoom
_FEET: Mapping[BlockName, bool] = {"paths": False, "equations": False, "detail": True, "tables": True}
"""The order in which blocks find their corners; True for those that are meant for the foot of a room."""
_IN_STRIP: tuple[BlockName, ...] = ("equations", "tables")  # those that may stand there, too, the first given up first
_LARGER = 3  # a polygon that is to be larger counts as one of so many times its labels


@frozen
class SheetContents:
    """All that a mechanism's sheet shows, whatever its paper; tight: without frame, tables and title.

    given, tables  of the strip; of the planes, in the shapes that they may have
    low, without   blocks that stand in the strip, not with their figures; blocks for which no paper is large enough
    brief     equations are without the rows of what is known of their terms
    detailed  the planes in which what lies too close together is drawn once more, magnified, and the room for it
    larger    the polygons that are to be larger than their number of labels asks for
    paged     none is larger than a handout's page has room for
    stages, said, scales  over the lines of the pencil, for single steps; room for the sentence of one [mm]; those kept
    """

    drawing: Planes
    tables: Mapping[Plane, Sequence[TableBlock]]
    given: Sequence[Table] = ()
    tight: bool = False
    low: frozenset[tuple[Plane, BlockName]] = frozenset()
    without: frozenset[tuple[Plane, BlockName]] = frozenset()
    brief: bool = False
    detailed: Mapping[Plane, DetailRoom] = field(default_factory=dict)
    larger: frozenset[Plane] = frozenset()
    paged: bool = False
    stages: bool = False
    said: float = 0.0
    scales: Mapping[Plane, float] = field(default_factory=dict)

    @cached_property
    def blocks(self) -> dict[Plane, dict[BlockName, Sequence[Block]]]:
        """Titles, ladders and tables of each figure, in all their shapes."""
        blocks = dict[Plane, dict[BlockName, Sequence[Block]]]()
        for plane in self.drawing.planes:
            own = self.ladders.get(plane)
            lines = self.drawing.paths.lines if plane == "position" else ()
            every: dict[BlockName, Sequence[Block]] = {
                "paths": [WrittenLines(tuple(lines), LEAST)] if lines else [],
                "equations": [] if own is None else [*dict.fromkeys((own, *map(own.within, _WIDTHS)))],
                "detail": [self.detailed[plane]] if plane in self.detailed else [],
                "tables": self.tables.get(plane, ()),
            }
            away = {name for where, name in self.low | self.without if where == plane}
            blocks[plane] = {name: every[name] for name in _FEET if every[name] and name not in away}
        return blocks

    @cached_property
    def extents(self) -> dict[Plane, Extent]:
        """With what stands beside each figure."""
        extents = dict[Plane, Extent]()
        for plane, extent in self.drawing.extents.items():
            blocks = tuple((tuple(s.size for s in shapes), _FEET[name]) for name, shapes in self.blocks[plane].items())
            labels = extent.labels * (_LARGER if plane in self.larger else 1)
            given, least = self.scales.get(plane, extent.given), self.drawing.least[plane] if self.paged else 0.0
            extents[plane] = replace(extent, blocks=blocks, given=given, labels=labels, least=least)
        return extents

    @cached_property
    def height(self) -> Height:
        """The height of the strip on a paper [mm], reckoned once for each."""
        return cache(self.strip.height) if self.strip else lambda _: 0.0

    @cached_property
    def strip(self) -> Strip | None:
        """The foot of the sheet, with the blocks that stand there."""
        if self.tight:
            return None
        if self.said:
            return Strip(notes=self.notes, least=self.said)
        low = {name: [plane for plane in self.drawing.planes if (plane, name) in self.low] for name in _IN_STRIP}
        blocks = (self.tables[plane][0] for plane in low["tables"])
        found = [*self.given, *(table for block in blocks for tier in block.tiers for table in tier)]
        return Strip(found, equations=[self.ladders[plane] for plane in low["equations"]], notes=self.notes)

    @cached_property
    def ladders(self) -> dict[Plane, Ladder]:
        """The equations of each polygon."""
        return {plane: own.brief if self.brief else own for plane, own in self.drawing.ladders.items()}

    @property
    def notes(self) -> list[Label]:
        """Sentences on what ruler and compass do not give, and on what the paper has no room for."""
        told, drawing, lang = list[str](), self.drawing, self.drawing.lang
        for plane in drawing.planes if drawing.style != "given" else ():
            steps = drawing.method.construction(plane).steps
            head = say(f"sheet.plane {plane}", lang) + say("common.colon", lang)
            if any(isinstance(step, Fit) and step.closures for step in steps):  # else a train's ratios give it
                told.append(head + say("sheet.fitted", lang))
            elif plane not in drawing.ladders and any(isinstance(step, Simultaneous) for step in steps):
                told.append(head + say("sheet.together", lang))
        told += [say("sheet.brief", lang)] * self.brief
        told += (say(f"sheet.no room {name}", lang) for name in sorted({name for _, name in self.without}))
        return [*map(plain, told)]

    def laid_out(self, papers: Sequence[Paper]) -> tuple[SheetContents, Layout]:
        """The best division of the smallest paper that holds all figures; blocks for which they would be drawn much
        coarser than bare stand in the strip, one more at a time."""
        papers = [replace(paper, margin=0.0) for paper in papers] if self.tight else papers
        bare = lay_out({p: replace(e, blocks=()) for p, e in self.extents.items()}, self.height, papers)
        order = [(plane, name) for *_, plane, name in sorted(self.movable, reverse=True)]
        tries = [replace(self, low=self.low.union(order[:count])) for count in range(len(order) + 1)]
        order.sort(key=lambda block: _IN_STRIP.index(block[1]))
        least = replace(self, detailed={}, brief=bool(self.ladders))
        given_up = [replace(least, without=self.without.union(order[:k])) for k in range(len(order) + 1)]
        sizes = sorted({paper.area for paper in papers})
        for every, some, most in ((sizes, tries, bare), (sizes[::-1], [*tries, *given_up], None)):
            for size, contents in product(every, some):
                same = [paper for paper in papers if paper.area == size]
                if layout := division(same, contents.extents, contents.height, most):
                    return contents, layout
        return given_up[-1], lay_out(given_up[-1].extents, given_up[-1].height, papers)

    @property
    def movable(self) -> list[tuple[bool, float, Plane, BlockName]]:
        """Blocks that may stand in the strip, too: tables rather than equations, large ones rather than small ones."""
        every = ((plane, name, own[name]) for plane, own in self.blocks.items() for name in _IN_STRIP if name in own)
        return [(_FEET[name], min(shape.size.real * shape.size.imag for shape in shapes), plane, name)
                for plane, name, shapes in every if not self.tight]  # fmt: skip

    def panel(self, layout: Layout, plane: Plane) -> Panel:
        """One plane's figure; lettered once for all divisions that show it alike."""
        panels, extent = self.drawing.panels, self.extents[plane]
        window, corners = layout.placed(plane, extent)
        place = (self.stages, plane, layout.rooms[plane], window, *corners, *self.blocks[plane], *layout.scales.items())
        if place not in panels:
            panel = self._plain_panel(layout, plane, window, corners)
            figure, bad = panel.figure, {*panel.near.unclear, *panel.near.clashing}
            labels = {k: figure.wanted[k].label for k in bad}
            alike = {k for k, label in labels.items() if label.count(_EQUALS) >= _FIXED and label[-1].place == "sub"}
            if crowd := alike | {k for k in figure.pole & bad if labels[k].count(_COMMA) >= _FIXED}:
                wanted = [want.alone if k in crowd else want for k, want in enumerate(figure.wanted)]
                panel = replace(panel, figure=Figure(figure.marks, wanted))  # the text tells the others, too
            if plane in self.detailed:
                panel = detailed(panel, partial(self.drawing.figure, plane), plane, self.detailed[plane].parts)
            panels[place] = panel
        return panels[place]

    def _plain_panel(self, layout: Layout, plane: Plane, window: Window, corners: Sequence[tuple[int, Place]]) -> Panel:
        """One plane's figure under its heading, with its blocks."""
        drawing, room = self.drawing, layout.rooms[plane]
        before = [*heading(say(f"sheet.plane {plane}", drawing.lang), plane, window.printed, room)]
        beside, rings = list[tuple[Room, tuple[Mark, ...]]](), None
        for shapes, (k, at) in zip(self.blocks[plane].values(), corners, strict=True):
            block, end = shapes[k], at + shapes[k].size
            rings = partial(block.rings, at) if isinstance(block, Ladder) else rings  # its numbers come last
            marks = tuple(block.rows(at) if isinstance(block, Ladder) else block.marks(at))
            beside.append((Room(at.real, at.imag, end.real, end.imag), marks))
        if self.stages and plane == "position":
            before += pencil_lines(drawing.method.construction(plane), drawing.plot, window, pages(drawing.method))
        return Panel(
            drawing.figure(plane, window), window, room.inset(2, 1, 2), tuple(before), plane,
            drawing.last(plane, window, layout.scales, rings), tuple(beside),
        )  # fmt: skip
