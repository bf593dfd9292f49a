"""The analysis' path: each change point is found once, and where it is, wherever steps happen to end."""

from __future__ import annotations

import math

import numpy as np
import pytest
from folding import folding

from graphkin import analytic
from graphkin.analytic.assembly import drawn
from graphkin.analytic.loops import applied, through
from graphkin.analytic.motions import driving
from graphkin.analytic.path import RightSides, path_along
from graphkin.files import library


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


@pytest.mark.parametrize("size", [3, 40, 200])
@pytest.mark.parametrize("kind", [float, complex])
def test_products_of_few_entries(size: int, kind: type):
    """Of small matrices and of large ones, with empty rows and columns: what the whole product gives."""
    rng = np.random.default_rng(size)
    matrix = np.where(rng.uniform(size=(size, size + 1)) < 1.5 / size, rng.normal(size=(size, size + 1)), 0.0)
    for shape in ((), (1,), (7,), (2, 5)):
        rows = (rng.normal(size=(*shape, size)) + 1j * rng.normal(size=(*shape, size))).astype(complex)
        rows = rows if kind is complex else rows.real
        for found in (through(rows, matrix), applied(matrix.T.copy(), rows)):
            assert found.dtype == kind
            assert found == pytest.approx(rows @ matrix, rel=0, abs=1e-12)


@pytest.mark.parametrize("name", ["ex3-1", "ex3-5", "ex3-7", "p3-19", "p3-8", "ex3-3", "p3-12", "s4-ex4", "parallelogram"])
def test_turns_are_walked_once(name: str, monkeypatch: pytest.MonkeyPatch):
    """Many turns on, a mechanism moves as it does there when it is taken there step by step; and is there at once where
    it comes round after a turn."""
    mechanism = folding("parallelogram", "none", 11) if name == "parallelogram" else library.load(name)
    (start,) = analytic.motion(mechanism).values
    steps = start + np.linspace(0, 2 * math.pi, 16) + 2 * math.pi * np.arange(-6, 10)
    counted, node = [], RightSides.node

    def counting(line: RightSides, at: float, guess: np.ndarray) -> object:
        counted.append(at)
        return node(line, at, guess)

    monkeypatch.setattr(RightSides, "node", counting)
    found = analytic.motion(mechanism, [steps])
    few = len(counted)
    with monkeypatch.context() as patched:
        patched.setattr(RightSides, "turn", math.inf)
        walked = analytic.motion(mechanism, [steps])
    for table in ("theta", "omega", "alpha", "s", "position", "acceleration"):
        for key, values in getattr(walked, table).items():
            scale = 1 + np.nanmax(np.abs(values))
            assert getattr(found, table)[key] == pytest.approx(values, rel=0, abs=1e-9 * scale, nan_ok=True), (table, key)
    assert name == "ex3-3" or few < (len(counted) - few) / 10  # whose gears come round only after several turns
