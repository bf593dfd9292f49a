"""The slowest point of a link's line, marked on the mechanism."""

from __future__ import annotations

from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import Run
from graphkin.sheet.marks import Disc, Mark, Stroke
from graphkin.sheet.window import Figure, Window
from graphkin.studies.finding.answers import SlowPoint

_DOT, _RING = 0.7, 1.7
"""A dot in a ring, which no point of a mechanism is [mm]."""
_FAR = 1.9
"""So many times larger the figure may become for its sake."""


def near(slow: SlowPoint, places: list[complex]) -> list[complex]:
    """Where it is, if that is one place and near enough to be drawn among these [m]."""
    if slow.along is None or not places:
        return []
    return [slow.place] if _extent([*places, slow.place]) <= _FAR * _extent(places) else []


def _extent(places: list[complex]) -> float:
    xs, ys = [place.real for place in places], [place.imag for place in places]
    return max(max(xs) - min(xs), max(ys) - min(ys))


def marked(slow: SlowPoint, ends: tuple[complex, complex], window: Window) -> Figure:
    """Its dot and ring, and the line on to it where it lies beyond the link; ends: the two points of the line [m]."""
    assert slow.along is not None
    at = window(slow.place)
    marks: list[Mark] = []
    if not 0 <= slow.along <= slow.length:
        marks.append(Stroke((window(ends[slow.along > 0]), at), "dashed"))
    marks += [Disc(at, _RING, "construction"), Disc(at, _DOT, "construction", "ink")]
    label = (Run("v", True), Run("min", False, "sub"))
    return Figure(marks, [LabelRequest(label, at, gap=_RING)])
