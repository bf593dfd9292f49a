"""The pencil strokes in a room: its darkness, without what is printed there, as a raster of the room."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Sequence
from typing import Protocol

import numpy as np

from graphkin.base.geometry import unit
from graphkin.photo.sheets import SheetRoom

STEP = 0.1  # of the raster [mm]
_GRID, _DOTS, _DOT, _POLE, _FRAME = 5.0, 10.0, 0.8, 0.8, 0.5
"""Lines of the grid and dots are so far apart; dots, the pole and the frame reach so far [mm]."""
_LINE = 0.6  # half of the widest that a printed line is seen [mm]
_DARKER = 3.0  # the line through the pole is at most so many times as dark as a bold one of the grid
_BELOW = 0.3  # of the pixels of a printed line so many at least have no pencil on them
NEAR = 0.9  # a stroke that is no farther off is one that was predicted [mm]
_BROAD, _BEYOND = 1.6, 400.0  # a line may have ink so wide, and so far beyond its ends [mm]
STRANGE = 9.0  # a line that is longer is no letter [mm]
_EACH = 0.7  # places are taken so far apart [mm]
_SHRINK = 3  # of the coarser raster on which ink is counted
_FAINT = 0.4  # of the usual darkness of strokes; what is fainter was rubbed out
_LEAST = 0.06  # fainter strokes are none at all


class MeasuredPaper(Protocol):
    """A sheet on a picture that is measured in millimetres, from the left upper corner of its paper, y down."""

    @property
    def rms(self) -> float:
        """By how much its millimetres are off."""

    def darkness(self, places: np.ndarray) -> np.ndarray:
        """From 0, paper, to 1; NaN outside of the picture."""


class Ink:
    """The drawing in a room. Places are in mm from the pole, y up.

    dark   (rows, columns) of squares of the side STEP; usual: darkness in the middle of a stroke
    pencil  width of a stroke [mm]
    mask   strokes, `wide` mm wide, as booleans; near: 1 where one is no farther off than NEAR
    seen   the part of the room that is on the picture; printed: along the line through the pole, of length 1
    """

    def __init__(self, page: MeasuredPaper, room: SheetRoom) -> None:
        self.pole, self.low, self.printed = room.pole, room.low, cmath.rect(1.0, room.direction)
        size = room.high - room.low
        x = (np.arange(round(size.real / STEP)) + 0.5) * STEP
        y = (np.arange(round(size.imag / STEP)) + 0.5) * STEP
        dark = page.darkness(room.low + x[None, :] + 1j * y[:, None])
        self.seen = float(np.isfinite(dark).mean())
        self.dark = np.nan_to_num(dark).astype(np.float32)
        self._without_print()
        self._find_strokes()

    def _find_strokes(self) -> None:
        import cv2

        smooth = cv2.GaussianBlur(self.dark, (0, 0), 0.15 / STEP)
        noise = 1.4826 * float(np.median(np.abs(smooth - np.median(smooth))))
        least = max(_LEAST, 5 * noise)
        peaks = smooth[(smooth > least) & (smooth >= cv2.dilate(smooth, np.ones((5, 5))))]
        self.usual = float(np.median(peaks)) if peaks.size > 50 else 1.0
        self.least = max(least, _FAINT * self.usual)
        mask = (smooth > self.least).astype(np.uint8)
        _, labels, stats, _ = cv2.connectedComponentsWithStats(mask)
        self.mask = (stats[:, cv2.CC_STAT_AREA] * STEP**2 > 0.5)[labels] & (mask > 0)
        self.wide = self._width(self.mask)
        self.pencil = self._width(self.mask & (cv2.GaussianBlur(self.dark, (0, 0), 0.6) > self.usual / 2))
        small = tuple(number // _SHRINK for number in self.mask.shape[::-1])
        part = cv2.resize(self.mask.astype(np.float32), small, interpolation=cv2.INTER_AREA)
        self.coarse = part * (_SHRINK * STEP) ** 2
        round_ = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * round(NEAR / STEP) + 1,) * 2)
        self.near = cv2.dilate(self.mask.astype(np.uint8), round_)

    @staticmethod
    def _width(mask: np.ndarray) -> float:
        """Of strokes: four times as much as places in them lie from their edges, all in all [mm]."""
        import cv2

        inside = cv2.distanceTransform(mask.astype(np.uint8), cv2.DIST_L2, 3)
        return 4 * STEP * float(inside[mask].mean()) if mask.any() else 0.5

    @property
    def length(self) -> float:
        """Of all strokes [mm]."""
        return float(self.mask.sum()) * STEP**2 / self.wide

    def along(self, lines: Sequence[tuple[complex, complex]], reach: float) -> float:
        """The length of the strokes that lie along some lines [mm]."""
        import cv2

        ends = self.pixels(np.array(lines, dtype=complex).reshape(-1, 2)) / _SHRINK
        drawn = np.zeros(self.coarse.shape, np.float32)
        for both in ends[(np.abs(ends) < 1e4).all(axis=1)]:
            one, other = ((round(16 * at.real), round(16 * at.imag)) for at in both)
            cv2.line(drawn, one, other, (1.0,), max(1, round(2 * reach / STEP / _SHRINK)), shift=4)
        return float(np.vdot(drawn, self.coarse)) / self.wide

    def strange(self, lines: Iterable[Sequence[complex]]) -> float:
        """The longest extent of what does not lie along some lines, that go on beyond both places of each [mm]."""
        return float(self.left(lines, _BROAD)[0].max(initial=0.0))

    def left(self, lines: Iterable[Sequence[complex]], wide: float) -> tuple[np.ndarray, np.ndarray]:
        """Places with ink off such lines, which are so wide; before them the extent of the ink that each is of [mm]."""
        import cv2

        left = self.mask.astype(np.uint8)
        for one, other in lines:
            beyond = _BEYOND * unit(other - one)
            ends = self.pixels(np.array([one - beyond, other + beyond])) * 16
            tail, head = ((round(at.real), round(at.imag)) for at in ends)
            cv2.line(left, tail, head, (0,), round(wide / STEP), shift=4)
        _, labels, stats, _ = cv2.connectedComponentsWithStats(left)
        y, x = np.nonzero(left)
        sizes = np.hypot(*stats[:, [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]].T)[labels[y, x]] * STEP
        return sizes, np.conj((x + 1j * y + 0.5 * (1 + 1j)) * STEP + self.low - self.pole)

    def places(self) -> np.ndarray:
        """Places with strokes, at every so many mm."""
        y, x = np.nonzero(self.mask[:: round(_EACH / STEP), :: round(_EACH / STEP)])
        return np.asarray(np.conj((x + 1j * y) * _EACH + self.low - self.pole))

    # --- places -----------------------------------------------------------------------------------

    def pixels(self, places: np.ndarray) -> np.ndarray:
        """Places as columns + i rows of the raster."""
        return np.asarray((self.pole + np.conj(places) - self.low) / STEP - 0.5 * (1 + 1j))

    def inside(self, places: np.ndarray) -> np.ndarray:
        at = self.pixels(places)
        rows, columns = self.dark.shape
        within = (at.real >= 0) & (at.imag >= 0) & (at.real <= columns - 1) & (at.imag <= rows - 1)
        return np.asarray(within)

    def at(self, places: np.ndarray) -> np.ndarray:
        """The darkness at places of any shape; 0 outside."""
        return self._sampled(self.dark, places, straight=True)

    def is_near(self, places: np.ndarray) -> np.ndarray:
        """1 where a stroke is near, else 0."""
        return self._sampled(self.near, places, straight=False)

    def _sampled(self, raster: np.ndarray, places: np.ndarray, straight: bool) -> np.ndarray:
        import cv2

        at = np.atleast_2d(self.pixels(places)).astype(np.complex64)
        how = cv2.INTER_LINEAR if straight else cv2.INTER_NEAREST
        found = cv2.remap(raster, at.real.copy(), at.imag.copy(), how, borderValue=0)
        return np.asarray(found).reshape(np.shape(places))

    def is_printed(self, places: np.ndarray) -> np.ndarray:
        """True on the line through the pole, which hides what is drawn along it."""
        return np.asarray(np.abs((places * self.printed.conjugate()).imag) < _LINE)

    # --- what is printed --------------------------------------------------------------------------

    def _without_print(self) -> None:
        """Takes away what each printed line darkens where no pencil went over it, and what all dots do alike."""
        rows, columns = self.dark.shape
        reach, bold = round(_LINE / STEP), 0.0
        for count, dark in ((columns, self.dark), (rows, self.dark.T)):
            middles = [round(k * _GRID / STEP) for k in range(1, round(count * STEP / _GRID))]
            bands = [dark[:, middle - reach : middle + reach] for middle in middles]
            for some in (bands[::2], bands[1::2]):  # fine lines, bold lines
                own = [np.quantile(band, 0.5, axis=0) for band in some]
                usual = np.median(own, axis=0) if own else 0.0
                for band, printed in zip(some, own, strict=True):  # a pencil may have gone along all of one
                    _take_off(band, np.minimum(printed, 1.2 * usual + 0.02))
                bold = max(bold, float(np.max(usual)))
        self._without_dots()
        self._without_line(bold * _DARKER)
        at = self.pixels(np.zeros(1, dtype=complex))[0]
        y, x = np.ogrid[:rows, :columns]
        self.dark[(x - at.real) ** 2 + (y - at.imag) ** 2 < (_POLE / STEP) ** 2] = 0.0
        edge = round(_FRAME / STEP)
        for side in (self.dark[:edge], self.dark[-edge:], self.dark[:, :edge], self.dark[:, -edge:]):
            side[:] = 0.0

    def _without_dots(self) -> None:
        reach, (rows, columns) = round(_DOT / STEP), self.dark.shape
        firsts = [(_DOTS - (low % _DOTS)) / STEP for low in (self.low.real, self.low.imag)]
        places = [(round(y), round(x)) for x in np.arange(firsts[0], columns, _DOTS / STEP)
                  for y in np.arange(firsts[1], rows, _DOTS / STEP)]  # fmt: skip
        places = [(y, x) for y, x in places if reach <= y < rows - reach and reach <= x < columns - reach]
        patches = [self.dark[y - reach : y + reach, x - reach : x + reach] for y, x in places]
        if patches:
            usual = np.median(patches, axis=0)
            for patch in patches:
                _take_off(patch, usual)

    def _without_line(self, darkest: float) -> None:
        """The line through the pole."""
        rows, columns = self.dark.shape
        at, along = self.pixels(np.zeros(1, dtype=complex))[0], self.printed.conjugate()
        y, x = np.mgrid[:rows, :columns]
        off = ((y - at.imag) * along.real - (x - at.real) * along.imag) * STEP
        there = np.abs(off) < _LINE
        bins = np.floor((off[there] + _LINE) / (STEP / 2)).astype(int)
        values = self.dark[there]
        printed = np.array([np.quantile(values[bins == k], _BELOW) if (bins == k).any() else 0.0
                            for k in range(math.ceil(4 * _LINE / STEP))])  # fmt: skip
        printed *= min(1.0, darkest / max(float(printed.max()), 1e-6))
        _take_off(values, printed[bins])
        self.dark[there] = values


def _take_off(dark: np.ndarray, printed: np.ndarray) -> None:
    """The rest of darkness without what lies below it: each lets through a part of the light."""
    dark[...] = 1 - (1 - dark) / (1 - np.clip(printed, 0.0, 0.9))
