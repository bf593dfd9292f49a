"""Layouts: a paper, the rooms of the figures on it, and their scales.

A figure is as large as its points at the scale, plus what its signs and letters reach beyond them (`Extent.reach`).
Divisions of the paper are tried, all shares at once; the one with the largest figures is taken.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache

import numpy as np

from graphkin.base.geometry import Array
from graphkin.base.rooms import Room, parted
from graphkin.base.scales import finer
from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.errors import NOWHERE, TooLargeForPaper
from graphkin.sheet.corners import Standing, standing
from graphkin.sheet.marks import Place
from graphkin.sheet.page import HEAD_WIDTH
from graphkin.sheet.paper import KEYS, UNITS, Paper
from graphkin.sheet.window import Extent, Window

HEAD = 7.5  # height of a figure's heading [mm]
_SECOND = 5.5  # its additional height where the scale stands under it, in a narrow room [mm]
_NARROWEST = 46.0  # a heading wants at least so much [mm]
_MECHANISM = 2.2  # the weight of the mechanism: its signs keep their size and need room between them
_INK = 1.0  # the worth of paper that is used
_AT_ONCE = 64  # so many divisions are held against blocks at once
_COARSER = 2.1  # so much coarser a figure may be drawn to have room for its equations and tables beside it
_FAIR, _MOST, _DEAR = 0.27, 0.4, 40.0
"""So much of the field each of three figures has at least, and the mechanism at most; the cost of what is not so."""

Height = Callable[[Paper], float]  # the height that the tables and the title need on a paper [mm]


@frozen
class Layout:
    """A paper divided: a room and a scale for each plane, and the strip for tables and title."""

    paper: Paper
    rooms: Mapping[Plane, Room]
    scales: Mapping[Plane, float]
    strip: Room

    def placed(self, plane: Plane, extent: Extent) -> tuple[Window, list[tuple[int, Place]]]:
        """The figure with its signs in the middle of what its blocks leave; each block's shape and its corner."""
        under, own, stands = self._standing(plane, extent)
        free = Room(*map(float, under[:, 0]))
        return stands.window(own, free, self.paper.times), stands.corners(free)

    def holds(self, extents: Mapping[Plane, Extent], strip: float) -> bool:
        """Its figures stand in its rooms at its scales, over a strip of that height [mm]."""
        every = (self._standing(plane, extent)[-1] for plane, extent in extents.items())
        return strip <= self.strip.size.imag and all(np.isfinite(stands.scales[0]) for stands in every)

    def _standing(self, plane: Plane, extent: Extent) -> tuple[Array, Extent, Standing]:
        """The room of a figure under its heading, its extent as drawn, and how it stands there."""
        under, own = _under_heading(_one(self.rooms[plane])), self.as_drawn(plane, extent)
        return under, own, standing(under, own)

    def as_drawn(self, plane: Plane, extent: Extent) -> Extent:
        """At the scale at which it is drawn."""
        return replace(extent.reduced(self.paper.times), given=self.scales[plane])


def _one(room: Room) -> Array:
    """Left, top, right and bottom (4, 1), as of many rooms."""
    return np.array([[room.left], [room.top], [room.right], [room.bottom]])


def _under_heading(rooms: Array) -> Array:
    high = np.where(rooms[2] - rooms[0] < HEAD_WIDTH, HEAD + _SECOND, HEAD)
    return np.asarray(rooms + high * np.array([[0.0], [1.0], [0.0], [0.0]]))


def cut_to(layout: Layout, plane: Plane, extent: Extent) -> Layout:
    """A paper with one figure, no higher than that figure and the strip need; without a frame, no wider either."""
    paper, own = layout.paper, layout.as_drawn(plane, extent)
    for side in ("height",) if paper.margin else ("width", "height"):
        field, foot = paper.divided(layout.strip.size.imag)
        less = np.arange(field.size.imag if side == "height" else field.size.real - HEAD_WIDTH)
        smaller = _one(field) - less * np.array([[0.0], [0.0], [side == "width"], [side == "height"]])
        fits = np.isfinite(standing(_under_heading(smaller), own).scales)
        paper = replace(paper, **{side: getattr(paper, side) - float(less[fits].max(initial=0.0))})
    field, foot = paper.divided(layout.strip.size.imag)
    return Layout(paper, {plane: field}, layout.scales, foot)


def lay_out(
    extents: Mapping[Plane, Extent], strip_height: Height, candidates: Sequence[Paper], freely: bool = False
) -> Layout:
    """The smallest of the papers that holds all; freely: given scales that are too fine for each are not kept. Raises
    TooLargeForPaper where a given scale is too fine for every paper."""
    free = {plane: replace(extent, given=None) for plane, extent in extents.items()}
    for whole in (extents, free) if freely else (extents,):
        for size in dict.fromkeys(paper.area for paper in candidates):
            papers = [paper for paper in candidates if paper.area == size]
            if (best := division(papers, whole, strip_height)) is not None:
                return best
    raise _too_large(extents, strip_height, candidates)


