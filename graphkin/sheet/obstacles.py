"""What labels keep away from: everything drawn, as shapely geometry in one tree."""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from graphkin.sheet.crossings import meet, overlap, through
from graphkin.sheet.lettering import box
from graphkin.sheet.marks import Arc, Disc, Mark, Place, PointMark, Stroke, Text, VectorMark

if TYPE_CHECKING:
    from numpy.typing import NDArray

_TIP, _TIP_HALF = 2.8, 0.5
"""Length and half width of an arrow head [mm]."""
_CIRCLE = tuple(cmath.rect(1, k * cmath.pi / 12) for k in range(25))


class Tree:
    """Obstacles by place: line segments (n, 2, 2), and areas.

    shapely finds whose surroundings overlap; those of a box are those of its diagonal. Whether a segment passes
    through an upright box is seen for all at once: most of what is drawn are segments, and asked one by one they would
    take longer than all else of a crowded sheet.
    """

    def __init__(self, segments: NDArray[np.float64], areas: Sequence[Sequence[Place]]) -> None:
        """areas: the corners of each."""
        import shapely

        self._shapely, self._segments = shapely, np.ascontiguousarray(np.moveaxis(segments, 0, -1))
        self._lines = shapely.STRtree(shapely.linestrings(segments))
        corners = np.array([place for area in areas for place in (*area, area[0])], dtype=complex)
        owners = np.repeat(np.arange(len(areas)), [len(area) + 1 for area in areas])
        rings = shapely.linearrings(corners.real, corners.imag, indices=owners)
        self._areas = shapely.STRtree(shapely.polygons(rings))

    def touched(self, low: NDArray[np.float64], high: NDArray[np.float64]) -> NDArray[np.intp]:
        """Rows of the boxes low..high that touch something, once for each thing touched."""
        diagonals = self._shapely.linestrings(np.stack([low, high], axis=1))
        rows, numbers = self._lines.query(diagonals)
        start, end = self._ends(numbers)
        hit = through(start, end, low[rows].T, high[rows].T)
        near = _once(self._areas.query(diagonals)[0])
        return np.concatenate([rows[hit], self._upon(near, low, high)])

    def around(
        self, low: NDArray[np.float64], high: NDArray[np.float64], clear: float, easy: float
    ) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
        """Rows of the boxes low..high to which something is nearer than is clear, and than is easy [mm], once for each
        thing."""
        wide, narrow = (low - easy, high + easy), (low - clear, high + clear)
        diagonals = self._shapely.linestrings(np.stack(wide, axis=1))
        rows, numbers = self._lines.query(diagonals)
        start, end = self._ends(numbers)
        hit = np.flatnonzero(through(start, end, wide[0][rows].T, wide[1][rows].T))
        near, start, end = rows[hit], start[:, hit], end[:, hit]
        least, most = narrow[0][near].T, narrow[1][near].T
        on = overlap(np.minimum(start, end), np.maximum(start, end), least, most) & through(start, end, least, most)
        beside = self._upon(_once(self._areas.query(diagonals)[0]), *wide)
        upon = self._upon(_once(beside), *narrow)
        return np.concatenate([near[on], upon]), np.concatenate([near, beside])

    def _upon(self, rows: Any, low: NDArray[np.float64], high: NDArray[np.float64]) -> NDArray[np.intp]:
        """Which of some of the boxes lie on areas, once for each."""
        if not len(rows):
            return rows  # type: ignore[no-any-return]
        boxes = self._shapely.box(low[rows, 0], low[rows, 1], high[rows, 0], high[rows, 1])
        found: NDArray[np.intp] = rows[self._areas.query(boxes, predicate="intersects")[0]]
        return found

    def crossed(self, start: NDArray[np.float64], end: NDArray[np.float64]) -> NDArray[np.intp]:
        """Rows of the lines start..end that touch something, once for each thing touched."""
        lines = self._shapely.linestrings(np.stack([start, end], axis=1))
        rows, numbers = self._lines.query(lines)
        other, other_end = self._ends(numbers)
        hit = meet(start[rows].T, end[rows].T, other, other_end)
        areas: NDArray[np.intp] = self._areas.query(lines, predicate="intersects")[0]
        return np.concatenate([rows[hit], areas])

    def _ends(self, numbers: NDArray[np.intp]) -> Any:
        """Where some of the segments start and end (2, 2, n)."""
        return self._segments[:, :, numbers]


def _once(rows: NDArray[np.intp]) -> NDArray[np.intp]:
    """Each row once, in order; numpy's own way there loads its masked arrays first."""
    return np.flatnonzero(np.bincount(rows))


def tree(drawn: Iterable[Mark]) -> Tree:
    """The marks as obstacles."""
    lines: list[Place] = []
    areas: list[tuple[Place, ...]] = []
    for mark in drawn:
        for places, filled in _outlines(mark):
            if filled:
                areas.append(places)
            else:
                for ends in pairwise(places):
                    lines += ends
    corners = np.array(lines, dtype=complex)
    return Tree(np.stack([corners.real, corners.imag], axis=-1).reshape(-1, 2, 2), areas)


def _outlines(mark: Mark) -> Iterator[tuple[tuple[Place, ...], bool]]:
    """Polylines and filled areas a mark is made of."""
    match mark:
        case Stroke(places, closed=closed, fill=fill):
            yield (*places, places[0]) if closed else places, closed and fill not in ("none", "tint")
        case Disc(centre, radius, fill=fill):
            yield tuple(centre + radius * turn for turn in _CIRCLE), fill not in ("none", "tint")
        case Arc():
            yield arc_places(mark), False
        case Text(label, at, size):
            yield _frame(label, at, size), True
        case VectorMark(start=start, end=end):
            yield (start, end), False
            if abs(end - start) > _TIP:
                yield _tip(start, end), True
        case PointMark(at=at, radius=radius):
            yield tuple(at + radius * turn for turn in _CIRCLE[::3]), True


def arc_places(arc: Arc) -> tuple[Place, ...]:
    """A polyline close to an arc."""
    count = max(4, int(abs(arc.sweep) * 8))
    return tuple(arc.centre + cmath.rect(arc.radius, arc.start + arc.sweep * k / count) for k in range(count + 1))


def _tip(start: Place, end: Place) -> tuple[Place, ...]:
    along = (end - start) / abs(end - start)
    back = end - along * _TIP
    return end, back + along * 1j * _TIP_HALF, back - along * 1j * _TIP_HALF


def _frame(label: Any, at: Place, size: float) -> tuple[Place, ...]:
    wide, up, down = box(label, size)
    return at + 1j * down, at + wide + 1j * down, at + wide - 1j * up, at - 1j * up


def bounds(drawn: Iterable[Mark]) -> tuple[float, float, float, float]:
    """Left, top, right, bottom of all marks [mm]."""
    places = [place for mark in drawn for outline, _ in _outlines(mark) for place in outline]
    xs, ys = [p.real for p in places] or [0.0], [p.imag for p in places] or [0.0]
    return min(xs), min(ys), max(xs), max(ys)


def places(drawn: Iterable[Mark]) -> Any:
    """Some places on all marks: what divides each side of their outlines into eight (2, n)."""
    outlines = [outline for mark in drawn for outline, _ in _outlines(mark)]
    start = np.array([place for outline in outlines for place in outline[:-1]], dtype=complex)
    end = np.array([place for outline in outlines for place in outline[1:]], dtype=complex)
    along = (start + (end - start) * np.linspace(0.0, 1.0, 9)[:, None]).ravel()
    return np.array([along.real, along.imag])
