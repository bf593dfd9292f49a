"""The free room of a figure: what comes last stands where lines and labels have left room, else it is left out."""

from __future__ import annotations

import cmath
from collections.abc import Callable, Iterable, Iterator, Sequence
from copy import copy
from functools import cached_property
from itertools import accumulate, count, islice, pairwise, product
from math import ceil
from typing import TypeVar

import numpy as np

from graphkin.base.boxes import overlap, xy
from graphkin.base.geometry import Array
from graphkin.base.rooms import Room
from graphkin.base.segments import Segments
from graphkin.sheet.label_candidates import LabelScene
from graphkin.sheet.label_requests import SIGN, LabelCandidates, LabelRequest
from graphkin.sheet.lettering import box
from graphkin.sheet.marks import ArcMark, Mark, Place, Stroke, Text
from graphkin.sheet.obstacles import bounds, obstacles, places

_CLEAR = 0.6  # the distance of what is added from everything there [mm]
_OFF = 0.65  # the distance of a number from the name to which it belongs [mm]
_WORD = np.array((2.2, -0.6))
"""Letters beside others read as theirs when nearer; how far above or below they may be for that [mm]."""
_EDGE, _GRID = 2.0, 2.0
"""The distance of a rectangle from all others; the grid of the places that are tried for it [mm]."""
_SLICE = 1.0  # between places of a line, and of slices of turned letters [mm]
_STEPS = 0.5  # the steps in which a line is shortened [mm]
_CRUMB = 2.0  # shorter pieces of a line that letters break are left out [mm]
_AT_ONCE = 4  # ways that are tried together; then twice as many, and so on
_Way = TypeVar("_Way")


