"""A design as plain data for JSON: metres, radians; what is infinite is null."""

from __future__ import annotations

import math
from typing import Any

from graphkin.say.design import phrased
from graphkin.studies.design import Design, Family, Solution


def as_json(design: Design) -> dict[str, Any]:
    """`{"format": 1, "solutions": [{"a": .., "b": .., ..}]}` in metres and radians; null where there is no such size.

    solutions   what meets the wishes; "valid" is false where it does not move through its positions, "why" says so
    rejected    points of the construction that look like solutions and are none
    bisectors   of two coupler positions: lines on which A and D are free (a point [m], a direction [rad])
    family      circles of crank centres: a, b, d, e, gamma_min along the admissible arcs, and the best point
    """
    return {
        "format": 1,
        "kind": design.kind,
        "given": dict(design.given),
        "solutions": [_data(one) for one in design.solutions],
        "rejected": [_data(one) for one in design.rejected],
        "why": [phrased(reason, "en") for reason in design.why],
        "bisectors": _bisectors(design),
        "family": [_family_data(one) for one in design.families],
    }


def _data(one: Solution) -> dict[str, Any]:
    return {
        "a": one.a, "b": one.b, "c": one.c, "d": one.d, "e": one.e, "gamma_min": one.gamma_min, "K": one.k,
        "swing": one.swing, "stroke": one.stroke, "theta": one.theta, "valid": one.valid,
        "why": [phrased(reason, "en") for reason in one.why], "notes": [phrased(reason, "en") for reason in one.notes],
        "points": {name: [place.real, place.imag] for name, place in one.places.items()},
        "positions": [{name: [z.real, z.imag] for name, z in places.items()} for places in one.limits],
        "slow": None if one.pace is None else ("ccw" if one.pace > 0 else "cw"),
    }  # fmt: skip


def _bisectors(design: Design) -> dict[str, Any] | None:
    if design.kind != "coupler" or design.best is None or len(design.best.limits) != 2:
        return None
    board = design.best.board()
    found: dict[str, Any] = {}
    for pivot, hinge in (("A", "B"), ("D", "C")):
        middle, (_, along) = (board.at(f"{hinge}1") + board.at(f"{hinge}2")) / 2, board.line(f"{hinge}12")
        found[pivot] = {"through": [middle.real, middle.imag], "direction": math.atan2(along.imag, along.real)}
    return found


def _family_data(one: Family) -> dict[str, Any]:
    """Every twentieth point; the arrays themselves have them all."""
    part = slice(None, None, 20)
    sizes = {"a": one.a, "b": one.b, "d": one.d, "e": one.e, "gamma_min": one.gamma_min}
    data: dict[str, Any] = {name: None if v is None else [float(x) for x in v[part]] for name, v in sizes.items()}
    data["A"] = [[float(z.real), float(z.imag)] for z in one.at[part]]
    data["arcs"] = [{"from": arc.start, "to": arc.end, "name": arc.name} for arc in one.arcs]
    known = math.isfinite(one.best[1])
    best = {"angle": one.best[0], "gamma_min": one.best[1]} if known else None
    return {"centre": [one.centre.real, one.centre.imag], "radius": one.radius, "best": best, **data}
