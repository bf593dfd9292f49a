"""Long mechanisms: nothing grows faster than about the square of their length, and the assembly is the same as by
trying every one."""

from __future__ import annotations

import cmath
import itertools
import math
import os
import random
import time
import tracemalloc
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from large_mechanisms import dyads, ladder, triads
from random_mechanisms import chain

from graphkin.analytic import motion
from graphkin.construction import Plot, replay
from graphkin.errors import AmbiguousSketch, CannotAssemble, GraphkinError
from graphkin.model.mechanism import Mechanism
from graphkin.planning import plan
from graphkin.planning.method import facts_of
from graphkin.planning.position import position
from graphkin.planning.stages import stages
from graphkin.planning.structure import Topology
from graphkin.proof.roads import compare
from graphkin.running import replay_all

LONG = {
    "64 dyads": lambda: dyads(64),
    "64 dyads, otherwise": lambda: dyads(64, seed=1),
    "64 guides": lambda: dyads(64, kinds=("RPR", "RRP")),
    "16 groups of Class III": lambda: triads(16),
    "ladder of 35 links": lambda: ladder(16),
}


@pytest.mark.parametrize("name", [pytest.param(name, marks=pytest.mark.further) if "otherwise" in name else name for name in LONG])
def test_both_roads_solve_it(name: str):
    mechanism = LONG[name]()
    method = plan(mechanism)
    plot = replay_all(method)
    assert max(abs(plot.position[point] - place) for point, place in mechanism.sketch.items()) < 1e-9
    assert compare(method, plot, motion(mechanism)) < 1e-9


@pytest.mark.parametrize(("make", "count"), [(dyads, 64), (triads, 16), (ladder, 8)])
def test_a_rough_sketch_is_enough(make: Callable[[int], Mechanism], count: int):
    mechanism = make(count)
    rough = moved(mechanism, 0.001, 0)
    method = plan(rough)
    plot = replay_all(method)
    assert max(abs(plot.position[point] - place) for point, place in mechanism.sketch.items()) < 1e-9
    assert compare(method, plot, motion(rough)) < 1e-9


def moved(mechanism: Mechanism, distance: float, seed: int) -> Mechanism:
    """The same with every sketched point so far from its place [m]."""
    rng = random.Random(seed)
    sketch = {p: z + cmath.rect(distance, rng.uniform(0, 2 * math.pi)) for p, z in mechanism.sketch.items()}
    return replace(mechanism, sketch=sketch)


def sketched_in_part(mechanism: Mechanism, share: float, seed: int) -> Mechanism:
    rng = random.Random(seed)
    return replace(mechanism, sketch={p: z for p, z in mechanism.sketch.items() if rng.random() < share})


def stretched(mechanism: Mechanism, link: str, factor: float) -> Mechanism:
    points = {point: place * factor for point, place in mechanism.links[link].points.items()}
    return replace(mechanism, links={**mechanism.links, link: replace(mechanism.links[link], points=points)})


def test_without_a_sketch_both_places_are_told():
    with pytest.raises(AmbiguousSketch) as refused:
        plan(sketched_in_part(dyads(64, kinds=("RRR",)), 0, 0))
    assert refused.value.point in refused.value.points
    assert refused.value.first != refused.value.second


@pytest.mark.parametrize("place", [1, 40, 64])
def test_a_link_that_does_not_reach_is_named(place: int):
    mechanism = dyads(64, kinds=("RRR",))
    link = str(2 * place)
    with pytest.raises(CannotAssemble) as refused:
        plan(stretched(mechanism, link, 30.0))
    assert link in refused.value.links
    assert refused.value.gap_mm > 100


# --- the same as by trying every assembly -------------------------------------------------------


