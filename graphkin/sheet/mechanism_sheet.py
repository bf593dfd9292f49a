"""The sheet of a mechanism: its figure and its polygons, laid out and lettered.

It is the cheapest of several arrangements, each a paper divided into rooms: it costs labels that find no place, those
on leaders, and what stands in the strip off its figure. Larger papers are tried where that may mend a fault of one.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import cache, cached_property, partial
from heapq import heappush, heapreplace

from graphkin.base.cache import kept
from graphkin.base.value import frozen
from graphkin.construction import Plane, Plot
from graphkin.errors import Lang, TooLargeForPaper
from graphkin.planning import Method
from graphkin.planning.drawn_position import shown
from graphkin.planning.method import Act
from graphkin.say.catalogue import say
from graphkin.say.entry import Sentence
from graphkin.say.numbers import circled
from graphkin.sheet.composition import DetailRoom, Planes, SheetContents, Style
from graphkin.sheet.detail import DETAILS, SAVED, knots
from graphkin.sheet.label_requests import CRAMMED
from graphkin.sheet.labels import UNCLEAR, burden
from graphkin.sheet.layout import Layout, cut_to
from graphkin.sheet.lettering import LABEL
from graphkin.sheet.page import Page, Panel, Sheet
from graphkin.sheet.paper import PAPERS, Paper, papers_for
from graphkin.sheet.path_figure import NONE, Paths
from graphkin.sheet.results import given_tables, tables
from graphkin.sheet.text_blocks import WrittenLines
from graphkin.sheet.titleblock import FOOT, tables_room
from graphkin.sheet.window import PLANES

_FEW, _MANY, _FAR, _TOO_FAR = 3.0, 6.0, 12.0, 48.0
"""At higher prices polygons with details are tried larger; other papers, as for a fifth leader; the largest alone; and
equations without the rows under them."""
_CROWD = 32  # labels without a good place, of which details relieve no more
_SMALLER = 1.26  # so much smaller no figure is drawn to have the scale of a handout, whose page has less room
_STRIP, _LOST, _ROWS = 8.0, 8.0, 1.0  # so high a strip costs 1 [mm]; a label without a place; an equation without rows


def mechanism_sheet(
    method: Method, plot: Plot, *, paper: str | None = None, lang: Lang = "en",
    only: Plane | Collection[Plane] | None = None, style: Style = "construction", upto: int | None = None,
    tight: bool = False, paths: Paths = NONE, told: bool = False,
) -> Sheet:  # fmt: skip
    """Draw a mechanism and its polygons to scale.

    plot   the method replayed at one position
    paper  a key of `PAPERS`; the smallest that fits where left out, cut to a single figure
    tight  cut to the figures, without frame, table and title, for another document
    only   the plane or planes to draw; all three where left out
    style  "construction": how the polygons are drawn, too; "result": what comes of it; "given": the mechanism with
           what is known of it, and nothing that would have to be found
    paths  of points, drawn under the mechanism
    told   a text above gives the equations of the polygons, and all data
    upto   draw the construction as far as this act of those planes, counted from 1, its newest marks emphasised

    Raises TooLargeForPaper where a scale of the mechanism file is too fine for A3.
    """
    if style == "given":
        best = _arranged(method, plot, NONE, lang, ("position",), style, False, tight, told, paper)
        return replace(best.page.sheet(), given=True)
    drawn = paths if paths.curves else NONE
    best = _arranged(method, plot, drawn, lang, _planes(only), style, upto is None, tight, told, paper)
    if upto is not None:
        return next(_staged(best, paper, [upto]))
    return replace(best.page.sheet(), crowded=max(best.bounds()) > _TOO_FAR)


def mechanism_step_sheets(
    method: Method, plot: Plot, *, paper: str | None = None, lang: Lang = "en",
    only: Plane | Collection[Plane] | None = None, tight: bool = False,
) -> Iterator[Sheet]:  # fmt: skip
    """One sheet a step, as `mechanism_sheet(.., upto=step)` gives them."""
    best = _arranged(method, plot, NONE, lang, _planes(only), "construction", False, tight, False, paper)
    yield from _staged(best, paper)


def _contents(drawing: Planes, tight: bool = False) -> SheetContents:
    """The data and nothing else, or all results."""
    if drawing.style == "given":
        return SheetContents(drawing, {}, [] if tight else given_tables(drawing.reading({})), tight)
    found = {} if tight else tables(drawing.method, drawing.plot, drawing.lang)
    return SheetContents(drawing, found, tight=tight)


def _planes(only: Plane | Collection[Plane] | None) -> tuple[Plane, ...]:
    planes = PLANES if only is None else (only,) if isinstance(only, str) else only
    return tuple(plane for plane in PLANES if plane in planes)


def scales_of(method: Method, plot: Plot, breaks: bool = True, paged: bool = False) -> Mapping[Plane, float]:
    """The scales of the sheet in every language, or of one on which no arrow is drawn broken; paged: none is finer than
    a handout's page has room for."""
    best = _arranged(method, plot, NONE, "en", PLANES, "construction", breaks, False, False, None)
    least = best.contents.drawing.least if paged else {}
    return {plane: max(scale, least.get(plane, 0.0)) for plane, scale in best.layout.scales.items()}


