"""Layouts: a paper, the rooms of the figures on it, and their scales.

A figure is as large as its points at the scale, plus what its signs and letters reach beyond them (`Extent.reach`).
Divisions of the paper are tried, all shares at once (`Rooms`); the one with the largest figures is taken.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache

import numpy as np

from graphkin.base.geometry import Array
from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.errors import NOWHERE
from graphkin.sheet.corners import Standing, standing
from graphkin.sheet.marks import Place
from graphkin.sheet.page import HEAD_WIDTH
from graphkin.sheet.paper import KEYS, UNITS, Paper, Room, Rooms, TooLargeForPaper, finer, papers_for
from graphkin.sheet.window import Extent, Window

HEAD = 7.5  # height of a figure's heading [mm]
_SECOND = 5.5  # its additional height where the scale stands under it, in a narrow room [mm]
_NARROWEST = 46.0  # a heading wants at least so much [mm]
_MECHANISM = 2.2  # the weight of the mechanism: its signs keep their size and need room between them
_INK = 1.0  # the worth of paper that is used
_AT_ONCE = 128  # so many divisions are held against blocks at once
_COARSER = 1.7  # so much coarser a figure may be drawn to have room for its equations and tables beside it
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

    def window(self, plane: Plane, extent: Extent) -> Window:
        """The figure with all its signs in the middle of what its blocks leave, under its heading."""
        return self.standing(plane, extent).window(self._own(plane, extent), self.free(plane), self.paper.times)

    def corners(self, plane: Plane, extent: Extent) -> list[tuple[int, Place]]:
        """The number of each of its blocks' shapes, and its upper left corner."""
        return self.standing(plane, extent).corners(self.free(plane))

    def standing(self, plane: Plane, extent: Extent) -> Standing:
        """A figure and its blocks under its heading."""
        return standing(_one(self.free(plane)), self._own(plane, extent))

    def free(self, plane: Plane) -> Room:
        """The part of its room in which a figure and its blocks stand."""
        return under_heading(self.rooms[plane])

    def _own(self, plane: Plane, extent: Extent) -> Extent:
        return replace(extent.reduced(self.paper.times), given=self.scales[plane])


def under_heading(room: Room) -> Room:
    """The part of a room that its heading leaves."""
    return Room(*map(float, _under_heading(_one(room))))


def _one(room: Room) -> Rooms:
    return Rooms(*map(np.asarray, (room.left, room.top, room.right, room.bottom)))


def _under_heading(room: Rooms) -> Rooms:
    return room._replace(top=room.top + np.where(room.right - room.left < HEAD_WIDTH, HEAD + _SECOND, HEAD))


def divided(paper: Paper, height: float) -> tuple[Room, Room]:
    """The field for figures, and under it a strip of that height [mm]."""
    whole, edge = paper.frame, paper.frame.bottom - height
    return replace(whole, bottom=edge), replace(whole, top=edge)


def alone(extent: Extent, strip_height: Height, paper: str | None) -> Layout:
    """One figure alone; a given scale that is too fine is not kept. Raises UnknownPaper."""
    papers = papers_for(paper)
    try:
        return lay_out({"position": extent}, strip_height, papers)
    except TooLargeForPaper:
        return lay_out({"position": replace(extent, given=None)}, strip_height, papers)


def cut_to(layout: Layout, plane: Plane, extent: Extent) -> Layout:
    """A paper with one figure, no higher than that figure and the strip need; without a frame, no wider either."""
    paper, strip = layout.paper, layout.strip.size.imag
    need = layout.standing(plane, extent).least
    wide = paper.width if paper.margin else min(paper.width, max(HEAD_WIDTH, math.ceil(need.real)))

    def high(wide: float) -> float:
        head = under_heading(Room(0.0, 0.0, replace(paper, width=wide).frame.size.real, 0.0)).top
        return 2.0 * paper.margin + strip + math.ceil(head + need.imag)

    wide = wide if high(wide) <= paper.height else paper.width  # in less width the heading may need more lines
    cut = replace(paper, width=wide, height=min(paper.height, high(wide)))
    field, foot = divided(cut, strip)
    own = Layout(cut, {plane: field}, layout.scales, foot)
    return own if np.isfinite(own.standing(plane, extent).scales).all() else layout


def lay_out(extents: Mapping[Plane, Extent], strip_height: Height, candidates: Sequence[Paper]) -> Layout:
    """The smallest of the papers that holds all.

    Raises TooLargeForPaper where a given scale is too fine for every paper.
    """
    for size in dict.fromkeys(paper.area for paper in candidates):
        papers = [paper for paper in candidates if paper.area == size]
        if (best := division(papers, extents, strip_height)) is not None:
            return best
    raise _too_large(extents, strip_height, candidates)


