"""Where a quantity equals, exceeds or stays below a value or another quantity."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise

import numpy as np

from graphkin.errors import NegativeSize, OtherUnits, Where
from graphkin.finding.conditions import Comparison, value
from graphkin.finding.found import Interval, Kind, Position
from graphkin.finding.ground import ROUNDING, TURN, Ground
from graphkin.finding.search import Curve, Function, crossings, differences, followed, tops, touches, vanishing
from graphkin.sweeps import Series
from graphkin.value import frozen

__all__ = ["Difference", "difference", "holding", "intervals", "nearest"]



@frozen
class Difference:
    """Left side less right side of a comparison over the places looked at.

    target     the value, SI; None where both sides are quantities
    vanishing  whether a vector is to come to nothing
    curve      angles: from -180 to 180 degrees
    """

    ground: Ground
    target: float | None
    vanishing: bool
    curve: Curve
    everywhere: bool


def difference(ground: Ground, wanted: Comparison, drawn: tuple[Series, ...], where: Where) -> Difference:
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
    function = _function(ground, target, wanted.size, turning)
    slope = ground.slope(size=wanted.size) if wanted.numeric else differences(_unturned(ground), ground.step / 2)
    curve = followed(function, slope, ground.places)
    gone = target == 0 and first.vectors is not None and first.along is None and wanted.sign == "="
    there = curve.values[np.isfinite(curve.values)]
    scale = max(abs(target or 0.0), _scale(ground))
    small = max(ROUNDING * scale, ground.noise(first.unit))
    always = bool(there.size) and float(np.max(np.abs(there))) <= small
    if there.size and float(np.ptp(there)) <= small:
        curve, gone = _level(curve, float(np.median(there))), False
    return Difference(ground, target, gone, curve, always)


def _level(curve: Curve, value: float) -> Curve:
    """The curve without its rounding, of whose tops and bottoms there are thousands."""
    values = np.where(np.isfinite(curve.values), value, np.nan)
    return Curve(curve.t, values, lambda t: np.full(t.shape, value), lambda t: np.zeros(t.shape))


def _scale(ground: Ground) -> float:
    """How large the quantities are."""
    values = np.concatenate([np.abs(entry.signed) for entry in ground.read(ground.places)])
    return float(np.nanmax(values, initial=0.0))


def _function(ground: Ground, target: float | None, size: bool, turning: bool) -> Function:
    def function(t: np.ndarray) -> np.ndarray:
        sides = [np.abs(entry.signed) if size else entry.signed for entry in ground.read(t)]
        found = sides[0] - (target if target is not None else sides[1])
        return np.mod(found + math.pi, TURN) - math.pi if turning else found

    return function


def _unturned(ground: Ground) -> Function:
    """The difference of two quantities, angles without jumps."""

    def function(t: np.ndarray) -> np.ndarray:
        one, other = (entry.signed for entry in ground.read(t))
        return np.asarray(one - other)

    return function


# --- zeros ------------------------------------------------------------------------------------


def holding(found: Difference) -> tuple[Position, ...]:
    """All places of a ground where both sides are equal."""
    ground = found.ground
    if found.vanishing:
        t, _ = vanishing(ground.places, *_vectors(ground))
        return tuple(ground.position(place, "zero") for place in ground.within(t))
    crossed, touched = ground.within(_real(found.curve, crossings)), ground.within(_real(found.curve, touches))
    kinds: dict[float, Kind] = {float(t): "zero" for t in crossed}
    close = 1e-7 * (ground.high - ground.low)
    kinds |= {float(t): "touch" for t in touched if np.all(np.abs(crossed - t) > close)}
    return tuple(ground.position(t, kinds[t]) for t in sorted(kinds))


def _real(curve: Curve, look: Callable[[Curve], np.ndarray]) -> np.ndarray:
    """Zeros of an angle's difference that are none half a turn off, where it jumps."""
    found = look(curve)
    with np.errstate(invalid="ignore"):
        return found[np.abs(curve.function(found)) < 1.0 + 1e-3 * curve.size]


