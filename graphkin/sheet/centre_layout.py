"""Which paper, at which scale, and where the figure, the circle diagram and the table stand on it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import cached_property, partial

from graphkin.base.value import frozen
from graphkin.errors import Lang
from graphkin.sheet.centre_circle import circle_size
from graphkin.sheet.centre_figure import bare_mechanism
from graphkin.sheet.centre_places import spots
from graphkin.sheet.centre_table import CentreTable, centre_table
from graphkin.sheet.layout import HEAD, divided, papers_for
from graphkin.sheet.mechanism_figure import mechanism_places
from graphkin.sheet.paper import Paper, Room
from graphkin.sheet.titleblock import strip_height
from graphkin.sheet.window import Extent, Window, corners
from graphkin.studies.centres import Centres

_TRIAL = 80.0
"""Size of the mechanism when it is drawn to see how far its signs reach [mm]."""
_LETTERS = 7.0
"""What labels and arrows need around the figure [mm]."""
_LARGE_ENOUGH = 14.0
"""The mechanism is to be so large, times the root of how many centres there are, which want letters in it [mm]."""
_SHOWN, _LARGER_PAPER = 16, 30
"""What a centre on the sheet is worth, and what a larger paper costs, which fewer printers have."""
_NEAR = (2.0, 1.3, 0.9, 0.6, 0.3, 0.0)
"""Centres so many times the mechanism's size away are looked for room for."""
_FIT = 20.0
"""The same, where all centres are to be on the sheet."""
_TITLE, _BAR = 70.0, 10.0
"""Width of the title block; height of the check bar under the table [mm]."""


@frozen
class CentreExtent:
    """What does not depend on the paper: places, and how far signs reach beyond them."""

    found: Centres

    @cached_property
    def places(self) -> list[complex]:
        return mechanism_places(self.found.method, self.found.plot)

    @cached_property
    def extent(self) -> Extent:
        """Of the mechanism alone."""
        given = self.found.method.mechanism.scales.get("length")
        return Extent.of(self.places, partial(bare_mechanism, self.found), given, letters=_LETTERS, trial=_TRIAL)

    @property
    def longest(self) -> float:
        """The mechanism's larger side [m]."""
        return self.extent.longest or 1.0

    @cached_property
    def finite(self) -> list[complex]:
        """Centres that are not at infinity, the nearest first [m]."""
        places = [spot.place for spot in spots(self.found) if spot.place is not None]
        return sorted(places, key=lambda place: (self.off(place), place.real, place.imag))

    def off(self, place: complex) -> float:
        """How far outside the mechanism a place lies, in its larger sides."""
        low, high = self.extent.low, self.extent.high
        x = max(low.real - place.real, place.real - high.real, 0.0)
        y = max(low.imag - place.imag, place.imag - high.imag, 0.0)
        return max(x, y) / self.longest

    def box(self, places: Iterable[complex]) -> Extent:
        """What holds the mechanism and more places."""
        low, high = corners([*self.places, *places])
        return replace(self.extent, low=low, high=high)


@frozen
class CentreLayout:
    """A paper divided, the window through which the figure is seen.

    shown  how many centres lie in its room
    large  how large the mechanism is, and how large it is to be [mm]
    """

    paper: Paper
    field: Room
    circle: Room
    strip: Room
    table: CentreTable
    window: Window
    shown: int
    large: float
    wanted: float

    @property
    def worth(self) -> float:
        """Centres on the sheet count, and that the mechanism is not small; larger paper only where it helps."""
        small = max(0.0, self.wanted - self.large)
        costs = 3 * small + _LARGER_PAPER * (self.paper.width * self.paper.height > 80_000) + 40 * self.table.lost
        return _SHOWN * self.shown + min(self.large, 100) / 8 - costs


def layouts(found: Centres, paper: str | None, lang: Lang, fit: bool) -> list[CentreLayout]:
    """Every way to lay the sheet out, the best first."""
    measures = CentreExtent(found)
    every = [way for one in papers_for(paper) for way in _on(measures, one, lang, fit)]
    return sorted(every, key=lambda way: -way.worth)


def _on(measures: CentreExtent, paper: Paper, lang: Lang, fit: bool) -> Iterator[CentreLayout]:
    """On one paper, with more or less room for centres outside the mechanism."""
    field, circle, strip, table = _divided(measures.found, paper, lang)
    room = field.inset(0, HEAD, 0)
    inner = room.size - measures.extent.reach
    if min(inner.real, inner.imag) < 15:
        return
    around, wanted = (_FIT,) if fit else _NEAR, _LARGE_ENOUGH * len(measures.found.centring.stages) ** 0.5
    boxes = (measures.box(place for place in measures.finite if measures.off(place) <= near) for near in around)
    for scale in sorted({_scale(measures, box, room, fit) for box in boxes}):
        shown = _held(measures, inner * scale)
        window = measures.box(shown).window(room, scale)
        yield CentreLayout(paper, field, circle, strip, table, window, len(shown), measures.longest / scale, wanted)


def _scale(measures: CentreExtent, box: Extent, room: Room, fit: bool) -> float:
    """The finest at which all fits; the file's own, where the mechanism (to fit: all of it) fits at that."""
    given = measures.extent.given
    kept = given is not None and (box if fit else measures.extent).fits(given, room)
    return given if given is not None and kept else box.finest(room)


def _held(measures: CentreExtent, room: complex) -> list[complex]:
    """As many centres as a room holds beside the mechanism [m], the nearest first."""
    held: list[complex] = []
    for place in measures.finite:
        size = measures.box([*held, place]).size
        if size.real <= room.real * (1 + 1e-9) and size.imag <= room.imag * (1 + 1e-9):
            held.append(place)
    return held


def _divided(found: Centres, paper: Paper, lang: Lang) -> tuple[Room, Room, Room, CentreTable]:
    """Strip at the foot; the circle diagram at the right, or under the figure on upright paper."""
    whole = paper.frame
    table = centre_table(found, lang, whole.size.real - _TITLE, 0.4 * paper.height)
    field, strip = divided(paper, max(strip_height(paper), table.height + 1 + _BAR))
    if paper.landscape:
        edge = field.right - circle_size(found).real
        return replace(field, right=edge), replace(field, left=edge), strip, table
    edge = field.bottom - circle_size(found).imag
    return replace(field, bottom=edge), replace(field, top=edge), strip, table