@frozen
class Arrangement:
    """The contents of a sheet on one divided paper."""

    contents: SheetContents
    layout: Layout

    @classmethod
    def on(cls, contents: SheetContents, papers: Sequence[Paper]) -> Arrangement:
        """On the smallest paper that holds all, some blocks in the strip if need be; cut where it is tight. Raises
        TooLargeForPaper."""
        try:
            made = cls(*contents.laid_out(papers))
        except TooLargeForPaper as error:
            raise error.at(contents.drawing.method.mechanism.where("scales", error.key)) from None
        return made.cut if contents.tight else made

    @property
    def cut(self) -> Arrangement:
        """Cut to its only figure, where it has but one."""
        (plane, *others), extents = self.contents.drawing.planes, self.contents.extents
        return self if others else replace(self, layout=cut_to(self.layout, plane, extents[plane]))

    @property
    def sold(self) -> Paper:
        """Its paper in the size in which it can be asked for."""
        return PAPERS[self.layout.paper.name]

    @cached_property
    def overfull(self) -> float:
        """The part of its room for letters that the labels of the fullest figure take; above 1 some lie on others."""
        rooms, extents = self.layout.rooms, self.contents.drawing.extents
        return max(extents[p].lettering / (CRAMMED * room.size.real * room.size.imag) for p, room in rooms.items())

    def bounds(self) -> Iterator[float]:
        """Its price, as far as it is composed: labels that find no place near by, the burden of the others, and what
        stands over the footer, off its figure. Of an overfull one all labels have no place. Polygons are composed
        first, those with details before others."""
        if self.overfull > 1:
            yield _LOST * sum(extent.labels for extent in self.contents.drawing.extents.values()) + self.overfull
            return
        rows = sum(len(ladder.blocks) for ladder in self.contents.ladders.values()) if self.contents.brief else 0
        yield (price := max(0.0, self.layout.strip.size.imag - FOOT) / _STRIP + _ROWS * rows)
        detailed, planes = self.contents.detailed, self.contents.drawing.planes
        for plane in sorted(planes, key=lambda plane: (plane not in detailed, plane == "position")):
            yield (price := round(price + self._price(plane), 6))

    @property
    def knotted(self) -> dict[Plane, DetailRoom]:
        """Details that would relieve labels of polygons: small ones where little is to be seen in them; none of an
        overfull figure, or of one in which more labels have no good place than a detail relieves."""
        planes = [plane for plane in self.contents.drawing.planes if plane != "position" and self.overfull <= 1]
        return {plane: DetailRoom(DETAILS[burden(panel.burdens) > 2 * SAVED])
                for plane, panel in zip(planes, map(self.panel, planes), strict=True)
                if (panel.burdens >= UNCLEAR).sum() <= _CROWD and knots(panel.figure, panel.burdens)}  # fmt: skip

    def enlarged(self) -> Iterator[Arrangement]:
        """On the same paper with larger polygons where these have details, and the mechanism as it is; with one alone
        that costs too much, at the cost of all others."""
        contents, scales = self.contents, self.layout.scales
        if contents.detailed and not contents.tight and not contents.larger:
            larger: Collection[Plane] = contents.detailed
            own: dict[Plane, float] = {plane: scale for plane, scale in scales.items() if plane == "position"}
            if max(self.bounds()) > _TOO_FAR:
                larger, own = [max(larger, key=self._price)], {}
            yield Arrangement.on(replace(contents, larger=frozenset(larger), scales=own), [self.sold])

    def _price(self, plane: Plane) -> float:
        """The price of one figure."""
        panel = self.panel(plane)
        return _LOST * len(panel.near.clashing) + burden(panel.burdens)

    @cached_property
    def panel(self) -> Callable[[Plane], Panel]:
        """The figure of each plane."""
        return cache(partial(self.contents.panel, self.layout))

    @property
    def page(self) -> Page:
        """All of it; of figures for another document no more paper than they need."""
        drawing, strip = self.contents.drawing, self.contents.strip
        panels, machine = [*map(self.panel, drawing.planes)], drawing.method.mechanism
        page = Page(self.layout.paper, panels, machine, drawing.plot.facts.values, drawing.lang, strip)
        return page.trimmed if self.contents.tight else page


