"""Where texts stand in a panel: beside what they name, on no other text and, if that can be, on no curve."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from graphkin.base.value import frozen

if TYPE_CHECKING:
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
