"""Where a quantity equals, exceeds or stays below a value or another quantity."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise

import numpy as np

from graphkin.base.value import frozen
from graphkin.errors import NegativeSize, OtherUnits, Where
from graphkin.studies.finding.answers import Interval, Kind, Position
from graphkin.studies.finding.conditions import Comparison, value
from graphkin.studies.finding.search import Curve, Function, crossings, differences, followed, tops, touches, vanishing
from graphkin.studies.finding.stretch import ROUNDING, TURN, Stretch
from graphkin.studies.sweeps import Series


@frozen
class Difference:
    """Left side less right side of a comparison over the places looked at.

    target     the value, SI; None where both sides are quantities
    vanishing  whether a vector is to come to nothing
    curve      angles: from -180 to 180 degrees
    """

    stretch: Stretch
    target: float | None
    vanishing: bool
    curve: Curve
    everywhere: bool


def difference(stretch: Stretch, wanted: Comparison, drawn: tuple[Series, ...], where: Where) -> Difference:
    """The two sides held against each other. Raises OtherUnits, NegativeSize, and what a wrong value raises."""
    first = drawn[0]
    target = None
    if wanted.numeric:
        target = value(wanted.other, first.unit, where)
        signless = wanted.size or (first.vectors is not None and first.along is None)
        if target < 0 and signless:
            raise NegativeSize(where, wanted.quantity, wanted.other)
    elif first.unit != drawn[1].unit:
        raise OtherUnits(where, first.name, first.unit, drawn[1].name, drawn[1].unit)
    turning = first.unit == "rad" and wanted.sign == "=" and not wanted.size
    function = _function(stretch, target, wanted.size, turning)
    slope = stretch.slope(size=wanted.size) if wanted.numeric else differences(_unturned(stretch), stretch.step / 2)
    curve = followed(function, slope, stretch.places)
    gone = target == 0 and first.vectors is not None and first.along is None and wanted.sign == "="
    there = curve.values[np.isfinite(curve.values)]
    scale = max(abs(target or 0.0), _scale(stretch))
    small = max(ROUNDING * scale, stretch.noise(first.unit))
    always = bool(there.size) and float(np.max(np.abs(there))) <= small
    if there.size and float(np.ptp(there)) <= small:
        curve, gone = _level(curve, float(np.median(there))), False
    return Difference(stretch, target, gone, curve, always)


def _level(curve: Curve, value: float) -> Curve:
    """The curve without its rounding, of whose tops and bottoms there are thousands."""
    values = np.where(np.isfinite(curve.values), value, np.nan)
    return Curve(curve.t, values, lambda t: np.full(t.shape, value), lambda t: np.zeros(t.shape))


def _scale(stretch: Stretch) -> float:
    """How large the quantities are."""
    values = np.concatenate([np.abs(entry.signed) for entry in stretch.read(stretch.places)])
    return float(np.nanmax(values, initial=0.0))


def _function(stretch: Stretch, target: float | None, size: bool, turning: bool) -> Function:
    def function(t: np.ndarray) -> np.ndarray:
        sides = [np.abs(entry.signed) if size else entry.signed for entry in stretch.read(t)]
        found = sides[0] - (target if target is not None else sides[1])
        return np.mod(found + math.pi, TURN) - math.pi if turning else found

    return function


def _unturned(stretch: Stretch) -> Function:
    """The difference of two quantities, angles without jumps."""

    def function(t: np.ndarray) -> np.ndarray:
        one, other = (entry.signed for entry in stretch.read(t))
        return np.asarray(one - other)

    return function


# --- zeros ------------------------------------------------------------------------------------


def holding(found: Difference) -> tuple[Position, ...]:
    """All places of a stretch where both sides are equal."""
    stretch = found.stretch
    if found.vanishing:
        t, _ = vanishing(stretch.places, *_vectors(stretch))
        return tuple(stretch.position(place, "zero") for place in stretch.within(t))
    crossed, touched = stretch.within(_real(found.curve, crossings)), stretch.within(_real(found.curve, touches))
    kinds: dict[float, Kind] = {float(t): "zero" for t in crossed}
    close = 1e-7 * (stretch.high - stretch.low)
    kinds |= {float(t): "touch" for t in touched if np.all(np.abs(crossed - t) > close)}
    return tuple(stretch.position(t, kinds[t]) for t in sorted(kinds))


def _real(curve: Curve, look: Callable[[Curve], np.ndarray]) -> np.ndarray:
    """Zeros of an angle's difference that are none half a turn off, where it jumps."""
    found = look(curve)
    with np.errstate(invalid="ignore"):
        return found[np.abs(curve.function(found)) < 1.0 + 1e-3 * curve.size]


