"""Positions of a mechanism side by side on one sheet, at one scale, each with its caption: those that were found.

Every figure has a cell of its own, and the fixed points stand at the same place in each cell, so that what has
moved is seen. Points are plain marks here: a sheet of several positions is looked at, not measured.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

from graphkin.base.geometry import place
from graphkin.base.rooms import enlarged
from graphkin.construction import Plot
from graphkin.errors import Lang
from graphkin.planning import Method
from graphkin.running.other_positions import moved_to
from graphkin.say.finding import caption, lines
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import Run
from graphkin.sheet.marks import Disc, Mark, Stroke
from graphkin.sheet.mechanism_figure import plain_mechanism, shown_places
from graphkin.sheet.page import Page, Sheet
from graphkin.sheet.paper import papers_for
from graphkin.sheet.single_figure import Picture, gridded
from graphkin.sheet.titleblock import Strip
from graphkin.sheet.window import Extent, Figure, Window
from graphkin.studies.finding import Findings
from graphkin.studies.finding.answers import SlowPoint

MOST = 12  # positions on one sheet, at most
_LARGE_ENOUGH = 48.0  # a figure of this size needs no larger paper [mm]
_DOT, _RING = 0.7, 1.7  # the slowest point: a dot in a ring, which no point of a mechanism is [mm]
_FAR = 1.9  # so many times larger the figure may become for its sake


def drawn(findings: Findings, lang: Lang = "en", *, paper: str | None = None) -> tuple[Sheet | None, int]:
    """The sheet, None where there is no position that can be drawn; and how many positions had no room on it. Raises
    UnknownPaper; DeadPoint or NotReached for a position that can be told but not drawn."""
    positions = findings.shown or ((findings.nearest,) if findings.nearest is not None else ())
    if not positions:
        return None, 0
    method = findings.method
    shown, slowest = positions[:MOST], {entry.position.t: entry for entry in findings.slow}
    plots = [moved_to(method, position.drivers) for position in shown]
    captions, slow = [caption(findings, one) for one in shown], [slowest.get(one.t) for one in shown]
    sheet = positions_sheet(method, plots, captions, lang, paper=paper, told=[*lines(findings, lang)], slow=slow)
    return sheet, len(positions) - len(shown)


def positions_sheet(
    method: Method, plots: Sequence[Plot], captions: Sequence[str], lang: Lang = "en", *, paper: str | None = None,
    told: Sequence[str] = (), slow: Sequence[SlowPoint | None] = (),
) -> Sheet:  # fmt: skip
    """The mechanism at several positions (at most `MOST`), at which the method is replayed, lettered (a), (b), .. with
    captions; on the smallest paper on which the figures are large enough where none is named; told: sentences in the
    strip; slow: the point to mark in each figure, where there is one. Raises UnknownPaper."""
    figures, places = list[Callable[[Window], Figure]](), list[complex]()
    for plot, point in zip(plots, slow or [None] * len(plots), strict=True):
        figures.append(partial(_figure, method, plot, plots, point))
        further = [] if point is None or point.along is None else [point.place]
        places += enlarged(shown_places(method, plot), further, _FAR)

    def over(window: Window) -> Figure:
        return sum((figure(window) for figure in figures), Figure())

    extent = Extent.of(places, over, method.mechanism.scales.get("length"))  # all as large as all over one another
    texts = (f"({chr(ord('a') + number)}) {text}" for number, text in enumerate(captions))
    pictures = [Picture(extent, figure, (text,)) for figure, text in zip(figures, texts, strict=True)]
    papers, strip = papers_for(paper), Strip(told=told)
    for area in sorted({one.area for one in papers}):  # the smallest on which they are large enough
        tried = ((*gridded([pictures], one, strip), one) for one in papers if one.area == area)
        scale, panels, chosen = min(tried, key=lambda each: each[0])
        if extent.longest / scale >= _LARGE_ENOUGH:
            break
    return Page(chosen, panels, method.mechanism, plots[0].facts.values, lang, strip).sheet()


def _figure(method: Method, plot: Plot, plots: Sequence[Plot], slow: SlowPoint | None, window: Window) -> Figure:
    """The mechanism and its slowest point with its line, dashed, on to it where it lies beyond the link."""
    figure = plain_mechanism(method, plot, window, plots)
    shown = shown_places(method, plot)
    if slow is None or slow.along is None or len(enlarged(shown, [slow.place], _FAR)) == len(shown):
        return figure
    at, marks = window(slow.place), list[Mark]()
    if not 0 <= slow.along <= slow.length:
        end = place(plot.position[slow.points[slow.along > 0]])
        marks.append(Stroke((window(end), at), "dashed"))
    marks += [Disc(at, _RING, "construction"), Disc(at, _DOT, "construction", "ink")]
    label = (Run("v", True), Run("min", False, "sub"))
    return figure + Figure(marks, [LabelRequest(label, at, gap=_RING)])
