"""Which curves stand together in a motion diagram, on which axes, and how the axes are divided."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from graphkin.base.value import frozen
from graphkin.model.quantities import EDGE, Quantity
from graphkin.outputs.diagram.curves import Curves
from graphkin.sheet.lettering import Label, joined
from graphkin.sheet.results import label_of

MOST = 6
"""More curves than these do not stand together."""
KINDS = ("position", "velocity", "acceleration", "ratio")
LETTERS = {"rad": "θ", "m": "s", "rad/s": "ω", "m/s": "v", "rad/s^2": "α", "m/s^2": "a", "g": "a", "1": ""}
HEADROOM = 0.16
"""Room above and below the curves for what is written at them, as a part of their height."""


_PLACE = {"rad": (0, 0), "m": (0, 1), "rad/s": (1, 0), "m/s": (1, 1), "rad/s^2": (2, 0), "m/s^2": (2, 1), "1": (3, 0)}
"""By SI unit: the kind of panel, and whether it is the second axis of one."""


@frozen
class Axis:
    """An upright axis: SI unit, and the numbers of its curves."""

    unit: str
    curves: tuple[int, ...]


@frozen
class CurvePanel:
    """Curves that stand together: one axis, or one on each side."""

    kind: str
    axes: tuple[Axis, ...]


def panels(units: Mapping[int, str]) -> tuple[CurvePanel, ...]:
    """Position above velocity above acceleration, quotients last; too many curves are shared out evenly.

    units  of the curves, by their numbers
    """
    return tuple(panel for number, kind in enumerate(KINDS) for panel in _of_kind(kind, number, units))


def _of_kind(kind: str, number: int, units: Mapping[int, str]) -> Iterator[CurvePanel]:
    groups: dict[str, list[int]] = {}
    for k, unit in sorted(units.items(), key=lambda entry: (_PLACE.get(entry[1], (3, 1))[1], entry[0])):
        if _PLACE.get(unit, (3, 1))[0] == number:
            groups.setdefault(unit, []).append(k)
    if len(groups) <= 2 and sum(map(len, groups.values())) <= MOST:
        if groups:
            yield CurvePanel(kind, tuple(Axis(unit, tuple(group)) for unit, group in groups.items()))
        return
    for unit, group in groups.items():
        size = math.ceil(len(group) / math.ceil(len(group) / MOST))
        for begin in range(0, len(group), size):
            yield CurvePanel(kind, (Axis(unit, tuple(group[begin : begin + size])),))


# --- scales -----------------------------------------------------------------------------------


def limits(found: Curves, panel: CurvePanel) -> list[tuple[float, float]]:
    """Least and greatest value of each axis, as shown; the zeros of two axes of a panel lie on one line."""
    ends = [_ends(found, axis, with_zero=panel.kind != "position") for axis in panel.axes]
    if panel.kind != "position":
        ends = _zeros_level(ends)
    return [_roomy(low, high) for low, high in ends]


def _ends(found: Curves, axis: Axis, with_zero: bool) -> tuple[float, float]:
    factor = EDGE[axis.unit].factor
    bounds = [(low * factor, high * factor) for low, high in map(found.bounds, axis.curves)]
    extra = [0.0] if with_zero else []
    return min([low for low, _ in bounds] + extra), max([high for _, high in bounds] + extra)


def _zeros_level(ends: list[tuple[float, float]]) -> list[tuple[float, float]]:
    sizes = [max(-low, high) or 1.0 for low, high in ends]
    down = max(-low / size for (low, _), size in zip(ends, sizes, strict=True))
    up = max(high / size for (_, high), size in zip(ends, sizes, strict=True))
    return [(-down * size, up * size) for size in sizes]


def _roomy(low: float, high: float) -> tuple[float, float]:
    size = high - low
    if size <= 1e-9 * max(abs(low), abs(high)) or size == 0:
        size = abs(high) or 1.0
    return low - HEADROOM * size, high + HEADROOM * size


def division(low: float, high: float, most: int, degrees: bool = False) -> list[float]:
    """Round values from low to high, at most so many: steps of 1, 2, 5, and of 15, 30, 60, 90 for degrees."""
    least = (high - low) / most
    step = next((s for s in (15.0, 30.0, 60.0, 90.0, 180.0, 360.0) if s >= least), 0.0) if degrees else 0.0
    if not step or (degrees and least <= 10):
        power = 10.0 ** math.floor(math.log10(least))
        step = next(power * k for k in (1, 2, 5, 10) if power * k >= least * (1 - 1e-9))
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [k * step for k in range(first, last + 1)]


# --- names ------------------------------------------------------------------------------------


def labels_of(quantities: Sequence[Quantity]) -> Label:
    """`ω₂ = ω₃`: curves that lie on one another."""
    return joined([label_of(quantity, "/") for quantity in quantities], " = ")
