"""Texts at the curves of a motion diagram: greatest and least values, dead points and change points.

They stand beside what they name, on no other text and, if that can be, on no curve.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from graphkin.base.geometry import Array, number
from graphkin.base.value import frozen
from graphkin.errors import Lang
from graphkin.outputs.diagram.curves import Curves
from graphkin.outputs.diagram.panels import event_mark, figure_of, place_of
from graphkin.running.path import Event

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D
    from matplotlib.path import Path
    from matplotlib.text import Text
    from matplotlib.transforms import Bbox

ON_A_CURVE, ON_A_NOTE = 60.0, 1000.0  # the cost of standing on a curve, or on another text, in points of distance
WRONG_SIDE = 8.0
STEPS = (4.0, 7.0, 11.0, 16.0, 22.0, 29.0, 37.0, 46.0)  # distances from its dot at which a text is tried [pt]
GAP, CLOSE = 3.0, 3.0  # room kept around a text, and between it and its dot [pt]
FAR = 10.0  # from here on a thin line leads from the dot to its text [pt]
SIZE = 7.5
THIN_PT = 0.18 * 72 / 25.4


@frozen
class DrawnPanel:
    """A panel that is drawn: its axes, and by the number of each curve its axis and its line."""

    sides: tuple[Axes, ...]
    lines: Mapping[int, tuple[Axes, Line2D]]


@frozen
class Note:
    """A text at a place.

    at    the place [pixels]
    size  width and height of the text [pixels]
    side  1: better above, -1: better below
    """

    at: tuple[float, float]
    size: tuple[float, float]
    side: int


def note_peaks(page: Figure, curves: Curves, drawn: Sequence[DrawnPanel], lang: Lang) -> None:
    """Write at every panel, once all is where it stays."""
    from matplotlib.path import Path

    page.draw_without_rendering()
    for panel in drawn:
        lines = [line for _, line in panel.lines.values()]
        straight = [line for line in panel.sides[0].lines if line not in lines]  # the zero line and the upright ones
        paths: list[Path] = []  # the drawn stretches [pixels], without the places where a curve is not known
        for line in (*lines, *straight):
            pixels = np.asarray(line.get_transform().transform(np.column_stack(line.get_data())))
            known = np.isfinite(pixels).all(axis=1)
            pieces: list[Array] = np.split(pixels, np.flatnonzero(np.diff(known.astype(int))) + 1)
            paths += [Path(piece) for piece in pieces if len(piece) > 1 and np.isfinite(piece).all()]
        boxes: list[Bbox] = []
        for event in curves.events:
            boxes.append(_name_event(page, panel, curves, event, paths, boxes, lang))
        _write_peaks(page, curves, panel, paths, boxes)


def _extent(page: Figure, text: Text) -> Bbox:
    return text.get_window_extent(page.canvas.get_renderer())  # type: ignore[attr-defined]


def _write_peaks(page: Figure, curves: Curves, drawn: DrawnPanel, paths: Sequence[Path], boxes: Sequence[Bbox]) -> None:
    top = drawn.sides[-1]
    texts: list[Text] = []
    notes: list[Note] = []
    across = curves.shown(curves.course.unit).factor
    for k, peak in [(curve, peak) for curve in drawn.lines for peak in curves.peaks[curve]]:
        (side, line), unit = drawn.lines[k], curves.shown(curves.series[k].unit)
        place = number(curves.course.value(peak.t)) * across, peak.value * unit.factor
        degree = unit.sign if unit.sign == "°" else ""
        text = f"{figure_of(place[1])}{degree} ({place_of(curves, peak.t)})"
        x, y = (float(part) for part in side.transData.transform(place))
        name = f"peak-{k}-{'greatest' if peak.sign > 0 else 'least'}"
        side.plot(*place, color=line.get_color(), marker="o", markersize=2.6, linestyle="", gid=name)
        texts.append(top.text(0, 0, text, fontsize=SIZE, color=line.get_color(), transform=None, va="bottom", zorder=5))
        box = _extent(page, texts[-1])
        notes.append(Note((x, y), (box.width, box.height), peak.sign))
    placed = arrange(notes, paths, boxes, drawn.sides[0].bbox, page.dpi / 72)
    for written, note, (box, led) in zip(texts, notes, placed, strict=True):
        _put(top, written, box)
        if led:
            near = np.clip(note.at, (box.x0, box.y0), (box.x1, box.y1))
            (x0, y0), (x1, y1) = (top.transAxes.inverted().transform(end) for end in (note.at, near))
            top.plot([x0, x1], [y0, y1], transform=top.transAxes, color=written.get_color(), linewidth=THIN_PT)


def _put(top: Axes, text: Text, box: Bbox) -> None:
    """Move a text to its box, in parts of the panel, so that it stays there at any resolution."""
    text.set_transform(top.transAxes)
    x, y = top.transAxes.inverted().transform((box.x0, box.y0))
    text.set_position((float(x), float(y)))


def _name_event(
    page: Figure, drawn: DrawnPanel, curves: Curves, event: Event, paths: Sequence[Path], boxes: Sequence[Bbox],
    lang: Lang,
) -> Bbox:  # fmt: skip
    """The word along an upright line, at the height and on the side where it hides least of the curves."""
    from matplotlib.transforms import Bbox

    first, top = drawn.sides[0], drawn.sides[-1]
    across = curves.shown(curves.course.unit).factor
    x = float(first.transData.transform((number(curves.course.value(event.at)) * across, 0))[0])
    text = top.text(0, 0, event_mark(event, lang), fontsize=SIZE, rotation=90, transform=None, va="bottom", zorder=5)
    size = _extent(page, text)
    frame, gap = first.bbox, 2 * page.dpi / 72
    tried: list[tuple[int, int, Bbox]] = []
    for left in (x + gap, x - gap - size.width):
        for part in (0.97, 0.03, 0.8, 0.2, 0.65, 0.35, 0.5):
            low = frame.y0 + 2 * gap + part * (frame.height - size.height - 4 * gap)
            box = Bbox.from_bounds(left, low, size.width, size.height)
            if frame.x0 < box.x0 and box.x1 < frame.x1:
                hidden = sum(path.intersects_bbox(box, filled=False) for path in paths)
                tried.append((hidden + 100 * sum(map(box.overlaps, boxes)), len(tried), box))
    box = min(tried, key=lambda entry: entry[:2])[2]
    _put(top, text, box)
    return box


def arrange(
    notes: Sequence[Note], curves: Sequence[Path], occupied: Sequence[Bbox], frame: Bbox, point: float
) -> list[tuple[Bbox, bool]]:
    """The box of each text [pixels], and True where a thin line leads to it.

    occupied  boxes in which nothing may stand; point: pixels in one point
    """
    from matplotlib.transforms import Bbox

    boxes: dict[int, Bbox] = {}
    dots = [Bbox.from_bounds(x - 2 * point, y - 2 * point, 4 * point, 4 * point) for x, y in (n.at for n in notes)]
    for _ in range(2):
        for k, note in enumerate(notes):
            others = [box for j, box in sorted(boxes.items()) if j != k]
            others += [*occupied, *(dot for j, dot in enumerate(dots) if j != k)]
            least = math.inf
            for cost, box in sorted(_tried(note, frame, point), key=lambda entry: entry[0]):
                if cost >= least:
                    break
                wide = box.padded(GAP * point)
                cost += ON_A_NOTE * sum(bool(wide.overlaps(other)) for other in others)
                if cost < least:
                    cost += ON_A_CURVE * sum(bool(path.intersects_bbox(wide, filled=False)) for path in curves)
                if cost < least:
                    boxes[k], least = box, cost
    return [(boxes[k], _distance(note.at, boxes[k]) > FAR * point) for k, note in enumerate(notes)]


def _tried(note: Note, frame: Bbox, point: float) -> Iterator[tuple[float, Bbox]]:
    """Boxes around a dot, each with its distance in points; all within the frame."""
    from matplotlib.transforms import Bbox

    (x, y), (wide, high) = note.at, note.size
    for step in STEPS:
        for angle in range(0, 360, 15):
            across, up = math.cos(math.radians(angle)), math.sin(math.radians(angle))
            left = x + across * (step * point + wide / 2) - wide / 2
            low = y + up * (step * point + high / 2) - high / 2
            left = min(max(left, frame.x0 + 4.5 * point), frame.x1 - 4.5 * point - wide)
            low = min(max(low, frame.y0 + 4.5 * point), frame.y1 - 4.5 * point - high)
            box = Bbox.from_bounds(left, low, wide, high)
            if (distance := _distance(note.at, box)) > CLOSE * point:
                lean = WRONG_SIDE * max(0.0, -note.side * up) + 3.0 * abs(across)
                yield distance / point + lean, box


def _distance(at: tuple[float, float], box: Bbox) -> float:
    """From a place to a box, 0 inside it."""
    return math.hypot(max(box.x0 - at[0], 0.0, at[0] - box.x1), max(box.y0 - at[1], 0.0, at[1] - box.y1))
