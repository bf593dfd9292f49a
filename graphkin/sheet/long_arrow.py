"""An arrow that is drawn broken: over five times as long as most of its plane, and nothing hangs on where its head is.

The scale is then chosen by the others. The arrow has its direction, a gap between two strokes in its middle, and its
size at its name; the length that is left out is stated, so that a ruler can add it.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Sequence

from graphkin.base.geometry import place
from graphkin.construction import Construction, Plot
from graphkin.planning import Method
from graphkin.planning.needed import PartsReader
from graphkin.sheet.marks import BREAK, Stroke, VectorMark
from graphkin.sheet.polygons import GearImage, PolygonFigure
from graphkin.sheet.window import Figure, corners, trial_window

_LONG, _WORTH, _DRAWN = 5.0, 1.5, 1.2
"""An arrow is drawn broken that is so many times as long as the median of all, where the polygon becomes so many times
smaller; it is drawn so many times as long as the longest other one."""
_POINT = 0.1  # shorter arrows and distances are none, where the polygon is as large as a trial [mm]
_SIGN = cmath.rect(1.6, cmath.pi / 3)  # half of a stroke of the break sign, on an arrow to the right [mm]


def left_out(method: Method, construction: Construction, plot: Plot, gears: Sequence[GearImage]) -> dict[str, complex]:
    """The head of the arrow that is drawn broken, and the piece of the arrow that is not drawn [SI]; or nothing."""
    points = plot.points(construction.plane)
    places = {name: place(points[name]) for name in (construction.pole, *construction.nodes) if name in points}
    polygon = PolygonFigure(method.mechanism, construction, plot, trial_window([*places.values()]), {})
    vectors = [vector for vector in polygon.vectors() if vector.length > _POINT]
    long = max(vectors, key=lambda vector: vector.length, default=None)
    lengths = sorted(vector.length for vector in vectors)
    if long is None or long.length <= _LONG * (lengths[(len(lengths) - 1) // 2] + lengths[len(lengths) // 2]) / 2:
        return {}
    drawn = _DRAWN * max(vector.length for vector in vectors if vector is not long) / long.length
    piece = (places[long.head] - places[long.tail]) * (1 - drawn)
    circles = [corner for image in gears for corner in image.corners]
    shorter = _span([*{**places, long.head: places[long.head] - piece}.values(), *circles])
    if _WORTH * shorter > _span([*places.values(), *circles]) or _bears(method, polygon, gears, long):
        return {}
    return {long.head: piece}


def _span(places: Iterable[complex]) -> float:
    """From corner to corner of what holds them."""
    low, high = corners([*places])
    return abs(high - low)


def _bears(method: Method, polygon: PolygonFigure, gears: Sequence[GearImage], arrow: VectorMark) -> bool:
    """True if something else is drawn or measured from the head of an arrow: it must be where it belongs."""
    ends = [name for vector in polygon.vectors() for name in (vector.tail, vector.head)]
    ends += [name for _, names in polygon.images() for name in names] + [image.centre for image in gears]
    ends += [arrow.head for name, at in polygon.points.items() if abs(at - arrow.end) < _POINT and name != arrow.head]
    readers = [PartsReader(method, each) for each in method.constructions]
    needs = (fact for reader, each in zip(readers, method.constructions, strict=True) for step in each.steps
             for fact in reader.needs(step))  # fmt: skip
    return ends.count(arrow.head) > 1 or (arrow.plane, arrow.head) in needs


def with_break_signs(figure: Figure) -> Figure:
    """The figure with two strokes across each arrow that is drawn broken, one on each side of its gap."""
    marks = [*figure.marks]
    for vector in (mark for mark in figure.marks if isinstance(mark, VectorMark) and mark.broken):
        along, middle = (vector.end - vector.start) / (vector.length or 1.0), (vector.start + vector.end) / 2
        for at in (middle - BREAK / 2 * along, middle + BREAK / 2 * along):
            marks.append(Stroke((at - along * _SIGN, at + along * _SIGN), "thin", step=vector.step))
    return Figure(marks, figure.wanted)
