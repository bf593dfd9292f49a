"""Labels find their places: none lies on a line, a vector or another label where there is room.

Each label has candidate places around its point or along its vector. All are held against everything drawn
at once (shapely's tree); then the label with the fewest free places left chooses first, and takes the one
nearest to what it names. The same marks give the same places. Where nothing near is free, a thin leader
goes to a place farther off.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from graphkin.sheet.lettering import Label, box
from graphkin.sheet.marks import Mark, Place, Stroke, Text
from graphkin.sheet.obstacles import tree
from graphkin.sheet.paper import LABEL
from graphkin.value import frozen

__all__ = ["Room", "Wanted", "settle"]

_CLEAR, _EASY = 0.45, 1.3
"""What a label keeps from lines at least, and likes to keep [mm]."""
_APART = 0.7
"""What two labels keep from each other [mm]."""
_RINGS = (0.0, 1.0, 2.2, 4.0, 6.5, 9.5, 13.0)
_LED = 4.0
"""From this ring on a leader is drawn."""
_TURNS = tuple(cmath.rect(1, math.tau * k / 16) for k in range(16))
_ALONG = (0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74, 0.18, 0.82)


@frozen
class Room:
    """A rectangle of the paper that labels must stay in [mm]."""

    left: float
    top: float
    right: float
    bottom: float


@frozen
class Wanted:
    """A label and what it names: a point (`start` only) or a line from start to end.

    gap   how far the symbol at the point, or the line's width, reaches [mm]
    away  the side it likes (any length; 0 for none)
    """

    label: Label
    start: Place
    end: Place | None = None
    gap: float = 0.75
    away: complex = 0j
    size: float = LABEL
    step: int | None = None


class _Spot(NamedTuple):
    """A candidate: the middle of the label's box, what it costs, and where a leader would go."""

    middle: Place
    cost: float
    anchor: Place | None


def settle(wanted: Sequence[Wanted], drawn: Sequence[Mark], room: Room) -> list[Mark]:
    """The labels (and their leaders) at their places among what is drawn."""
    if not wanted:
        return []
    table = _Table(wanted, drawn, room)
    chosen = table.choose()
    marks: list[Mark] = []
    for want, spot in zip(wanted, chosen, strict=True):
        wide, up, down = box(want.label, want.size)
        corner = spot.middle + complex(-wide / 2, (up - down) / 2)
        marks.append(Text(want.label, corner, want.size, want.step))
        if spot.anchor is not None:
            marks.append(_leader(spot, complex(wide, up + down) / 2, want))
    return marks


def _leader(spot: _Spot, half: complex, want: Wanted) -> Mark:
    """A thin line from the near side of a label's box to what it names."""
    assert spot.anchor is not None
    off = spot.anchor - spot.middle
    edge = complex(max(-half.real, min(half.real, off.real)), max(-half.imag, min(half.imag, off.imag)))
    way = off - edge
    begin = spot.middle + edge + way / abs(way) * 0.5 if abs(way) > 1 else spot.middle + edge
    return Stroke((begin, spot.anchor), "leader", step=want.step)


# --- candidates -------------------------------------------------------------------------------


def _spots(want: Wanted, half: complex) -> Iterator[_Spot]:
    if want.end is not None and abs(want.end - want.start) > 1.5:
        yield from _beside(want.start, want.end, half, want)
        yield from _around((want.start + want.end) / 2, half, want, first=3)
    else:
        yield from _around(want.start, half, want)


def _around(point: Place, half: complex, want: Wanted, first: int = 0) -> Iterator[_Spot]:
    """Rings about a point; a box touches the ring with its near side or corner."""
    away = want.away.conjugate() / abs(want.away) if want.away else 0j
    likings = [0.8 * (1 - (turn * away).real) if away else 0.05 * ((k - 14) % 16) for k, turn in enumerate(_TURNS)]
    sides = [complex(_held(turn.real) * half.real, _held(turn.imag) * half.imag) for turn in _TURNS]
    for ring in _RINGS[first:]:
        reach = want.gap + 0.6 + ring
        price, anchor = (1.6 * ring + 6, point) if ring >= _LED else (1.6 * ring, None)
        for turn, side, liking in zip(_TURNS, sides, likings):
            yield _Spot(point + reach * turn + side, price + liking, anchor)


def _held(x: float) -> float:
    """Cosine or sine of a direction, so that four of eight directions put the box's corners to the ring."""
    return max(-1.0, min(1.0, x * 1.6))


