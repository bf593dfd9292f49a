"""The analysis' path: each change point is found once, and where it is, wherever steps happen to end."""

from __future__ import annotations

import math

import numpy as np
import pytest
from folding import folding

from graphkin.analytic.assembly import drawn
from graphkin.analytic.motions import driving
from graphkin.analytic.path import RightSides, path_along


@pytest.mark.parametrize(("linkage", "wheel"), [("parallelogram", "roll"), ("rhombus", "none")])
def test_change_points_are_found_once(linkage: str, wheel: str):
    """From many places on a path, so that steps end far from a change point, beside it, and on it."""
    mechanism = folding(linkage, wheel, 11)
    start = drawn(mechanism)
    closure, first = driving(mechanism, start.loops)
    toward = np.zeros(len(closure.weights))
    toward[first] = 1.0
    c = closure.weights @ start.q
    ahead = path_along(RightSides(closure, c, toward), start.q, 0.0, math.pi)
    places = ahead.changes[0] + np.linspace(-0.08, -0.02, 60)
    for place, guess in zip(places, ahead.between(places), strict=True):
        line = RightSides(closure, c + place * toward, toward)
        node = line.node(0.0, guess)
        assert node is not None
        changes = place + np.array(path_along(line, node.q, 0.0, 0.2).changes)
        assert changes.tolist() == pytest.approx([ahead.changes[0]], abs=1e-7), place
