"""A path continued step by step, where links are fitted: each position is found from one close by.

Each step is foretold from the two before, and halved where it does not come to that. Where the angle of a crossing, or
of a fit, is about to become 0, one step goes from well before to well after, crossings changed over: if the links come
smoothly there, and the loci touch between, it is a change point. Else the path is felt for in ever smaller steps; where
none leads on, it ends.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from itertools import pairwise

import numpy as np

from graphkin.construction import Fit, Meet, Plot, Roll, Swing, replay
from graphkin.planning.method import Method
from graphkin.running.path import STEP_DEG, STEP_PART, Event, Path, along, by_slide_key, stride, turned
from graphkin.running.singularities import Crossing, choice_of, crossings, event_at, key_of, touching
from graphkin.value import frozen

FIRST = 1 / 32
"""The first step, of which nothing is foretold but its direction, as part of the longest."""
FARTHEST = 0.2
"""How far a link turns in a step at most [rad], or slides, in lengths of the mechanism."""
AWAY, SWERVE = 1e-3, 3e-3
"""How far links may come from where they were expected, and turn otherwise over a step [rad, lengths]."""
SHORTEST = 1e-6
"""Steps are not halved below this part of the longest."""
SOON = 1.25
"""So many longest steps ahead a change point is looked for."""
BETWEEN = 8
"""From one position found to the next so many are foretold, from which others are found."""


@frozen
class _Node:
    """Angles and displacements x (n,) at a place t of the path, their slopes, and the signed sine of each crossing."""

    t: float
    x: np.ndarray
    slope: np.ndarray
    sines: Mapping[str, float]


def continued(method: Method, path: Path) -> Path:
    """The path continued both ways from the drawn position; it ends where no step leads on."""
    forth, back = _Walk(method, path, 1), _Walk(method, path, -1)
    forth.walk(path.high)
    back.walk(path.low)
    changes = (*back.changes, *forth.changes)
    return replace(forth.so_far(back.nodes), stops=(*back.stops, *forth.stops), changes=changes)


class _Walk:
    """One direction of a path: positions found so far, change points gone through, and what ended it.

    missed   where loci only came near touching
    """

    def __init__(self, method: Method, path: Path, side: int) -> None:
        self.method, self.path, self.side = method, path, side
        self.sides = dict(path.sides)
        self.stops: tuple[Event, ...] = ()
        self.changes: tuple[Event, ...] = ()
        self.missed = -np.inf
        self.stride = stride(method, path.pace, STEP_DEG, STEP_PART)
        self.crossings = {key_of(step): step for step in crossings(method)}
        self.names = tuple(turned(method, along(method, path, 0.0)))
        rolled = {step.angle for step in method.position.steps if isinstance(step, Roll)}
        self.heard = np.array([name not in rolled for name in self.names])
        self.units = np.array([1.0 if name in method.structure.bases else method.size for name in self.names])
        near = path.near(0.0)
        start = self._looked_at(0.0, np.array([float(near.get(name, 0.0)) for name in self.names]), self.sides)
        self.nodes = [start]

    @property
    def last(self) -> _Node:
        return self.nodes[-1]

    @property
    def longest(self) -> float:
        """The longest step here: no link goes too far."""
        return float(min(self.stride, FARTHEST / max(self._largest(self.last.slope, self.last.x), 1e-300)))

    def walk(self, end: float) -> None:
        step = FIRST * self.longest
        while (ahead := self.side * (end - self.last.t)) > 1e-12 * self.stride:
            step = min(step, self.longest)
            if step < SHORTEST * self.stride:
                self._stop()
                return
            if (place := self._foretold()) is not None and self._through(place):
                step = self.longest
            elif self._taken(end if ahead < 1.001 * step else self.last.t + self.side * step):
                step *= 2
            else:
                step /= 2

    # --- steps --------------------------------------------------------------------------------

    def _looked_at(self, t: float, near: np.ndarray, sides: Mapping[int, int]) -> _Node:
        """Angles, displacements and their slopes at t, from some close by."""
        facts = replace(self.method.facts(self.path.values(t)), rates=self.path.pace)
        plot = Plot(facts, dict(zip(self.names, near, strict=True)))
        replay(self.method.velocity, replay(self.method.position, plot, sides))
        found, rates = turned(self.method, plot), {**plot.omega, **by_slide_key(plot.s_rate)}
        sines = {key: self._sine(step, plot, sides) for key, step in self.crossings.items()}
        x, slope = (np.array([float(table[name]) for name in self.names]) for table in (found, rates))
        return _Node(t, x, slope, sines)

    def _sine(self, step: Crossing, plot: Plot, sides: Mapping[int, int]) -> float:
        """The sine of a crossing with the sign of its side, which changes over where it goes through 0."""
        sine = float(plot.sines["position", key_of(step)])
        if isinstance(step, Fit):
            return sine * float(plot.senses[step.name])
        return sine if step.choice is None else sine * sides.get(step.choice, step.side)

    def _largest(self, change: np.ndarray, x: np.ndarray) -> float:
        """The largest of changes [rad, lengths]; of a displacement far off, as part of it."""
        scale = np.where(self.units == 1.0, 1.0, np.maximum(np.abs(x), self.units))
        return float(np.max(np.abs(change / scale)[self.heard], initial=0.0))

    def _taken(self, t: float) -> bool:
        """One step, if the links come to where they were expected, and fits stay on their side of change points."""
        node = self._as_foretold(t, self.sides)
        if node is None:
            return False
        if turning := [key for key in self.crossings if node.sines[key] * self.last.sines[key] < 0]:
            return self._gone_through(node, turning)
        self.nodes.append(node)
        return True

    def _as_foretold(self, t: float, sides: Mapping[int, int]) -> _Node | None:
        """The position that goes on smoothly from those so far; None where there is none."""
        x, slope = self._expected(t)
        node = self._looked_at(t, x, sides)
        if not (np.isfinite(node.x).all() and np.isfinite(node.slope).all()):
            return None
        if not self._largest(node.x - x, x) < AWAY:
            return None
        return node if self._largest(node.slope - slope, x) * abs(t - self.last.t) < SWERVE else None

    def _expected(self, t: float) -> tuple[np.ndarray, np.ndarray]:
        here = self.last
        if len(self.nodes) == 1:
            return here.x + (t - here.t) * here.slope, here.slope
        return _cubic(self.nodes[-2], here, t)

    # --- change points ------------------------------------------------------------------------

    def _foretold(self) -> float | None:
        """How far the first crossing is that is about to become flat, if it is soon."""
        ahead = min((self._flat_in(key) for key in self.crossings), default=np.inf)
        at = self.side * self.last.t + ahead
        return ahead if ahead < SOON * self.longest and at - self.missed > self.longest else None

    def _flat_in(self, key: str) -> float:
        if len(self.nodes) == 1:
            return np.inf
        before, here = self.nodes[-2:]
        falls = (abs(before.sines[key]) - abs(here.sines[key])) / abs(here.t - before.t)
        return abs(here.sines[key]) / falls if falls > 0 else np.inf

    def _through(self, ahead: float) -> bool:
        """One step over a place where crossings become flat, with these changed over."""
        far = ahead + max(ahead, self.longest / 2)
        turning = [key for key in self.crossings if self._flat_in(key) < far]
        sides = dict(self.sides)
        for key in turning:
            step = self.crossings[key]
            if isinstance(step, Meet | Swing) and step.choice is not None:
                sides[step.choice] = -sides[step.choice]
        node = self._as_foretold(self.last.t + self.side * far, sides)
        if node is not None and self._gone_through(node, turning):
            return True
        self.missed = self.side * self.last.t + ahead
        return False

    def _gone_through(self, beyond: _Node, turning: list[str]) -> bool:
        """Take the change points between here and there, if each crossing that changes over touches."""
        here, path = self.last, self.so_far(self.nodes[:1], beyond)
        found = [touching(self.method, path, self.crossings[key], here.t, beyond.t) for key in turning]
        places = [place for place in found if place is not None]
        if not places or len(places) < len(found):
            return False
        for key, place in sorted(zip(turning, places, strict=True), key=lambda entry: self.side * entry[1]):
            step = self.crossings[key]
            choice = choice_of(step)
            event = event_at(self.method, step, place, choice)
            self.changes = (*self.changes, event if choice else replace(event, kind="two ways"))
            self.sides |= {number: -self.sides[number] for number in choice}
        self.nodes.append(beyond)
        return True

    # --- what is found ------------------------------------------------------------------------

    def so_far(self, others: list[_Node], *beyond: _Node) -> Path:
        """The path as far as it is continued, with what lies between positions; `others` are on its other side."""
        nodes = sorted([*others[1:], *self.nodes, *beyond], key=lambda node: node.t)
        t, x = [nodes[-1].t], [nodes[-1].x]
        for left, right in reversed(list(pairwise(nodes))):
            t[:0] = between = [left.t + (right.t - left.t) * k / BETWEEN for k in range(BETWEEN)]
            x[:0] = [_cubic(left, right, place)[0] for place in between]
        tables = dict(zip(self.names, np.array(x).T, strict=True))
        return replace(self.path, nodes=(np.array(t), tables), changes=self.changes)

    def _stop(self) -> None:
        """The path ends here, to the last digit that stepping on gives, at the crossing that is flattest."""
        flattest = min(self.crossings, key=lambda key: abs(self.last.sines[key]))
        self.stops = (event_at(self.method, self.crossings[flattest], self.last.t, ()),)


def _cubic(left: _Node, right: _Node, t: float) -> tuple[np.ndarray, np.ndarray]:
    """Hermite's cubic through two nodes, and its slope: between them, or beyond."""
    width = right.t - left.t
    u = (t - left.t) / width
    x = left.x * (1 + 2 * u) * (1 - u) ** 2 + right.x * u**2 * (3 - 2 * u)
    x = x + width * (left.slope * u * (1 - u) ** 2 - right.slope * u**2 * (1 - u))
    slope = 6 * u * (1 - u) * (right.x - left.x) / width
    return x, slope + left.slope * (1 - u) * (1 - 3 * u) - right.slope * u * (2 - 3 * u)
