"""What labels have to choose from, side by side: a row of places for each label."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from graphkin.sheet.crossings import overlap
from graphkin.sheet.label_candidates import Boxes


class LabelChoice(NamedTuple):
    """What a label chooses from: boxes, what each costs as others stand now, whether it touches nothing."""

    boxes: Boxes
    cost: Any
    free: Any

    def taken(self, rows: Any) -> LabelChoice:
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
        """What a label has to choose from now."""
        count, width = len(choice.cost), self.cost.shape[1]
        first, end, after = label * width, label * width + count, label * width + width
        self.cost[label, :count], self.free[label, :count] = choice.cost, choice.free
        self.cost[label, count:], self.free[label, count:] = np.inf, False
        self._places[:, :, first:end], self._led[first:end] = choice.boxes
        self._low[:, first:end], self._high[:, first:end] = choice.boxes.reach
        self._low[:, end:after] = np.inf

    def place(self, label: int, spot: int) -> tuple[Any, Any]:
        """One place of a label (4, 2), and whether it has a leader."""
        number = label * self.cost.shape[1] + spot
        return self._places[:, :, number], self._led[number]

    def about(self, low: Any, high: Any, label: int) -> tuple[Any, Boxes]:
        """Which places, of labels but this one, reach into a box low..high (2, 1); and these."""
        width = self.cost.shape[1]
        near = overlap(self._low, self._high, low, high)
        near[label * width : label * width + width] = False
        numbers = np.flatnonzero(near)
        return numbers, Boxes(self._places.take(numbers, axis=2), self._led[numbers])

    def raise_(self, numbers: Any, more: Any, taken: Any) -> None:
        """Some places cost more; and some of these are no longer free."""
        self.cost.ravel()[numbers] += more
        self.free.ravel()[numbers[taken]] = False

    def copy(self) -> LabelTable:
        """The same, that can be changed by itself."""
        found = object.__new__(LabelTable)
        vars(found).update({name: value.copy() for name, value in vars(self).items()})
        return found
