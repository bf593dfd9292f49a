"""Centrodes rolling: one sheet a position, and all of them in one moving SVG."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from importlib import import_module

import numpy as np

from graphkin.centres.centrodes import Centrodes
from graphkin.errors import Lang
from graphkin.sheet import Sheet
from graphkin.sheet.about_page import Page, finished, mechanism_on, within
from graphkin.sheet.centrode_sheet import centre_at, centrode_marks, centrode_page, heading, plot_at
from graphkin.sheet.marks import Disc, Mark
from graphkin.sheet.window import Figure

__all__ = ["centrode_animation", "centrode_frames"]

FRAMES, SECONDS = 48, 8.0


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


def _frame(curves: Centrodes, t: float, on: Page, lang: Lang) -> Sheet:
    method, plot = curves.found.method, plot_at(curves, t)
    marks: list[Mark] = [*centrode_marks(curves, t, on), *mechanism_on(method, plot, on.window).marks]
    centre = centre_at(curves, t)
    if centre is not None and within(on.window(centre), on.room):
        marks.append(Disc(on.window(centre), 1.0, "vector", "ink"))
    return finished(on, method, plot, heading(curves, lang), Figure(marks), lang)


def centrode_animation(frames: Sequence[Sheet], seconds: float = SECONDS) -> str:
    """One SVG that shows the frames in turn, again and again (SMIL); a still viewer shows the first.

    What all frames have in common stands in it once.
    """
    first = frames[0]
    common = [mark for mark in first.marks if all(mark in frame.marks for frame in frames[1:])]
    head, body, foot = _parts(replace(first, marks=tuple(common)))
    groups = []
    for number, frame in enumerate(frames):
        own = tuple(mark for mark in frame.marks if mark not in common)
        groups.append(_group(number, len(frames), seconds, _parts(replace(frame, marks=own))[1]))
    return head + body + "".join(groups) + foot


def _parts(sheet: Sheet) -> tuple[str, str, str]:
    """An SVG's text up to its first mark, its marks, its end. Writers come after sheets, so it is looked up by name."""
    text = str(import_module("graphkin.outputs.svg").svg(sheet))
    start = text.index("</metadata>") + len("</metadata>")
    defs = text.find("</defs>", start)
    start = start if defs < 0 else defs + len("</defs>")
    end = text.rindex("</svg>")
    return text[:start], text[start:end], text[end:]


def _group(number: int, count: int, seconds: float, body: str) -> str:
    """The marks of one frame, seen for its share of the time."""
    start, end = f"{number / count:.6f}", f"{(number + 1) / count:.6f}"
    if count == 1:
        return f"<g>{body}</g>"
    values, keys = ("hidden;visible;hidden", f"0;{start};{end}") if number else ("visible;hidden", f"0;{end}")
    if number == count - 1:
        values, keys = "hidden;visible", f"0;{start}"
    state = "hidden" if number else "visible"
    return (
        f'<g visibility="{state}"><animate attributeName="visibility" values="{values}" keyTimes="{keys}" '
        f'calcMode="discrete" dur="{seconds:g}s" repeatCount="indefinite"/>{body}</g>'
    )
