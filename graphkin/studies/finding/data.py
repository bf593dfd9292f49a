"""What was found, as plain data for JSON: SI units, radians; what is infinite is null."""

from __future__ import annotations

import math
from typing import Any

from graphkin.studies.finding.answers import Findings, Interval, Phase, Position, SlowPoint, Speeds

Json = dict[str, Any]


def as_json(found: Findings) -> Json:
    """One object; parts that have nothing to say are left out."""
    data: Json = {
        "format": 1,
        "name": found.mechanism.name,
        "condition": found.condition.text,
        "drivers": [driver.name for driver in found.drivers],
        "units": dict(zip(found.quantities, found.units)),
    }
    if found.looked is not None:
        data["looked"] = {"driver": found.drivers[found.swept].name, "from": found.looked[0], "to": found.looked[1]}
        data["looked"] |= {"turn": found.turn, "dead_points": list(found.stopped)}
        data["everywhere"] = found.everywhere
        data["positions"] = [_position(found, position) for position in found.positions]
    parts: Json = {
        "intervals": [_interval(found, part) for part in found.intervals],
        "nearest": _position(found, found.nearest) if found.nearest else None,
        "range": found.swing,
        "slowest": [_slow(found, entry) for entry in found.slow],
        "speeds": [_speeds(found, entry) for entry in found.speeds],
        "notes": list(found.notes),
    }
    if found.stroke is not None:
        data["stroke"] = {"advance": _phase(found.stroke.advance), "return": _phase(found.stroke.retreat)}
        data["stroke"]["K"] = found.stroke.ratio
    return data | {key: part for key, part in parts.items() if part not in (None, [])}


def _position(found: Findings, position: Position) -> Json:
    values = {name: _finite(value) for name, value in zip(found.quantities, position.values)}
    return {"drivers": list(position.drivers), "values": values, "kind": position.kind}


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None


def _interval(found: Findings, part: Interval) -> Json:
    return {key: _position(found, getattr(part, key)) for key in ("begin", "end", "peak")}


def _phase(phase: Phase) -> Json:
    return {"growing": phase.up, "angle": phase.angle, "time": phase.time, "mean_speed": phase.mean}


def _slow(found: Findings, entry: SlowPoint) -> Json:
    return {
        "drivers": list(entry.position.drivers), "line": list(entry.points), "from_first": entry.along,
        "length": entry.length, "place": [entry.place.real, entry.place.imag], "speed": entry.speed,
    }  # fmt: skip


def _speeds(found: Findings, entry: Speeds) -> Json:
    rates = {driver.name: rate for driver, rate in zip(found.drivers, entry.rates)}
    return {"drivers": list(entry.position.drivers), "rates": rates, "factor": entry.factor, "value": entry.value}
