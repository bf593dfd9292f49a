"""The one page: figures in their rooms, over a strip with results and title, lettered and handed on as a `Sheet`.

    figures through windows --> Panels, lettered one by one --> Page --sheet--> Sheet --step_sheets--> Sheets

Here alone labels are settled, sheets made, and sheets of single steps taken from a whole one. What a sheet shows is
the business of the `.._sheet` files: each says which figures it has and what goes into its strip.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from math import ceil
from typing import Literal, Protocol, SupportsFloat

import numpy as np

from graphkin.base.geometry import Array
from graphkin.base.rooms import Room
from graphkin.base.value import bulky, frozen
from graphkin.construction import Plane
from graphkin.errors import Lang
from graphkin.model.mechanism import Mechanism
from graphkin.sheet.free_room import FreeRoom
from graphkin.sheet.label_candidates import LabelScene
from graphkin.sheet.label_requests import tangled
from graphkin.sheet.labels import Settled, settle
from graphkin.sheet.lettering import LABEL, formula, width
from graphkin.sheet.marks import Mark, Place, Stroke, Text, enlarged
from graphkin.sheet.obstacles import bounds
from graphkin.sheet.paper import Paper, written
from graphkin.sheet.titleblock import Strip
from graphkin.sheet.window import Figure, Window

HEAD_WIDTH = 76.0  # a figure's heading with its scale beside it is no wider [mm]

_UNDER = ("construction", "measured")  # thin lines of a construction lie under the figure's
_EDGE = 3.0  # the margin about the figures of a trimmed page [mm]
LayerName = Literal["sheet", "mechanism", "velocity", "acceleration", "leaders", "labels"]


@bulky
class Layer:
    """Marks that a drawing program shows or hides as one; `plane`: whose colour they have."""

    name: LayerName
    marks: tuple[Mark, ...]
    plane: Plane | None = None


@bulky
class Sheet:
    """A finished drawing.

    layers   in the order of painting [mm, y down]
    scales   by plane [m/mm, (m/s)/mm, (m/s²)/mm]; origins: where each plane's origin lies on the paper
    drivers  their values at the drawn position [rad, m]
    given    it shows what is given, and nothing that would have to be found
    crowded  it shows more than its paper bears
    """

    paper: Paper
    layers: tuple[Layer, ...]
    scales: Mapping[Plane, float]
    origins: Mapping[Plane, Place]
    mechanism: Mechanism
    drivers: tuple[float, ...]
    title: str
    lang: Lang
    given: bool = False
    crowded: bool = False

    @property
    def marks(self) -> tuple[Mark, ...]:
        """Of all layers."""
        return tuple(mark for layer in self.layers for mark in layer.marks)

    def upto(self, step: int) -> Sheet:
        """The drawing after a step of the construction, whose own marks are new."""

        def as_of_step(mark: Mark) -> Mark | None:
            later = mark.step is not None and mark.step > step
            if isinstance(mark, Stroke) and mark.breaks:
                mark = replace(mark, breaks=tuple(each for each in mark.breaks if (each[1] or 0) <= step))
            return None if later else replace(mark, new=True) if mark.step == step else mark

        return self.redrawn(as_of_step)

    def redrawn(self, change: Callable[[Mark], Mark | None]) -> Sheet:
        """Every mark changed, or left out."""
        changed = [(layer, map(change, layer.marks)) for layer in self.layers]
        layers = (replace(layer, marks=tuple(mark for mark in marks if mark is not None)) for layer, marks in changed)
        return replace(self, layers=tuple(layers))


def step_sheets(whole: Sheet, steps: Iterable[int] = ()) -> Iterator[Sheet]:
    """One sheet a step, what it adds emphasised, lettered only once; steps left out: all that draw something."""
    return (whole.upto(step) for step in steps or sorted({m.step for m in whole.marks if m.step is not None}))


class Last(Protocol):
    """Marks that are drawn last on a figure."""

    def lines(self) -> Iterator[Mark]:
        """Lines that labels should keep off, where that costs nothing."""

    def __call__(self, free: FreeRoom) -> list[Mark]:
        """As many as there is room for, among figure and labels."""


@frozen
class Panel:
    """A figure in its room.

    figure         on paper already, with the labels it wants; window: through which it is seen
    room           where its labels may stand [mm]
    before         what is painted before it: its heading, its caption
    beside         what stands with it, and the rooms that this takes up, which labels keep off
    more           what is drawn last, where figure and labels have left room; labels keep off its lines if they can
    plane          whose origin and scale the sheet tells; None for a figure whose scale it does not
    magnified      centre and radius of the parts that are drawn once more in details [SI]
    """

    figure: Figure
    window: Window
    room: Room
    before: tuple[Mark, ...] = ()
    plane: Plane | None = "position"
    more: Last | None = None
    beside: tuple[tuple[Room, tuple[Mark, ...]], ...] = ()
    magnified: tuple[tuple[complex, float], ...] = ()

    @property
    def drawn(self) -> list[Mark]:
        """Everything but the labels, which keep off it."""
        return [*self.before, *(mark for _, marks in self.beside for mark in marks), *self.figure.marks]

    @cached_property
    def scene(self) -> LabelScene:
        """Labels that want a place, and all that they keep off."""
        giving_way = [*self.more.lines()] if self.more is not None else ()
        return LabelScene(self.figure.wanted, [*self.before, *self.figure.marks], self.room, giving_way, self.beside)

    @cached_property
    def near(self) -> Settled:
        """Its labels near what they name."""
        return self._settled()

    @cached_property
    def far(self) -> Settled:
        """Its labels in a crowd, where some find no good place otherwise, and some are left out."""
        crowd = self.scene.crammed or self.near.clashing or self.near.unclear
        return self._settled(self.near) if crowd else self.near

    def _settled(self, near: Settled | None = None) -> Settled:
        return settle(self.scene, near)

    @cached_property
    def lettering(self) -> list[Mark]:
        """Its labels, and what is drawn last where they have left room, or make way."""
        free = FreeRoom(self.scene, self.far.marks)
        last = self.more(free) if self.more else ()
        return [*(mark for mark in self.far.marks if mark not in free.gone), *last]

    @cached_property
    def burdens(self) -> Array:
        """The burden of each label on the eye; twice that of a leader, where all are crammed."""
        wanted = self.figure.wanted
        if self.scene.crammed or not wanted:
            return np.full(len(wanted), 2.0)
        return self.near.burdens(wanted) + tangled(wanted)


@frozen
class Page:
    """All that one paper holds, without labels; strip: what stands at its foot, a page without one has no frame either;
    drivers, title: those of the file where left out [rad, m]."""

    paper: Paper
    panels: Sequence[Panel]
    mechanism: Mechanism
    drivers: Sequence[SupportsFloat] | None
    lang: Lang
    strip: Strip | None = None
    title: str = ""

    @property
    def windows(self) -> Mapping[Plane, Window]:
        """The window of each plane; the first, where several figures show it."""
        shown = dict.fromkeys(panel.plane for panel in self.panels if panel.plane is not None)
        return {plane: next(panel.window for panel in self.panels if panel.plane == plane) for plane in shown}

    @property
    def scales(self) -> Mapping[Plane, float]:
        return {plane: window.printed for plane, window in self.windows.items()}

    @property
    def trimmed(self) -> Page:
        """On a paper that ends where the figures do."""
        paper = self.paper
        _, _, right, bottom = bounds(mark for panel in self.panels for mark in (*panel.drawn, *panel.lettering))
        wide, high = ceil(right + _EDGE), min(paper.height, ceil(bottom + _EDGE))  # an arc may reach beyond its room
        return replace(self, paper=replace(paper, width=float(wide), height=float(high)))

    def sheet(self) -> Sheet:
        """Lettered."""
        times = self.paper.times
        values = [driver.value or 0.0 for driver in self.mechanism.drivers] if self.drivers is None else self.drivers
        sheet = Sheet(
            self.paper.enlarged, tuple(self._layers()), self.scales,
            {plane: times * window.origin for plane, window in self.windows.items()}, self.mechanism,
            tuple(map(float, values)), self.title or self.mechanism.headline(self.lang), self.lang,
        )  # fmt: skip
        return sheet if times == 1 else sheet.redrawn(lambda mark: enlarged(mark, times))

    def _layers(self) -> Iterator[Layer]:
        """The sheet under the figures, each plane's figure, and over all of them the leaders and the letters."""
        foot: list[Mark] = []
        if self.strip is not None:  # title, results, and the scales that are not over their figures
            texts = {mark.label for panel in self.panels for mark in panel.before if isinstance(mark, Text)}
            scales = {plane: scale for plane, scale in self.scales.items() if written(plane, scale) not in texts}
            foot += self.strip.marks(self.mechanism, self.paper, scales, self.lang)
        yield Layer("sheet", tuple(foot))
        drawn: dict[Plane, list[Mark]] = {}
        over: list[Stroke | Text] = []
        for panel in self.panels:
            figure = drawn.setdefault(panel.plane or "position", [])
            figure += [mark for mark in panel.lettering if isinstance(mark, Stroke) and mark.pen in _UNDER]
            figure += panel.drawn
            for mark in panel.lettering:
                if isinstance(mark, Text) or (isinstance(mark, Stroke) and mark.pen == "leader"):
                    over.append(replace(mark, accent=mark.accent or panel.plane))
                elif not (isinstance(mark, Stroke) and mark.pen in _UNDER):
                    figure.append(mark)
        for plane, marks in drawn.items():
            yield Layer("mechanism" if plane == "position" else plane, tuple(marks), plane)
        yield Layer("leaders", tuple(mark for mark in over if isinstance(mark, Stroke)))
        yield Layer("labels", tuple(mark for mark in over if isinstance(mark, Text)))


def heading(text: str, plane: Plane, scale: float, room: Room) -> tuple[Mark, ...]:
    """The name of a figure and its scale, in the upper left corner of its room; one under the other in a narrow one."""
    label, at = formula(text), complex(room.left + 3, room.top + 5.5)
    beside = width(label, LABEL) + 4 if room.size.real >= HEAD_WIDTH else 5.5j
    return Text(label, at, LABEL), Text(written(plane, scale), at + beside, LABEL)
