"""All figures of a sheet together: drawn once to see how far they reach, laid out, drawn, lettered."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from functools import cached_property

from graphkin.construction import Construction, Fit, Plane, Plot, Simultaneous
from graphkin.errors import Lang
from graphkin.planning import Method
from graphkin.sheet.gear_images import GearImage, gear_images
from graphkin.sheet.labels import Room, settle
from graphkin.sheet.layout import HEAD, Extent, Layout, lay_out, papers_for
from graphkin.sheet.lettering import Label, plain, width
from graphkin.sheet.marks import Mark, Place, Stroke, Text
from graphkin.sheet.mechanism_figure import mechanism_figure
from graphkin.sheet.obstacles import bounds
from graphkin.sheet.paper import LABEL, PAPERS, Paper
from graphkin.sheet.pencil import pencil_lines
from graphkin.sheet.polygons import Polygon, polygon_figure
from graphkin.sheet.results import Table, tables
from graphkin.sheet.scales import KEYS, TooLargeForPaper, finest, written
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.specials import named_specials
from graphkin.sheet.titleblock import strip, strip_heights
from graphkin.sheet.wheels import rims
from graphkin.sheet.window import PLANES, Figure, Window, births, constructions, first_steps
from graphkin.value import frozen

__all__ = ["Composed", "compose", "scales_of"]

_TRIAL = 100.0
"""Size of a figure when it is drawn to see how far its signs reach [mm]."""
_CROWDED, _EASED = 8, 4
"""With more leaders than this a larger paper is tried, and taken where it saves so many."""
_LARGE = [PAPERS["A3-landscape"], PAPERS["A3"]]
_MORE = (2, 4)
"""So many times its labels count for a plane where some found no place."""
_LETTERS = 6.5
"""What labels need around a figure [mm]."""
HEADINGS: dict[Lang, dict[Plane, str]] = {
    "en": {"position": "Mechanism", "velocity": "Velocity polygon", "acceleration": "Acceleration polygon"},
    "zh": {"position": "机构运动简图", "velocity": "速度多边形", "acceleration": "加速度多边形"},
}

FITTED: dict[Lang, str] = {"en": "fitted by trial", "zh": "样板法试凑"}
TOGETHER: dict[Lang, str] = {"en": "solved together", "zh": "联立求解"}


@frozen
class Composed:
    """Marks on a laid out paper, and where each plane's origin came to lie."""

    layout: Layout
    marks: list[Mark]
    origins: Mapping[Plane, Place]
    clashes: Mapping[Plane, int]
    """How many labels of a plane found no place of their own near what they name."""

    @property
    def lost(self) -> int:
        return sum(self.clashes.values())

    @property
    def crowded(self) -> int:
        """How many labels stand off from what they name, at the end of a leader."""
        return sum(isinstance(mark, Stroke) and mark.pen == "leader" for mark in self.marks)


@frozen
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
            machine = self.method.mechanism
            named = [complex(v) for name, v in points.items() if name in machine.points]
            drawn = [*named, *rims(machine, points)]
            return [*drawn, *named_specials(self.method, self.plot, drawn).values()]
        names = {self.construction(plane).pole, *self.construction(plane).nodes}
        found = [complex(v) for name, v in points.items() if name in names]
        return found + [corner for image in self.gears(plane) for corner in image.corners]

    def gears(self, plane: Plane) -> list[GearImage]:
        return gear_images(self.method, self.plot) if plane == "velocity" else []

    def figure(self, plane: Plane, window: Window) -> Figure:
        born = births(self.construction(plane), first_steps(self.method)[plane])
        if plane == "position":
            skeleton = Skeleton(self.method.mechanism, self.plot, window, born)
            return mechanism_figure(skeleton, self.method, self.values(plane))
        construction = self.construction(plane)
        return polygon_figure(Polygon(self.method.mechanism, construction, self.plot, window, born, self.gears(plane)))

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


@frozen
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
    method: Method, plot: Plot, planes: tuple[Plane, ...], paper: str | None, lang: Lang, stages: bool
) -> Composed:
    """Draw, lay out, letter. With `stages` the pencil's own lines are there too, and no results.

    The paper is the smallest that holds all and leaves its letters room; the same for `stages` or not.
    """
    work = _Work(_Planes(method, plot), planes, tables(method, plot, lang), lang)
    composed = _divided(work, paper)
    return work.on(composed.layout, stages, far=True) if stages or composed.lost else composed


def scales_of(method: Method, plot: Plot, lang: Lang) -> Mapping[Plane, float]:
    """The scales of the sheet, without its last lettering; labels that find no place choose paper and scales, too."""
    return _divided(_Work(_Planes(method, plot), PLANES, tables(method, plot, lang), lang), None).layout.scales