@kept(8, objects=3)  # both languages of a handout's figures
def _arranged(
    method: Method, plot: Plot, paths: Paths, lang: Lang, planes: tuple[Plane, ...], style: Style, breaks: bool,
    tight: bool, told: bool, paper: str | None,
) -> Arrangement:  # fmt: skip
    """The cheapest arrangement of the English sheet; of another language in its rooms, or at least at its scales.
    Solution, sheet, steps and other languages of one drawing hang on the same, so it is kept for a while."""
    arranged = partial(_arranged, method, plot, paths)
    if lang == "en":
        drawn = (method, plot) if style == "given" else shown(method, plot)
        drawing = Planes(*drawn, planes, style, lang, paths, breaks, told)
        if breaks and not any(drawing.left_out.values()):  # as it is without
            return arranged(lang, planes, style, False, tight, told, paper)
        best = cheapest(_contents(drawing, tight), paper)
        more = [least / best.layout.scales[plane] for plane, least in drawing.least.items()]
        if paper or planes != PLANES or not 1 < max(more) < _SMALLER:
            return best
        same = [each for each in papers_for(None) if each.area == best.sold.area]
        paged = Arrangement.on(replace(best.contents, paged=True), same)  # whose scales a handout has, if none suffers
        small = any(paged.layout.scales[plane] > _SMALLER * scale for plane, scale in best.layout.scales.items())
        return best if small or max(paged.bounds()) > max(best.bounds()) else paged
    best = arranged("en", planes, style, breaks, tight, told, paper)
    own = _contents(replace(best.contents.drawing, lang=lang), tight)
    english, layout = best.contents, best.layout
    details = {plane: replace(room, parts=best.panel(plane).magnified) for plane, room in english.detailed.items()}
    alike = replace(own, low=english.low, without=english.without, brief=english.brief, detailed=details,
                    scales=layout.scales)  # fmt: skip
    if layout.holds(alike.extents, alike.height(layout.paper)):
        return Arrangement(alike, layout)
    with suppress(TooLargeForPaper):
        larger = Arrangement.on(alike, [other for other in papers_for(paper) if other.area >= best.sold.area])
        return larger if paper else larger.cut
    return cheapest(own, paper)


