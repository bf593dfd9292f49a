"""A replay beside the analytic solution.

`proved` is the one reader of a position for whatever is drawn or told: it replays the construction, solves the
mechanism anew by the matrix method, and gives neither where they differ. `held` and `hold_rows` do so with numbers that
lie side by side in arrays, at a few places of them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from graphkin.analytic import Motion, mobility, motion
from graphkin.base.cache import kept
from graphkin.base.geometry import Real, Value, number
from graphkin.base.value import frozen
from graphkin.construction import Plot
from graphkin.errors import (
    GraphkinError,
    JoinedToNothing,
    RepeatedDriver,
    RoadsDiffer,
    TooFewDrivers,
    TooManyDrivers,
    UnevenLengths,
)
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.pairs import Rod
from graphkin.planning import Method
from graphkin.proof.readings import readings
from graphkin.running import replay_all

if TYPE_CHECKING:
    from graphkin.files.variants import Made, Variants
    from graphkin.running.variants import DrawnVariants

__all__ = ["AGREE", "PLACES", "Proved", "apart", "apart_each", "compare", "held", "hold_rows", "proved"]

AGREE = 1e-6  # results of the two roads that differ by more are not given; the tests hold them to 1e-9
PLACES = 12  # of many positions, or many mechanisms, both ends are held, and ten between
UNEVEN = 1e4  # a link so many times longer than another makes it doubtful what the digits say
FLAT = float(np.sin(np.radians(0.5)))
"""If lines meet under a smaller angle the mechanism stands at a dead point, and digits are lost."""

_Largest = Callable[[Sequence[Value]], Real]


@frozen
class Proved:
    """One position by both roads: the replayed construction, the analytic solution, and how far they differ."""

    plot: Plot
    exact: Motion
    worst: float


def proved(method: Method, values: Sequence[float] | None = None) -> Proved:
    """The drawn position, or the one at driver `values` [rad, m], proved. Raises RoadsDiffer where the two roads differ
    by more than `AGREE`, and what either road raises: dead points, positions that are not reached, mechanisms that
    cannot be assembled."""
    return _proved(method, None if values is None else tuple(map(number, values)))


@kept(64)
def _proved(method: Method, values: tuple[float, ...] | None) -> Proved:
    """One and the same plot, as often as it is asked for: by it sheets are kept."""
    plot = replay_all(method, values)
    exact = motion(method.mechanism, plot.facts.values)
    worst = compare(method, plot, exact)
    if not worst < AGREE:
        raise uneven(method.mechanism) or RoadsDiffer(method.mechanism.where("driver", 0), worst)
    return Proved(plot, exact, worst)


def held(method: Method, values: Sequence[Real] | None = None, compiled: bool | None = None) -> Plot:
    """A replay, and the analysis beside it: of arrays (n,) at both ends and at ten places between, once for as far as
    the drivers of a method go. Raises RoadsDiffer, and what single positions raise: NotReached beyond a dead point."""
    if values is None or not any(map(np.ndim, values)):
        _proved(method, None if values is None else tuple(map(number, values)))
        return replay_all(method, values)
    plot = replay_all(method, values, compiled)
    if not all(map(np.size, values)):
        return plot
    ends = [(np.fmin.reduce(value, axis=None), np.fmax.reduce(value, axis=None)) for value in plot.facts.values]
    known = _known(method)
    if not known or any(end[0] < low or end[1] > high for end, (low, high) in zip(ends, known, strict=True)):
        _hold(method, method.mechanism, plot, np.broadcast_arrays(*plot.facts.values))
        known[:] = ends
    return plot


@kept(64)
def _known(method: Method) -> list[tuple[float, float]]:
    """From where to where each driver was held [rad, m]; nothing yet."""
    return []


def hold_rows(
    method: Method, variants: Variants[Made], values: Sequence[Real] | None, drawn: DrawnVariants
) -> None:
    """Of many mechanisms drawn at once some, each by its own analysis. Raises RoadsDiffer."""
    from graphkin.running.variants import rows_of

    there = np.delete(np.arange(variants.count), [*drawn.refused])
    for row in map(int, there[_spread(there.size)]):
        each = (np.broadcast_to(value, (*np.shape(value)[:-1], variants.count)) for value in values or ())
        at = None if values is None else [value[..., row] for value in each]
        _hold(method, variants[row], rows_of(drawn.plot, row, Plot(drawn.plot.facts)), at)


def _hold(method: Method, mechanism: Mechanism, plot: Plot, values: Sequence[np.ndarray] | None) -> None:
    """Positions that are given, and are clear of dead points: evenly over how the drivers' values lie."""
    from graphkin.running.variants import rows_of

    if values is not None and values[0].ndim:
        far = max(values, key=lambda value: float(np.ptp(np.nan_to_num(value))))
        some = np.argsort(far.reshape(-1, far.shape[-1])[0])[_spread(far.shape[-1])]
        plot, values = rows_of(plot, some, Plot(plot.facts)), [value[..., some] for value in values]
    drawn, exact = readings(method, plot), motion(mechanism, values)
    clear = np.minimum.reduce(np.broadcast_arrays(1.0, *plot.sines.values())) > FLAT
    given = clear & (apart_each(mechanism, drawn, drawn) == 0)
    worst = apart_each(mechanism, drawn, exact)
    alone = mechanism is method.mechanism
    doubtful = given & (np.isnan(worst) if alone else ~(worst < AGREE))
    for k in map(int, np.flatnonzero(doubtful) if worst.ndim == 1 else ()):
        at = [float(value[k]) for value in values or ()]  # a dead point lies before it, on this way at least
        row = rows_of(plot, k, Plot(plot.facts))
        there = proved(method, at).exact if alone else _standing(mechanism, at, row.position)
        worst[k] = apart(mechanism, readings(method, row), there)
    if (given & ~(worst < AGREE)).any():
        raise RoadsDiffer(mechanism.where("driver", 0), float(np.max(np.nan_to_num(worst, nan=1.0)[given])))


