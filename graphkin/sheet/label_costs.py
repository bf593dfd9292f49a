"""The cost of a label's place beside other labels; and the table of places to choose from."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from graphkin.base.boxes import meet, overlap, through
from graphkin.base.geometry import Array

_APART = 1.0  # what two labels keep from each other [mm]
_PASSING = 0.4  # the distance of a leader from other labels [mm]
_ONE, _BESIDE = 0.5, 2.5
"""Leaders that end nearer together than the second look like one; than the first, they end at one place [mm]."""
_WORD = np.array([[2.2], [-1.2]])
"""Labels side by side and farther apart read as two; farther up or down they are no line [mm]."""
LYING = 1000.0  # the cost of a label that lies on another
_CROSSED, _LEADERS = 250.0, 5.0  # of a leader on a label, on a leader
_ENDS, _ONE_WORD = 4.0, 5.0
"""The costs of a leader that ends beside another's end, and of a label on a line with another, that read as one."""


class LabelPlaces(NamedTuple):
    """Places of labels, row by row.

    places  corners low and high of each, where its leader begins and ends (4, 2, n) [mm]; without one, the box's middle
    led     whether it has a leader
    cost    as things stand; free: it touches nothing
    """

    places: Array
    led: Array
    cost: Array
    free: Array

    def taken(self, rows: Array) -> LabelPlaces:
        """Some of them; numpy takes numbered columns several times as fast as it indexes them."""
        places = self.places.take(rows, axis=2)
        return LabelPlaces(places, self.led.take(rows), self.cost.take(rows), self.free.take(rows))

    @classmethod
    def joined(cls, parts: Iterable[LabelPlaces]) -> LabelPlaces:
        return cls(*(np.concatenate(each, axis=-1) for each in zip(*parts, strict=True)))

    def cheapest(self, count: int) -> LabelPlaces:
        """At most so many of them."""
        many = len(self.cost) > count
        return self.taken(np.sort(np.argpartition(self.cost, count)[:count])) if many else self

    @property
    def low(self) -> Array:
        return np.asarray(self.places[0])

    @property
    def high(self) -> Array:
        return np.asarray(self.places[1])

    @property
    def reach(self) -> tuple[Array, Array]:
        """Corners of what boxes and leaders lie in (2, n)."""
        return np.minimum(self.low, self.places[3]), np.maximum(self.high, self.places[3])

    def among(self, others: LabelPlaces) -> LabelPlaces:
        """The same with the costs that the others add."""
        (low, high), (least, most) = self.reach, others.reach
        near = overlap(low[..., None], high[..., None], least[:, None] - _BESIDE, most[:, None] + _BESIDE)
        rows, columns = np.nonzero(near)
        if not len(rows):
            return self
        more, clash = together(self.taken(rows), others.taken(columns))
        free = self.free & (np.bincount(rows, clash, len(self.cost)) == 0)
        return self._replace(cost=self.cost + np.bincount(rows, more, len(self.cost)), free=free)


def together(one: LabelPlaces, other: LabelPlaces) -> tuple[Array, Array]:
    """The costs of pairs of labels to each other (the other may be one); which lie on each other, or under a leader."""
    clash = overlap(one.low, one.high, other.low - _APART, other.high + _APART)
    more = LYING * clash + _ONE_WORD * overlap(one.low, one.high, other.low - _WORD, other.high + _WORD)
    if not (one.led.any() or other.led.any()):
        return more, clash
    crossed = under(one, other) | under(other, one)
    both = one.led & other.led
    (start, end), (other_start, other_end) = one.places[2:], other.places[2:]
    apart = np.abs(end - other_end).max(axis=0)
    more += _CROSSED * crossed + _ENDS * (both & (apart > _ONE) & (apart < _BESIDE))
    return more + _LEADERS * (both & meet(start, end, other_start, other_end)), clash | crossed


def under(led: LabelPlaces, other: LabelPlaces, keep: float = _PASSING) -> Array:
    """True for labels under the leader of the one they are paired with; one of them may be a single one."""
    (start, end), low, high = led.places[2:], other.low - keep, other.high + keep
    around = led.led.any() and led.led & overlap(np.minimum(start, end), np.maximum(start, end), low, high)
    return np.asarray(around & through(start, end, low, high) if around.any() else around)


class LabelTable:
    """Rows of places (count, width), one for each label; the rest of a row costs infinitely much. _every: all of them,
    row after row; _low, _high: corners of what each reaches (2, n)."""

    def __init__(self, count: int, width: int) -> None:
        size = count * width
        self._every = LabelPlaces(np.zeros((4, 2, size)), *(np.zeros(size, dtype=kind) for kind in (bool, float, bool)))
        self._low, self._high = np.full((2, size), np.inf), np.zeros((2, size))
        self.cost, self.free = (each.reshape(count, width) for each in self._every[2:])

    def write(self, label: int, choice: LabelPlaces) -> None:
        """The places that a label has to choose from now, no more than have room."""
        count, width = len(choice.cost), self.cost.shape[1]
        first, end, after = label * width, label * width + count, label * width + width
        for each, new in zip(self._every, choice, strict=True):
            each[..., first:end] = new
        self.cost[label, count:], self.free[label, count:] = np.inf, False
        self._low[:, first:end], self._high[:, first:end] = choice.reach
        self._low[:, end:after] = np.inf

    def taken(self, labels: Array, spots: Array) -> LabelPlaces:
        """One place of each of some labels."""
        return self._every.taken(labels * self.cost.shape[1] + spots)

    def burden(self, label: int, spot: Array, sign: int) -> None:
        """Add the cost of a label at one of its places to the places of all others, or take it away."""
        one, width = self.taken(np.array([label]), spot), self.cost.shape[1]
        low, high = one.reach
        near = overlap(self._low, self._high, low - _BESIDE, high + _BESIDE)
        near[label * width : label * width + width] = False
        if not len(numbers := np.flatnonzero(near)):
            return
        more, clash = together(self._every.taken(numbers), one)
        self._every.cost[numbers] += sign * more
        self._every.free[numbers[clash]] = False

    def copy(self) -> LabelTable:
        other = LabelTable(*self.cost.shape)
        for mine, its in zip((*self._every, self._low, self._high), (*other._every, other._low, other._high)):
            its[...] = mine
        return other