class FreeRoom:
    """A figure with its labels, and what has been added since."""

    def __init__(self, scene: LabelScene, labels: Sequence[Mark] = ()) -> None:
        self._scene, self.room, self.marks = scene, scene.room, [*scene.drawn, *scene.rows]
        self.wanted, self.gone = scene.wanted, list[Text]()
        self._lying, self._new, self._letters = scene.known, list[Mark](), _boxes(self.marks, scene.taken)
        self.add(labels)

    def add(self, marks: Sequence[Mark]) -> None:
        """These lie on the paper now, too."""
        self.marks += marks
        self._new += marks
        for name in ("_sums", "_signs"):
            vars(self).pop(name, None)
        self._letters = np.concatenate([self._letters, _boxes(marks)])

    def _clear(self, free: Array, low: Array, high: Array, lying: Segments | None = None) -> Array:
        """True for those of the boxes so far free that keep off all that lies there, and was added before."""
        if (rows := np.flatnonzero(free)).size:
            if lying is None and self._new:
                self._lying, self._new = self._lying + obstacles(self._new), []
            free[rows] = ~(lying or self._lying).touched(low[rows].T - _CLEAR, high[rows].T + _CLEAR)
        return free

    def free(self, low: Array, high: Array) -> Array:
        """True for those of many boxes (n, 2) that touch nothing and lie in the room."""
        return self._clear(self._scene.inside(low.T, high.T), low, high)

    def reach(self, start: Place, along: complex, most: float) -> float:
        """The length of a line on from a place, without running into letters or out of the room [mm]."""
        first = next(iter(self.pieces(start, start + along * most)), None) if most > _STEPS else None
        return abs(first[1] - start) if first is not None and first[0] == start else 0.0

    def on_line(self, start: Place, end: Place) -> bool:
        """True for a line that lies on an arrow, or on the side of an image."""
        return bool(self._scene.arrows.hold(LabelRequest((), start, 2 * end - start)).any())

    def pieces(self, start: Place, end: Place) -> list[tuple[Place, Place]]:
        """The pieces of a line that lie clear of letters and in the room."""
        length = abs(end - start) or 1.0  # of none there is no piece
        along, steps = (end - start) / length, np.arange(0.0, length + _STEPS / 2, _STEPS)
        at, letters = xy(start + along * steps)[:, None], self._letters.transpose(2, 0, 1)[..., None]
        bad = overlap(letters[:, :, 0] - _CLEAR, letters[:, :, 1] + _CLEAR, at, at).any(axis=0)
        bad |= ~self._scene.inside(at[:, 0], at[:, 0])
        turns = np.flatnonzero(np.diff(np.concatenate([[True], bad, [True]])))
        ends = ((float(steps[first]), float(steps[after - 1]) if after < len(steps) else length)
                for first, after in zip(turns[::2], turns[1::2], strict=True))  # fmt: skip
        return [(start + along * low, start + along * high) for low, high in ends if high - low > _CRUMB]

    @cached_property
    def _sums(self) -> Array:
        """Numbers of marks above and to the left of each corner of a grid's squares."""
        room, ((x, y), _) = self.room, places(self.marks)
        edges = [np.arange(low, high + 1e-9, _GRID) for low, high in ((room.top, room.bottom), (room.left, room.right))]
        return np.pad(np.histogram2d(y, x, edges)[0].cumsum(axis=0).cumsum(axis=1), ((1, 0), (1, 0)))

    def places(
        self, wanted: Sequence[LabelRequest], halves: Sequence[complex], wide: bool = False
    ) -> Iterator[Place | None]:
        """The best free middle of each of many labels at what it names, wide: or a little farther off, one after the
        other, among what was added meanwhile; None where there is none. halves: of the size of each box [mm]."""
        if not wanted:
            return
        near = [want.near(half, wide) for want, half in zip(wanted, halves, strict=True)]
        ends = [0, *accumulate(len(each.cost) for each in near)]
        every, half = LabelCandidates.joined(near), np.repeat(halves, np.diff(ends))
        middle, size = xy(every.middle).T, xy(half).T
        low, high = middle - size, middle + size
        free = self.free(low, high)
        free[free] = ~_beside(low[free], high[free], self._letters)
        owner = np.repeat(np.arange(len(wanted)), np.diff(ends))[free]
        free[free] = ~self._scene.arrows.strange(wanted, owner, low[free], high[free])
        marks, letters = len(self.marks), len(self._letters)
        for own in (slice(*pair) for pair in pairwise(ends)):
            left = free[own] & ~_beside(low[own], high[own], self._letters[letters:])
            if len(self.marks) > marks:
                left = self._clear(left, low[own], high[own])
            cost = np.where(left, every.cost[own], np.inf)
            yield complex(every.middle[own][cost.argmin()]) if left.any() else None

    def beside(self, site: LabelRequest, half: complex) -> Place | None:
        """The first free middle of a box beside the letters of the label at the same place, near no others, if any."""
        for want in (want for want in self.wanted if want.of == site.of and want.start == site.start):
            names = [label for label, _ in want.parts] or [want.label]
            texts = [mark for mark in self.marks[len(self._scene.drawn) :] if isinstance(mark, Text)]
            near = sorted((text for text in texts if text.label in names), key=lambda text: abs(text.at - want.place))
            if want.gap < SIGN and near:
                return self.next_to(near[: len(names)], half)
        return None

    def next_to(self, marks: Sequence[Mark], half: complex) -> Place | None:
        """The first free middle of a box beside marks, near no letters but theirs, if any is."""
        first, last = np.array(bounds(marks)).reshape(2, 2, 1)
        wide, high = (last - first)[:, 0] / 2 + (half.real + _OFF, half.imag + _OFF)
        aside = abs((last - first)[0, 0] / 2 - half.real)  # in line with an end of them
        off = [side + x for side in (1j * high, -1j * high) for x in (0, aside, -aside)]
        at = complex(*(first + last)[:, 0]) / 2 + np.array([wide, -wide, *off])
        low, most = xy(at - half).T, xy(at + half).T
        own = overlap(self._letters[:, 0].T, self._letters[:, 1].T, first, last)
        free = self.free(low, most) & ~_beside(low, most, self._letters[~own])
        return complex(at[free.argmax()]) if free.any() else None

    def corner(self, size: complex, from_below: bool = False) -> Place | None:
        """The upper left corner of the uppermost (or lowest) free rectangle and more beside it; None where none is."""
        wide, high = ceil((size.real + 2 * _EDGE) / _GRID) + 2, ceil((size.imag + 2 * _EDGE) / _GRID)
        sums = np.pad(self._sums, ((0, 0), (1, 1)), "edge")
        held = sums[high:, wide:] - sums[:-high, wide:] - sums[high:, :-wide] + sums[:-high, :-wide]
        rows, columns = np.nonzero(held == 0)
        if not len(rows):
            return None
        first = np.flatnonzero(rows == rows[-1 if from_below else 0])[0]
        return complex(self.room.left, self.room.top) + complex(columns[first], rows[first]) * _GRID + _EDGE * (1 + 1j)

    def letters(self, wanted: Sequence[LabelRequest]) -> Iterator[list[Mark]]:
        """Each label where there is room for it, one after the other, else nothing."""
        for want, middle in zip(wanted, self.places(wanted, [want.half for want in wanted]), strict=True):
            marks: list[Mark] = [] if middle is None else [*want.about(middle)]
            self.add(marks)
            yield marks

    def fitting(self, ways: Iterable[_Way], marks: Callable[[_Way], Sequence[Sequence[Mark]]]) -> Iterator[_Way]:
        """Those of many ways for whose marks there is room: of their parts these touch nothing, of the last no letters,
        arcs and arrow heads. More and more are tried together."""
        every, lots = iter(ways), count(_AT_ONCE, _AT_ONCE)
        while some := [*islice(every, next(lots))]:
            yield from (some[number] for number in self._fitting([marks(way) for way in some]))

    def _fitting(self, groups: Sequence[Sequence[Sequence[Mark]]]) -> list[int]:
        """The numbers of the groups of marks for which there is room."""
        good, last = [*range(len(groups))], len(groups[0]) - 1
        for part, letters in product(range(last + 1), (True, False)):  # few are left when lines are held against all
            every = [(k, mark) for k in good for mark in groups[k][part] if isinstance(mark, Text) == letters]
            if not every:
                continue
            marks = [mark for _, mark in every]
            if letters:
                covers = [_cover(mark) for mark in marks if isinstance(mark, Text)]
                low, high = np.concatenate(covers).swapaxes(0, 1)
                number = np.repeat(np.arange(len(marks)), [len(each) for each in covers])
                free = self.free(low, high) & ~_beside(low, high, self._letters)
            else:
                at, number = places(marks, _SLICE)
                free = self._clear(self._scene.inside(at, at), at.T, at.T, self._signs if part == last else None)
            bad = {every[k][0] for k in number[~free].tolist()}
            good = [k for k in good if k not in bad]
        return good

    @cached_property
    def _signs(self) -> Segments:
        """Letters, arcs and arrow heads."""
        heads = (mark for mark in self.marks if isinstance(mark, Stroke) and mark.fill == "ink")
        letters = (mark for mark in self.marks if isinstance(mark, Text | ArcMark))
        return obstacles([*self._scene.rows, *letters, *heads])

    def without(self, text: Text) -> FreeRoom:
        """The room that would be left if letters made way; they stay here."""
        first = len(self._scene.drawn) + len(self._scene.rows)
        return FreeRoom(self._scene, [mark for mark in self.marks[first:] if mark is not text])

    def leave_out(self, text: Text) -> None:
        """Letters make way for what comes after them."""
        gone, left = [*self.gone, text], self.without(text)
        vars(self).clear()
        vars(self).update(vars(left), gone=gone)

    def also(self, marks: Sequence[Mark]) -> FreeRoom:
        """The room that would be left with some more marks; nothing is added here."""
        other = copy(self)
        other.marks, other._new = [*self.marks], [*self._new]
        other.add(marks)
        return other


