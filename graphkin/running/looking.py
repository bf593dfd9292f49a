"""Positions beside each other on a path, each found from one close by: what there is to see at each of them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from graphkin.construction import Fit, Plot, replay
from graphkin.geometry import Value
from graphkin.planning.method import Method
from graphkin.running.compiled import CannotRecord, Program, compiled_program
from graphkin.running.many_positions import program_of
from graphkin.running.nodes import Nodes
from graphkin.running.path import Path, by_slide_key, turned
from graphkin.running.singularities import Crossing, crossings, key_of

ROUNDS = 2
"""How often the program is run, each time from what it found before; each is two steps of Newton's method."""


class Looking:
    """What there is to see along a path.

    names      of what is found: base links, and displacements by `slide_key`
    crossings  what may come to an end, by name
    start      the drawn position
    """

    def __init__(self, method: Method, path: Path) -> None:
        self.method, self.path = method, path
        self.crossings = {key_of(step): step for step in crossings(method)}
        self.program, self.times = _program(method, path)
        plot = self._replayed(np.zeros(1), dict(path.near(0.0)), path.sides)
        self.names = tuple(turned(method, plot))
        self.start = self._nodes(plot, np.zeros(1), path.sides)

    def quickly(self, t: np.ndarray, near: np.ndarray, sides: Mapping[int, int]) -> Nodes:
        """Positions at t (k,), from some close by (k, n): by the program, nan where it does not come to them."""
        if self.program is None:
            return self.plainly(t, near, sides)
        values = [np.broadcast_to(value, t.shape) for value in self.path.values(t)]
        for _ in range(ROUNDS):
            plot, doubtful = self.program.tried(values, sides, dict(zip(self.names, near.T)))
            if not doubtful.size:
                break
            x = self._columns(turned(self.method, plot), t.size)
            near = np.where(np.isfinite(x), x, near)
        found = self._nodes(plot, t, sides, self.times)
        found.x[doubtful] = np.nan
        return found

    def plainly(self, t: np.ndarray, near: np.ndarray, sides: Mapping[int, int]) -> Nodes:
        """The same by plain replay, which tries longer."""
        return self._nodes(self._replayed(t, dict(zip(self.names, near.T)), sides), t, sides)

    def _replayed(self, t: np.ndarray, near: dict[str, np.ndarray], sides: Mapping[int, int]) -> Plot:
        facts = replace(self.method.facts(self.path.values(t)), rates=self.path.pace)
        return replay(self.method.velocity, replay(self.method.position, Plot(facts, near), sides))

    def _nodes(self, plot: Plot, t: np.ndarray, sides: Mapping[int, int], times: float = 1.0) -> Nodes:
        found, rates = turned(self.method, plot), {**plot.omega, **by_slide_key(plot.s_rate)}
        sines = {key: self._sine(step, plot, sides) for key, step in self.crossings.items()}
        slope = self._columns({name: rates[name] for name in found}, t.size)
        return Nodes(t, self._columns(found, t.size), slope * times, self._columns(sines, t.size))

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


def _program(method: Method, path: Path) -> tuple[Program | None, float]:
    """A program with the drivers' rates as they are on the path, but for a factor; none where it leads nowhere."""
    facts = method.facts(None)
    rates, pace = np.array(facts.rates, dtype=float), np.array(path.pace)
    fastest = int(np.argmax(np.abs(pace)))
    if not pace[fastest]:
        return None, 1.0
    if rates[fastest] and np.allclose(pace * (times := rates[fastest] / pace[fastest]), rates, rtol=1e-12, atol=0):
        return program_of(method), 1 / times
    try:
        return compiled_program(method.constructions[:2], replace(facts, rates=path.pace), method.near), 1.0
    except CannotRecord:
        return None, 1.0
