"""Positions of a mechanism side by side on one sheet, at one scale, each with its caption: those that were found.

Every figure has a cell of its own, and the fixed points stand at the same place in each cell, so that what has
moved is seen. Points are plain marks here: a sheet of several positions is looked at, not measured.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from graphkin.base.geometry import place
from graphkin.construction import Plot
from graphkin.errors import Lang
from graphkin.planning import Method
from graphkin.running.other_positions import moved_to
from graphkin.say.finding import caption, lines
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import LABEL, Run
from graphkin.sheet.marks import Disc, Mark, Stroke
from graphkin.sheet.mechanism_figure import plain_mechanism, shown_places
from graphkin.sheet.page import Sheet
from graphkin.sheet.paper import Paper, Room, papers_for
from graphkin.sheet.single_figure import Caption, Picture, SheetGrid, panels_in
from graphkin.sheet.window import Extent, Figure, Window, corners
from graphkin.studies.finding import Findings
from graphkin.studies.finding.answers import SlowPoint

MOST = 12  # positions on one sheet, at most
_TRIAL = 60.0  # size of a figure when it is drawn to see how far its signs reach [mm]
_LETTERS = 6.0  # room for labels around a figure [mm]
_FOOT = 11.0  # room for a caption of two lines under each figure [mm]
_LARGE_ENOUGH = 48.0  # a figure of this size needs no larger paper [mm]
_DOT, _RING = 0.7, 1.7
"""The slowest point: a dot in a ring, which no point of a mechanism is [mm]."""
_FAR = 1.9  # so many times larger the figure may become for its sake


def drawn(
    method: Method, findings: Findings, lang: Lang = "en", *, paper: str | None = None
) -> tuple[Sheet, int] | None:
    """The sheet, and how many positions had no room on it; None where there is no position that can be drawn.

    Raises UnknownPaper; DeadPoint or NotReached for a position that can be told but not drawn.
    """
    positions = findings.shown or ((findings.nearest,) if findings.nearest is not None else ())
    if not positions:
        return None
    shown, slowest = positions[:MOST], {entry.position.t: entry for entry in findings.slow}
    plots = [moved_to(method, position.drivers) for position in shown]
    captions, slow = [caption(findings, one) for one in shown], [slowest.get(one.t) for one in shown]
    sheet = positions_sheet(method, plots, captions, lang, paper=paper, told=[*lines(findings, lang)], slow=slow)
    return sheet, len(positions) - len(shown)


def positions_sheet(
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
    scale, grid, cells = _grid(pictures, papers_for(paper), told)
    panels = [*panels_in(pictures, cells, scale)]
    return grid.page(panels, method.mechanism, lang, drivers=plots[0].facts.values).sheet()


def _pictures(
    method: Method, plots: Sequence[Plot], captions: Sequence[str], slow: Sequence[SlowPoint | None]
) -> list[Picture]:  # fmt: skip
    """All as large as all figures laid over one another."""
    figures = [partial(_figure, method, plot, plots, point) for plot, point in zip(plots, slow, strict=True)]
    places: list[complex] = []
    for plot, point in zip(plots, slow, strict=True):
        shown = shown_places(method, plot)
        places += shown + ([point.place] if point is not None and _is_near(point, shown) else [])

    def over(window: Window) -> Figure:
        return sum((figure(window) for figure in figures), Figure())

    extent = Extent.of(places, over, method.mechanism.scales.get("length"), letters=_LETTERS, trial=_TRIAL)
    texts = (f"({chr(ord('a') + number)}) {text}" for number, text in enumerate(captions))
    under = [Caption((text,), _FOOT, first=4.5, pitch=1.3 * LABEL, sides=2.0) for text in texts]
    return [Picture(extent, figure, text) for figure, text in zip(figures, under, strict=True)]


def _grid(
    pictures: Sequence[Picture], papers: Sequence[Paper], told: Sequence[str]
) -> tuple[float, SheetGrid, list[Room]]:
    """The scale, the grid and its cells on the smallest paper with figures large enough, else with the largest."""
    tried: list[tuple[float, SheetGrid, list[Room]]] = []
    for area in sorted({paper.width * paper.height for paper in papers}):
        for paper in (paper for paper in papers if paper.width * paper.height == area):
            grid = SheetGrid.over(paper, told=told)
            for columns in range(1, len(pictures) + 1):
                cells = grid.field.cells(len(pictures), columns)
                tried.append((pictures[0].scale(cells[0]), grid, cells))
        best = min(tried, key=lambda one: one[0])
        if pictures[0].extent.longest / best[0] >= _LARGE_ENOUGH:
            break
    return best


def _figure(method: Method, plot: Plot, plots: Sequence[Plot], slow: SlowPoint | None, window: Window) -> Figure:
    """The mechanism and its slowest point with its line, dashed, on to it where it lies beyond the link."""
    figure = plain_mechanism(method, plot, window, plots)
    if slow is None or slow.along is None or not _is_near(slow, shown_places(method, plot)):
        return figure
    at, marks = window(slow.place), list[Mark]()
    if not 0 <= slow.along <= slow.length:
        end = place(plot.position[slow.points[slow.along > 0]])
        marks.append(Stroke((window(end), at), "dashed"))
    marks += [Disc(at, _RING, "construction"), Disc(at, _DOT, "construction", "ink")]
    label = (Run("v", True), Run("min", False, "sub"))
    return figure + Figure(marks, [LabelRequest(label, at, gap=_RING)])


def _is_near(slow: SlowPoint, places: list[complex]) -> bool:
    """A slowest point that is one place and near enough to be drawn among these [m]."""
    if slow.along is None or not places:
        return False
    sizes = [high - low for low, high in (corners([*places, slow.place]), corners(places))]
    with_it, without = (max(size.real, size.imag) for size in sizes)
    return with_it <= _FAR * without
