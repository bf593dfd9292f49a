"""Sheets of single figures: a mechanism under a heading with more around it, or figures in cells over captions."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from math import log

from graphkin.base.rooms import Room
from graphkin.base.scales import finer
from graphkin.base.value import frozen
from graphkin.construction import Plane, Plot
from graphkin.errors import Lang
from graphkin.planning import Method
from graphkin.sheet.composition import Planes
from graphkin.sheet.drafting_figure import together
from graphkin.sheet.layout import HEAD, Layout, lay_out
from graphkin.sheet.lettering import LABEL, Label, formula, width
from graphkin.sheet.marks import Text
from graphkin.sheet.mechanism_figure import plain_mechanism, plainly
from graphkin.sheet.page import Page, Panel, Sheet, heading
from graphkin.sheet.paper import Paper, papers_for, written
from graphkin.sheet.text_blocks import broken
from graphkin.sheet.titleblock import Strip
from graphkin.sheet.window import Extent, Figure, Window

_LABELS = 20  # the number of labels by which upright paper or paper on its side is chosen


@frozen
class SingleFigure:
    """A figure alone on its page: its room [mm], and its window from SI to paper."""

    method: Method
    layout: Layout
    window: Window
    strip: Strip

    @property
    def room(self) -> Room:
        return self.layout.rooms["position"].inset(1, HEAD, 1)

    def mechanism(self, plot: Plot) -> Figure:
        """In no step of any construction."""
        return plain_mechanism(self.method, plot, self.window).numbered(None)

    def sheet(
        self, plot: Plot, words: str, figure: Figure, lang: Lang, further: Mapping[Plane, float] | None = None
    ) -> Sheet:
        """The sheet; words: the heading, further: scales to be told beside the figure's own."""
        head = heading(words, "position", self.window.printed, self.layout.rooms["position"])
        figure = Figure(figure.marks, [*together(figure.wanted)])
        panel = Panel(figure, self.window, self.room, before=head)
        strip = replace(self.strip, further=further or {})
        return Page(self.layout.paper, [panel], self.method.mechanism, plot.facts.values, lang, strip).sheet()


def place_for(
    method: Method, plots: Sequence[Plot], places: Sequence[complex], paper: str | None, strip: Strip
) -> SingleFigure:
    """On the smallest paper where these places [m] fit; a given scale that is too fine is not kept; plots: at which the
    mechanism is to be drawn. Raises UnknownPaper."""

    def drawn(window: Window) -> Figure:
        return sum((plain_mechanism(method, plot, window) for plot in plots), Figure())

    extent = replace(Extent.of(places, drawn), given=method.mechanism.scales.get("length"), labels=_LABELS)
    layout = lay_out({"position": extent}, strip.height, papers_for(paper), freely=True)
    return SingleFigure(method, layout, layout.placed("position", extent)[0], strip)


def problem_picture(method: Method, plot: Plot, size: complex, lang: Lang) -> Sheet:
    """The figure of a problem, with letters and nothing that is found, on a paper of at most this size [mm]."""
    drawing = Planes(method, plot, ("position",), "given", lang)

    def draw(window: Window) -> Figure:
        return plainly(drawing.figure("position", window))

    extent = Extent.of(drawing.values("position"), draw)
    scale = extent.scale(Room(0, 0, size.real, size.imag))
    room = extent.cut_out(scale)
    window = extent.window(room, scale)
    panel = Panel(draw(window), window, room, more=drawing.last("position", window, {}, None))
    paper = Paper("figure", room.right, room.bottom, 0.0)
    sheet = Page(paper, [panel], method.mechanism, plot.facts.values, lang).sheet()
    return sheet.redrawn(lambda mark: replace(mark, step=None))


# --- one grid for sheets of several figures ---------------------------------------------------------------------------


SCALE = "μ_l"
"""A line of a caption that stands for the scale of its figure."""
_PITCH, _SIDES, _FOOT = 1.35 * LABEL, 3.0, 4.5
"""From line to line of captions; what stays free beside them, and at their top and foot together [mm]."""


@frozen
class Picture:
    """A figure that wants a cell: its extent, its drawing through a window, and sentences in the middle under it."""

    extent: Extent
    draw: Callable[[Window], Figure]
    texts: Sequence[str] = ()

    def lines(self, wide: float, scale: float = 1.0) -> list[Label]:
        """Its caption in a cell of that width [mm]."""
        lines = (line for text in self.texts for line in broken(text, wide - 2 * _SIDES, LABEL))
        return [written("position", scale) if line == SCALE else formula(line) for line in lines]

    def need(self, wide: float, foot: float, scale: float) -> complex:
        """The least cell at a scale for its figure and for its caption as it is in a cell of that width [mm]."""
        least = max((width(line, LABEL) for line in self.lines(wide, scale)), default=0.0) + 2 * _SIDES
        size = self.extent.cut_out(scale).size
        return complex(max(size.real, least), size.imag + foot)

    def panel(self, cell: Room, foot: float, scale: float) -> Panel:
        """On paper, its caption in the foot of its cell."""
        window = self.extent.window(cell.inset(0, 0, foot), scale)
        return Panel(self.draw(window), window, cell.inset(1, 1, foot), tuple(self.caption(cell, foot, scale)))

    def caption(self, cell: Room, foot: float, scale: float = 1.0) -> Iterator[Text]:
        for k, label in enumerate(self.lines(cell.size.real, scale), start=1):
            corner = complex(cell.middle.real - width(label, LABEL) / 2, cell.bottom - foot + k * _PITCH)
            yield Text(label, corner, LABEL)


def foot_of(pictures: Iterable[Picture], wide: float) -> float:
    """The height of captions in cells of that width [mm]."""
    return _FOOT + _PITCH * max(len(picture.lines(wide)) for picture in pictures)


def gridded(
    groups: Sequence[Sequence[Picture]], paper: Paper, strip: Strip, head: float = 0.0
) -> tuple[float, list[Panel]]:
    """Pictures in rows over a strip, each group at one scale, in as many columns as make them largest; and the coarsest
    of the scales [m/mm]; head: room over them [mm]."""
    field = paper.divided(strip.height(paper))[0].inset(0, head, 0)
    every = [(picture, number) for number, group in enumerate(groups) for picture in group]
    tried = list[tuple[float, float, list[Room], list[float]]]()
    for columns in range(1, len(every) + 1):
        equal = field.cells(len(every), columns)
        wide = equal[0].size.real
        foot = foot_of((picture for picture, _ in every), wide)
        scales = [max(one.extent.scale(equal[0].inset(0, 0, foot)) for one in group) for group in groups]
        rows, cells = [every[k : k + columns] for k in range(0, len(every), columns)], equal
        free = {k for k, group in enumerate(groups) if all(one.extent.given is None for one in group)}
        while free:  # of what others leave free the smallest figure is made larger, as long as one can be
            small = min(free, key=lambda k: max(one.extent.longest for one in groups[k]) / scales[k])
            more = [finer(scale) if k == small else scale for k, scale in enumerate(scales)]
            if found := field.shared([[one.need(wide, foot, more[of]) for one, of in row] for row in rows]):
                scales, cells = more, found
            else:
                free.remove(small)
        tried.append((sum(map(log, scales)), foot, cells, scales))
    _, foot, cells, scales = min(tried, key=lambda one: one[0])
    each = zip(every, cells, strict=True)
    return max(scales), [picture.panel(cell, foot, scales[number]) for (picture, number), cell in each]
