"""The sheet of a mechanism: its figure and its polygons, drawn once to see how far they reach, laid out, lettered.

Labels that find no place choose paper and scales, too: a division is lettered near by before it is taken, unless its
figures are too small for so many labels.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cache, cached_property, partial

from graphkin.construction import Fit, Plane, Plot, Simultaneous
from graphkin.errors import Lang
from graphkin.planning import Method
from graphkin.planning.found_when import pages
from graphkin.say.plane import Polygon as Spoken
from graphkin.sheet.annotated import Annotated
from graphkin.sheet.detail import detailed
from graphkin.sheet.drafted import Drafted
from graphkin.sheet.equation_rows import EquationBlock, head_of, laid_out
from graphkin.sheet.fit import Extent
from graphkin.sheet.free_room import FreeRoom
from graphkin.sheet.given_tables import given_tables
from graphkin.sheet.layout import HEAD_LEFT, Height, Layout, cut_to, headed, lay_out, papers_for, under_heading
from graphkin.sheet.lettering import Label, plain
from graphkin.sheet.page import Last, Lettered, Page, Panel, Sheet, heading
from graphkin.sheet.paper import LARGE, Paper
from graphkin.sheet.path_figure import NONE, Paths
from graphkin.sheet.pencil import pencil_lines
from graphkin.sheet.planes import Planes, Style
from graphkin.sheet.results import tables
from graphkin.sheet.scales import TooLargeForPaper
from graphkin.sheet.table import Table
from graphkin.sheet.titleblock import Strip, strip_height
from graphkin.sheet.window import PLANES, Window
from graphkin.value import frozen

_CROWDED, _EASED = 10, 4
"""With more leaders than this a larger paper is tried, and taken where it saves so many."""
_COARSER = 1.34
"""So much coarser a figure may be drawn to have room for its equations over it."""
_TRIALS = 4
"""How often equations are moved into the strip, whose height leaves figures less room."""
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


def mechanism_sheet(
    method: Method,
    plot: Plot,
    *,
    paper: str | None = None,
    lang: Lang = "en",
    only: Plane | Collection[Plane] | None = None,
    style: Style = "construction",
    upto: int | None = None,
    tight: bool = False,
    paths: Paths = NONE,
) -> Sheet:
    """Draw a mechanism and its polygons to scale.

    plot   the method replayed at one position
    paper  a key of `PAPERS`; the smallest that fits where left out, cut to a single figure
    tight  cut to the figures, without frame, table and title, for another document
    only   the plane or planes to draw; all three where left out
    style  "construction": how the polygons are drawn, too; "result": what comes of it; "given": the mechanism with
           what is known of it, and nothing that would have to be found
    paths  of points, drawn under the mechanism
    upto   draw the construction as far as this act of those planes, counted from 1, its newest marks emphasised

    Raises TooLargeForPaper where a scale of the mechanism file is too fine for A3.
    """
    if style == "given":
        return _given(Planes(method, plot, ("position",), style, lang), paper, tight)
    drawing = Planes(method, plot, _planes(only), style, lang, paths)
    work = _Work(drawing, [] if tight else tables(method, plot, lang), tight)
    if upto is not None:
        return next(_staged(work, paper, [upto]))
    return _whole(work, paper).lettered.sheet


def _given(drawing: Planes, paper: str | None, tight: bool) -> Sheet:
    """The mechanism alone, with what the problem gives and asks."""
    work = _Work(drawing, [] if tight else given_tables(drawing.reading({})), tight)
    return replace(_whole(work, paper).lettered.sheet, given=True)


def _whole(work: _Work, paper: str | None) -> _Composed:
    """Divided best, and lettered as well as can be; equations for which figures have no room go into the strip.

    Those that only a small paper had no room for come back where it turns out too small for the letters as well.
    """
    trials, large, every = 1 if work.tight else _TRIALS, None, work
    while True:
        whole = _cut(work, paper, large, trials > 1)
        larger = paper is None and whole.layout.paper in LARGE
        if whole.homeless:
            work = work.without(whole.homeless)
        elif larger and large is None and work.apart:
            work, large = every, True
        elif trials > 1 and (out := whole.left_out):
            work, large, trials = work.without(out), larger, trials - 1
        else:
            return whole


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
    drawing = Planes(method, plot, _planes(only), "construction", lang)
    yield from _staged(_Work(drawing, [] if tight else tables(method, plot, lang), tight), paper)


def _planes(only: Plane | Collection[Plane] | None) -> tuple[Plane, ...]:
    wanted = PLANES if only is None else (only,) if isinstance(only, str) else only
    return tuple(plane for plane in PLANES if plane in wanted)


def scales_of(method: Method, plot: Plot, lang: Lang) -> Mapping[Plane, float]:
    """The scales of the sheet."""
    work = _Work(Planes(method, plot, PLANES, "construction", lang), tables(method, plot, lang))
    return _whole(work, None).layout.scales


# --- which paper, how divided -----------------------------------------------------------------


@frozen
class _Composed:
    """All of it on a divided paper.

    stages    over the lines of the pencil, for single steps
    details   what lies too close together is drawn once more, magnified
    hopeless  it was crammed without details
    homeless  equations for which there is no room, seen before anything was lettered
    """

    work: _Work
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
    def detailed(self) -> _Composed:
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


def _staged(work: _Work, paper: str | None, numbers: Sequence[int] = ()) -> Iterator[Sheet]:
    """The drawing as far as each act, or as some: the pencil's own lines are there too, and a sentence for results."""
    from graphkin.sheet.captions import Captions  # all the words of a solution

    found, drawing = _whole(work, paper), work.drawing
    layout, whole = found.layout, replace(found, stages=True).lettered.sheet
    others = {} if work.planes == PLANES else scales_of(drawing.method, drawing.plot, work.lang)
    captions = Captions.of(drawing.reading({**others, **layout.scales}), work.planes)
    strip = None if work.tight else layout.strip
    return (captions.sheet(whole, number, strip) for number in numbers or range(1, len(captions.acts) + 1))


