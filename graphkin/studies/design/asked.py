"""What may be asked for: values within their bounds, one condition more where one is free."""

from __future__ import annotations

import math
from collections.abc import Mapping

from graphkin.errors import OneCondition, WantedRange


def positive(**lengths: float | None) -> None:
    """Raises WantedRange for a length that is none [m]."""
    for name, value in lengths.items():
        if value is not None and not (math.isfinite(value) and value > 0):
            raise WantedRange(name, f"{value * 1e3:.6g} mm", "0 mm", "∞")


def angle_within(name: str, value: float | None, high: float) -> None:
    """Raises WantedRange for an angle not between 0 and `high` [rad]."""
    if value is not None and not 0 < value < high:
        raise WantedRange(name, f"{math.degrees(value):.6g}°", "0°", f"{math.degrees(high):g}°")


def ratio_within(k: float, high: float = 3.0) -> None:
    """Raises WantedRange for a time ratio outside 1 < K < high: at 1 there is no quick return, at 3 theta is 90 deg."""
    if not 1 < k < high:
        raise WantedRange("K", f"{k:g}", "1", f"{high:g}")


def one_of(conditions: Mapping[str, float | None], least: int = 0) -> str:
    """The one condition that is given, "" where none is. Raises OneCondition for more, or fewer than `least`."""
    given = [name for name, value in conditions.items() if value is not None]
    if not least <= len(given) <= 1:
        raise OneCondition(", ".join(given), ", ".join(conditions), "1" if least else "≤ 1")
    return given[0] if given else ""
