"""Studies."""

from __future__ import annotations

import math
from typing import Any

from graphkin.marking.power import Power
from graphkin.marking.slips import Mark
from graphkin.marking.told import SetTold
from graphkin.marking.tolerances import Tolerances
from graphkin.say.design import said
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
        "why": [said(reason, "en") for reason in design.why],
        "bisectors": _bisectors(design),
        "family": [_family_data(one) for one in design.families],
    }


def _data(one: Solution) -> dict[str, Any]:
    return {
        "a": one.a, "b": one.b, "c": one.c, "d": one.d, "e": one.e, "gamma_min": one.gamma_min, "K": one.k,
        "swing": one.swing, "stroke": one.stroke, "theta": one.theta, "valid": one.valid,
        "why": [said(reason, "en") for reason in one.why], "notes": [said(reason, "en") for reason in one.notes],
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


Json = dict[str, Any]


def tolerance_data(found: Tolerances) -> Json:
    """Each quantity, and each step of the pencil with its part in the scatter."""
    marking = found.key.marking
    length, angle = marking.on_paper
    return {
        "format": 1,
        "name": found.key.name,
        "pencil": {"length_mm": length, "angle_deg": angle},
        "sigmas": marking.sigmas,
        "relative": marking.relative,
        "scales": dict(marking.scales),
        "drawings": found.drawings,
        "failed": found.failed,
        "quantities": {
            entry.text: {
                "unit": entry.unit, "right": entry.right, "scatter": entry.scatter, "tolerance": entry.tolerance,
                "asked": entry.points > 0, **({"doubt": entry.doubt} if entry.doubt else {}),
            }
            for entry in found.entries
        },
        "steps": [
            {**_mark(cost.mark), "name": cost.name, "part": cost.over_all, "parts": dict(cost.parts)}
            for cost in found.costs
        ],
    }  # fmt: skip


def _mark(mark: Mark) -> Json:
    return {"plane": mark.plane, "what": mark.what, "of": list(mark.of)}


def power_data(power: Power) -> Json:
    """An object a mistake at a place, and the rates of false alarms."""
    return {
        "handed in": list(power.texts),
        "trials": power.trials,
        "mistakes": [
            {
                **dict(zip(("id", "way", "of", "form"), one.name, strict=True)), "moved": one.moved,
                "applicable": one.applicable, "tellable": one.tellable,
                "wrong": _part(one.wrong), "named": _part(one.named),
                "alone": _part(one.alone),
            }
            for one in power.found
        ],
        "right work": {"judged wrong": power.alarms[0], "mistake named": power.alarms[1]},
        "random numbers": {"mistake named": power.random},
    }  # fmt: skip


def told_data(told: SetTold) -> Json:
    """What a set's answers tell of mistakes; parts from 0 to 1."""
    return {
        "problems": told.problems,
        "pencil": dict(zip(("length_mm", "angle_deg"), told.pencil, strict=True)),
        "places": told.places,
        "applicable": told.seen,
        "told apart": told.apart,
        "lost by numbers": told.lost,
        "mistakes": {
            id: {"places": places, "applicable": seen, "told apart": apart}
            for id, (places, seen, apart) in told.kinds.items()
        },
        "sets": [{"ids": list(pair), "part": part} for pair, part in told.sets.items()],
        "within tolerance": [{"ids": list(pair), "part": part} for pair, part in told.rivals.items()],
        "right work": {"problems": told.tried, "judged wrong": told.alarms[0], "mistake named": told.alarms[1]},
    }


def _part(value: float) -> float | None:
    return value if math.isfinite(value) else None