def _cut(work: _Work, paper: str | None, large: bool | None, trial: bool) -> _Composed:
    """On the paper divided; cut to a single figure, where the paper was not asked for."""
    best = _divided(work, paper, large, trial)
    if len(work.planes) > 1 or not (work.tight or paper is None):
        return best
    return replace(best, layout=cut_to(best.layout, work.planes[0], work.extent(best.layout, work.planes[0])))


def _divided(work: _Work, paper: str | None, large: bool | None, trial: bool) -> _Composed:
    """On the paper divided best: the smallest that holds all and leaves its letters room.

    large  whether a larger one was taken when this was tried before
    trial  equations may still be moved into the strip: not lettered where some must be
    """
    papers = LARGE if large else papers_for(paper)
    try:
        layout = work.layout(papers)
    except TooLargeForPaper as error:
        raise error.at(work.drawing.method.mechanism.where("scales", error.key)) from None
    small, best = paper is None and layout.paper not in LARGE, _Composed(work, layout)
    if trial and not best.full and (homeless := work.homeless(layout)):
        return replace(best, homeless=homeless)
    if best.crammed:
        return _divided(work, paper, True, trial) if small else replace(best, details=True, hopeless=True)
    best = work.roomier(best, papers)
    found = best.detailed
    if small and (found.near.lost or (found.near.crowded > _CROWDED and large is None)):
        larger = work.roomier(_Composed(work, work.layout(LARGE)), LARGE)
        eased = larger.near.crowded <= best.near.crowded - _EASED
        return larger.detailed if (larger.near.lost, not eased) < (best.near.lost, True) else found
    return found


@frozen
class _Work:
    """What does not depend on the paper; `apart`: equations that go into the strip."""

    drawing: Planes
    found: list[Table]
    tight: bool = False
    apart: Sequence[EquationBlock] = ()

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

    def without(self, out: Sequence[EquationBlock]) -> _Work:
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
                free = FreeRoom(panel.drawn, panel.room)
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

    def roomier(self, composed: _Composed, papers: Sequence[Paper]) -> _Composed:
        """The same size of paper divided for the planes where labels found no place, if there are and that helps."""
        area = composed.layout.paper.width * composed.layout.paper.height
        same = [paper for paper in papers if paper.width * paper.height == area]
        crowded = [plane for plane, lost in zip(self.planes, composed.near.clashes, strict=True) if lost]
        for more in _MORE:
            if not composed.near.lost:
                break
            if (layout := self.layout(same, crowded, more)) != composed.layout:
                other = _Composed(self, layout)
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