def _vectors(stretch: Stretch) -> tuple[np.ndarray, Function]:
    def function(t: np.ndarray) -> np.ndarray:
        vectors = stretch.read(t)[0].vectors
        assert vectors is not None
        return vectors

    return function(stretch.places), function


def nearest(found: Difference) -> Position | None:
    """Where the two sides come nearest to each other, when they never meet."""
    stretch, curve = found.stretch, found.curve
    if found.vanishing:
        _, inner = vanishing(stretch.places, *_vectors(stretch))
    else:
        inner = np.concatenate([tops(curve), tops(curve, -1.0)])
    with np.errstate(invalid="ignore"):
        inner = inner[np.abs(curve.function(inner)) < np.inf]
    margin = 1e-9 * (stretch.high - stretch.low)
    margins = [margin if stopped else 0.0 for stopped in stretch.stopped]
    ends = np.array([stretch.low + margins[0], stretch.high - margins[1]])
    places = np.concatenate([stretch.within(inner), ends])
    apart = np.abs(curve.function(places))
    if not np.isfinite(apart).any():
        return None
    return stretch.position(float(places[np.nanargmin(apart)]), "nearest")


# --- more, or less ----------------------------------------------------------------------------


def intervals(found: Difference, sign: str) -> tuple[Interval, ...]:
    """Parts of the stretch where the left side is greater (`>`) or less (`<`) than the right one."""
    stretch, curve = found.stretch, found.curve
    up = 1.0 if sign == ">" else -1.0
    cuts = [stretch.low, *stretch.within(crossings(curve)), *_jumps(curve), stretch.high]
    cuts = sorted(set(cuts))
    parts = [(a, b) for a, b in pairwise(cuts) if b - a > 1e-9 * (stretch.high - stretch.low)]
    inside = [(a, b) for a, b in parts if _mostly(curve, up, a, b)]
    return tuple(_interval(stretch, curve, up, a, b) for a, b in _joined(stretch, inside))


def _jumps(curve: Curve) -> list[float]:
    """Where a quotient goes through infinity: its sign changes, but not through zero."""
    with np.errstate(invalid="ignore"):
        k = np.flatnonzero(curve.values[:-1] * curve.values[1:] < 0)
    zeros = np.searchsorted(crossings(curve), curve.t)
    return [float(curve.t[j]) for j in k if zeros[j] == zeros[j + 1]]


def _mostly(curve: Curve, up: float, begin: float, end: float) -> bool:
    values = curve.function(begin + (end - begin) * np.array([0.2, 0.5, 0.8]))
    with np.errstate(invalid="ignore"):
        return bool(np.sum(up * values > 0) >= 2)


def _joined(stretch: Stretch, parts: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Neighbours are one; on a full turn the last goes on in the first."""
    found: list[tuple[float, float]] = []
    for begin, end in parts:
        if found and begin == found[-1][1]:
            found[-1] = found[-1][0], end
        else:
            found.append((begin, end))
    if len(found) > 1 and stretch.closed and found[0][0] == stretch.low and found[-1][1] == stretch.high:
        first = found.pop(0)
        found[-1] = found[-1][0], first[1] + TURN
    return found


def _interval(stretch: Stretch, curve: Curve, up: float, begin: float, end: float) -> Interval:
    inner = tops(curve, up)
    inner = np.concatenate([inner, inner + TURN]) if end > stretch.high else inner
    places = np.concatenate([[begin], inner[(inner > begin) & (inner < end)], [end]])
    here = np.where(places > stretch.high, places - TURN, places)
    with np.errstate(invalid="ignore"):
        high = up * np.nan_to_num(curve.function(here), nan=-up * np.inf)
    k = int(np.argmax(high))
    most = _seen(stretch, float(places[k]), "max" if up > 0 else "min")
    return Interval(_end(stretch, begin), _end(stretch, end), most)


def _end(stretch: Stretch, t: float) -> Position:
    """An end of an interval: of the condition, of what was asked for, or at a dead point."""
    close = 1e-9 * (stretch.high - stretch.low)
    for place, stop in zip((stretch.low, stretch.high), stretch.stopped):
        if abs(t - place) <= close:
            return _seen(stretch, t, "stop" if stop else "end")
    return _seen(stretch, t, "zero")


def _seen(stretch: Stretch, t: float, kind: Kind) -> Position:
    """A position that may lie a turn on: read where it was looked at."""
    here = t - TURN if t > stretch.high else t
    if kind == "stop" or (any(stretch.stopped) and here in (stretch.low, stretch.high)):
        inward = 1e-7 * (stretch.high - stretch.low)
        here = min(max(here, stretch.low + inward), stretch.high - inward)
    values = stretch.position(here, kind).values
    return stretch.position(t, kind, values)
