"""The free room of a figure: what comes last stands where lines and labels have left room, else it is left out."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Sequence
from copy import copy
from dataclasses import field
from functools import cached_property
from itertools import accumulate
from typing import NamedTuple

import numpy as np

from graphkin.base.geometry import Array
from graphkin.base.value import frozen
from graphkin.sheet.boxes import OccupiedSquares
from graphkin.sheet.label_candidates import LabelScene
from graphkin.sheet.label_requests import LabelCandidates, LabelRequest
from graphkin.sheet.lettering import box
from graphkin.sheet.marks import ArcMark, Mark, Place, Stroke, Text
from graphkin.sheet.obstacles import Obstacles, bounds, obstacles, places

_CLEAR = 0.6  # the distance of what is added from everything there [mm]
_WORD = np.array((2.2, -0.6))
"""Letters beside others read as theirs when nearer; how far above or below they may be for that [mm]."""
_EDGE, _GRID = 2.0, 3.0
"""The distance of a rectangle from all others; the grid of the places that are tried for it [mm]."""
_SLICE = 1.0  # between places of a line, and of slices of turned letters [mm]
_STEPS = 0.5  # the steps in which a line is shortened [mm]


@frozen
class Annotations:
    """Marks beneath a figure and over it."""

    under: list[Mark] = field(default_factory=list)
    over: list[Mark] = field(default_factory=list)


class FreeSpots(NamedTuple):
    """Places of a label at what it names that were free at a time.

    half           of the width and height of its box [mm]
    marks, letters  how many there were then
    """

    middle: Array
    cost: Array
    half: complex
    marks: int
    letters: int


class FreeRoom:
    """A figure with its labels, and what has been added since."""

    def __init__(self, scene: LabelScene, labels: Sequence[Mark] = ()) -> None:
        self.room, self.marks, self._arrows = scene.room, [*scene.drawn, *labels], scene.arrows
        self._first, self._standing = len(self.marks), [scene.known, *([obstacles(labels)] if labels else [])]
        self._late: dict[int, Obstacles] = {}
        self._letters = _boxes([mark for mark in self.marks if isinstance(mark, Text)])

    def add(self, marks: Sequence[Mark]) -> None:
        """These lie on the paper now, too."""
        self.marks += marks
        self._late = {}
        for name in ("_occupied", "_signs"):
            vars(self).pop(name, None)
        self._letters = np.concatenate([self._letters, _boxes([mark for mark in marks if isinstance(mark, Text)])])

    def _added(self, first: int) -> list[Obstacles]:
        """Obstacles that came after so many marks, if any; made when they are asked for: much is added before."""
        if first < len(self.marks) and first not in self._late:
            self._late[first] = obstacles(self.marks[first:])
        return [self._late[first]] if first < len(self.marks) else []

    def free(self, low: Array, high: Array) -> Array:
        """True for those of many boxes (n, 2) that touch nothing and lie in the room."""
        return _clear(self._inside(low, high), low, high, [*self._standing, *self._added(self._first)])

    def reach(self, start: Place, along: complex, most: float) -> float:
        """The length of a line on from a place, without running into letters or out of the room [mm]."""
        steps, bad = self._along(start, along, most)
        return float(steps[np.argmax(bad)] - _STEPS) if bad.any() else most

    def pieces(self, start: Place, end: Place) -> list[tuple[Place, Place]]:
        """The pieces of a line that lie clear of letters."""
        length = abs(end - start)
        along = (end - start) / length
        steps, bad = self._along(start, along, length)
        turns = np.flatnonzero(np.diff(np.concatenate([[True], bad, [True]])))
        pieces: list[tuple[Place, Place]] = []
        for first, after in zip(turns[::2], turns[1::2], strict=True):
            low, high = float(steps[first]), float(steps[after - 1]) if after < len(steps) else length
            if high - low > _STEPS:
                pieces.append((start + along * low, start + along * high))
        return pieces

    def _along(self, start: Place, along: complex, most: float) -> tuple[Array, Array]:
        """Steps on from a place [mm], and whether there are letters, or no room."""
        steps, room, letters = np.arange(0.0, most + _STEPS / 2, _STEPS), self.room, self._letters
        xs, ys = start.real + along.real * steps, start.imag + along.imag * steps
        bad = (xs < room.left) | (xs > room.right) | (ys < room.top) | (ys > room.bottom)
        low, high = letters[:, 0, :, None] - _CLEAR, letters[:, 1, :, None] + _CLEAR
        within = (xs > low[:, 0]) & (xs < high[:, 0]) & (ys > low[:, 1]) & (ys < high[:, 1])
        return steps, bad | within.any(axis=0)

    @cached_property
    def _occupied(self) -> OccupiedSquares:
        """Squares that no free rectangle holds."""
        return OccupiedSquares(places(self.marks), _GRID)

    def spots(self, wanted: Sequence[LabelRequest], halves: Sequence[complex]) -> list[FreeSpots]:
        """The free places of many labels at what they name, all at once; half: of the size of each box [mm]."""
        if not wanted:
            return []
        near = [want.near(half) for want, half in zip(wanted, halves, strict=True)]
        ends = [0, *accumulate(len(each.cost) for each in near)]
        every, half = LabelCandidates.joined(near), np.repeat(halves, np.diff(ends))
        low, high = _corners(every.middle, half)
        free = self.free(low, high)
        free[free] = ~_beside(low[free], high[free], self._letters)
        owner = np.repeat(np.arange(len(wanted)), np.diff(ends))[free]
        free[free] = ~self._arrows.strange(wanted, owner, low[free], high[free])
        return [
            FreeSpots(each.middle[free[a:b]], each.cost[free[a:b]], half, len(self.marks), len(self._letters))
            for each, half, a, b in zip(near, halves, ends, ends[1:])
        ]

    def place(self, spots: FreeSpots) -> Place | None:
        """The middle of the best one that is still free; None where there is none without a leader."""
        low, high = _corners(spots.middle, np.asarray(spots.half))
        free = _clear(~_beside(low, high, self._letters[spots.letters :]), low, high, self._added(spots.marks))
        if not free.any():
            return None
        return complex(spots.middle[np.argmin(np.where(free, spots.cost, np.inf))])

    def corner(self, size: complex, from_below: bool = False) -> Place | None:
        """The upper left corner of the uppermost (or lowest) free rectangle of a size; None where there is none."""
        xs = np.arange(self.room.left + _EDGE, self.room.right - size.real - _EDGE, _GRID)
        ys = np.arange(self.room.top + _EDGE, self.room.bottom - size.imag - _EDGE, _GRID)
        if not (len(xs) and len(ys)):
            return None
        near, far = (xs - _EDGE, ys[:, None] - _EDGE), (xs + size.real + _EDGE, ys[:, None] + size.imag + _EDGE)
        rows, columns = np.nonzero(~self._occupied.within(near, far))
        low = np.stack([xs[columns], ys[rows]], axis=1)
        free = np.flatnonzero(self.free(low - _EDGE, low + np.array((size.real, size.imag)) + _EDGE))
        if not len(free):
            return None
        return complex(*low[free[np.argmax(low[free, 1])] if from_below else free[0]])

    def letters(self, wanted: Sequence[LabelRequest]) -> Iterator[list[Mark]]:
        """Each label where there is room for it, one after the other, else nothing."""
        for want, spots in zip(wanted, self.spots(wanted, [_half(want) for want in wanted]), strict=True):
            marks = _lettered(want, self.place(spots))
            self.add(marks)
            yield marks

    def first(self, groups: Sequence[tuple[Sequence[Mark], Sequence[Mark]]]) -> int | None:
        """The number of the first group of marks for which there is room: those of its first part touch nothing, those
        of its second no letters, arcs and arrow heads; None where there is none."""
        good = np.ones(len(groups), dtype=bool)
        for part in (0, 1):
            marks = [(k, mark) for k, group in enumerate(groups) for mark in group[part]]
            if not marks:
                continue
            covers = [(k, isinstance(mark, Text), *_cover(mark)) for k, mark in marks]
            owner = np.concatenate([np.full(len(low), k) for k, _, low, _ in covers])
            low, high = (np.concatenate(corners) for corners in list(zip(*covers, strict=True))[2:])
            if part:
                free = _clear(self._inside(low, high), low, high, [self._signs])
            else:
                free = self.free(low, high)
                letters = np.concatenate([np.full(len(low), text) for _, text, low, _ in covers])
                free[letters] &= ~_beside(low[letters], high[letters], self._letters)
            good[owner[~free]] = False
        return int(good.argmax()) if good.any() else None

    @cached_property
    def _signs(self) -> Obstacles:
        """Letters, arcs and arrow heads."""
        return obstacles(
            mark for mark in self.marks
            if isinstance(mark, Text | ArcMark) or (isinstance(mark, Stroke) and mark.fill == "ink")
        )  # fmt: skip

    def _inside(self, low: Array, high: Array) -> Array:
        """True for those of many boxes (n, 2) that lie in the room."""
        inside = (low >= (self.room.left, self.room.top)) & (high <= (self.room.right, self.room.bottom))
        return np.asarray(inside.all(axis=1))

    def letters_with(self, marks: Sequence[Mark], want: LabelRequest) -> list[Mark]:
        """A label where there would be room for it with some more marks, else nothing; nothing is added here."""
        (spots,) = self.spots([want], [_half(want)])
        other = copy(self)
        other.marks = [*self.marks]
        other.add(marks)
        return _lettered(want, other.place(spots))


def _half(want: LabelRequest) -> complex:
    """Of the width and height of a label's box [mm]."""
    wide, up, down = box(want.label, want.size)
    return complex(wide, up + down) / 2


