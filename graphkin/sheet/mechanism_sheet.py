"""The sheet of a mechanism: its figure and its polygons, drawn once to see how far they reach, laid out, lettered.

Labels that find no place choose paper and scales, too: every division is lettered near by before one is taken.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property, partial

from graphkin.construction import Construction, Fit, Plane, Plot, Simultaneous
from graphkin.errors import Lang
from graphkin.planning import Method
from graphkin.sheet.arrows import heads_apart, side_by_side
from graphkin.sheet.fit import Extent
from graphkin.sheet.gear_images import GearImage, gear_images
from graphkin.sheet.layout import Layout, cut_to, lay_out, papers_for
from graphkin.sheet.lettering import Label, plain
from graphkin.sheet.mechanism_figure import mechanism_figure
from graphkin.sheet.page import Lettered, Page, Panel, Sheet, heading, step_sheets
from graphkin.sheet.paper import LARGE, Paper
from graphkin.sheet.pencil import pencil_lines
from graphkin.sheet.plain_mechanism import shown_places
from graphkin.sheet.polygons import Polygon, polygon_figure
from graphkin.sheet.results import Table, tables
from graphkin.sheet.scales import KEYS, TooLargeForPaper
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.titleblock import Strip, strip_height
from graphkin.sheet.window import PLANES, Figure, Window, births, constructions, first_steps, step_count
from graphkin.value import frozen

_CROWDED, _EASED = 8, 4
"""With more leaders than this a larger paper is tried, and taken where it saves so many."""
_MORE = (2, 4)
"""So many times its labels count for a plane where some found no place."""
HEADINGS: dict[Lang, dict[Plane, str]] = {
    "en": {"position": "Mechanism", "velocity": "Velocity polygon", "acceleration": "Acceleration polygon"},
    "zh": {"position": "机构运动简图", "velocity": "速度多边形", "acceleration": "加速度多边形"},
}

FITTED: dict[Lang, str] = {"en": "fitted by trial", "zh": "样板法试凑"}
TOGETHER: dict[Lang, str] = {"en": "solved together", "zh": "联立求解"}


def mechanism_sheet(
    method: Method,
    plot: Plot,
    *,
    paper: str | None = None,
    lang: Lang = "en",
    only: Plane | Collection[Plane] | None = None,
    upto: int | None = None,
    tight: bool = False,
) -> Sheet:
    """Draw a mechanism and its polygons to scale.

    plot   the method replayed at one position
    paper  a key of `PAPERS`; the smallest that fits where left out, cut to a single figure
    tight  cut to the figures, without frame, table and title, for another document
    only   the plane or planes to draw; all three where left out
    upto   draw the construction as far as this step (1 to `step_count(method)`), its newest marks emphasised

    Raises TooLargeForPaper where a scale of the mechanism file is too fine for A3.
    """
    work = _Work(_Planes(method, plot), _planes(only), [] if tight else tables(method, plot, lang), lang, tight)
    if upto is not None:
        return _staged(work, paper).upto(upto)
    best = _cut(work, paper)
    return (work.on(best.layout, far=True) if best.lettered.lost else best).lettered.sheet


def mechanism_step_sheets(
    method: Method,
    plot: Plot,
    *,
    paper: str | None = None,
    lang: Lang = "en",
    only: Plane | Collection[Plane] | None = None,
    tight: bool = False,
) -> Iterator[Sheet]:
    """One sheet a step, as `mechanism_sheet(.., upto=step)` gives them."""
    work = _Work(_Planes(method, plot), _planes(only), [] if tight else tables(method, plot, lang), lang, tight)
    yield from step_sheets(_staged(work, paper), range(1, step_count(method) + 1))


def _planes(only: Plane | Collection[Plane] | None) -> tuple[Plane, ...]:
    wanted = PLANES if only is None else (only,) if isinstance(only, str) else only
    return tuple(plane for plane in PLANES if plane in wanted)


def scales_of(method: Method, plot: Plot, lang: Lang) -> Mapping[Plane, float]:
    """The scales of the sheet, without its last lettering."""
    return _divided(_Work(_Planes(method, plot), PLANES, tables(method, plot, lang), lang), None).layout.scales


@frozen
class _Planes:
    """Draws any plane through any window."""

    method: Method
    plot: Plot

    def construction(self, plane: Plane) -> Construction:
        return constructions(self.method)[plane]

    def values(self, plane: Plane) -> list[complex]:
        """The points a plane shows, in SI units."""
        if plane == "position":
            return shown_places(self.method, self.plot)
        points = self.plot.points(plane)
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
        polygon = Polygon(self.method.mechanism, construction, self.plot, window, born, self.gears(plane))
        return heads_apart(side_by_side(polygon_figure(polygon)))

    def extent(self, plane: Plane) -> Extent:
        """How large the plane's points are, and how far its signs reach beyond them."""
        given = self.method.mechanism.scales.get(KEYS[plane])
        return Extent.of(self.values(plane), partial(self.figure, plane), given)


