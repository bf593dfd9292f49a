"""One figure alone on its page: a mechanism with more around it, under a heading."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial

from graphkin.base.value import frozen
from graphkin.construction import Plane, Plot
from graphkin.errors import Lang
from graphkin.planning import Method
from graphkin.sheet.fit import Extent
from graphkin.sheet.layout import HEAD, Layout, alone
from graphkin.sheet.marks import Mark
from graphkin.sheet.page import Page, Panel, Sheet, heading
from graphkin.sheet.paper import Room
from graphkin.sheet.plain_mechanism import plain_mechanism
from graphkin.sheet.table import Table
from graphkin.sheet.titleblock import Strip, strip_height
from graphkin.sheet.window import Figure, Window

_LABELS = 20
"""How much lettering the choice between upright paper and paper on its side reckons with."""


@frozen
class Alone:
    """Where the figure stands: its room [mm], and through which window from SI to paper.

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
        self, plot: Plot, words: str, figure: Figure, lang: Lang, further: Mapping[Plane, float] | None = None,
        after: Sequence[Mark] = (),
    ) -> Sheet:  # fmt: skip
        """The sheet; words: the heading, further: scales to be told beside the figure's own, after: over all else."""
        head = heading(words, "position", self.window.scale, self.layout.rooms["position"])
        panel = Panel(figure, self.window, self.room, before=head, after=tuple(after))
        foot = Strip(self.layout.strip, self.found, further=further or {}, told=self.told)
        return Page(self.layout.paper, [panel], self.method.mechanism, plot.facts.values, lang, foot).sheet()


def place_for(
    method: Method, plots: Sequence[Plot], places: Sequence[complex], paper: str | None,
    found: Sequence[Table] = (), told: Sequence[str] = (),
) -> Alone:  # fmt: skip
    """On the smallest paper where these places [m] fit; a given scale that is too fine is not kept.

    plots  at which the mechanism is to be drawn; found, told: tables and sentences for the strip.
    Raises UnknownPaper.
    """

    def drawn(window: Window) -> Figure:
        return sum((plain_mechanism(method, plot, window) for plot in plots), Figure())

    extent = replace(Extent.of(places, drawn), given=method.mechanism.scales.get("length"), labels=_LABELS)
    layout = alone(extent, partial(strip_height, found=found, told=told), paper)
    return Alone(method, layout, layout.window("position", extent), found, told)
