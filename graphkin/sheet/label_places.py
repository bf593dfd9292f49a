"""All the places that the labels of a figure might take, what each costs, and which of them the labels do take."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from graphkin.sheet.lettering import box
from graphkin.sheet.nearness import Arrows
from graphkin.sheet.obstacles import Tree
from graphkin.sheet.paper import Room
from graphkin.sheet.wanted import Candidates, Wanted
from graphkin.value import filled

_CLEAR, _EASY = 0.45, 1.3
"""What a label keeps from lines at least, and likes to keep [mm]."""
_PASSING = 0.4
"""What a leader keeps from other labels [mm]."""
_TOUCH = 0.05
"""Closer than this to a box's edge is not yet on it [mm]."""
_ROUNDS = 8
"""How often labels of a crowd may make way for one another."""


class _Prices(NamedTuple):
    """What it costs to lie on a line, on a label, out of the room, nearer to another arrow than to its own without a
    leader; a leader on a label, on a leader.

    apart   what two labels keep from each other [mm]
    beside  for a leader that ends beside another's end
    word    for a label that stands on a line with another, and so close that both read as one
    """

    line: float = 60.0
    label: float = 80.0
    outside: float = 1000.0
    strange: float = 50.0
    crossed: float = 25.0
    leaders: float = 0.0
    apart: float = 0.7
    beside: float = 4.0
    word: float = 5.0


_NEAR, _CROWD = _Prices(), _Prices(400.0, 4000.0, 20000.0, 350.0, 900.0, 5.0, 1.3)
_ONE, _BESIDE = 0.5, 2.5
"""Leaders that end nearer together than the second look like one; than the first, they end at one place [mm]."""
_WORD = np.array((2.2, -1.2))
"""How far apart labels side by side read as two; how far up or down of it they are no line [mm]."""
_THROUGH = 1.5
"""What a far leader pays for each line it crosses."""


