"""Centrodes rolling: one sheet a position."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphkin.errors import Lang
from graphkin.sheet.centrode_sheet import centre_at, centrode_marks, centrode_page, heading, plot_at
from graphkin.sheet.marks import Disc
from graphkin.sheet.page import Sheet
from graphkin.sheet.single_figure import SingleFigure
from graphkin.sheet.window import Figure
from graphkin.studies.centres.centrodes import Centrodes

FRAMES = 48


def centrode_frames(
    curves: Centrodes, count: int = FRAMES, *, paper: str | None = None, lang: Lang = "en"
) -> Iterator[Sheet]:
    """The same sheet at `count` positions evenly over the motion, without letters at what moves.

    Raises UnknownPaper.
    """
    times = _times(curves, count)
    on = centrode_page(curves, [*times[:: max(1, count // 12)]], paper)
    for t in times:
        yield _frame(curves, float(t), on, lang)


def _times(curves: Centrodes, count: int) -> np.ndarray:
    """Of a motion that begins anew, the last position is the first; of others, the way there and back."""
    low, high = curves.span
    if any(piece.closed for piece in curves.pieces) or _comes_back(curves):
        return low + (high - low) * np.arange(count) / count
    there = np.linspace(low, high, count // 2 + 1)
    return np.concatenate([there, there[-2:0:-1]])


def _comes_back(curves: Centrodes) -> bool:
    """Whether all links stand at the end as they stood at the beginning."""
    stands = [np.array(curves.standing(link, np.array(curves.span))) for link in (curves.first, curves.second)]
    return all(bool(np.all(np.abs(stand[:, 1] - stand[:, 0]) < 1e-8)) for stand in stands)


def _frame(curves: Centrodes, t: float, on: SingleFigure, lang: Lang) -> Sheet:
    plot, centre = plot_at(curves, t), centre_at(curves, t)
    figure = Figure([*centrode_marks(curves, t, on), *on.mechanism(plot).marks])
    if centre is not None and on.room.holds(on.window(centre)):
        figure.marks.append(Disc(on.window(centre), 1.0, "vector", "ink"))
    return on.sheet(plot, heading(curves, lang), figure, lang)
