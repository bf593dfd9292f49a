"""The contents of a mechanism's sheet, plane by plane, and all of them on a divided paper."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from functools import cache, cached_property, partial
from typing import Literal

from graphkin.base.value import frozen
from graphkin.construction import Construction, Fit, Plane, Plot, Simultaneous
from graphkin.errors import Lang
from graphkin.planning import Method
from graphkin.planning.held_still import held_labels
from graphkin.planning.needed import Fact, at_rest
from graphkin.planning.step_numbers import births, pages
from graphkin.say.catalogue import say
from graphkin.say.plane import PolygonReading as Spoken
from graphkin.say.polygons import polygon as told
from graphkin.say.reading import Reading
from graphkin.sheet.annotations import Annotated
from graphkin.sheet.arrows import heads_apart, side_by_side
from graphkin.sheet.construction_lines import Drafted
from graphkin.sheet.detail import detailed
from graphkin.sheet.free_room import FreeRoom
from graphkin.sheet.gear_images import GearImage, gear_images
from graphkin.sheet.layout import HEAD_LEFT, Height, Layout, headed, lay_out, under_heading
from graphkin.sheet.lettering import Label, plain
from graphkin.sheet.mechanism_figure import bare_figure, mechanism_figure, mechanism_places, shown_places
from graphkin.sheet.page import Last, Lettered, Page, Panel, heading
from graphkin.sheet.paper import KEYS, Paper
from graphkin.sheet.path_figure import NONE, Paths
from graphkin.sheet.polygons import PolygonFigure, polygon_figure
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.text_blocks import EquationBlock, equation_blocks, head_of, laid_out
from graphkin.sheet.titleblock import Strip, Table, strip_height
from graphkin.sheet.window import Extent, Figure, Window, constructions

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


_COARSER = 1.34
"""So much coarser a figure may be drawn to have room for its equations over it."""
_FAR_TOO_MANY = 0.25
"""Where so many labels of a figure find no place, no other division is tried."""
_MORE = (2, 4)
"""So many times its labels count for a plane where some found no place."""
HEADINGS: dict[Lang, dict[Plane, str]] = {
    "en": {"position": "Mechanism", "velocity": "Velocity polygon", "acceleration": "Acceleration polygon"},
    "zh": {"position": "机构运动简图", "velocity": "速度多边形", "acceleration": "加速度多边形"},
}

FITTED: dict[Lang, str] = {"en": "fitted by trial", "zh": "样板法试凑"}
TOGETHER: dict[Lang, str] = {"en": "solved together", "zh": "联立求解"}


@frozen
class Composed:
    """All of it on a divided paper.

    stages    over the lines of the pencil, for single steps
    details   what lies too close together is drawn once more, magnified
    hopeless  it was crammed without details
    homeless  equations for which there is no room, seen before anything was lettered
    """

    work: Composition
    layout: Layout
    stages: bool = False
    details: bool = False
    hopeless: bool = False
    homeless: Sequence[EquationBlock] = ()

    @cached_property
    def full(self) -> bool:
        """Whether some figure is too small for what it has to letter."""
        rooms, extents = self.layout.rooms, self.work.extents
        return any(extents[plane].crammed(rooms[plane]) for plane in self.work.planes)

    @cached_property
    def crammed(self) -> bool:
        """Whether no division could help: some figure has far too much to letter."""
        if self.full or self.hopeless:
            return True
        panels = sorted(self.page.panels, key=lambda panel: -len(panel.figure.wanted))
        return any(panel.near.clashes > _FAR_TOO_MANY * len(panel.figure.wanted) for panel in panels)

    @cached_property
    def page(self) -> Page:
        return self.work.page(self.layout, self.stages, self.details)

    @cached_property
    def near(self) -> Lettered:
        """Each label near what it names."""
        return self.page.lettered(far=False)

    @property
    def detailed(self) -> Composed:
        """With details, where labels want them."""
        return replace(self, details=True) if self.near.lost or self.near.crowded else self

    @property
    def crowd(self) -> bool:
        """Whether labels have to go far off."""
        return self.crammed or self.near.lost > 0

    @property
    def left_out(self) -> Sequence[EquationBlock]:
        """Equations for which figures and letters have left no room."""
        return self.work.loose(self.layout) if self.crowd else self.lettered.left_out

    @cached_property
    def lettered(self) -> Lettered:
        """Its labels as well as can be."""
        found = self.page.lettered(far=True) if self.crowd else self.near
        return found.trimmed if self.work.tight else found


@frozen
class Composition:
    """What does not depend on the paper.

    apart     equations that go into the strip
    hopeless  even on the largest paper its figures are crammed
    """

    drawing: Planes
    found: list[Table]
    tight: bool = False
    apart: Sequence[EquationBlock] = ()
    hopeless: bool = False

    @property
    def planes(self) -> tuple[Plane, ...]:
        return self.drawing.planes

    @property
    def lang(self) -> Lang:
        return self.drawing.lang

    @cached_property
    def extents(self) -> dict[Plane, Extent]:
        """With the equations over each polygon."""
        return {plane: replace(extent, over=self._over(plane)) for plane, extent in self.drawing.extents.items()}

    def _over(self, plane: Plane) -> tuple[complex, complex] | None:
        return head_of(self.blocks[plane]) if self.blocks.get(plane) else None

    @cached_property
    def blocks(self) -> dict[Plane, list[EquationBlock]]:
        """The equations that stand with their polygons."""
        every = self.drawing.equations.items()
        return {plane: [block for block in blocks if block not in self.apart] for plane, blocks in every}

    def without(self, out: Sequence[EquationBlock]) -> Composition:
        """With some more equations in the strip."""
        apart, every = [*self.apart, *out], self.drawing.equations.values()
        return replace(self, apart=[block for blocks in every for block in blocks if block in apart])

    def loose(self, layout: Layout) -> list[EquationBlock]:
        """Equations that have no place of their own over a figure."""
        return [block for plane, blocks in self.blocks.items() if plane not in layout.headed for block in blocks]

    def homeless(self, layout: Layout) -> list[EquationBlock]:
        """Those for which there is no room even while nothing is lettered."""
        found: list[EquationBlock] = []
        for plane in self.planes:
            if loose := [block for block in self.blocks.get(plane, ()) if plane not in layout.headed]:
                panel = self.panel(layout, plane, stages=False, details=False)
                free = FreeRoom(panel.scene)
                found += [block for block in loose if free.corner(block.size) is None]
        return found

    @cached_property
    def notes(self) -> dict[Plane, Label]:
        """Planes that hold what ruler and compass do not give, and how it was found."""
        found: dict[Plane, Label] = {}
        for plane in self.planes if self.drawing.style != "given" else ():
            steps = [*self.drawing.construction(plane).steps]
            if any(isinstance(step, Fit) and step.closures for step in steps):  # else a train's ratios give it
                found[plane] = plain(FITTED[self.lang])
            elif any(isinstance(step, Simultaneous) for step in steps):
                found[plane] = plain(TOGETHER[self.lang])
        return found

    def layout(self, papers: Sequence[Paper], crowded: Collection[Plane] = (), more: int = 1) -> Layout:
        """The best division; crowded planes count as if they had more labels."""
        extents = {p: replace(e, labels=e.labels * more) if p in crowded else e for p, e in self.extents.items()}
        if self.tight:
            papers = [replace(paper, margin=0.0) for paper in papers]
        plain = lay_out({plane: replace(extent, over=None) for plane, extent in extents.items()}, self.height, papers)
        return headed(plain, extents, self.height, papers, _COARSER)

    @cached_property
    def height(self) -> Height:
        """What the strip needs on a paper [mm], reckoned once for each."""
        return cache(partial(strip_height, found=self.found, equations=self.apart)) if not self.tight else lambda _: 0.0

    def roomier(self, composed: Composed, papers: Sequence[Paper]) -> Composed:
        """The same size of paper divided for the planes where labels found no place, if there are and that helps."""
        area = composed.layout.paper.width * composed.layout.paper.height
        same = [paper for paper in papers if paper.width * paper.height == area]
        crowded = [plane for plane, lost in zip(self.planes, composed.near.clashes, strict=True) if lost]
        for more in _MORE:
            if not composed.near.lost:
                break
            if (layout := self.layout(same, crowded, more)) != composed.layout:
                other = Composed(self, layout)
                composed = other if other.near.lost < composed.near.lost else composed
        return composed

    def page(self, layout: Layout, stages: bool, details: bool) -> Page:
        """Everything on a divided paper."""
        method, plot = self.drawing.method, self.drawing.plot
        panels = [self.panel(layout, plane, stages, details) for plane in self.planes]
        foot = Strip(layout.strip, [] if stages else self.found, self.notes, equations=[] if stages else self.apart)
        strip = None if self.tight else foot
        return Page(layout.paper, panels, method.mechanism, plot.facts.values, self.lang, strip)

    def panel(self, layout: Layout, plane: Plane, stages: bool, details: bool) -> Panel:
        """One plane's figure under its heading; with `stages`, over the lines of the pencil."""
        window = layout.window(plane, self.extent(layout, plane))
        place = plane, stages, plane in layout.headed, layout.rooms[plane], window, *layout.scales.items()
        if place not in self._panels:
            self._panels[place] = self._panel(layout, plane, stages, window)
        panel, wanted = self._panels[place], details and plane != "position"
        return detailed(panel, partial(self.drawing.figure, plane), plane) if wanted else panel

    @cached_property
    def _panels(self) -> dict[tuple[object, ...], Panel]:
        """Panels without details, by all they hang on: they are lettered once, with details and without."""
        return {}

    def _panel(self, layout: Layout, plane: Plane, stages: bool, window: Window) -> Panel:
        drawing, room = self.drawing, layout.rooms[plane]
        before = [*heading(HEADINGS[self.lang][plane], plane, window.scale, room)]
        corner = complex(room.left + HEAD_LEFT, under_heading(room).top)
        if plane == "position":
            before += drawing.paths.written(corner)
        if plane in layout.headed:
            before += laid_out(self.blocks[plane], corner, room.size.real - 2 * HEAD_LEFT)
        if stages and plane == "position":
            from graphkin.sheet.construction_lines import pencil_lines

            before += pencil_lines(drawing.construction(plane), drawing.plot, window, pages(drawing.method))
        more = self.drafted(layout, plane, window) if drawing.style == "construction" else None
        return Panel(drawing.figure(plane, window), window, room.inset(1, 1, 1), tuple(before), (), plane, more)

    def extent(self, layout: Layout, plane: Plane) -> Extent:
        """With its equations over it, where they have room there."""
        return self.extents[plane] if plane in layout.headed else replace(self.extents[plane], over=None)

    def drafted(self, layout: Layout, plane: Plane, window: Window) -> Last:
        """How a polygon is constructed, and what of the mechanism is used for it."""
        if plane == "position":
            return Annotated(self.drawing.skeleton(window), self.drawing.reading(layout.scales), self.planes)
        acts = [act for act in self.drawing.method.acts if act.plane == plane]
        loose = [] if plane in layout.headed else self.blocks[plane]
        spoken = Spoken(self.drawing.reading(layout.scales), plane)
        return Drafted(self.drawing.polygon(plane, window), spoken, acts, loose)
