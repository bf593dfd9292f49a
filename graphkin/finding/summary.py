"""What was found in one row of a table: how many columns it takes depends on the condition alone."""

from __future__ import annotations

from graphkin.errors import Lang
from graphkin.finding.answers import Found
from graphkin.finding.conditions import Comparison, Extreme, Scaling, Slowest
from graphkin.finding.wording import quantity

__all__ = ["header", "summary"]

HEADS: dict[str, dict[Lang, str]] = {
    "at": {"en": "at {driver}", "zh": "{driver} 的位置"},
    "min": {"en": "least", "zh": "最小"},
    "max": {"en": "greatest", "zh": "最大"},
    "swing": {"en": "difference", "zh": "差"},
    "stroke": {"en": "stroke", "zh": "行程"},
    "along": {"en": "from {first}", "zh": "距 {first}"},
    "speed": {"en": "speed", "zh": "速度"},
}


def header(found: Found, lang: Lang) -> list[str]:
    """Names of the columns."""

    def say(key: str, **data: str) -> str:
        return HEADS[key][lang].format(**data)

    at = say("at", driver=found.drivers[found.swept].name)
    match found.condition:
        case Extreme(which="stroke"):
            return [say("min"), say("max"), say("stroke"), "K"]
        case Extreme(which="range"):
            return [say("min"), say("max"), say("swing")]
        case Extreme(which=which):
            return [say(which), at]
        case Comparison():
            return [at]
        case Scaling():
            return [driver.name for driver in found.drivers]
        case Slowest():
            return [say("along", first=found.slow[0].points[0] if found.slow else ""), say("speed")]


def summary(found: Found) -> list[str]:
    """The cells of one row; `-` for what is not there."""
    match found.condition:
        case Extreme(which=which):
            return _extreme(found, which)
        case Comparison():
            return [_places(found)]
        case Scaling():
            kinds = [driver.kind for driver in found.drivers]
            rates = found.speeds[0].rates if found.speeds else ()
            return [quantity(rate, "m/s" if kind == "slide" else "rad/s") for kind, rate in zip(kinds, rates)]
        case Slowest():
            first = found.slow[0]
            return ["-" if first.along is None else quantity(first.along, "m"), quantity(first.speed, "m/s")]


def _driven(found: Found, value: float) -> str:
    return quantity(value, "m" if found.drivers[found.swept].kind == "slide" else "rad")


def _extreme(found: Found, which: str) -> list[str]:
    unit = found.units[0]
    if which in ("max", "min"):
        chosen = [p for p in found.positions if p.kind != "largest"]
        value = quantity(chosen[0].values[0], unit) if chosen else "-"
        return [value, ", ".join(_driven(found, p.drivers[found.swept]) for p in chosen) or "-"]
    ends = [p.values[0] for p in found.positions] or [0.0]
    cells = [quantity(min(ends), unit), quantity(max(ends), unit)]
    swing = 0.0 if found.everywhere else found.swing
    cells.append("-" if swing is None else quantity(swing, unit))
    return cells if which == "range" else [*cells, f"{found.stroke.ratio:.6g}" if found.stroke else "-"]


def _places(found: Found) -> str:
    if found.everywhere:
        return "="
    told = [_driven(found, p.drivers[found.swept]) for p in found.positions]
    ends = [(part.begin, part.end) for part in found.intervals]
    told += [" .. ".join(_driven(found, p.drivers[found.swept]) for p in pair) for pair in ends]
    return ", ".join(told) or "-"
