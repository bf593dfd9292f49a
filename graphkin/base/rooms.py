"""Rectangles and circles: rooms of a drawing, and what holds places."""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

from graphkin.base.geometry import Array
from graphkin.base.value import frozen

RIM = 0.05  # nearer than this to the rim of a circle is still in it [mm]


@frozen
class Room:
    """A rectangle [mm, y down]."""

    left: float
    top: float
    right: float
    bottom: float

    @property
    def size(self) -> complex:
        """Width and height."""
        return complex(self.right - self.left, self.bottom - self.top)

    @property
    def middle(self) -> complex:
        return complex(self.left + self.right, self.top + self.bottom) / 2

    @property
    def corners(self) -> tuple[complex, complex, complex, complex]:
        low, high = complex(self.left, self.top), complex(self.right, self.bottom)
        return low, complex(high.real, low.imag), high, complex(low.real, high.imag)

    def inset(self, sides: float, top: float, foot: float) -> Room:
        """The same without a margin at each side, at the top and at the foot."""
        return Room(self.left + sides, self.top + top, self.right - sides, self.bottom - foot)

    def meander(self, step: float) -> tuple[complex, ...]:
        """A line to and fro through all of it, no farther apart."""
        rows = np.linspace(self.top, self.bottom, int((self.bottom - self.top) / step) + 2)
        sides = np.resize([self.left, self.right, self.right, self.left], 2 * len(rows))
        return tuple((sides + 1j * np.repeat(rows, 2)).tolist())

    def holds(self, place: complex) -> bool:
        return self.left <= place.real <= self.right and self.top <= place.imag <= self.bottom

    def cells(self, count: int, columns: int) -> list[Room]:
        """Equal cells, row by row."""
        wide, high = self.size.real / columns, self.size.imag / -(-count // columns)
        corners = ((self.left + k % columns * wide, self.top + k // columns * high) for k in range(count))
        return [Room(left, top, left + wide, top + high) for left, top in corners]

    def shared(self, needs: Sequence[Sequence[complex]]) -> list[Room]:
        """Cells row by row, each as large as it needs [mm] and a like part of what is left; none where they do not
        fit."""
        highs = [max(need.imag for need in row) for row in needs]
        spares = [(self.size.real - sum(need.real for need in row)) / len(row) for row in needs]
        spare, cells, top = (self.size.imag - sum(highs)) / len(needs), list[Room](), self.top
        for row, high, more in zip(needs, highs, spares, strict=True):
            left, low = self.left, top + high + spare
            for need in row:
                cells.append(Room(left, top, left := left + need.real + more, low))
            top = low
        return cells if min(spare, *spares) >= 0 else []


def parted(rooms: Array, share: Array, axis: int) -> tuple[Array, Array]:
    """Two parts of each of many rooms (4, n) beside each other (0) or one above the other (1)."""
    one, other = rooms.copy(), rooms.copy()
    one[2 + axis] = other[axis] = rooms[axis] + share * (rooms[2 + axis] - rooms[axis])
    return one, other


def corners(places: Sequence[complex]) -> tuple[complex, complex]:
    """Lower left and upper right corner of what holds all these places."""
    xs, ys = [v.real for v in places] or [0.0], [v.imag for v in places] or [0.0]
    return complex(min(xs), min(ys)), complex(max(xs), max(ys))


def enlarged(places: Sequence[complex], more: Iterable[complex], factor: float) -> list[complex]:
    """The places, and of more, in their order, those that leave the figure at most `factor` times as large."""
    every, (low, high) = list(places), corners(places)
    most = factor * (abs(high - low) or 1.0)
    for place in more:
        low, high = corners([*every, place])
        if cmath.isfinite(place) and abs(high - low) <= most:
            every.append(place)
    return every


class RoundRoom(NamedTuple):
    """A circle that holds what lies in it, or on its rim as near as matters [mm]."""

    centre: complex
    radius: float

    @classmethod
    def about(cls, places: Sequence[complex], larger: float, least: float) -> RoundRoom:
        """One that is so many times as large as what holds some places, and no smaller than the least."""
        low, high = corners(places)
        middle = (low + high) / 2
        return cls(middle, max(least, larger * max(abs(place - middle) for place in places)))

    def holds(self, *places: complex) -> bool:
        return all(abs(place - self.centre) <= self.radius + RIM for place in places)

    def piece(self, start: complex, end: complex) -> tuple[complex, complex] | None:
        """The piece of a line that lies in it."""
        along = end - start
        if abs(along) < 1e-9:
            return None
        foot = ((self.centre - start) / along).real
        aside = abs(start + foot * along - self.centre)
        if aside >= self.radius:
            return None
        half = (self.radius**2 - aside**2) ** 0.5 / abs(along)
        first, last = max(0.0, foot - half), min(1.0, foot + half)
        return (start + first * along, start + last * along) if first < last else None