@filled
class Table:
    """All candidates of all labels, row by row: those in the room, where a label has such.

    far        whether places far off are among them
    owner      which label each is of; candidates: the same as they were made; inside: which lie in the room
    low, high  corners of its box; begin, anchor: ends of its leader, where it is `led`: columns x, y (n, 2) [mm]
    cost       of each, as long as no label has a place; free: whether it touches nothing then
    """

    wanted: list[Wanted]
    known: Tree
    prices: _Prices
    far: bool
    owner: Any
    candidates: Candidates
    inside: Any
    low: Any
    high: Any
    begin: Any
    anchor: Any
    led: Any
    cost: Any
    free: Any

    @classmethod
    def of(
        cls, wanted: Sequence[Wanted], known: Tree, letters: Tree, arrows: Arrows, room: Room, far: bool = False
    ) -> Table:  # fmt: skip
        """With what they cost beside what is drawn, of which the letters let no leader through."""
        prices = _CROWD if far else _NEAR
        owner, spots, half = _spots(wanted, far)
        inside = _inside(spots.middle, half[owner], room)
        rows = np.flatnonzero(inside | ~np.isin(owner, owner[inside]))
        owner, inside, spots = owner[rows], inside[rows], spots.taken(rows)
        low, high = _columns(spots.middle - half[owner]), _columns(spots.middle + half[owner])
        led = spots.led
        anchor = _columns(np.where(led, spots.anchor, spots.middle))
        begin = np.clip(anchor, low, high)
        near, hits = _touching(known, low, high)
        strange, unled = np.zeros(len(rows), dtype=bool), np.flatnonzero(~led)
        strange[unled] = arrows.strange(wanted, owner[unled], low[unled], high[unled])
        cost = spots.cost + prices.strange * strange + 0.45 * np.minimum(near, 6) + prices.line * np.minimum(hits, 5)
        cost[~inside] += prices.outside
        leaders = np.flatnonzero(led)
        cost[leaders[letters.crossed(begin[leaders], anchor[leaders])]] += prices.crossed
        if far:
            lines = known.crossed(begin[leaders], anchor[leaders])
            cost[leaders] += _THROUGH * np.bincount(lines, minlength=len(leaders))
        free = (hits == 0) & inside & ~strange
        return cls([*wanted], known, prices, far, owner, spots, inside, low, high, begin, anchor, led, cost, free)

    def without(self, out: Collection[int]) -> Table:
        """The same without some labels, before any has a place."""
        kept = [k for k in range(len(self.wanted)) if k not in out]
        rows = np.flatnonzero(np.isin(self.owner, kept))
        owner, spots = np.searchsorted(kept, self.owner[rows]), self.candidates.taken(rows)
        others = (self.inside, self.low, self.high, self.begin, self.anchor, self.led, self.cost, self.free)
        wanted = [self.wanted[k] for k in kept]
        return Table(wanted, self.known, self.prices, self.far, owner, spots, *(each[rows] for each in others))

    def chosen(self) -> list[int]:
        """The row each label takes; in a crowd they make way for one another."""
        choice = _Choice(self, self.cost.copy(), self.free.copy())
        found = choice.greedy()
        return choice.mended(found) if self.far else found

    def against(self, row: int, rows: Any = slice(None)) -> tuple[Any, Any]:
        """Candidates (of some rows) that lie on the one in this row; those whose leader does, or on its leader."""
        low, high, apart = self.low[rows], self.high[rows], self.prices.apart
        clash = _overlap(low, high, self.low[row] - apart, self.high[row] + apart)
        begin, anchor, crossed = self.begin[rows], self.anchor[rows], np.zeros(len(low), dtype=bool)
        nearest, farthest = self.low[row] - _PASSING, self.high[row] + _PASSING
        maybe = np.flatnonzero(self.led[rows] & self._reaching(rows, nearest, farthest))
        crossed[maybe] = _cross(begin[maybe], anchor[maybe], nearest, farthest)
        if self.led[row]:
            maybe = np.flatnonzero(_overlap(low, high, self.least[row] - _PASSING, self.most[row] + _PASSING))
            crossed[maybe] |= _cross(self.begin[row], self.anchor[row], low[maybe] - _PASSING, high[maybe] + _PASSING)
        return clash, crossed

    def burden(self, row: int, rows: Any, clash: Any, crossed: Any) -> Any:
        """What the candidates cost more because a label lies in this row."""
        more = self.prices.label * clash + self.prices.crossed * crossed
        low, high = self.low[row] - _WORD, self.high[row] + _WORD
        more += self.prices.word * _overlap(self.low[rows], self.high[rows], low, high)
        if self.prices.leaders and self.led[row]:
            maybe = np.flatnonzero(self.led[rows] & self._reaching(rows, self.least[row], self.most[row]))
            meeting = _meet(self.begin[rows][maybe], self.anchor[rows][maybe], self.begin[row], self.anchor[row])
            more[maybe[meeting]] += self.prices.leaders
        if self.led[row]:
            apart = np.abs(self.anchor[rows] - self.anchor[row]).max(axis=1)
            more += self.prices.beside * (self.led[rows] & (apart > _ONE) & (apart < _BESIDE))
        return more

    def _reaching(self, rows: Any, low: Any, high: Any) -> Any:
        """Whose leaders have surroundings that overlap a box."""
        return _overlap(self.least[rows], self.most[rows], low, high)

    @cached_property
    def least(self) -> Any:
        """Lower corners of what leaders lie in (n, 2)."""
        return np.minimum(self.begin, self.anchor)

    @cached_property
    def most(self) -> Any:
        """Upper corners of what leaders lie in (n, 2)."""
        return np.maximum(self.begin, self.anchor)

    def clashing(self, chosen: Sequence[int]) -> list[int]:
        """Labels that lie on another or on something drawn, out of their room, or under a leader."""
        rows = np.array(chosen)
        low, high = self.low[rows], self.high[rows]
        bad = ~self.inside[rows]
        bad[self.known.touched(low + _TOUCH, high - _TOUCH)] = True
        over = np.all(low[:, None] < high[None] - _TOUCH, axis=-1) & np.all(high[:, None] > low[None] + _TOUCH, axis=-1)
        begin, anchor = self.begin[rows][:, None], self.anchor[rows][:, None]
        over |= self.led[rows][:, None] & _cross(begin, anchor, low[None], high[None])
        np.fill_diagonal(over, False)
        bad |= over.any(axis=0) | over.any(axis=1)
        return [int(k) for k in np.flatnonzero(bad)]


