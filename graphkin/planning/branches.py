"""Partial drawings of a mechanism side by side, as arrays over its branches."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from itertools import islice
from typing import Any

import numpy as np

from graphkin.base.geometry import Value
from graphkin.base.value import filled
from graphkin.construction import Plot

TABLES = ("near", "position", "theta", "s", "sines", "misses", "senses")


@filled
class Branches:
    """Drawings side by side: values of the plot are scalar or (w,); sides (w, choices made).

    alike  how many entries of each table, the first ones, are the same in every branch
    """

    plot: Plot
    sides: np.ndarray
    alike: Mapping[str, int] = field(default_factory=dict)

    @property
    def count(self) -> int:
        return len(self.sides)

    def taken(self, which: np.ndarray) -> Branches:
        """Some of the branches, in any order and any number of times each: (v,)."""
        plot = Plot(self.plot.facts)
        for name in TABLES:
            table = dict(getattr(self.plot, name))
            for key in self.new(name):
                if isinstance(value := table[key], np.ndarray) and value.ndim:
                    table[key] = value[which]
            setattr(plot, name, table)
        return Branches(plot, self.sides[which], self.alike).settled()

    def new(self, name: str) -> list[Any]:
        """The entries of a table that may be another in each branch, the last one first."""
        table: dict[Any, Value] = getattr(self.plot, name)
        return [*islice(reversed(table), len(table) - self.alike.get(name, 0))]

    def settled(self) -> Branches:
        """With one branch left all is alike that has been drawn."""
        if self.count == 1:
            for name in TABLES:
                table = getattr(self.plot, name)
                for key in self.new(name):
                    if isinstance(value := table[key], np.ndarray) and value.ndim:
                        table[key] = value[0]
            self.alike = {name: len(getattr(self.plot, name)) for name in TABLES if name != "near"}
        return self
