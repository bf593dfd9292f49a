"""Sheets of single figures: a mechanism under a heading with more around it, or figures in cells over captions."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from math import log
from typing import SupportsFloat

from graphkin.base.value import frozen
from graphkin.construction import Plane, Plot
from graphkin.errors import Lang
from graphkin.model.mechanism import Mechanism
from graphkin.planning import Method
from graphkin.say.dimensions import sizes
from graphkin.say.reading import Reading
from graphkin.sheet.dimension_lines import angles
from graphkin.sheet.drafting_figure import together
from graphkin.sheet.layout import HEAD, Layout, alone, divided
from graphkin.sheet.lettering import LABEL, formula, width
from graphkin.sheet.marks import Mark, Text
from graphkin.sheet.mechanism_figure import bare_figure, mechanism_places, plain_mechanism, plainly
from graphkin.sheet.mechanism_notes import MechanismNotes
from graphkin.sheet.page import Page, Panel, Sheet, heading
from graphkin.sheet.paper import Paper, Room
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.text_blocks import broken
from graphkin.sheet.titleblock import Strip, Table, strip_height
from graphkin.sheet.window import Extent, Figure, Window

_LABELS = 20  # the number of labels by which upright paper or paper on its side is chosen


@frozen
class SingleFigure:
    """A figure alone on its page: its room [mm], and its window from SI to paper.

    found, told  tables and sentences of its strip
    """

    method: Method
    layout: Layout
    window: Window
    found: Sequence[Table] = ()
    told: Sequence[str] = ()

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
        foot = Strip(self.layout.strip, self.found, further=further or {}, told=self.told)
        return Page(self.layout.paper, [panel], self.method.mechanism, plot.facts.values, lang, foot).sheet()


def place_for(
    method: Method, plots: Sequence[Plot], places: Sequence[complex], paper: str | None,
    found: Sequence[Table] = (), told: Sequence[str] = (),
) -> SingleFigure:  # fmt: skip
    """On the smallest paper where these places [m] fit; a given scale that is too fine is not kept.

    plots  at which the mechanism is to be drawn; found, told: tables and sentences for the strip.
    Raises UnknownPaper.
    """

    def drawn(window: Window) -> Figure:
        return sum((plain_mechanism(method, plot, window) for plot in plots), Figure())

    extent = replace(Extent.of(places, drawn), given=method.mechanism.scales.get("length"), labels=_LABELS)
    layout = alone(extent, partial(strip_height, found=found, told=told), paper)
    return SingleFigure(method, layout, layout.window("position", extent), found, told)




def problem_picture(method: Method, plot: Plot, size: complex, lang: Lang) -> Sheet:
    """The figure of a problem: the mechanism with its letters, and nothing that is found, on a paper no larger than
    this [mm] with nothing around it."""
    reading = Reading(method, plot, {}, lang)
    extent = Extent.of(mechanism_places(method, plot), partial(_given, reading))
    scale = extent.finest(Room(0, 0, size.real, size.imag))
    whole = extent.size / scale + extent.reach
    room = Room(0, 0, whole.real, whole.imag)
    window = extent.window(room, scale)
    notes = MechanismNotes(Skeleton(method.mechanism, plot, window, {}), reading, sizes(reading))
    panel = Panel(_given(reading, window), window, room, more=notes)
    paper = Paper("figure", room.right, room.bottom, 0.0)
    return Page(paper, [panel], method.mechanism, plot.facts.values, lang).sheet()


def _given(reading: Reading, window: Window) -> Figure:
    skeleton = Skeleton(reading.mechanism, reading.plot, window, {})
    bare = bare_figure(reading.method, skeleton)
    bare = angles(sizes(reading), skeleton, bare.marks) + bare
    return Figure([plainly(mark) for mark in bare.marks], bare.wanted)


# --- one grid for sheets of several figures ---------------------------------------------------------------------------


@frozen
class SheetGrid:
    """A paper divided: the field for figures, and the strip under it."""

    paper: Paper
    field: Room
    strip: Strip

    @classmethod
    def over(
        cls, paper: Paper, tables: Sequence[Table] = (), told: Sequence[str] = (), least: float = 0.0
    ) -> SheetGrid:
        """Over a strip as high as its tables and sentences need; least: at least so high [mm]."""
        field, foot = divided(paper, strip_height(paper, tables, told=told, least=least))
        return cls(paper, field, Strip(foot, tables, told=told))

    def page(
        self, panels: Iterable[Panel], machine: Mechanism, lang: Lang, *, base: Sequence[Mark] = (), title: str = "",
        drivers: Sequence[SupportsFloat] | None = None,
    ) -> Page:  # fmt: skip
        """The page with these panels; drivers: their values, the file's where left out."""
        values = [driver.value or 0.0 for driver in machine.drivers] if drivers is None else drivers
        return Page(self.paper, [*panels], machine, values, lang, self.strip, base, title)