def _beside(low: Array, high: Array, letters: Array) -> Array:
    """True for boxes (n, 2) on a line with letters and so near that they read as a part of them."""
    least, most = letters[:, 0] - _WORD, letters[:, 1] + _WORD
    return np.asarray(overlap(low.T[..., None], high.T[..., None], least.T[:, None], most.T[:, None]).any(axis=1))


def _boxes(marks: Sequence[Mark], taken: Sequence[Room] = ()) -> Array:
    """Lower and upper corner of each text among marks, and of rooms of others (n, 2, 2)."""
    rooms = np.array([(room.left, room.top, room.right, room.bottom) for room in taken]).reshape(-1, 2, 2)
    return np.concatenate([rooms, *(_cover(mark) for mark in marks if isinstance(mark, Text))])


def _cover(text: Text) -> Array:
    """Lower and upper corner of boxes that hold letters (n, 2, 2): slices of them where they are turned."""
    (wide, up, down), turn, (x, y) = box(text.label, text.size), cmath.rect(1, text.turn), (text.at.real, text.at.imag)
    if not text.turn:
        return np.array([[[x, y - up], [x + wide, y + down]]])
    at = text.at + turn * np.linspace(0.0, wide, int(wide / _SLICE) + 2)
    ends = np.array([xy(at - 1j * turn * up), xy(at + 1j * turn * down)])
    return np.array([ends.min(axis=0), ends.max(axis=0)]).transpose(2, 0, 1)
