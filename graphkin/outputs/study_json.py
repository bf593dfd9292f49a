"""Designs, tolerances of paper and the power of marking as plain data for JSON; SI units, radians; infinite is null."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from graphkin.base.geometry import Value, number
from graphkin.base.plain import Plain

if TYPE_CHECKING:
    from graphkin.marking.discriminability import SetDiscriminability
    from graphkin.marking.power import Power
    from graphkin.marking.tolerances import Tolerances
    from graphkin.studies.design import Design, Solution

Json = dict[str, Plain]


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None


def as_json(design: Design) -> Json:
    """`{"format": 1, "solutions": [{"a": .., "b": .., ..}]}` in metres and radians; null where there is no such size.

    solutions   the linkages that meet the wishes; "valid" is false for one that does not move through its positions,
                "why" says so
    rejected    points of the construction that look like solutions and are none
    bisectors   of two coupler positions: lines on which A and D are free (a point [m], a direction [rad])
    family      circles of crank centres: a, b, d, e, gamma_min along the admissible arcs, and the best point
    """
    from graphkin.say.design import phrased

    families: list[Json] = []
    for one in design.families:  # every twentieth point; the arrays themselves have them all
        arrays = {"a": one.a, "b": one.b, "d": one.d, "e": one.e, "gamma_min": one.gamma_min}
        families.append({
            "centre": [one.centre.real, one.centre.imag], "radius": one.radius,
            "best": {"angle": one.best[0], "gamma_min": one.best[1]} if math.isfinite(one.best[1]) else None,
            **{name: None if of is None else [float(value) for value in of[::20]] for name, of in arrays.items()},
            "A": [_xy(place) for place in one.at[::20]],
            "arcs": [{"from": arc.start, "to": arc.end, "name": arc.name} for arc in one.arcs],
        })  # fmt: skip
    bisectors: Json | None = None
    if design.kind == "coupler" and design.best is not None and len(design.best.limits) == 2:
        board, bisectors = design.best.board(), {}
        for pivot, hinge in (("A", "B"), ("D", "C")):
            middle, (_, along) = (board.at(f"{hinge}1") + board.at(f"{hinge}2")) / 2, board.line(f"{hinge}12")
            bisectors[pivot] = {"through": _xy(middle), "direction": math.atan2(along.imag, along.real)}
    return {
        "format": 1, "kind": design.kind, "given": dict(design.given),
        "solutions": [_solution(one) for one in design.solutions],
        "rejected": [_solution(one) for one in design.rejected],
        "why": [phrased(reason, "en") for reason in design.why],
        "bisectors": bisectors,
        "family": families,
    }  # fmt: skip


def _solution(one: Solution) -> Json:
    from graphkin.say.design import phrased

    return {
        "a": one.a, "b": one.b, "c": one.c, "d": one.d, "e": one.e, "gamma_min": one.gamma_min, "K": one.k,
        "swing": one.swing, "stroke": one.stroke, "theta": one.theta, "valid": one.valid,
        "why": [phrased(reason, "en") for reason in one.why], "notes": [phrased(reason, "en") for reason in one.notes],
        "points": {name: _xy(place) for name, place in one.places.items()},
        "positions": [{name: _xy(place) for name, place in places.items()} for places in one.limits],
        "slow": None if one.pace is None else ("ccw" if one.pace > 0 else "cw"),
    }  # fmt: skip


def _xy(place: Value) -> Plain:
    return [number(place.real), number(place.imag)]


def tolerance_data(tolerances: Tolerances) -> Json:
    """Each quantity, and each step of the pencil with its part in the scatter. Of an answer that is not told also the
    part that may be off, and the scales of a larger drawing that tells it, or null."""
    key, marking = tolerances.key, tolerances.key.marking
    length, angle = marking.on_paper
    return {
        "format": 1, "name": key.name, "pencil": {"length_mm": length, "angle_deg": angle}, "sigmas": marking.sigmas,
        "relative": marking.relative, "scales": dict(marking.scales), "drawings": tolerances.drawings,
        "failed": tolerances.failed,
        "quantities": {
            entry.text: {
                "unit": entry.unit, "right": entry.right, "scatter": entry.scatter, "tolerance": entry.tolerance,
                "asked": entry.points > 0, **({"doubt": entry.doubt} if entry.doubt else {}),
                **dict(zip(("part", "told at scales"), tolerances.untold.get(entry.text, ()))),
            }
            for entry in tolerances.entries
        },
        "steps": [
            {
                "plane": cost.mark.plane, "what": cost.mark.what, "of": list(cost.mark.of),
                "name": cost.name, "part": cost.over_all, "parts": dict(cost.parts),
            }
            for cost in tolerances.costs
        ],
    }  # fmt: skip


def power_data(power: Power) -> Json:
    """An object a mistake at a place, and the rates of false alarms."""
    return {
        "handed in": list(power.texts), "trials": power.trials,
        "mistakes": [
            {
                **dict(zip(("id", "way", "of", "form"), one.name, strict=True)), "moved": one.moved,
                "applicable": one.applicable, "tellable": one.tellable,
                "wrong": _finite(one.wrong), "named": _finite(one.named), "alone": _finite(one.alone),
            }
            for one in power.found
        ],
        "right work": {"judged wrong": power.alarms[0], "mistake named": power.alarms[1]},
        "random numbers": {"mistake named": power.random},
    }  # fmt: skip


def told_data(set_: SetDiscriminability) -> Json:
    """The mistakes that a set's answers tell apart; parts from 0 to 1."""
    return {
        "problems": set_.problems, "pencil": dict(zip(("length_mm", "angle_deg"), set_.pencil, strict=True)),
        "places": set_.places, "applicable": set_.seen, "told apart": set_.apart, "lost by numbers": set_.lost,
        "mistakes": {
            id: {"places": places, "applicable": seen, "told apart": apart}
            for id, (places, seen, apart) in set_.kinds.items()
        },
        "sets": [{"ids": list(pair), "part": part} for pair, part in set_.sets.items()],
        "within tolerance": [{"ids": list(pair), "part": part} for pair, part in set_.rivals.items()],
        "right work": {"problems": set_.tried, "judged wrong": set_.alarms[0], "mistake named": set_.alarms[1]},
    }  # fmt: skip
