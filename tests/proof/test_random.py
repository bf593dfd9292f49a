"""Two roads to one answer, on random mechanisms of every dyad kind."""

from __future__ import annotations

import cmath
import math
import os
import random
from dataclasses import replace

import pytest
from random_mechanisms import DYADS, Seed, chain, coupler_angle, cylinder, dyad, relative_angle
from roads import ALIKE, BATCHES, DERIVED, hold_derivatives, hold_roads_together, kinds, planned

from graphkin.errors import DeadPoint
from graphkin.model.mechanism import Mechanism
from graphkin.planning import plan
from graphkin.proof.roads import proved
from graphkin.running import replay_all

KINDS = (*DYADS, "cylinder", "relative", "coupler", "chain")
ROUGH = 100 if "GRAPHKIN_RANDOM" in os.environ else 40
OTHERS = {"cylinder": cylinder, "relative": relative_angle, "coupler": coupler_angle, "chain": chain}


def make(kind: str, seed: Seed) -> Mechanism:
    return OTHERS[kind](seed) if kind in OTHERS else dyad(kind, seed)


def rough(mechanism: Mechanism, seed: int) -> Mechanism:
    """The same with a sketch drawn by hand: every point a few millimetres off."""
    rng = random.Random(seed)
    sketch = {p: z + cmath.rect(0.001, rng.uniform(0, 2 * math.pi)) for p, z in mechanism.sketch.items()}
    return replace(mechanism, sketch=sketch)


@pytest.mark.parametrize("batch", BATCHES)
@pytest.mark.parametrize("kind", KINDS)
def test_polygons_equal_loop_equations(kind: str, batch: int):
    hold_roads_together(lambda seed: make(kind, seed), kinds(batch))


@pytest.mark.parametrize("kind", KINDS)
def test_velocity_is_the_derivative_of_position(kind: str):
    hold_derivatives(lambda seed: make(kind, seed), range(10**6, 10**6 + DERIVED))


@pytest.mark.many
@pytest.mark.parametrize("kind", KINDS)
def test_a_rough_sketch_is_enough(kind: str):
    """The sketch only picks the assembly: moved a little, it gives the same."""
    for structure in range(100, 100 + ROUGH // ALIKE):
        for number in range(ALIKE):
            mechanism = make(kind, (structure, number))
            exact = planned(mechanism)
            if exact is None or min(exact[1].sines.values()) < 0.3:
                continue
            found = proved(plan(rough(mechanism, number)))
            for point in mechanism.sketch:
                assert abs(exact[1].position[point] - found.plot.position[point]) < 1e-9
            assert found.worst < 1e-9


@pytest.mark.parametrize("kind", KINDS)
def test_turning_the_mechanism_turns_the_polygons(kind: str):
    for seed in range(10):
        mechanism = make(kind, seed)
        try:
            plot = replay_all(plan(mechanism))
        except DeadPoint:
            continue
        turn = cmath.exp(0.7j)
        turned = turned_by(mechanism, turn)
        other = replay_all(plan(turned))
        for name, arrow in plot.acceleration.items():
            size = max(abs(a) for a in plot.acceleration.values())
            assert abs(other.acceleration[name] - arrow * turn) <= 1e-8 * size, (kind, seed, name)


def turned_by(mechanism: Mechanism, turn: complex) -> Mechanism:
    """The whole machine on a base turned about the origin."""
    links = dict(mechanism.links)
    links["frame"] = replace(links["frame"], points={p: z * turn for p, z in links["frame"].points.items()})
    slides = tuple(
        replace(s, line=replace(s.line, direction=s.line.direction * turn)) if s.guide == "frame"
        else replace(s, tilt=s.tilt) for s in mechanism.slides
    )  # fmt: skip
    slides = tuple(
        replace(s, tilt=s.tilt - cmath.phase(turn)) if s.block == "frame" else s for s in slides
    )
    drivers = tuple(
        replace(d, value=d.value + cmath.phase(turn)) if d.kind == "angle" and d.from_link == "frame" else d
        for d in mechanism.drivers
    )
    sketch = {p: z * turn for p, z in mechanism.sketch.items()}
    return replace(mechanism, links=links, pairs=slides, drivers=drivers, sketch=sketch)
