"""Zeros and extremes of a function of one variable, all of them: looked at closely, then polished to rounding.

A function here takes many places at once (n,) and gives NaN where there is nothing; no word of mechanisms.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

import numpy as np

from graphkin.base.value import frozen

Function = Callable[[np.ndarray], np.ndarray]

ROUNDS = 70
BENT = 0.01
"""Between places where a curve bends by more than this part of its range, it is looked at more closely."""
GRAZE = 1e-10
"""A curve that comes so near to zero, as a part of its size, grazes it."""
EVEN = 501
STENCIL = np.array([-4, -3, -2, -1, 1, 2, 3, 4], dtype=float)
WEIGHTS = np.array([1 / 280, -4 / 105, 1 / 5, -4 / 5, 4 / 5, -1 / 5, 4 / 105, -1 / 280])


@frozen
class Curve:
    """A function looked at closely.

    t, values  places (n,), rising, and its values there
    slope      its derivative, or anything of the same sign
    """

    t: np.ndarray
    values: np.ndarray
    function: Function
    slope: Function

    @cached_property
    def size(self) -> float:
        """How large it is over most of its length, whatever it does where it may grow without limit."""
        even = np.searchsorted(self.t, np.linspace(self.t[0], self.t[-1], EVEN))
        large = np.abs(self.values[np.minimum(even, self.t.size - 1)])
        large = large[np.isfinite(large)]
        return float(np.percentile(large, 75)) if large.size else 0.0


    @cached_property
    def crests(self) -> np.ndarray:
        """Where it is greatest among its neighbours; looked for once, as the two that follow."""
        return _tops(self, 1.0)

    @cached_property
    def troughs(self) -> np.ndarray:
        return _tops(self, -1.0)

    @cached_property
    def zeros(self) -> np.ndarray:
        return _crossings(self)


def followed(function: Function, slope: Function, t: np.ndarray, rounds: int = 3) -> Curve:
    """The curve at places t and at more where it bends."""
    values = function(t)
    for _ in range(rounds):
        more = _bends(t, values)
        if not more.size or t.size > 60_000:
            break
        places = np.concatenate([t, more])
        order = np.argsort(places)
        t, values = places[order], np.concatenate([values, function(more)])[order]
    return Curve(t, values, function, slope)


def _bends(t: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Places halfway on both sides of those where the curve bends much."""
    there = np.abs(values[np.isfinite(values)])
    if there.size < 3:
        return t[:0]
    left, right = np.diff(values)[:-1], np.diff(values)[1:]
    with np.errstate(invalid="ignore"):
        sharp = np.flatnonzero(np.abs(right - left) > BENT * np.percentile(there, 90) + 1e-300) + 1
    gaps = np.unique(np.concatenate([sharp - 1, sharp]))
    gaps = gaps[(t[gaps + 1] - t[gaps]) > 1e-9 * (t[-1] - t[0])]
    return np.asarray((t[gaps] + t[gaps + 1]) / 2)


def differences(function: Function, step: float) -> Function:
    """The derivative of a smooth function by eighth differences; with shorter steps where it is not there."""

    def slope(t: np.ndarray) -> np.ndarray:
        found = np.full(t.shape, np.nan)
        for part in (1.0, 1 / 16, 1 / 256, 1 / 65536):
            open_ = np.flatnonzero(np.isnan(found))
            if not open_.size:
                break
            places = t[open_, None] + part * step * STENCIL
            found[open_] = function(places.ravel()).reshape(places.shape) @ WEIGHTS / (part * step)
        return found

    return slope


def bisected(function: Function, low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """Where the function changes sign between low and high (n,), to the last digits.

    Halved, or cut by a parabola through the last three places where that is sure to be closer (Chandrupatla 1997).
    """
    b, a = np.array(low, dtype=float), np.array(high, dtype=float)
    if not b.size:
        return b
    fb, fa = function(b), function(a)
    c, fc, part = a, fa, np.full(b.shape, 0.5)
    for _ in range(ROUNDS):
        there = a + part * (b - a)
        value = function(there)
        same = np.sign(value) == np.sign(fa)
        c, fc = np.where(same, a, b), np.where(same, fa, fb)
        b, fb = np.where(same, b, a), np.where(same, fb, fa)
        a, fa = there, value
        best = np.where(np.abs(fa) < np.abs(fb), a, b)
        width = 2 * np.finfo(float).eps * (np.abs(best) + 1e-3)
        share = width / np.maximum(np.abs(b - a), 1e-300)
        if np.all((share > 0.5) | (fa == 0) | (fb == 0)):
            break
        part = _cut(a, fa, b, fb, c, fc, np.minimum(share, 0.5))
    return np.asarray(np.where(fa == 0, a, best))


def _cut(
    a: np.ndarray, fa: np.ndarray, b: np.ndarray, fb: np.ndarray, c: np.ndarray, fc: np.ndarray, least: np.ndarray
) -> np.ndarray:
    """Which part of the way from a to b to go next."""
    with np.errstate(all="ignore"):
        xi, phi = (a - b) / (c - b), (fa - fb) / (fc - fb)
        sure = (phi**2 < xi) & ((1 - phi) ** 2 < 1 - xi)
        cut = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb)
    return np.clip(np.where(sure & np.isfinite(cut), cut, 0.5), least, 1 - least)


# --- zeros ------------------------------------------------------------------------------------


