"""A link about its pole, and centrodes, as data for other programs: SI units, numbers and lists alone."""

from __future__ import annotations

import cmath
from typing import Any

import numpy as np

from graphkin.studies.centres.about import About, CarriedPoint, Circle
from graphkin.studies.centres.centrodes import Centrodes

Json = dict[str, Any]


def about_json(seen: About) -> Json:
    """One object: poles, circles, and of each point its motion and the centre of curvature of its path.

    `pole` is a place [m], or {"direction": [x, y]} at infinity; null stands for what there is none of. `centre` of a
    point is "infinity" where its path is straight.
    """
    inflection, pole = seen.inflection, seen.pole
    line = inflection if not isinstance(inflection, Circle) else None
    return {
        "format": 1,
        "name": seen.found.method.mechanism.name,
        "link": seen.called,
        "speeds_assumed": seen.assumed,
        "pole": {"direction": _pair(seen.towards)} if cmath.isinf(pole) else _pair(pole),
        "omega": seen.omega,
        "alpha": seen.alpha,
        "acceleration_pole": _pair(seen.acceleration_pole),
        "pole_velocity": _pair(seen.pole_velocity),
        "tangent": _pair(seen.tangent),
        "inflection_circle": _circle(inflection) if isinstance(inflection, Circle) else None,
        "inflection_line": line and {"through": _pair(line.through), "direction": _pair(line.direction)},
        "return_circle": seen.returning and _circle(seen.returning),
        "points": {name: _point(carried) for name, carried in seen.points.items()},
    }


def _point(carried: CarriedPoint) -> Json:
    straight = cmath.isinf(carried.centre)
    return {
        "at": _pair(carried.place),
        "velocity": _pair(carried.velocity),
        "acceleration": _pair(carried.acceleration),
        "centre": "infinity" if straight else _pair(carried.centre),
        "radius": None if straight or cmath.isnan(carried.centre) else carried.radius,
    }


def _circle(drawn: Circle) -> Json:
    return {"centre": _pair(drawn.centre), "radius": drawn.radius}


def _pair(value: complex | None) -> list[float] | None:
    """[x, y]; None for nothing, and for what is nowhere."""
    if value is None or not cmath.isfinite(value):
        return None
    return [value.real + 0.0, value.imag + 0.0]


def centrodes_json(curves: Centrodes) -> Json:
    """One object: of each piece of the curves the drivers' values [rad, m] and the places [m] in each link's axes."""
    machine = curves.found.method.mechanism
    return {
        "format": 1,
        "name": machine.name,
        "centre": curves.name,
        "axes": [machine.called(link) for link in curves.axes],
        "drivers": [driver.name for driver in machine.drivers],
        "pieces": [
            {
                "closed": piece.closed,
                "drivers": [np.broadcast_to(value, piece.t.shape).tolist() for value in curves.path.values(piece.t)],
                "curves": [[[z.real, z.imag] for z in places.tolist()] for places in piece.places],
            }
            for piece in curves.pieces
        ],
    }