def _lettered(want: LabelRequest, middle: Place | None) -> list[Mark]:
    """A label about a place; nothing without one."""
    wide, up, down = box(want.label, want.size)
    return [] if middle is None else [*want.texts(middle + complex(-wide / 2, (up - down) / 2))]


def _clear(free: Array, low: Array, high: Array, lying: Sequence[Obstacles]) -> Array:
    """True for those of the boxes so far free that keep off all that lies there."""
    for each in lying:
        rows = np.flatnonzero(free)
        free[rows[each.touched(low[rows] - _CLEAR, high[rows] + _CLEAR)]] = False
    return free


def _corners(middle: Array, half: Array) -> tuple[Array, Array]:
    """Lower and upper corner (n, 2) of boxes about places (n,)."""
    middle, size = np.stack([middle.real, middle.imag], axis=-1), np.stack([np.real(half), np.imag(half)], axis=-1)
    return middle - size, middle + size


def _beside(low: Array, high: Array, letters: Array) -> Array:
    """True for boxes (n, 2) on a line with letters and so near that they read as a part of them."""
    least, most = letters[:, 0] - _WORD, letters[:, 1] + _WORD
    beside = [(low[:, k, None] < most[:, k]) & (high[:, k, None] > least[:, k]) for k in range(2)]
    return np.asarray((beside[0] & beside[1]).any(axis=1))


