"""A path traced from the drawn position: how far it leads, and through what."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from graphkin.base.cache import kept
from graphkin.construction import Meet, Swing
from graphkin.planning.method import Method
from graphkin.running.continuation import continued
from graphkin.running.path import DriverPath
from graphkin.running.scanning import scanned
from graphkin.running.singularities import LOOK_DEG, LOOK_PART
from graphkin.running.too_far import refuse_far


def trace(
    method: Method, pace: Sequence[float], low: float, high: float, after: tuple[DriverPath, float] | None = None
) -> DriverPath:
    """Look along the path from t = low to t = high (low <= 0 <= high) for stops and change points.

    after   a place on another path, to start from there instead of from the drawn position
    """
    ends, pace = (float(low), float(high)), tuple(float(p) for p in pace)
    return _from_drawn(method, pace, ends) if after is None else _traced(method, pace, ends, after)


@kept(16)
def _from_drawn(method: Method, pace: tuple[float, ...], ends: tuple[float, float]) -> DriverPath:
    """The same walk serves many sweeps."""
    return _traced(method, pace, ends, None)


def _traced(
    method: Method, pace: tuple[float, ...], ends: tuple[float, float], after: tuple[DriverPath, float] | None
) -> DriverPath:
    path = _setting_out(method, pace, ends, after)
    refuse_far(method, path, LOOK_DEG, LOOK_PART)
    if path.low == path.high:
        return path
    if method.fits:
        return continued(method, path)
    for end in reversed(ends):
        path = scanned(method, path, end)
    return path


def _setting_out(
    method: Method, pace: tuple[float, ...], ends: tuple[float, float], after: tuple[DriverPath, float] | None
) -> DriverPath:
    """A path of which only its start is known."""
    if after is None:
        start = tuple(float(value) for value in method.facts(None).values)
        near, sides = dict(method.near), _sides(method)
    else:
        before, t = after
        start = tuple(float(value) for value in before.values(t))
        near = dict(before.near(t))
        sides = {choice: int(side) for choice, side in before.crossings(t).items()}
    nodes = (np.zeros(1), {name: np.full(1, value) for name, value in near.items()})
    return DriverPath(start, pace, *ends, nodes=nodes if method.moves_on else None, sides=sides)


def _sides(method: Method) -> dict[int, int]:
    steps = method.position.steps
    return {step.choice: step.side for step in steps if isinstance(step, Meet | Swing) and step.choice is not None}
