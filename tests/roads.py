"""The replayed construction held against the analytic road, and against its own numerical derivatives."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable

import numpy as np
from random_mechanisms import Seed

from graphkin.analytic import mobility, motion
from graphkin.construction import Plot
from graphkin.errors import DeadPoint
from graphkin.model.mechanism import Mechanism
from graphkin.planning import Method, plan
from graphkin.proof.readings import readings
from graphkin.proof.roads import Proved, compare
from graphkin.running import replay_all

Make = Callable[[int], Mechanism]
ROUNDING = 1e-14
"""What the roads may differ by, by the square of the condition: more than 1e-9 only where that is below 0.003."""
ALIKE = 20
"""Random mechanisms of one topology."""
COUNT, BATCH = max(ALIKE, int(os.environ.get("GRAPHKIN_RANDOM", "60"))), 250
"""Random mechanisms of each kind, and of how many a test is made; more with GRAPHKIN_RANDOM in the environment."""
DERIVED = 40 if "GRAPHKIN_RANDOM" in os.environ else 22
"""Random mechanisms of each kind whose motion is held against its differences."""
BATCHES = range(-(-COUNT // BATCH))


def definite(mechanism: Mechanism) -> bool:
    """As many drivers as freedoms, each needed, and an assembled position to show it."""
    counted = mobility(mechanism)
    needed = counted.freedoms == len(mechanism.drivers) and not counted.redundant
    return needed and counted.gap_mm is None and not counted.unplaced


def kinds(batch: int) -> range:
    """The topologies of a batch."""
    return range(batch * BATCH // ALIKE, min((batch + 1) * BATCH, COUNT) // ALIKE)


def planned(mechanism: Mechanism) -> tuple[Method, Plot] | None:
    """A method and its plot; None at a dead point, which must be one."""
    try:
        method = plan(mechanism)
        return method, replay_all(method)
    except DeadPoint as error:
        assert error.angle_deg < 0.5
        return None


def hold_roads_together(make: Callable[[Seed], Mechanism], kinds: range) -> None:
    """Both roads give the sketched assembly and the same numbers; few of the mechanisms are dead points."""
    dead = 0
    for kind in kinds:
        for number in range(ALIKE):
            mechanism = make((kind, number))
            if (found := _proved(mechanism)) is None:
                dead += 1
                continue
            for point, place in mechanism.sketch.items():
                assert abs(found.plot.position[point] - place) < 1e-7, (kind, number, point)
            assert found.worst < max(1e-9, ROUNDING / float(found.exact.condition) ** 2), (kind, number)
    assert dead < len(kinds) * ALIKE * 0.1


def _proved(mechanism: Mechanism) -> Proved | None:
    if (found := planned(mechanism)) is None:
        return None
    method, plot = found
    exact = motion(mechanism)
    return Proved(plot, exact, compare(method, plot, exact))


def hold_derivatives(make: Make, seeds: Iterable[int]) -> None:
    """Differences over five instants of the construction itself, all drivers moving on together."""
    step, tried = 2e-5, 0
    for seed in seeds:
        mechanism = make(seed)
        found = planned(mechanism)
        if found is None or not np.min([np.min(sine) for sine in found[1].sines.values()], initial=1.0) >= 0.2:
            continue
        method, drawn = found
        tried += 1
        times = step * np.arange(-2, 3)
        values = [d.value + d.rate * times + d.acceleration * times**2 / 2 for d in method.drivers]
        plot, motions = replay_all(method, values), readings(method, drawn)
        for point in mechanism.points:
            link = mechanism.owners[point][-1]
            places = np.broadcast_to(plot.position[point], 5)
            velocity = places @ np.array([1, -8, 0, 8, -1]) / (12 * step)
            acceleration = places @ np.array([-1, 16, -30, 16, -1]) / (12 * step**2)
            scale = abs(velocity) + 1.0
            assert abs(velocity - motions.velocity_at(point, link)) < 1e-6 * scale, (seed, point)
            scale = abs(acceleration) + 10 * scale**2
            assert abs(acceleration - motions.acceleration_at(point, link)) < 1e-5 * scale, (seed, point)
    assert tried > 5