def cheapest(contents: SheetContents, paper: str | None) -> Arrangement:
    """The cheapest arrangement on the paper, or on one that is large enough; cut to a single figure. A figure for
    another document stays on the smallest. None is composed further once another is known to be cheaper; where the
    cheapest is far too dear, the largest papers are tried next."""
    papers, enlarged = papers_for(paper), set[int]()
    others, largest = [] if contents.tight else papers[::-1], max(each.area for each in papers)
    briefly = [each for each in others if each.area == largest and contents.ladders]
    tried = [(0.0, number, each, each.bounds()) for number, each in enumerate(_arrangements(contents, papers))]
    while True:
        price, number, best, bounds = tried[0]
        more: Iterable[Arrangement] = ()
        if price > _FEW and number not in enlarged and (price < _FAR or not others):
            enlarged.add(number)
            more = best.enlarged()
        elif price > _MANY and others:
            others.sort(key=lambda other: (-other.area, other.lying == best.layout.paper.lying))
            other = others.pop()
            if other != best.sold and (price < _FAR or other.area == largest):
                more = _arrangements(contents, [other])
        elif (price := next(bounds, -1.0)) >= 0:
            heapreplace(tried, (price, number, best, bounds))
        elif tried[0][0] > _TOO_FAR and briefly:
            more = _arrangements(replace(contents, brief=True), [briefly.pop()])
        else:
            return best if paper else best.cut
        with suppress(TooLargeForPaper):
            for each in more:
                heappush(tried, (0.0, len(tried), each, each.bounds()))


def _arrangements(contents: SheetContents, papers: Sequence[Paper]) -> Iterator[Arrangement]:
    """Those on papers: without details, and with those that it wants (large ones, too, where cut)."""
    yield (one := Arrangement.on(contents, papers))
    if small := one.knotted:
        for rooms in (small, dict.fromkeys(small, DetailRoom(DETAILS[1])))[: 1 + contents.tight]:
            yield Arrangement.on(replace(contents, detailed=rooms), papers)


def _staged(best: Arrangement, paper: str | None, numbers: Sequence[int] = ()) -> Iterator[Sheet]:
    """The drawing as far as each act, or as some: the pencil's own lines are there too, and a sentence for results."""
    told, stage = _spoken(best), replace(best, contents=replace(best.contents, stages=True))
    same = [each for each in papers_for(paper) if each.area == best.sold.area]
    wide = min(tables_room(each.reduced) for each in same)
    said = max(WrittenLines.sentences(texts, wide, LABEL).size.imag for texts in told.values())  # over the footer
    for scales in () if best.contents.tight else (best.layout.scales, {}):  # those of the whole sheet, if there is room
        with suppress(TooLargeForPaper):
            stage = Arrangement.on(replace(stage.contents, said=said, scales=scales, tables={}), same)
            stage = stage if paper else stage.cut
            told = _spoken(stage)
            break
    page = stage.page
    for act in [[*told][number - 1] for number in numbers] or told:
        if page.strip is not None and stage.contents.said:
            page = replace(page, strip=replace(page.strip, told=told[act]))
        yield page.sheet().upto(act.page)


def _spoken(stage: Arrangement) -> dict[Act, list[str]]:
    """The number and the sentence of each act, at the scales that are drawn. Raises TooLargeForPaper."""
    from graphkin.say.explained import derivation

    drawing, planes = stage.contents.drawing, stage.contents.drawing.planes
    others = {} if planes == PLANES else scales_of(drawing.method, drawing.plot, breaks=False)
    reading = drawing.reading({**others, **stage.layout.scales})
    entries = derivation(reading.method, reading.plot, reading.scales, reading.lang, as_planned=True)
    texts = {entry.act: entry.text for entry in entries if isinstance(entry, Sentence) and entry.act is not None}
    acts = [act for act in drawing.method.acts if act.plane in planes]
    heads = (say("sheet.step", drawing.lang, number=number, count=len(acts)) for number in range(1, len(acts) + 1))
    signs = (f"{circled(act.number)} " if act.numbered else "" for act in acts)
    return {act: [head, sign + texts.get(act, "")] for act, head, sign in zip(acts, heads, signs, strict=True)}
