"""The two roads held against each other over a sweep, before anything of it is told."""

from __future__ import annotations

import numpy as np

from graphkin.agreement import AGREE, apart
from graphkin.errors import RoadsDiffer
from graphkin.running.path import stride
from graphkin.sweeps.course import Course
from graphkin.sweeps.roads import moving

PLACES = 12
"""Positions at which they are held: both ends, and ten between."""
ASIDE_DEG, ASIDE_PART = 0.5, 0.005
"""So near a stop speeds grow without bound, and digits are lost: there it is held this far from it instead."""
BESIDE = 4
"""So many times as far from a change point, where what the neighbours lead to is told."""


def prove(course: Course) -> float:
    """The worst relative difference of the two roads at twelve places of a course. Raises RoadsDiffer."""
    t = _places(course)
    if not t.size:
        return 0.0
    drawn, exact = (moving(course.method, course.path, t, by) for by in ("construction", "analysis"))
    worst = apart(course.method.mechanism, drawn, exact)
    if not worst < AGREE:
        where = course.method.mechanism.where("driver", course.swept)
        raise RoadsDiffer(where, worst if np.isfinite(worst) else 1.0)  # one road does not lead there: wholly
    return worst


def _places(course: Course) -> np.ndarray:
    """Twelve places, evenly over what is asked for, none right beside a stop or a change point."""
    low, high = float(course.t.min()), float(course.t.max())
    aside = stride(course.method, course.path.pace, ASIDE_DEG, ASIDE_PART)
    aside = min(aside, (course.path.last - course.path.first) / 4)
    for stop in course.path.stops:
        low, high = (low, min(high, stop.at - aside)) if stop.at > 0 else (max(low, stop.at + aside), high)
    if low > high:
        return np.empty(0)
    t = np.linspace(low, high, PLACES)
    for change in course.path.changes:
        near = np.abs(t - change.at) < BESIDE * aside
        t[near] = change.at + BESIDE * aside * np.where(t[near] < change.at, -1.0, 1.0)
    return np.unique(np.clip(t, low, high))
