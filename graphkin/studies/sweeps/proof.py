"""The two roads held against each other over a sweep, before anything of it is told."""

from __future__ import annotations

import numpy as np

from graphkin.base.cache import kept
from graphkin.errors import RoadsDiffer
from graphkin.planning import Method
from graphkin.proof.roads import AGREE, PLACES, apart
from graphkin.running.path import DriverPath, stride
from graphkin.studies.sweeps.course import Course
from graphkin.studies.sweeps.roads import moving

ASIDE_DEG, ASIDE_PART = 0.5, 0.005
"""So near a stop speeds grow without bound, and digits are lost: there it is held this far from it instead."""
BESIDE = 4
"""So many times as far from a change point, where what the neighbours lead to is told."""


def prove(course: Course) -> float:
    """The worst relative difference of the two roads at twelve places of a course. Raises RoadsDiffer."""
    worst = _apart(course.path, course.method, float(course.t.min()), float(course.t.max()))
    if not worst < AGREE:
        where = course.method.mechanism.where("driver", course.swept)
        raise RoadsDiffer(where, worst if np.isfinite(worst) else 1.0)  # one road does not lead there: wholly
    return worst


@kept(16, objects=2)
def _apart(path: DriverPath, method: Method, low: float, high: float) -> float:
    """How far they differ at places from low to high on a path; 0 where all of it is right beside its stops."""
    t = _places(path, method, low, high)
    if not t.size:
        return 0.0
    drawn, exact = (moving(method, path, t, by) for by in ("construction", "analysis"))
    return apart(method.mechanism, drawn, exact)


def _places(path: DriverPath, method: Method, low: float, high: float) -> np.ndarray:
    """Twelve places, evenly over what is asked for, none right beside a stop or a change point."""
    aside = stride(method, path.pace, ASIDE_DEG, ASIDE_PART)
    aside = min(aside, (path.last - path.first) / 4)
    for stop in path.stops:
        low, high = (low, min(high, stop.at - aside)) if stop.at > 0 else (max(low, stop.at + aside), high)
    if low > high:
        return np.empty(0)
    t = np.linspace(low, high, PLACES)
    for change in path.changes:
        near = np.abs(t - change.at) < BESIDE * aside
        t[near] = change.at + BESIDE * aside * np.where(t[near] < change.at, -1.0, 1.0)
    return np.array(sorted({*np.clip(t, low, high).tolist()}))
