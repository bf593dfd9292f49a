"""The marks of a figure at many positions, each as one row of numbers that change: a mark that moves.

A mark is known from position to position by its kind and by its number among that kind. Where a row leaps from one
position to the next, one thing has taken another's place: it is two rows.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from math import cos, sin
from typing import assert_never

import numpy as np

from graphkin.base.geometry import Array
from graphkin.base.value import bulky
from graphkin.outputs.animation import as_before, matched
from graphkin.sheet.marks import ArcMark, Disc, Mark, Place, PointMark, Stroke, Text, VectorMark

_LEAP, _LEAST = 3.0, 0.6
"""So many times as far as to the positions on both sides, and so far at least [mm], is a leap."""
_RIGID = 4  # a stroke with more corners is moved as one thing, where it keeps its form
_FORM = 2e-4  # so far its corners may be off then [mm]


@bulky
class MarkTrack:
    """A mark through all positions: as it is where it is first there, its numbers (n, m), NaN where it is not there.

    form   of a stroke that moves as one thing, its corners as first drawn; its numbers are the ends of one line in it,
           which is `form` as it was at the corners `base`
    """

    mark: Mark
    numbers: np.ndarray
    form: tuple[Place, ...] = ()
    base: tuple[int, int] = (0, 0)

    @property
    def is_known(self) -> bool:
        """True of what stands for something: an arrow, a point, a line of a link; not of signs about them."""
        shows = isinstance(self.mark, Stroke | Disc) and self.mark.shows is not None
        return shows or isinstance(self.mark, VectorMark | PointMark)

    @property
    def there(self) -> np.ndarray:
        """True at the positions at which it is (n,)."""
        return np.asarray(~np.isnan(self.numbers[:, 0]))


def numbers(mark: Mark) -> list[float]:
    """All that changes of a mark while it moves [mm]."""
    match mark:
        case Stroke(places=places):
            return [side for at in places for side in (at.real, at.imag)]
        case Disc(centre=at, radius=radius):
            return [at.real, at.imag, radius]
        case ArcMark():
            ends = [mark.centre + mark.radius * complex(cos(a), sin(a)) for a in (mark.start, mark.start + mark.sweep)]
            return [*(side for at in ends for side in (at.real, at.imag)), mark.radius]
        case VectorMark():
            return [mark.start.real, mark.start.imag, mark.end.real, mark.end.imag]
        case PointMark(at=at) | Text(at=at):
            return [at.real, at.imag]
        case _:
            assert_never(mark)


def rows(frames: Sequence[Sequence[Mark]], leaps: bool = True) -> list[MarkTrack]:
    """The marks of all positions in their order of painting; `leaps`: the positions lie in a row, and are looked at."""
    return [row for marks in matched(frames, by_step=True) for row in _in_parts(_row(marks, leaps), leaps)]


def _row(marks: list[Mark | None], in_a_row: bool) -> MarkTrack:
    """The corners of a nameless stroke are counted from where they were before: its start may be drawn elsewhere."""
    first = next(mark for mark in marks if mark is not None)
    table = np.full((len(marks), len(numbers(first))), np.nan)
    before: Stroke | None = None
    for k, mark in enumerate(marks):
        if isinstance(mark, Stroke) and mark.shows is None and in_a_row:
            if before is not None and len(mark.places) <= 2 * _RIGID:
                mark = as_before(mark, before)
            before = mark
        if mark is not None:
            table[k] = numbers(mark)
    return MarkTrack(first, table)


def _in_parts(row: MarkTrack, leaps: bool) -> Iterator[MarkTrack]:
    row = _rigid(row)
    nameless = leaps and isinstance(row.mark, Stroke | Disc | ArcMark)
    cuts = [0, *(_leaps(row.numbers) if nameless else ()), len(row.numbers)]
    for first, last in pairwise(cuts):
        part = np.full_like(row.numbers, np.nan)
        part[first:last] = row.numbers[first:last]
        if not np.isnan(part[:, 0]).all():
            yield replace(row, numbers=part)


def _leaps(table: np.ndarray) -> list[int]:
    """The positions to which a row comes by a leap."""
    if len(table) < 4:
        return []
    steps = np.abs(np.diff(table, axis=0)).max(axis=1)
    around = np.nan_to_num(np.concatenate([[0.0], steps, [0.0]]))
    most = np.maximum(around[:-2], around[2:])
    return [int(k) + 1 for k in np.flatnonzero(steps > np.maximum(_LEAP * most, _LEAST))]


def _rigid(row: MarkTrack) -> MarkTrack:
    """A stroke of many corners by two of them, where it keeps its form."""
    if not isinstance(row.mark, Stroke) or len(row.mark.places) <= _RIGID:
        return row
    places = row.numbers[:, ::2] + 1j * row.numbers[:, 1::2]
    form = places[row.there][0]
    base = 0, int(np.argmax(abs(form - form[0])))
    length = form[base[1]] - form[0]
    if abs(length) < 1.0:
        return row
    turn = (places[:, base[1]] - places[:, 0]) / length
    off: Array = abs(places[:, :1] + turn[:, None] * (form - form[0]) - places)
    if np.nanmax(off) > _FORM:
        return row
    ends = places[:, [0, base[1]]]
    table = np.stack([ends[:, 0].real, ends[:, 0].imag, ends[:, 1].real, ends[:, 1].imag], axis=1)
    return replace(row, numbers=table, form=tuple(form.tolist()), base=base)
