"""The cost of a label's place, among what is drawn and beside other labels; and the table of places to choose from."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from graphkin.base.geometry import Array
from graphkin.sheet.boxes import meet, overlap, through
from graphkin.sheet.label_candidates import Boxes, Rated

_PASSING = 0.4  # the distance of a leader from other labels [mm]
_ONE, _BESIDE = 0.5, 2.5
"""Leaders that end nearer together than the second look like one; than the first, they end at one place [mm]."""
_WORD = np.array([[2.2], [-1.2]])
"""Labels side by side and farther apart read as two; farther up or down they are no line [mm]."""


class Prices(NamedTuple):
    """The costs of lying on a line, on a label, out of the room, nearer to another arrow than to its own without a
    leader; of a leader on a label, on a leader.

    apart    what two labels keep from each other [mm]
    through  for each line that a leader crosses
    beside   for a leader that ends beside another's end
    word     for a label that stands on a line with another, and so close that both read as one
    """

    line: float = 60.0
    label: float = 80.0
    outside: float = 1000.0
    strange: float = 50.0
    crossed: float = 25.0
    leaders: float = 0.0
    apart: float = 0.7
    through: float = 0.0
    beside: float = 4.0
    word: float = 5.0

    def alone(self, rated: Rated) -> Array:
        """The costs of candidates among what is drawn, as long as no label has a place."""
        cost = rated.cost + self.strange * rated.strange + 0.45 * np.minimum(rated.near, 6)
        cost += self.line * np.minimum(rated.hits, 5) + self.outside * ~rated.inside
        return cost + self.crossed * rated.lettered + self.through * rated.lines

    @staticmethod
    def reach(boxes: Boxes) -> tuple[Array, Array]:
        """Corners beyond which other boxes cost nothing (2, n)."""
        low, high = boxes.reach
        return low - _BESIDE, high + _BESIDE

    def beside_others(self, parts: Sequence[Boxes], others: Boxes) -> list[tuple[Array, Array]]:
        """The costs that the others add to each box of some parts; and which lie on one of them (n,)."""
        (least, most), boxes = self.reach(others), Boxes.joined(parts)
        ends, (low, high) = np.cumsum([len(part.led) for part in parts]), boxes.reach
        pairs = [_near(low[:, a:b], high[:, a:b], least, most) for a, b in pairwise([0, *ends])]
        rows = np.concatenate([rows + first for first, (rows, _) in zip([0, *ends], pairs, strict=False)])
        columns = np.concatenate([columns for _, columns in pairs])
        more, clash = self.together(boxes.taken(rows), others.taken(columns))
        count = len(boxes.led)
        more, clash = np.bincount(rows, more, count), np.bincount(rows, clash, count) > 0
        return [(more[a:b], clash[a:b]) for a, b in pairwise([0, *ends])]

    def together(self, one: Boxes, other: Boxes) -> tuple[Array, Array]:
        """The costs of pairs of labels to each other; which of them lie on each other, or under each other's leader.
        The other may be a single one."""
        clash = overlap(one.low, one.high, other.low - self.apart, other.high + self.apart)
        more = self.label * clash + self.word * overlap(one.low, one.high, other.low - _WORD, other.high + _WORD)
        if not (one.led.any() or other.led.any()):
            return more, clash
        crossed = under(one, other) | under(other, one)
        both = np.flatnonzero(one.led & other.led)
        leader, other_leader = one.taken(both).leader, other.some(both).leader
        apart = np.abs(leader[1] - other_leader[1]).max(axis=0)
        more += self.crossed * crossed
        more[both] += self.beside * ((apart > _ONE) & (apart < _BESIDE))
        if self.leaders:
            more[both] += self.leaders * meet(*leader, *other_leader)
        return more, clash | crossed


NEARBY = Prices()
CROWDED = Prices(1500.0, 4000.0, 20000.0, 350.0, 900.0, 5.0, 1.3, 1.5)


def under(led: Boxes, other: Boxes, keep: float = _PASSING) -> Array:
    """True for labels under the leader of the one they are paired with; one of them may be a single one."""
    lying = np.zeros(max(len(led.led), len(other.led)), dtype=bool)
    if not led.led.any():
        return lying
    start, end = led.leader
    around = overlap(np.minimum(start, end), np.maximum(start, end), other.low - keep, other.high + keep)
    rows = np.flatnonzero(led.led & around)
    if len(rows):
        led, other = led.some(rows), other.some(rows)
        start, end = led.leader
        lying[rows] = through(start, end, other.low - keep, other.high + keep)
    return lying


def _near(low: Array, high: Array, least: Array, most: Array) -> tuple[Array, Array]:
    """Pairs of the boxes low..high (2, n) that lie together and others that overlap: their rows, and the others'."""
    others = np.flatnonzero(overlap(least, most, low.min(axis=1, keepdims=True), high.max(axis=1, keepdims=True)))
    least, most = least.take(others, axis=1), most.take(others, axis=1)
    rows, columns = np.nonzero(overlap(low[..., None], high[..., None], least[:, None], most[:, None]))
    return rows, others[columns]


