"""The frame of a quantity's diagram over a driver's way: a grid with its figures, in which the page draws the curve."""

from __future__ import annotations

from html import escape
from typing import TypedDict

import numpy as np

from graphkin.outputs.diagram.panels import division
from graphkin.outputs.typesetting import html_words, short
from graphkin.page.elements import element
from graphkin.sheet.lettering import Label

_WIDTH, _HEIGHT, _LEFT, _RIGHT, _TOP, _FOOT = 120.0, 52.0, 14.0, 114.0, 3.0, 44.0  # [mm of its own]
_USUAL = 2.0  # of a grid's values so many percent are left out on either side: near dead points some are endless


class Frame(TypedDict):
    """The place of 0 in the drawing of a diagram, and the length of a unit, across and up [mm of its own]."""

    x: tuple[float, float]
    y: tuple[float, float]


def frame(values: np.ndarray, unit: str, ends: tuple[float, float], along: str, grid: bool) -> tuple[str, Frame]:
    """The lines and figures of the grid, and where it lies.

    values  of the quantity at all knots, NaN where it has none; of a `grid` of several drivers
    ends    of the driver's way, in its unit `along`
    """
    held = values[np.isfinite(values)]
    low, high = np.percentile(held, [_USUAL, 100 - _USUAL]) if grid else (held.min(), held.max())
    low, high = min(0.0, float(low)), max(0.0, float(high))
    up = _around(low, high if high > low else low + 1.0, unit == "°")
    x = _scale(ends[0], ends[1], _LEFT, _RIGHT)
    y = _scale(up[0], up[-1], _FOOT, _TOP)
    lines = [_line(_LEFT, _RIGHT, y[0] + y[1] * at, y[0] + y[1] * at, at == 0) for at in up]
    texts = [_text(_LEFT - 1, y[0] + y[1] * at + 1, "end", _figure(at)) for at in up]
    for at in division(*ends, most=6, degrees=along == "°"):
        lines.append(_line(x[0] + x[1] * at, x[0] + x[1] * at, _TOP, _FOOT, False))
        after = "°" if along == "°" else f" {along}"
        texts.append(_text(x[0] + x[1] * at, _FOOT + 4, "middle", _figure(at) + after))
    return "".join([*lines, *texts]), {"x": x, "y": y}


def diagram(name: str, label: Label, grid: str) -> str:
    """The frame of a quantity's diagram, with room for its curve and a cursor."""
    cursor = element("line", {"class": "diagram-cursor", "y1": _TOP, "y2": _FOOT})
    moved = element("path", {"class": "diagram-curve"}), cursor, element("circle", {"class": "diagram-dot", "r": 1.2})
    drawing = element("svg", {"viewBox": f"0 0 {_WIDTH:g} {_HEIGHT:g}", "aria-hidden": "true"}, grid, *moved)
    caption = element("figcaption", {}, html_words(label), " = ", element("output", {}))
    return element("figure", {"class": "diagram", "data-diagram": name}, caption, drawing)


def _around(low: float, high: float, degrees: bool) -> list[float]:
    """Round values, the first and the last beyond these."""
    inner = division(low, high, most=4, degrees=degrees)
    step = inner[1] - inner[0] if len(inner) > 1 else high - low
    before = [inner[0] - step] if inner[0] > low + 1e-9 * step else []
    return [*before, *inner, *([inner[-1] + step] if inner[-1] < high - 1e-9 * step else [])]


def _scale(first: float, last: float, start: float, end: float) -> tuple[float, float]:
    size = (end - start) / (last - first)
    return start - size * first, size


def _line(x1: float, x2: float, y1: float, y2: float, axis: bool) -> str:
    ends = {name: short(at) for name, at in zip(("x1", "x2", "y1", "y2"), (x1, x2, y1, y2), strict=True)}
    return element("line", {"class": f"diagram-{'axis' if axis else 'grid'}", **ends})


def _text(x: float, y: float, anchor: str, text: str) -> str:
    return element("text", {"x": short(x), "y": short(y), "text-anchor": anchor}, escape(text))


def _figure(value: float) -> str:
    return f"{value:.6g}".replace("-", "−")
