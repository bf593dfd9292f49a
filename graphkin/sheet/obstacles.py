"""The obstacles of labels: everything drawn, as lines; an area by its rim, and lines through it that leave no letter
room between them."""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from graphkin.base.boxes import xy
from graphkin.base.geometry import Array
from graphkin.base.lines import levels
from graphkin.base.segments import Segments
from graphkin.sheet.lettering import box
from graphkin.sheet.marks import ArcMark, Disc, Mark, Place, PointMark, Stroke, Text, VectorMark

_TIP, _TIP_HALF = 2.8, 0.5  # length and half width of an arrow head [mm]
_LETTER = 2.0  # no letter is much narrower [mm]
_CIRCLE = tuple(cmath.rect(1, k * cmath.pi / 12) for k in range(25))


def obstacles(drawn: Iterable[Mark], hollow: bool = False) -> Segments:
    """The marks as obstacles: their outlines, and what fills them; hollow: for lines alone, which cross an outline."""
    lines: list[Sequence[Place]] = []
    for mark in drawn:
        for outline, filled in _outlines(mark):
            lines.append(outline)
            if filled and not hollow:
                lines += levels(outline, _LETTER)
    places = xy(np.array([place for line in lines for place in line], dtype=complex))
    start = np.delete(np.arange(places.shape[1]), np.cumsum([len(line) for line in lines], dtype=np.intp) - 1)
    return Segments(places.take(start, axis=1), places.take(start + 1, axis=1))


def _outlines(mark: Mark) -> Iterator[tuple[Sequence[Place], bool]]:
    """Polylines that a mark is made of, and whether what is in them is filled."""
    match mark:
        case Stroke(closed=closed, fill=fill):
            yield mark.outline, closed and fill not in ("none", "tint")
        case Disc(centre, radius, fill=fill):
            yield [centre + radius * turn for turn in _CIRCLE], fill not in ("none", "tint")
        case ArcMark():
            yield arc_places(mark), False
        case Text(label, at, size):
            (wide, up, down), turn = box(label, size), cmath.rect(1, mark.turn)
            corners = (1j * down, wide + 1j * down, wide - 1j * up, -1j * up, 1j * down)
            yield [at + turn * corner for corner in corners], True
        case VectorMark(start=start, end=end):
            yield (start, end), False
            if abs(end - start) > _TIP:
                along = (end - start) / abs(end - start)
                back, half = end - along * _TIP, along * 1j * _TIP_HALF
                yield (back + half, end, back - half), False
        case PointMark(at=at, radius=radius):
            yield [at + radius * turn for turn in _CIRCLE[::3]], False


def arc_places(arc: ArcMark, fine: float = 1.0) -> tuple[Place, ...]:
    """A polyline close to an arc; fine: so many times as many places."""
    count = max(4, int(abs(arc.sweep) * 8 * fine))
    return tuple(arc.centre + cmath.rect(arc.radius, arc.start + arc.sweep * k / count) for k in range(count + 1))


def bounds(drawn: Iterable[Mark]) -> tuple[float, float, float, float]:
    """Left, top, right, bottom of all marks [mm]."""
    places = [place for mark in drawn for outline, _ in _outlines(mark) for place in outline]
    xs, ys = [p.real for p in places] or [0.0], [p.imag for p in places] or [0.0]
    return min(xs), min(ys), max(xs), max(ys)


def places(drawn: Iterable[Mark], apart: float = _LETTER) -> tuple[Array, Array]:
    """Places on marks, no farther apart along their outlines than that [mm] (2, n), and the number of each's mark."""
    outlines = [(number, outline) for number, mark in enumerate(drawn) for outline, _ in _outlines(mark)]
    start = np.array([place for _, outline in outlines for place in outline[:-1]], dtype=complex)
    end = np.array([place for _, outline in outlines for place in outline[1:]], dtype=complex)
    count = np.ceil(abs(end - start) / apart).astype(np.intp) + 1
    number = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    on = np.repeat(start, count) + np.repeat((end - start) / np.maximum(count - 1, 1), count) * number
    owner = np.repeat([mark for mark, _ in outlines], [len(outline) - 1 for _, outline in outlines])
    return xy(on), np.repeat(owner, count).astype(np.intp)