def division(
    papers: Sequence[Paper], whole: Mapping[Plane, Extent], strip_height: Height, bare: Layout | None = None
) -> Layout | None:
    """The best division, in which no figure is much coarser than in a bare one; None where nothing fits. Blocks are
    held against those alone that would be better without."""
    best, layout, reduced = -math.inf, None, (each.reduced for each in papers)
    every = ((paper, *paper.divided(strip_height(paper))) for paper in reduced)
    for paper, field, strip in (each for each in every if each[1].size.imag > 0):  # the strip has left some
        extents = {plane: extent.reduced(paper.times) for plane, extent in whole.items()}
        rooms, plain = _rooms(field, tuple(extents)), {p: replace(each, blocks=()) for p, each in extents.items()}
        alone = _bare_worths(field, tuple(plain.items()))
        fine = np.all([_fine(plane, worth, bare) for plane, worth in alone.items()], axis=0)
        most = np.where(fine, _values(alone), -math.inf)
        order = np.argsort(-most, kind="stable")
        for some in np.array_split(order, range(_AT_ONCE, len(order), _AT_ONCE)):
            if most[some[0]] <= best:
                break
            worths = dict[Plane, Array]()
            for plane, own in extents.items():  # of those in which the figures before it fit
                room = rooms[plane][:, some]
                worths[plane] = _worth(room, plane, own, field, len(rooms)) if own.blocks else alone[plane][:, some]
                fits = _fine(plane, worths[plane], bare)
                some, worths = some[fits], {plane: worth[:, fits] for plane, worth in worths.items()}
            values = _values(worths)
            if values.max(initial=best) > best:
                share = int(np.argmax(values))
                each = {plane: Room(*map(float, room[:, some[share]])) for plane, room in rooms.items()}
                chosen = {plane: float(worth[2, share]) for plane, worth in worths.items()}
                best, layout = values[share], Layout(paper, each, chosen, strip)
    return layout


def _values(worths: Mapping[Plane, Array]) -> Array:
    """The worth of many divisions (n,)."""
    value, ink, _ = np.sum([*worths.values()], axis=0)
    return np.asarray(np.round(value + _INK * np.log(ink), 9))


def _fine(plane: Plane, worth: Array, bare: Layout | None) -> Array:
    """Where a figure fits (n,), not much coarser than in a bare division."""
    return np.asarray(worth[2] <= (_COARSER * bare.scales[plane] if bare else math.inf))


@lru_cache(16)
def _bare_worths(field: Room, extents: tuple[tuple[Plane, Extent], ...]) -> dict[Plane, Array]:
    """Those of figures without blocks in all divisions of a field, which many contents have in common."""
    rooms = _rooms(field, tuple(plane for plane, _ in extents))
    return {plane: _worth(rooms[plane], plane, extent, field, len(rooms)) for plane, extent in extents}


def _worth(room: Array, plane: Plane, extent: Extent, field: Room, count: int) -> Array:
    """One of so many figures in many rooms of a field (3, n): the worth of its size and of the room about its labels,
    the part of the paper that it uses, and its scale; NaN where it does not fit."""
    area, free, machine = field.size.real * field.size.imag, _under_heading(room), plane == "position"
    scale = np.where(room[2] - room[0] >= _NARROWEST, standing(free, extent).scales, math.nan)
    wide, high = extent.size.real / scale, extent.size.imag / scale
    easy = 110.0 if machine else 50.0 + 2.2 * extent.labels  # it has room for its letters
    weight = math.sqrt(extent.labels / 10) * (_MECHANISM if machine else 1)
    large = np.maximum(wide, high)
    value = weight * (np.log(np.clip(large, 1.0, easy)) + 0.4 * np.log(np.clip(large / easy, 1.0, 1.8)))
    wide, high = wide + extent.reach.real, high + extent.reach.imag
    if extent.labels:
        value = value + 0.15 * np.log(1 + np.minimum(free[2] - free[0] - wide, free[3] - free[1] - high))
    if count == 3:
        part = (room[2] - room[0]) * (room[3] - room[1]) / area
        value = value - _DEAR * (np.maximum(0.0, _FAIR - part) + machine * np.maximum(0.0, part - _MOST))
    return np.array([value, wide * high / area, scale])


def _too_large(extents: Mapping[Plane, Extent], strip_height: Height, papers: Sequence[Paper]) -> TooLargeForPaper:
    """The given scale that does not fit, and the finest one that would."""
    given = [plane for plane, extent in extents.items() if extent.given is not None]
    area = max(paper.area for paper in papers)
    large = [paper for paper in papers if paper.area == area]
    for freed in (*([plane] for plane in given), given):
        loose = {plane: replace(e, given=None) if plane in freed else e for plane, e in extents.items()}
        if (layout := division(large, loose, strip_height)) is not None:
            plane = freed[0]
            scale, fits = extents[plane].given, layout.scales[plane]
            while division(large, {**loose, plane: replace(loose[plane], given=finer(fits))}, strip_height):
                fits = finer(fits)
            assert scale is not None
            return TooLargeForPaper(NOWHERE, KEYS[plane], scale, fits, large[0].name[:2], UNITS[plane])
    raise AssertionError("free scales fit every paper")


_SHARES = np.arange(6, 27) / 32
_SHARE, _OTHER = np.repeat(_SHARES, len(_SHARES)), np.tile(_SHARES, len(_SHARES))


@lru_cache(16)
def _rooms(field: Room, planes: tuple[Plane, ...]) -> dict[Plane, Array]:
    """All divisions of a field, many rooms of each plane: one after the other, or one beside or over the two others."""
    whole, every = np.repeat(_one(field), len(_SHARE), axis=1), list[tuple[Array, ...]]()
    for axis in (0, 1) if len(planes) > 1 else ():
        one, rest = parted(whole, _SHARE, axis)
        if len(planes) == 2:
            every.append((one, rest))
            continue
        every += [(one, *parted(rest, _OTHER, axis)), (one, *parted(rest, _OTHER, 1 - axis))]
        first, other = parted(one, _OTHER, 1 - axis)
        every += [(first, other, rest), (first, rest, other)]
    sides = zip(*(every or [(whole[:, :1],)]), strict=True)
    return {plane: np.concatenate(each, axis=1) for plane, each in zip(planes, sides, strict=True)}
