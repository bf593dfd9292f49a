"""Notes."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from graphkin.base.value import frozen
from graphkin.errors import Lang
from graphkin.model.quantities import EDGE
from graphkin.outputs.diagram import words
from graphkin.outputs.diagram.curves import Curves, Peak
from graphkin.outputs.diagram.panels import CurvePanel
from graphkin.running.path import Event

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.path import Path
    from matplotlib.transforms import Bbox

ON_A_CURVE, ON_A_NOTE = 60.0, 1000.0
"""What standing on a curve, or on another text, costs, in points of distance."""
WRONG_SIDE = 8.0
STEPS = (4.0, 7.0, 11.0, 16.0, 22.0, 29.0, 37.0, 46.0)
"""How far from its dot a text is tried [pt]."""
GAP, CLOSE = 1.5, 3.0
"""Room kept around a text, and between it and its dot [pt]."""
FAR = 10.0
"""From here on a thin line leads from the dot to its text [pt]."""


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


def arrange(
    notes: Sequence[Note], curves: Sequence[Path], taken: Sequence[Bbox], frame: Bbox, point: float
) -> list[tuple[Bbox, bool]]:
    """The box of each text [pixels], and whether a thin line leads to it.

    taken  boxes in which nothing may stand; point: pixels in one point
    """
    boxes: list[Any] = [None] * len(notes)
    dots = [_about(note.at, 2.0 * point) for note in notes]
    for _ in range(2):
        for k, note in enumerate(notes):
            others = [box for j, box in enumerate(boxes) if j != k and box is not None]
            others += [*taken, *(dot for j, dot in enumerate(dots) if j != k)]
            boxes[k] = _best(note, curves, others, frame, point)
    return [(box, _distance(note.at, box) > FAR * point) for note, box in zip(notes, boxes, strict=True)]


def _best(note: Note, curves: Sequence[Path], others: Sequence[Bbox], frame: Bbox, point: float) -> Bbox:
    best, least = None, math.inf
    for cost, box in sorted(_tried(note, frame, point), key=lambda entry: entry[0]):
        if cost >= least:
            break
        wide = box.padded(GAP * point)
        cost += ON_A_NOTE * sum(bool(wide.overlaps(other)) for other in others)
        if cost < least:
            cost += ON_A_CURVE * sum(bool(path.intersects_bbox(wide, filled=False)) for path in curves)
        if cost < least:
            best, least = box, cost
    assert best is not None
    return best


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
    across = max(box.x0 - at[0], 0.0, at[0] - box.x1)
    up = max(box.y0 - at[1], 0.0, at[1] - box.y1)
    return math.hypot(across, up)


def _about(at: tuple[float, float], size: float) -> Bbox:
    from matplotlib.transforms import Bbox

    return Bbox.from_bounds(at[0] - size, at[1] - size, 2 * size, 2 * size)


def paths_of(pixels: np.ndarray) -> list[Path]:
    """The drawn stretches of a curve (n, 2) [pixels], without the places where it is not known."""
    from matplotlib.path import Path

    known = np.isfinite(pixels).all(axis=1)
    breaks = np.flatnonzero(np.diff(known.astype(int))) + 1
    pieces = np.split(pixels, breaks)
    return [Path(piece) for piece in pieces if len(piece) > 1 and np.isfinite(piece).all()]


SIZE = 7.5
THIN_PT = 0.18 * 72 / 25.4


@frozen
class DrawnPanel:
    """A panel that is drawn: its axes, and the line of each curve by its number."""

    panel: CurvePanel
    sides: tuple[Axes, ...]
    lines: Mapping[int, Any]


def note_peaks(page: Figure, found: Curves, drawn: Sequence[DrawnPanel], lang: Lang) -> None:
    """Write at every panel, once all is where it stays."""
    page.draw_without_rendering()
    for panel in drawn:
        paths = [path for line in panel.lines.values() for path in paths_of(_pixels(line))]
        paths += _straight(panel)
        taken: list[Bbox] = []
        for event in found.events:
            taken.append(_name_event(page, panel, found, event, paths, taken, lang))
        _write_peaks(page, found, panel, paths, taken)


def _pixels(line: Any) -> np.ndarray:
    """Where a curve is drawn (n, 2) [pixels]."""
    return np.asarray(line.get_transform().transform(np.column_stack(line.get_data())))


def _straight(drawn: DrawnPanel) -> list[Any]:
    """The zero line and the upright lines [pixels]."""
    lines = [line for line in drawn.sides[0].lines if line not in drawn.lines.values()]
    return [path for line in lines for path in paths_of(_pixels(line))]


# --- greatest and least values ----------------------------------------------------------------


def _write_peaks(page: Figure, found: Curves, drawn: DrawnPanel, paths: Sequence[Any], taken: Sequence[Bbox]) -> None:
    top, frame, point = drawn.sides[-1], drawn.sides[0].bbox, page.dpi / 72
    texts, notes = [], []
    for k, place, peak, text in _peaks(found, drawn):
        line = drawn.lines[k]
        at = tuple(float(x) for x in line.axes.transData.transform(place))
        name = f"peak-{k}-{'greatest' if peak.sign > 0 else 'least'}"
        line.axes.plot(*place, color=line.get_color(), marker="o", markersize=2.6, linestyle="", gid=name)
        texts.append(top.text(0, 0, text, fontsize=SIZE, color=line.get_color(), transform=None, va="bottom", zorder=5))
        box = texts[-1].get_window_extent(page.canvas.get_renderer())  # type: ignore[attr-defined]
        notes.append(Note((at[0], at[1]), (box.width, box.height), peak.sign))
    placed = arrange(notes, paths, taken, frame, point)
    for written, note, (box, led) in zip(texts, notes, placed, strict=True):
        _put(top, written, note, box, led)


def _peaks(found: Curves, drawn: DrawnPanel) -> Iterator[tuple[int, tuple[float, float], Peak, str]]:
    """(curve, place in its axes, peak, text) of all extremes in a panel."""
    across = EDGE[found.course.unit].factor
    for k in drawn.lines:
        unit = EDGE[found.series[k].unit]
        for peak in found.peaks[k]:
            place = float(found.course.value(peak.t)) * across, peak.value * unit.factor
            degree = unit.sign if unit.sign == "°" else ""
            yield k, place, peak, f"{words.figure_of(place[1])}{degree} @ {words.place_of(found, peak.t)}"


def _put(top: Axes, text: Any, note: Note, box: Bbox, led: bool) -> None:
    """Move a text to its box, in parts of the panel, so that it stays there at any resolution."""
    inside = top.transAxes.inverted()
    text.set_transform(top.transAxes)
    text.set_position(inside.transform((box.x0, box.y0)))
    if led:
        near = np.clip(note.at, (box.x0, box.y0), (box.x1, box.y1))
        (x0, y0), (x1, y1) = inside.transform(note.at), inside.transform(near)
        top.plot([x0, x1], [y0, y1], transform=top.transAxes, color=text.get_color(), linewidth=THIN_PT)


# --- stops and change points ------------------------------------------------------------------


def _name_event(
    page: Figure,
    drawn: DrawnPanel,
    found: Curves,
    event: Event,
    paths: Sequence[Any],
    taken: Sequence[Bbox],
    lang: Lang,
) -> Bbox:
    """The word along an upright line, at the height and on the side where it hides least of the curves."""
    from matplotlib.transforms import Bbox

    first, top = drawn.sides[0], drawn.sides[-1]
    across = EDGE[found.course.unit].factor
    x = float(first.transData.transform((float(found.course.value(event.at)) * across, 0))[0])
    text = top.text(0, 0, words.event_mark(event, lang), fontsize=SIZE, rotation=90, transform=None, zorder=5)
    text.set_verticalalignment("bottom")
    size = text.get_window_extent(page.canvas.get_renderer())  # type: ignore[attr-defined]
    frame, gap = first.bbox, 2 * page.dpi / 72
    tried: list[tuple[int, int, Bbox]] = []
    for left in (x + gap, x - gap - size.width):
        for part in (0.97, 0.03, 0.8, 0.2, 0.65, 0.35, 0.5):
            low = frame.y0 + 2 * gap + part * (frame.height - size.height - 4 * gap)
            box = Bbox.from_bounds(left, low, size.width, size.height)
            if frame.x0 < box.x0 and box.x1 < frame.x1:
                hidden = sum(path.intersects_bbox(box, filled=False) for path in paths)
                tried.append((hidden + 100 * sum(map(box.overlaps, taken)), len(tried), box))
    box = min(tried, key=lambda entry: entry[:2])[2]
    text.set_transform(top.transAxes)
    across_part, up_part = top.transAxes.inverted().transform((box.x0, box.y0))
    text.set_position((float(across_part), float(up_part)))
    return box
