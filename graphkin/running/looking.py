"""Positions beside each other on a path, each found from one close by: what there is to see at each of them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import partial

import numpy as np

from graphkin.base.geometry import Value
from graphkin.construction import Fit, Plot, replay
from graphkin.construction.fitting import fit
from graphkin.construction.pencil import COMPASS, Compass
from graphkin.planning.method import Method
from graphkin.running.path import DriverPath, by_slide_key, turned
from graphkin.running.path_nodes import Nodes
from graphkin.running.singularities import Crossing, crossings, key_of

QUICK, LONGER = (Compass(fit=partial(fit, rounds=rounds)) for rounds in (3, 15))
"""Links that come close to where they fit do so in these steps of Newton's method; close to a dead point it takes more,
each of which leaves half of what was missing."""


class Looking:
    """What there is to see along a path.

    names      of what is found: base links, and displacements by `slide_key`
    crossings  what may come to an end, by name
    start      the drawn position
    """

    def __init__(self, method: Method, path: DriverPath) -> None:
        self.method, self.path = method, path
        self.crossings = {key_of(step): step for step in crossings(method)}
        plot = self._replayed(np.zeros(1), dict(path.near(0.0)), path.sides)
        self.names = tuple(turned(method, plot))
        self.start = self._nodes(plot, np.zeros(1), path.sides)

    def quickly(self, t: np.ndarray, near: np.ndarray, sides: Mapping[int, int]) -> Nodes:
        """Positions at t (k,), from some close by (k, n): nan where a few steps do not come to them."""
        return self._seen(t, near, sides, QUICK)

    def plainly(self, t: np.ndarray, near: np.ndarray, sides: Mapping[int, int]) -> Nodes:
        """The same, tried longer."""
        return self._seen(t, near, sides, LONGER)

    def _seen(self, t: np.ndarray, near: np.ndarray, sides: Mapping[int, int], compass: Compass) -> Nodes:
        return self._nodes(self._replayed(t, dict(zip(self.names, near.T)), sides, compass), t, sides)

    def _replayed(
        self, t: np.ndarray, near: dict[str, np.ndarray], sides: Mapping[int, int], compass: Compass = COMPASS
    ) -> Plot:
        facts = replace(self.method.facts(self.path.values(t)), rates=self.path.pace)
        plot = replay(self.method.position, Plot(facts, near), sides, compass)
        return replay(self.method.velocity, plot)

    def _nodes(self, plot: Plot, t: np.ndarray, sides: Mapping[int, int]) -> Nodes:
        found, rates = turned(self.method, plot), {**plot.omega, **by_slide_key(plot.s_rate)}
        sines = {key: self._sine(step, plot, sides) for key, step in self.crossings.items()}
        slope = self._columns({name: rates[name] for name in found}, t.size)
        return Nodes(t, self._columns(found, t.size), slope, self._columns(sines, t.size))

    def _columns(self, values: Mapping[str, Value], count: int) -> np.ndarray:
        """Beside each other (count, n)."""
        found = np.empty((count, len(values)))
        for k, value in enumerate(values.values()):
            found[:, k] = value
        return found

    def _sine(self, step: Crossing, plot: Plot, sides: Mapping[int, int]) -> Value:
        """The sine of a crossing with the sign of its side, which changes over where it goes through 0."""
        sine = plot.sines["position", key_of(step)]
        if isinstance(step, Fit):
            return sine * plot.senses[step.name]
        return sine if step.choice is None else sine * sides.get(step.choice, step.side)
