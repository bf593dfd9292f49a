"""The few sums that are done beside the drawing, by name. Angles [rad], lengths [m]."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

import numpy as np

from graphkin.base.geometry import Value

ROUNDING = 1e-9
"""Sines below this are none."""


def theta_of(k: float) -> float:
    """Angle between the crank's two limit positions: 180 deg (K - 1)/(K + 1) (极位夹角)."""
    return math.pi * (k - 1) / (k + 1)


def _sine(angle: Value) -> Value:
    """Nothing for what is only rounding."""
    sine = np.sin(angle)
    return np.where(np.abs(sine) < ROUNDING, 0.0, sine)[()]


RULES: Mapping[str, Callable[..., Value]] = {
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
    "sines": lambda side, one, other: side * abs(_sine(one) / _sine(other)),
    "sense": lambda sense, angle: sense * np.sign(np.cos(angle)),
    "sense of sines": lambda sense, one, other: sense * np.sign(np.sin(one) * np.sin(other)),
    "rate": lambda speed, arm, scale: speed / (arm * scale),
}
