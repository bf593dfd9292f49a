"""Partial drawings of a mechanism side by side, as arrays over its branches."""

from __future__ import annotations

import numpy as np

from graphkin.construction import Plot
from graphkin.geometry import Value
from graphkin.value import filled

TABLES = ("near", "position", "theta", "s", "sines", "misses", "senses")


@filled
class Branches:
    """Drawings side by side: values of the plot are scalar or (w,); sides (w, choices made)."""

    plot: Plot
    sides: np.ndarray

    @property
    def count(self) -> int:
        return len(self.sides)

    def taken(self, which: np.ndarray) -> Branches:
        """Some of the branches, in any order and any number of times each: (v,)."""
        plot = Plot(self.plot.facts)
        for name in TABLES:
            table = getattr(self.plot, name)
            setattr(plot, name, {key: _taken(value, which) for key, value in table.items()})
        return Branches(plot, self.sides[which])


def _taken(value: Value, which: np.ndarray) -> Value:
    return value[which] if isinstance(value, np.ndarray) and value.ndim else value
