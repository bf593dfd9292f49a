"""Comparisons and extremes on a stretch: where a quantity equals, exceeds or stays below another, is greatest or least.

A comparison is the zero of the difference of its two sides; a stroke lies between the least and the greatest value.
"""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np

from graphkin.base.value import frozen
from graphkin.errors import NegativeSize, OtherUnits, Where
from graphkin.studies.finding import conditions
from graphkin.studies.finding.answers import Interval, Kind, OutputStroke, Phase, Position
from graphkin.studies.finding.conditions import Comparison
from graphkin.studies.finding.search import Curve, Function, differences, followed, tops, touches, vanishing
from graphkin.studies.finding.stretch import ROUNDING, CourseStretch
from graphkin.studies.sweeps import Series
from graphkin.studies.sweeps.course import TURN

EQUAL = 1e-9  # extremes that differ by less than this part of the quantity's change are equal
BOUNDLESS = 1e5  # a value so many times the usual one, ever larger the closer to a place it is read, has no limit


@frozen
class Difference:
    """Left side less right side of a comparison over the places of a stretch.

    target     the value, SI; None where both sides are quantities
    vanishing  a vector is to come to nothing
    curve      angles: from -180 to 180 degrees
    everywhere both sides are equal throughout
    """

    stretch: CourseStretch
    target: float | None
    vanishing: bool
    curve: Curve
    everywhere: bool


def difference(stretch: CourseStretch, condition: Comparison, drawn: tuple[Series, ...], where: Where) -> Difference:
    """The two sides held against each other. Raises OtherUnits, NegativeSize, and what a wrong value raises."""
    first, size, target = drawn[0], condition.size, None
    unsigned = first.vectors is not None and first.along is None
    if condition.numeric:
        target = conditions.value(condition.other, first.unit, where)
        if target < 0 and (size or unsigned):
            raise NegativeSize(where, condition.quantity, condition.other)
    elif first.unit != drawn[1].unit:
        raise OtherUnits(where, first.name, first.unit, drawn[1].name, drawn[1].unit)
    turning = first.unit == "rad" and condition.sign == "=" and not size

    def apart(t: np.ndarray) -> np.ndarray:
        """The difference of both sides, angles without jumps."""
        sides = [np.abs(entry.signed) if size else entry.signed for entry in stretch.read(t)]
        return np.asarray(sides[0] - (target if target is not None else sides[1]))

    def function(t: np.ndarray) -> np.ndarray:
        return np.mod(apart(t) + math.pi, TURN) - math.pi if turning else apart(t)

    slope = stretch.slope(size=size) if condition.numeric else differences(apart, stretch.step / 2)
    curve = followed(function, slope, stretch.places)
    finite = curve.values[np.isfinite(curve.values)]
    largest = np.concatenate([np.abs(entry.signed) for entry in stretch.read(stretch.places)])
    scale = max(abs(target or 0.0), float(np.nanmax(largest, initial=0.0)))
    small = max(ROUNDING * scale, stretch.noise(first.unit))
    everywhere = bool(finite.size) and float(np.max(np.abs(finite))) <= small
    to_nothing = target == 0 and unsigned and condition.sign == "="
    if finite.size and float(np.ptp(finite)) <= small:  # without its rounding, of whose tops there are thousands
        level, to_nothing = float(np.median(finite)), False
        values = np.where(np.isfinite(curve.values), level, np.nan)
        curve = Curve(curve.t, values, lambda t: np.full(t.shape, level), lambda t: np.zeros(t.shape))
    return Difference(stretch, target, to_nothing, curve, everywhere)


# --- zeros ------------------------------------------------------------------------------------


def holding(sides: Difference) -> tuple[Position, ...]:
    """All places of a stretch where both sides are equal."""
    stretch = sides.stretch
    if sides.vanishing:
        t, _ = vanishing(stretch.places, *_vectors(stretch))
        return tuple(stretch.position(place, "zero") for place in stretch.within(t))
    places = []
    for zeros in (sides.curve.zeros, touches(sides.curve)):
        with np.errstate(invalid="ignore"):  # no zeros are the jumps of an angle's difference half a turn off
            near = np.abs(sides.curve.function(zeros)) < 1.0 + 1e-3 * sides.curve.size
        places.append(stretch.within(zeros[near]))
    crossed, touched = places
    kinds: dict[float, Kind] = {float(t): "zero" for t in crossed}
    close = 1e-7 * (stretch.high - stretch.low)
    kinds |= {float(t): "touch" for t in touched if np.all(np.abs(crossed - t) > close)}
    return tuple(stretch.position(t, kinds[t]) for t in sorted(kinds))


