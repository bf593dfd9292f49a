"""Scales of a drawing: what one millimetre on paper stands for.

mu_l in m/mm, mu_v in (m/s)/mm, mu_a in (m/s²)/mm: chosen from the series of scales, or given and then kept.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any, ClassVar

import numpy as np

from graphkin.construction import Plane
from graphkin.errors import GraphkinError, Lang, Where
from graphkin.sheet.lettering import Label, Run, number, quantity_label

LETTERS: dict[Plane, str] = {"position": "l", "velocity": "v", "acceleration": "a"}
UNITS: dict[Plane, str] = {"position": "m/mm", "velocity": "(m/s)/mm", "acceleration": "(m/s²)/mm"}
KEYS: dict[Plane, str] = {"position": "length", "velocity": "velocity", "acceleration": "acceleration"}
"""Key of a plane's scale in the mechanism file."""
SERIES = (1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0)
"""What a scale begins with: 1-2-5 (ISO 5455, the first series of GB/T 14690) and between them its second series."""
_NONE = 1e-300
_CLOSE = 1 - 1e-9
"""A scale that is too fine by rounding alone still fits."""


class TooLargeForPaper(GraphkinError):
    """A given scale at which the drawing fits no paper."""

    where: Where
    key: str
    given: float
    fits: float
    paper: str
    unit: str

    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: at {given:g} {unit} the drawing does not fit on {paper}. {fits:g} would fit; "
        "or leave the scale out and it is chosen.",
        "zh": "{where}：按 {given:g} {unit}，图形放不进 {paper} 图纸。可改用 {fits:g}，或不写比例尺，由程序选取。",
    }


class UnknownPaper(GraphkinError):
    """A paper that is not in the table."""

    name: str
    known: str

    text: ClassVar[dict[Lang, str]] = {
        "en": "There is no paper {name!r} here. Take one of {known}.",
        "zh": "没有 {name!r} 这种图纸。可选：{known}。",
    }


def finest(size: complex, room: complex) -> float:
    """The finest scale of the series at which a figure of this width and height fits its room.

    size  width + i height in SI units; room  the same in mm. A figure of no size takes 1 per mm of its room's
    hundredth, so that a mechanism at rest has a scale too.
    """
    return _next(max(size.real / room.real, size.imag / room.imag))


def finest_each(least: Any) -> Any:
    """The scale of the series next above each of many values (0.01 where there is none), as `finest` takes it."""
    finest, coarsest = float(least.min()), float(least.max())
    if not finest > _NONE:
        return np.full(least.shape, _next(0.0))
    series = _series(_power(finest), _power(coarsest))
    return series[np.searchsorted(series, least * _CLOSE)]


@lru_cache(64)
def _series(first: int, last: int) -> Any:
    """All scales from one power of ten to the one after another, the finest first."""
    return np.array(sorted({scale for power in range(first, last + 1) for scale in _steps(power)}))


def _next(least: float) -> float:
    """The scale of the series next above a value."""
    if not least > _NONE:
        return 0.01
    steps = _steps(_power(least))
    return next((scale for scale in steps if scale >= least * _CLOSE), steps[-1])


def _power(value: float) -> int:
    """The power of ten next below it."""
    return math.floor(math.log10(value))


@lru_cache(64)
def _steps(power: int) -> tuple[float, ...]:
    """The scales of the series from a power of ten to the next."""
    return (*(float(f"{step}e{power}") for step in SERIES), float(f"1e{power + 1}"))


def finer(scale: float) -> float:
    """The next finer scale of the series."""
    power = math.floor(math.log10(scale) + 1e-9)
    at = SERIES.index(round(scale / 10.0**power, 1))
    return float(f"{SERIES[at - 1]}e{power if at else power - 1}")


def written(plane: Plane, scale: float) -> Label:
    """`μ_l = 0.001 m/mm`."""
    return (*quantity_label("μ", LETTERS[plane]), Run(" = "), *number(scale), Run(f" {UNITS[plane]}"))
