"""Labels find their places: none lies on a line, a vector or another label where there is room.

Each label has candidate places around its point or along its vector. All are held against everything drawn
at once (shapely's tree); then the label with the fewest free places left chooses first, and takes the one
nearest to what it names. The same marks give the same places. Where nothing near is free, a thin leader
goes to a place farther off. In a crowd that leaves no place at all, leaders go much farther (`far`), labels
make way for one another, and at last those that say nothing new are left out.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from graphkin.sheet.lettering import box
from graphkin.sheet.marks import Disc, Mark, Place, Stroke
from graphkin.sheet.nearness import Arrows
from graphkin.sheet.obstacles import Tree, tree
from graphkin.sheet.paper import Room
from graphkin.sheet.wanted import Candidates, Wanted

_CLEAR, _EASY = 0.45, 1.3
"""What a label keeps from lines at least, and likes to keep [mm]."""
_PASSING = 0.4
"""What a leader keeps from other labels [mm]."""
_TOUCH = 0.05
"""Closer than this to a box's edge is not yet on it [mm]."""
_ROUNDS = 8
"""How often labels of a crowd may make way for one another."""
_DOT = 0.3
"""Where a leader meets an arrow is a dot of this radius, so that it is plain which of two it means [mm]."""
_NEIGHBOUR = 15.0
"""So near to a label without a place, others that say nothing new are left out [mm]."""


class Settled(NamedTuple):
    """Labels and leaders at their places; how many labels lie on something, or their leaders on labels."""

    marks: list[Mark]
    clashes: int


class _Prices(NamedTuple):
    """What it costs to lie on a line, on a label, out of the room, nearer to another arrow than to its own without a
    leader; a leader on a label, on a leader.

    apart   what two labels keep from each other [mm]
    beside  for a leader that ends beside another's end
    """

    line: float = 60.0
    label: float = 80.0
    outside: float = 1000.0
    strange: float = 50.0
    crossed: float = 25.0
    leaders: float = 0.0
    apart: float = 0.7
    beside: float = 4.0


_NEAR, _CROWD = _Prices(), _Prices(400.0, 4000.0, 20000.0, 350.0, 900.0, 5.0, 1.3)
_ONE, _BESIDE = 0.5, 2.5
"""Leaders that end nearer together than the second look like one; than the first, they end at one place [mm]."""
_THROUGH = 1.5
"""What a far leader pays for each line it crosses."""


def settle(wanted: Sequence[Wanted], drawn: Sequence[Mark], room: Room, far: bool = False) -> Settled:
    """The labels (and their leaders) at their places among what is drawn; `far`: farther off rather than on it."""
    if not wanted:
        return Settled([], 0)
    known, arrows = tree(drawn), Arrows(drawn)
    table = _Table(wanted, known, arrows, room)
    chosen = table.choose()
    clashing = table.clashing(chosen)
    left = list(wanted)
    while far and clashing:
        table = _Table(left, known, arrows, room, far)
        chosen = table.mended(table.choose())
        clashing = table.clashing(chosen)
        out = _left_out(left, clashing)
        if not out:
            break
        left = [want for k, want in enumerate(left) if k not in out]
    marks: list[Mark] = []
    for want, row in zip(left, chosen, strict=True):
        wide, up, down = box(want.label, want.size)
        middle, anchor = complex(table.candidates.middle[row]), complex(table.candidates.anchor[row])
        marks += want.texts(middle + complex(-wide / 2, (up - down) / 2))
        if table.led[row]:
            marks.append(_leader(middle, anchor, complex(wide, up + down) / 2, want))
            if want.of:
                marks.append(Disc(anchor, _DOT, "leader", "ink", step=want.step))
    return Settled(marks, len(clashing))


def _left_out(wanted: Sequence[Wanted], clashing: Sequence[int]) -> set[int]:
    """The spare ones of labels without a place, else the spare ones next to them."""
    own = {k for k in clashing if wanted[k].spare}
    places = [want.place for want in wanted]
    close = {
        k
        for k, want in enumerate(wanted)
        if want.spare and any(abs(places[k] - places[other]) < _NEIGHBOUR for other in clashing)
    }
    return own or close


def _leader(middle: Place, anchor: Place, half: complex, want: Wanted) -> Mark:
    """A thin line from the near side of a label's box to what it names."""
    off = anchor - middle
    edge = complex(max(-half.real, min(half.real, off.real)), max(-half.imag, min(half.imag, off.imag)))
    way = off - edge
    begin = middle + edge + way / abs(way) * 0.3 if abs(way) > 1 else middle + edge
    return Stroke((begin, anchor), "leader", step=want.step)


# --- the choice -------------------------------------------------------------------------------


def _middle(values: list[float]) -> float:
    """The median; numpy's would load masked arrays, which takes longer than placing the labels."""
    ordered = sorted(values)
    half = len(ordered) // 2
    return (ordered[half] + ordered[-half - 1]) / 2 if ordered else 0.0