@filled
class _Choice:
    """Labels taking their places: what each candidate costs now, and whether it touches nothing."""

    table: Table
    cost: Any
    free: Any

    def greedy(self) -> list[int]:
        """Who has the least freedom takes its best place first. The row each label takes."""
        owner = self.table.owner
        count = len(self.table.wanted)
        first = np.searchsorted(owner, np.arange(count + 1))
        chosen, waiting = np.empty(count, dtype=np.intp), np.arange(count)
        while len(waiting):
            left = np.bincount(owner[self.free], minlength=count)[waiting]
            best = np.minimum.reduceat(self.cost, first[:-1])[waiting]
            next_ = int(np.lexsort((-best, left))[0])
            label = waiting[next_]
            row = first[label] + int(np.argmin(self.cost[first[label] : first[label + 1]]))
            chosen[label] = row
            waiting = np.delete(waiting, next_)
            self._take(int(row))
        return [int(row) for row in chosen]

    def _take(self, row: int) -> None:
        """A label lies here now: places over it are bad ones."""
        clash, crossed = self.table.against(row)
        self.cost += self.table.burden(row, slice(None), clash, crossed)
        self.free &= ~(clash | crossed)

    def mended(self, chosen: list[int]) -> list[int]:
        """Each label once more takes its best place among all others, until none moves."""
        table, chosen, every = self.table, list(chosen), slice(None)
        own = [np.flatnonzero(table.owner == label) for label in range(len(chosen))]
        for _ in range(_ROUNDS):
            before = list(chosen)
            for label, row in enumerate(before):
                rows = own[label]
                cost = self.cost[rows] - table.burden(row, rows, *table.against(row, rows))
                best = int(np.argmin(cost))
                if cost[best] < cost[row - rows[0]] - 1e-6:
                    chosen[label] = int(rows[best])
                    self.cost -= table.burden(row, every, *table.against(row))
                    self.cost += table.burden(chosen[label], every, *table.against(chosen[label]))
            if chosen == before:
                break
        return chosen


def _spots(wanted: Sequence[Wanted], far: bool) -> tuple[Any, Candidates, Any]:
    """Whose each candidate is; all of them; half the width and height of each label's box, complex [mm]."""
    places = [want.place for want in wanted]
    crowd = complex(_middle([place.real for place in places]), _middle([place.imag for place in places]))
    boxes = [box(want.label, want.size) for want in wanted]
    halves = [complex(wide, up + down) / 2 for wide, up, down in boxes]
    found = [want.candidates(half) for want, half in zip(wanted, halves)]
    if far:
        more = (want.far_candidates(half, crowd) for want, half in zip(wanted, halves))
        found = [Candidates.joined(both) for both in zip(found, more)]
    owner = np.repeat(np.arange(len(wanted)), [len(each.cost) for each in found])
    return owner, Candidates.joined(found), np.array(halves)


def _touching(known: Tree, low: Any, high: Any) -> tuple[Any, Any]:
    """How much of what is drawn is too near to each box, and on how much it lies."""
    near = np.bincount(known.touched(low - _EASY, high + _EASY), minlength=len(low))
    maybe = np.flatnonzero(near)
    rows = maybe[known.touched(low[maybe] - _CLEAR, high[maybe] + _CLEAR)]
    return near, np.bincount(rows, minlength=len(low))


def _inside(middle: Any, half: Any, room: Room) -> Any:
    """Which boxes lie in the room."""
    low, high = middle - half, middle + half
    found = (low.real >= room.left) & (low.imag >= room.top)
    return found & (high.real <= room.right) & (high.imag <= room.bottom)


def _columns(places: Any) -> Any:
    """Complex places (n,) as columns x and y (n, 2)."""
    return np.array([places.real, places.imag]).T


def _overlap(low: Any, high: Any, other_low: Any, other_high: Any) -> Any:
    """Which of many boxes (n, 2) overlap another."""
    found = (low[:, 0] < other_high[0]) & (low[:, 1] < other_high[1])
    return found & (high[:, 0] > other_low[0]) & (high[:, 1] > other_low[1])


def _cross(start: Any, end: Any, low: Any, high: Any) -> Any:
    """Whether lines start..end pass through boxes low..high, one against many or many against one (by slabs)."""
    way = end - start
    way = np.where(np.abs(way) < 1e-9, 1e-9, way)
    first, second = (low - start) / way, (high - start) / way
    enter, leave = np.minimum(first, second), np.maximum(first, second)
    entered, left = np.maximum(enter[..., 0], enter[..., 1]), np.minimum(leave[..., 0], leave[..., 1])
    return np.maximum(entered, 0.0) <= np.minimum(left, 1.0)


def _meet(start: Any, end: Any, other_start: Any, other_end: Any) -> Any:
    """Whether lines start..end cross another line, away from their ends."""

    def side(a: Any, b: Any, c: Any) -> Any:
        return (b[..., 0] - a[..., 0]) * (c[..., 1] - a[..., 1]) - (b[..., 1] - a[..., 1]) * (c[..., 0] - a[..., 0])

    apart = side(start, end, other_start) * side(start, end, other_end) < 0
    return apart & (side(other_start, other_end, start) * side(other_start, other_end, end) < 0)


def _middle(values: list[float]) -> float:
    """The median; numpy's would load masked arrays, which takes longer than placing the labels."""
    ordered = sorted(values)
    half = len(ordered) // 2
    return (ordered[half] + ordered[-half - 1]) / 2 if ordered else 0.0
