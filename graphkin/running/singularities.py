"""Singular positions: dead points, where a path ends, and change points, which it goes through.

Between two positions, the angle under which two loci cross is looked at more closely where it is small: the loci part
(a dead point), touch (a change point, or parallel lines), or neither.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphkin.base.cache import kept
from graphkin.base.geometry import weights_of
from graphkin.base.tolerances import TOUCH
from graphkin.construction import Arc, Fit, Meet, Plot, Swing
from graphkin.model.naming import spelled
from graphkin.planning.method import Method
from graphkin.planning.refusals import Crossing, key_of, links_of
from graphkin.running.path import DriverPath, Event, along, stride

LOOK_DEG, LOOK_PART = 0.5, 0.002
"""The steps in which the path is looked at [deg, of the mechanism's size]."""
TOUCHING_SINE = 3e-6  # the sine to which two loci come down, as closely as it is looked at, where they touch
LOW_SINE = 0.3  # below this a least angle between two loci is looked at more closely
FALLEN = 0.9
"""A sine that comes to 0 between two positions is less than this part of what it is at the one before or after them:
in straight lines it were a third. One that keeps its value has lows of rounding alone, and is not looked at."""
ROUNDS, FINE = 3, 201
FEW, CLOSE = 5, 0.01
"""Positions where a sine goes through 0, and how far from there others are looked at, as part of how far these are."""
CENTRING = 1e-3  # a touching is weighed so far to both sides, as part of the steps in which the path is looked at


def crossings(method: Method) -> Iterator[Crossing]:
    """The steps of the position that may fail, without special points."""
    names = {ternary.name for ternary in method.ternaries.values()}
    for step in method.position.steps:
        if isinstance(step, Meet | Swing | Fit) and key_of(step) not in names:
            yield step


def event_at(method: Method, step: Crossing, at: float, choices: tuple[int, ...]) -> Event:
    """A stop, or a change point where choices change over, at a crossing."""
    links = tuple(spelled(method.mechanism.called(link)) for link in links_of(method.structure, step))
    return Event(at, _kind(step), links, choices)


def choice_of(step: Crossing) -> tuple[int, ...]:
    """The number of its choice, where it has one."""
    return () if isinstance(step, Fit) or step.choice is None else (step.choice,)


def _kind(step: Crossing) -> str:
    match step:
        case Meet(Arc(), Arc()):
            return "in line"
        case Meet(_, Arc()):
            return "right angle"
        case Meet():
            return "parallel"
        case Swing():
            return "tangent"
        case Fit():
            return "fit"


def first_touching(
    method: Method, path: DriverPath, t: np.ndarray, step: Crossing, plot: Plot
) -> tuple[float, bool] | None:
    """The place where the two loci of a crossing first touch or part, and whether the mechanism goes through."""
    sine, miss = _angle(method, step, plot, t.shape)
    apart = ~np.isfinite(sine) | (miss > 0)
    low = np.zeros(sine.shape, dtype=bool)  # local minima of the sine that are worth a closer look
    with np.errstate(invalid="ignore"):
        low[1:-1] = (sine[1:-1] <= sine[:-2]) & (sine[1:-1] <= sine[2:]) & (sine[1:-1] < LOW_SINE)
        low[1:-1] &= sine[1:-1] <= FALLEN * np.fmax(sine[:-2], sine[2:])
        low[-1] = sine[-1] < 0.01
    low &= ~apart
    for k in map(int, np.flatnonzero(low | apart)):
        around = float(t[max(k - 1, 0)]), float(t[min(k + 1, t.size - 1)])
        if (met := _closer(method, path, step, *around)) is not None:
            return met
        if apart[k]:
            return float(t[max(k - 1, 0)]), False
    return None


def _angle(method: Method, step: Crossing, plot: Plot, shape: tuple[int, ...]) -> tuple[np.ndarray, np.ndarray]:
    """The sine of the angle of a crossing, 0 where its loci touch, and by how much they part [m]."""
    key = key_of(step)
    miss = np.array(np.broadcast_to(plot.misses.get(key, -np.inf), shape), dtype=float)
    sine = np.array(np.broadcast_to(plot.sines["position", key], shape), dtype=float)
    if isinstance(step, Swing):  # a line through its own pivot gives no angle where the point comes to the pivot
        sine = np.fmin(sine, np.abs(miss) / method.size)
    touching = np.abs(miss) <= TOUCH * method.size
    sine[touching & ~np.isfinite(sine)] = 0.0
    miss[touching] = 0.0
    return sine, miss


@kept(8, objects=2)
def _between(method: Method, path: DriverPath, begin: float, end: float) -> Plot:
    """The positions between two places, drawn once for all crossings: where one parts, all that follow from it do."""
    return along(method, path, np.linspace(begin, end, FINE))


def _closer(method: Method, path: DriverPath, step: Crossing, begin: float, end: float) -> tuple[float, bool] | None:
    """Look closer between two positions: (where, whether it goes through), None where nothing happens."""
    parted: float | None = None
    for _ in range(ROUNDS):
        t = np.linspace(begin, end, FINE)
        sine, miss = _angle(method, step, _between(method, path, begin, end), t.shape)
        apart = np.flatnonzero(~np.isfinite(sine) | (miss > 0))
        if apart.size and parted is None:
            parted = _edge(method, path, step, t, int(apart[0]))
        # the first dip of the sine; without parting behind it, its least value; none where it falls until loci part
        sine = sine[: apart[0]] if apart.size else sine
        dips = np.flatnonzero((sine[1:-1] <= sine[:-2]) & (sine[1:-1] <= sine[2:])) + 1 if sine.size > 2 else apart[:0]
        if not dips.size and sine.size < FINE:
            return (parted, False) if parted is not None else None
        k = int(dips[np.argmin(sine[dips])] if dips.size else np.argmin(sine))
        begin, end = float(t[max(k - 1, 0)]), float(t[min(k + 1, FINE - 1)])
    if sine[k] > TOUCHING_SINE:
        return (parted, False) if parted is not None else None
    centre = _centred(method, path, step, float(t[k]))
    if not np.isfinite(centre):  # they part on one side: as flat as this only by rounding
        return (float(t[k]) if parted is None else parted), False
    return centre, _kind(step) != "parallel"


def touching(method: Method, path: DriverPath, step: Crossing, begin: float, end: float) -> float | None:
    """The place where the loci of a crossing touch between two others, to go on beyond; None where they do not."""
    if isinstance(step, Fit) and (place := _turned_over(method, path, step, begin, end)) is not None:
        return place
    met = _closer(method, path, step, begin, end)
    return met[0] if met is not None and met[1] else None


def _turned_over(method: Method, path: DriverPath, step: Fit, begin: float, end: float) -> float | None:
    """The place where a fitted group comes to its other side, its sine through 0 as straight as may be; else None."""
    for _ in range(2):
        t = np.linspace(begin, end, FEW)
        plot = along(method, path, t)
        signed = np.asarray(plot.sines["position", step.name] * plot.senses[step.name])
        if not signed[0] * signed[-1] < 0 or not np.all(np.diff(signed) * (signed[-1] - signed[0]) > 0):
            return None
        at = float(weights_of(np.zeros(1), signed)[0] @ t)
        aside = CLOSE * (end - begin)
        begin, end = at - aside, at + aside
    centre = _centred(method, path, step, at)
    return centre if np.isfinite(centre) else None


def _centred(method: Method, path: DriverPath, step: Crossing, at: float) -> float:
    """The place where the sine, which falls and rises in straight lines, comes to 0."""
    aside = CENTRING * stride(method, path.pace, LOOK_DEG, LOOK_PART)
    t = at + aside * np.array([-1.0, 1.0])
    (before, after), _ = _angle(method, step, along(method, path, t), t.shape)
    return at + aside * float((before - after) / (before + after))


def _edge(method: Method, path: DriverPath, step: Crossing, t: np.ndarray, k: int) -> float:
    """The last position at which the loci still meet, before position k."""
    if k == 0:
        return float(t[0])
    begin, end = float(t[k - 1]), float(t[k])
    for _ in range(5):
        t = np.linspace(begin, end, FINE)
        sine, miss = _angle(method, step, _between(method, path, begin, end), t.shape)
        apart = ~np.isfinite(sine) | (miss > 0)
        first = int(np.flatnonzero(apart)[0]) if apart.any() else FINE - 1
        begin, end = float(t[max(first - 1, 0)]), float(t[first])
    return begin
