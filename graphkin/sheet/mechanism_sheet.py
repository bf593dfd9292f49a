"""The sheet of a mechanism: its figure and its polygons, laid out and lettered.

It is the cheapest of several arrangements. An arrangement is a paper and its division into rooms, by which all is
composed; it costs the labels that find no place, those at the end of a leader, and what stands in the strip off its
figure. Arrangements are composed one after the other, each where it may mend a fault of the best so far: the
smallest paper that holds all, other divisions of it, details, the same paper turned, a larger paper.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import cached_property

from graphkin.base.value import frozen
from graphkin.construction import Plane, Plot
from graphkin.errors import Lang
from graphkin.planning import Method
from graphkin.planning.drawn_position import shown
from graphkin.planning.method import Act
from graphkin.say.catalogue import say
from graphkin.say.entry import Sentence
from graphkin.say.explained import derivation
from graphkin.say.numbers import circled
from graphkin.sheet.composition import Planes, SheetContents, Style
from graphkin.sheet.detail import SAVED
from graphkin.sheet.label_requests import CRAMMED
from graphkin.sheet.labels import burden
from graphkin.sheet.layout import Layout, cut_to
from graphkin.sheet.lettering import LABEL, Label, formula, plain
from graphkin.sheet.marks import Text, enlarged
from graphkin.sheet.page import Lettered, Page, Sheet
from graphkin.sheet.paper import PAPERS, Paper, TooLargeForPaper, papers_for
from graphkin.sheet.path_figure import NONE, Paths
from graphkin.sheet.results import given_tables, tables
from graphkin.sheet.text_blocks import LINE, broken
from graphkin.sheet.titleblock import FOOT, tables_room
from graphkin.sheet.window import PLANES

_MANY, _WORST = 8.0, 80.0  # at a higher price a larger paper is tried; either way of one
_STRIP, _LOST = 8.0, 8.0  # so high a strip costs as much as a leader [mm]; the price of a label without a place


def mechanism_sheet(
    method: Method, plot: Plot, *, paper: str | None = None, lang: Lang = "en",
    only: Plane | Collection[Plane] | None = None, style: Style = "construction", upto: int | None = None,
    tight: bool = False, paths: Paths = NONE,
) -> Sheet:  # fmt: skip
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
        drawing = Planes(method, plot, ("position",), style, lang)
        contents = SheetContents(drawing, {}, [] if tight else given_tables(drawing.reading({})), tight)
        return replace(cheapest(contents, paper).lettered.sheet, given=True)
    method, plot = shown(method, plot)
    drawing = Planes(method, plot, _planes(only), style, lang, paths)
    contents = SheetContents(drawing, {} if tight else tables(method, plot, lang), tight=tight)
    return cheapest(contents, paper).lettered.sheet if upto is None else next(_staged(contents, paper, [upto]))


def mechanism_step_sheets(
    method: Method, plot: Plot, *, paper: str | None = None, lang: Lang = "en",
    only: Plane | Collection[Plane] | None = None, tight: bool = False,
) -> Iterator[Sheet]:  # fmt: skip
    """One sheet a step, as `mechanism_sheet(.., upto=step)` gives them."""
    method, plot = shown(method, plot)
    drawing = Planes(method, plot, _planes(only), "construction", lang)
    yield from _staged(SheetContents(drawing, {} if tight else tables(method, plot, lang), tight=tight), paper)


def _planes(only: Plane | Collection[Plane] | None) -> tuple[Plane, ...]:
    planes = PLANES if only is None else (only,) if isinstance(only, str) else only
    return tuple(plane for plane in PLANES if plane in planes)


def scales_of(method: Method, plot: Plot, lang: Lang = "en") -> Mapping[Plane, float]:
    """The scales of the sheet."""
    contents = SheetContents(Planes(method, plot, PLANES, "construction", lang), tables(method, plot, lang))
    return cheapest(contents, None).layout.scales


# --- arrangements -----------------------------------------------------------------------------------------------------


@frozen
class Arrangement:
    """The contents of a sheet on one divided paper.

    papers  the smallest of these that holds all is taken
    cut     it is cut to its only figure
    """

    asked: SheetContents
    papers: Sequence[Paper]
    cut: bool = False

    @cached_property
    def laid_out(self) -> tuple[SheetContents, Layout]:
        """With blocks in the strip for which figures leave no room. Raises TooLargeForPaper."""
        try:
            contents, layout = self.asked.laid_out(self.papers)
        except TooLargeForPaper as error:
            raise error.at(self.asked.drawing.method.mechanism.where("scales", error.key)) from None
        only = contents.planes[0]
        return contents, cut_to(layout, only, contents.extents[only]) if self.cut else layout

    @property
    def contents(self) -> SheetContents:
        return self.laid_out[0]

    @property
    def layout(self) -> Layout:
        return self.laid_out[1]

    @property
    def sold(self) -> list[Paper]:
        """Its paper in the size in which it can be asked for."""
        return [PAPERS[self.layout.paper.name]]

    @cached_property
    def page(self) -> Page:
        return self.contents.page(self.layout)

    @cached_property
    def overfull(self) -> float:
        """The part of its room for letters that the labels of the fullest figure take; above 1 some cannot
        but lie on others, and no care helps."""
        rooms, extents = self.layout.rooms, self.contents.drawing.extents
        return max(extents[p].lettering / (CRAMMED * room.size.real * room.size.imag) for p, room in rooms.items())

    @cached_property
    def price(self) -> float:
        """Labels that find no place near by, the burden of the others, and what stands over the footer, off its figure:
        by this arrangements are compared. Of an overfull one all labels have no place."""
        if self.overfull > 1:
            return _LOST * sum(extent.labels for extent in self.contents.drawing.extents.values()) + self.overfull
        near, above = self.page.lettered(far=False), self.layout.strip.size.imag - FOOT
        return _LOST * near.lost + near.burden + max(0.0, above) / _STRIP

    @property
    def knotted(self) -> list[Plane]:
        """Planes whose labels would be worth a detail."""
        panels = zip(self.contents.planes, self.page.panels, strict=True) if self.overfull <= 1 else ()
        return [plane for plane, panel in panels if plane != "position" and burden(panel.burdens) >= SAVED]

    @cached_property
    def lettered(self) -> Lettered:
        """Its labels as well as can be: some are left out where others find no good place."""
        lettered = self.page.lettered(far=True)
        return lettered.trimmed if self.contents.tight else lettered


def cheapest(contents: SheetContents, paper: str | None) -> Arrangement:
    """The cheapest arrangement on the paper, or on one that is large enough; cut to a single figure."""
    usual = papers_for(paper)
    best = _on(Arrangement(contents, usual))
    for least, papers in ((_MANY, usual[2:]), (_WORST, usual[2:3]), (_WORST, usual[3:])):
        if best.price > least and papers and papers != best.sold:
            best = min(best, _on(replace(best, papers=papers)), key=lambda each: each.price)
    cut = len(contents.planes) == 1 and (contents.tight or paper is None)
    return replace(best, cut=True) if cut else best


def _on(first: Arrangement) -> Arrangement:
    """The cheaper on the papers of an arrangement, as it is or with details."""
    knots = [] if first.asked.detailed else first.knotted
    other = replace(first, asked=replace(first.asked, detailed=knots)) if knots else first
    return min(first, other, key=lambda each: each.price)


# --- single steps -----------------------------------------------------------------------------------------------------


def _staged(contents: SheetContents, paper: str | None, numbers: Sequence[int] = ()) -> Iterator[Sheet]:
    """The drawing as far as each act, or as some: the pencil's own lines are there too, and a sentence for results."""
    best, pitch = cheapest(contents, paper), LINE * LABEL
    lines, stage = _spoken(best), replace(best, asked=replace(best.contents, stages=True))
    area = best.sold[0].area
    same = [each for each in papers_for(paper) if each.area == area]
    for scales in () if contents.tight else (best.layout.scales, {}):  # those of the whole sheet, where there is room
        said = pitch * max(map(len, lines.values()))  # the sentences stand over the footer
        asked = replace(stage.asked, said=said, scales=scales, tables={})
        with suppress(TooLargeForPaper):
            stage = replace(stage, asked=asked, papers=same)
            lines = _spoken(stage)
            break
    strip, whole = stage.layout.strip, stage.lettered.sheet
    for act in [[*lines][number - 1] for number in numbers] or lines:
        sheet = whole.upto(act.page)
        if not contents.tight:
            below, *above = sheet.layers
            at = [complex(strip.left + 3, strip.top + 1 + pitch * (k + 0.8)) for k in range(len(lines[act]))]
            marks = [Text(line, place, LABEL) for line, place in zip(lines[act], at, strict=True)]
            larger = [enlarged(mark, stage.layout.paper.times) for mark in marks]
            sheet = replace(sheet, layers=(replace(below, marks=(*below.marks, *larger)), *above))
        yield sheet


def _spoken(stage: Arrangement) -> dict[Act, list[Label]]:
    """The lines of each act's sentence, at the scales that are drawn. Raises TooLargeForPaper."""
    drawing, planes = stage.contents.drawing, stage.contents.planes
    others = {} if planes == PLANES else scales_of(drawing.method, drawing.plot, drawing.lang)
    reading = drawing.reading({**others, **stage.layout.scales})
    entries = derivation(reading.method, reading.plot, reading.scales, reading.lang, as_planned=True)
    texts = {entry.act: entry.text for entry in entries if isinstance(entry, Sentence) and entry.act is not None}
    acts = [act for act in drawing.method.acts if act.plane in planes]
    lines = dict[Act, list[Label]]()
    for number, act in enumerate(acts, 1):
        head = plain(say("sheet.step", drawing.lang, number=number, count=len(acts)))
        sign = f"{circled(act.number)} " if act.numbered else ""
        wide = tables_room(stage.layout.paper)
        lines[act] = [head, *map(formula, broken(sign + texts.get(act, ""), wide, LABEL))]
    return lines
