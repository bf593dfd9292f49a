"""Links tried until they fit: positions that no ruler and compass gives, found by Newton's method."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from graphkin.base.geometry import Value
from graphkin.construction.gaps import Gaps
from graphkin.construction.kinds import Fit, Simultaneous
from graphkin.construction.linear import least, sense, solved
from graphkin.construction.plot import Plot, slide_key
from graphkin.construction.terms import Arm

ROUNDS = 30
FITTED = 1e-8
"""The last step at most [rad, of the group's size]; what it leaves is of the order of its square."""
ROUNDING, ROUNDED = 1e-5, 0.8
"""Steps so short that become no shorter than by this factor come of rounding: the links are all but free to move."""
GAP = 1e-10
"""The gap that is left at most, in units of the group's size."""


def fit(step: Fit, plot: Plot, rounds: int = ROUNDS) -> None:
    """Newton's method on the closures and contacts of a group, for all positions at once."""
    gaps, before = Gaps(step, plot, reach(step, plot)), np.inf
    x = _first_trial(step, plot, gaps)
    for _ in range(rounds):
        x, moved = _next_trial(gaps, x)
        farthest = np.max(moved, where=np.isfinite(moved), initial=0.0)
        if farthest <= FITTED or ROUNDED * before < farthest < ROUNDING:
            break
        before = farthest
    _keep_what_fits(step, plot, x, gaps)


def unknowns_of(step: Fit | Simultaneous) -> tuple[str, ...]:
    """What is to be found, as rows name it."""
    return step.angles + tuple(map(slide_key, step.slides))


def _first_trial(step: Fit, plot: Plot, gaps: Gaps) -> np.ndarray:
    """The unknowns at the position close by, over positions (.., n)."""
    x = np.empty((*_shape(plot, gaps), len(step.angles) + len(step.slides)))
    for k, name in enumerate(unknowns_of(step)):
        x[..., k] = plot.near[name]
    return x


def _shape(plot: Plot, gaps: Gaps) -> tuple[int, ...]:
    """Of the positions; where nothing differs so far but the group's own links or lines, over these."""
    tables = (plot.position, plot.theta, plot.s, plot.near)
    shapes = {value.shape for table in tables for value in table.values() if isinstance(value, np.ndarray)}
    return np.broadcast_shapes(gaps.shape, *shapes)


def reach(step: Fit, plot: Plot) -> float:
    """The longest arm of a group: what its gaps are measured by [m]."""
    arms = [part for closure in step.closures for part in closure.parts if isinstance(part, Arm)]
    shapes = plot.facts.shapes
    lengths = [_longest(shapes[a.link][a.head] - shapes[a.link][a.tail]) for a in arms]
    return max([*lengths, *(_longest(c) for contact in step.contacts for _, c in contact.angles)]) or 1.0


def _longest(arm: Value) -> float:
    return float(np.max(np.abs(arm))) if isinstance(arm, np.ndarray) else float(abs(arm))


def _next_trial(gaps: Gaps, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """One step of Newton's method, of half a unit at most, and how long the whole step would be in units."""
    gap, slope = gaps.at(x)
    change = solved(slope, gap)
    moved = np.abs(change).max(axis=-1)
    return x - change * gaps.units / np.maximum(1.0, moved / 0.5)[..., None], moved


def _keep_what_fits(step: Fit, plot: Plot, x: np.ndarray, gaps: Gaps) -> None:
    """The positions at which the group closes; NaN at the others, and by how much it misses there."""
    gap, slope = gaps.at(x)
    widest = np.abs(gap).max(axis=-1)
    fits = widest < GAP
    settle_all(step, plot, np.moveaxis(np.where(fits[..., None], x, np.nan), -1, 0))
    plot.senses[step.name] = sense(slope)
    plot.sines["position", step.name] = np.where(fits, least(slope), np.nan)[()]
    plot.misses[step.name] = np.where(fits, 0.0, widest * gaps.size)[()]


def sense_and_sine(step: Fit, plot: Plot) -> tuple[Value, Value]:
    """The same of a group that is found, where somebody wants to know."""
    found = (*(plot.theta[base] for base in step.angles), *(plot.s[slide] for slide in step.slides))
    gaps = Gaps(step, plot, reach(step, plot))
    x = np.stack(np.broadcast_arrays(*found, np.empty(_shape(plot, gaps)))[:-1], axis=-1)
    slope = gaps.at(x)[1]
    return sense(slope), least(slope)[()]


def settle_all(step: Fit, plot: Plot, x: Iterable[Value]) -> None:
    """The unknowns, in their order, as angles and displacements of the plot."""
    found = [value[()] if isinstance(value, np.ndarray) else value for value in x]
    for base, value in zip(step.angles, found):
        plot.settle("theta", base, value, counted=True)
    plot.s.update(zip(step.slides, found[len(step.angles) :], strict=True))
