"""The series of scales: a drawing's is taken from it, or given and then kept; and round steps."""

from __future__ import annotations

import math

import numpy as np

from graphkin.base.geometry import Array

SERIES = (1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0)
"""The first digits of scales: 1-2-5 (ISO 5455, the first series of GB/T 14690) and between them its second series."""
_ALL = np.array([float(f"{step}e{power}") for power in range(-30, 30) for step in SERIES])
_NONE = 1e-30
_CLOSE = 1 - 1e-9  # a scale that is too fine by rounding alone still fits


def finest(size: complex, room: complex) -> float:
    """The finest scale of the series at which a figure [SI] fits its room [mm], both width + i height. One of no size
    takes 0.01, so that a mechanism at rest has a scale too."""
    return float(finest_each(np.array([max(size.real / room.real, size.imag / room.imag)]))[0])


def finest_each(least: Array) -> Array:
    """The scale of the series next above each of many values (0.01 where there is none)."""
    if not (least > _NONE).all():
        return np.full(least.shape, 0.01)
    return _ALL[np.searchsorted(_ALL, least * _CLOSE)]


def finer(scale: float) -> float:
    """The next finer scale of the series."""
    return float(_ALL[np.searchsorted(_ALL, scale * _CLOSE) - 1])


def round_step(size: float, up: bool = False) -> float:
    """The largest of 1, 2, 5 times powers of ten that is at most this; or the smallest that is at least this."""
    power = 10.0 ** math.floor(math.log10(size))
    if up:
        return next(power * k for k in (1, 2, 5, 10) if power * k >= size * _CLOSE)
    return next(power * k for k in (5, 2, 1, 0.5) if power * k * _CLOSE <= size)


def multiples(low: float, high: float, step: float) -> Array:
    """Those of a step from low to high."""
    return np.arange(math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) + 1) * step
