"""Positions side by side on one sheet: the mechanism again and again, at one scale, each with its caption.

Every figure has a cell of its own, and the fixed points stand at the same place in each cell, so that what has
moved is seen. Points are plain marks here: a sheet of several positions is looked at, not measured.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

from graphkin.base.value import frozen
from graphkin.construction import Plot
from graphkin.errors import Lang
from graphkin.planning import Method
from graphkin.sheet.layout import divided, papers_for
from graphkin.sheet.mechanism_figure import plain_mechanism, shown_places
from graphkin.sheet.page import Page, Sheet
from graphkin.sheet.paper import BODY, Paper, Room
from graphkin.sheet.single_figure import Caption, Picture
from graphkin.sheet.slowest_point import marked, near
from graphkin.sheet.titleblock import Strip, strip_height
from graphkin.sheet.window import Extent, Figure, Window
from graphkin.studies.finding.answers import SlowPoint

MOST = 12
"""Positions on one sheet, at most."""
_TRIAL = 60.0
"""Size of a figure when it is drawn to see how far its signs reach [mm]."""
_LETTERS = 6.0
"""What labels need around a figure [mm]."""
_FOOT = 11.0
"""Room for a caption of two lines under each figure [mm]."""
_LARGE_ENOUGH = 48.0
"""A figure of this size needs no larger paper [mm]."""


def side_by_side(
    method: Method, plots: Sequence[Plot], captions: Sequence[str], lang: Lang = "en", *, paper: str | None = None,
    told: Sequence[str] = (), slow: Sequence[SlowPoint | None] = (),
) -> Sheet:  # fmt: skip
    """The mechanism at several positions (at most `MOST`), lettered (a), (b), .. with captions.

    plots   the method replayed at one position each
    paper   a key of `PAPERS`; the smallest on which the figures are large enough where left out
    told    sentences in the strip
    slow    the point to mark in each figure, where there is one

    Raises UnknownPaper.
    """
    if not 0 < len(plots) <= MOST or len(captions) != len(plots):
        raise ValueError(f"1 to {MOST} positions, each with a caption; given: {len(plots)}, {len(captions)}")
    pictures = _pictures(method, plots, captions, slow or [None] * len(plots))
    grid = _grid(pictures, papers_for(paper), told)
    panels = [picture.panel(cell, grid.scale) for picture, cell in zip(pictures, grid.cells)]
    return Page(grid.paper, panels, method.mechanism, plots[0].facts.values, lang, Strip(grid.strip, told=told)).sheet()


def _pictures(
    method: Method, plots: Sequence[Plot], captions: Sequence[str], slow: Sequence[SlowPoint | None]
) -> list[Picture]:  # fmt: skip
    """All as large as all figures laid over one another."""
    figures = [partial(_figure, method, plot, point) for plot, point in zip(plots, slow, strict=True)]
    places = [place for plot, point in zip(plots, slow, strict=True) for place in _places(method, plot, point)]

    def over(window: Window) -> Figure:
        return sum((figure(window) for figure in figures), Figure())

    extent = Extent.of(places, over, method.mechanism.scales.get("length"), letters=_LETTERS, trial=_TRIAL)
    lettered = (f"({chr(ord('a') + number)}) {caption}" for number, caption in enumerate(captions))
    shown = [Caption((text,), _FOOT, first=4.5, pitch=1.3 * BODY, sides=2.0) for text in lettered]
    return [Picture(extent, figure, caption) for figure, caption in zip(figures, shown)]


def _places(method: Method, plot: Plot, slow: SlowPoint | None) -> list[complex]:
    """What a figure shows [m]."""
    shown = shown_places(method, plot)
    return shown + near(slow, shown) if slow is not None else shown


def _figure(method: Method, plot: Plot, slow: SlowPoint | None, window: Window) -> Figure:
    """The mechanism, and the point that is marked."""
    figure = plain_mechanism(method, plot, window)
    if slow is None or not near(slow, shown_places(method, plot)):
        return figure
    first, second = (complex(plot.position[name]) for name in slow.points)
    return figure + marked(slow, (first, second), window)


# --- how large --------------------------------------------------------------------------------


@frozen
class _Grid:
    """A paper divided into equal cells."""

    paper: Paper
    cells: list[Room]
    strip: Room
    scale: float


def _grid(pictures: Sequence[Picture], papers: Sequence[Paper], told: Sequence[str]) -> _Grid:
    """The smallest paper with figures large enough, else the one with the largest."""
    best: _Grid | None = None
    for area in sorted({paper.width * paper.height for paper in papers}):
        same = [paper for paper in papers if paper.width * paper.height == area]
        grids = [grid for paper in same for grid in _grids(pictures, paper, told)]
        best = min([*grids, *([best] if best else [])], key=lambda grid: grid.scale)
        if pictures[0].extent.longest / best.scale >= _LARGE_ENOUGH:
            return best
    assert best is not None
    return best


def _grids(pictures: Sequence[Picture], paper: Paper, told: Sequence[str]) -> Iterator[_Grid]:
    """Every number of columns."""
    field, foot = divided(paper, strip_height(paper, told=told))
    for columns in range(1, len(pictures) + 1):
        cells = field.cells(len(pictures), columns)
        yield _Grid(paper, cells, foot, pictures[0].scale(cells[0]))
