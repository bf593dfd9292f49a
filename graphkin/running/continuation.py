"""A path continued by stretches, where links are fitted: each position is found from those before it.

Some steps are foretold at once from the two positions before, and taken as far as each comes to what those before it
led to expect; else one is halved until it does. Where the angle of a crossing, or of a fit, is about to become 0, one
step goes from well before to well after, crossings changed over: if the links come smoothly there, and the loci touch
between, it is a change point. Else the path is felt for in ever smaller steps; where none leads on, it ends.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial

import numpy as np

from graphkin.base.geometry import Real
from graphkin.construction import Fit, Meet, Plot, Roll, Swing, replay
from graphkin.construction.fitting import fit
from graphkin.construction.pencil import COMPASS, Compass
from graphkin.planning import Method
from graphkin.planning.refusals import key_of
from graphkin.running.path import STEP_DEG, STEP_PART, DriverPath, Event, Nodes, by_slide_key, cubic, stride, turned
from graphkin.running.singularities import choice_of, crossings, event_at, touching

QUICK, LONGER = (Compass(fit=partial(fit, rounds=rounds)) for rounds in (3, 15))
"""Links that come close to where they fit do so in these steps of Newton's method; close to a dead point it takes more,
each of which leaves half of what was missing."""
FIRST = 1 / 32  # the first step, of which nothing is foretold but its direction, as part of the longest
FARTHEST = 0.2  # a link turns no farther in a step [rad], or slides, in lengths of the mechanism
AWAY, SWERVE = 1e-3, 3e-3
"""Links may come so far from where they were expected, and turn so much otherwise over a step [rad, lengths]."""
SHORTEST = 1e-6  # steps are not halved below this part of the longest
SOON = 1.25  # so many longest steps ahead a change point is looked for
STRETCH, HALVINGS = 20, 6
"""Steps tried at once, and halvings."""
FELT = 0.001
"""Steps below this part of the longest are felt for one by one, and tried longer: the way may be about to end."""
GROWTH, STEADY = 1.5, 0.9
"""Each step may be so much longer than the one before, and this part of the longest that would do is taken."""
LEAST = 0.05  # the others are at least this part of the first step of a stretch
BETWEEN = 8  # from one position found to the next so many are foretold, from which others are found


def continued(method: Method, path: DriverPath) -> DriverPath:
    """The path continued both ways from the drawn position; it ends where no step leads on."""
    finder = NodeFinder(method, path)
    forth, back = _ContinuationWalk(finder, path, 1), _ContinuationWalk(finder, path, -1)
    forth.walk(path.high)
    back.walk(path.low)
    changes = (*back.changes, *forth.changes)
    return replace(forth.so_far(back.nodes[1:], forth.nodes), stops=(*back.stops, *forth.stops), changes=changes)


class NodeFinder:
    """Finds positions along a path, each from one close by. `names` of base links, and displacements by `slide_key`;
    `crossings` that may come to an end, by name; `start`: the drawn position."""

    def __init__(self, method: Method, path: DriverPath) -> None:
        self.method, self.path = method, path
        self.crossings = {key_of(step): step for step in crossings(method)}
        plot = self._replayed(np.zeros(1), dict(path.near(0.0)), path.sides)
        self.names = tuple(turned(method, plot))
        self.start = self._nodes(plot, np.zeros(1), path.sides)

    def at(self, t: np.ndarray, near: np.ndarray, sides: Mapping[int, int], compass: Compass) -> Nodes:
        """Positions at t (k,), from some close by (k, n): nan where the steps of a compass do not come to them."""
        return self._nodes(self._replayed(t, dict(zip(self.names, near.T)), sides, compass), t, sides)

    def _replayed(
        self, t: np.ndarray, near: Mapping[str, Real], sides: Mapping[int, int], compass: Compass = COMPASS
    ) -> Plot:
        facts = replace(self.method.facts(self.path.values(t)), rates=self.path.pace)
        return replay(self.method.velocity, replay(self.method.position, Plot(facts, near), sides, compass))

    def _nodes(self, plot: Plot, t: np.ndarray, sides: Mapping[int, int]) -> Nodes:
        values, rates = turned(self.method, plot), {**plot.omega, **by_slide_key(plot.s_rate)}
        sines = list[Real]()  # with the signs of their sides, which change over where they go through 0
        for step in self.crossings.values():
            sine = plot.sines["position", key_of(step)]
            if isinstance(step, Fit):
                sine = sine * plot.senses[step.name]
            elif step.choice is not None:
                sine = sine * sides.get(step.choice, step.side)
            sines.append(sine)
        x, slope, signed = (np.empty((t.size, len(of))) for of in (values, values, sines))
        for table, columns in ((x, values.values()), (slope, [rates[name] for name in values]), (signed, sines)):
            for k, value in enumerate(columns):
                table[:, k] = value
        return Nodes(t, x, slope, signed)


class _ContinuationWalk:
    """One direction of a path: positions, change points, what ended it, and where loci only came near (`missed`)."""

    def __init__(self, finder: NodeFinder, path: DriverPath, side: int) -> None:
        self.finder, self.path, self.side, method = finder, path, side, finder.method
        self.sides = dict(path.sides)
        self.stops: tuple[Event, ...] = ()
        self.changes: tuple[Event, ...] = ()
        self.missed, self.growth = -np.inf, GROWTH
        self.stride = stride(method, path.pace, STEP_DEG, STEP_PART)
        self.keys = (*finder.crossings,)
        rolled = {step.angle for step in method.position.steps if isinstance(step, Roll)}
        self.heard = np.array([name not in rolled for name in finder.names])
        self.units = np.array([1.0 if name in method.structure.bases else method.size for name in finder.names])
        self.nodes = finder.start

    @property
    def at(self) -> float:
        """The place of the last position found."""
        return float(self.nodes.t[-1])

    @property
    def longest(self) -> float:
        """The longest step here: no link goes too far."""
        return float(self._longest(self.nodes[-1:])[0])

    def walk(self, end: float) -> None:
        step = FIRST * self.longest
        while self.side * (end - self.at) > 1e-12 * self.stride:
            step = min(step, self.longest)
            if step < SHORTEST * self.stride:  # the path ends here, to the last digit, at the crossing that is flattest
                flattest = self.keys[int(np.argmin(np.abs(self.nodes.sines[-1])))]
                self.stops = (event_at(self.finder.method, self.finder.crossings[flattest], self.at, ()),)
                return
            if len(self.nodes) > 1 and self._soon(self.nodes[-2:-1], self.nodes[-1:])[0]:  # a crossing is nearly flat
                place = float(self._flat_in(self.nodes[-2:-1], self.nodes[-1:]).min())
            else:
                place = None
            if place is not None and self._through(place):
                step = self.longest
            else:
                step = self._stretch(step, end) or self._shorter(step, end) or step / 2**HALVINGS

    def _stretch(self, step: float, end: float) -> float:
        """Some steps as far as each goes on smoothly; the length of the next one, 0 where halving is to find it."""
        if step <= FELT * self.stride:
            return 0.0
        # lengths of the next steps, each a little longer than the one before, as links turn there as foretold (k,)
        growing = np.maximum(self.growth ** np.arange(STRETCH), LEAST)
        steps = np.minimum(step * growing, self.longest)
        x, slope = self.nodes.expected(self.at + self.side * np.cumsum(steps))
        turning = FARTHEST / np.maximum(self._largest(slope, x), 1e-300)
        far = np.asarray(np.minimum(steps, np.append(self.longest, turning[:-1])))
        t = self._not_beyond(self.at + self.side * np.cumsum(far), end)
        nodes = self.finder.at(t, self.nodes.foretold(t), self.sides, QUICK)
        count, off = self._going_on(nodes)
        self.nodes = self.nodes.and_then(nodes[:count])
        if not count and off[0] == np.inf:
            return 0.0
        here = min(count, t.size - 1)
        if off[here] < np.inf:  # what is foretold is off by the fourth power of the step
            step = float(far[here]) * min(GROWTH, STEADY * max(float(off[here]), 1e-3) ** -0.25)
            self.growth = min(GROWTH, step / float(far[max(here - 1, 0)]))
            return step
        return float(far[here])

    def _not_beyond(self, t: np.ndarray, end: float) -> np.ndarray:
        """Places as far as the end, the last of them there where it is no farther than a step."""
        before = np.count_nonzero(self.side * (end - t) > 1e-3 * np.abs(np.diff(t, prepend=self.at)))
        return t if before == t.size else np.append(t[:before], end)

    def _shorter(self, step: float, end: float) -> float:
        """One step, halved until the links come to where they were expected, and fits stay on their side of change
        points; the length of the next one, 0 where none does."""
        steps = step / 2.0 ** np.arange(HALVINGS)
        steps = steps[steps >= SHORTEST * self.stride]
        t = self.at + self.side * steps
        t[0] = self._not_beyond(t[:1], end)[0]
        expected = self.nodes.expected(t)
        for compass in (QUICK, LONGER) if step > FELT * self.stride else (LONGER,):
            nodes = self.finder.at(t, expected[0], self.sides, compass)
            for k in np.flatnonzero(self._off(nodes, *expected, np.abs(t - self.at)) < 1):
                node = nodes[k : k + 1]
                over = (node.sines * self.nodes.sines[-1:] < 0)[0]  # crossings beyond a change point
                turning = [key for key, beyond in zip(self.keys, over) if beyond]
                if not turning:
                    self.nodes = self.nodes.and_then(node)
                if not turning or self._gone_through(node, turning):
                    return float(steps[k] if k else GROWTH * step)
        return 0.0

    def _going_on(self, nodes: Nodes) -> tuple[int, np.ndarray]:
        """The number of positions that go on smoothly, each from those before it, until a crossing is about to be flat.
        Also how far each is off, as part of what it may be (k,)."""
        before = self.nodes[-2:]
        chain = before.and_then(nodes)
        here, last = chain[len(before) :], chain[len(before) - 1 : -1]
        x, slope = cubic(chain[:-2], chain[1:-1], chain.t[2:])
        if len(before) == 1:
            first = before.expected(nodes.t[:1])
            x, slope = (np.concatenate(pair) for pair in zip(first, (x, slope)))
        steps, longest = np.abs(here.t - last.t), self._longest(last)
        off = self._off(here, x, slope, steps)
        turning = (here.sines * last.sines < 0).any(axis=1)
        off[turning] = np.inf
        smooth = (off < 1) & (steps <= 1.1 * longest)
        count = int(smooth.size if smooth.all() else np.argmin(smooth))
        if flat := np.flatnonzero(self._soon(last[:count], here[:count])).tolist():
            count = min(count, flat[0] + 1)
        return count, off

    def _off(self, nodes: Nodes, x: np.ndarray, slope: np.ndarray, steps: np.ndarray) -> np.ndarray:
        """The distance of links from where they were expected, or from being as fast, as part of the bounds (k,)."""
        away = self._largest(nodes.x - x, x) / AWAY
        swerve = self._largest(nodes.slope - slope, x) * steps / SWERVE
        finite = np.isfinite(nodes.x).all(axis=1) & np.isfinite(nodes.slope).all(axis=1)
        return np.where(finite, np.maximum(away, swerve), np.inf)

    def _largest(self, change: np.ndarray, x: np.ndarray) -> np.ndarray:
        """The largest of changes (k, n) [rad, lengths]; of a displacement far off, as part of it."""
        scale = np.where(self.units == 1.0, 1.0, np.maximum(np.abs(x), self.units))
        return np.asarray(np.max(np.abs(change / scale)[:, self.heard], axis=1, initial=0.0))

    def _longest(self, nodes: Nodes) -> np.ndarray:
        turning = np.maximum(self._largest(nodes.slope, nodes.x), 1e-300)
        return np.asarray(np.minimum(self.stride, FARTHEST / turning))

    def _soon(self, before: Nodes, here: Nodes) -> np.ndarray:
        """True where a crossing is about to become flat, and was not found to miss that (k,)."""
        ahead, longest = self._flat_in(before, here).min(axis=1, initial=np.inf), self._longest(here)
        return np.asarray((ahead < SOON * longest) & (self.side * here.t + ahead - self.missed > longest))

    def _flat_in(self, before: Nodes, here: Nodes) -> np.ndarray:
        """The distance to where each crossing becomes flat (k, crossings); infinite where it does not."""
        falls = (np.abs(before.sines) - np.abs(here.sines)) / np.abs(here.t - before.t)[:, None]
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(falls > 0, np.abs(here.sines) / falls, np.inf)

    def _through(self, ahead: float) -> bool:
        """One step over a place where crossings become flat, with these changed over."""
        far = ahead + max(ahead, self.longest / 2)
        flat = self._flat_in(self.nodes[-2:-1], self.nodes[-1:])[0]
        turning = [key for key, place in zip(self.keys, flat) if place < far]
        sides = dict(self.sides)
        for key in turning:
            step = self.finder.crossings[key]
            if isinstance(step, Meet | Swing) and step.choice is not None:
                sides[step.choice] = -sides[step.choice]
        t = np.array([self.at + self.side * far])
        expected = self.nodes.expected(t)
        for compass in (QUICK, LONGER):
            node = self.finder.at(t, expected[0], sides, compass)
            if self._off(node, *expected, np.array([far]))[0] < 1:
                if self._gone_through(node, turning):
                    return True
                break
        self.missed = self.side * self.at + ahead
        return False

    def _gone_through(self, beyond: Nodes, turning: Sequence[str]) -> bool:
        """Take the change points between here and there, if each crossing that changes over touches."""
        here, there, path = self.at, float(beyond.t[0]), self.so_far(self.nodes[-1:], beyond)
        steps = [self.finder.crossings[key] for key in turning]
        touches = [touching(self.finder.method, path, step, here, there) for step in steps]
        places = [place for place in touches if place is not None]
        if not places or len(places) < len(touches):
            return False
        for step, place in sorted(zip(steps, places, strict=True), key=lambda entry: self.side * entry[1]):
            choice = choice_of(step)
            event = event_at(self.finder.method, step, place, choice)
            self.changes = (*self.changes, event if choice else replace(event, kind="two ways"))
            self.sides |= {number: -self.sides[number] for number in choice}
        self.nodes = self.nodes.and_then(beyond)
        return True

    def so_far(self, *nodes: Nodes) -> DriverPath:
        """The path through these positions, with what lies between them."""
        t, x = nodes[0].and_then(nodes[1]).in_order().between(BETWEEN)
        return replace(self.path, nodes=(t, dict(zip(self.finder.names, x.T))), changes=self.changes)
