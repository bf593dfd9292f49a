"""Loops of two unknowns: the formula gives what a search from many places finds."""

import numpy as np
import pytest
from random_mechanisms import dyad

from graphkin.analytic.assembly import drawn
from graphkin.analytic.blocks import blocks_of, dyad_ways
from graphkin.analytic.newton import EquationSystem, close, search
from graphkin.analytic.rules import driven


@pytest.mark.parametrize("kind", ["RRR", "RRP", "PRR", "RPR"])
@pytest.mark.parametrize("seed", range(4))
def test_both_ways_are_all_that_a_search_finds(kind: str, seed: int):
    mechanism = dyad(kind, seed)
    start = drawn(mechanism)
    drivers = tuple(driven(mechanism, driver) for driver in mechanism.drivers)
    closure = EquationSystem.of(start.loops, (*start.loops.relations, *drivers))
    (block,) = blocks_of(closure)
    given = block.given(start.q[None])
    both = dyad_ways(block, given)
    assert both is not None
    there = np.repeat(given, 60, axis=0)
    places = np.random.default_rng(seed).uniform(-3, 3, (60, 2))
    met = close(block.part, search(block.part, block.at(places, there), there), there, steps=40)
    found = met.q[met.gap < 1e-9, :2]
    assert np.max(block.part.loops.open_by(block.at(both[0], given.repeat(2, axis=0)))) < 1e-12
    apart = np.abs(np.exp(1j * (found[:, None] - both)) - 1).max(axis=-1)
    assert np.all(apart.min(axis=1) < 1e-7)
    assert np.all(apart.min(axis=0) < 1e-7)
