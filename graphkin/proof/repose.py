"""A mechanism at another position: the same file with that position as its drawn one."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from graphkin.construction import Plot
from graphkin.files import loads
from graphkin.files.toml import replaced_values
from graphkin.model.mechanism import FRAME, Driver, KeyPath, Mechanism, Pose
from graphkin.planning import Method
from graphkin.planning.drawn_position import value_of
from graphkin.running import replay_all

__all__ = ["standing"]

_DIGITS = 12
"""Of mm and deg in the new file."""


def standing(method: Method, values: Sequence[float]) -> Mechanism:
    """The mechanism where its drivers have these values [rad, m], reached from the drawn position on its branch.

    Its text has the drivers' values, the poses and the sketch of there. Raises NotReached.

    >>> from graphkin import api
    >>> turned = standing(api.plan(api.load("ex3-1")), [math.radians(120)])
    >>> turned.drivers[0].value == math.radians(120), f"{turned.sketch['C'] * 1000:.4f}"
    (True, '71.5045+47.5585j')
    """
    machine, plot = method.mechanism, replay_all(method, values)
    text = replaced_values(machine.text, dict(_changes(machine, plot, values)))
    return loads(text, name=machine.name, file=machine.file)


def _changes(machine: Mechanism, plot: Plot, values: Sequence[float]) -> Iterator[tuple[KeyPath, object]]:
    for number, (driver, value) in enumerate(zip(machine.drivers, values, strict=True)):
        if driver.value is not None and driver.kind != "spin":
            yield ("driver", number, "at" if driver.kind == "slide" else "angle"), _edge(driver, value)
    for number, pose in enumerate(machine.poses):
        yield ("pose", number, "at" if pose.kind == "slide" else "angle"), _edge(pose, float(value_of(plot, pose)))
    for point, place in plot.position.items():
        if point in machine.points and point not in machine.links[FRAME].points:
            place = complex(place) * 1000
            yield ("sketch", point), [round(place.real, _DIGITS), round(place.imag, _DIGITS)]


def _edge(entry: Driver | Pose, value: float) -> float:
    """In the unit of a number without one: mm, deg."""
    return round(value * 1000 if entry.kind == "slide" else math.degrees(value), _DIGITS)