def _standing(mechanism: Mechanism, at: Sequence[float], drawn: Mapping[str, Value]) -> Motion:
    """The analysis of a mechanism that is assembled where it is drawn, wherever a way from its own position leads: one
    of many stands on its own side of all its dead points and change points."""
    drivers = tuple(replace(driver, value=value) for driver, value in zip(mechanism.drivers, at, strict=True))
    sketch = {point: complex(drawn[point]) for point in mechanism.sketch}
    return motion(replace(mechanism, drivers=drivers, sketch=sketch))


def _spread(count: int) -> np.ndarray:
    """Both ends and ten places between, of so many."""
    return np.unique(np.linspace(0, count - 1, PLACES).round().astype(int)) if count else np.empty(0, int)


def compare(method: Method, plot: Plot, exact: Motion) -> float:
    """The worst relative difference between a replay and the analytic solution."""
    return apart(method.mechanism, readings(method, plot), exact)


def apart(mechanism: Mechanism, drawn: Motions, exact: Motions) -> float:
    """The worst relative difference between motions found by two roads; nan where either has none. Each kind of
    quantity is measured by the largest of its kind in the mechanism, or by what the lengths and speeds make of it (an
    angular acceleration of 0 by omega^2); angles in radians."""
    with np.errstate(invalid="ignore"):  # where either is nan
        return number(_apart(mechanism, drawn, exact, _largest))


def apart_each(mechanism: Mechanism, drawn: Motions, exact: Motions) -> np.ndarray:
    """The same for each of many mechanisms that lie side by side: (b,)."""
    with np.errstate(all="ignore"):  # where either is nan
        return np.asarray(_apart(mechanism, drawn, exact, _largest_of_each))


def _apart(mechanism: Mechanism, drawn: Motions, exact: Motions, largest: _Largest) -> Real:
    points = mechanism.points
    links = {point: mechanism.owners[point][-1] for point in points}
    velocity, right_velocity = ({p: m.velocity_at(p, links[p]) for p in points} for m in (drawn, exact))
    acceleration, right_acceleration = ({p: m.acceleration_at(p, links[p]) for p in points} for m in (drawn, exact))
    size, rate = _sizes(exact, right_velocity, largest)
    pairs: list[tuple[Mapping[str, Value], Mapping[str, Value], Real]] = [
        (drawn.omega, exact.omega, rate),
        (drawn.alpha, exact.alpha, rate**2),
        (drawn.s, exact.s, size),
        (drawn.s_rate, exact.s_rate, rate * size),
        (drawn.s_acceleration, exact.s_acceleration, rate**2 * size),
        ({point: drawn.position[point] for point in points}, exact.position, size),
        (velocity, right_velocity, rate * size),
        (acceleration, right_acceleration, rate**2 * size),
    ]
    turned = [np.exp(1j * (drawn.theta[link] - exact.theta[link])) - 1 for link in drawn.theta]
    return largest([largest(turned), *(_worst(*entry, largest) for entry in pairs)])


