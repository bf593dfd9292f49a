"""Zeros and extremes of a function of one variable, all of them: read closely, then polished to rounding.

A function here takes many places at once (n,) and gives NaN where there is nothing; no word of mechanisms.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

import numpy as np

from graphkin.base.value import frozen

Function = Callable[[np.ndarray], np.ndarray]

ROUNDS = 70
FINER = 3  # so often a curve is read more closely where it bends
BENT = 0.01  # between places where a curve bends by more than this part of its range, it is read more closely
GRAZE = 1e-10  # a curve that comes so near to zero, as a part of its size, grazes it
EVEN = 501
STENCIL = np.array([-4, -3, -2, -1, 1, 2, 3, 4], dtype=float)
WEIGHTS = np.array([1 / 280, -4 / 105, 1 / 5, -4 / 5, 4 / 5, -1 / 5, 4 / 105, -1 / 280])


@frozen
class Curve:
    """A function read closely.

    t, values  places (n,), rising, and its values there
    slope      its derivative, or anything of the same sign
    """

    t: np.ndarray
    values: np.ndarray
    function: Function
    slope: Function

    @cached_property
    def size(self) -> float:
        """Its size over most of its length, whatever it does where it may grow without limit."""
        even = np.searchsorted(self.t, np.linspace(self.t[0], self.t[-1], EVEN))
        large = np.abs(self.values[np.minimum(even, self.t.size - 1)])
        large = large[np.isfinite(large)]
        return float(np.percentile(large, 75)) if large.size else 0.0

    @cached_property
    def crests(self) -> np.ndarray:
        """Places at which it is greatest among its neighbours."""
        return _tops(self, 1.0)

    @cached_property
    def troughs(self) -> np.ndarray:
        """Places at which it is least among its neighbours."""
        return _tops(self, -1.0)

    @cached_property
    def zeros(self) -> np.ndarray:
        """Places at which it changes sign through zero (not through infinity)."""
        left, right = self.values[:-1], self.values[1:]
        with np.errstate(invalid="ignore"):
            k = np.flatnonzero(left * right < 0)
        zeros = bisected(self.function, self.t[k], self.t[k + 1])
        ends = np.abs(left[k]) + np.abs(right[k])
        small = np.abs(self.function(zeros)) <= 1e-6 * ends + 1e-12 * self.size
        return np.sort(np.concatenate([zeros[small], self.t[self.values == 0], _hidden(self)]))


def followed(function: Function, slope: Function, t: np.ndarray) -> Curve:
    """The curve at places t and at more where it bends."""
    values = function(t)
    for _ in range(FINER):
        more = _bends(t, values)
        if not more.size or t.size > 60_000:
            break
        places = np.concatenate([t, more])
        order = np.argsort(places)
        t, values = places[order], np.concatenate([values, function(more)])[order]
    return Curve(t, values, function, slope)


def _bends(t: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Places halfway on both sides of those where the curve bends much."""
    sizes = np.abs(values[np.isfinite(values)])
    if sizes.size < 3:
        return t[:0]
    left, right = np.diff(values)[:-1], np.diff(values)[1:]
    with np.errstate(invalid="ignore"):
        sharp = np.flatnonzero(np.abs(right - left) > BENT * np.percentile(sizes, 90) + 1e-300) + 1
    gaps = np.unique(np.concatenate([sharp - 1, sharp]))
    gaps = gaps[(t[gaps + 1] - t[gaps]) > 1e-9 * (t[-1] - t[0])]
    return np.asarray((t[gaps] + t[gaps + 1]) / 2)


def differences(function: Function, step: float) -> Function:
    """The derivative of a smooth function by eighth differences; with shorter steps where it is not there."""

    def slope(t: np.ndarray) -> np.ndarray:
        slopes = np.full(t.shape, np.nan)
        for part in (1.0, 1 / 16, 1 / 256, 1 / 65536):
            missing = np.flatnonzero(np.isnan(slopes))
            if not missing.size:
                break
            places = t[missing, None] + part * step * STENCIL
            slopes[missing] = function(places.ravel()).reshape(places.shape) @ WEIGHTS / (part * step)
        return slopes

    return slope


def bisected(function: Function, low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """The places between low and high (n,) at which the function changes sign, to the last digits.

    Halved, or cut by a parabola through the last three places where that is sure to be closer (Chandrupatla 1997).
    """
    b, a = np.array(low, dtype=float), np.array(high, dtype=float)
    if not b.size:
        return b
    fb, fa = function(b), function(a)
    c, fc, part = a, fa, np.full(b.shape, 0.5)
    for _ in range(ROUNDS):
        place = a + part * (b - a)
        value = function(place)
        same = np.sign(value) == np.sign(fa)
        c, fc = np.where(same, a, b), np.where(same, fa, fb)
        b, fb = np.where(same, b, a), np.where(same, fb, fa)
        a, fa = place, value
        best = np.where(np.abs(fa) < np.abs(fb), a, b)
        width = 2 * np.finfo(float).eps * (np.abs(best) + 1e-3)
        share = width / np.maximum(np.abs(b - a), 1e-300)
        if np.all((share > 0.5) | (fa == 0) | (fb == 0)):
            break
        with np.errstate(all="ignore"):  # the part of the interval from a to b at which to cut next
            xi, phi = (a - b) / (c - b), (fa - fb) / (fc - fb)
            sure = (phi**2 < xi) & ((1 - phi) ** 2 < 1 - xi)
            cut = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb)
        least = np.minimum(share, 0.5)
        part = np.clip(np.where(sure & np.isfinite(cut), cut, 0.5), least, 1 - least)
    return np.asarray(np.where(fa == 0, a, best))