class LabelChoice(NamedTuple):
    """Places that a label chooses from: boxes, their costs as others stand now, and whether each touches nothing."""

    boxes: Boxes
    cost: Array
    free: Array

    def taken(self, rows: Array) -> LabelChoice:
        return LabelChoice(self.boxes.taken(rows), self.cost[rows], self.free[rows])

    def cheapest(self, count: int) -> LabelChoice:
        """At most so many of them."""
        many = len(self.cost) > count
        return self.taken(np.sort(np.argpartition(self.cost, count)[:count])) if many else self


class LabelTable:
    """Rows of places, one for each label, with room for so many; the rest of a row costs infinitely much.

    cost, free     of each place (count, width)
    _places, _led  all of them, one row after the other (4, 2, n) [mm]
    _low, _high    corners of what each reaches (2, n)
    """

    def __init__(self, choices: Sequence[LabelChoice], width: int) -> None:
        shape = len(choices), max(width, *(len(choice.cost) for choice in choices))
        count = shape[0] * shape[1]
        self.cost, self.free = np.empty(shape), np.empty(shape, dtype=bool)
        self._places, self._led = np.zeros((4, 2, count)), np.zeros(count, dtype=bool)
        self._low, self._high = np.zeros((2, count)), np.zeros((2, count))
        for label, choice in enumerate(choices):
            self.write(label, choice)

    def write(self, label: int, choice: LabelChoice) -> None:
        """The places that a label has to choose from now."""
        count, width = len(choice.cost), self.cost.shape[1]
        first, end, after = label * width, label * width + count, label * width + width
        self.cost[label, :count], self.free[label, :count] = choice.cost, choice.free
        self.cost[label, count:], self.free[label, count:] = np.inf, False
        self._places[:, :, first:end], self._led[first:end] = choice.boxes
        self._low[:, first:end], self._high[:, first:end] = choice.boxes.reach
        self._low[:, end:after] = np.inf

    def place(self, label: int, spot: int) -> tuple[Array, Array]:
        """One place of a label (4, 2), and whether it has a leader."""
        number = label * self.cost.shape[1] + spot
        return self._places[:, :, number], self._led[number]

    def about(self, low: Array, high: Array, label: int) -> tuple[Array, Boxes]:
        """Numbers of places, of labels but this one, that reach into a box low..high (2, 1); and these."""
        width = self.cost.shape[1]
        near = overlap(self._low, self._high, low, high)
        near[label * width : label * width + width] = False
        numbers = np.flatnonzero(near)
        return numbers, Boxes(self._places.take(numbers, axis=2), self._led[numbers])

    def copy(self) -> LabelTable:
        """The same, that can be changed by itself."""
        other = object.__new__(LabelTable)
        vars(other).update({name: value.copy() for name, value in vars(self).items()})
        return other