class _Table:
    """All candidates of all labels, row by row."""

    def __init__(
        self, wanted: Sequence[Wanted], known: Tree, arrows: Arrows, room: Room, far: bool = False
    ) -> None:  # fmt: skip
        self.known, self.prices = known, _CROWD if far else _NEAR
        found: list[Candidates] = []
        owners: list[int] = []
        halves: list[complex] = []
        places = [want.place for want in wanted]
        crowd = complex(_middle([place.real for place in places]), _middle([place.imag for place in places]))
        for k, want in enumerate(wanted):
            wide, up, down = box(want.label, want.size)
            halves.append(complex(wide, up + down) / 2)
            parts = [want.candidates(halves[k]), *([want.far_candidates(halves[k], crowd)] if far else ())]
            found += parts
            owners += [k] * sum(len(part.cost) for part in parts)
        self.owner = np.array(owners)
        self.candidates = Candidates.joined(found)
        middle, self.led, self.cost = self.candidates.middle, self.candidates.led, self.candidates.cost
        half = np.array(halves)[self.owner]
        self.low, self.high = _columns(middle - half), _columns(middle + half)
        self.anchor = _columns(np.where(self.led, self.candidates.anchor, middle))
        self.begin = np.clip(self.anchor, self.low, self.high)
        self.strange = ~self.led & arrows.strange(wanted, self.owner, self.low, self.high)
        self.cost += self.prices.strange * self.strange
        self.free = self._judge(room) & ~self.strange
        if far:
            led = np.flatnonzero(self.led)
            lines = known.crossed(self.begin[led], self.anchor[led])
            self.cost[led] += _THROUGH * np.bincount(lines, minlength=len(led))

    def _judge(self, room: Room) -> Any:
        """Which candidates touch nothing drawn; near misses and bad places are written into the cost."""
        known = self.known
        near = np.bincount(known.touched(self.low - _EASY, self.high + _EASY), minlength=len(self.owner))
        maybe = np.flatnonzero(near)
        rows = maybe[known.touched(self.low[maybe] - _CLEAR, self.high[maybe] + _CLEAR)]
        hits = np.bincount(rows, minlength=len(self.owner))
        self.cost += 0.45 * np.minimum(near, 6) + self.prices.line * np.minimum(hits, 5)
        inside = np.all(self.low >= (room.left, room.top), axis=1)
        inside &= np.all(self.high <= (room.right, room.bottom), axis=1)
        self.cost[~inside] += self.prices.outside
        self.inside = inside
        return (hits == 0) & inside

    def choose(self) -> list[int]:
        """Greedy: who has the least freedom first. The row each label takes."""
        count = int(self.owner[-1]) + 1
        first = np.searchsorted(self.owner, np.arange(count + 1))
        chosen, waiting = np.empty(count, dtype=np.intp), np.arange(count)
        while len(waiting):
            left = np.bincount(self.owner[self.free], minlength=count)[waiting]
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
        clash, crossed = self._against(row)
        self.cost += self._burden(row, slice(None), clash, crossed)
        self.free &= ~(clash | crossed)

    def _against(self, row: int, rows: Any = slice(None)) -> tuple[Any, Any]:
        """Candidates (of some rows) that lie on the one in this row; those whose leader does, or on its leader."""
        low, high, apart = self.low[rows], self.high[rows], self.prices.apart
        left, top = self.low[row] - apart
        right, bottom = self.high[row] + apart
        clash = (low[:, 0] < right) & (low[:, 1] < bottom) & (high[:, 0] > left) & (high[:, 1] > top)
        nearest, farthest = self.low[row] - _PASSING, self.high[row] + _PASSING
        crossed = self.led[rows] & _cross(self.begin[rows], self.anchor[rows], nearest, farthest)
        if self.led[row]:
            crossed |= _cross(self.begin[row], self.anchor[row], low - _PASSING, high + _PASSING)
        return clash, crossed

    def _burden(self, row: int, rows: Any, clash: Any, crossed: Any) -> Any:
        """What the candidates cost more because a label lies in this row."""
        more = self.prices.label * clash + self.prices.crossed * crossed
        if self.prices.leaders and self.led[row]:
            meeting = _meet(self.begin[rows], self.anchor[rows], self.begin[row], self.anchor[row])
            more += self.prices.leaders * (self.led[rows] & meeting)
        if self.led[row]:
            apart = np.abs(self.anchor[rows] - self.anchor[row]).max(axis=1)
            more += self.prices.beside * (self.led[rows] & (apart > _ONE) & (apart < _BESIDE))
        return more

    def mended(self, chosen: list[int]) -> list[int]:
        """Each label once more takes its best place among all others, until none moves."""
        chosen, every = list(chosen), slice(None)
        own = [np.flatnonzero(self.owner == label) for label in range(len(chosen))]
        for _ in range(_ROUNDS):
            before = list(chosen)
            for label, row in enumerate(before):
                rows = own[label]
                cost = self.cost[rows] - self._burden(row, rows, *self._against(row, rows))
                best = int(np.argmin(cost))
                if cost[best] < cost[row - rows[0]] - 1e-6:
                    chosen[label] = int(rows[best])
                    self.cost -= self._burden(row, every, *self._against(row))
                    self.cost += self._burden(chosen[label], every, *self._against(chosen[label]))
            if chosen == before:
                break
        return chosen

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


def _columns(places: Any) -> Any:
    """Complex places (n,) as columns x and y (n, 2)."""
    return np.array([places.real, places.imag]).T


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
