"""A mechanism at another position: the same file with that position as its drawn one."""

from __future__ import annotations

from collections.abc import Sequence

from graphkin.files.changing import reposed
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.planning import Method
from graphkin.planning.drawn_position import value_of
from graphkin.running import replay_all

__all__ = ["standing"]


def standing(method: Method, values: Sequence[float]) -> Mechanism:
    """The mechanism where its drivers have these values [rad, m], reached from the drawn position on its branch.

    Its text has the drivers' values, the poses and the sketch of there. Raises NotReached.

    >>> import math
    >>> from graphkin import api
    >>> turned = standing(api.plan(api.load("ex3-1")), [math.radians(120)])
    >>> turned.drivers[0].value == math.radians(120), f"{turned.sketch['C'] * 1000:.4f}"
    (True, '71.5045+47.5585j')
    """
    machine, plot = method.mechanism, replay_all(method, values)
    poses = [float(value_of(plot, pose)) for pose in machine.poses]
    moving = {point for point in machine.points if point not in machine.links[FRAME].points}
    sketch = {point: complex(place) for point, place in plot.position.items() if point in moving}
    return reposed(machine, values, poses, sketch)
