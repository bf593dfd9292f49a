"""Sheets of single figures: a mechanism under a heading with more around it, or figures in cells over captions."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import SupportsFloat

from graphkin.base.value import frozen
from graphkin.construction import Plane, Plot
from graphkin.errors import Lang
from graphkin.model.mechanism import Mechanism
from graphkin.planning import Method
from graphkin.say.dimensions import sizes
from graphkin.say.numbers import circled
from graphkin.say.reading import Reading
from graphkin.sheet.dimension_lines import angles
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.layout import HEAD, Layout, alone, divided
from graphkin.sheet.lettering import LABEL, formula, plain, width
from graphkin.sheet.marks import Mark, Stroke, Text
from graphkin.sheet.mechanism_figure import bare_figure, mechanism_places, plain_mechanism, plainly
from graphkin.sheet.mechanism_notes import MechanismNotes
from graphkin.sheet.page import Page, Panel, Sheet, heading
from graphkin.sheet.paper import Paper, Room
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.titleblock import Strip, Table, strip_height, two_lines
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


def stage_number(line: Stroke, count: int) -> LabelRequest:
    """The number of a sentence at what it says is drawn."""
    start, end = line.places[len(line.places) // 2 - 1 :][:2]
    return LabelRequest(plain(circled(count)), start, end, gap=0.5, size=LABEL, step=line.step)


@frozen
class Caption:
    """Lines in the middle under a figure.

    height  of the room for them; first: from its top to the first base line; pitch: from line to line
    sides   what stays free beside them [mm]
    """

    texts: tuple[str, ...]
    height: float
    first: float = 5.0
    pitch: float = 1.35 * LABEL
    sides: float = 3.0

    def drawn(self, cell: Room) -> Iterator[Text]:
        pen = cell.bottom - self.height + self.first
        for text in self.texts:
            for line in two_lines(text, LABEL, cell.size.real - 2 * self.sides):
                label = formula(line)
                yield Text(label, complex((cell.left + cell.right - width(label, LABEL)) / 2, pen), LABEL)
                pen += self.pitch


@frozen
class Picture:
    """A figure that wants a cell: its extent, its drawing through a window, its caption."""

    extent: Extent
    draw: Callable[[Window], Figure]
    caption: Caption

    def captioned(self, start: str) -> Picture:
        """With a word before its caption."""
        first, *others = self.caption.texts
        return replace(self, caption=replace(self.caption, texts=(start + first, *others)))

    def scale(self, cell: Room) -> float:
        """The scale at which it fits a cell over its caption [m/mm]."""
        return self.extent.scale(cell.inset(0, 0, self.caption.height))

    def panel(self, cell: Room, scale: float) -> Panel:
        """On paper."""
        window = self.extent.window(cell.inset(0, 0, self.caption.height), scale)
        room = cell.inset(1, 1, self.caption.height)
        return Panel(self.draw(window), window, room, after=tuple(self.caption.drawn(cell)))


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
    """A paper divided: the field for figures and, on a sheet with a title block, the strip under it."""

    paper: Paper
    field: Room
    strip: Strip | None = None

    @classmethod
    def over(
        cls, paper: Paper, tables: Sequence[Table] = (), told: Sequence[str] = (), least: float = 0.0
    ) -> SheetGrid:
        """Over a strip as high as its tables and sentences need; least: at least so high [mm]."""
        field, foot = divided(paper, strip_height(paper, tables, told=told, least=least))
        return cls(paper, field, Strip(foot, tables, told=told))

    def page(
        self, panels: Sequence[Panel], machine: Mechanism, lang: Lang, *, base: Sequence[Mark] = (), title: str = "",
        drivers: Sequence[SupportsFloat] | None = None,
    ) -> Page:  # fmt: skip
        """The page with these panels; drivers: their values, the file's where left out."""
        values = [driver.value or 0.0 for driver in machine.drivers] if drivers is None else drivers
        return Page(self.paper, panels, machine, values, lang, self.strip, base, title)


def panels_in(pictures: Sequence[Picture], cells: Sequence[Room], scale: float | None = None) -> Iterator[Panel]:
    """Each picture in its cell, at one scale [m/mm], or each at its own."""
    for picture, cell in zip(pictures, cells, strict=True):
        yield picture.panel(cell, picture.scale(cell) if scale is None else scale)