def every_assembly(mechanism: Mechanism) -> dict[str, complex] | type[GraphkinError]:
    """The places of all points, or the refusal, with every combination of crossings drawn."""
    structure = Topology(mechanism)
    order, _ = stages(structure)
    construction, choices = position(structure, order)
    combinations = np.array([*itertools.product((1, -1), repeat=choices)]).reshape(2**choices, choices)
    plot = replay(construction, Plot(facts_of(structure, None, {})), dict(enumerate(combinations.T)))
    points = [*plot.position]
    table = np.array([np.broadcast_to(plot.position[point], len(combinations)) for point in points])
    closed = np.isfinite(table).all(axis=0)
    if not closed.any():
        return CannotAssemble
    table = table[:, closed]
    slides = [np.broadcast_to(value, len(closed))[closed] for value in plot.s.values()]
    forward = np.sign(np.array(slides)).sum(axis=0) if slides else np.zeros(table.shape[1])
    sketched = [k for k, point in enumerate(points) if point in mechanism.sketch]
    seen, target = table[sketched], np.array([mechanism.sketch[points[k]] for k in sketched])[:, None]
    away = (abs(seen - target) ** 2).sum(axis=0)
    best = int(np.lexsort((-forward, np.round(away, 18)))[0])
    for other in range(table.shape[1]):
        apart = (abs(seen[:, other] - seen[:, best]) ** 2).sum()
        if abs(table[:, other] - table[:, best]).max() < 1e-9:
            continue
        even = forward[other] == forward[best] if apart < 1e-18 else away[other] - away[best] < 0.04 * apart
        if even:
            return AmbiguousSketch
    return dict(zip(points, table[:, best].tolist(), strict=True))


def chosen(mechanism: Mechanism) -> dict[str, complex] | type[GraphkinError]:
    try:
        method = plan(mechanism)
    except (AmbiguousSketch, CannotAssemble) as refusal:
        return type(refusal)
    return {p: complex(z) for p, z in replay(method.position, Plot(method.facts(), method.near)).position.items()}


ALTERED: dict[str, Callable[[Mechanism, int], Mechanism]] = {
    "as sketched": lambda m, seed: m,
    "roughly": lambda m, seed: moved(m, 0.005, seed),
    "badly": lambda m, seed: moved(m, 0.06, seed),
    "in part": lambda m, seed: sketched_in_part(m, 0.4, seed),
    "hardly": lambda m, seed: moved(sketched_in_part(m, 0.15, seed), 0.03, seed),
    "other lengths": lambda m, seed: moved(stretched(m, m.moving[seed % len(m.moving)], 1.4), 0.02, seed),
}


@pytest.mark.parametrize("how", ALTERED)
def test_the_assembly_is_that_of_all(how: str):
    for seed in range(14 if "GRAPHKIN_RANDOM" in os.environ else 6):
        for make in (chain, lambda seed: dyads(7, seed)):
            mechanism = ALTERED[how](make(seed), seed)
            every, found = every_assembly(mechanism), chosen(mechanism)
            if isinstance(every, dict) and isinstance(found, dict):
                assert max(abs(found[point] - every[point]) for point in every) < 1e-7, (how, seed)
            else:
                assert every == found, (how, seed)


# --- how work grows -----------------------------------------------------------------------------


def seconds(work: Callable[[], object]) -> float:
    """The least of three times [s]; what is kept of a mechanism is kept of the same object only."""
    return min(timed(work) for _ in range(3))


def timed(work: Callable[[], object]) -> float:
    begin = time.thread_time()
    work()
    return time.thread_time() - begin


@pytest.mark.parametrize("make", [dyads, triads], ids=["dyads", "groups of Class III"])
@pytest.mark.parametrize("what", ["plan", "replay", "motion"])
def test_work_grows_with_the_square_at_most(make: Callable[[int], Mechanism], what: str):
    short, long = (make(count) for count in ((16, 64) if make is dyads else (4, 16)))

    def work(mechanism: Mechanism) -> Callable[[], object]:
        method = plan(mechanism)
        return {
            "plan": lambda: plan(replace(mechanism)), "replay": lambda: replay_all(method),
            "motion": lambda: motion(replace(mechanism)),
        }[what]  # fmt: skip

    assert seconds(work(long)) < 1.5 * 4**2 * seconds(work(short))


def test_planning_a_long_chain_is_quick_and_small():
    mechanism = dyads(64)
    assert seconds(lambda: plan(replace(mechanism))) < 0.9
    tracemalloc.start()
    plan(replace(mechanism))
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 60e6
