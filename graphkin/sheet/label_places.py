"""Which of the places that labels of a figure might take they do take."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from graphkin.sheet.crossings import overlap
from graphkin.sheet.label_candidates import FARTHEST, NEAR, Boxes, Rated, Scene
from graphkin.sheet.label_prices import CROWDED, NEARBY, under
from graphkin.sheet.wanted import LEAST

_TOUCH = 0.05
"""Closer than this to a box's edge is not yet on it [mm]."""
_MOST, _LEAST, _ALL = 80, 16, 8000
"""So many places of a label are kept in mind, fewer of each of many labels, and of all together."""
_REACH = 3.0
"""Labels farther apart than this do not disturb one another [mm]."""
_FEW = 8
"""For so many labels without a good place others make way."""
_PATIENCE, _WORK = 24, 900
"""How often a label of a figure may claim a place; less often in a crowd, where so many labels are asked at most."""
_CHAIN = 3
"""So many labels may claim places one after the other."""
_YIELDING = 0.02
"""What others cost that make way."""
_CHEAPER = 0.5
"""A label moves where that saves more."""


class Choice(NamedTuple):
    """What labels choose from, row by row: boxes, what each costs as others stand now, whether it touches nothing."""

    boxes: Boxes
    cost: Any
    free: Any

    def taken(self, rows: Any) -> Choice:
        return Choice(self.boxes.taken(rows), self.cost[rows], self.free[rows])

    def cheapest(self, count: int) -> Choice:
        """At most so many of them."""
        many = len(self.cost) > count
        return self.taken(np.sort(np.argpartition(self.cost, count)[:count])) if many else self

    @classmethod
    def joined(cls, parts: Sequence[Choice]) -> Choice:
        boxes, cost, free = zip(*parts, strict=True)
        return cls(Boxes.joined(boxes), np.concatenate(cost), np.concatenate(free))


