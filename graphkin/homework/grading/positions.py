"""The further positions that a problem asks for, each as a mechanism of its own that is drawn there."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Iterator
from copy import deepcopy
from typing import Any

import numpy as np

from graphkin import api
from graphkin import files as loading
from graphkin.construction import Plot
from graphkin.errors import GraphkinError, NoKeyAtPosition
from graphkin.marking.answers import asked_of
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import FRAME, Driver, Mechanism, Pose
from graphkin.model.quantities import Quantity
from graphkin.planning import Method
from graphkin.proof.readings import readings
from graphkin.results import driver_values
from graphkin.running import replay_all

_SAME = 1e-6
"""Values of both mechanisms that differ by a smaller part, of the largest of their kind, are the same."""


def further_methods(method: Method) -> Iterator[Method]:
    """One for each further position, in order: the same mechanism, drawn there, in the assembly it is moved into.

    Raises NoKeyAtPosition for one that is not reached, or of which a file cannot say how it stands.
    """
    for number, values in enumerate(list(driver_values(method))[1:], 2):
        where = method.mechanism.where("driver", 0, "also")
        try:
            plot = replay_all(method, values)
            there = api.plan(_moved(method, plot, values), method.structure.coincident)
            same = _same(method, plot, there)
        except GraphkinError as problem:
            raise NoKeyAtPosition(where, number, problem) from None
        if not same:
            raise NoKeyAtPosition(where, number)
        yield there


def _moved(method: Method, plot: Plot, values: tuple[float, ...]) -> Mechanism:
    """The mechanism file with what tells its position changed: drivers, poses, sketch."""
    mechanism = method.mechanism
    found, document = readings(method, plot), deepcopy(tomllib.loads(mechanism.text))
    for table, driver, value in zip(document["driver"], mechanism.drivers, values, strict=True):
        table.pop("also", None)
        if driver.value is not None:
            _set(table, driver, value)
    for table, pose in zip(document.get("pose", []), mechanism.poses, strict=True):
        _set(table, pose, _stands(mechanism, found, pose))
    fixed = mechanism.named(FRAME)
    places = {name: complex(plot.position[name]) * 1000 for name in mechanism.points if name not in fixed}
    document["sketch"] = {name: [place.real, place.imag] for name, place in places.items()}
    return loading.from_dict(document, name=mechanism.name)


def _set(table: dict[str, Any], one: Driver | Pose, value: float) -> None:
    table["at" if one.kind == "slide" else "angle"] = value * 1000 if one.kind == "slide" else math.degrees(value)


def _stands(mechanism: Mechanism, found: Motions, pose: Pose) -> float:
    """What holds of a pose at a position [rad, m]."""
    if pose.kind == "slide":
        return float(found.s[pose.link])
    assert pose.vector is not None, "a pose is of a direction or of a slide"
    return _direction(mechanism, found, pose.link, pose.vector) - (
        _direction(mechanism, found, pose.from_link, pose.from_vector) if pose.from_vector is not None else 0.0
    )


def _direction(mechanism: Mechanism, found: Motions, link: str, vector: tuple[str, str]) -> float:
    arm = mechanism.links[link].arm(*vector)
    turned = 0.0 if link == FRAME else float(found.theta[link])
    return turned + math.atan2(arm.imag, arm.real)


def _same(method: Method, plot: Plot, there: Method) -> bool:
    """Whether what is asked for is the same by both."""
    asked = list(asked_of(method.mechanism).values())
    one, other = (_answers(asked, readings(m, p)) for m, p in ((method, plot), (there, replay_all(there))))
    sizes = {q.unit: max(abs(v) for v, r in zip(one, asked, strict=True) if r.unit == q.unit) for q in asked}
    off = np.array([_off(q, a, b) / (sizes[q.unit] or 1.0) for q, a, b in zip(asked, one, other, strict=True)])
    return bool(np.all(off[~np.isnan(off)] < _SAME))


def _answers(asked: list[Quantity], found: Motions) -> list[float]:
    return [float(quantity.answer(found).value) for quantity in asked]


def _off(quantity: Quantity, one: float, other: float) -> float:
    """By how much, an angle but for whole turns."""
    return abs(math.remainder(one - other, math.tau)) if quantity.unit == "rad" else abs(one - other)


