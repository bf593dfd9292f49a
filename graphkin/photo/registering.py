"""Sheets on a picture: whose markers belong together, and where each place of the page lies in it, to a tenth of a mm.

Markers tell number and, by a homography, the rough place of everything. The dots, found one by one from there, tell
how the paper is bent and the lens draws.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from functools import cached_property

import numpy as np

from graphkin.base.geometry import Array
from graphkin.base.value import bulky, frozen
from graphkin.errors import GraphkinError, PhotographAgain
from graphkin.photo.dot_finding import fitted
from graphkin.photo.markers import CORNERS, SIZE, corners, edges, number_of
from graphkin.photo.page_map import Homography, PageMap, sampled
from graphkin.photo.pictures import GreyPicture, Pixels

_COARSE = 8.0  # pixels a mm, of which there are to be no fewer
_OFF = 0.3  # places that are off by more are not measured [mm]
_LOOKED = 2400  # pixels along a picture's longer side, in which markers are looked for
_WINDOWS = 7, 71, 16  # least, most and step of the squares in which that is black which is darker than most of it [px]
_SQUARE = np.array([0, 1, 1 + 1j, 1j]) * SIZE
_ASTRAY = 0.2  # part of the way from one marker to another by which it may be off where both tell it
_CELL = 3.0  # of the paper's brightness [mm]
_A4 = (210.0, 297.0)


@bulky
class RegisteredPage:
    """A sheet of paper on a picture.

    number         as its markers tell it; width, height: of the paper [mm]
    rms            by how much its places are off, estimated; within: 95 % of them are off by less [mm]
    per_mm         pixels; pixels: where places of the page lie on the picture [px]
    """

    number: int
    width: float
    height: float
    rms: float
    within: float
    per_mm: float
    pixels: PageMap
    grey: Pixels

    def darkness(self, places: Array) -> Array:
        """0 of paper to 1 of black, whatever light falls there; NaN outside the picture."""
        px, (high, wide) = self.pixels(places), self.grey.shape
        paper = sampled(self._paper, (px + 0.5 + 0.5j) / self._cell - (0.5 + 0.5j))
        inside = (px.real >= 0) & (px.imag >= 0) & (px.real <= wide - 1) & (px.imag <= high - 1)
        return np.where(inside, np.clip(1 - sampled(self.grey, px) / paper, 0.0, 1.0), np.nan)

    def crop(self, low: complex, high: complex, per_mm: float) -> Pixels:
        """A part of the page set straight, for people to look at; white outside the picture."""
        x, y = (np.arange(0.5 / per_mm, end, 1 / per_mm) for end in ((high - low).real, (high - low).imag))
        dark = self.darkness(low + x[None, :] + 1j * y[:, None])
        return np.asarray(np.nan_to_num(255 * (1 - dark), nan=255.0) + 0.5, dtype=np.uint8)

    @property
    def _cell(self) -> int:
        return max(4, round(_CELL * self.per_mm))

    @cached_property
    def _paper(self) -> Array:
        """Brightness of the paper by cells of so many pixels: of the light quarter of each, dark spots closed."""
        import cv2

        high, wide = (n // self._cell for n in self.grey.shape)
        whole = self.grey[: high * self._cell, : wide * self._cell].reshape(high, self._cell, wide, self._cell)
        cells, quarter = whole.transpose(0, 2, 1, 3).reshape(high, wide, -1), self._cell**2 * 3 // 4
        light = np.partition(cells, quarter, axis=2)[:, :, quarter].astype(np.float32)
        light = cv2.morphologyEx(light, cv2.MORPH_CLOSE, np.ones((3, 3), np.uint8)).astype(np.float32)
        return np.maximum(cv2.GaussianBlur(light, (0, 0), 0.7), 1.0)


@frozen
class SeenMarker:
    """Its corners on the picture, from its own left upper one clockwise [px]."""

    id: int
    at: tuple[complex, ...]

    @property
    def middle(self) -> complex:
        return sum(self.at) / 4

    @property
    def axes(self) -> tuple[complex, complex]:
        """One mm to the right, and one down, on its page [px]."""
        a, b, c, d = self.at
        return (b - a + c - d) / (2 * SIZE), (d - a + c - b) / (2 * SIZE)


@bulky
class SeenSheet:
    """Size of its paper, and those of its markers that are seen: 0 to 3 in the corners, 4 and 5 at the edges."""

    size: tuple[float, float]
    markers: Mapping[int, SeenMarker]

    @cached_property
    def at(self) -> tuple[complex, ...]:
        """Left upper corners of the markers on the page [mm]."""
        return *corners(*self.size), *edges(*self.size)

    @cached_property
    def pairs(self) -> tuple[Array, Array]:
        """Corners of the markers on the page [mm], and on the picture [px]."""
        places = np.concatenate([self.at[k] + _SQUARE for k in self.markers])
        return places, np.concatenate([marker.at for marker in self.markers.values()])

    @cached_property
    def rough(self) -> Homography:
        return Homography.of(*self.pairs)

    def with_ends(self, digits: Sequence[SeenMarker]) -> SeenSheet:
        """With the markers that stand where those at the edges do."""
        found = dict(self.markers)
        for k in (CORNERS, CORNERS + 1):
            around = self.rough(self.at[k] + _SQUARE)
            off = {marker: abs(marker.middle - around.mean()) for marker in digits}
            if off and min(off.values()) < abs(around[2] - around[0]):
                found[k] = min(off, key=off.__getitem__)
        return SeenSheet(self.size, found)


def registered(
    picture: GreyPicture, sizes: Collection[tuple[float, float]] = (_A4,)
) -> Iterator[RegisteredPage | GraphkinError]:
    """Every sheet on a picture, or why it cannot be measured; sizes: of the paper that was printed on [mm]."""
    markers = _markers(picture.grey)
    left = [marker for marker in markers if marker.id < CORNERS]
    count = 0
    while left:
        sheets = [SeenSheet(size, _together(first, left, size)) for size in sizes for first in left]
        off = [float(np.abs(each.rough(each.pairs[0]) - each.pairs[1]).max()) for each in sheets]
        sheet = sheets[max(range(len(sheets)), key=lambda k: (len(sheets[k].markers), -off[k]))]
        left = [marker for marker in left if marker not in sheet.markers.values()]
        if len(sheet.markers) > 1:
            count += 1
            yield _registered(picture, sheet.with_ends([marker for marker in markers if marker.id >= CORNERS]))
    if not count:
        yield PhotographAgain(picture.where, "none")


def _markers(grey: Pixels) -> list[SeenMarker]:
    """All that are seen, looked for where the picture is made small."""
    import cv2

    less = max(1.0, max(grey.shape) / _LOOKED)
    small = cv2.resize(grey, None, fx=1 / less, fy=1 / less, interpolation=cv2.INTER_AREA)
    setting = cv2.aruco.DetectorParameters()
    setting.adaptiveThreshWinSizeMin, setting.adaptiveThreshWinSizeMax, setting.adaptiveThreshWinSizeStep = _WINDOWS
    setting.cornerRefinementMethod = cv2.aruco.CORNER_REFINE_SUBPIX
    known = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_250)
    found, ids, _ = cv2.aruco.ArucoDetector(known, setting).detectMarkers(small)
    places = ((each.reshape(4, 2) + 0.5) * less - 0.5 for each in found)
    return [SeenMarker(int(id), tuple(complex(*p) for p in four)) for id, four in zip(np.ravel(ids), places)]


def _together(first: SeenMarker, others: Sequence[SeenMarker], size: tuple[float, float]) -> dict[int, SeenMarker]:
    """The corner markers that lie where they do on one page with the first, the nearest to that of each kind."""
    at, group, best = corners(*size), {first.id: first}, dict.fromkeys(range(CORNERS), _ASTRAY)
    for other in (marker for marker in others if marker.id != first.id):
        right, down = ((a + b) / 2 for a, b in zip(first.axes, other.axes))
        step = at[other.id] - at[first.id]
        way = step.real * right + step.imag * down
        off = abs(other.middle - first.middle - way) / max(abs(way), 1.0)
        if off < best[other.id]:
            group[other.id], best[other.id] = other, off
    return group


def _registered(picture: GreyPicture, sheet: SeenSheet) -> RegisteredPage | GraphkinError:
    """A sheet whose number and three corners are seen, fine enough, with dots enough."""
    missing = [k for k in range(len(sheet.at)) if k not in sheet.markers]
    lost, ends = tuple(k for k in missing if k < CORNERS), [k for k in missing if k >= CORNERS]
    if len(lost) > 1 or ends:
        px, (high, wide) = sheet.rough(np.array([sheet.at[k] + _SQUARE for k in missing])), picture.grey.shape
        cut = bool(((px.real < 0) | (px.imag < 0) | (px.real > wide) | (px.imag > high)).any())
        return PhotographAgain(picture.where, "corners" if len(lost) > 1 else "number", lost, cut)
    per_mm = sheet.rough.per_mm(*sheet.size)
    if not per_mm >= _COARSE:
        return PhotographAgain(picture.where, "coarse", value=per_mm)
    fit = fitted(picture.grey, sheet.rough, sheet.size, sheet.pairs)
    if fit is None:
        return PhotographAgain(picture.where, "faint")
    map, rms, within = fit
    if within > _OFF:
        return PhotographAgain(picture.where, "bent", value=within)
    number = number_of(*(sheet.markers[k].id for k in (CORNERS, CORNERS + 1)))
    return RegisteredPage(number, *sheet.size, rms, within, per_mm, map, picture.grey)
