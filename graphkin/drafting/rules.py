"""The few sums that are done beside the drawing, by name. Angles [rad], lengths [m]."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

__all__ = ["RULES", "theta_of"]


def theta_of(k: float) -> float:
    """Angle between the crank's two limit positions: 180 deg (K - 1)/(K + 1) (极位夹角)."""
    return math.pi * (k - 1) / (k + 1)


RULES: Mapping[str, Callable[..., float]] = {
    "theta": theta_of,
    "complement": lambda angle: math.pi / 2 - angle,
    "above": lambda angle: math.pi / 2 + angle / 2,
    "half": lambda value: value / 2,
    "double": lambda value: 2 * value,
    "half difference": lambda one, other: abs(one - other) / 2,
    "half sum": lambda one, other: (one + other) / 2,
    "difference": lambda one, other: one - other,
    "straight": lambda: math.pi,
    "same": lambda value: value,
    "over": lambda one, other: one / other,
    "lever": lambda rate, arm, other: rate * arm / other,
    "speed": lambda rate, arm, scale: rate * arm * scale,
    "rate": lambda speed, arm, scale: speed / (arm * scale),
}
