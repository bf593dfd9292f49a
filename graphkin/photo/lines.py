"""Lines of a drawing refined by profiles across them, and where they end."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from graphkin.base.value import frozen
from graphkin.photo.ink import Ink

_EVERY, _ACROSS = 0.2, 0.1  # of the profiles along a line, and of their places [mm]
_TRIM = 1.0  # at the ends of a line, where others begin [mm]
_LONG = 15.0  # shorter lines are followed on beyond their ends [mm]
_ON, _NEAR, _GAP = 8.0, 6.0, 9
"""By so much each time; an end is sought so far [mm]; ink ends where so many profiles, 0.1 mm apart, have none."""
_RIM = 1.5  # so near the rim of a room a line may go on [mm]
WIDER = 1.12  # so many times as wide as usual strokes is more than one
_SPOILT = 6.0  # a line with another beside it all along is known so many times worse
_FULL = 0.5  # half the width of a profile about its middle: a stroke and its blur, in widths of strokes
_INDEPENDENT = 6.0  # profiles of a hand's line that are so far apart do not wobble together [mm]
_HIDDEN = 0.15  # a line under a printed one is known so well [mm]
_SWAYS = 0.06  # a hand's line is not straight to so much [mm]
_WOBBLES = 12.0  # so far apart a hand's wobble has nothing in common [mm]
_TINY = 0.4  # a line is not better known than this by its length in mm
_LEAST = 0.015  # no line is known better [mm]
_FARTHER = 0.03  # a line that is a mm farther off needs so much more ink at either end
_TILT = (0.2, 0.08)  # its ends may be apart by so much [mm], and by this part of its length


@frozen
class SeenLine:
    """A line as it was drawn.

    middle, along  a place on it and its direction, of length 1; length: so much of it was seen [mm]
    off, turned    standard deviations of its place [mm] and of its direction [rad]
    scatter        of its profiles; spread: of the ink across it [mm]
    covered        the part of it that has ink
    """

    middle: complex
    along: complex
    length: float
    off: float
    turned: float
    scatter: float
    spread: float
    covered: float

    @classmethod
    def printed(cls, ends: np.ndarray, along: complex) -> SeenLine:
        """One that is hidden by the printed line through the pole."""
        length = float(abs(ends[1] - ends[0]))
        there = along * (ends.mean() * along.conjugate()).real
        return cls(complex(there), along, length, _HIDDEN, _HIDDEN * np.sqrt(12) / length, 0.0, 0.0, 1.0)

    def drawn_by(self, wobble: float, beside: float) -> SeenLine:
        """As it is known when the hand wobbles by so much [mm], which tilts a short line unseen, and when another one
        runs beside this part of it."""
        tilted = wobble / np.sqrt(max(1.0, self.length / _WOBBLES))
        return self.known(max(self.off, tilted, _LEAST * (1 + _SPOILT * beside)))

    def known(self, off: float) -> SeenLine:
        """With another standard deviation, and what follows for its direction [mm]."""
        return replace(self, off=off, turned=off * np.sqrt(12) / self.length)

    def beyond(self, place: complex) -> float:
        """The distance of a place along it from its middle [mm]."""
        return ((place - self.middle) * self.along.conjugate()).real

    def beside(self, place: complex) -> float:
        """The distance of a place to its left [mm]."""
        return ((place - self.middle) * self.along.conjugate()).imag


def line_near(ink: Ink, ends: np.ndarray, reach: float, spread: float = np.inf, goes_on: bool = False) -> SeenLine:
    """The line with most ink whose ends are no farther than `reach` mm from two places.

    spread   of usual strokes: where it is wider another one runs beside it, and nothing is measured
    goes_on  it is followed beyond its ends
    """
    tail, head = ends
    length = abs(head - tail)
    along = (head - tail) / length
    trim, reach = min(_TRIM, length / 5), min(reach, 0.4 * length + 0.4)
    t = np.arange(trim, length - trim + 1e-9, min(_EVERY, length / 10))
    offsets = np.arange(-round(reach / _ACROSS), round(reach / _ACROSS) + 1) * _ACROSS
    strip = ink.at(tail + along * (t[:, None] + 1j * offsets))
    strip = np.clip(strip, 0.0, 1.2 * ink.usual)
    a, b = _steps(strip, t / length, offsets, length)
    start, end = tail + 1j * along * a, head + 1j * along * b
    return _centred(ink, start, end, trim, spread, goes_on)


def _steps(strip: np.ndarray, part: np.ndarray, offsets: np.ndarray, length: float) -> tuple[float, float]:
    """Offsets of both ends of the straight line through a strip (profiles, offsets) that has most of its darkness."""
    count = len(offsets)
    which = np.arange(0, len(strip), max(1, len(strip) // 120))
    smooth = strip[which] + 0.5 * (np.roll(strip[which], 1, axis=1) + np.roll(strip[which], -1, axis=1))
    k = np.arange(count)
    at = np.rint(k[:, None, None] + (k[None, :, None] - k[:, None, None]) * part[which]).astype(int)
    sums = smooth[np.arange(len(which)), at].mean(axis=2)
    far = np.abs(offsets)
    sums[np.abs(offsets[:, None] - offsets[None, :]) > _TILT[0] + _TILT[1] * length] = 0.0
    sums *= 1 - _FARTHER * (far[:, None] + far[None, :])
    best = np.unravel_index(int(np.argmax(sums)), sums.shape)
    return float(offsets[best[0]]), float(offsets[best[1]])


def _centred(ink: Ink, start: complex, end: complex, trim: float, spread: float, goes_on: bool) -> SeenLine:
    """A line by the middles of its profiles, those of other lines left out."""
    half = max(0.4, _FULL * ink.pencil + 0.3)
    across = np.arange(-round(half / 0.05), round(half / 0.05) + 1) * 0.05
    covered, scatter, count, usual_wide = 0.0, 0.3, 1.0, 0.0
    length = abs(end - start)
    for again in range(3):
        if goes_on and again and abs(end - start) < _LONG:
            start, end = _goes_on(ink, start, end), _goes_on(ink, end, start)
        length = abs(end - start)
        along = (end - start) / length
        t = np.arange(trim, length - trim + 1e-9, min(_EVERY, length / 10))
        strip = np.maximum(ink.at(start + along * (t[:, None] + 1j * across)) - 0.25 * ink.least, 0.0)
        mass = strip.sum(axis=1)
        usual = np.median(mass[mass > 0.2 * mass.max(initial=0.0)]) if mass.any() else 0.0
        peak = strip.max(axis=1) > 0.75 * ink.least
        covered = float(peak.mean()) if len(peak) else 0.0
        good = peak & (mass > 0.35 * usual) & (mass < 1.6 * usual)
        with np.errstate(invalid="ignore", divide="ignore"):
            middles = (strip * across).sum(axis=1) / mass
            wide = np.sqrt((strip * across**2).sum(axis=1) / mass - middles**2)
        alone = good & (wide < WIDER * spread)
        good = alone if alone.sum() > 3 else good
        if good.sum() < 3:
            return SeenLine((start + end) / 2, along, length, 1.0, 1.0, 0.0, 1.0, covered)
        usual_wide = float(np.median(wide[good]))
        slope, there, scatter, kept = _straight(t[good] - length / 2, middles[good])
        count = max(2.0, kept * _EVERY / _INDEPENDENT)
        rise = slope * length / 2
        start, end = start + 1j * along * (there - rise), end + 1j * along * (there + rise)
    off = max(_LEAST, scatter / np.sqrt(count), _TINY / length)
    if usual_wide > WIDER * spread:  # it is one of several, somewhere among them
        off = np.sqrt(off**2 + usual_wide**2 - (WIDER * spread) ** 2)
    along, turned = (end - start) / abs(end - start), off * np.sqrt(12) / max(length, 1.0)
    return SeenLine((start + end) / 2, along, length, float(off), float(turned), scatter, usual_wide, covered)


def _goes_on(ink: Ink, end: complex, start: complex) -> complex:
    """The place up to which ink goes on straight beyond an end, no farther than the line is long."""
    along, most = (end - start) / abs(end - start), min(abs(end - start), _ON)
    last = _last_ink(ink, end, along, 0.2, most)
    far = most if last is None else last
    return end + along * (far - _TRIM) if far > 2 * _TRIM else end


def _last_ink(ink: Ink, place: complex, along: complex, first: float, most: float) -> float | None:
    """The distance from a place to where ink ends that begins at `first` [mm], at a gap; None: not before `most`."""
    t = np.arange(first, max(most, first + 0.1), 0.1)
    bare = ink.at(place + along * (t[:, None] + 1j * np.arange(-2, 3) * 0.1)).max(axis=1) <= 0.75 * ink.least
    gaps = np.flatnonzero(np.convolve(bare, np.ones(_GAP))[: len(t)] == _GAP)
    return float(t[max(0, gaps[0] - _GAP)]) if len(gaps) else None


def _straight(x: np.ndarray, y: np.ndarray) -> tuple[float, float, float, float]:
    """Slope, height at 0, scatter and weight of the straight line through most of some points."""
    slope, there, scatter, weight = 0.0, float(np.median(y)), 1.0, np.ones(len(x))
    for _ in range(6):
        total = float(weight.sum())
        if total < 2:
            break
        mean, height = float(weight @ x) / total, float(weight @ y) / total
        own = weight * (x - mean)
        spread = float(own @ (x - mean))
        slope = float(own @ y) / spread if spread > 1e-6 else 0.0
        there = height - slope * mean
        left = np.abs(y - there - slope * x)
        scatter = max(0.01, 1.4826 * float(np.partition(left, len(left) // 2)[len(left) // 2]))
        weight = np.clip(1 - (left / (4 * max(scatter, _SWAYS))) ** 2, 0, None) ** 2
    return slope, there, scatter, float(weight.sum())


def free_end(ink: Ink, line: SeenLine, near: complex, inwards: complex) -> complex | None:
    """The end of a line that no other crosses there; ink is as wide as the pencil beyond it. `inwards`: where the line
    comes from. None: it ends nowhere near."""
    at = line.middle + line.along * ((near - line.middle) * line.along.conjugate()).real
    along = line.along if ((at - inwards) * line.along.conjugate()).real > 0 else -line.along
    first = -min(_NEAR, abs(at - inwards) / 2)
    last = _last_ink(ink, at, along, first, _NEAR)
    if last is None or last <= first or not ink.inside(np.array(at + along * (last + _RIM))):
        return None
    return complex(at + along * (last - ink.pencil / 2))