def _vectors(stretch: CourseStretch) -> tuple[np.ndarray, Function]:
    def function(t: np.ndarray) -> np.ndarray:
        vectors = stretch.read(t)[0].vectors
        assert vectors is not None
        return vectors

    return function(stretch.places), function


def nearest(sides: Difference) -> Position | None:
    """The position at which the two sides come nearest to each other, when they never meet."""
    stretch, curve = sides.stretch, sides.curve
    if sides.vanishing:
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


def intervals(sides: Difference, sign: str) -> tuple[Interval, ...]:
    """Parts of the stretch where the left side is greater (`>`) or less (`<`) than the right one."""
    stretch, curve = sides.stretch, sides.curve
    up = 1.0 if sign == ">" else -1.0
    with np.errstate(invalid="ignore"):
        changes = np.flatnonzero(curve.values[:-1] * curve.values[1:] < 0)
    zeros = np.searchsorted(curve.zeros, curve.t)
    jumps = [float(curve.t[j]) for j in changes if zeros[j] == zeros[j + 1]]  # a quotient goes through infinity
    cuts = sorted({stretch.low, *stretch.within(curve.zeros), *jumps, stretch.high})
    parts, inside = [(a, b) for a, b in pairwise(cuts) if b - a > 1e-9 * (stretch.high - stretch.low)], []
    for begin, end in parts:
        values = curve.function(begin + (end - begin) * np.array([0.2, 0.5, 0.8]))
        with np.errstate(invalid="ignore"):
            if np.sum(up * values > 0) >= 2:  # in most of the part
                inside.append((begin, end))
    return tuple(_interval(stretch, curve, up, a, b) for a, b in _joined(stretch, inside))


