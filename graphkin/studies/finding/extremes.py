"""The greatest and the least value of a quantity on a stretch, and the stroke between them."""

from __future__ import annotations

import math

import numpy as np

from graphkin.base.value import frozen
from graphkin.studies.finding.answers import Kind, OutputStroke, Phase, Position
from graphkin.studies.finding.search import Curve, followed, tops
from graphkin.studies.finding.stretch import TURN, Stretch

EQUAL = 1e-9
"""Extremes that differ by less than this part of what the quantity changes are equal."""
BOUNDLESS = 1e5
"""A value so many times the usual one, ever larger the closer it is looked, has no limit."""


@frozen
class Extremes:
    """All places of the greatest, and of the least value.

    curve   the quantity
    level   whether it never changes
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


def extremes(stretch: Stretch, *, size: bool = False) -> Extremes:
    """Of the stretch's first quantity; `size`: of its size, whatever its sense."""
    curve = followed(stretch.values(size=size), stretch.slope(size=size), stretch.places)
    there = curve.values[np.isfinite(curve.values)]
    spread = float(np.ptp(there)) if there.size else 0.0
    noise = stretch.noise(stretch.read(stretch.places[:1])[0].unit)
    if spread <= max(1e-10 * float(np.max(np.abs(there), initial=0.0)), noise, 1e-14):
        return Extremes(curve, (), (), True)
    return Extremes(curve, _best(stretch, curve, 1.0, "max"), _best(stretch, curve, -1.0, "min"), False)


def _best(stretch: Stretch, curve: Curve, sign: float, kind: Kind) -> tuple[Position, ...]:
    inner = stretch.within(tops(curve, sign))
    found = [(float(v), float(t), kind) for v, t in zip(curve.function(inner), inner)]
    found = [_pole_or(curve, sign, *entry) for entry in found] + _ends(stretch, curve, sign)
    if not found:
        return ()
    best = max(sign * value for value, _, _ in found)
    near = EQUAL * float(np.ptp(curve.values[np.isfinite(curve.values)])) if math.isfinite(best) else 0.0
    chosen = [entry for entry in found if sign * entry[0] >= best - near]
    apart = sorted(_apart(stretch, chosen), key=lambda entry: entry[1])
    return tuple(_position(stretch, value, t, what) for value, t, what in apart)


def _position(stretch: Stretch, value: float, t: float, kind: Kind) -> Position:
    others = stretch.position(t, kind).values[1:] if kind not in ("stop", "pole") and len(stretch.names) > 1 else ()
    return stretch.position(t, kind, (value, *others))


def _apart(stretch: Stretch, found: list[tuple[float, float, Kind]]) -> list[tuple[float, float, Kind]]:
    """An end beside an extreme is the same one."""
    close = 1e-7 * (stretch.high - stretch.low)
    inner = [entry for entry in found if entry[2] not in ("end", "stop")]
    ends = [e for e in found if e[2] in ("end", "stop") and all(abs(e[1] - other[1]) > close for other in inner)]
    return inner + ends


def _pole_or(curve: Curve, sign: float, value: float, t: float, kind: Kind) -> tuple[float, float, Kind]:
    """An extreme that is none: the quantity grows without limit there."""
    if abs(value) > BOUNDLESS * curve.size and curve.size > 0:
        return sign * math.inf, t, "pole"
    return value, t, kind


def _ends(stretch: Stretch, curve: Curve, sign: float) -> list[tuple[float, float, Kind]]:
    """The ends of what is looked at, where they are not one; of an angle that goes round they differ by turns."""
    if stretch.closed and not _goes_round(stretch):
        return []
    found: list[tuple[float, float, Kind]] = []
    for t, stop, inward in ((stretch.low, stretch.stopped[0], 1.0), (stretch.high, stretch.stopped[1], -1.0)):
        if not stop:
            found.append((float(curve.function(np.array([t]))[0]), t, "end"))
        elif (value := _limit(curve, t, inward * (stretch.high - stretch.low))) is not None:
            found.append((value, t, "stop" if math.isfinite(value) else "pole"))
    return [entry for entry in found if not math.isnan(entry[0]) and (math.isfinite(entry[0]) or entry[0] * sign > 0)]


def _limit(curve: Curve, t: float, span: float) -> float | None:
    """What the quantity tends to at a dead point: all there goes with the root of the distance."""
    far, near = curve.function(t + span * np.array([1e-4, 1e-6])), curve.function(t + span * 1e-6 / 4.0 ** np.arange(3))
    if not np.isfinite([*far, *near]).all():
        return None
    if abs(far[1]) > 3 * abs(far[0]) and abs(far[1]) > curve.size:
        return math.copysign(math.inf, far[1])
    return float((near[0] - 6 * near[1] + 8 * near[2]) / 3)


# --- stroke -----------------------------------------------------------------------------------


def stroke(stretch: Stretch, found: Extremes) -> tuple[OutputStroke | None, tuple[str, ...]]:
    """Advance and return of an output over a full turn of its driver; why there are none."""
    if found.swing is None:
        return None, ()
    if not stretch.closed:
        return None, ("no turn",)
    if len(found.highest) > 1 or len(found.lowest) > 1:
        return None, ("several strokes",)
    if _goes_round(stretch):
        return None, ("goes round",)
    driver = stretch.course.driver
    sense = math.copysign(1.0, driver.rate) if driver.rate else 1.0
    up = math.fmod(sense * (found.highest[0].t - found.lowest[0].t) + TURN, TURN)
    steady = driver.rate and not driver.acceleration
    phases = []
    for rising, angle in ((True, up), (False, TURN - up)):
        time = angle / abs(driver.rate) if steady else None
        phases.append(Phase(rising, angle, time, found.swing / time if time else None))
    advance, retreat = sorted(phases, key=lambda phase: -phase.angle)
    return OutputStroke(advance, retreat, advance.angle / retreat.angle), ()


def _goes_round(stretch: Stretch) -> bool:
    """Whether an angle is another one, by turns, after a turn of the driver."""
    ends = stretch.read(np.array([stretch.low, stretch.high]))[0]
    return ends.unit == "rad" and abs(float(np.ptp(ends.values))) > 1.0