def _divided(work: _Work, paper: str | None) -> Composed:
    """Lettered near by, on the paper divided best."""
    try:
        layout = work.layout(papers_for(paper))
    except TooLargeForPaper as error:
        raise error.at(work.drawing.method.mechanism.where("scales", error.key)) from None
    composed = work.on(layout)
    if composed.lost:
        composed = work.roomier(composed, papers_for(paper))
    if paper is None and _small(composed) and (composed.crowded > _CROWDED or composed.lost):
        larger = work.on(work.layout(_LARGE))
        if larger.lost:
            larger = work.roomier(larger, _LARGE)
        eased = larger.crowded <= composed.crowded - _EASED
        composed = larger if (larger.lost, not eased) < (composed.lost, True) else composed
    return composed


def _small(composed: Composed) -> bool:
    return not composed.layout.paper.name.startswith("A3")


@frozen
class _Work:
    """What does not depend on the paper."""

    drawing: _Planes
    planes: tuple[Plane, ...]
    found: list[Table]
    lang: Lang

    @cached_property
    def extents(self) -> dict[Plane, Extent]:
        return {plane: self.drawing.extent(plane) for plane in self.planes}

    @cached_property
    def notes(self) -> dict[Plane, Label]:
        """Planes that hold what ruler and compass do not give, and how it was found."""
        found: dict[Plane, Label] = {}
        for plane in self.planes:
            kinds = {type(step) for step in self.drawing.construction(plane).steps}
            if Fit in kinds:
                found[plane] = plain(FITTED[self.lang])
            elif Simultaneous in kinds:
                found[plane] = plain(TOGETHER[self.lang])
        return found

    def layout(self, papers: Sequence[Paper], crowded: Collection[Plane] = (), more: int = 1) -> Layout:
        """The best division; crowded planes count as if they had more labels."""
        extents = {p: replace(e, labels=e.labels * more) if p in crowded else e for p, e in self.extents.items()}
        return lay_out(extents, strip_heights(self.found), papers)

    def roomier(self, composed: Composed, papers: Sequence[Paper]) -> Composed:
        """The same size of paper divided for the planes where labels found no place, if that helps."""
        area = composed.layout.paper.width * composed.layout.paper.height
        same = [paper for paper in papers if paper.width * paper.height == area]
        crowded = [plane for plane, lost in composed.clashes.items() if lost]
        for more in _MORE:
            if (layout := self.layout(same, crowded, more)) != composed.layout:
                other = self.on(layout)
                composed = other if other.lost < composed.lost else composed
        return composed

    def on(self, layout: Layout, stages: bool = False, far: bool = False) -> Composed:
        """Everything on a divided paper; with `far`, labels of a crowd go far off to find a place."""
        machine, found = self.drawing.method.mechanism, [] if stages else self.found
        marks = strip(machine, found, layout.paper, layout.strip, layout.scales, self.notes, self.lang)
        origins: dict[Plane, Place] = {}
        clashes: dict[Plane, int] = {}
        for plane in self.planes:
            origins[plane] = _origin(self.drawing.values(plane), self.extents[plane], layout, plane)
            figure, drawn = _placed(self.drawing, plane, layout, origins[plane], self.lang, stages)
            settled = settle(figure.wanted, drawn, _inner(layout.rooms[plane]), far)
            marks += drawn + settled.marks
            clashes[plane] = settled.clashes
        return Composed(layout, marks, origins, clashes)


def _origin(values: Sequence[complex], extent: Extent, layout: Layout, plane: Plane) -> Place:
    """The plane's origin on paper, so that the figure with all its signs stands in the middle of its room."""
    room, scale = layout.rooms[plane], layout.scales[plane]
    low, _ = _corners(values)
    whole = extent.size / scale + extent.reach
    x = (room.left + room.right - whole.real) / 2 + extent.left
    y = (room.top + HEAD + room.bottom - whole.imag) / 2 + extent.top + extent.size.imag / scale
    return complex(x, y) - low.conjugate() / scale


def _placed(
    drawing: _Planes, plane: Plane, layout: Layout, origin: Place, lang: Lang, stages: bool
) -> tuple[Figure, list[Mark]]:
    """One plane's figure, and its marks with heading and lines of the pencil, without labels."""
    room, window = layout.rooms[plane], Window(origin, layout.scales[plane])
    figure = drawing.figure(plane, window)
    marks = [*_heading(plane, room, layout.scales[plane], lang)]
    if stages:
        before = first_steps(drawing.method)[plane]
        marks += pencil_lines(drawing.construction(plane), drawing.plot, window, room, before)
    return figure, marks + figure.marks


def _inner(room: Room) -> Room:
    """Where labels may stand."""
    return Room(room.left + 1, room.top + 1, room.right - 1, room.bottom - 1)


def _heading(plane: Plane, room: Room, scale: float, lang: Lang) -> list[Mark]:
    """What the figure is, and its scale."""
    label, at = plain(HEADINGS[lang][plane]), complex(room.left + 3, room.top + 5.5)
    return [Text(label, at, LABEL), Text(written(plane, scale), at + width(label, LABEL) + 4, LABEL)]