def _beside(start: Place, end: Place, half: complex, want: Wanted) -> Iterator[_Spot]:
    """Both sides of a line, at several places along it."""
    along = (end - start) / abs(end - start)
    away = want.away / abs(want.away) if want.away else 0j
    for normal in (along * -1j, along * 1j):
        support = abs(normal.real) * half.real + abs(normal.imag) * half.imag
        liking = 0.6 * (1 - (normal * away.conjugate()).real) if away else (0.0 if normal.imag <= 0 else 0.1)
        for more in (0.0, 0.75, 1.65):
            for t in _ALONG:
                middle = start + (end - start) * t + normal * (support + want.gap + more)
                yield _Spot(middle, 1.2 * more + 2.5 * abs(t - 0.5) + liking, None)


# --- the choice -------------------------------------------------------------------------------


class _Table:
    """All candidates of all labels, row by row."""

    def __init__(self, wanted: Sequence[Wanted], drawn: Sequence[Mark], room: Room) -> None:
        self.spots: list[_Spot] = []
        owners: list[int] = []
        sizes: list[tuple[float, float]] = []
        for k, want in enumerate(wanted):
            wide, up, down = box(want.label, want.size)
            found = list(_spots(want, complex(wide, up + down) / 2))
            self.spots += found
            owners += [k] * len(found)
            sizes += [(wide / 2, (up + down) / 2)] * len(found)
        self.owner = np.array(owners)
        middle = np.array([(spot.middle.real, spot.middle.imag) for spot in self.spots])
        half = np.array(sizes)
        self.low, self.high = middle - half, middle + half
        anchors = [spot.middle if spot.anchor is None else spot.anchor for spot in self.spots]
        self.middle, self.anchor = middle, np.array([(anchor.real, anchor.imag) for anchor in anchors])
        self.led = np.array([spot.anchor is not None for spot in self.spots])
        self.cost = np.array([spot.cost for spot in self.spots])
        self.free = self._judge(drawn, room)

    def _judge(self, drawn: Sequence[Mark], room: Room) -> Any:
        """Which candidates touch nothing drawn; near misses and bad places are written into the cost."""
        known = tree(drawn)
        hits = np.bincount(known.touched(self.low - _CLEAR, self.high + _CLEAR), minlength=len(self.spots))
        near = np.bincount(known.touched(self.low - _EASY, self.high + _EASY), minlength=len(self.spots))
        self.cost += 0.45 * np.minimum(near, 6) + 60.0 * np.minimum(hits, 5)
        inside = np.all(self.low >= (room.left, room.top), axis=1)
        inside &= np.all(self.high <= (room.right, room.bottom), axis=1)
        self.cost[~inside] += 1000.0
        return (hits == 0) & inside

    def choose(self) -> list[_Spot]:
        """Greedy: who has the least freedom first."""
        count = int(self.owner.max()) + 1
        chosen: dict[int, _Spot] = {}
        while len(chosen) < count:
            left = np.bincount(self.owner[self.free], minlength=count)
            best = self._best(count)
            label = min((k for k in range(count) if k not in chosen), key=lambda k: (left[k], -best[k], k))
            rows = np.flatnonzero(self.owner == label)
            row = int(rows[np.argmin(self.cost[rows])])
            chosen[label] = self.spots[row]
            self._take(row)
        return [chosen[k] for k in range(count)]

    def _best(self, count: int) -> Any:
        """The cost of each label's best place."""
        best = np.full(count, np.inf)
        np.minimum.at(best, self.owner, self.cost)
        return best

    def _take(self, row: int) -> None:
        """A label lies here now: places over it are bad ones."""
        clash = np.all(self.low < self.high[row] + _APART, axis=1)
        clash &= np.all(self.high > self.low[row] - _APART, axis=1)
        self.cost[clash] += 80.0
        crossed = self.led & _cross(self.middle, self.anchor, self.low[row], self.high[row])
        if self.led[row]:
            crossed |= _cross(self.middle[row], self.anchor[row], self.low, self.high)
        self.cost[crossed] += 25.0
        self.free &= ~(clash | crossed)


def _cross(start: Any, end: Any, low: Any, high: Any) -> Any:
    """Whether lines start..end pass through boxes low..high, one against many or many against one (by slabs)."""
    way = end - start
    way = np.where(np.abs(way) < 1e-9, 1e-9, way)
    first, second = (low - start) / way, (high - start) / way
    enter = np.minimum(first, second).max(axis=-1)
    leave = np.maximum(first, second).min(axis=-1)
    return np.maximum(enter, 0.0) <= np.minimum(leave, 1.0)
