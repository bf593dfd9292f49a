"""Positions side by side on one sheet: the mechanism again and again, at one scale, each with its caption.

Every figure has a cell of its own, and the fixed points stand at the same place in each cell, so that what has
moved is seen. Points are plain marks here: a sheet of several positions is looked at, not measured.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from graphkin.construction import Plot
from graphkin.errors import Lang
from graphkin.planning import Method
from graphkin.sheet import Sheet
from graphkin.sheet.labels import Room, settle
from graphkin.sheet.layout import papers_for
from graphkin.sheet.lettering import plain, width
from graphkin.sheet.marks import Disc, Mark, Place, PointMark, Text
from graphkin.sheet.mechanism_figure import mechanism_figure
from graphkin.sheet.obstacles import bounds
from graphkin.sheet.paper import BODY, Paper
from graphkin.sheet.scales import finest
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.specials import named_specials
from graphkin.sheet.titleblock import broken, strip, strip_heights
from graphkin.sheet.wheels import rims
from graphkin.sheet.window import Figure, Window, births, first_steps
from graphkin.value import frozen

__all__ = ["MOST", "side_by_side"]

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


@frozen
class _Frame:
    """How much room every figure wants: its points [m], and what its signs reach beyond them [mm]."""

    low: complex
    high: complex
    left: float
    top: float
    right: float
    bottom: float

    @property
    def size(self) -> complex:
        return self.high - self.low

    @property
    def reach(self) -> complex:
        return complex(self.left + self.right, self.top + self.bottom)


@frozen
class _Grid:
    """A paper divided into equal cells."""

    paper: Paper
    cells: tuple[Room, ...]
    strip: Room
    scale: float


def side_by_side(
    method: Method, plots: Sequence[Plot], captions: Sequence[str], lang: Lang = "en", *, paper: str | None = None
) -> Sheet:
    """The mechanism at several positions (at most `MOST`), lettered (a), (b), .. with captions.

    plots   the method replayed at one position each
    paper   a key of `PAPERS`; the smallest on which the figures are large enough where left out

    Raises UnknownPaper.
    """
    if not 0 < len(plots) <= MOST or len(captions) != len(plots):
        raise ValueError(f"1 to {MOST} positions, each with a caption; given: {len(plots)}, {len(captions)}")
    frame = _frame(method, plots)
    grid = _grid(method, frame, len(plots), papers_for(paper))
    marks = strip(method.mechanism, [], grid.paper, grid.strip, {"position": grid.scale}, {}, lang)
    for number, (plot, caption, cell) in enumerate(zip(plots, captions, grid.cells)):
        marks += _cell(method, plot, frame, grid.scale, cell)
        marks += _caption(f"({chr(ord('a') + number)}) {caption}", cell)
    origin = _origin(frame, grid.scale, grid.cells[0])
    drivers = tuple(float(value) for value in plots[0].facts.values)
    title = method.mechanism.headline(lang)
    scales, origins = {"position": grid.scale}, {"position": origin}
    return Sheet(grid.paper, tuple(marks), scales, origins, method.mechanism, drivers, title, lang)  # type: ignore[arg-type]


# --- how large --------------------------------------------------------------------------------


def _values(method: Method, plot: Plot) -> list[complex]:
    """The places a figure shows [m]."""
    machine, points = method.mechanism, plot.position
    drawn = [*(complex(points[p]) for p in machine.points if p in points), *rims(machine, points)]
    return [*drawn, *named_specials(method, plot, drawn).values()]


def _figure(method: Method, plot: Plot, window: Window) -> Figure:
    born = births(method.position, first_steps(method)["position"])
    return mechanism_figure(Skeleton(method.mechanism, plot, window, born), method, _values(method, plot))


def _frame(method: Method, plots: Sequence[Plot]) -> _Frame:
    """What holds all figures, laid over one another."""
    places = [place for plot in plots for place in _values(method, plot)]
    low = complex(min(z.real for z in places), min(z.imag for z in places))
    high = complex(max(z.real for z in places), max(z.imag for z in places))
    trial = finest(high - low, complex(_TRIAL, _TRIAL))
    reaches = [bounds(_figure(method, plot, Window(0j, trial)).marks) for plot in plots]
    left, top = min(r[0] for r in reaches), min(r[1] for r in reaches)
    right, bottom = max(r[2] for r in reaches), max(r[3] for r in reaches)
    return _Frame(
        low, high,
        max(0.0, low.real / trial - left) + _LETTERS, max(0.0, -high.imag / trial - top) + _LETTERS,
        max(0.0, right - high.real / trial) + _LETTERS, max(0.0, bottom + low.imag / trial) + _LETTERS,
    )  # fmt: skip


def _grid(method: Method, frame: _Frame, count: int, papers: Sequence[Paper]) -> _Grid:
    """The smallest paper with figures large enough, else the one with the largest."""
    best: _Grid | None = None
    for area in sorted({paper.width * paper.height for paper in papers}):
        same = [paper for paper in papers if paper.width * paper.height == area]
        grids = [grid for paper in same for grid in _grids(method, frame, count, paper)]
        best = min([*grids, *([best] if best else [])], key=lambda grid: grid.scale)
        if max(frame.size.real, frame.size.imag) / best.scale >= _LARGE_ENOUGH:
            return best
    assert best is not None
    return best


def _grids(method: Method, frame: _Frame, count: int, paper: Paper) -> Iterator[_Grid]:
    """Every number of columns."""
    height = strip_heights([])[paper.name]
    left, top, right = paper.margin, paper.margin, paper.width - paper.margin
    foot = paper.height - paper.margin
    given = method.mechanism.scales.get("length")
    for columns in range(1, count + 1):
        rows = math.ceil(count / columns)
        wide, high = (right - left) / columns, (foot - height - top) / rows
        cells = [
            Room(left + k % columns * wide, top + k // columns * high, left + (k % columns + 1) * wide,
                 top + (k // columns + 1) * high)
            for k in range(count)
        ]  # fmt: skip
        room = complex(max(wide - frame.reach.real, 1.0), max(high - frame.reach.imag - _FOOT, 1.0))
        scale = finest(frame.size, room)
        if given is not None and given >= scale:
            scale = given
        yield _Grid(paper, tuple(cells), Room(left, foot - height, right, foot), scale)


# --- drawing ----------------------------------------------------------------------------------


def _origin(frame: _Frame, scale: float, cell: Room) -> Place:
    """Where the mechanism's origin lies, so that the figures stand in the middle of their cells."""
    whole = frame.size / scale + frame.reach
    x = (cell.left + cell.right - whole.real) / 2 + frame.left
    y = (cell.top + cell.bottom - _FOOT - whole.imag) / 2 + frame.top + frame.size.imag / scale
    return complex(x, y) - frame.low.conjugate() / scale


def _cell(method: Method, plot: Plot, frame: _Frame, scale: float, cell: Room) -> list[Mark]:
    """One figure with its labels."""
    figure = _figure(method, plot, Window(_origin(frame, scale, cell), scale))
    drawn = [_plain(mark) for mark in figure.marks]
    inner = Room(cell.left + 1, cell.top + 1, cell.right - 1, cell.bottom - _FOOT)
    settled = settle(figure.wanted, drawn, inner)
    if settled.clashes:
        settled = settle(figure.wanted, drawn, inner, far=True)
    return drawn + settled.marks


def _plain(mark: Mark) -> Mark:
    """A point as a circle and nothing more."""
    if not isinstance(mark, PointMark):
        return mark
    return Disc(mark.at, mark.radius, "outline" if mark.fill == "paper" else "construction", mark.fill, step=mark.step)


def _caption(text: str, cell: Room) -> Iterator[Mark]:
    """One line or two, in the middle under the figure."""
    room = cell.right - cell.left - 4
    pen = cell.bottom - _FOOT + 4.5
    for line in broken(text, BODY, room):
        label = plain(line)
        yield Text(label, complex((cell.left + cell.right - width(label, BODY)) / 2, pen), BODY)
        pen += 1.3 * BODY
