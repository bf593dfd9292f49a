"""What paper allows, and how well mistakes are told apart, for programs; SI units, radians."""

from __future__ import annotations

import math
from typing import Any

from graphkin.marking.discriminability import SetDiscriminability
from graphkin.marking.pencil import Mark
from graphkin.marking.power import Power
from graphkin.marking.tolerances import Tolerances

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


def told_data(told: SetDiscriminability) -> Json:
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