def _vectors(ground: Ground) -> tuple[np.ndarray, Function]:
    def function(t: np.ndarray) -> np.ndarray:
        vectors = ground.read(t)[0].vectors
        assert vectors is not None
        return vectors

    return function(ground.places), function


def nearest(found: Difference) -> Position | None:
    """Where the two sides come nearest to each other, when they never meet."""
    ground, curve = found.ground, found.curve
    if found.vanishing:
        _, inner = vanishing(ground.places, *_vectors(ground))
    else:
        inner = np.concatenate([tops(curve), tops(curve, -1.0)])
    with np.errstate(invalid="ignore"):
        inner = inner[np.abs(curve.function(inner)) < np.inf]
    margin = 1e-9 * (ground.high - ground.low)
    margins = [margin if stopped else 0.0 for stopped in ground.stopped]
    ends = np.array([ground.low + margins[0], ground.high - margins[1]])
    places = np.concatenate([ground.within(inner), ends])
    apart = np.abs(curve.function(places))
    if not np.isfinite(apart).any():
        return None
    return ground.position(float(places[np.nanargmin(apart)]), "nearest")


# --- more, or less ----------------------------------------------------------------------------


def intervals(found: Difference, sign: str) -> tuple[Interval, ...]:
    """Parts of the ground where the left side is greater (`>`) or less (`<`) than the right one."""
    ground, curve = found.ground, found.curve
    up = 1.0 if sign == ">" else -1.0
    cuts = [ground.low, *ground.within(crossings(curve)), *_jumps(curve), ground.high]
    cuts = sorted(set(cuts))
    parts = [(a, b) for a, b in pairwise(cuts) if b - a > 1e-9 * (ground.high - ground.low)]
    inside = [(a, b) for a, b in parts if _mostly(curve, up, a, b)]
    return tuple(_interval(ground, curve, up, a, b) for a, b in _joined(ground, inside))


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


def _joined(ground: Ground, parts: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Neighbours are one; on a full turn the last goes on in the first."""
    found: list[tuple[float, float]] = []
    for begin, end in parts:
        if found and begin == found[-1][1]:
            found[-1] = found[-1][0], end
        else:
            found.append((begin, end))
    if len(found) > 1 and ground.closed and found[0][0] == ground.low and found[-1][1] == ground.high:
        first = found.pop(0)
        found[-1] = found[-1][0], first[1] + TURN
    return found


def _interval(ground: Ground, curve: Curve, up: float, begin: float, end: float) -> Interval:
    inner = tops(curve, up)
    inner = np.concatenate([inner, inner + TURN]) if end > ground.high else inner
    places = np.concatenate([[begin], inner[(inner > begin) & (inner < end)], [end]])
    here = np.where(places > ground.high, places - TURN, places)
    with np.errstate(invalid="ignore"):
        high = up * np.nan_to_num(curve.function(here), nan=-up * np.inf)
    k = int(np.argmax(high))
    return Interval(_end(ground, begin), _end(ground, end), _seen(ground, float(places[k]), "max" if up > 0 else "min"))


def _end(ground: Ground, t: float) -> Position:
    """An end of an interval: of the condition, of what was asked for, or at a dead point."""
    close = 1e-9 * (ground.high - ground.low)
    for place, stop in zip((ground.low, ground.high), ground.stopped):
        if abs(t - place) <= close:
            return _seen(ground, t, "stop" if stop else "end")
    return _seen(ground, t, "zero")


def _seen(ground: Ground, t: float, kind: Kind) -> Position:
    """A position that may lie a turn on: read where it was looked at."""
    here = t - TURN if t > ground.high else t
    if kind == "stop" or (any(ground.stopped) and here in (ground.low, ground.high)):
        inward = 1e-7 * (ground.high - ground.low)
        here = min(max(here, ground.low + inward), ground.high - inward)
    values = ground.position(here, kind).values
    return ground.position(t, kind, values)