def crossings(curve: Curve) -> np.ndarray:
    """Where the curve changes sign through zero (not through infinity)."""
    return curve.zeros


def _crossings(curve: Curve) -> np.ndarray:
    left, right = curve.values[:-1], curve.values[1:]
    with np.errstate(invalid="ignore"):
        k = np.flatnonzero(left * right < 0)
    found = bisected(curve.function, curve.t[k], curve.t[k + 1])
    ends = np.abs(left[k]) + np.abs(right[k])
    small = np.abs(curve.function(found)) <= 1e-6 * ends + 1e-12 * curve.size
    return np.sort(np.concatenate([found[small], curve.t[curve.values == 0], *_hidden(curve)]))


def _hidden(curve: Curve) -> list[np.ndarray]:
    """Pairs of zeros between two neighbouring places, where the curve dips just through zero and back."""
    found = []
    for sign in (1.0, -1.0):
        dips = tops(curve, -sign)
        depth = sign * curve.function(dips)
        inside = dips[depth < -GRAZE * curve.size]
        k = np.searchsorted(curve.t, inside)
        for ends in (curve.t[np.maximum(k - 1, 0)], curve.t[np.minimum(k, curve.t.size - 1)]):
            above = sign * curve.function(ends) > 0
            found.append(bisected(curve.function, inside[above], ends[above]))
    dipped = np.concatenate(found) if found else curve.t[:0]
    at = np.searchsorted(curve.t, dipped) - 1
    at = np.clip(at, 0, curve.t.size - 2)
    with np.errstate(invalid="ignore"):
        new = curve.values[at] * curve.values[at + 1] > 0
    return [dipped[new]]


def touches(curve: Curve) -> np.ndarray:
    """Where the curve comes to zero and turns back."""
    found = [curve.t[:0]]
    for sign in (1.0, -1.0):
        dips = tops(curve, -sign)
        with np.errstate(invalid="ignore"):
            touching = np.abs(curve.function(dips)) <= GRAZE * curve.size
        found.append(dips[touching])
    return np.sort(np.concatenate(found))


# --- extremes ---------------------------------------------------------------------------------


def tops(curve: Curve, sign: float = 1.0) -> np.ndarray:
    """Where the curve is greatest (sign 1) or least (sign -1) among its neighbours, ends left out."""
    return curve.crests if sign > 0 else curve.troughs


def _tops(curve: Curve, sign: float) -> np.ndarray:
    up = sign * curve.values
    with np.errstate(invalid="ignore"):
        k = np.flatnonzero((up[1:-1] >= up[:-2]) & (up[1:-1] > up[2:])) + 1
    return _polished(curve, sign, k)


def _polished(curve: Curve, sign: float, k: np.ndarray) -> np.ndarray:
    """Where the slope changes its sign about places k; else the best place of a search by sections."""
    if not k.size:
        return curve.t[:0]
    low, high = _back(curve, sign, k), curve.t[k + 1]
    with np.errstate(invalid="ignore"):
        turns = (sign * curve.slope(low) > 0) & (sign * curve.slope(high) < 0)
    found = np.empty(k.size)
    found[turns] = bisected(curve.slope, low[turns], high[turns])
    found[~turns] = _sectioned(curve.function, sign, low[~turns], high[~turns])
    return found


def _back(curve: Curve, sign: float, k: np.ndarray) -> np.ndarray:
    """The place before k, or before all those with the same value."""
    begin = k - 1
    level = (curve.values[begin] == curve.values[k]) & (begin > 0)
    while level.any():
        begin = np.where(level, begin - 1, begin)
        level &= (curve.values[begin] == curve.values[k]) & (begin > 0)
    return np.asarray(curve.t[begin])


def _sectioned(function: Function, sign: float, low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """The greatest value between low and high by golden sections."""
    golden = (np.sqrt(5) - 1) / 2
    for _ in range(70 if low.size else 0):
        one, two = high - golden * (high - low), low + golden * (high - low)
        left = sign * function(one) >= sign * function(two)
        low, high = np.where(left, low, one), np.where(left, two, high)
    return np.asarray((low + high) / 2)


# --- vectors ----------------------------------------------------------------------------------


def vanishing(t: np.ndarray, vectors: np.ndarray, function: Function) -> tuple[np.ndarray, np.ndarray]:
    """Where a vector comes to nothing, and where its size is least at all among its neighbours.

    Near a simple zero a vector moves along a line; its part along that line changes sign there.
    """
    size = np.abs(vectors)
    with np.errstate(invalid="ignore"):
        k = np.flatnonzero((size[1:-1] <= size[:-2]) & (size[1:-1] <= size[2:])) + 1
    along = vectors[k + 1] - vectors[k - 1]

    def part(places: np.ndarray) -> np.ndarray:
        return np.asarray((np.conj(along) * function(places)).real)

    low, high = t[k - 1], t[k + 1]
    found = bisected(part, low, high) if k.size else low
    scale = float(np.percentile(size[np.isfinite(size)], 90)) if np.isfinite(size).any() else 0.0
    doubtful = np.flatnonzero(np.abs(function(found)) > 1e-9 * scale) if k.size else k
    least = _sectioned(lambda places: np.abs(function(places)), -1.0, low[doubtful], high[doubtful])
    better = np.abs(function(least)) < np.abs(function(found[doubtful])) if doubtful.size else doubtful > 0
    found[doubtful[better]] = least[better]
    return found[np.abs(function(found)) <= 1e-9 * scale], found
