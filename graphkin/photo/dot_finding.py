"""The dots of a page, found on its picture one by one, and the map from page to picture that they tell."""

from __future__ import annotations

import numpy as np

from graphkin.base.geometry import Array
from graphkin.photo.markers import DOT, dots
from graphkin.photo.page_map import Homography, PageMap, sampled, smoothed
from graphkin.photo.pictures import Pixels

_REACHES = 4.2, 1.0, 0.4  # how far from its place a dot is looked for: by markers alone, by the dots around it [mm]
_FINE = 8.0  # samples a mm with which a dot is looked for
_ROUND = 0.95  # around a dot within which it is compared [mm]
_SOFT = 0.045  # of a dot's rim [mm]
_LIKE = 0.6  # part of what is seen around a dot's place that is to be the dot
_PRINTED = 0.01  # by how much printers lay dots, and all of them alike, to one side [mm]
_LEAST = 0.3  # part of the dots that is to be found
_GAP = 35.0  # from any dot's place to the nearest that is found, at the most [mm]


def fitted(
    grey: Pixels, rough: Homography, size: tuple[float, float], marks: tuple[Array, Array]
) -> tuple[PageMap, float, float] | None:
    """The map from a rough one and corners of markers on the page and in the picture; by how much places are off by it,
    as dots are from what the others tell [mm]: rms of those that agree, and within this 95 % of all; where those of a
    region do not agree, all. None where dots are not found, or not everywhere."""
    places = np.array(list(dots(*size)))
    fit, back = PageMap(rough, np.zeros((2, 2), complex)), Homography(np.linalg.inv(rough.matrix))
    for reach in _REACHES:
        at, like = _placed(grey, fit, _looked_for(grey, fit, places, reach))
        good = (like > _LIKE) & (np.abs(at - places) < reach)
        if good.sum() < _LEAST * places.size:
            return None
        shifts = np.concatenate([back(fit(at[good])) - places[good], back(marks[1]) - marks[0]])
        table, off, weights = smoothed(np.concatenate([places[good], marks[0]]), shifts, size)
        fit = PageMap(rough, table)
    if _gap(places, places[good]) > _GAP:
        return None
    off, weights = off[: good.sum()], weights[: good.sum()]
    most = 0.95 if _gap(places, places[good][weights > 0.5]) < _GAP else 1.0
    rms = np.hypot(np.sqrt(np.sum(weights * off**2) / weights.sum()), _PRINTED)
    return fit, float(rms), float(np.hypot(np.quantile(off, most), 2 * _PRINTED))


def _gap(places: Array, found: Array) -> float:
    """From any place to the nearest that is found, at the most [mm]."""
    return float(np.abs(np.subtract.outer(places, found)).min(axis=1).max())


def _disc(x: Array, y: Array) -> Array:
    """A printed dot as a camera sees it: 1 in its middle, soft at its rim."""
    return 1 / (1 + np.exp((np.hypot(x, y) - DOT / 2) / _SOFT))


def _looked_for(grey: Pixels, map: PageMap, places: Array, reach: float) -> Array:
    """The place near its own where each is most like a dot."""
    import cv2

    side, far = round(_ROUND * _FINE), round(reach * _FINE)
    grid = np.arange(-side - far, side + far + 1) / _FINE
    patches = sampled(grey, map.around(places, (grid[None, :] + 1j * grid[:, None]).ravel())).astype(np.float32)
    disc = -_disc(*np.meshgrid(grid[far:-far], grid[far:-far])).astype(np.float32)
    like = (cv2.matchTemplate(each.reshape(grid.size, -1), disc, cv2.TM_CCOEFF_NORMED) for each in patches)
    best = np.array([complex(*cv2.minMaxLoc(each)[3]) for each in like])
    return places + (best - far * (1 + 1j)) / _FINE


def _placed(grey: Pixels, map: PageMap, places: Array) -> tuple[Array, Array]:
    """Each dot's place, from one near it, by the shift of the dot that best explains the brightness around it beside
    lines along and across the page, as grids and tables have; and what part of the rest the dot explains."""
    side = np.linspace(-_ROUND, _ROUND, 21)
    x, y = (part[np.hypot(*np.meshgrid(side, side)) <= _ROUND] for part in np.meshgrid(side, side))
    slopes = ((_disc(x + h.real, y + h.imag) - _disc(x - h.real, y - h.imag)) / 2e-3 for h in (1e-3, 1e-3j))
    basis = np.stack([_disc(x, y), *slopes, *(x == side[:, None]), *(y == side[:, None])], 1)
    solve, at = np.linalg.pinv(basis), places.copy()
    for _ in range(4):
        seen = sampled(grey, map.around(at, x + 1j * y))
        parts = seen @ solve.T
        move = -(parts[:, 1] + 1j * parts[:, 2]) / np.minimum(parts[:, 0], -1e-9)
        at += move / np.maximum(1.0, np.abs(move) / 0.2)
    light, left = seen - parts[:, 3:] @ basis[:, 3:].T, seen - parts @ basis.T
    like = 1 - (left**2).sum(1) / np.maximum(1e-9, (light**2).sum(1))
    return at, np.where(parts[:, 0] < 0, like, 0.0)