class Places:
    """Labels taking their places; in a crowd farther off.

    boxes   where each label stands; stands: which of them do
    _all    what they choose from, label by label; _first: where that of each begins; _spot: which of it each takes
    _tier   how far off each looks; _patience: how often one may still claim a place
    """

    def __init__(self, scene: Scene, last: int) -> None:
        """last: the farthest tier in which labels look for places."""
        count = len(scene.wanted)
        self.scene, self.prices, self._last = scene, CROWDED if last == FARTHEST else NEARBY, last
        self.boxes = Boxes(np.zeros((4, 2, count)), np.zeros(count, dtype=bool))
        self.stands = np.zeros(count, dtype=bool)
        self._spot, self._tier = np.zeros(count, dtype=np.intp), np.full(count, NEAR)
        self._patience = min(_PATIENCE, _WORK // count)
        self._many = max(_LEAST, min(_MOST, _ALL // count))
        self._choose_from([self._offered(rated) for rated in scene.rated(range(count), NEAR)])
        self._look_on(self._greedy(range(count)))
        self._mend()

    def _choose_from(self, choices: Sequence[Choice]) -> None:
        """What each label has to choose from."""
        self._all, self._first = Choice.joined(choices), np.cumsum([0, *(len(each.cost) for each in choices)])
        self._reach = self._all.boxes.reach

    def _change(self, choices: Mapping[int, Choice]) -> None:
        """What some labels have to choose from."""
        ranges = enumerate(pairwise(self._first))
        self._choose_from([choices[k] if k in choices else self._all.taken(slice(a, b)) for k, (a, b) in ranges])

    def _offered(self, rated: Rated) -> Choice:
        """The candidates of a label that cost least as the others stand."""
        choice = Choice(rated.boxes, self.prices.alone(rated), rated.free).cheapest(3 * self._many)
        if not self.stands.any():
            return choice
        more, clash = self.prices.beside_others(choice.boxes, self._others(choice.boxes))
        return choice._replace(cost=choice.cost + more, free=choice.free & ~clash).cheapest(self._many)

    # --- farther and farther ----------------------------------------------------------------------

    def _enough(self) -> Any:
        """What a label may cost before it looks for farther places."""
        return np.where(self._tier < self._last, np.array([*LEAST, np.inf])[self._tier + 1], np.inf)

    def _look_on(self, waiting: Sequence[int]) -> None:
        """For those that have found no good place."""
        while waiting:
            self._tier[waiting] = np.minimum(self._tier[waiting] + 1, self._last)
            offered: dict[int, Choice] = {}
            for tier in set(self._tier[waiting]):
                some = [label for label in waiting if self._tier[label] == tier]
                offered |= zip(some, map(self._offered, self.scene.rated(some, tier)), strict=True)
            self._change(offered)
            waiting = self._greedy(waiting)

    # --- one after the other ----------------------------------------------------------------------

    def _others(self, boxes: Boxes) -> Boxes:
        """Labels that stand about some boxes."""
        (low, high), (least, most) = boxes.reach, self.boxes.reach
        near = overlap(least, most, low.min(axis=1, keepdims=True) - _REACH, high.max(axis=1, keepdims=True) + _REACH)
        return self.boxes.taken(np.flatnonzero(self.stands & near))

    def _burden(self, label: int, sign: int) -> None:
        """What a label that stands here makes the places of all others cost more."""
        rows, more, clash = self.prices.beside_one(self._all.boxes, self._reach, self.boxes.taken([label]))
        own = (rows >= self._first[label]) & (rows < self._first[label + 1])
        self._all.cost[rows] += np.where(own, 0.0, sign * more)
        self._all.free[rows[clash]] = False

    def _put(self, label: int, spot: int) -> None:
        """A label takes one of its places."""
        row, boxes = self._first[label] + spot, self._all.boxes
        self.boxes.places[:, :, label], self.boxes.led[label] = boxes.places[:, :, row], boxes.led[row]
        self._spot[label], self.stands[label] = spot, True
        self._burden(label, 1)

    def _lift(self, label: int) -> None:
        """A label leaves its place."""
        self._burden(label, -1)
        self.stands[label] = False

    def _greedy(self, labels: Sequence[int]) -> list[int]:
        """Who has the least freedom takes its best place first; who finds none for so little waits."""
        waiting, put_off, enough = np.array(labels), [], self._enough()
        while len(waiting):
            left = np.add.reduceat(self._all.free, self._first[:-1], dtype=np.intp)[waiting]
            best = np.minimum.reduceat(self._all.cost, self._first[:-1])[waiting]
            next_ = int(np.lexsort((-best, left))[0])
            label = int(waiting[next_])
            waiting = np.delete(waiting, next_)
            if best[next_] > enough[label]:
                put_off.append(label)
            else:
                self._put(label, int(np.argmin(self._all.cost[self._first[label] : self._first[label + 1]])))
        return sorted(put_off)

    def _mend(self) -> None:
        """All move to better places; who is left with a bad one looks farther, and for the last few others make way."""
        if self._last == NEAR:
            return
        self._move()
        bad = self._bad() if self._bad().sum() <= 3 * _FEW else False
        self._look_again(np.flatnonzero((self._now() > self._enough()) | bad))
        self._relieve()

    def _relieve(self) -> None:
        """Others make way for the last few labels without a good place, one after the other, as long as that helps."""
        before: Any = None
        while before is None or self._badness() < before:
            before, bad = self._badness(), np.flatnonzero(self._bad())
            for label in map(int, bad if len(bad) <= _FEW else ()):
                if self._bad()[label] and self._patience:
                    self._patience -= 1
                    self._tried(label)

    def _tried(self, label: int) -> None:
        """A label claims its place, and who loses its own by that does the same, if that leaves all better."""
        before, bad, boxes, first = self._badness(), self._bad(), self._all.boxes, self._first
        kept = [each.copy() for each in (*self.boxes, self.stands, self._spot, self._tier, *self._all[1:])]
        for _ in range(_CHAIN):
            self._claim(label)
            if self._badness() < before:
                return
            lost = np.where(self._bad() & ~bad, self._now(), 0.0)
            label = int(np.argmax(lost))
            if not lost[label]:
                break
        places, led, self.stands, self._spot, self._tier, cost, free = kept
        self.boxes, self._all = Boxes(places, led), Choice(boxes, cost, free)
        self._first, self._reach = first, boxes.reach

    def _bad(self) -> Any:
        """Which labels have no good place."""
        return self._now() > self.prices.strange

    def _badness(self) -> tuple[int, float]:
        """How many labels have no good place, and what all cost."""
        return int(np.sum(self._bad())), float(self._now().sum())

    def _claim(self, label: int) -> None:
        """A label takes the place that is its best if others make way; these look for new ones."""
        self._lift(label)
        self._tier[label] = self._last
        rated = self.scene.rated([label], self._last)[0]
        alone, (more, _) = self.prices.alone(rated), self.prices.beside_others(rated.boxes, self._others(rated.boxes))
        liked = np.sort(np.argsort(alone + _YIELDING * more)[: self._many])
        self._change({label: Choice(rated.boxes, alone + more, rated.free).taken(liked)})
        self._put(label, int(np.argmin((alone + _YIELDING * more)[liked])))
        rows, cost, _ = self.prices.beside_one(self.boxes, self.boxes.reach, self.boxes.taken([label]))
        self._look_again(row for row in rows[cost > self.prices.strange] if row != label and self.stands[row])

    def _look_again(self, labels: Iterable[int]) -> None:
        """Some labels leave their places and look on from there; then all move to better ones."""
        labels = [int(label) for label in labels]
        for label in labels:
            self._lift(label)
        self._look_on(labels)
        self._move()

    def _now(self) -> Any:
        """What each label costs where it stands."""
        return np.where(self.stands, self._all.cost[self._first[:-1] + self._spot], 0.0)

    def _move(self) -> None:
        """Whoever gains most by it takes a better place, until none gains much: all together cost less each time."""
        first = self._first[:-1]
        while True:
            gain = self._now() - np.minimum.reduceat(self._all.cost, first)
            label = int(np.argmax(np.where(self.stands, gain, 0.0)))
            if not self.stands[label] or gain[label] < _CHEAPER:
                break
            self._lift(label)
            self._put(label, int(np.argmin(self._all.cost[first[label] : self._first[label + 1]])))

    def leave_out(self, labels: Collection[int]) -> None:
        """Some labels are not lettered; those without a good place, and all others, may stand where they would have."""
        for label in labels:
            self._lift(label)
        self._move()
        self._relieve()

    # --- what has no place ------------------------------------------------------------------------

    def clashing(self) -> list[int]:
        """Labels that lie on another or on something drawn, out of their room, or under a leader."""
        rows = np.flatnonzero(self.stands)
        boxes = self.boxes.taken(rows)
        bad = ~self.scene.inside(boxes)
        bad[self.scene.touched(boxes.low.T + _TOUCH, boxes.high.T - _TOUCH)] = True
        one, other = Boxes(boxes.places[..., None], boxes.led[:, None]), Boxes(boxes.places[:, :, None], boxes.led)
        over = overlap(one.low, one.high, other.low + _TOUCH, other.high - _TOUCH)
        led = np.flatnonzero(boxes.led)
        over[led] |= under(one.taken(led), other, 0.0)
        np.fill_diagonal(over, False)
        bad |= over.any(axis=0) | over.any(axis=1)
        return [int(label) for label in rows[bad]]
