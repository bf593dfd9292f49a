"""Looking along a way for dead points, where it ends, and for change points, which it goes through.

Between positions half a degree apart, the angle under which two loci cross is looked at more closely where it is small:
the loci part (a dead point), touch (a change point, or parallel lines), or neither.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from graphkin.geometry import Value
from graphkin.methods.assembly import links_of
from graphkin.methods.far import refuse_far
from graphkin.methods.method import Method
from graphkin.methods.way import Event, Way, along, stride, with_nodes
from graphkin.steps import Arc, Fit, Meet, Plot, Swing, replay, slide_key

__all__ = ["Crossing", "by_slide_key", "crossings", "event_at", "key_of", "look_along", "touching", "turned"]

LOOK_DEG, LOOK_PART = 0.5, 0.002
"""How closely the way is looked at [deg, of the mechanism's size]."""
TOUCH = 1e-11
"""Circles that miss each other by less than this part of the mechanism's size touch."""
TOUCHING_SINE = 3e-6
"""The sine to which two loci come down, as closely as it is looked at, where they touch."""
LOW_SINE = 0.3
"""Below this a least angle between two loci is looked at more closely."""
ROUNDS, FINE = 3, 201
FAST, HALVINGS = 0.5, 6
"""Where a link turns more between two positions [rad], those between are looked at, too; so often."""
CENTRING = 1e-3
"""How far to both sides of a touching it is weighed, as part of how closely the way is looked at."""

Crossing = Meet | Swing | Fit


def look_along(
    method: Method, pace: Sequence[float], low: float, high: float, after: tuple[Way, float] | None = None
) -> Way:
    """Look along the way from t = low to t = high (low <= 0 <= high) for stops and change points.

    after   a place on another way, to start from there instead of from the drawn position
    """
    from graphkin.methods.walking import walked

    way = _setting_out(method, tuple(float(p) for p in pace), (float(low), float(high)), after)
    refuse_far(method, way, LOOK_DEG, LOOK_PART)
    if method.fits:
        return walked(method, way)
    for end in (high, low):
        way = _scouted(method, way, end)
    return way


def _setting_out(
    method: Method, pace: tuple[float, ...], ends: tuple[float, float], after: tuple[Way, float] | None
) -> Way:
    """A way of which only its start is known."""
    if after is None:
        start = tuple(float(value) for value in method.facts(None).values)
        near, sides = dict(method.near), _sides(method)
    else:
        before, t = after
        start = tuple(float(value) for value in before.values(t))
        near = before.near(t)
        sides = {choice: int(side) for choice, side in before.crossings(t).items()}
    nodes = (np.zeros(1), {name: np.full(1, value) for name, value in near.items()})
    return Way(start, pace, *ends, nodes=nodes if method.moves_on else None, sides=sides)


def _sides(method: Method) -> dict[int, int]:
    steps = method.position.steps
    return {step.choice: step.side for step in steps if isinstance(step, Meet | Swing) and step.choice is not None}


# --- looking ----------------------------------------------------------------------------------


def _scouted(method: Method, way: Way, end: float) -> Way:
    """The way with what lies between the drawn position and `end` on it."""
    begin, step = 0.0, stride(method, way.pace, LOOK_DEG, LOOK_PART)
    side = 1.0 if end > 0 else -1.0
    while side * (end - begin) > 1e-6 * step:
        count = int(np.ceil(abs(end - begin) / step)) + 2
        seen, t, plot = _seen(method, way, np.linspace(begin, end, count))
        event = _next_event(method, seen, t, plot)
        if event is None:
            return seen
        way = _as_far_as(seen, event.at)
        if not event.choices:
            return replace(way, stops=(*way.stops, event))
        way = replace(way, changes=(*way.changes, event))
        begin = event.at + side * 1e-3 * step
    return way


def _seen(method: Method, way: Way, t: np.ndarray) -> tuple[Way, np.ndarray, Plot]:
    """The plot at t, from the drawn position on to one side; where rolling counts, each position from the one before.

    There the way gets what is found as its nodes, and more positions where a link turns fast.
    """
    if way.nodes is None:
        return way, t, along(method, way, t)
    near = way.near(float(t[0]))
    for halving in range(HALVINGS + 1):
        plot = Plot(method.facts(way.values(t)), near, follows=True)
        replay(method.position, plot, way.crossings(t))
        tables = {name: np.array(np.broadcast_to(value, t.shape)) for name, value in turned(method, plot).items()}
        fast = np.max([np.abs(np.diff(tables[base])) for base in method.structure.bases], axis=0, initial=0.0) > FAST
        if not fast.any() or halving == HALVINGS:
            break
        t = np.insert(t, np.flatnonzero(fast) + 1, (t[:-1] + t[1:])[fast] / 2)
    return with_nodes(way, t, {name: _filled(t, table) for name, table in tables.items()}), t, plot


def turned(method: Method, plot: Plot) -> dict[str, Value]:
    """Angles by base link, and displacements by `slide_key`."""
    return {base: plot.theta[base] for base in method.structure.bases} | by_slide_key(plot.s)


def by_slide_key(displacements: Mapping[str, Value]) -> dict[str, Value]:
    """Displacements, or how fast they change, named as `near` has them."""
    return {slide_key(slide): value for slide, value in displacements.items()}


def _filled(t: np.ndarray, table: np.ndarray) -> np.ndarray:
    """A table with what lies between where a position has no value of its own."""
    there = np.isfinite(table)
    order = np.argsort(t[there])
    return table if there.all() or not there.any() else np.interp(t, t[there][order], table[there][order])


def _as_far_as(way: Way, end: float) -> Way:
    """The way without nodes beyond `end`."""
    if way.nodes is None:
        return way
    t, tables = way.nodes
    kept = t <= end if end > 0 else t >= end
    return replace(way, nodes=(t[kept], {name: table[kept] for name, table in tables.items()}))


def _next_event(method: Method, way: Way, t: np.ndarray, plot: Plot) -> Event | None:
    """The first stop or change point among positions t, in their order."""
    found: list[tuple[float, Crossing, bool]] = []
    for step in crossings(method):
        if (met := _first(method, way, t, step, plot)) is not None:
            found.append((met[0], step, met[1]))
    if not found:
        return None
    nearest = min(abs(place - t[0]) for place, _, _ in found)
    here = [entry for entry in found if abs(entry[0] - t[0]) < nearest + 1e-3 * abs(t[1] - t[0])]
    at, step, passes = here[0]
    choices = tuple(choice for _, other, through in here if through for choice in _choice(other))
    return event_at(method, step, at, choices if passes else ())


def crossings(method: Method) -> Iterator[Crossing]:
    """The steps of the position that may fail, without special points."""
    names = {ternary.name for ternary in method.ternaries.values()}
    for step in method.position.steps:
        if isinstance(step, Meet | Swing | Fit) and key_of(step) not in names:
            yield step


def key_of(step: Crossing) -> str:
    """The name under which a plot keeps the angle of a crossing."""
    return step.point if isinstance(step, Meet) else step.slide if isinstance(step, Swing) else step.name


def event_at(method: Method, step: Crossing, at: float, choices: tuple[int, ...]) -> Event:
    """A stop, or a change point where choices change over, at a crossing."""
    return Event(at, _kind(step), _called(method, step), choices)


def _choice(step: Crossing) -> tuple[int, ...]:
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


def _called(method: Method, step: Crossing) -> tuple[str, ...]:
    return tuple(method.mechanism.called(link) for link in links_of(method.structure, step))


def _first(method: Method, way: Way, t: np.ndarray, step: Crossing, plot: Plot) -> tuple[float, bool] | None:
    """Where the two loci of a crossing first touch or part, and whether the mechanism goes through."""
    sine, miss = _angle(method, step, plot, t.shape)
    apart = ~np.isfinite(sine) | (miss > 0)
    low = _lows(sine) & ~apart
    for k in map(int, np.flatnonzero(low | apart)):
        around = float(t[max(k - 1, 0)]), float(t[min(k + 1, t.size - 1)])
        if (found := _closer(method, way, step, *around)) is not None:
            return found
        if apart[k]:
            return float(t[max(k - 1, 0)]), False
    return None


def _lows(sine: np.ndarray) -> np.ndarray:
    """Local minima of the sine that are worth a closer look."""
    low = np.zeros(sine.shape, dtype=bool)
    with np.errstate(invalid="ignore"):
        low[1:-1] = (sine[1:-1] <= sine[:-2]) & (sine[1:-1] <= sine[2:]) & (sine[1:-1] < LOW_SINE)
        low[-1] = sine[-1] < 0.01
    return low


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


def _closer(method: Method, way: Way, step: Crossing, begin: float, end: float) -> tuple[float, bool] | None:
    """Look closer between two positions: (where, whether it goes through), None where nothing happens."""
    parted: float | None = None
    for _ in range(ROUNDS):
        t = np.linspace(begin, end, FINE)
        sine, miss = _angle(method, step, along(method, way, t), t.shape)
        apart = np.flatnonzero(~np.isfinite(sine) | (miss > 0))
        if apart.size and parted is None:
            parted = _edge(method, way, step, t, int(apart[0]))
        k = _lowest(sine[: apart[0]] if apart.size else sine)
        if k is None:
            return (parted, False) if parted is not None else None
        begin, end = float(t[max(k - 1, 0)]), float(t[min(k + 1, FINE - 1)])
    if sine[k] > TOUCHING_SINE:
        return (parted, False) if parted is not None else None
    centre = _centred(method, way, step, float(t[k]))
    if not np.isfinite(centre):  # they part on one side: as flat as this only by rounding
        return (float(t[k]) if parted is None else parted), False
    return centre, _kind(step) != "parallel"


def touching(method: Method, way: Way, step: Crossing, begin: float, end: float) -> float | None:
    """Where the loci of a crossing touch between two places, to go on beyond; None where they do not."""
    found = _closer(method, way, step, begin, end)
    return found[0] if found is not None and found[1] else None


def _lowest(sine: np.ndarray) -> int | None:
    """The first dip of the sine; without parting behind it, its least value. None where it falls until loci part."""
    whole = sine.size == FINE
    if sine.size > 2:
        dips = np.flatnonzero((sine[1:-1] <= sine[:-2]) & (sine[1:-1] <= sine[2:])) + 1
        if dips.size:
            return int(dips[np.argmin(sine[dips])])
    return int(np.argmin(sine)) if whole else None


def _centred(method: Method, way: Way, step: Crossing, at: float) -> float:
    """Where the sine, which falls and rises in straight lines, comes to 0."""
    aside = CENTRING * stride(method, way.pace, LOOK_DEG, LOOK_PART)
    t = at + aside * np.array([-1.0, 1.0])
    (before, after), _ = _angle(method, step, along(method, way, t), t.shape)
    return at + aside * float((before - after) / (before + after))


def _edge(method: Method, way: Way, step: Crossing, t: np.ndarray, k: int) -> float:
    """The last position at which the loci still meet, before position k."""
    if k == 0:
        return float(t[0])
    begin, end = float(t[k - 1]), float(t[k])
    for _ in range(5):
        t = np.linspace(begin, end, FINE)
        sine, miss = _angle(method, step, along(method, way, t), t.shape)
        apart = ~np.isfinite(sine) | (miss > 0)
        first = int(np.flatnonzero(apart)[0]) if apart.any() else FINE - 1
        begin, end = float(t[max(first - 1, 0)]), float(t[first])
    return begin