def _boxes(texts: Sequence[Text]) -> Array:
    """Lower and upper corner of each text (n, 2, 2)."""
    return np.concatenate([np.zeros((0, 2, 2)), *(np.stack(_cover(text), axis=1) for text in texts)])


def _cover(mark: Mark) -> tuple[Array, Array]:
    """Boxes low..high (n, 2) that hold a mark: slices of letters where they are turned, places on a line."""
    if isinstance(mark, Text):
        if not mark.turn:
            left, top, right, bottom = bounds([mark])
            return np.array([[left, top]]), np.array([[right, bottom]])
        (wide, up, down), turn = box(mark.label, mark.size), cmath.rect(1, mark.turn)
        at = mark.at + turn * np.linspace(0.0, wide, int(wide / _SLICE) + 2)
        ends = np.stack([at - 1j * turn * up, at + 1j * turn * down])
        sides = np.stack([ends.real, ends.imag], axis=-1)
        return sides.min(axis=0), sides.max(axis=0)
    if isinstance(mark, Stroke) and len(mark.places) == 2:
        start, end = mark.places
        line = start + (end - start) * np.linspace(0.0, 1.0, int(abs(end - start) / _SLICE) + 2)
        on = np.stack([line.real, line.imag], axis=-1)
    else:
        on = places([mark], _SLICE).T
    return on, on