def _sizes(exact: Motions, velocity: Mapping[str, Value], largest: _Largest) -> tuple[Real, Real]:
    """Extent of the mechanism [m] and its fastest rotation, or speed over extent [rad/s]."""
    places = [exact.position[point] for point in velocity]
    size = largest([place - places[0] for place in places])
    size = size + (size == 0)
    return size, largest([*(v / size for v in (*velocity.values(), *exact.s_rate.values())), *exact.omega.values()])


def _worst(drawn: Mapping[str, Value], right: Mapping[str, Value], natural: Real, largest: _Largest) -> Real:
    size = largest([natural, *(right[name] for name in drawn)])
    return largest([drawn[name] - right[name] for name in drawn]) / (size + (size == 0))


def _largest(values: Sequence[Value]) -> float:
    """The largest size of all values (nan where one is nan), 0 of none."""
    sizes = [float(np.max(np.abs(value)) if isinstance(value, np.ndarray) else abs(value)) for value in values]
    return math.nan if any(map(math.isnan, sizes)) else max(sizes, default=0.0)


def _largest_of_each(values: Sequence[Value]) -> Real:
    """The same for each mechanism."""
    largest: Real = 0.0
    for value in values:
        largest = np.maximum(largest, np.abs(value))
    return largest


def wrong_drivers(mechanism: Mechanism) -> GraphkinError | None:
    """The error that names the freedoms and the driver at fault; None where the drivers are right. Freedoms are counted
    by rank, so a constraint that repeats others and is met is no error."""
    counted = mobility(mechanism)
    if counted.freedoms is None:
        return None
    called = tuple(mechanism.called(link) for link in counted.free)
    count, last = len(mechanism.drivers), len(mechanism.drivers) - 1
    which = counted.redundant[0] if counted.redundant else last
    if count > counted.freedoms:
        name = mechanism.drivers[which].name
        return TooManyDrivers(mechanism.where("driver", which), counted.freedoms, count, name)
    if count < counted.freedoms and counted.gap_mm is None:
        if loose := _loose(mechanism, counted.free):
            (owner,) = mechanism.owners[loose[0]]
            where = mechanism.where(FRAME, loose[0]) if owner == FRAME else mechanism.where("links", owner)
            return JoinedToNothing(where, called, counted.freedoms, count, loose)
        return TooFewDrivers(mechanism.where("driver", last), called, counted.freedoms, count)
    if counted.redundant:
        name = mechanism.drivers[which].name
        return uneven(mechanism) or RepeatedDriver(mechanism.where("driver", which), called, counted.freedoms, name)
    return None


def uneven(mechanism: Mechanism) -> UnevenLengths | None:
    """The error that names a link far longer than the shortest, beside which that has few digits: what is found then
    may be so for this reason alone."""
    reach = {name: max(abs(z - first) for z in others) for name, link in mechanism.links.items() if name != FRAME
             for first, *others in [[*link.points.values()]] if others}  # fmt: skip
    sizes = [size for size in reach.values() if size > 0]
    longest = max(reach, key=lambda name: reach[name], default="")
    if not sizes or max(sizes) < UNEVEN * min(sizes):
        return None
    return UnevenLengths(mechanism.where("links", longest), max(sizes) * 1000, min(sizes) * 1000)


def _loose(mechanism: Mechanism, free: tuple[str, ...]) -> tuple[str, ...]:
    """Points that join nothing: of the frame those that no pair uses, of free links those that hang on one joint."""
    used = {point for pair in mechanism.pairs for _, point, _ in pair.circles}
    for pair in mechanism.pairs:
        used |= {point for line in pair.lines for point in (line.origin, *(line.base or ()))}
        used |= {*pair.equivalent.points} if isinstance(pair.equivalent, Rod) else set()
    alone = {point for point, owners in mechanism.owners.items() if len(owners) == 1}
    joins = [pair.links for pair in mechanism.hinges] + [pair.joins for pair in mechanism.pairs]
    hanging = [link for link in free if sum(link in links for links in joins) < 2]
    return tuple(point for link in (FRAME, *hanging) for point in mechanism.named(link)
                 if point in alone and (link != FRAME or point not in used))  # fmt: skip