# --- which paper, how divided -----------------------------------------------------------------


@frozen
class _Composed:
    """A page lettered, and how its paper was divided."""

    layout: Layout
    lettered: Lettered


def _staged(work: _Work, paper: str | None) -> Sheet:
    """The pencil's own lines are there too, and no results; the paper is that of the sheet without them."""
    return work.on(_cut(work, paper).layout, stages=True, far=True).lettered.sheet


def _cut(work: _Work, paper: str | None) -> _Composed:
    """On the paper divided; cut to a single figure, where the paper was not asked for."""
    best = _divided(work, paper)
    if len(work.planes) > 1 or not (work.tight or paper is None):
        return best
    return work.on(cut_to(best.layout, work.planes[0], work.extents[work.planes[0]]))


def _divided(work: _Work, paper: str | None) -> _Composed:
    """Lettered near by, on the paper divided best: the smallest that holds all and leaves its letters room."""
    try:
        layout = work.layout(papers_for(paper))
    except TooLargeForPaper as error:
        raise error.at(work.drawing.method.mechanism.where("scales", error.key)) from None
    best = work.roomier(work.on(layout), papers_for(paper))
    now = best.lettered
    if paper is None and layout.paper not in LARGE and (now.crowded > _CROWDED or now.lost):
        larger = work.roomier(work.on(work.layout(LARGE)), LARGE)
        eased = larger.lettered.crowded <= now.crowded - _EASED
        return larger if (larger.lettered.lost, not eased) < (now.lost, True) else best
    return best


@frozen
class _Work:
    """What does not depend on the paper."""

    drawing: _Planes
    planes: tuple[Plane, ...]
    found: list[Table]
    lang: Lang
    tight: bool = False

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
        if self.tight:
            return lay_out(extents, lambda paper: 0.0, [replace(paper, margin=0.0) for paper in papers])
        return lay_out(extents, partial(strip_height, found=self.found), papers)

    def roomier(self, composed: _Composed, papers: Sequence[Paper]) -> _Composed:
        """The same size of paper divided for the planes where labels found no place, if there are and that helps."""
        if not composed.lettered.lost:
            return composed
        area = composed.layout.paper.width * composed.layout.paper.height
        same = [paper for paper in papers if paper.width * paper.height == area]
        crowded = [plane for plane, lost in zip(self.planes, composed.lettered.clashes) if lost]
        for more in _MORE:
            if (layout := self.layout(same, crowded, more)) != composed.layout:
                other = self.on(layout)
                composed = other if other.lettered.lost < composed.lettered.lost else composed
        return composed

    def on(self, layout: Layout, stages: bool = False, far: bool = False) -> _Composed:
        """Everything on a divided paper; with `far`, labels of a crowd go far off to find a place."""
        method, plot = self.drawing.method, self.drawing.plot
        panels = [self.panel(layout, plane, stages) for plane in self.planes]
        foot = None if self.tight else Strip(layout.strip, [] if stages else self.found, self.notes)
        lettered = Page(layout.paper, panels, method.mechanism, plot.facts.values, self.lang, foot).lettered(far)
        return _Composed(layout, lettered.trimmed if self.tight else lettered)

    def panel(self, layout: Layout, plane: Plane, stages: bool) -> Panel:
        """One plane's figure under its heading; with `stages`, over the lines of the pencil."""
        drawing, room, window = self.drawing, layout.rooms[plane], layout.window(plane, self.extents[plane])
        before = [*heading(HEADINGS[self.lang][plane], plane, window.scale, room)]
        if stages:
            first = first_steps(drawing.method)[plane]
            before += pencil_lines(drawing.construction(plane), drawing.plot, window, room, first)
        return Panel(drawing.figure(plane, window), window, room.inset(1, 1, 1), tuple(before), plane=plane)