# --- zeros ------------------------------------------------------------------------------------


def _hidden(curve: Curve) -> np.ndarray:
    """Pairs of zeros between two neighbouring places, where the curve dips just through zero and back."""
    zeros = []
    for sign in (1.0, -1.0):
        dips = tops(curve, -sign)
        depth = sign * curve.function(dips)
        inside = dips[depth < -GRAZE * curve.size]
        k = np.searchsorted(curve.t, inside)
        for ends in (curve.t[np.maximum(k - 1, 0)], curve.t[np.minimum(k, curve.t.size - 1)]):
            above = sign * curve.function(ends) > 0
            zeros.append(bisected(curve.function, inside[above], ends[above]))
    dipped = np.concatenate(zeros)
    at = np.clip(np.searchsorted(curve.t, dipped) - 1, 0, curve.t.size - 2)
    with np.errstate(invalid="ignore"):
        return np.extract(curve.values[at] * curve.values[at + 1] > 0, dipped)


def touches(curve: Curve) -> np.ndarray:
    """Places at which the curve comes to zero and turns back."""
    turns = np.concatenate([tops(curve, -1.0), tops(curve, 1.0)])
    with np.errstate(invalid="ignore"):
        return np.sort(turns[np.abs(curve.function(turns)) <= GRAZE * curve.size])


# --- extremes ---------------------------------------------------------------------------------


def tops(curve: Curve, sign: float = 1.0) -> np.ndarray:
    """Places at which the curve is greatest (sign 1) or least (-1) among its neighbours, ends left out."""
    return curve.crests if sign > 0 else curve.troughs


def _tops(curve: Curve, sign: float) -> np.ndarray:
    """Zeros of the slope about the places of the greatest values; else the best places of a search by sections."""
    t, values, up = curve.t, curve.values, sign * curve.values
    with np.errstate(invalid="ignore"):
        k = np.flatnonzero((up[1:-1] >= up[:-2]) & (up[1:-1] > up[2:])) + 1
    if not k.size:
        return t[:0]
    begin = k - 1  # the place before k, or before all those with the same value
    while (level := (values[begin] == values[k]) & (begin > 0)).any():
        begin = np.where(level, begin - 1, begin)
    low, high = t[begin], t[k + 1]
    with np.errstate(invalid="ignore"):
        turns = (sign * curve.slope(low) > 0) & (sign * curve.slope(high) < 0)
    tops = np.empty(k.size)
    tops[turns] = bisected(curve.slope, low[turns], high[turns])
    tops[~turns] = _sectioned(curve.function, sign, low[~turns], high[~turns])
    return tops


def _sectioned(function: Function, sign: float, low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """The greatest value between low and high by golden sections."""
    golden = (np.sqrt(5) - 1) / 2
    for _ in range(70 if low.size else 0):
        one, two = high - golden * (high - low), low + golden * (high - low)
        left = sign * function(one) >= sign * function(two)
        low, high = np.where(left, low, one), np.where(left, two, high)
    return np.asarray((low + high) / 2)


def vanishing(t: np.ndarray, vectors: np.ndarray, function: Function) -> tuple[np.ndarray, np.ndarray]:
    """Places at which a vector comes to nothing, and all at which its size is least among its neighbours.

    Near a simple zero a vector moves along a line; its part along that line changes sign there.
    """
    size = np.abs(vectors)
    with np.errstate(invalid="ignore"):
        k = np.flatnonzero((size[1:-1] <= size[:-2]) & (size[1:-1] <= size[2:])) + 1
    along = vectors[k + 1] - vectors[k - 1]

    def part(t: np.ndarray) -> np.ndarray:
        return np.asarray((np.conj(along) * function(t)).real)

    low, high = t[k - 1], t[k + 1]
    places = bisected(part, low, high)
    scale = float(np.percentile(size[np.isfinite(size)], 90)) if np.isfinite(size).any() else 0.0
    doubtful = np.flatnonzero(np.abs(function(places)) > 1e-9 * scale)
    least = _sectioned(lambda at: np.abs(function(at)), -1.0, low[doubtful], high[doubtful])
    better = np.abs(function(least)) < np.abs(function(places[doubtful]))
    places[doubtful[better]] = least[better]
    return places[np.abs(function(places)) <= 1e-9 * scale], places
