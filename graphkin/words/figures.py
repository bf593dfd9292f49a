"""How a figure is written: four significant digits, which is what paper gives."""

from __future__ import annotations

import cmath
from decimal import Decimal

__all__ = ["degrees", "number"]

_PLAIN = range(-6, 9)
"""Powers of ten that are still written out."""


def number(value: float, zero: float = 0.0) -> str:
    """`27.12`, `69.2`, `−3.919`, `0`; `1.2e−12` only where nobody would count the zeros.

    zero  sizes up to this are rounding noise, and 0
    """
    if abs(value) <= zero or value == 0:
        return "0"
    text = f"{value:.4g}"
    mantissa, _, exponent = text.partition("e")
    if exponent:
        written_out = int(exponent) in _PLAIN
        text = format(Decimal(text), "f") if written_out else f"{mantissa}e{int(exponent)}"
    return text.replace("-", "−")


def degrees(vector: complex) -> str:
    """Direction of a vector, counter-clockwise from +x, from 0 to 360: `153.4°`."""
    angle = round(cmath.phase(vector) * 180 / cmath.pi, 6) % 360
    return f"{number(angle if float(f'{angle:.4g}') < 360 else 0.0)}°"