def _joined(stretch: CourseStretch, parts: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Neighbours are one; on a full turn the last goes on in the first."""
    joined: list[tuple[float, float]] = []
    for begin, end in parts:
        if joined and begin == joined[-1][1]:
            joined[-1] = joined[-1][0], end
        else:
            joined.append((begin, end))
    if len(joined) > 1 and stretch.closed and joined[0][0] == stretch.low and joined[-1][1] == stretch.high:
        first = joined.pop(0)
        joined[-1] = joined[-1][0], first[1] + TURN
    return joined


def _interval(stretch: CourseStretch, curve: Curve, up: float, begin: float, end: float) -> Interval:
    inner = tops(curve, up)
    inner = np.concatenate([inner, inner + TURN]) if end > stretch.high else inner
    places = np.concatenate([[begin], inner[(inner > begin) & (inner < end)], [end]])
    here = np.where(places > stretch.high, places - TURN, places)
    with np.errstate(invalid="ignore"):
        high = up * np.nan_to_num(curve.function(here), nan=-up * np.inf)
    most = _position_at(stretch, float(places[np.argmax(high)]), "max" if up > 0 else "min")
    return Interval(_end(stretch, begin), _end(stretch, end), most)


def _end(stretch: CourseStretch, t: float) -> Position:
    """An end of an interval: of the condition, of the stretch, or at a dead point."""
    close = 1e-9 * (stretch.high - stretch.low)
    for place, stop in zip((stretch.low, stretch.high), stretch.stopped):
        if abs(t - place) <= close:
            return _position_at(stretch, t, "stop" if stop else "end")
    return _position_at(stretch, t, "zero")


def _position_at(stretch: CourseStretch, t: float, kind: Kind) -> Position:
    """A position that may lie a turn on: read on the stretch itself."""
    here = t - TURN if t > stretch.high else t
    if kind == "stop" or (any(stretch.stopped) and here in (stretch.low, stretch.high)):
        inward = 1e-7 * (stretch.high - stretch.low)
        here = min(max(here, stretch.low + inward), stretch.high - inward)
    values = stretch.position(here, kind).values
    return stretch.position(t, kind, values)


# --- extremes ---------------------------------------------------------------------------------


@frozen
class Extremes:
    """All places of the greatest, and of the least value.

    curve   the quantity
    level   it never changes
    """

    curve: Curve
    highest: tuple[Position, ...]
    lowest: tuple[Position, ...]
    level: bool

    @property
    def swing(self) -> float | None:
        """Greatest less least; None where there is no greatest or no least."""
        if not self.highest or not self.lowest:
            return None
        swing = self.highest[0].values[0] - self.lowest[0].values[0]
        return swing if math.isfinite(swing) else None


def extremes(stretch: CourseStretch) -> Extremes:
    """The extremes of the stretch's first quantity."""
    curve = followed(stretch.values(), stretch.slope(), stretch.places)
    finite = curve.values[np.isfinite(curve.values)]
    spread = float(np.ptp(finite)) if finite.size else 0.0
    noise = stretch.noise(stretch.read(stretch.places[:1])[0].unit)
    if spread <= max(1e-10 * float(np.max(np.abs(finite), initial=0.0)), noise, 1e-14):
        return Extremes(curve, (), (), True)
    return Extremes(curve, _best(stretch, curve, 1.0, "max"), _best(stretch, curve, -1.0, "min"), False)


Candidate = tuple[float, float, Kind]  # a value, its place t, and its kind


def _best(stretch: CourseStretch, curve: Curve, sign: float, kind: Kind) -> tuple[Position, ...]:
    """The positions of the greatest (sign 1) or least (-1) value; an end beside an extreme is the same one."""
    inner = stretch.within(tops(curve, sign))
    candidates: list[Candidate] = []
    for value, t in zip(curve.function(inner).tolist(), inner.tolist()):
        endless = abs(value) > BOUNDLESS * curve.size > 0  # the quantity grows without limit there
        candidates.append((sign * math.inf, t, "pole") if endless else (value, t, kind))
    candidates += _ends(stretch, curve, sign)
    if not candidates:
        return ()
    best = max(sign * value for value, _, _ in candidates)
    near = EQUAL * float(np.ptp(curve.values[np.isfinite(curve.values)])) if math.isfinite(best) else 0.0
    equal = [entry for entry in candidates if sign * entry[0] >= best - near]
    close = 1e-7 * (stretch.high - stretch.low)
    within = [entry for entry in equal if entry[2] not in ("end", "stop")]
    ends = [e for e in equal if e[2] in ("end", "stop") and all(abs(e[1] - other[1]) > close for other in within)]
    positions = []
    for value, t, what in sorted(within + ends, key=lambda entry: entry[1]):
        with_others = what not in ("stop", "pole") and len(stretch.names) > 1
        others = stretch.position(t, what).values[1:] if with_others else ()
        positions.append(stretch.position(t, what, (value, *others)))
    return tuple(positions)


def _ends(stretch: CourseStretch, curve: Curve, sign: float) -> list[Candidate]:
    """The ends of the stretch, where they are not one; of an angle that goes round they differ by turns."""
    if stretch.closed and not _goes_round(stretch):
        return []
    ends: list[Candidate] = []
    for t, stop, inward in ((stretch.low, stretch.stopped[0], 1.0), (stretch.high, stretch.stopped[1], -1.0)):
        if not stop:
            ends.append((float(curve.function(np.array([t]))[0]), t, "end"))
        elif (value := _limit(curve, t, inward * (stretch.high - stretch.low))) is not None:
            ends.append((value, t, "stop" if math.isfinite(value) else "pole"))
    return [entry for entry in ends if not math.isnan(entry[0]) and (math.isfinite(entry[0]) or entry[0] * sign > 0)]


def _limit(curve: Curve, t: float, span: float) -> float | None:
    """The limit of the quantity at a dead point: all there goes with the root of the distance."""
    far, near = curve.function(t + span * np.array([1e-4, 1e-6])), curve.function(t + span * 1e-6 / 4.0 ** np.arange(3))
    if not np.isfinite([*far, *near]).all():
        return None
    if abs(far[1]) > 3 * abs(far[0]) and abs(far[1]) > curve.size:
        return math.copysign(math.inf, far[1])
    return float((near[0] - 6 * near[1] + 8 * near[2]) / 3)


def stroke(stretch: CourseStretch, ends: Extremes) -> tuple[OutputStroke | None, tuple[str, ...]]:
    """Advance and return of an output over a full turn of its driver, or notes on why there are none."""
    if ends.swing is None:
        return None, ()
    if not stretch.closed:
        return None, ("no turn",)
    if len(ends.highest) > 1 or len(ends.lowest) > 1:
        return None, ("several strokes",)
    if _goes_round(stretch):
        return None, ("goes round",)
    driver = stretch.course.driver
    sense = math.copysign(1.0, driver.rate) if driver.rate else 1.0
    up = math.fmod(sense * (ends.highest[0].t - ends.lowest[0].t) + TURN, TURN)
    steady = driver.rate and not driver.acceleration
    phases = []
    for rising, angle in ((True, up), (False, TURN - up)):
        time = angle / abs(driver.rate) if steady else None
        phases.append(Phase(rising, angle, time, ends.swing / time if time else None))
    advance, retreat = sorted(phases, key=lambda phase: -phase.angle)
    return OutputStroke(advance, retreat, advance.angle / retreat.angle), ()


def _goes_round(stretch: CourseStretch) -> bool:
    """True if an angle is another one, by turns, after a turn of the driver."""
    both = stretch.read(np.array([stretch.low, stretch.high]))[0]
    return both.unit == "rad" and abs(float(np.ptp(both.values))) > 1.0
