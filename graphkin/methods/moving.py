"""Other positions: whether a mechanism gets there from the drawn one, and how, where each hangs on the one before."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from graphkin.errors import NotReached
from graphkin.geometry import Value
from graphkin.methods.looking import crossings, event_at, key_of, look_along, turned
from graphkin.methods.swift import in_parts
from graphkin.methods.way import Event, Way, along, stride
from graphkin.steps import Fit, Plot, replay

if TYPE_CHECKING:
    from graphkin.methods import Method

__all__ = ["moved_to", "reached", "walked"]

STEP_DEG, STEP_PART = 3.0, 0.02
"""How far a mechanism is moved at once where its position is found from the one before [deg, of its size]."""
SURPRISE = 0.02
"""How far a link may turn beside what its turning so far foretold [rad]; more, and the step is halved."""
SWERVE, SLIP = 0.15, 0.005
"""How much the turning over a step may differ at its two ends, and from their mean [rad]: another branch does."""
SHORTEST = 1 / 256
"""Steps are not halved below this part of the longest, for many positions at once."""
CROSSING = 2e-5
"""Through a change point only by steps this much shorter than the longest; longer ones could cut across."""
FLAT_SINE = 0.1
"""Crossings under a smaller angle may change over where the way is stuck."""


# --- single positions -------------------------------------------------------------------------


def reached(method: Method, values: Sequence[Value]) -> tuple[Way, float]:
    """The way to a position, and how far on it; the other way round where only that one is free of dead points."""
    way, t = _to(method, values)
    if not way.leads_to(t):
        other = _other_way_round(method, values)
        second, far = _to(method, other)
        if method.structure.contacts or not second.leads_to(far):
            raise _not_reached(method, way, t)
        return second, far
    return way, t


def _to(method: Method, values: Sequence[Value]) -> tuple[Way, float]:
    """The straight way from the drawn position: t counts the driver that goes farthest."""
    start = np.array([float(value) for value in method.facts(None).values])
    change = np.array([float(value) for value in values]) - start
    t = float(np.max(np.abs(change), initial=0.0))
    pace = change / t if t else np.zeros_like(change)
    return look_along(method, tuple(pace), 0.0, t), t


def _other_way_round(method: Method, values: Sequence[Value]) -> Sequence[Value]:
    start = method.facts(None).values
    return [
        end - np.copysign(2 * np.pi, end - begin) if driver.kind == "angle" and end != begin else end
        for begin, end, driver in zip(start, values, method.drivers, strict=True)
    ]


def _not_reached(method: Method, way: Way, t: float) -> NotReached:
    moving = int(np.argmax(np.abs(way.pace)))
    driver = method.drivers[moving]

    def told(at: float) -> str:
        value = float(way.values(at)[moving])
        return f"{value * 1000:.6g} mm" if driver.kind == "slide" else f"{np.degrees(value):.6g}°"

    where = method.mechanism.where("driver", moving)
    return NotReached(where, driver.name, told(0.0), told(t), told(way.last))


# --- positions --------------------------------------------------------------------------------


def moved_to(method: Method, values: Sequence[Value]) -> Plot:
    """One position, reached from the drawn one; or many, all at once.

    Where each position hangs on the one before (a fit, rolling) the many are reached by moving on, too.
    """
    if not any(np.ndim(value) for value in values):
        return along(method, *reached(method, values))
    if not method.moves_on:
        return replay(method.position, Plot(method.facts(values)))
    return _moved_on(method, values)


def _moved_on(method: Method, values: Sequence[Value]) -> Plot:
    """Positions each on its own way, or on one: step by step, each foretold from the two before."""
    start = np.array(method.facts(None).values)
    change = np.array([value - begin for value, begin in zip(np.broadcast_arrays(*values), start, strict=True)])
    far = change.reshape(len(start), -1)
    line = far[:, int(np.argmax(np.abs(far).sum(axis=0)))]
    along_it = np.tensordot(line, change, 1) / max(float(line @ line), np.finfo(float).tiny)
    if np.allclose(np.multiply.outer(line, along_it), change, rtol=0, atol=1e-12):
        way = look_along(method, tuple(line), float(min(along_it.min(), 0.0)), float(max(along_it.max(), 0.0)))
        return in_parts(method, way, np.where(way.leads_to(along_it), along_it, np.nan)[()])
    return _fanned(method, values)


def _fanned(method: Method, values: Sequence[Value]) -> Plot:
    """Every position on its own straight way; a step that surprises one of them is halved for all."""
    facts = method.facts(values)
    start = method.facts(None).values
    ways = [np.asarray(end) - begin for begin, end in zip(start, facts.values, strict=True)]
    farthest = tuple(float(np.max(np.abs(way))) for way in ways)
    longest = min(1.0, stride(method, farthest, STEP_DEG, STEP_PART))
    done, step = 0.0, longest
    near: dict[str, Value] = {**method.near}
    slope: dict[str, Value] = dict.fromkeys(near, 0.0)
    while True:
        there = min(1.0, done + step)
        at = tuple(begin + way * there for begin, way in zip(start, ways, strict=True))
        guess = {name: near[name] + slope[name] * (there - done) for name in near}
        plot = replay(method.position, Plot(replace(facts, values=at), guess))
        now = turned(method, plot)
        if _surprise(now, guess, method.structure.bases) > SURPRISE and step > longest * SHORTEST:
            step /= 2
            continue
        if there == 1.0:
            return plot
        slope = {name: np.nan_to_num((now[name] - near[name]) / (there - done)) for name in now}
        near, done, step = now, there, min(longest, 1.5 * step)


def _surprise(now: Mapping[str, Value], guess: Mapping[str, Value], bases: Sequence[str]) -> float:
    """The largest angle between where links are and where they were expected."""
    return max((float(np.nanmax(np.abs(now[b] - guess[b]), initial=0.0)) for b in bases), default=0.0)


# --- one way, step by step --------------------------------------------------------------------


def walked(method: Method, way: Way) -> Way:
    """The way walked in steps both ways from the drawn position; it ends where no step leads on."""
    forth, back = _Walk(method, way), _Walk(method, way)
    forth.walk(way.high)
    back.walk(way.low)
    t = np.array([*back.at[:0:-1], *forth.at])
    nodes = [*back.found[:0:-1], *forth.found]
    tables = {name: np.array([node[name] for node in nodes]) for name in nodes[0]}
    return replace(
        way, stops=(*back.stops, *forth.stops), changes=(*back.changes, *forth.changes), nodes=(t, tables)
    )


class _Walk:
    """One direction of a way: nodes found so far, change points gone through, and what ended it.

    found, slopes   angles by base link and displacements at each node, and their change with t
    """

    def __init__(self, method: Method, way: Way) -> None:
        self.method, self.way = method, way
        self.sides = dict(way.sides)
        self.stops: tuple[Event, ...] = ()
        self.changes: tuple[Event, ...] = ()
        self.longest = stride(method, way.pace, STEP_DEG, STEP_PART)
        now, slope, self.senses = self._looked_at(0.0, way.near(0.0), self.sides)
        self.at, self.found, self.slopes = [0.0], [now], [slope]

    def walk(self, end: float) -> None:
        step = longest = self.longest
        while abs(end - self.at[-1]) > 1e-12 * longest:
            if self._taken(self._ahead(end, step), self.sides):
                step = min(longest, 1.5 * step)
            elif step > longest * CROSSING:
                step /= 2
            elif not self._through(end, 64 * step):
                self._stop(end, step)
                return

    def _ahead(self, end: float, step: float) -> float:
        way = end - self.at[-1]
        return end if abs(way) <= step else self.at[-1] + float(np.copysign(step, way))

    def _looked_at(
        self, t: float, near: Mapping[str, Value], sides: Mapping[int, int]
    ) -> tuple[dict[str, float], dict[str, float], dict[str, Value]]:
        """Angles and displacements at t, how they change with it, and the senses of what is fitted."""
        facts = replace(self.method.facts(self.way.values(t)), rates=self.way.pace)
        plot = replay(self.method.velocity, replay(self.method.position, Plot(facts, near), sides))
        now = {name: float(value) for name, value in turned(self.method, plot).items()}
        rates = {**plot.omega, **plot.s_rate}
        return now, {name: float(rates[name]) for name in now}, plot.senses

    def _taken(self, ahead: float, sides: Mapping[int, int]) -> bool:
        """One step, if the links come to where they were expected, and go on as they did."""
        step, before, slope = ahead - self.at[-1], self.found[-1], self.slopes[-1]
        guess = {name: value + slope[name] * step for name, value in before.items()}
        now, then, senses = self._looked_at(ahead, guess, sides)
        if not all(map(np.isfinite, now.values())):
            return False
        if senses != self.senses and abs(step) > self.longest * CROSSING:
            return False
        secant = {name: (now[name] - before[name]) / step for name in now}
        then = {name: value if np.isfinite(value) else secant[name] for name, value in then.items()}
        for base in self.method.structure.bases:
            swerve = abs(then[base] - slope[base]) * abs(step)
            slip = abs((then[base] + slope[base]) / 2 - secant[base]) * abs(step)
            if swerve > SWERVE or slip > SLIP:
                return False
        self.at.append(ahead)
        self.found.append(now)
        self.slopes.append(then)
        self.senses = senses
        return True

    def _through(self, end: float, step: float) -> bool:
        """Through a change point, if crossings under small angles, changed over, lead on."""
        plot = along(self.method, self._so_far(), self.at[-1])
        here = self.at[-1]
        for crossing in crossings(self.method):
            if isinstance(crossing, Fit) or crossing.choice is None:
                continue
            if float(plot.sines["position", key_of(crossing)]) > FLAT_SINE:
                continue
            changed = self.sides | {crossing.choice: -self.sides[crossing.choice]}
            if self._taken(self._ahead(end, step), changed):
                self.sides = changed
                at = (here + self.at[-1]) / 2
                self.changes = (*self.changes, event_at(self.method, crossing, at, (crossing.choice,)))
                return True
        return False

    def _so_far(self) -> Way:
        """The way as far as it has been walked."""
        t = np.array(self.at)
        order = np.argsort(t)
        tables = {name: np.array([node[name] for node in self.found])[order] for name in self.found[0]}
        return replace(self.way, nodes=(t[order], tables), changes=self.changes)

    def _stop(self, end: float, step: float) -> None:
        """The way ends here: where, to the last digit that stepping on gives, and at which crossing."""
        smallest = 1e-9 * self.longest
        while step > smallest:
            if not self._taken(self._ahead(end, step), self.sides):
                step /= 2
        plot = along(self.method, self._so_far(), self.at[-1])
        flattest = min(crossings(self.method), key=lambda step: float(plot.sines["position", key_of(step)]))
        self.stops = (event_at(self.method, flattest, self.at[-1], ()),)