def division(
    papers: Sequence[Paper], whole: Mapping[Plane, Extent], strip_height: Height, bare: Layout | None = None
) -> Layout | None:
    """The best division, in which no figure is much coarser than in a bare one; None where nothing fits. Blocks are
    held against those alone that would be better without."""
    best, layout = -math.inf, None
    for paper in (each.reduced for each in papers):
        extents = {plane: extent.reduced(paper.times) for plane, extent in whole.items()}
        field, strip = divided(paper, strip_height(paper))
        rooms = _rooms(field, tuple(extents))
        most, _ = _values(rooms, {plane: replace(extent, blocks=()) for plane, extent in extents.items()}, field, bare)
        order = np.argsort(-most, kind="stable")
        for some in np.array_split(order, range(_AT_ONCE, len(order), _AT_ONCE)):
            if most[some[0]] <= best:
                break
            own = {plane: Rooms(*(side[some] for side in room)) for plane, room in rooms.items()}
            values, scales = _values(own, extents, field, bare)
            share = int(np.argmax(values))
            if values[share] > best:
                each = {plane: Room(*(float(side[share]) for side in room)) for plane, room in own.items()}
                chosen = {plane: float(scale[share]) for plane, scale in scales.items()}
                best, layout = values[share], Layout(paper, each, chosen, strip)
    return layout


def _values(
    rooms: Mapping[Plane, Rooms], extents: Mapping[Plane, Extent], field: Room, bare: Layout | None
) -> tuple[Array, dict[Plane, Array]]:
    """The values of many divisions, and the scales there."""
    free, scales = {plane: _under_heading(room) for plane, room in rooms.items()}, dict[Plane, Array]()
    for plane, room in rooms.items():
        own = standing(free[plane], extents[plane]).scales
        most = math.inf if bare is None else _COARSER * bare.scales[plane]
        scales[plane] = np.where((room.right - room.left >= _NARROWEST) & (own <= most), own, math.nan)
    score = _score(extents, scales, free, field.size.real * field.size.imag)
    return np.where(np.isnan(score), -math.inf, np.round(score - _DEAR * _unfair(rooms, field.size), 9)), scales


@lru_cache(16)
def _rooms(field: Room, planes: tuple[Plane, ...]) -> dict[Plane, Rooms]:
    """All divisions of a field as one: many rooms of each plane."""
    every = [*_divisions(_one(field), planes)]
    sizes = [max(side.size for room in division.values() for side in room) for division in every]
    sides = {plane: [[np.broadcast_to(side, (count,)) for side in division[plane]]
                     for division, count in zip(every, sizes, strict=True)] for plane in planes}  # fmt: skip
    return {plane: Rooms(*map(np.concatenate, zip(*each, strict=True))) for plane, each in sides.items()}


def _score(
    extents: Mapping[Plane, Extent], scales: Mapping[Plane, Array], free: Mapping[Plane, Rooms], area: float
) -> Array:
    """The worth of many divisions: size of figures, room about them, paper used. NaN: one has no room.

    free  what rooms have under their headings; area: of the whole field [mm^2]
    """
    total, inked = np.asarray(0.0), np.asarray(0.0)
    for plane, extent in extents.items():
        room = free[plane]
        wide, high = extent.size.real / scales[plane], extent.size.imag / scales[plane]
        easy = 110.0 if plane == "position" else 50.0 + 2.2 * extent.labels  # it has room for its letters
        weight = math.sqrt(extent.labels / 10) * (_MECHANISM if plane == "position" else 1)
        large = np.maximum(wide, high)
        total = total + weight * (np.log(np.clip(large, 1.0, easy)) + 0.4 * np.log(np.clip(large / easy, 1.0, 1.8)))
        wide, high = wide + extent.reach.real, high + extent.reach.imag
        total = total + 0.15 * np.log(1 + np.minimum(room.right - room.left - wide, room.bottom - room.top - high))
        inked = inked + wide * high / area
    return np.asarray(total + _INK * np.log(inked))


def _unfair(rooms: Mapping[Plane, Rooms], whole: complex) -> Array:
    """The parts of a field that a mechanism has too much and figures too little of, beside one another."""
    unfair = np.asarray(0.0)
    for plane, room in rooms.items() if len(rooms) == 3 else ():
        part = (room.right - room.left) * (room.bottom - room.top) / (whole.real * whole.imag)
        unfair = unfair + np.maximum(0.0, _FAIR - part) + np.maximum(0.0, part - _MOST if plane == "position" else 0.0)
    return unfair


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


# --- divisions of a field ---------------------------------------------------------------------------------------------

_SHARES = np.arange(6, 27) / 32
_SHARE, _OTHER = np.repeat(_SHARES, len(_SHARES)), np.tile(_SHARES, len(_SHARES))


def _divisions(field: Rooms, planes: tuple[Plane, ...]) -> Iterator[dict[Plane, Rooms]]:
    """Rooms in the order of drawing: one after the other, or one beside or over the two others."""
    if len(planes) == 1:
        yield {planes[0]: field}
        return
    for across in (True, False):
        if len(planes) == 2:
            yield dict(zip(planes, _cut(field, _SHARES, across), strict=True))
            continue
        one, rest = _cut(field, _SHARE, across)
        yield dict(zip(planes, (one, *_cut(rest, _OTHER, across)), strict=True))
        yield dict(zip(planes, (one, *_cut(rest, _OTHER, not across)), strict=True))
        for other, last in (planes[1:], planes[:0:-1]):
            yield {**dict(zip((planes[0], other), _cut(one, _OTHER, not across), strict=True)), last: rest}


def _cut(room: Rooms, share: Array, across: bool) -> tuple[Rooms, Rooms]:
    """Two parts beside each other (`across`) or one above the other."""
    if across:
        x = room.left + share * (room.right - room.left)
        return room._replace(right=x), room._replace(left=x)
    y = room.top + share * (room.bottom - room.top)
    return room._replace(bottom=y), room._replace(top=y)