SCALE = "(1: )"
"""Stands in a caption for the scale of its figure."""
_PITCH, _SIDES, _FOOT = 1.35 * LABEL, 3.0, 4.5
"""From line to line of captions; what stays free beside them, and at their top and foot together [mm]."""


@frozen
class Picture:
    """A figure that wants a cell: its extent, its drawing through a window, and sentences in the middle under it."""

    extent: Extent
    draw: Callable[[Window], Figure]
    texts: Sequence[str] = ()

    def lines(self, wide: float) -> list[str]:
        """Its caption in a cell of that width [mm]."""
        return [line for text in self.texts for line in broken(text, wide - 2 * _SIDES, LABEL)]

    def panel(self, cell: Room, foot: float, scale: float) -> Panel:
        """On paper, its caption in the foot of its cell."""
        window = self.extent.window(cell.inset(0, 0, foot), scale)
        return Panel(self.draw(window), window, cell.inset(1, 1, foot), after=tuple(self.caption(cell, foot, scale)))

    def caption(self, cell: Room, foot: float, scale: float = 1.0) -> Iterator[Text]:
        for k, line in enumerate(self.lines(cell.size.real), start=1):
            label = formula(line.replace(SCALE, f"(1:{scale * 1e3:g})"))
            corner = complex(cell.middle.real - width(label, LABEL) / 2, cell.bottom - foot + k * _PITCH)
            yield Text(label, corner, LABEL)


def foot_of(pictures: Iterable[Picture], wide: float) -> float:
    """The height of captions in cells of that width [mm]."""
    return _FOOT + _PITCH * max(len(picture.lines(wide)) for picture in pictures)


def gridded(
    groups: Sequence[Sequence[Picture]], paper: Paper, tables: Sequence[Table] = (), told: Sequence[str] = (),
    head: float = 0.0,
) -> tuple[float, SheetGrid, Iterator[Panel]]:  # fmt: skip
    """Pictures in equal cells, each group at one scale, in as many columns as make them largest; the coarsest of the
    scales [m/mm].

    head  room over them [mm]
    """
    grid, tried = SheetGrid.over(paper, tables, told), list[tuple[float, float, list[Room], list[float]]]()
    every = [(picture, number) for number, group in enumerate(groups) for picture in group]
    for columns in range(1, len(every) + 1):
        cells = grid.field.inset(0, head, 0).cells(len(every), columns)
        foot = foot_of((picture for picture, _ in every), cells[0].size.real)
        free = cells[0].inset(0, 0, foot)
        scales = [max(picture.extent.scale(free) for picture in group) for group in groups]
        tried.append((sum(map(log, scales)), foot, cells, scales))
    _, foot, cells, scales = min(tried, key=lambda one: one[0])
    each = zip(every, cells, strict=True)
    return max(scales), grid, (picture.panel(cell, foot, scales[number]) for (picture, number), cell in each)
