"""Sweeps: both roads over whole turns and reachable ranges, through change points, into tables."""

from __future__ import annotations

import csv
import io
import json
import math
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner, Result
from random_mechanisms import DYADS, chain, coupler_angle, cylinder, dyad, triad

from graphkin import library
from graphkin.check.comparison import apart
from graphkin.cli import main
from graphkin.errors import BadRange, GraphkinError, NoPosition, NoSuchDriver
from graphkin.loading import loads
from graphkin.mechanism import Mechanism
from graphkin.methods import plan
from graphkin.sweeps import at, course, sweep
from graphkin.sweeps.roads import moving

LIMITED = ("fig3-6", "fig3-10", "p3-22", "s4-ex3", "ex3-2", "s4-ex8")


def run(*words: str) -> Result:
    return CliRunner().invoke(main, list(words))


def both(mechanism: Mechanism, count: int = 181, margin: float = 0.02) -> float:
    """How far the two roads are apart over everything that is reached, but for the neighbourhood of dead points."""
    way = course(plan(mechanism))
    low, high = way.way.first, way.way.last
    trim = margin * (high - low)
    t = np.linspace(low + trim * (low != way.way.low), high - trim * (high != way.way.high), count)
    roads = [moving(way.method, way.way, t, by) for by in ("construction", "analysis")]
    assert all(np.isfinite(value).all() for value in roads[1].alpha.values()), mechanism.name
    return apart(mechanism, *roads)


@pytest.mark.parametrize("name", library.names())
def test_both_roads_sweep_alike(name: str):
    assert both(library.load(name)) < 1e-9


@pytest.mark.parametrize("kind", [*DYADS, "cylinder", "coupler", "chain", "triad"])
def test_both_roads_sweep_random_mechanisms_alike(kind: str):
    make = {"cylinder": cylinder, "coupler": coupler_angle, "chain": chain, "triad": triad}.get(kind)
    tried = 0
    for seed in range(3 if kind == "triad" else 8):
        mechanism = make(seed) if make else dyad(kind, seed)
        try:
            plan(mechanism)
        except GraphkinError:
            continue
        tried += 1
        assert both(mechanism) < 1e-9, (kind, seed)
    assert tried
