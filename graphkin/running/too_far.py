"""How far a mechanism can be moved at once: it is looked along the path there, every half degree."""

from __future__ import annotations

import math

from graphkin.errors import TooFar
from graphkin.model.quantities import EDGE, driven
from graphkin.planning.method import Method
from graphkin.running.path import DriverPath, stride

MOST = 1e7
"""Points looked at on a path, at most: some 0.3 GB."""
FITTING = 30
"""How much more a position costs where links are fitted."""


def refuse_far(method: Method, path: DriverPath, look_deg: float, look_part: float) -> None:
    """Raises TooFar for a path with too many positions to be looked at."""
    cost = max(len(method.mechanism.points), 4) * (FITTING if method.fits else 1)
    most = MOST / cost * stride(method, path.pace, look_deg, look_part)
    if path.high - path.low <= most:
        return
    moving = max(range(len(path.pace)), key=lambda k: abs(path.pace[k]))
    driver = method.drivers[moving]
    unit = EDGE[driven(driver.kind == "slide")]
    start, end = (unit.shown(path.start[moving] + path.pace[moving] * t) for t in (path.low, path.high))
    farthest = unit.shown(_round(abs(path.pace[moving]) * most))
    raise TooFar(method.mechanism.where("driver", moving), driver.name, start, end, farthest)


def _round(value: float) -> float:
    """With two digits, rounded off."""
    digits = 10.0 ** (math.floor(math.log10(value)) - 1)
    return math.floor(value / digits) * digits
